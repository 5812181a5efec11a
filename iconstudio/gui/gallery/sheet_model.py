"""What a sheet of icons shows, entry by entry: results, or icons of the collection, and rules."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from PySide6.QtCore import (
    QAbstractListModel,
    QMimeData,
    QModelIndex,
    QObject,
    QPersistentModelIndex,
    Qt,
)

from iconstudio.gui.exchange.dragging import packed
from iconstudio.gui.pictures.picture import Picture
from iconstudio.model import Exemplar, Pictogram

Index = QModelIndex | QPersistentModelIndex


@dataclass(frozen=True, slots=True, eq=False)
class Rule:
    """A line across the sheet with a few words; ``heading`` if it begins a section.

    ``more`` is added as long as nothing follows.
    """

    text: str
    heading: bool = False
    more: str = ""


Entry = Picture | Exemplar | Rule

Describe = Callable[[Entry, bool], tuple[str, str]]
"""Returns what to call an icon, which may be marked, and its tool tip."""


def results_with(advice: str) -> Describe:
    """Return what describes results by their names, and what can be done with them."""
    return lambda picture, marked: (picture.name, f"{picture.name}\n{advice}")


def credited(icon: Exemplar) -> str:
    """Return an icon's name, and whom to thank for it, in two lines."""
    credit = icon.pictogram.credit
    return f"{icon.name}\n{credit.author} · {credit.license}"


def pictogram_of(entry: Picture | Exemplar) -> Pictogram:
    """Return the icon of an entry, as it is dragged away."""
    return entry.pictogram if isinstance(entry, Exemplar) else entry.pictogram()


class SheetModel(QAbstractListModel):
    """The entries of a sheet; some icons may be marked, in whatever sense."""

    def __init__(self, parent: QObject, describe: Describe, draggable: bool) -> None:
        super().__init__(parent)
        self.entries: list[Entry] = []
        self.is_marked: Callable[[Entry], bool] = lambda entry: False
        self.shown: Callable[[Entry], Entry] = lambda entry: entry
        """Returns an entry as it is to be seen."""
        self._describe = describe
        self._draggable = draggable

    def rowCount(self, parent: Index = QModelIndex()) -> int:  # noqa: B008 - Qt's default
        """Return how many entries there are."""
        return 0 if parent.isValid() else len(self.entries)

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> str | None:
        """Describe an entry to tool tips and screen readers."""
        entry = self.entry(index)
        if entry is None:
            return None
        ruled = isinstance(entry, Rule)
        name, tip = (entry.text, None) if ruled else self._describe(entry, self.is_marked(entry))
        if role == Qt.ItemDataRole.ToolTipRole:
            return tip
        named = Qt.ItemDataRole.DisplayRole, Qt.ItemDataRole.AccessibleTextRole
        return name if role in named else None

    def flags(self, index: Index) -> Qt.ItemFlag:
        """Let icons be picked and perhaps dragged, but no rules."""
        if isinstance(self.entry(index), Rule):
            return Qt.ItemFlag.NoItemFlags
        drag = Qt.ItemFlag.ItemIsDragEnabled if self._draggable else Qt.ItemFlag.NoItemFlags
        return super().flags(index) | drag

    def mimeData(self, indexes: Sequence[QModelIndex]) -> QMimeData:
        """Return what a drag of an icon carries."""
        return packed(pictogram_of(self.entry(indexes[0])))

    def entry(self, index: Index) -> Entry | None:
        """Return what is seen at ``index``."""
        inside = index.isValid() and index.row() < len(self.entries)
        return self.shown(self.entries[index.row()]) if inside else None

    def index_of(self, entry: Entry) -> QModelIndex:
        """Return where an entry is, if it is there."""
        entries = enumerate(self.entries)
        row = next((row for row, one in entries if one is entry or self.shown(one) is entry), -1)
        return self.index(row) if row >= 0 else QModelIndex()

    def show(self, entries: Sequence[Entry]) -> None:
        """Show other entries."""
        self.beginResetModel()
        self.entries = list(entries)
        self.endResetModel()

    def insert(self, row: int, entry: Entry) -> None:
        """Put one more entry before those at ``row`` and below."""
        self.beginInsertRows(QModelIndex(), row, row)
        self.entries.insert(row, entry)
        self.endInsertRows()

    def put(self, entry: Entry, other: Entry) -> None:
        """Show an entry in the place of another one."""
        index = self.index_of(entry)
        if index.isValid():
            self.entries[index.row()] = other
            self.dataChanged.emit(index, index)

    def reorder(self, entries: Sequence[Entry]) -> None:
        """Show the same entries in another order; what is pointed at and picked stays so."""
        self.layoutAboutToBeChanged.emit()
        before = self.persistentIndexList()
        held = [self.entries[index.row()] for index in before]
        self.entries = list(entries)
        rows = {id(entry): row for row, entry in enumerate(self.entries)}
        self.changePersistentIndexList(before, [self.index(rows[id(one)]) for one in held])
        self.layoutChanged.emit()

    def mark(self, is_marked: Callable[[Entry], bool]) -> None:
        """Say which icons are marked."""
        self.is_marked = is_marked
        self.renew()

    def renew(self) -> None:
        """Have all entries drawn anew."""
        if self.entries:
            self.dataChanged.emit(self.index(0), self.index(len(self.entries) - 1))
