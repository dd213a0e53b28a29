"""Casimirs found by exact algebra: the textbook's, and none where there is none."""

import sys
from fractions import Fraction

import jax.numpy as jnp
import jaxtyping
import numpy as np
import pytest
from flint import fmpq

import polhode as ph
from polhode import algebra as lie
from polhode import fields
from polhode._base.rational import _sparse as sparse
from polhode.algebra._own_casimirs import find_casimirs
from polhode.algebra.casimirs import rational_brackets
from polhode.errors import InvalidInput
from specimens import ALGEBRAS
from sweeping import first

EXACT = 1e-12


def galilei():
    """The massless Galilei algebra: turns J, boosts K, momenta P, energy E, as 5×5 matrices on (x, t, 1)."""
    def unit(i, j):
        one = np.zeros((5, 5))
        one[i, j] = 1.0
        return one

    turns = [unit((k + 2) % 3, (k + 1) % 3) - unit((k + 1) % 3, (k + 2) % 3) for k in range(3)]
    return lie.from_matrices(
        np.array([*turns, *(unit(k, 3) for k in range(3)), *(unit(k, 4) for k in range(3)), unit(3, 4)])
    )


def test_rotations_and_rigid_motions():
    assert list(map(str, lie.polynomial_casimirs(lie.SO3(), 4))) == ["x1² + x2² + x3²"]
    assert list(map(str, lie.polynomial_casimirs(lie.SE3(), 4))) == ["x1 x4 + x2 x5 + x3 x6", "x4² + x5² + x6²"]
    assert sorted(map(str, lie.polynomial_casimirs(lie.SO(4), 4))) == [
        "x1 x6 − x2 x5 + x3 x4", "x1² + x2² + x3² + x4² + x5² + x6²",
    ]  # fmt: skip
    assert [str(c) for c in lie.polynomial_casimirs(lie.Heisenberg(2), 3)] == ["x5"]
    assert [str(c) for c in lie.polynomial_casimirs(lie.SL(2), 4)] == ["4 x1 x2 + x3²"]


def test_none_where_there_is_none():
    assert lie.polynomial_casimirs(lie.AffineLine(), 5) == []


def test_galilei_has_momentum_squared_and_its_product_with_the_boost():
    casimirs = lie.polynomial_casimirs(galilei(), 4)
    assert [c.degree for c in casimirs] == [2, 4]
    point = np.random.default_rng(0).normal(size=(20, 10))
    k, p = point[:, 3:6], point[:, 6:9]
    wanted = np.stack([np.sum(p * p, axis=1), np.sum(np.cross(k, p) ** 2, axis=1)])
    for found, values in zip(casimirs, wanted, strict=True):
        ratio = found(point) / values
        assert ratio == pytest.approx(ratio[0], rel=1e-9)


@pytest.mark.parametrize(("algebra", "degrees"),
                         first(1, [(lie.Sp(2), [2, 4]), (lie.SL(3), [2, 3]), (lie.SU(3), [2, 3])]),
                         ids=lambda x: getattr(x, "name", ""))  # fmt: skip
def test_found_ones_and_known_ones_are_functions_of_each_other(algebra, degrees):
    casimirs = lie.polynomial_casimirs(algebra, max(degrees))
    assert [c.degree for c in casimirs] == degrees
    rng = np.random.default_rng(2)
    vectors = rng.normal(size=(12, algebra.dim))
    found = np.stack([c(vectors) for c in casimirs])
    known = np.asarray(algebra.casimirs(algebra.from_dual_vector(vectors))).T
    powers = {2: [found[0]], 3: [found[1]], 4: [found[1], found[0] ** 2]}
    for degree, values in zip(degrees, known, strict=True):
        columns = np.stack(powers[degree], axis=1)
        left = values - columns @ np.linalg.lstsq(columns, values, rcond=None)[0]
        assert np.abs(left).max() < 1e-9 * np.abs(values).max()


@pytest.mark.parametrize("algebra", first(2, [a for a in ALGEBRAS if a.dim <= 8]), ids=lambda a: a.name)
def test_they_are_constant_on_orbits(algebra):
    rng = np.random.default_rng(3)
    mu = algebra.from_dual_vector(rng.normal(size=algebra.dim))
    moved = mu + algebra.exp_change(algebra.from_vector(0.3 * rng.normal(size=algebra.dim)), mu)
    for casimir in lie.polynomial_casimirs(algebra, 3):
        before, after = (float(casimir(algebra.to_dual_vector(m))) for m in (mu, moved))
        assert after == pytest.approx(before, rel=EXACT, abs=EXACT)


