"""Fixed-step cases in single precision, with full inertias and thresholds, and an engine that is run on all of them."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cache
from importlib.resources import files
from typing import NamedTuple

import numpy as np

from polhode import rotation
from polhode.errors import FormatError, InvalidInput, shown
from polhode.judging._mistakes import StateConvention
from polhode.judging._stepping import Step, SteppedEngine
from polhode.types import Array, Float64

TABLE = "fixed_step_cases.json"
FORMAT, VERSION = "polhode fixed-step cases", 1
ORDERS = (1, 2, 4)


@dataclass(frozen=True, eq=False)
class FixedStepCase:
    """One case: its given values are float32 numbers, kept as doubles; vectors are along the body's axes.

    Attributes:
        name: different for every case.
        inertia: (3, 3) full tensor [kg m²].
        attitude: (4,) at the start, unit quaternion wxyz, body → space.
        angular_velocity, momentum: (3,) at the start [rad/s, kg m²/s].
        dt: of a step [s].
        steps: (K,) numbers of steps after which exact states are given.
        attitudes, momenta: (K, 4) and (K, 3), exact.
        attitude_thresholds, momentum_thresholds: by the order of a method, 1, 2 or 4, (K,) largest error in
            float32 [rad, relative to |L|]: twice that of a plain method of that order.
    """

    name: str
    inertia: Float64[Array, "3 3"]
    attitude: Float64[Array, "4"]
    angular_velocity: Float64[Array, "3"]
    momentum: Float64[Array, "3"]
    dt: float
    steps: tuple[int, ...]
    attitudes: Float64[Array, "time 4"]
    momenta: Float64[Array, "time 3"]
    attitude_thresholds: Mapping[int, Float64[Array, "time"]]
    momentum_thresholds: Mapping[int, Float64[Array, "time"]]


class FixedStepErrors(NamedTuple):
    """The errors of an engine in one case.

    Attributes:
        name: of the case.
        attitude: (K,) [rad].
        momentum: (K,) relative to |L|.
        passed: whether all are within the thresholds.
    """

    name: str
    attitude: Float64[Array, "time"]
    momentum: Float64[Array, "time"]
    passed: bool


@dataclass(frozen=True, eq=False)
class FixedStepResults:
    """The errors of an engine in the cases that it ran, and the cases that it refused; printed as a table.

    Attributes:
        order: whose thresholds count.
        errors: of each case.
        refused: name of each case at which the engine raised an error, and what the error said.
    """

    order: int
    errors: tuple[FixedStepErrors, ...]
    refused: tuple[tuple[str, str], ...]

    @property
    def passed(self) -> bool:
        """Whether the engine ran every case within its thresholds."""
        return not self.refused and all(one.passed for one in self.errors)

    def __str__(self) -> str:
        lines = [f"{'case':38}{'attitude [rad]':>16}{'momentum':>12}  after the last step, order {self.order}"]
        for one in self.errors:
            word = "passed" if one.passed else "over the threshold"
            lines.append(f"{one.name:38}{one.attitude[-1]:16.2g}{one.momentum[-1]:12.2g}  {word}")
        return "\n".join([*lines, *(f"{name:38}refused: {why}" for name, why in self.refused)])


@cache
def fixed_step_cases() -> tuple[FixedStepCase, ...]:
    """Return the fixed-step cases of the table, whose states were computed in ball arithmetic.

    Raises:
        FormatError: for a table of another version.

    >>> case = fixed_step_cases()[0]
    >>> case.name, case.dt, case.steps
    ('box about no axis', 0.015625, (1, 16, 128, 640))
    """
    table = json.loads(files("polhode.judging").joinpath(TABLE).read_text(encoding="utf-8"))
    if (table.get("format"), table.get("version")) != (FORMAT, VERSION):
        raise FormatError(f"a table must be of format {FORMAT}, version {VERSION}; got {shown(table.get('version'))}.")
    cases = []
    for entry in table["cases"]:
        limits = entry.pop("thresholds")
        by_order = [{n: np.array(limits[f"order_{n}"][part]) for n in ORDERS} for part in ("attitude", "momentum")]
        arrays = {key: np.array(value) for key, value in entry.items() if key not in {"name", "dt", "steps"}}
        for array in (*arrays.values(), *by_order[0].values(), *by_order[1].values()):
            array.setflags(write=False)
        cases.append(FixedStepCase(**{**entry, **arrays, "steps": tuple(entry["steps"])},
                                   attitude_thresholds=by_order[0], momentum_thresholds=by_order[1]))
    return tuple(cases)


def run_fixed_steps(
    make_step: Callable[[Float64[Array, "3 3"]], Step], order: int = 1, *, variable: str = "momentum",
    axes: str = "body",
) -> FixedStepResults:
    """Run an engine on all fixed-step cases; one at which it raises an error is listed, and does not end the run.

    Args:
        make_step: takes an inertia (3, 3) [kg m², body axes] and returns a step as ``judge`` takes it.
        order: of its method, 1, 2 or 4, whose thresholds count.
        variable, axes: what the step's rate is, as ``judge`` takes them.

    Raises:
        InvalidInput: for another order, variable or axes.
    """
    if order not in ORDERS:
        raise InvalidInput(f"`order` must be 1, 2 or 4; got {shown(order)}. Take the next lower one.")
    convention = StateConvention(variable, axes)
    errors, refused = [], []
    for case in fixed_step_cases():
        try:
            errors.append(_run_case(make_step(case.inertia), case, order, convention))
        except Exception as error:  # whatever an engine raises, the other cases are still to be run
            refused.append((case.name, f"{type(error).__name__}: {error}"))
    return FixedStepResults(order, tuple(errors), tuple(refused))


def _run_case(step: Step, case: FixedStepCase, order: int, convention: StateConvention) -> FixedStepErrors:
    engine = SteppedEngine(step, np.asarray(case.inertia), convention)
    run = engine.run(case.attitude, case.momentum, case.dt, case.steps[-1])
    places = np.array(case.steps)
    q, L = np.asarray(run.attitude)[places], np.asarray(run.momentum)[places]
    angle = np.where(np.isfinite(q).all(axis=-1), np.asarray(rotation.angle_between(q, case.attitudes)), np.inf)
    off = np.linalg.norm(L - case.momenta, axis=-1) / np.linalg.norm(case.momenta, axis=-1)
    off = np.where(np.isfinite(off), off, np.inf)
    lost = case.attitude_thresholds[order] >= 1.0
    passed = (angle <= case.attitude_thresholds[order]) | lost, off <= case.momentum_thresholds[order]
    return FixedStepErrors(case.name, angle, off, bool(np.all(passed)))
