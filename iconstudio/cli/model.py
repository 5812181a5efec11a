"""``iconstudio model``: sketch-based modelling without a window."""

from pathlib import Path

from iconstudio.cli import grid, running
from iconstudio.cli.timing import Stopwatch, profiled
from iconstudio.model import Sketch
from iconstudio.output.request import sketch_request
from iconstudio.session import Session
from iconstudio.workflows.grid import GridSettings
from iconstudio.workflows.modelling.file import read_sketch
from iconstudio.workflows.modelling.page import doubts
from iconstudio.workflows.modelling.spec import MODELLING


@grid.grid_command("model", "SKETCH.json", "all four", tidies=True)
def command(options: grid.GridOptions) -> None:
    """Make icons in the shape of the polygon in SKETCH.json out of parts of real ones.

    The file may have "holes" and "lines" inside the polygon, and a weight of fine
    details, "detail".
    """
    file = read_sketch(options.file)
    settings = options.settings(GridSettings().styles)
    with profiled(options.profile) as stopwatch, Session() as session:
        sketch = options.of(file.resolved(session.icon), session)
        dump, tidy = options.dump, options.tidy
        run(session, sketch, settings, options.folder, stopwatch, dump=dump, tidy=tidy)


def run(
    session: Session,
    sketch: Sketch,
    settings: GridSettings,
    folder: Path,
    stopwatch: Stopwatch,
    *,
    dump: bool = False,
    tidy: bool = True,
) -> None:
    """Model a sketch, write everything into ``folder``, and say what is there."""
    settings.chosen_styles()
    request = sketch_request(sketch)
    grid.need_keyword(sketch.keyword)
    if doubt := doubts(sketch):
        running.tell(doubt)
    events = session.run(MODELLING, sketch, settings)
    grid.run(session, events, request, settings, folder, stopwatch, dump=dump, tidy=tidy)
