"""The time in which internal losses bring a body to a flat spin, by the energy-sink method.

Losses are so slow that L runs round one polhode after another: dE/dt = −α ⟨|L × Ω|²⟩, the mean over the polhode of
energy E, which complete elliptic integrals give. Along the way 1/⟨…⟩ grows as a logarithm at the separatrix, and
without bound towards the axis of least moment; the integral over E is taken by variables in which it is smooth.

Source: Likins, J. Spacecraft 3 (1966) 1638; Hughes, *Spacecraft Attitude Dynamics*, §5.4 for the method; the losses are
those of the double bracket.
"""

from __future__ import annotations

import math

import numpy as np

from polhode._base import check
from polhode._base.arrays import known_numbers_only
from polhode.errors import InvalidInput
from polhode.exact.free_body import FreeMotion
from polhode.special.carlson import carlson_rd
from polhode.types import Array, ArrayLike, Float64, Real

FLAT = math.radians(5.0)  # of L to the major axis, within which it is a flat spin


@known_numbers_only
def flat_spin_time(
    moments: Real[ArrayLike, "3"], momentum: Real[ArrayLike, "3"], rate: float, angle: float = FLAT
) -> float | None:
    """Return the time [s] after which L stays within an angle of the major axis; None if it never gets there.

    Zero if it starts there. None for a sphere and for a start exactly on another principal axis, as losses change
    neither motion, and on the separatrix.

    Args:
        moments: (3,) principal moments [kg m²], ascending.
        momentum: (3,) L at the start [kg m²/s, principal axes].
        rate: α of the double bracket L̇ = L × Ω + α L × (L × Ω) [s/(kg m²)].
        angle: from the major axis [rad], below a right angle.

    Raises:
        InvalidInput: for moments that do not ascend, or values out of range.

    >>> body, L = (1.0, 1.0, 2.0), (0.8, 0.0, 0.6)
    >>> falls = math.log((0.8 / 0.6) / math.tan(math.radians(5.0)))  # tan θ of a symmetric body, as an exponential
    >>> round(flat_spin_time(body, L, 0.01), 4), round(falls / (0.01 * 0.5), 4)
    (544.7856, 544.7856)
    """
    I, L = _check_arguments(moments, momentum, rate, angle)  # noqa: E741
    norm2 = float(L @ L)
    if not norm2 or I[0] == I[2]:
        return None
    # 2E = Σ L_i²/I_i less |L|²/I₃, |L|²/I₁ and |L|²/I₂: differences of energies as sums of terms that do not cancel
    least, across = 1.0 / I[0] - 1.0 / I[2], (I[1] - I[0]) / (I[0] * I[1])  # 1/I1 − 1/I3, 1/I1 − 1/I2
    rest = (I[2] - I[1]) / (I[1] * I[2])  # 1/I2 − 1/I3
    above = 0.5 * (least * L[0] ** 2 + rest * L[1] ** 2)  # E − E_min
    below = 0.5 * (across * L[1] ** 2 + least * L[2] ** 2)  # E_max − E
    beyond = 0.5 * (across * L[0] ** 2 - rest * L[2] ** 2)  # E − E_separatrix
    top, middle = 0.5 * least * norm2, 0.5 * rest * norm2  # E_max − E_min, E_separatrix − E_min
    # a polhode about the major axis is farthest from it where L₁ = 0: 2(E − E_min) = (1/I₂ − 1/I₃) |L|² sin²
    end = 0.5 * math.sin(angle) ** 2 * (rest if rest else least) * norm2
    if above <= end:
        return 0.0
    if not below or not beyond:
        return None
    if middle == 0.0:  # two largest moments: no separatrix on the way
        waited = _integral(I, norm2, -math.log1p(-end / top), math.log1p(above / below), True)
    elif beyond > 0.0:
        waited = _integral(I, norm2, 0.0, math.log1p(beyond / below), True)
        waited += _integral(I, norm2, 0.0, math.log(middle / end), False)
    else:
        waited = _integral(I, norm2, math.log1p(-beyond / above), math.log(middle / end), False)
    return waited / rate


