"""From a coloured drawing to a pictogram: what of it is ink, and what is paper.

The rule. All that is more than half as opaque as the drawing's body is its silhouette, divided
into regions of even colour (``regions``). Of these,

1. *one tone*, all over, is ink, whatever its colour and opacity;
2. in a *line drawing*, with a dark line around most of it, the lines and what is about as dark
   are ink, and the fills that they enclose are paper; a shape that they do not enclose is a part
   of the drawing, or decoration (``linework``); a detail that stands out within a fill is ink;
3. a *tile* behind the drawing is paper: a rectangle or a rounded square in which the drawing
   stands free, neither in small pieces (as a die's dots) nor filling it (as a screen). A disc is
   a badge or a face, and a tile only if it is near white. A bare sign, such as a triangle, keeps
   its tile, for that is a button; and a paler shade of all that is on it is no tile but the body
   of a thing in two tones. Gloss goes with its tile (``tiles``);
4. *near white* on other colours is paper, unless it is all around;
5. of the others, what mainly borders on the outside is ink; what mainly borders on ink is paper
   (eyes in a face, the door of a house), and what mainly borders on paper is ink; but thick layers
   of different colours, as of a burger or a flag, the midst of a mosaic and sectors of a wheel are
   ink as what is beside them (``stacks``); of a board in two colours, the darker squares are ink;
6. between two regions of ink runs a line of paper, unless both are lines, and cross (``crossing``);
   between two of paper that differ strongly, one of ink. Where paper is a part of the silhouette, a
   line of ink runs along the contour (a cloud before the sun, a flag's white half), unless it is
   narrow, or pure white that takes a bite out of a colour (a crescent, ``whites``);
7. colours that differ little are shades of one, but a figure on its ground is told from it if
   there is nothing else (``shades``);
8. the flat shadow that a figure casts aslant on its tile or badge is a part of that (``cast``);
9. letters and lines that are too fine for regions stand out from what is around them (``details``).

Of a drawing in two tones, dark on pale, regions only tell which of them is ink; what is drawn is as
fine as its pixels (``two_tones``). Even layers that are less opaque than the body, down to half of
it, or to a fifth if they make a part of the drawing, are as opaque, but paler; what is fainter is
left out, and what fades ends where it is half as opaque as the body (``layers``).
"""

from typing import NamedTuple

import numpy as np
import scipy
from numpy.typing import NDArray

from iconstudio.algorithms.extremes import maximum_filter
from iconstudio.algorithms.tones import details, regions
from iconstudio.algorithms.tones.alternation import Omission, Tones, decide
from iconstudio.algorithms.tones.cast import without_cast_shadow
from iconstudio.algorithms.tones.crossing import crossing
from iconstudio.algorithms.tones.duotone import dark_is_ink, separated, two_tones
from iconstudio.algorithms.tones.glow import without_glow
from iconstudio.algorithms.tones.layers import without_faint
from iconstudio.algorithms.tones.linework import line_drawing, outline
from iconstudio.algorithms.tones.lost import loses_edges
from iconstudio.algorithms.tones.regions import STRIKING, Mask, Regions, cielab, nearest
from iconstudio.algorithms.tones.resolution import (
    SIDE,
    SMALLEST,
    body_alpha,
    enlarged,
    reduced,
    repeated,
)
from iconstudio.algorithms.tones.separation import LINE, blend, separating
from iconstudio.algorithms.tones.shades import shades
from iconstudio.algorithms.tones.stacks import checkered, stacked
from iconstudio.algorithms.tones.tiles import is_sheet, tile
from iconstudio.algorithms.tones.whites import beside_outline, whites

CONTRAST = 14.0
"""Neighbouring colours that differ by less (CIEDE2000) are shades of one."""
FAINT = 11.0
"""As CONTRAST, where all that is on a tile would be one shape."""
GREYISH = 9.0
"""As CONTRAST, where white that is left out would take a grey along."""
_RIM, _CONTOUR = 5, 0.2
"""Pixels along the contour that tell of such a grey, and how much of them it has."""
OUTLINE = 2 * LINE
"""Width of the line along white that is a part of the silhouette, in pixels."""
_FINE = 5
"""Half the width, in pixels, of the thickest lines that may have no even colour."""
_ROUNDING = 3
"""Levels of sRGB by which pixels of one colour may differ."""
_SEAM = 2
"""Pixels on either side of an edge that are not all ink or paper."""
_CLOSED = 28.0
"""Width in pixels of the narrowest paper in colour that has a line along the contour."""
_NARROW = 2 * LINE
"""Width of regions that no line sets off, unless their colour is striking."""


