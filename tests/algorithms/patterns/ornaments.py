"""Small exemplars of known shapes."""

import numpy as np

from iconstudio.algorithms.patterns.exemplar import Exemplar

SIDE = 64
Y, X = np.mgrid[:SIDE, :SIDE].astype(np.float32)


def soft(distance):
    """The coverage of what lies where distances are negative."""
    return np.clip(0.5 - distance, 0, 1).astype(np.float32)


def disc(y, x, radius):
    return np.hypot(Y - y, X - x) - radius


def black_on_white(mask, **options):
    colours = np.repeat(1 - mask[..., None], 3, axis=2)
    return Exemplar(colours, mask[None], **options)


def shapes():
    """Two discs, two rings and a square, with a blank ground; one more is cut by the border."""
    square = np.maximum(np.abs(Y - 47), np.abs(X - 15)) - 7
    rings = [np.abs(disc(*at)) - 1.6 for at in ((14, 15, 7), (46, 47, 8))]
    discs = [disc(14, 46, 8), disc(31, 31, 5), disc(63, 33, 6)]
    return black_on_white(soft(np.minimum.reduce([square, *rings, *discs])))


def stripes(period=16):
    return black_on_white(soft(np.abs((Y + 0.5) % period - period / 2) - period / 4))


def checks(period=16):
    wave = np.sin(2 * np.pi * (Y + 0.5) / period) * np.sin(2 * np.pi * (X + 0.5) / period)
    return black_on_white((wave > 0).astype(np.float32))


def two_layers():
    """Red discs over a blue grid on yellow."""
    above = soft(np.minimum.reduce([disc(y, x, 7) for y in (16, 48) for x in (16, 48)]))
    below = soft(np.minimum(np.abs(Y % 32 - 16), np.abs(X % 32 - 16)) - 2)
    red, blue, yellow = np.eye(3, dtype=np.float32)[[0, 2, 0]]
    yellow = yellow + np.float32([0, 1, 0])
    ground = yellow + below[..., None] * (blue - yellow)
    return Exemplar((ground + above[..., None] * (red - ground)).astype(np.float32),
                    np.stack([above, below]))  # fmt: skip
