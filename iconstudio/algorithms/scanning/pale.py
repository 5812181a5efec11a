"""A pale drawing in one colour, on the white page of a computer, is as good as a dark one.

Paper that is lit unevenly differs by as much as such a drawing from its page; but where the page is
clean and all edges are sharp, there is no light that could tell them apart, and it is made darker.
"""

import numpy as np
import scipy
from numpy.typing import NDArray

from iconstudio.algorithms.scanning.ground import ground_of, sharpness
from iconstudio.algorithms.scanning.margin import PAPER, corners_of
from iconstudio.algorithms.scanning.resampling import premultiplied

_FAINTEST, _PALE = 15.0, 64.0
"""Levels by which a pale drawing differs from its page in the channel where it does most: by less,
it may be noise; by more, it is none."""
_FARTHEST = 90
"""Percent of the drawing that are nearer to the page than its one colour."""
_NOISE = 8.0
"""Levels by which lossy files miss a blend of page and colour."""
_FEW = 0.01
"""How much of a drawing may do so by more."""
_LONGEST = 1024
"""Pixels of the longer side of the largest picture that is looked at."""
_SHARP = 0.6
"""How sharp the edges of a drawing are; those of stains and shadows are not."""


def darkened(pixels: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """Return a picture (h, w, 3) of a pale drawing with as strong a colour as that hue can have.

    Any other is as it is.
    """
    if pixels.shape[2] == 4 or max(pixels.shape[:2]) > _LONGEST:
        return pixels
    page = np.median(corners_of(pixels), axis=0)
    if page.min() <= PAPER or (pixels < page - _PALE).any():
        return pixels  # as nearly all are
    levels = pixels.astype(np.float32)
    blended = premultiplied(levels)
    ground = ground_of(blended)
    if ground is None or ground.mask.all() or not ground.is_clean(blended):
        return pixels
    page = ground.colour[:3]
    off = levels - page
    away = np.linalg.norm(off, axis=2)
    way = np.median(off[away >= np.percentile(away[~ground.mask], _FARTHEST)], axis=0)
    if way.max() > _NOISE or way.min() > -_FAINTEST:
        return pixels
    share = off @ way / float(way @ way)
    drawn = share > 0.5
    strays = np.linalg.norm(off - share[..., None] * way, axis=2) > _NOISE
    contour = drawn & ~scipy.ndimage.binary_erosion(drawn, border_value=1)
    if strays.sum() > _FEW * drawn.sum() or not contour.any():
        return pixels
    if sharpness(share[..., None])[contour].mean() < _SHARP:
        return pixels
    strongest = way * (page / -np.minimum(way, -1)).min()
    dark = page + np.clip(share, 0, 1)[..., None] * strongest
    stronger: NDArray[np.uint8] = np.clip(np.rint(dark), 0, 255).astype(np.uint8)
    return stronger
