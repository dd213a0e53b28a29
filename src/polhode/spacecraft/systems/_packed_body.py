"""Packed states of a body with mounts and torques, and the axes along which these see it."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from itertools import chain
from typing import Any, NamedTuple

import equinox as eqx
import jax.numpy as jnp
import numpy as np

from polhode import rotation
from polhode._base import check
from polhode._base.arrays import compiled_for_few_calls, is_traced, known_numbers_only, require_doubles
from polhode.errors import InvalidInput, shown
from polhode.motion._axes import Turn
from polhode.motion._inputs import refuse_not_finite
from polhode.motion._layout import (
    ATTITUDE,
    ENERGY,
    MOMENTUM,
    MOMENTUM_SPACE,
    MOMENTUM_SQUARED,
    Quantity,
    StateLayout,
    StatePart,
)
from polhode.spacecraft.systems._moving_masses import Arrangement, Burned, arrange, momenta
from polhode.spacecraft.systems.mounts import AbstractMount, AbstractMounted
from polhode.spacecraft.systems.moving_parts import AbstractMovingPart
from polhode.spacecraft.systems.propellant import Propellant
from polhode.spacecraft.torques import AbstractTorque
from polhode.systems._checks import as_finite_state, check_unit_attitude
from polhode.systems._symmetric import solve_symmetric
from polhode.systems.base import AbstractSystem
from polhode.types import Array, ArrayLike, Float64, Real


class BodyState(NamedTuple):
    """A packed state taken apart.

    Attributes:
        attitude: (…, 4) or None.
        momentum: L (…, 3) of body and mounts.
        mounts: the own states (…, n) of the mounts, in their order.
        torques: those of the torques.
    """

    attitude: Float64[Array, "*batch 4"] | None
    momentum: Float64[Array, "*batch 3"]
    mounts: tuple[Float64[Array, "*batch n"], ...]
    torques: tuple[Float64[Array, "*batch n"], ...]


class Structure(NamedTuple):
    """The axes in which a body is given, with its other mass properties.

    Attributes:
        turn: from the given axes to the principal ones.
        center_of_mass: (3,) with all mounts at rest [m, given axes].
        mass: () of all together [kg]; None where it is not known.
    """

    turn: Turn
    center_of_mass: Float64[Array, "3"]
    mass: Float64[Array, ""] | None


class AbstractPackedBody(AbstractSystem):
    """The state of a body with mounts and torques: attitude, momentum, the own states of mounts and of torques.

    Attitude and momentum of a state are those of the principal axes. Mounts and torques have them along the given
    axes, so that none of them depends on the principal ones.
    """

    moments: eqx.AbstractVar[Float64[Array, "3"]]
    mounts: eqx.AbstractVar[tuple[AbstractMounted, ...]]
    torques: eqx.AbstractVar[tuple[AbstractTorque, ...]]
    structure: eqx.AbstractVar[Structure | None]

    @property
    def given_axes(self) -> Float64[Array, "3 3"] | None:
        """(3, 3) principal axes by columns in the given ones, which mounts and torques have; None if both agree."""
        return None if self.structure is None else self.structure.turn.matrix

    @property
    def inertia(self) -> Float64[Array, "3"] | Float64[Array, "3 3"]:
        """The inertia of all with the mounts locked at rest [kg m², given axes]: (3,) if diagonal, or (3, 3)."""
        if self.structure is None:
            return self.moments
        axes = self.structure.turn.matrix
        return (axes * self.moments) @ axes.T

    @property
    def carrier(self) -> Float64[Array, "3"] | Float64[Array, "3 3"]:
        """K [kg m², given axes], the inertia of the parts that turn with Ω: (3,) if diagonal, or (3, 3)."""
        turning = [inertia for mount in self.mounts if (inertia := mount.inertia) is not None]
        whole = self.inertia
        return (jnp.diag(whole) if whole.ndim == 1 else whole) - sum(turning) if turning else whole

    @property
    def needs_attitude(self) -> bool:
        """Whether a mount or a torque depends on the attitude."""
        return any(attachment.needs_attitude for attachment in chain(self.mounts, self.torques))

    @property
    def own_parts(self) -> tuple[StatePart, ...]:
        """The parts of the state behind the momentum: of the mounts, then of the torques; equal names are counted."""
        parts = [part for attachment in chain(self.mounts, self.torques) for part in attachment.state_parts]
        often, counted = Counter(part.name for part in parts), Counter[str]()
        named = []
        for part in parts:
            counted[part.name] += 1
            named.append(part._replace(name=f"{part.name}_{counted[part.name]}") if often[part.name] > 1 else part)
        return tuple(named)

    @property
    def moving_parts(self) -> tuple[AbstractMovingPart, ...]:
        """Those mounts that move their mass."""
        return tuple(mount for mount in self.mounts if isinstance(mount, AbstractMovingPart))

    @property
    def tanks(self) -> tuple[Propellant, ...]:
        """Those mounts whose mass leaves the body."""
        return tuple(mount for mount in self.mounts if isinstance(mount, Propellant))

    # ------------------------------------------------------------------ axes

    def _as_given(self, body: BodyState) -> BodyState:
        """Return a state along the given axes, from the principal ones; the attachments' own states are so already."""
        if self.structure is None:
            return body
        back = self.structure.turn.back
        attitude = None if body.attitude is None else back.attitude(body.attitude)
        return body._replace(attitude=attitude, momentum=back.vector(body.momentum))

    def _along_principal(self, vector: Array) -> Array:
        return vector if self.structure is None else self.structure.turn.vector(vector)

    # ------------------------------------------------------------------ packed states

    def pack(
        self, attitude: Real[ArrayLike, "*#batch 4"] | None = None,
        angular_velocity: Real[ArrayLike, "*#batch 3"] | None = None,
        momentum: Real[ArrayLike, "*#batch 3"] | None = None,
        rates: Sequence[Real[ArrayLike, "..."] | None] | None = None,
        actuators: Sequence[Real[ArrayLike, "..."] | None] | None = None,
        coordinates: Sequence[Real[ArrayLike, "..."] | None] | None = None,
    ) -> Float64[Array, "... n"]:
        """Return packed states (…, n), from values along the given axes; for a body from moments, the principal.

        Args:
            attitude: (…, 4) unit quaternion wxyz, given axes → space; left out, the state has none, or the identity
                where a mount or a torque needs it.
            angular_velocity: Ω (…, 3) of the body [rad/s, given axes]; this, ``momentum``, or neither for rest.
            momentum: L (…, 3) of the body with its mounts [kg m²/s, given axes].
            rates: of the mounts relative to the body, one for each mount in their order [rad/s], (…) for a rotor,
                (…, 3) for a slug or a pendulum, (…, n) for another moving part; None, or the whole left out, is rest
                in the body.
            actuators: own states (…, n) of the torques, one for each torque in their order; None, or the whole left
                out, is zero.
            coordinates: q (…, n) of the mounts that move their mass, None for others; None, or the whole left out, is
                where they rest.

        Raises:
            InvalidInput: if both velocity and momentum are given, for NaN, or lists that do not fit mounts and torques.
        """
        if angular_velocity is not None and momentum is not None:
            raise InvalidInput("give `angular_velocity` or `momentum`, not both.")
        require_doubles(attitude=attitude, angular_velocity=angular_velocity, momentum=momentum)
        given = {"attitude": attitude, "angular_velocity": angular_velocity, "momentum": momentum}
        refuse_not_finite(**{name: jnp.asarray(x, dtype=float) for name, x in given.items() if x is not None})
        values, acting = self._checked_rates(rates), self._checked_actuators(actuators)
        places = self._checked_coordinates(coordinates)
        for name, own in (("rates", values), ("actuators", acting), ("coordinates", places)):
            refuse_not_finite(**{f"{name}[{k}]": x for k, x in enumerate(own) if x is not None})
        quaternion = np.array([1.0, 0.0, 0.0, 0.0]) if self.needs_attitude else None
        if attitude is not None:
            quaternion = jnp.asarray(attitude, dtype=float)
            quaternion = rotation.normalize(quaternion if is_traced(quaternion) else np.asarray(quaternion))
        velocity = np.zeros(3) if angular_velocity is None else jnp.asarray(angular_velocity, dtype=float)
        whole = None if momentum is None else jnp.asarray(momentum, dtype=float)
        return _pack(self, quaternion, velocity, whole, values, places, acting)

    def _arranged(self, owns: Sequence[Array]) -> Arrangement | None:
        """Return where the moving parts are and what is burned; None without any. Of states (…, n) of all mounts."""
        pairs = list(zip(self.mounts, owns, strict=True))
        parts = [mount for mount, _ in pairs if isinstance(mount, AbstractMovingPart)]
        states = [own for mount, own in pairs if isinstance(mount, AbstractMovingPart)]
        burned = [Burned(mount.full - own[..., 0], mount.place, mount.inertia_per_mass)
                  for mount, own in pairs if isinstance(mount, Propellant)]
        if not (parts or burned):
            return None
        carrier = self.carrier
        carrier = jnp.diag(carrier) if carrier.ndim == 1 else carrier
        center = jnp.zeros(3) if self.structure is None else self.structure.center_of_mass
        return arrange(parts, states, carrier, center, self._mass, burned)

    @property
    def _mass(self) -> Array:
        """The mass of all together; one where it is not given, and no mass moves."""
        mass = None if self.structure is None else self.structure.mass
        return jnp.ones(()) if mass is None else mass

    def _started(
        self, arrangement: Arrangement | None, rates: list[Array | None], places: list[Array | None], velocity: Array
    ) -> tuple[Array, list[Array]]:
        """Return L (…, 3) and the own states of all mounts that move at rates in a body that turns with Ω (…, 3)."""
        known: list[Array] = [np.zeros(()) if rate is None else rate for rate in rates]
        pairs = list(zip(self.mounts, known, places, strict=True))
        moving = [(mount, rate, q) for mount, rate, q in pairs if isinstance(mount, AbstractMovingPart)]
        each = [mount.coordinate_rates(q, rate) for mount, rate, q in moving if q is not None]
        speeds = [rate[..., j] for rate in each for j in range(rate.shape[-1])]
        if arrangement is None:
            carrier = self.carrier
            total, canonical = carrier * velocity if carrier.ndim == 1 else velocity @ carrier, []
        else:
            total, canonical = momenta(arrangement, velocity, speeds)
        queue, own = iter(canonical), []
        for mount, rate, q in pairs:
            if isinstance(mount, AbstractMovingPart):
                assert q is not None, "moving parts have coordinates"
                further = mount.start_further(q, rate, velocity)
                pieces = [q, *(next(queue)[..., None] for _ in range(mount.count)), further]
                shape = np.broadcast_shapes(*(piece.shape[:-1] for piece in pieces))
                pieces = [jnp.broadcast_to(piece, (*shape, piece.shape[-1])) for piece in pieces]
                own.append(jnp.concatenate(pieces, axis=-1))
            else:
                assert isinstance(mount, AbstractMount)
                own.append(mount.start(rate, velocity))
            total = total + mount.momentum(own[-1])
        return total, own

    def _checked_coordinates(self, coordinates: Sequence[Array | None] | None) -> list[Array | None]:
        per_mount = _one_each("coordinates", coordinates, "mounts", len(self.mounts))
        places: list[Array | None] = []
        for k, (mount, q) in enumerate(zip(self.mounts, per_mount, strict=True)):
            moves = isinstance(mount, AbstractMovingPart)
            if q is not None and not moves:
                raise InvalidInput(
                    f"`coordinates[{k}]` is for a {type(mount).__name__}, which does not move its mass; got {shown(q)}."
                    " Give None for it."
                )
            places.append(_of_part(f"coordinates[{k}]", mount, q, mount.count, "coordinates") if moves else None)
        return places

    def _checked_rates(self, rates: Sequence[Array | None] | None) -> list[Array | None]:
        per_mount = _one_each("rates", rates, "mounts", len(self.mounts))
        values: list[Array | None] = []
        for k, (mount, rate) in enumerate(zip(self.mounts, per_mount, strict=True)):
            if rate is not None and not mount.state_size:
                raise InvalidInput(
                    f"`rates[{k}]` is for a {type(mount).__name__}, which has no rate of its own to start with; "
                    f"got {shown(rate)}. Give None for it."
                )
            if isinstance(mount, AbstractMovingPart):
                values.append(_of_part(f"rates[{k}]", mount, rate, mount.rate_count, "rates"))
            elif isinstance(mount, Propellant) and rate is not None:
                mount.start(rate, np.zeros(3))  # refuses all but a zero that is not traced
                values.append(None)
            else:
                values.append(None if rate is None else jnp.asarray(rate, dtype=float))
        return values

    def _checked_actuators(self, actuators: Sequence[Array | None] | None) -> list[Array]:
        per_torque = _one_each("actuators", actuators, "torques", len(self.torques))
        own = []
        for k, (torque, part) in enumerate(zip(self.torques, per_torque, strict=True)):
            own.append(np.zeros(torque.state_size) if part is None else jnp.asarray(part, dtype=float))
            if own[-1].shape[-1:] != (torque.state_size,):
                raise InvalidInput(
                    f"`actuators[{k}]` must have shape (…, {torque.state_size}), the own state of a "
                    f"{type(torque).__name__}; got {own[-1].shape}."
                )
        return own

    def parts(self, state: Real[ArrayLike, "..."]) -> BodyState:
        """Take a packed state apart, along the principal axes.

        Raises:
            InvalidInput: for a wrong last axis.
        """
        require_doubles(state=state)
        sizes = [attachment.state_size for attachment in chain(self.mounts, self.torques)]
        shape, bare = jnp.shape(state), 3 + sum(sizes)
        carries = shape[-1:] == (4 + bare,)
        if not (carries or (shape[-1:] == (bare,) and not self.needs_attitude)):
            shorter = "" if self.needs_attitude else f"(…, {bare}), or "
            raise InvalidInput(
                f"`state` of {type(self).__name__} must have shape {shorter}(…, {4 + bare}) with the attitude in "
                f"front; got {shape}. Make it by `pack(attitude, angular_velocity)`."
            )
        ends = np.cumsum([4] * carries + [3, *sizes]).tolist()
        split = [state[..., start:end] for start, end in zip([0, *ends[:-1]], ends, strict=True)]
        attitude = split.pop(0) if carries else None
        momentum, *own = split
        return BodyState(attitude, momentum, tuple(own[: len(self.mounts)]), tuple(own[len(self.mounts) :]))

    @known_numbers_only
    def check_state(self, state: Real[ArrayLike, "*shape"]) -> Float64[Array, "*shape"]:
        """Return states as an array.

        Raises:
            InvalidInput: for wrong shapes, values that are not finite, an attitude that is not a unit quaternion.
        """
        state = as_finite_state(state, float)
        return state if self.parts(np.asarray(state)).attitude is None else check_unit_attitude(state)

    def layout(self, state: Float64[Array, "*batch n"]) -> StateLayout:
        front = () if self.parts(state).attitude is None else (ATTITUDE,)
        return StateLayout((*front, MOMENTUM, *self.own_parts))

    def scales(self, state: Float64[Array, "*batch n"]) -> Float64[Array, "n"]:
        """Return one for the attitude, and for momenta their size, or the size that torques and motors give from rest.

        Other parts of the state have their own size, or one; displacements at rest that of the body.
        """
        body = self.parts(state)
        layout = StateLayout(self.own_parts)
        behind = jnp.concatenate([*body.mounts, *body.torques, jnp.zeros((*body.momentum.shape[:-1], 0))], axis=-1)
        sizes = {part.name: jnp.max(jnp.abs(layout.part(behind, part.name)), initial=0.0) for part in layout.parts}
        momenta = [part.name for part in layout.parts if part.unit == MOMENTUM.unit]
        largest = jnp.max(jnp.abs(body.momentum), initial=0.0)
        for name in momenta:
            largest = jnp.maximum(largest, sizes[name])
        for mount in self.mounts:
            largest = jnp.maximum(largest, mount.momentum_scale)
        for torque in self.torques:
            largest = jnp.maximum(largest, jnp.max(self.moments) * torque.rate)
        for mount, own in zip(self.mounts, body.mounts, strict=True):
            if isinstance(mount, AbstractMovingPart):  # momentum that springs give a body from rest
                energy = jnp.max(jnp.abs(mount.potential(mount.coordinates_of(own))), initial=0.0)
                largest = jnp.maximum(largest, jnp.sqrt(2.0 * energy * jnp.max(self.moments)))
        scale = jnp.where(largest > 0, largest, jnp.max(self.moments))
        scales = [jnp.ones(4)] if body.attitude is not None else []
        scales.append(jnp.full(3, scale))
        length = jnp.sqrt(jnp.max(self.moments) / self._mass)
        natural = {"m": length, "kg m s-1": scale / length}
        for part in layout.parts:
            usual = natural.get(part.unit, 1.0)
            size = scale if part.name in momenta else jnp.where(sizes[part.name] > 0, sizes[part.name], usual)
            scales.append(jnp.full(part.size, size))
        return jnp.concatenate(scales)

    @property
    def quantities(self) -> dict[str, Quantity]:
        return {
            "energy": ENERGY,
            "kinetic_energy": Quantity("J", "kinetic energy"),
            "|L|²": MOMENTUM_SQUARED,
            "momentum_space": MOMENTUM_SPACE,
            "jacobi_integral": Quantity("J", "Jacobi integral in the orbit's frame"),
        }

    @property
    def free_moments(self) -> Float64[Array, "3"] | None:
        return None if self.mounts or self.torques else self.moments



