"""Options that several commands have, as one parameter of each command's function."""

from __future__ import annotations

import functools
import inspect
from collections.abc import Callable
from typing import Any, get_type_hints


def grouped(function: Callable[..., None]) -> Callable[..., None]:
    """Return a command whose parameters that are named tuples of options are the options themselves.

    Typer reads a command's options from its signature and annotations. A parameter annotated with a NamedTuple class,
    whose fields are annotated as Typer's options with defaults, is replaced by all of them, in its place.
    """
    hints = get_type_hints(function, include_extras=True)
    parameters: list[inspect.Parameter] = []
    groups: dict[str, Any] = {}
    for parameter in inspect.signature(function).parameters.values():
        kind: Any = hints[parameter.name]
        fields = getattr(kind, "_fields", None) if isinstance(kind, type) else None
        if fields is None:
            parameters.append(parameter.replace(annotation=kind))
            continue
        groups[parameter.name] = kind
        options, defaults = get_type_hints(kind, include_extras=True), kind._field_defaults
        parameters += [inspect.Parameter(name, parameter.kind, default=defaults[name], annotation=options[name])
                       for name in fields]

    @functools.wraps(function)
    def command(**given: Any) -> None:
        made = {name: kind(*(given.pop(field) for field in kind._fields)) for name, kind in groups.items()}
        function(**given, **made)

    command.__signature__ = inspect.Signature(parameters)  # type: ignore[attr-defined]
    command.__annotations__ = {parameter.name: parameter.annotation for parameter in parameters}
    del command.__wrapped__  # type: ignore[attr-defined]  # which Typer would look through
    return command
