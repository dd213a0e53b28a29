"""Where a gyrostat's energy is critical on its momentum sphere: all roots of the equation for the multiplier.

Ω = λΠ gives Π_i = h_i/(1 − λI_i), and |Π| = |L| an equation for λ. Between two of its poles 1/I_i, where Σ Π_i² is
convex, it has two roots or none, and beyond the outermost ones a single root each; so none is missed. An axis without
a part of the rotor's momentum adds λ = 1/I_i, where Π_i is free.

Source: Hughes, *Spacecraft Attitude Dynamics*, §6.6.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable

import numpy as np

from polhode.types import Array, Float64

Factors = Callable[[float], Float64[Array, "3"]]


@np.errstate(all="ignore")  # what is infinite at a pole is larger than one
def steady_points(
    moments: Float64[Array, "3"], rotor: Float64[Array, "3"], norm: float
) -> Float64[np.ndarray, "count 3"]:
    """Return all Π (m, 3) with |Π| = norm at which Π × I⁻¹(Π − h) = 0, of a body without a circle of them.

    Args:
        moments: (3,) I.
        rotor: (3,) h.
        norm: |L|, positive.
    """
    h = rotor / norm
    points = [h / factors(u) for factors, u in _roots(moments, h)]
    for k in np.flatnonzero(h == 0.0):
        point = np.where(h == 0.0, 0.0, h / (1.0 - moments / moments[k]))
        rest = 1.0 - float(point @ point)
        points += [point + side * math.sqrt(rest) * np.eye(3)[k] for side in (1.0, -1.0) if rest > 0.0]
    vectors = np.array(points).reshape(-1, 3)
    return norm * vectors / np.linalg.norm(vectors, axis=1, keepdims=True)


def _roots(moments: Array, h: Array) -> list[tuple[Factors, float]]:
    """Return the factors 1 − λI_i as functions of a variable for each interval between poles, and its values."""
    farthest = 700.0  # logarithm of a distance from a pole whose exponential is still a double
    each = sorted({float(moment) for moment in moments[h != 0.0]}, reverse=True)  # their poles rise
    if not each:
        return []
    largest, smallest = each[0], each[-1]
    # λ = (1 ∓ eᵘ)/I beyond the first and the last pole; nothing cancels, as all factors have one sign there
    before: Factors = lambda u: (largest - moments) / largest + moments / largest * math.exp(u)  # noqa: E731
    behind: Factors = lambda u: (smallest - moments) / smallest - moments / smallest * math.exp(u)  # noqa: E731
    roots = [(f, _halve(lambda u, f=f: _excess(h, f(u)), -farthest, farthest)) for f in (before, behind)]
    for low, high in itertools.pairwise(each):
        factors = _make_factors(moments, low, high)
        # the least value is where the derivative by λ, 2 Σ I_i Π_i²/(1 − λI_i), changes its sign
        slope = lambda u, f=factors: -float(np.sum(np.where(h, moments * h**2 / f(u) ** 3, 0.0)))  # noqa: E731
        least = _halve(slope, -farthest, farthest)
        if _excess(h, factors(least)) < 0.0:
            excess = lambda u, f=factors: _excess(h, f(u))  # noqa: E731
            roots += [(factors, _halve(excess, -farthest, least)),
                      (factors, _halve(lambda u, g=excess: -g(u), least, farthest))]
    return roots


def _make_factors(moments: Array, low: float, high: float) -> Factors:
    """Return the factors between the poles 1/low and 1/high, at shares s and 1 − s of the way for s/(1 − s) = eᵘ."""
    width = (low - high) / (low * high)

    def factors(u: float) -> Float64[Array, "3"]:
        ahead, left = width / (1.0 + math.exp(-u)), width / (1.0 + math.exp(u))
        # from the pole that is on the same side as that of the moment, so that nothing cancels
        near = (low - moments) / low - moments * ahead, (high - moments) / high + moments * left
        return np.where(moments >= low, *near)

    return factors


def _excess(h: Array, factors: Array) -> float:
    return float(np.sum(np.where(h, (h / factors) ** 2, 0.0))) - 1.0


def _halve(function: Callable[[float], float], low: float, high: float) -> float:
    """Return where a function that is positive first becomes negative, to the last digit."""
    halvings = 200  # of an interval, until it is empty
    for _ in range(halvings):
        middle = 0.5 * (low + high)
        if middle in (low, high):
            break
        low, high = (middle, high) if function(middle) > 0.0 else (low, middle)
    return 0.5 * (low + high)
