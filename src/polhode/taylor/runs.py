"""Motions by Taylor series: one copy after the other, from stretch to stretch between jumps."""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable
from typing import NamedTuple

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np

from polhode.motion.outcome import Status
from polhode.systems.base import AbstractSystem, Event
from polhode.taylor import kernel
from polhode.taylor.kernels import chosen_kernel
from polhode.taylor.machine import Machine, machine_of
from polhode.types import Array, Double, Float64, Integer

ORDER, LOCAL = 24, 1e-19  # to rounding: of an order at which errors of single steps do not add up with one sign
LOOSEST_ORDER = 8
MOST_STEPS = 15_000_000
FIRST_HITS = 256  # crossings that there is room for at first


class Precision(NamedTuple):
    """How far a step reaches.

    Attributes:
        order: of the series.
        reach: of a step, in radii of convergence.
    """

    order: int
    reach: float


def precision_of(tolerance: float | None, order: int | None = None) -> Precision:
    """Return order and reach of steps whose error is a tolerance of the state's size; to rounding if it is None.

    Source: Jorba & Zou, Exp. Math. 14 (2005) 99, §3.1 for the order, §3.2 for the reach.
    """
    local = LOCAL if tolerance is None else tolerance
    if order is None:
        order = ORDER if tolerance is None else max(LOOSEST_ORDER, math.ceil(1.0 - 0.5 * math.log(local)))
    return Precision(order, local ** (1.0 / order) * math.exp(-0.7 / (order - 1)))


class Runs(NamedTuple):
    """What came out for each of C copies.

    Attributes:
        states: (C, T, *shape) samples; infinite after the end.
        received: (C, T, B) what balances received.
        status: (C,) numbers of ``Status``.
        event: (C,) which event ended it, −1 where none did.
        end: (C,) [s] the event's own time, or the last; NaN where steps shrank to nothing.
        end_state: (C, *shape) the state then.
        end_received: (C, B) what balances received until then.
        steps: (C,) how many were taken.
        balances: their names.
    """

    states: Double[Array, "..."]
    received: Float64[Array, "copies time balances"]
    status: Integer[Array, "copies"]
    event: Integer[Array, "copies"]
    end: Float64[Array, "copies"]
    end_state: Double[Array, "..."]
    end_received: Float64[Array, "copies balances"]
    steps: Integer[Array, "copies"]
    balances: tuple[str, ...]


class Plan(NamedTuple):
    """What is common to all copies: where steps must end, the machine up to there, and how far steps reach."""

    borders: list[float]
    machines: list[Machine]
    times: Float64[np.ndarray, "later"]
    precision: Precision
    longest: float
    forth: float


def _planned(
    system: AbstractSystem, state: Array, times: np.ndarray, precision: Precision, longest: float,
    through: Event | None = None,
) -> Plan:  # fmt: skip
    forth = 1.0 if times[-1] > times[0] else -1.0
    borders = _borders(system, times, forth)
    machines = [machine_of(system, state, between, through) for between in itertools.pairwise(borders)]
    return Plan(borders, machines, times[1:], precision, longest, forth)


