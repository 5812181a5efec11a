"""What a project holds: the pages of workflows and the results that were picked."""

from collections.abc import Generator, Iterator, Mapping
from contextlib import closing
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, TypeVar

from msgspec import structs

from iconstudio.inputs import json
from iconstudio.model import Icon, IconstudioError
from iconstudio.project.archive import INDEX, Index, Project
from iconstudio.project.parts import Parts, ProjectSession, StoredParts
from iconstudio.workflows.events import Progress
from iconstudio.workflows.pages import Page, PageFormat
from iconstudio.workflows.workflow import Workflow, load_object

T = TypeVar("T")

_HERE = Path(INDEX)


class Formats(dict[str, PageFormat[Any, Any]]):
    """Those of the pages of workflows, by their names; loaded when they are first needed."""

    def __init__(self, workflows: Mapping[str, Workflow[Any]]) -> None:
        super().__init__()
        self.workflows = workflows

    def __missing__(self, name: str) -> PageFormat[Any, Any]:
        workflow = self.workflows[name]
        self[name] = load_object(workflow.page_format)(workflow)
        return self[name]


@dataclass(frozen=True, slots=True, eq=False)
class Contents:
    """The pages that are not empty, by the names of their workflows, and the recent results."""

    current: str = ""
    """The name of the workflow in sight."""
    pages: Mapping[str, Page] = field(default_factory=dict)
    recent: tuple[Icon, ...] = ()
    complaints: tuple[str, ...] = ()
    """What could not be read; a sentence for the user each."""
    unread: Project | None = None
    """The project with pages that could not be read: they are stored again as they were."""

    def alike(self, other: "Contents", formats: Formats) -> bool:
        """Whether there is nothing that would be lost with the other ones in their place."""
        pages = self.pages
        return (
            pages.keys() == other.pages.keys()
            and all(formats[name].alike(pages[name], other.pages[name]) for name in pages)
            and _all_in(self.recent, other.recent)
            and _all_in(other.recent, self.recent)
        )

    def results(self, formats: Formats) -> Iterator[Icon]:
        """Yield all results: the recent ones, and those that are kept on pages."""
        yield from self.recent
        for name, page in self.pages.items():
            yield from formats[name].kept(page)

    def project(self, formats: Formats, file: str = "") -> Project:
        """Return them as they are stored; a journal tells in which ``file`` they were saved."""
        unread = self.unread
        parts = Parts() if unread is None else Parts(unread.index.icons)
        pages = {name: formats[name].write(page, parts) for name, page in self.pages.items()}
        recent = tuple(parts.result(one) for one in self.recent if one.path)
        icons: dict[str, Any] = {**parts.icons}
        contents = parts.contents
        if unread is not None:
            pages = unread.index.pages | pages
            icons = unread.index.icons | icons
            contents = {**unread.parts} | contents
        index = Index(current=self.current, pages=pages, recent=recent, icons=icons, file=file)
        return Project(index, contents)


def reading(session: ProjectSession, project: Project, formats: Formats) -> Generator[Any]:
    """Yield the contents of a project at last; before that progress.

    A page that cannot be read is told and kept, and the others are there. Fields that are not
    known here are told, too.
    """
    index = project.index
    parts = StoredParts(index.icons, project.parts, session)
    parts.note_unknown("In the project", project.unknown)
    pages: dict[str, Page] = {}
    for name in sorted(index.pages):
        if name not in formats.workflows:
            parts.complaints.append(
                f"There is no workflow “{name}” here: its page is not shown, but kept as it is."
            )
            continue
        title = formats.workflows[name].title
        try:
            page = index.pages[name]
            stored = json.converted(page, formats[name].stored, _HERE, f", {name}")
            parts.note_unknown(f"On the page of {title}", json.unknown_fields(stored, page))
            with closing(formats[name].read(stored, parts)) as steps:
                pages[name] = yield from _told(steps, parts)
        except IconstudioError as error:
            parts.complaints.append(f"The page of {title} could not be read. {error}")
    recent = yield from _told(parts.results(index.recent), parts)
    left = {name: page for name, page in index.pages.items() if name not in pages}
    unread = Project(structs.replace(index, pages=left), project.parts) if left else None
    complaints = (*parts.complaints, *parts.passed_over)
    yield Contents(index.current, pages, recent, complaints, unread)


def _told(steps: Generator[Any, None, T], parts: StoredParts) -> Generator[Progress, None, T]:
    """Yield at each step the share of the project that has been read; return the same."""
    try:
        while True:
            next(steps)
            yield Progress("open", parts.share, "Opening the project")
    except StopIteration as end:
        found: T = end.value
        return found


def _all_in(some: tuple[Icon, ...], others: tuple[Icon, ...]) -> bool:
    return all(any(one.looks_like(other) for other in others) for one in some)
