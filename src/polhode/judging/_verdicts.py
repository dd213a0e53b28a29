"""Judges an engine by its own steps: order, drift, growth of errors, where spins end, and mistakes that explain it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Any, NamedTuple

import numpy as np

from polhode import rotation
from polhode.judging._convergence import LIMITS as CONVERGENCE
from polhode.judging._convergence import Convergence, departures, judge_convergence
from polhode.judging._mistakes import (
    EngineEquations,
    StateConvention,
    list_convention_mistakes,
    list_equation_mistakes,
)
from polhode.judging._run import (
    Drift,
    EngineRun,
    Growth,
    SpinEnd,
    exact_motion,
    find_spin_end,
    measure_drift,
    measure_growth,
    turned_angle,
)
from polhode.judging._stepping import SteppedEngine, Stop, find_length_change
from polhode.types import Array, Float64

START = np.array([0.8, -0.5, 0.3]) / np.sqrt(0.98)
"""Direction of L along the principal axes that is near none of them."""
TURN = np.array([0.1, -0.7, 0.5, 0.5])
GIVEN = "the given start"


class VerdictThresholds(NamedTuple):
    """Numbers that decide how long an engine is run before its verdict.

    Attributes:
        short_run: rad, through which the body rotates in a short run: enough for each mistake to show, and before
            errors of an unstable motion grow.
        short_run_samples: times of a short run at which states are compared.
        max_halvings: of the step.
        clear_distance: times the uncertainty of a limit; one so far from the exact motion will not come back to it.
        max_samples: of a long run.
        start_from_axis: rad between an axis and L, at the start of the long runs that show where spins end.
    """

    short_run: float = 3.0
    short_run_samples: int = 12
    max_halvings: int = 6
    clear_distance: float = 10.0
    max_samples: int = 4000
    start_from_axis: float = 0.3


LIMITS = VerdictThresholds()


@dataclass(frozen=True, eq=False)
class Judgement:
    """The judgement of one engine in one motion.

    Attributes:
        name: of the motion.
        run: states of the long run, up to the first that is not finite.
        dt: its step [s]; None where it is not known.
        right: whether the engine solves the equations of a free body; None where its states do not decide it.
        convergence: what halved steps showed; None where the engine gave only one step.
        mistakes: each, in words, makes the engine right; empty for a right engine and for an unexplained one.
        unseen: mistakes that this motion cannot show.
        energy, momentum: drift of E and |L|.
        growth: of the attitude's error.
        ends: where spins go, by where they begin.
        runs: the long runs, by the same.
        residual, allowed: of a judgement by one step, the largest departure and what the step explains.
        explained: with the first of the mistakes, what halved steps show, or by one step the largest departure.
        stops: where long runs no longer give states, by where they begin; empty where all do to the end.
        length_change: largest deviation of the quaternion's length from 1, with its sign; 0 within tolerance.
        motion: which of the motions of the report, counted from 0; some runs of one motion are judged singly.
    """

    name: str
    run: EngineRun
    dt: float | None
    right: bool | None
    convergence: Convergence | None
    mistakes: tuple[str, ...]
    unseen: tuple[str, ...]
    energy: Drift
    momentum: Drift
    growth: Growth
    ends: dict[str, SpinEnd] = field(default_factory=dict)
    runs: dict[str, EngineRun] = field(default_factory=dict)
    residual: float | None = None
    allowed: float | None = None
    explained: Convergence | float | None = None
    stops: dict[str, Stop] = field(default_factory=dict)
    length_change: float = 0.0
    motion: int = 0

    @property
    def stop(self) -> tuple[Stop, str] | None:
        """Where the first of the long runs that do so no longer gives states, and where it begins; None without one."""
        return next(((stop, name) for name, stop in self.stops.items()), None)


def judge_engine(
    engine: SteppedEngine, attitude: Float64[Array, "4"], momentum: Float64[Array, "3"], dt: float, steps: int
) -> Judgement:
    """Return the judgement on a step function.

    Args:
        engine: the function with its body and convention.
        attitude: (4,) unit quaternion wxyz at the start, body → space.
        momentum: (3,) at the start [kg m²/s, body axes].
        dt: of the step to be judged [s]; shorter ones show the order.
        steps: of the long runs.
    """
    span = _short_span(engine.inertia, attitude, momentum, dt)
    convergence = converge(engine, attitude, momentum, dt, span)
    explained = {} if convergence.converges else find_mistakes(engine, attitude, momentum, dt, span)
    every = max(1, -(-steps // LIMITS.max_samples))
    count = -(-steps // every) * every
    starts = {GIVEN: momentum, **near_axes(engine.inertia, float(np.linalg.norm(momentum)))}
    whole = {name: engine.run(attitude, L, dt, count, every) for name, L in starts.items()}
    stops = {name: run.stop for name, run in whole.items() if run.stop is not None}
    runs = {name: run.finite_part() for name, run in whole.items()}
    ends = {name: find_spin_end(run) for name, run in runs.items()}
    unseen = find_unseen(engine.convention, engine.inertia, attitude, momentum, _short_times(span))
    run, right = runs[GIVEN], None if convergence.open and not explained else convergence.converges
    return Judgement(GIVEN, run, dt, right, convergence, tuple(explained), unseen, *measure(run), ends,
                     dict(runs), explained=next(iter(explained.values()), None), stops=stops,
                     length_change=find_length_change(run.lengths, run.eps))


def measure(run: EngineRun) -> tuple[Drift, Drift, Growth]:
    """Return the drifts of energy and |L|, and the growth of the attitude's error."""
    rounding = 4.0 * run.eps * np.sqrt(run.steps + 1.0) + 16.0 * run.eps + 2.0 * run.printed_unit
    with np.errstate(all="ignore"):
        energy, norm = (measure_drift(x, run.turned, rounding, run.periods) for x in (run.energy, run.momentum_norm))
        growth = measure_growth(run.angle, run.turned, run.eps * (16.0 + run.steps / 2.0) + 2.0 * run.printed_unit)
    return energy, norm, growth


