"""Thresholds of branches of equilibria and of periodic motions, and of searches for them, each on either side."""

from types import SimpleNamespace

import jax.numpy as jnp
import numpy as np
import pytest

import polhode as ph
from polhode.analysis import _branches, continuation, equilibria, periodic_branches
from polhode.analysis._conserved import choose_casimirs
from polhode.analysis.floquet import PeriodicMotion

SO3 = ph.algebra.SO3()
E3 = np.array([0.0, 0.0, 1.0])


def family(make, state, low, high):
    return _branches.Family(make, choose_casimirs(make(low).algebra, None).source, state, low, high)


@pytest.fixture(scope="module")
def bodies():
    """Free bodies by the ratio v of the curvatures of the energy at their third axis."""
    return family(lambda v: ph.systems.FreeRigidBody((1.0, 1.0 / (1.0 / 3.0 + v * 2.0 / 3.0), 3.0)), E3, 0.0, 1.0)


@pytest.fixture(scope="module")
def spins():
    """Spins with an easy axis z in a field, of which one turns over by a fold."""
    make = lambda h: ph.systems.LiePoisson(SO3, lambda m: -0.5 * m[2] ** 2 - 0.3 * m[0] - h * m[2])  # noqa: E731
    return family(make, E3, -1.0, 1.0)


@pytest.fixture(scope="module")
def begin(spins):
    return spins.place(spins.at_value(np.array([0.15, 0.0, 0.99]), 1.0), 1.0)


def test_a_curvature_below_the_threshold_is_flat(bodies):
    assert bodies.place(E3, 1.1e-7).verdict == "stable" and bodies.place(E3, 0.9e-7).verdict == "undecided"


def test_a_weak_part_of_the_poisson_tensor_moves_nothing():
    """On so(3) ⊕ so(3) the second momentum turns at its own size alone."""
    both = ph.algebra.Product(SO3, SO3)
    two = family(lambda v: ph.systems.LiePoisson(both, lambda m: 0.5 * m[0] ** 2 + v * m[3] ** 2), np.ones(6), 0.0, 1.0)
    for size, dimension in ((1.1e-9, 4), (0.9e-9, 2)):
        assert two.equations(np.array([0.0, 0.0, 1.0, 0.0, 0.0, size]), 0.5).leaf.shape == (6, dimension)


def test_a_curve_of_equilibria_needs_some_points(bodies, monkeypatch):
    """Of two equal moments all axes of a circle are at rest."""
    place = bodies.place(E3, 0.0)
    for most, count in ((7, 7), (6, 0)):
        monkeypatch.setattr(_branches, "LIMITS", _branches.BranchLimits(max_places=most))
        points, closes = _branches.trace_family(bodies, place)
        assert len(points) == count and not closes


def test_newtons_method_has_a_number_of_steps(spins, begin, monkeypatch):
    guess, along = begin.vector + 0.01 * begin.tangent[:3], begin.tangent
    assert spins.settle(guess, 1.0, along) is not None
    monkeypatch.setattr(_branches, "LIMITS", _branches.BranchLimits(max_newton_steps=1))
    assert spins.settle(guess, 1.0, along) is None


@pytest.mark.filterwarnings("error")
def test_a_branch_is_followed_to_the_end(spins, begin):
    assert _branches.follow(spins, begin)[-1].value == -1.0


@pytest.mark.parametrize("changed", [{"max_places": 5}, {"shortest_step": 0.01}, {"min_cosine": 1.0}])
def test_a_branch_that_is_given_up_says_so(spins, begin, monkeypatch, changed):
    monkeypatch.setattr(_branches, "LIMITS", _branches.BranchLimits(**changed))
    with pytest.warns(UserWarning, match="a branch of equilibria could not be followed"):
        assert len(_branches.follow(spins, begin)) <= 5


@pytest.mark.long
def test_steps_have_a_length(spins, begin, monkeypatch):
    monkeypatch.setattr(_branches, "LIMITS", _branches.BranchLimits(longest_step=0.1))
    few = len(_branches.follow(spins, begin))
    monkeypatch.setattr(_branches, "LIMITS", _branches.BranchLimits(longest_step=0.02))
    assert len(_branches.follow(spins, begin)) > 3 * few


def test_places_nearer_than_the_threshold_are_one(spins, begin):
    path = [begin, *_branches.follow(spins, begin)[1:4]]
    atlas = continuation._Atlas(spins, [path], [], [])
    for off, number in ((0.9e-5, 0), (1.1e-5, None)):
        aside = path[1]._replace(vector=path[1].vector + off * np.array([0.0, 1.0, 0.0]))
        assert atlas.find_branch(aside) == number


def stub(value=0.0, vector=(0.0, 0.0, 1.0), along=0.0, exponents=(0.0,), negative=0):
    """Return a place, with the part of its direction along the parameter."""
    tangent = np.array([np.sqrt(1.0 - along**2), 0.0, 0.0, along])
    return _branches.Place(np.array(vector), value, tangent, negative, np.zeros((3, 0)), np.eye(3)[0], 1.0, 0.0,
                           np.array(exponents, complex), 1e-9)  # fmt: skip


def test_a_fold_has_its_extreme_or_no_part_along_the_parameter(any_type):
    atlas = continuation._Atlas(None, [], [], [])
    assert atlas._turns(stub(0.0), stub(0.2, along=0.5), stub(0.1))
    assert not atlas._turns(stub(0.0), stub(1.0, along=0.5), stub(2.0))
    assert atlas._turns(stub(0.0), stub(1.0, along=0.9e-3), stub(2.0))
    assert not atlas._turns(stub(0.0), stub(1.0, along=1.1e-3), stub(2.0))


