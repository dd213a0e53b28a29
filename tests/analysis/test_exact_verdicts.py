"""Verdicts near symmetry, against moments and margins compared as fractions, and against SymPy's exact signs."""

import importlib
import itertools
import warnings
from fractions import Fraction

import jax.numpy as jnp
import numpy as np
import pytest

import polhode as ph
from polhode import algebra as lie
from polhode import systems
from polhode.analysis import _exact_functions as exact_functions
from polhode.analysis.equilibria import find_equilibria
from polhode.certificates._exact_tracing import Unaffordable, trace_polynomials
from polhode.errors import InvalidInput
from sweeping import first

ULP = 2.0**-52
e1, e2, e3 = np.eye(3)
so3 = lie.SO3()


def expected_of_axis(moments, axis):
    """Return the verdict by comparing fractions: middle moments and those of an equator are unstable."""
    moments = [Fraction(x) for x in moments]
    others = [moments[(axis + k) % 3] - moments[axis] for k in (1, 2)]
    if not any(others):
        return "stable"
    return "stable" if others[0] * others[1] > 0 else "unstable"


NEAR = [
    *((1.0, 1.0 + k * ULP, 3.0) for k in (1, 2, 4, 8, 16, 64)), *((1.0, 3.0, 3.0 + 4 * k * ULP) for k in (1, 16)),
    *((1.0 - gap, 1.0, 1.0 + gap) for gap in (ULP, 1e-15, 1e-13, 3e-13, 1e-12, 1e-11)),
    (1.0, 1.0, 3.0), (1.0, 3.0, 3.0), (1.0, 1.0, 1.0),
]  # fmt: skip


@pytest.mark.long_after(4)
@pytest.mark.parametrize("moments", NEAR)
def test_axes_of_nearly_symmetric_bodies(moments):
    body = systems.FreeRigidBody(moments)
    for axis in range(3):
        found = ph.stability(body, np.eye(3)[axis])
        assert found.verdict == expected_of_axis(moments, axis)
        m = [Fraction(moments[(axis + k) % 3]) for k in range(3)]
        square = (1 / m[2] - 1 / m[0]) * (1 / m[0] - 1 / m[1])  # λ² = (1/I3 − 1/I1)(1/I1 − 1/I2), by hand
        assert found.rate == pytest.approx(float(max(square, 0)) ** 0.5, rel=1e-9, abs=0.0)


def test_certificates_of_nearly_symmetric_bodies_prove_the_same():
    for moments, axis in itertools.product([(1.0, 1.0 + 8 * ULP, 3.0), (1.0 - 1e-13, 1.0, 1.0 + 1e-13)], range(3)):
        found = ph.stability(systems.FreeRigidBody(moments), np.eye(3)[axis])
        assert found.certificate.as_rational().verdict == found.verdict


@pytest.mark.long_after(2)
@pytest.mark.parametrize("tilt", [2.0**-52, 1e-15, 1e-13, 1e-12])
def test_what_a_top_does_not_conserve_proves_nothing(tilt):
    sleeping = np.array([0.0, 0.0, 2.5, 0.0, 0.0, 1.0])
    found = ph.stability(systems.HeavyTop((1.0, 1.0 + tilt, 0.5), 1.0), sleeping)
    assert found.verdict == "undecided" and "Lagrange" not in found.certificate
    assert ph.stability(systems.HeavyTop((1.0, 1.0, 0.5), 1.0), sleeping).verdict == "stable"


@pytest.mark.long_after(3)
@pytest.mark.parametrize(("I1", "mgl", "steps"), [(0.3, 0.7, k) for k in (-3, -2, -1, 0, 1, 2)] + [(1.0, 1.0, 0)])
def test_sleeping_tops_within_ulps_of_their_threshold(I1, mgl, steps):
    """Stable where L3² > 4 I1 mgl, else growing at √(mgl/I1 − L3²/4 I1²): as fractions."""
    L3 = float(np.sqrt(4.0 * I1 * mgl) * (1.0 + steps * ULP))
    margin = Fraction(L3) ** 2 - 4 * Fraction(I1) * Fraction(mgl)
    found = ph.stability(systems.HeavyTop((I1, I1, 0.2), mgl), np.array([0, 0, L3, 0, 0, 1.0]))
    assert found.verdict == ("stable" if margin > 0 else "unstable" if margin < 0 else "undecided")
    assert found.rate == pytest.approx(float(max(-margin, 0)) ** 0.5 / (2 * I1), rel=1e-9, abs=0.0)


