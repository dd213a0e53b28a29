"""Bodies and spins that break formulas: seeded draws over every nasty family of the free rigid body.

A family is a function of a random generator that gives moments and momentum; times are drawn the same way for all,
|ω||t| log-uniform from 1e-2 to 1e15 with either sign, and every third case has its axes shuffled.
"""

from __future__ import annotations

from collections.abc import Callable, Collection
from typing import NamedTuple

import numpy as np

Vector = tuple[float, float, float]
Rng = np.random.Generator
Family = Callable[[Rng], tuple[np.ndarray, np.ndarray]]
SHORTEST_TURN, LONGEST_TURN = -2.0, 15.0
"""Powers of ten of the angle |ω| t."""


class Case(NamedTuple):
    """One body, its momentum along the principal axes at time 0, and the time asked for."""

    family: str
    moments: Vector
    momentum: Vector
    time: float


def _power(rng: Rng, low: float, high: float) -> float:
    return float(10.0 ** rng.uniform(low, high))


def _sign(rng: Rng) -> float:
    return float(rng.choice((-1.0, 1.0)))


def _triaxial(rng: Rng) -> np.ndarray:
    return np.sort(rng.uniform(0.1, 1.0, 3)) * _power(rng, -1, 1)


def _direction(rng: Rng) -> np.ndarray:
    vector = rng.normal(size=3)
    return vector / np.linalg.norm(vector) * _power(rng, -1, 1)


def _slope(moments: np.ndarray) -> float:
    """L1/L3 on the separatrix."""
    i1, i2, i3 = moments
    return float(np.sqrt((i3 - i2) * i1 / ((i2 - i1) * i3)))


def generic(rng: Rng):
    return _triaxial(rng), _direction(rng)


def short_axis(rng: Rng):
    moments = _triaxial(rng)
    l2, l3 = rng.normal(size=2)
    return moments, np.array([_slope(moments) * l3 * rng.uniform(-1, 1), l2, l3])


def long_axis(rng: Rng):
    moments = _triaxial(rng)
    l1, l2 = rng.normal(size=2)
    return moments, np.array([l1, l2, l1 / _slope(moments) * rng.uniform(-1, 1)])


def wide_moments(rng: Rng):
    return np.sort(10.0 ** rng.uniform(-12, 12, 3)), _direction(rng)


def wide_spin(rng: Rng):
    """Angular velocity in any direction: the momentum lies along the heavy axis, to as little as 1e-12."""
    moments = np.sort(10.0 ** rng.uniform(-6, 6, 3))
    momentum = _direction(rng) * moments
    return moments, momentum / np.linalg.norm(momentum) * _power(rng, -3, 3)


def near_oblate(rng: Rng):
    i1, i3 = np.sort(rng.uniform(0.1, 1, 2))
    return np.array([i1, i1 * (1 + _power(rng, -17, -1)), i3 * 1.3]), _direction(rng)


def near_prolate(rng: Rng):
    i1, i3 = np.sort(rng.uniform(0.1, 1, 2))
    return np.array([i1 / 1.3, i3 * (1 - _power(rng, -17, -1)), i3]), _direction(rng)


def near_sphere(rng: Rng):
    return _power(rng, -1, 1) * (1 + np.array([0.0, _power(rng, -17, -1), _power(rng, -17, -1)])), _direction(rng)


def near_separatrix(rng: Rng):
    moments = _triaxial(rng)
    l3, l2 = rng.normal() * _power(rng, -3, 0), rng.normal()
    return moments, np.array([_sign(rng) * _slope(moments) * l3 * (1 + _sign(rng) * _power(rng, -17, -2)), l2, l3])


def near_separatrix_backward(rng: Rng):
    """L1 < 0 near the separatrix: the start lies on the far half of the polhode."""
    moments = _triaxial(rng)
    l2, l3 = rng.normal(size=2)
    return moments, np.array([-_slope(moments) * abs(l3) * (1 + _sign(rng) * _power(rng, -17, -2)), l2, l3])


def saddle(rng: Rng):
    """A start as close to the unstable axis as 1e-150, on or off the separatrix."""
    moments = _triaxial(rng)
    l3 = _sign(rng) * _power(rng, -150, -1)
    ratio = _sign(rng) * (1 + _sign(rng) * _power(rng, -17, 0)) if rng.random() < 0.7 else _power(rng, -100, 100)
    return moments, np.array([_slope(moments) * l3 * ratio, _sign(rng) * _power(rng, -1, 1), l3])


def separatrix_near_symmetric(rng: Rng):
    i1, i3 = np.sort(rng.uniform(0.1, 1, 2))
    gap = _power(rng, -15, -2)
    moments = np.array([i1, i1 * (1 + gap), i3 * 1.3] if rng.random() < 0.5 else [i1 / 1.3, i3 * (1 - gap), i3])
    l2, l3 = rng.normal(), rng.normal() * _power(rng, -9, 0)
    return moments, np.array([_sign(rng) * _slope(moments) * l3 * (1 + _sign(rng) * _power(rng, -17, -2)), l2, l3])


EXACT_SEPARATRICES = ((3, 4, 6, 1, 1), (2, 5, 6, 1, 3), (3, 5, 8, 3, 4), (4, 5, 9, 4, 3), (9, 10, 18, 2, 1))


def exact_separatrix(rng: Rng):
    """(I2-I1) I3 L1² = (I3-I2) I1 L3² in whole numbers, scaled by powers of two; some starts at the saddle."""
    i1, i2, i3, l1, l3 = EXACT_SEPARATRICES[rng.integers(len(EXACT_SEPARATRICES))]
    small = 2.0 ** (-int(rng.integers(0, 500)) if rng.random() < 0.5 else 0)
    momentum = np.array([_sign(rng) * l1 * small, rng.normal() * 3, _sign(rng) * l3 * small])
    return np.array([i1, i2, i3]) * 2.0 ** int(rng.integers(-9, 9)), momentum


