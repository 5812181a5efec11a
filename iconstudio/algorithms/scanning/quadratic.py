"""How light falls on a sheet or a desk: by degrees, as a quadratic surface tells."""

import numpy as np
from numpy.typing import NDArray


def quadratic(picture: NDArray[np.float32], paper: NDArray[np.bool_]) -> NDArray[np.float32]:
    """Return (h, w, c): the quadratic surface closest to the colours of the paper."""
    height, width = paper.shape
    y, x = np.mgrid[-1 : 1 : height * 1j, -1 : 1 : width * 1j]
    terms = np.stack([np.ones_like(x), x, y, x * x, x * y, y * y], axis=-1).astype(np.float32)
    # Every few pixels will do.
    some = np.flatnonzero(paper)[:: max(1, int(paper.sum()) // 20000)]
    colours = picture.reshape(paper.size, -1)
    fit, *_ = np.linalg.lstsq(terms.reshape(-1, 6)[some], colours[some], rcond=None)
    surface: NDArray[np.float32] = np.clip(terms @ fit, 0, 1.2)
    return surface
