"""Reads the states that an engine wrote into a JSON file; a run that is refused does not end the reading."""

from __future__ import annotations

import difflib
import json
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from polhode.bodies._inertia import principal_axes
from polhode.errors import FormatError, InvalidInput, shown
from polhode.formats.opening import read_text
from polhode.judging._mistakes import VARIABLES, StateConvention
from polhode.judging._stepping import find_printed_unit
from polhode.judging.motion_table import reference_motions
from polhode.types import Array, Float64

FORMAT, VERSION = "polhode engine states", 1
RATES = {"momenta": "momentum", "angular_velocities": "angular velocity"}
START = ("inertia", "attitude", "momentum", "angular_velocity")
TOP = ("format", "version", "engine", "axes", "dt", "runs")
OF_RUN = ("motion", *START, "dt", "axes", "times", "attitudes", *RATES)


class StateFileThresholds(NamedTuple):
    """Numbers that decide which states of a file are refused.

    Attributes:
        max_bytes: of a file, which is read into memory.
        max_number: of a state; squares of larger ones leave double precision.
        max_step: s, beyond which times are not finite.
        length_tolerance: by which the length of a quaternion may miss 1, as a method without normalization makes it.
        start_length_tolerance: by which that of the start may miss it, where no method has changed it.
        tensor_tolerance: of the largest entry, by which a tensor may be asymmetric or miss I1 + I2 ≥ I3, as printed
            digits make it.
    """

    max_bytes: int = 512 * 1024 * 1024
    max_number: float = 1e150
    max_step: float = 1e300
    length_tolerance: float = 1e-2
    start_length_tolerance: float = 1e-6
    tensor_tolerance: float = 1e-6


LIMITS = StateFileThresholds()


@dataclass(frozen=True, eq=False)
class GivenMotion:
    """A free body's motion as it starts, at time 0.

    Attributes:
        name: of the motion.
        inertia: (3, 3) [kg m², body axes].
        attitude: (4,) unit quaternion wxyz, body → space.
        momentum: (3,) [kg m²/s, body axes].
        variable: by which a run gives a start of its own, "momentum" or "angular velocity"; empty for a known motion.
    """

    name: str
    inertia: Float64[Array, "3 3"]
    attitude: Float64[Array, "4"]
    momentum: Float64[Array, "3"]
    variable: str = ""

    def read_by(self, other: StateConvention, declared: StateConvention) -> GivenMotion:
        """Return the start for a run that gave it, like its states, in another convention than the declared one."""
        own = StateConvention(self.variable)  # starts are along the body's axes
        change: dict[str, Any] = {"scalar_last": other.scalar_last, "inverse": other.inverse, "degrees": other.degrees}
        if other.variable != declared.variable:
            change["variable"] = next(x for x in VARIABLES if x != self.variable)
        if other.axes != declared.axes and declared.axes == own.axes:
            change["axes"] = other.axes
        written = own.encode(self.attitude, self.momentum, self.inertia)
        attitude, momentum = replace(own, **change).decode(*written, self.inertia)
        return replace(self, attitude=attitude, momentum=momentum)


@dataclass(frozen=True, eq=False)
class WrittenStates:
    """States that an engine wrote of one motion with one step size.

    Attributes:
        given: the motion.
        dt: the step [s]; None where the file does not say.
        times: (T,) rising, after the start [s].
        quaternions, rates: (T, 4) and (T, 3), as the engine wrote them.
        convention: what these are meant to be.
        number: of the run in the file, counted from 1.
    """

    given: GivenMotion
    dt: float | None
    times: Float64[Array, "time"]
    quaternions: Float64[Array, "time 4"]
    rates: Float64[Array, "time 3"]
    convention: StateConvention
    number: int

    @cached_property
    def printed_unit(self) -> float:
        """Unit of the last digit that was printed, relative to the states; 0 for all digits."""
        largest = float(np.abs(self.rates).max()) or 1.0
        # a turn is twice the change of a unit quaternion
        return 2.0 * find_printed_unit(self.quaternions) + find_printed_unit(self.rates) / largest

    @property
    def label(self) -> str:
        """The name of the run where its motion is judged by several runs singly."""
        return _label(self.number, self.given.name)


def _label(number: int, motion: Any) -> str:
    label = f"run {number}"
    # a motion without a name is called after its run
    return f"{label} ({motion})" if isinstance(motion, str) and motion != label else label


