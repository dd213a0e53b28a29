"""Bodies: laws of composition, moments against mpmath, and deterministic axes."""

import itertools
import warnings

import array_api_strict as strict
import mpmath
import numpy as np
import pytest

import polhode as ph
from polhode.bodies._inertia import principal_axes
from polhode.errors import InvalidInput

EXACT = 1e-14
"""A few roundings on sums of some terms, relative."""
MOMENT = 16 * np.finfo(float).eps
"""Relative error of a moment: six sweeps of three rotations, each a rounding or two."""


def test_a_box_from_its_pieces_is_the_box():
    whole = ph.shapes.box(6.0, (1.0, 2.0, 3.0))
    pieces = [ph.shapes.box(2.0, (1.0, 2.0, 1.0)).placed((1, 0, 0, 0), (5.0, 0.0, z)) for z in (-1.0, 0.0, 1.0)]
    together = ph.combine(pieces)
    assert together.inertia == pytest.approx(whole.inertia, abs=EXACT * 10)
    assert together.center_of_mass == pytest.approx([5.0, 0.0, 0.0], abs=EXACT)
    forgotten = sum(piece.inertia for piece in pieces)
    assert np.abs(forgotten - whole.inertia).max() > 1.0


def test_parallel_axis():
    ball = ph.shapes.sphere(2.0, 1.0)
    assert ball.about((0.0, 0.0, 3.0))[0, 0] == pytest.approx(0.8 + 18.0, rel=EXACT)
    assert ball.about((0.0, 0.0, 3.0))[2, 2] == pytest.approx(0.8, rel=EXACT)


def test_turning_a_body_turns_its_axes():
    body = ph.shapes.box(1.0, (1.0, 2.0, 3.0))
    q = ph.rotation.from_rotation_vector([0.3, -0.4, 0.5])
    turned = body.placed(q, (1.0, 2.0, 3.0))
    assert turned.principal_moments == pytest.approx(body.principal_moments, rel=EXACT)
    rebuilt = turned.principal_axes @ np.diag(turned.principal_moments) @ turned.principal_axes.T
    assert rebuilt == pytest.approx(turned.inertia, abs=EXACT)


AWKWARD = [
    np.diag([3.0, 1.0, 2.0]),
    np.diag([2.0, 2.0, 1.0]),
    np.diag([1.0, 1.0, 1.0]),
    np.array([[2.0, 1e-17, 0], [1e-17, 2.0, 0], [0, 0, 3.0]]),
    np.array([[2.0, 0.3, 0.1], [0.3, 2.5, -0.2], [0.1, -0.2, 3.0]]),
    np.eye(3) - np.ones((3, 3)) / 6.0,  # symmetric about (1, 1, 1): no given axis is nearer than another
]


@pytest.mark.parametrize("inertia", AWKWARD)
def test_axes_are_right_handed_and_do_not_move_with_rounding(inertia):
    body = ph.Body(1.0, (0, 0, 0), inertia)
    axes = body.principal_axes
    assert np.linalg.det(axes) == pytest.approx(1.0)
    assert axes.T @ axes == pytest.approx(np.eye(3), abs=EXACT)
    assert axes @ np.diag(body.principal_moments) @ axes.T == pytest.approx(inertia, abs=EXACT * 3)
    for signs in itertools.product((-1, 0, 1), repeat=3):
        noise = 1e-15 * np.array([[0.0, signs[0], signs[1]], [signs[0], 0, signs[2]], [signs[1], signs[2], 0]])
        again = ph.Body(1.0, (0, 0, 0), inertia + noise)
        assert again.principal_axes == pytest.approx(axes, abs=1e-12)
        assert again.principal_moments == pytest.approx(body.principal_moments, rel=EXACT)


def test_bare_eigenvectors_would_move_with_rounding():
    noise = 1e-15 * np.array([[0.0, 1, 0], [1, 0, 0], [0, 0, 0]])
    moved = np.linalg.eigh(np.diag([2.0, 2.0, 3.0]) + noise)[1] - np.eye(3)
    assert np.abs(moved).max() > 0.1


@pytest.mark.parametrize("seed", range(20))
def test_moments_and_axes_against_mpmath(seed):
    rng = np.random.default_rng(seed)
    second_moments = np.diag(rng.uniform(0.1, 1.0, 3)) * 10.0 ** rng.uniform(-8, 8)
    turn = ph.rotation.as_matrix(ph.rotation.normalize(rng.normal(size=4)))
    inertia = turn @ (np.trace(second_moments) * np.eye(3) - second_moments) @ turn.T
    body = ph.Body(1.0, (0, 0, 0), 0.5 * (inertia + inertia.T))
    with mpmath.workdps(40):
        values, vectors = mpmath.eigsy(mpmath.matrix(body.inertia.tolist()))
    for k in range(3):
        assert abs(body.principal_moments[k] - values[k]) <= MOMENT * values[2]
        overlap = sum(float(vectors[i, k]) * body.principal_axes[i, k] for i in range(3))
        assert abs(overlap) == pytest.approx(1.0, abs=1e-12)


