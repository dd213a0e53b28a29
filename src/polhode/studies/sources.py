"""Every file with an attitude history: a spec, a polhode dataset or table, an AEM or a C-kernel, by its content."""

from __future__ import annotations

import contextlib
import re
from dataclasses import dataclass, replace
from decimal import Decimal
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from polhode import rotation
from polhode._base.plugins import FAILURES
from polhode.analysis._mechanics import Mechanics
from polhode.analysis.attitude_history import AttitudeHistory
from polhode.errors import FormatError, InvalidInput, PolhodeError, one_line, shown
from polhode.formats.attitude_checks import check_recorded, single_attitude
from polhode.formats.form import Form, Kernels
from polhode.formats.form_registry import find_form, form_that_begins, form_that_is_named
from polhode.formats.labels import AttitudeLabels, Recording, find_labels
from polhode.formats.opening import is_folder, open_file
from polhode.formats.stamps import exact_number
from polhode.formats.table_form import Line, detect_form, is_comment
from polhode.kinds.reading import read_spec
from polhode.motion._trajectory import Trajectory
from polhode.motion.frame import BodyFrame
from polhode.studies.naming import name_file_in_errors
from polhode.studies.tables import TableMapping, needs_mapping

SPEC, TABLE = "spec", "table"  # kinds of files that are no form
OWN_ATTITUDE = (b"time [s],q_w,q_x,q_y,q_z", b'"time [s]","q_w","q_x","q_y","q_z"')
_OF_TOML = re.compile(r"\s*(\[|[\w.\"'-]+\s*=)")
COUNTED_FROM = "counted_from"
"""Attribute of tables and datasets: the stamp that times count from [s]."""


class HistoryLimits(NamedTuple):
    """Numbers that decide whether a recorded history is refused and a rotor is ignored."""

    # rad between two samples of one time, which seven digits of a quaternion leave
    max_attitude_difference: float = 1e-6
    max_rotor_momentum: float = 1e-9  # of the largest; less changes no energy that is printed


LIMITS = HistoryLimits()


@dataclass(frozen=True, eq=False)
class Source:
    """An attitude history and its source.

    Attributes:
        kind: name of its form, "spec" or "table".
        trajectory: along the body's given axes.
        history: the trajectory for comparisons.
        labels: names, frames and epoch; None where it has no epoch.
        system: of a spec, as it names it.
        begin: the stamp of its clock that its times count from [s], exactly; 0 where they count from the clock's zero.
    """

    kind: str
    trajectory: Trajectory
    history: AttitudeHistory
    labels: AttitudeLabels | None
    system: str | None = None
    begin: Decimal = Decimal(0)


def find_begin(path: Path, trajectory: Trajectory) -> Decimal:
    """Return the stamp of its file's clock that a trajectory's times count from [s], exactly; 0 for the clock's zero.

    Raises:
        FormatError: where a dataset has a text instead of a number.
    """
    stamp = trajectory.source.attributes.get(COUNTED_FROM) if isinstance(trajectory.source, Recording) else None
    try:
        return Decimal(0) if stamp is None else exact_number(str(stamp))
    except ValueError as error:
        raise FormatError(f"{path}: {COUNTED_FROM} {error}; got {shown(stamp)}. Import the file again.") from None


def kind_in_words(kind: str, article: bool = True) -> str:
    """Return the usual name of a kind of file, like "an AEM".

    >>> kind_in_words("aem"), kind_in_words("spec", article=False)
    ('an AEM', 'spec')
    """
    form = find_form(kind)
    name = kind if form is None else form.title
    return f"{'an' if name[0] == 'A' else 'a'} {name}" if article else name


def detect_kind(path: Path, table: TableMapping | None = None) -> str:
    """Return the form of a file, detected by its first bytes; other text is a spec, or a table of another tool.

    Args:
        path: of the file.
        table: the meaning of its columns, with which any text but a spec is a table of another tool.

    Raises:
        InvalidInput: for what is missing.
        FormatError: for any other file.
    """
    head_size = 65536  # bytes by which a file is recognised
    if is_folder(path):
        return "netcdf"  # a store, which is read as such a dataset
    with open_file(path, "spec or motion") as file:
        head = file.read(head_size)
    begin = head.removeprefix(b"\xef\xbb\xbf")
    if len(head) < head_size and not begin.strip():
        raise FormatError(f"{path}: is empty, so that there is nothing to read. Check the path, or write it again.")
    form = form_that_begins(begin) or (form_that_is_named(path) if table is None else None)
    overruled = form is not None and form.is_table and table is not None and (table.only or _fits(path, table))
    if form is not None and not overruled and not (form.name == "csv" and _is_chosen(begin, table)):
        return form.name
    if begin.lstrip().startswith(b"<?xml"):
        raise FormatError(f"{path}: is XML, and no message of CCSDS's that is read here. Check the file.")
    if head.startswith(b"PK\x03\x04"):
        raise FormatError(f"{path}: is a zip archive, from which only fit takes logs of gyros. Unpack it.")
    if b"\0" in head:
        why = "is not a spec, a dataset of polhode's, an AEM or a C-kernel: it begins like none of them"
        raise FormatError(f"{path}: {why}; it may be broken. Check the file.")
    if path.suffix.lower() == ".toml":
        return SPEC
    return TABLE if table is not None or _looks_like_table(path, head) else SPEC


