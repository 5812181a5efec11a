"""The window's own small line icons, drawn on a grid of 24 units."""

import re
from functools import cache
from pathlib import Path

from PySide6.QtCore import QByteArray, QRect, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QIcon, QIconEngine, QPainter, QPaintEvent, QPixmap, QPixmapCache
from PySide6.QtSvg import QSvgRenderer
from PySide6.QtWidgets import QWidget

from iconstudio.gui.theme import theme


@cache
def _shapes() -> dict[str, str]:
    """Return the markup of each icon, by its name."""
    sheet = Path(__file__).with_name("icons.svg").read_text("utf-8")
    return dict(re.findall(r'<g id="([\w-]+)">(.*?)</g>', sheet, re.DOTALL))


def pixmap(name: str, color: QColor, size: int = 20, ratio: float = 2.0) -> QPixmap:
    """Return the icon ``name`` in ``color``; ``size`` in device-independent pixels.

    Each is drawn once: the same icons stand in every workspace.
    """
    key = f"{name} {color.name(QColor.NameFormat.HexArgb)} {size} {ratio}"
    picture = QPixmapCache.find(key)
    if picture is None:
        # Where a layout has no room yet, icons of no size are asked for.
        picture = _drawn(name, color, size, ratio) if size * ratio >= 1 else QPixmap()
        QPixmapCache.insert(key, picture)
    return picture


def _drawn(name: str, color: QColor, size: int, ratio: float) -> QPixmap:
    ink = color.name()
    shapes = _shapes()[name].replace('fill="ink"', f'fill="{ink}"')
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

    def __init__(self, name: str, token: str = "muted", side: int = 18) -> None:
        super().__init__()
        self._icon = icon(name, token)
        self.setFixedSize(side, side)

    def paintEvent(self, event: QPaintEvent) -> None:
        """Draw the icon."""
        with QPainter(self) as painter:
            self._icon.paint(painter, self.rect())
