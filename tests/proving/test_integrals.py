"""Polynomial integrals against the published ones, and none where there is none."""

import math

import jax.numpy as jnp
import numpy as np
import pytest
import sympy

from polhode.algebra import SE3, SO3
from polhode.errors import InvalidInput
from polhode.proving import LiePoissonBracket, SymbolicSystem, polynomial_integrals
from polhode.proving.symbolic.derivations import clebsch
from polhode.systems import BrunBody, FreeRigidBody, Gyrostat, HeavyTop, Kirchhoff, LiePoisson, Manakov

X = sympy.symbols("x1:7", real=True)
a1, a2, a3, theta = sympy.symbols("a1 a2 a3 theta", positive=True)
BRACKET = LiePoissonBracket(SE3(), X, parameters=["a", a1, a2, a3, theta])


def span_of(expressions, wanted):
    """Whether a polynomial is a linear combination of others."""
    x = sorted(set().union(*(sympy.sympify(e).free_symbols for e in [*expressions, wanted])), key=str)
    polys = [sympy.Poly(e, *x) for e in [*expressions, wanted]]
    monomials = sorted({m for p in polys for m in p.monoms()})
    matrix = sympy.Matrix([[p.coeff_monomial(m) for m in monomials] for p in polys])
    return matrix.rank() == matrix[:-1, :].rank()


def test_clebsch_has_the_published_ratio():
    """For a = (1, 1/2, 1/4), θ = 1.3: |Π|² − Σ c P² with c ∝ (.54167, −.10833, −.43333) modulo |P|².

    The numbers follow from Clebsch's condition with b_i = θ a_j a_k: c_i = θ a_i less its mean.
    """
    system = Kirchhoff(clebsch.inertia((1.0, 0.5, 0.25), 1.3))
    (F,) = polynomial_integrals(system, 2)
    H = SymbolicSystem.from_system(system).hamiltonian
    poly = sympy.Poly(F, *X)
    # bring the squares of Π to |Π|² with H, which is found up to
    angular = [[poly.coeff_monomial(v**2) for v in X[:3]], [H.coeff(v, 2) for v in X[:3]]]
    weights = sympy.Matrix([*angular, [1, 1, 1]]).T.nullspace()[0]
    full = F * weights[0] + H * weights[1]
    assert [sympy.expand(full).coeff(v, 2) for v in X[:3]] == [-weights[2]] * 3
    c = np.array([float(sympy.expand(full).coeff(v, 2)) for v in X[3:]])
    c -= c.mean()
    assert np.allclose(c / c[0], np.array([0.54167, -0.10833, -0.43333]) / 0.54167, atol=2e-5)


def test_clebsch_in_symbols():
    a, b = (a1, a2, a3), (theta * a2 * a3, theta * a3 * a1, theta * a1 * a2)
    H = sum(n * v**2 for n, v in zip((*a, *b), X, strict=True)) / 2
    system = SymbolicSystem(BRACKET, H)
    (F,) = polynomial_integrals(system, 2)
    published = sum(v**2 for v in X[:3]) - theta * sum(n * v**2 for n, v in zip(a, X[3:], strict=True))
    assert system.is_integral(F) and system.is_integral(published)
    place = {a1: 2, a2: 3, a3: 5, theta: 7}
    known = [F, H, sum(v**2 for v in X[3:])]
    assert span_of([sympy.expand(k.subs(place)) for k in known], sympy.expand(published.subs(place)))
    # off Clebsch's condition there is none
    assert polynomial_integrals(SymbolicSystem(BRACKET, H + a1 * X[3] ** 2), 2) == []


@pytest.mark.long
def test_brun_has_the_integral_of_the_system():
    body = BrunBody((1.0, 2.0, 4.0), 1.3)
    (F,) = polynomial_integrals(body, 2)
    H = SymbolicSystem.from_system(body).hamiltonian
    e = sympy.Rational(1.3)
    published = sum(v**2 for v in X[:3]) - 8 * e * (X[3] ** 2 + X[4] ** 2 / 2 + X[5] ** 2 / 4)
    assert span_of([F, H, sum(v**2 for v in X[3:])], published)


