"""Stability by differentiation: agrees with the closed forms, and changes at known thresholds."""

import jax.numpy as jnp
import numpy as np
import pytest

import polhode as ph
from polhode import algebra as lie
from polhode import systems
from polhode.analysis.free_axes import axis_stability
from polhode.errors import InvalidInput

BESIDE = 1e-8  # relative distance from a threshold at which the verdict must already be right
RATE = 1e-9


@pytest.mark.long_cases("moments2")
@pytest.mark.parametrize(
    "moments",
    [(1.0, 2.0, 3.0), (3.0, 1.0, 2.0), (1.0, 1.0, 2.0), (1.0, 2.0, 2.0), (2.0, 2.0, 2.0), (1.0, 1.000001, 2.0)],
)
def test_agrees_with_the_closed_forms(moments):
    closed = axis_stability(moments, 2.0)
    for k in range(3):
        found = ph.stability(systems.FreeRigidBody(moments), 2.0 * np.eye(3)[k])
        assert (found.verdict, found.growth) == (closed[k].verdict, closed[k].growth)
        assert found.rate == pytest.approx(closed[k].rate, rel=RATE)


def sleeping(spin, I1=1.0, I3=0.5, weight=1.0):
    top = systems.BodyInPotential((I1, I1, I3), lambda up: weight * up[2])
    return ph.stability(top, np.array([0, 0, I3 * spin, 0, 0, 1.0]), [lambda point: point[2]])


@pytest.mark.long
def test_sleeping_top_at_its_threshold():
    threshold = 2.0 * np.sqrt(1.0 * 1.0) / 0.5
    assert sleeping(threshold * (1 + BESIDE)).verdict == "stable"
    below = sleeping(threshold * (1 - BESIDE))
    assert below.verdict == "unstable"
    # I1² λ² = mgl I1 − I3²ω²/4
    assert below.rate == pytest.approx(np.sqrt(1.0 - 0.25 * (0.5 * threshold * (1 - BESIDE)) ** 2), rel=1e-6)
    assert sleeping(0.0).rate == pytest.approx(1.0, rel=RATE)
    assert sleeping(-2 * threshold).verdict == "stable"


def test_sleeping_top_without_its_integral_is_undecided():
    top = systems.BodyInPotential((1.0, 1.0, 0.5), lambda up: up[2])
    found = ph.stability(top, np.array([0, 0, 0.5 * 5.0, 0, 0, 1.0]))
    assert found.verdict == "undecided" and "gyroscopic" in found.certificate


@pytest.mark.long
def test_hanging_body_is_stable_and_turned_over_it_is_not():
    for sign, verdict in ((-1.0, "stable"), (1.0, "unstable")):
        body = systems.BodyInPotential((1.0, 2.0, 3.0), lambda up: 0.7 * up[2])
        found = ph.stability(body, np.array([0, 0, 0, 0, 0, sign]))
        assert found.verdict == verdict
    assert found.rate == pytest.approx(np.sqrt(0.7), rel=RATE)  # the smaller moment falls faster


def pair(anisotropy):
    """Two spins, −s1·s2 − K (z1² + z2²)."""
    energy = lambda s: -jnp.dot(s[0], s[1]) - anisotropy * (s[0, 2] ** 2 + s[1, 2] ** 2)  # noqa: E731
    return systems.LiePoisson(lie.Power(lie.SO3(), 2), energy, {"Sz": lambda s: s[0, 2] + s[1, 2]})


@pytest.mark.long
def test_spin_pair_on_both_sides_of_its_thresholds():
    down = np.array([[0, 0, 1.0], [0, 0, -1.0]])
    assert ph.stability(pair(1.0 + BESIDE), down).verdict == "stable"
    below = ph.stability(pair(1.0 - BESIDE), down)
    # by hand: λ² = 4K (1 − K) for the mode (s1 + s2, s1 − s2)
    assert below.verdict == "unstable" and below.rate == pytest.approx(2.0 * np.sqrt(BESIDE), rel=1e-6)
    assert ph.stability(pair(0.5), down).rate == pytest.approx(1.0, rel=RATE)
    up = np.array([[0, 0, 1.0], [0, 0, 1.0]])
    assert ph.stability(pair(0.3), up).verdict == "stable"


@pytest.mark.sweep
def test_four_dimensional_body():
    """About a pair of planes; by Manakov's equations, linearised by hand in the test below."""
    body = systems.Manakov((1.0, 2.0, 3.0, 4.0))
    point = body.algebra.from_dual_vector(np.array([1.0, 0.2, 0.3, 0.4, 0.5, 0.6]))
    found = ph.find_equilibria(body, point)
    assert len(found) == 12
    casimirs = np.asarray(body.algebra.casimirs(found))
    assert casimirs == pytest.approx(np.tile(np.asarray(body.algebra.casimirs(point)), (12, 1)), rel=1e-9)
    for equilibrium in found:
        field = np.asarray(body.vector_field(0.0, equilibrium))
        assert np.abs(field).max() < 1e-9
        verdict = ph.stability(body, equilibrium)
        flow = four_dimensional_flow(body, equilibrium)
        assert verdict.verdict == ("unstable" if flow.real.max() > 1e-6 else "stable")
        if verdict.verdict == "unstable":
            assert verdict.rate == pytest.approx(flow.real.max(), rel=1e-7)


def four_dimensional_flow(body, equilibrium):
    """Exponents of δṀ = [δM, Ω] + [M, δΩ] by the matrices of the equation itself."""
    basis = np.asarray(body.algebra.basis)
    sums = np.asarray(body.masses)[:, None] + np.asarray(body.masses)[None, :]
    spin = equilibrium / sums
    columns = [e @ spin - spin @ e + equilibrium @ (e / sums) - (e / sums) @ equilibrium for e in basis]
    return np.linalg.eigvals(np.array([[0.5 * np.sum(b * c) for c in columns] for b in basis]))


