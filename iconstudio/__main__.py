"""The program's beginning: joins the command line and the window, which do not know each other."""

import gc
import sys

from iconstudio.safepath import leave_current_folder


class _Window:
    """The window as the command line sees it; Qt is imported when it is asked for."""

    def obstacle(self) -> str | None:
        from iconstudio.gui.window.availability import obstacle

        reason: str | None = obstacle()
        return reason

    def open(self, example: str | None) -> int:
        return _run(example=example)

    def open_project(self, path: str) -> int:
        return _run(project=path)


def _run(example: str | None = None, project: str | None = None) -> int:
    gc.disable()  # Nearly all that is made until the window is there stays.
    from iconstudio.gui.app import run

    code: int = run(example, project=project)
    return code


def main() -> None:
    """Run the command line; without a command, open the window."""
    leave_current_folder()
    from iconstudio.cli.app import run

    sys.exit(run(sys.argv[1:], _Window()))


if __name__ == "__main__":
    main()