def near_permanent(rng: Rng):
    momentum = np.array([_sign(rng) * _power(rng, -150, -1) for _ in range(3)])
    momentum[rng.integers(3)] = _sign(rng) * _power(rng, -1, 1)
    return _triaxial(rng), momentum


def flat(rng: Rng):
    i1, i2 = np.sort(rng.uniform(0.1, 1, 2))
    return np.array([i1, i2, i1 + i2]), _direction(rng)


def sphere(rng: Rng):
    return np.full(3, _power(rng, -3, 3)), _direction(rng)


def oblate(rng: Rng):
    i1, i3 = np.sort(rng.uniform(0.1, 1, 2))
    momentum = _direction(rng)
    momentum[2] *= rng.choice((1.0, 1e-8, 1e-100, 0.0))
    return np.array([i1, i1, i3]), momentum


def prolate(rng: Rng):
    i1, i3 = np.sort(rng.uniform(0.1, 1, 2))
    momentum = _direction(rng)
    momentum[0] *= rng.choice((1.0, 1e-8, 1e-100, 0.0))
    return np.array([i1, i3, i3]), momentum


def permanent(rng: Rng):
    momentum = np.zeros(3)
    momentum[rng.integers(3)] = _sign(rng) * _power(rng, -3, 3)
    return _triaxial(rng), momentum


def zero_component(rng: Rng):
    momentum = _direction(rng)
    momentum[rng.integers(3)] = 0.0
    return _triaxial(rng), momentum


def one_ulp(rng: Rng):
    """Moments one unit in the last place apart."""
    i1, i3 = np.sort(rng.uniform(0.1, 1, 2))
    above, two_above = np.nextafter(i1, 2.0), np.nextafter(np.nextafter(i1, 2.0), 2.0)
    choices = ([i1, above, i3 * 1.3], [i1 / 1.3, i3, np.nextafter(i3, 2.0)], [i1, above, two_above], [i1, i1, above])
    return np.array(choices[rng.integers(4)]), _direction(rng) * (1.0, 1.0, rng.choice((1.0, 1e-8)))


def huge_scale(rng: Rng):
    return _triaxial(rng) * _power(rng, -100, 100), _direction(rng) * _power(rng, -100, 100)


def tiny_components(rng: Rng):
    """One component leads; the others, or one of them, are down to 1e-290 of it, where their squares vanish."""
    momentum = np.array([_sign(rng) * _power(rng, -290, -130) * rng.choice((0.0, 1.0, 1.0)) for _ in range(3)])
    momentum[rng.integers(3)] = _sign(rng) * _power(rng, -1, 1)
    return _triaxial(rng), momentum


TRAPS = (
    ((3, 4, 6), (1, 2.5, 1)),
    ((3, 4, 6), (-1, 0.3, 1)),
    ((3, 4, 6), (-1, -7.1, -1)),
    ((0.03507562337, 0.03507562339, 9.578), (4.0, -3.0, 5e-6)),
    ((0.05198459, 0.58218555469275, 0.58218555469287), (4e-8, -3.0, 2.0)),
    ((2.7147, 6.9814, 6.9814), (-1.2e-114, 3.56, -4.4e-100)),
    ((0.0232, 0.0349, 0.0377), (-1.3e-58, -7.02, -3.4e-58)),
    ((0.1283117113776, 0.1283117113784, 0.5717), (7.2, 8.5, -2e-5)),
    ((1, 2, 3), (1e-6, 2, 3e-6)),
    ((1.0, 2.0, 3.0), (0.01, 2.0, 0.03)),
)


def traps(rng: Rng):
    """Single cases that once broke a formula."""
    moments, momentum = TRAPS[rng.integers(len(TRAPS))]
    return np.array(moments, float), np.array(momentum, float)


FAMILIES: tuple[Family, ...] = (
    generic, short_axis, long_axis, wide_moments, wide_spin, near_oblate, near_prolate, near_sphere,
    near_separatrix, near_separatrix_backward, saddle, separatrix_near_symmetric, exact_separatrix, near_permanent,
    flat, sphere, oblate, prolate, permanent, zero_component, one_ulp, huge_scale, traps,
    tiny_components,
)  # fmt: skip


def _speed(family: Callable[..., object], moments: np.ndarray, momentum: np.ndarray) -> float:
    """|ω|; for spins that hide a far faster rate, |L|/I_min, which is what a phase in double-double has to carry."""
    if family is wide_spin:
        return float(np.linalg.norm(momentum) / moments.min())
    spin = momentum / moments
    return float(np.abs(spin).max() * np.linalg.norm(spin / np.abs(spin).max()))


def draw(
    count_per_family: int, seed: int, longest_turn: float = LONGEST_TURN, names: Collection[str] = ()
) -> list[Case]:
    """Return ``count_per_family`` cases of every family, or of those named, |ω||t| up to 10**``longest_turn``."""
    cases = []
    for number, family in enumerate(FAMILIES):
        if names and family.__name__ not in names:
            continue
        rng = np.random.default_rng([seed, number])
        for index in range(count_per_family):
            moments, momentum = family(rng)
            speed = _speed(family, moments, momentum)
            time = _power(rng, SHORTEST_TURN, longest_turn) / speed * (-1.0 if rng.random() < 1 / 3 else 1.0)
            order = rng.permutation(3) if index % 3 == 2 else np.arange(3)
            cases.append(Case(family.__name__, tuple(moments[order].tolist()), tuple(momentum[order].tolist()), time))
    return cases
