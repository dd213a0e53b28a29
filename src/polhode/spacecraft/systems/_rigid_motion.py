"""The equations of motion of a body with mounts, moving parts, propellant and torques."""

from __future__ import annotations

from itertools import chain
from typing import NamedTuple

import jax.numpy as jnp
import numpy as np

from polhode import rotation
from polhode.spacecraft.systems._moving_masses import Arrangement, flux, pulls, shares, slopes, velocities
from polhode.spacecraft.systems._observed_body import AbstractObservedBody
from polhode.spacecraft.systems._packed_body import BodyState
from polhode.spacecraft.systems.attachments import Time
from polhode.spacecraft.systems.mounts import AbstractMount
from polhode.spacecraft.systems.moving_parts import AbstractMovingPart
from polhode.spacecraft.systems.propellant import Propellant
from polhode.spacecraft.torques import GravityGradient, torque_of
from polhode.systems._symmetric import solve
from polhode.systems.base import Event
from polhode.types import Array, Float64

States = Float64[Array, "*#batch n"]


class Moment(NamedTuple):
    """A state along the given axes, with its velocities.

    Attributes:
        body: the state.
        velocity: Ω (…, 3).
        arrangement: where the moving parts are; None without any.
        rates: q̇_j (…) of all moving parts.
        momentum: (…, 3), L less the own momenta of mounts and spins.
    """

    body: BodyState
    velocity: Array
    arrangement: Arrangement | None
    rates: list[Array]
    momentum: Array


