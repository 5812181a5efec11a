"""Exemplars and their patterns, in one picture: ``python -m tests.figures.patterns``."""

from collections.abc import Iterable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from iconstudio.model import CANVAS, ColouredLayer, Fill, Patterned, Patterning
from iconstudio.output import png
from iconstudio.output.figure import MUTED, Figure
from iconstudio.reading import returned
from iconstudio.resources import resource
from iconstudio.session import Session
from iconstudio.workflows.events import Result
from iconstudio.workflows.files import read_file
from iconstudio.workflows.pattern.imaging import over_white
from iconstudio.workflows.pattern.spec import PATTERN

SINGLE = "garden", "cats", "music", "night"
LAYERED = "meadow", "picnic", "vine"
TARGET = resource("pictures") / "patterns.png"
SIDE, GAP, HEAD = 256, 32, 44


def main() -> None:
    """Write the picture."""
    with Session() as session:
        png_bytes = png.encoded(sheet(session, SINGLE, LAYERED))
    Path(TARGET).write_bytes(png_bytes)


def sheet(session: Session, *groups: Iterable[str]) -> Image.Image:
    """Return exemplars, each with its pattern of twice the width, side by side."""
    rows = [name for group in groups for name in group]
    cell = 3 * SIDE + 12
    down = -(-len(rows) // 2)
    figure = Figure(2 * cell + 3 * GAP, down * (SIDE + HEAD) + GAP)
    for place, name in enumerate(rows):
        x = GAP + place // down * (cell + GAP)
        y = GAP + place % down * (SIDE + HEAD)
        path = resource("examples") / "patterns" / f"{name}.json"
        work = returned(read_file(path, PATTERN, session))
        work = replace(work, width=4 * CANVAS, height=2 * CANVAS, tile=False)
        (icon,) = [one.icon for one in session.run(PATTERN, work) if isinstance(one, Result)]
        figure.image(x, y, exemplar_pixels(session, work))
        figure.image(x + SIDE + 12, y, _opaque(png.icon_pixels(icon, 2 * SIDE)))
        figure.text(x, y + SIDE + 6, icon.title, 16, colour=MUTED, width=cell)
    return figure.picture


def exemplar_pixels(session: Session, work: Patterning) -> NDArray[np.uint8]:
    """Return an exemplar as it is given, (SIDE, SIDE, 4)."""
    if work.image is not None:
        image = Image.fromarray(over_white(work.image.photo)).resize((SIDE, SIDE))
        return _opaque(np.asarray(image))
    fills = tuple(
        Fill(
            session.drawing(session.exemplar(one.icon)).path.transformed(one.transform), one.colour
        )
        for one in work.motifs
    )
    layers = (ColouredLayer("exemplar", fills),)
    canvas: dict[str, Any] = {"width": CANVAS, "height": CANVAS, "tile": False, "torn": 0.0}
    icon = Patterned(fills[0].path, "", layers=layers, ground=work.ground, **canvas)
    return _opaque(png.icon_pixels(icon, SIDE))


def _opaque(pixels: NDArray[np.uint8]) -> NDArray[np.uint8]:
    whole = np.full((*pixels.shape[:2], 4), 255, np.uint8)
    whole[..., :3] = pixels[..., :3]
    return whole


if __name__ == "__main__":
    main()
