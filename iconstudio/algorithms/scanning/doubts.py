"""What makes one doubt a drawing: lines too faint to be ink, and shading as on photos."""

import math

import numpy as np
import scipy
from numpy.typing import NDArray

from iconstudio.algorithms.extremes import greatest_channel, maximum_filter, minimum_filter
from iconstudio.algorithms.scanning.margin import box_of, rim_of

SPECK = 72
"""Most pixels of what is taken for dirt, on the paper or in the ink."""
SPOT = 8
"""Most pixels of what is dirt, however thin the lines are."""
_GRAIN = 3
"""Most pixels of what is no dot, whoever made it."""
_LETTERS, _SEVERAL = 5, 4
"""Half the width in pixels of the gaps between letters, and how many are writing, at least."""
_ROUND, _OBLONG = 0.65, 1.5
"""How much of its bounding box a dot fills at least, and how oblong that is at most."""
_AS_WIDE, _AS_DARK = 0.8, 0.85
"""What is no dirt has so much of the width of a drawing's lines, and of their darkness, at least:
the pen touched the paper there."""
_GRADUAL, _SOFT, _SOFTEST = 0.01, 6, 12
"""Shading changes by so much from pixel to pixel, at so many pixels from the edge of ink; at more
if that is out of focus, but no more than the last."""
_SLIM = 8
"""Half the width in pixels of a faint line: the rules of a notebook, or the rim of a stain."""
_BESIDE = 3
"""Pixels beside ink that its blurred edges reach."""
VISIBLE, _GRAINS, _SHORT = 0.02, 8.0, 0.1
"""How much darker than paper the faintest lines of a drawing are, also in grains of it; how long
they are, as part of the picture."""
CLEAN = 0.08
"""As the first, where no camera or scanner saw the drawing."""
_FAINTER = 0.02
"""How much of them beside ink is told."""
_THICK = 7
"""Pixels across of what is no line but a shadow or a stain."""
_DOTS = 0.25
"""How much of a drawing in faint lines its dots span, which alone are ink, at most."""
_UNLIKE, _FEWEST = 0.82, 16
"""How much neighbours differ in noise, as part of any two pixels, at least; pixels to a side of the
coarsest picture that is asked."""
_SAME = 3
"""Levels by which a single colour varies in lossy files."""
PLAIN = "No drawing can be made out on it: it is one plain area of a single colour."
LEAST = 0.12
"""A drawing is darker than its paper by so much at least, of all the way to black: what is so much
darker is no noise."""


def has_fainter_lines(
    dark: NDArray[np.float32],
    light: NDArray[np.float32],
    threshold: float,
    visible: float = VISIBLE,
) -> bool:
    """Whether long lines can be seen beside the ink of a picture that are too faint to be ink.

    They are darker in ``light`` (h, w, c), the picture itself, than both of their sides. What is
    darker than one of them is the edge of a shadow.
    """
    ink = dark > threshold
    away = ~scipy.ndimage.binary_dilation(ink, iterations=_BESIDE)
    paper = dark[away]
    if not paper.size:
        return False
    around = (2 * _SLIM + 1, 2 * _SLIM + 1, 1)
    groove = greatest_channel(scipy.ndimage.grey_closing(light, around) - light)
    seen = away & (dark > _faintest(paper, visible)) & (groove > visible / 2)
    lines, _ = scipy.ndimage.label(seen, np.ones((3, 3)))
    long = np.zeros(lines.max() + 1, bool)
    for number, box in enumerate(scipy.ndimage.find_objects(lines), 1):
        long[number] = max(side.stop - side.start for side in box) > _SHORT * max(seen.shape)
    return bool(long[lines].sum() > _FAINTER * ink.sum())


def _faintest(paper: NDArray[np.float32], visible: float) -> float:
    """Return how dark the faintest lines on paper (n,) are."""
    middle = np.median(paper)
    grain = 1.48 * np.median(abs(paper - middle))
    return float(middle + max(visible, _GRAINS * grain))


def drawing_in_faint_lines(dark: NDArray[np.float32], threshold: float) -> NDArray[np.bool_] | None:
    """Return the lines (h, w) of a drawing of which no more than a few dots are ink; None if not.

    A line that is thinner than a pixel is fainter than a dot by the same pencil. What reaches the
    rim, as the rules of a notebook do, is none.
    """
    ink = box_of(without_specks(dark > threshold, SPOT))
    paper = dark[dark < threshold]
    seen = dark > _faintest(paper, VISIBLE)
    labels, _ = scipy.ndimage.label(seen, np.ones((3, 3)))
    shaded = scipy.ndimage.binary_opening(seen & (dark < threshold), np.ones((_THICK, _THICK)))
    no_lines = {0, *np.unique(rim_of(labels)), *np.unique(labels[shaded])}
    lines = np.zeros(seen.shape, bool)
    for number, box in enumerate(scipy.ndimage.find_objects(labels), 1):
        long = max(side.stop - side.start for side in box) > _SHORT * max(seen.shape)
        if long and number not in no_lines:
            lines[box] |= labels[box] == number
    around = box_of(lines & (dark < threshold))
    if ink is None or around is None or dark[ink].size > _DOTS * dark[around].size:
        return None
    return lines


def is_plain(pixels: NDArray[np.uint8]) -> bool:
    """Whether a picture (h, w, c) shows one colour, all over."""
    seen = pixels.shape[2] == 3 or pixels[..., 3].any()
    return bool(seen and np.ptp(pixels, axis=(0, 1)).max() <= _SAME)


