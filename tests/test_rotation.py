"""Rotations against SciPy, mpmath and their own laws, in NumPy, strict arrays and JAX."""

import array_api_strict
import jax
import mpmath
import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from polhode import rotation
from polhode.errors import InvalidInput

ROUNDING = 2e-15
"""A dozen roundings on entries up to 1."""


@pytest.fixture
def quaternions():
    q = np.random.default_rng(1).normal(size=(200, 4))
    return q / np.linalg.norm(q, axis=1, keepdims=True)


def test_matrix_agrees_with_scipy(quaternions):
    theirs = Rotation.from_quat(quaternions[:, [1, 2, 3, 0]]).as_matrix()
    assert np.abs(rotation.as_matrix(quaternions) - theirs).max() < ROUNDING


def test_product_is_composition_and_rotate_is_the_matrix(quaternions):
    p, q = quaternions[:100], quaternions[100:]
    product = rotation.as_matrix(rotation.multiply(p, q))
    assert np.abs(product - rotation.as_matrix(p) @ rotation.as_matrix(q)).max() < ROUNDING
    wrong = rotation.as_matrix(rotation.multiply(q, p))
    assert np.abs(product - wrong).max() > 0.1
    v = np.random.default_rng(2).normal(size=(100, 3))
    assert np.abs(rotation.rotate(p, v) - np.einsum("nij,nj->ni", rotation.as_matrix(p), v)).max() < 5 * ROUNDING


def test_the_rate_of_the_quaternion_turns_the_matrix_about_the_body_axes(quaternions):
    """dR/dt = R hat(Ω), by the derivative of the matrix; about the space axes it would be hat(Ω) R."""
    velocity = np.random.default_rng(4).normal(size=(200, 3))
    rates = rotation.quaternion_rate(quaternions, velocity)
    with jax.enable_x64(True):
        turning = np.asarray(jax.jvp(rotation.as_matrix, (quaternions,), (rates,))[1])
    matrices, skew = rotation.as_matrix(quaternions), rotation.hat(velocity)
    assert np.abs(turning - matrices @ skew).max() < 10 * ROUNDING
    assert np.abs(turning - skew @ matrices).max() > 0.1
    pure = np.concatenate([np.zeros((200, 1)), velocity], axis=-1)
    assert np.abs(rates - 0.5 * rotation.multiply(quaternions, pure)).max() < ROUNDING


def test_from_matrix_returns_the_quaternion_up_to_sign(quaternions):
    special = np.vstack([quaternions, np.eye(4), [[0, 0.6, 0.8, 0], [0, 0, -0.6, 0.8], [1e-9, 0, 0, 1]]])
    back = rotation.from_matrix(rotation.as_matrix(special))
    assert (np.abs(np.abs(np.sum(back * special, axis=1)) - 1.0) < ROUNDING).all()


@pytest.mark.parametrize("angle", [0.0, 1e-300, 1e-12, 1e-3, 1.0, 3.0, *(np.pi - np.array([1e-3, 1e-9, 1e-14]))])
def test_the_shortest_rotation_takes_one_direction_to_another_by_their_angle(angle):
    """Within rounding up to opposite directions, where 1 + a·b would lose every digit."""
    a, across = np.array([2.0, -3.0, 6.0]) / 7.0, np.array([3.0, 6.0, 2.0]) / 7.0
    with mpmath.workdps(40):
        b = np.array([float(mpmath.cos(angle) * x + mpmath.sin(angle) * y) for x, y in zip(a, across, strict=True)])
        half = float(mpmath.cos(mpmath.mpf(angle) / 2))
    q = rotation.shortest_between(1e-200 * a, 1e200 * b)
    assert abs(np.linalg.norm(q) - 1.0) < ROUNDING
    assert np.abs(rotation.rotate(q, a) - b).max() < ROUNDING
    assert abs(q[0] - half) < ROUNDING
    assert abs(q[1:] @ a) < ROUNDING


def test_the_shortest_rotation_between_opposite_directions_is_half_a_turn():
    assert rotation.shortest_between((0.0, 0.0, -1.0), (0.0, 0.0, 1.0)).tolist() == [0.0, 1.0, 0.0, 0.0]
    some = np.random.default_rng(3).normal(size=(50, 3))
    q = rotation.shortest_between(some, -some)
    assert np.abs(rotation.rotate(q, some) + some).max() < 5 * ROUNDING


def test_a_perpendicular_is_a_unit_vector_at_right_angles():
    vectors = np.vstack([np.random.default_rng(4).normal(size=(50, 3)), np.eye(3), [[1e300, 1e-300, 0.0]]])
    found = rotation.perpendicular(vectors)
    scaled = vectors / np.abs(vectors).max(axis=1, keepdims=True)
    assert np.abs(np.linalg.norm(found, axis=1) - 1.0).max() < ROUNDING
    assert np.abs(np.sum(found * scaled, axis=1)).max() < ROUNDING


@pytest.mark.parametrize("angle", [0.0, 1e-300, 1e-9, 9e-4, 1.1e-3, 1.0, 3.0, np.pi - 1e-9])
def test_exponential_and_logarithm(angle):
    axis = np.array([2.0, -3.0, 6.0]) / 7.0
    q = rotation.from_rotation_vector(angle * axis)
    half = mpmath.mpf(angle) / 2
    assert abs(q[0] - mpmath.cos(half)) < ROUNDING
    assert abs(q[1:] @ axis - mpmath.sin(half)) <= ROUNDING * max(angle, 1e-300)
    back = rotation.as_rotation_vector(q)
    assert np.abs(back - angle * axis).max() <= 8 * ROUNDING * max(angle, 1e-300)


