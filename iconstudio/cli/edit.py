"""``iconstudio edit``: sketch-based editing without a window."""

from dataclasses import replace
from pathlib import Path

from iconstudio.cli import grid
from iconstudio.inputs.edit import read_edit
from iconstudio.output.wish import changed
from iconstudio.session import Session
from iconstudio.workflows.editing import own_styles, prepare_change
from iconstudio.workflows.grid import ModelSettings


@grid.grid_command("edit", "EDIT.json", "the icon's own")
def command(
    file: Path,
    folder: Path,
    keyword: str | None,
    exclude: tuple[str, ...],
    styles: tuple[str, ...],
    lambdas: tuple[float, ...],
    scales: tuple[float, ...],
    dump: bool,
) -> None:
    """Change the icon in EDIT.json: take parts off, and put parts of other icons on."""
    read = read_edit(file)
    with Session() as session:
        edit = read.resolved(session.icon)
        edit = replace(
            edit,
            keyword=edit.keyword if keyword is None else keyword,
            exclude=edit.exclude | frozenset(exclude),
        )
        icon = session.exemplar(edit.icon)
        wish = changed(edit, prepare_change(edit, icon))
        settings = ModelSettings(styles or own_styles(icon), lambdas, scales)
        settings.chosen_styles()
        grid.need_keyword(edit.keyword)
        grid.run(session, session.edit(edit, settings), wish, settings, folder, dump=dump)
