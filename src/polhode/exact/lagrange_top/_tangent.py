"""The derivative of a Lagrange top's attitude and momentum along perturbations of all its inputs.

Whole nutations add equal changes, given by the Hessian of the action, and the rest is one short flow that is
differentiated step by step; nothing takes the root of anything that may vanish. Which nutations count as whole is
chosen so that the flow is not led upright and back down near the separatrix, where float64 would lose the way. A top
without a period is upright or becomes so, and goes on by its linear equations.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

from polhode._base.arrays import COMPLEX_STEP, derivative_columns, namespace, split_halves
from polhode.exact._blocks import Vectors
from polhode.exact.lagrange_top import _standing as standing
from polhode.exact.lagrange_top._flow import flow, slopes
from polhode.exact.lagrange_top._formulas_reduction import Reduction
from polhode.exact.lagrange_top._formulas_roots import TurningPoints
from polhode.exact.lagrange_top._periods import Invariants, Nutation, added_by_nutation
from polhode.exact.lagrange_top._preparation import FORMULAS, Prepared
from polhode.special import _doubledouble as dd
from polhode.special._circular import reduced_phase, split_rate
from polhode.special._doubledouble import DoubleDouble
from polhode.types import Array, Bool, Complex128, Float64

Number = Float64[Array, "*batch"]
Flag = Bool[Array, "*batch"]
Complex = Complex128[Array, "*batch"]
Vector = tuple[Complex, Complex, Complex]  # α, β, w, complex
Change = Float64[Array, "*shape"]  # with any axes before those of the batch
Moved = tuple[Complex128[Array, "*shape"], Complex128[Array, "*shape"], Complex128[Array, "*shape"]]


class TangentData(NamedTuple):
    """What the derivative needs of a prepared top, one plain array each; ``…`` and ``…_rest`` are one number."""

    I1: Number
    I3: Number
    L1: Number
    L2: Number
    L3: Number
    w: Number
    x: Number
    y: Number
    z: Number
    size: Number
    G: Number
    D: Number
    D_rest: Number
    c: Number
    energy: Number
    s2: Number
    d: Number
    A: Number
    B: Number
    tilt: Number  # largest 1 − cos θ
    place: Number  # of the epoch in the nutation, in periods from the lowest point; on the separatrix λτ
    lift: Number  # by which c, energy, s2, d have the displacement scaled up where the top leaves the vertical; else 1
    climb: Number  # the x = Wτ that is missing from each ascent and descent then, else 0
    nutation: Number
    nutation_rest: Number
    alpha: Number
    alpha_rest: Number
    beta: Number
    beta_rest: Number
    spin: Number
    spin_rest: Number
    sign_alpha: Number
    sign_beta: Number
    permanent: Flag
    separatrix: Flag
    hanging: Flag
    reversed: Flag
    momentum_scale: Number
    rate_scale: Number

    @property
    def whole_nutation(self) -> Nutation:
        return Nutation(
            self.G, self.L3, self.c, self.energy, self.s2, self.d, self.A, self.B, self.lift, self.climb
        )


class _Course(NamedTuple):
    """How the motion is cut up: whole nutations, one flow, and standing."""

    whole: Number
    rest: Number  # τ of the flow
    tau: DoubleDouble
    phases: tuple[Number, Number]  # of α and β, apart from the flow's, in turns


def tangent_data(prepared: Prepared) -> TangentData:
    """Return the data of a prepared top."""
    motion, top, points, rates = prepared
    xp = namespace(top.reversed)
    a = dd.from_float(top.momentum[2])
    permanent, separatrix = rates.permanent, rates.separatrix
    endless = permanent | separatrix
    hanging = permanent & (top.s0[0] > 0)
    safe = lambda v, x: xp.where(endless, x, v[0])  # noqa: E731
    square = dd.square(a)
    # 4κ about the vertical position of the top
    D = dd.where(hanging, dd.negate(dd.add(dd.scale(top.G, 2.0), square)), top.D)
    place = xp.where(motion[0] != 0.0, 2.0 * motion[10], motion[10])
    momentum, quaternion, (c, energy, s2, d, tilt) = _given_size(xp, top, points)
    lift = FORMULAS.times_power(xp.ones_like(c), xp.where(FORMULAS.leaves(top), top.lift, 0.0))
    return TangentData(
        *top.moments, *momentum, *quaternion, top.size[0], top.G[0], *D, c, energy, xp.where(endless, 0.0, s2),
        xp.where(endless, 0.0, d), safe(points.A, 1.0), safe(points.B, 1.0), xp.where(permanent, top.s0[0], tilt),
        place, lift, FORMULAS.climb(top)[0], *rates.nutation, *rates.alpha, *rates.beta, *rates.spin, rates.sign_alpha,
        rates.sign_beta, permanent, separatrix, hanging, top.reversed, top.momentum_scale, top.rate_scale,
    )


def _given_size(
    xp: Any, top: Reduction, points: TurningPoints
) -> tuple[tuple[Array, Array, Array], tuple[Array, Array, Array, Array], tuple[Array, Array, Array, Array, Array]]:
    """Return momentum, quaternion, and c, ε, s2, d, s1 with the displacement scaled down again to what was given.

    Those five of tops that leave the vertical stay scaled up, as periods are given by them.
    """
    upright = FORMULAS.is_upright(top)
    below, above = (xp.where(v, 0.0, -top.lift) for v in (upright, ~upright))
    (L1, L2, L3), (w, x, y, z) = top.momentum, top.quaternion
    power = FORMULAS.times_power
    momentum = (power(L1, -top.lift), power(L2, -top.lift), L3)
    quaternion = (power(w, below), power(x, above), power(y, above), power(z, below))
    energy = dd.add(top.F, dd.multiply(dd.from_float(L3), top.c))
    # upright all five are of second order; below, d alone, as what is lifted of the others is next to nothing there
    twice = xp.where(FORMULAS.leaves(top), 0.0, 2.0 * above)
    c, energy, s2, d, s1 = (power(v[0], twice) for v in (top.c, energy, points.s2, points.d, points.s1))
    return momentum, quaternion, (c, energy, s2, power(d, 2.0 * below), s1)


def state_tangent(
    top: TangentData,
    time: Number,
    state: tuple[Float64[Array, "*batch 4"], Float64[Array, "*batch 3"]],
    changes: Vectors,
) -> tuple[Float64[Array, "*shape 4"], Float64[Array, "*shape 3"]]:
    """Return the changes of attitude (…, 4) and momentum (…, 3).

    I1 = I2 is one quantity: its change is the mean of the first two moments' changes.

    Args:
        top: with entries of the batch shape.
        time: (…) since the epoch.
        state: attitude (…, 4) and momentum (…, 3) at the time.
        changes: of moments (…, 3), mgl (…, 1), momentum (…, 3), attitude (…, 4) and time (…); with any axes
            before; the result is linear in them.
    """
    xp = namespace(time, *changes)
    attitude, momentum = state
    G, a = top.G, top.L3
    start, change, (dG, da, dI1, dI3) = scaled_changes(xp, top, changes)
    course = _course(xp, top, time)
    invariants = changed_invariants(xp, top, start, change, dG, da)
    parts = tuple(f(v) for v in start for f in (xp.real, xp.imag))
    # the way up and down magnifies by the inverse of the displacement
    step = xp.minimum(xp.maximum(1e-60 / top.lift, 1e-305), COMPLEX_STEP)
    later, columns = derivative_columns(lambda *s: flow(s, course.rest, top.D, top.tilt), (*parts, G, a), step)
    moved = _applied(columns, (*(f(v) for v in change for f in (xp.real, xp.imag)), dG, da))
    stood = _stood(xp, top, course, (start, _paired(later)), (change, moved), invariants)
    endless = top.permanent | top.separatrix
    moved = tuple(xp.where(endless, x, y) for x, y in zip(stood, moved, strict=True))
    now = _spherical(xp, top, attitude, momentum)
    # where the motion is now, as a flow from the start would lose what is large along it
    added = added_by_nutation(top.whole_nutation, now, invariants)
    added = tuple(xp.where(course.whole == 0.0, 0.0, course.whole * x) for x in added)
    times = (time, changes[4], dI1, dI3)
    return _assembled(xp, top, now, (moved, added), da, times, course.phases)


def scaled_changes(xp: Any, top: TangentData, changes: Vectors) -> tuple[Vector, Moved, tuple[Change, ...]]:
    """Return (α, β, w), its change, and those of G, a, I1 and I3, in the units of the reduction."""
    d_moments, d_mgl, d_momentum, d_attitude = changes[:4]
    sense = xp.where(top.reversed, -1.0, 1.0)
    dL1, dL2, dL3 = (d_momentum[..., k] / top.momentum_scale for k in range(3))
    dL2, dL3 = sense * dL2, sense * dL3
    unit = top.rate_scale / top.momentum_scale  # of the inverse moment
    dI1, dI3 = 0.5 * (d_moments[..., 0] + d_moments[..., 1]) * unit, d_moments[..., 2] * unit
    d_weight = sense * d_mgl[..., 0] / top.momentum_scale / top.rate_scale
    dG = 2.0 * d_weight * top.I1 + top.G * (dI1 / top.I1)
    w, x, y, z = (d_attitude[..., k] for k in range(4))
    change = tuple(xp.where(top.reversed, p, q) for p, q in ((-x, w), (w, x), (z, y), (-y, z)))
    size = xp.sqrt(top.size)
    q = tuple(v / size for v in (top.w, top.x, top.y, top.z))
    along = sum(u * v for u, v in zip(q, change, strict=True))
    dq = tuple((v - u * along) / size for u, v in zip(q, change, strict=True))
    start = (q[0] + 1j * q[3], q[1] + 1j * q[2], top.L1 + 1j * top.L2)
    return start, (dq[0] + 1j * dq[3], dq[1] + 1j * dq[2], dL1 + 1j * dL2), (dG, dL3, dI1, dI3)


def changed_invariants(xp: Any, top: TangentData, start: Vector, change: Moved, dG: Change, da: Change) -> Invariants:
    """Return the changes of ε = |w|² − G s, c = 2 Im β̄αw − a s, a and G, of which the first two are lifted twice."""
    alpha, beta, w = start[0], top.lift * start[1], top.lift * start[2]
    d_alpha, d_beta, d_w = change[0], top.lift * change[1], top.lift * change[2]
    conj = xp.conj
    s, ds = 2.0 * xp.real(conj(beta) * beta), 4.0 * xp.real(conj(beta) * d_beta)
    d_twist = conj(d_beta) * (alpha * w) + (conj(beta) * w) * d_alpha + (conj(beta) * alpha) * d_w
    energy = 2.0 * xp.real(conj(w) * d_w) - top.G * ds - s * dG
    return Invariants(energy, 2.0 * xp.imag(d_twist) - top.L3 * ds - s * da, da, dG)


def _course(xp: Any, top: TangentData, time: Array) -> _Course:
    endless = top.separatrix | top.permanent
    zero = (0.0 * top.I1, 0.0 * top.I1)
    nutation = dd.where(endless, dd.one_like(top.I1), (top.nutation, top.nutation_rest))
    pi = (dd.PI[0] + zero[0], dd.PI[1] + zero[0])
    per_time = dd.divide(dd.scale(nutation, top.rate_scale), dd.multiply_float(pi, top.I1))
    halves = split_halves(time)
    fraction, low, count = reduced_phase(split_rate(*dd.where(endless, zero, per_time)), halves)
    more = _nutations_more(xp, top.place, fraction + low)
    count, fraction = xp.where(endless, 0.0, count + more), fraction - more
    tau = dd.divide(dd.scale(dd.from_float(time), top.rate_scale), dd.from_float(top.I1))
    rate = 0.5 * xp.sqrt(xp.where(top.separatrix, xp.abs(top.D), 1.0))
    end = top.place + rate * tau[0]
    upright = 13.0  # λ times the time from the lowest point to where a top on the separatrix is upright: |β|² is 1e-11
    end = xp.minimum(xp.maximum(end, xp.minimum(top.place, -upright)), xp.maximum(top.place, upright))
    climb = xp.where(top.separatrix, xp.where(xp.abs(end) < upright, tau[0], (end - top.place) / rate), 0.0)
    rest = xp.where(endless, climb, (fraction + low) * math.pi / nutation[0])
    return _Course(count, rest, tau, _phases(xp, top, nutation, halves, count))


def _nutations_more(xp: Any, place: Array, fraction: Array) -> Array:
    """Return the whole nutations to take out in addition to those that leave ``fraction``.

    From one side of the lowest point to the other, the way leads down and up again or through the top. Changes grow by
    e^K in half a nutation: the former loses the shorter leg twice, as growth that is undone; the latter what a rounding
    of the start grows by until the end.
    """
    end = place + fraction
    more = xp.round(end)
    end = end - more
    here, there = 2.0 * xp.abs(place), 2.0 * xp.abs(end)
    over = (place * end < 0) & (2.0 - 2.0 * here - there < 2.0 * xp.minimum(here, there))
    return more + xp.where(over, xp.where(end > 0, 1.0, -1.0), 0.0)


def _phases(
    xp: Any, top: TangentData, nutation: DoubleDouble, halves: tuple[Array, Array], count: Array
) -> tuple[Array, Array]:
    """Return the turns of α and β in whole nutations, by the spin that I3 ≠ I1 adds, and while it is upright."""
    zero = 0.0 * top.I1
    endless = top.separatrix | top.permanent
    inverse = dd.divide((dd.INVERSE_TWO_PI[0] + zero, dd.INVERSE_TWO_PI[1] + zero), dd.from_float(top.I1))
    half_spin = dd.scale((top.spin, top.spin_rest), 0.5)
    out: list[Array] = []
    for linear, sign, sense, upright in (
        ((top.alpha, top.alpha_rest), top.sign_alpha, 1.0, endless & ~top.hanging),
        ((top.beta, top.beta_rest), top.sign_beta, -1.0, top.hanging),
    ):
        turn = dd.scale(dd.add(dd.divide(linear, nutation), dd.from_float(sign)), 0.5)  # of a nutation, in turns
        turn = dd.where(endless, (zero, zero), turn)
        own = dd.add(dd.scale(half_spin, sense), dd.from_float(xp.where(upright, 0.5 * sense * top.L3, 0.0)))
        x, x_rest, _ = reduced_phase(split_rate(*turn), split_halves(count))
        y, y_rest, _ = reduced_phase(split_rate(*dd.scale(dd.multiply(own, inverse), top.rate_scale)), halves)
        out.append((x + y) + (x_rest + y_rest))
    return out[0], out[1]


def _applied(columns: tuple[Array, ...], change: tuple[Array, ...]) -> Moved:
    """Return Σ_k column k × change k of every output."""
    sums: tuple[Any, ...] = tuple(sum(c[k, ...] * x for k, x in enumerate(change)) for c in columns)
    return _paired(sums)


def _paired(parts: tuple[Array, ...]) -> Moved:
    ar, ai, br, bi, wr, wi = parts
    return ar + 1j * ai, br + 1j * bi, wr + 1j * wi


def _stood(
    xp: Any, top: TangentData, course: _Course, values: tuple[Vector, Vector], changes: tuple[Moved, Moved],
    by: Invariants,
) -> Moved:
    """Return the changes of an upright top, from the epoch or the end of its climb on, α's phase ½aτ taken off."""
    permanent, hanging = top.permanent, top.hanging
    begin = xp.where(permanent, 0.0, course.rest)
    now, change = (tuple(xp.where(permanent, x, y) for x, y in zip(*v, strict=True)) for v in (values, changes))
    growth = standing.growth(dd.scale((top.D, top.D_rest), 0.25), course.tau, begin, ~permanent)
    sense = xp.where(hanging, -1.0, 1.0)
    a, da = sense * top.L3, sense * by.a
    of = da, xp.where(hanging, 2.0 * da, by.c + 2.0 * da)
    tangent = standing.upright_change(
        a, standing.reversed_axis(hanging, now), standing.reversed_axis(hanging, change), of, growth
    )
    climbing = top.separatrix & (begin == course.tau[0])
    tangent = tuple(xp.where(climbing, x, y) for x, y in zip(change, tangent, strict=True))
    # α's phase of the climb is in the flow
    back = xp.exp(-0.5j * a * begin)
    tangent = (tangent[0] * back, tangent[1], tangent[2] * xp.conj(back))
    idle = standing.resting_change(values[0], changes[0], (by.G, by.a), course.tau[0])
    resting = (top.G == 0) & (top.L3 == 0)
    return tuple(xp.where(resting, x, y) for x, y in zip(idle, standing.given_axis(hanging, tangent), strict=True))


