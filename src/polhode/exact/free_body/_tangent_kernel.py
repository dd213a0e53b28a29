"""The integrals of elliptic functions behind the derivatives of the free motion, regular for every modulus.

With u = √b t, m = g/b and m1 = κ/b: s = sn u/√b, c = cn u, d = dn u, ρ = ∫₀ᵗ s², σ = ∫₀ᵗ (s/d)². They obey
t = s c/d + b ρ + κ σ. ρ and σ come from the logarithmic derivatives of theta functions of the smaller nome, and from
Taylor series where u is small and those cancel. Sources: Whittaker & Watson, ch. 21–22; DLMF 20.7, 22.16.
"""

from __future__ import annotations

from typing import NamedTuple

from polhode._base.arrays import namespace
from polhode.special.elliptic import jacobi_at_reduced_phase, nome, sd_squared_over_half_period
from polhode.types import Array, ArrayOrFloat, Float64

Number = Float64[Array, "*batch"]
Operand = Float64[ArrayOrFloat, "*#shape"]


class Kernel(NamedTuple):
    """s, c, d, ρ, σ as the module's head defines them."""

    s: Number
    c: Number
    d: Number
    rho: Number
    sigma: Number


def elliptic_kernel(
    time: Operand,
    b: Operand,
    g: Operand,
    kappa: Operand,
    turns: Operand,
    rest: tuple[Operand, Operand],
    to_quarter: Operand,
) -> Kernel:
    """Return the kernel at √b t = 2K turns + rest, |rest| ≤ K, with K − |rest| given without cancellation.

    ``b ≥ g ≥ 0`` and ``kappa = b − g`` are given each to its last digit.
    """
    xp = namespace(b)
    positive = b > 0
    safe = xp.where(positive, b, 1.0)
    rate = xp.sqrt(safe)
    m, m1 = g / safe, xp.where(positive, kappa / safe, 1.0)
    full = g <= kappa
    q = nome(xp.where(full, m, m1))
    sine, cosine, delta, F = jacobi_at_reduced_phase(q, full, rest, to_quarter)
    turning = (turns != 0) & (full | (q > 0))
    F = F + xp.where(turning, turns * sd_squared_over_half_period(xp.where(turning, q, 0.04), full), 0.0)
    # sn and cn change sign with each 2K, dn does not
    odd = 1.0 - 2.0 * (turns - 2.0 * xp.floor(0.5 * turns))
    sine, cosine = odd * sine, odd * cosine
    u = xp.where(positive, rate * time, 0.0)
    # ∫sn² du, by t = s c/d + bρ + κσ
    G = u - sine * cosine / delta - m1 * F
    small = xp.abs(u) < 0.5  # where the series in u² are used
    X = xp.where(small, b * time * time, 0.0)
    y, over_sn, over_sd = _series(X, m, m1)
    s = xp.where(small, time * xp.sqrt(y), sine / rate)
    ss = xp.where(small, s * s, 0.0)
    cube = xp.where(small, time * time * time, 0.0)
    return Kernel(
        s=s,
        c=xp.where(small, xp.sqrt(xp.abs(1.0 - b * ss)), cosine),
        d=xp.where(small, xp.sqrt(xp.abs(1.0 - g * ss)), delta),
        rho=xp.where(small, cube * over_sn, G / rate / safe),
        sigma=xp.where(small, cube * over_sd, F / rate / safe),
    )


def _series(X: Array, m: Array, m1: Array) -> tuple[Array, Array, Array]:
    """Return sn²/u², ∫sn²/u³ and ∫sd²/u³ as series in X = u²: y″ = 2 − 4(1+m)y + 6my² and its like for sd²."""
    xp = namespace(X)

    def coefficients(linear: Array, square: Array) -> list[Array]:
        e = [xp.ones_like(X)]
        for k in range(1, 14):  # the first term left out is below 1e-17
            products = e[0] * 0.0
            for j in range(k - 1):
                products = products + e[j] * e[k - 2 - j]
            e.append((linear * e[k - 1] + square * products) / ((2 * k + 2) * (2 * k + 1)))
        return e

    def polynomial(terms: list[Array]) -> Array:
        value = terms[-1]
        for term in terms[-2::-1]:
            value = term + X * value
        return value

    # (sd²)″ = 2 + 4(m − m1) sd² − 6 m m1 sd⁴, so that both start as u²; ∫ of u²·u^2k is u^(2k+3)/(2k + 3)
    e, f = coefficients(-4.0 * (1.0 + m), 6.0 * m), coefficients(4.0 * (m - m1), -6.0 * m * m1)
    integrated = lambda c: [x / (2 * k + 3) for k, x in enumerate(c)]  # noqa: E731
    return polynomial(e), polynomial(integrated(e)), polynomial(integrated(f))