def test_exponential_and_logarithm_have_finite_gradients_at_zero():
    with jax.enable_x64(True):
        derivative = jax.jit(jax.jacobian(rotation.from_rotation_vector))(jax.numpy.zeros(3))
        assert np.array_equal(derivative[1:], 0.5 * np.eye(3))
        back = jax.jit(jax.jacobian(rotation.as_rotation_vector))(jax.numpy.array([1.0, 0, 0, 0]))
        assert np.allclose(back[:, 1:], 2.0 * np.eye(3), atol=ROUNDING)


def test_small_angles_between():
    q = rotation.from_rotation_vector([0.3, 0.2, -1.0])
    nearby = rotation.multiply(q, rotation.from_rotation_vector([0.0, 3e-12, 4e-12]))
    # the quaternions themselves are rounded at 1e-16
    assert abs(rotation.angle_between(q, nearby) - 5e-12) < 1e-15
    assert rotation.angle_between(q, -q) < ROUNDING


def test_hat_and_vee():
    v, w = np.array([1.0, 2.0, 3.0]), np.array([-2.0, 0.5, 4.0])
    assert np.allclose(rotation.hat(v) @ w, np.cross(v, w), atol=ROUNDING)
    assert np.array_equal(rotation.vee(rotation.hat(v)), v)


def test_scipy_round_trip(quaternions):
    back = rotation.from_scipy(rotation.as_scipy(quaternions))
    assert np.abs(np.abs(np.sum(back * quaternions, axis=1)) - 1.0).max() < ROUNDING


@pytest.mark.parametrize("sequence", ["ZYX", "XYZ", "YXZ", "ZXZ", "xyz", "zxz", "yzx"])
def test_euler_angles_agree_with_scipy(sequence):
    """SciPy too writes turns about the body's own axes in capitals."""
    angles = np.random.default_rng(3).uniform(-3.0, 3.0, (50, 3))
    wanted = rotation.from_scipy(Rotation.from_euler(sequence, angles))
    assert rotation.angle_between(rotation.from_euler_angles(angles, sequence), wanted).max() < ROUNDING
    with jax.enable_x64(True):
        traced = jax.jit(lambda a: rotation.from_euler_angles(a, sequence))(jax.numpy.asarray(angles))
    assert rotation.angle_between(np.asarray(traced), wanted).max() < ROUNDING


@pytest.mark.parametrize("function", ["conjugate", "normalize", "as_matrix", "as_rotation_vector"])
def test_strict_arrays_and_jax_agree_with_numpy(function, quaternions):
    call = getattr(rotation, function)
    wanted = call(quaternions)
    strict = call(array_api_strict.asarray(quaternions))
    assert np.abs(np.asarray(strict) - wanted).max() < ROUNDING
    with jax.enable_x64(True):
        assert np.abs(np.asarray(jax.jit(call)(jax.numpy.asarray(quaternions))) - wanted).max() < ROUNDING


def test_strict_arrays_through_the_matrix_and_the_exponential(quaternions):
    matrices = array_api_strict.asarray(rotation.as_matrix(quaternions))
    back = np.asarray(rotation.from_matrix(matrices))
    assert np.abs(np.abs(np.sum(back * quaternions, axis=1)) - 1.0).max() < ROUNDING
    vectors = array_api_strict.asarray(quaternions[:, 1:])
    shortest = rotation.shortest_between(vectors, rotation.perpendicular(vectors))
    assert np.abs(np.asarray(shortest)[:, 0] - np.sqrt(0.5)).max() < ROUNDING
    assert np.abs(np.asarray(rotation.from_rotation_vector(vectors)) ** 2).sum(axis=1) == pytest.approx(1.0)


def test_limits_have_two_sides():
    limits, x = rotation.LIMITS, (1.0, 0.0, 0.0)
    rotation.rotate((1.0 + 0.9 * limits.max_length_error, 0.0, 0.0, 0.0), x)
    with pytest.raises(InvalidInput, match="must have length 1"):
        rotation.rotate((1.0 + 1.1 * limits.max_length_error, 0.0, 0.0, 0.0), x)
    rotation.from_matrix(np.diag([1.0 + 0.4 * limits.max_orthogonality_error, 1.0, 1.0]))  # its square counts
    with pytest.raises(InvalidInput, match="must be orthogonal"):
        rotation.from_matrix(np.diag([1.0 + 0.6 * limits.max_orthogonality_error, 1.0, 1.0]))
    within, beyond = (rotation.shortest_between(x, (-1.0, k * limits.max_sum_of_opposite, 0.0)) for k in (0.9, 1.1))
    assert within[0] == 0.0 < beyond[0]


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda: rotation.normalize([0.0, 0, 0, 0]), "zero"),
        (lambda: rotation.from_matrix(2.0 * np.eye(3)), "orthogonal"),
        (lambda: rotation.from_matrix(np.diag([1.0, 1.0, -1.0])), "reflection"),
        (lambda: rotation.as_matrix([1.0, 0, 0]), "shape"),
        (lambda: rotation.as_matrix(np.ones(4, dtype=np.float32)), "float64"),
        (lambda: rotation.from_axis_angle([0.0, 0, 0], 1.0), "direction"),
        (lambda: rotation.shortest_between([0.0, 0, 0], [1.0, 0, 0]), "`start`.*direction"),
        (lambda: rotation.perpendicular([1.0, 0]), "shape"),
        (lambda: rotation.from_euler_angles([1.0, 0], "ZYX"), "shape"),
        (lambda: rotation.from_euler_angles([1.0, 0, 0], "ZZX"), "no two alike"),
        (lambda: rotation.from_euler_angles([1.0, 0, 0], "ZyX"), "capitals"),
    ],
)
def test_bad_input(call, words):
    with pytest.raises(InvalidInput, match=words):
        call()
