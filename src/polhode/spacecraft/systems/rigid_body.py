"""A rigid body put together from parts, mounts inside it and torques on it, with its equations of motion."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, ClassVar

import jax.numpy as jnp
import numpy as np

from polhode import rotation
from polhode._base import check
from polhode._base.arrays import compiled_for_few_calls, known_numbers_only
from polhode.bodies.body import Body
from polhode.errors import InvalidInput
from polhode.motion._axes import Turn
from polhode.motion.frame import BodyFrame
from polhode.spacecraft.systems._moving_masses import leave_hub
from polhode.spacecraft.systems._packed_body import Structure
from polhode.spacecraft.systems._rigid_motion import AbstractRigidMotion, Moment, take_rates
from polhode.spacecraft.systems.attachments import Time
from polhode.spacecraft.systems.mounts import AbstractMount, AbstractMounted
from polhode.spacecraft.systems.moving_parts import AbstractMovingPart, checked_mounts
from polhode.spacecraft.torques import AbstractTorque, GravityGradient, checked_torques
from polhode.systems.base import Balance, Vectors
from polhode.systems.free_rigid_body import checked_moments
from polhode.types import Array, ArrayLike, Float64, Real

States = Float64[Array, "*#batch n"]


class AbstractRigidBody(AbstractRigidMotion):
    """A body with mounts and torques: L̇ = L × (Ω + Σ d) + Σ τ, dR/dt = R hat(Ω + Σ d), with KΩ = L − Σ p.

    L is the whole angular momentum, p the momentum that a mount has of its own, d its drift (zero but for losses
    without a state of their own), τ a torque, K the ``carrier`` inertia. Moving parts change K and the centre of mass;
    Ω and their rates then come from one mass matrix. Inner forces never change R L. State: the attitude, L, the own
    states of mounts and of torques, as ``layout`` names them; the attitude may be left out where nothing depends on it.
    Attitude and L of states are along the principal axes at rest; arguments and results of attachments and arguments of
    ``pack`` are along the body's given axes.
    """

    # ------------------------------------------------------------------ invariants and balances

    @property
    def conserves_energy(self) -> bool:
        """Whether nothing inside or outside does work."""
        return not self._is_acted_on and all(mount.conserves_energy for mount in self.mounts)

    @property
    def _is_acted_on(self) -> bool:
        """Whether anything from outside changes R L."""
        return bool(self.torques or self.tanks)

    def energy(self, state: Float64[Array, "*batch n"]) -> Float64[Array, "*batch"]:
        """Return ½ Ω·KΩ and the mounts' own energy (…) [J]."""
        return self._energy(self._moment(self._as_given(self.parts(state))))

    def power(self, t: Time, state: States) -> Float64[Array, "*batch"]:
        """Return the power of mounts and torques (…) [W]."""
        now, t = self._moment(self._as_given(self.parts(state))), jnp.asarray(t)
        return self._outer_power(now, *self._loads(t, now)) + self._inner_power(t, now)

    def _energy(self, now: Moment) -> Array:
        own = [mount.energy(values) for mount, values in zip(self.mounts, now.body.mounts, strict=True)]
        moving = self._parts_with_states(now.body)
        canonical = [values[..., part.count + j] for part, values in moving for j in range(part.count)]
        # ½ (L·Ω + π·q̇), less the momenta with energies of their own
        own += [0.5 * momentum * rate for momentum, rate in zip(canonical, now.rates, strict=True)]
        return sum(own, 0.5 * jnp.sum(now.momentum * now.velocity, axis=-1))

    def _outer_power(self, now: Moment, torque: Array, loads: list[Array]) -> Array:
        return sum((a * b for a, b in zip(loads, now.rates, strict=True)), jnp.sum(torque * now.velocity, axis=-1))

    def _inner_power(self, t: Array, now: Moment) -> Array:
        body, rates = now.body, list(now.rates)
        power: Any = 0.0
        for mount, own in zip(self.mounts, body.mounts, strict=True):
            if isinstance(mount, AbstractMovingPart):
                given = t, body.attitude, now.velocity, own, take_rates(rates, mount.count, now.velocity)
                power = power + jnp.sum(mount.applied(*given) * given[-1], axis=-1) + mount.further_power(*given)
            else:
                assert isinstance(mount, AbstractMount)
                power = power + mount.power(t, body.attitude, now.velocity, own)
        for tank in self.tanks:
            power = power + self._power_of_flow(tank, t, now)
        # the drift adds L × d to L̇, and Ω·(L × d) = −d·(L × Ω) to the power
        return power - jnp.sum(self._drift(now) * jnp.cross(body.momentum, now.velocity), axis=-1)

    def invariants(self, state: Float64[Array, "*batch n"]) -> dict[str, Float64[Array, "..."]]:
        """Return |L|² and the momentum in space, where no torque acts, and energy, where nothing does work."""
        if self._is_acted_on:
            return {}
        body = self.parts(state)
        values = {"energy": self.energy(state)} if self.conserves_energy else {}
        # L̇ = L × (…) keeps |L|, and R L whatever acts inside
        values |= {"|L|²": jnp.sum(body.momentum**2, axis=-1)}
        if body.attitude is not None:
            values["momentum_space"] = rotation.rotate(body.attitude, body.momentum)
        return values

    def balance_values(self, t: Time, state: States) -> dict[str, Float64[Array, "..."]]:
        return self._balance_values(jnp.asarray(t), self._moment(self._as_given(self.parts(state))))

    def _balance_values(self, t: Array, now: Moment) -> dict[str, Array]:
        if not self._is_acted_on:
            return {} if self.conserves_energy else {"energy": self._energy(now)}
        values = {"kinetic_energy": self._energy(now), "|L|²": jnp.sum(now.body.momentum**2, axis=-1)}
        gravity = self._gravity_of_integral(now)
        return values if gravity is None else values | {"jacobi_integral": self._jacobi_integral(gravity, t, now)}

    def balances(self, t: Time, state: States) -> dict[str, Balance]:
        """Return energy and |L|² with their powers, and with gravity on a circular orbit the Jacobi integral.

        Under torques the energy is called kinetic, as the potential of their sources is not in it.
        """
        now, t = self._moment(self._as_given(self.parts(state))), jnp.asarray(t)
        values = self._balance_values(t, now)
        if not values:
            return {}
        inner, rates = self._inner_power(t, now), {}
        if self._is_acted_on:
            torque, loads = self._loads(t, now)
            power = self._outer_power(now, torque, loads) + inner
            rates = {"kinetic_energy": power, "|L|²": 2.0 * jnp.sum(torque * now.body.momentum, axis=-1)}
            if (gravity := self._gravity_of_integral(now)) is not None:
                rates["jacobi_integral"] = self._jacobi_rate(gravity, t, now, torque, power)
        return {name: Balance(value, rates.get(name, inner)) for name, value in values.items()}

    def _gravity_of_integral(self, now: Moment) -> GravityGradient | None:
        """Return the gravity with which the body has a Jacobi integral."""
        gravity = [torque for torque in self.torques if isinstance(torque, GravityGradient)]
        alone = now.body.attitude is not None and len(gravity) == 1 and gravity[0].circular and not self.tanks
        return gravity[0] if alone else None

    def _jacobi_integral(self, gravity: GravityGradient, t: Array, now: Moment) -> Array:
        """Return H − ν·L, with H = T + V and the orbit's ν.

        V = ½ GM/R³ (3 R̂·JR̂ − tr J) is the work of gravity on the body as it is, but for a constant.
        """
        attitude = now.body.attitude
        assert attitude is not None, "gravity needs the attitude"
        orbital = now.velocity - gravity.relative_velocity(attitude, now.velocity)
        inertia, (strength, centre) = self._momentary_inertia(now), gravity.pull(t, attitude)
        pulled = 3.0 * jnp.sum(centre * jnp.sum(inertia * centre[..., None, :], axis=-1), axis=-1)
        if now.arrangement is not None:
            pulled = pulled - (jnp.trace(inertia, axis1=-2, axis2=-1) - jnp.sum(self.moments))
        return self._energy(now) + 0.5 * strength * pulled - jnp.sum(orbital * now.body.momentum, axis=-1)

    def _jacobi_rate(self, gravity: GravityGradient, t: Array, now: Moment, torque: Array, power: Array) -> Array:
        """Return the rate of H − ν·L.

        V changes by −τ·w − Q·q̇, with w = Ω − ν the velocity relative to the orbit's frame, and ν·L by ν·τ.
        """
        attitude = now.body.attitude
        assert attitude is not None, "gravity needs the attitude"
        relative = gravity.relative_velocity(attitude, now.velocity)
        if now.arrangement is None:
            pull, loads = gravity.torque(t, attitude, now.velocity), []
        else:
            pull, loads = self._gravity(gravity, t, now)
        rate = power - jnp.sum(torque * (now.velocity - relative), axis=-1) - jnp.sum(pull * relative, axis=-1)
        rate = rate - sum((a * b for a, b in zip(loads, now.rates, strict=True)), 0.0)
        return rate - jnp.sum(pull * self._drift(now), axis=-1)

    def vectors(self, state: Float64[Array, "*batch n"]) -> Vectors:
        body = self.parts(state)
        velocity = self._along_principal(self._moment(self._as_given(body)).velocity)
        return Vectors(body.attitude, body.momentum, velocity)


