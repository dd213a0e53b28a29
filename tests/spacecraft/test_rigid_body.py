"""A body put together from mounts and torques, against its parts as rigid bodies of their own in space."""

import dataclasses

import jax
import jax.numpy as jnp
import numpy as np
import pytest

import polhode as ph
from polhode import rotation
from polhode.errors import InvalidInput
from polhode.spacecraft import (
    AbstractMount,
    AbstractTorque,
    EnergySink,
    GravityGradient,
    HeldWheel,
    LaggedTorque,
    LinearDrag,
    QuadraticDrag,
    RigidBody,
    SphericalSlug,
    Wheel,
)
from polhode.spacecraft.systems import attachments
from polhode.systems import DoubleBracket, Gyrostat, KeplerOrbit, TorquedGyrostat
from spacecraft import multibody
from spacecraft.multibody import Hub
from systems.balances import worst_balance

MOMENTS = np.array([1.0, 2.0, 2.6])
ATTITUDE = rotation.normalize(np.array([0.9, 0.1, -0.2, 0.3]))
VELOCITY = np.array([0.3, -0.9, 0.6])
FIRST, SECOND = np.array([0.48, 0.6, 0.64]), np.array([0.8, -0.6, 0.0])
TIMES = np.linspace(0.0, 8.0, 17)
MOTION = 1e-11  # relative, of adaptive steps at 1e-12 over some turns
AGREES = 3e-10  # two integrators of tolerance 1e-12 over some turns
BALANCE = 1e-10
EXACT = 1e-13  # of a derivative by jax.jvp against its formula


def motor(t, attitude, angular_velocity, rate):
    """One that brakes its rotor, looks at the time, and steers by attitude and velocity."""
    tilt = rotation.as_matrix(attitude)[..., 0, 2]
    return 0.05 * jnp.sin(2.0 * t) - 0.01 * rate + 0.02 * tilt - 0.03 * angular_velocity[..., 2]


def same_motor(t, turn, velocity, spin):
    return 0.05 * np.sin(2.0 * t) - 0.01 * spin + 0.02 * turn[0, 2] - 0.03 * velocity[2]


ROTORS = [Wheel(FIRST, 0.2, motor), Wheel(5.0 * SECOND, 0.1, 0.03, friction=0.02)]
RATES = [4.0, -6.0]
BODY = RigidBody(MOMENTS, ROTORS)
START = BODY.pack(ATTITUDE, VELOCITY, rates=RATES)


def hub(**more):
    wheels = [
        multibody.Wheel(FIRST, 0.2, 0.13, same_motor),
        multibody.Wheel(SECOND, 0.1, 0.06, lambda t, R, v, s: 0.03 - 0.02 * s),
    ]
    return Hub(np.diag(MOMENTS), wheels, **more)


def rates_of(trajectory, rotors):
    """Rates of rotors relative to the body (T, k), from their momenta."""
    count = len(rotors)
    own = [trajectory.part(f"rotor_momentum_{k + 1}" if count > 1 else "rotor_momentum") for k in range(count)]
    velocity = np.asarray(trajectory.angular_velocity)
    return np.stack([h / float(r.moment) - velocity @ np.asarray(r.axis) for r, h in zip(rotors, own, strict=True)], -1)


def momentum_of_all(whole, trajectory, rotors):
    """Angular momentum in space, body by body, from the velocities alone (T, 3)."""
    turns = rotation.as_matrix(trajectory.attitude)
    return np.stack([
        whole.momentum(turn, turn @ velocity, rates, np.zeros(3))
        for turn, velocity, rates in zip(turns, trajectory.angular_velocity, rates_of(trajectory, rotors), strict=True)
    ])  # fmt: skip


