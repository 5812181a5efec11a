"""Keeps unsaved work in the journal, edit by edit, and finds what other windows left there."""

import time
from collections.abc import Callable

from PySide6.QtCore import QObject, QTimer, Signal

from iconstudio.gui.jobs.worker import Worker, once
from iconstudio.project.archive import Project
from iconstudio.project.journal import Journal, LeftBehind, journals_folder, left_behind

GAP = 0.02
"""Seconds from one writing to the next at least: a drag is many changes."""


class Journaling(QObject):
    """Writes in a thread of its own, at once, so that no edit waits for anything else.

    Parameters
    ----------
    take
        Returns what returns the project as it is now; that is called in the thread.

    Signals
    -------
    found(LeftBehind)
        A window that is no more left work behind.
    failed(str)
        Work cannot be kept; a sentence for the user. Once, until it can be again.
    """

    found = Signal(object)
    failed = Signal(str)

    def __init__(self, take: Callable[[], Callable[[], Project]], parent: QObject) -> None:
        super().__init__(parent)
        self._take = take
        self._journal = Journal(journals_folder())
        self._worker = Worker(self)
        self._writing = self._again = self._kept = self._told = False
        self._began = 0.0
        self._timer = QTimer(self, singleShot=True)
        self._timer.timeout.connect(self._write)
        self._held: list[LeftBehind] = []
        """What was left behind, and nothing has become of it yet."""
        self._restored: list[LeftBehind] = []
        """What goes once the window's own journal has it."""
        self._gone: list[LeftBehind] = []
        """What is to go."""

    def look(self) -> None:
        """Look for what was left behind."""
        self._worker.submit(lambda: left_behind(journals_folder())).event.connect(self._find)

    def note(self) -> None:
        """Keep what is there now in place of what was kept."""
        if self._writing:
            self._again = True
        elif not self._timer.isActive():
            rest = self._began + GAP - time.monotonic()
            if rest > 0:
                self._timer.start(round(rest * 1000))
            else:
                self._write()

    def clear(self) -> None:
        """Keep nothing: all is saved, or as it was before."""
        self._timer.stop()
        self._again = False
        restored, self._restored = self._restored, []
        for left in restored:
            self._remove(left)
        if self._kept:
            self._kept = False
            journal = self._journal
            self._worker.submit(lambda: once(journal.clear))

    def restored(self, left: LeftBehind) -> None:
        """Remove what was left behind once the window's own journal has it."""
        self._held.remove(left)
        self._restored.append(left)
        self.note()

    def dismiss(self, left: LeftBehind) -> None:
        """Remove what was left behind."""
        self._held.remove(left)
        self._remove(left)

    def close(self) -> None:
        """The window closes, and nothing in it is to be kept."""
        self._timer.stop()
        self._again = False
        self._worker.close()
        self._journal.clear()
        for left in (*self._gone, *self._restored):  # its removal may not have had its turn
            left.discard()
        for left in self._held:
            left.release()
        self._held.clear()

    def _remove(self, left: LeftBehind) -> None:
        self._gone.append(left)
        self._worker.submit(lambda: once(left.discard))

    def _find(self, left: LeftBehind) -> None:
        self._held.append(left)
        self.found.emit(left)

    def _write(self) -> None:
        self._writing = self._kept = True
        self._again = False
        self._began = time.monotonic()
        make, journal = self._take(), self._journal
        restored, self._restored = self._restored, []
        self._gone += restored

        def write() -> None:
            journal.write(make())
            for left in restored:
                left.discard()

        job = self._worker.submit(lambda: once(write))
        job.event.connect(self._succeed)
        job.failed.connect(self._fail)
        job.finished.connect(self._end)

    def _succeed(self) -> None:
        self._told = False

    def _fail(self, message: str) -> None:
        if not self._told:
            self._told = True
            self.failed.emit(message)

    def _end(self) -> None:
        self._writing = False
        if self._again:
            self.note()
