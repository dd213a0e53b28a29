"""Brackets by differentiation against the tensor, orbits against their known sizes, the form against the bracket."""

import jax
import jax.numpy as jnp
import numpy as np
import pytest

import polhode as ph
from polhode import algebra as lie
from polhode import poisson
from polhode.errors import InvalidInput
from specimens import ALGEBRAS
from sweeping import first, only

EXACT = 1e-12
SMALL = [a for a in ALGEBRAS if a.dim <= 10]
AT_ONCE = [a for a in SMALL if a.name in ("SE3", "SU(3)")]  # one with singular orbits, one of complex matrices


def point_of(algebra, seed=0, count=None):
    shape = (algebra.dim,) if count is None else (count, algebra.dim)
    return algebra.from_dual_vector(jnp.asarray(np.random.default_rng(seed).normal(size=shape)))


def functions(algebra):
    vector = algebra.to_dual_vector
    return lambda m: jnp.sum(vector(m) ** 3), lambda m: jnp.sin(vector(m)[0] * vector(m)[-1])


def test_signs_of_the_minus_bracket():
    L = jnp.array([1.0, 2.0, 5.0])
    for i, j, k in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
        value = poisson.bracket(lie.SO3(), lambda m, i=i: m[i], lambda m, j=j: m[j])
        assert float(value(L)) == -float(L[k])
    moments = jnp.array([1.0, 2.0, 3.0])
    field = poisson.hamiltonian_field(lie.SO3(), lambda m: 0.5 * jnp.sum(m * m / moments))
    assert np.asarray(field(L)) == pytest.approx(np.cross(L, L / moments))
    plus = poisson.hamiltonian_field(lie.SO3(), lambda m: 0.5 * jnp.sum(m * m / moments), sign=1)
    assert np.asarray(plus(L)) == pytest.approx(-np.asarray(field(L)))


@pytest.mark.long_cases("SU(3)")
@pytest.mark.parametrize("algebra", only(AT_ONCE, SMALL), ids=lambda a: a.name)
def test_bracket_field_tensor_and_time_derivative_agree(algebra):
    F, G = functions(algebra)
    points = point_of(algebra, count=5)

    @jax.jit  # one compilation of everything instead of one of each operation
    def measured(points):
        in_coordinates = [jax.vmap(jax.grad(lambda v, f=f: f(algebra.from_dual_vector(v)))) for f in (F, G)]
        slopes = [slope(algebra.to_dual_vector(points)) for slope in in_coordinates]
        found = []
        for sign in (-1, 1):
            tensor = poisson.poisson_tensor(algebra, points, sign)
            field = poisson.hamiltonian_field(algebra, G, sign)(points)
            found.append((
                poisson.bracket(algebra, F, G, sign)(points),
                jnp.einsum("ni,nij,nj->n", slopes[0], tensor, slopes[1]),
                jax.jvp(jax.vmap(F), (points,), (field,))[1],
                poisson.time_derivative(algebra, F, G, sign)(points),
            ))  # fmt: skip
        return found

    for values, by_tensor, along, again in measured(points):
        assert np.asarray(by_tensor) == pytest.approx(np.asarray(values), rel=EXACT, abs=EXACT)
        assert np.asarray(along) == pytest.approx(np.asarray(values), rel=EXACT, abs=EXACT)
        assert np.asarray(again) == pytest.approx(np.asarray(values), rel=EXACT, abs=EXACT)


@pytest.mark.long_cases("SU(3)")
@pytest.mark.parametrize("algebra", only(AT_ONCE, SMALL), ids=lambda a: a.name)
def test_form_on_hamiltonian_fields_is_the_bracket(algebra):
    F, G = functions(algebra)
    mu = point_of(algebra, 1)

    @jax.jit
    def measured(mu):
        dF, dG = (poisson.differential(algebra, f)(mu) for f in (F, G))
        return [
            (
                poisson.bracket(algebra, F, G, sign)(mu),
                poisson.kks_form(algebra, mu, dF, dG, sign),
                [algebra.to_dual_vector(poisson.hamiltonian_field(algebra, f, sign)(mu)) for f in (F, G)],
            )
            for sign in (-1, 1)
        ]

    tangent = poisson.orbit_tangent(algebra, mu)
    for sign, (bracket, form, fields) in zip((-1, 1), measured(mu), strict=True):
        value = float(bracket)
        assert float(form) == pytest.approx(value, rel=EXACT, abs=EXACT)
        # and by the matrix of the form in the orbit's own basis
        inside = [tangent @ np.asarray(x) for x in fields]
        for x, part in zip(fields, inside, strict=True):
            assert tangent.T @ part == pytest.approx(np.asarray(x), abs=1e-11 * max(np.abs(x).max(), 1.0))
        assert inside[0] @ poisson.kks_matrix(algebra, mu, sign) @ inside[1] == pytest.approx(value, rel=1e-9, abs=1e-9)


