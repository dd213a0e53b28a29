"""The derivative of a Lagrange top's attitude and momentum along perturbations of all that it is given.

Over a whole nutation the motion is a turn about the vertical and one about the axis, so that perturbations grow by the
same nilpotent amount each time: with M the derivative of the flow over one period and S those turns,
(S⁻¹M)ⁿ = 1 + n (S⁻¹M − 1). The Jacobian of n periods and a rest is put together from two short flows that are
differentiated as they stand; nothing here takes the root of anything that may vanish.
"""

from __future__ import annotations

import math
from typing import Any

from polhode.arrays import derivative_columns, first_order_only, namespace, split_halves
from polhode.exact.top_flow import flow, slopes
from polhode.exact.top_preparation import PreparedTop, prepare_top, turns_per_time
from polhode.special import doubledouble as dd
from polhode.special.circular import reduced_phase, split_rate

Array = Any
LARGEST_EXPONENT = 300.0  # of a growing perturbation that is followed


def top_tangent(values: tuple[Array, ...], changes: tuple[Array, ...]) -> tuple[Array, Array]:
    """Return the changes of attitude (…, 4) and momentum (…, 3).

    I1 = I2 is one quantity: its change is the mean of the first two moments' changes.

    Args:
        values: moments (…, 3), mgl (…, 1), momentum (…, 3), attitude (…, 4) and time (…), of one batch shape.
        changes: of the values, likewise; the result is linear in them.
    """
    xp = namespace(*values)
    *given, time = first_order_only(tuple(values), "LagrangeMotion")
    prepared = prepare_top(*given)
    top = prepared.top
    start, start_change, I1_change, I3_change = _scaled(xp, prepared, given, changes)
    rest, count, phases = _reduced_time(xp, prepared, time)
    D, tilt = top.D[0], xp.where(prepared.rates.permanent, top.s0[0], prepared.points.s1[0])
    period = xp.where(prepared.rates.separatrix | prepared.rates.permanent, 0.0, math.pi / prepared.rates.nutation[0])
    # one period more on everything: what each adds
    whole = derivative_columns(lambda *s: flow(s, period, D, tilt), start)
    once = _turned_back(_applied(whole, start_change), phases[0])
    added = [x - y for x, y in zip(once, start_change[:6], strict=True)]
    grown = [x + count * y for x, y in zip(start_change[:6], added, strict=True)]
    short = derivative_columns(lambda *s: flow(s, rest, D, tilt), start)
    later = flow(start, rest, D, tilt)
    moved = _applied(short, (*grown, *start_change[6:]))
    times = (time, changes[4], I1_change, I3_change)
    return _assembled(xp, prepared, (later, moved, start, start_change), times, phases)


def _scaled(
    xp: Any, prepared: PreparedTop, given: list[Array], changes: tuple[Array, ...]
) -> tuple[tuple[Array, ...], tuple[Array, ...], Array, Array]:
    """Return (α, β, w, G, a), its change, and those of I1 and I3, in the units of the reduction."""
    top = prepared.top
    d_moments, d_mgl, d_momentum, d_attitude = changes[:4]
    sense = xp.where(top.reversed, -1.0, 1.0)
    L1, L2, L3 = top.momentum
    dL1, dL2, dL3 = (d_momentum[..., k] / top.momentum_scale for k in range(3))
    dL2, dL3 = sense * dL2, sense * dL3
    unit = top.rate_scale / top.momentum_scale  # of the inverse moment
    dI1, dI3 = 0.5 * (d_moments[..., 0] + d_moments[..., 1]) * unit, d_moments[..., 2] * unit
    I1 = top.moments[0]
    weight, d_weight = (
        sense * v[..., 0] / top.momentum_scale / top.rate_scale for v in (given[1], d_mgl)
    )  # fmt: skip
    dG = 2.0 * (d_weight * I1 + weight * dI1)
    w, x, y, z = (d_attitude[..., k] for k in range(4))
    change = tuple(xp.where(top.reversed, p, q) for p, q in ((-x, w), (w, x), (z, y), (-y, z)))
    size = xp.sqrt(top.size[0])
    q = tuple(v / size for v in top.quaternion)
    along = sum(u * v for u, v in zip(q, change, strict=True))
    dq = tuple((v - u * along) / size for u, v in zip(q, change, strict=True))
    zero = 0.0 * L1
    start = (q[0], q[3], q[1], q[2], L1, L2, top.G[0] + zero, L3)
    return start, (dq[0], dq[3], dq[1], dq[2], dL1, dL2, dG + zero, dL3), dI1, dI3


def _reduced_time(xp: Any, prepared: PreparedTop, time: Array) -> tuple[Array, Array, tuple[Any, ...]]:
    """Return τ less whole periods, their number, and the phases of α and β: per period, and in all.

    Without a period none is taken out, and a top that goes upright is followed no farther than it can be.
    """
    top, rates = prepared.top, prepared.rates
    endless = rates.separatrix | rates.permanent
    zero = 0.0 * top.moments[0]
    pi = (dd.PI[0] + zero, dd.PI[1] + zero)
    per_time = dd.divide(dd.scale(rates.nutation, top.rate_scale), dd.multiply_float(pi, top.moments[0]))
    per_time = dd.where(endless, (zero, zero), per_time)
    halves = split_halves(time)
    fraction, low, count = reduced_phase(split_rate(*per_time), halves)
    nutation = xp.where(endless, 1.0, rates.nutation[0])
    all_of_it = time * top.rate_scale / top.moments[0]
    growth = xp.sqrt(xp.abs(top.D[0])) + xp.sqrt(xp.abs(top.G[0]))
    longest = LARGEST_EXPONENT / xp.where(growth > 0, growth, 1.0)
    kept = xp.minimum(xp.maximum(all_of_it, -longest), longest)
    followed = xp.where(rates.separatrix & (growth > 0), kept, all_of_it)
    rest = xp.where(endless, followed, (fraction + low) * math.pi / nutation)
    safe = dd.where(endless, dd.one_like(nutation), rates.nutation)
    once, total = [], []
    for linear, sign, sense in ((rates.alpha, rates.sign_alpha, 0.5), (rates.beta, rates.sign_beta, -0.5)):
        turn = dd.scale(dd.add(dd.divide(linear, safe), dd.from_float(sign)), 0.5)  # of a period, in turns
        turn = dd.where(endless, dd.scale(turn, 0.0), turn)
        spin = split_rate(*turns_per_time(top, dd.scale(rates.spin, sense)))
        a, b, _ = reduced_phase(split_rate(*turn), split_halves(count))
        c, d, _ = reduced_phase(spin, halves)
        once.append(turn[0] - xp.round(turn[0]) + turn[1])
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


def _assembled(xp: Any, prepared: PreparedTop, motion: Any, times: Any, phases: Any) -> tuple[Array, Array]:
    """Add the changes of τ = t/I1 and of the spin ν t, turn by the phases, and go back to the given axes and units."""
    later, moved, start, start_change = motion
    time, d_time, dI1, dI3 = times
    top = prepared.top
    I1, I3 = top.moments
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
