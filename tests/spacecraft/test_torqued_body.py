"""Bodies under torques: decay laws, point masses in the true field, the Jacobi integral, libration."""

import jax
import jax.numpy as jnp
import mpmath
import numpy as np
import pytest
from scipy.integrate import solve_ivp

import polhode as ph
from polhode import rotation
from polhode.errors import InvalidInput
from polhode.spacecraft import AbstractTorque, GravityGradient, LinearDrag, QuadraticDrag, TorquedBody
from polhode.systems import KeplerOrbit
from sweeping import first
from systems.balances import worst_balance

MOMENTS = (1.0, 2.0, 2.6)
TILTED = rotation.normalize(np.array([0.9, 0.1, -0.2, 0.3]))
MOTION = 1e-11  # relative, of adaptive steps at 1e-12 over some turns
BALANCE = 1e-10  # relative, asked of simulate's balances
LIBRATION = 1e-7  # relative, of frequencies from motions small enough to be linear
TIMES = np.linspace(0.0, 8.0, 17)


@pytest.mark.sweep
def test_linear_drag_decays_exponentially():
    coefficient = np.array([0.1, 0.2, 0.3])
    found = ph.simulate(TorquedBody(MOMENTS, [LinearDrag(coefficient)]), 3.0 * np.eye(3), TIMES)
    exact = 3.0 * np.exp(-coefficient[:, None] * TIMES / np.array(MOMENTS)[:, None])
    assert np.abs(found.momentum[range(3), :, range(3)] - exact).max() < MOTION
    sphere = ph.simulate(TorquedBody((2.0, 2.0, 2.0), [LinearDrag([0.5] * 3)]), [[1.0, -2.0, 0.5]] * 3, TIMES)
    assert np.abs(sphere.momentum[1] - np.array([1.0, -2.0, 0.5]) * np.exp(-0.25 * TIMES)[:, None]).max() < MOTION
    one, three = (TorquedBody(MOMENTS, [LinearDrag(c)]).vector_field(0.0, np.ones(3)) for c in (0.5, [0.5] * 3))
    assert (np.asarray(one) == np.asarray(three)).all()


@pytest.mark.sweep
def test_quadratic_drag_decays_as_one_over_time():
    body = TorquedBody(MOMENTS, [QuadraticDrag(0.4)])
    found = ph.simulate(body, 3.0 * np.eye(3), TIMES)
    moments = np.array(MOMENTS)[:, None]
    exact = 3.0 / (1.0 + 0.4 * (3.0 / moments) * TIMES / moments)
    assert np.abs(found.momentum[range(3), :, range(3)] - exact).max() < MOTION
    assert (np.asarray(body.vector_field(0.0, np.zeros(3))) == 0.0).all()


@pytest.mark.sweep
def test_without_torques_it_is_the_free_body():
    start = np.concatenate([TILTED, [0.3, 1.8, 1.5]])
    found = ph.simulate(TorquedBody(MOMENTS, []), start, TIMES)
    motion = ph.FreeMotion(MOMENTS, momentum=start[4:], attitude=TILTED)
    assert np.abs(found.attitude - motion.attitude(TIMES)).max() < MOTION
    assert np.abs(found.angular_velocity - motion.angular_velocity(TIMES)).max() < MOTION
    assert max(found.drift.values()) < MOTION


class FixedInSpace(AbstractTorque):
    """A user's own."""

    vector: jax.Array

    @property
    def needs_attitude(self):
        return True

    def torque(self, t, attitude, angular_velocity, actuator=None):
        return rotation.rotate(rotation.conjugate(attitude), jnp.sin(t)[..., None] * self.vector)


@pytest.mark.sweep
def test_a_torque_of_ones_own_adds_up_in_space():
    vector, momentum = np.array([0.3, -0.5, 1.0]), np.array([0.3, 1.8, 1.5])
    found = ph.simulate(TorquedBody(MOMENTS, [FixedInSpace(jnp.array(vector))]), [*TILTED, *momentum], TIMES)
    exact = rotation.rotate(TILTED, momentum) + (1.0 - np.cos(TIMES))[:, None] * vector
    assert np.abs(rotation.rotate(found.attitude, found.momentum) - exact).max() < MOTION
    assert max(found.drift.values()) < MOTION
    dataset = ph.as_dataset(found)
    assert dataset["momentum"].shape == (17, 3) and dataset["kinetic_energy"].attrs["drift"] < MOTION
    assert (dataset["kinetic_energy_received"].values == found.received["kinetic_energy"]).all()


