"""A scan, a photo of a drawing or a picture of an icon becomes black and white.

What lights the paper unevenly is divided out (flat-field correction), so that one threshold
(N. Otsu, 1979) serves all of it; it may be a coloured pen, chalk on a board, or transparent.
"""

from dataclasses import dataclass, replace

import numpy as np
import scipy
from numpy.typing import NDArray

from iconstudio.algorithms.extremes import maximum_filter, minimum_filter
from iconstudio.algorithms.scanning.behind import left_behind
from iconstudio.algorithms.scanning.checkerboard import without_checkerboard
from iconstudio.algorithms.scanning.covered import covered
from iconstudio.algorithms.scanning.dark_edge import dark_edge
from iconstudio.algorithms.scanning.darkness import darkness, ground_of, seen_through
from iconstudio.algorithms.scanning.dithering import without_dithering
from iconstudio.algorithms.scanning.doubts import (
    CLEAN,
    LEAST,
    PLAIN,
    SPECK,
    drawing_in_faint_lines,
    has_fainter_lines,
    is_noise,
    is_plain,
    shading,
    without_crumbs,
    without_dirt,
    without_specks,
)
from iconstudio.algorithms.scanning.enlarged import at_own_resolution
from iconstudio.algorithms.scanning.faint_lines import faint_lines, is_clean, with_faint_lines
from iconstudio.algorithms.scanning.finger import finger
from iconstudio.algorithms.scanning.flat import flat_drawing
from iconstudio.algorithms.scanning.free import LARGE, free_drawing, on_nothing
from iconstudio.algorithms.scanning.ground import has_grain
from iconstudio.algorithms.scanning.margin import box_of, rim_of, with_margin, without_half_lines
from iconstudio.algorithms.scanning.noise import without_noise
from iconstudio.algorithms.scanning.pale import darkened
from iconstudio.algorithms.scanning.paper import trend
from iconstudio.algorithms.scanning.printed import without_print
from iconstudio.algorithms.scanning.punched import punch_holes
from iconstudio.algorithms.scanning.repeated import unrepeated
from iconstudio.algorithms.scanning.resampling import (
    COARSE,
    in_squares,
    reconstructed,
    resized,
    shrunk,
)
from iconstudio.algorithms.scanning.shadow import without_shadow
from iconstudio.algorithms.scanning.sharpened import unsharpened
from iconstudio.algorithms.scanning.sheet import photographed_sheet
from iconstudio.algorithms.scanning.uneven import uneven_light
from iconstudio.algorithms.tones.alternation import Omission
from iconstudio.algorithms.tones.tone import Inked, pictogram
from iconstudio.model import IconstudioError

SIDE = 512
"""Pixels of the longer side of a drawing; its curves are fitted to about a third of one."""

_COARSE = 512
"""Pixels of the longer side at which paper and drawing are told apart."""
_MARGIN = 0.04
"""Air around a drawing, as part of its longer side."""
_FAINTEST = 0.02
"""Less contrast than this is not made more."""
_SHADED = 0.04
"""So much of what is not paper is shading on a photo, and not on a drawing."""
_ENLARGED = 2.0
"""How many times a picture is enlarged at most in which lines are told from the edges of others."""

_BEYOND = 2
"""Pixels beyond the edge of a small picture that are taken for paper."""
_LITTLE = 0.25
"""How much ink the darkest pixel beside an edge has at least, and the brightest at most."""


@dataclass(frozen=True, slots=True, eq=False)
class Scan:
    """A drawing, cut out of its paper."""

    darkness: NDArray[np.uint8]
    """(h, w), the longer side ``SIDE``: from 0, paper, to 255, the darkest there can be."""
    threshold: int
    """What is darker is ink, if the user does not say otherwise."""
    inverted: bool
    """Whether the drawing was lighter than its ground."""
    found: bool = True
    """Whether a drawing was made out; if not, ``darkness`` is all of the picture, stretched."""
    shaded: bool = False
    """Whether much of it is neither ink nor paper, as on a photo of something else."""
    faint: bool = False
    """Whether lines that can be seen are fainter than ``threshold``."""
    coloured: Inked | None = None
    """Of a drawing in flat colours, its pictogram: what is ink at ``threshold``."""
    omissions: frozenset[Omission] = frozenset()
    """What of the picture was left out."""

    def at(self, threshold: int) -> NDArray[np.bool_]:
        """Return where it is ink at a threshold, (h, w) as ``darkness`` or its pictogram."""
        if self.coloured is not None and threshold == self.threshold:
            return self.coloured.coverage > 127
        return self.darkness > threshold


