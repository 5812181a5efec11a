"""The window's own small line icons, drawn on a grid of 24 units."""

from PySide6.QtCore import QByteArray, QRect, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QIcon, QIconEngine, QPainter, QPaintEvent, QPixmap, QPixmapCache
from PySide6.QtSvg import QSvgRenderer
from PySide6.QtWidgets import QWidget

from iconstudio.gui.theme import theme

_SHEET = '<rect x="4" y="4" width="16" height="16" rx="3" stroke-opacity="0.45"/>'
_STAR = "M12 3.5l2.6 5.4 5.9.8-4.3 4.1 1 5.9-5.2-2.8-5.2 2.8 1-5.9-4.3-4.1 5.9-.8z"

_SHAPES = {
    "photo": '<rect x="3" y="4" width="18" height="16" rx="2"/><circle cx="8.5" cy="9.5" r="1.8"/>'
    '<path d="M4 18l5.5-5 3.5 3 3.5-4 4.5 5"/>',
    "examples": '<rect x="3" y="3" width="8" height="8" rx="1.5"/>'
    '<circle cx="17" cy="7" r="4"/><path d="M7 13l4 8H3z"/>'
    '<path d="M14 14h7v7h-7z"/>',
    "undo": '<path d="M8 5L4 9l4 4M4 9h10a5.5 5.5 0 0 1 0 11H9"/>',
    "redo": '<path d="M16 5l4 4-4 4M20 9H10a5.5 5.5 0 0 0 0 11h5"/>',
    "polygon": '<path d="M6 18L4.5 8 13 4l7 6-4 8z"/><circle cx="4.5" cy="8" r="2" fill="ink"/>'
    '<circle cx="13" cy="4" r="2" fill="ink"/><circle cx="20" cy="10" r="2" fill="ink"/>'
    '<circle cx="16" cy="18" r="2" fill="ink"/><circle cx="6" cy="18" r="2" fill="ink"/>',
    "pan": '<path d="M12 3v18M3 12h18M9 6l3-3 3 3M9 18l3 3 3-3M6 9l-3 3 3 3M18 9l3 3-3 3"/>',
    "fit": '<path d="M4 9V4h5M20 9V4h-5M4 15v5h5M20 15v5h-5"/><rect x="9" y="9" width="6" '
    'height="6" rx="1"/>',
    "clear": '<path d="M4 7h16M9 7V4h6v3M6 7l1 13h10l1-13M10 11v5M14 11v5"/>',
    "regions": '<circle cx="12" cy="12" r="8"/><circle cx="12" cy="12" r="3"/>'
    '<path d="M12 2v4M12 18v4M2 12h4M18 12h4"/>',
    "dim": '<circle cx="12" cy="12" r="8"/><path d="M12 4v16a8 8 0 0 0 0-16z" fill="ink"/>',
    "close": '<path d="M6 6l12 12M18 6L6 18"/>',
    "new": '<path d="M6 3h8l4 4v14H6zM14 3v4h4"/>',
    "open": '<path d="M3 19V6h6l2 2h8v3M3 19l3-8h16l-3 8z"/>',
    "axis-none": '<rect x="4" y="4" width="16" height="16" rx="3"/><path d="M9 15l6-6"/>',
    "axis-horizontal": f'{_SHEET}<path d="M12 2v20"/>',
    "axis-vertical": f'{_SHEET}<path d="M2 12h20"/>',
    "axis-diagonal": f'{_SHEET}<path d="M3 3l18 18"/>',
    "axis-antidiagonal": f'{_SHEET}<path d="M21 3L3 21"/>',
    "star": f'<path d="{_STAR}"/>',
    "star-full": f'<path d="{_STAR}" fill="ink"/>',
    "like": '<rect x="3" y="3" width="8" height="8" rx="2" fill="ink"/>'
    '<rect x="14" y="4" width="6" height="6" rx="1.5"/><rect x="4" y="14" width="6" height="6" '
    'rx="1.5"/><rect x="14" y="14" width="6" height="6" rx="1.5"/>',
    "dice": '<rect x="4" y="4" width="16" height="16" rx="3"/>'
    '<circle cx="8.5" cy="8.5" r="1.2" fill="ink"/><circle cx="15.5" cy="8.5" r="1.2" fill="ink"/>'
    '<circle cx="12" cy="12" r="1.2" fill="ink"/><circle cx="8.5" cy="15.5" r="1.2" fill="ink"/>'
    '<circle cx="15.5" cy="15.5" r="1.2" fill="ink"/>',
    "back": '<path d="M20 12H5M11 6l-6 6 6 6"/>',
    "search": '<circle cx="10.5" cy="10.5" r="6.5"/><path d="M15.5 15.5L21 21"/>',
    "remove": '<ellipse cx="12" cy="10" rx="8.5" ry="6.5" stroke-dasharray="3 2.2"/>'
    '<path d="M8.5 10h7"/><path d="M9 16.3c-2.6.7-3 4.2.6 4.2"/>',
    "add": '<ellipse cx="12" cy="10" rx="8.5" ry="6.5"/>'
    '<path d="M8.5 10h7M12 6.5v7"/><path d="M9 16.3c-2.6.7-3 4.2.6 4.2"/>',
    "select": '<path d="M6 3.5l12.5 9.2-5.6.9-3 5.4z"/>',
    "arrow": '<path d="M6 3.5l12.5 8.2-5.6 1.1L10 18.5z"/>',
    "brush": '<path d="M20 4c-5 1.5-9 5-10.5 8.5l2 2C15 13 18.5 9 20 4z"/>'
    '<path d="M9 13.5c-3 0-3 3-5 5.5 3.5 .5 7 0 7-3.5z"/>',
    "eraser": '<path d="M8.5 19L3.5 14 13.5 4l7 7-8 8zM8.5 9l7 7M8.5 19H20"/>',
    "mirror": '<path d="M12 3v18" stroke-dasharray="3 2.5"/><path d="M9 7L3 17h6zM15 7l6 10h-6z"/>',
    "eye": '<path d="M2.5 12C5 7.5 8.2 5.5 12 5.5s7 2 9.5 6.5c-2.5 4.5-5.7 6.5-9.5 '
    '6.5S5 16.5 2.5 12z"/><circle cx="12" cy="12" r="3"/>',
    "eye-closed": '<path d="M2.5 10C5 14 8.2 16 12 16s7-2 9.5-6M12 16v3.5M6.5 14.5l-2 '
    '3M17.5 14.5l2 3"/>',
    "live": '<circle cx="12" cy="12" r="2" fill="ink"/><path d="M8.5 15.5a5 5 0 0 1 0-7M15.5 '
    '8.5a5 5 0 0 1 0 7M5.6 18.4a9 9 0 0 1 0-12.8M18.4 5.6a9 9 0 0 1 0 12.8"/>',
    "hint": '<circle cx="12" cy="12" r="9"/><path d="M12 11v6M12 7.4v.2"/>',
    "warning": '<path d="M12 4L2.8 20h18.4zM12 10v5M12 17.4v.2"/>',
}


