"""Legendre functions P_ν(cos θ) on the cut, for complex degrees ν whose ν(ν+1) is real.

With −ν(ν+1) = κ the series of ₂F₁(−ν, ν+1; 1; x), x = (1 − cos θ)/2, has real terms, whatever ν is. Beyond x = ½ it is
continued in 1 − x, where it has a logarithm. Source: NIST DLMF 14.3.1, 15.2.1, 15.8.10.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np

from polhode._base.arrays import namespace
from polhode._base.extras import needing
from polhode.types import Array, Float64

EULER = 0.57721566490153286061


class LegendreFunction(NamedTuple):
    """P_ν(cos θ) as coefficients of its two series, made by ``legendre_function``.

    Attributes:
        near: (n,) of xⁿ.
        far: (n,) of (1 − x)ⁿ next to the logarithm: near · (2ψ(n+1) − ψ(n−ν) − ψ(n+ν+1)).
        sine: sin(π(ν+1))/π, the weight of the second solution.
    """

    near: Float64[Array, "n"]
    far: Float64[Array, "n"]
    sine: Float64[Array, ""]

    def values(self, tilt: Float64[Array, "*shape"]) -> tuple[Float64[Array, "*shape"], Float64[Array, "*shape"]]:
        """Return P_ν(cos θ) and its derivative by θ, at angles 0 ≤ θ < π, any shape."""
        xp = namespace(tilt)
        # P_ν = Σ (−ν)_n (ν+1)_n/(n!)² xⁿ (DLMF 14.3.1, 15.2.1); beyond x = ½ DLMF 15.8.10 with a = −ν, b = ν + 1:
        # P_ν = sin π(ν+1)/π · Σ (−ν)_n (ν+1)_n/(n!)² [2ψ(n+1) − ψ(n−ν) − ψ(n+ν+1) − ln y] yⁿ, where
        # 1/(Γ(−ν)Γ(ν+1)) = sin π(ν+1)/π by reflection
        x, y = xp.sin(0.5 * tilt) ** 2, xp.cos(0.5 * tilt) ** 2
        slope = 0.5 * xp.sin(tilt)  # dx/dθ = −dy/dθ
        below = x <= 0.5
        u = xp.where(below, x, 0.5)
        v = xp.where(below, 0.5, y)
        first, d_first = _sum(self.near, u)
        with_log, d_with_log = _sum(self.near, v)
        rest, d_rest = _sum(self.far, v)
        log = xp.log(v)
        second = self.sine * (rest - log * with_log)
        d_second = -self.sine * (d_rest - log * d_with_log - with_log / v)
        return xp.where(below, first, second), slope * xp.where(below, d_first, d_second)


def legendre_function(kappa: float) -> LegendreFunction:
    """Return P_ν for ν(ν+1) = −κ < 0.

    >>> round(float(legendre_function(2.0).values(np.asarray(1.0))[0]), 12)
    1.59239232636
    """
    with needing("Legendre functions need", alone=True):
        from scipy.special import digamma

    # −ν and ν + 1 are the roots of z(1 − z) = κ: both real or conjugates of each other, so that ψ(n−ν) + ψ(n+ν+1) is
    # real, and (n − ν)(n + ν + 1) = n(n+1) + κ
    nu = -0.5 + np.sqrt(complex(0.25 - kappa))
    near, far, terms = [1.0], [], 64  # in x ≤ ½ terms fall as xⁿ/n: the rest is below 1e-19 of the sum
    for n in range(terms):
        pair = digamma(n - nu) + digamma(n + nu + 1.0)
        far.append(near[n] * float((2.0 * _digamma(n + 1) - pair).real))
        near.append(near[n] * (n * (n + 1.0) + kappa) / (n + 1.0) ** 2)
    sine = float((np.sin(np.pi * (nu + 1.0)) / np.pi).real)
    return LegendreFunction(np.array(near[:terms]), np.array(far), np.asarray(sine))


def _digamma(n: int) -> float:
    # ψ(n) = −γ + Σ_{k<n} 1/k (DLMF 5.4.14)
    return math.fsum([-EULER, *(1.0 / k for k in range(1, n))])


def _sum(coefficients: Array, x: Array) -> tuple[Array, Array]:
    """Return a power series and its derivative, by Horner's rule in blocks: 14 steps to compile instead of 63."""
    xp = namespace(x)
    block = 8
    blocks = xp.reshape(xp.asarray(coefficients), (coefficients.shape[0] // block, block))
    inside = x[..., None] if x.ndim else xp.reshape(x, (1,))
    values, slopes = _horner([blocks[:, n] for n in range(block)], [0.0] * block, inside, 1.0)
    count = range(blocks.shape[0])
    return _horner([values[..., k] for k in count], [slopes[..., k] for k in count], x**block, block * x ** (block - 1))


def _horner(coefficients: list[Array], slopes: list[Any], y: Array, dy: Any) -> tuple[Array, Array]:
    """Return Σ cₙ yⁿ and its derivative, from the derivatives of cₙ and of y."""
    value, slope = coefficients[-1] + 0.0 * y, slopes[-1] + 0.0 * y
    for c, d in zip(coefficients[-2::-1], slopes[-2::-1], strict=True):
        slope = d + dy * value + y * slope
        value = c + y * value
    return value, slope
