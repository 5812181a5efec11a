"""The hybrids on the sheet, in sections, each drawn in batches."""

from bisect import bisect
from collections.abc import Sequence
from dataclasses import dataclass, field

from PySide6.QtCore import QObject, QPersistentModelIndex, QPoint

from iconstudio.gui.gallery.sheet import Sheet
from iconstudio.gui.gallery.sheet_model import Rule
from iconstudio.gui.pictures.picture import Picture
from iconstudio.gui.theme.theme import UNIT
from iconstudio.gui.workspaces.hybrids.hover_bar import HoverBar
from iconstudio.model import Mix

Entry = Picture | Rule


@dataclass(eq=False)
class Section:
    """The hybrids of one mix. ``entries[start:]`` are of the batch that is being drawn."""

    title: str
    mix: Mix
    entries: list[Entry] = field(default_factory=list)
    start: int = 0
    drawn: int = 0
    """How many draws are done."""
    exhausted: bool = False
    """Whether the last batch brought nothing new."""

    def __post_init__(self) -> None:
        if self.title:
            self.entries.append(Rule(self.title, heading=True))
            self.start = 1

    @property
    def batch(self) -> list[Picture]:
        """The hybrids of the batch that is being drawn, or was last."""
        return [one for one in self.entries[self.start :] if isinstance(one, Picture)]

    @property
    def pictures(self) -> list[Picture]:
        """All hybrids of the section, from the top down."""
        return [one for one in self.entries if isinstance(one, Picture)]

    @property
    def ordered(self) -> list[Entry]:
        """All entries, those of the batch in the order of their ranks."""
        return self.entries[: self.start] + sorted(self.entries[self.start :], key=rank)


class Sections(QObject):
    """Sections one below the other on a sheet, or one alone. Of a batch, the best come first.

    What the user looks at, or points at, stays where it is while hybrids arrive.
    """

    def __init__(self, sheet: Sheet, bar: HoverBar) -> None:
        super().__init__(sheet)
        self._sheet, self._model = sheet, sheet.model()
        self.all: list[Section] = []
        self.alone: Section | None = None
        """The section that is shown without the others, if one is."""
        self._unsettled: Section | None = None
        self._bar = bar
        bar.left.connect(self.settle)

    @property
    def pictures(self) -> list[Picture]:
        """All hybrids, from the top down, in sight or not."""
        return [picture for section in self.all for picture in section.pictures]

    @property
    def in_sight(self) -> list[Picture]:
        """The hybrids of the section that is shown alone, or else all of them."""
        return self.pictures if self.alone is None else self.alone.pictures

    def clear(self) -> None:
        """Forget all sections."""
        self.all, self.alone = [], None
        self._sheet.show_entries(())

    def restore(self, sections: Sequence[Section]) -> None:
        """Show sections that were there before, all of them."""
        self.all = list(sections)
        self.show_alone(None)

    def open(self, section: Section) -> None:
        """Put a new section on top, and show it alone if it has others below it."""
        self.all.insert(0, section)
        self.show_alone(section if len(self.all) > 1 else None)

    def show_alone(self, section: Section | None) -> None:
        """Show one section, or all."""
        self.alone = section
        shown = self.all if section is None else [section]
        self._sheet.show_entries([entry for one in shown for entry in one.entries])

    def begin(self, section: Section) -> None:
        """Begin a batch of a section."""
        section.start = len(section.entries)

    def add(self, section: Section, picture: Picture) -> None:
        """Put a hybrid into the section's present batch, before all that are worse.

        What the user looks at stays as it is until the batch is settled.
        """
        top, first = self._top(section), section.start
        anchor, held = self._anchor(), self._last_held()
        if top is not None and first <= held - top < len(section.entries):
            first = held - top + 1
        self._insert(section, bisect(section.entries, rank(picture), lo=first, key=rank), picture)
        self._unsettled = section
        if anchor is not None and anchor[0].row() != anchor[1]:  # else no layout is needed yet
            self._restore(anchor)

    def end(self, section: Section, rule: Rule) -> None:
        """End the present batch with a rule."""
        self._insert(section, len(section.entries), rule)
        self._unsettled = section
        if self._bar.row < 0:
            self.settle()

    def settle(self) -> None:
        """Put the batch that was drawn last in order, now that nobody points at it."""
        section, self._unsettled = self._unsettled, None
        if section not in self.all or section.entries == section.ordered:
            return
        anchor, top = self._anchor(), self._top(section)
        section.entries = section.ordered
        if top is not None:
            rows = self._model.entries
            after = top + len(section.entries)
            self._model.reorder([*rows[:top], *section.entries, *rows[after:]])
            self._restore(anchor)

    def _insert(self, section: Section, place: int, entry: Entry) -> None:
        top = self._top(section)
        section.entries.insert(place, entry)
        if top is not None:
            self._model.insert(top + place, entry)

    def _top(self, section: Section) -> int | None:
        """Return the row at which a section begins, if it is in sight."""
        if self.alone is not None:
            return 0 if section is self.alone else None
        return sum(len(one.entries) for one in self.all[: self.all.index(section)])

    # -- what the user looks at ----------------------------------------------------------------

    def _last_held(self) -> int:
        """Return the last row that must stay where it is; -1 if none."""
        current = self._sheet.currentIndex().row() if self._sheet.hasFocus() else -1
        return max(self._first_visible() - 1, self._bar.row, current)

    def _first_visible(self) -> int:
        """Return the first row of which something is in sight; 0 at the top of the sheet."""
        if self._sheet.verticalScrollBar().value() == 0:
            return 0
        return max(0, self._sheet.indexAt(QPoint(6 * UNIT, 3 * UNIT)).row())

    def _anchor(self) -> tuple[QPersistentModelIndex, int, int] | None:
        """Return an entry in sight, its row and its place; None at the top of the sheet."""
        row = self._first_visible()
        if row == 0:
            return None
        index = self._model.index(row)
        return QPersistentModelIndex(index), row, self._sheet.visualRect(index).top()

    def _restore(self, anchor: tuple[QPersistentModelIndex, int, int] | None) -> None:
        """Scroll so that the entry is at its place again."""
        self._sheet.executeDelayedItemsLayout()
        if anchor is not None and anchor[0].isValid():
            now = self._sheet.visualRect(self._model.index(anchor[0].row())).top()
            if moved := now - anchor[2]:
                bar = self._sheet.verticalScrollBar()
                bar.setValue(bar.value() + moved)


def rank(entry: Entry) -> tuple[bool, float, int]:
    """Return by what a batch is sorted: the best first, the rule at its end."""
    if isinstance(entry, Rule):
        return True, 0.0, 0
    return False, -entry.icon.score.total, entry.icon.draw
