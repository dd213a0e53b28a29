"""From a Lagrange top and its start to the constants of its motion: rates, theta series and phases."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

from polhode._base.arrays import barrier, choose, compiled, namespace, split_halves
from polhode.exact._array_states import ArrayStates
from polhode.exact._blocks import Columns, flatten_motion
from polhode.exact.lagrange_top import _formulas as formulas
from polhode.exact.lagrange_top._formulas import Motion
from polhode.exact.lagrange_top._formulas_setup import TurningPoints
from polhode.exact.lagrange_top._frequencies import Frequencies, climb, top_frequencies
from polhode.exact.lagrange_top._reduction import Reduction, reduce_top
from polhode.exact.lagrange_top._roots import FORMULAS, turning_points
from polhode.special import _doubledouble as dd
from polhode.special._circular import split_rate
from polhode.special._doubledouble import DoubleDouble
from polhode.special._first_kind import first_kind
from polhode.special.elliptic import nome_per_parameter
from polhode.types import Array, Float64

STATES = ArrayStates(formulas)


class Prepared(NamedTuple):
    """The flattened ``Motion`` for evaluation, with its sources."""

    motion: Columns
    top: Reduction
    points: TurningPoints
    rates: Frequencies


class _Arguments(NamedTuple):
    """The modulus and the places of start and poles in the lattice."""

    full: Array
    q: Array  # nome of the smaller parameter
    theta3: Array
    y_alpha: Array  # imaginary distance of the poles, times π/2K (full) or π/2K'
    y_beta: Array
    r_alpha: Array  # full: q e^{2y}, accurate where y is far out
    r_beta: Array
    x0: DoubleDouble


def prepare(
    moments: Float64[Array, "*batch 3"],
    mgl: Float64[Array, "*batch 1"],
    momentum: Float64[Array, "*batch 3"],
    attitude: Float64[Array, "*batch 4"],
) -> Prepared:
    """Return the constants of motion of tops with arrays (…, 3), (…, 1), (…, 3) and (…, 4) of one batch shape."""
    top = barrier(compiled(reduce_top, moments)(moments, mgl, momentum, attitude))
    points = barrier(compiled(turning_points, moments)(top))
    rates = barrier(compiled(top_frequencies, moments)(top, points))
    arguments = barrier(compiled(_arguments, moments)(top, points, rates))
    axial = momentum[..., 2]
    return Prepared(compiled(_motion, moments)(top, points, rates, arguments, axial), top, points, rates)


def _arguments(top: Reduction, points: TurningPoints, rates: Frequencies) -> _Arguments:
    xp = namespace(top.reversed)
    G, s2, t1, d, A, B = (v[0] for v in (top.G, points.s2, points.t1, points.d, points.A, points.B))
    separatrix, permanent = rates.separatrix, rates.permanent
    m, m1 = G * d / A, xp.where(separatrix, 0.0, B / A)
    full = permanent | ((m <= m1) & ~separatrix)
    small = xp.where(permanent, 0.0, xp.where(full, m, m1))
    q = small * nome_per_parameter(small, xp.sqrt(1.0 - small))
    theta3 = 1.0 + 2.0 * (q + q**4 + q**9)
    still = permanent | rates.steady
    v_a, v_b, w_a, w_b, x0 = _integrals(top, points, still)
    scale = 1.0 / (theta3 * theta3)  # π/2K of the smaller quarter period
    v_a = xp.where(separatrix, xp.atan2(xp.sqrt(t1), xp.sqrt(d)), v_a)
    v_b = xp.where(separatrix | (s2 == 0), 0.0, v_b)
    # where the tilt stays the pole is infinitely far: only e^−y = 0 enters
    y_alpha = xp.where(rates.steady, math.inf, xp.where(permanent, 0.0, v_a * scale))
    y_beta = xp.where(rates.steady, math.inf, xp.where(permanent, 0.0, v_b * scale))
    tail = lambda w: xp.where(full & (q > 0), xp.exp(-2.0 * scale * w), 0.0)  # noqa: E731
    x0 = dd.scale(dd.add(x0, climb(top)), xp.where(top.p[0] >= 0, 1.0, -1.0))
    return _Arguments(full, q, theta3, y_alpha, y_beta, tail(w_a), tail(w_b), x0)


def _integrals(top: Reduction, points: TurningPoints, idle: Array) -> tuple[Any, ...]:
    """Return the distances v of α's and β's poles from the real axis, K' − v, and x0, by R_F in double-double.

    All five in one run; places where an answer is not used get harmless arguments.
    """
    xp = namespace(idle)
    G, d, A, B, s1, s2, t1, t2 = (
        top.G, points.d, points.A, points.B, points.s1, points.s2, points.t1, points.t2,
    )  # fmt: skip
    one = dd.one_like(d[0])
    over = dd.divide
    pairs = (
        (over(d, t2), over(dd.multiply(d, points.Z_plus), dd.multiply(A, t2))),
        (over(dd.multiply(d, points.Z_minus), dd.multiply(s1, B)), over(d, s1)),
        (over(dd.multiply(G, t1), points.Z_plus), over(dd.multiply(G, t2), points.Z_plus)),
        (over(dd.multiply(G, s2), B), over(dd.multiply(G, s1), A)),
        (over(points.from_upper, d), over(points.Y, A)),
    )
    columns = []
    for x, y in pairs:
        bad = idle | ~(x[0] + y[0] > 0) | ~xp.isfinite(x[0] + y[0])
        columns.append((dd.where(bad, one, x), dd.where(bad, one, y)))
    stacked = [tuple(xp.stack([c[i][k] for c in columns]) for k in (0, 1)) for i in (0, 1)]
    values = first_kind(*stacked)
    of = [(values[0][k, ...], values[1][k, ...]) for k in range(5)]
    factors = (
        over(t1, t2), over(dd.multiply(s2, A), dd.multiply(s1, B)), over(A, points.Z_plus), over(points.Z_minus, B),
        over(points.from_lower, d),
    )  # fmt: skip
    integrals = [dd.multiply(dd.sqrt(f), v) for f, v in zip(factors, of, strict=True)]
    zero = dd.from_float(xp.zeros_like(d[0]))
    return (
        integrals[0][0], integrals[1][0], integrals[2][0], integrals[3][0],
        dd.where(idle & ~(d[0] > 0), zero, integrals[4]),
    )  # fmt: skip


def _motion(
    top: Reduction, points: TurningPoints, rates: Frequencies, at: _Arguments, axial: Array
) -> tuple[Array, ...]:
    """Return the flattened ``Motion``."""
    xp = namespace(top.reversed)
    permanent, separatrix = rates.permanent, rates.separatrix
    turns = [FORMULAS.turns_per_time(v, top.moments[0], top.rate_scale) for v in _phase_rates(top, rates)]
    zero = xp.zeros_like(axial)
    full, q, theta3 = at.full, at.q, at.theta3
    half_periods = FORMULAS.half_periods(rates.nutation, top.moments[0], top.rate_scale)
    saddle = dd.divide(dd.scale(rates.half_root, top.rate_scale), dd.from_float(top.moments[0]))
    third = dd.where(full, dd.scale(half_periods, 0.5), dd.where(separatrix, saddle, half_periods))
    K, period = FORMULAS.periods(rates.half_root, rates.nutation, q)
    fraction = dd.scale(dd.divide(at.x0, K), 0.5)
    start = dd.where(full, dd.scale(fraction, 0.5), dd.where(separatrix, at.x0, fraction))
    third, start = (dd.where(permanent, value, v) for value, v in (((zero, zero), third), ((0.25 + zero, zero), start)))
    period = dd.where(separatrix, (1.0 + zero, zero), period)
    upper, lower = split_halves(period[0])
    coefficients = choose(full, _full_series, _complementary_series, *_series_columns(top, points, rates, at))
    argument_rate = xp.where(full, rates.nutation[0], rates.half_root[0] / (theta3 * theta3))
    argument_rate = xp.where(permanent, 0.0, argument_rate)
    linear = _linear_rates(rates, at)
    motion = barrier(Motion(
        full, split_rate(*turns[0]), split_rate(*turns[1]), split_rate(*third), start,
        coefficients[0:4], coefficients[4:8], coefficients[8:12], coefficients[12:16], coefficients[16],
        (q, upper, lower + period[1], *(xp.where(separatrix | full, 0.0, y / math.pi) for y in (at.y_alpha, at.y_beta)),
         xp.where(separatrix, 0.0, 1.0)),
        (xp.where(permanent, 1.0, rates.sign_alpha), xp.where(permanent, 1.0, rates.sign_beta)),
        (2.0 * argument_rate * top.momentum_scale, 2.0 * (linear[0] + linear[1]) * top.momentum_scale),
        (1.0 + zero, zero, 1.0 + zero, zero), axial, xp.where(top.reversed, -1.0, 1.0),
    ))
    return flatten_motion(motion._replace(phases=_constant_phases(top, motion, linear, argument_rate)))


def _phase_rates(top: Reduction, rates: Frequencies) -> tuple[DoubleDouble, DoubleDouble]:
    """Return the linear rates of the phases of α and β by τ, the spin that I3 ≠ I1 adds included."""
    half_spin = dd.scale(rates.spin, 0.5)
    alpha, beta = dd.add(rates.alpha, half_spin), dd.subtract(rates.beta, half_spin)
    I1, I3 = top.moments
    own = dd.divide(dd.two_product(0.5 * top.momentum[2], I1), dd.from_float(I3))
    return dd.where(rates.permanent, own, alpha), dd.where(rates.permanent, dd.negate(own), beta)


def _linear_rates(rates: Frequencies, at: _Arguments) -> tuple[Array, Array]:
    """Return the derivatives by τ of the phases of α and β that evaluation adds to A and B, spin aside."""
    xp = namespace(at.full)
    out = []
    for rate, sign, y in (
        (rates.alpha, rates.sign_alpha, at.y_alpha), (rates.beta, rates.sign_beta, at.y_beta),
    ):
        carried = sign * xp.where(at.full | rates.separatrix, 0.0, y) * rates.nutation[0] * (2.0 / math.pi)
        out.append(xp.where(rates.permanent, 0.0, rate[0] + carried))
    return out[0], out[1]


def _series_columns(top: Reduction, points: TurningPoints, rates: Frequencies, at: _Arguments) -> tuple[Array, ...]:
    xp = namespace(at.full)
    root_t, root_s = (xp.sqrt(0.5 * v[0]) for v in (points.t2, points.s1))
    # a permanent top has one of α, β, or at rest both, as it started: A = |α| sin z and B = i |β| sin z at z = π/2
    own_t, own_s = (xp.sqrt(0.5 * v[0]) for v in (top.t0, top.s0))
    root_t, root_s = xp.where(rates.permanent, own_t, root_t), xp.where(rates.permanent, own_s, root_s)
    # what stays near the vertical moves as the lifted top does, at the given size
    down = xp.ldexp(xp.ones_like(root_t), -xp.where(top.leaves, 0, top.lift))
    root_t, root_s = root_t * xp.where(top.upright, 1.0, down), root_s * xp.where(top.upright, down, 1.0)
    return root_t, root_s, at.q, at.theta3, at.y_alpha, at.y_beta, at.r_alpha, at.r_beta, rates.permanent


def _full_series(*columns: Array) -> tuple[Array, ...]:
    """Return sums and differences of the coefficients of e^{±ikz}, k = 1, 3, 5, 7, in A and in B, and an idle entry."""
    root_t, root_s, q, theta3, y_alpha, y_beta, r_alpha, r_beta, permanent = columns
    xp = namespace(q)
    of_alpha, of_beta = FORMULAS.full_sizes(root_t, root_s, q, theta3)
    a_sum, a_gap = FORMULAS.full_terms(of_alpha, xp.exp(-2.0 * y_alpha), q, r_alpha, -1.0)
    b_sum, b_gap = FORMULAS.full_terms(of_beta, xp.exp(-2.0 * y_beta), q, r_beta, 1.0)
    first = {0: root_t, 12: root_s}
    out = [xp.where(permanent, first.get(k, 0.0 * q), v) for k, v in enumerate((*a_sum, *a_gap, *b_sum, *b_gap))]
    return (*out, xp.zeros_like(q))


def _complementary_series(*columns: Array) -> tuple[Array, ...]:
    """Return A's factors of sin ky and cos ky, k = 1, 3, 5, 7, B's of cos and sin of 2, 4, 6, 8 y, and its constant."""
    *series, last = FORMULAS.complementary_series(*columns[:6])
    return (*(x for part in series for x in part), last)


def _constant_phases(
    top: Reduction, motion: Motion, linear: tuple[Array, Array], argument_rate: Array
) -> tuple[Array, ...]:
    """Return cos and sin of the phases that turn A and B at the epoch into the given α and β."""
    xp = namespace(argument_rate)
    sums = STATES.sums_at_start(flatten_motion(motion))
    up = xp.ldexp(xp.ones_like(argument_rate), top.lift)
    up_alpha, up_beta = xp.where(top.upright, 1.0, up), xp.where(top.upright, up, 1.0)
    lifts = (up_alpha, up_alpha, up_beta, up_beta) * 2
    L1, L2, L3 = top.momentum
    size = L1 * L1 + L2 * L2 + L3 * L3 + top.G[0]
    size = xp.where(size > 0, size, 1.0)
    lifted = *(x * y for x, y in zip(sums[:8], lifts, strict=True)), *sums[8:]
    return FORMULAS.constant_phases(top.quaternion, top.size, top.momentum, size, lifted, linear, argument_rate)
