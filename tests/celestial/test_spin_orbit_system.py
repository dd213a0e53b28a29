"""The spin-orbit problem against the pendulum, the whole body, and its own energy."""

import jax
import jax.numpy as jnp
import numpy as np
import pytest
from scipy.special import ellipk

import polhode as ph
from polhode import rotation
from polhode.celestial import SpinOrbit
from polhode.errors import InvalidInput
from polhode.spacecraft import GravityGradient, TorquedBody
from polhode.systems import KeplerOrbit

MOTION = 1e-10  # of adaptive steps at 1e-12 over ten orbits
MOMENTS = (1.0, 2.0, 2.6)


@pytest.mark.sweep
@pytest.mark.parametrize("amplitude", [0.7, 1e-3, 1.5])
def test_synchronous_libration_on_a_circular_orbit_is_a_pendulum(amplitude):
    """2(θ − nt) is a pendulum of small frequency n ω0: period 4K(sin θmax)/(n ω0)."""
    n, asphericity = 0.5, 0.3
    period = 4.0 * ellipk(np.sin(amplitude) ** 2) / (n * asphericity)
    times = period * np.array([0.0, 0.25, 0.5, 1.0, 3.0])
    found = ph.simulate(SpinOrbit(asphericity, 0.0, n), [amplitude, n], times)
    offset = found.states[:, 0] - n * times
    assert np.abs(offset - amplitude * np.array([1.0, 0.0, -1.0, 1.0, 1.0])).max() < MOTION


@pytest.mark.sweep
def test_it_is_the_planar_motion_of_the_body_under_the_gravity_gradient():
    orbit = KeplerOrbit(0.7, 0.3, mean_anomaly=0.4)
    system = SpinOrbit.from_body(ph.Body.from_moments(MOMENTS), orbit)
    times = np.linspace(0.0, 10.0, 21)
    angle, rate = 0.3, 1.1
    flat = ph.simulate(system, [angle, rate], times)
    attitude = rotation.from_axis_angle(np.array([0.0, 0.0, 1.0]), np.asarray(angle))
    body = TorquedBody(MOMENTS, [GravityGradient(orbit, MOMENTS)])
    whole = ph.simulate(body, [*attitude, 0.0, 0.0, MOMENTS[2] * rate], times)
    turned = 2.0 * np.unwrap(np.arctan2(whole.attitude[:, 3], whole.attitude[:, 0]))
    assert np.abs(turned - flat.states[:, 0]).max() < MOTION
    assert np.abs(whole.angular_velocity[:, 2] - flat.states[:, 1]).max() < MOTION
    assert np.abs(flat.states[:, 0] - angle - rate * times).max() > 0.3


@pytest.mark.sweep
def test_the_energy_changes_as_the_orbit_demands():
    times = np.linspace(0.0, 20.0, 11)
    states = np.array([[0.1, 1.0], [2.0, 1.5], [0.0, 0.4]])
    found = ph.simulate(SpinOrbit(0.89, 0.4), states, times)
    assert found.drift["energy_per_moment"].shape == (3,) and found.drift["energy_per_moment"].max() < MOTION
    assert np.ptp(found.balances["energy_per_moment"], axis=-1).min() > 0.1
    dataset = ph.as_dataset(found)
    assert (dataset["rate"].values == found.states[..., 1]).all() and dataset["angle"].attrs["units"] == "rad"


@pytest.mark.long_cases("1.0-True")
@pytest.mark.parametrize(("factor", "kept"), [(1.0, True), (1.0 + 1e-9, False)])
def test_the_rate_of_the_energy_is_its_derivative_along_the_motion(factor, kept):
    system, t, state = SpinOrbit(0.89, 0.4), jnp.asarray(0.7), jnp.array([0.5, 1.3])
    field = system.vector_field(t, state) * jnp.array([1.0, factor])
    _, slope = jax.jvp(lambda t, y: system.balances(t, y)["energy_per_moment"].value, (t, state), (jnp.ones(()), field))
    assert (abs(slope - system.balances(t, state)["energy_per_moment"].rate) < 1e-14) == kept


def test_from_body_takes_sorted_moments():
    system = SpinOrbit.from_body(ph.Body.from_moments((3.0, 1.5, 2.0)), KeplerOrbit(2.0, 0.1, 0.5))
    assert abs(float(system.asphericity) - np.sqrt(0.5)) < 1e-15
    assert float(system.mean_motion) == 2.0 and float(system.eccentricity) == 0.1
    assert float(system.orbit.mean_anomaly(0.0)) == 0.5


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda: SpinOrbit(-0.1, 0.1), "`asphericity`"),
        (lambda: SpinOrbit(1.8, 0.1), "√3"),
        (lambda: SpinOrbit(0.1, 1.1), "`eccentricity`"),
        (lambda: ph.simulate(SpinOrbit(0.1, 0.1), [1.0, 2.0, 3.0], [0.0, 1.0]), r"shape \(…, 2\)"),
    ],
)
@pytest.mark.usefixtures("any_type")
def test_bad_input(call, words):
    with pytest.raises(InvalidInput, match=words):
        call()