@compiled_for_few_calls
def _pack(
    body: AbstractPackedBody, attitude: Array | None, velocity: Array, momentum: Array | None,
    rates: list[Array | None], places: list[Array | None], actuators: list[Array],
) -> Array:
    """Return packed states of arguments that ``pack`` has checked; of Ω only where the momentum is None."""
    arrangement = body._arranged([_at_start(x, q) for x, q in zip(body.mounts, places, strict=True)])
    if momentum is not None:
        # L = J Ω + the momentum of parts that turn against the body
        still = body._started(arrangement, rates, places, jnp.zeros(3))[0]
        units = [body._started(arrangement, rates, places, unit)[0] - still for unit in jnp.eye(3)]
        rows, right = [[unit[..., i] for unit in units] for i in range(3)], momentum - still
        velocity = jnp.stack(solve_symmetric(rows, [right[..., i] for i in range(3)]), axis=-1)
    total, own = body._started(arrangement, rates, places, velocity)
    front = [] if attitude is None else [attitude]
    if body.structure is not None:
        front = [body.structure.turn.attitude(x) for x in front]
    parts = [*front, body._along_principal(total), *own, *actuators]
    shape = np.broadcast_shapes(*(part.shape[:-1] for part in parts))
    return jnp.concatenate([jnp.broadcast_to(part, (*shape, part.shape[-1])) for part in parts], axis=-1)


