"""Bodies under torques: decay laws, point masses in the true field, the Jacobi integral, libration."""

import mpmath
import numpy as np
import pytest

import polhode as ph
from polhode import rotation
from polhode.errors import InvalidInput
from polhode.systems import GravityGradient, KeplerOrbit, LinearDrag, QuadraticDrag, TorquedBody

MOMENTS = (1.0, 2.0, 2.6)
TILTED = rotation.normalize(np.array([0.9, 0.1, -0.2, 0.3]))
MOTION = 1e-11  # relative, of adaptive steps at 1e-12 over some turns
BALANCE = 1e-10  # relative, asked of simulate's balances
LIBRATION = 1e-7  # relative, of frequencies from motions small enough to be linear
TIMES = np.linspace(0.0, 8.0, 17)


def test_linear_drag_decays_exponentially():
    sphere = TorquedBody((2.0, 2.0, 2.0), [LinearDrag(0.5)])
    start = np.array([1.0, -2.0, 0.5])
    found = ph.simulate(sphere, start, TIMES)
    assert np.abs(found.momentum - start * np.exp(-0.5 * TIMES / 2.0)[:, None]).max() < MOTION
    body = TorquedBody(MOMENTS, [LinearDrag((0.1, 0.2, 0.3))])
    for axis in range(3):
        found = ph.simulate(body, 3.0 * np.eye(3)[axis], TIMES)
        exact = np.exp(-0.1 * (axis + 1) * TIMES / MOMENTS[axis])
        assert np.abs(found.momentum[:, axis] / 3.0 - exact).max() < MOTION


def test_quadratic_drag_decays_as_one_over_time():
    body = TorquedBody(MOMENTS, [QuadraticDrag(0.4)])
    for axis, moment in enumerate(MOMENTS):
        found = ph.simulate(body, 3.0 * np.eye(3)[axis], TIMES)
        exact = 1.0 / (1.0 + 0.4 * (3.0 / moment) * TIMES / moment)
        assert np.abs(found.momentum[:, axis] / 3.0 - exact).max() < MOTION
    assert (np.asarray(body.vector_field(0.0, np.zeros(3))) == 0.0).all()


def test_without_torques_it_is_the_free_body():
    start = np.concatenate([TILTED, [0.3, 1.8, 1.5]])
    found = ph.simulate(TorquedBody(MOMENTS, []), start, TIMES)
    motion = ph.FreeMotion(MOMENTS, start[4:], TILTED)
    assert np.abs(found.attitude - motion.attitude(TIMES)).max() < MOTION
    assert np.abs(found.angular_velocity - motion.angular_velocity(TIMES)).max() < MOTION
    assert max(found.drift.values()) < MOTION


def test_energy_and_momentum_follow_the_torques():
    orbit = KeplerOrbit(0.7, 0.3, mean_anomaly=0.4)
    body = TorquedBody(MOMENTS, [LinearDrag((0.1, 0.2, 0.3)), QuadraticDrag(0.05), GravityGradient(orbit, MOMENTS)])
    found = ph.simulate(body, np.concatenate([TILTED, [0.3, 1.8, 1.5]]), TIMES)
    assert set(found.balances) == {"kinetic_energy", "momentum_squared"}
    assert max(found.drift.values()) < BALANCE
    assert np.ptp(found.balances["kinetic_energy"]) > 0.1


class BentGravity(GravityGradient):
    """A broken specimen: twice the torque, the same potential."""

    def torque(self, t, attitude, angular_velocity):
        return 2.0 * super().torque(t, attitude, angular_velocity)


def test_the_jacobi_integral_is_kept_on_a_circular_orbit():
    orbit = KeplerOrbit(1.1e-3, 0.0, mean_anomaly=0.4)
    start = np.concatenate([TILTED, 1e-3 * np.array([0.3, 1.8, 1.5])])
    times = np.linspace(0.0, 10.0 * float(orbit.period), 51)
    found = ph.simulate(TorquedBody(MOMENTS, [GravityGradient(orbit, MOMENTS)]), start, times)
    assert found.drift["jacobi_integral"] < BALANCE and np.ptp(found.balances["kinetic_energy"]) > 1e-7
    assert np.abs(np.linalg.norm(found.attitude, axis=-1) - 1.0).max() < BALANCE
    broken = ph.simulate(TorquedBody(MOMENTS, [BentGravity(orbit, MOMENTS)]), start, times)
    assert broken.drift["jacobi_integral"] > 1e-3
    dragged = ph.simulate(TorquedBody(MOMENTS, [LinearDrag(1e-4), GravityGradient(orbit, MOMENTS)]), start, times)
    assert dragged.drift["jacobi_integral"] < BALANCE and np.ptp(dragged.balances["jacobi_integral"]) > 1e-7


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


def test_pitch_librates_with_the_textbook_frequency():
    """Hughes, section 9.2: ω² = 3 n² (I_roll − I_yaw)/I_pitch, with yaw radial and pitch along the normal."""
    n, spacing = 1.1e-3, 100.0
    x = offsets(n, (0.0, 0.0, 1e-5), spacing, 200)[:, 2]
    both, middle = x[2:] + x[:-2], x[1:-1]  # = 2 cos(ωh) x for any oscillation
    found = np.arccos(0.5 * (both @ middle) / (middle @ middle)) / spacing
    exact = n * np.sqrt(3.0 * (MOMENTS[1] - MOMENTS[0]) / MOMENTS[2])
    assert abs(found / exact - 1.0) < LIBRATION
    still = offsets(n, (0.0, 0.0, 0.0), spacing, 20)
    assert np.abs(still).max() < 1e-11


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


def test_batches_and_bare_momenta():
    body = TorquedBody(MOMENTS, [LinearDrag(0.1)])
    start = np.array([[[0.3, 1.8, 1.5]], [[1.0, 0.0, 0.2]]])
    found = ph.simulate(body, start, TIMES)
    assert found.states.shape == (2, 1, 17, 3) and found.attitude is None
    one = ph.simulate(body, start[1, 0], TIMES)
    assert np.abs(found.states[1, 0] - one.states).max() < MOTION
    orbit = KeplerOrbit(1.0, 0.1)
    rest = ph.simulate(TorquedBody(MOMENTS, [GravityGradient(orbit, MOMENTS)]), [*TILTED, 0.0, 0.0, 0.0], TIMES)
    assert np.abs(rest.momentum[-1]).max() > 0.1


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
