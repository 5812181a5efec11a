"""``iconstudio edit``: sketch-based editing without a window."""

from iconstudio.cli import grid, running
from iconstudio.cli.timing import profiled
from iconstudio.output.request import edit_request
from iconstudio.session import Session
from iconstudio.workflows.editing.editing import own_styles
from iconstudio.workflows.editing.file import read_edit
from iconstudio.workflows.editing.page import doubts
from iconstudio.workflows.editing.placing import place_edited
from iconstudio.workflows.editing.spec import EDITING


@grid.grid_command("edit", "EDIT.json", "the icon's own")
def command(options: grid.GridOptions) -> None:
    """Change the icon in EDIT.json: take parts off, and put parts of other icons on."""
    read = read_edit(options.file)
    with profiled(options.profile) as stopwatch, Session() as session:
        edit = options.of(read.resolved(session.icon), session)
        running.tell_remarks([edit.icon])
        icon = session.exemplar(edit.icon)
        request = edit_request(place_edited(edit, icon, session.workers, session.render))
        settings = options.settings(own_styles(icon))
        settings.chosen_styles()
        grid.need_keyword(edit.keyword)
        if doubt := doubts(edit):
            running.tell(doubt)
        events = session.run(EDITING, edit, settings)
        grid.run(session, events, request, settings, options.folder, stopwatch, dump=options.dump)
