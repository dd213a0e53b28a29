"""A torque that another package brings goes where ours go, without a change to any file of ours."""


import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np
import pytest

import polhode as ph
from polhode.spacecraft import RigidBody
from polhode.testing import LawBroken, check_system

GAIN, FIELD = 4e7, 3e-5
MOMENT = 2.0
RATE = GAIN * FIELD**2 / MOMENT
"""What of a ball's spin across the field decays at [1/s]: I dΩ/dt = k (Ω × B) × B."""
START = np.array([0.3, 0.0, 0.4])


@pytest.fixture
def coils(plugin):
    from bdot_coils import BDotCoils

    return BDotCoils


def ball(coils, gain=GAIN):
    return RigidBody((MOMENT,) * 3, torques=[coils(gain, (FIELD, 0.0, 0.0))])


def test_a_ball_stops_across_the_field_as_computed_by_hand(coils, tmp_path):
    times = np.linspace(0.0, 100.0, 11)
    craft = ball(coils)
    found = ph.simulate(craft, craft.pack(angular_velocity=START), times)
    in_space = ph.rotation.rotate(found.attitude, found.momentum) / MOMENT
    decay = np.exp(-RATE * times)
    wanted = np.stack([0.3 + 0.0 * times, 0.0 * times, 0.4 * decay], axis=-1)
    assert np.abs(in_space - wanted).max() < 1e-13
    assert found.drift["kinetic_energy"] < 1e-13  # misses the balance of energy and work by so much
    ph.formats.write_dataset(found, tmp_path / "craft.nc")
    back = ph.formats.read_dataset(tmp_path / "craft.nc")
    assert (back.attitude == found.attitude).all()
    assert found.plot().axes


@pytest.mark.sweep
def test_derivatives_go_through_it(coils):
    seconds, known = 50.0, ball(coils)

    def energy(gain):
        craft = eqx.tree_at(lambda body: body.torques[0].gain, known, gain)
        end = ph.solve(
            craft, craft.pack(angular_velocity=START), (0.0, seconds), method=ph.integrators.Taylor
        ).end_state
        return 0.5 * jnp.sum(craft.parts(end).momentum ** 2) / MOMENT

    across = 0.5 * MOMENT * 0.4**2 * np.exp(-2.0 * RATE * seconds)
    with jax.enable_x64(True):
        assert jax.grad(energy)(GAIN) == pytest.approx(-2.0 * FIELD**2 / MOMENT * seconds * across, rel=1e-12)


@pytest.mark.long
def test_laws_of_systems_hold_and_a_broken_specimen_is_refused(coils):
    class Entangled(coils):
        """Lets each spacecraft of a batch feel the field of all."""

        def torque(self, t, attitude, angular_velocity, actuator=None):
            return super().torque(t, attitude, angular_velocity) * (1.0 + jnp.size(angular_velocity))

    craft = ball(coils)
    states = [craft.pack(angular_velocity=spin) for spin in (START, 2.0 * START)]
    check_system(craft, states=states)
    with pytest.raises(LawBroken):
        check_system(ball(Entangled), states=states)
