"""Lines that are too thin to be seen."""

import numpy as np
import scipy
from numpy.typing import NDArray

_NEARLY_ALL = 0.95


def thickened(ink: NDArray[np.bool_], least: int) -> NDArray[np.bool_]:
    """Return ink (h, w) so thick that its thickest lines measure ``least`` pixels.

    It is the same array if they do; else the new one is larger by as much on each side.
    """
    framed = np.pad(ink, least)
    depths = scipy.ndimage.distance_transform_edt(framed)[framed]
    width = 2 * float(np.quantile(depths, _NEARLY_ALL)) - 1 if depths.size else float(least)
    if width >= least:
        return ink
    away = scipy.ndimage.distance_transform_edt(~framed)
    thick: NDArray[np.bool_] = away <= np.ceil((least - width) / 2)
    return thick