def pixmap(name: str, color: QColor, size: int = 20, ratio: float = 2.0) -> QPixmap:
    """Return the icon ``name`` in ``color``; ``size`` in device-independent pixels.

    Each is drawn once: the same icons stand in every workspace.
    """
    key = f"{name} {color.name(QColor.NameFormat.HexArgb)} {size} {ratio}"
    picture = QPixmapCache.find(key)
    if picture is None:
        picture = _drawn(name, color, size, ratio)
        QPixmapCache.insert(key, picture)
    return picture


def _drawn(name: str, color: QColor, size: int, ratio: float) -> QPixmap:
    ink = color.name()
    shapes = _SHAPES[name].replace('fill="ink"', f'fill="{ink}"')
    svg = (
        '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 24 24" fill="none" '
        f'stroke="{ink}" stroke-width="1.6" stroke-linecap="round" stroke-linejoin="round">'
        f"{shapes}</svg>"
    )
    side = round(size * ratio)
    picture = QPixmap(QSize(side, side))
    picture.fill(Qt.GlobalColor.transparent)
    with QPainter(picture) as painter:
        painter.setOpacity(color.alphaF())
        QSvgRenderer(QByteArray(svg.encode())).render(painter, QRectF(0, 0, side, side))
    picture.setDevicePixelRatio(ratio)
    return picture


_TOKENS = {"remove": "danger", "add": "added"}
"""Icons that have a colour of their own."""
_FAINT = 0.35
"""Opacity of what is disabled."""


class _ThemedEngine(QIconEngine):
    """Paints an icon in a colour of the theme that is in use at that moment."""

    def __init__(self, name: str, token: str) -> None:
        super().__init__()
        self._name, self._token = name, token

    def clone(self) -> QIconEngine:
        """Return the same once more."""
        return _ThemedEngine(self._name, self._token)

    def scaledPixmap(
        self, size: QSize, mode: QIcon.Mode, state: QIcon.State, scale: float
    ) -> QPixmap:
        """Return the icon of a size in device-independent pixels, of ``scale`` pixels each."""
        alpha = _FAINT if mode == QIcon.Mode.Disabled else 1.0
        color = theme.current().color(self._token, alpha)
        return pixmap(self._name, color, min(size.width(), size.height()), scale)

    def pixmap(self, size: QSize, mode: QIcon.Mode, state: QIcon.State) -> QPixmap:
        """Return the icon, a pixel of the device to each of the window."""
        return self.scaledPixmap(size, mode, state, 1.0)

    def paint(self, painter: QPainter, rect: QRect, mode: QIcon.Mode, state: QIcon.State) -> None:
        """Draw the icon."""
        ratio = painter.device().devicePixelRatioF()
        painter.drawPixmap(rect, self.scaledPixmap(rect.size(), mode, state, ratio))


def icon(name: str, token: str = "") -> QIcon:
    """Return the icon ``name`` in a colour of the theme; it follows the theme by itself."""
    return QIcon(_ThemedEngine(name, token or _TOKENS.get(name, "text")))


class Sign(QWidget):
    """An icon that only tells something: nothing happens when it is clicked."""

    def __init__(
        self, name: str, token: str = "muted", side: int = 18, parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self._icon = icon(name, token)
        self.setFixedSize(side, side)

    def paintEvent(self, event: QPaintEvent) -> None:
        """Draw the icon."""
        with QPainter(self) as painter:
            self._icon.paint(painter, self.rect())
