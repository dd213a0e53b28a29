"""The three frequencies of a Lagrange top: nutation, and the mean turns of α and β, by arithmetic–geometric means.

α and β turn by c'/2t and c/2s, whose means over a nutation are complete integrals of the third kind. Each has two
forms, one for either side of the pole that it looks at, so that nothing cancels. Source: Carlson, SIAM J. Math. Anal. 8
(1977) 231; Klein & Sommerfeld, *Theorie des Kreisels*, ch. VI.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from polhode._base.arrays import namespace
from polhode.exact._agm import third_kind_agm
from polhode.exact.lagrange_top._formulas_setup import TurningPoints
from polhode.exact.lagrange_top._reduction import Reduction
from polhode.exact.lagrange_top._roots import FORMULAS
from polhode.special import _doubledouble as dd
from polhode.special._doubledouble import DoubleDouble
from polhode.types import Array, Bool, Float64

Number = Float64[Array, "*batch"]
Flag = Bool[Array, "*batch"]


class Frequencies(NamedTuple):
    """Rates by τ = t/I1 in scaled units; all but the signs and flags are double-double."""

    half_root: DoubleDouble  # W = ½√A: x = x0 + W τ
    nutation: DoubleDouble  # ϖ = ½ agm(√A, √B) = πW/2K, zero on the separatrix
    alpha: DoubleDouble  # linear rates of the phases of α and β apart from their theta quotients
    beta: DoubleDouble
    sign_alpha: Number  # sgn c' and sgn c, +1 for zero
    sign_beta: Number
    spin: DoubleDouble  # ν I1, the spin that I3 ≠ I1 adds, by τ
    permanent: Flag  # the momentum stays: sleeping, hanging, rest
    separatrix: Flag
    steady: Flag  # the tilt stays


def top_frequencies(top: Reduction, points: TurningPoints) -> Frequencies:
    """Return the frequencies of reduced tops."""
    xp = namespace(top.reversed)
    a = top.momentum[2]
    upright = (top.s0[0] == 0) | (top.t0[0] == 0)
    permanent = (top.w2[0] == 0) & (upright | ((top.G[0] == 0) & (a == 0)))
    separatrix = ~(points.B[0] > 0) & ~permanent
    one = dd.one_like(a)
    root_A, root_B = dd.sqrt(points.A), dd.sqrt(points.B)
    aperiodic = permanent | separatrix
    square_alpha, square_beta, first_alpha, first_beta = _starts(top, points)
    starts = [dd.where(aperiodic, one, v) for v in (root_A, root_B, square_alpha, square_beta)]
    # α's and β's sums share the mean: one run over both
    both = [tuple(xp.stack([x, y]) for x, y in zip(*pair, strict=True))
            for pair in ((starts[0], starts[0]), (starts[1], starts[1]), (starts[2], starts[3]))]
    mean, totals = third_kind_agm(*both)
    nutation = dd.scale((mean[0][0, ...], mean[1][0, ...]), 0.5)
    total_alpha, total_beta = ((totals[0][k, ...], totals[1][k, ...]) for k in (0, 1))
    sign_alpha = xp.where(top.c_plus[0] >= 0, 1.0, -1.0)
    sign_beta = xp.where(top.c[0] >= 0, 1.0, -1.0)
    c_plus, c = dd.scale(top.c_plus, sign_alpha), dd.scale(top.c, sign_beta)
    alpha = FORMULAS.drift(
        first_alpha, c_plus, top.G, points.Z_plus, points.t1, points.t2, points.d, nutation, total_alpha
    )
    beta = FORMULAS.drift(first_beta, c, top.G, points.Z_minus, points.s2, points.s1, points.d, nutation, total_beta)
    beta = dd.where(first_beta, dd.negate(beta), beta)
    zero = dd.from_float(xp.zeros_like(a))
    alpha = dd.where(separatrix, dd.scale(c_plus, 0.25), alpha)
    beta = dd.where(separatrix, zero, beta)
    I1, I3 = top.moments
    spin = FORMULAS.spin(I1, I3, a)
    frequencies = Frequencies(
        dd.scale(root_A, 0.5), dd.where(separatrix, zero, nutation), dd.scale(alpha, sign_alpha),
        dd.scale(beta, sign_beta), sign_alpha, sign_beta, spin, permanent, separatrix, ~(points.d[0] > 0) & ~aperiodic,
    )
    return _lingering(top, frequencies)


def climb(top: Reduction) -> DoubleDouble:
    """Return the x = W τ after which the displacement of a top that leaves the vertical has the lifted one's size."""
    xp = namespace(top.reversed)
    places = xp.astype(xp.where(top.leaves, top.lift, 0), xp.float64)
    return dd.multiply_float(tuple(c + 0.0 * places for c in dd.LN2), places)


def _lingering(top: Reduction, lifted: Frequencies) -> Frequencies:
    """Return the frequencies of tops that leave the vertical from those of the lifted ones.

    The displacement grows and falls as e^{±x}, so K = πW/2ϖ is longer by ``climb``. During it α turns by c'/4 and
    β not at all, so the turns of a nutation that are beyond that stay unchanged and their mean rates shrink as ϖ does.
    """
    W, nutation, c_plus = lifted.half_root, lifted.nutation, dd.scale(top.c_plus, 0.25)
    pi = tuple(c + 0.0 * W[0] for c in dd.PI)
    longer = dd.scale(dd.divide(dd.multiply(climb(top), nutation), dd.multiply(pi, W)), 2.0)  # climb/K
    share = dd.divide(dd.one_like(W[0]), dd.add(dd.one_like(W[0]), longer))
    alpha = dd.add(c_plus, dd.multiply(dd.subtract(lifted.alpha, c_plus), share))
    nutation, beta = dd.multiply(nutation, share), dd.multiply(lifted.beta, share)
    alpha, beta, nutation = (
        dd.where(top.leaves, x, y)
        for x, y in ((alpha, lifted.alpha), (beta, lifted.beta), (nutation, lifted.nutation))
    )
    return lifted._replace(alpha=alpha, beta=beta, nutation=nutation)


def _starts(top: Reduction, points: TurningPoints) -> tuple[Any, ...]:
    """Return p² at the start of either sum, and whether either takes the form that starts from Z."""
    first_alpha = points.Z_plus[0] <= 2.0 * points.A[0]
    first_beta = dd.multiply(top.G, points.s2)[0] <= points.Z_minus[0]
    square_alpha = FORMULAS.start_of_alpha(first_alpha, points.A, points.Z_plus, points.t1, points.t2)
    square_beta = FORMULAS.start_of_beta(first_beta, top.c, points.A, points.B, points.Z_minus, points.s1, points.s2)
    return square_alpha, square_beta, first_alpha, first_beta
