"""The derivative of a Lagrange top's motion where the axis stays vertical: sleeping, hanging, at rest, almost upright.

About an upright top 4β'' = (2G − a²) β, so that perturbations turn or grow with constant coefficients; a hanging one is
an upright one with G < 0 on the reversed axis. A top on the separatrix that has come so near upright that |β|² is
rounding goes on like that, its own β falling as e^{−λσ}; what α feels of β̄ δβ, which stays, is added.
"""

from __future__ import annotations

from typing import NamedTuple

from polhode._base.arrays import namespace, split_halves
from polhode.special import _doubledouble as dd
from polhode.special._circular import reduced_phase, sine_cosine_turns, split_rate
from polhode.special._doubledouble import DoubleDouble
from polhode.types import Array, Bool, Complex128, Float64

Number = Float64[Array, "*batch"]
Flag = Bool[Array, "*batch"]
Complex = Complex128[Array, "*batch"]
Vector = tuple[Complex, Complex, Complex]  # α, β, w, complex
Change = Float64[Array, "*shape"]  # with any axes before those of the batch
Moved = tuple[Complex128[Array, "*shape"], Complex128[Array, "*shape"], Complex128[Array, "*shape"]]


class Growth(NamedTuple):
    """C and S solve y'' = κ y from (1, 0) and (0, 1) after σ = τ − τ1."""

    elapsed: Number  # σ
    kappa: Number
    C: Number
    S: Number
    decay: Number  # the exponent that the top's own β falls with, of the sign of σ; zero where β is


def growth(kappa: DoubleDouble, tau: DoubleDouble, begin: Number, falling: Flag) -> Growth:
    """Return the growth over τ − ``begin``.

    Args:
        kappa: κ, of either sign.
        tau: elapsed τ = t/I1.
        begin: τ from which the top is upright; zero where κ < 0.
        falling: whether a β of its own is to be followed.
    """
    xp = namespace(begin)
    rises = kappa[0] > 0
    root = dd.sqrt(dd.where(rises, kappa, dd.negate(kappa)))
    elapsed = dd.subtract(tau, dd.from_float(begin))
    exponent, low = dd.multiply(root, elapsed)
    largest = 340.0  # exponent of growth up to which a change is followed: its square and a flow's do not overflow
    far = xp.abs(exponent) > largest
    exponent = xp.where(far, xp.where(exponent < 0, -largest, largest), xp.where(rises, exponent, 0.0))
    low = xp.where(far, 0.0, low)
    cosh, sinh = xp.cosh(exponent), xp.sinh(exponent)
    zero = 0.0 * begin
    turns = dd.multiply(root, tuple(c + zero for c in dd.INVERSE_TWO_PI))
    # a stable top's phase is that of τ itself, whose low half counts
    fraction, rest, _ = reduced_phase(split_rate(*turns), split_halves(tau[0]))
    fraction = fraction + (rest + turns[0] * tau[1])
    sine, cosine = sine_cosine_turns(fraction - xp.round(fraction))
    some = root[0] > 0
    S = xp.where(rises, sinh + cosh * low, sine) / xp.where(some, root[0], 1.0)
    C = xp.where(rises, cosh + sinh * low, cosine)
    decay = xp.where(falling, xp.where(elapsed[0] < 0, -root[0], root[0]), 0.0)
    return Growth(elapsed[0], kappa[0], C, xp.where(some, S, elapsed[0]), decay)


def upright_change(a: Number, now: Vector, change: Moved, of: tuple[Change, Change], by: Growth) -> Moved:
    """Return the changes of α, β, w at σ near a top that is or becomes upright, α's own phase ½aσ taken off.

    Args:
        a: of the top.
        now: α, β, w at σ = 0.
        change: of them.
        of: changes of a and of c' = p_φ + a.
        by: the growth over σ.
    """
    xp = namespace(a)
    alpha, beta, w = now
    da, dc_plus = of
    own = xp.where(by.decay != 0, by.decay, 1.0)
    # the part of β that falls, which is all of it but for errors that grew on the way up
    beta = xp.where(by.decay != 0, 0.5 * (beta - 0.5 * (w * alpha - 1j * a * beta) / own), 0.0)
    slope = 0.5 * (w * change[0] + alpha * change[2] - 1j * (a * change[1] + beta * da))
    # δβ'' = κ δβ from δβ and δβ' = ½ δ(wα − iaβ)
    changed = by.C * change[1] + by.S * slope
    changed_slope = by.kappa * by.S * change[1] + by.C * slope
    sigma = by.elapsed
    fall = xp.exp(-by.decay * sigma)
    spent = 0.5 * (1.0 - fall * fall) / own
    # ∫ e^{−λσ} δβ dσ and e^{−λσ} δβ, with cosh and sinh multiplied out so that nothing overflows
    met = 0.5 * (sigma + spent) * change[1] + 0.5 * (sigma - spent) / own * slope
    end = 0.5 * (1.0 + fall * fall) * change[1] + spent * slope
    conj = xp.conj
    # |α|² = 1 − |β|² gives the change of |α|; χ' = c'/4|α|² with c' near 2a that of the phase
    shrink = xp.real(conj(beta) * (change[1] - end))
    angle = 0.25 * dc_plus * sigma + 0.5 * a * 2.0 * xp.real(conj(beta) * met)
    d_alpha = change[0] + alpha * (shrink + 1j * angle)
    now_beta, now_w = fall * beta, fall * (1j * a - 2.0 * by.decay) * beta * conj(alpha)
    # w = (2β' + iaβ)/α, |α| = 1
    d_w = (2.0 * changed_slope + 1j * (a * changed + da * now_beta) - now_w * d_alpha) * conj(alpha)
    return d_alpha, changed, d_w


def resting_change(start: Vector, change: Moved, of: tuple[Change, Change], tau: Number) -> Moved:
    """Return the changes at τ of a top at rest without weight, by changes of G and a among ``of``."""
    conj = namespace(tau).conj
    alpha, beta, _ = start
    d_alpha, d_beta, d_w = change
    dG, da = of
    # w changes by δw + δG ᾱβ τ, and 2α' = i a α − w̄ β, 2β' = w α − i a β are integrated about a = w = 0
    pull = 0.5 * tau * tau * dG
    return (
        d_alpha + 0.5 * (1j * da * alpha * tau - conj(d_w) * beta * tau - pull * alpha * beta * conj(beta)),
        d_beta + 0.5 * (d_w * alpha * tau + pull * alpha * conj(alpha) * beta - 1j * da * beta * tau),
        d_w + dG * conj(alpha) * beta * tau,
    )


def reversed_axis(hanging: Flag, vector: Moved) -> Moved:
    """Return α, β, w of the top with its axis reversed, (−β, α, w̄), where it hangs."""
    xp = namespace(hanging)
    alpha, beta, w = vector
    return xp.where(hanging, -beta, alpha), xp.where(hanging, alpha, beta), xp.where(hanging, xp.conj(w), w)


def given_axis(hanging: Flag, vector: Moved) -> Moved:
    """Return the inverse of ``reversed_axis``."""
    xp = namespace(hanging)
    alpha, beta, w = vector
    return xp.where(hanging, beta, alpha), xp.where(hanging, -alpha, beta), xp.where(hanging, xp.conj(w), w)
