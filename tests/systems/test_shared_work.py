"""Conserved quantities with common steps: these are made once, and their number grows slowly with the system."""

import inspect
import math
from typing import Any

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np
import pytest

from polhode import fields, systems
from polhode.algebra._joint_functions import JointFunction, evaluate_jointly, evaluate_sizes
from polhode.systems import trajectories
from polhode.taylor import expressions


def manakov(n):
    upper = np.triu(np.random.default_rng(n).normal(size=(n, n)), 1)
    return systems.Manakov(1.0 + np.arange(n) / n), jnp.asarray(upper - upper.T)


def toda(n):
    return fields.Toda(n), jnp.asarray(np.random.default_rng(n).normal(size=2 * n - 1))


def steps(function, *arguments):
    """Return names and sizes of the results of all steps, those within other steps among them."""

    def within(jaxpr):
        for step in jaxpr.eqns:
            inner = [p.jaxpr for p in step.params.values() if hasattr(p, "jaxpr")]
            if inner:
                for each in inner:
                    yield from within(each)
            else:
                yield step.primitive.name, sum(math.prod(x.aval.shape) for x in step.outvars)

    return list(within(jax.make_jaxpr(function)(*arguments).jaxpr))


def test_a_common_function_is_called_once_for_all_at_one_point():
    calls = []

    def joint(point):
        calls.append(point)
        return {"sum": point[0] + point[1], "product": point[0] * point[1]}

    functions = {name: JointFunction(joint, name) for name in ("sum", "product")} | {"own": lambda point: point[0]}
    point = np.array([2.0, 3.0])
    assert evaluate_jointly(functions, point) == {"sum": 5.0, "product": 6.0, "own": 2.0} and len(calls) == 1
    assert functions["product"](point) == 6.0 and len(calls) == 2
    assert evaluate_sizes(functions, point) == {}  # as none says them


def test_other_quantities_of_a_subclass_take_the_place_of_common_ones():
    class Changed(fields.Toda):
        @property
        def extra_invariants(self):
            return {"half": lambda point: 0.5 * point[..., 0]}

    make: Any = Changed
    system, point = make(3), jnp.arange(1.0, 6.0)
    values = system.invariants(point)
    assert float(values["half"]) == 0.5 and not any(name.startswith("tr") for name in values)
    assert system.invariant_sizes(point) == {}


@pytest.mark.parametrize("n", [2, 3, 4, 7])
def test_traces_of_a_toda_lattice_are_those_of_eigenvalues(n):
    system, point = toda(n)
    eigenvalues, values = np.linalg.eigvalsh(np.asarray(system.matrix(point))), system.invariants(point)
    for k in range(3, n + 1):
        wanted, size = np.sum(eigenvalues**k), np.sum(np.abs(eigenvalues) ** k)
        assert abs(float(values[f"tr L^{k}"]) - wanted) < 1e-14 * n * size


@pytest.mark.parametrize("n", [3, 4, 5, 6])
def test_coefficients_of_a_body_are_those_of_traces_at_many_s(n):
    system, point = manakov(n)
    values, square = system.invariants(point), np.diag(np.asarray(system.masses) ** 2)
    for k in range(3, n + 1):
        # a polynomial of degree k in s from its values at k + 1 roots of unity
        roots = np.exp(2j * np.pi * np.arange(k + 1) / (k + 1))
        traces = [np.trace(np.linalg.matrix_power(np.asarray(point) + s * square, k)) for s in roots]
        coefficients = np.fft.fft(traces) / (k + 1)
        largest = np.abs(coefficients).max()
        for j in range(1, k - 1):
            name = f"s^{j} of tr (M + sΛ²)^{k}"
            assert (name in values) == ((k - j) % 2 == 0)
            assert abs(coefficients[j] - float(values.get(name, 0.0))) < 1e-13 * n * largest


@pytest.mark.parametrize(("system", "point"), [toda(3), toda(6), manakov(3), manakov(5)])
def test_sizes_are_those_of_gradients(system, point):
    sizes = system.invariant_sizes(point)
    assert list(sizes) == list(system.extra_invariants)
    for name, function in system.extra_invariants.items():
        wanted = float(jnp.sum(jnp.abs(point * jax.grad(function)(point))))
        assert abs(float(sizes[name]) - wanted) < 1e-13 * wanted
    batch = system.invariant_sizes(jnp.stack([point, 2.0 * point]))
    assert all(value.shape == (2,) for value in batch.values())


def test_steps_of_invariants_grow_no_faster_than_their_number():
    """Of n particles there are n traces; of n dimensions some n²/4 coefficients. Without sharing it was n² and n⁴."""
    chains, bodies = ([len(steps(system.invariants, point)) for system, point in map(make, (8, 16, 32))]
                      for make in (toda, manakov))  # fmt: skip
    assert chains[1] < 2.1 * chains[0] and chains[2] < 2.1 * chains[1]
    assert bodies[1] < 4.1 * bodies[0] and bodies[2] < 4.1 * bodies[1]
    products = [name for name, _ in steps(toda(32)[0].invariants, toda(32)[1]) if name == "dot_general"]
    assert len(products) == 15  # L², …, L^16


def test_sizes_of_terms_take_one_product_of_matrices_for_each_power():
    """Differentiated, each of n traces would take all products of matrices backwards; the values take half as many."""

    terms = inspect.unwrap(trajectories._terms)

    def numbers(n):
        system, point = toda(n)
        return sum(size for name, size in steps(lambda x: terms(system, x), point) if name == "dot_general")

    assert numbers(16) == (14 + 7) * 16**2 and numbers(32) == (30 + 15) * 32**2


def test_gradients_add_up_in_proportion_to_what_there_is(monkeypatch):
    """A component in many products receives one slope from each, which were added up anew at each arrival."""
    additions = []

    def add(tape):
        def counted(a, b):
            additions.append(1)
            return a + b

        return counted

    monkeypatch.setattr(expressions.Tape, "add", property(add))

    def count(n):
        tape = expressions.Tape(n)
        first, *others = tape.state()
        whole = tape.total([first * other for other in others])
        additions.clear()
        slopes = expressions.gradient(whole)
        assert slopes[0].terms == dict.fromkeys(range(1, n), 1.0) and slopes[n - 1].terms == {0: 1.0}
        return len(additions)

    assert count(100) < 2.1 * count(50)


def test_systems_with_arrays_share_work_within_other_functions():
    """As methods of modules with arrays have neither a hash nor one identity."""
    system, point = manakov(4)
    alone = system.invariants(point)
    traced = eqx.filter_jit(lambda s, x: s.invariants(x))(system, point)
    for name, value in alone.items():
        np.testing.assert_allclose(traced[name], value, rtol=1e-13, atol=1e-13)
