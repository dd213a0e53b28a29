"""The integrals of elliptic functions behind the derivatives of the free motion, regular for every modulus.

With u = √b t, m = g/b and m1 = κ/b: s = sn u/√b, c = cn u, d = dn u, ρ = ∫₀ᵗ s², σ = ∫₀ᵗ (s/d)². They obey
t = s c/d + b ρ + κ σ. ρ and σ come from the logarithmic derivatives of theta functions of the smaller nome, and from
Taylor series where u is small and those cancel. Sources: Whittaker & Watson, ch. 21–22; DLMF 20.7, 22.16.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

from polhode.arrays import namespace
from polhode.special import doubledouble as dd

Array = Any
SMALL = 0.5  # |u| below which the series in u² are used
TERMS = 14  # the first term left out is below 1e-17 there
FARTHEST = 340.0  # of the hyperbolic argument: beyond it e^2x overflows


class Kernel(NamedTuple):
    """s, c, d, ρ, σ as the module's head defines them."""

    s: Array
    c: Array
    d: Array
    rho: Array
    sigma: Array


def elliptic_kernel(
    time: Array, b: Array, g: Array, kappa: Array, turns: Array, rest: tuple[Array, Array], to_quarter: Array
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
    q = _nome(xp.where(full, m, m1))
    sine, cosine, delta, F, half_turn = _of_reduced_phase(q, full, rest, to_quarter, turns)
    F = F + turns * half_turn
    odd = 1.0 - 2.0 * (turns - 2.0 * xp.floor(0.5 * turns))
    sine, cosine = odd * sine, odd * cosine
    u = xp.where(positive, rate * time, 0.0)
    G = u - sine * cosine / delta - m1 * F
    small = xp.abs(u) < SMALL
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


def _nome(parameter: Array) -> Array:
    xp = namespace(parameter)
    k = xp.sqrt(1.0 - parameter)
    e = 0.5 * parameter / ((1.0 + k) * (1.0 + xp.sqrt(k)) ** 2)
    e4 = e**4
    return e * (1.0 + e4 * (2.0 + e4 * (15.0 + e4 * (150.0 + e4 * 1707.0))))


def _of_reduced_phase(
    q: Array, full: Array, rest: tuple[Array, Array], to_quarter: Array, turns: Array
) -> tuple[Array, Array, Array, Array, Array]:
    """Return sn, cn, dn, F = ∫ sd² du at the reduced phase, and F over a half turn, in the smaller nome."""
    xp = namespace(q)
    q3, q8 = q**3, q**8
    t2, t3, t4 = 1.0 + q**2 + q**6, 1.0 + 2.0 * (q + q**4 + q**9), 1.0 - 2.0 * (q - q**4 + q**9)
    c2 = t3**6 / (4.0 * t2**4 * t4**4)
    kq = 2.0 + 8.0 * q3 + 18.0 * q8
    circular = _circular(q, (t2, t3, t4), c2, kq, xp.where(full, (rest[0] + rest[1]) / t3**2, 0.5))
    hyperbolic = _hyperbolic(q, (t2, t3, t4), c2, kq, rest, to_quarter, full)
    safe = xp.where((q > 0) & (turns != 0), q, 1.0)
    half_circular = c2 * kq * math.pi / t3
    half_hyperbolic = c2 * (0.5 / safe + kq * xp.log(safe) / t3)
    half = xp.where(turns != 0, xp.where(full, half_circular, half_hyperbolic), 0.0)
    return (*(xp.where(full, x, y) for x, y in zip(circular, hyperbolic, strict=True)), half)  # type: ignore[return-value]


def _circular(q: Array, thetas: tuple[Array, ...], c2: Array, kq: Array, z: Array) -> tuple[Array, ...]:
    xp = namespace(q)
    t2, t3, t4 = thetas
    first = (xp.sin(z), xp.cos(z))
    sines, cosines = [first[0]], [first[1]]
    for _ in range(5):
        s, c = sines[-1], cosines[-1]
        sines.append(s * first[1] + c * first[0])
        cosines.append(c * first[1] - s * first[0])
    s1, s2, s3, s4, s5, s6 = sines
    e1, e2, e3, e4, e5, e6 = cosines
    a1, a2 = s1 - q**2 * s3 + q**6 * s5, e1 + q**2 * e3 + q**6 * e5
    a3 = 1.0 + 2.0 * (q * e2 + q**4 * e4 + q**9 * e6)
    a4 = 1.0 - 2.0 * (q * e2 - q**4 * e4 + q**9 * e6)
    F = c2 * (kq * z / t3 - (s2 + 2.0 * q**3 * s4 + 3.0 * q**8 * s6) / a3)
    return t3 / t2 * a1 / a4, t4 / t2 * a2 / a4, t4 / t3 * a3 / a4, F


def _hyperbolic(
    q: Array, thetas: tuple[Array, ...], c2: Array, kq: Array, rest: tuple[Array, Array], to_quarter: Array, full: Array
) -> tuple[Array, ...]:
    xp = namespace(q)
    t2, t3, t4 = thetas
    side = xp.where(rest[0] < 0, -1.0, 1.0)
    e = t3 - 1.0
    shrink = e * (2.0 + e) / t3**2  # 1 − 1/θ3²
    v = xp.where(full, 0.5, side * rest[0])
    x, low = dd.two_sum(v, -v * shrink)
    low = low + xp.where(full, 0.0, side * rest[1]) * (1.0 - shrink)
    x = xp.minimum(x, FARTHEST + 0.0 * x)
    decay = xp.exp(-x) * (1.0 - low)
    h = decay * decay
    r = xp.where(q > 0, xp.exp(-2.0 * xp.where(full, 0.0, to_quarter) / t3**2), 0.0)  # = q e^2x ≤ 1
    q1r, q2r, q3r = q * r, q * q * r, q**3 * r
    h3, h5 = h**3, h**5
    g1 = (1.0 - h) - q1r * (1.0 - h3) + q2r**2 * (1.0 - h5) - q3r**3 * (1.0 - h5 * h * h)
    g2 = (1.0 + h) + q1r * (1.0 + h3) + q2r**2 * (1.0 + h5) + q3r**3 * (1.0 + h5 * h * h)
    o1, o2, o3, o4 = r + q * h, q1r**2 + (q * q * h) ** 2, q2r**3 + (q**3 * h) ** 3, q3r**4
    g3, g4 = 1.0 + o1 + o2 + o3 + o4, 1.0 - o1 + o2 - o3 + o4
    sn, cn, dn = side * t3 / t4 * g1 / g2, t2 / t4 * 2.0 * decay * g4 / g2, t2 / t3 * 2.0 * decay * g3 / g2
    sinh = 0.5 / h * ((1.0 - h * h) + 2.0 * q * q1r * (1.0 - h**4) + 3.0 * q**6 * r**2 * (1.0 - h**6))
    return sn, cn, dn, side * c2 * (sinh / g3 - kq * x / t3)


def _series(X: Array, m: Array, m1: Array) -> tuple[Array, Array, Array]:
    """Return sn²/u², ∫sn²/u³ and ∫sd²/u³ as series in X = u²: y″ = 2 − 4(1+m)y + 6my² and its like for sd²."""
    xp = namespace(X)

    def coefficients(linear: Array, square: Array) -> list[Array]:
        e = [xp.ones_like(X)]
        for k in range(1, TERMS):
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

    e, f = coefficients(-4.0 * (1.0 + m), 6.0 * m), coefficients(4.0 * (m - m1), -6.0 * m * m1)
    integrated = lambda c: [x / (2 * k + 3) for k, x in enumerate(c)]  # noqa: E731
    return polynomial(e), polynomial(integrated(e)), polynomial(integrated(f))
