"""The program's commands, and how they end."""

import sys
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import click

from iconstudio import __version__
from iconstudio.model import IconstudioError

MISTAKE = 2
"""Exit code for bad input."""
INTERRUPTED = 130


@dataclass(frozen=True)
class Context:
    """What every command may need."""

    open_window: Callable[[str | None], int]


class _Commands(click.Group):
    """Imports a command's module when it is asked for: ``--help`` and the window stay quick."""

    names = ("demo", "library", "model", "search")

    def list_commands(self, ctx: click.Context) -> list[str]:
        return list(self.names)

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        if cmd_name not in self.names:
            return None
        from importlib import import_module

        return import_module(f"iconstudio.cli.{cmd_name}").command


@click.command(
    cls=_Commands,
    invoke_without_command=True,
    context_settings={"help_option_names": ["-h", "--help"]},
)
@click.version_option(__version__, prog_name="iconstudio")
@click.pass_context
def commands(ctx: click.Context) -> None:
    """Make new icons out of parts of real ones. Without a command, the window opens."""
    if ctx.invoked_subcommand is None:
        from iconstudio.windowing import obstacle

        if (reason := obstacle()) is not None:
            raise IconstudioError(
                f"{reason}\nWithout a window: iconstudio model SKETCH.json --out FOLDER"
            )
        ctx.exit(ctx.obj.open_window(None))


def run(arguments: Sequence[str], open_window: Callable[[str | None], int]) -> int:
    """Run the program; mistakes are told in a sentence.

    Parameters
    ----------
    open_window
        Opens the window with the example of a name, or empty, and returns the exit code.
    """
    try:
        code = commands.main(
            list(arguments),
            prog_name="iconstudio",
            standalone_mode=False,
            obj=Context(open_window),
        )
        return code if isinstance(code, int) else 0
    except click.exceptions.Exit as end:
        return end.exit_code
    except click.ClickException as error:
        error.show()
        return error.exit_code
    except (click.Abort, KeyboardInterrupt):
        click.echo("Stopped.", err=True)
        return INTERRUPTED
    except IconstudioError as error:
        click.echo(f"iconstudio: {error}", err=True)
        return MISTAKE
    except BrokenPipeError:
        # Whoever read our output has seen enough; keep Python from complaining at exit.
        sys.stdout = None
        return 0