class _Share(NamedTuple):
    ink: NDArray[np.float32]
    """How much of each pixel is ink, from 0 to 1, were all inside."""
    omissions: frozenset[Omission]


class Inked(NamedTuple):
    """The pictogram of a drawing."""

    coverage: NDArray[np.uint8]
    """(n, n), 255 = ink."""
    omissions: frozenset[Omission] = frozenset()
    """What of the drawing is no part of it."""


def pictogram(rgba: NDArray[np.uint8]) -> Inked:
    """Return the pictogram of a drawing (n, n, 4).

    The drawing is sRGB with straight alpha, fitted to the square; n is best a multiple of SIDE.
    A drawing without anything to see has no ink.
    """
    rgb, alpha = reduced(rgba)
    body = body_alpha(alpha)
    opaque, faint = without_faint(rgba[..., 3].astype(np.float32), body)
    unlit = without_glow(rgb, alpha, body)
    if unlit is not None:
        share, own = unlit
        at = nearest(repeated(own, len(rgba)))
        opacity = rgba[..., 3] * enlarged(share, len(rgba)) + 0.5
        rest = pictogram(np.dstack([rgba[..., :3][at], opacity.astype(np.uint8)]))
        # Of the glow, a faint trace may be left; what was faint beside it may be gone with it.
        omissions = rest.omissions - {Omission.FAINT} | {Omission.GLOW}
        return Inked(rest.coverage, omissions | {Omission.FAINT} if faint else omissions)
    silhouette = np.minimum(opaque * (255 / body), 255)
    inside = alpha > body / 2
    omissions = frozenset[Omission]()
    if inside.any() and np.ptp(rgb[inside], axis=0).max() > _ROUNDING:
        share, omissions = _in_two_tones(rgba, rgb, inside) or _in_colours(rgba, rgb, inside)
        silhouette *= enlarged(share, len(rgba))
    if faint:
        omissions |= {Omission.FAINT}
    return Inked((silhouette + 0.5).astype(np.uint8), omissions)


def _in_two_tones(rgba: NDArray[np.uint8], rgb: NDArray[np.uint8], inside: Mask) -> _Share | None:
    """Return how much of each pixel (n, n) is ink; None unless the drawing is in two tones."""
    two = two_tones(rgb, inside)
    if two is None:
        return None
    found = separated(two, rgb, inside)
    tones = _tones(found)
    dark = dark_is_ink(found, tones.ink)
    if dark is None or tones.outlined.any():
        return None
    share = two.darkness(rgba[..., :3])
    return _Share(share if dark else 1 - share, tones.omissions)


def _in_colours(rgba: NDArray[np.uint8], rgb: NDArray[np.uint8], inside: Mask) -> _Share:
    """Return how much of each pixel (n, n) is ink."""
    divided = _regions(rgb, inside)
    lit = without_cast_shadow(rgba, rgb, divided, SMALLEST)
    if lit is not None:
        share, omissions = _in_colours(*lit, inside)
        return _Share(share, omissions | {Omission.SHADOW})
    found = shades(rgb, inside, divided, SMALLEST)
    tones = _tones(found)
    soft = np.ones(inside.shape, np.float32)
    drawn, rim = separating(rgb, found, tones.lines), _rim(found, tones.outlined)
    if tones.lines.any() or not tones.ink[1:].all() or tones.over.any():
        soft = _soft(rgb, found, tones, drawn, rim)
    plain = enlarged(soft, len(rgba))
    soft = _with_details(plain, rgba, inside, found, tones)
    lines = np.maximum(drawn, rim)
    if lines.any():  # beside which nothing is a detail
        at_lines = repeated(maximum_filter(lines, 5) > 0, len(rgba))
        soft = np.where(at_lines, plain, soft)
    lost = loses_edges(cielab(rgb), found, tones, soft > 0.5)
    return _Share(soft, tones.omissions | ({Omission.SHADES} if lost else set()))


