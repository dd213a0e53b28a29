"""Jacobi's theta functions of real and complex argument, in real arithmetic.

θ1 = 2 Σ (−1)ⁿ q^{(n+½)²} sin (2n+1)z, θ2 = 2 Σ q^{(n+½)²} cos (2n+1)z, θ3 = 1 + 2 Σ q^{n²} cos 2nz,
θ4 = 1 + 2 Σ (−1)ⁿ q^{n²} cos 2nz (Whittaker & Watson, ch. 21; DLMF 20.2).
"""

from __future__ import annotations

from typing import NamedTuple

from polhode._base.arrays import as_float64, known_false, namespace
from polhode.errors import InvalidInput, shown
from polhode.types import Array, ArrayLike, Float64, Real


class ThetaLimits(NamedTuple):
    """What the series are accurate for."""

    max_nome: float = 0.2  # with the imaginary transformation e^−π = 0.043 is enough for any lattice


LIMITS = ThetaLimits()


def theta1(z: Real[ArrayLike, "*#shape"], q: Real[ArrayLike, "*#shape"]) -> Float64[Array, "*shape"]:
    """Return θ1(z, q) for real z and 0 ≤ q ≤ 0.2."""
    return theta(1, z, 0.0, q)[0]


def theta2(z: Real[ArrayLike, "*#shape"], q: Real[ArrayLike, "*#shape"]) -> Float64[Array, "*shape"]:
    """Return θ2(z, q) for real z and 0 ≤ q ≤ 0.2."""
    return theta(2, z, 0.0, q)[0]


def theta3(z: Real[ArrayLike, "*#shape"], q: Real[ArrayLike, "*#shape"]) -> Float64[Array, "*shape"]:
    """Return θ3(z, q) for real z and 0 ≤ q ≤ 0.2."""
    return theta(3, z, 0.0, q)[0]


def theta4(z: Real[ArrayLike, "*#shape"], q: Real[ArrayLike, "*#shape"]) -> Float64[Array, "*shape"]:
    """Return θ4(z, q) for real z and 0 ≤ q ≤ 0.2."""
    return theta(4, z, 0.0, q)[0]


def theta(
    kind: int, z: Real[ArrayLike, "*#shape"], y: Real[ArrayLike, "*#shape"], q: Real[ArrayLike, "*#shape"]
) -> tuple[Float64[Array, "*shape"], Float64[Array, "*shape"]]:
    """Return real and imaginary part of θ_kind(z + iy, q), kind 1 to 4, for |y| ≤ −ln q (a period of the lattice).

    Raises:
        InvalidInput: for another kind, or q outside [0, 0.2].
    """
    if kind not in (1, 2, 3, 4):
        raise InvalidInput(f"`kind` must be 1, 2, 3 or 4; got {shown(kind)}.")
    xp = namespace(z, y, q)
    z, y, q = (as_float64(xp, v, name) for v, name in ((z, "z"), (y, "y"), (q, "q")))
    if known_false(xp.all((q >= 0) & (q <= LIMITS.max_nome))):
        raise InvalidInput(f"`q` must lie in [0, {LIMITS.max_nome:g}]; take the complementary nome for larger ones.")
    # sin ω(z+iy) = sin ωz cosh ωy + i cos ωz sinh ωy, cos ω(z+iy) = cos ωz cosh ωy − i sin ωz sinh ωy
    zero = 0.0 * (z + y + q)
    real, imaginary = zero + (1.0 if kind > 2 else 0.0), zero
    for n in range(6):  # q^36 is below 1e-25
        power = (n + 0.5) ** 2 if kind < 3 else float((n + 1) ** 2)
        frequency = 2.0 * n + (1.0 if kind < 3 else 2.0)
        sign = -1.0 if (kind == 1 and n % 2) or (kind == 4 and n % 2 == 0) else 1.0
        weight = 2.0 * sign * q**power
        s, c = xp.sin(frequency * z), xp.cos(frequency * z)
        rise, fall = xp.cosh(frequency * y), xp.sinh(frequency * y)
        if kind == 1:
            real, imaginary = real + weight * s * rise, imaginary + weight * c * fall
        else:
            real, imaginary = real + weight * c * rise, imaginary - weight * s * fall
    return real, imaginary
