"""Turns the arguments of Python that messages name into the options of the running command."""

from __future__ import annotations

import ast
import contextlib
import re
from collections.abc import Iterator
from contextvars import ContextVar
from typing import Any

from polhode.formats.form import Kernels

_TICKED = re.compile(r"`([a-z_.]+)(?:=([^`]+))?`")
_RUNNING: ContextVar[Any] = ContextVar("running command", default=None)
OF_KERNELS = {name: f"--{name.replace('_', '-')}" for name in Kernels._fields}
"""Options that `polhode fit` lacks, for which it refers to `polhode import`."""
OTHERWISE = {
    "fit": {"windows": "--window", "draw": "--figures"}, "lines": {"lowest": "--from", "highest": "--to"},
    "wobble": {"start": "--from", "end": "--to"}, "sweep": {"store": "--out"}, "learn": {"folder": "--from"},
}  # fmt: skip
"""Arguments whose option has another name."""
COMMANDS = {"polhode.spacecraft.read_ck": "`polhode import` and `polhode compare`"}
"""The commands for functions that messages name; every other command is the function of its name."""
COLUMNS = "columns"  # an argument of which the command has an option for each word


@contextlib.contextmanager
def run_as(context: Any) -> Iterator[None]:
    """Let ``as_options`` name a command's options within this context."""
    token = _RUNNING.set(context)
    try:
        yield
    finally:
        _RUNNING.reset(token)


def as_options(text: str) -> str:
    """Return a message of the library with the running command's options in place of Python's arguments.

    An argument is in backticks, with a value or without: `align_clock=True` is --align-clock, and
    `columns={"time": "t"}` is --time t. Outside a command the text stays as it is.

    >>> as_options("Say it by `offset`.")
    'Say it by `offset`.'
    """
    context = _RUNNING.get()
    if context is None:
        return text
    own = text.replace(f" of `polhode.{context.command.name}`", "")
    return _TICKED.sub(lambda match: _translate(match, context), own)


def argument_names(context: Any) -> dict[str, Any]:
    """Return a command's options by the names of the Python arguments that they set."""
    other = OTHERWISE.get(context.command.name, {})
    options = {option: one for one in context.command.params for option in one.opts if option.startswith("--")}
    named = {option[2:].replace("-", "_"): one for option, one in options.items() if option not in other.values()}
    return named | {name: options[option] for name, option in other.items()}


def _translate(match: re.Match[str], context: Any) -> str:
    name, value = match[1], match[2]
    if value is None and name in COMMANDS:
        return COMMANDS[name]
    known = argument_names(context)
    if name in known:
        return _spell(known[name], value, context)
    if name in OF_KERNELS and value is None:
        return OF_KERNELS[name]
    if name == COLUMNS and "mapping" in known:
        return _spell_columns(value, known, context)
    return match[0]


def _spell_columns(value: str | None, known: dict[str, Any], context: Any) -> str:
    """Return options of columns: those of a mapping's words, or those that were given."""
    words = None if value is None else _read_value(value)
    if isinstance(words, dict) and words.keys() <= known.keys():
        return " ".join(_spell(known[name], repr(word), context) for name, word in words.items())
    from polhode.cli.column_options import ColumnOptions

    given = [name for name in ColumnOptions._fields if context.params.get(name) is not None]
    return ", ".join(known[name].opts[0] for name in given or ["mapping"])


def _spell(option: Any, value: str | None, context: Any) -> str:
    """Return an option with its value as it is written on the command line."""
    name = option.opts[0]
    if value is None:
        is_off = option.secondary_opts and context.params.get(option.name) is False
        return option.secondary_opts[0] if is_off else name
    said = _read_value(value)
    if said is None:
        return f"{name} {option.metavar or value}"
    if isinstance(said, bool):
        return name if said or not option.secondary_opts else option.secondary_opts[0]
    many = isinstance(said, tuple | list)
    text = (" " if option.nargs > 1 else ",").join(map(str, said)) if many else str(said)
    if " " in text and not many:
        text = f'"{text}"'
    return f"{name}={text}" if text.startswith("-") else f"{name} {text}"


def _read_value(text: str) -> Any:
    """Return a value of Python; None for text that is none, as (start, end)."""
    try:
        return ast.literal_eval(text)
    except (SyntaxError, ValueError, TypeError, MemoryError, RecursionError):
        return None
