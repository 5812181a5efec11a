"""Rows, columns, cards and the widgets in them, in the rhythm and the roles of the style sheet."""

from collections.abc import Callable
from typing import Any, TypeVar

from PySide6.QtCore import QEvent, QObject, QSize, Qt
from PySide6.QtWidgets import (
    QBoxLayout,
    QFrame,
    QHBoxLayout,
    QLabel,
    QLayout,
    QPushButton,
    QScrollArea,
    QSplitter,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from iconstudio.files import with_names
from iconstudio.gui.theme import icons
from iconstudio.gui.theme.theme import UNIT

W = TypeVar("W", bound=QWidget)
L = TypeVar("L", bound=QBoxLayout)

Part = QWidget | QLayout | tuple[QWidget | QLayout | None, int] | int | None
"""What stands in a row: a widget or a layout, perhaps with its stretch; a space in pixels; None is
a stretch."""


TIGHT = 2, 2, 2, 2
"""Margins around the segments of a switch."""


def row(
    *parts: Part,
    of: QWidget | None = None,
    spacing: int = UNIT,
    margins: tuple[int, int, int, int] = (0, 0, 0, 0),
) -> QHBoxLayout:
    """Return a row, which is the layout ``of`` a widget if one is given."""
    return _filled(QHBoxLayout(of), parts, spacing, margins)


def column(
    *parts: Part,
    of: QWidget | None = None,
    spacing: int = UNIT,
    margins: tuple[int, int, int, int] = (0, 0, 0, 0),
) -> QVBoxLayout:
    """Return a column, which is the layout ``of`` a widget if one is given."""
    return _filled(QVBoxLayout(of), parts, spacing, margins)


def card(*parts: Part, margins: tuple[int, int, int, int] | None = None) -> QFrame:
    """Return a framed column of a surface's own."""
    frame = with_role(QFrame(), "card")
    column(*parts, of=frame, margins=margins or (UNIT * 3 // 2, UNIT, UNIT, UNIT))
    return frame


def segments(frame: QFrame, *buttons: QToolButton) -> None:
    """Make a frame a switch, with a segment for each button."""
    with_role(frame, "segments")
    row(*(with_role(button, "segment") for button in buttons), of=frame, spacing=2, margins=TIGHT)


def splitter(orientation: Qt.Orientation, *parts: tuple[QWidget, int, int]) -> QSplitter:
    """Return widgets side by side, each with its size in pixels and its stretch."""
    both = QSplitter(orientation)
    both.setHandleWidth(UNIT)
    both.setChildrenCollapsible(False)
    for number, (widget, _, stretch) in enumerate(parts):
        both.addWidget(widget)
        both.setStretchFactor(number, stretch)
    both.setSizes([size for _, size, _ in parts])
    return both


def scrolled(widget: QWidget, **properties: Any) -> QScrollArea:
    """Return a transparent area in which a widget can be scrolled up and down."""
    area = QScrollArea(widgetResizable=True, **properties)
    area.setWidget(widget)
    area.viewport().setAutoFillBackground(False)
    widget.setAutoFillBackground(False)
    area.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
    return area


def label(text: str = "", role: str = "muted", **properties: Any) -> QLabel:
    """Return words in a role of the style sheet: ``title``, ``heading`` or ``muted``."""
    return with_role(QLabel(text, **properties), role)


def push_button(
    text: str, tip: str = "", do: Callable[..., Any] | None = None, role: str = ""
) -> QPushButton:
    """Return a button with words; its role may be ``primary`` or ``pill``."""
    button = QPushButton(text, toolTip=tip, autoDefault=role == "primary")
    if role:
        with_role(button, role)
    if do is not None:
        button.clicked.connect(do)
    return button


def tool_button(
    icon: str, tip: str, do: Callable[..., Any] | None = None, side: int = 16, token: str = ""
) -> QToolButton:
    """Return a button with a small icon ``side`` pixels wide, named by its tool tip."""
    button = QToolButton(toolTip=tip)
    button.setAccessibleName(tip)
    button.setIcon(icons.icon(icon, token))
    button.setIconSize(QSize(side, side))
    if do is not None:
        button.clicked.connect(do)
    return button


def show_sentence(label: QLabel, sentence: str) -> bool:
    """Show a sentence with the names of files, their whole paths in the tool tip.

    Returns
    -------
    Whether that is another one.
    """
    before, short = label.text(), with_names(sentence)
    label.setText(short)
    label.setToolTip(sentence if short != sentence else "")
    return short != before


def hidden(widget: W) -> W:
    """Return a widget hidden, and with its room kept: what is beside it does not move."""
    policy = widget.sizePolicy()
    policy.setRetainSizeWhenHidden(True)
    widget.setSizePolicy(policy)
    widget.hide()
    return widget


class OnGeometry(QObject):
    """Calls a function whenever a widget has another place or size."""

    def __init__(self, widget: QWidget, do: Callable[[], object]) -> None:
        super().__init__(widget)
        self._do = do
        widget.installEventFilter(self)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Look out for another place or size."""
        if event.type() in (QEvent.Type.Move, QEvent.Type.Resize):
            self._do()
        return False


def with_role(widget: W, role: str) -> W:
    """Return a widget that the style sheet paints in a role."""
    widget.setProperty(role, True)
    return widget


def turn_role(widget: QWidget, role: str, on: bool) -> None:
    """Let the style sheet paint a widget in a role, or no longer."""
    if bool(widget.property(role)) != on:
        widget.setProperty(role, on)
        widget.style().unpolish(widget)
        widget.style().polish(widget)


def _filled(
    layout: L, parts: tuple[Part, ...], spacing: int, margins: tuple[int, int, int, int]
) -> L:
    layout.setContentsMargins(*margins)
    layout.setSpacing(spacing)
    for part in parts:
        thing, stretch = part if isinstance(part, tuple) else (part, 0)
        if thing is None:
            layout.addStretch(stretch)
        elif isinstance(thing, int):
            layout.addSpacing(thing)
        elif isinstance(thing, QLayout):
            layout.addLayout(thing, stretch)
        else:
            layout.addWidget(thing, stretch)
    return layout
