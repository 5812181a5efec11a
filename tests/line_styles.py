"""Styles and shapes for tests of *Curve Analogies*, made by formulas, and how they are measured."""

import numpy as np

from iconstudio.algorithms.curves.curve import Curve
from iconstudio.algorithms.curves.example import Pair

LONG = 800


def _noise(count, step, sigma, random):
    """Smooth random numbers of standard deviation 1."""
    reach = int(4 * sigma / step)
    kernel = np.exp(-0.5 * (np.arange(-reach, reach + 1) * step / sigma) ** 2)
    smooth = np.convolve(random.normal(size=count + 2 * reach), kernel, "valid")
    return smooth / smooth.std()


def jitter():
    x = np.arange(0, LONG, 0.5)
    return x + 3j * _noise(len(x), 0.5, 6, np.random.default_rng(1))


def castle():
    random = np.random.default_rng(1)
    points, height = [0j], 0
    while points[-1].real < LONG:
        points.append(points[-1] + random.uniform(10, 16))
        height = 8 - height
        points.append(points[-1].real + 1j * height)
    return np.array(points)


def loops():
    angle = np.arange(0, LONG / 26 * 2 * np.pi, 0.05)
    size = 8 + 1.5 * _noise(len(angle), 0.05, 3, np.random.default_rng(1))
    return 26 * angle / (2 * np.pi) + size * np.exp(1j * angle)


def brush():
    random = np.random.default_rng(1)
    x = np.arange(0, LONG, 0.5)
    return x + 1j * (2 * _noise(len(x), 0.5, 14, random) + 0.5 * _noise(len(x), 0.5, 2, random))


STYLES = {one.__name__: one for one in (jitter, castle, loops, brush)}


def pair_of(styled):
    """A style's example, along the straight line in its middle."""
    ends = np.array([styled.real.min(), styled.real.max()])
    return Pair.of(ends + 1j * styled.imag.mean(), styled)


def unit(points, closed=False):
    """A curve with parameters from 0 to 1."""
    return Curve.of(points, closed).unit


def circle(radius=90.0):
    return unit(128 + 128j + radius * np.exp(2j * np.pi * np.arange(400) / 400), True)


def rounded_square(side=180.0, radius=40.0):
    turn = radius * np.exp(1j * np.linspace(0, np.pi / 2, 40))
    inset = side / 2 - radius
    corners = [(turn + inset + 1j * inset) * 1j**k for k in range(4)]
    return unit(128 + 128j + np.concatenate(corners), True)


def spectrum(made, plain, step=1.0):
    """The power of the directions relative to the plain line's, in half octaves, adding up to 1."""
    curve = made.resampled(step)
    points = np.append(curve.points, curve.points[:1]) if curve.closed else curve.points
    ways = np.diff(points)
    along = plain.arc_at(curve.parameters[: len(ways)])
    sweep = plain.at_arc(along + 2) - plain.at_arc(along - 2)
    relative = ways / abs(ways) * (sweep / abs(sweep)).conj()
    relative = (relative - relative.mean()) * np.hanning(len(relative))
    power = abs(np.fft.fft(relative)) ** 2
    frequency = abs(np.fft.fftfreq(len(relative), step))
    edges = 2.0 ** (-7 + np.arange(13) / 2)
    bands = np.histogram(frequency, edges, weights=power)[0]
    return bands / bands.sum()


def offset(made, plain):
    """The root of the mean square of how far a curve is from the plain one."""
    dense = plain.resampled(0.5).points
    return np.sqrt(np.mean([abs(dense - one).min() ** 2 for one in made.resampled(1.0).points]))


def misfit(some, others, half=12.0):
    """The median over windows of one curve of the rigid RMS to the best window of another."""
    k = np.arange(-half, half + 1)

    def windows(curve, every):
        inset = 0 if curve.closed else half
        found = curve.at_arc(np.arange(inset, curve.length - inset, every)[:, None] + k)
        return found - found.mean(axis=1, keepdims=True)

    a, b = windows(some, 4.0), windows(others, 1.0)
    energy = (abs(a) ** 2).sum(axis=1)[:, None] + (abs(b) ** 2).sum(axis=1)
    best = (energy - 2 * abs(a @ b.conj().T)).min(axis=1)
    return np.median(np.sqrt(np.maximum(best, 0) / len(k)))
