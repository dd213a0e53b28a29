"""Tops and starts that break formulas: seeded draws over every nasty family of the Lagrange top.

A family is a function of a random generator that gives I1, I3, mgl, momentum and attitude; times are drawn the same way
for all, rate × |t| log-uniform from 1e-2 to 1e12 with either sign.
"""

from __future__ import annotations

from collections.abc import Callable, Collection
from typing import Any, NamedTuple

import numpy as np

Rng = np.random.Generator
Family = Callable[[Rng], Any]
SHORTEST_TURN, LONGEST_TURN = -2.0, 12.0
"""Powers of ten of rate × |t|, with rate = |L|/I1 + √(|mgl|/I1)."""
LEVEL = (0.5, 0.5, 0.5, 0.5)
"""An attitude with the axis exactly level and every entry exact; there β̄α = ½, so that L1 is −I1 θ̇ up to sign."""


class TopCase(NamedTuple):
    """One top, its start at time 0, and the time asked for."""

    family: str
    moments: tuple[float, float, float]
    mgl: float
    momentum: tuple[float, float, float]
    attitude: tuple[float, float, float, float]
    time: float


def _power(rng: Rng, low: float, high: float) -> float:
    return float(10.0 ** rng.uniform(low, high))


def _sign(rng: Rng) -> float:
    return float(rng.choice((-1.0, 1.0)))


def _moments(rng: Rng) -> tuple[float, float]:
    return tuple(rng.uniform(0.2, 2.0, 2))


def _any_attitude(rng: Rng) -> np.ndarray:
    q = rng.normal(size=4)
    return q / np.linalg.norm(q)


def _upright(rng: Rng, below: bool = False) -> np.ndarray:
    angle = rng.uniform(0, 2 * np.pi)
    c, s = np.cos(angle), np.sin(angle)
    return np.array([0.0, c, s, 0.0] if below else [c, 0.0, 0.0, s])


def _tipped(rng: Rng, small: float, below: bool = False) -> np.ndarray:
    q = _upright(rng, below) + small * (_upright(rng, not below))
    return q / np.linalg.norm(q)


def generic(rng: Rng):
    return *_moments(rng), _power(rng, -1, 1), rng.normal(size=3), _any_attitude(rng)


def wide_ratio(rng: Rng):
    return 1.0, _power(rng, -6, 6), _power(rng, -1, 1), rng.normal(size=3), _any_attitude(rng)


def cusp(rng: Rng):
    return *_moments(rng), _power(rng, -1, 1), (0.0, 0.0, rng.normal() * 3), _any_attitude(rng)


def near_cusp(rng: Rng):
    small = rng.normal(size=2) * _power(rng, -16, -2)
    return *_moments(rng), _power(rng, -1, 1), (*small, rng.normal() * 3), _any_attitude(rng)


def fast_loop(rng: Rng):
    return *_moments(rng), 1.0, (*rng.normal(size=2), _sign(rng) * _power(rng, 0.5, 1.5)), _any_attitude(rng)


def steady(rng: Rng):
    """At a level axis L2 = mgl I1/L3 precesses steadily; all in a few digits, so that it is exact."""
    a, v = (_sign(rng) * int(rng.integers(1, 200)) / 16 for _ in range(2))
    I1 = 2.0 ** int(rng.integers(-3, 4))
    return I1, float(rng.uniform(0.2, 2)), a * v / I1, (0.0, v, a), LEVEL


def near_steady(rng: Rng):
    I1, I3, mgl, (_, v, a), q = steady(rng)
    return I1, I3, mgl, (a * _power(rng, -18, -2), v * (1 + _sign(rng) * _power(rng, -17, -2)), a), q


def sleeping(rng: Rng):
    return *_moments(rng), _power(rng, -1, 1), (0.0, 0.0, rng.normal() * 3), _upright(rng)


def hanging(rng: Rng):
    return *_moments(rng), _power(rng, -1, 1), (0.0, 0.0, rng.normal() * 3), _upright(rng, below=True)


def near_sleeping(rng: Rng):
    I1, I3 = _moments(rng)
    mgl, small = _power(rng, -1, 1), _power(rng, -30, -1)
    a = _sign(rng) * 2 * np.sqrt(I1 * mgl) * (rng.uniform(1, 4) if rng.random() < 0.5 else rng.uniform(0, 1))
    return I1, I3, mgl, (*rng.normal(size=2) * small, a), _tipped(rng, small)


def near_hanging(rng: Rng):
    small = _power(rng, -30, -1)
    a = rng.normal() * rng.choice((0.0, 1.0, small))
    return *_moments(rng), _power(rng, -1, 1), (*rng.normal(size=2) * small, a), _tipped(rng, small, below=True)


