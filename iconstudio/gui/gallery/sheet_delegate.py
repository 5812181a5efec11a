"""How the entries of a sheet are drawn."""

from dataclasses import dataclass
from enum import Enum, auto

from PySide6.QtCore import QPoint, QPointF, QRect, QRectF, QSize, Qt
from PySide6.QtGui import QImage, QPainter, QPen
from PySide6.QtWidgets import QStyle, QStyledItemDelegate, QStyleOptionViewItem, QWidget

from iconstudio.gui.gallery.display import setting
from iconstudio.gui.gallery.sheet_model import Index, Rule
from iconstudio.gui.pictures.mipmap import fitted
from iconstudio.gui.pictures.picture import Display, stencil
from iconstudio.gui.theme import icons, theme
from iconstudio.gui.theme.painting import RADIUS, paint_frame
from iconstudio.gui.theme.theme import UNIT
from iconstudio.model import Exemplar

_RULE, _HEADING = 3 * UNIT, 4 * UNIT


class Mark(Enum):
    """How an icon that is marked is drawn."""

    STRUCK = auto()
    """Pale, and struck through."""
    TICK = auto()
    STAR = auto()


@dataclass(frozen=True, slots=True)
class Look:
    """How icons are drawn: ``side`` and ``margin`` in device-independent pixels."""

    side: int
    margin: float = 4
    mark: Mark = Mark.TICK
    framed: bool = False
    """Whether each has a frame, not only those that are pointed at or picked."""
    picks: bool = False
    """Whether the one that is picked is shown."""
    fills: bool = False
    """Whether as many as fit in a row share its width, and rules go across."""
    coded: bool = False
    """Whether they are shown by their colour code, too, as the user wants it."""
    tidies: bool = False
    """Whether they are shown tidied or not, as the user wants it."""


def framed(side: int, coded: bool = False) -> Look:
    """Return how results look that are each on a small sheet of their own."""
    return Look(side, margin=3.5, framed=True, coded=coded)


class SheetDelegate(QStyledItemDelegate):
    """Draws icons and rules."""

    def __init__(self, parent: QWidget, look: Look) -> None:
        super().__init__(parent)
        self.look = look
        self._images: dict[tuple[str, str, int], QImage] = {}
        self.set_width(8 * look.side)

    def set_width(self, width: int) -> None:
        """Let as many icons as fit fill a row of ``width``, if they are to fill it."""
        side = self.look.side
        across = width // max(1, width // side) if self.look.fills else side
        self._cell = QSize(across, side)
        self._rule, self._heading = QSize(width, _RULE), QSize(width, _HEADING)

    def sizeHint(self, option: QStyleOptionViewItem, index: Index) -> QSize:
        """Return the size of an icon's cell, or of a rule across the sheet."""
        entry = index.model().entry(index)
        if isinstance(entry, Rule):
            return self._heading if entry.heading else self._rule
        return self._cell

    def paint(self, painter: QPainter, option: QStyleOptionViewItem, index: Index) -> None:
        """Draw one entry."""
        model, scheme = index.model(), theme.current()
        entry = model.entry(index)
        painter.save()
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        if isinstance(entry, Rule):
            last = index.row() == model.rowCount() - 1
            text = entry.text + (entry.more if last else "")
            _paint_rule(painter, QRectF(option.rect), text, entry.heading, scheme)
        else:
            mark = self.look.mark if model.is_marked(entry) else None
            gap = 1.5 if self.look.framed else 2.0
            box = QRectF(option.rect).adjusted(gap, gap, -gap, -gap)
            self._paint_frame(painter, box, option.state, mark is Mark.TICK, scheme)
            inner = QRectF(0, 0, *2 * (self.look.side - 2 * self.look.margin,))
            inner.moveCenter(box.center())
            painter.setOpacity(0.25 if mark is Mark.STRUCK else 1.0)
            if isinstance(entry, Exemplar):
                pixels = round(inner.width() * painter.device().devicePixelRatioF())
                painter.drawImage(inner, self._image(entry, scheme, pixels))
            else:
                display = setting.value if self.look.coded else Display.PLAIN
                entry.paint(painter, inner, scheme.color("text"), display)
            painter.setOpacity(1.0)
            _paint_mark(painter, mark, box, inner, scheme)
        painter.restore()

    def _paint_frame(
        self,
        painter: QPainter,
        box: QRectF,
        state: QStyle.StateFlag,
        ticked: bool,
        scheme: theme.Theme,
    ) -> None:
        hovered = bool(state & QStyle.StateFlag.State_MouseOver)
        focused = bool(state & QStyle.StateFlag.State_HasFocus)
        picked = self.look.picks and bool(state & QStyle.StateFlag.State_Selected)
        if self.look.framed:
            colour = scheme.color("accent" if focused else "border")
            painter.setPen(QPen(colour, 1.5 if focused else 1))
            painter.setBrush(scheme.color("accent_soft" if hovered else "surface"))
            painter.drawRoundedRect(box, RADIUS, RADIUS)
        else:
            paint_frame(painter, box, picked or ticked, focused, hovered)

    def _image(self, icon: Exemplar, scheme: theme.Theme, side: int) -> QImage:
        key = (icon.id, scheme.text, side)
        if key not in self._images:
            self._images[key] = fitted(stencil(icon.coverage, scheme.color("text")), side)
        return self._images[key]


def _paint_mark(
    painter: QPainter, mark: Mark | None, box: QRectF, inner: QRectF, scheme: theme.Theme
) -> None:
    match mark:
        case Mark.STRUCK:
            painter.setPen(QPen(scheme.color("danger"), 1.8))
            painter.drawLine(inner.bottomLeft(), inner.topRight())
        case Mark.TICK:
            _paint_tick(painter, box.topRight() + QPointF(-UNIT, UNIT), scheme)
        case Mark.STAR:
            place = QRect(box.topRight().toPoint() - QPoint(19, -3), QSize(16, 16))
            icons.icon("star-full", "accent").paint(painter, place)


def _paint_tick(painter: QPainter, centre: QPointF, scheme: theme.Theme) -> None:
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(scheme.color("accent"))
    painter.drawEllipse(centre, 7, 7)
    pen = QPen(scheme.color("on_accent"), 1.6)
    pen.setCapStyle(Qt.PenCapStyle.RoundCap)
    pen.setJoinStyle(Qt.PenJoinStyle.RoundJoin)
    painter.setPen(pen)
    tick = (QPointF(-3, 0), QPointF(-1, 2.4), QPointF(3.2, -2.4))
    painter.drawPolyline([centre + point for point in tick])


def _paint_rule(
    painter: QPainter, box: QRectF, text: str, heading: bool, scheme: theme.Theme
) -> None:
    font = theme.strong(painter.font()) if heading else painter.font()
    font.setPixelSize(13 if heading else 11)
    painter.setFont(font)
    painter.setPen(scheme.color("text" if heading else "muted"))
    where = box.adjusted(UNIT / 2, 0, 0, 0)
    painter.drawText(where, Qt.AlignmentFlag.AlignVCenter | Qt.AlignmentFlag.AlignLeft, text)
    words = painter.fontMetrics().horizontalAdvance(text)
    painter.setPen(QPen(scheme.color("border"), 1))
    y = box.center().y()
    painter.drawLine(int(where.left() + words + UNIT), int(y), int(box.right() - UNIT), int(y))
