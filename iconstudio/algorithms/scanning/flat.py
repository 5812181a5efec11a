"""Bitmaps that a computer drew in colours, as emoji and app icons are: told, and made crisp.

A palette (``palette``) are the colours that areas are evenly painted with; at an edge, and in a
thin line, a pixel blends two of them. What part of a pixel each colour takes is enlarged, not the
pixels: so the edges of small bitmaps are as sharp as those of large ones, and no third colour
appears between two. What is lit unevenly, shaded or drawn with a pencil has no such palette, or no
even ground.
"""

from itertools import combinations

import numpy as np
import scipy
from numpy.typing import NDArray

from iconstudio.algorithms.extremes import maximum_filter, minimum_filter
from iconstudio.algorithms.scanning.blending import unblended
from iconstudio.algorithms.scanning.free import (
    FILLED,
    SPARSE,
    cut_drawing,
    has_colours,
    on_square,
    scaled,
)
from iconstudio.algorithms.scanning.ground import (
    AROUND,
    ASTRAY,
    CLEAR,
    Ground,
    ground_of,
    is_gradient,
)
from iconstudio.algorithms.scanning.margin import (
    PAPER,
    TINGE,
    box_of,
    corners_of,
    has_stripes,
    is_banner,
    rim_of,
)
from iconstudio.algorithms.scanning.palette import (
    SMALL,
    Palette,
    evenly_painted,
    is_in_one_colour,
    palette_of,
)
from iconstudio.algorithms.scanning.resampling import (
    numbered,
    premultiplied,
    resized,
    shrunk,
)
from iconstudio.algorithms.scanning.sheet import sheet_on_desk
from iconstudio.algorithms.tones.alternation import Omission
from iconstudio.algorithms.tones.tone import pictogram

_LONGEST = 384
"""Pixels of the longer side of the bitmap that is looked at."""
_MISSED, _MISSED_SMALL, _LOSSY = 0.04, 0.08, 0.15
"""Part of the drawing that may be of other colours than those of the palette and their blends; in
small bitmaps, more lies where colours meet; in lossy files, edges do."""
_LACKING, _DOTS = 4, 12
"""Colours of lines and dots that are added to a palette, at most; and those of dots alone."""
_ABSENT = 20.0
"""Levels that it costs to blend a colour that no even area near has."""
_GROUND = 0.9
"""How much of a pixel at the edge of a drawing is ground, at most."""
_PURE, _BY_DEGREES = 0.9, 0.045
"""How much of a pixel has one colour, if it is no blend; what part of a drawing may be blends in
the midst of blends."""
_NEAR = 7
"""Pixels across, of what is near."""
_BLEEDS = 0.5
"""How much of the rim a coloured ground has, at least; less is what shows beside an app icon."""
_DARK = 105.0
"""Levels below which a ground is dark, whatever its colour."""
_DESK = 0.75
"""How much of the rim a desk has at least around a sheet of paper, whose corners are sharp."""
_PAINT, _PAPER_AND_INK = 0.02, 2
"""How much of a sheet, or of what is around, a colour has to count; and how many a sheet has with
what is drawn on it. A desk has one."""
_ALL_ALONG = 0.98
"""How much of the lines beside a stripe has another colour, if that is a stripe, too."""
_IN_SHADOW = 0.1
"""How much of the rim has shades, where what has not is no ground."""
_FADING, _NEARER = 0.9, 0.7
"""How much of where a soft shadow meets the ground is nearly of its colour; and by what part of
what it differs elsewhere that differs, if it has but few shades."""
_CLEAN = 3.0
"""Levels by which the ground of a drawing with shades strays at most; that of a photo does."""
_EVENLY = 0.4
"""How much of a bitmap without a page is evenly painted, at least."""
_GRAIN = 1.8
"""Levels that its pixels stray from those around, in the mean, at most."""
_LINES = 0.08
"""Half the width of the thickest lines, as part of the drawing."""
_WINDOWS, _RECTANGULAR = 0.75, 0.9
"""How much of a frame its windows span, at least, and of their bounding boxes they fill; a sign
spans less of the tile that it is on, or is no rectangle."""
_TOUCHING = 3
"""Pixels on either side of where rectangles touch, of 512."""
_FULL = 0.7
"""How much of its bounding box a tile or a badge fills, and a little air."""


