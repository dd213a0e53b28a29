"""The derivative of attitude and momentum along perturbations of moments, momentum, attitude and time."""

from __future__ import annotations

from polhode import rotation
from polhode.arrays import first_order_only, namespace
from polhode.exact.free_body.preparation import Prepared, prepare
from polhode.exact.free_body.reduction import Reduction, as_sorted, from_sorted
from polhode.exact.free_body.tangent import momentum_tangent
from polhode.rotation import cross_of_parts
from polhode.types import Array, Float64

State = tuple[Float64[Array, "*batch 4"], Float64[Array, "*batch 3"]]
Values = tuple[
    Float64[Array, "*batch 3"], Float64[Array, "*batch 3"], Float64[Array, "*batch 4"], Float64[Array, "*batch"]
]


def state_tangent(values: Values, state: State, changes: Values) -> State:
    """Return the changes of attitude (…, 4) and momentum (…, 3).

    With ξ the turn in body axes, δR = R hat(ξ), and D = R0ᵀR:
    |L|² ξ = L × (Dᵀ δL0 − δL) + L (t δE + ½ Σ δ(1/I_i) ∫L_i²), to which Ω δt is added.

    Args:
        values: moments (…, 3), momentum (…, 3), attitude (…, 4) and time (…), of one batch shape.
        state: attitude and momentum at the time.
        changes: of the values, likewise; linear in them.
    """
    moments, momentum, attitude, time = values
    d_moments, d_momentum, d_attitude, d_time = changes
    attitude_t, momentum_t = state
    xp = namespace(moments, momentum, time)
    identity = xp.zeros_like(attitude) + xp.asarray([1.0, 0.0, 0.0, 0.0], dtype=xp.float64)
    motion, body, frequencies, time = first_order_only((*prepare(moments, momentum, identity), time), "FreeMotion")
    prepared = Prepared(motion, body, frequencies)
    scale, rate = body.momentum_scale, body.rate_scale
    now = tuple(x / scale for x in as_sorted(body, momentum_t))
    start_change = tuple(x / scale for x in as_sorted(body, d_momentum))
    moments_change = tuple(x * (rate / scale) for x in _sorted_sizes(body, d_moments))
    change, flow, present, work = momentum_tangent(prepared, time * rate, moments_change, start_change)

    resting = xp.all(momentum == 0, axis=-1)
    change = tuple(xp.where(resting, e, x) for e, x in zip(start_change, change, strict=True))
    relative = rotation.multiply(rotation.conjugate(attitude), attitude_t)
    carried = as_sorted(body, rotation.rotate(rotation.conjugate(relative), d_momentum))
    seen = tuple(x / scale - y for x, y in zip(carried, change, strict=True))
    size = xp.where(resting, 1.0, body.G2[0])
    turn = tuple((c + x * work) / size for c, x in zip(cross_of_parts(now, seen), now, strict=True))
    velocity = tuple(x / i for x, i in zip(present, body.moments, strict=True))
    at_rest = tuple(time * rate * e / i for e, i in zip(start_change, body.moments, strict=True))
    turn = tuple(xp.where(resting, r, x) + v * (rate * d_time) for r, x, v in zip(at_rest, turn, velocity, strict=True))
    moved = tuple((x + f * (rate * d_time)) * scale for x, f in zip(change, flow, strict=True))
    xi = xp.stack(from_sorted(body, turn), axis=-1)
    given = rotation.multiply(d_attitude, rotation.multiply(rotation.conjugate(attitude), attitude_t))
    return given + rotation.quaternion_rate(attitude_t, xi), xp.stack(from_sorted(body, moved), axis=-1)


def _sorted_sizes(body: Reduction, sizes: Array) -> tuple[Array, ...]:
    """Return what goes with each axis, without sign, in sorted order."""
    xp = namespace(body.long_axis)
    columns = [sum(xp.abs(body.axes[i][j]) * sizes[..., i] for i in range(3)) for j in range(3)]
    first, third = (xp.where(body.long_axis, columns[2 - j], columns[j]) for j in (0, 2))
    return first, columns[1], third
