"""The derivative of a Lagrange top's attitude and momentum along perturbations of all that it is given.

Over a whole nutation the motion is a turn about the vertical and one about the axis, so that perturbations grow by the
same nilpotent amount each time: with M the derivative of the flow over one period and S those turns,
(S⁻¹M)ⁿ = 1 + n (S⁻¹M − 1). The Jacobian of n periods and a rest is put together from two short flows that are
differentiated as they stand; nothing here takes the root of anything that may vanish.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

from polhode.arrays import derivative_columns, first_order_only, namespace, split_halves
from polhode.exact.top_flow import flow, slopes
from polhode.exact.top_preparation import PreparedTop
from polhode.special import doubledouble as dd
from polhode.special.circular import reduced_phase, split_rate

Array = Any
LONGEST = 2500.0  # rate × time up to which a top without a period is followed
NEAR = 1e-5  # m1 below which float64 cannot follow a whole nutation: its errors are some eps/m1²


class TangentData(NamedTuple):
    """What the derivative needs of a prepared top, one plain array each."""

    I1: Array
    I3: Array
    L1: Array
    L2: Array
    L3: Array
    w: Array
    x: Array
    y: Array
    z: Array
    size: Array
    G: Array
    D: Array
    tilt: Array  # largest 1 − cos θ
    m1: Array  # complementary parameter, the distance from the separatrix
    nutation: Array
    nutation_rest: Array
    alpha: Array
    alpha_rest: Array
    beta: Array
    beta_rest: Array
    spin: Array
    spin_rest: Array
    sign_alpha: Array
    sign_beta: Array
    permanent: Array
    separatrix: Array
    reversed: Array
    momentum_scale: Array
    rate_scale: Array


def tangent_data(prepared: PreparedTop) -> TangentData:
    """Return the data of a prepared top."""
    _, top, points, rates = prepared
    xp = namespace(top.reversed)
    tilt = xp.where(rates.permanent, top.s0[0], points.s1[0])
    m1 = xp.where(rates.permanent, 1.0, points.B[0] / points.A[0])
    return TangentData(
        *top.moments, *top.momentum, *top.quaternion, top.size[0], top.G[0], top.D[0], tilt, m1, *rates.nutation,
        *rates.alpha, *rates.beta, *rates.spin, rates.sign_alpha, rates.sign_beta, rates.permanent, rates.separatrix,
        top.reversed, top.momentum_scale, top.rate_scale,
    )  # fmt: skip


def top_tangent(top: TangentData, time: Array, changes: tuple[Array, ...]) -> tuple[Array, Array]:
    """Return the changes of attitude (…, 4) and momentum (…, 3).

    I1 = I2 is one quantity: its change is the mean of the first two moments' changes. NaN where it cannot be had: past
    the first half nutation with m1 < 1e-5, and far in time on the separatrix, asleep or hanging.

    Args:
        top: with entries of the batch shape.
        time: (…) since the epoch.
        changes: of moments (…, 3), mgl (…, 1), momentum (…, 3), attitude (…, 4) and time (…); the result is linear in
            them.
    """
    xp = namespace(time, *changes)
    *entries, time = first_order_only((*top, time), "LagrangeMotion")
    top = TangentData(*entries)
    start, start_change, I1_change, I3_change = _scaled(xp, top, changes)
    rest, count, phases = _reduced_time(xp, top, time)
    endless = top.separatrix | top.permanent
    period = xp.where(endless, 0.0, math.pi / xp.where(endless, 1.0, top.nutation))
    whole = derivative_columns(lambda *s: flow(s, period, top.D, top.tilt), start)
    # one period more adds the same to every change
    once = _turned_back(_applied(whole, start_change), phases[0])
    lost = (count != 0.0) & (top.m1 < NEAR)
    factor = xp.where(lost, math.nan, count)
    grown = [x + xp.where(count == 0.0, 0.0, factor * (y - x)) for x, y in zip(start_change[:6], once, strict=True)]
    short = derivative_columns(lambda *s: flow(s, rest, top.D, top.tilt), start)
    later = flow(start, rest, top.D, top.tilt)
    moved = _applied(short, (*grown, *start_change[6:]))
    times = (time, changes[4], I1_change, I3_change)
    return _assembled(xp, top, (later, moved, start, start_change), times, phases)


def _scaled(
    xp: Any, top: TangentData, changes: tuple[Array, ...]
) -> tuple[tuple[Array, ...], tuple[Array, ...], Array, Array]:
    """Return (α, β, w, G, a), its change, and those of I1 and I3, in the units of the reduction."""
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
    start = (q[0], q[3], q[1], q[2], top.L1, top.L2, top.G, top.L3)
    return start, (dq[0], dq[3], dq[1], dq[2], dL1, dL2, dG, dL3), dI1, dI3


def _reduced_time(xp: Any, top: TangentData, time: Array) -> tuple[Array, Array, tuple[Any, ...]]:
    """Return τ less whole periods, their number, and the phases of α and β: per period, and in all.

    Without a period none is taken out, and the rest is NaN where it is too long to be followed.
    """
    endless = top.separatrix | top.permanent
    zero = (0.0 * top.I1, 0.0 * top.I1)
    nutation = dd.where(endless, dd.one_like(top.I1), (top.nutation, top.nutation_rest))
    pi = (dd.PI[0] + zero[0], dd.PI[1] + zero[0])
    per_time = dd.divide(dd.scale(nutation, top.rate_scale), dd.multiply_float(pi, top.I1))
    halves = split_halves(time)
    fraction, low, count = reduced_phase(split_rate(*dd.where(endless, zero, per_time)), halves)
    rate = xp.sqrt(top.L1 * top.L1 + top.L2 * top.L2 + top.L3 * top.L3 + 2.0 * top.G)
    elapsed = time * top.rate_scale / top.I1
    followed = xp.where(xp.abs(elapsed) * rate > LONGEST, math.nan, elapsed)
    rest = xp.where(endless, followed, (fraction + low) * math.pi / nutation[0])
    inverse = dd.divide((dd.INVERSE_TWO_PI[0] + zero[0], dd.INVERSE_TWO_PI[1] + zero[0]), dd.from_float(top.I1))
    half_spin = dd.scale(dd.multiply((top.spin, top.spin_rest), inverse), 0.5 * top.rate_scale)
    once, total = [], []
    for linear, sign, sense in (
        ((top.alpha, top.alpha_rest), top.sign_alpha, 1.0), ((top.beta, top.beta_rest), top.sign_beta, -1.0),
    ):  # fmt: skip
        turn = dd.scale(dd.add(dd.divide(linear, nutation), dd.from_float(sign)), 0.5)  # of a period, in turns
        turn = dd.where(endless, zero, turn)
        a, b, _ = reduced_phase(split_rate(*turn), split_halves(count))
        c, d, _ = reduced_phase(split_rate(*dd.scale(half_spin, sense)), halves)
        once.append((turn[0] - xp.round(turn[0])) + turn[1])
        total.append((a + c) + (b + d))
    return rest, count, (tuple(once), tuple(total))


def _applied(columns: tuple[Array, ...], change: tuple[Array, ...]) -> list[Array]:
    """Return Σ_k column k × change k of every output."""
    return [sum(c[k, ...] * x for k, x in enumerate(change)) for c in columns]


def _turned_back(change: list[Array], turns: tuple[Array, Array]) -> list[Array]:
    """Return (α, β, w) less the phases of one period."""
    xp = namespace(*change)
    out: list[Array] = []
    for k, angle in enumerate((turns[0], turns[1], turns[1] - turns[0])):
        c, s = xp.cos(2.0 * math.pi * angle), xp.sin(2.0 * math.pi * angle)
        x, y = change[2 * k], change[2 * k + 1]
        out += [x * c + y * s, y * c - x * s]
    return out


def _assembled(xp: Any, top: TangentData, motion: Any, times: Any, phases: Any) -> tuple[Array, Array]:
    """Add the changes of τ = t/I1 and of the spin ν t, turn by the phases, and go back to the given axes and units."""
    later, moved, start, start_change = motion
    time, d_time, dI1, dI3 = times
    I1, I3 = top.I1, top.I3
    a, da = start[7], start_change[7]
    scaled, d_scaled = time * top.rate_scale, d_time * top.rate_scale
    d_tau = (d_scaled - scaled * (dI1 / I1)) / I1
    spin = a * (I1 - I3) / (I1 * I3)
    d_spin = da * (I1 - I3) / (I1 * I3) + a * (dI1 / (I1 * I1) - dI3 / (I3 * I3))
    d_half = 0.5 * (d_spin * scaled + spin * d_scaled)
    flowed = slopes((*later, *start[6:]))
    moved = [x + v * d_tau for x, v in zip(moved, flowed, strict=True)]
    out: list[Array] = []
    turns = (phases[1][0], phases[1][1], phases[1][1] - phases[1][0])
    for k, (angle, share) in enumerate(zip(turns, (1.0, -1.0, -2.0), strict=True)):
        x, y = later[2 * k], later[2 * k + 1]
        dx, dy = moved[2 * k] - share * d_half * y, moved[2 * k + 1] + share * d_half * x
        c, s = xp.cos(2.0 * math.pi * angle), xp.sin(2.0 * math.pi * angle)
        out += [dx * c - dy * s, dx * s + dy * c]
    ar, ai, br, bi, wr, wi = out
    sense = xp.where(top.reversed, -1.0, 1.0)
    turned = top.reversed
    attitude = (
        xp.where(turned, br, ar), xp.where(turned, -ar, br), xp.where(turned, -ai, bi), xp.where(turned, bi, ai),
    )  # fmt: skip
    momentum = (wr, sense * wi, sense * da)
    return xp.stack(attitude, axis=-1), xp.stack([v * top.momentum_scale for v in momentum], axis=-1)
