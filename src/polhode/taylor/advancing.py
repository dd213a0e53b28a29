"""Advances copies of a batch by a kernel from one jump of a system to the next."""

from __future__ import annotations

import math
import time
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from polhode._base.compiled.threads import in_threads
from polhode.motion._outcome import Status
from polhode.taylor import kernel
from polhode.taylor.kernel_extended import ORDERS_IN_PAIRS
from polhode.taylor.kernel_space import EVENT, NEXT, STEPS, TIME, Copies, Course, exact_for, lanes_for, series_for
from polhode.taylor.kernels import Kernel, choose_kernel, note, note_rest, write_code
from polhode.taylor.machine import Machine
from polhode.types import Array, Float64, Integer


class AdvancingLimits(NamedTuple):
    """Bounds of a run, and when threads pay off."""

    max_steps: int = 1_000_000_000  # of a run, about an hour
    relative_rounding: float = 1.1e-16  # of the change that one of the state by its own size makes: not put back
    min_copies_of_thread: int = 64


LIMITS = AdvancingLimits()


def begin_copies(
    machine: Machine, y: Float64[Array, "copies n"], scale: Float64[Array, "copies n"],
    samples: Float64[Array, "copies time n"], first: float, hits: int,
    others: Float64[Array, "copies companions n"] | None = None,
) -> Copies:
    """Return copies at a first time, which is that of the first sample, with room for so many events each.

    Args:
        machine: that moves them.
        y, scale: their states and the sizes of these.
        samples: room for samples.
        first: time [s].
        hits: how many events there is room for.
        others: states of companions; none for None.
    """
    copies, n = y.shape
    now, counts = np.tile([first, 0.0, 1.0], (copies, 1)), np.tile([0, 1, 0, -1], (copies, 1))
    crossed = np.zeros((copies, hits, 2 + n))
    if machine.exact is None:
        wanted, slack = _evaluate_conserved(machine, y, scale)
    else:  # a state with more digits is not to be put back by numbers that have fewer
        wanted = slack = np.zeros((copies, 0))
    low = np.zeros((copies, 0 if machine.exact is None else n))
    others = np.zeros((copies, 0, n)) if others is None else others
    theirs, sizes = np.zeros((*others.shape[:2], wanted.shape[1])), np.zeros((copies, n))
    if others.size:
        values, _ = integrals_at(machine, others.reshape(-1, n)[:, : machine.form.size])
        theirs, sizes = _finite(values).reshape(theirs.shape), np.abs(y)
    return Copies(y, low, scale, wanted, slack, np.zeros(copies, np.int64), samples, now, counts, crossed, others,
                  theirs, np.abs(others - y[:, None]), sizes)


def advance_copies(
    copies: Copies, machine: Machine, course: Course, check: Callable[[float], None], share: Callable[[float], float],
    most: int = LIMITS.max_steps,
) -> None:
    """Advance all copies that have not stopped before to the end of a course.

    Args:
        copies: which are changed.
        machine: of their system, between two of its jumps.
        course: common to all.
        check: called with the completed share of all, between parts of a long run.
        share: the completed part of the span at a time.
        most: how many steps a part of a run has.
    """
    status = copies.status
    status[status == kernel.DONE] = kernel.RUNNING
    if machine.clock >= 0:
        copies.y[:, machine.clock] = copies.now[:, TIME]
    spent, at_first = 0.0, math.nan  # time since the end of the first part, and how much was done by then
    while (running := np.flatnonzero(status == kernel.RUNNING)).size:
        use = choose_kernel(running.size, machine.exact is not None)
        # Python's runs are long enough to ask how much of the processor they took, whatever else it does
        clock = time.perf_counter if use.is_compiled else time.process_time
        before = clock()
        _advance(copies, machine, course, use, running, most)
        seconds = clock() - before
        note(use, running.size, machine.program, seconds)
        if copies.counts[:, STEPS].max() >= LIMITS.max_steps:
            return
        if (left := np.flatnonzero(status == kernel.RUNNING)).size:
            done = (len(status) - left.size + share(float(copies.now[left[0], TIME]))) / len(status)
            check(done)
            spent, at_first = (0.0, done) if math.isnan(at_first) else (spent + seconds, at_first)
            if done > at_first:
                note_rest(use, machine.exact is not None, spent, spent * (1.0 - done) / (done - at_first))