def _with_details(
    soft: NDArray[np.float32],
    rgba: NDArray[np.uint8],
    inside: Mask,
    found: Regions,
    tones: Tones,
) -> NDArray[np.float32]:
    """Return how much of each pixel is ink, given that without letters and thin lines."""
    n = len(rgba)
    masks = inside, found.pure, tones.ink[found.labels]
    within, pure, ink = (repeated(mask, n) for mask in masks)
    levels = rgba[..., :3].astype(np.float32) @ np.array([0.299, 0.587, 0.114], np.float32)
    grey = np.where(within, levels, np.float32(255))
    reach = round(_FINE * n / SIDE)
    return details.with_details(soft, grey, within, pure, ink, reach)


def _regions(rgb: NDArray[np.uint8], inside: Mask) -> Regions:
    lab = cielab(rgb)
    found = regions.regions(lab, inside, CONTRAST, SMALLEST)
    if _hides_grey(found, lab):
        closer = regions.regions(lab, inside, GREYISH, SMALLEST)
        # Where shades of other colours come apart, too, it is no chart but a picture.
        found = closer if len(closer.areas) <= len(found.areas) + 2 else found
    if len(found.areas) != 3:
        return found
    # Of one shape on a tile the shades are all that there is.
    closer = regions.regions(lab, inside, FAINT, SMALLEST)
    return closer if tile(closer).any() else found


def _hides_grey(found: Regions, lab: NDArray[np.float32]) -> bool:
    """Whether white that is paper was joined by an even grey that makes a part of the contour."""
    if not (found.white & (found.lengths[0] > 0)).any():
        return False
    inside = found.labels > 0
    grey = whites(found).paper[found.labels] & found.pure & ~regions.near_white(lab)
    rim = inside & ~scipy.ndimage.binary_erosion(inside, iterations=_RIM)
    return bool((grey & rim).sum() > _CONTOUR * rim.sum())


def _tones(found: Regions) -> Tones:
    board = checkered(found)
    if board is not None:
        pale = ~board & (found.lengths[0] > 0)
        pale[0] = False
        return Tones(board, found.lengths < 0, np.zeros_like(board), pale)
    line = outline(found)
    if line is not None:
        return line_drawing(found, line)
    behind, white = tile(found), whites(found)
    page = behind & found.white if behind.any() else white.page
    omissions = {Omission.PAGE: page & ~is_sheet(found), Omission.TILE: behind & ~found.white}
    ink = _alternating(found, behind, white.paper)
    # A line would leave little of a narrow region.
    narrow = found.widths < _NARROW
    narrow = (narrow | narrow[:, None]) & (found.contrasts < STRIKING)
    narrow |= beside_outline(found, white.paper)
    closed = ~ink & ~found.white & (found.lengths[0] > 0) & (found.widths > _CLOSED)
    closed[0] = False
    outlined = ((white.outlined & ~ink) | closed) & ~behind.any()
    # White at the outside without an outline is none of the drawing's shapes.
    shapes = ~ink & ~behind & ~(white.paper & (found.lengths[0] > 0) & ~white.outlined)
    shapes[0] = False
    apart = shapes & shapes[:, None] & found.striking
    return Tones(
        ink,
        (ink & ink[:, None] & (found.lengths > 0) & ~narrow & ~crossing(found)) | apart,
        np.zeros_like(ink),
        outlined,
        frozenset(what for what, some in omissions.items() if some.any()),
    )


