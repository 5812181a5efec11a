"""``iconstudio demo``: the main job on an example, in the window or, where none opens, without."""

from pathlib import Path

import click

from iconstudio.workflows.modelling.file import example


@click.command("demo")
@click.argument("name", default="motorbike")
@click.option(
    "--out",
    "folder",
    type=click.Path(path_type=Path),
    default=Path("iconstudio-demo"),
    show_default=True,
    metavar="DIR",
    help="Folder for the results where no window opens.",
)
@click.option("--headless", is_flag=True, help="Open no window in any case.")
@click.pass_context
def command(ctx: click.Context, name: str, folder: Path, headless: bool) -> None:
    """Remix an example sketch: the motorbike, or the example NAME."""
    sketch = example(name).sketch
    reason = "No window was wanted." if headless else ctx.obj.obstacle()
    if reason is None:
        ctx.exit(ctx.obj.open(name))
    click.echo(f"{reason}\nRemixing without a window.", err=True)

    from iconstudio.cli.model import run
    from iconstudio.cli.timing import Stopwatch
    from iconstudio.session import Session
    from iconstudio.workflows.grid import GridSettings

    with Session() as session:
        run(session, sketch, GridSettings(), folder, Stopwatch())
    click.echo("With a screen and Qt's libraries, the same command opens the window.", err=True)