def _spherical(xp: Any, top: TangentData, attitude: Array, momentum: Array) -> Vector:
    """Return α, β, w of a state, in the units and on the axis of the reduction."""
    reverse, sense = top.reversed, xp.where(top.reversed, -1.0, 1.0)
    w, x, y, z = (attitude[..., k] for k in range(4))
    L1, L2 = momentum[..., 0] / top.momentum_scale, sense * momentum[..., 1] / top.momentum_scale
    pairs = (-x, w), (-y, z), (w, x), (z, y)
    return _paired((*(xp.where(reverse, new, old) for new, old in pairs), L1, L2))


def _assembled(
    xp: Any, top: TangentData, now: Vector, changes: tuple[Moved, Moved], da: Array, times: Any,
    phases: tuple[Array, Array],
) -> tuple[Array, Array]:
    """Return the changes of attitude and momentum on the given axes and in the given units.

    The flow's change is multiplied by the phases; those by whole nutations, by τ = t/I1 and by the spin ν t are added.
    """
    time, d_time, dI1, dI3 = times
    I1, I3, a = top.I1, top.I3, top.L3
    scaled, d_scaled = time * top.rate_scale, d_time * top.rate_scale
    d_tau = (d_scaled - scaled * (dI1 / I1)) / I1
    spin = a * (I1 - I3) / (I1 * I3)
    d_spin = da * (I1 - I3) / (I1 * I3) + a * (dI1 / (I1 * I1) - dI3 / (I3 * I3))
    d_half = 0.5 * (d_spin * scaled + spin * d_scaled)
    flowed = _paired(slopes((*(f(v) for v in now for f in (xp.real, xp.imag)), top.G, a)))
    first, second = phases
    out: list[Array] = []
    for value, slope, moved, added, turn, share in zip(
        now, flowed, *changes, (first, second, second - first), (1.0, -1.0, -2.0), strict=True
    ):
        angle = 2.0 * math.pi * turn
        change = moved * (xp.cos(angle) + 1j * xp.sin(angle)) + added
        change = change + (slope * d_tau + 1j * value * (share * d_half))
        out += [xp.real(change), xp.imag(change)]
    ar, ai, br, bi, wr, wi = out
    reverse, sense = top.reversed, xp.where(top.reversed, -1.0, 1.0)
    attitude = (
        xp.where(reverse, br, ar), xp.where(reverse, -ar, br), xp.where(reverse, -ai, bi), xp.where(reverse, bi, ai),
    )  # fmt: skip
    momentum = (wr, sense * wi, sense * da)
    return xp.stack(attitude, axis=-1), xp.stack([v * top.momentum_scale for v in momentum], axis=-1)
