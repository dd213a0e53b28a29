"""The function that a verdict holds as data is critical at the equilibrium and has the signature that it says."""

import jax
import jax.numpy as jnp
import numpy as np
import pytest

import polhode as ph
from polhode import analysis, systems
from polhode.analysis.energy_casimir import energy_casimir
from sweeping import only

BODY = systems.FreeRigidBody((1.0, 2.0, 3.0))
TOP = systems.HeavyTop((1.0, 1.0, 0.5), 1.0, (0.0, 0.0, 1.0))
ROTOR = systems.Gyrostat((1.0, 2.0, 3.0), (0.1, 0.2, 0.3))
CRITICAL = 1e-11  # of the terms of dF
CASES = {  # found when they are asked for, not by every worker that collects tests
    "minor axis": (BODY, lambda: [2.0, 0.0, 0.0]),
    "intermediate axis": (BODY, lambda: [0.0, 2.0, 0.0]),
    "major axis": (BODY, lambda: [0.0, 0.0, 2.0]),
    "sleeping top": (TOP, lambda: TOP.upright(5.0)),
    "falling top": (TOP, lambda: TOP.upright(1.0)),
    "hanging top": (TOP, lambda: TOP.upright(5.0, hanging=True)),
    "rotor": (ROTOR, lambda: ph.find_equilibria(ROTOR, np.array([0.3, 0.2, 0.9]))[0]),
}


def case(name):
    system, point = CASES[name]
    return system, np.asarray(point(), float)


def function_of(system, found):
    """F as a function of the point, put together from the data alone."""
    function = found.function

    def values(point):
        return jnp.stack([system.invariants(point)[name] for name in function.names])

    at_rest = values(jnp.asarray(function.point))

    def whole(point):
        kept = values(point)
        energy = function.weights[0] * system.energy(point)
        linear = energy + jnp.asarray(function.weights[1:]) @ kept
        if function.squares is None:
            return linear
        return linear + jnp.asarray(function.squares) @ ((kept - at_rest) / (function.lengths * function.unit)) ** 2

    return whole


def judged(name):
    system, point = case(name)
    found = ph.stability(system, point)
    assert found.function is not None and np.array_equal(found.function.point, point)
    return found, function_of(system, found), jnp.asarray(point)


@pytest.mark.sweep
@pytest.mark.parametrize("name", only(("sleeping top", "intermediate axis"), CASES))
def test_it_is_critical_and_definite_where_it_says_so(name):
    found, function, point = judged(name)
    assert float(jnp.abs(jax.grad(function)(point)).max()) < CRITICAL * (1.0 + float(jnp.abs(point).max()))
    curvatures = np.linalg.eigvalsh(jax.hessian(function)(point))
    positive, flat, negative = found.function.signature
    if found.verdict == "stable":
        # with its squares it is definite in the whole space
        assert not flat and 0 in (positive, negative)
        assert (curvatures > 0.0).all() if positive else (curvatures < 0.0).all()
    else:
        assert positive and negative and curvatures[0] < 0.0 < curvatures[-1]


def test_the_check_sees_another_function():
    found, _, point = judged("sleeping top")
    wrong = found.function.rename({})
    wrong.weights[1] *= 1.01
    assert float(jnp.abs(jax.grad(function_of(TOP, found))(point)).max()) > 1e-3


def test_the_sentence_and_the_report_are_made_of_it():
    found = ph.stability(*case("sleeping top"))
    assert str(found.function) in found.certificate
    called = analysis.top_stability(TOP, 5.0).upright
    assert "|Γ|²" in called.function.names and "|P|²" not in called.certificate


def test_a_negative_weight_of_the_energy_turns_the_signature():
    """Two oscillators of which −H + C alone is definite: F = H − C has only negative curvatures."""
    energy, other = np.diag([-2.0, -2.0, 1.0, 1.0]), np.diag([-1.0, -1.0, 3.0, 3.0])
    turn = np.array([[0.0, 1.0], [-1.0, 0.0]])
    flow = np.block([[turn, np.zeros((2, 2))], [np.zeros((2, 2)), 2.0 * turn]])
    found = energy_casimir(flow, np.zeros(4), energy, [np.zeros(4)], [other], ["C"])
    assert found.verdict == "stable" and found.function is not None and found.function.weights[0] == 1.0
    curvatures = np.linalg.eigvalsh(energy + found.function.weights[1] * other)
    assert found.function.signature == ((curvatures > 0).sum(), 0, (curvatures < 0).sum()) == (0, 0, 4)
    assert "negative definite" in found.certificate
