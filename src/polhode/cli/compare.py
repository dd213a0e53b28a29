"""``polhode compare A B``: how two attitude histories differ."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

from polhode.analysis.comparison import compare
from polhode.analysis.mechanics import Mechanics
from polhode.cli.clocks import lay_side_by_side, offset_of
from polhode.cli.columns import ColumnOptions, Table, about_reading, notes_on_reading, tables_to_compare
from polhode.cli.publish import publish
from polhode.cli.sources import KINDS_IN_WORDS, Kernels, Source, body_of, source_of
from polhode.errors import InvalidInput, one_line
from polhode.formats.labels import plain as same_name
from polhode.reports.answer import Answer, Group
from polhode.reports.comparison import ComparisonReport
from polhode.reports.report import Report


def run_compare(
    first: Path, second: Path, json: bool, out: Path | None, spec: Path | None, kernels: Kernels,
    columns: ColumnOptions, offset: str | None = None,
) -> None:  # fmt: skip
    """Read both, compare, draw, and print the answers."""
    told, tables = offset_of(offset), tables_to_compare(columns)
    a, b = (source_of(path, kernels, table) for path, table in zip((first, second), tables, strict=True))
    _check_used(a, b, tables)
    shared = None if spec is None else body_of(spec).mechanics
    if spec is not None and shared is None:
        raise InvalidInput(f"{spec}: is neither of a free body nor of a top, so what would be kept is not known here.")
    known = shared or a.history.mechanics or b.history.mechanics
    histories = [replace(side.history, mechanics=shared or side.history.mechanics or known) for side in (a, b)]
    try:
        laid = lay_side_by_side(a, b, told)
        found = compare(*histories, offset=laid.offset)
    except InvalidInput as error:
        raise InvalidInput(f"{first}, {second}: {error}") from None
    read, notes = _readings(a, b)
    made = ComparisonReport(found, laid.words, (*notes, *_kinds(a, b), *_names(a, b)), *_unknown(a, b, known))
    names = Group("", [Answer("names", found.names)])
    title = one_line(f"{first} (A) and {second} (B)")
    report = Report(title, "comparison", made.summary, [names, *read, *made.answers()], made.all_notes(),
                    lambda: _drawn(made))  # fmt: skip
    publish(report, json, figures=out or Path(f"{first.stem}_and_{second.stem}"))


def _check_used(a: Source, b: Source, tables: tuple[Table | None, Table | None]) -> None:
    """Refuse options of columns that no file takes.

    Raises:
        InvalidInput: naming the file.
    """
    for side, table in zip((a, b), tables, strict=True):
        if table is not None and table.only and side.kind != "table":
            why = f"is {KINDS_IN_WORDS[side.kind]}, and a mapping is for tables"
            raise InvalidInput(f"{side.history.name}: {why}. Leave its part of the mapping out.")
    if tables != (None, None) and "table" not in (a.kind, b.kind):
        why = "is a table, and the options of columns are for these"
        raise InvalidInput(f"neither {a.history.name} nor {b.history.name} {why}. Leave them out.")


def _readings(a: Source, b: Source) -> tuple[list[Group], list[str]]:
    """Return how tables among the two are read, and notes on it."""
    groups, notes = [], []
    for name, side in (("a", a), ("b", b)):
        if side.kind == "table":
            title = f"How {side.history.name} ({name.upper()}) is read"
            groups.append(about_reading(side.trajectory, title, f"read_as.{name}"))
            notes += notes_on_reading(side.trajectory, side.history.name)
    return groups, notes


def _unknown(a: Source, b: Source, known: Mechanics | None) -> list[str]:
    """Say why there is neither energy nor momentum, unless it is for want of a spec."""
    if known is not None:
        return ["energy and momentum need angular velocities, and the samples are too few to find these."]
    specs = [side for side in (a, b) if side.system is not None]
    if not specs:
        return []
    which = " and ".join(f"{side.history.name} is of the system {side.system}" for side in specs)
    return [f"energy and momentum are known here of free bodies and tops only, and {which}."]


def _kinds(a: Source, b: Source) -> list[str]:
    """Say of specs that are not evaluated exactly how they were come by."""
    return [
        f"{side.history.name} is a motion without a closed form: its samples are compared."
        for side in (a, b) if side.kind == "spec" and side.history.exact is None
    ]  # fmt: skip


def _names(a: Source, b: Source) -> list[str]:
    """Say where the labels differ: the comparison takes the axes as they are."""
    if a.labels is None or b.labels is None:
        return []
    found = []
    for name, words in (("reference_frame", "space axes"), ("body_frame", "body axes"), ("object_name", "objects")):
        mine, theirs = getattr(a.labels, name), getattr(b.labels, name)
        if same_name(mine) != same_name(theirs):
            found.append(f"{words} have different names, {mine} and {theirs}; they are compared as if the same.")
    return found


def _drawn(report: ComparisonReport) -> dict[str, Any]:
    from polhode.figures.comparison_figure import comparison

    return {"comparison": comparison(report.comparison)}
