"""The list of kinds: the folders next to this file, those of wings, and those of other packages.

The tables ``plugin.toml`` hold what selects a kind, so that a spec imports only the kind that it names.
"""

from __future__ import annotations

import contextlib
import pkgutil
from collections.abc import Callable, Iterable, Iterator
from functools import cache
from importlib.metadata import EntryPoint
from pathlib import Path
from typing import Any

from polhode._base.plugins import find_entry_points, load_entry_point, record_nothing
from polhode._base.plugins.wings import wing_details, wing_points
from polhode.errors import InvalidInput, PolhodeError
from polhode.kinds.added_figures import added_figures
from polhode.kinds.base import AbstractKind, NextStep, Spec

GROUP = "polhode.kinds"
HOME = Path(__file__).parent


@cache
def _own() -> dict[str, EntryPoint]:
    """Return the entry points of this package, by name."""
    folders = (module.name for module in pkgutil.iter_modules([str(HOME)]) if module.ispkg)
    names = {folder.replace("_", "-"): f"{__package__}.{folder}:KIND" for folder in folders}
    return {name: EntryPoint(name, value, GROUP) for name, value in names.items()} | wing_points(GROUP)


@cache
def _others() -> dict[str, Any]:
    """Return entry points by name."""
    return find_entry_points(GROUP, _own())


def kind_names() -> list[str]:
    """Return the names of all kinds; none of them is imported."""
    return sorted({*_own(), *_others()})


def find_kind(name: str) -> AbstractKind | None:
    """Return a kind by name, None where there is none; it alone is imported.

    Raises:
        InvalidInput: for a kind of another package that cannot be imported, or is not a kind.
    """
    if name in _own():
        return _own()[name].load()
    if name not in _others():
        return None
    point = _others()[name]
    kind = load_entry_point(point)
    if not isinstance(kind, AbstractKind):
        raise InvalidInput(f"the kind {name} of another package, {point.value}, is not an AbstractKind. Update it.")
    return kind


def default_kind() -> AbstractKind:
    """Return the kind that a spec without [system] means, one of this package's own."""
    return _own()[default_kind_name()].load()


def default_kind_name() -> str:
    """Return the name of ``default_kind``, which is not imported."""
    return next(name for name, row in wing_details(GROUP).items() if row.get("default"))


def other_kind(subject: str, in_closed_form: bool) -> AbstractKind | None:
    """Return another kind of this subject, in closed form or by steps, for a remedy to name; None without one."""
    named = [name for name in kind_names() if _may_have(name, "subject", lambda value: value == subject)]
    alike = (kind for kind in _importable(named) if kind.subject == subject != "")
    return next((kind for kind in alike if kind.in_closed_form == in_closed_form), None)


def closed_form_kinds() -> list[str]:
    """Return the names of the kinds whose motion is known in closed form."""
    return sorted(kind.name for kind in _importable() if kind.in_closed_form)


def kinds_with_table(key: str) -> list[str]:
    """Return the names of the kinds whose specs have a table of this name at the top."""
    return sorted(kind.name for kind in _importable() if key in kind.table.beside)


def known_figures() -> set[str]:
    """Return the names of the figures of all kinds that can be imported, with those that are added to them."""
    return {name for kind in _importable()
            for name in (*kind.figure_names, *added_figures(kind.name, kind.figure_names))}


def kind_of_source(source: Any) -> AbstractKind | None:
    """Return the kind whose pictures show a trajectory's source; None where no kind has any of its own."""
    name = getattr(source, "kind", "")
    with contextlib.suppress(PolhodeError):
        return find_kind(name) if isinstance(name, str) and name else None
    return None


def next_steps(spec: Spec) -> list[NextStep]:
    """Return the commands that a report suggests: those of its own kind, and of other kinds that can use its body."""
    def is_for(keys: list[str]) -> bool:
        return any(getattr(spec.source, key, None) is not None for key in keys)

    named = [name for name in kind_names() if _may_have(name, "offers", is_for)]
    others = (kind for kind in _importable(named) if kind is not spec.kind)
    return [*spec.kind.next_steps(spec), *(step for kind in others for step in kind.offers(spec))]


def _may_have(name: str, key: str, fits: Callable[[Any], bool]) -> bool:
    """Whether a kind's row in the tables has a fitting value of a key; kinds of other packages have no row, and may."""
    row = wing_details(GROUP).get(name, {})
    return name not in _own() or (key in row and fits(row[key]))


def _importable(names: Iterable[str] | None = None) -> Iterator[AbstractKind]:
    """Yield kinds, all or those of some names, but those of other packages that cannot be imported.

    A plug-in that is only listed is not recorded as used.
    """
    for name in kind_names() if names is None else names:
        with contextlib.suppress(PolhodeError):
            with record_nothing():
                kind = find_kind(name)
            if kind is not None:
                yield kind
