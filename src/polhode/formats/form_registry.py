"""The list of file formats: the modules of ``formats/forms``, those of wings, and those of other packages."""

from __future__ import annotations

import contextlib
import pkgutil
from functools import cache
from importlib import import_module
from pathlib import Path
from typing import Any

from polhode.errors import InvalidInput
from polhode.formats.form import Form
from polhode.plugins import find_entry_points, load_entry_point
from polhode.plugins.wings import wing_details, wing_points

GROUP = "polhode.formats"
HOME = Path(__file__).parent / "forms"


@cache
def forms() -> dict[str, Form]:
    """Return all forms by name, those of other packages last; those that cannot be imported are left out."""
    own = _beside() | {name: point.load() for name, point in wing_points(GROUP).items()}
    by_name: dict[str, Form] = {form.name: form for _, form in sorted(own.items())}
    return by_name | {form.name: form for form in _of_others() if form.name not in by_name}


def writable_names() -> list[str]:
    """Return the names of the forms that can be written, in the order of ``forms``; those of wings are not imported."""
    beside = [form.name for form in _beside().values() if form.write is not None]
    wings = [name for name, details in wing_details(GROUP).items() if details.get("writes")]
    own = sorted({*beside, *wings})
    return [*own, *(form.name for form in _of_others() if form.write is not None and form.name not in own)]


@cache
def _beside() -> dict[str, Form]:
    """Return the forms in the folder ``forms``, by their modules."""
    names = [module.name for module in pkgutil.iter_modules([str(HOME)])]
    return {name: import_module(f"polhode.formats.forms.{name}").FORM for name in names}


def _of_others() -> list[Form]:
    found = []
    for point in find_entry_points(GROUP, {*_beside(), *wing_points(GROUP)}).values():
        with contextlib.suppress(InvalidInput):
            found.append(_load(point))
    return found


def _load(point: Any) -> Form:
    form = load_entry_point(point)
    if not isinstance(form, Form):
        raise InvalidInput(f"the format {point.name} of another package, {point.value}, is not a Form. Update it.")
    return form


def check_importable(name: str) -> None:
    """Say why a form of another package is not there.

    Raises:
        InvalidInput: where an entry point of this name cannot be imported, or names no form.
    """
    if point := find_entry_points(GROUP, ()).get(name):
        _load(point)


def writable_forms() -> dict[str, Form]:
    """Return those that can be written, by name."""
    return {name: form for name, form in forms().items() if form.write is not None}


def form_that_is_named(path: Path) -> Form | None:
    """Return the form of a file whose content does not show it, by its name; None for none of them."""
    return next((form for form in forms().values() if form.named is not None and form.named(path)), None)


def form_that_begins(head: bytes) -> Form | None:
    """Return the form of a file by the bytes that it begins with; None for none of them."""
    return next((form for form in forms().values() if form.begins is not None and form.begins(head)), None)