@pytest.mark.sweep
def test_two_skew_rotors_with_motors_move_as_bodies_of_their_own():
    found = ph.simulate(BODY, START, TIMES)
    exact = hub().motion(TIMES, rotation.as_matrix(ATTITUDE), VELOCITY, RATES)
    turns = rotation.as_matrix(found.attitude)
    assert np.abs(turns - [turn for turn, *_ in exact]).max() < AGREES
    velocity = np.einsum("tij,tj->ti", turns, found.angular_velocity)
    assert np.abs(velocity - [omega for _, omega, *_ in exact]).max() < AGREES
    assert np.abs(rates_of(found, ROTORS) - [rates for _, _, rates, _ in exact]).max() < 10 * AGREES
    assert np.ptp(rates_of(found, ROTORS), axis=0).min() > 0.3
    whole = momentum_of_all(hub(), found, ROTORS)
    assert np.abs(whole - whole[0]).max() < MOTION * np.linalg.norm(whole[0])
    assert set(found.invariants) == {"|L|²", "momentum_space"} and max(found.drift.values()) < BALANCE
    energies = np.array([hub().energy(*sample) for sample in exact])
    assert np.abs(found.balances["energy"] - energies).max() < 10 * AGREES
    assert np.abs(found.received["energy"] - (energies - energies[0])).max() < 10 * AGREES


class WithoutReaction(Wheel):
    """A broken specimen: it turns, and the body does not feel it."""

    def momentum(self, own):
        return jnp.zeros((*own.shape[:-1], 3))


@pytest.mark.long
def test_a_rotor_without_reaction_is_found_out():
    rotors = [ROTORS[0], WithoutReaction(SECOND, 0.1, 0.03, friction=0.02)]
    body = RigidBody(MOMENTS, rotors)
    found = ph.simulate(body, body.pack(ATTITUDE, VELOCITY, rates=RATES), TIMES, estimate_error=False)
    whole = momentum_of_all(hub(), found, rotors)
    assert np.abs(whole - whole[0]).max() > 0.01 and found.drift["energy"] > 1e-3


@pytest.mark.sweep
def test_a_slug_and_drag_as_bodies_of_their_own():
    drag = np.array([0.02, 0.05, 0.03])
    mounts = [ROTORS[1], SphericalSlug(0.3, 0.15)]
    body = RigidBody(MOMENTS, mounts, [LinearDrag(drag)])
    slug = np.array([0.5, 0.2, -0.4])
    found = ph.simulate(body, body.pack(ATTITUDE, VELOCITY, rates=[RATES[1], slug]), TIMES)
    whole = Hub(np.diag(MOMENTS), hub().wheels[1:], 0.3, 0.15, lambda t, R, velocity: -drag * velocity)
    exact = whole.motion(TIMES, rotation.as_matrix(ATTITUDE), VELOCITY, RATES[1:], VELOCITY + slug)
    turns = rotation.as_matrix(found.attitude)
    assert np.abs(turns - [turn for turn, *_ in exact]).max() < AGREES
    space = np.einsum("tij,tj->ti", turns, found.part("slug_momentum")) / 0.3
    assert np.abs(space - [ball for *_, ball in exact]).max() < AGREES
    energies = np.array([whole.energy(*sample) for sample in exact])
    assert np.abs(found.balances["kinetic_energy"] - energies).max() < 10 * AGREES
    assert max(found.drift.values()) < BALANCE and energies[-1] < 0.9 * energies[0]


def test_with_nothing_it_is_the_free_body():
    body = RigidBody(MOMENTS)
    found = ph.simulate(body, body.pack(ATTITUDE, VELOCITY), TIMES)
    motion = ph.FreeMotion(MOMENTS, momentum=MOMENTS * VELOCITY, attitude=ATTITUDE)
    assert np.abs(found.attitude - motion.attitude(TIMES)).max() < MOTION
    assert np.abs(found.angular_velocity - motion.angular_velocity(TIMES)).max() < MOTION
    assert set(found.invariants) == {"energy", "|L|²", "momentum_space"} and max(found.drift.values()) < MOTION
    assert (np.asarray(body.free_moments) == MOMENTS).all() and BODY.free_moments is None


