"""Lengths, lists of numbers and transforms, as SVG writes them."""

import math
import re
import xml.etree.ElementTree as ET

Box = tuple[float, float, float, float]
"""x, y, width and height in user space."""
Matrix = tuple[float, float, float, float, float, float]
"""a, b, c, d, e, f: x' = a x + c y + e, y' = b x + d y + f."""

IDENTITY: Matrix = (1.0, 0.0, 0.0, 1.0, 0.0, 0.0)
NUMBER = re.compile(r"[+-]?(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][+-]?\d+)?")
_LENGTH = re.compile(rf"({NUMBER.pattern})\s*([a-z]*)", re.IGNORECASE)
_PIXELS = {
    "": 1, "px": 1, "pt": 96 / 72, "pc": 16, "mm": 96 / 25.4, "cm": 96 / 2.54, "in": 96,
    "em": 16, "rem": 16, "ex": 8, "q": 96 / 101.6,
}  # fmt: skip
_ANGLES = {"": 1.0, "deg": 1.0, "rad": 180 / math.pi, "grad": 0.9, "turn": 360.0}
_ARGUMENT = re.compile(rf"{NUMBER.pattern}(?:[a-zA-Z]+|%)?")
_FLAT = 1e-15
"""Part of the square of its largest number that the determinant of a flat matrix has at most."""
_FUNCTION = re.compile(r"([a-zA-Z0-9]+)\s*\(([^()]*)\)")


def pixels(length: str | None) -> float | None:
    """Return a CSS length in pixels; None if absent, or relative to something else."""
    match = _LENGTH.fullmatch((length or "").strip())
    if match is None or match[2].lower() not in _PIXELS:
        return None
    return finite(float(match[1]) * _PIXELS[match[2].lower()])


def length(text: str | None, whole: float, default: float = 0.0) -> float:
    """Return a length in pixels, of which a percentage is part of ``whole``."""
    text = (text or "").strip()
    if text.endswith("%"):
        match = NUMBER.fullmatch(text[:-1].strip())
        return default if match is None else finite(float(match[0]) / 100 * whole) or 0.0
    found = pixels(text)
    return default if found is None else found


def page_of(root: ET.Element) -> Box | None:
    """Return the box of a document's ``viewBox``, or else of its size; None if it has neither."""
    box = numbers(root.get("viewBox", ""))
    if len(box) == 4 and box[2] > 0 and box[3] > 0:
        return box[0], box[1], box[2], box[3]
    width, height = pixels(root.get("width")), pixels(root.get("height"))
    return (0.0, 0.0, width, height) if width and height else None


def whole_of(name: str, page: Box) -> float:
    """Return what percentages of an attribute, or property, are of (SVG 2, section 8.9)."""
    if name in ("x", "cx", "rx", "width", "x1", "x2"):
        return page[2]
    if name in ("y", "cy", "ry", "height", "y1", "y2"):
        return page[3]
    return math.hypot(page[2], page[3]) / math.sqrt(2)


def numbers(text: str) -> list[float]:
    """Return all numbers in a text."""
    return [float(one) for one in NUMBER.findall(text)]


def finite(number: float) -> float | None:
    """Return a number; None if it is infinite."""
    return number if math.isfinite(number) else None


def multiplied(first: Matrix, then: Matrix) -> Matrix:
    """Return the matrix that maps a point by ``then``, and the result by ``first``."""
    a, b, c, d, e, f = first
    g, h, i, j, k, m = then
    return (
        a * g + c * h,
        b * g + d * h,
        a * i + c * j,
        b * i + d * j,
        a * k + c * m + e,
        b * k + d * m + f,
    )


def inverse(matrix: Matrix) -> Matrix | None:
    """Return the inverse of a matrix; None if it has none."""
    a, b, c, d, e, f = matrix
    det = a * d - b * c
    if not math.isfinite(det) or abs(det) <= _FLAT * max(map(abs, matrix[:4])) ** 2:
        return None
    return (
        d / det,
        -b / det,
        -c / det,
        a / det,
        (c * f - d * e) / det,
        (b * e - a * f) / det,
    )


def scale_of(matrix: Matrix) -> float:
    """Return by how much a matrix enlarges, in the mean over all directions."""
    a, b, c, d, _, _ = matrix
    return math.sqrt(abs(a * d - b * c))


def even_part(matrix: Matrix) -> Matrix:
    """Return what of a matrix moves and enlarges: it turns and shears the outcome no further.

    A matrix that is flat, and shows nothing, has none.
    """
    a, b, c, d, e, f = matrix
    scale = scale_of(matrix)
    rest = inverse((a / scale, b / scale, c / scale, d / scale, 0, 0)) if scale else None
    if rest is None or not math.isfinite(scale):
        return IDENTITY
    x, y = multiplied(rest, (1, 0, 0, 1, e, f))[4:]
    return scale, 0.0, 0.0, scale, x, y


