"""Stepped motions as users call for them: many copies and one, with and without an error estimate, at equal errors"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from functools import partial
from typing import Any, NamedTuple

import numpy as np
from callers import dopri8, find_exact, make_copies, off, simulated
from cases import Case, cases
from first_motion import first_motion
from measure import Row, compared, missing, seconds

import polhode as ph

try:
    import heyoka_peer
except ImportError:
    heyoka_peer = None

SPAN, COPIES, TURNS = 20.0, 400, 5
LONG = 2000.0  # where one motion's steps are nearly all of its time
TARGETS = (1e-8, 1e-12)
CHAOTIC = "heavy top", "Kirchhoff's body, full matrix", "chain of eight spins"
TOPS, SHORT = 10_000, 10.0
ENOUGH = 2  # choices that meet all errors: tighter ones cost more
OURS = (*10.0 ** -np.arange(6.0, 16.0), None)
THEIRS = 10.0 ** -np.arange(5.0, 16.0)  # at 1e-16 heyoka's so(6) did not end in 50 CPU s
DOPRI8 = 10.0 ** -np.arange(6.0, 15.0)
NEEDED = "`pip install heyoka`"
MANY, ONE = "heyoka, 8 at a time", "heyoka"


def rows(quick: bool) -> Iterator[Row]:
    """Yield heyoka's time over that of ``ph.simulate``, at no more than each error; of one motion also Dopri8's."""
    for case in list(cases())[: 2 if quick else None]:
        starts = make_copies(case, 16 if quick else COPIES)
        exact = find_exact(case, starts, SPAN)
        if heyoka_peer is None:
            yield missing(case.name, MANY, NEEDED)
        else:
            first = None if quick else first_motion(case.name)
            peer = heyoka_peer.many(case, starts, SPAN)
            yield from _against(f"{case.name}, {len(starts):,} copies", case, starts, exact, SPAN, MANY, peer, quick)
            peer = heyoka_peer.one(case, starts[:1], SPAN)
            for row in _against(f"{case.name}, one", case, starts[:1], exact[:1], SPAN, ONE, peer, quick):
                yield row._replace(first=first)
        yield from _general(case, starts[:1], exact[:1], quick)
        if heyoka_peer is not None and not quick and not case.name.startswith(CHAOTIC):
            exact, peer = find_exact(case, starts[:1], LONG), heyoka_peer.one(case, starts[:1], LONG)
            yield from _against(f"{case.name}, one to t = {LONG:.0f}", case, starts[:1], exact, LONG, ONE, peer, quick)
    yield from _tops(quick)


def _tops(quick: bool) -> Iterator[Row]:
    """Yield many different heavy tops over a short time."""
    case = next(one for one in cases() if one.name == "heavy top")
    starts = np.repeat(case.start[None], 16 if quick else TOPS, axis=0)
    starts[:, 4:7] += 0.1 * np.random.default_rng(0).normal(size=(len(starts), 3))
    work = f"heavy tops, {len(starts):,} to t = {SHORT:.0f}"
    if heyoka_peer is None:
        yield missing(work, MANY, NEEDED)
        return
    peer = heyoka_peer.many(case, starts, SHORT)
    yield from _against(work, case, starts, find_exact(case, starts, SHORT), SHORT, MANY, peer, quick)


def _against(
    work: str, case: Case, starts: np.ndarray, exact: np.ndarray, span: float, name: str,
    peer: Callable[[float], np.ndarray], quick: bool,
) -> Iterator[Row]:
    """Yield the peer at each error, at the cheapest of its tolerances, against ours without and with errors."""
    plain = partial(simulated, case, starts, span)
    mine, theirs = _tried(plain, OURS, exact), _tried(peer, THEIRS, exact)
    for target in TARGETS:
        said, other = f"{work}, error at most {target:g}", _cheapest(theirs, target)
        if other is None:
            yield Row(said, name, note="the peer does not come as near")
            continue
        by = partial(peer, other.choice)
        note = f"peer's tolerance {other.choice:g}"
        if (ours := _cheapest(mine, target)) is None:
            yield Row(said, name, note="ours does not come as near")
        else:
            times = compared(partial(plain, ours.choice), by, 2 if quick else TURNS)
            yield Row(said, name, ours.error, other.error, *times, f"ours {_words(ours.choice)}; {note}")
        estimated = partial(plain, target, known=True)
        try:
            error = off(estimated(), exact)
        except ph.NotConverged:
            yield Row(f"{said}, ours with its estimate", name, note="roundings grow to more than that")
            continue
        times, note = compared(estimated, by, 2 if quick else TURNS), f"ours tolerance {target:g}; {note}"
        yield Row(f"{said}, ours with its estimate", name, error, other.error, *times, note)


def _general(case: Case, start: np.ndarray, exact: np.ndarray, quick: bool) -> Iterator[Row]:
    """Yield diffrax's Dopri8 for one motion."""
    plain, peer, name = partial(simulated, case, start, SPAN), dopri8(case, start, SPAN), "diffrax Dopri8"
    mine, theirs = _tried(plain, OURS, exact), _tried(peer, DOPRI8, exact)
    for target in TARGETS:
        said = f"{case.name}, one, error at most {target:g}"
        ours, other = (_cheapest(tried, target) for tried in (mine, theirs))
        if ours is None or other is None:
            yield Row(said, name, note=f"{'ours' if ours is None else 'the peer'} does not come as near")
            continue
        times = compared(partial(plain, ours.choice), partial(peer, other.choice), 2 if quick else TURNS)
        note = f"ours {_words(ours.choice)}; peer's tolerance {other.choice:g}"
        yield Row(said, name, ours.error, other.error, *times, note)


class Tried(NamedTuple):
    """One way to run, the cheapest first in order."""

    time: float
    error: float
    choice: Any


def _tried(run: Callable[[Any], np.ndarray], choices: Iterable[Any], exact: np.ndarray) -> list[Tried]:
    """Return what was tried, from loose to tight, until two are as exact as is asked for."""
    tried: list[Tried] = []
    for choice in choices:
        run(choice)  # compiles
        kept: list[np.ndarray] = []
        time = seconds(lambda choice=choice, kept=kept: kept.append(run(choice)))
        tried.append(Tried(time, off(kept[0], exact), choice))
        if sum(one.error <= min(TARGETS) for one in tried) == ENOUGH:
            break
    return tried


def _cheapest(tried: list[Tried], target: float) -> Tried | None:
    return min((one for one in tried if one.error <= target), default=None, key=lambda one: one.time)


def _words(tolerance: float | None) -> str:
    return "to rounding" if tolerance is None else f"tolerance of steps {tolerance:g}"
