"""Reads and replaces single numbers of a spec by their keys, like ``spin.rate`` or ``body.moments.1``."""

from __future__ import annotations

import copy
import difflib
import types
from collections.abc import Sequence
from typing import Annotated, Any, NamedTuple, Union, get_args, get_origin

from pydantic import BaseModel

from polhode.errors import shown
from polhode.spec.fields import UNIT
from polhode.spec.models import SpecFile
from polhode.spec.rules import list_words

TOP = ("body", "spin", "time", "system")


class KeyLimits(NamedTuple):
    """A number that decides whether a key is a place in a list."""

    max_digits: int = 9  # of a place


LIMITS = KeyLimits()


class Number(NamedTuple):
    """The numbers at a key.

    Attributes:
        unit: SI unit of its numbers, "" for plain ones; None where it depends on other keys.
        length: how many numbers, 0 for one that is no list.
    """

    unit: str | None
    length: int = 0


def number_at(key: str, system: type[BaseModel], beside: Sequence[str] = ()) -> Number:
    """Return unit and length of the numbers at a key of a spec.

    Args:
        key: names and places with dots between; places in lists count from 1.
        system: model of the table [system].
        beside: fields of it that a spec gives as tables at the top.

    Raises:
        ValueError: with a message, where there is no such key, or no number at it.
    """
    first, *rest = _names(key)
    if first not in (*TOP, *beside) or not rest:
        known = list_words([f"{name}." for name in (*TOP, *beside)], "or")
        raise ValueError(f"must begin with {known}; got {shown(key)}")
    of_system = system.model_fields[first].annotation if first in beside else system
    at: Any = of_system if first == "system" or first in beside else SpecFile.model_fields[first].annotation
    marks: list[Any] = []
    for part in rest:
        at, marks = _inside(at, part, key)
    at, marks = _bare(at, marks)
    length = 0
    if get_origin(at) is tuple:
        length = len(get_args(at))
        marks = marks if _unit(marks) is not None else _bare(get_args(at)[0], [])[1]
    unit = _unit(marks)
    if unit is None and not (at is float and marks):
        raise ValueError(f"is not a number with a unit, nor a list of such; got {shown(key)}")
    return Number(unit, length)


def _names(key: str) -> list[str]:
    """Return the names in a key, with that of a body's list of parts as ``name_parts`` has it."""
    names = key.split(".")
    return ["body", "part", *names[2:]] if names[:2] == ["body", "parts"] else names


def is_place(name: str) -> bool:
    """Whether a name in a key is a place in a list, of which Python's own reading would take digits of any number."""
    return name.isascii() and name.isdecimal() and len(name) <= LIMITS.max_digits


def _inside(at: Any, part: str, key: str) -> tuple[Any, list[Any]]:
    """Return the annotation of one field or place, and its metadata."""
    at, _ = _bare(at, [])
    if isinstance(at, type) and issubclass(at, BaseModel):
        if part not in at.model_fields:
            near = difflib.get_close_matches(part, at.model_fields, 1)
            known = f"did you mean {near[0]}?" if near else f"known there are {', '.join(at.model_fields)}"
            raise ValueError(f"names no key of a spec: {shown(key)} has no {part}; {known}")
        field = at.model_fields[part]
        return field.annotation, list(field.metadata)
    items = get_args(at) if get_origin(at) in (tuple, list) else ()
    most = len(items) if get_origin(at) is tuple else 10**6
    if not items or not is_place(part) or not 1 <= int(part) <= most:
        places = f"a place from 1 to {most}" if get_origin(at) is tuple else "a place, counted from 1"
        raise ValueError(f"needs {places if items else 'to end'} before {shown('.' + part)}; got {shown(key)}")
    return items[min(int(part), len(items)) - 1], []


def _bare(at: Any, marks: list[Any]) -> tuple[Any, list[Any]]:
    """Return an annotation without None, and its metadata apart."""
    while True:
        if get_origin(at) is Annotated:
            at, *more = get_args(at)
            marks = [*marks, *more]
        elif get_origin(at) in (Union, types.UnionType):
            at = next(choice for choice in get_args(at) if choice is not type(None))
        else:
            return at, marks


def _unit(marks: list[Any]) -> str | None:
    units = (getattr(getattr(mark, "func", None), UNIT, None) for mark in marks)
    return next((unit for unit in units if unit is not None), None)


def with_value(tables: dict[str, Any], key: str, value: Any) -> dict[str, Any]:
    """Return a file's tables with another value at a key; tables on the way are made where they are missing.

    Raises:
        ValueError: with a message, where a list on the way is missing or too short.
    """
    changed = copy.copy(tables)
    at: Any = changed
    *parents, last = _names(key)
    for name, after in zip(parents, [*parents[1:], last], strict=True):
        place = _place(at, name, key)
        inner = at[place] if isinstance(place, int) or place in at else {}
        if isinstance(inner, str) and name == "system":  # its short form, the kind alone
            inner = {"kind": inner}
        if not isinstance(inner, dict | list) or (is_place(after) != isinstance(inner, list)):
            why = f"cannot be set, as the spec has no list or table at {shown(name)}"
            raise ValueError(f"{why}; got {shown(key)}. Write it out")
        at[place] = copy.copy(inner)
        at = at[place]
    at[_place(at, last, key)] = value
    return changed


def _place(at: dict[str, Any] | list[Any], name: str, key: str) -> str | int:
    if isinstance(at, dict):
        return name
    if not 1 <= int(name) <= len(at):
        raise ValueError(f"names place {name} of a list of {len(at)} in the spec; got {shown(key)}")
    return int(name) - 1


def write_quantity(value: Any, unit: str) -> Any:
    """Return a number, or a list of them, as a spec writes it: text with its unit, or plain without one."""
    if isinstance(value, list | tuple):
        return [write_quantity(item, unit) for item in value]
    return f"{float(value)} {unit}" if unit else float(value)