def runs_of(
    system: AbstractSystem,
    states: Double[Array, "..."],
    times: Float64[np.ndarray, "time"],
    precision: Precision,
    longest: float = math.inf,
    check: Callable[[float], None] = lambda share: None,
    scales: Float64[Array, "copies n"] | None = None,
) -> Runs:
    """Return the motions of states at times, which need not be ends of steps.

    Args:
        system: what moves.
        states: (C, *shape).
        times: (T,) [s], in one direction.
        precision: of the steps.
        longest: step [s].
        check: called with the share that is done, between parts of a long run.
        scales: sizes of the components, infinite of those that shorten no step; by default the system's.

    Raises:
        Untraceable: if the system's rates are not made of operations that have a recurrence.
    """
    plan = _planned(system, states[0], times, precision, longest)
    form, program = plan.machines[0].form, plan.machines[0].program
    y = np.zeros((len(states), program.size))
    y[:, : form.size] = form.flat(states)
    if scales is None:
        scale = _scales(system, states, times[0], plan.machines[0], program.size)
    else:
        scale = np.full((len(states), program.size), np.inf)
        scale[:, : form.size] = scales
    samples = np.full((len(states), len(times), program.size), np.inf)
    samples[:, 0] = y  # without the time, which no state has
    found = []
    for k in range(len(states)):
        given = y[k], scale[k], samples[k, 1:], lambda part, k=k: check((k + part) / len(states))
        found.append(_one(plan, *given, times[0], np.zeros((1, 2 + program.size)))[:4])
    status, event, end, steps = (np.array(column) for column in zip(*found, strict=True))
    balances = plan.machines[0].balances
    extra = slice(form.size, form.size + len(balances))
    received = samples[..., extra], y[:, extra].copy()
    return Runs(form.back(samples), received[0], status, event, end, form.back(y), received[1], steps, balances)


class Crossings(NamedTuple):
    """Where a motion goes through the zeros of a function.

    Attributes:
        times: (K,) [s].
        states: (K, *shape).
        status: one of ``Status``: of the run, which may have ended before all were found.
        event: which of the system's events ended it, or −1.
        end: [s] up to when crossings were sought.
    """

    times: Float64[Array, "crossings"]
    states: Double[Array, "..."]
    status: int
    event: int
    end: float


def crossings_of(
    system: AbstractSystem,
    state: Double[Array, "..."],
    through: Event,
    times: Float64[np.ndarray, "2"],
    precision: Precision,
    most: int,
    falling: bool,
    check: Callable[[float], None] = lambda share: None,
) -> Crossings:
    """Return where the motion of one state goes through the zeros of a function of time and state.

    Args:
        system: what moves.
        state: one.
        through: the function, written with JAX.
        times: first and last [s].
        precision: of the steps.
        most: how many crossings end the search.
        falling: whether only those from positive to negative count, in the direction of the motion.
        check: called between parts of a long run.

    Raises:
        Untraceable: if rates, events or the function are not made of operations that have a recurrence.
    """
    plan = _planned(system, state, times, precision, math.inf, through)
    form, size = plan.machines[0].form, plan.machines[0].program.size
    y = np.zeros(size)
    y[: form.size] = form.flat(state)
    scale = _scales(system, np.asarray(state)[None], times[0], plan.machines[0], size)[0]
    hits = np.zeros((min(most, FIRST_HITS), 2 + size))
    watch = Watch(falling, most)
    status, event, end, _, hits = _one(plan, y, scale, np.full((1, size), np.inf), check, times[0], hits, watch)
    found = hits[hits[:, 1] == len(system.events)][:most]
    return Crossings(found[:, 0], form.back(found[:, 2:]), status, event, end)


class Watch(NamedTuple):
    """What is watched beside the system's events."""

    falling: bool
    most: int


def _one(
    plan: Plan, y: Array, scale: Array, samples: Array, check: Callable[[float], None], first: float, hits: Array,
    watch: Watch | None = None,
) -> tuple[int, int, float, int, Array]:  # fmt: skip
    """Move one copy, and return its status, event, end, number of steps, and what was crossed (H, 2 + n)."""
    now, counts = np.array([first, 0.0, 1.0]), np.array([0, 0, 0, 0, -1])
    wanted = _conserved_values(plan.machines[0], y)
    status = kernel.DONE
    for machine, end in zip(plan.machines, plan.borders[1:], strict=True):
        if machine.clock >= 0:
            y[machine.clock] = now[0]
        given = machine, y, scale, wanted, end, samples, now, counts
        status = _through(plan, *given, hits, check, watch)
        while status == kernel.FULL and watch is not None and counts[3] < watch.most:
            hits = np.concatenate([hits, np.zeros_like(hits)])
            status = _through(plan, *given, hits, check, watch)
        if status != kernel.DONE:
            break
    steps, crossed = int(counts[0]), hits[: counts[3]]
    if status == kernel.STOPPED:
        return Status.EVENT, int(crossed[-1, 1]), float(now[0]), steps, crossed
    if status in (kernel.DONE, kernel.FULL):
        return Status.COMPLETED, -1, float(now[0]), steps, crossed
    samples[counts[1] :] = np.inf
    return Status.NOT_CONVERGED, -1, math.nan, steps, crossed