def scanned(
    pixels: NDArray[np.uint8],
    inverted: bool | None = None,
    sheet: NDArray[np.bool_] | None = None,
) -> Scan:
    """Find the drawing on a picture.

    Parameters
    ----------
    pixels
        (h, w, 3) RGB or (h, w, 4) RGBA, in sRGB.
    inverted
        Whether it is lighter than its ground; None to find out.
    sheet
        (h, w) where the sheet lies, of the coarse picture; None to find out.

    Raises
    ------
    IconstudioError
        If there is nothing to be seen.
    """
    step = _step(pixels)
    small = shrunk(pixels, step)
    left_out: frozenset[Omission] = frozenset()
    if small.shape[2] == 4:
        see, inverted = seen_through(small, inverted)
        coarse = see(small)
    else:
        ground, valid, inverted = ground_of(small, inverted, sheet)
        coarse = np.where(valid, darkness(small, ground, inverted), 0.0)
        left_out = frozenset(() if valid.all() else {Omission.DESK})
    bounds = _bounds(coarse, not inverted)
    if bounds is None and small.shape[2] == 3:
        # What is that faint was taken for paper.
        ground = trend(1 - small if inverted else small, valid)
    left, top, right, bottom = bounds or (0, 0, *coarse.shape[::-1])
    # Once more, only the drawing and in its own resolution.
    height, width = coarse.shape
    area = pixels[top * step : bottom * step, left * step : right * step]
    finer = max(1, max(area.shape[:2]) // (2 * SIDE))
    fine = shrunk(area, finer)
    if small.shape[2] == 4:
        dark = see(fine)
    else:
        shape = fine.shape[:2]
        here = np.s_[top : min(bottom, height), left : min(right, width)]
        dark = darkness(fine, resized(ground[here], shape), inverted)
        dark = np.where(resized(valid[here].astype(np.float32), shape) > 0.5, dark, 0.0)
    scale = SIDE / max(dark.shape)
    dark = _enlarged(dark, tuple(max(1, round(side * scale)) for side in dark.shape))
    dark = np.clip(scipy.ndimage.gaussian_filter(dark, 1.0), 0, 1)
    threshold = _threshold(dark) if bounds else None
    if threshold is not None and not inverted:
        dark = with_faint_lines(dark, threshold)
    fainter = False
    lines = None if threshold is None else drawing_in_faint_lines(dark, threshold)
    if threshold is not None and lines is not None:
        # Of lines as of ink, half the darkness.
        threshold = float(np.median(dark[lines & (dark < threshold)])) / 2
    if threshold is not None and scale < _ENLARGED:
        light = _light(small, coarse, inverted)
        fainter = has_fainter_lines(scipy.ndimage.gaussian_filter(coarse, 0.7), light, threshold)
        if fainter and not has_grain((255 * np.clip(light, 0, 1)).astype(np.uint8)):
            # What no camera saw may be drawn whole at a finer resolution.
            light = resized(_light(fine, dark, inverted), dark.shape)
            fainter = has_fainter_lines(dark, light, threshold, CLEAN)
    if threshold is None:
        low, high = np.percentile(dark, (1, 99.9))
        dark = np.clip((dark - low) / max(high - low, _FAINTEST), 0, 1)
    return Scan(
        np.rint(dark * 255).astype(np.uint8),
        round((0.5 if threshold is None else threshold) * 255),
        inverted,
        threshold is not None,
        shading(dark, threshold or 0.5, scale) > _SHADED,
        fainter,
        omissions=left_out,
    )


def _light(
    seen: NDArray[np.float32], dark: NDArray[np.float32], inverted: bool
) -> NDArray[np.float32]:
    """Return a picture (h, w, 3), dark on light; or how light that is which has alpha (h, w, 4)."""
    if seen.shape[2] == 4:
        return 1 - dark[..., None]
    return 1 - seen if inverted else seen


def recognised(pixels: NDArray[np.uint8], inverted: bool | None = None) -> Scan:
    """Find the drawing on a picture as ``scanned`` does, or by its colours if it has flat ones.

    These tell only if nobody says whether it is lighter than its ground.

    Raises
    ------
    IconstudioError
        If there is nothing to be seen.
    """
    if is_plain(pixels):
        raise IconstudioError(PLAIN)
    if not inverted:
        pixels = darkened(pixels)
    pixels = without_dithering(in_squares(unrepeated(pixels)))
    own = at_own_resolution(pixels)  # what enlarges softly sharpens, too, and is told better
    pixels = unsharpened(pixels) if own is pixels and not inverted else own
    if is_noise(pixels):
        return replace(scanned(pixels, inverted), found=False)
    left_out: frozenset[Omission] = frozenset()
    if pixels.shape[2] == 3 and not inverted:
        small = shrunk(pixels, _step(pixels))
        for what, find in (
            (Omission.DESK, dark_edge),
            (Omission.FINGER, finger),
            (Omission.HOLES, punch_holes),
        ):
            over = find(small)
            if over is not None:
                pixels = covered(pixels, small, over)
                small = shrunk(pixels, _step(pixels))
                left_out |= {what}
    found = _recognised(pixels, inverted)
    return replace(found, omissions=found.omissions | left_out)


def _recognised(pixels: NDArray[np.uint8], inverted: bool | None) -> Scan:
    opaque = pixels.shape[2] == 3
    if opaque and not inverted:
        blank = without_print(pixels)
        if blank is not None:
            coarse = shrunk(blank.pixels, _step(blank.pixels)).shape[:2]
            whole = np.ones(coarse, bool) if blank.whole else None
            found = scanned(blank.pixels, inverted, whole)
            # What may be left of the print is no line of the drawing.
            return replace(found, faint=False, omissions=found.omissions | {Omission.PRINT})
        small = shrunk(pixels, _step(pixels))
        sheet = photographed_sheet(small)
        light = None if sheet is not None else uneven_light(small)
        if sheet is not None or (light is not None and light.one_pen):
            return scanned(pixels, inverted, sheet)
        if light is not None:
            pixels = light.divided_out(pixels)
    picture = without_checkerboard(without_half_lines(pixels))
    pixels = without_noise(picture)
    left_out: frozenset[Omission] = frozenset()
    lit = without_shadow(pixels) if inverted is None else None
    if lit is not None:
        pixels = picture = lit
        left_out = frozenset({Omission.SHADOW})
    if inverted is None:
        pixels = on_nothing(pixels)
    if not inverted:
        pixels = with_margin(pixels)
    drawing = _coloured_drawing(pixels) if inverted is None else None
    coloured = None if drawing is None else pictogram(drawing)
    if drawing is None or coloured is None or not (coloured.coverage > 127).any():
        found = scanned(pixels if inverted else with_margin(pixels, tiles=True), inverted)
        left_out |= found.omissions
        told = left_out & {Omission.DESK} or inverted is not None or not _is_on_paper(found)
        if found.found and not found.shaded and not told:
            left_out |= left_behind(picture, least=found.threshold / 255)
        return replace(found, omissions=left_out)
    # Of what is opaque all over, only a shadow is hardly so.
    left_out |= coloured.omissions - ({Omission.FAINT} if opaque else set())
    if not left_out & {Omission.TILE, Omission.PAGE} and not _fills_its_box(drawing):
        left_out |= left_behind(picture, drawing)
    return replace(scanned(pixels), found=True, shaded=False, coloured=coloured, omissions=left_out)


def _step(pixels: NDArray[np.uint8]) -> int:
    longest: int = max(pixels.shape[:2])
    return -(-longest // _COARSE)


def _is_on_paper(scan: Scan) -> bool:
    """Whether what is around a drawing is no ink."""
    return bool((rim_of(scan.darkness) <= scan.threshold).mean() > 0.5)


def _fills_its_box(drawing: NDArray[np.uint8]) -> bool:
    """Whether a drawing (n, n, 4) is a full rectangle, as one that reaches all edges is."""
    seen = drawing[..., 3] > 0
    box = box_of(seen)
    return box is not None and bool(seen[box].all())


def _coloured_drawing(pixels: NDArray[np.uint8]) -> NDArray[np.uint8] | None:
    """Return the drawing (n, n, 4) on a picture if a computer drew it in colours, else None.

    Where there are pixels enough, those are best as they are; fewer are made crisp.
    """
    ways = [flat_drawing, free_drawing]
    if max(pixels.shape[:2]) >= LARGE:
        ways = [free_drawing, flat_drawing]
    return next((drawing for way in ways if (drawing := way(pixels)) is not None), None)


def ink_of(scan: Scan, threshold: int | None = None) -> NDArray[np.bool_]:
    """Return (h, w) where there is ink: what is darker than ``threshold``, without specks.

    At the threshold of the scan, or None, a drawing in flat colours is its pictogram.

    Raises
    ------
    IconstudioError
        If there is none, or no threshold was chosen and no drawing made out.
    """
    if threshold is None and not scan.found:
        raise IconstudioError("No drawing can be made out on it.")
    level = scan.threshold if threshold is None else threshold
    ink = scan.at(level)
    by_colours = scan.coloured is not None and level == scan.threshold
    if by_colours:
        ink = ~without_crumbs(~without_crumbs(ink))
    else:
        ink = ~without_specks(~without_dirt(ink, scan.darkness), SPECK)
    if ink.any():
        return ink
    if threshold is None:
        raise IconstudioError("No drawing can be made out on it, but for specks.")
    raise IconstudioError("Nothing is that dark. Lower the threshold.")


def _enlarged(dark: NDArray[np.float32], shape: tuple[int, ...]) -> NDArray[np.float32]:
    """Return the darkness at another resolution; of few pixels, that of the shape they show."""
    threshold = _threshold(dark) if shape[0] >= COARSE * dark.shape[0] else None
    if threshold is None:
        return resized(dark, shape)
    whole = 2 * threshold
    ink = _greys_of_edges(np.pad(np.clip(dark / whole, 0, 1), _BEYOND))
    scale = shape[0] / dark.shape[0]
    larger = reconstructed(
        np.stack([ink, 1 - ink]), tuple(round(side * scale) for side in ink.shape)
    )
    at = round(_BEYOND * scale)
    return whole * larger[0, at : at + shape[0], at : at + shape[1]]


def _greys_of_edges(ink: NDArray[np.float32]) -> NDArray[np.float32]:
    """Return ink, from 0 to 1, without noise on the paper and shades within: they are no edges."""
    near_ink = maximum_filter(ink, 3) > _LITTLE
    near_paper = minimum_filter(ink, 3) < _LITTLE
    edges: NDArray[np.float32] = np.where(near_ink & near_paper, ink, np.rint(ink))
    return edges


def _bounds(dark: NDArray[np.float32], axes: bool) -> tuple[int, int, int, int] | None:
    """Return left, top, right, bottom of the drawing with some air; None if there is none.

    It may have faint ``axes``.
    """
    soft = scipy.ndimage.gaussian_filter(dark, 0.7)
    threshold = _threshold(soft)
    if threshold is None:
        return None
    # Also what is a little fainter than the rest: the user may want it.
    ink = without_specks(soft > 0.7 * threshold, soft.size // 20000)
    lines = drawing_in_faint_lines(soft, threshold)
    if lines is None and axes and is_clean(soft, threshold):
        lines = faint_lines(soft, threshold)
    box = box_of(ink if lines is None else ink | lines)
    if box is None:
        return None
    top, bottom, left, right = box[0].start, box[0].stop, box[1].start, box[1].stop
    air = round(_MARGIN * max(bottom - top, right - left)) + 1
    height, width = dark.shape
    return (
        max(0, left - air),
        max(0, top - air),
        min(width, right + air),
        min(height, bottom + air),
    )


def _threshold(dark: NDArray[np.float32]) -> float | None:
    """Return half the darkness of ink, where a blurred edge really runs; None if there is none."""
    from skimage.filters import threshold_otsu

    if np.ptp(dark) < LEAST:
        return None
    split = threshold_otsu(dark)
    paper, ink = dark[dark <= split], dark[dark > split]
    low, high = float(np.median(paper)), float(np.percentile(ink, 75))
    if high - low < LEAST:
        return None
    return (low + high) / 2