def threshold(rng: Rng):
    """a² = 4 mgl I1 exactly, at or near the vertical."""
    a = _sign(rng) * int(rng.integers(1, 100)) / 8
    small = _power(rng, -20, -1) * rng.choice((0.0, 1.0, 1.0))
    return 1.0, float(rng.uniform(0.2, 2)), a * a / 4, (*rng.normal(size=2) * small, a), _tipped(rng, small)


def near_threshold(rng: Rng):
    I1, I3, mgl, (x, y, a), q = threshold(rng)
    return I1, I3, mgl * (1 + _sign(rng) * _power(rng, -16, -1)), (x, y, a), q


def spherical_pendulum(rng: Rng):
    return *_moments(rng), _power(rng, -1, 1), (*rng.normal(size=2), 0.0), _any_attitude(rng)


def near_spherical_pendulum(rng: Rng):
    return *_moments(rng), _power(rng, -1, 1), (*rng.normal(size=2), _power(rng, -30, -2)), _any_attitude(rng)


def planar_pendulum(rng: Rng):
    below, size = rng.random() < 0.5, _power(rng, -3, 1)
    q = LEVEL if rng.random() < 0.3 else _upright(rng, below)
    momentum = (rng.normal() * size, 0.0 if q is LEVEL else rng.normal() * size, 0.0)
    return *_moments(rng), _power(rng, -1, 1), momentum, q


def through_top(rng: Rng):
    return *_moments(rng), _power(rng, -1, 1), rng.normal(size=3) * _power(rng, -2, 1), _upright(rng)


def through_bottom(rng: Rng):
    return *_moments(rng), _power(rng, -1, 1), rng.normal(size=3) * _power(rng, -2, 1), _upright(rng, below=True)


def near_vertical_passage(rng: Rng):
    q = _tipped(rng, _power(rng, -20, -3), bool(rng.random() < 0.5))
    return *_moments(rng), _power(rng, -1, 1), rng.normal(size=3), q


TRIPLES = ((3, 4, 5), (5, 12, 13), (4, 3, 5), (15, 8, 17), (21, 20, 29), (1, 0, 1))


def separatrix(rng: Rng):
    """c = 0 and |w|² = G s at a level axis: L1² + L3² = 2 mgl I1 in whole numbers, L2 = L3."""
    x, a, r = TRIPLES[rng.integers(len(TRIPLES))]
    scale = 2.0 ** int(rng.integers(-4, 3))
    x, a = _sign(rng) * x * scale, _sign(rng) * a * scale
    return 1.0, float(rng.uniform(0.2, 2)), (r * scale) ** 2 / 2, (x, a, a), LEVEL


def near_separatrix(rng: Rng):
    I1, I3, mgl, (x, y, a), q = separatrix(rng)
    y = y * (1 + _power(rng, -17, -2) * rng.choice((-1.0, 0.0, 1.0)))
    return I1, I3, mgl, (x * (1 + _sign(rng) * _power(rng, -17, -2)), y, a), q


def weak(rng: Rng):
    return *_moments(rng), _power(rng, -20, -2) * rng.choice((0.0, 1.0, 1.0)), rng.normal(size=3), _any_attitude(rng)


def weightless_special(rng: Rng):
    momentum = rng.normal(size=3) * rng.choice((0.0, 1.0), size=3)
    return *_moments(rng), 0.0, momentum, _any_attitude(rng) if rng.random() < 0.5 else _upright(rng)


def huge_spin(rng: Rng):
    return *_moments(rng), 1.0, (*rng.normal(size=2), _sign(rng) * _power(rng, 2, 6)), _any_attitude(rng)


def next_to_nothing(rng: Rng):
    """Upright but for 1e-300 to 1e-30: it sleeps, or leaves after hundreds of times the time in which it doubles."""
    I1, I3 = _moments(rng)
    mgl, small = _power(rng, -1, 1), _power(rng, -300, -30)
    a = _sign(rng) * 2 * np.sqrt(I1 * mgl) * rng.uniform(0.1, 1.5)
    q, momentum = _tipped(rng, small), rng.normal(size=2) * small
    if rng.random() < 0.3:  # of either part alone
        momentum = 0.0 * momentum
    elif rng.random() < 0.3:
        q[1:3] = 0.0
    return I1, I3, mgl, (*momentum, a), q


