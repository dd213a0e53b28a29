"""Judges an engine by states that it wrote: with one step size cautiously, with three of one motion by their limit."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from itertools import pairwise
from typing import NamedTuple, TypeVar

import numpy as np

from polhode.errors import InvalidInput, NotConverged
from polhode.judging._convergence import LIMITS as CONVERGENCE
from polhode.judging._convergence import Convergence, departures, judge_convergence
from polhode.judging._mistakes import (
    EngineEquations,
    StateConvention,
    list_convention_mistakes,
    list_equation_mistakes,
)
from polhode.judging._run import EngineRun, exact_motion, find_spin_end, turned_angle
from polhode.judging._state_files import WrittenStates
from polhode.judging._stepping import find_eps, find_length_change, find_printed_unit
from polhode.judging._verdicts import GIVEN, Judgement, find_unseen, measure
from polhode.types import Array, Float64

States = tuple[Array, Array]
Left = TypeVar("Left", Convergence, float)


class StatesThresholds(NamedTuple):
    """Numbers that decide on states in a file.

    Attributes:
        max_angle: rad of rotation, up to which states are compared; later ones amplify any error.
        min_states: within that angle.
        min_residual_ratio: the residual without a mistake over that with it, for a mistake to be the explanation.
        start_tolerance: of the largest number; starts that differ by less are of one motion.
        step_ratio_tolerance: by which two steps may miss a ratio of 2.
        time_tolerance: of the shortest step, by which times of two runs may differ.
        first_order_error: rad per radian of rotation and per radian of a step, that a method of order 1 may have.
        max_slack: rad per radian of rotation, that no step explains, however long.
        min_decay: of ln |L|; less is no damping.
    """

    max_angle: float = 10.0
    min_states: int = 4
    min_residual_ratio: float = 100.0
    start_tolerance: float = 1e-12
    step_ratio_tolerance: float = 1e-6
    time_tolerance: float = 1e-6
    first_order_error: float = 1.0
    max_slack: float = 0.02
    min_decay: float = 1e-3


LIMITS = StatesThresholds()


def judge_states(states: Sequence[WrittenStates]) -> tuple[list[Judgement], list[tuple[str, str]]]:
    """Return the judgement on each run, one on all where three or more halve their steps; and the refused runs.

    Args:
        states: of the runs, in any order.
    """
    groups: list[list[WrittenStates]] = []
    for one in states:
        group = next((group for group in groups if _are_of_one_motion(group[0], one)), None)
        if group is None:
            groups.append(group := [])
        group.append(one)
    judged: list[Judgement] = []
    refused = []
    for number, group in enumerate(groups):
        halved = _by_halved_steps(group)
        halved = halved if len(halved) >= 3 else []
        for one in halved[:1] or group:
            try:
                judgement = _judge_one(one, halved)
            except InvalidInput as error:
                refused += [(run.label, str(error)) for run in halved or [one]]
                continue
            alone = len(group) == 1 or halved
            judged.append(replace(judgement, name=judgement.name if alone else one.label, motion=number))
    return judged, refused


def _are_of_one_motion(one: WrittenStates, other: WrittenStates) -> bool:
    """Whether runs have equal starts up to rounding in files, whatever their names."""
    if one.convention != other.convention:
        return False
    pairs = ((getattr(run.given, name) for run in (one, other)) for name in ("inertia", "attitude", "momentum"))
    return all(np.abs(a - b).max() <= LIMITS.start_tolerance * np.abs(a).max() for a, b in pairs)


def _by_halved_steps(group: Sequence[WrittenStates]) -> list[WrittenStates]:
    """Return runs from the longest step to the shortest, where each has half the step of the one before."""
    ordered = sorted((one for one in group if one.dt is not None), key=lambda one: -(one.dt or 0.0))
    off = [abs((a.dt or 0.0) / (b.dt or 1.0) - 2.0) for a, b in pairwise(ordered)]
    return ordered if all(one < LIMITS.step_ratio_tolerance for one in off) else []


def _judge_one(one: WrittenStates, halved: Sequence[WrittenStates]) -> Judgement:
    """Judge by the start as declared; where that is not right, with mistakes of convention in the start, too.

    These are tried before mistakes in equations, which take long to solve for a start in degrees.
    """
    judgement, refusal = None, None
    try:
        judgement = _judge_as_read(one, halved, search=not one.given.variable)
    except InvalidInput as error:
        refusal = error
    if one.given.variable and not (judgement and judgement.right):
        judgement = _judge_with_start(one, halved, judgement) or (judgement and _judge_as_read(one, halved))
    if judgement is None:
        assert refusal is not None
        raise refusal
    return judgement


def _judge_with_start(
    one: WrittenStates, halved: Sequence[WrittenStates], plain: Judgement | None
) -> Judgement | None:
    """Return the judgement with the first mistakes of convention that explain states and start; None without any."""
    bound = plain.residual / LIMITS.min_residual_ratio if plain is not None and plain.residual else np.inf
    conventions = list_convention_mistakes(one.convention)
    for pairs in (False, True):
        explained: dict[str, Judgement] = {}
        for name, other in conventions.items():
            if (" and " in name) != pairs:
                continue
            read = [replace(run, given=run.given.read_by(other, one.convention), convention=other)
                    for run in halved or [one]]
            try:
                judgement = _judge_as_read(read[0], read if halved else (), search=False)
            except (InvalidInput, NotConverged):
                continue
            if judgement.right or (judgement.residual or np.inf) <= min(judgement.allowed or 0.0, bound):
                explained[f"{name}, in the start too"] = judgement
        if explained:
            judgement = next(iter(explained.values()))
            left = judgement.residual if judgement.convergence is None else judgement.convergence
            whole = {} if plain is None else {"residual": plain.residual, "allowed": plain.allowed}
            return replace(plain or judgement, right=False, mistakes=tuple(explained), explained=left, **whole)
    return None


def _judge_as_read(one: WrittenStates, halved: Sequence[WrittenStates], search: bool = True) -> Judgement:
    """Judge states and start as declared and, if asked, search for mistakes in the states alone that explain them."""
    given, run = one.given, as_run(one, one.convention)
    short = _short_part(run)
    if halved:
        common = _common_times(halved, float(run.times[short]))
        limit = _converge(halved, common, None, lambda given: given.convention)

        def explain(convention: StateConvention | None, equations: EngineEquations | None) -> Convergence | None:
            left = _converge(halved, common, equations, lambda given: convention or given.convention)
            return left if left.converges else None

        explained = _find(one, explain) if search and not limit.converges else {}
        right = None if limit.open and not explained else limit.converges
        verdict = {"right": right, "convergence": limit, **_mistake_fields(explained)}
    else:
        verdict = _judge_by_one_step(one, run, short, search)
    times = np.concatenate([[0.0], run.times[1 : short + 1]])
    unseen = find_unseen(one.convention, given.inertia, given.attitude, given.momentum, times)
    energy, norm, growth = measure(run)
    return Judgement(given.name, run, one.dt, unseen=unseen, energy=energy, momentum=norm, growth=growth,
                     ends={GIVEN: find_spin_end(run)}, length_change=_length_change(halved or [one]),
                     **verdict)  # type: ignore[arg-type]


def _mistake_fields(explained: Mapping[str, Convergence | float]) -> dict[str, object]:
    """Return the fields of a judgement for the mistakes: their names, and the residual with the first of them."""
    return {"mistakes": tuple(explained), "explained": next(iter(explained.values()), None)}


def _length_change(states: Sequence[WrittenStates]) -> float:
    """Return the largest change of length of the quaternions over all runs."""
    changes = [find_length_change(np.linalg.norm(one.quaternions, axis=-1),
                                  max(find_eps(one.quaternions), find_printed_unit(one.quaternions)))
               for one in states]
    return max(changes, key=abs)


def as_run(one: WrittenStates, convention: StateConvention) -> EngineRun:
    """Return the exact start and the states, decoded by a convention."""
    q, L = convention.decode(one.quaternions, one.rates, one.given.inertia)
    steps = len(one.times) if one.dt is None else max(1, round(float(one.times[-1]) / one.dt))
    return EngineRun(one.given.inertia, np.concatenate([[0.0], one.times]), np.vstack([one.given.attitude, q]),
                     np.vstack([one.given.momentum, L]), find_eps(one.quaternions, one.rates), steps,
                     one.printed_unit)


def _short_part(run: EngineRun) -> int:
    """Return the index of the last state that is compared."""
    last = int(np.searchsorted(run.turned, LIMITS.max_angle, side="right")) - 1
    if last < LIMITS.min_states:
        within = run.times[-1] * LIMITS.max_angle / max(float(run.turned[-1]), 1e-300)
        raise InvalidInput(f"`times` must have {LIMITS.min_states} or more within the first {LIMITS.max_angle:g} rad, "
                           f"here {within:.4g} s; got {last}. Write states more often.")
    return last


def _judge_by_one_step(one: WrittenStates, run: EngineRun, short: int, search: bool) -> dict[str, object]:
    part = slice(1, short + 1)
    rate = float(run.turned[short] / run.times[short])
    steps = short if one.dt is None else float(run.times[short]) / one.dt
    rounding = run.eps * (16.0 + steps / 2.0) + 2.0 * run.printed_unit
    slack = CONVERGENCE.max_uncertainty
    if one.dt is not None:
        slack = min(LIMITS.max_slack, LIMITS.first_order_error * one.dt * rate)
    allowed = max(rounding, slack * float(run.turned[short]))

    def residual(convention: StateConvention | None, equations: EngineEquations | None) -> float:
        read = run if convention is None else as_run(one, convention)
        exact = _exact(one, run.times, equations)
        return float(np.abs(departures(read.attitude[part], read.momentum[part], *(x[part] for x in exact))).max())

    plain = residual(None, None)
    if not plain > rounding:
        return {"right": True, "convergence": None, "mistakes": (), "residual": plain, "allowed": allowed}
    bound = min(allowed, plain / LIMITS.min_residual_ratio)

    def explain(convention: StateConvention | None, equations: EngineEquations | None) -> float | None:
        left = residual(convention, equations)
        return left if left <= bound else None

    explained = _find(one, explain, _measure_damping(run, short)) if search else {}
    right = False if explained or not plain <= allowed else None
    return {"right": right, "convergence": None, "residual": plain, "allowed": allowed, **_mistake_fields(explained)}


def _exact(one: WrittenStates, times: Float64[Array, "time"], equations: EngineEquations | None) -> States:
    given = one.given
    if equations is not None:
        return equations.solve(given.inertia, given.attitude, given.momentum, times)
    motion = exact_motion(given.inertia, given.attitude, given.momentum)
    return np.asarray(motion.attitude(times)), np.asarray(motion.momentum(times))


def _find(
    one: WrittenStates, explain: Callable[[StateConvention | None, EngineEquations | None], Left | None],
    damping: float = 0.0,
) -> dict[str, Left]:
    """Return the mistakes that explain the states, with their residuals; pairs are tried where no single one does."""
    conventions, of_equations = list_convention_mistakes(one.convention), (
        one.convention.variable, one.given.attitude, damping)  # fmt: skip
    single: list[tuple[str, StateConvention | None, EngineEquations | None]]
    single = [(name, other, None) for name, other in conventions.items() if " and " not in name]
    single += [(name, None, other) for name, other in list_equation_mistakes(*of_equations).items()]
    pairs = [(name, other, None) for name, other in conventions.items() if " and " in name]
    for tried in (single, pairs):
        explained = {}
        for name, convention, equations in tried:
            try:
                left = explain(convention, equations)
            except NotConverged:
                continue
            if left is not None:
                explained[name] = left
        if explained:
            return explained
    return {}


def _measure_damping(run: EngineRun, short: int) -> float:
    with np.errstate(all="ignore"):
        decay = np.log(run.momentum_norm[: short + 1] / run.momentum_norm[0])
    rate = float(np.polyfit(run.times[: short + 1], decay, 1)[0]) if np.isfinite(decay).all() else 0.0
    return -rate if abs(rate) * float(run.times[short]) > LIMITS.min_decay else 0.0


def _common_times(halved: Sequence[WrittenStates], last: float) -> Float64[Array, "time"]:
    """Return the times that all runs share, to a millionth of the shortest step."""
    times = halved[0].times[halved[0].times <= last * (1.0 + 1e-9)]
    for one in halved[1:]:
        near = np.abs(one.times[_nearest(one.times, times)] - times)
        times = times[near <= LIMITS.time_tolerance * (halved[-1].dt or 1.0)]
    if len(times) < LIMITS.min_states:
        raise InvalidInput(f"runs with dt, dt/2, dt/4 must have {LIMITS.min_states} times in common within "
                           f"{LIMITS.max_angle:g} rad; got {len(times)}. Write the same times in each.")
    return times


def _nearest(rising: Float64[Array, "samples"], wanted: Float64[Array, "time"]) -> Array:
    right = np.clip(np.searchsorted(rising, wanted), 1, len(rising) - 1)
    return np.where(wanted - rising[right - 1] < rising[right] - wanted, right - 1, right)


def _converge(
    halved: Sequence[WrittenStates], times: Float64[Array, "time"], equations: EngineEquations | None,
    convention: Callable[[WrittenStates], StateConvention],
) -> Convergence:
    from_start = np.concatenate([[0.0], times])
    exact = [x[1:] for x in _exact(halved[0], from_start, equations)]
    motion = exact_motion(halved[0].given.inertia, halved[0].given.attitude, halved[0].given.momentum)
    levels, floors = [], []
    for one in halved:
        run = as_run(one, convention(one))
        kept = _nearest(run.times, times)
        levels.append(departures(run.attitude[kept], run.momentum[kept], *exact))
        steps = float(times[-1]) / (one.dt or 1.0)
        floors.append(run.eps * (16.0 + steps / 2.0) + run.printed_unit + (0.0 if equations is None else 1e-10))
    return judge_convergence(levels, floors, float(turned_angle(motion, from_start)[-1]))