@pytest.mark.long_after(2)
def test_beside_a_nearly_symmetric_equator_nothing_is_claimed():
    """(0.6, 0.8, 0) is at rest where two moments are equal; an ulp off it moves, slower than any threshold sees."""
    point = np.array([0.6, 0.8, 0.0])
    assert ph.stability(systems.FreeRigidBody((1.0, 1.0 + 8 * ULP, 3.0)), point).verdict == "undecided"
    equal = ph.stability(systems.FreeRigidBody((1.0, 1.0, 3.0)), point)
    assert (equal.verdict, equal.growth) == ("unstable", "linear")


@pytest.mark.long_after(2)
@pytest.mark.parametrize("conserved", [
    {"integrals": [lambda m: m[2]]},
    {"casimirs": [lambda m: m[3] ** 2 + m[4] ** 2 + (1 + 1e-13) * m[5] ** 2, lambda m: m[:3] @ m[3:]]},
])  # fmt: skip
def test_functions_that_are_nearly_conserved_are_refused(conserved):
    d = 1e-13 if "integrals" in conserved else 0.0
    top = systems.LiePoisson(lie.SE3(), lambda m: 0.5 * (m[0] ** 2 + m[1] ** 2 / (1 + d) + 2 * m[2] ** 2) + m[5])
    with pytest.raises(InvalidInput, match=r"in exact arithmetic it does not, .* is \d.*e-1[34]"):
        ph.stability(top, np.array([0, 0, 2.5, 0, 0, 1.0]), **conserved)


# ---------------------------------------------------------------------- polynomials of any degree

def test_a_cubic_at_its_zero_is_smooth(monkeypatch):
    """Its slope and curvature vanish at the point, so that nothing may be compared with them; L3 alone decides."""
    cubic = lambda L: 1e-6 * L[2] + (L[0] + L[1] / 2 + 0.3 * (L[2] - 1)) ** 3  # noqa: E731
    assert ph.stability(systems.LiePoisson(so3, cubic), e3).verdict == "stable"
    monkeypatch.setattr(exact_functions, "LIMITS", exact_functions.LIMITS._replace(max_coordinates=0))  # by doubles
    assert ph.stability(systems.LiePoisson(so3, cubic), e3).verdict == "stable"
    with pytest.raises(InvalidInput, match="twice differentiable"):
        ph.stability(systems.LiePoisson(so3, lambda L: cubic(L) + 1e-6 * jnp.abs(L[0])), e3)


def determinant_by_sympy(L, H, point):
    """Return det D²(H − λC) on the plane across L, C = ½|L|², by SymPy: positive where it is definite."""
    import sympy

    slope = sympy.Matrix([sympy.diff(H, x) for x in L]).subs(dict(zip(L, point, strict=True)))
    z = sympy.Matrix(point)
    assert not any(slope.cross(z))
    multiplier = slope.dot(z) / z.dot(z)
    second = sympy.hessian(H, L).subs(dict(zip(L, point, strict=True))) - multiplier * sympy.eye(3)
    basis = sympy.Matrix.hstack(*sympy.Matrix([point]).nullspace())
    inner = basis.T * second * basis
    return inner.det()


@pytest.mark.long
@pytest.mark.parametrize("seed", range(40))
def test_random_polynomials_on_a_sphere(seed):
    """Definite on the leaf is stable, indefinite unstable, as on a surface; degenerate is neither by signs alone."""
    import sympy

    rng = np.random.default_rng(seed)
    x = sympy.symbols("x1 x2 x3")
    point = [0, 0, 1] if seed % 2 else [3, 0, 4]
    across = [x[0] - point[0], x[1], x[2] - point[2]]
    H = sympy.Integer(0)
    for power in (1, 2, 2, 3, 4):
        row = [sympy.Rational(int(k), 8) for k in rng.integers(-8, 9, 3)]
        scale = sympy.Rational(1, 2 ** int(rng.integers(0, 60)))
        form = sum(a * b for a, b in zip(row, across, strict=True))
        H += scale * (sum(a * b for a, b in zip(point, x, strict=True)) if power == 1 else form**power)
    det = determinant_by_sympy(x, H, point)
    function = sympy.lambdify(x, H, "jax")
    found = ph.stability(systems.LiePoisson(so3, lambda L: function(L[0], L[1], L[2])), np.array(point, float))
    if det:
        assert found.verdict == ("stable" if det > 0 else "unstable")
    else:
        assert found.verdict in ("undecided", "unstable", "stable") and not found.rate


# ---------------------------------------------------------------------- no warnings