@pytest.mark.sweep
def test_with_held_rotors_it_is_the_gyrostat():
    mounts = [HeldWheel(FIRST, 0.2, 4.0), HeldWheel((0.0, -2.0, 0.0), 0.1, 3.0)]
    body, rotor = RigidBody(MOMENTS, mounts), 0.8 * FIRST + np.array([0.0, -0.3, 0.0])
    start = body.pack(ATTITUDE, VELOCITY)
    assert np.abs(np.asarray(start[4:]) - (MOMENTS * VELOCITY + rotor)).max() < 1e-15
    found = ph.simulate(body, start, TIMES)
    same = ph.simulate(Gyrostat(MOMENTS, rotor), start, TIMES, order=8)
    assert np.abs(found.states - same.states).max() < AGREES
    assert np.abs(found.invariants["energy"] - same.invariants["energy"]).max() < AGREES


def test_a_driven_rotor_has_the_rates_of_the_gyrostat_with_a_motor():
    """On an axis that is no principal one, which the carrier's moments must not feel."""
    axis, less = np.array([0.6, 0.0, 0.8]), MOMENTS
    gyrostat = TorquedGyrostat(less, axis, 0.2, 0.04)
    body = ph.Body.from_inertia(np.diag(less) + 0.2 * np.outer(axis, axis))
    craft = RigidBody.from_body(body, [Wheel(axis, 0.2, 0.04)])
    start = gyrostat.pack(ATTITUDE, VELOCITY, rates=[4.0])
    same = gyrostat.pack(ATTITUDE, momentum=start[4:7], rates=[4.0])
    assert np.abs(np.asarray(same - start)).max() < 1e-15
    state = craft.pack(ATTITUDE, VELOCITY, rates=[4.0])
    turn = np.asarray(body.principal_axes)  # of the craft's states
    one, other = gyrostat.vector_field(0.0, start), craft.vector_field(0.0, state)
    assert np.abs(np.asarray(one[4:7]) - turn @ np.asarray(other[4:7])).max() < 1e-14
    assert abs(float(one[7] - other[7])) < 1e-15
    assert abs(float(gyrostat.energy(start) - craft.energy(state))) < 1e-14
    assert np.abs(np.asarray(gyrostat.velocity(start) - craft.velocity(state))).max() < 1e-14
    assert abs(float(gyrostat.power(0.0, start) - craft.power(0.0, state))) < 1e-15


@pytest.mark.sweep
def test_a_free_rotor_and_a_driven_one_are_the_gyrostats_with_the_moments_of_the_carrier():
    less = MOMENTS - np.array([0.0, 0.2, 0.0])
    for torque, driven in ((None, 0.0), (0.04, 0.04)):
        body = RigidBody(MOMENTS, [Wheel((0.0, 1.0, 0.0), 0.2, torque)])
        start = body.pack(ATTITUDE, VELOCITY, rates=[4.0])
        found = ph.simulate(body, start, TIMES)
        same = ph.simulate(TorquedGyrostat(less, (0.0, 1.0, 0.0), 0.2, driven), start, TIMES)
        assert np.abs(found.states - same.states).max() < AGREES
        assert ("energy" in found.invariants) == (torque is None)
    free = RigidBody(MOMENTS, [Wheel((0.0, 1.0, 0.0), 0.2)])
    start = free.pack(ATTITUDE, VELOCITY, rates=[4.0])
    one = ph.simulate(free, start, TIMES)
    momentum = 0.2 * (4.0 + VELOCITY[1])
    same = ph.simulate(Gyrostat(less, (0.0, momentum, 0.0)), start[:7], TIMES, order=8)
    assert np.abs(one.states[:, :7] - same.states).max() < AGREES


@pytest.mark.long
def test_with_an_energy_sink_it_is_the_double_bracket():
    body = RigidBody(MOMENTS, [EnergySink(0.2)])
    start = body.pack(ATTITUDE, VELOCITY)
    found, same = (ph.simulate(system, start, TIMES, **more) for system, more in
                   ((body, {}), (DoubleBracket(MOMENTS, 0.2), {"tolerance": 1e-11})))  # fmt: skip
    assert np.abs(found.states - same.states).max() < AGREES
    assert np.abs(found.balances["energy"] - same.balances["energy"]).max() < AGREES
    L = MOMENTS * VELOCITY
    turning = VELOCITY + 0.2 * np.cross(L, VELOCITY)
    wanted = [*(0.5 * rotation.multiply(ATTITUDE, np.array([0.0, *turning]))), *np.cross(L, turning)]
    assert np.abs(np.asarray(body.vector_field(0.0, start)) - wanted).max() < 1e-15
    assert float(body.power(0.0, start)) == pytest.approx(-0.2 * np.sum(np.cross(L, VELOCITY) ** 2), rel=1e-14)


