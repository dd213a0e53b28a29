"""A rigid body put together from parts, mounts inside it and torques on it, with its equations of motion."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import chain
from typing import Any, ClassVar, NamedTuple

import jax.numpy as jnp
import numpy as np

from polhode import rotation
from polhode.arrays import known_numbers_only
from polhode.bodies.body import Body
from polhode.errors import InvalidInput, shown
from polhode.motion._axes import Turn
from polhode.motion.frame import BodyFrame
from polhode.systems._moving_masses import Arrangement, pulls, shares, slopes, velocities
from polhode.systems._packed_body import BodyState, Structure
from polhode.systems._seen_body import AbstractSeenBody
from polhode.systems._symmetric import solve
from polhode.systems.attachments import Time
from polhode.systems.base import Balance, Vectors
from polhode.systems.free_rigid_body import checked_moments
from polhode.systems.mounts import AbstractMount, AbstractMounted
from polhode.systems.moving_parts import AbstractMovingPart, checked_mounts
from polhode.systems.torques import AbstractTorque, GravityGradient, checked_torques, torque_of
from polhode.types import Array, ArrayLike, Float64, Real

States = Float64[Array, "*#batch n"]


class Moment(NamedTuple):
    """A state along the given axes, with its velocities.

    Attributes:
        body: the state.
        velocity: Ω (…, 3).
        arrangement: where the moving parts are; None without any.
        rates: q̇_j (…) of all moving parts.
        momentum: (…, 3), L less what mounts and spins have of their own.
    """

    body: BodyState
    velocity: Array
    arrangement: Arrangement | None
    rates: list[Array]
    momentum: Array


class AbstractRigidBody(AbstractSeenBody):
    """A body with mounts and torques: L̇ = L × (Ω + Σ d) + Σ τ, dR/dt = R hat(Ω + Σ d), with KΩ = L − Σ p.

    L is the whole angular momentum, p the momentum that a mount has of its own, d its drift (zero but for losses
    without a state of their own), τ a torque, K the ``carrier`` inertia. Moving parts change K and the centre of mass;
    Ω and their rates then come from one mass matrix. What is inside never changes R L. State: the attitude, L, the own
    states of mounts and of torques, as ``layout`` names them; the attitude may be left out where nothing asks for it.
    Attitude and L of states are along the principal axes at rest; what attachments see and give, and what ``pack``
    takes, is along the body's given axes.
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
        now = self._moment(self._as_given(own))
        torque, loads = self._loads(t, now)
        turning = now.velocity + self._drift(now)
        change = self._along_principal(jnp.cross(now.body.momentum, turning) + torque)
        turning = self._along_principal(turning)
        attitude = () if own.attitude is None else (rotation.quaternion_rate(own.attitude, turning),)
        rates = [*self._mount_rates(t, now, loads)]
        for acting, values in zip(self.torques, now.body.torques, strict=True):
            rates.append(acting.state_rate(t, now.body.attitude, now.velocity, values))
        shape = change.shape[:-1]
        rates = [jnp.broadcast_to(rate, (*shape, rate.shape[-1])) for rate in rates]
        return jnp.concatenate([*attitude, change, *rates], axis=-1)

    def external_torque(self, t: Time, state: States) -> Float64[Array, "*batch 3"]:
        """Return the sum of all torques about the centre of mass (…, 3) [N m, given axes]."""
        return self._loads(jnp.asarray(t), self._moment(self._as_given(self.parts(state))))[0]

    def _moment(self, body: BodyState) -> Moment:
        """Return the velocities of a state along the given axes, and where its moving parts are."""
        momentum = body.momentum
        for mount, own in zip(self.mounts, body.mounts, strict=True):
            momentum = momentum - mount.momentum(own)
        arrangement = self._arranged(body.mounts)
        if arrangement is None:
            return Moment(body, solve(self.carrier, momentum), None, [], momentum)
        canonical = [own[..., mount.count + j] for mount, own in self._moving(body) for j in range(mount.count)]
        velocity, rates = velocities(arrangement, momentum, canonical)
        return Moment(body, velocity, arrangement, rates, momentum)

    def _moving(self, body: BodyState) -> list[tuple[AbstractMovingPart, Array]]:
        pairs = zip(self.mounts, body.mounts, strict=True)
        return [(mount, own) for mount, own in pairs if isinstance(mount, AbstractMovingPart)]

    def _drift(self, now: Moment) -> Array:
        drifts = (x.drift(now.body.momentum, now.velocity) for x in self.mounts if isinstance(x, AbstractMount))
        return sum(drifts, jnp.zeros_like(now.velocity))

    def _loads(self, t: Array, now: Moment) -> tuple[Array, list[Array]]:
        """Return the torque about the centre of mass (…, 3), and what forces from outside are along q (…)."""
        total, loads = jnp.zeros_like(now.velocity), [jnp.zeros(now.velocity.shape[:-1]) for _ in now.rates]
        for torque, along in self._torques_apart(t, now):
            total = total + torque
            loads = [load + more for load, more in zip(loads, along, strict=True)] if along else loads
        return total, loads

    def _torques_apart(self, t: Array, now: Moment) -> list[tuple[Array, list[Array]]]:
        """Return of each torque its part of ``_loads``; nothing along q for a couple."""
        each = []
        for torque, own in zip(self.torques, now.body.torques, strict=True):
            if now.arrangement is not None and isinstance(torque, GravityGradient):
                each.append(self._gravity(torque, t, now))
                continue
            stored = self._stored(now) if torque.needs_stored else now.velocity
            couple = torque_of(torque, t, now.body.attitude, now.velocity, own, stored)
            force, along = torque.force(t, now.body.attitude, now.velocity, own), []
            if force is not None and self.structure is not None:
                # about the centre of mass, which is where it is now, τ − c × F
                center = self.structure.center_of_mass
                if now.arrangement is not None:
                    center = center + now.arrangement.offset
                    # the carrier's points move by −∂_j d where the centre of mass stays
                    shifts = shares(self.moving_parts, now.arrangement, self._mass)
                    along = [-jnp.sum(force * shift, axis=-1) for shift in shifts]
                couple = couple - jnp.cross(center, force)
            each.append((couple, along))
        return each

    def _gravity(self, gravity: GravityGradient, t: Array, now: Moment) -> tuple[Array, list[Array]]:
        """Return the gravity gradient on the body as it is now, and what it is along each q."""
        assert now.arrangement is not None and now.body.attitude is not None, "gravity needs the attitude"
        strength, centre = gravity.pull(t, now.body.attitude)
        owns = [own for _, own in self._moving(now.body)]
        inertia = self._momentary_inertia(now)
        couple = jnp.cross(centre, jnp.sum(inertia * centre[..., None, :], axis=-1))
        along = pulls(self.moving_parts, owns, now.arrangement, strength, centre)
        return 3.0 * strength[..., None] * couple, along

    def _momentary_inertia(self, now: Moment) -> Array:
        """Return the inertia (…, 3, 3) with all that turns by itself."""
        if now.arrangement is None:
            whole = self.inertia
            return jnp.diag(whole) if whole.ndim == 1 else whole
        inertia = now.arrangement.inertia
        for mount, own in zip(self.mounts, now.body.mounts, strict=True):
            moving = isinstance(mount, AbstractMovingPart)
            turning = mount.spin_inertia(mount.coordinates_of(own)) if moving else mount.inertia
            inertia = inertia if turning is None else inertia + turning
        return inertia

    def _mount_rates(self, t: Array, now: Moment, loads: list[Array]) -> list[Array]:
        """Return how fast the own states of all mounts change."""
        body, found = now.body, []
        pairs = self._moving(body)
        slope: list[Array] = []
        if now.arrangement is not None:
            parts, owns = zip(*pairs, strict=True)
            slope = slopes(parts, owns, now.arrangement, now.velocity, now.rates, self._mass)
        forces, rates = [a + b for a, b in zip(slope, loads, strict=True)], list(now.rates)
        for mount, own in zip(self.mounts, body.mounts, strict=True):
            if isinstance(mount, AbstractMovingPart):
                rate, forced = (_taken(x, mount.count, now.velocity) for x in (rates, forces))
                given = t, body.attitude, now.velocity, own, rate
                found += [rate, forced + mount.applied(*given), mount.further_rate(*given)]
            else:
                assert isinstance(mount, AbstractMount)
                found.append(mount.state_rate(t, body.attitude, now.velocity, own))
        return found

    # ------------------------------------------------------------------ what is kept, and what is balanced

    @property
    def conserves_energy(self) -> bool:
        """Whether nothing inside or outside does work."""
        return not self.torques and all(mount.conserves_energy for mount in self.mounts)

    def energy(self, state: Float64[Array, "*batch n"]) -> Float64[Array, "*batch"]:
        """Return ½ Ω·KΩ and the mounts' own energy (…) [J]."""
        return self._energy(self._moment(self._as_given(self.parts(state))))

    def power(self, t: Time, state: States) -> Float64[Array, "*batch"]:
        """Return the power of mounts and torques (…) [W]."""
        now, t = self._moment(self._as_given(self.parts(state))), jnp.asarray(t)
        return self._outer_power(now, *self._loads(t, now)) + self._inner_power(t, now)

    def _energy(self, now: Moment) -> Array:
        own = [mount.energy(values) for mount, values in zip(self.mounts, now.body.mounts, strict=True)]
        canonical = [values[..., part.count + j] for part, values in self._moving(now.body) for j in range(part.count)]
        # ½ (L·Ω + π·q̇), less the momenta that have their energies of their own
        own += [0.5 * momentum * rate for momentum, rate in zip(canonical, now.rates, strict=True)]
        return sum(own, 0.5 * jnp.sum(now.momentum * now.velocity, axis=-1))

    def _outer_power(self, now: Moment, torque: Array, loads: list[Array]) -> Array:
        return sum((a * b for a, b in zip(loads, now.rates, strict=True)), jnp.sum(torque * now.velocity, axis=-1))

    def _inner_power(self, t: Array, now: Moment) -> Array:
        body, rates = now.body, list(now.rates)
        power: Any = 0.0
        for mount, own in zip(self.mounts, body.mounts, strict=True):
            if isinstance(mount, AbstractMovingPart):
                given = t, body.attitude, now.velocity, own, _taken(rates, mount.count, now.velocity)
                power = power + jnp.sum(mount.applied(*given) * given[-1], axis=-1) + mount.further_power(*given)
            else:
                assert isinstance(mount, AbstractMount)
                power = power + mount.power(t, body.attitude, now.velocity, own)
        # the drift adds L × d to L̇, and Ω·(L × d) = −d·(L × Ω) to the power
        return power - jnp.sum(self._drift(now) * jnp.cross(body.momentum, now.velocity), axis=-1)

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
        now, t = self._moment(self._as_given(self.parts(state))), jnp.asarray(t)
        body, energy, inner = now.body, self._energy(now), self._inner_power(t, now)
        if not self.torques:
            return {} if self.conserves_energy else {"energy": Balance(energy, inner)}
        torque, loads = self._loads(t, now)
        balances = {
            "kinetic_energy": Balance(energy, self._outer_power(now, torque, loads) + inner),
            "|L|²": Balance(jnp.sum(body.momentum**2, axis=-1), 2.0 * jnp.sum(torque * body.momentum, axis=-1)),
        }
        gravity = [torque for torque in self.torques if isinstance(torque, GravityGradient)]
        if body.attitude is not None and len(gravity) == 1 and gravity[0].circular:
            rest = self._outer_power(now, torque, loads) + inner
            balances["jacobi_integral"] = self._jacobi_integral(gravity[0], t, now, torque, rest)
        return balances

    def _jacobi_integral(self, gravity: GravityGradient, t: Array, now: Moment, torque: Array, power: Array) -> Balance:
        """Return H − ν·L, with H = T + V and the orbit's ν.

        V = ½ GM/R³ (3 R̂·JR̂ − tr J) is the work of gravity on the body as it is, but for a constant; it changes by
        −τ·w − Q·q̇, with w = Ω − ν the velocity relative to the orbit's frame, and ν·L by ν·τ.
        """
        attitude = now.body.attitude
        assert attitude is not None, "gravity needs the attitude"
        relative = gravity.relative_velocity(attitude, now.velocity)
        orbital, inertia = now.velocity - relative, self._momentary_inertia(now)
        strength, centre = gravity.pull(t, attitude)
        pulled = 3.0 * jnp.sum(centre * jnp.sum(inertia * centre[..., None, :], axis=-1), axis=-1)
        if now.arrangement is not None:
            pulled = pulled - (jnp.trace(inertia, axis1=-2, axis2=-1) - jnp.sum(self.moments))
        value = self._energy(now) + 0.5 * strength * pulled - jnp.sum(orbital * now.body.momentum, axis=-1)
        if now.arrangement is None:
            pull, loads = gravity.torque(t, attitude, now.velocity), []
        else:
            pull, loads = self._gravity(gravity, t, now)
        rate = power - jnp.sum(torque * orbital, axis=-1) - jnp.sum(pull * relative, axis=-1)
        rate = rate - sum((a * b for a, b in zip(loads, now.rates, strict=True)), 0.0)
        return Balance(value, rate - jnp.sum(pull * self._drift(now), axis=-1))

    def vectors(self, state: Float64[Array, "*batch n"]) -> Vectors:
        body = self.parts(state)
        velocity = self._along_principal(self._moment(self._as_given(body)).velocity)
        return Vectors(body.attitude, body.momentum, velocity)


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
        carrier = np.asarray(self.carrier)
        left = np.linalg.eigvalsh(carrier) if carrier.ndim == 2 else carrier
        if not left.min() > 0:
            raise InvalidInput(
                f"`mounts` must be parts of the body; without what they turn by themselves it is left with moments "
                f"[{', '.join(f'{x:.6g}' for x in left)}] kg m². `moments` are those of the whole body, its mounts "
                "locked."
            )

    @classmethod
    def from_body(
        cls, body: Body, mounts: Sequence[AbstractMounted] = (), torques: Sequence[AbstractTorque] = ()
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
        plain = Turn.to(np.asarray(body.principal_axes))  # by NumPy: JAX would compile each operation of it
        turn = Turn(jnp.asarray(plain.matrix), jnp.asarray(plain.quaternion))
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


def _taken(values: list[Array], count: int, like: Array) -> Array:
    """Take the next numbers (…) out of a list, and return them as (…, count)."""
    taken = [values.pop(0) for _ in range(count)]
    return jnp.stack(jnp.broadcast_arrays(*taken), axis=-1) if taken else jnp.zeros((*like.shape[:-1], 0))