@known_numbers_only
def sink_rate_by_loss(moments: Real[ArrayLike, "3"], momentum: Real[ArrayLike, "3"], power: float) -> float:
    """Return α [s/(kg m²)] of losses that take a mean power on the polhode of a start.

    Args:
        moments: (3,) principal moments [kg m²], ascending.
        momentum: (3,) L at the start [kg m²/s, principal axes].
        power: [W].

    Raises:
        InvalidInput: for a start that loses nothing, steadily about an axis or at rest.

    >>> round(sink_rate_by_loss((1.0, 1.0, 2.0), (0.8, 0.0, 0.6), 0.01 * (0.5 * 0.8 * 0.6) ** 2), 12)
    0.01
    """
    samples = 512  # of a polhode, over which means converge exponentially
    I, L = _check_arguments(moments, momentum, power, FLAT)  # noqa: E741
    motion = FreeMotion(I, momentum=L)
    if motion.period is None:
        raise InvalidInput(
            f"the start must turn about no axis steadily, or nothing is lost; its momentum is {L.tolist()} kg m²/s. "
            "Tilt it, or give the strength of the losses in another way."
        )
    period = float(motion.period) if math.isfinite(motion.period) else 0.0  # all of the separatrix is at its saddle
    loss = float(np.mean(_losses(I, np.asarray(motion.momentum(period * np.arange(samples) / samples)) ** 2)))
    return power / loss


@known_numbers_only
def sink_rate_by_time(moments: Real[ArrayLike, "3"], momentum_norm: float, time_constant: float) -> float:
    """Return α [s/(kg m²)] of losses by which the last approach to the major axis falls to 1/e in a time.

    The exponents there are those of a 2×2 matrix with trace −α|L|²(d₁ + d₂) and determinant (α²|L|⁴ + |L|²) d₁d₂, where
    d_k = 1/I_k − 1/I₃; that of the slower approach counts.

    Args:
        moments: (3,) principal moments [kg m²], ascending.
        momentum_norm: |L| [kg m²/s].
        time_constant: [s].

    Raises:
        InvalidInput: on a sphere, and for values out of range.

    >>> round(sink_rate_by_time((1.0, 1.0, 2.0), 2.0, 50.0), 12)
    0.01
    """
    I, L = _check_arguments(moments, (0.0, 0.0, momentum_norm), time_constant, FLAT)  # noqa: E741
    first, second = (I[2] - I[0]) / (I[0] * I[2]), (I[2] - I[1]) / (I[1] * I[2])
    square = float(L @ L)
    if not first or not square:
        raise InvalidInput("a sphere, or a body at rest, does not approach an axis; leave the damping time out.")
    oscillating = 2.0 / (time_constant * square * (first + second))
    if (oscillating * (first - second)) ** 2 * square <= 4.0 * first * second:
        return float(oscillating)
    if not second:
        return float(1.0 / (time_constant * square * first))
    # 1/τ² − α|L|²(d₁ + d₂)/τ + (α²|L|⁴ + |L|²) d₁d₂ = 0
    a, b = square * square * first * second, square * (first + second) / time_constant
    c = 1.0 / time_constant**2 + square * first * second
    return float((b + math.sqrt(b * b - 4.0 * a * c)) / (2.0 * a))


