"""Trajectories as CSV: one line that names columns with their units, then numbers that read back bit for bit.

Source: RFC 4180 for the form.
"""

from __future__ import annotations

import csv
import io
import re
import warnings
from pathlib import Path

import numpy as np

from polhode.errors import FormatError, InvalidInput, shown
from polhode.formats.attitude_checks import check_recorded
from polhode.formats.labels import Recording
from polhode.formats.numerals import LIMITS, MAY_VANISH, read_number
from polhode.formats.opening import MB, open_file
from polhode.formats.paths import as_path, write_whole
from polhode.motion._layout import ATTITUDE, MOMENTUM, StateLayout
from polhode.motion._outcome import Ending, Outcome
from polhode.motion._trajectory import Trajectory
from polhode.types import Array

LARGEST_FILE = 2000 * MB  # seven million rows of fourteen columns
CHUNK = 10_000  # rows that are in memory as Python's numbers at once
_ONLY_NUMBERS = re.compile(r"[-+0-9.eE,\r\n]*", re.ASCII)
_VECTORS = {"angular_velocity": ("omega", "rad s-1"), "momentum": ("L", "kg m2 s-1")}


def write_csv(trajectory: Trajectory, path: str | Path) -> Path:
    """Write one body's motion as a table: time, attitude, angular velocity, momentum, then all other known quantities.

    Columns are named like ``time [s]``, ``q_w``, ``omega_1 [rad s-1]``, ``L_1 [kg m2 s-1]``; numbers have the digits
    that they need to be read back exactly.

    Args:
        trajectory: of one body. Where the given axes are known, the table is along these, and its columns end in x, y
            and z; otherwise it is along the trajectory's own axes, 1, 2 and 3.
        path: of the file.

    Raises:
        InvalidInput: for batches, and where the file cannot be written.
    """
    unknown = trajectory.frame is None and trajectory.given_axes is None
    columns = _columns(trajectory.along("given"), "123" if unknown else "xyz")
    table = np.stack([values for _, values in columns], axis=-1)
    # RFC 4180 ends lines with CR LF, as the csv module does by itself
    with write_whole(path) as draft, draft.open("w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file)
        writer.writerow([name for name, _ in columns])
        for begin in range(0, len(table), CHUNK):
            writer.writerows(table[begin : begin + CHUNK].tolist())
    return Path(path)


def _columns(trajectory: Trajectory, axes: str) -> list[tuple[str, Array]]:
    times = np.asarray(trajectory.times, dtype=float)
    columns: list[tuple[str, Array]] = [("time [s]", times)]

    def add(values: Array, names: list[str]) -> None:
        values = np.asarray(values, dtype=float).reshape(len(times), -1) if len(times) else np.zeros((0, len(names)))
        columns.extend(zip(names, values.T, strict=True))

    if shape := trajectory.batch_shape:
        raise InvalidInput(f"a CSV file holds one body; got a batch of shape {shape}. Write a dataset instead.")
    if trajectory.attitude is not None:
        add(trajectory.attitude, [f"q_{part}" for part in "wxyz"])
    for attribute, (symbol, unit) in _VECTORS.items():
        if (values := getattr(trajectory, attribute)) is not None:
            add(values, [f"{symbol}_{axis} [{unit}]" for axis in axes])
    further = trajectory.further_parts()
    for part, values in further:
        ends = {"body": axes, "given": "xyz", "space": "xyz"}.get(part.frame) or range(1, part.size + 1)
        add(values, [_label_column(f"{part.name}_{end}" if part.size > 1 else part.name, part.unit) for end in ends])
    if len(columns) == 1 and not further:
        add(trajectory.states, [f"state_{k}" for k in range(int(np.prod(np.shape(trajectory.states)[1:])))])
    for name, values in (trajectory.invariants | trajectory.balances).items():
        count = 1 if np.ndim(values) == 1 else np.shape(values)[1]
        vector = count == 3 and not trajectory.quantity(name).of_copies
        ends = [""] if np.ndim(values) == 1 else [f"_{part}" for part in ("xyz" if vector else range(count))]
        add(values, [_label_column(f"{name}{end}", trajectory.quantity(name).unit) for end in ends])
    for name, values in trajectory.observed.items():
        ends = [""] if np.ndim(values) == 1 else [f"_{k}" for k in range(1, np.shape(values)[1] + 1)]
        add(values, [_label_column(f"{name}{end}", trajectory.quantity(name).unit) for end in ends])
    for name, values in trajectory.received.items():
        add(values, [_label_column(f"{name}_received", trajectory.quantity(name).unit)])
    return columns


def _label_column(name: str, unit: str) -> str:
    return f"{name} [{unit}]" if unit not in ("", "1") else name


def read_csv(path: str | Path) -> Trajectory:
    """Return the motion in a table that ``write_csv`` wrote, bit for bit.

    Columns that are neither attitude, angular velocity nor momentum are among the invariants, under their names. The
    source is a ``Recording``.

    Raises:
        InvalidInput: if the file is missing.
        FormatError: naming the line, if it is not such a table; naming the sample, if one has no attitude.
    """
    path = as_path("path", path)
    names, table = _read_table(path)
    columns = dict(zip(names, table.T, strict=True))
    if "time [s]" not in columns:
        raise FormatError(f'{path}, line 1: a column must be named "time [s]"; got {shown(names)}.')

    def take_columns(wanted: list[str]) -> Array | None:
        missing = [name for name in wanted if name not in columns]
        if len(missing) == len(wanted):
            return None
        if missing:
            raise FormatError(f"{path}, line 1: has no column {missing[0]}, and others that go with it. Add it.")
        return np.stack([columns.pop(name) for name in wanted], axis=-1)

    times = columns.pop("time [s]")
    attitude = take_columns([f"q_{part}" for part in "wxyz"])

    def vector(attribute: str) -> Array | None:
        symbol, unit = _VECTORS[attribute]
        own, given = (take_columns([f"{symbol}_{axis} [{unit}]" for axis in axes]) for axes in ("123", "xyz"))
        return given if own is None else own

    velocity, momentum = vector("angular_velocity"), vector("momentum")
    check_recorded(path, times, attitude, velocity)
    parts = [part for part in (attitude, momentum) if part is not None]
    if not parts:
        parts = [np.stack(list(columns.values()), axis=-1) if columns else times[:, None]]
    states = np.concatenate(parts, axis=-1)
    others: dict[str, Array] = {}
    for name, values in columns.items():
        plain = name.partition(" [")[0]
        if plain in others:
            raise FormatError(f"{path}, line 1: {shown(plain)} is there twice, in two units. Leave out one.")
        others[plain] = values
    named = [part for part, values in ((ATTITUDE, attitude), (MOMENTUM, momentum)) if values is not None]
    return Trajectory(
        times, states, StateLayout(tuple(named)), attitude, momentum, velocity, others,
        outcome=Outcome(Ending.RECORDED), source=Recording(path.name),
    )


def _read_table(path: Path) -> tuple[list[str], Array]:
    """Return the columns' names and the numbers (n, k)."""
    try:
        with io.TextIOWrapper(open_file(path, "CSV", LARGEST_FILE), "utf-8-sig", newline="") as file:
            names = _names(path, file.readline(LIMITS.max_line + 1))
            parts, rows, number = [], [], 1
            while line := file.readline(LIMITS.max_line + 1):
                number += 1
                if len(line) > LIMITS.max_line:
                    raise FormatError(f"{path}, line {number}: has more than {LIMITS.max_line} characters.")
                rows.append((number, line))
                if len(rows) == CHUNK:
                    parts.append(_numbers(path, rows, len(names)))
                    rows = []
            parts.append(_numbers(path, rows, len(names)))
            return names, np.concatenate(parts)
    except UnicodeDecodeError:
        raise FormatError(f"{path}: is not UTF-8 text, so it is not a table of polhode's.") from None


def _names(path: Path, line: str) -> list[str]:
    try:
        names = next(csv.reader([line], strict=True), [])
    except csv.Error:
        names = []
    if not names or len(set(names)) != len(names) or len(line) > LIMITS.max_line or not "".join(names).isprintable():
        raise FormatError(f"{path}, line 1: must name the columns, each once, in printable text; got {shown(line)}.")
    return names


def _numbers(path: Path, rows: list[tuple[int, str]], count: int) -> Array:
    """Return the numbers (n, count) of lines, blank ones left out."""
    whole = "".join(line for _, line in rows)
    if _ONLY_NUMBERS.fullmatch(whole) and not MAY_VANISH.search(whole):
        try:
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")  # of lines that are blank, all of them
                table = np.loadtxt(io.StringIO(whole, newline=""), delimiter=",", ndmin=2, comments=None)
            if np.isfinite(table).all() and table.shape[1] == count:
                return table
        except ValueError:
            pass
    values = []
    for number, line in rows:
        words = [word.strip() for word in line.strip().split(",")]
        if words == [""]:
            continue
        if len(words) != count:
            why = f"must have {count} numbers, as line 1 has names; got {len(words)}"
            raise FormatError(f"{path}, line {number}: {why}.")
        values.append([_number(path, number, word) for word in words])
    return np.array(values, dtype=float).reshape(-1, count)


def _number(path: Path, line: int, word: str) -> float:
    try:
        return read_number(word)
    except ValueError as error:
        raise FormatError(f"{path}, line {line}: {shown(word)} {error}.") from None
