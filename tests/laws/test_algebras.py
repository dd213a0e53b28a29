"""Every algebra obeys its laws; one flipped structure constant, and they say so."""

import jax.numpy as jnp
import numpy as np
import pytest

from polhode import algebra as lie
from polhode import fields
from polhode.testing import LawBroken, check_algebra
from specimens import ALGEBRAS
from sweeping import first

SLOW = (lie.Product, lie.Semidirect, lie.SO, lie.SL, lie.Sp, lie.AffineLine, lie.DualNumbers, lie.SOpq,
        fields.QuantizedSphere, lie.ConstantsAlgebra, lie.U)  # fmt: skip


def one_of_each_class_at_once():
    """The smallest of each class, but for those that are compiled for long; these and the others in the sweep.

    Of matrices SU stands for all: its are complex.
    """
    smallest = {}
    for algebra in sorted(ALGEBRAS, key=lambda a: a.dim):
        if algebra.dim > 1 and type(algebra) not in SLOW:
            smallest.setdefault(type(algebra), algebra)
    for algebra in ALGEBRAS:
        slow = [] if algebra is smallest.get(type(algebra)) else [pytest.mark.sweep]
        yield pytest.param(algebra, id=algebra.name, marks=slow)


@pytest.mark.long
@pytest.mark.parametrize("algebra", list(one_of_each_class_at_once()))
def test_laws(algebra):
    check_algebra(algebra)


class Flipped(lie.SO3):
    """so(3) with one structure constant of the wrong sign."""

    def bracket(self, x, y):
        return jnp.cross(x, y) * jnp.array([1.0, 1.0, -1.0])


class Undual(lie.SO3):
    """so(3) with the coadjoint map of the other sign."""

    def coadjoint(self, x, mu):
        return jnp.cross(x, mu)


class Leaking(lie.SO3):
    """so(3) with a Casimir that is none."""

    def casimirs(self, mu):
        return mu[..., :1]


class Loose(lie.SO3):
    """so(3) whose exponential turns a little too far."""

    def exp_change(self, x, mu):
        return super().exp_change(x * (1 + 1e-10), mu)


class Swapped(lie.SO3):
    """so(3) whose group elements are multiplied in the wrong order."""

    def compose(self, g, h):
        return super().compose(h, g)


@pytest.mark.parametrize(
    ("broken", "law"),
    [(Swapped, "Ad"), (Flipped, "Jacobi|duality"), (Undual, "duality"), (Leaking, "Casimirs"), (Loose, "exp_change")],
)
def test_broken_specimens_are_caught(broken, law):
    with pytest.raises(LawBroken, match=law):
        check_algebra(broken())


def test_nan_is_caught():
    class Undefined(lie.SO3):
        def bracket(self, x, y):
            return jnp.cross(x, y) * jnp.nan

    with pytest.raises(LawBroken):
        check_algebra(Undefined())


@pytest.mark.parametrize("algebra", first(3, [a for a in ALGEBRAS if a.dim <= 10]), ids=lambda a: a.name)
def test_index_is_the_corank_of_the_poisson_tensor(algebra):
    vector = np.random.default_rng(1).normal(size=algebra.dim)
    rank = np.linalg.matrix_rank(algebra.structure_constants() @ vector, tol=1e-9)
    assert lie.index(algebra) == algebra.dim - rank


def test_su2_is_so3_and_so4_is_twice_so3():
    assert lie.SU(2).structure_constants() == pytest.approx(lie.SO3().structure_constants(), abs=1e-15)
    forms = np.linalg.eigvalsh(lie.killing_form(lie.SO(4)))
    assert forms == pytest.approx(-4.0 * np.ones(6))


def test_centres():
    assert len(lie.centre(lie.SU(3))) == 0 and len(lie.centre(lie.AffineLine())) == 0
    assert np.abs(lie.centre(lie.Heisenberg(2))) == pytest.approx(np.eye(5)[4:])
    assert len(lie.centre(lie.SO(2))) == 1


def test_killing_form_tells_semisimple_algebras():
    assert np.linalg.matrix_rank(lie.killing_form(lie.SL(3))) == 8
    assert np.linalg.matrix_rank(lie.killing_form(lie.SE3())) == 3
    assert not lie.killing_form(lie.Heisenberg(1)).any()
    assert (np.linalg.eigvalsh(lie.killing_form(lie.SL(2))) > 0).sum() == 2  # not compact