def test_a_polynomial_that_is_no_casimir_is_caught():
    wrong = lie.polynomial_casimirs(lie.SO(4), 2)[0]
    so3 = lie.SO(3)
    mu = so3.from_dual_vector(np.array([1.0, 2.0, 3.0]))
    padded = lambda m: np.concatenate([so3.to_dual_vector(m), so3.to_dual_vector(m)])  # noqa: E731
    moved = mu + so3.exp_change(so3.from_vector(np.array([0.3, 0.1, 0.2])), mu)
    assert abs(float(wrong(padded(moved)) - wrong(padded(mu)))) > 1e-3


def test_bad_input():
    with pytest.raises(InvalidInput, match="whole number"):
        lie.polynomial_casimirs(lie.SO3(), 0)
    with pytest.raises(InvalidInput, match="Lower the degree"):
        lie.polynomial_casimirs(lie.SO(8), 6)
    # l = 3 harmonics have square roots as constants, whose doubles are no algebra
    with pytest.raises(InvalidInput, match=r"must satisfy Jacobi's identity exactly .* Give them as Fractions"):
        lie.polynomial_casimirs(fields.QuantizedSphere(3), 2)
    with pytest.raises(InvalidInput, match='`read_as` must be "exact" or "decimal"'):
        lie.polynomial_casimirs(lie.SO3(), 2, "short")


def scaling(c):
    """[e3, e1] = e1, [e3, e2] = −c e2: x1^p x2^q is a Casimir for c = p/q alone."""
    table = np.zeros((3, 3, 3), dtype=object)
    table[2, 0, 0], table[0, 2, 0], table[2, 1, 1], table[1, 2, 1] = 1, -1, f"-{c}" if isinstance(c, str) else -c, c
    return table


@pytest.mark.parametrize(("c", "read_as", "wanted"), [
    (0.12345, "exact", []), (0.5, "exact", ["x1 x2²"]), (0.1 + 0.2, "decimal", []), (0.25, "decimal", ["x1 x2⁴"]),
    (1 / 3, "exact", []), (1 / 3, "decimal", []), (Fraction(1, 3), "exact", ["x1 x2³"]), ("1/3", "exact", ["x1 x2³"]),
    (0.2, "exact", []), (0.2, "decimal", ["x1 x2⁵"]), ("0.2", "exact", ["x1 x2⁵"]), (0.5 + 1e-12, "exact", []),
], ids=str)  # fmt: skip
def test_constants_are_the_numbers_that_are_given(c, read_as, wanted):
    """No double is refused, and none is taken for another: .12345 "must be rational", and 0.5 + 1e-12 was 1/2."""
    table = scaling(c) if isinstance(c, Fraction | str) else scaling(c).astype(float)
    algebra = lie.from_structure_constants(table)
    assert [str(f) for f in lie.polynomial_casimirs(algebra, 6, read_as)] == wanted
    assert np.array_equal(algebra.constants, scaling(float(Fraction(c))).astype(float))


def test_rounded_constants_are_the_simple_fractions_near_them():
    """Those of su(4) have thirds, and as doubles no Jacobi identity."""
    assert rational_brackets(lie.SU(4))[0][1] and all(
        value.denominator <= 6 for row in rational_brackets(lie.SU(4)) for v in row for value in v.values())
    wrong = lie.SU(3).structure_constants().copy()
    wrong[0, 1, 2] += 5e-13
    wrong[1, 0, 2] -= 5e-13
    with pytest.raises(InvalidInput, match="up to rounding only"):
        lie.polynomial_casimirs(lie.from_structure_constants(wrong), 2)


def test_a_run_says_which_casimirs_it_cannot_watch(monkeypatch):
    def outcome(c, **options):
        algebra = lie.from_structure_constants(scaling(c).astype(float), **options)
        return str(ph.simulate(ph.systems.LiePoisson(algebra, lambda m: m[2] ** 2 / 2 + m[0]), [1.0, 1.0, 0.3],
                               [0.0, 0.1]).outcome)  # fmt: skip

    assert outcome(0.5) == "successful" == outcome(0.12345, casimirs=[])
    assert outcome(0.12345) == ("successful: 0 of 1 Casimirs are watched: no polynomial of degree ≤ 4 is another; "
                                "give others by `casimirs=`")  # fmt: skip
    monkeypatch.setitem(sys.modules, "flint", None)
    find_casimirs.cache_clear()
    assert "0 of 1 Casimirs are watched: Exact Casimirs and integrals need python-flint, which" in outcome(0.5)
    find_casimirs.cache_clear()


