"""Symbolic systems run as numerical ones, and numerical ones are read exactly."""

import jax
import jax.numpy as jnp
import numpy as np
import pytest
import sympy

import polhode as ph
from polhode.algebra import SO, SO3
from polhode.errors import InvalidInput
from polhode.proving import (
    LiePoissonBracket,
    SymbolicSystem,
    compile_expression,
    kks_form,
    polynomial_integrals,
    reduce_to_sphere,
    second_variation,
)
from polhode.proving.symbolic.derivation import Derivation, Numerical
from polhode.systems import (
    BodyInPotential,
    BrunBody,
    DoubleBracket,
    FreeRigidBody,
    Gyrostat,
    HeavyTop,
    Kirchhoff,
    Manakov,
)

I1, I2, I3 = sympy.symbols("I1 I2 I3", positive=True)
k = sympy.Symbol("k")
SO3_ = LiePoissonBracket(SO3(), ["L1", "L2", "L3"], parameters=[I1, I2, I3, k])
BODY = SymbolicSystem(SO3_, sum(x**2 / (2 * i) for x, i in zip(SO3_.coordinates, (I1, I2, I3), strict=True)))
SE3_ = LiePoissonBracket(ph.algebra.SE3())
NUMERICAL = [
    FreeRigidBody((1.0, 2.0, 3.0)),
    HeavyTop((1.0, 2.0, 3.0), 0.7, (1.0, 2.0, 0.5)),
    BrunBody((1.0, 2.0, 3.0), 0.7),
    Gyrostat((1.0, 2.0, 3.0), (0.1, 0.2, 0.5)),
    Kirchhoff(np.diag([1.0, 2.0, 3.0, 2.0, 3.0, 5.0]) + 0.1),
    Manakov((1.0, 2.0, 3.0, 4.0)),
]


@pytest.mark.long_after(2)
@pytest.mark.parametrize("system", NUMERICAL, ids=lambda x: type(x).__name__)
def test_a_numerical_system_is_read_and_moves_alike(system):
    symbolic = SymbolicSystem.from_system(system)
    points = np.random.default_rng(0).normal(size=(5, system.algebra.dim))
    x = symbolic.bracket.coordinates
    rates = sympy.lambdify(x, [symbolic.bracket(v, symbolic.hamiltonian) for v in x], modules="numpy")
    states = system.algebra.from_dual_vector(jnp.asarray(points))
    field = jax.jit(lambda y: system.algebra.to_dual_vector(system.vector_field(0.0, y)))
    wanted = np.asarray(field(states))
    mine = np.array([rates(*point) for point in points], dtype=float)
    assert np.abs(mine - wanted).max() < 1e-13 * np.abs(wanted).max()


def test_the_numbers_of_a_system_are_read_as_it_is_said_and_divided_exactly():
    """A moment of 3 gives 1/6; one of 0.7 is the double next to it, or 7/10 where somebody says so."""
    L1, L2, L3 = SO3_.coordinates
    for read_as, third in (("exact", sympy.Rational(0.7)), ("decimal", sympy.Rational(7, 10))):
        symbolic = SymbolicSystem.from_system(FreeRigidBody((1.0, 3.0, 0.7)), ["L1", "L2", "L3"], read_as)
        assert sympy.expand(symbolic.hamiltonian - L1**2 / 2 - L2**2 / 6 - L3**2 / (2 * third)) == 0
        assert symbolic.bracket.read_as == read_as


def test_doubles_in_an_expression_are_fractions():
    x = SO3_.coordinates
    given = 0.5 * x[0] ** 2 + x[1] ** 2 / sympy.Integer(3) + 0.1 * x[2]
    symbolic = SymbolicSystem(SO3_, given)
    assert symbolic.hamiltonian == x[0] ** 2 / 2 + x[1] ** 2 / 3 + sympy.Rational(0.1) * x[2]
    assert not polynomial_integrals(symbolic, 2)
    meant = LiePoissonBracket(SO3(), ["L1", "L2", "L3"], read_as="decimal")
    assert SymbolicSystem(meant, given).hamiltonian == x[0] ** 2 / 2 + x[1] ** 2 / 3 + x[2] / 10


