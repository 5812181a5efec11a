"""New lines in a style, along nothing (*Curve Analogies*, sections 3.1 and 3.4)."""

from iconstudio.model import Line, LineStyle
from iconstudio.model.polygon import Point

SHORTEST, LONGEST = 20.0, 20_000.0
WIDTH = 4.0
"""Of the stroke, in canvas units."""


def scribbled(style: LineStyle, length: float, seed: int) -> tuple[Line, Point]:
    """Return a new line of about this length in a style, and the size of what it draws.

    It lies as near to the origin as its width lets it. Runs in a worker process.
    """
    import numpy as np

    from iconstudio.algorithms.curves.multiresolution import scribble
    from iconstudio.algorithms.curves.prepared import prepare, smoothed

    prepared = prepare(style)
    parameters, levels = prepared.whole
    made = scribble(levels, length, parameters, seed, style.rotation)
    widths = WIDTH * smoothed(prepared.widths(levels, made.sources), made.curve, WIDTH)
    points = np.stack([made.curve.points.real, made.curve.points.imag], axis=1)
    edge = max(WIDTH, widths.max())
    points += edge - points.min(axis=0)
    across, down = np.ceil(points.max(axis=0) + edge)
    varied = tuple(widths.tolist()) if np.ptp(widths) > 0 else ()
    line = Line(tuple((x, y) for x, y in points.tolist()), width=WIDTH, widths=varied)
    return line, (float(across), float(down))
