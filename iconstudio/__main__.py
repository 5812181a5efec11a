"""The program's beginning: joins the command line and the window, which do not know each other."""

import sys


def open_window(path: str | None = None) -> int:
    """Open the window, with an example or a sketch file if named; return the exit code."""
    from iconstudio.gui.app import run

    return run(path)


def main() -> None:
    """Run the command line; without a command, open the window."""
    from iconstudio.cli.app import run

    sys.exit(run(sys.argv[1:], open_window))


if __name__ == "__main__":
    main()
