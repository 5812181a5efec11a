"""A sheet of paper that lies on a desk is told from the desk."""

from collections.abc import Iterator

import numpy as np
import scipy
from numpy.typing import NDArray

from iconstudio.algorithms.scanning.margin import rim_of
from iconstudio.algorithms.scanning.quadrangle import quadrangularity

_LEAST, _MOST = 0.12, 0.995
"""How much of a picture a sheet that lies on something darker may cover."""
_STRAIGHT = 0.9
"""How much of the smallest quadrangle around it a sheet fills."""
_CONTRAST = 0.15
_SHARP = 0.3
"""So much of the contrast between sheet and desk lies in the edge between them, not in light."""
_ALL_BUT = 0.8
"""The drawing may touch the edge of the sheet somewhere."""
_BEYOND = 0.5
"""How much of the edge of the picture that is not of the sheet is of the desk, at least."""
_BLUR = 1.5
_GLINT = 3
"""Half the width in pixels of what is too slim to be part of a sheet."""
_TINGE = 0.12
"""Paper in the shadow differs in colour from paper in the light by no more, as part of it."""
_DARK = 0.02
"""What is no brighter has no colour that could be compared."""
_INK, _DRAWN = 0.6, 0.002
"""Ink is so dark beside its paper, and covers so much of it, at least."""
_FLAT, _NOISY = 1.5 / 255, 16 / 255
"""What was photographed varies by more; and paper beside edges, by the noise of lossy files."""
_SAME = 0.06
"""Colours that differ by no more are one."""


def sheet_on_desk(picture: NDArray[np.float32]) -> NDArray[np.bool_] | None:
    """Return (h, w) where a sheet lies, (h, w, 3) in sRGB from 0 to 1; None if no desk is seen.

    A sheet is a light quadrangle with something darker or more colourful around it, and a sharp
    edge between them. Paper in shadow beside it is no desk. A white card on a drawing from a
    computer looks like that, too; but what is cut out of a card shows the ground, and ink on a
    sheet does not.
    """
    best, found = 0.0, None
    for light in (picture @ np.array([0.2126, 0.7152, 0.0722], np.float32), picture.min(axis=2)):
        if np.ptp(light) < _CONTRAST:
            continue
        for level in _levels(light):
            sheet, straight = _sheet(light, level)
            if straight <= best or not _goes_on(light <= level, ~sheet):
                continue
            if _is_card(picture, light > level, sheet):
                continue
            if not _is_in_shadow(picture, ~sheet):
                best, found = straight, sheet
    return found


def _levels(light: NDArray[np.float32]) -> Iterator[float]:
    """Yield brightnesses that may part a sheet from a desk, or from a desk and from ink."""
    from skimage.filters import threshold_multiotsu, threshold_otsu

    yield float(threshold_otsu(light))
    try:
        yield from map(float, threshold_multiotsu(light, 3, nbins=64)[::-1])
    except ValueError:
        return  # fewer than three brightnesses


def _sheet(light: NDArray[np.float32], level: float) -> tuple[NDArray[np.bool_], float]:
    """Return what may be the sheet among what is brighter than a level, and how straight it is.

    That is 0 if it is none.
    """
    # Without glints on the desk that touch the sheet.
    bright = scipy.ndimage.binary_opening(light > level, iterations=_GLINT)
    labels, count = scipy.ndimage.label(bright)
    if not count:
        return bright, 0.0
    largest = labels == 1 + int(np.argmax(np.bincount(labels.ravel())[1:]))
    sheet = scipy.ndimage.binary_fill_holes(largest)
    if not _LEAST < sheet.mean() < _MOST:
        return sheet, 0.0
    straight = quadrangularity(sheet)
    contrast = np.median(light[largest]) - np.median(light[~sheet])
    usable = straight > _STRAIGHT and contrast > _CONTRAST
    return sheet, straight if usable and _is_sharp(light, sheet, _SHARP * contrast) else 0.0


def _is_sharp(light: NDArray[np.float32], sheet: NDArray[np.bool_], step: float) -> bool:
    """Whether brightness falls at once by a step nearly everywhere around a sheet."""
    slope = scipy.ndimage.gaussian_gradient_magnitude(light, _BLUR, mode="nearest")
    steps = scipy.ndimage.maximum_filter(slope, 5) * (_BLUR * np.sqrt(2 * np.pi))
    rim = sheet & ~scipy.ndimage.binary_erosion(sheet, border_value=1)
    return bool(np.mean(steps[rim] > step) > _ALL_BUT)


def _goes_on(dark: NDArray[np.bool_], outside: NDArray[np.bool_]) -> bool:
    """Whether a desk reaches the edge of the picture: what does not is drawn on the sheet."""
    beyond = rim_of(dark)[rim_of(outside)]
    return bool(beyond.size and beyond.mean() > _BEYOND)


def _is_card(
    picture: NDArray[np.float32], bright: NDArray[np.bool_], sheet: NDArray[np.bool_]
) -> bool:
    """Whether this was drawn by a computer, and what is cut out of the light shows its ground."""
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
