"""Pixels that blend two or three colours, as those of edges and corners do."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray


def unblended(
    pixels: NDArray[np.float32], colours: Sequence[NDArray[np.float32]]
) -> tuple[NDArray[np.float32], NDArray[np.float32]]:
    """Return how much of each pixel (n, c) each of one to three colours (n or 1, c) takes, (k, n).

    They add up to 1. Also how far the pixel is from that blend, squared, (n,); it is infinite where
    the nearest blend has nothing of one of the colours, or where they are no different.
    """
    *others, last = colours
    rest = pixels - last
    ways = [np.broadcast_to(other - last, rest.shape) for other in others]
    shares = _solved(ways, rest)
    for share, way in zip(shares, ways, strict=True):
        rest = rest - share[:, None] * way
    shares.append(1 - sum(shares, start=np.zeros(len(pixels), np.float32)))
    stacked = np.stack(shares)
    away = np.where((stacked >= 0).all(axis=0), _dot(rest, rest), np.float32(np.inf))
    return stacked, away


def _solved(
    ways: list[NDArray[np.float32]], rest: NDArray[np.float32]
) -> list[NDArray[np.float32]]:
    """Return the multiples of none, one or two ways whose sum is nearest to the rest."""
    if not ways:
        return []
    one = ways[0]
    own, along = _dot(one, one), _dot(one, rest)
    if len(ways) == 1:
        return [np.where(own < 1, -1, along / np.maximum(own, 1))]
    other = ways[1]
    its, both, across = _dot(other, other), _dot(one, other), _dot(other, rest)
    area = own * its - both**2
    flat = area <= 1e-3 * own * its
    area = np.where(flat, 1, area)
    return [
        np.where(flat, -1, (along * its - across * both) / area),
        np.where(flat, -1, (across * own - along * both) / area),
    ]


def _dot(one: NDArray[np.float32], other: NDArray[np.float32]) -> NDArray[np.float32]:
    product: NDArray[np.float32] = np.einsum("nc,nc->n", one, other)
    return product
