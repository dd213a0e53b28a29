"""Checks of the command line that hold for all commands and options."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from typing import Any

import typer
from typer.core import TyperCommand

from polhode.cli.naming import as_options, run_as
from polhode.errors import InvalidInput, PolhodeError, shown
from polhode.formats.numerals import read_number

_WHOLE = re.compile(r"[-+]?[0-9]{1,12}")


def check_arguments(arguments: Sequence[str]) -> None:
    """Refuse empty arguments.

    Raises:
        InvalidInput: for one that is empty, as where a shell's variable has no value, or holds a NUL.
    """
    if "" in arguments or any(text.endswith("=") and text.startswith("--") for text in arguments):
        raise InvalidInput("an argument is empty. Leave it out, or check the variable that it comes from.")
    if wrong := [text for text in arguments if "\0" in text]:
        raise InvalidInput(f"no argument may hold a NUL; got {shown(wrong[0])}.")


def whole_number(least: int, most: int) -> Callable[[str | int], int]:
    """Return how an option reads a whole number; Python alone would take 2_5 for 25, and digits of any script."""

    def parse(text: str | int) -> int:
        if not _WHOLE.fullmatch(str(text)) or not least <= int(text) <= most:
            raise typer.BadParameter(f"must be a whole number from {least} to {most}; got {shown(text)}")
        return int(text)

    return parse


def real_number(text: str | float) -> float:
    """Return the finite number that a word of an option is, as files have it; Python alone would take ``1e-400`` for 0.

    Raises:
        typer.BadParameter: for anything else.
    """
    try:
        return read_number(str(text))
    except ValueError as error:
        raise typer.BadParameter(f"{error}; got {shown(text)}") from None


class StrictCommand(TyperCommand):
    """A command that refuses an option given twice; the last would be taken, and the others dropped silently.

    The library's messages name arguments of Python; the command names its options instead.
    """

    def parse_args(self, ctx: Any, args: list[str]) -> list[str]:
        """Return the result of the base class's parser.

        Raises:
            InvalidInput: naming the option.
        """
        order = self.make_parser(ctx).parse_args(list(args))[2]
        for option in order:
            single = option.param_type_name == "option" and not getattr(option, "multiple", False)
            if single and order.count(option) > 1:
                raise InvalidInput(f"{option.opts[0]} is given {order.count(option)} times. Give it once.")
        return super().parse_args(ctx, args)

    def invoke(self, ctx: Any) -> Any:
        """Run the command.

        Raises:
            PolhodeError: as the command does, naming its options.
        """
        with run_as(ctx):
            try:
                return super().invoke(ctx)
            except PolhodeError as error:
                error.args = tuple(map(as_options, error.args))
                raise
