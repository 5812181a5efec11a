"""How the window looks: design tokens, palette and style sheet, light and dark."""

from dataclasses import dataclass

from PySide6.QtCore import Qt
from PySide6.QtGui import QColor, QFont, QFontDatabase, QGuiApplication, QPalette
from PySide6.QtWidgets import QApplication, QStyleFactory

from iconstudio.resources import resource

UNIT = 8
"""The rhythm of the layout in device-independent pixels: every distance is a multiple or a half."""


STRONG = "Inter Semi Bold"
"""Family of the headings: the bundled files name each weight as a family of its own."""


@dataclass(frozen=True, slots=True)
class Theme:
    """Colours by what they are for."""

    dark: bool
    window: str
    surface: str
    sunken: str
    border: str
    text: str
    muted: str
    accent: str
    on_accent: str
    accent_soft: str
    danger: str
    danger_soft: str
    added: str

    def color(self, token: str, alpha: float = 1.0) -> QColor:
        """Return the colour of a token, from transparent (0) to opaque (1)."""
        color = QColor(getattr(self, token))
        color.setAlphaF(alpha)
        return color


LIGHT = Theme(
    dark=False,
    window="#f4f4f1",
    surface="#ffffff",
    sunken="#ebebe7",
    border="#dcdcd6",
    text="#1c1c1a",
    muted="#66665f",
    accent="#3f51d9",
    on_accent="#ffffff",
    accent_soft="#e6e9fc",
    danger="#b3261e",
    danger_soft="#fbe9e7",
    added="#1b7a43",
)

DARK = Theme(
    dark=True,
    window="#19191b",
    surface="#232326",
    sunken="#121214",
    border="#39393e",
    text="#ededf0",
    muted="#a0a0a8",
    accent="#8d9bff",
    on_accent="#14151f",
    accent_soft="#2d3052",
    danger="#ffb4a9",
    danger_soft="#43231f",
    added="#74d79c",
)


def current() -> Theme:
    """Return the theme that follows the system's colour scheme."""
    dark = QGuiApplication.styleHints().colorScheme() == Qt.ColorScheme.Dark
    return DARK if dark else LIGHT


def prepare(application: QApplication) -> None:
    """Set what is the same in all themes: the style of the widgets, and the typeface."""
    application.setStyle(QStyleFactory.create("Fusion"))
    _load_fonts(application)


def apply(application: QApplication, theme: Theme) -> None:
    """Give the whole application the look of ``theme``."""
    # To replace a style sheet takes Qt four times as long as to remove it and set one.
    application.setStyleSheet("")
    application.setPalette(_palette(theme))
    application.setStyleSheet(_style_sheet(theme))


def _load_fonts(application: QApplication) -> None:
    """Use the bundled typeface; without it, the system's."""
    families: list[str] = []
    folder = resource("fonts")
    for file in sorted([*folder.glob("*.ttf"), *folder.glob("*.otf")]):
        number = QFontDatabase.addApplicationFont(str(file))
        families += QFontDatabase.applicationFontFamilies(number) if number >= 0 else []
    font = QFont(families[0]) if families else application.font()
    font.setPixelSize(13)
    font.setHintingPreference(QFont.HintingPreference.PreferNoHinting)
    application.setFont(font)


def strong(font: QFont) -> QFont:
    """Return ``font`` for headings."""
    font = QFont(font)
    if _has_strong():
        font.setFamily(STRONG)
    else:
        font.setWeight(QFont.Weight.DemiBold)
    return font


def _has_strong() -> bool:
    return STRONG in QFontDatabase.families()


def _palette(theme: Theme) -> QPalette:
    roles = {
        QPalette.ColorRole.Window: theme.window,
        QPalette.ColorRole.WindowText: theme.text,
        QPalette.ColorRole.Base: theme.surface,
        QPalette.ColorRole.AlternateBase: theme.sunken,
        QPalette.ColorRole.Text: theme.text,
        QPalette.ColorRole.PlaceholderText: theme.muted,
        QPalette.ColorRole.Button: theme.surface,
        QPalette.ColorRole.ButtonText: theme.text,
        QPalette.ColorRole.Highlight: theme.accent,
        QPalette.ColorRole.HighlightedText: theme.on_accent,
        QPalette.ColorRole.ToolTipBase: theme.text,
        QPalette.ColorRole.ToolTipText: theme.surface,
        QPalette.ColorRole.Link: theme.accent,
        QPalette.ColorRole.Mid: theme.border,
    }
    palette = QPalette()
    for role, color in roles.items():
        palette.setColor(role, QColor(color))
    for role in (QPalette.ColorRole.ButtonText, QPalette.ColorRole.Text):
        palette.setColor(QPalette.ColorGroup.Disabled, role, theme.color("muted", 0.5))
    return palette


def _style_sheet(theme: Theme) -> str:
    sheet = _SHEET.replace(
        "@strong;", f'font-family: "{STRONG}";' if _has_strong() else "font-weight: 600;"
    )
    for token in Theme.__slots__:
        sheet = sheet.replace(f"@{token};", f"{getattr(theme, token)};")
    return sheet


