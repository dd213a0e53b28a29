"""From a body and its momentum to the constants of its motion, for arrays: phases, theta series and matrices."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

from polhode._base.arrays import choose, compiled, namespace, split_halves
from polhode.exact._array_states import ArrayStates
from polhode.exact._blocks import Columns, flatten_motion
from polhode.exact.free_body import _formulas as formulas
from polhode.exact.free_body._formulas import Motion
from polhode.exact.free_body._frequencies import Frequencies, canonical_frequencies
from polhode.exact.free_body._reduction import FORMULAS, Reduction, canonical_reduction
from polhode.rotation import product_of_parts
from polhode.special import _doubledouble as dd
from polhode.special._circular import split_rate
from polhode.special._doubledouble import DoubleDouble
from polhode.special.elliptic import nome_per_parameter
from polhode.types import Array, Float64

STATES = ArrayStates(formulas)
HUGE = 2.0**-400, 2.0**-200  # a hyperbolic sine above the inverse of the first is scaled by the second
LOG_OF_SCALE: DoubleDouble = (138.62943611198907, -3.3555121496085278e-15)  # 200 ln 2


class Prepared(NamedTuple):
    """The flattened ``Motion`` for evaluation, with the reduction and frequencies it came from."""

    motion: Columns
    body: Reduction
    frequencies: Frequencies


def prepare(
    moments: Float64[Array, "*batch 3"], momentum: Float64[Array, "*batch 3"], attitude: Float64[Array, "*batch 4"]
) -> Prepared:
    """Return the constants of motion of bodies with arrays (…, 3), (…, 3) and (…, 4) of one batch shape."""
    body = canonical_reduction(moments, momentum)
    rates = compiled(canonical_frequencies, moments)(body)
    return Prepared(compiled(_motion, moments)(body, rates, moments, momentum, attitude), body, rates)


def _motion(body: Reduction, rates: Frequencies, moments: Array, momentum: Array, attitude: Array) -> Columns:
    """Return the flattened ``Motion``."""
    xp = namespace(moments, momentum, attitude)
    constant, separatrix = rates.constant, rates.separatrix
    m, m1 = body.A[0] * body.P[0], -body.C[0] * body.S[0]
    full = constant | ((m <= m1) & ~separatrix)
    first, second = FORMULAS.phase_rates(full, rates.precession, rates.mean, body.V, body.rate_scale)
    saddle_rate = dd.scale(dd.divide(rates.modulus_rate, body.V), body.rate_scale)
    rotation_rate = _permanent_rate(body)
    first = dd.where(constant, rotation_rate, first)
    zero = xp.zeros_like(m)
    second = dd.where(constant, (zero, zero), dd.where(separatrix, saddle_rate, second))

    arguments = choose(full, _full_arguments, _complementary_arguments, *_argument_columns(body, rates, m, m1))
    arguments = tuple(xp.where(constant, 1.0 if k == 2 else 0.0, x) for k, x in enumerate(arguments))
    unfinished = Motion(
        full, split_rate(*first), split_rate(*second), arguments[0:2], arguments[2:12], arguments[12:17], arguments[17],
        (zero,) * 16, (zero,) * 9,
    )
    to_attitude, to_momentum = _matrices(unfinished, body, rates, moments, momentum, attitude)
    return flatten_motion(unfinished._replace(to_attitude=to_attitude, to_momentum=to_momentum))


def _permanent_rate(body: Reduction) -> DoubleDouble:
    """Return |Ω|/4π, the rate of half the angle of a permanent rotation, in turns."""
    omega = [dd.divide(dd.from_float(x), dd.from_float(i)) for x, i in zip(body.momentum, body.moments, strict=True)]
    size = dd.sqrt(dd.add(dd.add(dd.square(omega[0]), dd.square(omega[1])), dd.square(omega[2])))
    zero = 0.0 * size[0]
    rate = dd.multiply(size, (dd.INVERSE_TWO_PI[0] + zero, dd.INVERSE_TWO_PI[1] + zero))
    return dd.scale(dd.scale(rate, 0.5), body.rate_scale)


def _argument_columns(body: Reduction, rates: Frequencies, m: Array, m1: Array) -> tuple[Array, ...]:
    singles = (x[0] for x in (body.A, body.B, body.C, body.P, body.Q, rates.G))
    return (*singles, *body.canonical, m, m1, rates.separatrix, *rates.modulus_rate, *rates.mean, body.root_P)


def _full_arguments(*columns: Array) -> tuple[Array, ...]:
    """Return start, coefficients of A and B, and idle entries of the form for m ≤ ½."""
    A, B, C, _, Q, _, *momentum, m, m1 = columns[:11]
    rise, run, series = FORMULAS.full_arguments(A, B, C, Q, (m, m1), columns[16], tuple(momentum))
    xp = namespace(A)
    zero = xp.zeros_like(A)
    return (xp.atan2(rise, run) * (0.25 / math.pi), zero, *series, *(zero,) * 6)


def _complementary_arguments(*columns: Array) -> tuple[Array, ...]:
    """Return start, harmonics, nome and parity of the form for m > ½, separatrix included."""
    _, B, C, P, Q, G, *momentum, m, m1, separatrix = columns[:12]
    l1, l2, _ = momentum
    xp = namespace(B)
    total = B * Q
    k = xp.where(separatrix, 1.0, xp.sqrt(m / total))
    small = xp.where(separatrix, 0.0, m1 / total)
    q = small * nome_per_parameter(small, k)
    dn, along, cosine, dc = FORMULAS.complementary_amplitudes(B, C, P, Q, G, tuple(momentum))
    # close to the unstable axis the hyperbolic sine and its square leave the range of numbers
    huge = cosine + dc < HUGE[0] * along
    factor, sinh = FORMULAS.landen(k, dn, xp.where(huge, HUGE[1] * along, along), cosine, dc)
    y = xp.atan(xp.sqrt(Q / P) * factor)
    x = xp.where(huge, xp.log(2.0 * sinh), xp.asinh(sinh))
    back = xp.where(huge, 0.5 * xp.exp(x), xp.sinh(x))
    x = dd.fast_two_sum(x, (sinh - back) / xp.where(huge, back, xp.sqrt(1.0 + back * back)))
    zero = xp.zeros_like(q)
    x = dd.where(huge, dd.add(x, tuple(c + zero for c in LOG_OF_SCALE)), x)
    x = dd.scale(x, xp.where((l2 < 0) != (l1 < 0), -1.0, 1.0))
    period = FORMULAS.half_period(columns[12:14], columns[14:16], q)
    period = dd.where(separatrix, dd.from_float(xp.ones_like(q)), period)
    upper, lower = split_halves(period[0])
    periodic = xp.where(separatrix, 0.0, 1.0)
    y_turns = periodic * y * (0.5 / math.pi)
    parity = xp.where(l1 < 0, 1.0, 0.0)
    return (*dd.divide(x, period), *FORMULAS.harmonics(y), xp.sqrt(q), upper, lower + period[1], y_turns, periodic,
            parity)  # fmt: skip


def _matrices(
    motion: Motion, body: Reduction, rates: Frequencies, moments: Array, momentum: Array, attitude: Array
) -> tuple[tuple[Array, ...], tuple[Array, ...]]:
    """Return the matrices from spinor to attitude and from canonical direction to momentum in the given axes."""
    xp = namespace(motion.full)
    a0, a1, b0, b1 = STATES.sums_at_start(flatten_motion(motion))
    norm = xp.sqrt((a0 * a0 + a1 * a1) + (b0 * b0 + b1 * b1))
    a0, a1, b0, b1 = a0 / norm, a1 / norm, b0 / norm, b1 / norm
    # rows of (start frame)* (present frame) as functions of the spinor (Re A, Im A, Re B, Im B)
    relative = ((a0, a1, b0, b1), (-b1, b0, -a1, a0), (b0, b1, -a0, -a1), (-a1, a0, b1, -b0))
    mirror = xp.where(body.long_axis, -1.0, 1.0)
    axes = [[mirror * x for x in row] for row in body.axes]
    rotated = [[_sum(axes[i][j] * relative[1 + j][k] for j in range(3)) for i in range(3)] for k in range(4)]
    axis = _rotation_axis(moments, momentum)
    constant = rates.constant
    zero, one = xp.zeros_like(a0), xp.ones_like(a0)
    start = tuple(attitude[..., k] for k in range(4))
    columns = []
    for k in range(4):
        scalar = xp.where(constant, one if k == 0 else zero, relative[0][k])
        vector = tuple(xp.where(constant, axis[i] if k == 1 else zero, rotated[k][i]) for i in range(3))
        columns.append(product_of_parts(start, (scalar, *vector)))
    size = rates.G[0] * body.momentum_scale
    to_momentum = tuple(
        xp.where(constant, momentum[..., i] if j == 2 else zero, size * body.axes[i][j] + zero)
        for i in range(3) for j in range(3)
    )
    return tuple(columns[k][i] for i in range(4) for k in range(4)), to_momentum


def _sum(terms: Any) -> Array:
    first, *rest = terms
    for term in rest:
        first = first + term
    return first


def _rotation_axis(moments: Array, momentum: Array) -> tuple[Array, ...]:
    """Return the direction of Ω along the given axes, zero at rest."""
    xp = namespace(moments)
    I, L = ([v[..., k] for k in range(3)] for v in (moments, momentum))  # noqa: E741
    largest = xp.maximum(xp.maximum(xp.abs(L[0]), xp.abs(L[1])), xp.abs(L[2]))
    largest = xp.where(largest > 0, largest, 1.0)
    least = xp.minimum(xp.minimum(I[0], I[1]), I[2])
    x, y, z = (momentum / largest * (least / moment) for momentum, moment in zip(L, I, strict=True))
    size = xp.sqrt((x * x + y * y) + z * z)
    size = xp.where(size > 0, size, 1.0)
    return x / size, y / size, z / size
