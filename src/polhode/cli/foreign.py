"""Commands that other packages bring, by the entry-point group ``polhode.commands``."""

from __future__ import annotations

import contextlib
from typing import Any

import typer
from typer.core import TyperGroup

from polhode.cli.arguments import StrictCommand
from polhode.errors import InvalidInput
from polhode.plugins import find_entry_points, load_entry_point

GROUP = "polhode.commands"


class Commands(TyperGroup):
    """The commands of polhode, and after them those of other packages; one is imported only when it is asked for.

    An entry point names a function whose arguments are annotated as Typer has them. It hands what it found out to
    ``polhode.publish``.
    """

    def list_commands(self, ctx: Any) -> list[str]:
        own = super().list_commands(ctx)
        others = sorted(find_entry_points(GROUP, "command", own))
        return [*own, *(name for name in others if self._can_be_had(ctx, name))]

    def _can_be_had(self, ctx: Any, name: str) -> bool:
        """Whether a command can be imported; one that cannot is left out of the list, and told when it is asked for."""
        with contextlib.suppress(InvalidInput):
            return self.get_command(ctx, name) is not None
        return False

    def get_command(self, ctx: Any, cmd_name: str) -> Any:
        own = super().get_command(ctx, cmd_name)
        if own is not None:
            return own
        point = find_entry_points(GROUP, "command", ()).get(cmd_name)
        if point is None:
            return None
        function = load_entry_point(point, "command")
        alone = typer.Typer(add_completion=False, pretty_exceptions_enable=False, rich_markup_mode=None)
        try:
            alone.command(cmd_name, cls=StrictCommand)(function)
            return typer.main.get_command(alone)
        except Exception as error:  # such as annotations that Typer does not know
            why = f"the command {cmd_name} of another package, {point.value}, cannot be used: {error}"
            raise InvalidInput(f"{why}. Update or remove it.") from error
