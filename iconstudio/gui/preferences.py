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


def remembered(name: str) -> list[str]:
    """Return a list of texts that was kept; empty if there is none."""
    found = _settings().value(name, [])
    return [found] if isinstance(found, str) else [str(one) for one in found or []]


def remember(name: str, texts: list[str]) -> None:
    """Keep a list of texts."""
    _settings().setValue(name, texts)


def put_in_front(name: str, text: str, most: int) -> None:
    """Put a text in front of a list that is kept, of which ``most`` are."""
    remember(name, [text, *(one for one in remembered(name) if one != text)][:most])


def _settings() -> QSettings:
    scope = QSettings.Scope.UserScope
    return QSettings(QSettings.Format.IniFormat, scope, "iconstudio", "iconstudio")