def _alternating(found: Regions, behind: Mask, white: Mask) -> Mask:
    """Return which regions are ink: those on the outside, and what lies within their holes."""
    paper = behind.copy()
    paper[0] = True
    # Of paper on the outside colours do not matter.
    weights = found.lengths * np.minimum(found.contrasts, 60)
    weights[:, paper] = 120 * found.lengths[:, paper]
    tone = np.where(paper, -1, 0)
    if not behind.any():
        tone[white] = -1
        tone[stacked(found) & ~white] = 1
    # The shade along a contour is no outline of what it is the shade of.
    inner = found.contrasts[:, 1:].max(axis=1)
    shade = (tone == 0) & (found.widths < _NARROW) & (inner > 0) & (inner < STRIKING)
    weights[shade] = found.lengths[shade]
    # Nor is a pale line around white one of what is darker.
    weights[beside_outline(found, white)] = 0
    # Nor is a second one, along the first.
    outermost = shade & (found.lengths[0] > 0)
    second = shade & (found.lengths[:, outermost].sum(axis=1) > 0.4 * found.around)
    second &= found.lengths[0] == 0
    weights[second] = -found.lengths[second]
    decide(tone, found, weights, shade)
    return tone > 0


def _rim(found: Regions, outlined: Mask) -> NDArray[np.float32]:
    """Return how much of each pixel, (SIDE, SIDE) from 0 to 1, belongs to lines of the contour."""
    if not outlined.any():
        return np.zeros(found.labels.shape, np.float32)
    depth = scipy.ndimage.distance_transform_edt(np.pad(found.labels > 0, 1))[1:-1, 1:-1]
    # Ink beside such a line is joined without a seam.
    at = scipy.ndimage.binary_dilation(outlined[found.extended], np.ones((3, 3)), _SEAM)
    return np.where(at, np.clip(OUTLINE + 0.5 - _smooth(depth, LINE / 4), 0, 1), 0)


def _soft(
    rgb: NDArray[np.uint8],
    found: Regions,
    tones: Tones,
    drawn: NDArray[np.float32],
    rim: NDArray[np.float32],
) -> NDArray[np.float32]:
    """Return how much of each pixel is ink, (SIDE, SIDE) from 0 to 1, were all inside.

    ``drawn`` is how much of it belongs to lines between regions, and ``rim`` to the contour's.
    """
    soft = _blended(rgb, found, tones.ink)
    labels = found.extended
    soft = np.where(tones.ink[labels], np.minimum(soft, 1 - drawn), np.maximum(soft, drawn))
    if tones.over.any():
        over = tones.over[labels]
        away = _smooth(scipy.ndimage.distance_transform_edt(~over), LINE / 4)
        others = tones.ink[labels] & ~over
        soft = np.where(others, np.minimum(soft, np.clip(away - LINE + 0.5, 0, 1)), soft)
    return _without_crumbs(np.maximum(soft, rim), found.labels > 0)


def _blended(rgb: NDArray[np.uint8], found: Regions, ink: Mask) -> NDArray[np.float32]:
    """Return how much of each pixel is ink, as its blend of the colours of ink and paper tells."""
    toned = ink[found.extended]
    pure = found.pure & (found.labels > 0)
    if not (pure & toned).any() or not (pure & ~toned).any():
        return toned.astype(np.float32)
    mixed, share, _ = blend(rgb, pure & toned, pure & ~toned, found.pure | (found.labels == 0))
    soft = toned.astype(np.float32)
    soft[mixed] = share
    return _smooth(soft, 0.6)


def _without_crumbs(soft: NDArray[np.float32], inside: Mask) -> NDArray[np.float32]:
    """Take away what lines leave of ink or paper that is smaller than any detail."""
    soft = soft.copy()
    for tone in (1, 0):
        of_tone = (soft > 0.5) == tone
        pieces, _ = scipy.ndimage.label(of_tone & inside)
        small = (np.bincount(pieces.ravel()) < SMALLEST)[pieces] & (pieces > 0)
        around = scipy.ndimage.binary_dilation(small, np.ones((3, 3)))
        # A dot of the drawing's own has nothing else around it.
        reached = maximum_filter(np.where(small, pieces, 0), 3)
        crumbs = np.unique(reached[around & inside & ~of_tone])
        at = scipy.ndimage.binary_dilation(np.isin(pieces, crumbs[crumbs > 0]), np.ones((3, 3)))
        soft[at] = 1 - tone
    return soft


def _smooth(values: NDArray[np.floating], sigma: float) -> NDArray[np.float32]:
    smooth: NDArray[np.float32] = scipy.ndimage.gaussian_filter(values.astype(np.float32), sigma)
    return smooth