def flat_drawing(pixels: NDArray[np.uint8]) -> NDArray[np.uint8] | None:
    """Return a coloured drawing (SIDE, SIDE, 4), free and crisp; None if the bitmap shows none.

    ``pixels`` are (h, w, 3) RGB or (h, w, 4) RGBA, in sRGB. The drawing is fitted to the square and
    has two colours or more; its ground, which is what is all around, is transparent. A drawing in
    one colour is none of these: its darkness tells more.
    """
    if min(pixels.shape[:2]) < 8:
        return None
    small = shrunk(pixels, -(-max(pixels.shape[:2]) // _LONGEST)) * np.float32(255)
    blended = premultiplied(small)
    free = pixels.shape[2] == 4
    if free and max(pixels.shape[:2]) <= SMALL and is_in_one_colour(blended):
        return None
    found = ground_of(blended)
    palette = palette_of(blended, found)
    if palette is not None and not free:
        palette = palette._replace(lossy=not palette.is_exact(blended))
    if found is not None and found.around > _DESK:
        sheet = _on_a_desk(small, found.colour)
        if sheet is not None and not _is_painted(palette, blended, sheet):
            return None
    if palette is None:
        return cut_drawing(pixels)
    if found is not None and _goes_on_in_shadow(palette, found):
        found = None
    ground, around = (None, 0.0) if found is None else (0, found.around)
    uneven = found is not None and not free and not found.is_clean(blended)
    if _is_full_bleed(palette, blended, ground, around) or (uneven and is_gradient(pixels)):
        return _full_bleed(blended, palette)
    if ground is None:
        return None
    if small.shape[2] == 3:
        noise = palette.noise(ground, blended) if max(blended.shape) > SMALL else 0.0
        if palette.shades and noise > _CLEAN:
            return None
        fading = _fading(palette, ground, blended)
        if any(palette.colours[one].sum() > palette.colours[ground].sum() for one in fading):
            return _full_bleed(blended, palette)  # a glow, which goes on behind the drawing
        for one in fading:
            palette = palette.without(one, ground)
    palette, parts = _completed(blended, palette)
    if parts is None:
        return cut_drawing(pixels)
    return _painted(parts, palette, ground, around < AROUND)


def _completed(
    blended: NDArray[np.float32], palette: Palette
) -> tuple[Palette, NDArray[np.float32] | None]:
    """Return a palette with what it lacks, and how much of each pixel has each colour, (k, h, w).

    None if too much is of other colours still.
    """
    small = max(blended.shape) <= SMALL
    exact = _MISSED_SMALL if small else _MISSED
    most = exact if palette.is_exact(blended) else _LOSSY
    few = most / 4 if small else most
    even = evenly_painted(blended, 3) & (not small and not palette.shades)
    parts, amiss, lacking, is_dot = _parts(blended, palette, even)
    for added in range(_DOTS):
        if lacking is None or not (is_dot or (amiss > few and added < _LACKING)):
            break
        palette = palette.with_colour(lacking)
        if small:
            palette = palette.without_blends(blended)
        parts, amiss, lacking, is_dot = _parts(blended, palette, even)
    free = small and bool((palette.colours[:, 3] < CLEAR).any())
    if amiss > most or (free and _change_by_degrees(parts)):
        return palette, None
    return palette, parts


def _change_by_degrees(parts: NDArray[np.float32]) -> bool:
    """Whether colours go over into each other within areas, as those of steep gradients do."""
    mixed = scipy.ndimage.binary_erosion(parts.max(axis=0) < _PURE, np.ones((3, 3)))
    drawn = parts.argmax(axis=0) != parts.sum(axis=(1, 2)).argmax()
    return bool(mixed.sum() > _BY_DEGREES * drawn.sum())


def _is_full_bleed(
    palette: Palette, blended: NDArray[np.float32], ground: int | None, around: float
) -> bool:
    """Whether colours reach the edge of a bitmap that are no page: a flag, or a full tile.

    Paper has no strong colour, wherever it lies in the shadow, and its picture has grain.
    """
    coloured = np.ptp(palette.colours[:, :3], axis=1) > TINGE
    if ground is not None and palette.colours[ground].min() > PAPER:
        # Stripes of white, as on flags: more of a page was added around.
        corners = corners_of(blended) - palette.colours[ground]
        at_corners = np.linalg.norm(corners, axis=1) < ASTRAY
        striped = has_stripes(palette.number == ground)
        full = around < AROUND and (striped or not at_corners.all())
        full = full and coloured.any() and not palette.shades
    elif ground is not None:
        dark = palette.colours[ground, :3].max() < _DARK and not palette.shades and coloured.any()
        banner = around >= AROUND and dark and is_banner(palette.number == ground)
        full = (around > _BLEEDS and coloured[ground]) or banner
    elif palette.shades:
        full = coloured[list(palette.shades)].all()
    else:
        full = coloured.any()
    return bool(
        full
        and (palette.colours[:, 3] >= CLEAR).all()
        and (palette.number >= 0).mean() > _EVENLY
        and _grain(palette, blended) < _GRAIN
    )


def _grain(palette: Palette, blended: NDArray[np.float32]) -> float:
    """Return by how many levels pixels of even areas stray from those around, in the mean."""
    low = minimum_filter(palette.number, 3)
    even = (low >= 0) & (low == maximum_filter(palette.number, 3))
    away = abs(blended - scipy.ndimage.uniform_filter(blended, (3, 3, 1)))[even]
    return float(away.max(axis=1).mean()) if even.any() else np.inf


def _full_bleed(blended: NDArray[np.float32], palette: Palette) -> NDArray[np.uint8]:
    """Return a drawing that covers all of a bitmap, opaque; as it is if it has too many colours."""
    shape = scaled(blended.shape[:2], FILLED / max(blended.shape[:2]))
    palette, parts = _completed(blended, palette)
    if parts is None:
        return on_square(resized(blended, shape))
    return on_square(_at(list(parts), palette.shades, palette, shape)[1])


def _on_a_desk(small: NDArray[np.float32], ground: NDArray[np.float32]) -> NDArray[np.bool_] | None:
    """Return where a sheet of paper lies on its ground; one as white as that is no desk."""
    if small.shape[2] == 4 or ground.min() > PAPER:
        return None
    sheet = sheet_on_desk(small / np.float32(255))
    return None if sheet is None or np.ptp(np.median(small[sheet], axis=0)) > TINGE else sheet


def _is_painted(
    palette: Palette | None, blended: NDArray[np.float32], sheet: NDArray[np.bool_]
) -> bool:
    """Whether a sheet is but a stripe, or a part of a drawing, as too many flat colours tell."""
    if palette is None:
        return False
    smooth = _grain(palette, blended) < _GRAIN
    if smooth and has_stripes(palette.number != 0, _ALL_ALONG):
        return True
    if not (smooth or palette.is_exact(blended)):
        return False
    counted = {one: palette.number == one for one in range(len(palette.colours))}
    on_it = {one for one, there in counted.items() if there[sheet].mean() > _PAINT}
    beside_it = {one for one, there in counted.items() if there[~sheet].mean() > _PAINT}
    return len(on_it) > _PAPER_AND_INK or len(beside_it - on_it) > 1


def _goes_on_in_shadow(palette: Palette, ground: Ground) -> bool:
    """Whether a ground may be that part of paper or of a desk that is lit, beside shades."""
    shaded = np.isin(rim_of(palette.number), list(palette.shades)).mean() > _IN_SHADOW
    return bool(shaded and ground.around < AROUND and not corners_of(ground.mask).all())


def _fading(palette: Palette, ground: int, blended: NDArray[np.float32]) -> list[int]:
    """Return the colours that fade into the ground all around, as soft shadows and glows do.

    They meet the ground nearly in its colour; what has but few shades, nearer to it than elsewhere.
    A cloud or a button may fade into it on one side.
    """
    fading: list[int] = []
    away = np.linalg.norm(palette.colours - palette.colours[ground], axis=1)
    beside = scipy.ndimage.binary_dilation(palette.number == ground, np.ones((_NEAR, _NEAR)))
    for one in set(range(len(away))) - {ground}:
        meets = blended[beside & (palette.number == one)] - palette.colours[ground]
        most = ASTRAY if one in palette.shades else min(ASTRAY, _NEARER * away[one])
        if len(meets) and (np.linalg.norm(meets, axis=1) < most).mean() > _FADING:
            fading.append(one)
    return fading


def _parts(
    blended: NDArray[np.float32], palette: Palette, even: NDArray[np.bool_]
) -> tuple[NDArray[np.float32], float, NDArray[np.float32] | None, bool]:
    """Return how much of each pixel has each colour, (k, h, w).

    Also how much of the drawing is no blend of two of them, or, if it is small, of three; the
    colour of its pixel that is farthest from any; and whether that lies in a dot, where colours
    are ``even``.
    """
    count = len(palette.colours)
    parts = (np.arange(count)[:, None, None] == palette.number).astype(np.float32)
    near = np.stack([maximum_filter(one, _NEAR) for one in parts]) > 0
    mixed = palette.number < 0
    pixels, absent = blended[mixed], ~near[:, mixed]
    colours = [palette.at(one, mixed) for one in range(count)]
    best = np.full(len(pixels), np.inf, np.float32)
    missed, values = best.copy(), np.zeros((count, len(pixels)), np.float32)
    for size in (1, 2, 3) if max(mixed.shape) <= SMALL else (1, 2):
        # What two colours blend is no blend of three.
        open_ = np.flatnonzero(missed > ASTRAY**2) if size > 2 else np.arange(len(pixels))
        for some in combinations(range(count), size):
            corners = [c if len(c) == 1 else c[open_] for c in (colours[one] for one in some)]
            shares, away = unblended(pixels[open_], corners)
            lacks = absent[list(some)][:, open_] & (shares > 0.1)
            cost = away + lacks.sum(axis=0) * np.float32(_ABSENT**2)
            better = cost < best[open_]
            at = open_[better]
            best[at], missed[at] = cost[better], away[better]
            values[:, at] = 0
            values[np.ix_(some, at)] = shares[:, better]
    parts[:, mixed] = values
    drawn = (palette.number != palette.counts.argmax()).sum()
    amiss = float((missed > ASTRAY**2).sum() / max(drawn, 1))
    in_dots = np.where(even[mixed], missed, 0)
    is_dot = bool(in_dots.max(initial=0) > ASTRAY**2)
    lacking = pixels[(in_dots if is_dot else missed).argmax()] if amiss else None
    return parts, amiss, lacking, is_dot


def _painted(
    parts: NDArray[np.float32], palette: Palette, ground: int, cut: bool
) -> NDArray[np.uint8] | None:
    """Return the drawing without what of its ground is outside; None if it has one colour.

    The colour of the ground counts as one if it lies on a tile. ``cut`` drawings reach the edge of
    the bitmap.
    """
    crop = box_of(parts[ground] < _GROUND)
    if crop is None:
        return None
    labels, colours = _enlarged(parts[(slice(None), *crop)], palette, ground, crop)
    pieces, _ = scipy.ndimage.label(np.pad(labels == ground, 1, constant_values=True))
    inside = (pieces != pieces[0, 0])[1:-1, 1:-1]
    if palette.colours[ground, 3] < CLEAR:
        inside = labels != ground
    own = has_colours(colours[inside & (labels != ground)])
    if not own and not (has_colours(colours[inside]) and inside.mean() > _FULL):
        return None
    ink = inside & (labels != ground)
    depth = scipy.ndimage.distance_transform_edt(np.pad(ink, 1))
    if not own and depth.max() < _LINES * max(labels.shape) and ink.mean() < SPARSE:
        # The frame of a drawing in lines is no tile, nor a desk with sheets on it.
        return on_square(np.where(ink[..., None], colours, 0))
    if not own and _has_windows(ink, inside & ~ink):
        return None
    painted = on_square(np.where(inside[..., None], colours, 0))
    on_tile = own or cut or Omission.TILE in pictogram(painted).omissions
    return painted if on_tile else None


def _has_windows(ink: NDArray[np.bool_], holes: NDArray[np.bool_]) -> bool:
    """Whether holes are the windows of a frame: rectangles that span most of it."""
    # Squares of a checkerboard touch at their corners.
    apart = scipy.ndimage.binary_erosion(holes, np.ones((3, 3)), iterations=_TOUCHING)
    pieces, _ = scipy.ndimage.label(apart)
    whole = sum(pieces[box].size for box in scipy.ndimage.find_objects(pieces))
    spans = (
        max(int(np.ptp(np.flatnonzero(mask.any(axis=axis)))) for axis in (0, 1))
        for mask in (holes, ink)
    )
    across, least = next(spans), _WINDOWS * next(spans)
    return bool(across > least and apart.sum() > _RECTANGULAR * whole)


def _enlarged(
    parts: NDArray[np.float32], palette: Palette, ground: int, crop: tuple[slice, slice]
) -> tuple[NDArray[np.intp], NDArray[np.float32]]:
    """Return the number (h, w) of the colour of each pixel of the drawing, and it (h, w, 4)."""
    pad = [(2, 2), (2, 2)]
    padded = [np.pad(one, pad, constant_values=n == ground) for n, one in enumerate(parts)]
    scale = min(FILLED / max(parts.shape[1:]), 1 / max(padded[0].shape))
    shape = scaled(padded[0].shape, scale)
    shades = {
        number: np.pad(shade[crop], [*pad, (0, 0)], mode="edge")
        for number, shade in palette.shades.items()
    }
    return _at(padded, shades, palette, shape, ground)


def _at(
    parts: list[NDArray[np.float32]],
    shades: dict[int, NDArray[np.float32]],
    palette: Palette,
    shape: tuple[int, ...],
    ground: int | None = None,
) -> tuple[NDArray[np.intp], NDArray[np.float32]]:
    """Return the number (h, w) of each pixel's colour at another resolution, and it (h, w, 4)."""
    free = ground is not None and not palette.has_blends_of(ground)
    labels = numbered(np.stack(parts), shape, ground if free else None, palette.lossy)
    colours = palette.colours[labels]
    for number, shade in shades.items():
        at = labels == number
        colours[at] = resized(shade, shape)[at]
    return labels, colours