@pytest.mark.parametrize("algebra", first(2, [lie.SE3(), lie.SU(3), lie.SO3(), lie.SO(4)]), ids=lambda a: a.name)
def test_restricted_bracket_inverts_the_form(algebra):
    mu = point_of(algebra, 2)
    form, inner = poisson.kks_matrix(algebra, mu), poisson.restricted_bracket(algebra, mu)
    assert -inner @ form == pytest.approx(np.eye(len(form)), abs=1e-11)
    assert not inner @ form == pytest.approx(np.eye(len(form)), abs=0.1)


@pytest.mark.long
def test_orbit_dimensions():
    assert poisson.orbit_dimension(lie.SO3(), np.array([[0.0, 0, 0], [1e-9, 0, 0], [1, 2, 3]])).tolist() == [0, 2, 2]
    assert poisson.orbit_dimension(lie.SE3(), point_of(lie.SE3())) == 4
    assert poisson.orbit_dimension(lie.SE3(), np.array([1.0, 2, 3, 0, 0, 0])) == 2
    assert poisson.orbit_dimension(lie.SU(3), point_of(lie.SU(3))) == 6
    special = lie.SU(3).from_dual_vector(np.eye(8)[7])
    assert poisson.orbit_dimension(lie.SU(3), special) == 4  # the complex projective plane
    assert poisson.orbit_dimension(lie.AffineLine(), np.array([1.0, 0.0])) == 0
    assert poisson.orbit_dimension(lie.AffineLine(), np.array([0.0, 1.0])) == 2


def test_area_of_a_cap_and_the_whole_sphere():
    angle, size = 0.7, 2.5
    turns = np.linspace(0.0, 2.0 * np.pi, 4000, endpoint=False)
    across = np.sin(angle) * np.stack([np.cos(turns), np.sin(turns)], axis=1)
    cap = size * np.column_stack([across, np.full(len(turns), np.cos(angle))])
    wanted = 2.0 * np.pi * (1.0 - np.cos(angle)) * size
    assert poisson.symplectic_area(cap, sign=1) == pytest.approx(wanted, rel=1e-5)
    assert poisson.symplectic_area(cap) == pytest.approx(-wanted, rel=1e-5)
    assert poisson.liouville_volume(lie.SO3(), np.array([0.0, 3.0, 4.0])) == pytest.approx(20.0 * np.pi, rel=EXACT)
    motion = ph.FreeMotion((1.0, 2.0, 3.0), momentum=(0.3, 1.8, 1.5))
    loop = motion.momentum(np.linspace(0.0, motion.period, 4001)[:-1])
    assert abs(poisson.symplectic_area(loop)) == pytest.approx(2.0 * np.pi * motion.action, rel=1e-6)


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda: poisson.bracket(lie.SO3(), jnp.sum, jnp.sum, 2), "sign"),
        (lambda: poisson.bracket(lie.SO3(), lambda m: m, jnp.sum)(jnp.ones(3)), "one real number"),
        (lambda: poisson.bracket(lie.SO3(), lambda m: 1j * m[0], jnp.sum)(jnp.ones(3)), "complex"),
        (lambda: poisson.bracket(lie.SO3(), jnp.sum, jnp.sum)(jnp.ones(4)), "shape"),
        (lambda: poisson.poisson_tensor(lie.SO3(), np.array([1.0, np.nan, 0.0])), "finite"),
        (lambda: poisson.orbit_tangent(lie.SO3(), np.ones((2, 3))), "one point"),
        (lambda: poisson.symplectic_area(np.eye(3)[:2]), "three"),
        (lambda: poisson.symplectic_area(np.eye(3) * np.array([[1.0], [2.0], [3.0]])), "sphere"),
        (lambda: poisson.liouville_volume(lie.SE3(), np.ones(6)), "SO3"),
    ],
)
def test_bad_input(call, words):
    with pytest.raises(InvalidInput, match=words):
        call()
