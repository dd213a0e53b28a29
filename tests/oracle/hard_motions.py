"""The hard motions of the reference table: what free bodies and tops have in common.

Every number is a double that anybody gets again: written out, or drawn by ``random.Random`` and rounded to a few
digits. Times are rounded too, so that a period that is only roughly known does no harm.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import hypot, inf, isfinite, pi, sqrt
from random import Random
from typing import NamedTuple

from scipy.special import ellipkm1

FREE, TOP = "free body", "Lagrange top"
IDENTITY = (1.0, 0.0, 0.0, 0.0)
LEVEL = (0.5, 0.5, 0.5, 0.5)
STARTS = (IDENTITY, LEVEL, (0.5, -0.5, 0.5, 0.5), (0.1, -0.7, 0.5, 0.5), (-0.3, 0.9, 0.3, -0.1))
"""Unit quaternions, whose lengths as doubles are 1 to rounding at most."""
TURNS = (0.0, 0.1, 0.37, -1.7, 10.0, 100.0)
"""Times in turns: one is 2π over the fastest rate of rotation."""
PERIODS = (0.25, 1.0, 3.3, -300.0, 1e4, 1e6)
"""Times in periods of the motion, or in tens of turns where it has none."""
MODERATE = 1000.0
"""Radians, as a rough bound, that the body turns until a time which a stepping engine reaches."""
LONGEST = 1e15
"""Radians, in which a double still counts turns; later times are left out."""
SHARE = (0.8, -0.5, 0.3)
"""A direction, roughly, that is near no axis."""
Vector = Sequence[float]


class HardMotion(NamedTuple):
    """One motion of the table, before its states are known; ``rate`` [rad/s] bounds how fast it turns, roughly."""

    name: str
    family: str
    kind: str
    moments: tuple[float, ...]
    mgl: float
    momentum: tuple[float, ...]
    attitude: tuple[float, ...]
    times: tuple[float, ...]
    rate: float

    @property
    def moderate(self) -> tuple[bool, ...]:
        return tuple(self.rate * abs(t) <= MODERATE for t in self.times)


def rounded(value: float, digits: int = 4) -> float:
    return float(f"{value:.{digits - 1}e}")


def times_of(rate: float, period: float) -> tuple[float, ...]:
    """Times in turns and in periods, each once, the nearest to the start first."""
    turn = 2.0 * pi / rate
    span = period if isfinite(period) and period > 0.0 else 10.0 * turn
    found = {rounded(share * turn) for share in TURNS} | {rounded(share * span) for share in PERIODS}
    return tuple(sorted((t for t in found if rate * abs(t) <= LONGEST), key=lambda t: (abs(t), t)))


def free(name: str, family: str, moments: Vector, momentum: Vector, attitude: Vector = IDENTITY) -> HardMotion:
    rate, period = rate_and_period(moments, momentum)
    return HardMotion(name, family, FREE, tuple(map(float, moments)), 0.0, tuple(map(float, momentum)),
                      tuple(map(float, attitude)), times_of(rate, period), rate)  # fmt: skip


def rate_and_period(moments: Vector, momentum: Vector) -> tuple[float, float]:
    """A bound of |Ω| [rad/s], and the polhode's period [s], infinite where L rests or follows the separatrix."""
    order = sorted(range(3), key=lambda k: moments[k])
    size, least = hypot(*momentum), min(moments)
    a1, a2, a3 = (least / moments[k] for k in order)
    n1, n2, n3 = (momentum[k] / size for k in order)
    p, q = (a1 - a3) * n1**2 + (a2 - a3) * n2**2, (a1 - a2) * n2**2 + (a1 - a3) * n3**2
    s = (a1 - a2) * n1**2 - (a2 - a3) * n3**2
    most = [[(p, a1 - a3)], [(p, a2 - a3), (q, a1 - a2)], [(q, a1 - a3)]]  # n1² ≤ p/(a1 − a3), and so on
    largest = [min([1.0, *(sqrt(above / gap) for above, gap in bounds if gap > 0.0)]) for bounds in most]
    unit = size / least
    rate = unit * hypot(*(a * n for a, n in zip((a1, a2, a3), largest, strict=True)))
    square, small = ((a1 - a2) * p, q) if s > 0.0 else ((a2 - a3) * q, p)
    if s == 0.0 or square == 0.0 or small == 0.0:
        return rate, inf
    return rate, 4.0 * float(ellipkm1((a1 - a3) * abs(s) / square)) / sqrt(square) / unit


def slope(moments: Vector) -> float:
    """L1/L3 on the separatrix, of moments in ascending order."""
    i1, i2, i3 = moments
    return sqrt((i3 - i2) * i1 / ((i2 - i1) * i3))


def drawn_moments(rng: Random) -> tuple[float, ...]:
    return tuple(sorted(rounded(0.1 + 0.9 * rng.random()) for _ in range(3)))


def drawn_vector(rng: Random) -> tuple[float, ...]:
    return tuple(rounded(2.0 * rng.random() - 1.0) for _ in range(3))


def drawn_attitude(rng: Random) -> tuple[float, ...]:
    return rng.choice(STARTS)
