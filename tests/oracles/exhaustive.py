"""The plain way of matching: every translation at full resolution, by fast Fourier transforms."""

from collections.abc import Sequence

import numpy as np
from scipy import fft

from iconstudio.algorithms.iconification.matching import FAR, PreparedExemplar
from iconstudio.algorithms.iconification.saliency import Region
from iconstudio.model import CANVAS

REACH = CANVAS // 2 - 1
"""The greatest translation along x or y, in pixels."""


def exhaustive(
    field: np.ndarray, regions: Sequence[Region], exemplars: Sequence[PreparedExemplar]
) -> np.ndarray:
    """Return the least error of each exemplar in each region, (regions, exemplars).

    Exemplar by exemplar, scale by scale, mirrored and not; all regions in one batch, and the terms
    of equation 12 joined in one inverse transform. ``field`` is the sketch's TSDF.
    """
    masks = np.stack([region.mask for region in regions])
    ours = field - FAR
    side = exemplars[0].squared.shape[-1]
    size = fft.next_fast_len(max(CANVAS + side - 1, CANVAS + 2 * REACH), real=True)
    mask_spectra = fft.rfft2(masks, (size, size))
    field_spectra = fft.rfft2(-2 * masks * ours, (size, size))
    constant = (masks * ours**2).sum(axis=(1, 2))[:, None]
    # A position is the shift of the exemplar's corner, and counts modulo the transform's size.
    shifts = np.arange(-REACH, REACH + 1) - (side - CANVAS) // 2
    least = np.full((len(regions), len(exemplars)), np.inf)
    for number, one in enumerate(exemplars):
        for scale in range(len(one.scales)):
            for theirs in (one.field(scale), one.field(scale)[:, ::-1]):
                both = fft.rfft2(np.stack([theirs, theirs**2]), (size, size)).conj()
                errors = fft.irfft2(field_spectra * both[0] + mask_spectra * both[1], (size, size))
                errors = errors[:, shifts][:, :, shifts].reshape(len(regions), -1) + constant
                least[:, number] = np.minimum(least[:, number], errors.min(axis=1))
    return least
