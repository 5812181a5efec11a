"""Where the files that come with the program lie."""

from pathlib import Path

_HERE = Path(__file__).resolve().parent


def resource(name: str) -> Path:
    """Return the path of a file or folder under ``resources/``.

    In an installed wheel the folder is ``iconstudio/_resources``; in a checkout it stands beside
    the package.
    """
    installed = _HERE / "_resources"
    return (installed if installed.is_dir() else _HERE.parent / "resources") / name
