"""The three frequencies of a Lagrange top: nutation, and the mean turns of α and β, by arithmetic–geometric means.

α and β turn by c'/2t and c/2s, whose means over a nutation are complete integrals of the third kind. Each has two
forms, one for either side of the pole that it looks at, so that nothing cancels. Source: Carlson, SIAM J. Math. Anal. 8
(1977) 231; Klein & Sommerfeld, *Theorie des Kreisels*, ch. VI.
"""

from __future__ import annotations

from typing import NamedTuple

from polhode.exact._formulas import by_theta, third_kind_mean
from polhode.exact._kernel_arithmetic import (
    Number,
    Pair,
    Truth,
    add,
    choice,
    constant,
    divide,
    multiply,
    multiply_float,
    negation,
    root_or_zero,
    scale,
    subtract,
    two_product,
    two_sum,
    where,
)
from polhode.exact.lagrange_top._formulas_reduction import ONE, ZERO, Reduction, leaves
from polhode.exact.lagrange_top._formulas_roots import TurningPoints
from polhode.special._doubledouble import INVERSE_TWO_PI, LN2, PI


class Frequencies(NamedTuple):
    """Rates by τ = t/I1 in scaled units; all but the signs and flags are double-double."""

    half_root: Pair  # W = ½√A: x = x0 + W τ
    nutation: Pair  # ϖ = ½ agm(√A, √B) = πW/2K, zero on the separatrix
    alpha: Pair  # linear rates of the phases of α and β apart from their theta quotients
    beta: Pair
    sign_alpha: Number  # sgn c' and sgn c, +1 for zero
    sign_beta: Number
    spin: Pair  # ν I1, the spin that I3 ≠ I1 adds, by τ
    permanent: Truth  # the momentum stays: sleeping, hanging, rest
    separatrix: Truth
    steady: Truth  # the tilt stays


class Starts(NamedTuple):
    """What the means start from, and harmless numbers where there is no period."""

    root_A: Pair
    root_B: Pair
    alpha: Pair  # p² of the sums of α and β
    beta: Pair
    permanent: Truth
    separatrix: Truth


def start_of_alpha(first: bool, a: Pair, z_plus: Pair, t1: Pair, t2: Pair) -> Pair:
    """Return p² at the start of the sum of α; ``first`` says that it takes the form that starts from Z."""
    return choice(first, z_plus, divide(multiply(a, t2), choice(first, constant(ONE, t1[0]), t1)))


def start_of_beta(first: bool, c: Pair, a: Pair, b: Pair, z_minus: Pair, s1: Pair, s2: Pair) -> Pair:
    """Return p² of the sum of β. Where c = 0 the factor of the sum vanishes, and p² must only not be zero."""
    other = divide(multiply(s1, b), choice(first, constant(ONE, s2[0]), s2))
    return choice(first, choice(c[0] == 0.0, a, z_minus), other)


def drift(first: bool, c: Pair, g: Pair, z: Pair, near: Pair, far: Pair, d: Pair, nutation: Pair, total: Pair) -> Pair:
    """Return cG/(4Z) Σ in the first form, |c|/(2 near) [1 − d/(2 far) Σ] − ϖ in the second."""
    idle = c[0] == 0.0
    ratio = divide(choice(first, multiply(c, g), c), choice(idle, ONE, choice(first, z, near)))
    share = subtract(constant(ONE, c[0]), scale(multiply(divide(d, far), total), 0.5))
    return choice(
        first, scale(multiply(ratio, total), 0.25), subtract(multiply(scale(ratio, 0.5), share), nutation)
    )


def spin(i1: float, i3: float, axial: float) -> Pair:
    """Return ν I1, the spin that I3 ≠ I1 adds, by τ."""
    return divide(multiply_float(two_sum(i1, -i3), axial), (i3, 0.0))


def turns_per_time(rate: Pair, i1: float, rate_scale: float) -> Pair:
    """Return a rate by τ as turns per time."""
    inverse = divide(constant(INVERSE_TWO_PI, i1), (i1, 0.0))
    return multiply(rate, scale(inverse, rate_scale))


def half_periods(nutation: Pair, i1: float, rate_scale: float) -> Pair:
    """Return the rate of x/2K [half periods per time]."""
    return divide(scale(nutation, rate_scale), multiply_float(constant(PI, i1), i1))


def periods(half_root: Pair, nutation: Pair, nome: float) -> tuple[Pair, Pair]:
    """Return K and πK/K', of the nome of the smaller parameter."""
    quarter = divide(scale(multiply(half_root, constant(PI, nome)), 0.5), nutation)
    return quarter, by_theta(scale(quarter, 2.0), nome)


def _first_alpha(points: TurningPoints) -> bool:
    return points.Z_plus[0] <= 2.0 * points.A[0]


def _first_beta(top: Reduction, points: TurningPoints) -> bool:
    return multiply(top.G, points.s2)[0] <= points.Z_minus[0]