def test_torques_add_up():
    orbit = KeplerOrbit(0.7, 0.3, mean_anomaly=0.4)
    body = RigidBody(MOMENTS, torques=[LinearDrag(0.1), QuadraticDrag(0.05), GravityGradient(orbit, MOMENTS)])
    state, t = body.pack(ATTITUDE, VELOCITY), 2.0
    centre = rotation.as_matrix(ATTITUDE).T @ np.asarray(orbit.direction(t))
    pull = 3.0 * 0.49 / float(orbit.distance_ratio(t)) ** 3 * np.cross(centre, MOMENTS * centre)
    wanted = pull - (0.1 + 0.05 * np.linalg.norm(VELOCITY)) * VELOCITY
    assert np.abs(np.asarray(body.external_torque(t, state)) - wanted).max() < 1e-15
    field = np.asarray(body.vector_field(t, state))
    assert np.abs(field[4:] - (np.cross(MOMENTS * VELOCITY, VELOCITY) + wanted)).max() < 1e-15


def test_a_lagged_torque_answers_a_step_exponentially():
    """On a sphere from rest about one axis: I Ω = u (t − T (1 − e^(−t/T))), whose power heats nothing but the body."""
    lag = LaggedTorque(lambda t, attitude, velocity: jnp.array([0.0, 0.6, 0.0]) + 0.0 * velocity, 0.7)
    body = RigidBody((2.0, 2.0, 2.0), torques=[lag])
    found = ph.simulate(body, body.pack(), TIMES)
    grown = 1.0 - np.exp(-TIMES / 0.7)
    assert np.abs(found.part("actuator_torque")[:, 1] - 0.6 * grown).max() < MOTION
    assert np.abs(found.momentum[:, 1] - 0.6 * (TIMES - 0.7 * grown)).max() < MOTION
    assert found.drift["kinetic_energy"] < BALANCE
    begun = body.pack(actuators=[(0.0, 0.6, 0.0)])
    assert np.asarray(begun).tolist() == [1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.6, 0.0]


CIRCLE = KeplerOrbit(0.7, 0.0, mean_anomaly=0.4)
EVERYTHING = RigidBody(
    MOMENTS,
    [*ROTORS, HeldWheel((0.0, 1.0, 2.0), 0.05, 7.0), SphericalSlug(0.2, 0.05), EnergySink(0.02)],
    [LinearDrag((0.01, 0.02, 0.03)), QuadraticDrag(0.01), GravityGradient(CIRCLE, MOMENTS),
     LaggedTorque(lambda t, attitude, velocity: 0.1 * jnp.sin(t)[..., None] * attitude[..., 1:], 0.5)],
)  # fmt: skip


def start_of_everything():
    return EVERYTHING.pack(ATTITUDE, VELOCITY, rates=[*RATES, None, (0.1, -0.2, 0.3), None])


@pytest.mark.sweep
def test_with_everything_on_at_once_energy_changes_by_the_sum_of_powers():
    state = start_of_everything()
    worst = worst_balance(EVERYTHING, 0.8, state)
    assert set(worst) == {"kinetic_energy", "|L|²", "jacobi_integral"} and max(worst.values()) < EXACT
    found = ph.simulate(EVERYTHING, state, TIMES)
    assert set(found.balances) == set(worst) and max(found.drift.values()) < BALANCE
    assert np.ptp(found.balances["kinetic_energy"]) > 0.1 and found.invariants == {}
    assert found.layout.names == ("attitude", "momentum", "rotor_momentum_1", "rotor_momentum_2", "slug_momentum",
                                  "actuator_torque")  # fmt: skip


class Perpetual(Wheel):
    """A broken specimen: its friction costs nothing."""

    def power(self, t, attitude, angular_velocity, own):
        return 0.0 * super().power(t, attitude, angular_velocity, own)


