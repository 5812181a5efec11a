"""A coloured note that lies on something paler is told, and what is drawn upon it."""

import numpy as np
import scipy
from numpy.typing import NDArray

from iconstudio.algorithms.extremes import greatest_channel
from iconstudio.algorithms.scanning.quadrangle import quadrangle, quadrangularity
from iconstudio.algorithms.scanning.quadratic import quadratic

Mask = NDArray[np.bool_]

_APART = 0.08
"""By how much a channel of the note differs from the desk, as part of it, at least."""
_LEAST, _MOST = 0.06, 0.8
"""How much of a picture a note covers."""
_STRAIGHT = 0.95
"""How much of its quadrangle a note fills."""
_BLANK, _ALIKE = 0.7, 0.2
"""How much of a note is blank, and by how much that varies, as part of its colour."""
_INK, _DRAWN = 0.7, 0.002
"""What is drawn is so dark beside the note, and covers so much of it, at least."""
_MARGIN, _CLEAR = 0.03, 0.05
"""Width of the edge of a note, as part of its size; how much of that is drawn upon at most: a box
that was drawn has lines there."""
_PAPER = 0.3
"""Brightness of a note, at least."""
_RIM = 6
"""Pixels along the edge of a picture that show the desk."""
_ALONE = 0.1
"""How much lies beside a note on the desk, as part of it, at most."""


def note_on_desk(picture: NDArray[np.float32]) -> Mask | None:
    """Return (h, w) where a note lies, (h, w, 3) in sRGB from 0 to 1; None if no desk is seen.

    A note is a quadrangle of one colour with something darker drawn on it, and lies free on a desk
    that is lit by degrees. Along its sides nothing is drawn.
    """
    from skimage.draw import polygon2mask

    rim = np.ones(picture.shape[:2], bool)
    rim[_RIM:-_RIM, _RIM:-_RIM] = False
    desk = quadratic(picture, rim)
    away = greatest_channel(abs(picture - desk) / np.maximum(desk, _APART)) > _APART
    away = scipy.ndimage.binary_opening(away, iterations=2)
    pieces, _ = scipy.ndimage.label(away)
    sizes = np.bincount(pieces.ravel())
    sizes[0] = 0
    if not _LEAST * away.size < sizes.max(initial=0) < _MOST * away.size:
        return None
    note = scipy.ndimage.binary_fill_holes(pieces == sizes.argmax())
    if (away & ~note).sum() > _ALONE * note.sum() or quadrangularity(note) < _STRAIGHT:
        return None
    light = picture.mean(axis=2)
    middle = np.median(picture[note], axis=0)
    blank = note & (greatest_channel(abs(picture - middle)) < _ALIKE * max(middle.max(), _PAPER))
    ink = note & (light < _INK * middle.mean())
    depth = scipy.ndimage.distance_transform_edt(note)
    edge = note & (depth < _MARGIN * np.sqrt(note.sum())) & (depth > 2)
    if (
        middle.mean() < _PAPER
        or blank.sum() < _BLANK * note.sum()
        or ink.sum() < _DRAWN * note.sum()
        or ink[edge].mean() > _CLEAR
    ):
        return None
    corners, _ = quadrangle(note)
    whole: Mask = polygon2mask(note.shape, corners) & note
    return whole
