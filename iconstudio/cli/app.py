"""The program's commands, and how they end."""

import errno
import io
import os
import shlex
import sys
from collections.abc import Iterable, Sequence
from difflib import get_close_matches
from pathlib import Path
from typing import ClassVar, Protocol

import click

from iconstudio import __version__
from iconstudio.model import IconstudioError

MISTAKE = 2
"""Exit code for bad input."""
INTERRUPTED = 130


class Window(Protocol):
    """The window, which the command line knows only by this."""

    def obstacle(self) -> str | None:
        """Return a sentence that says why no window can open here; None if one can."""

    def open(self, example: str | None) -> int:
        """Show the window, with an example if named, until it is closed; return the exit code."""

    def open_project(self, path: str) -> int:
        """Show the window with a project until it is closed; return the exit code."""


class _Commands(click.Group):
    """One command for each workflow, and some more.

    A command's module is imported when it is asked for: ``--help`` and the window stay quick.
    """

    others: ClassVar[dict[str, str]] = {
        "demo": "Remix an example sketch, in the window if one can open.",
        "gallery": "Draw sketches with their chosen results in one picture.",
        "library": "For developers: build the collection of icons anew.",
        "scribble": "Draw a new line in a line style.",
        "search": "List the icons that a word retrieves.",
        "show": "Say whose an icon is, and draw it on its canvas.",
    }

    @property
    def helps(self) -> dict[str, str]:
        from iconstudio.workflows.registry import workflows

        return dict(sorted((self.others | {one.name: one.help for one in workflows()}).items()))

    def list_commands(self, ctx: click.Context) -> list[str]:
        return list(self.helps)

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        from iconstudio.project.archive import SUFFIX
        from iconstudio.workflows.registry import workflows
        from iconstudio.workflows.workflow import load_object

        if cmd_name.lower().endswith(SUFFIX):
            return _opening(cmd_name)
        own = {one.name: one for one in workflows()}.get(cmd_name)
        if own is not None and not own.command:
            from iconstudio.cli.plain import command_of

            return command_of(own)
        if own is None and cmd_name not in self.others:
            raise IconstudioError(_advice(cmd_name, self.helps))
        reference = own.command if own is not None else f"iconstudio.cli.{cmd_name}:command"
        command: click.Command = load_object(reference)
        return command

    def format_commands(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        with formatter.section("Commands"):
            formatter.write_dl(list(self.helps.items()))


@click.command(
    cls=_Commands,
    invoke_without_command=True,
    context_settings={"help_option_names": ["-h", "--help"]},
)
@click.version_option(__version__, prog_name="iconstudio")
@click.pass_context
def commands(ctx: click.Context) -> None:
    """Make new icons out of parts of real ones. Without a command, the window opens.

    A project, FILE.iconstudio, in place of the command is opened in it.
    """
    if ctx.invoked_subcommand is None:
        ctx.exit(_checked(ctx.obj).open(None))


def _opening(path: str) -> click.Command:
    """Return the command that opens a project in the window."""

    @click.command(name=path, help="Open a project in the window.")
    @click.pass_context
    def command(ctx: click.Context) -> None:
        if not os.path.isfile(path):
            raise IconstudioError(f"There is no file “{path}”. Check its name and folder.")
        ctx.exit(_checked(ctx.obj).open_project(path))

    return command


def _advice(word: str, commands: Iterable[str]) -> str:
    """Say what to type in place of a word that is no command."""
    from iconstudio.images.reading import SUFFIXES

    suffix, typed = Path(word).suffix.lower(), shlex.quote(word)
    beginning, commands_listed = f"“{word}” is no command.", "iconstudio --help lists them"
    if suffix == ".json":
        return _advice_on_work(word)
    if suffix.removeprefix(".") in ("svg", "svgz", *SUFFIXES):
        return (
            f"{beginning} To see it as an icon: iconstudio show {typed} --png icon.png. To work on "
            "it, open the window by iconstudio, and drop it there."
        )
    if near := get_close_matches(word.lower(), [*commands], n=1, cutoff=0.7):
        return f"{beginning} Do you mean this? iconstudio {near[0]}"
    if not word.strip() or os.path.lexists(word):
        return f"{beginning} {commands_listed}."
    return f"{beginning} {commands_listed}; iconstudio search {typed} lists icons of that name."


def _advice_on_work(path: str) -> str:
    """Say which command runs the work in a JSON file."""
    from iconstudio.inputs import json
    from iconstudio.workflows.files import likely_workflow
    from iconstudio.workflows.registry import workflows

    likely, typed = likely_workflow(json.load(Path(path)), workflows()), shlex.quote(path)
    if likely is None:
        return (
            f"“{path}” is no command. Name one before it: iconstudio COMMAND {typed} --out FOLDER"
        )
    how = f"iconstudio {likely.name} {typed} --out FOLDER"
    return f"“{path}” is no command, but {likely.noun} work. Run it by: {how}"


def _checked(window: Window) -> Window:
    """Return a window that can open.

    Raises
    ------
    IconstudioError
        If it cannot.
    """
    if (reason := window.obstacle()) is not None:
        raise IconstudioError(
            f"{reason}\nWithout a window: iconstudio model SKETCH.json --out FOLDER"
        )
    return window


def _printable(text: str) -> str:
    """Return a text that can be written: a name in it may hold bytes that are no text."""
    return text.encode(errors="backslashreplace").decode()


def run(arguments: Sequence[str], window: Window) -> int:
    """Run the program and return its exit code; mistakes are told in a sentence."""
    try:
        code = commands.main(
            list(arguments),
            prog_name="iconstudio",
            standalone_mode=False,
            obj=window,
        )
        return code if isinstance(code, int) else 0
    except click.exceptions.Exit as end:
        return end.exit_code
    except click.ClickException as error:
        shown = io.StringIO()
        error.show(shown)
        click.echo(_printable(shown.getvalue()), err=True, nl=False)
        return error.exit_code
    except (click.Abort, KeyboardInterrupt):
        click.echo("Stopped.", err=True)
        return INTERRUPTED
    except IconstudioError as error:
        click.echo(f"iconstudio: {_printable(str(error))}", err=True)
        return MISTAKE
    except UnicodeEncodeError as error:  # half of a surrogate pair, where no file name is meant
        click.echo(
            f"iconstudio: {error.object!a:.60} is no text in UTF-8. Type it again.", err=True
        )
        return MISTAKE
    except BrokenPipeError:
        # Whoever read our output has seen enough; keep Python from complaining at exit.
        sys.stdout = None
        return 0
    except OSError as error:
        if error.errno != errno.ENOSPC:
            raise
        sys.stdout = None  # It cannot be flushed.
        click.echo("iconstudio: The disk is full. Make room, and run again.", err=True)
        return MISTAKE