def is_table(kind: str) -> bool:
    """Whether a kind of file is a table of another tool, whose columns need a meaning."""
    return kind == TABLE or ((form := find_form(kind)) is not None and form.is_table)


def _fits(path: Path, table: TableMapping) -> bool:
    """Whether a mapping for two files is for this one: whether its columns are there."""
    from polhode.formats.column_resolution import resolve_mapping
    from polhode.formats.plain_table import table_form

    try:
        resolve_mapping(path, table_form(path), table.mapping)
    except InvalidInput:
        return False
    return True


def _is_chosen(begin: bytes, table: TableMapping | None) -> bool:
    """Whether the mapping applies to a table of polhode's: if it is for this file, or if the table needs it."""
    return table is not None and (table.only or not begin.startswith(OWN_ATTITUDE))


def _looks_like_table(path: Path, head: bytes) -> bool:
    """Whether a file begins like a table of numbers; the lists of a spec in TOML do not, as they have brackets."""
    lines = head.decode("utf-8", "replace").splitlines()
    content = [Line(k, text) for k, text in enumerate(lines, 1)]
    if any(_OF_TOML.match(line.text) for line in content if not is_comment(line.text)):
        return False
    try:
        detect_form(path, content)
    except FormatError:
        return False
    return True


def read_recorded(
    path: Path, kernels: Kernels, table: TableMapping | None = None, kind: str | None = None
) -> tuple[str, Trajectory, AttitudeLabels | None]:
    """Return kind, trajectory and labels of a file that holds samples.

    Raises:
        InvalidInput: for a spec, which holds none, for a table without the meaning of its columns, or as the readers
            do.
    """
    kind = detect_kind(path, table) if kind is None else kind
    if kind == TABLE:
        from polhode.formats.column_reading import read_columns

        if table is None:
            raise needs_mapping(path)
        read = read_columns(path, table.mapping)
        return kind, read, find_labels(read)
    form = find_form(kind)
    if form is None or form.read is None:
        raise InvalidInput(f"{path}: is no AEM, C-kernel, table or dataset, as it does not begin like one. Check the "
                           "file.")
    trajectory = _read_form(form, path, kernels)
    labels = find_labels(trajectory) if form.has_labels else None
    return kind, trajectory, _keep_chosen(labels) if form.is_own else labels


def _read_form(form: Form, path: Path, kernels: Kernels) -> Trajectory:
    """Return the content of a file; readers of other packages may return or raise anything, so it is checked.

    Raises:
        FormatError: for what cannot be read, holds nothing, or is no attitude.
    """
    assert form.read is not None
    unexpected = (ValueError, IndexError, KeyError, TypeError, ArithmeticError) if form.is_ours else FAILURES
    try:
        with contextlib.nullcontext() if form.is_ours else name_file_in_errors(path):
            trajectory = form.read(path, kernels)
    except (PolhodeError, OSError):
        raise
    except unexpected as error:
        as_what, why = kind_in_words(form.name), one_line(str(error))
        if not form.is_ours:
            as_what, why = f"the format {form.name} of another package", f"{type(error).__name__}: {why}"
        raise FormatError(f"{path}: cannot be read as {as_what} ({why}). Check the file.") from error
    if not isinstance(trajectory, Trajectory):
        raise FormatError(f"{path}: the format {form.name} of another package gives {shown(trajectory)}, not a "
                          "Trajectory. Update the package.")
    times = np.asarray(trajectory.times)
    if not form.is_own and not len(times):
        raise FormatError(f"{path}: holds no samples. Check the file.")
    check_recorded(path, trajectory.times, trajectory.attitude, trajectory.angular_velocity)
    if not form.is_own and not (np.diff(times) >= 0.0).all():
        raise FormatError(f"{path}: has times that fall. Check the file.")
    return trajectory


def load_source(path: Path, kernels: Kernels, table: TableMapping | None = None, kind: str | None = None) -> Source:
    """Return the attitude history of any file, whose kind ``detect_kind`` may have given already.

    Raises:
        InvalidInput: for what is missing, has no attitude, or holds several bodies.
        NotConverged: for a spec whose motion could not be followed.
    """
    kind = detect_kind(path, table) if kind is None else kind
    if kind == SPEC:
        return _from_spec(path)
    _, recorded, labels = read_recorded(path, kernels, table, kind)
    if kind == TABLE and recorded.attitude is None:
        raise InvalidInput(f"{path}: a comparison is of attitudes, and only `gyro` is given. Name them by `quat`, "
                           "`matrix`, `mrp` or `euler`.")
    trajectory = recorded.along("given")
    history = replace(
        _history(path, trajectory), resolution=_resolution(kind, recorded),
        mechanics=_find_mechanics(trajectory, recorded.frame),
    )
    return Source(kind, trajectory, history, labels, None, find_begin(path, recorded))


