"""Keeps Python from importing what happens to lie in the current folder.

A user may stand in any folder, and in one with a download named ``pickle.py``.
"""

import os
import sys


def leave_current_folder() -> None:
    """Import nothing from the current folder any more, in this process and those it starts.

    To be called before anything else is imported. A folder where Python or its packages are
    installed stays; where the program itself lies comes last, so that it hides nothing.
    """
    protect_children()
    named = {os.path.abspath(one) for one in _named()}
    kept = [one for one in sys.path if not _is_current(one) or one in named or _is_installed(one)]
    own = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
    if own not in kept:
        kept.append(own)
    sys.path[:] = kept


def protect_children() -> None:
    """Let the Python processes that this one starts begin without the current folder."""
    os.environ["PYTHONSAFEPATH"] = "1"
    if "PYTHONPATH" in os.environ:
        os.environ["PYTHONPATH"] = os.pathsep.join(_named())
    if sys.flags.ignore_environment and not sys.flags.safe_path:
        from multiprocessing import util

        given = util._args_from_interpreter_flags  # type: ignore[attr-defined]  # not public
        util._args_from_interpreter_flags = lambda: [*given(), "-P"]  # type: ignore[attr-defined]  # not public


def _named() -> list[str]:
    """Return the folders that the user has named for imports; an empty name means here."""
    names = os.environ.get("PYTHONPATH", "").split(os.pathsep)
    return [one for one in names if one not in ("", os.curdir)]


def _is_current(folder: str) -> bool:
    try:
        return os.path.samefile(folder or os.curdir, os.curdir)
    except OSError:  # one of them is gone
        return folder == ""


def _is_installed(folder: str) -> bool:
    import site

    users = site.getusersitepackages() if site.ENABLE_USER_SITE else None
    return folder in (os.path.dirname(os.__file__), *site.getsitepackages(), users)