def near_axes(inertia: Float64[Array, "3 3"], size: float) -> dict[str, Float64[Array, "3"]]:
    """Return momenta (3,) of a size, 0.3 rad from the axes of least and of largest moment, by name."""
    _, axes = np.linalg.eigh(inertia)
    tilt = LIMITS.start_from_axis
    off = tilt * np.array([0.6, 0.8])
    along = {"near the axis of least moment": (np.cos(tilt), *np.sin(tilt) * off / tilt),
             "near the axis of largest moment": (*np.sin(tilt) * off / tilt, np.cos(tilt))}  # fmt: skip
    return {name: size * axes @ np.array(direction) for name, direction in along.items()}


def converge(
    engine: SteppedEngine, attitude: Float64[Array, "4"], momentum: Float64[Array, "3"], dt: float, span: float,
    equations: EngineEquations | None = None, max_halvings: int = LIMITS.max_halvings,
) -> Convergence:
    """Return whether the engine converges, to the exact motion or to the solution of wrong equations.

    Steps are halved from ``dt`` until it does, or ``max_halvings`` times.
    """
    times, samples = _short_times(span), LIMITS.short_run_samples
    motion = exact_motion(engine.inertia, attitude, momentum)
    if equations is None:
        exact = np.asarray(motion.attitude(times)), np.asarray(motion.momentum(times))
    else:
        exact = equations.solve(engine.inertia, attitude, momentum, times)
    rotation_angle = float(turned_angle(motion, times)[-1])
    levels, floors = [], []
    result = Convergence(False, None, (), None, np.inf)
    for halvings in range(max_halvings + 1):
        every = round(span / samples / dt) * 2**halvings
        run = engine.run(attitude, momentum, span / (samples * every), samples * every, every)
        with np.errstate(all="ignore"):
            levels.append(departures(run.attitude, run.momentum, *exact)[1:])
        # rounding of each step adds up, at worst in one direction; equations are solved to 1e-11
        floors.append(run.eps * (16.0 + run.steps / 2.0) + (0.0 if equations is None else 1e-10))
        result = judge_convergence(levels, floors, rotation_angle)
        resolved = result.unsure <= CONVERGENCE.max_uncertainty * max(rotation_angle, 1.0)
        if result.converges or (resolved and (result.limit or 0.0) > LIMITS.clear_distance * result.unsure):
            break
    return result


