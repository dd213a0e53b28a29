"""A named tuple of options stands for all of them in a command's signature."""

import inspect
from typing import Annotated, NamedTuple

import typer
from typer.testing import CliRunner

from polhode.cli.commands.records import fit, import_
from polhode.cli.grouped_options import grouped
from polhode.spacecraft.commands import compare

Size = Annotated[int, typer.Option("--size", metavar="N", help="How large.")]
Colour = Annotated[str | None, typer.Option("--colour", metavar="NAME", help="Which colour.")]


class Looks(NamedTuple):
    size: Size = 3
    colour: Colour = None


def test_a_group_is_its_options_in_its_place():
    seen = []
    app = typer.Typer()

    @app.command()
    @grouped
    def draw(name: str, loud: bool = False, *, looks: Looks) -> None:
        """Draw something."""
        seen.append((name, loud, looks))

    help_text = CliRunner().invoke(app, ["--help"]).output
    assert help_text.index("--loud") < help_text.index("--size") < help_text.index("--colour")
    assert "How large." in help_text and "Draw something." in help_text
    for words in (["a"], ["b", "--colour", "red", "--loud"], ["c", "--size", "7"]):
        assert CliRunner().invoke(app, words).exit_code == 0
    assert seen == [("a", False, Looks()), ("b", True, Looks(colour="red")), ("c", False, Looks(7))]
    assert CliRunner().invoke(app, ["a", "--size", "big"]).exit_code == 2


def test_commands_with_columns_have_few_parameters():
    """They had 31, 26 and 23; Typer sees as many as before."""
    for command, options in ((fit, 31), (import_, 23), (compare, 26)):
        assert len(inspect.signature(command).parameters) == options
        assert len(inspect.signature(inspect.getclosurevars(command).nonlocals["function"]).parameters) <= 9