@pytest.mark.long
def test_a_wrong_power_is_found_out():
    body = dataclasses.replace(EVERYTHING)
    object.__setattr__(body, "mounts", (Perpetual(FIRST, 0.2, friction=1e-6), *EVERYTHING.mounts[1:]))
    assert worst_balance(body, 0.8, start_of_everything())["kinetic_energy"] > 1e-7


@pytest.mark.sweep
def test_the_jacobi_integral_of_a_satellite_with_a_free_rotor_is_kept():
    satellite = RigidBody(MOMENTS, [Wheel(FIRST, 0.2), HeldWheel(SECOND, 0.1, 5.0)], [GravityGradient(CIRCLE, MOMENTS)])
    found = ph.simulate(satellite, satellite.pack(ATTITUDE, VELOCITY, rates=[3.0, None]), TIMES)
    assert np.ptp(found.received["jacobi_integral"]) < 1e-14 and found.drift["jacobi_integral"] < BALANCE
    assert np.ptp(found.balances["kinetic_energy"]) > 0.1


class Spring(AbstractTorque):
    """A user's own, with a state: it winds up as the body turns about its third axis."""

    @property
    def state_parts(self):
        return (ph.motion.StatePart("winding", 1, "rad", "angle of the spring"),)

    def state_rate(self, t, attitude, angular_velocity, actuator):
        return angular_velocity[..., 2:]

    def torque(self, t, attitude, angular_velocity, actuator=None):
        return jnp.concatenate([jnp.zeros((*actuator.shape[:-1], 2)), -0.5 * actuator], axis=-1)


@pytest.mark.sweep
def test_a_torque_of_ones_own_with_a_state():
    body = RigidBody((1.0, 1.0, 2.0), torques=[Spring()])
    found = ph.simulate(body, body.pack(angular_velocity=(0.0, 0.0, 0.4)), TIMES)
    wanted = 0.8 * np.sin(0.5 * TIMES)
    assert found.layout.names == ("momentum", "winding")
    assert np.abs(found.part("winding") - wanted).max() < MOTION and found.drift["kinetic_energy"] < BALANCE


class SprungWheel(AbstractMount):
    """A user's own, with two parts: a wheel on a torsion spring."""

    axis: jax.Array
    moment: float
    stiffness: float

    @property
    def state_parts(self):
        return (ph.motion.StatePart("wheel_momentum", 1, "kg m2 s-1"), ph.motion.StatePart("twist", 1, "rad"))

    @property
    def inertia(self):
        return self.moment * jnp.outer(self.axis, self.axis)

    def momentum(self, own):
        return self.part(own, "wheel_momentum")[..., None] * self.axis

    def energy(self, own):
        h, twist = self.part(own, "wheel_momentum"), self.part(own, "twist")
        return 0.5 * h**2 / self.moment + 0.5 * self.stiffness * twist**2

    def state_rate(self, t, attitude, angular_velocity, own):
        rate = self.part(own, "wheel_momentum") / self.moment - angular_velocity @ self.axis
        return jnp.stack([-self.stiffness * self.part(own, "twist"), rate], axis=-1)

    def start(self, rate, angular_velocity):
        h = self.moment * (rate + angular_velocity @ self.axis)
        return jnp.stack([h, 0.0 * h], axis=-1)


@pytest.mark.sweep
def test_a_mount_of_ones_own_with_two_parts():
    """About one axis the twist swings by k (1/J + 1/(I − J)); on a skew axis the energy and the momentum stay."""
    alone = RigidBody(MOMENTS, [SprungWheel(jnp.array([0.0, 0.0, 1.0]), 0.2, 0.5)])
    found = ph.simulate(alone, alone.pack(angular_velocity=(0.0, 0.0, 0.3), rates=[1.5]), TIMES)
    rate = np.sqrt(0.5 * (1.0 / 0.2 + 1.0 / (MOMENTS[2] - 0.2)))
    assert np.abs(found.part("twist") - 1.5 / rate * np.sin(rate * TIMES)).max() < 10 * MOTION
    skew = RigidBody(MOMENTS, [SprungWheel(jnp.asarray(FIRST), 0.2, 0.5)])
    found = ph.simulate(skew, skew.pack(ATTITUDE, VELOCITY, rates=[1.5]), TIMES)
    assert set(found.invariants) == {"energy", "|L|²", "momentum_space"} and max(found.drift.values()) < BALANCE
    assert np.asarray(skew.scales(found.states[0]))[-2] > 0.5 and np.asarray(skew.scales(found.states[0]))[-1] == 1.0


