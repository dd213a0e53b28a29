"""``polhode.compare``: how two attitude histories differ."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import replace
from decimal import Decimal
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from polhode.analysis._mechanics import Mechanics
from polhode.errors import InvalidInput, shown
from polhode.formats.form import Kernels
from polhode.formats.labels import plain as same_name
from polhode.formats.paths import as_path
from polhode.reports.answer import Group
from polhode.spacecraft.comparing import comparison
from polhode.spacecraft.comparing.clocks import Align, lay_side_by_side, parse_clocks
from polhode.spacecraft.comparing.report import ComparisonReport
from polhode.studies.naming import name_file_in_errors
from polhode.studies.sources import TABLE, Source, is_table, kind_in_words, load_body, load_source
from polhode.studies.tables import TableMapping, describe_reading, list_reading_notes, take_columns

History = comparison.Source | Path | str


class StudyLimits(NamedTuple):
    """What the moments of a file and of a spec may differ by."""

    relative_inertia: float = 1e-6  # that seven digits of a file leave


LIMITS = StudyLimits()


def compare(
    a: History, b: History, *, spec: Path | str | None = None, offset: float | str | None = None,
    align_clock: bool = False, columns: Mapping[str, Any] | None = None,
) -> ComparisonReport:
    """Return the report on how two attitude histories of one body differ.

    Both are compared along common body axes: where one is exact it is evaluated at the other's samples, and
    of two sampled ones B is interpolated by a spline of rotations. ``ph.spacecraft.compare`` has the numbers alone.

    Args:
        a: the reference for times: a history, a trajectory with attitudes, a motion in closed form, or a file
            with one: spec, dataset, CSV of polhode's, CCSDS AEM, C-kernel with its own kernels next to it, table.
        b: the other.
        spec: of files, that of the body's spec, for its moments where the two do not give energy and momentum.
        offset: A's time at B's time zero [s]; of files also a text like "-68.5 s", or "start" if both begin at the same
            moment. Left out, it is 0, and of files what their epochs say.
        align_clock: of two files, whether the offset is estimated from the attitudes. Where several fit, the nearest to
            `offset` is taken, which then need not be exact.
        columns: of tables of other programs among the files, words of a mapping by name, like {"time": "t", "quat":
            "qw,qx,qy,qz"}. Two tables with different columns are read by ``polhode.formats.read_columns`` first.

    Raises:
        InvalidInput: for files that cannot be read, for anything but an attitude history, and for two histories that
            have no time in common.
        NotConverged: for a spec whose motion could not be followed.

    >>> import polhode as ph
    >>> motion = ph.FreeMotion((1.0, 2.0, 3.0), momentum=(0.3, 1.8, 1.5))
    >>> ph.compare(motion, motion.sample([0.0, 1.0, 2.0])).summary
    'Both agree to 3.0e-16 rad: to rounding.'
    """
    if not (offset is None or isinstance(offset, str) or (isinstance(offset, int | float) and math.isfinite(offset))):
        raise InvalidInput(f"`offset` must be a time in seconds, or a text like `-68.5 s`; got {shown(offset)}.")
    table = take_columns(columns, False)
    if isinstance(a, str | Path) and isinstance(b, str | Path):
        parsed = parse_clocks(offset, align_clock)
        body = None if spec is None else as_path("spec", spec)
        return compare_files(as_path("a", a), as_path("b", b), body, tables=(table, table), offset=parsed)
    if table is not None and not isinstance(a, str | Path) and not isinstance(b, str | Path):
        raise InvalidInput(f"`columns` must be left out where neither is a file; got {shown(columns)}.")
    sides = [load_source(Path(side), Kernels(), table).history if isinstance(side, str | Path) else side
             for side in (a, b)]
    if align_clock:
        raise InvalidInput("`align_clock` is for two files. Use `polhode.spacecraft.comparing.comparison.align_clocks` "
                           "on histories.")
    if spec is not None or isinstance(offset, str):
        name, got = ("spec", spec) if spec is not None else ("offset", offset)
        rule = "left out" if name == "spec" else "a time in seconds"
        more = " An AttitudeHistory takes its mechanics with it." if name == "spec" else ""
        raise InvalidInput(f"`{name}` must be {rule} where not both are files; got {shown(got)}.{more}")
    begin = 0.0 if offset is None else float(offset)
    words = "taken as one" if begin == 0.0 else f"B's time zero is at {begin:.9g} s of A"
    return ComparisonReport(comparison.compare(*sides, offset=begin), words)


def compare_files(
    first: Path, second: Path, spec: Path | None = None, kernels: Kernels | None = None,
    tables: tuple[TableMapping | None, TableMapping | None] = (None, None), offset: Decimal | str | Align | None = None,
) -> ComparisonReport:
    """Return the report on how the attitude histories of two files differ.

    Args:
        first: spec, dataset or CSV of polhode's, CCSDS AEM, C-kernel, or any table; times are counted by it.
        second: likewise.
        spec: of the body, for its moments.
        kernels: clock, frame and leap-second kernels for C-kernels.
        tables: options of the columns of each, where it is a table of another tool.
        offset: A's clock at B's zero [s], "start" if both begin at the same moment, or that the attitudes show it; None
            for what the epochs say.

    Raises:
        InvalidInput: for files that cannot be read or have no time in common.
        NotConverged: for a spec whose motion could not be followed.
    """
    a, b = (load_source(path, kernels or Kernels(), table)
            for path, table in zip((first, second), tables, strict=True))
    _check_used(a, b, tables)
    shared = None if spec is None else _find_mechanics(spec)
    known = shared or a.history.mechanics or b.history.mechanics
    others = [] if shared is None else [side.history.name for side in (a, b) if _has_other_moments(side, shared)]
    histories = [replace(side.history, mechanics=shared or side.history.mechanics or known) for side in (a, b)]
    with name_file_in_errors(f"{first}, {second}"):
        laid = lay_side_by_side(a, b, offset)
        result = comparison.compare(*histories, offset=laid.offset)
    reading, notes = _readings(a, b)
    doubts = [f"the moments of {spec} are not those that {name} has." for name in others]
    warned = (*notes, *doubts, *_kinds(a, b), *_names(a, b))
    unknown = _unknown(a, b, known)
    why = {} if unknown is None else {"unknown": unknown}
    return ComparisonReport(result, laid.words, laid.aligned, warned, reading=tuple(reading), **why)


def _has_other_moments(side: Source, shared: Mechanics) -> bool:
    """Whether a file's own moments differ from those of the spec given for both."""
    own = side.history.mechanics
    if own is None:
        return False
    difference = float(np.abs(own.inertia - shared.inertia).max())
    return difference > LIMITS.relative_inertia * float(np.abs(own.inertia).max())