def _one_each(name: str, values: Any, things: str, count: int) -> list[Array | None]:
    if values is None:
        return [None] * count
    if not isinstance(values, Sequence | np.ndarray) or len(values) != count:
        check.refuse(name,
                     f"a list with one entry for each of the {count} {things}, None where there is nothing to say",
                     values)
    require_doubles(**{f"{name}[{k}]": value for k, value in enumerate(values)})
    return list(values)


def _of_part(name: str, part: AbstractMovingPart, value: Any, count: int, what: str) -> Array:
    """Return coordinates or rates (…, n) of a moving part; a number where it has one of them."""
    if value is None:
        return np.zeros(count)
    numbers = jnp.asarray(value, dtype=float)
    if count == 1 and numbers.shape[-1:] != (1,):
        numbers = numbers[..., None]
    if numbers.shape[-1:] != (count,):
        raise InvalidInput(
            f"`{name}` must have shape (…, {count}), the {what} of a {type(part).__name__}; got {numbers.shape}."
        )
    return numbers


def _at_start(mount: AbstractMounted, q: Array | None) -> Array:
    """Return an own state (…, n) in which only those parts count that change the mass properties."""
    if isinstance(mount, AbstractMount):
        return mount.start(np.zeros(()), jnp.zeros(3))
    assert q is not None, "moving parts have coordinates"
    return jnp.concatenate([q, jnp.zeros((*q.shape[:-1], mount.state_size - q.shape[-1]))], axis=-1)
