"""Draws hybrids batch by batch onto a sheet."""

from dataclasses import dataclass, replace

from PySide6.QtCore import QObject, Signal

from iconstudio.caches.kept import Kept
from iconstudio.grammar import counted
from iconstudio.gui.gallery.sheet_model import Rule
from iconstudio.gui.jobs.runner import Runner
from iconstudio.gui.jobs.worker import Worker
from iconstudio.gui.pictures.picture import Picture, pictured
from iconstudio.gui.workspaces.hybrids.panels import SheetPanel
from iconstudio.gui.workspaces.hybrids.sections import Section
from iconstudio.model import CANVAS, IconstudioError, Mix
from iconstudio.session import Session
from iconstudio.workflows.events import Event
from iconstudio.workflows.hybrids.batches import Seen, new_hybrids
from iconstudio.workflows.hybrids.spec import HYBRIDS

CODED = CANVAS
"""Side of a hybrid's colour-coded picture."""


@dataclass(frozen=True, slots=True)
class _Left:
    """A sheet that another one has taken the place of."""

    sections: tuple[Section, ...]
    seen: Seen

    def __len__(self) -> int:
        return sum(len(one.pictures) for one in self.sections)


class Draws(QObject):
    """Fills a sheet: a main section, and above it one for each hybrid that others should be like.

    Sheets of earlier mixes are kept for a while, so that undo brings them back.

    Signals
    -------
    counted(int)
        How many hybrids there are.
    section_changed()
        Another section is shown alone, or all are.
    """

    counted = Signal(int)
    section_changed = Signal()

    def __init__(
        self, session: Session, worker: Worker, panel: SheetPanel, parent: QObject
    ) -> None:
        super().__init__(parent)
        self._session = session
        self._panel, self._sheet, self._sections = panel, panel.sheet, panel.sections
        self.ran: Mix | None = None
        """What the hybrids on the sheet are of."""
        self._name = ""
        self._seen = Seen()
        self._kept: Kept[_Left] = Kept()
        self._section: Section | None = None
        """The section whose batch is drawn now, or was last."""
        self._scrolled = 0
        """Where the user was on the whole sheet."""
        self.runner = Runner(worker, self)
        self.runner.ended.connect(self._end)
        panel.sheet.neared_end.connect(self.draw_on)
        panel.button.clicked.connect(self.show_all)

    def start(self, mix: Mix, name: str) -> None:
        """Draw on a new sheet, or more on the one that is there if it is of the same mix.

        The hybrids are called ``name`` and a number.
        """
        if mix == self.ran:
            self.show_all()
            if not self.runner.running:
                self._draw(self._main)
            self._sheet.scrollToBottom()
            return
        self._leave()
        self._seen, self.ran, self._name = Seen(), mix, name
        section = Section("", mix)
        self._sections.open(section)
        self._show_section()
        self._draw(section)

    def recall(self, mix: Mix, name: str) -> bool:
        """Show the hybrids of a mix in place of those that are there, if they are kept.

        Returns
        -------
        Whether they are.
        """
        left = None if mix == self.ran else self._kept.find((mix, name))
        if left is None:
            return False
        self._leave()
        self._seen, self.ran, self._name, self._section = left.seen, mix, name, None
        self._sections.restore(left.sections)
        self._show_section()
        return True

    def _leave(self) -> None:
        """Take all hybrids from the sheet, and keep them for a while."""
        self.runner.cancel()
        self._sections.settle()
        if self._sections.pictures:
            left = _Left(tuple(self._sections.all), self._seen)
            self._kept.put((self.ran, self._name), left)
        self._sections.clear()

    def clear(self) -> None:
        """Let go of all hybrids."""
        self._leave()
        self._seen, self.ran, self._section = Seen(), None, None
        self._show_section()

    def draw_like(self, picture: Picture) -> None:
        """Draw hybrids that resemble one, in a section of their own.

        Raises
        ------
        IconstudioError
            If it is none of those on the sheet.
        """
        drawn = picture.tidied or picture
        if not any(one is drawn for one in self._sections.pictures):
            raise IconstudioError(
                "This hybrid is of an earlier sheet. Mix its icons again to draw more like it."
            )
        if self._sections.alone is None:
            self._scrolled = self._sheet.verticalScrollBar().value()
        title = f"More like {picture.title}"
        section = next((one for one in self._sections.all if one.title == title), None)
        if section is not None:
            self._sections.show_alone(section)
        else:
            self.runner.cancel()
            section = Section(title, replace(self._main.mix, like=picture.icon.seeds))
            self._sections.open(section)
            self._draw(section)
        self._show_section()

    def draw_on(self) -> None:
        """Draw the next batch of what the user has scrolled to the end of."""
        section = self._sections.alone or self._main
        if section is not None and not self.runner.running and not section.exhausted:
            self._draw(section)

    def show_all(self) -> None:
        """Show the whole sheet again, where the user left it."""
        if self._sections.alone is None:
            return
        self._sections.show_alone(None)
        self._show_section()
        self._sheet.executeDelayedItemsLayout()
        self._sheet.verticalScrollBar().setValue(self._scrolled)

    @property
    def _main(self) -> Section | None:
        """The section of all draws that resemble nothing."""
        return self._sections.all[-1] if self._sections.all else None

    def _draw(self, section: Section) -> None:
        self._section = section
        self._sections.begin(section)
        mix, name, seen = replace(section.mix, first=section.drawn), self._name, self._seen
        session = self._session
        self.runner.start(
            lambda: pictured(new_hybrids(session.run(HYBRIDS, mix), name, seen), side=CODED)
        )

    def show(self, event: Event | Picture) -> None:
        """Put a hybrid that was drawn on the sheet."""
        if isinstance(event, Picture) and self._section is not None:
            self._sections.add(self._section, event)
            self.counted.emit(len(self._sections.in_sight))

    def _end(self, whole: bool) -> None:
        section = self._section
        if section is None:  # the sheet was cleared
            return
        new = section.batch
        if whole:
            section.drawn += section.mix.draws
            section.exhausted = not new
        else:
            section.drawn = max([section.drawn, *(one.icon.draw + 1 for one in new)])
            # What was drawn but not shown any more may come again.
            self._seen = Seen([one.icon for one in self._sections.pictures])
        if whole or new:
            more = " · nothing new any more" if section.exhausted else " · scroll on for more"
            self._sections.end(section, Rule(counted(section.drawn, "draw"), more=more))

    def _show_section(self) -> None:
        self._panel.button.setVisible(self._sections.alone is not None)
        self.section_changed.emit()
