"""Where an exemplar is put on the canvas: the transformation T of equation 4."""

from dataclasses import dataclass

from fontTools.misc.transform import Transform

from iconstudio.model.canvas import CANVAS
from iconstudio.model.exemplar import Exemplar, Frame


@dataclass(frozen=True, slots=True, order=True)
class Placement:
    """Mirror about the vertical centre line, scale about the centre, then shift by whole pixels.

    A canvas point p goes to ``c + scale * F(p - c) + (dx, dy)`` with c the centre of
    the canvas and F the mirroring of x if ``flip``.
    """

    scale: float = 1.0
    flip: bool = False
    dx: int = 0
    dy: int = 0

    def __post_init__(self) -> None:
        """Take plain numbers only: those of NumPy would be written out as ``np.float64(0.9)``."""
        object.__setattr__(self, "scale", float(self.scale))
        object.__setattr__(self, "flip", bool(self.flip))
        object.__setattr__(self, "dx", round(self.dx))
        object.__setattr__(self, "dy", round(self.dy))

    @property
    def transform(self) -> Transform:
        """The same as an affine map of canvas points, with the algebra of such maps.

        >>> Placement(scale=2, flip=True, dx=5).transform.transformPoint((128, 138))
        (133.0, 148.0)
        """
        half, mirror = CANVAS / 2, -1 if self.flip else 1
        there = Transform().translate(half + self.dx, half + self.dy)
        return there.scale(mirror * self.scale, self.scale).translate(-half, -half)

    def frame(self, frame: Frame) -> Frame:
        """Return the part of the pictogram that the canvas shows *before* mirroring.

        Rendering this frame, and mirroring the picture left to right if ``flip``,
        draws the pictogram at this placement at any resolution.

        >>> Placement(scale=2).frame(Frame(0, 0, 24))  # twice as large: the middle half is seen
        Frame(x=6.0, y=6.0, size=12.0)
        """
        unit = frame.size / CANVAS
        size = frame.size / self.scale
        dx = -self.dx if self.flip else self.dx
        centre_x = frame.x + frame.size / 2 - dx * unit / self.scale
        centre_y = frame.y + frame.size / 2 - self.dy * unit / self.scale
        return Frame(centre_x - size / 2, centre_y - size / 2, size)


@dataclass(frozen=True, eq=False)
class Source:
    """An exemplar at a placement: one label of the graph cut (section 3.4)."""

    exemplar: Exemplar
    placement: Placement
    error: float = 0.0
    """Matching error of equation 4 in its region; 0 if it was not matched."""
    region: int = -1
    """Number of the salient region it was matched for; -1 if none."""
