"""What the user prefers, remembered from one time to the next."""

from typing import TypeVar

from PySide6.QtCore import QSettings

T = TypeVar("T", bool, str)


def preferred(name: str, default: T) -> T:
    """Return what is preferred: a truth value, or a text."""
    return type(default)(_settings().value(name, default, type=type(default)))


def prefer(name: str, wanted: bool | str) -> None:
    """Remember whether something is wanted."""
    settings = _settings()
    if not settings.contains(name) or wanted != preferred(name, wanted):
        settings.setValue(name, wanted)


def _settings() -> QSettings:
    scope = QSettings.Scope.UserScope
    return QSettings(QSettings.Format.IniFormat, scope, "iconstudio", "iconstudio")
