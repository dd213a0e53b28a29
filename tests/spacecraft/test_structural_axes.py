"""A body in its given axes against the same body along its principal axes, with everything on it rotated by hand."""

import jax.numpy as jnp
import numpy as np
import pytest

import polhode as ph
from polhode import rotation
from polhode.errors import InvalidInput
from polhode.spacecraft import (
    AbstractTorque,
    GravityGradient,
    LaggedTorque,
    LinearDrag,
    RigidBody,
    SphericalSlug,
    Wheel,
)
from polhode.systems import KeplerOrbit
from systems.balances import worst_balance

TURN = rotation.as_matrix(rotation.normalize(np.array([0.7, 0.3, -0.5, 0.4])))
CENTER = np.array([0.3, -0.2, 0.5])
BODY = ph.Body(40.0, CENTER, TURN @ np.diag([1.0, 2.0, 2.6]) @ TURN.T)
AXES = BODY.principal_axes
ATTITUDE, VELOCITY = rotation.normalize(np.array([0.9, 0.1, -0.2, 0.3])), np.array([0.3, -0.9, 0.6])
AXIS, ORBIT = np.array([0.48, 0.6, 0.64]), KeplerOrbit(0.7, 0.0, 0.4)
PLACE, FORCE = np.array([1.0, 0.4, -0.3]), np.array([0.02, -0.05, 0.01])
TIMES = np.linspace(0.0, 8.0, 9)
ROUNDING = 2e-15
MOTION = 2e-12  # relative, of two runs whose roundings differ
BALANCE = 1e-12


class Push(AbstractTorque):
    """A force at a place of the body."""

    place: np.ndarray
    push: np.ndarray

    def force(self, t, attitude, angular_velocity, actuator=None):
        return self.push + 0.0 * angular_velocity

    def torque(self, t, attitude, angular_velocity, actuator=None):
        return jnp.cross(jnp.asarray(self.place), self.force(t, attitude, angular_velocity))


def motor(axes):
    """A user's function for the given axes; for others it gets these."""
    given = axes.T

    def turning(t, attitude, angular_velocity, rate):
        column = rotation.rotate(attitude, jnp.broadcast_to(given[:, 0], angular_velocity.shape))
        return 0.05 * jnp.sin(2.0 * t) - 0.01 * rate + 0.02 * column[..., 2] - 0.03 * angular_velocity @ given[:, 2]

    return turning


def command(axes):
    def wanted(t, attitude, angular_velocity):
        return (-0.2 * angular_velocity @ axes.T + 0.1 * jnp.sin(t)[..., None] * jnp.array([1.0, 2.0, 3.0])) @ axes

    return wanted


def everything(axes, center, gravity):
    mounts = [Wheel(AXIS @ axes, 0.2, motor(axes), friction=0.01), SphericalSlug(0.2, 0.05)]
    return mounts, [gravity, LinearDrag(0.01), LaggedTorque(command(axes), 0.5), Push((PLACE - center) @ axes,
                                                                                      FORCE @ axes)]  # fmt: skip


GIVEN = RigidBody.from_body(BODY, *everything(np.eye(3), np.zeros(3), GravityGradient(ORBIT)))
SAME = RigidBody(BODY.principal_moments,
                 *everything(AXES, CENTER, GravityGradient(ORBIT, BODY.principal_moments)))  # fmt: skip
SLUG = np.array([0.1, -0.2, 0.3])


def starts(**more):
    own = GIVEN.pack(ATTITUDE, VELOCITY, rates=[4.0, SLUG])
    turned = rotation.multiply(ATTITUDE, rotation.from_matrix(AXES))
    return own, SAME.pack(turned, VELOCITY @ AXES, rates=[4.0, SLUG @ AXES])


def test_states_are_along_the_principal_axes():
    own, same = (np.asarray(x) for x in starts())
    assert np.abs(own[:8] - same[:8]).max() < ROUNDING
    assert np.abs(own[8:11] @ AXES - same[8:11]).max() < ROUNDING  # the slug's own state is along the given axes
    given = GIVEN.pack(ATTITUDE, momentum=BODY.inertia @ VELOCITY + 0.2 * 4.0 * AXIS + 0.2 * SLUG, rates=[4.0, SLUG])
    assert np.abs(np.asarray(given) - own).max() < ROUNDING


@pytest.mark.sweep
def test_the_motion_is_that_of_the_body_along_its_principal_axes():
    own, same = starts()
    one, two = ph.simulate(GIVEN, own, TIMES), ph.simulate(SAME, same, TIMES)
    assert np.abs(one.states[:, :8] - two.states[:, :8]).max() < MOTION
    assert np.abs(one.angular_velocity - two.angular_velocity).max() < MOTION
    assert max(one.drift.values()) < BALANCE and set(one.balances) == {"kinetic_energy", "|L|²", "jacobi_integral"}
    for name, values in one.balances.items():
        assert np.abs(values - two.balances[name]).max() < MOTION * np.abs(values).max()
    along = one.along("given")
    assert np.abs(along.angular_velocity[0] - VELOCITY).max() < ROUNDING
    assert np.abs(along.attitude[0] - ATTITUDE).max() < ROUNDING
    assert max(worst_balance(GIVEN, 0.8, own).values()) < BALANCE


def test_a_force_turns_about_the_centre_of_mass():
    """τ = (r − c) × F; a broken specimen that counts places from the origin is off by c × F."""
    push = RigidBody.from_body(BODY, torques=[Push(PLACE, FORCE)])
    got = np.asarray(push.external_torque(0.0, push.pack()))
    assert np.abs(got - np.cross(PLACE - CENTER, FORCE)).max() < ROUNDING
    assert np.abs(got - np.cross(PLACE, FORCE)).max() > 0.01


def test_gravity_takes_the_inertia_of_the_body_or_checks_its_own():
    exact = RigidBody.from_body(BODY, torques=[GravityGradient(ORBIT, BODY.inertia)])
    state, centre = exact.pack(ATTITUDE), rotation.as_matrix(ATTITUDE).T @ np.asarray(ORBIT.direction(1.5))
    wanted = 3.0 * 0.49 * np.cross(centre, BODY.inertia @ centre)
    assert np.abs(np.asarray(exact.external_torque(1.5, state)) - wanted).max() < ROUNDING
    for wrong in (BODY.principal_moments, 1.001 * BODY.inertia):
        with pytest.raises(InvalidInput, match=r"gravity gradient on the moments .* Give both the same"):
            RigidBody.from_body(BODY, torques=[GravityGradient(ORBIT, wrong)])
    with pytest.raises(InvalidInput, match="has no moments yet"):
        GravityGradient(ORBIT).torque(0.0, jnp.array([1.0, 0.0, 0.0, 0.0]), jnp.zeros(3))


def test_what_is_not_a_body_is_refused(any_type):
    with pytest.raises(InvalidInput, match=r"`body` must be a polhode\.Body"):
        RigidBody.from_body((1.0, 2.0, 3.0))  # type: ignore[arg-type]
