"""Projects in files: new, open, save; and nothing is lost without a question."""

from collections.abc import Callable, Generator
from contextlib import closing
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any

from PySide6.QtCore import QObject, Signal
from PySide6.QtWidgets import QWidget

from iconstudio.gui.exchange.patience import Patience
from iconstudio.gui.jobs.runner import Runner
from iconstudio.gui.jobs.worker import Worker, once
from iconstudio.gui.pictures.picture import Picture, picture_of
from iconstudio.gui.project import questions, recents
from iconstudio.gui.project.journaling import Journaling
from iconstudio.gui.project.questions import Answer
from iconstudio.gui.project.work import Work
from iconstudio.inputs import json
from iconstudio.inputs.formats import plain_text
from iconstudio.model import IconstudioError
from iconstudio.project.archive import SUFFIX, Project
from iconstudio.project.contents import Contents, Formats
from iconstudio.project.files import OpenedProject, Stamp, opening, restoring, save
from iconstudio.project.journal import LeftBehind
from iconstudio.session import Session
from iconstudio.workflows.events import Progress
from iconstudio.workflows.files import likely_workflow


@dataclass(frozen=True, slots=True)
class WorkFile:
    """A file of work of one workflow, or anything else that its workspace may know."""

    path: Path
    workflow: str
    """The name of the workflow; empty if it is of none."""