def _resolution(kind: str, recorded: Trajectory) -> float:
    """Return the uncertainty of a file's times by their digits [s]."""
    said = recorded.source.attributes.get("time_resolution") if isinstance(recorded.source, Recording) else None
    if isinstance(said, float | int) and said > 0.0:
        return float(said)
    return 0.0 if (form := find_form(kind)) is None else form.resolution


def _find_mechanics(trajectory: Trajectory, frame: BodyFrame | None) -> Mechanics | None:
    """Return the mechanics of a free body's dataset, whose momentum is the moments times the velocity.

    A dataset does not have the weight of a top, and a rotor's momentum is not in the moments.
    """
    kept = {"energy", "momentum_space"} <= trajectory.invariants.keys()
    if frame is None or frame.pivot is not None or not kept:
        return None
    if trajectory.angular_velocity is None or trajectory.momentum is None:
        return None
    inertia, momentum = frame.inertia, np.asarray(trajectory.momentum)
    left = np.abs(np.asarray(trajectory.angular_velocity) @ inertia - momentum).max()
    return Mechanics(inertia) if left <= LIMITS.max_rotor_momentum * np.abs(momentum).max() else None


class SpecBody(NamedTuple):
    """The body of a spec.

    Attributes:
        kind: the spec's system.
        frame: the axes that its motion is along, moments about the point that it turns about; None for none.
        mechanics: from which energy and momentum follow, along the given axes; None unless it is free, or a top.
    """

    kind: str
    frame: BodyFrame | None
    mechanics: Mechanics | None


def load_body(path: Path) -> SpecBody:
    """Return the body of a spec.

    Raises:
        InvalidInput: for another kind of file, and as reading the spec does.
    """
    if (kind := detect_kind(path)) != SPEC:
        why = f"is {kind_in_words(kind)}, and `spec` wants a spec, whose [body] has the moments"
        raise InvalidInput(f"{path}: {why}. Give a TOML file like those of `polhode report`.")
    spec = read_spec(path)
    with name_file_in_errors(path):
        motion = spec.motion()
    return SpecBody(spec.kind.name, motion.trajectory.frame, motion.mechanics)


def _from_spec(path: Path) -> Source:
    spec = read_spec(path)
    if not spec.kind.has_attitude:
        raise _without_attitudes(path)
    with name_file_in_errors(path):
        moved = spec.motion()
    trajectory = moved.trajectory.along("given")
    history = replace(_history(path, trajectory), mechanics=moved.mechanics)

    if moved.trajectory.motion is not None:

        def exact(times: Any) -> tuple[Any, Any]:
            samples = moved.trajectory.resample(times).along("given")
            return samples.attitude, samples.angular_velocity

        history = replace(history, exact=exact)
    return Source("spec", trajectory, history, _keep_chosen(spec.labels), spec.kind.name)


def _without_attitudes(path: Path) -> InvalidInput:
    why = "holds no attitudes, only how a state changes, and a comparison is of attitudes"
    return InvalidInput(f"{path}: {why}. Choose the motion of a body that turns in space.")


def _keep_chosen(labels: AttitudeLabels | None) -> AttitudeLabels | None:
    """Return labels with a chosen epoch, else None: the default epoch carries no information."""
    usual = AttitudeLabels()
    unsaid = labels is None or (labels.epoch, labels.time_system) == (usual.epoch, usual.time_system)
    return None if unsaid else labels


def _history(path: Path, trajectory: Trajectory) -> AttitudeHistory:
    if trajectory.attitude is None:
        raise _without_attitudes(path)
    try:
        attitude = single_attitude(trajectory, "A comparison")
    except InvalidInput as error:
        raise InvalidInput(f"{path}: {error}") from None
    times, first, again = np.unique(np.asarray(trajectory.times), return_index=True, return_inverse=True)
    apart = rotation.angle_between(attitude, attitude[first][again.reshape(-1)])
    if apart.max() > LIMITS.max_attitude_difference:
        when = np.asarray(trajectory.times)[int(np.argmax(apart))]
        raise InvalidInput(f"{path}: has two attitudes at {when:.9g} s, {apart.max():.3g} rad apart. Leave out one.")
    velocity = trajectory.angular_velocity
    velocity = None if velocity is None else np.asarray(velocity)[first]
    return AttitudeHistory(one_line(path.name), times, attitude[first], velocity)
