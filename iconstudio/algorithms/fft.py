"""Real two-dimensional Fourier transforms of batches: the adapter of pyFFTW.

pyFFTW plans each shape once, and releases the interpreter lock while it transforms.
"""

import os
from functools import lru_cache

import numpy as np
import pyfftw
from numpy.typing import NDArray

_THREADS = os.cpu_count() or 1
_WORTH_THREADS = 256
"""Smaller transforms are over before a second thread has begun, and suffer when cores are busy."""


def fast_size(least: int) -> int:
    """Return the smallest transform size of at least ``least`` that is quick to compute."""
    return pyfftw.next_fast_len(least)


def forward(batch: NDArray[np.float32], size: int) -> NDArray[np.complex64]:
    """Transform (n, h, w) float32, padded with zeros to (n, size, size)."""
    plan = _plan(len(batch), size, True)
    plan.input_array[:] = 0
    plan.input_array[:, : batch.shape[1], : batch.shape[2]] = batch
    return plan().copy()


def inverse(spectra: NDArray[np.complex64], size: int) -> NDArray[np.float32]:
    """Transform (n, size, size // 2 + 1) complex64 back to (n, size, size) float32.

    The answer is overwritten by the next call of the same shape: copy what you keep.
    """
    plan = _plan(len(spectra), size, False)
    plan.input_array[:] = spectra
    return plan()


@lru_cache(maxsize=16)
def _plan(count: int, size: int, forwards: bool) -> pyfftw.FFTW:
    real = pyfftw.empty_aligned((count, size, size), dtype="float32")
    spectrum = pyfftw.empty_aligned((count, size, size // 2 + 1), dtype="complex64")
    return pyfftw.FFTW(
        *((real, spectrum) if forwards else (spectrum, real)),
        axes=(1, 2),
        direction="FFTW_FORWARD" if forwards else "FFTW_BACKWARD",
        flags=("FFTW_MEASURE", "FFTW_DESTROY_INPUT"),
        threads=_THREADS if size >= _WORTH_THREADS else 1,
    )