BEARERS = [
    {}, {"positive": True}, {"complex": True}, {"integer": True}, {"real": True},
]  # fmt: skip


@pytest.mark.parametrize("assumed", BEARERS, ids=str)
def test_a_symbol_that_bears_a_coordinates_name_is_that_coordinate(assumed):
    """At every door; they were other symbols, of which every bracket vanished."""
    L1, L2, L3 = x = sympy.symbols("L1 L2 L3", **assumed)
    mine = dict(zip(SO3_.coordinates, (1, 2, 4), strict=True))
    assert SO3_(L1, L2) == -SO3_.coordinates[2] and SO3_(L1, L2**2).subs(mine) == -16
    H = sum(v**2 / (2 * i) for v, i in zip(x, sympy.symbols("I1 I2 I3", **assumed), strict=True))
    system = SymbolicSystem(SO3_, H)
    assert system.hamiltonian == BODY.hamiltonian and system.equations == BODY.equations
    assert system.is_integral(sum(v**2 for v in x)) and not system.is_integral(L1)
    assert not SO3_.is_casimir(L1) and SO3_.jacobiator(L1, L2**2, L3) == 0
    assert polynomial_integrals(system, 1) == []
    assert second_variation(system, (I1, 0, 0), [sum(v**2 for v in x)]).multipliers == (-1 / (2 * I1),)
    running = system.to_system({"I1": 1, "I2": 2, "I3": 3}, conserved={"size": sum(v**2 for v in x)})
    assert float(running.conserved["size"](jnp.array([1.0, 2.0, 2.0]))) == 9.0
    assert float(compile_expression(L1 * L2, SO3_.coordinates, SO3())(jnp.array([2.0, 3.0, 5.0]))) == 6.0
    with pytest.raises(InvalidInput, match="must commute"):
        system.to_system({"I1": 1, "I2": 2, "I3": 3}, conserved={"first": L1})
    assert Derivation("P", system, Numerical(lambda v: None, [])).system.is_integral(H)


UNKNOWN = sympy.Symbol("L4", real=True)
DOORS = {
    "bracket": lambda: SO3_(UNKNOWN, SO3_.coordinates[0]),
    "equations": lambda: SO3_.hamilton_equations(UNKNOWN**2),
    "jacobiator": lambda: SO3_.jacobiator(*SO3_.coordinates[:2], UNKNOWN),
    "Casimir": lambda: SO3_.is_casimir(UNKNOWN),
    "system": lambda: SymbolicSystem(SO3_, UNKNOWN**2),
    "integral": lambda: BODY.is_integral(UNKNOWN),
    "conserved": lambda: BODY.to_system({"I1": 1, "I2": 2, "I3": 3}, {"F": UNKNOWN}),
    "second variation": lambda: second_variation(BODY, (1, 0, 0), [UNKNOWN]),
    "equilibrium": lambda: second_variation(BODY, (UNKNOWN, 0, 0), []),
    "compiled": lambda: compile_expression(UNKNOWN, SO3_.coordinates, SO3()),
    "form": lambda: kks_form(SO3_, (UNKNOWN, 0, 0), (0, 1, 0)),
}  # fmt: skip


@pytest.mark.parametrize("door", DOORS)
def test_a_symbol_that_is_neither_coordinate_nor_declared_is_refused(door):
    with pytest.raises(InvalidInput, match=r"must be coordinates or declared parameters, here L1.*; got 'L4'"):
        DOORS[door]()