def graded(small, place):
    """Return an inertia with one small moment, fixed to full relative accuracy by its entries."""
    size = np.ones(3)
    size[place] = np.sqrt(small)
    return np.array([[2.0, 0.2, 0.3], [0.2, 1.9, 0.1], [0.3, 0.1, 2.1]]) * size * size[:, None]


@pytest.mark.parametrize("small", [1e-6, 1e-12, 1e-18, 1e-24])
@pytest.mark.parametrize("place", [0, 1, 2])
def test_small_moments_are_relatively_accurate_where_the_entries_fix_them(small, place):
    moments, _ = principal_axes(graded(small, place))
    with mpmath.workdps(80):
        exact = mpmath.eigsy(mpmath.matrix(graded(small, place).tolist()), eigvals_only=True)[0]
    assert abs(moments[0] / exact - 1) <= MOMENT


def test_the_usual_eigenvalues_would_lose_small_moments():
    with mpmath.workdps(80):
        exact = mpmath.eigsy(mpmath.matrix(graded(1e-18, 1).tolist()), eigvals_only=True)[0]
    assert abs(np.linalg.eigvalsh(graded(1e-18, 1))[0] / float(exact) - 1) > 1e-3


def test_a_turned_symmetric_body_stays_symmetric_and_a_turned_rod_thin():
    rng = np.random.default_rng(5)
    for _ in range(50):
        q = ph.rotation.normalize(rng.normal(size=4))
        cylinder = ph.shapes.cylinder(1.0, 1.0, 3.0).placed(q).principal_moments
        assert cylinder[1] == cylinder[2] == pytest.approx(1.0, rel=EXACT)
        ball = ph.shapes.sphere(1.0, 1.0).placed(q)
        assert ball.principal_moments[0] == ball.principal_moments[2]
        assert np.abs(ball.principal_axes - np.eye(3)).max() < EXACT
        rod = ph.shapes.rod(1.0, 1.0).placed(q).principal_moments
        assert rod[0] == 0.0
        assert rod[1] == rod[2]


def test_a_nearly_symmetric_body_is_not_taken_for_symmetric():
    body = ph.Body.from_moments((1.0, 1.0 + 1e-12, 1.5)).placed(ph.rotation.from_rotation_vector([0.3, 0.4, 0.5]))
    assert body.principal_moments[1] - body.principal_moments[0] == pytest.approx(1e-12, rel=1e-2)
    exact = ph.Body.from_moments((1.0, np.nextafter(1.0, 2.0), 1.5)).principal_moments
    assert exact[1] > exact[0]


@pytest.mark.parametrize("order", list(itertools.permutations((1.0, 2.5, 3.0))))
def test_given_axes_of_moments_are_kept(order):
    body = ph.Body.from_moments(order)
    assert body.principal_moments.tolist() == body.moments.tolist() == [1.0, 2.5, 3.0]
    assert np.diag(body.inertia).tolist() == list(order)
    for k, moment in enumerate((1.0, 2.5, 3.0)):
        assert np.abs(body.principal_axes[:, k]).tolist() == [float(value == moment) for value in order]
    assert np.linalg.det(body.principal_axes) == 1.0


def test_a_body_takes_the_moments_that_a_motion_takes():
    for moments in ((3.0, 1.0, 2.5), [3.0, 1.0, 2.5], np.array([3.0, 1.0, 2.5])):
        body, motion = ph.Body.from_moments(moments, 2.0), ph.FreeMotion(moments, momentum=(0.0, 0.0, 1.0))
        assert body.mass == 2.0
        assert np.diag(body.inertia).tolist() == np.asarray(motion.moments).tolist()
    with pytest.raises(TypeError):
        ph.Body.from_moments(3.0, 1.0, 2.5)  # pyright: ignore  # as it was called once
    with pytest.raises(InvalidInput, match="shape"):
        ph.Body.from_moments(3.0)


def test_a_body_cannot_change_under_its_cached_axes():
    body = ph.Body(1.0, (0, 0, 0), np.diag([1.0, 2, 2.5]))
    for array in (body.inertia, body.center_of_mass, body.principal_moments, body.principal_axes):
        with pytest.raises(ValueError, match="read-only"):
            array[0] = 7.0


def test_other_arrays_are_converted():
    import array_api_strict
    import jax

    inertia = np.array([[2.0, 0.3, 0.1], [0.3, 2.5, -0.2], [0.1, -0.2, 3.0]])
    wanted = ph.Body(1.0, (0, 0, 0), inertia).principal_moments
    with jax.enable_x64(True):
        lifted = jax.numpy.asarray(inertia)
    for other in (lifted, array_api_strict.asarray(inertia), inertia.tolist()):
        assert ph.Body(1.0, (0, 0, 0), other).principal_moments.tolist() == wanted.tolist()
    with pytest.raises(InvalidInput, match="traced"):
        jax.jit(lambda x: ph.Body(1.0, (0, 0, 0), x * np.eye(3)).principal_moments)(2.0)


