"""A pictogram rasterised on the canvas: the raw material of matching and remixing."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from iconstudio.model.pictogram import Pictogram


@dataclass(frozen=True)
class Frame:
    """The square of a pictogram's SVG user space that is mapped to the whole canvas."""

    x: float
    y: float
    size: float

    def __post_init__(self) -> None:
        """Take plain numbers only: those of NumPy would be written out as ``np.float64(0.9)``."""
        for name in ("x", "y", "size"):
            object.__setattr__(self, name, float(getattr(self, name)))


@dataclass(frozen=True, eq=False)
class Exemplar:
    """A pictogram, scaled to the canvas by its tight bounding box and centred (section 3.4).

    ``coverage`` is (CANVAS, CANVAS) uint8, read-only: how dark a pixel is after alpha, 255 = black.
    """

    pictogram: Pictogram
    frame: Frame
    coverage: NDArray[np.uint8]

    @property
    def id(self) -> str:
        """The pictogram's identifier, ``set:name``."""
        return self.pictogram.id

    @property
    def name(self) -> str:
        """What to call the pictogram."""
        return self.pictogram.name

    @cached_property
    def ink(self) -> NDArray[np.bool_]:
        """(CANVAS, CANVAS) bool: pixels that are more than half dark."""
        return self.coverage > 127