def test_parameters_are_declared_once_and_differ_from_coordinates():
    with pytest.raises(InvalidInput, match="different names; got 'L1' twice"):
        LiePoissonBracket(SO3(), ["L1", "L2", "L3"], parameters=[sympy.Symbol("L1")])
    bracket = LiePoissonBracket(SO3(), ["L1", "L2", "L3"], parameters="a")
    system = SymbolicSystem(bracket, sympy.Symbol("a") * sympy.Symbol("L1"))
    assert [str(s) for s in system.parameters] == ["a"]
    b = sympy.Symbol("b")
    assert [str(s) for s in system.subs({"a": b**2}).parameters] == ["b"]
    with pytest.raises(InvalidInput, match="has symbols"):
        system.to_system({"a": b})
    with pytest.raises(InvalidInput, match=r'must be decimals like "0\.3"'):
        SymbolicSystem(bracket, "__import__('os').getcwd()")


def test_hamilton_equations_are_eulers():
    L1, L2, L3 = SO3_.coordinates
    published = [(I2 - I3) / (I2 * I3) * L2 * L3, (I3 - I1) / (I3 * I1) * L3 * L1, (I1 - I2) / (I1 * I2) * L1 * L2]
    assert all(sympy.simplify(a - b) == 0 for a, b in zip(BODY.equations.values(), published, strict=True))
    assert r"\dot{L_{1}} &=" in BODY.latex()


def bent_body():
    """Return a body with a quartic term and a parameter, from symbols."""
    L1, L2, L3 = SO3_.coordinates
    bent = SymbolicSystem(SO3_, BODY.hamiltonian + k * L1**4 + sympy.cos(L2))
    return bent.to_system({I1: 1, "I2": 2.0, "I3": "3", k: 0.1}, {"size": L1**2 + L2**2 + L3**2})


@pytest.mark.long
def test_a_symbolic_hamiltonian_runs():
    """Against the same system written for JAX."""
    running, inertia = bent_body(), jnp.array([1.0, 2.0, 3.0])
    other = ph.systems.LiePoisson(SO3(), lambda L: jnp.sum(L**2 / inertia) / 2 + 0.1 * L[0] ** 4 + jnp.cos(L[1]))
    points = jnp.asarray(np.random.default_rng(0).normal(size=(5, 3)))
    assert jnp.abs(running.vector_field(0.0, points) - other.vector_field(0.0, points)).max() < 1e-14
    assert jnp.abs(running.energy(points) - other.energy(points)).max() < 1e-14
    assert running.conserved["size"](points[0]) == pytest.approx(float(jnp.sum(points[0] ** 2)), rel=1e-14)


def test_other_values_compile_nothing_again():
    traced = []

    @jax.jit
    def rate(system, point):
        traced.append(system)
        return system.vector_field(0.0, point)

    for first in (1.0, 2.0, 3.0):
        field = rate(BODY.to_system({I1: first, I2: 2.0, I3: 3.0}), jnp.ones(3))
        assert float(field[2]) == pytest.approx(1 / 2 - 1 / first, abs=1e-15)
    assert len(traced) == 1


@pytest.mark.long
def test_it_is_simulated():
    """A free body from symbols against the closed form, and one with a quartic term by what it conserves."""
    times = np.linspace(0.0, 3.0, 4)
    free = BODY.to_system({I1: 1.0, I2: 2.0, I3: 3.0})
    exact = ph.FreeMotion((1.0, 2.0, 3.0), momentum=(0.3, 0.8, 0.5)).momentum(times)
    assert np.abs(np.asarray(ph.simulate(free, [0.3, 0.8, 0.5], times).states) - exact).max() < 1e-14
    moved = ph.simulate(bent_body(), [0.3, 0.8, 0.5], times)
    assert moved.drift["size"] < 1e-12 and moved.drift["energy"] < 1e-12


def test_own_tables_and_the_other_sign_run():
    c = np.zeros((3, 3, 3))
    c[0, 1, 2], c[1, 0, 2], c[1, 2, 0], c[2, 1, 0], c[2, 0, 1], c[0, 2, 1] = 2, -2, 1, -1, 1, -1
    bracket = LiePoissonBracket(c, sign=1)
    system = SymbolicSystem(bracket, sum((k + 1) * x**2 for k, x in enumerate(bracket.coordinates)))
    field = system.to_system().vector_field(0.0, jnp.array([0.3, 0.8, 0.5]))
    place = dict(zip(bracket.coordinates, (0.3, 0.8, 0.5), strict=True))
    mine = [float(e.subs(place)) for e in system.equations.values()]
    assert np.allclose(field, mine, rtol=1e-14)


