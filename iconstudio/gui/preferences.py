"""What the user prefers, remembered from one time to the next."""

from PySide6.QtCore import QSettings


def preferred(name: str, default: bool) -> bool:
    """Return whether something is wanted."""
    return bool(_settings().value(name, default, type=bool))


def prefer(name: str, wanted: bool) -> None:
    """Remember whether something is wanted."""
    if wanted != preferred(name, not wanted):
        _settings().setValue(name, wanted)


def _settings() -> QSettings:
    scope = QSettings.Scope.UserScope
    return QSettings(QSettings.Format.IniFormat, scope, "iconstudio", "iconstudio")