class BentGravity(GravityGradient):
    """A broken specimen: slightly more torque, the same potential."""

    def torque(self, t, attitude, angular_velocity, actuator=None):
        return (1.0 + 1e-9) * super().torque(t, attitude, angular_velocity)


@pytest.mark.sweep
def test_balances_change_at_their_rates():
    start = np.concatenate([TILTED, [0.3, 1.8, 1.5]])
    drags = [LinearDrag((0.1, 0.2, 0.3)), QuadraticDrag(0.05)]
    circle, ellipse = KeplerOrbit(0.7, 0.0, mean_anomaly=0.4), KeplerOrbit(0.7, 0.3)
    cases = ((circle, GravityGradient, True), (circle, BentGravity, False), (ellipse, BentGravity, True))
    for orbit, kind, kept in cases:
        worst = worst_balance(TorquedBody(MOMENTS, [*drags, kind(orbit, MOMENTS)]), 2.0, start)
        assert ("jacobi_integral" in worst) == (orbit is circle)
        assert all(value < 1e-14 for value in worst.values()) == kept, worst


@pytest.mark.long
@pytest.mark.parametrize("at_rest", first(1, [False, True]))
def test_energy_and_momentum_follow_the_torques(at_rest):
    orbit = KeplerOrbit(0.7, 0.3, mean_anomaly=0.4)
    body = TorquedBody(MOMENTS, [LinearDrag((0.1, 0.2, 0.3)), QuadraticDrag(0.05), GravityGradient(orbit, MOMENTS)])
    start = np.array([*TILTED, 0.0, 0.0, 0.0] if at_rest else [*TILTED, 0.3, 1.8, 1.5])
    found = ph.simulate(body, start, TIMES)
    assert set(found.balances) == {"kinetic_energy", "|L|²"}
    assert max(found.drift.values()) < BALANCE
    assert np.ptp(found.balances["kinetic_energy"]) > 0.01


@pytest.mark.sweep
def test_the_jacobi_integral_is_kept_on_a_circular_orbit():
    orbit = KeplerOrbit(1.1e-3, 0.0, mean_anomaly=0.4)
    start = np.concatenate([TILTED, 1e-3 * np.array([0.3, 1.8, 1.5])])
    times = np.linspace(0.0, 5.0 * float(orbit.period), 21)
    found = ph.simulate(TorquedBody(MOMENTS, [GravityGradient(orbit, MOMENTS)]), start, times)
    assert found.drift["jacobi_integral"] < BALANCE and np.ptp(found.balances["kinetic_energy"]) > 1e-7
    assert np.abs(np.linalg.norm(found.attitude, axis=-1) - 1.0).max() < BALANCE


def test_the_torque_is_that_of_point_masses_in_the_true_field():
    """Masses ± on each axis: the next term falls with the square of size over distance."""
    orbit = KeplerOrbit.from_semi_major_axis(7.0e6, 3.986004418e14, 0.2, mean_anomaly=1.0)
    size, masses = np.array([2.0, 1.5, 0.5]), np.array([3.0, 2.0, 1.0])
    second = 2.0 * masses * size**2
    moments = second.sum() - second
    torque = np.asarray(GravityGradient(orbit, moments).torque(30.0, TILTED, np.zeros(3)))
    ratio, way = float(orbit.distance_ratio(30.0)), np.asarray(orbit.direction(30.0))
    turn = rotation.as_matrix(TILTED)
    with mpmath.workdps(50):
        gm = mpmath.mpf(float(orbit.mean_motion)) ** 2 * mpmath.mpf(7.0e6) ** 3
        place = [mpmath.mpf(7.0e6) * ratio * mpmath.mpf(float(x)) for x in turn.T @ way]
        total = [mpmath.mpf(0)] * 3
        for axis in range(3):
            for side in (-1, 1):
                arm = [mpmath.mpf(float(side * size[axis])) * (k == axis) for k in range(3)]
                at = [a + b for a, b in zip(place, arm, strict=True)]
                far = mpmath.sqrt(sum(x * x for x in at))
                force = [-gm * mpmath.mpf(masses[axis]) * x / far**3 for x in at]
                for k in range(3):
                    i, j = (k + 1) % 3, (k + 2) % 3
                    total[k] += arm[i] * force[j] - arm[j] * force[i]
        exact = np.array([float(x) for x in total])
    assert np.abs(torque - exact).max() < 1e-11 * np.abs(exact).max()
    assert np.abs(exact).min() > 1e-8