@pytest.mark.long
def test_kovalevskaya_at_degree_four():
    for moments, mgl, axis in (
        ((2.0, 2.0, 1.0), 1.0, (1.0, 0.0, 0.0)),
        ((2 * math.pi, 2 * math.pi, math.pi), math.sqrt(2.0), (0.6, 0.8, 0.0)),
        ((2.2468, 2.2468, 1.1234), 0.7, (0.0, 1.0, 0.0)),
    ):
        top = HeavyTop(moments, mgl, axis)
        result = polynomial_integrals(top, 4)
        assert len(result) == 1 and polynomial_integrals(top, 3) == []
        # against the integral of the numerical top: a combination of products of energy, Casimirs and what was found
        z = np.random.default_rng(0).normal(size=(40, 6))
        (mine,) = (sympy.lambdify(X, F)(*z.T) for F in result)
        energy, up, vertical = np.asarray(top.energy(z)), (z[:, 3:] ** 2).sum(1), (z[:, :3] * z[:, 3:]).sum(1)
        columns = np.stack([mine, energy, energy**2, up, up**2, energy * up, vertical, vertical**2], axis=1)
        columns /= np.abs(columns).max(axis=0)
        (kovalevskaya,) = (np.asarray(f(z)) for f in top.extra_invariants.values())
        fit = np.linalg.lstsq(columns, kovalevskaya, rcond=None)[0]
        assert np.abs(columns @ fit - kovalevskaya).max() < 1e-11 * np.abs(kovalevskaya).max()


@pytest.mark.long_after(2)
@pytest.mark.parametrize("system", [
    HeavyTop((1.0, 2.0, 2.5), 1.0, (0.6, 0.0, 0.8)),
    HeavyTop((2.0, 2.0, 1.1), 1.0, (1.0, 0.0, 0.0)),  # near Kovalevskaya's
    HeavyTop((2.0, 2.0, 1.0), 1.0, (0.6, 0.0, 0.8)),
    Kirchhoff((1.0, 2.0, 3.0, 2.0, 3.0, 5.0)),
    FreeRigidBody((1.0, 2.0, 3.0)),
], ids=lambda s: type(s).__name__)  # fmt: skip
def test_none_for_a_generic_system(system):
    assert polynomial_integrals(system, 4) == []


def test_goryachev_and_chaplygin_is_none():
    """Theirs holds on Π·Γ = 0 alone, so that it is no integral."""
    assert polynomial_integrals(HeavyTop((4.0, 4.0, 1.0), 1.0, (1.0, 0.0, 0.0)), 3) == []


@pytest.mark.long
def test_integrals_of_symmetry():
    assert polynomial_integrals(HeavyTop((1.0, 1.0, 0.4), 1.0), 4) == [X[2]]
    assert polynomial_integrals(Gyrostat((2.0, 2.0, 3.0), (0.0, 0.0, 0.3)), 2) == [X[2]]
    assert len(polynomial_integrals(HeavyTop((1.0, 2.0, 2.5), 0.0), 2)) == 1  # Euler's |Π|²
    # with three equal moments L3 is the difference of energy and Casimir
    assert polynomial_integrals(Gyrostat((2.0, 2.0, 2.0), (0.0, 0.0, 0.3)), 1) == []


@pytest.mark.long
def test_manakov_in_four_dimensions():
    body = Manakov((1.0, 2.0, 3.0, 4.5))
    (F,) = polynomial_integrals(body, 2)
    z = np.random.default_rng(0).normal(size=(20, 6))
    points = body.algebra.from_dual_vector(z)
    columns = np.column_stack([sympy.lambdify(X, F)(*z.T), body.energy(points), body.algebra.casimirs(points)])
    of_degree_two = [f for name, f in body.extra_invariants.items() if name in ("s^1 of tr (M + sΛ²)^3",
                                                                               "s^2 of tr (M + sΛ²)^4")]  # fmt: skip
    assert len(of_degree_two) == 2
    for wanted in of_degree_two:
        values = np.asarray(wanted(points))
        fit = np.linalg.lstsq(columns, values, rcond=None)[0]
        assert np.abs(columns @ fit - values).max() < 1e-12 * np.abs(values).max()


@pytest.mark.parametrize(("make", "degree", "message"), [
    (lambda: FreeRigidBody((1.0, 2.0, 3.0)), 0, "at least 1"),
    (lambda: FreeRigidBody((1.0, 2.0, 3.0)), -1, "at least 1; got -1"),
    (lambda: FreeRigidBody((1.0, 2.0, 3.0)), 1.5, "whole number"),
    (lambda: Manakov((1.0, 2.0, 3.0, 4.5)), 20, "monomials"),
    (lambda: SymbolicSystem(BRACKET, sympy.sqrt(X[0])), 2, "polynomial"),
    (lambda: SymbolicSystem(BRACKET, sympy.Symbol("a") * X[0] ** 2), 5, "has symbols"),
    (lambda: SymbolicSystem(BRACKET, sympy.sin(sympy.Symbol("a")) * X[0] ** 2), 2, "rational functions"),
    (lambda: LiePoisson(SO3(), lambda z: jnp.sin(z[0])), 2, "must be a polynomial to be read exactly; it has sine"),
    (lambda: "a top", 2, "Lie–Poisson system"),
])  # fmt: skip
def test_mistakes_are_named(make, degree, message, any_type):
    with pytest.raises(InvalidInput, match=message):
        polynomial_integrals(make(), degree)
