"""Algebras that contain an so(3) carry an attitude: against SciPy's integration of R' = R hat(Ω), and closed forms."""

from functools import cache

import jax
import jax.numpy as jnp
import numpy as np
import pytest
from scipy.integrate import solve_ivp

import polhode as ph
from polhode import rotation
from polhode.algebra.base import AbstractLieAlgebra
from polhode.errors import InvalidInput
from polhode.formats.dataset import write_dataset
from polhode.formats.dataset_reading import read_dataset
from polhode.testing import check_system

lie = ph.algebra
TIMES = np.linspace(0.0, 5.0, 11)
ROUNDING = 1e-12
"""Of ours and of SciPy's DOP853 at 1e-13, over five seconds."""
MOMENTS = jnp.array([1.0, 2.0, 3.0])
ATTITUDE = np.array([0.5, -0.5, 0.1, 0.7])
HAT = lie.SO3().structure_constants().transpose(0, 2, 1)
"""(e_i)^ (3, 3, 3), so that HAT_i v = e_i × v."""


def so4():
    """Turns L and K with [L, L] = L, [L, K] = K, [K, K] = L: the K are no ideal."""
    c, epsilon = np.zeros((6, 6, 6)), lie.SO3().structure_constants()
    c[:3, :3, :3] = c[:3, 3:, 3:] = c[3:, :3, 3:] = c[3:, 3:, :3] = epsilon
    return c


def magnetic_top():
    """A body with two vectors of space, the vertical and a field: so(3) ⋉ R⁶, on which no system of ours is."""
    blocks = np.zeros((3, 6, 6))
    blocks[:, :3, :3] = blocks[:, 3:, 3:] = HAT
    algebra = lie.Semidirect(lie.SO3(), blocks, casimirs=[], rotations=(0, 1, 2))
    return ph.systems.LiePoisson(
        algebra, lambda m: 0.5 * jnp.sum(m[:3] ** 2 / MOMENTS) + 0.8 * m[5] + 0.5 * m[6])  # fmt: skip


def four_dimensional():
    algebra = lie.from_structure_constants(so4(), casimirs=[], rotations=(0, 1, 2))
    inverse = jnp.array([1.0, 0.5, 0.3, 0.4, 0.7, 0.2])
    return ph.systems.LiePoisson(algebra, lambda m: 0.5 * jnp.sum(inverse * m**2) + 0.2 * m[0] * m[4])


POINTS = {magnetic_top: [0.3, 1.0, 2.0, 0.1, 0.2, 0.9, 0.8, -0.3, 0.4],
          four_dimensional: [0.3, 1.0, 2.0, 0.5, -0.4, 1.2]}  # fmt: skip


@cache
def by_scipy(make):
    """Return rotation matrices and points by DOP853, from the constants of the algebra and the gradient of H alone."""
    system, start = make(), start_of(make)
    c, velocity = np.asarray(system.algebra.structure_constants()), jax.jit(system.velocity)

    def rate(t, y):
        R, mu = y[:9].reshape(3, 3), y[9:]
        xi = np.asarray(velocity(mu))
        hat = np.array([[0.0, -xi[2], xi[1]], [xi[2], 0.0, -xi[0]], [-xi[1], xi[0], 0.0]])
        return np.concatenate([(R @ hat).ravel(), np.einsum("i,k,ijk->j", xi, mu, c)])

    begin = np.concatenate([rotation.as_matrix(start[:4]).ravel(), start[4:]])
    found = solve_ivp(rate, (0.0, TIMES[-1]), begin, method="DOP853", rtol=1e-13, atol=1e-13, t_eval=TIMES)
    return found.y[:9].T.reshape(-1, 3, 3), found.y[9:].T


def start_of(make):
    return np.concatenate([ATTITUDE, POINTS[make]])


@pytest.mark.long_after(1)
@pytest.mark.parametrize("make", POINTS)
def test_the_attitude_is_that_of_scipy(make):
    system, start = make(), start_of(make)
    matrices, points = by_scipy(make)
    found = ph.simulate(system, start, TIMES)
    assert found.layout.names == ("attitude", "momentum", "point_behind")
    assert np.abs(rotation.as_matrix(found.attitude) - matrices).max() < ROUNDING
    assert np.abs(found.momentum - points[:, :3]).max() < ROUNDING
    assert np.abs(found.angular_velocity - np.asarray(system.velocity(points))[:, :3]).max() < ROUNDING
    # the test sees a rotation the wrong way round
    assert np.abs(rotation.as_matrix(rotation.conjugate(found.attitude)) - matrices).max() > 0.1
    stepped = ph.simulate(system, start, TIMES, ph.integrators.LieMidpoint)
    assert np.abs(rotation.as_matrix(stepped.attitude) - matrices).max() < ROUNDING


@pytest.mark.long
@pytest.mark.parametrize("make", POINTS)
def test_laws(make):
    check_system(make())


@pytest.mark.long
def test_methods_of_order_four_whose_stages_need_an_ideal():
    top, start = magnetic_top(), start_of(magnetic_top)
    matrices, _ = by_scipy(magnetic_top)
    errors = [np.abs(rotation.as_matrix(ph.simulate(
        top, start, TIMES, ph.integrators.MuntheKaas, step=step, estimate_error=False).attitude) - matrices).max()
        for step in (0.1, 0.05)]  # fmt: skip
    assert 3.7 < np.log2(errors[0] / errors[1]) < 4.3
    start = start_of(four_dimensional)
    with pytest.raises(InvalidInput, match="`MuntheKaas` of order 4 has no attitude"):
        ph.simulate(four_dimensional(), start, TIMES, ph.integrators.MuntheKaas)
    assert ph.simulate(four_dimensional(), start[4:], TIMES, ph.integrators.MuntheKaas).attitude is None


