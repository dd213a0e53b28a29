"""The derivative of attitude and momentum along perturbations of moments, momentum, attitude and time."""

from __future__ import annotations

from polhode import rotation
from polhode._base.arrays import namespace
from polhode.exact.free_body._preparation import as_sorted, from_sorted, prepare
from polhode.exact.free_body._tangent import momentum_tangent, sorted_sizes
from polhode.rotation import cross_of_parts
from polhode.types import Array, Float64

State = tuple[Float64[Array, "*batch 4"], Float64[Array, "*batch 3"]]
Values = tuple[
    Float64[Array, "*batch 3"], Float64[Array, "*batch 3"], Float64[Array, "*batch 4"], Float64[Array, "*batch"]
]
Changes = tuple[
    Float64[Array, "*more 3"], Float64[Array, "*more 3"], Float64[Array, "*more 4"], Float64[Array, "*more"]
]
Changed = tuple[Float64[Array, "*more 4"], Float64[Array, "*more 3"]]


def state_tangent(values: Values, state: State, changes: Changes) -> Changed:
    """Return the changes of attitude (…, 4) and momentum (…, 3).

    With ξ the turn in body axes, δR = R hat(ξ), and D = R0ᵀR:
    |L|² ξ = L × (Dᵀ δL0 − δL) + L (t δE + ½ Σ δ(1/I_i) ∫L_i²), to which Ω δt is added.

    Args:
        values: moments (…, 3), momentum (…, 3), attitude (…, 4) and time (…), of one batch shape.
        state: attitude and momentum at the time.
        changes: of the values, likewise, with any axes before; the result is linear in them.
    """
    moments, momentum, attitude, time = values
    d_moments, d_momentum, d_attitude, d_time = changes
    attitude_t, momentum_t = state
    xp = namespace(moments, momentum, time)
    identity = xp.zeros_like(attitude) + xp.asarray([1.0, 0.0, 0.0, 0.0], dtype=xp.float64)
    prepared = prepare(moments, momentum, identity)
    body = prepared.body
    scale, rate = body.momentum_scale, body.rate_scale
    now = tuple(x / scale for x in as_sorted(body, momentum_t))
    start_change = tuple(x / scale for x in as_sorted(body, d_momentum))
    moments_change = tuple(x * (rate / scale) for x in sorted_sizes(body, d_moments))
    change, flow, present, work = momentum_tangent(prepared, time * rate, moments_change, start_change)

    resting = xp.all(momentum == 0, axis=-1)
    change = tuple(xp.where(resting, e, x) for e, x in zip(start_change, change, strict=True))
    # differences of derivatives come with attitudes of other lengths, in which everything is linear
    length2 = xp.sum(attitude * attitude, axis=-1, keepdims=True)
    relative = rotation.multiply(rotation.conjugate(attitude), attitude_t) / length2
    carried = as_sorted(body, rotation.rotate(rotation.conjugate(relative), d_momentum))
    gap = tuple(x / scale - y for x, y in zip(carried, change, strict=True))
    size = xp.where(resting, 1.0, body.G2[0])
    # R L and R0 L0 are one vector: ξ × L = Dᵀ δL0 − δL gives ξ across L. Along it, (L·ξ)˙ = L·δΩ
    # = δE + ½ Σ δ(1/I_i) L_i²
    turn = tuple((c + x * work) / size for c, x in zip(cross_of_parts(now, gap), now, strict=True))
    velocity = tuple(x / i for x, i in zip(present, body.moments, strict=True))
    at_rest = tuple(time * rate * e / i for e, i in zip(start_change, body.moments, strict=True))
    turn = tuple(xp.where(resting, r, x) + v * (rate * d_time) for r, x, v in zip(at_rest, turn, velocity, strict=True))
    moved = tuple((x + f * (rate * d_time)) * scale for x, f in zip(change, flow, strict=True))
    xi = xp.stack(from_sorted(body, turn), axis=-1)
    of_start = rotation.multiply(d_attitude, relative)
    return of_start + rotation.quaternion_rate(attitude_t, xi), xp.stack(from_sorted(body, moved), axis=-1)