def read_engine_states(
    path: Path, of_spec: GivenMotion | None = None
) -> tuple[str, list[WrittenStates], list[tuple[str, str]]]:
    """Return the engine's name, the states of each run, and the name and reason of each run that was refused.

    Args:
        path: of the file, as ``polhode judge`` describes it.
        of_spec: the motion of runs that name none.

    Raises:
        InvalidInput: for a file that cannot be read.
        FormatError: for what is not JSON of this format and version, and for keys at the top that it does not have.
    """
    try:
        table = json.loads(read_text(path, "JSON", LIMITS.max_bytes))
    except (ValueError, RecursionError) as error:
        if isinstance(error, InvalidInput):
            raise
        # Python refuses whole numbers of many digits by a plain ValueError, whose words are for programmers
        parses = isinstance(error, json.JSONDecodeError | RecursionError)
        why = f"is not JSON ({error})" if parses else "has a number of too many digits"
        raise FormatError(f"{path}: {why}. Write one object with format, version and runs.") from None
    header = (table.get("format"), table.get("version")) if isinstance(table, dict) else None
    if header != (FORMAT, VERSION):
        got = shown(header if header else table)
        raise FormatError(f"{path}: must have `format` {FORMAT} and `version` {VERSION}; got {got}. Write both.")
    table = _without_null(table)
    if unknown := _word_unknown(table, TOP, OF_RUN, "it belongs in a run."):
        raise FormatError(f"{path}: {unknown}")
    runs = table.get("runs")
    if not isinstance(runs, list) or not runs:
        raise FormatError(f"{path}: `runs` must be a list of runs, one at least; got {shown(runs)}.")
    states, refused = [], []
    for number, run in enumerate(runs, 1):
        try:
            states.append(_read_run(run, table, of_spec, number))
        except InvalidInput as error:
            refused.append((_label(number, run.get("motion") if isinstance(run, dict) else None), str(error)))
    return str(table.get("engine", path.stem)), states, refused


def checked_tensor(inertia: Any) -> Float64[Array, "3 3"]:
    """Return an inertia (3,) or (3, 3) as a tensor [kg m²].

    Raises:
        InvalidInput: for another shape, what is not symmetric and positive, and for moments that no body has.
    """
    try:
        values = np.asarray(inertia, dtype=float)
    except (TypeError, ValueError, OverflowError):
        values = np.empty(0)
    tensor = np.diag(values) if values.shape == (3,) else values
    square = tensor.shape == (3, 3) and np.isfinite(tensor).all()
    if not square or np.abs(tensor - tensor.T).max() > LIMITS.tensor_tolerance * np.abs(tensor).max():
        raise InvalidInput(f"`inertia` must be three moments or a symmetric (3, 3) tensor; got {shown(inertia)}.")
    tensor = 0.5 * (tensor + tensor.T)
    moments, _ = principal_axes(tensor)
    if not (moments[0] > 0.0 and moments[0] + moments[1] >= moments[2] * (1.0 - LIMITS.tensor_tolerance)):
        got = ", ".join(f"{x:.6g}" for x in moments)
        raise InvalidInput(f"`inertia` must have positive moments with I1 + I2 ≥ I3; got ({got}). Check its entries.")
    return tensor


def _without_null(table: dict[str, Any]) -> dict[str, Any]:
    """Return a table without the keys whose value is null, as some languages write unset fields."""
    return {key: value for key, value in table.items() if value is not None}


def _word_unknown(table: dict[str, Any], known: Sequence[str], elsewhere: Sequence[str], place: str) -> str:
    """Return in words the unknown keys of a table, with what may be meant; nothing without any."""
    said = []
    for key in (key for key in table if key not in known):
        near = difflib.get_close_matches(key, known, 1)
        hint = f"did you mean {near[0]}?" if near else f"known there are {', '.join(known)}."
        said.append(f"unknown key {shown(key)}; {place if key in elsewhere else hint}")
    return " ".join(said)


def _read_run(run: Any, table: dict[str, Any], of_spec: GivenMotion | None, number: int) -> WrittenStates:
    if not isinstance(run, dict):
        raise InvalidInput(f"a run must be an object with times, attitudes and a rate; got {shown(run)}.")
    run = _without_null(run)
    if unknown := _word_unknown(run, OF_RUN, TOP, "it belongs beside `runs`."):
        raise InvalidInput(unknown)
    given = _given_motion(run, of_spec, f"run {number}")
    named = [key for key in RATES if key in run]
    if len(named) != 1:
        raise InvalidInput(f"a run must have `momenta` or `angular_velocities`, one of them; got {shown(named)}.")
    times = _numbers(run, "times", (-1,))
    if len(times) < 4 or not np.isfinite(times).all() or times[0] < 0.0 or not (np.diff(times) > 0.0).all():
        raise InvalidInput(f"`times` must be four or more, rising, from 0 or later; got {shown(times.tolist()[:6])}.")
    q, rates = _finite_states(run, "attitudes", times, 4), _finite_states(run, named[0], times, 3)
    lengths = np.linalg.norm(q, axis=-1)
    if np.abs(lengths - 1.0).max() > LIMITS.length_tolerance:
        got = f"{lengths[np.abs(lengths - 1.0).argmax()]:.4g}"
        raise InvalidInput(f"`attitudes` must be quaternions of length 1; got length {got}. Divide each by its norm.")
    dt = run.get("dt", table.get("dt"))
    if dt is not None and (isinstance(dt, bool) or not (isinstance(dt, int | float) and 0.0 < dt < LIMITS.max_step)):
        raise InvalidInput(f"`dt` must be a positive time in seconds; got {shown(dt)}. Leave it out if it varies.")
    convention = StateConvention(RATES[named[0]], str(run.get("axes", table.get("axes", "body"))))
    late = times > 0.0
    return WrittenStates(given, dt, times[late], q[late], rates[late], convention, number)


