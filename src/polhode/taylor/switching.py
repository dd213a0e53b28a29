"""Motions past branches on what moves: from one border to the next, each copy by the program of the sides it is on."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache

import numpy as np

from polhode.taylor import kernel
from polhode.taylor.expressions import Untraceable
from polhode.taylor.flight import fly
from polhode.taylor.kernel_space import EVENT, HITS, STEPS, TIME, Copies, Course
from polhode.taylor.machine import Machine
from polhode.taylor.sides import Branches, Signs, settle
from polhode.types import Array, Integer

HELD = -1  # the status of copies that wait while others move
MOST_CROSSINGS = 20_000  # of a copy, from which on other steps take less time
MOST_AT_ONCE = 16  # at the same time
SETTLED, MOST_STEPS = 50, 100_000  # steps since the last crossing, after which a border may not be near, and at most


def fly_past_branches(
    copies: Copies, machine: Machine, build: Callable[..., Machine],
    course_of: Callable[[Copies, Machine, Array, Array], Course], check: Callable[[float], None],
    share: Callable[[float], float],
) -> Signs:  # fmt: skip
    """Go on up to the end of a course, as ``fly`` does, and return the sides on which a copy is then.

    Args:
        copies: which are changed.
        machine: for the sides on which a state is; those of the copies may be others.
        build: returns the machine for other ``signs``.
        course_of: returns the course by a machine; with which watched functions have to fall, and which end it.
        check, share: as of ``fly``.

    Raises:
        Untraceable: where a motion goes along a border, crosses too many, or comes to a border from two sides.
    """
    status, count = copies.status, len(copies.status)
    events = len(machine.events)
    open_ = np.isin(status, (kernel.RUNNING, kernel.DONE))
    if machine.clock >= 0:
        copies.y[:, machine.clock] = copies.now[:, TIME]
    assert machine.branches is not None
    signs: list[Signs] = [machine.branches.signs] * count
    machine_of = cache(lambda each: build(signs=each))  # asked at each crossing, and hashing a system takes long
    branches_of = lambda each: _branches(machine_of(each))  # noqa: E731
    nowhere = np.full(count, -1)
    forth = course_of(copies, machine, np.ones(0, bool), np.ones(0, bool)).forth
    _settle_some(branches_of, copies, signs, np.flatnonzero(open_), nowhere, forth)
    crossings, at_once, latest = np.zeros(count, int), np.zeros(count, int), np.full(count, np.nan)
    steps = copies.counts[:, STEPS].copy()  # at the last crossing
    while (left := np.flatnonzero(open_)).size:
        each = signs[left[0]]
        together = np.array([k for k in left if signs[k] == each])
        now, before = machine_of(each), status.copy()
        status[:] = HELD
        status[together] = kernel.RUNNING
        watched = np.ones(events + len(_branches(now).watched), bool)

        def check_borders(part: float, now: Machine = now, some: Array = together) -> None:
            check(part)
            _check_distance(_branches(now), copies, some, steps)

        fly(copies, now, course_of(copies, now, watched, watched), check_borders, share, SETTLED)
        after = status.copy()
        status[:] = before
        status[together] = after[together]
        crossed = nowhere.copy()
        for k in together:
            event = int(copies.counts[k, EVENT])
            if status[k] == kernel.STOPPED and event >= events:
                crossed[k] = _branches(now).place(event - events)
                status[k], copies.counts[k, HITS] = kernel.RUNNING, 0
                crossings[k] += 1
                at_once[k] = at_once[k] + 1 if copies.now[k, TIME] == latest[k] else 0
                latest[k], steps[k] = copies.now[k, TIME], copies.counts[k, STEPS]
            else:
                open_[k] = False
        if crossings.max() > MOST_CROSSINGS or at_once.max() > MOST_AT_ONCE:
            raise Untraceable("branches on something that moves, whose borders it crosses too often")
        _settle_some(branches_of, copies, signs, np.flatnonzero(crossed >= 0), crossed, forth)
        _check_ends(_branches(now), copies, together[status[together] == kernel.DONE])
    return signs[0]


def _branches(machine: Machine) -> Branches:
    assert machine.branches is not None
    return machine.branches


def _settle_some(
    branches_of: Callable[[Signs], Branches], copies: Copies, signs: list[Signs], some: Integer[np.ndarray, "some"],
    crossed: Integer[np.ndarray, "copies"], forth: float,
) -> None:  # fmt: skip
    if some.size:
        found = settle(branches_of, np.asarray(copies.y)[some], [signs[k] for k in some], crossed[some], forth)
        for k, each in zip(some, found, strict=True):
            signs[k] = each


def _check_distance(branches: Branches, copies: Copies, some: Array, steps: Array) -> None:
    """Refuse motions that come ever nearer to a border, where steps would shrink to nothing.

    Raises:
        Untraceable: for such a one.
    """
    since = copies.counts[some, STEPS] - steps[some]
    late = some[(since > SETTLED) & (copies.status[some] == kernel.RUNNING)]
    if late.size and (since.max() > MOST_STEPS or branches.touches_border(np.asarray(copies.y)[late])):
        raise Untraceable("a branch on something that moves, whose border the motion approaches and never crosses")


def _check_ends(branches: Branches, copies: Copies, some: Integer[np.ndarray, "some"]) -> None:
    """Refuse motions that have come to another side unseen.

    Raises:
        Untraceable: for such a one.
    """
    if some.size and not branches.hold(np.asarray(copies.y)[some]):
        raise Untraceable("a branch on something that moves, whose border it has crossed unseen")
