"""What a project holds, as the window has it; written and read in threads."""

from collections.abc import Generator, Mapping
from contextlib import closing
from dataclasses import dataclass, field
from typing import Any

from iconstudio.gui.document.document import Page
from iconstudio.gui.document.pages import PageFormat, pictures_in
from iconstudio.gui.gallery.icon_list import same
from iconstudio.gui.gallery.pictures import Picture
from iconstudio.inputs.fields import Fields
from iconstudio.model import IconstudioError
from iconstudio.project.archive import Project
from iconstudio.project.parts import Parts, StoredParts
from iconstudio.session import Session
from iconstudio.workflows.workflow import Workflow, named

PLAIN = "iconstudio.gui.workspaces.plain.workspace:PlainWorkspace"
"""The workspace of workflows that have none of their own."""


class Formats(dict[str, PageFormat]):
    """Those of the pages of workflows, by their names; loaded when they are first needed."""

    def __init__(self, workflows: Mapping[str, Workflow]) -> None:
        super().__init__()
        self.workflows = workflows

    def __missing__(self, name: str) -> PageFormat:
        workflow = self.workflows[name]
        self[name] = named(workflow.workspace or PLAIN).page_format(workflow)
        return self[name]


@dataclass(frozen=True, slots=True, eq=False)
class Contents:
    """The pages that are not empty, by the names of their workflows, and the recent results."""

    current: str = ""
    """The name of the workflow in sight."""
    pages: Mapping[str, Page] = field(default_factory=dict)
    recent: tuple[Picture, ...] = ()
    complaints: tuple[str, ...] = ()
    """What could not be read; a sentence for the user each."""

    def alike(self, other: "Contents", formats: Formats) -> bool:
        """Whether there is nothing that would be lost with the other ones in their place."""
        pages = self.pages
        return (
            pages.keys() == other.pages.keys()
            and all(formats[name].alike(pages[name], other.pages[name]) for name in pages)
            and _all_in(self.recent, other.recent)
            and _all_in(other.recent, self.recent)
        )

    def project(self, formats: Formats, **index: Any) -> Project:
        """Return them as they are stored, with more that is to be told."""
        parts = Parts()
        pages = {name: formats[name].write(page, parts) for name, page in self.pages.items()}
        recent = [parts.result(one.icon) for one in self.recent if one.icon.path]
        stored = {"current": self.current, "pages": pages, "recent": recent, "icons": parts.icons}
        return Project(stored | index, parts.contents)


def reading(
    session: Session,
    index: Fields,
    contents: Mapping[str, bytes],
    formats: Formats,
) -> Generator[Any]:
    """Yield the contents of a project at last; before that progress, or None.

    A page that cannot be read is told, and the others are there.
    """
    parts = StoredParts(index, contents, session)
    pages: dict[str, Page] = {}
    entries = index.object("pages")
    for name in sorted(entries.keys):
        if name not in formats.workflows:
            parts.complaints.append(f"There is no workflow “{name}” here: its page was left out.")
            continue
        try:
            with closing(formats[name].read(entries.object(name), parts)) as steps:
                pages[name] = yield from steps
        except IconstudioError as error:
            title = formats.workflows[name].title
            parts.complaints.append(f"The page of {title} could not be read. {error}")
    recent = yield from pictures_in(index.texts("recent"), parts)
    yield Contents(index.text("current"), pages, recent, tuple(parts.complaints))


def _all_in(some: tuple[Picture, ...], others: tuple[Picture, ...]) -> bool:
    return all(any(same(one, other) for other in others) for one in some)