@pytest.mark.sweep
def test_matrix_algebras_run():
    bracket = LiePoissonBracket(SO(4))
    system = SymbolicSystem(bracket, sum(x**2 / (2 * (k + 1)) for k, x in enumerate(bracket.coordinates)))
    running = system.to_system()
    z = jnp.arange(1.0, 7.0)
    field = running.algebra.to_dual_vector(running.vector_field(0.0, running.algebra.from_dual_vector(z)))
    place = dict(zip(bracket.coordinates, map(float, z), strict=True))
    assert np.allclose(field, [float(e.subs(place)) for e in system.equations.values()], rtol=1e-13)


@pytest.mark.long
def test_the_sphere_has_the_published_form():
    """ω = −area/|L| for the minus bracket (Marsden & Ratiu §14.4), and + for the other."""
    for sign in (-1, 1):
        system = SymbolicSystem(SO3_.with_sign(sign), BODY.hamiltonian)
        result = reduce_to_sphere(system)
        assert result.form == sign and result.area == result.radius
        assert r"\wedge" in result.latex()
    phi, z, L = result.angle, result.height, result.radius
    # canonical in (φ, z): φ̇ = {φ, z} ∂H/∂z
    H = result.hamiltonian
    assert sympy.simplify(result.rates[phi] - sympy.diff(H, z)) == 0
    assert sympy.simplify(result.rates[z] + sympy.diff(H, phi)) == 0
    assert L in H.free_symbols
    with pytest.raises(InvalidInput, match="only so"):
        reduce_to_sphere(SymbolicSystem(SE3_, 0))


def test_kks_form_is_the_numerical_one():
    rng = np.random.default_rng(0)
    mu, x, y = rng.normal(size=(3, 6))
    for sign in (-1, 1):
        mine = kks_form(SE3_.with_sign(sign), list(x), list(y))
        value = float(mine.subs(dict(zip(SE3_.coordinates, mu, strict=True))))
        assert value == pytest.approx(float(ph.poisson.kks_form(ph.algebra.SE3(), mu, x, y, sign)), rel=1e-13)
    # ω(X_F, X_G) = {F, G} for elements dF, dG
    F, G = SE3_.coordinates[0], SE3_.coordinates[4]
    assert kks_form(SE3_, [1, 0, 0, 0, 0, 0], [0, 0, 0, 0, 1, 0]) == SE3_(F, G)


@pytest.mark.parametrize(("call", "message"), [
    (lambda: BODY.to_system({"I1": 1}), "I2, I3 missing"),
    (lambda: BODY.to_system({"I1": 1, "I2": 1, "I3": 1, "J": 2}), "no parameter"),
    (lambda: BODY.subs({"I1": float("nan")}), "finite"),
    (lambda: BODY.to_system({"I1": 1, "I2": 2, "I3": 3}, {"first": SO3_.coordinates[0]}),
     "must commute with the Hamiltonian; first = 'L1' changes at the rate"),
    (lambda: SymbolicSystem(SO3(), 0), "LiePoissonBracket"),
    (lambda: compile_expression(I1, SO3_.coordinates, SO3()), "declared parameters, here L1, L2, L3; got 'I1'"),
    (lambda: SymbolicSystem.from_system(DoubleBracket((1.0, 2.0, 3.0), 0.3)), "loses energy"),
    (lambda: SymbolicSystem.from_system(BodyInPotential((1.0, 2.0, 3.0), lambda up: jnp.cos(up[2]))), "polynomial"),
    (lambda: SymbolicSystem.from_system("top"), "Lie–Poisson"),
])  # fmt: skip
def test_mistakes_are_named(call, message, any_type):
    with pytest.raises(InvalidInput, match=message):
        call()