def _through(
    plan: Plan, machine: Machine, y: Array, scale: Array, wanted: Array, end: float, samples: Array, now: Array,
    counts: Array, hits: Array, check: Callable[[float], None], watch: Watch | None,
) -> int:  # fmt: skip
    """Go on up to a jump, the last time or an event, or until there is no room for another crossing."""
    # the system's events fall from positive to zero, and end the motion
    falling = np.ones(len(machine.events) + (watch is not None), bool)
    stops = falling.copy()
    if watch is not None:
        falling[-1], stops[-1] = watch.falling, False
    counts[2] = 0
    first, last = plan.borders[0], plan.borders[-1]
    while True:
        use = chosen_kernel()
        with np.errstate(all="ignore"):
            status = use.advance(
                *machine.program, *machine.integrals, y, scale, wanted, np.array([end]), plan.times, samples, now,
                counts, hits, plan.precision.order, plan.precision.reach, plan.longest, plan.forth, machine.clock,
                falling, stops, use.stretch,
            )  # fmt: skip
        if status != kernel.RUNNING or counts[0] >= MOST_STEPS:
            return int(status)
        check(float((now[0] - first) / (last - first)))


def _borders(system: AbstractSystem, times: np.ndarray, forth: float) -> list[float]:
    jumps = np.ravel(np.asarray(system.jumps, float))
    inside = jumps[(forth * jumps > forth * times[0]) & (forth * jumps < forth * times[-1])]
    return [float(times[0]), *sorted({float(t) for t in inside}, key=lambda t: forth * t), float(times[-1])]


def _scales(system: AbstractSystem, states: Array, t: float, machine: Machine, size: int) -> Float64[Array, "copies n"]:
    """Return the sizes by which components are compared; infinite of the time, which never limits a step."""
    form = machine.form
    own, values = _sizes(system, jnp.asarray(states), jnp.asarray(t))
    scale = np.full((len(states), size), np.inf)
    own = np.broadcast_to(own.reshape(len(states), -1), (len(states), int(np.prod(form.shape))))
    scale[:, : form.size] = np.repeat(own, 2, axis=1) if form.is_complex else own
    for k, name in enumerate(machine.balances):
        value = np.abs(np.asarray(values[name]))
        scale[:, form.size + k] = np.where(value > 0.0, value, 1.0)
    return scale


@eqx.filter_jit
def _sizes(system: AbstractSystem, states: Array, t: Array) -> tuple[Array, dict[str, Array]]:
    """Return scales (C, *shape) and values (C,) of balances at states (C, *shape)."""

    def one(state: Array) -> tuple[Array, dict[str, Array]]:
        own = jnp.broadcast_to(system.scales(state), jnp.shape(state))
        return own, {name: balance.value for name, balance in system.balances(t, state).items()}

    own, values = jax.vmap(one)(states)
    return jnp.real(own), values


def _conserved_values(machine: Machine, y: Array) -> Float64[Array, "conserved"]:
    """Return what is conserved at a start, computed as the kernel does."""
    program = machine.integrals
    if not machine.names:
        return np.zeros(0)
    z, blank = np.zeros(program.slots + 8), np.zeros(program.products + 8)
    z[: machine.form.size] = y[: machine.form.size]
    with np.errstate(all="ignore"):
        values = chosen_kernel().values_at(*program, z, blank, blank.copy(), len(machine.names))
    return np.where(np.isfinite(values), values, 0.0)