def relative_equilibrium(n, tilt):
    """Axis 1 along the radius, axis 3 along the orbit's normal, then turned by a small rotation vector in the body."""
    attitude = rotation.from_rotation_vector(np.asarray(tilt))
    spin = n * rotation.rotate(rotation.conjugate(attitude), np.array([0.0, 0.0, 1.0]))
    return np.concatenate([attitude, np.asarray(MOMENTS) * spin])


def offsets(n, tilt, spacing, count):
    """Rotation vectors (T, 3) from the orbit's frame to the body, at equal times."""
    system = TorquedBody(MOMENTS, [GravityGradient(KeplerOrbit(n, 0.0), MOMENTS)])
    times = spacing * np.arange(count)
    found = ph.simulate(system, relative_equilibrium(n, tilt), times)
    frame = rotation.from_axis_angle(np.array([0.0, 0.0, 1.0]), n * times)
    return rotation.as_rotation_vector(rotation.multiply(rotation.conjugate(frame), found.attitude))


@pytest.mark.sweep
def test_pitch_librates_with_the_textbook_frequency():
    """Hughes, section 9.2: ω² = 3 n² (I_roll − I_yaw)/I_pitch, with yaw radial and pitch along the normal."""
    n, spacing = 1.1e-3, 100.0
    x = offsets(n, (0.0, 0.0, 1e-5), spacing, 200)[:, 2]
    both, middle = x[2:] + x[:-2], x[1:-1]  # = 2 cos(ωh) x for any oscillation
    found = np.arccos(0.5 * (both @ middle) / (middle @ middle)) / spacing
    exact = n * np.sqrt(3.0 * (MOMENTS[1] - MOMENTS[0]) / MOMENTS[2])
    assert abs(found / exact - 1.0) < LIBRATION
    still = offsets(n, (0.0, 0.0, 0.0), spacing, 200)
    assert np.abs(still).max() < 1e-11


@pytest.mark.sweep
def test_roll_and_yaw_librate_with_the_textbook_frequencies():
    """Hughes, section 9.2: s⁴ + (1 + 3k1 + k1 k3) n² s² + 4 k1 k3 n⁴ = 0, k1 = (p − y)/r, k3 = (p − r)/y."""
    n, spacing = 1.1e-3, 400.0
    x = offsets(n, (1e-5, 2e-5, 0.0), spacing, 200)[:, 1]
    outer, inner, middle = x[4:] + x[:-4], x[3:-1] + x[1:-3], x[2:-2]
    (a, b), *_ = np.linalg.lstsq(np.stack([inner, middle], axis=1), outer, rcond=None)
    # each cosine c = cos ωh solves 4c² − 2 = 2ac + b
    found = np.sort(np.arccos(np.roots([4.0, -2.0 * a, -2.0 - b])) / spacing)
    yaw, roll, pitch = MOMENTS
    k1, k3 = (pitch - yaw) / roll, (pitch - roll) / yaw
    exact = n * np.sqrt(np.sort(-np.roots([1.0, 1.0 + 3.0 * k1 + k1 * k3, 4.0 * k1 * k3])))
    assert np.abs(found / exact - 1.0).max() < 10 * LIBRATION


