"""What is told of a pictogram that is not all of its drawing, or not as it was."""

from collections.abc import Collection

from iconstudio.algorithms.tones.alternation import Omission

THIN = "Its lines are too thin to be seen at the size of an icon; they were drawn thicker."

OMITTED = {
    Omission.TILE: "The ground behind the drawing, such as a tile, was left out.",
    Omission.PAGE: "The white, or nearly white, behind the drawing was left out.",
    Omission.SHADES: "Some neighbouring shades or colours were drawn as one.",
    Omission.FAINT: "Parts that are hardly opaque, such as shadows, were left out.",
    Omission.DESK: "What lies around the sheet of paper was left out.",
    Omission.HOLES: "The punch holes of the sheet were left out.",
    Omission.FINGER: "A finger at the edge of the photo was left out.",
    Omission.PRINT: "The lines or dots that the paper is printed with were left out.",
    Omission.GLOW: "The glow around the drawing was left out.",
    Omission.SHADOW: "The shadow of the drawing was left out.",
    Omission.DECORATION: "Paler colour behind or beside what is dark was left out.",
}
"""Of what was left out."""


def said_of(omissions: Collection[Omission]) -> list[str]:
    """Return what to say of omissions, a sentence each; one of all shadows is enough."""
    if Omission.FAINT in omissions:
        omissions = set(omissions) - {Omission.SHADOW}
    return [said for what, said in OMITTED.items() if what in omissions]
