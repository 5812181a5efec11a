"""Small exemplars and problems that several tests share."""

from collections.abc import Iterable

import numpy as np
from scipy import ndimage

from iconstudio.algorithms.iconification.energy import RemixProblem
from iconstudio.algorithms.iconification.saliency import Region, saliency, salient_regions
from iconstudio.algorithms.raster import fill_polygon
from iconstudio.model import (
    CANVAS,
    Contour,
    Credit,
    Exemplar,
    Frame,
    Icon,
    Path,
    Pictogram,
    Point,
    Polygon,
)
from iconstudio.workflows.events import Event, Result

CREDIT = Credit("shape", "A. Artist", "MIT", "https://example.org/mit", "https://example.org")


def pictogram(name: str, body: str) -> Pictogram:
    """A pictogram drawn in canvas units."""
    return Pictogram(
        f"test:{name}",
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 256 256">{body}</svg>',
        CREDIT,
    )


def exemplar(ink: np.ndarray, name: str = "shape") -> Exemplar:
    """An exemplar with this ink; its SVG is one rectangle for each run of ink in a row."""
    runs = []
    for y, row in enumerate(ink):
        edges = np.flatnonzero(np.diff(np.pad(row.astype(int), 1)))
        runs += [
            f"M{left} {y}H{right}V{y + 1}H{left}Z"
            for left, right in zip(edges[::2], edges[1::2], strict=True)
        ]
    return Exemplar(
        pictogram(name, f'<path d="{"".join(runs)}"/>'),
        Frame(0, 0, CANVAS),
        np.where(ink, 255, 0).astype(np.uint8),
    )


def blob(seed: int, sigma: float = 14, level: float = 0.0) -> np.ndarray:
    """A random smooth shape in the middle of the canvas, (CANVAS, CANVAS) bool."""
    noise = ndimage.gaussian_filter(
        np.random.default_rng(seed).normal(size=(CANVAS, CANVAS)), sigma
    )
    ys, xs = np.mgrid[:CANVAS, :CANVAS] - CANVAS / 2
    radius = np.hypot(xs, ys)
    return (noise / noise.std() * 0.5 + 1.2 - radius / 80 > level) & (radius < 90)


def problem(ink: np.ndarray, data: np.ndarray) -> RemixProblem:
    """A remix of ``ink`` (K, CANVAS, CANVAS) with the given data cost."""
    from iconstudio.algorithms.raster import solid

    return RemixProblem(data.astype(np.float32), ink, np.stack([solid(one) for one in ink]))


def saliency_of(polygon: Polygon) -> np.ndarray:
    """The saliency map of a polygon in canvas pixels."""
    return saliency([polygon], fill_polygon(polygon))


def regions_of(polygon: Polygon) -> tuple[Region, ...]:
    """The salient regions of a polygon in canvas pixels."""
    return salient_regions(saliency_of(polygon))


def outline(*contours: Iterable[Point]) -> Path:
    """Closed contours of straight lines through these points."""
    rows = [[(float(x), float(y)) for x, y in contour] for contour in contours]
    return Path(tuple(Contour(start, tuple((point,) for point in rest)) for start, *rest in rows))


def icons(events: Iterable[Event]) -> list[Icon]:
    """What a run has made, previews too."""
    return [event.icon for event in events if isinstance(event, Result)]