def starts_of(top: Reduction, points: TurningPoints) -> Starts:
    """Return what the means start from."""
    a = top.momentum[2]
    vertical = (top.s0[0] == 0.0) | (top.t0[0] == 0.0)
    permanent = (top.w2[0] == 0.0) & (vertical | ((top.G[0] == 0.0) & (a == 0.0)))
    separatrix = negation(points.B[0] > 0.0) & negation(permanent)
    idle, one = permanent | separatrix, constant(ONE, a)
    alpha = start_of_alpha(_first_alpha(points), points.A, points.Z_plus, points.t1, points.t2)
    first = _first_beta(top, points)
    beta = start_of_beta(first, top.c, points.A, points.B, points.Z_minus, points.s1, points.s2)
    return Starts(
        choice(idle, one, root_or_zero(points.A)), choice(idle, one, root_or_zero(points.B)), choice(idle, one, alpha),
        choice(idle, one, beta), permanent, separatrix,
    )  # fmt: skip


def frequencies_of(
    top: Reduction, points: TurningPoints, start: Starts, mean: Pair, total_alpha: Pair, total_beta: Pair
) -> Frequencies:
    """Return the frequencies of a top as its displacement is scaled, of the mean and the third-kind sums."""
    nutation, separatrix = scale(mean, 0.5), start.separatrix
    sign_alpha, sign_beta = where(top.c_plus[0] >= 0.0, 1.0, -1.0), where(top.c[0] >= 0.0, 1.0, -1.0)
    c_plus, c, first = scale(top.c_plus, sign_alpha), scale(top.c, sign_beta), _first_beta(top, points)
    alpha = drift(
        _first_alpha(points), c_plus, top.G, points.Z_plus, points.t1, points.t2, points.d, nutation, total_alpha
    )
    beta = drift(first, c, top.G, points.Z_minus, points.s2, points.s1, points.d, nutation, total_beta)
    alpha = scale(choice(separatrix, scale(c_plus, 0.25), alpha), sign_alpha)
    beta = scale(choice(separatrix, ZERO, beta), where(first, -sign_beta, sign_beta))
    steady = negation((points.d[0] > 0.0) | start.permanent | separatrix)
    return Frequencies(
        scale(root_or_zero(points.A), 0.5), choice(separatrix, ZERO, nutation), alpha, beta, sign_alpha, sign_beta,
        spin(top.moments[0], top.moments[1], top.momentum[2]), start.permanent, separatrix, steady,
    )  # fmt: skip


def climb(top: Reduction) -> Pair:
    """Return the x = W τ after which the displacement of a top that leaves the vertical has the lifted one's size."""
    return multiply_float(constant(LN2, top.rate_scale), where(leaves(top), top.lift, 0.0))


def _lingering(top: Reduction, rates: Frequencies) -> Frequencies:
    """Return the frequencies of tops that leave the vertical from those of the lifted ones.

    The displacement grows and falls as e^{±x}, so K = πW/2ϖ is longer by ``climb``. During it α turns by c'/4 and
    β not at all, so the turns of a nutation that are beyond that stay unchanged and their mean rates shrink as ϖ does.
    """
    W, c_plus, one = rates.half_root, scale(top.c_plus, 0.25), constant(ONE, rates.half_root[0])
    pi, lingers = constant(PI, W[0]), leaves(top)
    longer = scale(divide(multiply(climb(top), rates.nutation), multiply(pi, W)), 2.0)  # climb/K
    share = divide(one, add(one, longer))
    alpha = add(c_plus, multiply(subtract(rates.alpha, c_plus), share))
    return Frequencies(
        W, choice(lingers, multiply(rates.nutation, share), rates.nutation), choice(lingers, alpha, rates.alpha),
        choice(lingers, multiply(rates.beta, share), rates.beta), rates.sign_alpha, rates.sign_beta, rates.spin,
        rates.permanent, rates.separatrix, rates.steady,
    )  # fmt: skip


def frequencies(top: Reduction, points: TurningPoints) -> Frequencies:
    """Return the frequencies of a reduced top."""
    start = starts_of(top, points)
    mean, total_alpha = third_kind_mean(start.root_A, start.root_B, start.alpha)
    _, total_beta = third_kind_mean(start.root_A, start.root_B, start.beta)
    return _lingering(top, frequencies_of(top, points, start, mean, total_alpha, total_beta))


def phase_rates(top: Reduction, rates: Frequencies) -> tuple[Pair, Pair]:
    """Return the rates of the phases of α and β [turns per time], the spin that I3 ≠ I1 adds included."""
    half = scale(rates.spin, 0.5)
    i1, i3 = top.moments
    own = divide(two_product(0.5 * top.momentum[2], i1), (i3, 0.0))
    alpha = choice(rates.permanent, own, add(rates.alpha, half))
    beta = choice(rates.permanent, (-own[0], -own[1]), subtract(rates.beta, half))
    return turns_per_time(alpha, i1, top.rate_scale), turns_per_time(beta, i1, top.rate_scale)