class RigidBody(AbstractRigidBody):
    """A body with any mounts inside and any torques on it.

    With nothing it is the free body, with a ``HeldWheel`` a gyrostat, with an ``EnergySink`` the double bracket. As
    Lie–Poisson systems, with exact flows and verdicts, these are ``FreeRigidBody``, ``Gyrostat`` and ``DoubleBracket``.

    ``RigidBody(moments, …)`` is along its principal axes with the centre of mass as origin, ``from_body`` along the
    axes in which a body is given.

    Args:
        moments: (3,) principal moments of the whole body, its mounts locked [kg m²], positive.
        mounts: parts inside, such as ``Wheel``; any number, on any axes.
        torques: torques on it, such as ``LinearDrag``; any number.
        structure: the given axes, as ``from_body`` makes them; None for the principal ones.

    Raises:
        InvalidInput: for moments that are not positive, rotors that leave the body none, anything but a mount or a
            torque, one whose methods fail, or a gravity gradient on other moments.

    >>> from polhode.spacecraft import LinearDrag, Wheel
    >>> wheels = [Wheel((1.0, 0.0, 0.0), 0.1, motor=0.02), Wheel((0.0, 3.0, 4.0), 0.1)]
    >>> body = RigidBody((1.0, 2.0, 2.5), wheels, [LinearDrag(0.5)])
    >>> start = body.pack(angular_velocity=(0.0, 0.0, 1.0), rates=[5.0, 0.0])
    >>> body.layout(start).names
    ('momentum', 'rotor_momentum_1', 'rotor_momentum_2')
    >>> round(float(body.power(0.0, start)), 9)
    -0.4
    """

    kind: ClassVar[str] = "rigid-body"
    title: ClassVar[str] = "Rigid body"
    moments: Float64[Array, "3"]
    mounts: tuple[AbstractMounted, ...]
    torques: tuple[AbstractTorque, ...]
    structure: Structure | None

    @known_numbers_only
    def __init__(
        self,
        moments: Real[ArrayLike, "3"],
        mounts: Sequence[AbstractMounted] = (),
        torques: Sequence[AbstractTorque] = (),
        structure: Structure | None = None,
    ) -> None:
        self.moments, self.structure = checked_moments(moments), structure
        frame = self._frame()
        self.mounts = checked_mounts(mounts, frame)
        self.torques = checked_torques(torques, frame)
        if not self.mounts:
            return
        mass, carrier = _left_over(self, jnp.asarray(frame.center_of_mass))
        if self.moving_parts:
            if not float(mass) > 0.0:
                raise InvalidInput(
                    f"`mounts` must be parts of the body; they have {float(self._mass - mass):g} kg of its "
                    f"{float(self._mass):g} kg. Give the mass of all together."
                )
        carrier = np.asarray(carrier)
        left = np.linalg.eigvalsh(carrier) if carrier.ndim == 2 else carrier
        if not left.min() > 0:
            raise InvalidInput(
                f"`mounts` must be parts of the body; without what moves or turns by itself the body of moments "
                f"[{', '.join(f'{x:.6g}' for x in np.asarray(self.moments))}] kg m² is left with "
                f"[{', '.join(f'{x:.6g}' for x in left)}] kg m². Its moments are those of the whole, mounts locked: "
                "check them, and the moments of the mounts."
            )

    @classmethod
    def from_body(
        cls, body: Body, mounts: Sequence[AbstractMounted] = (), torques: Sequence[AbstractTorque] = ()
    ) -> RigidBody:
        """Return the body with mounts and torques in its given axes.

        Axes of mounts, vectors of torques, their positions from the origin of these axes, and arguments and results of
        functions of the user are along the given axes, as are arguments of ``pack``. States and trajectories are along
        the principal axes, as everywhere; ``trajectory.along("given")`` turns them. A torque with a resultant ``force``
        is referred to the centre of mass.

        Args:
            body: all together, its mounts locked.
            mounts: parts inside.
            torques: torques on it.

        Raises:
            InvalidInput: as the class does, and for a thin rod, which has no moment about itself.

        >>> import polhode as ph
        >>> craft = RigidBody.from_body(ph.shapes.box(12.0, (0.1, 0.2, 0.3)))  # whose moments descend along x, y, z
        >>> start = craft.pack(angular_velocity=(0.0, 0.0, 2.0))
        >>> [round(float(x), 9) for x in start]  # about z, the axis of least moment
        [0.1, 0.0, 0.0]
        """
        check.instance("body", body, Body, "a polhode.Body",
                       "Make one from moments by `RigidBody(moments, mounts, torques)`.")
        plain = Turn.to(np.asarray(body.principal_axes))  # by NumPy: JAX would compile each operation of it
        turn = Turn(jnp.asarray(plain.matrix), jnp.asarray(plain.quaternion))
        mass = None if body.mass is None else jnp.asarray(body.mass)
        structure = Structure(turn, jnp.asarray(body.center_of_mass), mass)
        return cls(body.principal_moments, mounts, torques, structure)

    def _frame(self) -> BodyFrame:
        """Return the axes in which attachments are given, and the mass properties along them."""
        moments = np.asarray(self.moments)
        if self.structure is None:
            return BodyFrame(moments, np.eye(3), np.zeros(3), None)
        turn, center, mass = self.structure
        return BodyFrame(moments, np.asarray(turn.matrix), np.asarray(center), None if mass is None else float(mass))


@compiled_for_few_calls
def _left_over(body: RigidBody, center: Array) -> tuple[Array, Array]:
    """Return mass () and inertia, (3,) or (3, 3), of a body without its parts and rotors."""
    carrier = body.carrier
    if not body.moving_parts:
        return body._mass, carrier
    carrier = jnp.diag(carrier) if carrier.ndim == 1 else carrier
    return leave_hub(body.moving_parts, carrier, center, body._mass)