COMPLEX = {
    "su(2)": lie.SU(2), "su(3)": lie.SU(3), "su(4)": lie.SU(4), "u(2)": lie.U(2), "su(2)²": lie.Power(lie.SU(2), 2),
    "su(2) and so(3)": lie.Product(lie.SU(2), so3),
}  # fmt: skip


@pytest.mark.long_after(3)
@pytest.mark.parametrize("name", first(2, list(COMPLEX)))
@pytest.mark.parametrize("function", [lambda x: x**2, lambda x: 1.0 - jnp.cos(x)])
def test_verdicts_on_complex_algebras_are_silent(name, function):
    algebra = COMPLEX[name]
    weights = jnp.arange(1.0, algebra.dim + 1)
    system = systems.LiePoisson(algebra, lambda m: jnp.sum(weights * function(algebra.to_dual_vector(m))))
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert ph.stability(system, algebra.from_dual_vector(np.eye(algebra.dim)[-1])).verdict


# ---------------------------------------------------------------------- equilibria

@pytest.mark.long
def test_points_that_move_are_not_found():
    """On R² ⋊ diag(1, √2) there is one equilibrium of this energy at the level: x1^(2 − √2) = c √2, by hand."""
    c = np.zeros((3, 3, 3))
    c[2, 0, 0], c[0, 2, 0], c[2, 1, 1], c[1, 2, 1] = 1.0, -1.0, np.sqrt(2.0), -np.sqrt(2.0)
    system = systems.LiePoisson(lie.from_structure_constants(c), lambda m: 0.5 * (m[2] ** 2 + m[0] ** 2) - m[1])
    casimirs = [lambda m: m[1] / m[0] ** jnp.sqrt(2.0)]
    points = find_equilibria(system, np.array([1.0, 0.5, 0.0]), casimirs=casimirs)
    first_one = (0.5 * np.sqrt(2.0)) ** (1.0 / (2.0 - np.sqrt(2.0)))
    assert points == pytest.approx(np.array([[first_one, 0.5 * first_one ** np.sqrt(2.0), 0.0]]), abs=1e-9)
    assert ph.stability(system, points[0], casimirs=casimirs).verdict == "stable"


# ---------------------------------------------------------------------- leaves

def test_a_leaf_of_one_point_is_said_to_be_one():
    """Heisenberg's x1 at (1, 0, 0): beside it x2 moves by x3 without end, as `simulate` shows."""
    found = ph.stability(systems.LiePoisson(lie.Heisenberg(1), lambda m: m[0]), e1)
    exact = found.certificate.as_rational()
    assert found.verdict == exact.verdict == exact.as_json()["verdict"] == "undecided"
    assert "leaves nearby are larger" in found.certificate and "nothing is proved" in exact.statement


def test_exact_functions_have_a_largest_dimension(monkeypatch):
    """Beyond it doubles decide: what is not surely decided stays open."""
    monkeypatch.setattr(exact_functions, "LIMITS", exact_functions.LIMITS._replace(max_coordinates=2))
    for gap in (1e-13, 1e-12):
        body = systems.FreeRigidBody((1.0 - gap, 1.0, 1.0 + gap))
        assert ph.stability(body, e2).verdict == "undecided"
    assert ph.stability(systems.FreeRigidBody((1.0, 2.0, 3.0)), e2).verdict == "unstable"


# ---------------------------------------------------------------------- sizes

@pytest.mark.long
@pytest.mark.parametrize(("power", "exact"), [(20, True), (60, False), (200, False)])
def test_brackets_are_multiplied_out_as_long_as_it_pays(power, exact, monkeypatch):
    """(L1 + L2 + L3)ⁿ is largest along (1, 1, 1), whatever n is; a proof needs it multiplied out, or is refused."""
    seen = []
    real = exact_functions.exact_functions
    module = importlib.import_module("polhode.analysis.stability")
    monkeypatch.setattr(module, "exact_functions", lambda *a: seen.append(real(*a)) or seen[-1])
    system = systems.LiePoisson(so3, lambda L: ((L[0] + L[1] + L[2]) / 3) ** power)
    found = ph.stability(system, np.ones(3))
    assert (seen[0] is not None) == exact
    assert found.verdict == "stable"
    if power == 200:
        with pytest.raises(InvalidInput, match=r"products of terms to multiply out\. The numerical verdict holds"):
            found.certificate.as_rational()


def test_the_bound_of_products_counts_each(monkeypatch):
    """x1 + … + xn, squared, takes n² of them."""
    square = lambda x: (x.sum() ** 2)[None]  # noqa: E731
    for most, enough in ((39, False), (42, True)):
        try:
            trace_polynomials(square, 6, Fraction, most)
        except Unaffordable:
            assert not enough
        else:
            assert enough
