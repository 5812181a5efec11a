"""The user's input: a rough polygon, what is inside of it, and what to look for."""

from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING

from iconstudio.model.errors import IconstudioError
from iconstudio.model.inner import Inner
from iconstudio.model.polygon import Polygon
from iconstudio.model.symmetry import Axis

if TYPE_CHECKING:
    from iconstudio.model.montage import Layer


@dataclass(frozen=True, slots=True)
class Sketch:
    """What the user drew and typed (section 3)."""

    polygon: Polygon = field(default_factory=Polygon)
    keyword: str = ""
    exclude: frozenset[str] = field(default_factory=frozenset)
    """Identifiers of pictograms that must not be used."""
    symmetry: Axis | None = None
    pins: "tuple[Layer, ...]" = ()
    """Icons, where they lie on the canvas that the polygon is ``fitted`` to, and strokes over the
    places that must be theirs, in the styles to which they belong."""
    include: frozenset[str] = field(default_factory=frozenset)
    """Identifiers of those that may be used though they are less alike than others."""
    inner: Inner = field(default_factory=Inner)
    """What is drawn inside the polygon."""
    detail: float = 0.0
    """How much fine details of the polygon count beyond what they do in the paper, from 0 to 1."""

    def fitted(self) -> "Sketch":
        """Return the sketch on the canvas, its polygon ``fitted``.

        Raises
        ------
        IconstudioError
            If the polygon is no good, what is drawn inside it encloses nothing, or ``detail`` is
            out of range.
        """
        move = self.polygon.fitting()
        self.inner.check()
        if not 0 <= self.detail <= 1:
            raise IconstudioError(
                f"The weight of fine details, {self.detail:g}, is out of range: it goes from 0, as "
                "in the paper, to 1."
            )
        polygon = Polygon(tuple(map(move, self.polygon.vertices)))
        return replace(self, polygon=polygon, inner=self.inner.moved(move))