def _integral(I: Array, norm2: float, first: float, last: float, long: bool) -> float:  # noqa: E741
    """Return ∫ dE/⟨|L × Ω|²⟩ from one polhode to another on one side of the separatrix.

    They are given by w, the log of the energy's distance from the extremum on that side, at the separatrix over here:
    from E_max for long-axis modes, from E_min for short-axis modes.
    """
    least, across, rest = 1.0 / I[0] - 1.0 / I[2], (I[1] - I[0]) / (I[0] * I[1]), (I[2] - I[1]) / (I[1] * I[2])
    # the distance from the extremum is ½ own |L|² e^(−w), so that |dE| = ½ own |L|² e^(−w) dw
    w, weights = _panels(first, last)
    own, other = (across, rest) if long else (rest, across)
    # largest squares of L on the polhode: along the axis that it does not circle, the middle and the encircled one
    fall, past = np.exp(-w), other - own * np.expm1(-w)
    small, middle, large = norm2 * own / least * fall, norm2 * fall, norm2 * past / least
    # L is (cn, sn, dn) along these; parameter 1 − m is dn² where L is nearest to the middle axis
    m, m1 = other * fall / past, -least * np.expm1(-w) / past
    cs, sd, cd = _mean_products(m, m1)
    of_small, of_large = (rest, across) if long else (across, rest)  # 1/I − 1/I2 of the two axes
    means = of_small**2 * small * middle * cs + of_large**2 * middle * large * sd + least**2 * small * large * cd
    return float(np.sum(weights * 0.5 * own * norm2 * fall / means))


def _mean_products(m: Array, m1: Array) -> tuple[Array, Array, Array]:
    """Return the means of cn² sn², sn² dn² and cn² dn² over a period, for parameters m and 1 − m.

    With Δ² = 1 − m sin²φ let B = ∫ cos²φ/Δ, D = ∫ sin²φ/Δ and T = ∫ sin²φ cos²φ/Δ over a quarter turn. Then
    K = B + D, and (sin φ cos φ Δ)′ integrates to zero, whence 3 m T = B − (1 − m) D. Where B and D almost cancel,
    T = ½ Σ (½)_k/k! B(k + 3/2, 3/2) m^k. Source: DLMF 19.25.1 for B and D.
    """
    small = 0.1  # parameter up to which a series gives the difference of B and D without cancellation
    terms = 18  # of that series, the next being below small^18 = 1e-18
    zero, one = np.zeros_like(m), np.ones_like(m)
    D, B = carlson_rd(zero, m1, one) / 3.0, m1 * carlson_rd(zero, one, m1) / 3.0
    series, term = zero, 0.0625 * math.pi * one
    for k in range(terms):
        series = series + term
        term = term * m * (k + 0.5) * (k + 1.5) / ((k + 1.0) * (k + 3.0))
    T = np.where(m < small, series, (B - m1 * D) / (3.0 * np.maximum(m, small)))
    return T / (B + D), (m1 * D + m * T) / (B + D), (B - m * T) / (B + D)


def _panels(first: float, last: float) -> tuple[Float64[np.ndarray, "n"], Float64[np.ndarray, "n"]]:
    """Return points and weights (n,) between 0 ≤ first < last; at w = 0, the separatrix, the integrand may grow."""
    nearest = 2.0**-40  # of the way, to the separatrix; the part left out is below 1e-10 of the time
    count = 12  # of Gauss and Legendre in each panel; panels double in length away from the separatrix
    start = first or nearest * last
    borders = np.geomspace(start, last, 1 + math.ceil(math.log2(last / start)))
    nodes, weights = np.polynomial.legendre.leggauss(count)
    half = 0.5 * np.diff(borders)[:, None]
    return (borders[:-1, None] + half * (nodes + 1.0)).ravel(), (half * weights).ravel()


def _losses(I: Array, squares: Array) -> Float64[np.ndarray, "..."]:  # noqa: E741
    """Return |L × Ω|² (…) of squares (…, 3) of the components of L."""
    pairs = ((0, 1), (0, 2), (1, 2))
    terms = [((I[j] - I[i]) / (I[i] * I[j])) ** 2 * squares[..., i] * squares[..., j] for i, j in pairs]
    return np.sum(terms, axis=0)


def _check_arguments(moments: ArrayLike, momentum: ArrayLike, rate: float, angle: float) -> tuple[Array, Array]:
    I = check.array("moments", moments, (3,), "kg m²", above=0, ascending=True)  # noqa: E741
    L = check.array("momentum", momentum, (3,), "kg m²/s")
    rate = check.number("rate", rate, "s/(kg m²)", above=0)
    angle = check.number("angle", angle, "rad", above=0, below=0.5 * math.pi, rule="between 0 and π/2")
    return I, L
