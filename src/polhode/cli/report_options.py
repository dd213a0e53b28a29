"""Options of ``polhode report`` that wings bring by their tables, and other packages by ``polhode.report-options``.

Each takes a path and names a function that writes something else about the report there. The table of a wing also has
the option's line of the help, so that the help imports none.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextvars import ContextVar
from inspect import Parameter, Signature
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING, Annotated, Any

import typer

from polhode._base.plugins import FAILURES, find_entry_points, load_entry_point, record_nothing
from polhode._base.plugins.wings import wing_details, wing_points
from polhode.cli.arguments import StrictCommand
from polhode.errors import InvalidInput, PolhodeError, one_line

if TYPE_CHECKING:
    from polhode.reports.report import Report

GROUP = "polhode.report-options"
WriteMore = Callable[["Report", Path], tuple[Sequence[str], Sequence[str]]]
"""Writes the files of an option, and returns their names and notes to print."""
_PREFIX = "brought_"  # of the names of parameters, so that none is an argument of the command
_ASKED: ContextVar[Mapping[str, Path]] = ContextVar("asked for by options brought", default=MappingProxyType({}))


class ReportCommand(StrictCommand):
    """The command ``report``, with the options of wings and other packages after its own."""

    def get_params(self, ctx: Any) -> list[Any]:
        params = super().get_params(ctx)
        own = len(self.params)
        return [*params[:own], *self._brought(), *params[own:]]

    def format_options(self, ctx: Any, formatter: Any) -> None:
        """Write the list of the help, for which other packages are imported; those that cannot be are left out."""
        points = self._others()
        self._cached = [option for option in self._brought() if _describe(option, points)]
        super().format_options(ctx, formatter)

    def invoke(self, ctx: Any) -> Any:
        """Run the command, during which ``write_more`` knows the options that were given."""
        names = {_PREFIX + name.replace("-", "_"): name for name in (*wing_points(GROUP), *self._others())}
        given = {name: ctx.params.pop(key, None) for key, name in names.items()}
        token = _ASKED.set({name: Path(path) for name, path in given.items() if path is not None})
        try:
            return super().invoke(ctx)
        finally:
            _ASKED.reset(token)

    def _brought(self) -> list[Any]:
        if not hasattr(self, "_cached"):
            lines, names = wing_details(GROUP), (*wing_points(GROUP), *self._others())
            self._cached = [_make_option(name, **lines.get(name, {})) for name in names]
        return self._cached

    def _others(self) -> Mapping[str, Any]:
        if not hasattr(self, "_points"):
            taken = {word.lstrip("-") for param in self.params for word in param.opts} | {"help", *wing_points(GROUP)}
            self._points = dict(sorted(find_entry_points(GROUP, taken).items()))
        return self._points


def _make_option(name: str, metavar: str = "PATH", help: str = "") -> Any:
    """Return an option as Typer makes it."""

    def alone(**given: str | None) -> None: ...

    key = _PREFIX + name.replace("-", "_")
    option = typer.Option(f"--{name}", metavar=metavar, help=help)
    alone.__annotations__ = {key: Annotated[str | None, option]}
    argument = Parameter(key, Parameter.POSITIONAL_OR_KEYWORD, default=None, annotation=alone.__annotations__[key])
    alone.__signature__ = Signature([argument])  # type: ignore[attr-defined]
    made = typer.Typer(add_completion=False, rich_markup_mode=None)
    made.command()(alone)
    return typer.main.get_command(made).params[0]


def _describe(option: Any, points: Mapping[str, Any]) -> bool:
    """Give an option of another package its line of the help; False where it cannot be imported."""
    point = points.get(option.opts[0].removeprefix("--"))
    if point is None:
        return True
    try:
        with record_nothing():
            words = (load_entry_point(point).__doc__ or "").strip()
    except InvalidInput:
        return False
    option.help = words.partition("\n")[0]
    return True


def is_asked_for_more() -> bool:
    """Whether the running command was given any of these options."""
    return bool(_ASKED.get())


def write_more(report: Report) -> Iterator[tuple[Sequence[str], Sequence[str]]]:
    """Yield the files that the options brought to a running command write, and notes on them.

    Raises:
        InvalidInput: as the option does, whatever one of another package raises.
    """
    for name, path in _ASKED.get().items():
        if name in wing_points(GROUP):
            yield wing_points(GROUP)[name].load()(report, path)
            continue
        write: WriteMore = load_entry_point(find_entry_points(GROUP, wing_points(GROUP))[name])
        try:
            files, notes = ([str(each) for each in some] for some in write(report, path))
        except PolhodeError:
            raise
        except FAILURES as error:
            what = f"{type(error).__name__}: {one_line(str(error))}"
            raise InvalidInput(f"--{name}: the option of report {name} of another package fails ({what}). Update or "
                               "remove it.") from error
        yield files, notes
