"""Motions past branches on moving values: from border to border, each copy by the program of the sides it is on."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from typing import Any, NamedTuple

import numpy as np

from polhode.taylor import kernel
from polhode.taylor.advancing import advance_copies
from polhode.taylor.expressions import Untraceable
from polhode.taylor.kernel_space import EVENT, HITS, STEPS, TIME, UNIT, Copies, Course
from polhode.taylor.machine import Machine
from polhode.taylor.sides import Branches, Signs, settle
from polhode.types import Array, Bool, Float64, Integer

HELD, STRANDED = -1, -2  # the status of copies that wait while others move, and of those that series cannot follow
ROUNDED = 0.25 * float(np.finfo(float).eps)  # of a time, as the root mean square of its rounding
SIGNS = np.random.default_rng(0).choice([-1.0, 1.0], 1024)  # of roundings, one crossing after another
APPROACHED = "a branch on something that moves, whose border the motion approaches and never crosses"
UNSEEN = "a branch on something that moves, whose border it has crossed undetected"
TOO_OFTEN = "branches on something that moves, whose borders it crosses too often"


class SwitchingLimits(NamedTuple):
    """Bounds of a copy's crossings, beyond which it has no series."""

    max_crossings: int = 20_000  # from which on other steps take less time
    max_crossings_at_once: int = 16
    steps_to_leave: int = 50  # after a crossing, until when a border may be near
    max_steps: int = 100_000  # after a crossing


LIMITS = SwitchingLimits()


class Watched(NamedTuple):
    """The watched functions besides borders.

    Attributes:
        falling: (W,) whether only changes from positive to negative count.
        stops: (W,) whether they end the motion.
        most: how many of those that do not are noted.
        enlarge: makes room for more of them.
        late: (C,) roundings of the time by which copies cross borders too late, to show the effect; or None.
        changes: how many small changes of its first components a state has behind these.
        size: of a state.
    """

    falling: Bool[Array, "watched"]
    stops: Bool[Array, "watched"]
    most: int
    enlarge: Callable[[Copies], Copies]
    late: Float64[np.ndarray, "copies"] | None = None
    changes: int = 0
    size: int = 0


def advance_past_branches(
    copies: Copies, machine: Machine, build: Callable[..., Machine],
    course_of: Callable[[Copies, Machine, Array, Array], Course], check: Callable[[float], None],
    share: Callable[[float], float], watched: Watched,
) -> tuple[Copies, Signs]:
    """Advance copies to the end of a course, as ``advance_copies`` does.

    Args:
        copies: which are changed.
        machine: for the sides on which a state is; those of the copies may be others.
        build: returns the machine for other ``signs``.
        course_of: returns the course by a machine; with which watched functions have to fall, and which end it.
        check, share: as of ``advance_copies``.
        watched: the functions that the machine watches before the borders.

    Returns:
        The copies, which may have more room, and the sides on which a copy is then.

    Raises:
        Untraceable: naming the copies whose motion goes along a border, crosses too many, or comes to a border from
            two sides; the others have come to the end.
    """
    run = _Run(copies, machine, build, course_of, watched)
    while (left := np.flatnonzero(run.open)).size:
        each = run.signs[left[0]]
        together = np.array([k for k in left if run.signs[k] == each])
        run.go_on(each, together, check, share)
    if (lost := run.copies.status == STRANDED).any():
        raise Untraceable(run.reason, lost)
    return run.copies, run.signs[0]


def time_of_roundings(number: int, t: float, count: Any) -> Any:
    """Return by how much [s] the time of a jump is off by so many roundings, by turns too early and too late."""
    return SIGNS[number % len(SIGNS)] * ROUNDED * abs(t) * count