def outcome(
    copies: Copies,
) -> tuple[Integer[Array, "copies"], Integer[Array, "copies"], Float64[Array, "copies"]]:
    """Return status, the event that ended each or −1, and the time of the end, or NaN; nothing is left after that."""
    stopped, fine = copies.status == kernel.STOPPED, (copies.status == kernel.DONE) | (copies.status == kernel.FULL)
    status = np.where(stopped, Status.EVENT, np.where(fine, Status.COMPLETED, Status.NOT_CONVERGED))
    event = np.where(stopped, copies.counts[:, EVENT], -1)
    end = np.where(stopped | fine, copies.now[:, TIME], math.nan)
    for k in np.flatnonzero(~stopped & ~fine):
        copies.out[k, copies.counts[k, NEXT] :] = np.inf
    return status, event, end


def _advance(copies: Copies, machine: Machine, course: Course, use: Kernel, running: Array, most: int) -> None:
    code, values = write_code(use, machine.program, machine.integrals)
    limit = min(most, max(1, use.stretch // machine.program.length))
    orders = 1 + max(course.order, *course.orders.tolist()) if course.companions else 1 + course.order
    watched, conserved = len(course.falling), copies.wanted.shape[1]

    def fill(low: int, high: int) -> None:
        part = slice(running[low], running[high - 1] + 1)
        rates = series_for(machine.program, orders, use.lanes, code)
        integrals = series_for(machine.integrals, 1, use.lanes, values, machine.integrals.outputs)
        exact = exact_for(machine.exact, machine.numbers, ORDERS_IN_PAIRS)
        lanes = lanes_for(machine.program, exact, course.order, use.lanes, watched, conserved, course.companions)
        with np.errstate(all="ignore"):
            use.advance(rates, integrals, Copies(*(x[part] for x in copies)), lanes, course, limit)

    if use.is_compiled:  # as Python's threads wait for each other
        in_threads(fill, running.size, LIMITS.min_copies_of_thread)
    else:
        fill(0, running.size)


def integrals_at(
    machine: Machine, y: Float64[Array, "copies n"]
) -> tuple[Float64[np.ndarray, "copies conserved"], Float64[np.ndarray, "copies conserved n"]]:
    """Return the conserved quantities at states, in the order of the machine's names, and their derivatives."""
    count, n = len(machine.names), machine.form.size
    columns, first = np.zeros((len(y), count * (1 + n))), 0
    by_python = 256  # copies at a time, before Python asks for a better kernel
    while count and first < len(y):
        use = choose_kernel(len(y) - first)
        part = slice(first, len(y) if use.is_compiled else first + by_python)
        states, points = np.zeros(n * use.lanes), np.ascontiguousarray(y[part])
        # the time is measured only where it counts, as measuring takes longer than a compiled run
        before = 0.0 if use.is_compiled else time.process_time()
        with np.errstate(all="ignore"):
            use.conserved_values(series_for(machine.integrals, 1, use.lanes), points, states, columns[part])
        if not use.is_compiled:
            note(use, len(points), machine.integrals, time.process_time() - before)
        first = part.stop
    return columns[:, :count], columns[:, count:].reshape(len(y), count, n)


def _evaluate_conserved(machine: Machine, y: Array, scale: Array) -> tuple[Array, Array]:
    """Return the conserved quantities (C, K) at starts (C, n), and their slack."""
    n = machine.form.size
    values, slopes = integrals_at(machine, y[:, :n])
    finite = np.where(np.isfinite(scale[:, :n]), scale[:, :n], 0.0)
    with np.errstate(all="ignore"):
        sizes = np.sum(np.abs(slopes) * finite[:, None], axis=-1)
    slack = LIMITS.relative_rounding * np.where(np.isfinite(sizes), sizes, 0.0)
    return _finite(values), slack


def _finite(values: Array) -> Array:
    return np.where(np.isfinite(values), values, 0.0)