@pytest.mark.long
def test_su4_ends_soon_as_its_equations_fall_apart():
    """As one matrix of 11,554 × 3,060 it took minutes, in one call that no signal gets through."""
    assert [c.degree for c in lie.polynomial_casimirs(lie.SU(4), 4)] == [2, 3, 4]


def test_blocks_give_what_the_whole_gives(monkeypatch):
    """In one block, as before, and in many: the same reduced echelon form."""
    rng = np.random.default_rng(1)
    rows = [{3 * int(k) + n % 3: fmpq(int(rng.integers(1, 9))) for k in rng.choice(6, 3, replace=False)}
            for n in range(14)]  # fmt: skip
    assert len(sparse._blocks(rows, 18)) >= 3
    apart = sparse._reduce_rows(rows, 18)
    monkeypatch.setattr(sparse, "_blocks", lambda rows, columns: [(rows, list(range(columns)))])
    assert sparse._reduce_rows(rows, 18) == apart


def test_a_system_too_large_is_refused_before_it_is_solved(monkeypatch):
    monkeypatch.setattr(sparse, "LIMITS", sparse.SolvingLimits(max_work=1e4))
    with pytest.raises(InvalidInput, match=r"equations for \d+ unknowns at once.*Lower the degree.*`casimirs=`"):
        lie.polynomial_casimirs(lie.SO(4), 4)
    assert len(lie.polynomial_casimirs(lie.SO(4), 2)) == 2


ENGEL = np.zeros((4, 4, 4))
ENGEL[0, 1, 2], ENGEL[1, 0, 2], ENGEL[0, 2, 3], ENGEL[2, 0, 3] = 1.0, -1.0, 1.0, -1.0


def square(x):
    return 2.0 * x[1] * x[3] - x[2] ** 2


@pytest.mark.sweep
def test_an_algebra_of_ones_own_finds_its_casimirs_or_takes_those_given():
    assert lie.from_structure_constants(ENGEL).casimir_names == ("x4", "2 x2 x4 − x3²")
    last = lie.polynomial_casimirs(lie.from_structure_constants(ENGEL), 1)
    given = lie.from_structure_constants(ENGEL, casimirs=[*last, square])
    assert given.casimir_names == ("x4", "C2")
    assert np.asarray(given.casimirs(np.array([[1.0, 2.0, 3.0, 4.0]]))).tolist() == [[4.0, 7.0]]
    assert lie.from_structure_constants(ENGEL, casimirs=[]).casimir_names == ()
    # of so(3) acting on vectors those of se(3), and of triangular matrices a quotient, which no search finds
    rho = lie.SO3().structure_constants().transpose(0, 2, 1)
    known = lie.Semidirect(lie.SO3(), rho, casimirs=[lambda x: x[3:] @ x[3:], lambda x: x[:3] @ x[3:]])
    point = np.arange(1.0, 7.0)
    assert sorted(np.asarray(known.casimirs(point)).tolist()) == sorted(
        np.asarray(lie.SE3().casimirs(point)).tolist())  # fmt: skip
    unit = lambda i, j: np.eye(3)[i][:, None] * np.eye(3)[j]  # noqa: E731
    upper = np.array([unit(0, 0) - unit(1, 1), unit(1, 1) - unit(2, 2), unit(0, 1), unit(1, 2), unit(0, 2)])
    assert lie.from_matrices(upper).casimir_names == ()
    quotient = lie.from_matrices(upper, casimirs=[lambda m: m[0] - m[1] + 3.0 * m[2] * m[3] / m[4]])
    assert quotient.casimir_names == ("C1",)


@pytest.mark.parametrize(
    ("casimirs", "words"),
    [
        ([lambda x: x[3], lambda x: x[2]], r"`casimirs\[1\]` must be a Casimir.*\{casimirs\[1\], x1\} is 1 of its"),
        ([lambda x: 2.0 * x[1] * x[3] - 1.001 * x[2] ** 2], r"`casimirs\[0\]` must be a Casimir.*is 0\.000"),
        ([lambda x: x[3], lambda x: x[3] ** 2], "independent; the gradients of these 2 span 1"),
        ([lambda x: 3.0 + 0.0 * x[0]], "these 1 span 0"),
        ([lambda x: x], "real scalar"),
        ([lambda x: np.sum(np.asarray(x))], "written with jax"),
        (square, "list of functions"),
        ([lambda x: jnp.sqrt(-(x[3] ** 2))], "differentiable at most points"),
    ],
)
@pytest.mark.usefixtures("any_type")
def test_functions_that_are_no_casimirs_are_refused(casimirs, words):
    with pytest.raises(InvalidInput, match=words):
        lie.from_structure_constants(ENGEL, casimirs=casimirs)


