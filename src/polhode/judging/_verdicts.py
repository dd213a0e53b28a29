"""Judges an engine by its own steps: order, drift, growth of errors, where spins end, and mistakes that explain it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from polhode import rotation
from polhode.judging._convergence import SEEN, Convergence, departures, judge_convergence
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
RADIANS = 3.0  # that short runs turn
SAMPLES = 12  # of them
MOST_HALVINGS = 6
CLEAR = 10.0  # times what a limit is unsure by: a limit so far from the exact motion will not come back
GIVEN = "the given start"
KEPT = 4000  # samples of a long run, at most
NEAR = 0.3  # rad between an axis and L where spins start, to see where they end


@dataclass(frozen=True, eq=False)
class Judgement:
    """What was found of one engine in one motion.

    Attributes:
        name: of the motion.
        run: states of the long run, up to the first that is not finite.
        dt: its step [s]; None where it is not known.
        right: whether the engine solves the equations of a free body; None where its states do not tell.
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
        length_change: by how much the quaternion's length is off 1 where it is most, with its sign; 0 where it stays.
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
    every = max(1, -(-steps // KEPT))
    count = -(-steps // every) * every
    starts = {GIVEN: momentum, **near_axes(engine.inertia, float(np.linalg.norm(momentum)))}
    whole = {name: engine.run(attitude, L, dt, count, every) for name, L in starts.items()}
    stops = {name: run.stop for name, run in whole.items() if run.stop is not None}
    runs = {name: run.finite_part() for name, run in whole.items()}
    ends = {name: find_spin_end(run) for name, run in runs.items()}
    unseen = find_unseen(engine.convention, engine.inertia, attitude, momentum, span * np.arange(SAMPLES + 1) / SAMPLES)
    run, right = runs[GIVEN], None if convergence.open and not explained else convergence.converges
    return Judgement(GIVEN, run, dt, right, convergence, tuple(explained), unseen, *measure(run), ends,
                     dict(runs), explained=next(iter(explained.values()), None), stops=stops,
                     length_change=find_length_change(run.lengths, run.eps))  # fmt: skip


def measure(run: EngineRun) -> tuple[Drift, Drift, Growth]:
    """Return the drifts of energy and |L|, and the growth of the attitude's error."""
    rounding = 4.0 * run.eps * np.sqrt(run.steps + 1.0) + 16.0 * run.eps + 2.0 * run.printed_unit
    with np.errstate(all="ignore"):
        energy, norm = (measure_drift(x, run.turned, rounding, run.periods) for x in (run.energy, run.momentum_norm))
        growth = measure_growth(run.angle, run.turned, run.eps * (16.0 + run.steps / 2.0) + 2.0 * run.printed_unit)
    return energy, norm, growth


def near_axes(inertia: Float64[Array, "3 3"], size: float) -> dict[str, Float64[Array, "3"]]:
    """Return momenta (3,) of a size, 0.3 rad from the axes of least and of largest moment, by what they are near to."""
    _, axes = np.linalg.eigh(inertia)
    off = NEAR * np.array([0.6, 0.8])
    along = {"near the axis of least moment": (np.cos(NEAR), *np.sin(NEAR) * off / NEAR),
             "near the axis of largest moment": (*np.sin(NEAR) * off / NEAR, np.cos(NEAR))}  # fmt: skip
    return {name: size * axes @ np.array(direction) for name, direction in along.items()}


def converge(
    engine: SteppedEngine, attitude: Float64[Array, "4"], momentum: Float64[Array, "3"], dt: float, span: float,
    equations: EngineEquations | None = None, most: int = MOST_HALVINGS,
) -> Convergence:
    """Return whether the engine converges, to the exact motion or to what wrong equations give.

    Steps are halved from ``dt`` until it does, ``most`` times at most.
    """  # fmt: skip
    times = span * np.arange(SAMPLES + 1) / SAMPLES
    motion = exact_motion(engine.inertia, attitude, momentum)
    if equations is None:
        exact = np.asarray(motion.attitude(times)), np.asarray(motion.momentum(times))
    else:
        exact = equations.solve(engine.inertia, attitude, momentum, times)
    turned = float(turned_angle(motion, times)[-1])
    levels, floors = [], []
    found = Convergence(False, None, (), None, np.inf)
    for halvings in range(most + 1):
        every = round(span / SAMPLES / dt) * 2**halvings
        run = engine.run(attitude, momentum, span / (SAMPLES * every), SAMPLES * every, every)
        with np.errstate(all="ignore"):
            levels.append(departures(run.attitude, run.momentum, *exact)[1:])
        # rounding of each step adds up, at worst in one direction; equations are solved to 1e-11
        floors.append(run.eps * (16.0 + run.steps / 2.0) + (0.0 if equations is None else 1e-10))
        found = judge_convergence(levels, floors, turned)
        known = found.unsure <= SEEN * max(turned, 1.0)
        if found.converges or (known and (found.limit or 0.0) > CLEAR * found.unsure):
            break
    return found


def find_mistakes(
    engine: SteppedEngine, attitude: Float64[Array, "4"], momentum: Float64[Array, "3"], dt: float, span: float
) -> dict[str, Convergence]:
    """Return the mistakes of which any one explains all that the engine does: how it converges with each.

    A pair of mistakes is looked for only where no single one is enough.
    """
    conventions = list_convention_mistakes(engine.convention)
    pairs = {name: other for name, other in conventions.items() if " and " in name}
    single = {name: other for name, other in conventions.items() if name not in pairs}
    damping = _measure_damping(engine, attitude, momentum, dt, span)

    def explain(others: Mapping[str, StateConvention | EngineEquations]) -> dict[str, Convergence]:
        found = {}
        for name, other in others.items():
            by_convention = isinstance(other, StateConvention)
            meant = replace(engine, convention=other) if by_convention else engine
            try:
                found[name] = converge(meant, attitude, momentum, dt, span, None if by_convention else other)
            except Exception:  # an engine may refuse, in any way, states in a convention that is not its own
                continue
        return {name: one for name, one in found.items() if one.converges}

    equations = list_equation_mistakes(engine.convention.variable, attitude, damping)
    return explain({**single, **equations}) or explain(pairs)


def find_unseen(
    convention: StateConvention, inertia: Float64[Array, "3 3"], attitude: Float64[Array, "4"],
    momentum: Float64[Array, "3"], times: Float64[Array, "time"],
) -> tuple[str, ...]:
    """Return the mistakes that would leave the states of this motion as they are, so that it cannot show them."""
    motion = exact_motion(inertia, attitude, momentum, float(times[0]))
    exact = np.asarray(motion.attitude(times)), np.asarray(motion.momentum(times))
    bound = SEEN * max(1.0, float(turned_angle(motion, times)[-1]))
    found = []
    for name, other in list_convention_mistakes(convention).items():
        if " and " not in name:
            states = other.decode(*convention.encode(*exact, inertia), inertia)
            if np.abs(departures(*states, *exact)).max() <= bound:
                found.append(name)
    for name, equations in list_equation_mistakes(convention.variable, attitude).items():
        if np.abs(departures(*equations.solve(inertia, attitude, momentum, times), *exact)).max() <= bound:
            found.append(name)
    return tuple(found)


def _measure_damping(
    engine: SteppedEngine, attitude: Float64[Array, "4"], momentum: Float64[Array, "3"], dt: float, span: float
) -> float:
    """Return the rate at which |L| decays in the limit of short steps [1/s], 0 where it does not."""
    rates: list[Any] = []
    for halvings in (3, 4, 5):
        every = round(span / SAMPLES / dt) * 2**halvings
        run = engine.run(attitude, momentum, span / (SAMPLES * every), SAMPLES * every, every)
        with np.errstate(all="ignore"):
            rates.append(-np.log(run.momentum_norm[-1] / run.momentum_norm[0]) / span)
    # errors of the first order in the step, of which the limit is free
    limit, earlier = 2.0 * rates[2] - rates[1], 2.0 * rates[1] - rates[0]
    return float(limit) if np.isfinite(limit) and abs(limit) > 4.0 * abs(limit - earlier) + 1e-6 / span else 0.0


def _short_span(
    inertia: Float64[Array, "3 3"], attitude: Float64[Array, "4"], momentum: Float64[Array, "3"], dt: float
) -> float:
    """Return a time in which the body turns by some radians, so many whole steps [s]."""
    rate = float(np.linalg.norm(np.linalg.solve(inertia, momentum)))
    return SAMPLES * dt * max(1, round(RADIANS / rate / dt / SAMPLES))


def default_start(inertia: Float64[Array, "3 3"]) -> tuple[Float64[Array, "4"], Float64[Array, "3"]]:
    """Return attitude (4,) and momentum (3,, body axes) for a body: near no axis, a radian a second."""
    _, axes = np.linalg.eigh(inertia)
    direction = axes @ START
    rate = float(np.linalg.norm(np.linalg.solve(inertia, direction)))
    return np.asarray(rotation.normalize(TURN)), direction / rate
