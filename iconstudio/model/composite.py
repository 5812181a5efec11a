"""A remixed icon: who owns each pixel, what it cost, and how it is drawn."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from iconstudio.model.canvas import CANVAS
from iconstudio.model.exemplar import Frame
from iconstudio.model.path import Path
from iconstudio.model.pictogram import Credit, Pictogram
from iconstudio.model.placement import Source
from iconstudio.model.symmetry import Axis

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
    symmetry: Axis | None = None
    """What it was held to beside what the page says: it takes the place of one that was not."""
    without: tuple[str, ...] = ()
    """Identifiers of icons that were left out, so that it differs: it takes the place of a copy."""

    @property
    def stands_in(self) -> bool:
        """Whether it takes the place of another result."""
        return self.symmetry is not None or bool(self.without)

    def owners(self, least: float = 0.0) -> tuple[int, ...]:
        """Return the labels that own ink, and at least the share ``least``, by falling share."""
        some = [k for k, share in enumerate(self.shares) if share > 0 and share >= least]
        return tuple(sorted(some, key=lambda k: -self.shares[k]))

    @property
    def contributors(self) -> tuple[Pictogram, ...]:
        """The pictograms to thank for the ink, each once, from the largest part down.

        The part of a source that is itself a result counts for its origins, in equal shares. Two
        pictograms of the same name and credit are one, wherever their drawings were read from.
        """
        shares: dict[tuple[str, Credit], float] = {}
        thanked: dict[tuple[str, Credit], Pictogram] = {}
        for label in self.owners():
            origins = self.sources[label].exemplar.pictogram.origins
            for origin in origins:
                key = origin.id, origin.credit
                thanked.setdefault(key, origin)
                shares[key] = shares.get(key, 0.0) + self.shares[label] / len(origins)
        return tuple(thanked[key] for key in sorted(shares, key=shares.__getitem__, reverse=True))


@dataclass(frozen=True, eq=False)
class Drawing:
    """A composite redrawn and traced.

    ``coverage`` is the same drawing as ``path``, (n, n) uint8 with n a multiple of CANVAS,
    255 = ink.
    """

    path: Path
    coverage: NDArray[np.uint8]
    owners: NDArray[np.uint8] | None = None
    """(k, k): index of the source that owns each part of ``frame``; None: as the labels say."""
    frame: Frame = WHOLE
    """The square of the composite's canvas that is drawn, in its units: more than the canvas if a
    source that owns its border reaches past it. Path and coverage are in units of this square."""
    untidied: Path | None = None
    """The path before what seams brought about was put right; None if nothing was."""

    def owned(self, labels: NDArray[np.uint8]) -> NDArray[np.uint8]:
        """Return who owns each pixel of the coverage, (n, n); ``labels`` are the composite's."""
        owners = labels if self.owners is None else self.owners
        n = len(self.coverage)
        step = np.arange(n) * len(owners) // n
        return owners[step[:, None], step]
