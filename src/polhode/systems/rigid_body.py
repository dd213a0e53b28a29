"""A rigid body put together from parts, mounts inside it and torques on it, with its equations of motion."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from itertools import chain
from typing import Any, ClassVar, NamedTuple

import equinox as eqx
import jax.numpy as jnp
import numpy as np

from polhode import rotation
from polhode.arrays import known_numbers_only, refuse_single_precision
from polhode.errors import InvalidInput, shown
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
from polhode.systems.attachments import Time
from polhode.systems.base import AbstractSystem, Balance, Vectors, as_finite_state, check_unit_attitude
from polhode.systems.free_rigid_body import checked_moments
from polhode.systems.mounts import AbstractMount, checked_mounts
from polhode.systems.torques import AbstractTorque, GravityGradient, checked_torques
from polhode.types import Array, ArrayLike, Float64, Real

States = Float64[Array, "*#batch n"]


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


class AbstractRigidBody(AbstractSystem):
    """A body with mounts and torques: L̇ = L × (Ω + Σ d) + Σ τ, dR/dt = R hat(Ω + Σ d), with KΩ = L − Σ p.

    L is the whole angular momentum along the principal axes, p the momentum that a mount has of its own, d its drift
    (zero but for losses without a state of their own), τ a torque, K the ``carrier`` inertia. Mounts act on the body
    through p and d alone, and so never change R L. State: the attitude, L, the own states of mounts and of torques, as
    ``layout`` names them; the attitude may be left out where nothing asks for it.
    """

    moments: eqx.AbstractVar[Float64[Array, "3"]]
    mounts: eqx.AbstractVar[tuple[AbstractMount, ...]]
    torques: eqx.AbstractVar[tuple[AbstractTorque, ...]]

    @property
    def carrier(self) -> Float64[Array, "3"] | Float64[Array, "3 3"]:
        """K [kg m²], the inertia of what turns with Ω: (3,) of the principal axes, or (3, 3)."""
        turning = self._turning_inertia()
        return jnp.diag(self.moments) - sum(turning) if turning else self.moments

    def _turning_inertia(self) -> list[Array]:
        return [inertia for mount in self.mounts if (inertia := mount.inertia) is not None]

    @property
    def needs_attitude(self) -> bool:
        """Whether a mount or a torque depends on how the body is turned."""
        return any(attachment.needs_attitude for attachment in chain(self.mounts, self.torques))

    @property
    def jumps(self) -> Float64[Array, "jumps"]:
        """(J,) times [s] at which a mount or a torque starts, ends or jumps."""
        own = [jnp.ravel(jnp.asarray(x.jumps, dtype=float)) for x in chain(self.mounts, self.torques)]
        return jnp.concatenate([*own, jnp.zeros(0)])

    @property
    def own_parts(self) -> tuple[StatePart, ...]:
        """The parts of the state behind the momentum: of the mounts, then of the torques; equal names are counted."""
        parts = [part for attachment in chain(self.mounts, self.torques) for part in attachment.state_parts]
        often, seen = Counter(part.name for part in parts), Counter[str]()
        named = []
        for part in parts:
            seen[part.name] += 1
            named.append(part._replace(name=f"{part.name}_{seen[part.name]}") if often[part.name] > 1 else part)
        return tuple(named)

    # ------------------------------------------------------------------ motion

    def vector_field(self, t: Time, state: States) -> Float64[Array, "*batch n"]:
        body, t = self.parts(state), jnp.asarray(t)
        velocity = self._velocity(body)
        turning = velocity + self._drift(body, velocity)
        change = jnp.cross(body.momentum, turning) + self._torque(t, body, velocity)
        attitude = () if body.attitude is None else (rotation.quaternion_rate(body.attitude, turning),)
        own = [
            attachment.state_rate(t, body.attitude, velocity, values)
            for attachment, values in zip((*self.mounts, *self.torques), (*body.mounts, *body.torques), strict=True)
        ]
        return jnp.concatenate([*attitude, change, *own], axis=-1)

    def external_torque(self, t: Time, state: States) -> Float64[Array, "*batch 3"]:
        """Return the sum of all torques (…, 3) [N m, body axes]."""
        body = self.parts(state)
        return self._torque(jnp.asarray(t), body, self._velocity(body))

    def _velocity(self, body: BodyState) -> Array:
        return _solve(self.carrier, self._carried_momentum(body))

    def _carried_momentum(self, body: BodyState) -> Array:
        """Return KΩ, the momentum of the parts that turn with Ω."""
        momentum = body.momentum
        for mount, own in zip(self.mounts, body.mounts, strict=True):
            momentum = momentum - mount.momentum(own)
        return momentum

    def _drift(self, body: BodyState, velocity: Array) -> Array:
        return sum((mount.drift(body.momentum, velocity) for mount in self.mounts), jnp.zeros_like(velocity))

    def _torque(self, t: Array, body: BodyState, velocity: Array) -> Array:
        torques = zip(self.torques, body.torques, strict=True)
        return sum((x.torque(t, body.attitude, velocity, own) for x, own in torques), jnp.zeros_like(velocity))

    # ------------------------------------------------------------------ what is kept, and what is balanced

    @property
    def conserves_energy(self) -> bool:
        """Whether nothing inside or outside does work."""
        return not self.torques and all(mount.conserves_energy for mount in self.mounts)

    def energy(self, state: Float64[Array, "*batch n"]) -> Float64[Array, "*batch"]:
        """Return ½ Ω·KΩ and the mounts' own energy (…) [J]."""
        body = self.parts(state)
        return self._energy(body, self._velocity(body))

    def power(self, t: Time, state: States) -> Float64[Array, "*batch"]:
        """Return the power of mounts and torques (…) [W]."""
        body, t = self.parts(state), jnp.asarray(t)
        velocity = self._velocity(body)
        outer = jnp.sum(self._torque(t, body, velocity) * velocity, axis=-1)
        return outer + self._inner_power(t, body, velocity)

    def _energy(self, body: BodyState, velocity: Array) -> Array:
        own = [mount.energy(values) for mount, values in zip(self.mounts, body.mounts, strict=True)]
        return sum(own, 0.5 * jnp.sum(self._carried_momentum(body) * velocity, axis=-1))

    def _inner_power(self, t: Array, body: BodyState, velocity: Array) -> Array:
        pairs = zip(self.mounts, body.mounts, strict=True)
        power = sum((mount.power(t, body.attitude, velocity, own) for mount, own in pairs), 0.0)
        # the drift adds L × d to L̇, and Ω·(L × d) = −d·(L × Ω) to the power
        return power - jnp.sum(self._drift(body, velocity) * jnp.cross(body.momentum, velocity), axis=-1)

    def invariants(self, state: Float64[Array, "*batch n"]) -> dict[str, Float64[Array, "..."]]:
        """Return |L|² and the momentum in space, where no torque acts, and energy, where nothing does work."""
        if self.torques:
            return {}
        body = self.parts(state)
        values = {"energy": self.energy(state)} if self.conserves_energy else {}
        # L̇ = L × (…) keeps |L|, and R L whatever the body does inside
        values |= {"|L|²": jnp.sum(body.momentum**2, axis=-1)}
        if body.attitude is not None:
            values["momentum_space"] = rotation.rotate(body.attitude, body.momentum)
        return values

    def balances(self, t: Time, state: States) -> dict[str, Balance]:
        """Return energy and |L|² with their powers, and with gravity on a circular orbit the Jacobi integral.

        Under torques the energy is called kinetic, as the potential of what causes them is not in it.
        """
        body, t = self.parts(state), jnp.asarray(t)
        velocity = self._velocity(body)
        energy = self._energy(body, velocity)
        inner = self._inner_power(t, body, velocity)
        if not self.torques:
            return {} if self.conserves_energy else {"energy": Balance(energy, inner)}
        torque = self._torque(t, body, velocity)
        balances = {
            "kinetic_energy": Balance(energy, jnp.sum(torque * velocity, axis=-1) + inner),
            "|L|²": Balance(jnp.sum(body.momentum**2, axis=-1), 2.0 * jnp.sum(torque * body.momentum, axis=-1)),
        }
        gravity = [torque for torque in self.torques if isinstance(torque, GravityGradient)]
        if body.attitude is not None and len(gravity) == 1 and gravity[0].circular:
            balances["jacobi_integral"] = self._jacobi_integral(gravity[0], t, body, body.attitude, torque)
        return balances

    def _jacobi_integral(
        self, gravity: GravityGradient, t: Array, body: BodyState, attitude: Array, torque: Array
    ) -> Balance:
        """Return H − n π_z: that of the body with its mounts locked, and what they add by turning.

        With w = Ω − ν the velocity relative to the orbit's frame, a mount adds its energy less ν·p, and takes
        ½ w·Sw − ½ ν·Sν = ½ (w − ν)·SΩ for the inertia S that it turns by itself.
        """
        velocity = self._velocity(body)
        relative = gravity.relative_velocity(attitude, velocity)
        orbital = velocity - relative
        value = gravity.jacobi_integral(t, attitude, velocity)
        for mount, own in zip(self.mounts, body.mounts, strict=True):
            value = value + mount.energy(own) - jnp.sum(orbital * mount.momentum(own), axis=-1)
            if mount.inertia is not None:
                locked = _times(mount.inertia, velocity)
                value = value - 0.5 * jnp.sum((relative - orbital) * locked, axis=-1)
        pull = gravity.torque(t, attitude, velocity)
        rate = jnp.sum((torque - pull) * relative, axis=-1) + self._inner_power(t, body, velocity)
        return Balance(value, rate - jnp.sum(pull * self._drift(body, velocity), axis=-1))

    # ------------------------------------------------------------------ packed states

    def pack(
        self, attitude: Real[ArrayLike, "*#batch 4"] | None = None,
        angular_velocity: Real[ArrayLike, "*#batch 3"] | None = None,
        momentum: Real[ArrayLike, "*#batch 3"] | None = None,
        rates: Sequence[Real[ArrayLike, "..."] | None] | None = None,
        actuators: Sequence[Real[ArrayLike, "..."] | None] | None = None,
    ) -> Float64[Array, "... n"]:  # fmt: skip
        """Return packed states (…, n).

        Args:
            attitude: (…, 4) unit quaternion wxyz, body → space; left out, the state has none, or the identity where a
                mount or a torque needs it.
            angular_velocity: Ω (…, 3) of the body [rad/s, body axes]; this, ``momentum``, or neither for rest.
            momentum: L (…, 3) of the body with its mounts [kg m²/s, body axes].
            rates: of the mounts relative to the body, one for each mount in their order [rad/s], (…) for a rotor,
                (…, 3) for a slug; None, or the whole left out, is rest in the body.
            actuators: own states (…, n) of the torques, one for each torque in their order; None, or the whole left
                out, is zero.

        Raises:
            InvalidInput: if both velocity and momentum are given, or rates or actuators that do not fit what there is.
        """
        if angular_velocity is not None and momentum is not None:
            raise InvalidInput("give `angular_velocity` or `momentum`, not both.")
        refuse_single_precision(attitude=attitude, angular_velocity=angular_velocity, momentum=momentum)
        values, acting = self._checked_rates(rates), self._checked_actuators(actuators)
        if attitude is None and self.needs_attitude:
            attitude = jnp.array([1.0, 0.0, 0.0, 0.0])
        velocity = jnp.zeros(3) if angular_velocity is None else jnp.asarray(angular_velocity, dtype=float)
        if momentum is not None:
            starts = zip(self.mounts, values, strict=True)
            inside = sum(mount.momentum(mount.start(rate, jnp.zeros(3))) for mount, rate in starts)
            velocity = _solve(self._locked_inertia(), jnp.asarray(momentum, dtype=float) - inside)
        own = [mount.start(rate, velocity) for mount, rate in zip(self.mounts, values, strict=True)]
        total = _times(self.carrier, velocity)
        for mount, part in zip(self.mounts, own, strict=True):
            total = total + mount.momentum(part)
        front = [] if attitude is None else [rotation.normalize(jnp.asarray(attitude, dtype=float))]
        parts = [*front, total, *own, *acting]
        shape = np.broadcast_shapes(*(part.shape[:-1] for part in parts))
        return jnp.concatenate([jnp.broadcast_to(part, (*shape, part.shape[-1])) for part in parts], axis=-1)

    def _checked_rates(self, rates: Sequence[Array | None] | None) -> list[Array]:
        per_mount = _one_each("rates", rates, "mounts", len(self.mounts))
        for k, (mount, rate) in enumerate(zip(self.mounts, per_mount, strict=True)):
            if rate is not None and not mount.state_size:
                raise InvalidInput(
                    f"`rates[{k}]` is for a {type(mount).__name__}, which has no rate of its own to start with; "
                    f"got {shown(rate)}. Give None for it."
                )
        return [jnp.zeros(()) if rate is None else jnp.asarray(rate, dtype=float) for rate in per_mount]

    def _checked_actuators(self, actuators: Sequence[Array | None] | None) -> list[Array]:
        per_torque = _one_each("actuators", actuators, "torques", len(self.torques))
        own = []
        for k, (torque, part) in enumerate(zip(self.torques, per_torque, strict=True)):
            own.append(jnp.zeros(torque.state_size) if part is None else jnp.asarray(part, dtype=float))
            if own[-1].shape[-1:] != (torque.state_size,):
                raise InvalidInput(
                    f"`actuators[{k}]` must have shape (…, {torque.state_size}), the own state of a "
                    f"{type(torque).__name__}; got {own[-1].shape}."
                )
        return own

    def _locked_inertia(self) -> Array:
        turning, carrier = self._turning_inertia(), self.carrier
        return (jnp.diag(carrier) if carrier.ndim == 1 else carrier) + sum(turning) if turning else carrier

    def parts(self, state: Real[ArrayLike, "..."]) -> BodyState:
        """Take a packed state apart.

        Raises:
            InvalidInput: for a wrong last axis.
        """
        refuse_single_precision(state=state)
        sizes = [attachment.state_size for attachment in chain(self.mounts, self.torques)]
        shape, bare = jnp.shape(state), 3 + sum(sizes)
        carries = shape[-1:] == (4 + bare,)
        if not (carries or (shape[-1:] == (bare,) and not self.needs_attitude)):
            shorter = "" if self.needs_attitude else f"(…, {bare}), or "
            raise InvalidInput(
                f"`state` of {type(self).__name__} must have shape {shorter}(…, {4 + bare}) with the attitude in "
                f"front; got {shape}. Make it by `state(attitude, angular_velocity)`."
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
        return state if self.parts(state).attitude is None else check_unit_attitude(state)

    def layout(self, state: Float64[Array, "*batch n"]) -> StateLayout:
        front = () if self.parts(state).attitude is None else (ATTITUDE,)
        return StateLayout((*front, MOMENTUM, *self.own_parts))

    def scales(self, state: Float64[Array, "*batch n"]) -> Float64[Array, "n"]:
        """Return one for the attitude, and for momenta their size, or that which torques and motors give from rest.

        Other parts of the state have their own size, or one.
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
        scale = jnp.where(largest > 0, largest, jnp.max(self.moments))
        scales = [jnp.ones(4)] if body.attitude is not None else []
        scales.append(jnp.full(3, scale))
        for part in layout.parts:
            size = scale if part.name in momenta else jnp.where(sizes[part.name] > 0, sizes[part.name], 1.0)
            scales.append(jnp.full(part.size, size))
        return jnp.concatenate(scales)

    def vectors(self, state: Float64[Array, "*batch n"]) -> Vectors:
        body = self.parts(state)
        return Vectors(body.attitude, body.momentum, self._velocity(body))

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


class RigidBody(AbstractRigidBody):
    """A body with any mounts inside and any torques on it.

    With nothing it is the free body, with a ``HeldWheel`` a gyrostat, with an ``EnergySink`` the double bracket. As
    Lie–Poisson systems, with exact flows and verdicts, these are ``FreeRigidBody``, ``Gyrostat`` and ``DoubleBracket``.

    Args:
        moments: (3,) principal moments of the whole body, its mounts locked [kg m²], positive.
        mounts: what is inside, such as ``Wheel``; any number, on any axes.
        torques: what acts on it, such as ``LinearDrag``; any number.

    Raises:
        InvalidInput: for moments that are not positive, rotors that leave the body none, what is not a mount or a
            torque, one whose methods fail, or a gravity gradient on other moments.

    >>> from polhode.systems import LinearDrag, Wheel
    >>> wheels = [Wheel((1.0, 0.0, 0.0), 0.1, motor=0.02), Wheel((0.0, 3.0, 4.0), 0.1)]
    >>> body = RigidBody((1.0, 2.0, 2.5), wheels, [LinearDrag(0.5)])
    >>> start = body.pack(angular_velocity=(0.0, 0.0, 1.0), rates=[5.0, 0.0])
    >>> body.layout(start).names
    ('momentum', 'rotor_momentum_1', 'rotor_momentum_2')
    >>> round(float(body.power(0.0, start)), 9)
    -0.4
    """

    title: ClassVar[str] = "Rigid body"
    moments: Float64[Array, "3"]
    mounts: tuple[AbstractMount, ...]
    torques: tuple[AbstractTorque, ...]

    @known_numbers_only
    def __init__(
        self,
        moments: Real[ArrayLike, "3"],
        mounts: Sequence[AbstractMount] = (),
        torques: Sequence[AbstractTorque] = (),
    ) -> None:
        self.moments = checked_moments(moments)
        self.mounts = checked_mounts(mounts)
        self.torques = checked_torques(torques, self.moments)
        carrier = np.asarray(self.carrier)
        left = np.linalg.eigvalsh(carrier) if carrier.ndim == 2 else carrier
        if not left.min() > 0:
            raise InvalidInput(
                f"`mounts` must be parts of the body; without what they turn by themselves it is left with moments "
                f"[{', '.join(f'{x:.6g}' for x in left)}] kg m². `moments` are those of the whole body, its mounts "
                "locked."
            )


def _one_each(name: str, values: Any, things: str, count: int) -> list[Array | None]:
    if values is None:
        return [None] * count
    if not isinstance(values, Sequence | np.ndarray) or len(values) != count:
        raise InvalidInput(
            f"`{name}` must be a list with one entry for each of the {count} {things}, None where there is nothing to "
            f"say; got {shown(values)}."
        )
    refuse_single_precision(**{f"{name}[{k}]": value for k, value in enumerate(values)})
    return list(values)


def _times(inertia: Array, vector: Array) -> Array:
    """Return the product of a symmetric inertia (3, 3), or the diagonal (3,) of one, and vectors (…, 3)."""
    return inertia * vector if inertia.ndim == 1 else vector @ inertia


def _solve(inertia: Array, vector: Array) -> Array:
    """Solve I x = b for x by Cramer's rule, I symmetric (3, 3) or its diagonal (3,), b (…, 3)."""
    if inertia.ndim == 1:
        return vector / inertia
    size = jnp.max(jnp.abs(inertia))  # so that products of three neither overflow nor vanish
    a, b, c = inertia / size
    # I⁻¹ = adj I/det I: its columns are cross products of the rows, and det I = a·(b × c)
    adjugate = jnp.stack([jnp.cross(b, c), jnp.cross(c, a), jnp.cross(a, b)])
    return (vector @ adjugate) / jnp.dot(a, adjugate[0]) / size
