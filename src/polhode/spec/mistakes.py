"""Turns mistakes in a spec into messages for people."""

from __future__ import annotations

import difflib
import itertools
import re
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any, get_args, get_origin

from pydantic import BaseModel, ValidationError

from polhode.errors import shown
from polhode.spec.models import SpecFile, known_keys
from polhode.spec.rules import Location, Mistake

_BARE = re.compile(r"[\w-]{1,40}")
WORDS = {
    "string_type": "must be text in quotes",
    "bool_type": "must be true or false",
    "int_type": "must be a whole number",
    "list_type": "must be a list, [ … ]",
    "model_type": "must be a table of keys and values",
    "greater_than_equal": "must be at least {ge}",
    "less_than_equal": "must be at most {le}",
    "greater_than": "must be greater than {gt}",
    "less_than": "must be less than {lt}",
    "too_short": "must have at least {min_length} entry",
}


def list_mistakes(
    error: ValidationError, root: type[BaseModel] = SpecFile, at: Location = (), beside: Sequence[str] = ()
) -> list[Mistake]:
    """Return pydantic's errors about a model in plain English, with their places in the file.

    Args:
        error: of pydantic.
        root: the model.
        at: its place in the file.
        beside: tables that a kind has at the top of the file.
    """
    return [((*at, *mistake["loc"]), _word_mistake(mistake, root, beside, at)) for mistake in error.errors()]


def as_message(path: Path, mistakes: list[Mistake]) -> list[str]:
    """Return the lines of one message that names the file and every mistake; of very many only the first."""
    max_characters = 1600  # of all mistakes together
    lines = list(dict.fromkeys(f"  {_key(location)}: {text}" for location, text in mistakes))
    count = "1 mistake" if len(lines) == 1 else f"{len(lines)} mistakes"
    sizes = itertools.accumulate(len(line) for line in lines)
    kept = max(1, sum(size <= max_characters for size in sizes))
    rest = [] if kept == len(lines) else [f"  and {len(lines) - kept} more"]
    return [f"{path} has {count}:", *lines[:kept], *rest]


def _key(location: Location) -> str:
    """Return a place as sweeps name it too: "wheel.1.moment", where lists count from one."""
    words = [str(x + 1) if isinstance(x, int) else x if _BARE.fullmatch(x) else shown(x) for x in location]
    return ".".join(words) or "the file"


def _word_mistake(mistake: Any, root: type[BaseModel], beside: Sequence[str], at: Location) -> str:
    kind, last = mistake["type"], mistake["loc"][-1]
    if kind == "extra_forbidden":
        model = _model_at(mistake["loc"][:-1], root)
        known = [*known_keys(model), *(["system", "sweep", *beside] if model is SpecFile else [])]
        if (table := _table_with(str(last), model, (*at, *mistake["loc"][:-1]))) is not None:
            return f"unknown key; it goes into {table}"
        near = difflib.get_close_matches(str(last), known, n=1)
        return "unknown key; " + (f"did you mean {near[0]}?" if near else f"known here are {', '.join(known)}")
    if kind == "missing":
        field = _model_at(mistake["loc"][:-1], root).model_fields.get(str(last))
        return "is missing" + (f"; {field.description}" if field is not None and field.description else "")
    value = mistake["input"]
    if kind == "value_error":
        text = mistake["msg"].removeprefix("Value error, ")
    else:
        message = mistake["msg"][0].lower() + mistake["msg"][1:]
        words = WORDS[kind].format(**mistake.get("ctx", {})) if kind in WORDS else message
        text = f"{words}; got {shown(value)}"
    # checks of values print them as Python does
    return text.replace(f"; got {value}", f"; got {str(value).lower()}") if isinstance(value, bool) else text


def _table_with(key: str, model: type[BaseModel], location: Location) -> str | None:
    """Return the table within another one that takes a key, as a file writes it; None without one."""
    for name, field in model.model_fields.items():
        inner = _model_in(field.annotation)
        if inner is not None and key in known_keys(inner):
            table = _key((*location, name))
            return f"[[{table}]]" if any(get_origin(of) is list for of in _parts_of(field.annotation)) else f"[{table}]"
    return None


def _parts_of(annotation: Any) -> Iterator[Any]:
    yield annotation
    for part in get_args(annotation):
        yield from _parts_of(part)


def _model_at(location: Location, model: type[BaseModel]) -> type[BaseModel]:
    inside: Any = model
    for part in location:
        if isinstance(part, str):
            inside = str if part not in model.model_fields else model.model_fields[part].annotation  # a file's name
        else:  # a place of a list, whose entries may have models of their own
            entries = next(filter(lambda of: get_origin(of) is tuple, (inside, *get_args(inside))), None)
            each = get_args(entries)
            inside = each[part] if len(each) > part and Ellipsis not in each else inside
        model = _model_in(inside) or model
    return model


def _model_in(annotation: Any) -> type[BaseModel] | None:
    """Return the model named anywhere in an annotation."""
    if isinstance(annotation, type) and issubclass(annotation, BaseModel):
        return annotation
    return next((model for model in map(_model_in, get_args(annotation)) if model), None)
