"""From a TOML file to a body, its spin and the times asked for."""

from __future__ import annotations

import difflib
import os
from collections.abc import Iterable, Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

from pydantic import BaseModel, ValidationError

from polhode._base import check
from polhode._base.extras import needing
from polhode._base.plugins import record_plugins
from polhode.errors import FormatError, InvalidInput, NotConverged, printable, shown
from polhode.formats.mesh_archives import names_its_unit
from polhode.formats.opening import open_for_a_spec
from polhode.formats.paths import as_path
from polhode.kinds.base import AbstractKind, Spec
from polhode.kinds.registry import default_kind_name, find_kind, kind_names, kinds_with_table
from polhode.reports.base import SystemReport
from polhode.reports.report import with_inputs
from polhode.spec.building import build_body
from polhode.spec.built import BuiltBody, PartsRefused
from polhode.spec.export import make_labels
from polhode.spec.mistakes import as_message, list_mistakes
from polhode.spec.models import BodyTable, SpecFile, SystemTable, known_keys
from polhode.spec.parsing import name_parts, read_tables
from polhode.spec.reach import beyond_reach
from polhode.spec.rules import Location, Mistake, body_sources, find_broken_rules, table_rules

SWEEP = "sweep"  # the table of a sweep, for which a spec is the template


def read_spec(path: str | Path) -> Spec[Any]:
    """Read a spec; every mistake in it is reported at once.

    Raises:
        InvalidInput: naming the file and, for each mistake, the key, the rule and the given value.
        FormatError: if the file is not TOML, or a file that it names is of another format.
    """
    path = Path(path)
    tables = read_tables(path)
    tables.pop(SWEEP, None)
    with open_for_a_spec():
        return build_spec(tables, path)


def read_spec_or_molecule(path: str | Path) -> Spec[Any]:
    """Read a spec, or a structure file as the spec of its atoms alone.

    Raises:
        InvalidInput, FormatError: as ``read_spec`` does.
    """
    from polhode.formats.molecule import FORMS

    path = Path(path)
    if path.suffix.lower().lstrip(".") in FORMS:
        return build_spec({"body": {"molecule": path.name}}, path)
    return read_spec(path)


def build_spec(tables: dict[str, Any], path: Path) -> Spec:
    """Return the spec of a file's tables, as ``read_spec`` does.

    Args:
        tables: as TOML has them, without [sweep]; they stay as they are.
        path: of the file, which messages name and from whose folder paths count.
    """
    with needing("Specs need"), record_plugins() as plugins:
        spec = _build_spec(tables, path)
    return replace(spec, plugins=tuple(sorted(plugins)))


def _build_spec(tables: dict[str, Any], path: Path) -> Spec:
    table = dict(name_parts(tables))
    raw, kind, faults = _read_system(table.pop("system", default_kind_name()))
    mistakes, model = [], None
    raw, misplaced = _join_tables_beside(kind, raw, table)
    mistakes += find_broken_rules(table, _rules_of_kind(kind, table | {"system": raw}))
    system, wrong = (None, []) if kind is None else _system(kind, raw)
    mistakes += misplaced + faults + wrong
    try:
        model = SpecFile.model_validate(table)
    except ValidationError as error:
        mistakes += list_mistakes(error, beside=() if kind is None else kind.table.beside)
    if kind is not None:
        beyond = [*_as_written(kind, beyond_reach(system, ("system",), kind.reach)),
                  *beyond_reach(model, (), kind.reach)]  # fmt: skip
        locations = {location for location, _ in mistakes}
        mistakes += [mistake for mistake in beyond if mistake[0] not in locations]
    built, unphysical = _build_body(table.get("body"), path, mistakes)
    if model is None or kind is None or system is None or mistakes or unphysical:
        faults = mistakes + [(location, str(error)) for location, error in unphysical]
        of_files = not mistakes and all(isinstance(error, FormatError) for _, error in unphysical)
        raise (FormatError if of_files else InvalidInput)(*as_message(path, faults))
    name = printable(model.name or path.stem).replace("\n", " ")
    return Spec(
        name=name, kind=kind, system=system, body=None if built is None else built.body, spin=model.spin,
        until=model.time.until, samples=model.time.samples, labels=make_labels(model.export, model.name or path.stem),
        source=model.body, folder=path.parent, body_notes=() if built is None else built.notes,
    )


def report(spec: Spec[Any] | str | Path) -> SystemReport:
    """Return the answers about the motion of a spec, or of a file that holds one.

    ``summary``, ``notes`` and ``answers`` are its text; ``values()`` and ``json()`` give the numbers, and
    ``trajectory`` is the motion, of kinds that have one.

    Raises:
        InvalidInput: as ``read_spec`` does, and for values that the system refuses.
        NotConverged: where the motion could not be followed.
    """
    if isinstance(spec, Spec):
        return spec.report()
    check.instance("spec", spec, (str, os.PathLike), "a Spec, as `read_spec` returns it, or the path of a file",
                   "What a report says of motions and trajectories is in `polhode.analysis`.")
    return with_inputs(lambda: _report_on_file(as_path("spec", spec)))


def _report_on_file(path: Path) -> SystemReport:
    read = read_spec(path)
    try:
        return read.report()
    except (InvalidInput, NotConverged) as error:
        raise type(error)(f"{path}: {error}") from None


def model_of_tables(kind: AbstractKind, tables: dict[str, Any]) -> type[BaseModel]:
    """Return the model of a kind's table [system], with the tables that a file gives beside it."""
    raw, _, _ = _read_system(tables.get("system", kind.name))
    return kind.model_of(_join_tables_beside(kind, raw, dict(tables))[0])


