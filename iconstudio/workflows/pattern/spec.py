"""What patterns declare."""

from dataclasses import replace

from iconstudio.model import Patterning, Pictogram
from iconstudio.workflows.pattern.file import PatternFile
from iconstudio.workflows.workflow import Workflow, lazily


def icons_of(work: Patterning) -> tuple[Pictogram, ...]:
    """Return the icons of an exemplar, each once."""
    return tuple(dict.fromkeys(one.icon for one in work.motifs))


def with_icons(work: Patterning, icons: tuple[Pictogram, ...]) -> Patterning:
    """Return the work with these icons scattered over its canvas."""
    from iconstudio.workflows.pattern.scattering import scattered

    return replace(work, motifs=scattered(icons, work.seed), image=None)


PATTERN = Workflow(
    name="pattern",
    title="Pattern",
    noun="pattern",
    help="Continue a few icons, or an ornament, as a pattern.",
    invitation="Make a pattern of it",
    file=PatternFile,
    run=lazily("iconstudio.workflows.pattern.patterning:run"),
    command="iconstudio.cli.pattern:command",
    examples="patterns",
    workspace="iconstudio.gui.workspaces.pattern.workspace:PatternWorkspace",
    page_format="iconstudio.workflows.pattern.page_format:PatternPages",
    icons=icons_of,
    with_icons=with_icons,
)