def rounded_separatrix(rng: Rng):
    """On the separatrix at any attitude, were it not for the rounding of the momentum."""
    q = _any_attitude(rng)
    I1, I3, mgl = *_moments(rng), _power(rng, -1, 1)
    alpha, beta, G = complex(*q[[0, 3]]), complex(*q[[1, 2]]), 2.0 * mgl * I1
    s, t = abs(beta) ** 2, abs(alpha) ** 2
    # p_φ = L3 makes Im β̄αw = s L3, and |w|² = 2 G s the rest
    spin = float(rng.uniform(-1.0, 1.0) * np.sqrt(2.0 * t * G))
    w = complex(np.sqrt(2.0 * s * s * t * G - (s * spin) ** 2), s * spin) / (beta.conjugate() * alpha)
    return I1, I3, mgl, (w.real, w.imag, spin), q


def planar_separatrix(rng: Rng):
    """A pendulum that all but reaches upright, or all but stays below it: c = 0, |w|² = G s to 1e-2 … rounding."""
    I1, I3, mgl, half, turn = *_moments(rng), _power(rng, -1, 1), rng.uniform(0.02, 1.55), _sign(rng)
    speed = np.sqrt(4.0 * mgl * I1) * np.sin(half) * (1.0 + rng.choice((-1.0, 0.0, 1.0)) * _power(rng, -17, -2))
    c, s = np.cos(half), np.sin(half) * _sign(rng)
    if rng.random() < 0.5:
        return I1, I3, mgl, (turn * speed, 0.0, 0.0), np.array([c, s, 0.0, 0.0])
    return I1, I3, mgl, (0.0, turn * speed, 0.0), np.array([c, 0.0, s, 0.0])


EXAMPLES = (
    (0.9682719346341885, 0.18551392144253734, 0.8725861054209123, (-0.14539832407994902, 0.0, 0.0),
     (0.9968674072078577, 0.07909091254172769, 0.0, 0.0)),
    (1.0, 0.5, 1.0, (2.0, 0.0, 0.0), LEVEL),
    (1.0, 0.5, 2.0, (2.0, 0.0, 0.0), LEVEL),
    (1.0, 0.5, 1.0, (0.0, 0.0, 2.5), (0.8, 0.6, 0.0, 0.0)),
)


def traps(rng: Rng):
    """Single cases that once broke a formula in one language or another."""
    return EXAMPLES[rng.integers(len(EXAMPLES))]


def _plain(rng: Rng):
    return PLAIN[rng.integers(len(PLAIN))](rng)


def scaled(rng: Rng):
    I1, I3, mgl, momentum, q = _plain(rng)
    mass, rate = 2.0 ** rng.integers(-40, 41), 2.0 ** rng.integers(-40, 41)
    return I1 * mass, I3 * mass, mgl * mass * rate**2, np.array(momentum) * mass * rate, q


def below(rng: Rng):
    """mgl < 0."""
    I1, I3, mgl, momentum, q = _plain(rng)
    return I1, I3, -mgl, momentum, q


def not_quite_unit(rng: Rng):
    I1, I3, mgl, momentum, q = _plain(rng)
    return I1, I3, mgl, momentum, np.array(q) * (1 + _sign(rng) * _power(rng, -16, -6.1))


PLAIN: tuple[Family, ...] = (
    generic, wide_ratio, cusp, near_cusp, fast_loop, steady, near_steady, sleeping, hanging, near_sleeping,
    near_hanging, threshold, near_threshold, spherical_pendulum, near_spherical_pendulum, planar_pendulum, through_top,
    through_bottom, near_vertical_passage, separatrix, near_separatrix, weak, weightless_special, huge_spin,
    rounded_separatrix, planar_separatrix,
)  # fmt: skip
FAMILIES: tuple[Family, ...] = (*PLAIN, scaled, below, not_quite_unit, next_to_nothing, traps)


def draw_tops(
    count_per_family: int, seed: int, longest_turn: float = LONGEST_TURN, names: Collection[str] = ()
) -> list[TopCase]:
    """Return ``count_per_family`` cases of every family, or of those named, rate × |t| up to 10**``longest_turn``."""
    cases = []
    for number, family in enumerate(FAMILIES):
        if names and family.__name__ not in names:
            continue
        rng = np.random.default_rng([seed, number])
        for _ in range(count_per_family):
            I1, I3, mgl, momentum, attitude = family(rng)
            size = float(np.abs(momentum).max())
            rate = size / I1 + np.sqrt(abs(mgl) / I1) or 1.0
            time = _power(rng, SHORTEST_TURN, longest_turn) / rate * _sign(rng)
            moments = (float(I1), float(I1), float(I3))
            cases.append(TopCase(family.__name__, moments, float(mgl), tuple(map(float, momentum)),
                                 tuple(map(float, attitude)), float(time)))  # fmt: skip
    return cases
