"""The list of file formats: the modules of ``formats/forms``, those of wings, and those of other packages.

The tables ``plugin.toml`` hold what selects a format, so that only one that is used is imported. Formats of other
packages are all imported for the selection.
"""

from __future__ import annotations

import contextlib
import pkgutil
from collections.abc import Callable, Iterator
from fnmatch import fnmatch
from functools import cache
from importlib.metadata import EntryPoint
from pathlib import Path
from typing import Any, NamedTuple

from polhode._base.plugins import FAILURES, find_entry_points, load_entry_point
from polhode._base.plugins.wings import wing_details, wing_points
from polhode.errors import InvalidInput, PolhodeError, one_line
from polhode.formats.form import Form

GROUP = "polhode.formats"
HOME = Path(__file__).parent / "forms"


class _Listed(NamedTuple):
    """A form of this package that need not be imported: its entry point and its row of ``plugin.toml``."""

    point: EntryPoint
    table: dict[str, Any]

    def load(self) -> Form:
        return self.point.load()

    def may(self, fits: Callable[[dict[str, Any]], bool]) -> bool:
        """Whether its table fits, or says too little to decide."""
        return "ending" not in self.table or fits(self.table)


def forms() -> dict[str, Form]:
    """Return all forms by name, those of other packages last; those that cannot be imported are left out."""
    return {name: one.load() for name, one in _own().items()} | _others()


def find_form(name: str) -> Form | None:
    """Return a form by name, None where there is none; of polhode's own, it alone is imported."""
    own = _own().get(name)
    return _others().get(name) if own is None else own.load()


def writable_names() -> list[str]:
    """Return the names of the forms that can be written, in the order of ``forms``; those of wings are not imported."""
    own = [name for name, one in _own().items() if _is_written(one)]
    return [*own, *(name for name, form in _others().items() if form.write is not None)]


def extra_of(name: str) -> str | None:
    """Return the extra that a form of polhode's own needs, None where the application has all."""
    return _own()[name].table.get("extra") if name in _own() else None


def _is_written(one: _Listed) -> bool:
    return bool(one.table.get("writes")) or ("ending" not in one.table and one.load().write is not None)


@cache
def _own() -> dict[str, _Listed]:
    """Return the forms of this package by name, in the order of their modules; none is imported."""
    beside = {module.name: f"polhode.formats.forms.{module.name}:FORM" for module in pkgutil.iter_modules([str(HOME)])}
    points = {name: EntryPoint(name, value, GROUP) for name, value in beside.items()} | wing_points(GROUP)
    listed = [_Listed(point, wing_details(GROUP).get(name, {})) for name, point in sorted(points.items())]
    return {one.table.get("name", one.point.name): one for one in listed}


@cache
def _others() -> dict[str, Form]:
    """Return the forms of other packages by name, but those that cannot be imported."""
    others = {}
    for point in find_entry_points(GROUP, _own()).values():
        with contextlib.suppress(InvalidInput):
            form = _load(point)
            others |= {} if form.name in _own() else {form.name: form}
    return others


def _load(point: Any) -> Form:
    form = load_entry_point(point)
    if not isinstance(form, Form):
        raise InvalidInput(f"the format {point.name} of another package, {point.value}, is not a Form. Update it.")
    return form


def check_importable(name: str) -> None:
    """Refuse a form of another package that is not available, with the reason.

    Raises:
        InvalidInput: where an entry point of this name cannot be imported, or names no form.
    """
    if point := find_entry_points(GROUP, ()).get(name):
        _load(point)


def writable_forms() -> dict[str, Form]:
    """Return the forms that can be written, by name."""
    return {name: form for name in writable_names() if (form := find_form(name)) is not None}


def forms_that_end(ending: str) -> list[Form]:
    """Return the forms whose files' names have an ending, in the order of ``forms``."""
    return [form for form in _asked(lambda row: row["ending"] == ending) if form.ending == ending]


def form_that_is_named(path: Path) -> Form | None:
    """Return the form of a file whose content does not show it, by its name; None for none of them."""
    asked = _asked(lambda row: any(fnmatch(path.name, pattern) for pattern in row.get("names", ())))
    return next((form for form in asked if form.named is not None and _says(form, form.named, path)), None)


def form_that_begins(head: bytes) -> Form | None:
    """Return the form of a file by the bytes that it begins with; None for none of them."""
    small = head.lower()
    asked = _asked(lambda row: any(text.lower().encode() in small for text in row.get("heads", ())))
    return next((form for form in asked if form.begins is not None and _says(form, form.begins, head)), None)


def _says(form: Form, test: Callable[[Any], bool], begin: Any) -> bool:
    """Return what a form says of a file; the test of another package may raise anything."""
    try:
        return test(begin)
    except FAILURES as error:
        if form.is_ours or isinstance(error, PolhodeError):
            raise
        what = f"{type(error).__name__}: {one_line(str(error))}"
        raise InvalidInput(f"the format {form.name} of another package fails ({what}). Update or remove it.") from error


def _asked(fits: Callable[[dict[str, Any]], bool]) -> Iterator[Form]:
    """Yield the forms that the tables do not rule out, each imported when its turn comes, then those of others."""
    yield from (one.load() for one in _own().values() if one.may(fits))
    yield from _others().values()
