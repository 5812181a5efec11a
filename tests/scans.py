"""Scans of icons, made up: how a drawing of known shape looks on paper, on a board, in a file."""

import io

import numpy as np
from PIL import Image
from scipy import ndimage
from skimage.transform import ProjectiveTransform, warp

SIDE = 400
"""Pixels of the icon on a scan."""


def _blank(ink: np.ndarray, random: np.random.Generator) -> np.ndarray:
    """Put an icon somewhere on a sheet: (h, w) from 0, paper, to 1, ink."""
    sheet = np.zeros((3 * SIDE // 2, 9 * SIDE // 5))
    y, x = random.integers(20, SIDE // 2 - 20), random.integers(20, 4 * SIDE // 5 - 20)
    sheet[y : y + SIDE, x : x + SIDE] = ink
    return sheet


def _grey(light: np.ndarray) -> np.ndarray:
    return np.repeat(light[..., None], 3, axis=2)


def _pixels(picture: np.ndarray) -> np.ndarray:
    return (np.clip(picture, 0, 1) * 255).astype(np.uint8)


def _unevenly_lit(shape: tuple[int, int], random: np.random.Generator) -> np.ndarray:
    y, x = np.mgrid[-1 : 1 : shape[0] * 1j, -1 : 1 : shape[1] * 1j]
    angle = random.uniform(0, 2 * np.pi)
    return 0.75 + 0.17 * (np.cos(angle) * x + np.sin(angle) * y)


def plain(sheet, random):
    return _pixels(_grey(1 - sheet))


def blurred(sheet, random):
    return _pixels(_grey(1 - ndimage.gaussian_filter(sheet, 2)))


def noisy(sheet, random):
    return _pixels(_grey(1 - 0.85 * sheet) + random.normal(0, 0.08, (*sheet.shape, 3)))


def unevenly_lit(sheet, random):
    light = (1 - 0.8 * sheet) * _unevenly_lit(sheet.shape, random)
    return _pixels(_grey(light) + random.normal(0, 0.02, (*sheet.shape, 3)))


def half_in_shadow(sheet, random):
    y, x = np.mgrid[: sheet.shape[0], : sheet.shape[1]]
    shadow = 1 - 0.35 / (1 + np.exp(-(0.8 * x + 0.6 * y - 0.6 * sheet.shape[1]) / 25))
    return _pixels(_grey((1 - 0.8 * sheet) * shadow) + random.normal(0, 0.02, (*sheet.shape, 3)))


def yellow_pen(sheet, random):
    paper, pen = np.array([0.97, 0.95, 0.88]), np.array([0.95, 0.8, 0.2])
    picture = paper + (pen - paper) * sheet[..., None]
    return _pixels(picture + random.normal(0, 0.015, picture.shape))


def pencil(sheet, random):
    return _pixels(_grey(0.9 - 0.3 * sheet) + random.normal(0, 0.03, (*sheet.shape, 3)))


def chalk(sheet, random):
    light = (0.12 + 0.7 * sheet) * _unevenly_lit(sheet.shape, random)
    return _pixels(_grey(light) + random.normal(0, 0.03, (*sheet.shape, 3)))


def inverted(sheet, random):
    return _pixels(_grey(sheet))


def squeezed_as_jpeg(sheet, random):
    file = io.BytesIO()
    Image.fromarray(unevenly_lit(sheet, random)).save(file, "JPEG", quality=15)
    return np.asarray(Image.open(file))


def with_specks(sheet, random):
    specks = np.zeros(sheet.shape)
    specks[random.integers(0, sheet.shape[0], 150), random.integers(0, sheet.shape[1], 150)] = 0.8
    return _pixels(_grey(1 - np.maximum(0.85 * sheet, ndimage.grey_dilation(specks, 3))))


def on_a_desk(sheet, random):
    """The sheet lies straight; ``turned`` turns it, and the drawing with it."""
    light = np.pad(unevenly_lit(sheet, random) / 255, ((30, 40), (50, 20), (0, 0)), mode="constant")
    desk = np.pad(np.zeros(sheet.shape), ((30, 40), (50, 20)), constant_values=1)[..., None]
    picture = light + desk * np.array([0.35, 0.25, 0.18])
    return _pixels(picture + random.normal(0, 0.02, picture.shape))


def lit_from_one_side(sheet, random):
    """Without noise, as a picture that was made up is."""
    return _pixels(_grey(0.9 - 0.6 * sheet) * np.linspace(0.35, 1, sheet.shape[1])[:, None])


def lit_by_a_lamp(sheet, random):
    y, x = np.mgrid[: sheet.shape[0], : sheet.shape[1]]
    far = np.hypot(y - 200, x - 500)
    return _pixels(_grey((1 - 0.8 * sheet) * (1 - 0.65 * far / far.max())))


def in_a_deep_shadow(sheet, random):
    y, x = np.mgrid[: sheet.shape[0], : sheet.shape[1]]
    shadow = 1 - 0.65 / (1 + np.exp(-(x + 0.3 * y - 0.6 * sheet.shape[1]) / 20))
    light = _grey((1 - 0.8 * sheet) * shadow)
    return _pixels(
        light + random.normal(0, 0.01, light.shape)
    )  # a camera's; without, it is painted


def on_an_even_desk(sheet, random):
    return laid_on(sheet, (0.24, 0.16, 0.12))


def on_a_yellow_desk(sheet, random):
    return laid_on(sheet, (0.9, 0.75, 0.2))


def laid_on(sheet, colour, degrees=0):
    """A white sheet on a desk of one colour, the drawing turned with it; without noise."""
    paper = np.pad(np.ones(sheet.shape), ((30, 40), (50, 20)))
    ink = np.pad(sheet, ((30, 40), (50, 20)))
    if degrees:
        paper, ink = (ndimage.rotate(one, degrees, order=1) for one in (paper, ink))
    return _pixels((paper - 0.9 * ink)[..., None] + (1 - paper)[..., None] * np.array(colour))


def photographed(sheet, corners, desk, blur=2.5, noise=12.0, seed=0):
    """A photo of a sheet on a desk, aslant, unevenly lit, out of focus, noisy, as poor JPEG.

    The desk is dark, pale, wood, checked or striped. ``corners`` of the sheet are (4, 2), x and y,
    from the upper left on clockwise; they may lie past the photo. Returns the photo,
    (h, w, 3) uint8, and where its ink is, (h, w) from 0 to 1.
    """
    random = np.random.default_rng(seed)
    shape = (480, 640)
    height, width = sheet.shape
    to_sheet = _homography(corners, [(0, 0), (width, 0), (width, height), (0, height)])
    paper, ink = (warp(one, to_sheet, output_shape=shape) for one in (np.ones_like(sheet), sheet))
    picture = (0.9 * paper - 0.75 * ink)[..., None] + (1 - paper)[..., None] * _desk(desk, shape)
    picture = picture * _unevenly_lit(shape, random)[..., None] / 0.9
    picture = ndimage.gaussian_filter(picture, (blur, blur, 0))
    file = io.BytesIO()
    noisy = _pixels(picture + random.normal(0, noise / 255, picture.shape))
    Image.fromarray(noisy).save(file, "JPEG", quality=40)
    return np.asarray(Image.open(file)), ink


def _homography(points, images) -> ProjectiveTransform:
    rows = []
    for (x, y), (u, v) in zip(points, images, strict=True):
        rows += [(x, y, 1, 0, 0, 0, -u * x, -u * y), (0, 0, 0, x, y, 1, -v * x, -v * y)]
    solved = np.linalg.solve(np.array(rows, float), np.ravel(images))
    return ProjectiveTransform(matrix=np.append(solved, 1).reshape(3, 3))


def _desk(kind: str, shape: tuple[int, int]) -> np.ndarray:
    y, x = np.mgrid[: shape[0], : shape[1]]
    if kind == "wood":
        veins = 0.12 * np.sin(y / 4 + 2 * np.sin(x / 60))
        return np.array([0.45, 0.3, 0.18]) * (1 + veins[..., None])
    if kind == "pale":
        return np.broadcast_to(np.array([0.82, 0.8, 0.78]), (*shape, 3))
    chosen = {"dark": 0 * x, "checked": (x // 45 + y // 45) % 2, "striped": (x + y) // 30 % 2}
    colours = np.array([[0.15, 0.14, 0.17], [0.4, 0.36, 0.33]])
    return colours[chosen[kind]]


def transparent(sheet, random):
    return _on_nothing(sheet, (0, 0, 0))


def white_on_nothing(sheet, random):
    return _on_nothing(sheet, (255, 255, 255))


def orange_on_nothing(sheet, random):
    return _on_nothing(sheet, (250, 140, 30))


def _on_nothing(sheet, colour):
    picture = np.empty((*sheet.shape, 4), np.uint8)
    picture[..., :3], picture[..., 3] = colour, _pixels(sheet)
    return picture


def small(sheet, random):
    grey = Image.fromarray(_pixels(1 - sheet))
    smaller = grey.resize((grey.width // 4, grey.height // 4), Image.Resampling.LANCZOS)
    return np.repeat(np.asarray(smaller)[..., None], 3, axis=2)


def large(sheet, random):
    picture = Image.fromarray(unevenly_lit(sheet, random))
    larger = (3 * picture.width, 3 * picture.height)
    return np.asarray(picture.resize(larger, Image.Resampling.BICUBIC))


KINDS = (
    *(plain, blurred, noisy, unevenly_lit, half_in_shadow, yellow_pen, pencil, chalk, inverted),
    *(squeezed_as_jpeg, with_specks, on_a_desk, transparent, white_on_nothing, orange_on_nothing),
    *(small, large, lit_from_one_side, lit_by_a_lamp, in_a_deep_shadow),
    *(on_an_even_desk, on_a_yellow_desk),
)


def scan(ink: np.ndarray, kind, seed: int) -> np.ndarray:
    """Return a scan of an icon, (SIDE, SIDE) from 0 to 1: (h, w, 3) or (h, w, 4) uint8."""
    random = np.random.default_rng(seed)
    return kind(_blank(ink, random), random)


def fitted(shape: np.ndarray, side: int = 256) -> np.ndarray:
    """Return a shape, (h, w) from 0 to 1, scaled to fill a canvas but for a margin, as bool."""
    rows = np.flatnonzero((shape > 0.5).any(axis=1))
    columns = np.flatnonzero((shape > 0.5).any(axis=0))
    crop = shape[rows[0] : rows[-1] + 1, columns[0] : columns[-1] + 1]
    scale = (side - 16) / max(crop.shape)
    size = tuple(max(1, round(one * scale)) for one in crop.shape[::-1])
    canvas = Image.new("L", (side, side))
    image = Image.fromarray(_pixels(crop)).resize(size, Image.Resampling.BICUBIC)
    canvas.paste(image, ((side - size[0]) // 2, (side - size[1]) // 2))
    return np.asarray(canvas) > 127


def iou(first: np.ndarray, second: np.ndarray) -> float:
    """Return the intersection of two shapes as part of their union."""
    return float((first & second).sum() / (first | second).sum())
