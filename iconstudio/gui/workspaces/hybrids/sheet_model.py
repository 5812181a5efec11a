"""The hybrids on the sheet, in sections, each drawn in batches."""

from bisect import bisect
from dataclasses import dataclass, field

from PySide6.QtCore import QAbstractListModel, QModelIndex, QObject, QPersistentModelIndex, Qt

from iconstudio.gui.gallery.pictures import Picture
from iconstudio.model import Mix

Index = QModelIndex | QPersistentModelIndex


@dataclass(frozen=True, slots=True, eq=False)
class Rule:
    """A line across the sheet with a few words; ``heading`` if it begins a section.

    ``more`` is added as long as nothing follows.
    """

    text: str
    heading: bool = False
    more: str = ""


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


class SheetModel(QAbstractListModel):
    """Sections one below the other, or one alone. Of a batch, the best come first."""

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self.sections: list[Section] = []
        self.alone: Section | None = None
        """The section that is shown without the others, if one is."""
        self._rows: list[Entry] = []

    def rowCount(self, parent: Index = QModelIndex()) -> int:  # noqa: B008 - Qt's default
        """Return how many entries are in sight."""
        return 0 if parent.isValid() else len(self._rows)

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> str | None:
        """Describe an entry to tool tips and screen readers."""
        entry = self.entry(index)
        picture = entry if isinstance(entry, Picture) else None
        if role == Qt.ItemDataRole.ToolTipRole and picture is not None:
            return f"{picture.title.capitalize()}\n{terms(picture)}"
        if role in (Qt.ItemDataRole.DisplayRole, Qt.ItemDataRole.AccessibleTextRole):
            return picture.title if picture is not None else getattr(entry, "text", None)
        return None

    def flags(self, index: Index) -> Qt.ItemFlag:
        """Let hybrids be picked, but no rules."""
        picture = isinstance(self.entry(index), Picture)
        return super().flags(index) if picture else Qt.ItemFlag.NoItemFlags

    def entry(self, index: Index) -> Entry | None:
        """Return what is at ``index``."""
        inside = index.isValid() and index.row() < len(self._rows)
        return self._rows[index.row()] if inside else None

    def index_of(self, picture: Picture) -> QModelIndex:
        """Return where a hybrid is, if it is in sight."""
        row = next((row for row, one in enumerate(self._rows) if one is picture), -1)
        return self.index(row) if row >= 0 else QModelIndex()

    @property
    def pictures(self) -> list[Picture]:
        """All hybrids, from the top down, in sight or not."""
        return [picture for section in self.sections for picture in section.pictures]

    @property
    def in_sight(self) -> list[Picture]:
        """The hybrids of the section that is shown alone, or else all of them."""
        return self.pictures if self.alone is None else self.alone.pictures

    def clear(self) -> None:
        """Forget all sections."""
        self.beginResetModel()
        self.sections, self.alone, self._rows = [], None, []
        self.endResetModel()

    def open(self, section: Section) -> None:
        """Put a new section on top, and show it alone if it has others below it."""
        self.sections.insert(0, section)
        self.show_alone(section if len(self.sections) > 1 else None)

    def show_alone(self, section: Section | None) -> None:
        """Show one section, or all."""
        self.beginResetModel()
        self.alone = section
        shown = self.sections if section is None else [section]
        self._rows = [entry for one in shown for entry in one.entries]
        self.endResetModel()

    def begin(self, section: Section) -> None:
        """Begin a batch of a section."""
        section.start = len(section.entries)

    def add(self, section: Section, picture: Picture, held: int = -1) -> None:
        """Put a hybrid into the section's present batch, before all that are worse.

        Rows up to ``held``, if that is in the batch, stay as they are until ``settle``.
        """
        top = self._top(section)
        first = section.start
        if top is not None and first <= held - top < len(section.entries):
            first = held - top + 1
        place = bisect(section.entries, rank(picture), lo=first, key=rank)
        self._insert(section, place, picture)

    def settled(self, section: Section) -> bool:
        """Whether the section's present batch is in the order of ranks."""
        ranks = list(map(rank, section.entries[section.start :]))
        return ranks == sorted(ranks)

    def settle(self, section: Section) -> None:
        """Put the section's present batch in the order of ranks."""
        entries = section.entries[: section.start]
        entries += sorted(section.entries[section.start :], key=rank)
        top = self._top(section)
        if top is None:
            section.entries = entries
            return
        self.layoutAboutToBeChanged.emit()
        before = self.persistentIndexList()
        held = [self._rows[index.row()] for index in before]
        section.entries = entries
        self._rows[top : top + len(entries)] = entries
        rows = {id(entry): row for row, entry in enumerate(self._rows)}
        self.changePersistentIndexList(before, [self.index(rows[id(one)]) for one in held])
        self.layoutChanged.emit()

    def end(self, section: Section, rule: Rule) -> None:
        """End the present batch with a rule."""
        self._insert(section, len(section.entries), rule)

    def _insert(self, section: Section, place: int, entry: Entry) -> None:
        top = self._top(section)
        if top is not None:
            self.beginInsertRows(QModelIndex(), top + place, top + place)
            self._rows.insert(top + place, entry)
        section.entries.insert(place, entry)
        if top is not None:
            self.endInsertRows()

    def _top(self, section: Section) -> int | None:
        """Return the row at which a section begins, if it is in sight."""
        if self.alone is not None:
            return 0 if section is self.alone else None
        above = self.sections[: self.sections.index(section)]
        return sum(len(one.entries) for one in above)


def rank(entry: Entry) -> tuple[bool, float, int]:
    """Return by what a batch is sorted: the best first, the rule at its end."""
    if isinstance(entry, Rule):
        return True, 0.0, 0
    return False, -entry.icon.score.total, entry.icon.draw


def terms(picture: Picture) -> str:
    """Say what the rank score of a hybrid is made of."""
    score = picture.icon.score
    parts = {
        "smooth seams": score.seam,
        "in one piece": score.whole,
        "symmetry": score.symmetry,
        "shared by several icons": score.sharing,
    }
    lines = [f"{name} {value:.0%}" for name, value in parts.items()]
    return f"Rank score {score.total:.2f}: " + ", ".join(lines)
