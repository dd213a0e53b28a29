"""The work space of the kernel, in flat arrays that Python makes before it begins."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from polhode.taylor.kernel_zeros import MAX_WAITING
from polhode.taylor.program import Program
from polhode.types import Array, Bool, Float64, Integer

if TYPE_CHECKING:
    from polhode.taylor.llvm_writer import Code  # which needs Numba

NOBODY = -1  # in a lane
TIME, LATEST, UNIT = range(3)  # of a copy, where its ``now`` has them
STEPS, NEXT, HITS, EVENT = range(4)  # and its ``counts``
MANY_KICKS = 8191  # a prime number, so that steps do not repeat them soon


class Series(NamedTuple):
    """A program, and the coefficients that it has computed.

    Attributes:
        whole, number: of the program.
        flat: coefficients of one order after the other, each of all nodes, each of all lanes.
        z: the same memory as the numbers that a kernel computes with.
        a, b: factors of products, where they are kept apart.
        code: address of ``straight_line`` code for the program, or 0, and ``begins`` the first order that it computes.
        bounded: arguments of functions whose change in a step is bounded, see ``Program.bounded_arguments``.
    """

    whole: Integer[Array, "integers"]
    number: Float64[np.ndarray, "numbers"]
    flat: Float64[np.ndarray, " many"]
    z: Array
    a: Float64[np.ndarray, " many"]
    b: Float64[np.ndarray, " many"]
    code: int
    begins: int
    bounded: Integer[Array, "numbers"]


class Exact(NamedTuple):
    """A program whose first coefficients are computed with twice as many digits, each in two parts.

    Its state is that of the other program, followed by numbers of the system, which do not move.

    Attributes:
        whole, number: of the program, empty where nothing is computed so.
        high, low: coefficients of one order after the other, each of all nodes.
        still: (slots,) 1 for nodes that do not move.
    """

    whole: Integer[Array, "integers"]
    number: Float64[Array, "numbers"]
    high: Float64[Array, " many"]
    low: Float64[Array, " many"]
    still: Integer[Array, "slots"]


class Copies(NamedTuple):
    """The state of C copies of n numbers.

    Attributes:
        y: (C, n) states.
        low: (C, n) what these leave of states with twice as many digits; else (C, 0).
        scale: (C, n) sizes of their components, infinite of those that have none and are not put back.
        wanted: (C, K) what is conserved.
        slack: (C, K) by how much a state may be off that.
        status: (C,) see ``kernel``.
        out: (C, T, n) where samples are put.
        now: (C, 3) the present time, that of the last event, and a unit of time to begin with, as a step's length.
        counts: (C, 4) steps so far, next sample, hits so far, which event was last (−1).
        hits: (C, H, 2 + n) time, number and state of events.
        others, others_wanted: (C, J, n) and (C, J, K) states of companions, and what they conserve.
        gaps: (C, J, n) by how much their numbers have been off the copy's, at most, where steps end.
        sizes: (C, n) of the copy's own numbers, likewise.
    """

    y: Float64[Array, "copies n"]
    low: Float64[Array, "copies low"]
    scale: Float64[Array, "copies n"]
    wanted: Float64[Array, "copies conserved"]
    slack: Float64[Array, "copies conserved"]
    status: Integer[Array, "copies"]
    out: Float64[Array, "copies time n"]
    now: Float64[Array, "copies 3"]
    counts: Integer[Array, "copies 4"]
    hits: Float64[Array, "copies hits row"]
    others: Float64[Array, "copies companions n"]
    others_wanted: Float64[Array, "copies companions conserved"]
    gaps: Float64[Array, "copies companions n"]
    sizes: Float64[Array, "copies n"]


class Course(NamedTuple):
    """The data shared by all copies.

    Attributes:
        times: (T,) samples, in the direction of time, and ``samples`` how many.
        order, reach, longest: of the coefficients, of a step in radii of convergence, and step.
        forth: 1, or −1 of runs backwards in time.
        falling, stops: (W,) whether only changes from positive to negative are events, and which end a run.
        end: the last time.
        clock: component of the state that is the time, or −1.
        follows: (F,) components of no size of their own that change with the others, as tangents do, and
            ``followers`` how many.
        orders: (J,) of the companions' series, and ``companions`` how many.
        kicks: ``MANY_KICKS`` shares by which companions' numbers are moved, one after the other.
    """

    times: Float64[Array, "time"]
    samples: int
    order: int
    reach: float
    longest: float
    forth: float
    falling: Bool[Array, "watched"]
    stops: Bool[Array, "watched"]
    end: float
    clock: int
    follows: Integer[Array, "followers"]
    followers: int
    orders: Integer[Array, "companions"]
    companions: int
    kicks: Float64[Array, "kicks"]


class Lanes(NamedTuple):
    """Copies side by side, and room for what is computed of them; flat arrays have one number of all lanes at a time.

    Attributes:
        which: the copy in each lane.
        states, low, scales, wanted, slack: of these.
        exact: what computes the first coefficients of their rates with twice as many digits.
        units, left, steps, lengths: of time in the series, until the end, of a step in units, see ``step_lengths``.
        later, event, last, lowered: time and event at the end of a step, if that is the last, if the unit was too long.
        due: whether a state is to be put back onto what is conserved, and ``rows`` for it, see ``eliminate``.
        watched: coefficients of what is watched, and ``p`` (W, order + 1) those of one lane.
        terms: of what is watched: a smaller change than this in a step is rounding.
        work, waiting: see ``kernel_zeros``.
        others, others_wanted, gaps, sizes: of companions, see ``Copies``.
        own: states, and what they conserve, of copies while their companions take the places of these.
        kicks: shares by which one companion's numbers are moved.
    """

    which: Integer[Array, "lanes"]
    states: Float64[Array, " many"]
    low: Float64[Array, " many"]
    exact: Exact
    scales: Float64[Array, " many"]
    wanted: Float64[Array, " many"]
    slack: Float64[Array, " many"]
    units: Float64[np.ndarray, "lanes"]
    left: Float64[Array, "lanes"]
    steps: Float64[Array, "lanes"]
    lengths: Float64[Array, " many"]
    later: Float64[Array, "lanes"]
    event: Integer[Array, "lanes"]
    last: Integer[Array, "lanes"]
    lowered: Integer[Array, "lanes"]
    due: Float64[Array, "lanes"]
    rows: Float64[Array, " many"]
    watched: Float64[Array, " many"]
    p: Float64[Array, "watched orders"]
    terms: Float64[Array, " many"]
    work: Float64[Array, "orders"]
    waiting: Float64[Array, " many"]
    others: Float64[Array, " many"]
    others_wanted: Float64[Array, " many"]
    gaps: Float64[Array, " many"]
    sizes: Float64[Array, " many"]
    own: Float64[Array, " many"]
    kicks: Float64[Array, " many"]


def series_for(program: Program, orders: int, width: int, code: Code | None = None, outputs: int = 0) -> Series:
    """Return room for so many orders of so many lanes, and outputs; one copy keeps the factors of its products."""
    flat = _zeros((orders * program.slots + outputs + 8) * width)
    factors = orders * program.products + 8 if width == 1 else 0
    address, begins = (0, 0) if code is None else code[:2]
    a, b = _zeros(factors), _zeros(factors)
    return Series(program.whole, program.number, flat, flat, a, b, address, begins, program.bounded_arguments)


def exact_for(program: Program | None, numbers: Float64[Array, "numbers"], orders: int) -> Exact:
    """Return room for so many orders in two parts; ``numbers`` are those of the system, which end the state."""
    if program is None:
        return Exact(np.zeros(0, np.int64), _zeros(0), _zeros(0), _zeros(0), np.zeros(0, np.int64))
    high, low = _zeros(orders * program.slots), _zeros(orders * program.slots)
    high[program.size - len(numbers) : program.size] = numbers
    return Exact(program.whole, program.number, high, low, program.still(len(numbers)))


def lanes_for(
    program: Program, exact: Exact, order: int, width: int, watched: int, conserved: int, companions: int
) -> Lanes:
    """Return lanes in which nobody is."""
    n, lengths = program.size, 9  # see ``kernel_series.step_lengths``
    numbers = lambda count: _zeros(count * width)  # noqa: E731
    marks = lambda: np.zeros(width, np.int64)  # noqa: E731
    return Lanes(
        np.full(width, NOBODY), numbers(n), numbers(n if len(exact.whole) else 0), exact, numbers(n),
        numbers(conserved), numbers(conserved), np.ones(width),
        numbers(1), numbers(1), numbers(lengths), numbers(1), marks(), marks(), marks(), numbers(1),
        numbers(conserved * (n + 1 + conserved)),
        numbers(watched * (order + 1)), np.zeros((watched, order + 1)), numbers(watched),
        np.zeros(order + 1), np.zeros(2 * MAX_WAITING + 8),
        numbers(companions * n), numbers(companions * conserved), numbers(companions * n),
        numbers(n if companions else 0), numbers(n + conserved if companions else 0),
        numbers(n if companions else 0),
    )


def _zeros(count: int) -> Float64[np.ndarray, " many"]:
    """Return zeros that begin where a line of the cache does: vectors across two of them take twice as long to load."""
    line = 64  # bytes
    padded = np.zeros(count + line // 8)
    first = -padded.ctypes.data % line // 8
    return padded[first : first + count]
