"""The punch holes of a sheet are told from dots that are drawn.

Two or more lie near one side of the sheet and along it, about its middle, far apart; they are
round, dark all over, of one size, and nothing is drawn between them and that side.
"""

import numpy as np
import scipy
from numpy.typing import NDArray

from iconstudio.algorithms.scanning.quadratic import quadratic
from iconstudio.algorithms.tones.regions import Mask

_DARK = 0.25
"""How much darker than the paper holes are, at least, as part of it."""
_LEAST, _MOST = 0.008, 0.06
"""Diameter of a hole, as part of the longer side of the sheet."""
_FILLED, _OBLONG = 0.65, 1.35
"""How much of its bounding box a hole fills, and how oblong that is at most."""
_ALIKE = 0.3
"""By how much holes of one sheet differ in diameter, as part of it."""
_FAR, _ASKEW = 0.12, 0.02
"""How far the middle of a hole is from the side of the sheet, as part of its longer side; and by
how much that varies along the side, as a sheet may lie askew."""
_APART = 5.0
"""How far holes are apart, at least, in diameters."""
_CENTRED = 0.12
"""How far the middle of all holes is from that of the side, as part of it."""
_AROUND = 0.5
"""How far around a hole nothing is drawn, in diameters; its edges are blurred there."""


def punch_holes(picture: NDArray[np.float32]) -> Mask | None:
    """Return the punch holes of a sheet and a little around them, (h, w), or None.

    ``picture`` is (h, w, 3) in sRGB from 0 to 1; the sheet fills it.
    """
    light = picture.mean(axis=2, keepdims=True)
    paper = quadratic(light, light[..., 0] >= np.median(light))
    seen = (light < (1 - _DARK) * paper)[..., 0]
    longest = max(seen.shape)
    pieces, _ = scipy.ndimage.label(seen, np.ones((3, 3)))
    boxes = scipy.ndimage.find_objects(pieces)
    round_ = [
        (number, _middle(at), _diameter(at))
        for number, at in enumerate(boxes, 1)
        if _LEAST * longest < _diameter(at) < _MOST * longest
        and max(_sides(at)) < _OBLONG * min(_sides(at))
        and (pieces[at] == number).mean() > _FILLED
    ]
    for axis in (0, 1):
        for far_side in (False, True):
            reach = seen.shape[1 - axis]
            found = [
                (
                    number,
                    middle[axis],
                    reach - middle[1 - axis] if far_side else middle[1 - axis],
                    d,
                )
                for number, middle, d in round_
            ]
            holes = _along(found, seen.shape[axis], longest)
            if holes and _is_bare(pieces, holes, axis, far_side):
                wide = 1 + round(_AROUND * max(d for *_, d in holes))
                mask = np.isin(pieces, [number for number, *_ in holes])
                around: NDArray[np.bool_] = scipy.ndimage.binary_dilation(mask, iterations=wide)
                return around
    return None


_Hole = tuple[int, float, float, float]
"""Its number, where it is along a side, how far from it, and its diameter."""


def _along(found: list[_Hole], length: int, longest: int) -> list[_Hole]:
    """Return the holes along a side of that length; empty if they are none."""
    near = sorted((hole for hole in found if hole[2] < _FAR * longest), key=lambda hole: hole[1])
    if len(near) < 2:
        return []
    _, at, away, diameters = (np.array(values) for values in zip(*near, strict=True))
    usual = np.median(diameters)
    alike = abs(diameters - usual).max() < max(_ALIKE * usual, 2)
    apart = np.diff(at).min() > _APART * usual
    straight = np.ptp(away) < max(_ASKEW * longest, 2)
    centred = abs((at[0] + at[-1]) / 2 - length / 2) < _CENTRED * length
    return near if alike and apart and straight and centred else []


def _is_bare(pieces: NDArray[np.int32], holes: list[_Hole], axis: int, far_side: bool) -> bool:
    """Whether nothing but holes lies between them and the side."""
    turned = pieces if axis == 0 else pieces.T
    deepest = round(max(away + diameter for _, _, away, diameter in holes))
    band = turned[:, -deepest:] if far_side else turned[:, :deepest]
    rest = (band > 0) & ~np.isin(band, [number for number, *_ in holes])
    return not scipy.ndimage.binary_opening(rest, np.ones((2, 2))).any()


def _sides(at: tuple[slice, ...]) -> list[int]:
    return [side.stop - side.start for side in at]


def _diameter(at: tuple[slice, ...]) -> float:
    return sum(_sides(at)) / 2


def _middle(at: tuple[slice, ...]) -> tuple[float, ...]:
    return tuple((side.start + side.stop) / 2 for side in at)
