"""Commands that wings bring by their tables, and other packages by the entry-point group ``polhode.commands``."""

from __future__ import annotations

import contextlib
from collections.abc import Callable, Mapping, Sequence
from typing import Any

import typer
from typer.core import TyperCommand, TyperGroup

from polhode._base.plugins import find_entry_points, load_entry_point
from polhode._base.plugins.wings import wing_details, wing_points
from polhode.cli.arguments import StrictCommand
from polhode.errors import InvalidInput

GROUP = "polhode.commands"


class Commands(TyperGroup):
    """The commands of polhode, those of wings, and those of other packages; one is imported only when it is asked for.

    An entry point names a function whose arguments are annotated as Typer has them. It hands its report to
    ``polhode.publish``. The table of a wing also has the command's line of the help.
    """

    def list_commands(self, ctx: Any) -> list[str]:
        own = [*super().list_commands(ctx), *wing_points(GROUP)]
        others = sorted(find_entry_points(GROUP, own))
        return [*own, *(name for name in others if self._can_be_had(ctx, name))]

    def format_commands(self, ctx: Any, formatter: Any) -> None:
        """Write the list of the help; commands of wings are not imported for it."""
        lines, names = wing_details(GROUP), self.list_commands(ctx)
        room = formatter.width - 6 - max(map(len, names))
        rows = [(name, self._line(ctx, name, lines, room)) for name in names]
        with formatter.section("Commands"):
            formatter.write_dl(rows)

    def _line(self, ctx: Any, name: str, lines: Mapping[str, Mapping[str, str]], room: int) -> str:
        command = TyperCommand(name, help=lines[name]["help"]) if name in lines else self.get_command(ctx, name)
        return "" if command is None else command.get_short_help_str(room)

    def _can_be_had(self, ctx: Any, name: str) -> bool:
        """Whether a command can be imported; others are left out of the list, and explained when asked for."""
        with contextlib.suppress(InvalidInput):
            return self.get_command(ctx, name) is not None
        return False

    def get_command(self, ctx: Any, cmd_name: str) -> Any:
        own = super().get_command(ctx, cmd_name)
        if own is not None:
            return own
        if cmd_name in wing_points(GROUP):
            return _make_command(cmd_name, wing_points(GROUP)[cmd_name].load())
        point = find_entry_points(GROUP, ()).get(cmd_name)
        if point is None:
            return None
        try:
            return _make_command(cmd_name, load_entry_point(point))
        except InvalidInput:
            raise
        except Exception as error:  # such as annotations that Typer does not know
            why = f"the command {cmd_name} of another package, {point.value}, cannot be used: {error}"
            raise InvalidInput(f"{why}. Update or remove it.") from error


def is_compiled_as_by_python(command: Sequence[str]) -> bool:
    """Whether a command's numbers must be those of Python and of workers elsewhere to the last bit."""
    return any("compiled" in wing_details(GROUP).get(name, {}) for name in command)


def _make_command(name: str, function: Callable[..., None]) -> Any:
    alone = typer.Typer(add_completion=False, pretty_exceptions_enable=False, rich_markup_mode=None)
    alone.command(name, cls=StrictCommand)(function)
    return typer.main.get_command(alone)
