"""Equation 4 at many translations at once, by long waves (Appendix A, equations 12 to 16).

With A the exemplar's field moved by t and B the sketch's, equation 12 splits the error into
sum M A^2 - 2 sum M B A + sum M B^2: two correlations and a constant. Appendix A computes them with
fast Fourier transforms. But fields are ramps 2 D_MAX pixels wide, and the masks are wider still, so
short waves add almost nothing to either correlation: it is enough to keep the few waves that are
longer than ``SHORTEST``. They are then so few that matrix products, which evaluate the correlations
only at the translations that matter, are faster than fast transforms of any size.

Nothing is averaged before it is squared. What is lost is the product of the short waves of A with
those of M B: errors are off by a few hundredths at most, where good matches have an error of 0.05
to 2 and an empty picture one of 25, and the best placement is found to three pixels or better.

Pictures are real, so of the waves along x only those of numbers 0 and above are kept; along y both
signs are. Coordinates begin at the centre of a picture, so that to mirror it only swaps waves.
"""

from dataclasses import dataclass
from functools import cached_property, lru_cache

import numpy as np
from numpy.typing import NDArray

from iconstudio.model import CANVAS

REACH = 125
"""Greatest translation that is tried along x or y, in canvas pixels."""
STEP = 5
"""Every how many pixels a translation is tried."""
SHORTEST = 18
"""Waves shorter than this are left out, in canvas pixels."""


@dataclass(frozen=True)
class Waves:
    """The waves that pictures are taken apart into.

    Parameters
    ----------
    side
        Side of the exemplars' fields in pixels; at least CANVAS.
    """

    side: int

    @property
    def period(self) -> int:
        """The length of the longest wave: no translation wraps a field around into the canvas."""
        return (CANVAS + self.side) // 2 + REACH

    @property
    def highest(self) -> int:
        """The number of the shortest wave."""
        return self.period // SHORTEST

    @cached_property
    def steps(self) -> NDArray[np.int64]:
        """The translations that are tried along an axis, in pixels."""
        return np.arange(-REACH, REACH + 1, STEP)

    def spectrum(self, pictures: NDArray[np.float32]) -> NDArray[np.complex64]:
        """Return the Fourier coefficients of pictures (..., n, n): (..., x waves, y waves)."""
        along_x, along_y = _kernels(self.period, self.highest, pictures.shape[-1])
        rows = (pictures @ along_x).view(np.complex64)
        return np.ascontiguousarray((along_y @ rows).swapaxes(-1, -2))

    @cached_property
    def back_along_x(self) -> NDArray[np.float32]:
        """(2 x waves, steps): from real and imaginary parts of x waves to translations."""
        k = np.arange(self.highest + 1)
        weight = np.where(k > 0, 2, 1) / self.period**2
        turn = np.exp(2j * np.pi / self.period * np.outer(k, self.steps)) * weight[:, None]
        return np.stack([turn.real, -turn.imag], axis=1).reshape(-1, len(self.steps)).astype("f4")

    @cached_property
    def back_along_y(self) -> NDArray[np.complex64]:
        """(steps, y waves): from y waves to translations."""
        k = np.arange(-self.highest, self.highest + 1)
        turn: NDArray[np.complex128] = np.exp(2j * np.pi / self.period * np.outer(self.steps, k))
        return turn.astype(np.complex64)


@lru_cache(maxsize=8)
def _kernels(
    period: int, highest: int, side: int
) -> tuple[NDArray[np.float32], NDArray[np.complex64]]:
    """Return the sums that make coefficients of a picture: real along x, complex along y."""
    places = np.arange(side) - (side - 1) / 2
    k = np.arange(-highest, highest + 1)
    wave = np.exp(-2j * np.pi / period * np.outer(k, places)).astype(np.complex64)
    along_x = np.ascontiguousarray(wave[highest:].T).view(np.float32)
    return along_x, wave


def spectra_of(waves: Waves, fields: NDArray[np.float32]) -> NDArray[np.complex64]:
    """Return what a ``SlidingWindow`` needs of exemplars' fields (v, n, n) less ``FAR``.

    Returns
    -------
    (x waves, v, 2 y waves) complex64: the spectra of the fields and of their squares
    """
    both = waves.spectrum(np.stack([fields, fields**2], axis=1))  # (v, 2, x, y)
    return np.ascontiguousarray(both.transpose(2, 0, 1, 3)).reshape(both.shape[2], len(fields), -1)


class SlidingWindow:
    """Equation 4 for one sketch and one mask.

    Parameters
    ----------
    field
        (CANVAS, CANVAS) float32, the sketch's TSDF less ``FAR``, so that it vanishes far outside.
    mask
        (CANVAS, CANVAS) float32.
    """

    def __init__(self, waves: Waves, field: NDArray[np.float32], mask: NDArray[np.float32]) -> None:
        self._waves = waves
        self._constant = float(np.einsum("ij,ij,ij", mask, field, field))
        ours = waves.spectrum(np.stack([-2 * mask * field, mask]))  # (term, x, y)
        mirrored = ours[..., ::-1].conj()
        both = np.stack([ours, mirrored]).transpose(2, 0, 1, 3)  # (x, flip, term, y)
        # Translation t turns the product of our wave with the conjugate of theirs; the sum over
        # the y waves is a matrix product, of real numbers so that it is a fast one.
        turned = both[:, :, None] * waves.back_along_y[None, None, :, None]  # (x, flip, t, term, y)
        turned = turned.reshape(len(turned), -1, ours.shape[0] * ours.shape[2])
        real, imaginary = turned.view(np.float32), (-1j * turned).view(np.float32)
        self._along_y = np.stack([real, imaginary], axis=1).swapaxes(-1, -2)

    def errors(self, spectra: NDArray[np.complex64]) -> NDArray[np.float32]:
        """Return the errors of exemplars, given by ``spectra_of``, at every translation tried.

        Returns
        -------
        (v, 2, steps along y, steps along x) float32
            The second axis says whether the exemplar is mirrored; steps along x then count to the
            other side, as it is the sketch that is mirrored.
        """
        steps = len(self._waves.steps)
        theirs = spectra.view(np.float32)[:, None]  # (x, 1, v, terms)
        along_x = theirs @ self._along_y  # (x, 2, v, flips and steps)
        count = along_x.shape[2]
        errors = along_x.reshape(-1, count * 2 * steps).T @ self._waves.back_along_x
        errors += self._constant
        return errors.reshape(count, 2, steps, steps)