def test_states_are_made_and_taken_apart_by_name():
    batch = BODY.pack(np.stack([ATTITUDE, ATTITUDE]), [VELOCITY, -VELOCITY], rates=[[4.0, 2.0], 0.0])
    assert batch.shape == (2, 9)
    parts = BODY.parts(batch)
    assert np.abs(np.asarray(BODY.vectors(batch).angular_velocity) - [VELOCITY, -VELOCITY]).max() < 1e-15
    wanted = 0.2 * np.array([4.0 + VELOCITY @ FIRST, 2.0 - VELOCITY @ FIRST])
    assert np.abs(np.asarray(parts.mounts[0])[:, 0] - wanted).max() < 1e-15
    # the same motion from its momentum, which is that of the locked body and what turns in it
    momentum = MOMENTS * VELOCITY + 0.2 * 4.0 * FIRST - 0.1 * 6.0 * SECOND
    assert np.abs(np.asarray(START[4:7]) - momentum).max() < 1e-15
    assert np.abs(np.asarray(BODY.pack(ATTITUDE, momentum=momentum, rates=RATES) - START)).max() < 1e-15
    resting = np.asarray(BODY.pack(ATTITUDE, VELOCITY))
    assert np.abs(resting[4:7] - MOMENTS * VELOCITY).max() < 1e-15
    # without a motor that looks, the attitude may be left out
    bare = RigidBody(MOMENTS, ROTORS[1:])
    assert bare.layout(bare.pack(angular_velocity=VELOCITY)).names == ("momentum", "rotor_momentum")
    driven = TorquedGyrostat(MOMENTS, FIRST, 0.2, 0.1)
    whole = driven.pack(ATTITUDE, VELOCITY, rates=[4.0])
    same = driven.pack(ATTITUDE, momentum=whole[4:7], rates=[4.0])
    assert np.abs(np.asarray(same - whole)).max() < 1e-15


def test_adaptive_steps_know_the_sizes():
    assert np.asarray(BODY.scales(START)).tolist() == [1.0] * 4 + [float(np.abs(np.asarray(START[4:])).max())] * 5
    still = RigidBody(MOMENTS, [Wheel(FIRST, 0.2, 0.05)])
    assert np.asarray(still.scales(still.pack())) == pytest.approx([0.1] * 4, rel=1e-15)
    lagged = RigidBody(MOMENTS, torques=[EVERYTHING.torques[-1]])
    assert np.asarray(lagged.scales(lagged.pack())).tolist() == [1.0] * 4 + [2.6] * 3 + [1.0] * 3


class Flat(Wheel):
    def momentum(self, own):
        return own[..., :1]


class Narrow(AbstractTorque):
    def torque(self, t, attitude, angular_velocity):
        return angular_velocity


