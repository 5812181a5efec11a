"""Fixtures of the window's tests, where Qt can be loaded; elsewhere one test says why it cannot."""

try:
    import PySide6.QtWidgets  # noqa: F401
except ImportError:
    pass
else:
    from fixtures import (  # noqa: F401
        look,
        no_thread_is_left,
        no_warnings_of_qt,
        own_journals,
        own_preferences,
        qapp_cls,
        session,
        sketching,
        window,
    )