def test_a_heavy_top_on_an_algebra_of_ones_own():
    own = lie.Semidirect(lie.SO3(), HAT, rotations=(0, 1, 2))
    top = ph.systems.HeavyTop(MOMENTS, 1.3, (0.6, 0.0, 0.8))
    start = np.asarray(top.pack(attitude=(1.0, 0.0, 0.0, 0.0), angular_velocity=(0.3, 1.0, 0.1)))
    found = ph.simulate(ph.systems.LiePoisson(own, top.energy), start, TIMES)
    wanted = ph.simulate(top, start, TIMES)
    assert np.abs(found.attitude - wanted.attitude).max() < ROUNDING
    assert "momentum_space" not in found.invariants  # gravity turns it


def test_an_so3_behind_other_components():
    """A free body beside an oscillator: its momentum in space stays, and the closed form has its attitude."""
    both = lie.Product(lie.Heisenberg(1), lie.SO3(), rotations=(3, 4, 5))
    system = ph.systems.LiePoisson(both, lambda m: 0.5 * (m[0] ** 2 + m[1] ** 2 + jnp.sum(m[3:] ** 2 / MOMENTS)))
    momentum = np.array([0.3, 1.0, 2.0])
    found = ph.simulate(system, np.concatenate([ATTITUDE, [1.0, 0.5, 1.0], momentum]), TIMES)
    assert found.layout.names == ("attitude", "point_before", "momentum")
    body = ph.FreeMotion(np.asarray(MOMENTS), momentum=momentum, attitude=ATTITUDE)
    assert np.abs(found.attitude - body.attitude(TIMES)).max() < ROUNDING
    assert found.drift["momentum_space"] < ROUNDING


class Own(AbstractLieAlgebra):
    """so(3) and a number that commutes, with components that are said to turn."""

    said: tuple[int, ...] = (1, 2, 3)

    @property
    def dim(self):
        return 4

    @property
    def rotations(self):
        return self.said

    def bracket(self, x, y):
        turned = jnp.cross(x[..., 1:], y[..., 1:])
        return jnp.concatenate([jnp.zeros_like(turned[..., :1]), turned], axis=-1)

    def coadjoint(self, x, mu):
        turned = jnp.cross(mu[..., 1:], x[..., 1:])
        return jnp.concatenate([jnp.zeros_like(turned[..., :1]), turned], axis=-1)


def free(m):
    return 0.5 * jnp.sum(m[1:] ** 2 / MOMENTS) + m[0] * m[1]


def test_a_class_of_ones_own_is_checked_where_a_system_takes_it():
    found = ph.simulate(ph.systems.LiePoisson(Own(), free), [1.0, 0.0, 0.0, 0.0, 0.2, 0.3, 1.0, 2.0], TIMES)
    rates = found.momentum / np.asarray(MOMENTS) + np.array([0.2, 0.0, 0.0])
    assert found.angular_velocity == pytest.approx(rates, abs=ROUNDING) and found.drift["momentum_space"] < ROUNDING
    with pytest.raises(InvalidInput, match=r"\[e_0, e_1\] = 0, counted from 0"):
        ph.systems.LiePoisson(Own((0, 1, 2)), free)


@pytest.mark.usefixtures("any_type")
@pytest.mark.parametrize(("rotations", "words"), [
    ((0, 1), "must be three components one behind the other, from .* of the 6 that the algebra has; got"),
    ((0, 2, 1), "one behind the other"), ((4, 5, 6), "one behind the other"), ((-3, -2, -1), "one behind the other"),
    ((0.5, 1.5, 2.5), "one behind the other"), ("abc", "one behind the other"), (2, "one behind the other"),
    ((3, 4, 5), r"those of so\(3\), \[e_3, e_4\] = e_5 and so on; here \[e_3, e_4\] = 1 e_2, counted from 0"),
])  # fmt: skip
def test_components_that_are_no_so3(rotations, words):
    with pytest.raises(InvalidInput, match=words):
        lie.from_structure_constants(so4(), casimirs=[], rotations=rotations)


def test_factors_of_the_brackets_count():
    with pytest.raises(InvalidInput, match=r"here \[e_0, e_1\] = 2 e_2"):
        lie.from_structure_constants(2.0 * lie.SO3().structure_constants(), rotations=(0, 1, 2))
    turns = lie.from_matrices(HAT, rotations=(0, 1, 2))
    assert turns.rotations == (0, 1, 2) and lie.from_matrices(HAT).rotations == ()


def test_right_invariant_systems_and_those_that_say_nothing_have_none():
    own = lie.Semidirect(lie.SO3(), HAT, rotations=(0, 1, 2))
    for system in (ph.systems.LiePoisson(own, free_of_six, sign=1),
                   ph.systems.LiePoisson(lie.Semidirect(lie.SO3(), HAT), free_of_six)):  # fmt: skip
        with pytest.raises(InvalidInput, match=r"must have shape \(…, 6\)"):
            ph.simulate(system, np.ones(10), TIMES)
    assert ph.simulate(system, np.ones(6), TIMES).layout.names == ("point",)


def free_of_six(m):
    return 0.5 * jnp.sum(m[:3] ** 2 / MOMENTS)


def test_pages_and_files(tmp_path):
    found = ph.simulate(magnetic_top(), start_of(magnetic_top), TIMES)
    page = ph.write_page(found, tmp_path / "own.html")
    assert "<script" in page.read_text("utf-8")
    again = read_dataset(write_dataset(found, tmp_path / "own.nc"))
    assert np.array_equal(again.states, found.states) and again.layout == found.layout
    assert np.array_equal(again.angular_velocity, found.angular_velocity)