OWN = [lambda x: x[3], square]


def test_own_casimirs_have_names():
    named = lie.from_structure_constants(ENGEL, casimirs=OWN, names=("charge", "spread"))
    assert named.casimir_names == ("charge", "spread")
    assert {k: float(v) for k, v in named.named_casimirs(np.array([1.0, 2.0, 3.0, 4.0])).items()} == {
        "charge": 4.0, "spread": 7.0,
    }  # fmt: skip
    assert lie.Product(named, lie.SO3()).casimir_names == ("charge of 0", "spread of 0", "|L|² of 1")
    rho = lie.SO3().structure_constants().transpose(0, 2, 1)
    advected = lie.Semidirect(lie.SO3(), rho, [lambda x: x[3:] @ x[3:], lambda x: x[:3] @ x[3:]], ["|Γ|²", "L·Γ"])
    assert advected.casimir_names == ("|Γ|²", "L·Γ")
    turns = [[[0, 0, 0], [0, 0, -1], [0, 1, 0]], [[0, 0, 1], [0, 0, 0], [-1, 0, 0]], [[0, -1, 0], [1, 0, 0], [0, 0, 0]]]
    spins = lie.from_matrices(turns, [lambda x: x @ x], names=["size"])
    assert spins.casimir_names == ("size",)
    # polynomials that are their own names are called by the given ones too
    found = lie.polynomial_casimirs(lie.from_structure_constants(ENGEL), 1)
    assert lie.from_structure_constants(ENGEL, casimirs=found, names=["charge"]).casimir_names == ("charge",)


def test_names_stand_in_what_a_run_keeps_and_a_certificate_says():
    body = lie.from_structure_constants(lie.SO3().structure_constants(), [lambda x: x @ x], ["size"])
    system = ph.systems.LiePoisson(body, lambda x: 0.5 * jnp.sum(x**2 / jnp.array([1.0, 2.0, 3.0])))
    assert set(ph.simulate(system, [0.3, 1.8, 1.5], np.linspace(0.0, 1.0, 3)).drift) == {"energy", "size"}
    assert "size" in ph.stability(system, np.array([0.0, 0.0, 1.0])).certificate


@pytest.mark.parametrize(
    ("casimirs", "names", "words"),
    [
        (None, ["charge"], "are of `casimirs`, which are not given"),
        (OWN, ["charge"], "as many as `casimirs`, 2; got 1"),
        (OWN, "charge", "list of texts"),
        (OWN, ["charge", " "], "list of texts"),
        (OWN, ["charge", 3], "list of texts"),
        (OWN, ["charge", "charge"], "differ from each other"),
        (OWN, ["charge", "energy"], 'from "energy"'),
    ],
)
def test_names_that_do_not_fit_are_refused(casimirs, names, words, monkeypatch):
    monkeypatch.setattr(jaxtyping.config, "jaxtyping_disable", True)
    with pytest.raises(InvalidInput, match=words):
        lie.from_structure_constants(ENGEL, casimirs=casimirs, names=names)


def test_without_flint_none_are_watched(monkeypatch):
    assert len(lie.from_structure_constants(ENGEL * np.sqrt(2.0)).casimir_names) == 2
    monkeypatch.setitem(sys.modules, "flint", None)
    assert lie.from_structure_constants(3.0 * ENGEL).casimir_names == ()
    assert lie.from_structure_constants(3.0 * ENGEL, casimirs=[square]).casimir_names == ("C1",)


@pytest.mark.long
def test_a_basis_that_depends_over_the_complex_numbers_acts_as_it_should():
    """B and iB: group elements were read off over the complex numbers, with half of each component."""
    basis = np.concatenate([lie.SL(2).basis, 1j * lie.SL(2).basis])
    algebra = lie.from_matrices(basis, casimirs=[])
    x, mu = np.random.default_rng(5).normal(size=(2, 6))
    assert np.asarray(mu + algebra.exp_change(0.1 * x, mu)) == pytest.approx(
        np.asarray(algebra.coadjoint_action(algebra.exp(0.1 * x), mu)), abs=1e-13)  # fmt: skip
