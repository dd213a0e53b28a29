"""Conditions of stability in symbols against published ones, and against verdicts for numbers."""

import numpy as np
import pytest
import sympy

import polhode as ph
from polhode.algebra import SE3, SO3
from polhode.errors import InvalidInput
from polhode.proving import (
    LiePoissonBracket,
    SymbolicSystem,
    characteristic_polynomial,
    definite_conditions,
    instability,
    linearisation,
    positive_condition,
    second_variation,
)
from polhode.proving.symbolic.sign_conditions import definite_for_some, unstable_condition
from polhode.systems import FreeRigidBody, HeavyTop

I1, I2, I3, S, m, g, ell = sympy.symbols("I1 I2 I3 S m g l", positive=True)
s = sympy.Symbol("s")
a, b, c = sympy.symbols("a b c", real=True)
MOMENTS = (I1, I2, I3)
SO3_ = LiePoissonBracket(SO3(), ["L1", "L2", "L3"], parameters=[I1, I2, I3, S])
SE3_ = LiePoissonBracket(
    SE3(), ["Pi1", "Pi2", "Pi3", "G1", "G2", "G3"], parameters=[I1, I2, I3, S, m, g, ell]
)
BODY = SymbolicSystem(SO3_, sum(x**2 / (2 * i) for x, i in zip(SO3_.coordinates, MOMENTS, strict=True)))


def top(moments):
    x = SE3_.coordinates
    return SymbolicSystem(SE3_, sum(v**2 / (2 * i) for v, i in zip(x, moments, strict=False)) + m * g * ell * x[5])


@pytest.mark.parametrize("axis", range(3))
def test_free_body_is_stable_iff_its_moment_is_strictly_extremal(axis):
    spin = [S if k == axis else 0 for k in range(3)]
    own, first, second = MOMENTS[axis], *(i for k, i in enumerate(MOMENTS) if k != axis)
    result = second_variation(BODY, spin, SO3_.casimirs(2))
    assert result.positive == sympy.And(own > first, own > second)
    assert result.negative == sympy.And(first > own, second > own)
    between = sympy.Or(sympy.And(own > first, second > own), sympy.And(own > second, first > own))
    assert instability(BODY, spin) == between


@pytest.mark.long
def test_free_body_agrees_with_verdicts():
    result = second_variation(BODY, (0, S, 0), SO3_.casimirs(2))
    unstable = instability(BODY, (0, S, 0))
    for moments in np.random.default_rng(0).uniform(0.5, 2.0, size=(4, 3)):
        place = dict(zip(MOMENTS, moments, strict=True))
        verdict = ph.stability(FreeRigidBody(moments), (0.0, 1.3, 0.0)).verdict
        assert (verdict == "stable") == bool(result.definite.subs(place))
        assert (verdict == "unstable") == bool(unstable.subs(place))


@pytest.mark.long
def test_the_sleeping_top_has_the_published_condition():
    sleeping = top((I1, I1, I3))
    point = (0, 0, S, 0, 0, 1)
    result = second_variation(sleeping, point, [*SE3_.casimirs(2), SE3_.coordinates[2]])
    assert result.positive == (S**2 > 4 * I1 * g * ell * m) and result.negative == sympy.false
    assert len(result.free) == 1 and "Longleftarrow" in result.latex()
    # without the spin as an integral only a stronger condition is found: no multiplier is free then
    weaker = second_variation(sleeping, point, SE3_.casimirs(2))
    assert weaker.positive == (I3 * S**2 > I1 * S**2 + I3**2 * g * ell * m)
    for spin, verdict in ((2.1, "stable"), (1.9, "unstable")):
        assert ph.stability(HeavyTop((1.0, 1.0, 0.5), 1.0), (0, 0, spin, 0, 0, 1.0)).verdict == verdict
        assert bool(result.positive.subs({I1: 1, g: 1, ell: 1, m: 1, S: spin})) == (verdict == "stable")


def test_hanging_top_is_always_stable():
    hanging = second_variation(top((I1, I1, I3)), (0, 0, S, 0, 0, -1), [*SE3_.casimirs(2), SE3_.coordinates[2]])
    assert hanging.positive == sympy.true


def test_the_linearised_free_body():
    matrix = linearisation(BODY, (0, S, 0))
    assert matrix == sympy.Matrix([[0, 0, S * (1 / I3 - 1 / I2)], [0, 0, 0], [S * (1 / I2 - 1 / I1), 0, 0]]).applyfunc(
        sympy.factor)  # fmt: skip
    wanted = s * (s**2 - S**2 * (I1 - I2) * (I2 - I3) / (I1 * I2**2 * I3))
    assert sympy.simplify(characteristic_polynomial(BODY, (0, S, 0)) - wanted) == 0