def find_mistakes(
    engine: SteppedEngine, attitude: Float64[Array, "4"], momentum: Float64[Array, "3"], dt: float, span: float
) -> dict[str, Convergence]:
    """Return each mistake that alone explains the engine, and how the engine converges with it.

    Pairs of mistakes are tried only where no single one explains it.
    """
    conventions = list_convention_mistakes(engine.convention)
    pairs = {name: other for name, other in conventions.items() if " and " in name}
    single = {name: other for name, other in conventions.items() if name not in pairs}
    damping = _measure_damping(engine, attitude, momentum, dt, span)

    def explain(others: Mapping[str, StateConvention | EngineEquations]) -> dict[str, Convergence]:
        tried = {}
        for name, other in others.items():
            by_convention = isinstance(other, StateConvention)
            meant = replace(engine, convention=other) if by_convention else engine
            try:
                tried[name] = converge(meant, attitude, momentum, dt, span, None if by_convention else other)
            except Exception:  # an engine may refuse, in any way, states in a convention that is not its own
                continue
        return {name: one for name, one in tried.items() if one.converges}

    equations = list_equation_mistakes(engine.convention.variable, attitude, damping)
    return explain({**single, **equations}) or explain(pairs)


def find_unseen(
    convention: StateConvention, inertia: Float64[Array, "3 3"], attitude: Float64[Array, "4"],
    momentum: Float64[Array, "3"], times: Float64[Array, "time"],
) -> tuple[str, ...]:
    """Return the mistakes that do not change the states of this motion, so that it cannot show them."""
    motion = exact_motion(inertia, attitude, momentum, float(times[0]))
    exact = np.asarray(motion.attitude(times)), np.asarray(motion.momentum(times))
    bound = CONVERGENCE.max_uncertainty * max(1.0, float(turned_angle(motion, times)[-1]))
    hidden = []
    for name, other in list_convention_mistakes(convention).items():
        if " and " not in name:
            states = other.decode(*convention.encode(*exact, inertia), inertia)
            if np.abs(departures(*states, *exact)).max() <= bound:
                hidden.append(name)
    for name, equations in list_equation_mistakes(convention.variable, attitude).items():
        if np.abs(departures(*equations.solve(inertia, attitude, momentum, times), *exact)).max() <= bound:
            hidden.append(name)
    return tuple(hidden)


def _measure_damping(
    engine: SteppedEngine, attitude: Float64[Array, "4"], momentum: Float64[Array, "3"], dt: float, span: float
) -> float:
    """Return the rate at which |L| decays in the limit of short steps [1/s], 0 where it does not."""
    rates: list[Any] = []
    samples = LIMITS.short_run_samples
    for halvings in (3, 4, 5):
        every = round(span / samples / dt) * 2**halvings
        run = engine.run(attitude, momentum, span / (samples * every), samples * every, every)
        with np.errstate(all="ignore"):
            rates.append(-np.log(run.momentum_norm[-1] / run.momentum_norm[0]) / span)
    # extrapolated, as the errors are of first order in the step
    limit, earlier = 2.0 * rates[2] - rates[1], 2.0 * rates[1] - rates[0]
    return float(limit) if np.isfinite(limit) and abs(limit) > 4.0 * abs(limit - earlier) + 1e-6 / span else 0.0


def _short_span(
    inertia: Float64[Array, "3 3"], attitude: Float64[Array, "4"], momentum: Float64[Array, "3"], dt: float
) -> float:
    """Return the time of a short run, a whole number of steps between samples [s]."""
    rate, samples = float(np.linalg.norm(np.linalg.solve(inertia, momentum))), LIMITS.short_run_samples
    return samples * dt * max(1, round(LIMITS.short_run / rate / dt / samples))


def _short_times(span: float) -> Float64[Array, "time"]:
    return span * np.arange(LIMITS.short_run_samples + 1) / LIMITS.short_run_samples


def default_start(inertia: Float64[Array, "3 3"]) -> tuple[Float64[Array, "4"], Float64[Array, "3"]]:
    """Return attitude (4,) and momentum (3,, body axes) for a body: far from each axis, at one radian per second."""
    _, axes = np.linalg.eigh(inertia)
    direction = axes @ START
    rate = float(np.linalg.norm(np.linalg.solve(inertia, direction)))
    return np.asarray(rotation.normalize(TURN)), direction / rate
