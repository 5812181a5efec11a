"""The user's input for patterns: an exemplar, and how it is to be continued."""

from dataclasses import dataclass
from math import radians

from iconstudio.model.canvas import CANVAS
from iconstudio.model.montage import Stroke
from iconstudio.model.path import Transform
from iconstudio.model.photo import Photo
from iconstudio.model.pictogram import Pictogram

INK, GROUND = "#20242c", "#ffffff"


@dataclass(frozen=True, slots=True)
class Motif:
    """An icon on the canvas of an exemplar."""

    icon: Pictogram
    x: float = CANVAS / 2
    y: float = CANVAS / 2
    """Where the middle of its own canvas lies."""
    size: float = CANVAS / 4
    """Side of its own canvas, in units of the exemplar's."""
    turn: float = 0.0
    """Degrees, clockwise."""
    flip: bool = False
    """Whether it is mirrored left to right, before it is turned."""
    colour: str = INK
    """``#rrggbb``"""

    def __post_init__(self) -> None:
        """Take plain numbers only: those of NumPy would be written out as ``np.float64(0.9)``."""
        for name in ("x", "y", "size", "turn"):
            object.__setattr__(self, name, float(getattr(self, name)))

    @property
    def transform(self) -> Transform:
        """What takes a point of the icon's canvas to one of the exemplar's.

        >>> Motif(None, x=100, y=50, size=64).transform.transformPoint((128, 0))
        (100.0, 18.0)
        """
        scale = self.size / CANVAS
        there = Transform().translate(self.x, self.y).rotate(radians(self.turn))
        half = CANVAS / 2
        return there.scale(-scale if self.flip else scale, scale).translate(-half, -half)


@dataclass(frozen=True, slots=True)
class Correction:
    """A stroke of the brush over an image, in its own pixels: what it covers is of one layer."""

    layer: int
    """Its number from the ground, 0, up."""
    stroke: Stroke


@dataclass(frozen=True, slots=True)
class Separation:
    """An image, and how its colours are separated into layers (section 3)."""

    photo: Photo
    colours: int | None = None
    """How many, with the ground; None: as many as there are."""
    corrections: tuple[Correction, ...] = ()
    credits: tuple[Pictogram, ...] = ()
    """Whom to thank for it."""


@dataclass(frozen=True, slots=True)
class Patterning:
    """An exemplar of motifs, or of an image, and the pattern that is wanted."""

    motifs: tuple[Motif, ...] = ()
    """From back to front."""
    image: Separation | None = None
    """In place of motifs."""
    ground: str = GROUND
    """The colour behind all motifs, ``#rrggbb``; empty for none. An image has its own, or none."""
    width: int = 2 * CANVAS
    height: int = 2 * CANVAS
    """Of the pattern, in units of the exemplar's canvas."""
    tile: bool = True
    """Whether the pattern continues itself."""
    seed: int = 0
    scale: float = 1.0
    """Of what is in the pattern, over what is in the exemplar."""
    turn: float = 0.0
    """Degrees by which motifs turn, each about its own middle."""
    density: float = 1.0
    """Motifs to an area, over those of the exemplar."""
    fill: Pictogram | None = None
    """The shape that the pattern fills; None: all of its rectangle."""