class _Run:
    """A run of copies, each with the sides on which it is."""

    def __init__(self, copies: Copies, machine: Machine, build: Callable[..., Machine],
                 course_of: Callable[[Copies, Machine, Array, Array], Course], watched: Watched) -> None:
        count = len(copies.status)
        self.copies, self.course_of, self.watched, self.reason = copies, course_of, watched, ""
        self.machine_of = cache(lambda each: build(signs=each))  # called often, and hashing a system takes long
        self.open: Bool[Array, "copies"] = np.isin(copies.status, (kernel.RUNNING, kernel.DONE))
        if machine.clock >= 0:
            copies.y[:, machine.clock] = copies.now[:, TIME]
        self.signs: list[Signs] = [_branches(machine).signs] * count
        self.forth = course_of(copies, machine, np.ones(0, bool), np.ones(0, bool)).forth
        self.crossings, self.at_once, self.latest = np.zeros(count, int), np.zeros(count, int), np.full(count, np.nan)
        self.steps = copies.counts[:, STEPS].copy()  # at the last crossing
        self._settle(np.flatnonzero(self.open), np.full(count, -1))

    def go_on(
        self, each: Signs, together: Integer[np.ndarray, "some"], check: Callable[[float], None],
        share: Callable[[float], float],
    ) -> None:
        """Move copies on equal sides to where they leave these, or to their end."""
        machine, status = self.machine_of(each), self.copies.status
        branches, own = _branches(machine), len(self.watched.falling)
        before = status.copy()
        status[:] = HELD
        status[together] = kernel.RUNNING
        borders = np.ones(len(branches.watched), bool)
        course = self.course_of(self.copies, machine, np.append(self.watched.falling, borders),
                                np.append(self.watched.stops, borders))

        def check_borders(part: float) -> None:
            check(part)
            self._check_distance(branches, together)

        advance_copies(self.copies, machine, course, check_borders, share, LIMITS.steps_to_leave)
        after = status.copy()
        status[:] = before
        status[together] = after[together]
        crossed = np.full(len(status), -1)
        for k in together.tolist():
            event = int(self.copies.counts[k, EVENT])
            if status[k] == kernel.STOPPED and event >= own:
                crossed[k] = branches.place(event - own)
                self._cross(k)
            else:
                self.open[k] = False
        full = together[(status[together] == kernel.FULL) & (self.copies.counts[together, HITS] < self.watched.most)]
        if full.size:
            self.copies = self.watched.enlarge(self.copies)
            status[full], self.open[full] = kernel.RUNNING, True
        self._settle(np.flatnonzero(crossed >= 0), crossed)
        done = together[self.copies.status[together] == kernel.DONE]
        if done.size and not branches.hold(np.asarray(self.copies.y)[done]):
            self._strand([k for k in done if not branches.hold(np.asarray(self.copies.y)[[k]])], UNSEEN)

    def _cross(self, k: int) -> None:
        """Record that a copy has crossed a border, which does not count among the events that it noted."""
        now, counts = self.copies.now, self.copies.counts
        self.copies.status[k] = kernel.RUNNING
        counts[k, HITS] -= 1
        self.crossings[k] += 1
        self.at_once[k] = self.at_once[k] + 1 if now[k, TIME] == self.latest[k] else 0
        self.latest[k], self.steps[k] = now[k, TIME], counts[k, STEPS]
        if self.crossings[k] > LIMITS.max_crossings or self.at_once[k] > LIMITS.max_crossings_at_once:
            self._strand([k], TOO_OFTEN)

    def _settle(self, some: Integer[np.ndarray, "some"], crossed: Integer[np.ndarray, "copies"]) -> None:
        """Determine the sides on which copies continue, one by one where one of them has none."""
        some = some[self.open[some]]
        branches_of = lambda each: _branches(self.machine_of(each))  # noqa: E731
        try:
            signs = settle(branches_of, np.asarray(self.copies.y)[some], [self.signs[k] for k in some], crossed[some],
                           self.forth, np.asarray(self.copies.now)[some, UNIT]) if some.size else []
        except Untraceable as error:
            if some.size == 1:
                self._strand(some, str(error))
            else:
                for k in some:
                    self._settle(np.array([k]), crossed)
            return
        for k, each in zip(some, signs, strict=True):
            if crossed[k] >= 0 and (self.watched.late is not None or self.watched.changes):
                self._jump(int(k), int(crossed[k]), branches_of(self.signs[k]), branches_of(each))
            self.signs[k] = each

    def _jump(self, k: int, crossed: int, before: Branches, after: Branches) -> None:
        """Let small changes jump where rates do, and show the effect of a rounding of the time of crossing."""
        y, count, t = np.asarray(self.copies.y), self.watched.changes, float(self.copies.now[k, TIME])
        rates = before.rates_at(y[[k]])
        jump = after.rates_at(y[[k]]) - rates
        if not jump.any():
            return
        if count:
            # δ⁺ = δ⁻ + (f⁺ − f⁻) (∇g·δ⁻)/(∇g·f⁻) at g = 0, as a neighbour crosses earlier or later (Aizerman &
            # Gantmakher, Quart. J. Mech. Appl. Math. 11 (1958) 407)
            n = self.watched.size // (1 + count)
            pace = before.slope_along(crossed, y[[k]], rates)
            for first in range(n, (1 + count) * n, n):
                direction = np.zeros_like(rates)
                direction[:n] = y[k, first : first + n]
                y[k, first : first + n] += jump[:n] * (before.slope_along(crossed, y[[k]], direction) / pace)
        if self.watched.late is not None:
            y[k] -= time_of_roundings(int(self.crossings[k]), t, self.watched.late[k]) * jump

    def _check_distance(self, branches: Branches, some: Integer[np.ndarray, "some"]) -> None:
        """Strand copies that come ever nearer to a border, where steps would shrink to nothing."""
        since = self.copies.counts[some, STEPS] - self.steps[some]
        running = self.copies.status[some] == kernel.RUNNING
        late = some[(since > LIMITS.steps_to_leave) & running]
        if late.size and branches.touches_border(np.asarray(self.copies.y)[late]):
            near = [k for k in late if branches.touches_border(np.asarray(self.copies.y)[[k]])]
            self._strand(near, APPROACHED)
        if (long := some[(since > LIMITS.max_steps) & running]).size:
            self._strand(long, APPROACHED)

    def _strand(self, some: Any, reason: str) -> None:
        self.reason = self.reason or reason
        self.copies.status[some] = STRANDED
        self.open[some] = False


def _branches(machine: Machine) -> Branches:
    assert machine.branches is not None
    return machine.branches
