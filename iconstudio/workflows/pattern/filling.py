"""The shape of an icon that a pattern fills."""

from iconstudio.model import CANVAS, Path, Transform

_LINES = 0.5
"""An icon is drawn in lines if it inks less of what its contours enclose."""


def fitted(path: Path, size: tuple[int, int]) -> Path:
    """Return the shape of an icon as large as so many rows and columns allow, in the middle."""
    rows, columns = size
    scale = min(rows, columns) / CANVAS
    off = (columns - CANVAS * scale) / 2, (rows - CANVAS * scale) / 2
    return enclosed(path).transformed(Transform(scale, 0, 0, scale, *off))


def enclosed(path: Path) -> Path:
    """Return all that an icon drawn in lines encloses; of another one, its own shape."""
    areas = [Path((contour,)).area for contour in path.contours]
    if not areas:
        return path
    way = max(areas, key=abs) > 0
    outer = [(one, area) for one, area in zip(path.contours, areas, strict=True)
             if (area > 0) == way]  # fmt: skip
    if abs(sum(areas)) >= _LINES * abs(sum(area for _, area in outer)):
        return path
    return Path(tuple(one for one, _ in outer))
