"""What whole nutations of a Lagrange top add to a perturbation: the Hessian of the action, in closed form.

After one nutation T the motion is back but for phases θ_α, θ_β of α and β. T and both phases are first derivatives of
the action J(ε, c, a, G) = ∮ √f/(s t) ds with f = s t (ε + G s) − (c + a s)² = u̇², ε = |w|² − G s:
T = 2 J_ε, θ_α = ½(a T − J_a), θ_β = −J_c − θ_α. Of its second derivatives the poles drop out: all are sums of
I_k = ∮ s^k f^{−3/2} ds, finite parts, which the complete integrals B = ∫cos²/Δ and D = ∫sin²/Δ give with no difference
that cancels, whatever roots of f coincide, at the steady top and near the separatrix.
Source: Arnold, *Mathematical Methods of Classical Mechanics*, §50, for action and angles; DLMF 19.2 and 19.25(i).
"""

from __future__ import annotations

from typing import NamedTuple

from polhode._base.arrays import namespace
from polhode.special.carlson import carlson_rd
from polhode.types import Array, Complex128, Float64

Number = Float64[Array, "*batch"]
Complex = Complex128[Array, "*batch"]
Change = Float64[Array, "*shape"]  # with any axes before those of the batch
Moved = tuple[Complex128[Array, "*shape"], Complex128[Array, "*shape"], Complex128[Array, "*shape"]]


class Nutation(NamedTuple):
    """A top's invariants and turning points, one plain array each, each as accurate as possible."""

    G: Number
    a: Number
    c: Number  # p_φ − L3
    energy: Number  # ε
    s2: Number  # 1 − u2
    d: Number  # u2 − u1
    A: Number  # G (u3 − u1)
    B: Number  # G (u3 − u2)
    lift: Number  # by which the displacement is scaled up above and in the changes of ε and c, 1 for most tops
    climb: Number  # the x = ½√A τ by which each ascent and descent is longer than with the displacement scaled up


class Invariants(NamedTuple):
    """Changes of ε, c, a and G."""

    energy: Change
    c: Change
    a: Change
    G: Change


def moments_of_nutation(top: Nutation) -> tuple[tuple[Number, Number, Number, Number], Number]:
    """Return I_0 … I_3 and the period T by τ."""
    xp = namespace(top.A)
    m, m1 = top.G * top.d / top.A, top.B / top.A
    one = xp.ones_like(m1)
    # D = R_D(0, m1, 1)/3, B = m1 R_D(0, 1, m1)/3
    both = carlson_rd(xp.zeros_like(xp.stack([m1, m1])), xp.stack([m1, one]), xp.stack([one, m1])) / 3.0
    D, B = both[0], m1 * both[1]
    largest = 0.1  # parameter up to which (D − B)/m is summed as a series
    small = m < largest
    gap = xp.where(small, _gap(m), (D - B) / xp.where(small, 1.0, m))
    near_saddle = (m1 * (1.0 - 2.0 * m) * D - (1.0 + m) * B) / xp.where(m < 0.5, 1.0, m)
    third = xp.where(m < 0.5, gap - (B + D) - 2.0 * m1 * D, near_saddle)
    inverse = top.G / top.B  # 1/(u3 − u2)
    scale = 4.0 / (top.A * xp.sqrt(top.A))
    q0, q1 = scale * third * inverse * inverse, scale * (B + 2.0 * m1 * D) * inverse
    q2, q3 = -scale * (B + (1.0 - 2.0 * m) * D), -scale * (B + 2.0 * m1 * D) * top.d
    s = top.s2
    moments = (q0, s * q0 + q1, s * (s * q0 + 2.0 * q1) + q2, s * (s * (s * q0 + 3.0 * q1) + 3.0 * q2) + q3)
    return moments, 4.0 * (B + D) / xp.sqrt(top.A)


def _gap(m: Array) -> Array:
    """Return (D − B)/m = ∫ sin² cos² Δ^−3 by its power series, for m < 0.1."""
    ratios = [(n + 1.5) * (n + 1.5) / ((n + 1.0) * (n + 3.0)) for n in range(18)]
    total = 1.0 + 0.0 * m
    for ratio in ratios[::-1]:
        total = 1.0 + ratio * m * total
    return 0.19634954084936207 * total  # π/16


class NutationChange(NamedTuple):
    """A nutation's period by τ, and its changes with the invariants."""

    period: Number  # T
    period_change: Change
    twist: Change  # ½(δJ_a − T δa): δθ_α = ½ a δT − twist
    turn: Change  # −δJ_c = δ(θ_α + θ_β)


def change_of_nutation(top: Nutation, change: Invariants) -> NutationChange:
    """Return the period, and the changes of it and of the phases."""
    (I0, I1, I2, I3), period = moments_of_nutation(top)
    G, a, c, energy = top.G, top.a, top.c, top.energy
    e_c, e_a = 0.5 * (c * I0 + a * I1), 0.5 * (c * I1 + a * I2)
    de, dc, da, dG = change
    dT = 2.0 * (0.25 * (I2 - 2.0 * I1) * de + e_c * dc + e_a * da + 0.25 * (I3 - 2.0 * I2) * dG)
    longer, d_longer = _change_of_climbs(top, change)
    period, dT = period + longer, dT + d_longer
    mixed = energy * I1 + G * I2
    dJc = e_c * de - (energy * I0 + G * I1) * dc - mixed * da + e_a * dG
    # of first order in the displacement: what is of second order beside it would count once it is scaled up
    of_displacement = (e_a * (de / top.lift) - mixed * (dc / top.lift)) / top.lift
    dJa = of_displacement - (energy * I2 + G * I3) * da + 0.5 * (c * I2 + a * I3) * dG
    # during the climbs α turns by ½a and β not at all
    return NutationChange(period, dT, 0.5 * (dJa - period * da), 0.5 * (a * d_longer + longer * da) - dJc)


def _change_of_climbs(top: Nutation, change: Invariants) -> tuple[Number, Change]:
    """Return the time by τ of an ascent and a descent beyond the given numbers, 2 climb/W, and its change.

    W = ½√(2G − a²) is the rate at which an upright top leaves.
    """
    W = 0.5 * namespace(top.A).sqrt(top.A)
    time = 2.0 * top.climb / W
    return time, -time * (change.G - top.a * change.a) / (4.0 * W * W)


def added_by_nutation(
    top: Nutation, start: tuple[Complex, Complex, Complex], change: Invariants
) -> Moved:
    """Return the contribution of one nutation to the changes of α, β and w, after its phases are removed.

    That is −ẏ δT and the turns by δθ_α and δθ_β, with a δT taken out of each where it cancels.

    Args:
        top: the nutation.
        start: α, β and w, complex.
        change: of the invariants.
    """
    period, dT, twist, turn = change_of_nutation(top, change)
    alpha, beta, w = start
    conj = namespace(period).conj
    return (
        0.5 * conj(w) * beta * dT - 1j * alpha * twist,
        -0.5 * w * alpha * dT + 1j * beta * (twist + turn),
        -top.G * conj(alpha) * beta * dT + 1j * w * (2.0 * twist + turn - top.a * dT),
    )
