"""A remixed icon: who owns each pixel, what it cost, and how it is drawn."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from iconstudio.model.canvas import CANVAS
from iconstudio.model.exemplar import Frame
from iconstudio.model.placement import Source

WHOLE = Frame(0, 0, CANVAS)
"""The canvas itself."""


@dataclass(frozen=True, eq=False)
class Composite:
    """The labelling L of equation 5 with its energy.

    ``energy == data_cost + lambda_s * m / CANVAS * smoothness_cost``; m is the side of ``labels``.
    """

    style: str
    """The style of section 3.5; of a hybrid or a montage, the workflow's name."""
    lambda_s: float
    sources: tuple[Source, ...]
    labels: NDArray[np.uint8]
    """(m, m), m a multiple of CANVAS: index into ``sources`` of the owner of each pixel of the
    canvas."""
    energy: float
    data_cost: float
    smoothness_cost: float
    shares: tuple[float, ...]
    """Part of the drawing's ink that each source owns; they sum to 1."""
    iou: float | None
    """Intersection over union of the filled drawing and the outline that was wanted; None if none
    was."""


@dataclass(frozen=True, eq=False)
class Drawing:
    """A composite redrawn and traced: the icon itself.

    ``path`` is the ``d`` attribute of one SVG path in canvas units (0 to CANVAS), to be
    filled with the nonzero rule. ``coverage`` is the same drawing, (n, n) uint8 with n a multiple
    of CANVAS, 255 = ink.
    """

    path: str
    coverage: NDArray[np.uint8]
    owners: NDArray[np.uint8] | None = None
    """(k, k): index of the source that owns each part of ``frame``; None: as the labels say."""
    frame: Frame = WHOLE
    """The square of the composite's canvas that is drawn, in its units: more than the canvas if a
    source that owns its border reaches past it. Path and coverage are in units of this square."""
