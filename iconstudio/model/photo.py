"""A photo to trace over."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True, slots=True, eq=False)
class Photo:
    """A photo under the drawing.

    ``width`` and ``height`` are the original's pixels, the unit of the outline.
    """

    path: str
    """The file that it was read from; empty if it was in none."""
    width: int
    height: int
    levels: tuple[NDArray[np.uint32], ...]
    """The pixels and copies, each half as large as the one before, as (h, w) words 0xAARRGGBB,
    the colours multiplied by alpha."""
    remark: str = ""
    """What of it could not be read, or is not shown."""
    data: bytes = b""
    """A file of it, for a project."""
    suffix: str = ".png"
    """How the name of such a file ends."""

    @property
    def scaled_down(self) -> bool:
        """Whether the photo was too large to be kept whole."""
        return len(self.levels[0][0]) < self.width