@pytest.mark.long
def test_states_without_and_with_attitude():
    body = TorquedBody(MOMENTS, [LinearDrag(0.1)])
    bare = body.vector_field(0.0, np.array([[[0.3, 1.8, 1.5]], [[1.0, 0.0, 0.2]]]))
    whole = body.vector_field(0.0, np.array([[[*TILTED, 0.3, 1.8, 1.5]], [[*TILTED, 1.0, 0.0, 0.2]]]))
    assert bare.shape == (2, 1, 3) and whole.shape == (2, 1, 7)
    assert (np.asarray(whole[..., 4:]) == np.asarray(bare)).all()
    assert body.vectors(np.ones(3)).attitude is None
    # from rest the momentum is held to what the orbit's rate would give it
    resting = TorquedBody(MOMENTS, [GravityGradient(KeplerOrbit(1e-3, 0.1), MOMENTS)])
    assert np.allclose(resting.scales(jnp.array([*TILTED, 0.0, 0.0, 0.0])), [1.0] * 4 + [2.6e-3] * 3)


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda: TorquedBody((1.0, 2.0, -3.0), []), "positive"),
        (lambda: TorquedBody(MOMENTS, [3.0]), "AbstractTorque"),
        (lambda: TorquedBody(MOMENTS, [GravityGradient(KeplerOrbit(1.0, 0.0), (1.0, 2.0, 3.0))]), "both the same"),
        (lambda: LinearDrag(-1.0), "not negative"),
        (lambda: LinearDrag((1.0, 2.0)), "one or three"),
        (lambda: QuadraticDrag(np.inf), "`coefficient`"),
        (lambda: ph.simulate(TorquedBody(MOMENTS, []), np.ones(7), TIMES), "unit quaternion"),
        (lambda: ph.simulate(TorquedBody(MOMENTS, []), np.ones(4), TIMES), r"shape \(…, 3\), or \(…, 7\)"),
        (
            lambda: ph.simulate(
                TorquedBody(MOMENTS, [GravityGradient(KeplerOrbit(1.0, 0.0), MOMENTS)]), np.ones(3), TIMES
            ),
            r"shape \(…, 7\)",
        ),
    ],
)
@pytest.mark.usefixtures("any_type")
def test_bad_input(call, words):
    with pytest.raises(InvalidInput, match=words):
        call()


@pytest.mark.long
@pytest.mark.parametrize("eccentricity", [0.0, 0.3, 0.8])
def test_gravity_gradient_against_steps_in_the_true_anomaly(eccentricity):
    """Which needs no equation of Kepler's: dt = (r/a)² df / (n √(1 − e²)), r/a = (1 − e²) / (1 + e cos f)."""
    moments, n, e = np.array([1.0, 2.0, 2.5]), 0.7, eccentricity
    body = TorquedBody(moments, [GravityGradient(KeplerOrbit(n, e), moments)])
    start = np.array([1.0, 0.0, 0.0, 0.0, 0.3, 0.1, 2.4])

    def rates(f, y):
        (w, x, u, v), momentum, ratio = y[:4], y[4:7], (1.0 - e * e) / (1.0 + e * np.cos(f))
        turn = np.array([[1 - 2 * (u * u + v * v), 2 * (x * u - w * v), 2 * (x * v + w * u)],
                         [2 * (x * u + w * v), 1 - 2 * (x * x + v * v), 2 * (u * v - w * x)],
                         [2 * (x * v - w * u), 2 * (u * v + w * x), 1 - 2 * (x * x + u * u)]])  # fmt: skip
        centre, spin = turn.T @ np.array([np.cos(f), np.sin(f), 0.0]), momentum / moments
        torque = np.cross(momentum, spin) + 3.0 * (n * n / ratio**3) * np.cross(centre, moments * centre)
        a, b, c = spin
        attitude = 0.5 * np.array([-x * a - u * b - v * c, w * a + u * c - v * b, w * b - x * c + v * a,
                                   w * c + x * b - u * a])  # fmt: skip
        per_f = ratio**2 / (n * np.sqrt(1.0 - e * e))
        return np.concatenate([attitude, torque, [1.0]]) * per_f

    found = solve_ivp(rates, (0.0, 11.0), [*start, 0.0], method="DOP853", rtol=1e-13, atol=1e-14).y[:, -1]
    ours = ph.simulate(body, start, [0.0, found[-1]], ph.integrators.Taylor)
    assert ours.error_estimate < 1e-9
    assert np.abs(ours.states[-1] - found[:-1]).max() < 1e-9
