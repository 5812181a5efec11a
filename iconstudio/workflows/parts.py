"""The parts of a result: which piece of it comes from which source."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from iconstudio.algorithms.raster import Bitmap
from iconstudio.model import CANVAS, Path, Point, Remix, Source

REACH = 6.0
"""A part is found from so far, in units of its drawing."""


@dataclass(frozen=True, eq=False)
class Part:
    """A piece of ink of one source."""

    icon: Remix
    label: int
    coverage: NDArray[np.uint8]
    """(n, n): of the drawing, what belongs to it."""

    @property
    def source(self) -> Source:
        """Where it comes from."""
        return self.icon.composite.sources[self.label]

    @cached_property
    def ink(self) -> Bitmap:
        """(CANVAS, CANVAS): where it lies on the canvas, which its drawing may exceed."""
        frame, n = self.icon.drawing.frame, len(self.coverage)
        along = np.arange(CANVAS) + 0.5
        rows, columns = (
            np.clip((along - start) / frame.size * n, 0, n - 1).astype(int)
            for start in (frame.y, frame.x)
        )
        ink: Bitmap = self.coverage[np.ix_(rows, columns)] > 127
        return ink

    @cached_property
    def outline(self) -> Path:
        """Its outline, in units of the drawing."""
        from iconstudio.algorithms.tracing.vectorize import trace

        return trace(self.coverage)


@dataclass(frozen=True, eq=False)
class Parts:
    """All parts of a result."""

    icon: Remix

    def at(self, point: Point, reach: float = REACH) -> Part | None:
        """Return the part nearest to a point, within ``reach``, both in units of the drawing."""
        ys, xs = self._inked
        unit = CANVAS / len(self._pieces)
        away = np.hypot((xs + 0.5) * unit - point[0], (ys + 0.5) * unit - point[1])
        nearest = int(away.argmin()) if len(away) else 0
        if not len(away) or away[nearest] > reach:
            return None
        return self._part(int(self._pieces[ys[nearest], xs[nearest]]))

    def _part(self, number: int) -> Part:
        if number not in self._known:
            own = self._pieces == number
            coverage = np.where(own, self.icon.drawing.coverage, np.uint8(0))
            label = int(self._owners[tuple(np.argwhere(own)[0])])
            self._known[number] = Part(self.icon, label, coverage)
        return self._known[number]

    @cached_property
    def _known(self) -> dict[int, Part]:
        return {}

    @cached_property
    def _owners(self) -> NDArray[np.uint8]:
        """(n, n): the owner of each pixel of the drawing."""
        return self.icon.drawing.owned(self.icon.composite.labels)

    @cached_property
    def _pieces(self) -> NDArray[np.int64]:
        """(n, n): the number of the part that each pixel belongs to; 0 is paper."""
        from skimage.measure import label

        ink = self.icon.drawing.coverage > 127
        pieces: NDArray[np.int64] = label(np.where(ink, self._owners.astype(int) + 1, 0))
        return pieces

    @cached_property
    def _inked(self) -> tuple[NDArray[np.intp], ...]:
        return np.nonzero(self._pieces)