def between(outer: Matrix, matrix: Matrix, inner: Matrix) -> Matrix:
    """Return what becomes of a matrix if the space it leads from, and to, are mapped so."""
    back = inverse(inner)
    return IDENTITY if back is None else multiplied(multiplied(outer, matrix), back)


def mapped(matrix: Matrix, box: Box) -> Box:
    """Return the bounding box of a box that is mapped."""
    a, b, c, d, e, f = matrix
    x, y, width, height = box
    corners = [(x, y), (x + width, y), (x, y + height), (x + width, y + height)]
    xs = [a * px + c * py + e for px, py in corners]
    ys = [b * px + d * py + f for px, py in corners]
    return min(xs), min(ys), max(xs) - min(xs), max(ys) - min(ys)


def enlarged(box: Box, by: float) -> Box:
    """Return a box that is larger by as much on every side."""
    return box[0] - by, box[1] - by, box[2] + 2 * by, box[3] + 2 * by


def written(values: "tuple[float, ...]") -> str:
    """Return numbers as SVG writes them, to a relative precision of 1e-9."""
    return " ".join(f"{float(value):.10g}" for value in values)


def transform(text: str | None) -> Matrix | None:
    """Return the matrix of a ``transform``, as attributes and as CSS write it.

    None if it is not understood.
    """
    matrix = IDENTITY
    text = (text or "").strip()
    if text.lower() in ("", "none"):
        return matrix
    inner = (_ARGUMENT.sub("", arguments) for _, arguments in _FUNCTION.findall(text))
    rest = "".join([_FUNCTION.sub("", text), *inner])
    if rest.replace(",", "").strip():
        return None
    for name, arguments in _FUNCTION.findall(text):
        one = _one(name, _ARGUMENT.findall(arguments))
        if one is None or not all(map(math.isfinite, one)):
            return None
        matrix = multiplied(matrix, one)
    return matrix


def _one(name: str, arguments: list[str]) -> Matrix | None:
    angular = name.lower() in ("rotate", "rotatez", "skewx", "skewy", "skew")
    values = [
        _angle(one) if angular and not (number and name.lower() == "rotate") else pixels(one)
        for number, one in enumerate(arguments)
    ]
    if name.lower().startswith("scale"):
        values = [_factor(one) for one in arguments]
    v = [one for one in values if one is not None]
    if not v or len(v) < len(values):
        return None
    match name.lower(), len(v):
        case "matrix", 6:
            return v[0], v[1], v[2], v[3], v[4], v[5]
        case ("translate", 1 | 2) | ("translate3d", 3):
            return 1, 0, 0, 1, v[0], v[1] if len(v) > 1 else 0
        case "translatex", 1:
            return 1, 0, 0, 1, v[0], 0
        case "translatey", 1:
            return 1, 0, 0, 1, 0, v[0]
        case ("scale", 1 | 2) | ("scale3d", 3):
            return v[0], 0, 0, v[1] if len(v) > 1 else v[0], 0, 0
        case "scalex", 1:
            return v[0], 0, 0, 1, 0, 0
        case "scaley", 1:
            return 1, 0, 0, v[0], 0, 0
        case (("rotate" | "rotatez"), (1 | 3)):
            turned = math.radians(v[0])
            cos, sin = math.cos(turned), math.sin(turned)
            turn = cos, sin, -sin, cos, 0.0, 0.0
            if len(v) == 1:
                return turn
            return around((v[1], v[2]), turn)
        case "skewx", 1:
            return 1, 0, math.tan(math.radians(v[0])), 1, 0, 0
        case "skewy", 1:
            return 1, math.tan(math.radians(v[0])), 0, 1, 0, 0
        case "skew", (1 | 2):
            down = math.tan(math.radians(v[1])) if len(v) > 1 else 0.0
            return 1, down, math.tan(math.radians(v[0])), 1, 0, 0
    return None


def around(point: tuple[float, float], matrix: Matrix) -> Matrix:
    """Return a matrix whose origin is at ``point``."""
    x, y = point
    return multiplied(multiplied((1, 0, 0, 1, x, y), matrix), (1, 0, 0, 1, -x, -y))


def _angle(text: str) -> float | None:
    match = _LENGTH.fullmatch(text)
    if match is None or match[2].lower() not in _ANGLES:
        return None
    return float(match[1]) * _ANGLES[match[2].lower()]


def _factor(text: str) -> float | None:
    number = NUMBER.match(text)
    if number is None or text[number.end() :] not in ("", "%"):
        return None
    return float(number[0]) / (100 if text.endswith("%") else 1)