def kind_of_tables(tables: dict[str, Any], path: Path) -> AbstractKind:
    """Return the kind that a file's tables name.

    Raises:
        InvalidInput: where there is no such kind.
    """
    _, kind, mistakes = _read_system(tables.get("system", default_kind_name()))
    if kind is None:
        raise InvalidInput(*as_message(path, mistakes))
    return kind


def _read_system(raw: Any) -> tuple[Any, AbstractKind | None, list[Mistake]]:
    """Return the table [system] in its long form, the kind that it names, and its mistakes."""
    raw = {"kind": raw} if isinstance(raw, str) else raw
    if isinstance(raw, dict):
        return raw, *_kind(raw)
    known = ", ".join(kind_names())
    return raw, None, [(("system",), f"must be a table, or one of its kinds, {known}; got {shown(raw)}")]


def _kind(raw: dict[str, Any]) -> tuple[AbstractKind | None, list[Mistake]]:
    """Return the kind that a raw table [system] names, or the mistake in the name."""
    name = raw.get("kind")
    kind = find_kind(name) if isinstance(name, str) else None
    if kind is not None:
        return kind, []
    got = "it is missing" if name is None else f"got {shown(name)}"
    near = difflib.get_close_matches(name, kind_names(), 1) if isinstance(name, str) else []
    hint = f"; did you mean {near[0]}?" if near else ""
    return None, [(("system", "kind"), f"must be one of {', '.join(kind_names())}; {got}{hint}")]


def _rules_of_kind(kind: AbstractKind | None, tables: dict[str, Any]) -> Iterator[Mistake]:
    """Yield missing and superfluous tables, and mistakes in the kind's own keys."""
    yield from table_rules(tables, "" if kind is None else kind.name, None if kind is None else kind.table)
    if kind is not None:
        yield from _as_written(kind, kind.rules(tables))


def _system(kind: AbstractKind, raw: dict[str, Any]) -> tuple[SystemTable | None, list[Mistake]]:
    model = kind.model_of(raw)
    try:
        return kind.settle(model.model_validate(raw)), []
    except ValidationError as error:
        return None, list(_as_written(kind, list_mistakes(error, model, ("system",))))


def _join_tables_beside(kind: AbstractKind | None, raw: Any, table: dict[str, Any]) -> tuple[Any, list[Mistake]]:
    """Move a kind's own tables from the top of a file into its [system]; return that, and misplaced keys."""
    beside = () if kind is None else kind.table.beside
    wrong: list[Mistake] = []
    for key in [key for key in table if key not in SpecFile.model_fields and key not in beside]:
        if kinds := kinds_with_table(key):
            which = " or ".join(f'"{name}"' for name in kinds)
            wrong.append(((key,), f"goes with another system; write system = {which} at the top, or leave it out"))
            table.pop(key)
    if not isinstance(raw, dict):
        return raw, wrong
    for key in [key for key in beside if key in raw]:
        wrong.append((("system", key), f"belongs at the top of the file and not in [system]; write it as [{key}]"))
    kept = {key: value for key, value in raw.items() if key not in beside}
    return kept | {key: table.pop(key) for key in beside if key in table}, wrong


def _as_written(kind: AbstractKind, mistakes: Iterable[Mistake]) -> Iterator[Mistake]:
    """Yield mistakes at the places that their tables have in the file."""
    for location, text in mistakes:
        moved = location[:1] == ("system",) and location[1:2] and location[1] in kind.table.beside
        yield (location[1:] if moved else location), text


def _build_body(
    raw: Any, path: Path, mistakes: list[Mistake]
) -> tuple[BuiltBody | None, list[tuple[Location, InvalidInput]]]:
    """Return the body, or the mistakes in its table.

    Where there are mistakes, every part that is right in itself is tried on its own: each part, and the source of the
    body as if its other keys were right.
    """

    def clean(location: Location) -> bool:
        return not any(where[: len(location)] == location for where, _ in mistakes)

    if not isinstance(raw, dict):
        return None, []
    parts = raw.get("part")
    numbers = range(len(parts) if isinstance(parts, list) else 0)
    right = [k for k in numbers if clean(("body", "part", k))]
    sources = [key for key in body_sources() if key in raw]
    if len(right) < len(numbers):
        assert isinstance(parts, list)
        alone = [k for k in right if parts[k].get("cut") is not True]
        kept = {"part": [parts[k] for k in alone]}
        if "density" in raw and clean(("body", "density")):
            kept |= {"density": raw["density"]}
        _, faults = _attempt(kept, path, alone) if alone else (None, [])
        return None, [fault for fault in faults if len(fault[0]) > 1]  # not the parts together
    if len(sources) != 1 or not clean(("body", sources[0])):
        return None, []
    kept = {key: value for key, value in raw.items() if key in known_keys(BodyTable) and clean(("body", key))}
    if "joints" in raw and "joints" not in kept:
        kept |= {"joints": {}}  # the file's links may be right at any pose
    if "mesh" in kept:
        kept = kept if names_its_unit(str(kept["mesh"])) else {"mesh_unit": "m", **kept}
        if ("mass" in kept) == ("density" in kept):
            kept = {key: value for key, value in kept.items() if key != "density"} | {"mass": "1 kg"}
    return _attempt(kept, path, list(numbers))


def _attempt(
    table: dict[str, Any], path: Path, numbers: list[int]
) -> tuple[BuiltBody | None, list[tuple[Location, InvalidInput]]]:
    """Return the body of a table whose parts have these numbers in the file, or its mistakes."""
    try:
        return build_body(BodyTable.model_validate(table), path.parent, path), []
    except PartsRefused as error:
        return None, [(("body", "part", numbers[k]), fault) for k, fault in error.faults]
    except InvalidInput as error:
        return None, [(("body",), error)]
