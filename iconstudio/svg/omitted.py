"""What is told of the parts of a drawing that its pictogram leaves out."""

from iconstudio.algorithms.tones.alternation import Omission

OMITTED = {
    Omission.TILE: "The tile behind the drawing was left out.",
    Omission.PAGE: "The white behind the drawing was left out.",
    Omission.SHADES: "Shades that differ too little to be told apart were drawn as one.",
    Omission.FAINT: "Parts that are hardly opaque, such as shadows, were left out.",
    Omission.DECORATION: "Colour that lies behind or beside its lines was left out.",
}