@pytest.mark.parametrize(
    ("make", "words"),
    [
        (lambda: ph.Body.from_moments((1.0, 1.0, 3.0)), "I1 \\+ I2 ≥ I3"),
        (lambda: ph.Body.from_moments((-1.0, 2.0, 2.0)), "negative"),
        (lambda: ph.Body.from_moments((np.nan, 2.0, 2.0)), "finite"),
        (lambda: ph.Body.from_moments((0.0, 0.0, 0.0)), "vanish"),
        (lambda: ph.Body(-1.0, (0, 0, 0), np.eye(3)), "mass"),
        (lambda: ph.Body(1.0, (0, 0, 0), [[1, 1, 0], [0, 1, 0], [0, 0, 1]]), "symmetric"),
        (lambda: ph.Body.from_moments((1, 1, 1)).about((0, 0, 1)), "mass"),
        (lambda: ph.combine([]), "at least one"),
        (lambda: ph.combine([3.0]), "Body objects"),
        (lambda: ph.combine([ph.Body.from_moments((1, 1, 1))]), "mass"),
        (lambda: ph.Body(1.0, (0, 0), np.eye(3)), "shape"),
        (lambda: ph.Body(1.0, (0, 0, 0), np.eye(3) * (1 + 1j)), "complex"),
        (lambda: ph.Body(1.0, (0, 0, 0), np.eye(3, dtype=np.float32)), "float32"),
        (lambda: ph.Body(1.0, (0, 0, 0), [[1, 2, 0], [2, 1, 0], [0, 0, 1.0]]), "negative"),
        (lambda: ph.shapes.sphere(1, 1).placed(np.diag([1.0, 1.0, -1.0])), "proper rotation"),
        (lambda: ph.shapes.sphere(1, 1).placed((0.0, 0.0, 0.0, 0.0)), "zero quaternion"),
        (lambda: ph.shapes.sphere(1, 1).placed((1.0, 0.0)), "shape"),
    ],
)
@pytest.mark.usefixtures("any_type")
def test_bad_input(make, words):
    with pytest.raises(InvalidInput, match=words):
        make()


def test_a_rod_is_a_body_but_has_no_free_motion():
    with pytest.raises(InvalidInput, match="zero moment"):
        ph.FreeMotion.from_body(ph.shapes.rod(1.0, 1.0), angular_velocity=(1.0, 2.0, 3.0))


def test_flat_bodies_are_physical_to_rounding():
    assert ph.Body.from_moments((0.1, 0.2, 0.1 + 0.2)).principal_moments[2] > 0.3


def test_arrays_of_other_libraries_are_converted():
    center, inertia = strict.asarray([0.0, 0.0, 1.0]), strict.asarray([[3.0, 1, 0], [1, 3, 0], [0, 0, 3]])
    body = ph.Body(2.0, center, inertia)
    same = ph.Body(2.0, np.asarray(center), np.asarray(inertia))
    assert isinstance(body.inertia, np.ndarray) and (body.principal_moments == same.principal_moments).all()
    points = ph.Body.from_points(strict.asarray([1.0, 2.0, 3.0]), strict.eye(3))
    assert (points.inertia == ph.Body.from_points([1.0, 2.0, 3.0], np.eye(3)).inertia).all()
    assert (ph.shapes.box(1.0, strict.asarray([1.0, 2.0, 3.0])).inertia == ph.shapes.box(1.0, (1, 2, 3)).inertia).all()


def test_placed_takes_a_scipy_rotation_or_only_a_shift():
    from scipy.spatial.transform import Rotation

    body = ph.Body(2.0, (1.0, 0, 0), np.diag([1.0, 2.0, 2.5]))
    turn = Rotation.from_rotvec([0.3, -0.2, 0.9])
    assert (body.placed(turn).inertia == body.placed(turn.as_matrix()).inertia).all()
    moved = body.placed(translation=(0.0, 3.0, 0.0))
    assert moved.center_of_mass.tolist() == [1.0, 3.0, 0.0] and (moved.inertia == body.inertia).all()


@pytest.mark.parametrize(
    "make",
    [
        lambda: ph.Body.from_moments((1e300, 2e300, 3e300)),
        lambda: ph.Body.from_moments((1e-300, 2e-300, 3e-300)),
        lambda: ph.shapes.sphere(1.0, 1.0).placed(translation=(1e200, 0, 0)),
        lambda: ph.shapes.sphere(1.0, 1e200),
        lambda: ph.Body.from_points([1.0, 1.0], [[0, 0, 0], [1e200, 0, 0]]),
        lambda: ph.Body.from_points([1.0, 1.0], [[0, 0, 0], [1, 0]]),
        lambda: ph.Body.from_atoms(["H", "H"], [[0, 0, 0], [1, 0]]),
        lambda: ph.combine(None),
    ],
)
def test_nothing_beyond_the_range_of_bodies_and_no_warning(make, any_type):
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        with pytest.raises(InvalidInput):
            make()