class ProjectFiles(QObject):
    """The file that the window's work is in, if any, and whether it is as it is there.

    Signals
    -------
    changed()
        Another file, or what is in sight differs from it now, or no longer.
    remarked(str), failed(str)
        What was done, and what could not be; a sentence for the user.
    imported(WorkFile)
        A file was opened that is no project.
    progressed(Progress), rested()
        A project is being read that takes long; nothing is being read any more.
    restoring(bool)
        Work that a window left behind is being read, or no longer, whatever came of it.
    restored(LeftBehind)
        All of it is here.
    """

    changed = Signal()
    remarked = Signal(str)
    failed = Signal(str)
    imported = Signal(object)
    progressed = Signal(object)
    rested = Signal()
    restoring = Signal(bool)
    restored = Signal(object)

    def __init__(self, session: Session, work: Work, files: Worker, window: QWidget) -> None:
        super().__init__(window)
        self._session = session
        self._work = work
        self._files = files
        self._window = window
        self._saved: Contents | None = work.contents()
        """As it is in the file, or at the beginning; None if it never was like that."""
        self._path: Path | None = None
        self._stamp: Stamp | None = None
        """Of the file as it was read or saved here."""
        self._project = 0
        """Counts the projects that were here."""
        self._modified = self._loading = False
        self._pictures: tuple[Picture, ...] = ()
        """Of results on pages that wait for their workspaces, so that nobody draws them again."""
        self.journaling = Journaling(self._taken, self)
        self._runner = Runner(files, self)
        self._patience = Patience(self.progressed.emit, self.rested.emit, self)
        self._runner.event.connect(self._receive)
        self._runner.progress.connect(self._tell)
        self._runner.failed.connect(self.failed)
        self._runner.ended.connect(self._rest)
        self.journaling.failed.connect(self.failed)
        work.changed.connect(self._compare)

    @property
    def path(self) -> Path | None:
        """The file; None if the work has not been saved yet."""
        return self._path

    @property
    def modified(self) -> bool:
        """Whether there is work that is not in the file."""
        return self._modified

    @property
    def name(self) -> str:
        """What the project is called; empty if it has not been saved yet."""
        return "" if self._path is None else self._path.name

    # -- what the user does --------------------------------------------------------------------

    def new(self) -> None:
        """Start another project."""
        self.cancel()
        self._replace(OpenedProject(Contents()))

    def choose(self) -> None:
        """Ask for a file, and open it."""
        path = questions.ask_which(self._window)
        if path is not None:
            self.open(path)

    def open(self, path: Path) -> None:
        """Open a project in place of the one that is there, or import a file of something else."""
        session, formats = self._session, self._work.formats
        self.remarked.emit(f"Opening “{path.name}”…")
        if path.suffix.lower() == SUFFIX:
            self._read(lambda: _opening(session, path, formats))
        else:
            self._read(lambda: _workflow_of(path, formats))

    def restore(self, found: LeftBehind) -> None:
        """Open work that a window left behind, still unsaved."""
        session, formats = self._session, self._work.formats
        self._read(lambda: _with_pictures(restoring(session, found, formats), formats))
        self.restoring.emit(True)

    def save(self, then: Callable[[], object] | None = None) -> None:
        """Save into the file, or ask for one; ``then`` is called once that is done."""
        if self._path is None:
            self.save_as(then)
        else:
            self._write(self._path, then)

    def save_as(self, then: Callable[[], object] | None = None) -> None:
        """Ask for a file, and save into it."""
        try:
            path = questions.ask_where(self._window, self.name or f"Untitled{SUFFIX}")
        except IconstudioError as error:
            self.remarked.emit("")
            self.failed.emit(str(error))
            return
        if path is not None:
            self._write(path, then, anyway=True)  # the dialog has asked

    def may_go(self, again: Callable[[], object]) -> bool:
        """Whether nothing is lost if the work goes from sight, or the user does not mind.

        If it is to be saved first, ``again`` is called once that is done.
        """
        if self._work.opening and not questions.ask_about_opening(self._window):
            return False
        if not self._modified:
            return True
        answer = questions.ask_about_unsaved(self._window, self.name)
        if answer is Answer.SAVE:
            self.save(again)
        return answer is Answer.DISCARD

    def cancel(self) -> None:
        """Read on no further; what is there stays."""
        self._runner.cancel()

    def close(self) -> None:
        """The window closes; what is not saved was let go."""
        self.cancel()
        self.journaling.close()

    # -- how it is done ------------------------------------------------------------------------

    def _read(self, make: Callable[[], Generator[Any]]) -> None:
        self._runner.start(make)
        self._patience.begin()

    def _tell(self, progress: Progress) -> None:
        if self._patience.asked:
            self.progressed.emit(progress)

    def _rest(self) -> None:
        self.restoring.emit(False)
        self._patience.end()

    def _replace(self, opened: OpenedProject, pictures: tuple[Picture, ...] = ()) -> None:
        """Put another project in place, once it is certain that nothing is lost."""
        again = partial(self._replace, opened, pictures)
        if self.may_go(again):  # more may have been done while it was saved
            self._pictures = pictures
            self._load(opened)

    def _write(self, path: Path, then: Callable[[], object] | None, anyway: bool = False) -> None:
        """Save in the background; ``anyway``: also over what others have saved there meanwhile."""
        contents, formats, project = self._work.contents(), self._work.formats, self._project
        known = self._stamp if path == self._path and not anyway else None

        def saved(stamp: Stamp | None) -> None:
            recents.note(path)
            self.remarked.emit(f"Saved “{path}”.")
            if project != self._project:  # another one has taken its place
                return
            self._path, self._saved, self._stamp = path, contents, stamp
            self._compare()
            self.changed.emit()
            if then is not None:
                then()

        self.remarked.emit("")
        job = self._files.submit(lambda: once(lambda: save(path, contents.project(formats), known)))
        job.event.connect(saved)
        job.failed.connect(self.failed)

    def _receive(self, event: object) -> None:
        match event:
            case (OpenedProject() as opened, pictures):
                self._replace(opened, pictures)
            case WorkFile():
                self.imported.emit(event)

    def _load(self, opened: OpenedProject) -> None:
        contents, found = opened.contents, opened.left
        self._project += 1
        self._loading = True  # half of it is nothing to keep
        self._work.load(contents)
        self._loading = False
        # What could not be read must not vanish from the file when the rest is saved.
        whole = not contents.complaints
        self._path = opened.path if whole else None
        self._stamp = opened.stamp
        self._saved = self._work.contents() if whole and found is None else None
        if opened.path is not None and found is None:
            recents.note(opened.path)
        if opened.path is not None:
            self.remarked.emit(f"Opened “{opened.path.name}”.")
        for complaint in contents.complaints:
            self.failed.emit(complaint)
        self._compare()
        self.changed.emit()
        if found is not None and whole:
            self.journaling.restored(found)
            self.restored.emit(found)

    def _compare(self) -> None:
        if self._loading:
            return
        now = self._work.contents()
        saved, formats = self._saved, self._work.formats
        modified = saved is None or not now.alike(saved, formats)
        if modified:
            self.journaling.note()
        else:
            self.journaling.clear()
        if modified != self._modified:
            self._modified = modified
            self.changed.emit()

    def _taken(self) -> Callable[[], Project]:
        contents, formats = self._work.contents(), self._work.formats
        file = "" if self._path is None else str(self._path.absolute())
        return lambda: contents.project(formats, file=plain_text(file))


def _opening(session: Session, path: Path, formats: Formats) -> Generator[Any]:
    try:
        yield from _with_pictures(opening(session, path, formats), formats)
    except IconstudioError:
        if not path.exists():
            recents.discard(path)
        raise


def _with_pictures(events: Generator[Any], formats: Formats) -> Generator[Any]:
    """Pass events on, and an opened project with the pictures of all results in it.

    They are drawn where nobody waits for them.
    """
    with closing(events):
        for event in events:
            if not isinstance(event, OpenedProject):
                yield event
                continue
            results, pictures = tuple(event.contents.results(formats)), []
            for result in results:
                pictures.append(picture_of(result))
                yield Progress("draw", len(pictures) / len(results), "Drawing the results")
            yield event, tuple(pictures)


def _workflow_of(path: Path, formats: Formats) -> Generator[WorkFile]:
    """Yield a file with the workflow that it is of, as it says."""
    likely = None
    if path.suffix.lower() == ".json":
        likely = likely_workflow(json.load(path), formats.workflows.values())
    yield WorkFile(path, "" if likely is None else likely.name)