_SHEET = """
QToolTip { background: @text; color: @surface; border: 0; padding: 4px 8px; }
QMenuBar { background: @window; padding: 2px 8px; }
QMenuBar::item { padding: 4px 8px; border-radius: 4px; background: transparent; }
QMenuBar::item:selected { background: @sunken; }
QMenu { background: @surface; border: 1px solid @border; padding: 4px; }
QMenu::item { padding: 6px 24px 6px 12px; border-radius: 4px; }
QMenu::item:selected { background: @accent_soft; color: @text; }
QMenu::item:disabled { color: @muted; }
QMenu::separator { height: 1px; background: @border; margin: 4px 8px; }

QFrame[card="true"] { background: @surface; border: 1px solid @border; border-radius: 8px; }
QFrame[sheet="true"] { background: @surface; border: 0; border-radius: 8px; }
QFrame[layer="true"] { border-radius: 6px; }
QFrame[layer="true"]:hover { background: @sunken; }
QFrame[layer="true"][chosen="true"] { background: @accent_soft; }
QFrame[notice="true"] { background: @danger_soft; border: 1px solid @danger; border-radius: 8px; }
QFrame[notice="true"][hint="true"] { background: @accent_soft; border-color: @accent; }
QLabel[heading="true"] { @strong; }
QLabel[title="true"] { font-size: 16px; @strong; }
QLabel[muted="true"] { color: @muted; font-size: 12px; }
QLabel[error="true"] { color: @danger; font-size: 12px; }

QLineEdit { background: @surface; border: 1px solid @border; border-radius: 6px;
            padding: 0 8px; min-height: 30px; selection-background-color: @accent;
            selection-color: @on_accent; }
QLineEdit:focus { border: 2px solid @accent; padding: 0 7px; min-height: 28px; }

QPushButton { background: @surface; border: 1px solid @border; border-radius: 6px;
              padding: 0 12px; min-height: 30px; }
QPushButton:hover { background: @sunken; }
QPushButton:pressed { background: @border; }
QPushButton:focus { border: 2px solid @accent; padding: 0 11px; min-height: 28px; }
QPushButton:disabled { color: @muted; background: @window; }
QPushButton[primary="true"] { background: @accent; color: @on_accent; border: 0;
              @strong; min-height: 32px; padding: 0 16px; }
QPushButton[primary="true"]:focus { border: 2px solid @text; min-height: 28px; padding: 0 14px; }
QPushButton[primary="true"]:disabled { background: @border; color: @muted; }

QPushButton[pill="true"] { background: @surface; color: @accent; border: 1px solid @accent;
              border-radius: 13px; min-height: 24px; padding: 0 12px; font-size: 12px; }
QPushButton[pill="true"]:hover { background: @accent_soft; }
QPushButton[pill="true"]:focus { border: 2px solid @accent; min-height: 22px; padding: 0 11px; }

QToolButton { background: transparent; border: 1px solid transparent; border-radius: 6px;
              padding: 5px; }
QToolButton:hover { background: @sunken; }
QToolButton:checked { background: @accent_soft; }
QToolButton:pressed { background: @border; }
QToolButton:focus { border: 1px solid @accent; }
QToolButton::menu-indicator { image: none; }
QToolButton[segment="true"] { padding: 4px 12px; min-height: 22px; }
QToolButton[segment="true"]:checked { background: @surface; border: 1px solid @border; }
QFrame[segments="true"] { background: @sunken; border-radius: 7px; }
QToolButton[floating="true"] { background: @surface; border: 1px solid @border; padding: 2px; }
QToolButton[floating="true"]:hover { background: @accent_soft; }
QToolButton[floating="true"]:focus { border: 1px solid @accent; }

QProgressBar { background: @sunken; border: 0; border-radius: 3px; max-height: 6px;
               min-height: 6px; }
QProgressBar::chunk { background: @accent; border-radius: 3px; }

QSlider::groove:horizontal { height: 4px; background: @border; border-radius: 2px; }
QSlider::sub-page:horizontal { background: @accent; border-radius: 2px; }
QSlider::handle:horizontal { background: @surface; border: 1px solid @muted; width: 14px;
                             height: 14px; margin: -6px 0; border-radius: 8px; }
QSlider::handle:horizontal:focus { border: 2px solid @accent; }

QScrollArea, QListView { background: transparent; border: 0; }
QListWidget { background: @surface; border: 1px solid @border; border-radius: 8px; padding: 4px;
    outline: 0; }
QListWidget::item { padding: 6px 8px; border-radius: 4px; color: @text; }
QListWidget::item:selected { background: @accent_soft; color: @text; }
QScrollBar:vertical { background: transparent; width: 10px; margin: 0; }
QScrollBar::handle:vertical { background: @border; border-radius: 4px; min-height: 24px;
                              margin: 1px; }
QScrollBar::handle:vertical:hover { background: @muted; }
QScrollBar::add-line, QScrollBar::sub-line { height: 0; width: 0; }
QScrollBar::add-page, QScrollBar::sub-page { background: transparent; }

QSplitter::handle { background: transparent; }
"""