def _finite_states(run: dict[str, Any], key: str, times: Float64[Array, "time"], size: int) -> Float64[Array, "time n"]:
    values = _numbers(run, key, (len(times), size))
    bad = np.flatnonzero(~(np.abs(values) < LIMITS.max_number).all(axis=-1))
    if len(bad):
        first = int(bad[0])
        # as the file has it, where NumPy would write null as nan
        got = f"{json.dumps(run[key][first])} in state {first + 1}, at t = {times[first]:.6g} s"
        raise InvalidInput(f"`{key}` must be finite numbers below {LIMITS.max_number:g}; got {got}. Leave out what "
                           "follows.")
    return values


def _check_start(run: dict[str, Any]) -> None:
    """Refuse a start that is given twice, or in part."""
    own = [key for key in START if key in run]
    if "motion" in run and own:
        raise InvalidInput(f"a run must have `motion` or a start of its own, not both; got {shown(run['motion'])} and "
                           f"{', '.join(own)}. Leave out one.")
    if "momentum" in own and "angular_velocity" in own:
        got = f"{shown(run['momentum'])} and {shown(run['angular_velocity'])}"
        raise InvalidInput(f"a run must have `momentum` or `angular_velocity`, not both; got {got}. Leave out one.")
    if own and "inertia" not in own:
        raise InvalidInput(f"a start of a run's own must have `inertia`; got {', '.join(own)} alone. Add it, or leave "
                           "them out for the motion of a spec.")


def _given_motion(run: dict[str, Any], of_spec: GivenMotion | None, label: str) -> GivenMotion:
    _check_start(run)
    if "inertia" in run:
        inertia = checked_tensor(run["inertia"])
        attitude = _numbers(run, "attitude", (4,))
        if not abs(np.linalg.norm(attitude) - 1.0) <= LIMITS.start_length_tolerance:
            raise InvalidInput(f"`attitude` must have length 1; got {shown(run['attitude'])}. Divide it by its norm.")
        by_rate = "angular_velocity" in run
        momentum = inertia @ _numbers(run, "angular_velocity", (3,)) if by_rate else _numbers(run, "momentum", (3,))
        if not (momentum.any() and np.isfinite(momentum).all()):
            raise InvalidInput(f"a body must turn at the start; got L = {shown(momentum.tolist())}.")
        unit = attitude / np.linalg.norm(attitude)
        return GivenMotion(label, inertia, unit, momentum, VARIABLES[by_rate])
    if "motion" in run:
        known = {motion.name: motion for motion in reference_motions()}
        motion = known.get(str(run["motion"]))
        if motion is None:
            raise InvalidInput(f"`motion` must be a name of the table of motions; got {shown(run['motion'])}.")
        if motion.kind != "free body":
            raise InvalidInput(f"{motion.name} is a {motion.kind}, and only free bodies are judged. Compare it by "
                               "`polhode.judging.compare_engine`.")
        unit = motion.attitude / np.linalg.norm(motion.attitude)
        return GivenMotion(motion.name, np.diag(motion.moments), unit, np.asarray(motion.momentum))
    if of_spec is None:
        raise InvalidInput("a run must name its `motion` of the table or give `inertia`, `attitude` and `momentum`; "
                           "for the motion of a spec, give the spec.")
    return of_spec


def _numbers(run: dict[str, Any], key: str, shape: tuple[int, ...]) -> np.ndarray:
    try:
        values = np.asarray(run.get(key), dtype=float)
    except (TypeError, ValueError, OverflowError):
        values = np.empty(0)
    if values.ndim != len(shape) or any(n not in (-1, m) for n, m in zip(shape, values.shape, strict=True)):
        size = " × ".join("any number" if n == -1 else str(n) for n in shape)
        raise InvalidInput(f"`{key}` must be {size} numbers; got {shown(run.get(key))}.")
    return values