def test_a_wrong_hamiltonian_fails():
    """A cubic term is felt by no Casimir: the point is no equilibrium, or another condition comes out."""
    L1, L2, _ = SO3_.coordinates
    bent = SymbolicSystem(SO3_, BODY.hamiltonian + L1 * L2)
    with pytest.raises(InvalidInput, match="must be at rest; the rate of L3"):
        linearisation(bent, (S, 0, 0))
    with pytest.raises(InvalidInput, match="no multipliers"):
        second_variation(bent, (S, 0, 0), SO3_.casimirs(2))
    heavier = SymbolicSystem(SO3_, BODY.hamiltonian + L2**2 / 2)
    result = second_variation(heavier, (S, 0, 0), SO3_.casimirs(2))
    assert result.positive != second_variation(BODY, (S, 0, 0), SO3_.casimirs(2)).positive


def test_signs():
    x, y = sympy.symbols("x y", positive=True)
    assert positive_condition(x + y) == sympy.true and positive_condition(-x) == sympy.false
    assert positive_condition(0) == sympy.false and positive_condition(-(a**2) * x) == sympy.false
    assert positive_condition(a**2) == sympy.Ne(a, 0)
    assert positive_condition((x - y) * (a - b)) == sympy.Or(sympy.And(x > y, a > b), sympy.And(y > x, b > a))
    assert positive_condition(a * b * c) == (a * b * c > 0)
    assert positive_condition(a / b, {b: -1}) == (a < 0)


def test_definite_matrices_of_numbers():
    """Against eigenvalues, for random integers; and for some unknown by trying many."""
    rng = np.random.default_rng(0)
    for _ in range(25):
        half = rng.integers(-3, 4, size=(3, 3))
        matrix = half + half.T + np.diag(rng.choice([-9, 0, 9]) * np.ones(3, dtype=int))
        values = np.linalg.eigvalsh(matrix)
        if np.abs(values).min() > 1e-9:
            expected = (values[0] > 0, values[-1] < 0)
            assert tuple(map(bool, definite_conditions(sympy.Matrix(matrix)))) == expected
    t = sympy.Symbol("t", real=True)
    for p, q in ((1, 1), (1, -1), (3, 2)):
        matrix = sympy.Matrix([[1, t - p], [t - p, q - t]])
        result = definite_for_some(matrix, t)[0]
        numbers = sympy.lambdify(t, matrix)
        tried = any(np.linalg.eigvalsh(np.array(numbers(v), float))[0] > 0 for v in np.linspace(-20.0, 20.0, 4001))
        assert bool(result) == tried
    slanted = definite_for_some(sympy.diag(t - a, b - t), t)[0]
    assert slanted == (b > a)
    with pytest.raises(InvalidInput, match="not decided"):
        definite_for_some(sympy.diag(t**3 - a, 1), t)


def test_roots_decide_instability():
    """Against numerical roots, for polynomials in s² of degree one to three."""
    rng = np.random.default_rng(0)
    for degree in (1, 2, 3):
        for _ in range(25):
            # real and complex roots s², none of which is zero
            roots = list(rng.integers(1, 5, size=degree) * rng.choice([-1.0, 1.0], size=degree, p=[0.8, 0.2]))
            if degree > 1 and rng.random() < 0.4:
                roots[:2] = [complex(-2, 1), complex(-2, -1)]
            coefficients = np.real(np.poly(roots)).round().astype(int)
            poly = sum(int(c) * s ** (2 * (degree - k)) for k, c in enumerate(coefficients))
            if len({complex(r) for r in roots}) == degree:
                exponents = np.sqrt(np.array(roots, dtype=complex))
                assert bool(unstable_condition(poly, s)) == bool((np.abs(exponents.real) > 1e-9).any())
    with pytest.raises(InvalidInput, match="even"):
        unstable_condition(s**2 + s + 1, s)


@pytest.mark.parametrize(("call", "message"), [
    (lambda: second_variation(BODY, (S, 0, 0), [SO3_.coordinates[0]]), "Casimirs or integrals"),
    (lambda: linearisation(BODY, (S, 0)), "3 coordinates"),
    (lambda: linearisation(BODY, {"L1": S}), "3 coordinates"),
    (lambda: definite_conditions(sympy.Matrix([[1, a], [0, 1]])), "symmetric"),
])  # fmt: skip
def test_mistakes_are_named(call, message):
    with pytest.raises(InvalidInput, match=message):
        call()
