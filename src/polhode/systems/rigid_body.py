"""A rigid body put together from parts, mounts inside it and torques on it, with its equations of motion."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import chain
from typing import ClassVar

import equinox as eqx
import jax.numpy as jnp
import numpy as np

from polhode import rotation
from polhode.arrays import known_numbers_only
from polhode.bodies.body import Body
from polhode.errors import InvalidInput, shown
from polhode.motion._axes import Turn
from polhode.motion._layout import ENERGY, MOMENTUM, MOMENTUM_SPACE, MOMENTUM_SQUARED, Quantity, StateLayout
from polhode.motion.frame import BodyFrame
from polhode.systems._packed_body import AbstractPackedBody, BodyState, Structure
from polhode.systems._symmetric import solve, times
from polhode.systems.attachments import Time
from polhode.systems.base import Balance, Vectors
from polhode.systems.free_rigid_body import checked_moments
from polhode.systems.mounts import AbstractMount, checked_mounts
from polhode.systems.torques import AbstractTorque, GravityGradient, checked_torques, torque_of
from polhode.types import Array, ArrayLike, Float64, Real

States = Float64[Array, "*#batch n"]


class AbstractRigidBody(AbstractPackedBody):
    """A body with mounts and torques: L̇ = L × (Ω + Σ d) + Σ τ, dR/dt = R hat(Ω + Σ d), with KΩ = L − Σ p.

    L is the whole angular momentum, p the momentum that a mount has of its own, d its drift (zero but for losses without
    a state of their own), τ a torque, K the ``carrier`` inertia. Mounts act on the body through p and d alone, and so
    never change R L. State: the attitude, L, the own states of mounts and of torques, as ``layout`` names them; the
    attitude may be left out where nothing asks for it. Attitude and L of states are along the principal axes; what
    attachments see and give, and what ``pack`` takes, is along the body's given axes.
    """

    @property
    def jumps(self) -> Float64[Array, "jumps"]:
        """(J,) times [s] at which a mount or a torque starts, ends or jumps."""
        own = [jnp.ravel(jnp.asarray(x.jumps, dtype=float)) for x in chain(self.mounts, self.torques)]
        return jnp.concatenate([*own, jnp.zeros(0)])

    @property
    def names_all_jumps(self) -> bool:
        return all(attachment.names_all_jumps for attachment in chain(self.mounts, self.torques))

    # ------------------------------------------------------------------ motion

    def vector_field(self, t: Time, state: States) -> Float64[Array, "*batch n"]:
        own, t = self.parts(state), jnp.asarray(t)
        body = self._as_given(own)
        velocity = self._velocity(body)
        turning = velocity + self._drift(body, velocity)
        change = jnp.cross(body.momentum, turning) + self._torque(t, body, velocity)
        turning, change = self._along_principal(turning), self._along_principal(change)
        attitude = () if own.attitude is None else (rotation.quaternion_rate(own.attitude, turning),)
        rates = [
            attachment.state_rate(t, body.attitude, velocity, values)
            for attachment, values in zip((*self.mounts, *self.torques), (*body.mounts, *body.torques), strict=True)
        ]
        return jnp.concatenate([*attitude, change, *rates], axis=-1)

    def external_torque(self, t: Time, state: States) -> Float64[Array, "*batch 3"]:
        """Return the sum of all torques about the centre of mass (…, 3) [N m, given axes]."""
        body = self._as_given(self.parts(state))
        return self._torque(jnp.asarray(t), body, self._velocity(body))

    def _velocity(self, body: BodyState) -> Array:
        return solve(self.carrier, self._carried_momentum(body))

    def _carried_momentum(self, body: BodyState) -> Array:
        """Return KΩ, the momentum of the parts that turn with Ω."""
        momentum = body.momentum
        for mount, own in zip(self.mounts, body.mounts, strict=True):
            momentum = momentum - mount.momentum(own)
        return momentum

    def _drift(self, body: BodyState, velocity: Array) -> Array:
        return sum((mount.drift(body.momentum, velocity) for mount in self.mounts), jnp.zeros_like(velocity))

    def _torque(self, t: Array, body: BodyState, velocity: Array) -> Array:
        return sum(self._torques_apart(t, body, velocity), jnp.zeros_like(velocity))

    def _torques_apart(self, t: Array, body: BodyState, velocity: Array) -> list[Array]:
        each = []
        for torque, own in zip(self.torques, body.torques, strict=True):
            stored = self._stored(body, velocity) if torque.needs_stored else velocity
            each.append(torque_of(torque, t, body.attitude, velocity, own, stored))
            force = torque.force(t, body.attitude, velocity, own)
            if force is not None and self.structure is not None:
                # from the origin of the given axes to the centre of mass, τ − c × F
                each[-1] = each[-1] - jnp.cross(self.structure.center_of_mass, force)
        return each

    # ------------------------------------------------------------------ what is seen along the given axes

    def as_given(self, state: States) -> BodyState:
        """Return a packed state taken apart, attitude and momentum along the given axes."""
        return self._as_given(self.parts(state))

    def velocity(self, state: States) -> Float64[Array, "*batch 3"]:
        """Return Ω (…, 3) [rad/s, given axes]."""
        return self._velocity(self.as_given(state))

    def packed_as_given(
        self, attitude: Float64[Array, "*#batch 4"], velocity: Float64[Array, "*#batch 3"], state: States
    ) -> Float64[Array, "*batch n"]:
        """Return states with another attitude and Ω, along the given axes, whose mounts and torques are as they were."""
        own = self.parts(state)
        momentum = times(self.carrier, velocity)
        for mount, values in zip(self.mounts, own.mounts, strict=True):
            momentum = momentum + mount.momentum(values)
        if self.structure is not None:
            attitude = self.structure.turn.attitude(attitude)
        front = [attitude, self._along_principal(momentum)]
        return jnp.concatenate([*front, *own.mounts, *own.torques], axis=-1)

    def stored(self, state: States) -> Float64[Array, "*batch 3"]:
        """Return L − IΩ (…, 3), the momentum of what turns against the body [kg m²/s, given axes]."""
        body = self.as_given(state)
        return self._stored(body, self._velocity(body))

    def torques_apart(self, t: Time, state: States) -> list[Float64[Array, "..."]]:
        """Return each torque about the centre of mass (…, 3) [N m, given axes], in the order of ``torques``."""
        body = self.as_given(state)
        return self._torques_apart(jnp.asarray(t), body, self._velocity(body))

    def _stored(self, body: BodyState, velocity: Array) -> Array:
        """Return L − IΩ, what the mounts have of momentum because they turn against the body."""
        stored = jnp.zeros_like(velocity)
        for mount, own in zip(self.mounts, body.mounts, strict=True):
            stored = stored + mount.momentum(own)
            if (inertia := mount.inertia) is not None:
                stored = stored - times(inertia, velocity)
        return stored

    # ------------------------------------------------------------------ what is kept, and what is balanced

    @property
    def conserves_energy(self) -> bool:
        """Whether nothing inside or outside does work."""
        return not self.torques and all(mount.conserves_energy for mount in self.mounts)

    def energy(self, state: Float64[Array, "*batch n"]) -> Float64[Array, "*batch"]:
        """Return ½ Ω·KΩ and the mounts' own energy (…) [J]."""
        body = self._as_given(self.parts(state))
        return self._energy(body, self._velocity(body))

    def power(self, t: Time, state: States) -> Float64[Array, "*batch"]:
        """Return the power of mounts and torques (…) [W]."""
        body, t = self._as_given(self.parts(state)), jnp.asarray(t)
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
        body, t = self._as_given(self.parts(state)), jnp.asarray(t)
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
                locked = times(mount.inertia, velocity)
                value = value - 0.5 * jnp.sum((relative - orbital) * locked, axis=-1)
        pull = gravity.torque(t, attitude, velocity)
        rate = jnp.sum((torque - pull) * relative, axis=-1) + self._inner_power(t, body, velocity)
        return Balance(value, rate - jnp.sum(pull * self._drift(body, velocity), axis=-1))

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
        velocity = self._along_principal(self._velocity(self._as_given(body)))
        return Vectors(body.attitude, body.momentum, velocity)

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

    ``RigidBody(moments, …)`` stands along its principal axes with the centre of mass as origin, ``from_body`` along the
    axes in which a body is given.

    Args:
        moments: (3,) principal moments of the whole body, its mounts locked [kg m²], positive.
        mounts: what is inside, such as ``Wheel``; any number, on any axes.
        torques: what acts on it, such as ``LinearDrag``; any number.
        structure: the given axes, as ``from_body`` makes them; None for the principal ones.

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
    structure: Structure | None

    @known_numbers_only
    def __init__(
        self,
        moments: Real[ArrayLike, "3"],
        mounts: Sequence[AbstractMount] = (),
        torques: Sequence[AbstractTorque] = (),
        structure: Structure | None = None,
    ) -> None:
        self.moments, self.structure = checked_moments(moments), structure
        frame = self._frame()
        self.mounts = checked_mounts(mounts, frame)
        self.torques = checked_torques(torques, frame)
        carrier = np.asarray(self.carrier)
        left = np.linalg.eigvalsh(carrier) if carrier.ndim == 2 else carrier
        if not left.min() > 0:
            raise InvalidInput(
                f"`mounts` must be parts of the body; without what they turn by themselves it is left with moments "
                f"[{', '.join(f'{x:.6g}' for x in left)}] kg m². `moments` are those of the whole body, its mounts "
                "locked."
            )

    @property
    def limited(self) -> bool:
        """Whether a mount or a torque has limits."""
        return any(attachment.limited for attachment in chain(self.mounts, self.torques))

    def without_limits(self) -> RigidBody:
        """Return the same body, whose actuators give whatever they are asked for.

        Where ``load`` stays below one along its motion, that is the motion of the limited body too, and rates of change
        have no corners.
        """
        mounts = tuple(mount.without_limits() for mount in self.mounts)
        torques = tuple(torque.without_limits() for torque in self.torques)
        return eqx.tree_at(lambda body: (body.mounts, body.torques), self, (mounts, torques))

    def load(self, t: Time, state: States) -> Float64[Array, "*batch"]:
        """Return the largest of what actuators are asked for over their limits (…); above one a limit acts."""
        body, t = self._as_given(self.parts(state)), jnp.asarray(t)
        velocity = self._velocity(body)
        stored, largest = self._stored(body, velocity), jnp.zeros(velocity.shape[:-1])
        for attachment, own in zip((*self.mounts, *self.torques), (*body.mounts, *body.torques), strict=True):
            largest = jnp.maximum(largest, attachment.load(t, body.attitude, velocity, own, stored))
        return largest

    @classmethod
    def from_body(
        cls, body: Body, mounts: Sequence[AbstractMount] = (), torques: Sequence[AbstractTorque] = ()
    ) -> RigidBody:
        """Return the body with mounts and torques that stand in its given axes.

        Axes of mounts, vectors of torques, their positions from the origin of these axes, and what functions of the
        user get and give are along the given axes, as is what ``pack`` takes. States and trajectories are along the
        principal axes, as everywhere; ``trajectory.along("given")`` turns them. A torque with a resultant ``force`` is
        referred to the centre of mass.

        Args:
            body: all together, its mounts locked.
            mounts: what is inside.
            torques: what acts on it.

        Raises:
            InvalidInput: as the class does, and for a thin rod, which has no moment about itself.

        >>> import polhode as ph
        >>> craft = RigidBody.from_body(ph.shapes.box(12.0, (0.1, 0.2, 0.3)))  # whose moments descend along x, y, z
        >>> start = craft.pack(angular_velocity=(0.0, 0.0, 2.0))
        >>> [round(float(x), 9) for x in start]  # about z, the axis of least moment
        [0.1, 0.0, 0.0]
        """
        if not isinstance(body, Body):
            raise InvalidInput(f"`body` must be a polhode.Body; got {shown(body)}. Make one from moments by "
                               "`RigidBody(moments, mounts, torques)`.")  # fmt: skip
        turn = Turn.to(jnp.asarray(body.principal_axes))
        mass = None if body.mass is None else jnp.asarray(body.mass)
        structure = Structure(turn, jnp.asarray(body.center_of_mass), mass)
        return cls(body.principal_moments, mounts, torques, structure)

    def _frame(self) -> BodyFrame:
        """Return the axes in which attachments stand, and the mass properties along them."""
        moments = np.asarray(self.moments)
        if self.structure is None:
            return BodyFrame(moments, np.eye(3), np.zeros(3), None)
        turn, center, mass = self.structure
        return BodyFrame(moments, np.asarray(turn.matrix), np.asarray(center), None if mass is None else float(mass))