def test_intermediate_axis_on_both_sides_of_symmetry():
    """Axis 1 of (1 + δ, 1, 3): the intermediate one for δ > 0, that of least inertia for δ < 0."""
    axis = np.array([1.0, 0.0, 0.0])
    assert ph.stability(systems.FreeRigidBody((1.0 - BESIDE, 1.0, 3.0)), axis).verdict == "stable"
    above = ph.stability(systems.FreeRigidBody((1.0 + BESIDE, 1.0, 3.0)), axis)
    assert above.verdict == "unstable"
    assert above.rate == pytest.approx(np.sqrt(BESIDE * (2.0 - BESIDE) / 3.0) / (1.0 + BESIDE), rel=1e-7)


@pytest.mark.sweep
def test_four_dimensional_body_at_a_threshold():
    """Rotation in plane 12, a little in plane 34: the third mass decides, at a value found by the exponents."""
    def case(third):
        body = systems.Manakov((1.0, 2.0, third, 4.0))
        return body, np.asarray(body.algebra.from_dual_vector(np.array([1.0, 0, 0, 0, 0, 0.05])))

    def grows(third):
        return four_dimensional_flow(*case(third)).real.max() > 1e-6

    low, high = 1.5, 3.0
    assert grows(low) and not grows(high)
    while high - low > 1e-12:
        middle = 0.5 * (low + high)
        low, high = (middle, high) if grows(middle) else (low, middle)
    assert ph.stability(*case(low * (1 - BESIDE))).verdict == "unstable"
    assert ph.stability(*case(high * (1 + BESIDE))).verdict == "stable"


@pytest.mark.long
def test_relative_equilibrium_of_a_symmetric_top():
    """Steady precession at angle θ: mgl = Ω (I3 ω3 − I1 Ω cos θ), stable by reduction of the turn about the axis."""
    I1, I3, weight, theta = 1.0, 0.5, 1.0, np.radians(60)
    spin = 5.0
    top = systems.BodyInPotential((I1, I1, I3), lambda up: weight * up[2])
    rates = np.roots([I1 * np.cos(theta), -I3 * spin, weight])
    for precession in rates:
        up = np.array([np.sin(theta), 0.0, np.cos(theta)])
        point = np.concatenate([[I1 * precession * np.sin(theta), 0.0, I3 * spin], up])
        found = ph.stability(top, point, [lambda p: p[2]])
        assert found.verdict == "stable"
    with pytest.raises(InvalidInput, match="not an equilibrium"):
        ph.stability(top, point)
    point[0] *= 1.01
    with pytest.raises(InvalidInput, match="not a relative equilibrium"):
        ph.stability(top, point, [lambda p: p[2]])


def test_constants_algebra_finds_its_own_casimirs():
    algebra = lie.from_structure_constants(lie.SO3().structure_constants())
    body = systems.LiePoisson(algebra, lambda L: 0.5 * jnp.sum(L**2 / jnp.array([1.0, 2.0, 3.0])))
    found = [ph.stability(body, row) for row in np.eye(3)]
    assert [f.verdict for f in found] == ["stable", "unstable", "stable"]
    assert "x1² + x2² + x3²" in found[0].certificate


@pytest.mark.long
def test_equilibria_of_the_free_body_are_the_axes():
    found = ph.find_equilibria(systems.FreeRigidBody((1.0, 2.0, 3.0)), np.array([0.3, 1.8, 1.5]))
    size = np.linalg.norm([0.3, 1.8, 1.5])
    assert sorted(map(tuple, np.round(found / size) + 0.0)) == sorted(map(tuple, np.vstack([np.eye(3), -np.eye(3)])))
    assert np.abs(np.linalg.norm(found, axis=1) - size).max() < 1e-12
    energies = 0.5 * np.sum(found**2 / np.array([1.0, 2.0, 3.0]), axis=1)
    assert (np.diff(energies) > -1e-12).all()


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda b: ph.stability(b, np.ones((2, 3))), "one point"),
        (lambda b: ph.stability(b, np.ones(4)), "shape"),
        (lambda b: ph.stability(b, np.array([1.0, np.nan, 0.0])), "finite"),
        (lambda b: ph.stability(b, np.ones(3)), "not an equilibrium"),
        (lambda b: ph.find_equilibria(b, np.zeros(3)), "other than zero"),
    ],
)
def test_bad_input(call, words):
    with pytest.raises(InvalidInput, match=words):
        call(systems.FreeRigidBody((1.0, 2.0, 3.0)))


@pytest.mark.long_after(1)
@pytest.mark.parametrize("power", [3, 4])
def test_degenerate_equilibria_are_found_as_exactly_as_others(power):
    """H = z²/2 + xⁿ on the sphere: at (0, ±1, 0) Newton's method comes nearer by equal factors, and stops before."""
    own = systems.LiePoisson(ph.algebra.SO3(), lambda S: 0.5 * S[2] ** 2 + S[0] ** power)
    found = ph.find_equilibria(own, [0.0, 1.0, 0.0])
    degenerate = found[np.abs(found[:, 1]) > 0.5]
    np.testing.assert_array_equal(degenerate[np.argsort(degenerate[:, 1])], [[0.0, -1.0, 0.0], [0.0, 1.0, 0.0]])
    assert [ph.stability(own, point).verdict for point in degenerate] == ["undecided"] * 2
    for point in found:
        ph.stability(own, point)  # which refuses what is no equilibrium
