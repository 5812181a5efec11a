"""A sheet of paper that lies on a desk is told from the desk."""

import numpy as np
import scipy
from numpy.typing import NDArray

from iconstudio.algorithms.scanning.ground import unevenness
from iconstudio.algorithms.scanning.margin import rim_of
from iconstudio.algorithms.scanning.note import note_on_desk
from iconstudio.algorithms.scanning.quadrangle import quadrangularity
from iconstudio.algorithms.scanning.sides import sheet_by_its_sides

_STRAIGHT = 0.9
"""How much of the smallest quadrangle around it a sheet fills."""
_BLUR = 1.5
_GLINT = 3
"""Half the width in pixels of what is too slim to be part of a sheet."""
_TINGE = 0.12
"""Paper in the shadow differs in colour from paper in the light by no more, as part of it."""
_DIMMEST = 0.2
"""How bright paper is, at least: a glow on something dark is none."""
_DARK = 0.02
"""What is no brighter has no colour that could be compared."""
_SHADE = 0.3
"""What is darker than the sheet by so much, as part of it, may be ink."""
_INK, _DRAWN = 0.6, 0.002
"""Ink is so dark beside its paper, and covers so much of it, at least."""
_FLAT, _NOISY = 1.5 / 255, 16 / 255
"""What was photographed varies by more; and paper beside edges, by the noise of lossy files."""
_EXACT, _ALIKE = 2.5 / 255, 0.85
"""By how much what a computer painted strays at most, and how much of it does not."""
_ACROSS, _LEVEL, _PAINTED = 5, 0.75 / 255, 0.4
"""How much of what it painted does not vary at all within so many pixels, also in lossy files."""
_FEWEST = 100
"""Pixels of the shorter side of a photo, at least: of fewer, edges and noise leave nothing even."""
_SAME = 0.06
"""Colours that differ by no more are one."""


def sheet_on_desk(picture: NDArray[np.float32]) -> NDArray[np.bool_] | None:
    """Return (h, w) where a sheet lies, (h, w, 3) in sRGB from 0 to 1; None if no desk is seen.

    A sheet is a light quadrangle with something darker or more colourful around it, and a sharp
    edge between them. Paper in shadow beside it is no desk. A white card on a drawing from a
    computer looks like that, too; but what is cut out of a card shows the ground, and ink on a
    sheet does not.
    """
    sheet = sheet_by_its_sides(picture)
    if sheet is None or np.median(picture[sheet].max(axis=1)) < _DIMMEST:
        return None
    if _is_card(picture, sheet) or _is_in_shadow(picture, ~sheet):
        return None
    return sheet


def photographed_sheet(picture: NDArray[np.float32]) -> NDArray[np.bool_] | None:
    """Return as ``sheet_on_desk`` does, but only if sheet and desk look as cameras see them.

    Neither has one colour all over then, as light and grain are uneven.
    """
    if min(picture.shape[:2]) < _FEWEST or _is_of_one_colour(rim_of(picture)):
        return None
    sheet = sheet_on_desk(picture)
    if sheet is None:
        sheet = note_on_desk(picture)
    if sheet is None:
        return None
    paper = sheet & (picture.mean(axis=2) > np.median(picture[sheet]) * (1 - _SHADE))
    even = unevenness(picture, _ACROSS) < _LEVEL
    painted = any(
        _is_of_one_colour(picture[part]) or even[part].mean() > _PAINTED for part in (paper, ~sheet)
    )
    return None if painted else sheet


def _is_of_one_colour(colours: NDArray[np.float32]) -> bool:
    away = abs(colours - np.median(colours, axis=0)).max(axis=1)
    return bool((away < _EXACT).mean() > _ALIKE)


def _is_card(picture: NDArray[np.float32], sheet: NDArray[np.bool_]) -> bool:
    """Whether this was drawn by a computer, and what is cut out of the light shows its ground."""
    light = picture.mean(axis=2)
    bright = light >= (np.median(light[sheet]) + np.median(light[~sheet])) / 2
    outside, paper = ~sheet, sheet & bright
    if not (_is_flat(picture[outside], _FLAT) and _is_flat(picture[paper], _NOISY)):
        return False
    ink = sheet & ~bright
    ink[:_GLINT], ink[-_GLINT:], ink[:, :_GLINT], ink[:, -_GLINT:] = False, False, False, False
    ink &= scipy.ndimage.binary_erosion(sheet, iterations=2 * _GLINT, border_value=1)
    core = scipy.ndimage.binary_erosion(ink, iterations=2)
    if not core.any():
        core = ink
    if not core.any():
        return True
    difference = np.median(picture[core], axis=0) - np.median(picture[outside], axis=0)
    return bool((abs(difference) < _SAME).all())


def _is_in_shadow(picture: NDArray[np.float32], outside: NDArray[np.bool_]) -> bool:
    """Whether what lies on one side of a sheet is more of it in the shadow, and drawn upon.

    It is of the same tinge then, and not all of it is equally dark.
    """
    # Without what is left of light paper along the edge of the picture.
    outside = scipy.ndimage.binary_opening(outside, iterations=_GLINT)
    if quadrangularity(outside) <= _STRAIGHT:
        return False
    shadow, paper = (np.median(picture[part], axis=0) for part in (outside, ~outside))
    bright = paper > _DARK  # yellow paper has no blue, nor has it in the shadow
    if not bright.any() or (shadow[~bright] > _DARK).any():
        return False
    shade = shadow[bright] / paper[bright]
    if np.ptp(shade) > _TINGE * shade.mean():
        return False
    light = scipy.ndimage.gaussian_filter(picture.mean(axis=2), _BLUR)
    inner = scipy.ndimage.binary_erosion(outside, iterations=2 * _GLINT)
    ink = inner & (light < _INK * np.median(light[outside]))
    return bool(ink.sum() > _DRAWN * outside.sum())


def _is_flat(colours: NDArray[np.float32], most: float) -> bool:
    low, high = np.percentile(colours, (20, 80), axis=0)
    return bool((high - low < most).all())
