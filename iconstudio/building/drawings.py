"""Draws every icon of a build once, in worker processes, to take its fingerprint.

Bodies come from outside: one that the checks refuse, that no renderer survives, or that
shows nothing, has no fingerprint.
"""

from collections.abc import Iterator, Sequence
from concurrent.futures import Future

import numpy as np
from numpy.typing import NDArray
from scipy import ndimage

from iconstudio.algorithms.raster import solid
from iconstudio.library.fingerprint import Fingerprint, fingerprint
from iconstudio.library.iconify import RawIcon, document
from iconstudio.model import Frame, IconstudioError
from iconstudio.model.progress import Progress
from iconstudio.svg.check import check
from iconstudio.svg.resvg import render_coverage
from iconstudio.workers import Workers, loss

_SIZE = 96
_BATCH = 512
_PALE = 20
"""What is darker can be seen."""
_SOFT = 2
"""Pixels around the dark parts that are theirs: soft edges."""
_LOST = 0.03
"""Of a drawing, so much may be lost with its pale parts."""
_SECONDS = 60.0
_MEMORY = 1 << 30


def fingerprints(
    icons: Sequence[RawIcon], workers: Workers
) -> Iterator[Progress | list[Fingerprint | None]]:
    """Yield progress, and at last the fingerprint of every icon, None where there is none."""
    batches = [icons[i : i + _BATCH] for i in range(0, len(icons), _BATCH)]
    futures = [
        workers.submit(_draw_all, batch, timeout=_SECONDS, memory=_MEMORY) for batch in batches
    ]
    found: list[Fingerprint | None] = []
    for batch, future in zip(batches, futures, strict=True):
        drawn = _result(future)
        found += drawn if drawn is not None else _one_by_one(batch, workers)
        done = f"Drawing icons ({len(found)} of {len(icons)})"
        yield Progress("prepare", len(found) / len(icons), done)
    yield found


def _one_by_one(batch: Sequence[RawIcon], workers: Workers) -> list[Fingerprint | None]:
    """Draw a batch that took its worker down: only the culprits are lost."""
    drawn = (
        _result(workers.submit(_draw_all, [icon], timeout=5.0, memory=_MEMORY)) for icon in batch
    )
    return [one[0] if one else None for one in drawn]


def _result(future: "Future[list[Fingerprint | None]]") -> list[Fingerprint | None] | None:
    """Return what a worker has drawn; None if it died, or took too much."""
    try:
        return future.result()
    except Exception as error:
        if loss(error, "Drawing"):
            return None
        raise


def _draw_all(icons: Sequence[RawIcon]) -> list[Fingerprint | None]:
    return [_draw(icon) for icon in icons]


def _draw(icon: RawIcon) -> Fingerprint | None:
    left, top, width, height = map(float, icon.view_box.split())
    side = max(width, height)
    frame = Frame(left - (side - width) / 2, top - (side - height) / 2, side)
    svg = document(icon.body, icon.view_box)
    try:
        check(svg)
        coverage = render_coverage(svg, frame, _SIZE)
    except IconstudioError:
        return None
    return None if loses_its_shape(coverage) else fingerprint(coverage)


def loses_its_shape(coverage: NDArray[np.uint8]) -> bool:
    """Return whether a drawing, (n, n) uint8, 255 = ink, has another shape without its pale parts.

    A duotone's pale layer is no ink (section 3.1: black and white). One that lies within the dark
    lines may go; but not the body of a bin whose lid alone is dark.
    """
    dark, seen = coverage > 127, coverage > _PALE
    if not (seen & ~ndimage.binary_dilation(dark, iterations=_SOFT)).any():
        return False  # nearly all of them: nothing is pale but edges
    whole = solid(seen)
    beyond = whole & ~ndimage.binary_dilation(solid(dark), iterations=_SOFT)
    return bool(beyond.sum() > _LOST * whole.sum())
