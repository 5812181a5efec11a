"""The layers' own colours, completed where others hide them, and their collapse (section 3)."""

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import distance_transform_edt

from iconstudio.algorithms.patterns.distance import coverage
from iconstudio.algorithms.patterns.exemplar import Colours, Distances, Exemplar, Places

Paints = NDArray[np.float32]
"""(L + 1, h, w, 3): the colours of each layer, then those of the ground below all."""

_SURE = 0.99


def paints(exemplar: Exemplar) -> Paints:
    """Return the colours that each layer has by itself.

    Those of its foreground, where it is not hidden; elsewhere, as along its soft edge and below
    other layers, the colour of the nearest such pixel.
    """
    above = np.zeros(exemplar.masks.shape[1:], np.float32)
    colours = []
    for mask in (*exemplar.masks, np.ones_like(above)):
        seen = (1 - above) * mask
        colours.append(_completed(exemplar.colours, seen))
        above = np.maximum(above, mask)
    return np.stack(colours)


def _completed(colours: Colours, seen: NDArray[np.float32]) -> Colours:
    """Return colours of which only those are right that are ``seen`` (h, w), from 0 to 1."""
    most = seen.max()
    if most == 0:
        return colours
    unknown = seen < min(_SURE, most)
    nearest = distance_transform_edt(unknown, return_distances=False, return_indices=True)
    completed: Colours = colours[tuple(nearest)]
    return completed


def collapse(distances: Distances, sources: list[Places], colours: Paints) -> Colours:
    """Return the picture of layers in their order, each over those that follow it.

    Parameters
    ----------
    distances
        (L, H, W)
    sources
        L + 1 times (H, W, 2): where in the exemplar each layer, and the ground, has its colours.
    colours
        Those of the exemplar, of ``paints``.
    """
    picture: Colours = _taken(colours[-1], sources[-1])
    for m in reversed(range(len(distances))):
        over = coverage(distances[m])[..., None]
        picture = over * _taken(colours[m], sources[m]) + (1 - over) * picture
    return picture


def _taken(colours: Colours, source: Places) -> Colours:
    taken: Colours = colours[source[..., 0], source[..., 1]]
    return taken