@pytest.mark.parametrize(("value", "off", "inside"), [
    (0.019, 0.0, True), (0.021, 0.0, False), (0.0, 0.039, True), (0.0, 0.041, False),
])  # fmt: skip
def test_a_family_of_equilibria_has_a_neighbourhood(value, off, inside):
    atlas = continuation._Atlas(SimpleNamespace(range=2.0, size=1.0), [], [], [])
    assert atlas._is_in_family(stub(value, (off, 0.0, 1.0)), stub(), np.array([[0.0, 0.0, 1.0]])) is inside


@pytest.mark.parametrize(("imaginary", "kind"), [(1.1e-6, "Hamiltonian Hopf"), (0.9e-6, "exchange")])
def test_exponents_that_oscillate_make_a_hopf_bifurcation(imaginary, kind, any_type):
    path = [stub(), stub(1.0, exponents=[1.0 + 1j * imaginary])]
    assert [name for name, _ in continuation._exchanges(SimpleNamespace(between=lambda *_: None), path)] == [kind]


@pytest.mark.parametrize(("departure", "kind"), [(2.1e-8, "transcritical"), (1.9e-8, "branch point")])
def test_another_branch_must_leave_the_value_where_it_begins(monkeypatch, departure, kind):
    monkeypatch.setattr(continuation, "trace_family", lambda *_: (np.zeros((0, 3)), False))
    monkeypatch.setattr(continuation, "step_onto_branch", lambda *_: [stub(departure), stub(-departure)])
    monkeypatch.setattr(continuation._Atlas, "find_branch", lambda *_: 0)
    atlas = continuation._Atlas(SimpleNamespace(range=2.0), [[]], [], [])
    atlas._split(stub(), 0)
    assert atlas.meetings[0][0] == kind


@pytest.mark.filterwarnings("error")
def test_there_is_a_number_of_branches(any_type):
    atlas = continuation._Atlas(None, [[]] * 63, [], [])
    atlas.add([])
    assert len(atlas.paths) == 64
    with pytest.raises(UserWarning, match="more than 64 branches"):
        atlas.add([])


@pytest.mark.parametrize(("moves", "count"), [
    ({"distance": 1.1e-6}, 2), ({"distance": 0.9e-6}, 1), ({"residual": 0.9e-10}, 2), ({"residual": 1.1e-10}, 1),
    ({"field": 0.9e-8}, 2), ({"field": 1.1e-8}, 1),
])  # fmt: skip
def test_roots_that_are_equilibria_and_differ(monkeypatch, moves, count):
    """Of two roots the second is moved away from the first, off its level, or off rest."""
    root = np.array([1.0, moves.get("distance", 1.0), 0.0])
    solved = (np.array([[1.0, 0.0, 0.0], root]), np.array([0.0, moves.get("residual", 0.0)]),
              np.array([0.0, moves.get("field", 0.0)]), np.zeros(2), np.zeros(2))  # fmt: skip
    monkeypatch.setattr(equilibria, "_solve", lambda *_: solved)
    assert len(equilibria.find_equilibria(ph.systems.FreeRigidBody((1.0, 2.0, 3.0)), E3)) == count


@pytest.mark.parametrize(("imaginary", "kinds"), [(0.9e-7, (1, 0, 0)), (1.1e-7, (0, 0, 1))])
def test_multipliers_that_are_real_but_for_rounding(imaginary, kinds):
    multipliers = np.array([1.0, 2.0 + 2j * imaginary])
    motion = PeriodicMotion(E3, 1.0, 0.0, np.eye(2), multipliers, np.full(2, 1e-9))
    assert periodic_branches._Family._kinds(SimpleNamespace(_trivial=1), motion) == kinds


@pytest.mark.parametrize(("size", "trivial"), [(1.1e-8, 3), (0.9e-8, 2)])
def test_conserved_quantities_that_depend_on_each_other(monkeypatch, size, trivial):
    slopes = np.array([[1.0, 0.0, 0.0], [0.0, size, 0.0]])
    monkeypatch.setattr(periodic_branches, "_levels_and_slopes", lambda *_: (np.zeros(2), slopes))
    begin = PeriodicMotion(E3, 1.0, 0.0, np.eye(3), np.ones(3), np.zeros(3))
    family = periodic_branches._Family(lambda value: None, np.array([0.0, 1.0]), begin, 0.0, False)
    assert family._trivial == trivial


class Cycle(ph.systems.AbstractSystem):
    """r' = r (μ − r²), at an even rate round."""

    mu: float

    def vector_field(self, t, state):
        x, y = state
        growth = self.mu - x * x - y * y
        return jnp.stack([growth * x - 2.0 * y, growth * y + 2.0 * x])

    def invariants(self, state):
        return {}


@pytest.mark.long
@pytest.mark.parametrize("changed", [{}, {"shortest_step": 0.02}, {"min_cosine": 1.0}])
def test_a_branch_of_periodic_motions_that_is_given_up_says_so(recwarn, monkeypatch, changed):
    monkeypatch.setattr(periodic_branches, "LIMITS", periodic_branches.PeriodicBranchLimits(**changed))
    branch = periodic_branches.continue_periodic(Cycle, (0.1, 0.15), [0.31, 0.0], 3.1)
    warned = [str(one.message) for one in recwarn if "a branch of periodic motions could not" in str(one.message)]
    assert bool(warned) == bool(changed) and (branch.values[-1] == 0.15) == (not changed)