class NotBatched(AbstractTorque):
    def torque(self, t, attitude, angular_velocity, actuator=None):
        return jnp.sin(t) * jnp.ones(3)


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda: RigidBody((1.0, 2.0)), "`moments` must be three positive"),
        (lambda: RigidBody(MOMENTS, Wheel(FIRST, 0.1)), "`mounts` must be a list"),
        (lambda: RigidBody(MOMENTS, [LinearDrag(0.1)]), "Derive your own from AbstractMount"),
        (lambda: RigidBody(MOMENTS, [], [Wheel(FIRST, 0.1)]), "Derive your own from AbstractTorque"),
        (lambda: RigidBody(MOMENTS, [Wheel((1, 0, 0), 0.6), Wheel((2, 0, 0), 0.5)]), r"`mounts` must be parts of the"),
        (lambda: RigidBody(MOMENTS, [SphericalSlug(1.5, 0.1)]), r"left with \[-0.5, 0.5, 1.1\] kg m²"),
        (lambda: RigidBody(MOMENTS, [Flat(FIRST, 0.1)]), r"a Flat, must give `momentum` of shape \(3,\)"),
        (lambda: RigidBody(MOMENTS, [], [Narrow()]), r"`torques\[0\]`, a Narrow, cannot be evaluated"),
        (lambda: RigidBody(MOMENTS, [], [NotBatched()]), r"`torques\[0\]`, a NotBatched, cannot be evaluated"),
        (lambda: RigidBody(MOMENTS, [Wheel(FIRST, 0.1, lambda *given: jnp.ones(2))]), r"`mounts\[0\]`, a Wheel"),
        (lambda: RigidBody(MOMENTS, [Wheel(FIRST, 0.1, lambda *given: np.sin(given[0]))]), r"written with jax\.numpy"),
        (lambda: RigidBody(MOMENTS, [], [GravityGradient(CIRCLE, (1.0, 2.0, 3.0))]), "both the same"),
        (lambda: Wheel((0.0, 0.0, 0.0), 0.1), "`axis` must be a direction"),
        (lambda: Wheel((1.0, 0.0), 0.1), "`axis` must be three finite"),
        (lambda: Wheel(FIRST, 0.0), "`moment` must be positive and finite"),
        (lambda: Wheel(FIRST, 0.1, "fast"), "`motor` must be a finite number .N m.; got .fast.. Functions take SI"),
        (lambda: Wheel(FIRST, 0.1, friction=-1.0), "`friction` must be finite and not negative"),
        (lambda: HeldWheel(FIRST, 0.1, np.inf), "`rate` must be a finite number"),
        (lambda: SphericalSlug(0.1, -1.0), "`damping` must be finite and not negative"),
        (lambda: EnergySink(-0.1), "`rate` must be finite and not negative"),
        (lambda: LaggedTorque(0.3, 1.0), "`command` must be a function"),
        (lambda: LaggedTorque(lambda *given: given[2], 0.0), "`time_constant`"),
        (lambda: BODY.pack(ATTITUDE, VELOCITY, VELOCITY), "not both"),
        (lambda: BODY.pack(ATTITUDE, rates=[1.0]), "one entry for each of the 2 mounts"),
        (lambda: BODY.pack(ATTITUDE, rates=[1.0, np.float32(2.0)]), r"`rates\[1\]` must be float64"),
        (lambda: EVERYTHING.pack(rates=[0.0, 0.0, 1.0, None, None]), r"`rates\[2\]` is for a HeldWheel"),
        (lambda: EVERYTHING.pack(actuators=[None, None, None, (1.0, 2.0)]), r"`actuators\[3\]` must have"),
        (lambda: EVERYTHING.pack(ATTITUDE, actuators=0.0), "one entry for each of the 4 torques"),
        (lambda: BODY.check_state(np.ones(7)), r"RigidBody must have shape \(…, 9\)"),
        (lambda: BODY.check_state(np.ones(9)), "unit quaternion"),
        (lambda: RigidBody(MOMENTS).check_state(np.ones(9)), r"shape \(…, 3\), or \(…, 7\)"),
    ],
)  # fmt: skip
@pytest.mark.usefixtures("any_type")
def test_bad_input(call, words):
    with pytest.raises(InvalidInput, match=words):
        call()


def test_shapes_are_checked_once_for_all_that_differ_by_numbers(monkeypatch):
    checked = []
    monkeypatch.setattr(attachments, "_right", {})
    monkeypatch.setattr(attachments, "_check_shapes", lambda name, attachment, *rest: checked.append(attachment))
    for moment in (0.1, 0.2):
        RigidBody(MOMENTS, [Wheel(FIRST, moment), Wheel((0, 1, 0), 2.0 * moment)], [LinearDrag(moment)])
    assert [type(x).__name__ for x in checked[::2]] == ["Wheel", "LinearDrag"]
    for _ in range(2):  # another function each time, which may give anything
        RigidBody(MOMENTS, [Wheel(FIRST, 0.1, motor=lambda *now: now[0])])
    assert len(checked) == 8