def is_noise(pixels: NDArray[np.uint8]) -> bool:
    """Whether each pixel (h, w, c) is as unlike its neighbours as any other, however coarsely seen.

    Of a drawing, however noisy, neighbours are alike at some resolution.
    """
    levels = pixels.astype(np.float32)
    spread = levels.var(axis=(0, 1)).sum()
    while spread > 1:
        apart = [(np.diff(levels, axis=axis) ** 2).mean(axis=(0, 1)).sum() / 2 for axis in (0, 1)]
        if min(apart) < _UNLIKE * spread:
            return False
        height, width = (side // 2 for side in levels.shape[:2])
        if min(height, width) < _FEWEST:
            return True
        levels = levels[: 2 * height, : 2 * width]
        levels = levels.reshape(height, 2, width, 2, -1).mean(axis=(1, 3))
        spread = levels.var(axis=(0, 1)).sum()
    return False


def shading(dark: NDArray[np.float32], threshold: float, scale: float) -> float:
    """Return how much of what is not paper is neither ink, its edge nor a line, from 0 to 1.

    What was enlarged much by ``scale``, or is out of focus, has wider edges.
    """
    ink = dark > threshold
    even = scipy.ndimage.gaussian_filter(dark, 2.0)  # without noise
    slope = np.hypot(*np.gradient(np.pad(even, 1, mode="edge")))[1:-1, 1:-1]
    enlarged = max(1.0, scale / 2)
    width = round(np.clip(_spread(ink, dark, slope), _SOFT * enlarged, _SOFTEST * enlarged))
    size, inner = 2 * width + 1, np.s_[width:-width, width:-width]
    low = minimum_filter(np.pad(ink, width), size)[inner]  # beyond the picture is paper
    edge = maximum_filter(ink, size) & ~low
    visible = even > LEAST
    around = 2 * round(_SLIM * enlarged) + 1
    wide = maximum_filter(minimum_filter(even, around), around) > LEAST
    shaded = visible & ~edge & (slope > _GRADUAL) & maximum_filter(wide, around)
    return float(shaded.sum() / max(1, visible.sum()))


def _spread(ink: NDArray[np.bool_], dark: NDArray[np.float32], slope: NDArray[np.float32]) -> float:
    """Return over how many pixels the sharpest edges of ink are spread: three of their sigmas.

    All edges of a drawing out of focus are alike; of other photos, some are sharp.
    """
    rim = ink & ~scipy.ndimage.binary_erosion(ink)
    if not rim.any():
        return 0.0
    steepest = max(float(np.percentile(slope[rim], 90)), 1e-6)
    return 3 * float(np.median(dark[ink])) / (math.sqrt(2 * math.pi) * steepest)


def without_dirt(ink: NDArray[np.bool_], dark: NDArray[np.number]) -> NDArray[np.bool_]:
    """Return ink (h, w) without small parts that no pen of its lines made, by their darkness.

    However small a dot is beside a large drawing, it is as wide as the line, and as dark.
    """
    clean = without_specks(ink, SPECK)
    spots = without_specks(ink & ~clean, SPOT)
    if not spots.any() or not clean.any():
        return clean
    width = scipy.ndimage.distance_transform_edt(np.pad(ink, 1))[1:-1, 1:-1]
    middle = clean & (width >= maximum_filter(width, 3))
    labels, count = scipy.ndimage.label(spots)
    widest, darkest = (
        scipy.ndimage.maximum(values, labels, np.arange(count + 1)) for values in (width, dark)
    )
    drawn = widest >= _AS_WIDE * np.median(width[middle])
    drawn &= darkest >= _AS_DARK * np.median(dark[middle])
    drawn[0] = False
    cleaned: NDArray[np.bool_] = clean | drawn[labels]
    return cleaned


def without_crumbs(shape: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Return a shape that was told by its colours without its smallest parts, but for dots."""
    clean = without_specks(shape, SPECK)
    return clean | dots(shape & ~clean, SPOT)


def dots(shape: NDArray[np.bool_], speck: int = _GRAIN) -> NDArray[np.bool_]:
    """Return what of a shape (h, w) is as round as dots are, and of more than ``speck`` pixels."""
    found = np.zeros_like(shape)
    spots, _ = scipy.ndimage.label(without_specks(shape, speck))
    for number, box in enumerate(scipy.ndimage.find_objects(spots), 1):
        spot = spots[box] == number
        if spot.mean() > _ROUND and max(spot.shape) < _OBLONG * min(spot.shape):
            found[box] |= spot
    return found


def writing(shape: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Return what of a shape (h, w) are small parts, several side by side, as letters are."""
    parts = without_specks(shape, 1)
    lines, _ = scipy.ndimage.label(maximum_filter(parts, 2 * _LETTERS + 1))
    numbers, _ = scipy.ndimage.label(parts, np.ones((3, 3)))
    of_each = np.unique(np.stack([lines[parts], numbers[parts]]), axis=1)[0]
    several = np.bincount(of_each, minlength=lines.max() + 1) >= _SEVERAL
    found: NDArray[np.bool_] = parts & several[lines]
    return found


def without_specks(shape: NDArray[np.bool_], speck: int) -> NDArray[np.bool_]:
    """Return a shape without parts of at most ``speck`` pixels."""
    labels, _ = scipy.ndimage.label(shape)
    large = np.bincount(labels.ravel()) > speck
    large[0] = False
    cleaned: NDArray[np.bool_] = large[labels]
    return cleaned
