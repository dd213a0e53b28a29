"""Symbolic brackets against the numerical ones of every algebra, and against published relations."""

import jax
import jax.numpy as jnp
import numpy as np
import pytest
import sympy

from polhode import poisson
from polhode.algebra import SE3, SO3, from_structure_constants, index
from polhode.errors import InvalidInput
from polhode.proving import LiePoissonBracket
from specimens import ALGEBRAS

POINTS = np.random.default_rng(5).normal(size=(4, 60))


def rational(algebra):
    try:
        LiePoissonBracket(algebra)
    except InvalidInput:
        return False
    return True


def those_with_rational_constants():
    """The smallest of each class, and the others in the sweep."""
    observed = set()
    for algebra in sorted((a for a in ALGEBRAS if a.dim < 16), key=lambda a: a.dim):
        marks = [pytest.mark.sweep] if type(algebra) in observed or (algebra.dim > 3 and algebra.dim != 6) else []
        observed.add(type(algebra))
        yield pytest.param(algebra, id=algebra.name, marks=marks)


def levi_civita(change=None):
    table = [[[0] * 3 for _ in range(3)] for _ in range(3)]
    for i, j, k in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
        table[i][j][k], table[j][i][k] = 1, -1
    for (i, j, k), value in (change or {}).items():
        table[i][j][k], table[j][i][k] = value, -value
    return table


@pytest.mark.long_after(5)
@pytest.mark.long_cases("DualNumbers(SU(2))")
@pytest.mark.parametrize("algebra", list(those_with_rational_constants()))
def test_equals_the_numerical_bracket(algebra):
    if not rational(algebra):
        with pytest.raises(InvalidInput, match="up to rounding only"):
            LiePoissonBracket(algebra)
        return
    symbolic = LiePoissonBracket(algebra)
    points = POINTS[:, : algebra.dim]
    mine = sympy.lambdify(symbolic.coordinates, symbolic.tensor.tolist(), modules="numpy")
    numbers = np.asarray(poisson.poisson_tensor(algebra, algebra.from_dual_vector(jnp.asarray(points))))
    for point, tensor in zip(points, numbers, strict=True):
        assert np.abs(np.array(mine(*point), dtype=float) - tensor).max() < 1e-13 * max(1.0, np.abs(tensor).max())
    assert not symbolic.broken_triples()


@pytest.mark.parametrize(("algebra", "degree"), [
    (SO3(), 2), (SE3(), 2), *(pytest.param(a, 4, marks=pytest.mark.sweep) for a in ALGEBRAS if a.dim <= 10),
], ids=lambda a: getattr(a, "name", ""))  # fmt: skip
def test_casimirs_are_those_of_the_algebra(algebra, degree):
    """As many as can be, their brackets vanish, and the gradients of the numerical ones lie in the span of theirs."""
    if not rational(algebra):
        pytest.skip("constants are not rational")
    symbolic = LiePoissonBracket(algebra)
    result = symbolic.casimirs(degree)
    assert len(result) == index(algebra) or not algebra.casimir_names
    assert all(map(symbolic.is_casimir, result))
    if not result:
        return
    point = POINTS[0, : algebra.dim]
    slopes = sympy.lambdify(symbolic.coordinates, [[sympy.diff(C, x) for x in symbolic.coordinates] for C in result])
    mine = np.array(slopes(*point), dtype=float)
    numbers = jax.jacrev(lambda z: algebra.casimirs(algebra.from_dual_vector(z)))(jnp.asarray(point))
    left = np.linalg.lstsq(mine.T, np.asarray(numbers).T, rcond=None)[0]
    assert np.abs(mine.T @ left - np.asarray(numbers).T).max() < 1e-12


@pytest.mark.parametrize("sign", [-1, 1])
def test_functions_and_both_signs(sign):
    algebra = SE3()
    symbolic = LiePoissonBracket(algebra, sign=sign)
    x = symbolic.coordinates
    F, G = x[0] ** 2 * x[4] + sympy.sin(x[1]), x[2] * x[3] - sympy.exp(x[5])
    value = sympy.lambdify(x, symbolic(F, G))
    numerical = poisson.bracket(
        algebra, lambda z: z[0] ** 2 * z[4] + jnp.sin(z[1]), lambda z: z[2] * z[3] - jnp.exp(z[5]), sign
    )
    assert value(*POINTS[0, :6]) == pytest.approx(float(numerical(jnp.asarray(POINTS[0, :6]))), rel=1e-13)
    assert symbolic(F, G) == -symbolic.with_sign(-sign)(F, G)


def test_jacobiator_and_leibniz():
    so3 = LiePoissonBracket(SO3(), ["L1", "L2", "L3"])
    L1, L2, L3 = so3.coordinates
    F, G, K = L1**2 * L2, sympy.sin(L3) + L1, L2 * L3
    assert so3.jacobiator(F, G, K) == 0
    assert sympy.expand(so3(F * G, K) - F * so3(G, K) - G * so3(F, K)) == 0
    assert so3(F, F) == 0


def test_a_wrong_constant_breaks_jacobi():
    assert not LiePoissonBracket(levi_civita()).broken_triples()
    broken = LiePoissonBracket(levi_civita({(0, 1, 0): 1}))
    x = broken.coordinates
    assert broken.jacobiator(*x) == x[1] and broken.broken_triples() == {tuple(x): x[1]}
    assert not broken.is_casimir(sum(v**2 for v in x))
    with pytest.raises(InvalidInput, match="Jacobi"):
        from_structure_constants(np.array(levi_civita({(0, 1, 0): 1}), dtype=float))


def test_a_table_of_symbols():
    """so(3) bent into so(2, 1) by one parameter is a Lie algebra for all its values."""
    c = sympy.Symbol("c", real=True)
    bent = LiePoissonBracket(levi_civita({(0, 1, 2): c}))
    x1, x2, x3 = bent.coordinates
    assert not bent.broken_triples()
    assert bent.is_casimir(x1**2 + x2**2 + c * x3**2)
    assert not bent.is_casimir(x1**2 + x2**2 + x3**2)
    with pytest.raises(InvalidInput, match="numbers for exact linear algebra"):
        bent.casimirs(2)


def test_latex():
    assert r"\{L_{1}, L_{2}\} &= - L_{3}" in LiePoissonBracket(SO3(), ["L1", "L2", "L3"]).latex()


@pytest.mark.parametrize(("make", "message"), [
    (lambda: LiePoissonBracket(SO3(), sign=2), "`sign`"),
    (lambda: LiePoissonBracket(SO3(), ["L1", "L2"]), "3 different names"),
    (lambda: LiePoissonBracket(SO3(), ["L1", "L2", "L2"]), "3 different names"),
    (lambda: LiePoissonBracket([[1, 2], [3, 4]]), "dim, dim, dim"),
    (lambda: LiePoissonBracket([[[1.0]]]), "antisymmetric"),
    (lambda: LiePoissonBracket([[[float("nan")]]]), "finite"),
])  # fmt: skip
def test_mistakes_are_named(make, message):
    with pytest.raises(InvalidInput, match=message):
        make()
