"""Correlations by fast Fourier transforms.

SciPy's take 1.3 to 1.8 times as long as those of pyFFTW with a plan, at the sizes of patterns; they
need no plans to be kept, and start no threads.
"""

import numpy as np
from numpy.typing import NDArray
from scipy import fft

Field = NDArray[np.float32]
Spectrum = NDArray[np.complex64]


class Searched:
    """Channels (C, h, w) that masked patches are looked for in."""

    def __init__(self, channels: Field) -> None:
        channels = np.ascontiguousarray(channels, np.float32)
        self._shape = channels.shape[1:]
        self._spectra = forward(channels, self._shape)
        self._squares = forward(np.einsum("cij,cij->ij", channels, channels), self._shape)

    def squared_differences(self, patch: Field, mask: Field) -> Field:
        """Return the sums of squared differences of a patch at all places where it lies within.

        Parameters
        ----------
        patch
            (C, n, m)
        mask
            (n, m), the weights of its pixels, at least 0.

        Returns
        -------
        (h - n + 1, w - m + 1)
        """
        weighted = patch * mask
        constant = float((weighted * patch).sum())
        product = self._squares * np.conj(forward(mask, self._shape))
        products = self._spectra * np.conj(forward(weighted, self._shape))
        sums = backward(product - 2 * products.sum(axis=0), self._shape)
        rows, columns = (all_ - own + 1 for all_, own in zip(self._shape, mask.shape, strict=True))
        differences: Field = np.maximum(sums[:rows, :columns] + np.float32(constant), 0)
        return differences


def forward(fields: Field, shape: tuple[int, ...]) -> Spectrum:
    """Return the spectra (..., h, w // 2 + 1) of fields (..., n, m), padded to a shape (h, w)."""
    spectra: Spectrum = fft.rfft2(np.asarray(fields, np.float32), s=shape)
    return spectra


def backward(spectra: Spectrum, shape: tuple[int, ...]) -> Field:
    """Return the fields (..., h, w) of spectra."""
    fields: Field = fft.irfft2(spectra, s=shape)
    return fields
