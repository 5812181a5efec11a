"""How the window looks: design tokens, palette and style sheet, light and dark."""

from dataclasses import dataclass
from pathlib import Path

from PySide6.QtCore import Qt, QTimer
from PySide6.QtGui import QColor, QFont, QFontDatabase, QGuiApplication, QPalette
from PySide6.QtWidgets import QApplication, QStyleFactory
from shiboken6.Shiboken import isValid

from iconstudio.resources import resource

UNIT = 8
"""The rhythm of the layout in device-independent pixels: every distance is a multiple or a half."""


STRONG = "Inter Semi Bold"
"""Family of the headings: the bundled files name each weight as a family of its own."""
_NEXT_TURN = 1
"""Milliseconds. With none, Qt goes on before it looks at what else has come."""


@dataclass(frozen=True, slots=True)
class Theme:
    """Colours by what they are for."""

    name: str
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
    name="light",
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
    name="dark",
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
    _undress(application, theme)
    application.setStyleSheet(_style_sheet(theme))


def change(application: QApplication, theme: Theme) -> None:
    """Give a running application another look, in three turns of its loop: it answers in between.

    Until it has all of it, its windows show the old one.
    """
    windows = [one for one in application.topLevelWidgets() if one.updatesEnabled()]
    for one in windows:
        one.setUpdatesEnabled(False)
    _undress(application, theme)

    def dress() -> None:
        application.setStyleSheet(_style_sheet(theme))
        QTimer.singleShot(_NEXT_TURN, application, show)

    def show() -> None:
        for one in windows:
            if isValid(one):
                one.setUpdatesEnabled(True)

    QTimer.singleShot(_NEXT_TURN, application, dress)


def _undress(application: QApplication, theme: Theme) -> None:
    # To replace a style sheet takes Qt four times as long as to remove it and set one.
    application.setStyleSheet("")
    application.setPalette(_palette(theme))


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
    here = Path(__file__).parent
    sheet = (here / "style.qss").read_text("utf-8").replace("@here", here.as_posix())
    sheet = sheet.replace(
        "@strong;", f'font-family: "{STRONG}";' if _has_strong() else "font-weight: 600;"
    )
    sheet = sheet.replace("@name", theme.name)
    for token in Theme.__slots__:
        sheet = sheet.replace(f"@{token};", f"{getattr(theme, token)};")
    return sheet