def _find_mechanics(spec: Path) -> Mechanics:
    mechanics = load_body(spec).mechanics
    if mechanics is None:
        raise InvalidInput(f"{spec}: is neither of a free body nor of a top, so what would be kept is not known here.")
    return mechanics


def _check_used(a: Source, b: Source, tables: tuple[TableMapping | None, TableMapping | None]) -> None:
    """Refuse options of columns that no file takes.

    Raises:
        InvalidInput: naming the file.
    """
    for side, table in zip((a, b), tables, strict=True):
        if table is not None and table.only and side.kind != TABLE:
            why = f"is {kind_in_words(side.kind)}, and a mapping is for tables"
            raise InvalidInput(f"{side.history.name}: {why}. Leave its part of the mapping out.")
    if tables != (None, None) and TABLE not in (a.kind, b.kind):
        why = "is a table, and the options of columns are for these"
        raise InvalidInput(f"neither {a.history.name} nor {b.history.name} {why}. Leave them out.")


def _readings(a: Source, b: Source) -> tuple[list[Group], list[str]]:
    """Return how tables among the two are read, and notes on it."""
    groups, notes = [], []
    for name, side in (("a", a), ("b", b)):
        if is_table(side.kind):
            title = f"How {side.history.name} ({name.upper()}) is read"
            groups.append(describe_reading(side.trajectory, title, f"read_as.{name}"))
            notes += list_reading_notes(side.trajectory, side.history.name)
    return groups, notes


def _unknown(a: Source, b: Source, known: Mechanics | None) -> str | None:
    """Explain missing energy and momentum, unless a spec is all that is missing."""
    if known is not None:
        return "energy and momentum need angular velocities, and the samples are too few to find these."
    specs = [side for side in (a, b) if side.system is not None]
    if not specs:
        return None
    which = " and ".join(f"{side.history.name} is of the system {side.system}" for side in specs)
    return f"energy and momentum are known here of free bodies and tops only, and {which}."


def _kinds(a: Source, b: Source) -> list[str]:
    """Note specs whose motion is sampled, not evaluated exactly."""
    return [
        f"{side.history.name} is a motion without a closed form: its samples are compared."
        for side in (a, b) if side.kind == "spec" and side.history.exact is None
    ]


def _names(a: Source, b: Source) -> list[str]:
    """Note labels that differ; the comparison takes the axes as given."""
    if a.labels is None or b.labels is None:
        return []
    notes = []
    for name, words in (("reference_frame", "space axes"), ("body_frame", "body axes"), ("object_name", "objects")):
        mine, theirs = getattr(a.labels, name), getattr(b.labels, name)
        if mine and theirs and same_name(mine) != same_name(theirs):
            notes.append(f"{words} have different names, {mine} and {theirs}; they are compared as if the same.")
    return notes
