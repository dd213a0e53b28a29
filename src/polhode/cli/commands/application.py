"""The command-line application, and the arguments that many commands share."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from polhode.cli.foreign import Commands

app = typer.Typer(
    name="polhode",
    cls=Commands,
    help="How does this thing rotate? Exact motion of rigid bodies, and what it means.",
    no_args_is_help=True,
    add_completion=False,
    pretty_exceptions_enable=False,
    rich_markup_mode=None,  # half of the time of `--help`
)

SpecPath = Annotated[Path, typer.Argument(metavar="SPEC", help="TOML file: what body, how it spins, when.")]
AsJson = Annotated[bool, typer.Option("--json", help="Print one JSON object, which has units, on standard output.")]
BodySpec = Annotated[Path | None, typer.Option("--spec", metavar="SPEC", help="Whose body it is, for its moments.")]


@app.callback(invoke_without_command=True)
def about(
    version: Annotated[bool, typer.Option("--version", help="Print the version and stop.", is_eager=True)] = False,
) -> None:
    """How does this thing rotate? Exact motion of rigid bodies, and what it means."""
    if version:
        from polhode import __version__

        typer.echo(f"polhode {__version__}")
        raise typer.Exit