class AbstractRigidMotion(AbstractObservedBody):
    """L̇ = L × (Ω + Σ d) + Σ τ and dR/dt = R hat(Ω + Σ d), with the states of mounts and torques."""

    @property
    def jumps(self) -> Float64[Array, "jumps"]:
        """(J,) times [s] at which a mount or a torque starts, ends or jumps."""
        own = [jumps for x in chain(self.mounts, self.torques) if np.size(jumps := x.jumps)]
        return jnp.concatenate([jnp.ravel(jnp.asarray(jumps, dtype=float)) for jumps in own]) if own else np.zeros(0)

    @property
    def names_all_jumps(self) -> bool:
        return all(attachment.names_all_jumps for attachment in chain(self.mounts, self.torques))

    @property
    def events(self) -> dict[str, Event]:
        """The event of an empty tank whose flow does not end by itself."""
        ends = {}
        for k, mount in enumerate(self.mounts):
            if isinstance(mount, Propellant) and mount.may_run_empty:
                name = "tank empty" if len(self.tanks) == 1 else f"tank {k} empty"
                ends[name] = lambda t, state, k=k: self.parts(state).mounts[k][..., 0]
        return ends

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
        moving = self._parts_with_states(body)
        canonical = [own[..., mount.count + j] for mount, own in moving for j in range(mount.count)]
        velocity, rates = velocities(arrangement, momentum, canonical)
        return Moment(body, velocity, arrangement, rates, momentum)

    def _parts_with_states(self, body: BodyState) -> list[tuple[AbstractMovingPart, Array]]:
        pairs = zip(self.mounts, body.mounts, strict=True)
        return [(mount, own) for mount, own in pairs if isinstance(mount, AbstractMovingPart)]

    def _drift(self, now: Moment) -> Array:
        drifts = (x.drift(now.body.momentum, now.velocity) for x in self.mounts if isinstance(x, AbstractMount))
        return sum(drifts, jnp.zeros_like(now.velocity))

    def _loads(self, t: Array, now: Moment) -> tuple[Array, list[Array]]:
        """Return the torque about the centre of mass (…, 3), and the generalised outer forces along q (…)."""
        total: Array = jnp.zeros_like(now.velocity)
        loads: list[Array] = [jnp.zeros(now.velocity.shape[:-1]) for _ in now.rates]
        for torque, along in self._torques_apart(t, now):
            total = total + torque
            loads = [load + more for load, more in zip(loads, along, strict=True)] if along else loads
        for tank in self.tanks:
            torque, along = self._jet(tank, t, now)
            total, loads = total + torque, [load + more for load, more in zip(loads, along, strict=True)]
        return total, loads

    def _jet(self, tank: Propellant, t: Array, now: Moment) -> tuple[Array, list[Array]]:
        """Return the rates of L (…, 3) and each π (…) by thrust and the flow of momentum out of the nozzle."""
        assert now.arrangement is not None and self.structure is not None, "propellant is in a body with mass"
        flow, place = tank.outflow(t)[..., None], tank.nozzle - self.structure.center_of_mass
        _, momentum, canonical = flux(self.moving_parts, now.arrangement, now.velocity, now.rates, place)
        thrust = -flow * tank.exhaust_velocity
        torque = jnp.cross(place - now.arrangement.offset, thrust) - flow * momentum
        shifts = shares(self.moving_parts, now.arrangement)
        pushed = [-jnp.sum(thrust * shift, axis=-1) for shift in shifts]
        return torque, [push - flow[..., 0] * taken for push, taken in zip(pushed, canonical, strict=True)]

    def _power_of_flow(self, tank: Propellant, t: Array, now: Moment) -> Array:
        """Return ṁ (½ |w_t|² + ½ Ω·κΩ) (…), by which the energy grows where mass leaves at given L and π."""
        assert now.arrangement is not None and self.structure is not None, "propellant is in a body with mass"
        place = tank.place - self.structure.center_of_mass
        speed, _, _ = flux(self.moving_parts, now.arrangement, now.velocity, now.rates, place)
        taken = jnp.sum(speed**2, axis=-1)
        if tank.inertia_per_mass is not None:
            taken = taken + jnp.sum(now.velocity * (now.velocity @ tank.inertia_per_mass), axis=-1)
        return 0.5 * tank.outflow(t) * taken

    def _torques_apart(self, t: Array, now: Moment) -> list[tuple[Array, list[Array]]]:
        """Return each torque's part of ``_loads``; a couple has none along q."""
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
                    shifts = shares(self.moving_parts, now.arrangement)
                    along = [-jnp.sum(force * shift, axis=-1) for shift in shifts]
                couple = couple - jnp.cross(center, force)
            each.append((couple, along))
        return each

    def _gravity(self, gravity: GravityGradient, t: Array, now: Moment) -> tuple[Array, list[Array]]:
        """Return the gravity gradient on the body as it is now, and the generalised force along each q."""
        assert now.arrangement is not None and now.body.attitude is not None, "gravity needs the attitude"
        strength, centre = gravity.pull(t, now.body.attitude)
        owns = [own for _, own in self._parts_with_states(now.body)]
        inertia = self._momentary_inertia(now)
        couple = jnp.cross(centre, jnp.sum(inertia * centre[..., None, :], axis=-1))
        along = pulls(self.moving_parts, owns, now.arrangement, strength, centre)
        return 3.0 * strength[..., None] * couple, along

    def _momentary_inertia(self, now: Moment) -> Array:
        """Return the inertia (…, 3, 3), parts that turn by themselves included."""
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
        """Return the rates of the own states of all mounts."""
        body, changes = now.body, []
        pairs = self._parts_with_states(body)
        slope: list[Array] = []
        if now.arrangement is not None:
            parts, owns = [part for part, _ in pairs], [own for _, own in pairs]
            slope = slopes(parts, owns, now.arrangement, now.velocity, now.rates)
        forces, rates = [a + b for a, b in zip(slope, loads, strict=True)], list(now.rates)
        for mount, own in zip(self.mounts, body.mounts, strict=True):
            if isinstance(mount, AbstractMovingPart):
                rate, forced = (take_rates(x, mount.count, now.velocity) for x in (rates, forces))
                given = t, body.attitude, now.velocity, own, rate
                changes += [rate, forced + mount.applied(*given), mount.further_rate(*given)]
            else:
                assert isinstance(mount, AbstractMount)
                changes.append(mount.state_rate(t, body.attitude, now.velocity, own))
        return changes


def take_rates(values: list[Array], count: int, like: Array) -> Float64[Array, "... n"]:
    """Take the next numbers (…) out of a list, and return them as (…, count)."""
    taken = [values.pop(0) for _ in range(count)]
    return jnp.stack(jnp.broadcast_arrays(*taken), axis=-1) if taken else jnp.zeros((*like.shape[:-1], 0))
