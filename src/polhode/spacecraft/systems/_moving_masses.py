"""Kinetics of a carrier with moving parts: one mass matrix for its rotation and all coordinates of the parts.

Let a part k have mass m, its centre at r(q) from the origin of the body's axes and the inertia I(q) about that centre,
and turn against the carrier with Σ_j w_j q̇_j. Let c₀ be the centre of mass of all where the parts rest, M the whole
mass, ρ = r − c₀, and d = Σ m (r − r₀)/M the way of the centre of mass. Of the motion about the centre of mass,

  T = ½ Ω·J Ω + Ω·Σ_j b_j q̇_j + ½ Σ_ij M_ij q̇_i q̇_j,
  J = J₀ + Σ [I − I₀ + m (D(ρ) − D(ρ₀))] − M D(d),  D(x) = |x|² 1 − x xᵀ,
  b_j = m (ρ − d) × ∂_j r + I w_j,
  M_ij = m ∂_i r·∂_j r + w_i·I w_j − (m ∂_i r)·(m' ∂_j r')/M,

where the last term, in which i and j may belong to two parts, is the carrier's own motion through
space. A part with a ``gauge`` f has ∂_i f ∂_j f in M too. L = J Ω + Σ b q̇ and π_j = b_j·Ω + Σ M q̇ are the momenta;
L̇ = L × Ω + τ, and π̇ = ∂T/∂q − ∂V/∂q + Q at fixed Ω and q̇. So H(L, q, π) = T + V moves only by τ·Ω + Q·q̇.

Source: Meirovitch, *Methods of Analytical Dynamics* (1970), §4.9 (quasi-coordinates); Hughes, *Spacecraft Attitude
Dynamics* (1986), §3.3 and ch. 3, of point masses and dampers in a body.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import jax
import jax.numpy as jnp

from polhode.spacecraft.systems.moving_parts import AbstractMovingPart
from polhode.systems._symmetric import solve_symmetric
from polhode.types import Array, Float64

Vectors = list[Array]


class Placed(NamedTuple):
    """A part where its coordinates put it.

    Attributes:
        place: ρ (…, 3), from the centre of mass at rest.
        shifts: ∂_j r (…, 3), one for each coordinate.
        tensor: I (…, 3, 3); None for a point.
        axes: w_j (…, 3), one for each coordinate; empty for a part that does not turn.
        gauges: ∂_j f (…), one for each coordinate; empty for a part without a gauge.
    """

    place: Array
    shifts: Vectors
    tensor: Array | None
    axes: Vectors
    gauges: Vectors


class Arrangement(NamedTuple):
    """All parts where their coordinates put them.

    Attributes:
        parts: each where it is.
        offset: d (…, 3).
        inertia: J (…, 3, 3) less parts that turn by states of their own.
        columns: b_j (…, 3), one for each coordinate of all parts.
        masses: M_ij (…).
        mass: M (…), of all that remains.
    """

    parts: list[Placed]
    offset: Array
    inertia: Array
    columns: Vectors
    masses: list[Vectors]
    mass: Array


class Burned(NamedTuple):
    """Propellant that has left a tank: mass (…), former place (3,) from the origin, and κ (3, 3), None for a point."""

    mass: Array
    place: Array
    inertia_per_mass: Array | None


def arrange(
    parts: Sequence[AbstractMovingPart], owns: Sequence[Array], carrier: Array, center: Array, mass: Array,
    burned: Sequence[Burned] = (),
) -> Arrangement:
    """Return the arrangement of the parts, with the inertia that follows from it.

    Args:
        parts: that move.
        owns: their states (…, n).
        carrier: (3, 3) with all parts at rest.
        center: (3,) of mass with all parts at rest.
        mass: of all together at first.
        burned: propellant that has left.
    """
    left = mass - sum((tank.mass for tank in burned), 0.0)
    placed = [_place(part, part.coordinates_of(own), center) for part, own in zip(parts, owns, strict=True)]
    inertia, offset = carrier, jnp.zeros(3)
    for part, at in zip(parts, placed, strict=True):
        place, tensor = part.at_rest()
        place = place - center
        inertia = inertia + part.mass * (_spread(at.place) - _spread(place))
        if at.tensor is not None and tensor is not None:
            inertia = inertia + (at.tensor - tensor)
        offset = offset + (part.mass / left)[..., None] * (at.place - place)
    for tank in burned:
        place = tank.place - center
        lost = _spread(place) if tank.inertia_per_mass is None else _spread(place) + tank.inertia_per_mass
        inertia = inertia - tank.mass[..., None, None] * lost
        offset = offset - (tank.mass / left)[..., None] * place
    inertia = inertia - jnp.asarray(left)[..., None, None] * _spread(offset)
    columns, impulses, owners = [], [], []
    for k, (part, at) in enumerate(zip(parts, placed, strict=True)):
        for j, shift in enumerate(at.shifts):
            column = part.mass * jnp.cross(at.place - offset, shift)
            columns.append(column + _turned(at.tensor, at.axes[j]) if at.axes else column)
            impulses.append(part.mass * shift)
            owners.append((k, j))
    masses: list[Vectors] = [[_dot(a, b) * (-1.0 / left) for b in impulses] for a in impulses]
    for i, (k, first) in enumerate(owners):
        for j, (other, second) in enumerate(owners):
            if k == other:
                masses[i][j] = masses[i][j] + _own_mass(parts[k], placed[k], first, second)
    return Arrangement(placed, offset, inertia, columns, masses, jnp.asarray(left))


def _place(part: AbstractMovingPart, q: Array, center: Array) -> Placed:
    shifts = [jax.jvp(part.position, (q,), (unit,))[1] for unit in _units(q)]
    axes = [] if (turning := part.turning_axes(q)) is None else list(turning)
    gauges = []
    if part.gauge(q) is not None:
        gauges = [jax.jvp(part.gauge, (q,), (unit,))[1] for unit in _units(q)]
    return Placed(part.position(q) - center, shifts, part.tensor(q), axes, gauges)


def _own_mass(part: AbstractMovingPart, at: Placed, i: int, j: int) -> Array:
    own = part.mass * _dot(at.shifts[i], at.shifts[j])
    if at.axes:
        own = own + _dot(at.axes[i], _turned(at.tensor, at.axes[j]))
    return own + at.gauges[i] * at.gauges[j] if at.gauges else own


def leave_hub(
    parts: Sequence[AbstractMovingPart], carrier: Array, center: Array, mass: Array
) -> tuple[Float64[Array, ""], Float64[Array, "3 3"]]:
    """Return mass () and inertia (3, 3) about its own centre of the rest of a body without its parts."""
    left, first, about = jnp.asarray(mass), jnp.zeros(3), carrier
    for part in parts:
        place, tensor = part.at_rest()
        place = place - center
        left, first, about = left - part.mass, first - part.mass * place, about - part.mass * _spread(place)
        about = about if tensor is None else about - tensor
    safe = jnp.where(left > 0.0, left, 1.0)
    return left, about - safe * _spread(first / safe)


def momenta(
    arrangement: Arrangement, velocity: Array, rates: Vectors
) -> tuple[Float64[Array, "... 3"], Vectors]:
    """Return L (…, 3) of carrier and parts, and π_j (…), of Ω (…, 3) and q̇_j (…)."""
    angular = jnp.sum(arrangement.inertia * velocity[..., None, :], axis=-1)
    for column, rate in zip(arrangement.columns, rates, strict=True):
        angular = angular + column * rate[..., None]
    own = []
    for column, row in zip(arrangement.columns, arrangement.masses, strict=True):
        own.append(sum((m * rate for m, rate in zip(row, rates, strict=True)), _dot(column, velocity)))
    return angular, own


def velocities(
    arrangement: Arrangement, momentum: Array, own: Vectors
) -> tuple[Float64[Array, "... 3"], Vectors]:
    """Return Ω (…, 3) and q̇_j (…) of L (…, 3) and π_j (…)."""
    rows = [[arrangement.inertia[..., i, j] for j in range(3)] for i in range(3)]
    for i, row in enumerate(rows):
        row.extend(column[..., i] for column in arrangement.columns)
    for column, row in zip(arrangement.columns, arrangement.masses, strict=True):
        rows.append([*(column[..., i] for i in range(3)), *row])
    solution = solve_symmetric(rows, [*(momentum[..., i] for i in range(3)), *own])
    return jnp.stack(jnp.broadcast_arrays(*solution[:3]), axis=-1), solution[3:]


def slopes(
    parts: Sequence[AbstractMovingPart], owns: Sequence[Array], arrangement: Arrangement, velocity: Array,
    rates: Vectors,
) -> Vectors:
    """Return ∂(T − V)/∂q_j (…) at fixed Ω and q̇, with the spin momentum that a part may carry.

    With v = Ω × ρ + ṙ of a part and v_c = Ω × d + ḋ of the centre of mass, both relative to their places at rest,
    ∂T/∂q_j = m (v − v_c)·∂_j v + ∂_j ½ ω·Iω, so that every part's derivatives are its own.
    """
    drifting = jnp.cross(velocity, arrangement.offset)
    flat = iter(rates)
    own_rates = [[next(flat) for _ in at.shifts] for at in arrangement.parts]
    for part, at, speeds in zip(parts, arrangement.parts, own_rates, strict=True):
        for shift, rate in zip(at.shifts, speeds, strict=True):
            drifting = drifting + (part.mass / arrangement.mass * rate)[..., None] * shift
    forces = []
    for part, at, speeds, own in zip(parts, arrangement.parts, own_rates, owns, strict=True):
        moving = jnp.cross(velocity, at.place) - drifting
        for shift, rate in zip(at.shifts, speeds, strict=True):
            moving = moving + shift * rate[..., None]
        forces.extend(_slopes_of(part, own, velocity, speeds, part.mass * moving))
    return forces


def _slopes_of(part: AbstractMovingPart, own: Array, velocity: Array, rates: Vectors, impulse: Array) -> Vectors:
    q = part.coordinates_of(own)
    if not part.count:
        return []
    speed = jnp.broadcast_to(jnp.stack(rates, axis=-1), (*impulse.shape[:-1], part.count))
    q, rest = jnp.broadcast_to(q, speed.shape), own[..., part.count :]

    def lagrangian(at: Array) -> Array:
        place, moving = jax.jvp(part.position, (at,), (speed,))
        value = _dot(impulse, jnp.cross(velocity, place) + moving) - part.potential(at)
        tensor, axes = part.tensor(at), part.turning_axes(at)
        if tensor is not None:
            turning = velocity
            for axis, rate in zip(axes or (), rates, strict=axes is not None):
                turning = turning + axis * rate[..., None]
            value = value + 0.5 * _dot(turning, _turned(tensor, turning))
        if part.gauge(at) is not None:
            value = value + 0.5 * jax.jvp(part.gauge, (at,), (speed,))[1] ** 2
        if part.carries_spin:
            value = value + _dot(velocity, part.momentum(jnp.concatenate([at, rest], axis=-1)))
        return value

    return [jax.jvp(lagrangian, (q,), (unit,))[1] for unit in _units(q)]


def shares(parts: Sequence[AbstractMovingPart], arrangement: Arrangement) -> Vectors:
    """Return ∂_j d (…, 3), the derivatives of the centre of mass by the coordinates."""
    pairs = zip(parts, arrangement.parts, strict=True)
    return [(part.mass / arrangement.mass)[..., None] * shift for part, at in pairs for shift in at.shifts]


def pulls(
    parts: Sequence[AbstractMovingPart], owns: Sequence[Array], arrangement: Arrangement, strength: Array, centre: Array
) -> Vectors:
    """Return −∂V/∂q_j (…) of V = ½ GM/R³ (3 R̂·JR̂ − tr J), of the strength GM/R³ (…) and R̂ (…, 3).

    On dm at x from the centre of mass acts GM/R³ (3 R̂ R̂·x − x) dm, which ∂_j r moves and w_j turns.
    """
    forces = []
    for part, at, own in zip(parts, arrangement.parts, owns, strict=True):
        place = at.place - arrangement.offset
        force = strength[..., None] * (3.0 * centre * _dot(centre, place)[..., None] - place)
        spin, tensor = part.spin_inertia(part.coordinates_of(own)), at.tensor
        if spin is not None:
            tensor = spin if tensor is None else tensor + spin
        for j, shift in enumerate(at.shifts):
            pull = part.mass * _dot(shift, force)
            if at.axes:
                couple = jnp.cross(centre, _turned(tensor, centre))
                pull = pull + 3.0 * strength * _dot(at.axes[j], couple)
            forces.append(pull)
    return forces


def flux(
    parts: Sequence[AbstractMovingPart], arrangement: Arrangement, velocity: Array, rates: Vectors, place: Array
) -> tuple[Float64[Array, "... 3"], Float64[Array, "... 3"], Vectors]:
    """Return w (…, 3) of a point of the carrier about the centre of mass, (r − c) × w, and w·∂w/∂q̇_j (…).

    They are velocity, momentum and canonical momentum of a kilogram there, which it takes along where it leaves.

    Args:
        place: r (3,), from the centre of mass at rest.
    """
    moved, arm = shares(parts, arrangement), place - arrangement.offset
    speed = jnp.cross(velocity, arm)
    for shift, rate in zip(moved, rates, strict=True):
        speed = speed - shift * rate[..., None]
    return speed, jnp.cross(arm, speed), [-_dot(speed, shift) for shift in moved]


def _units(q: Array) -> Vectors:
    return [jnp.broadcast_to(row, q.shape) for row in jnp.eye(q.shape[-1])]


def _dot(a: Array, b: Array) -> Array:
    return jnp.sum(a * b, axis=-1)


def _turned(tensor: Array | None, vector: Array) -> Array:
    assert tensor is not None, "a part that turns has an inertia"
    return jnp.sum(tensor * vector[..., None, :], axis=-1)


def _spread(place: Array) -> Array:
    """Return D(x) = |x|² 1 − x xᵀ (…, 3, 3)."""
    return jnp.sum(place**2, axis=-1)[..., None, None] * jnp.eye(3) - place[..., :, None] * place[..., None, :]
