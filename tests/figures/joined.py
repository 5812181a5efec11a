"""Results as they were traced, and of their sources' curves: ``python -m tests.figures.joined``.

Nodes are marked: on the left those that a tracer sets, on the right the sources' own.
"""

from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from iconstudio.algorithms.iconification.energy import placed_sources
from iconstudio.model import CANVAS, Drawing, Frame, Remix
from iconstudio.output import png
from iconstudio.output.figure import MUTED, Figure
from iconstudio.resources import resource
from iconstudio.session import Session
from iconstudio.svg.placed import render_placed
from iconstudio.svg.resvg import render_colours
from iconstudio.workflows.drawing import draw
from iconstudio.workflows.events import Result
from iconstudio.workflows.grid import GridSettings
from iconstudio.workflows.modelling.file import read_sketch
from iconstudio.workflows.modelling.spec import MODELLING

TARGET = resource("pictures") / "joined.png"
SIDE, GAP, HEAD = 512, 32, 44


class Subject(NamedTuple):
    """A sketch of the gallery, and which of its results to show."""

    name: str
    style: str
    lambda_s: float


SUBJECTS = (
    Subject("motorcycle", "light", 0.47),
    Subject("lamp", "lightest", 0.75),
    Subject("sailboat", "lightest", 0.19),
)


def main() -> None:
    """Write the picture."""
    figure = Figure(2 * SIDE + 3 * GAP, len(SUBJECTS) * (SIDE + HEAD) + GAP)
    with Session() as session:
        for row, subject in enumerate(SUBJECTS):
            y = GAP + row * (SIDE + HEAD)
            for column, drawing in enumerate(drawings(session, subject)):
                x = GAP + column * (SIDE + GAP)
                figure.image(x, y, picture(drawing))
                said = f"{'traced' if column == 0 else 'of its sources'}: {nodes(drawing)} nodes"
                figure.text(x, y + SIDE + 6, said, 16, colour=MUTED, width=SIDE)
    Path(TARGET).write_bytes(png.encoded(figure.picture))


def drawings(session: Session, subject: Subject) -> tuple[Drawing, Drawing]:
    """Return a result as it was traced before, and as it is drawn now."""
    file = read_sketch(resource("examples") / "gallery" / f"{subject.name}.json")
    settings = GridSettings(styles=(subject.style,), lambdas=(subject.lambda_s,))
    found = [
        one.icon for one in session.run(MODELLING, file.sketch, settings) if isinstance(one, Result)
    ]
    remix = found[-1]
    assert isinstance(remix, Remix)
    ink, _ = placed_sources(remix.composite.sources, len(remix.composite.labels))
    traced = draw(remix.composite.labels, ink, remix.composite.sources, render_placed, exact=False)
    return traced, remix.drawing


def nodes(drawing: Drawing) -> int:
    """Return how many nodes its path has."""
    return sum(len(contour.segments) for contour in drawing.path.contours)


def picture(drawing: Drawing) -> NDArray[np.uint8]:
    """Draw a path in grey with its nodes, (SIDE, SIDE, 4)."""
    ends = [segment[-1] for contour in drawing.path.contours for segment in contour.segments]
    marks = "".join(f'<circle cx="{x}" cy="{y}" r="1.6"/>' for x, y in ends)
    body = f'<path d="{drawing.path.svg()}" fill="#b4b8c0"/><g fill="#1f5fd0">{marks}</g>'
    document = f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 256 256">{body}</svg>'
    return render_colours(document, Frame(0, 0, CANVAS), SIDE)


if __name__ == "__main__":
    main()
