"""Closures as data: those of one code share what is compiled, and each keeps its own numbers."""

import copy
import functools
import gc
import os
import pickle
import re
import subprocess
import sys
import weakref
from pathlib import Path
from typing import Any

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np
import pytest

import polhode as ph
from polhode import algebra as lie
from polhode.algebra._closures import Closure, take_apart
from polhode.analysis import equilibria
from polhode.analysis._branches import Family
from polhode.analysis._branches import _call as derivatives_along
from polhode.analysis._conserved import Own
from polhode.errors import InvalidInput
from polhode.systems import BodyInPotential, LiePoisson

POINT = np.array([0.3, 1.8, 1.5])
SPACE = jax.ShapeDtypeStruct((3,), float)
WEIGHTS = np.array([1.0, 2.0, 3.0])
UNIT = {"field": 1.0}


def by_cell(a):
    return lambda m: 0.5 * jnp.sum(m**2 / WEIGHTS) - a * m[0]


def by_array(a):
    weights = a * WEIGHTS
    return lambda m: jnp.sum(weights * m**2)


def by_list(a):
    weights = [a, 2.0, 3.0]
    return lambda m: sum(weights[k] * m[k] ** 2 for k in range(3))


def by_default(a):
    return lambda m, b=a: b * m[0] * m[2]


def by_partial(a):
    return functools.partial(lambda b, m: b * m[1] + m[0] ** 2, a)


def by_object(a):
    class Held:
        scale = a

        def value(self, m):
            return self.scale * jnp.sum(m**4)

    return Held().value


def by_nested(a):
    inner = lambda x: a * jnp.where(x > 0.0, x, 0.3 * x)  # noqa: E731
    return lambda m: inner(m[0]) + jnp.linalg.norm(m)


def by_loop(a):
    return lambda m: jax.lax.fori_loop(0, 3, lambda k, total: total + a * m[k] ** 3, 0.0)


def by_while(a):
    body = lambda now: (now[0] + 1, a * now[1] + 0.1)  # noqa: E731
    return lambda m: jax.lax.while_loop(lambda now: now[0] < 3, body, (0, m[0]))[1]


def by_branch(a):
    return lambda m: jax.lax.cond(m[0] > 0.0, lambda x: a * x[1], lambda x: 2.0 * a + x[2], m)


def by_jit(a):
    return jax.jit(lambda m: a * jnp.sum(jnp.sin(a * m)))


def by_jax_number(a):
    number = jnp.asarray(a)
    return lambda m: number * m[2] + number


SAME_CODE = [by_cell, by_array, by_list, by_default, by_partial, by_object, by_nested, by_loop, by_while, by_branch,
             by_jit, by_jax_number]  # fmt: skip


def compiled(function: Any) -> int:
    return function._cached._cache_size()


def value_and_slope(function, point):
    return jax.jvp(function, (point,), (jnp.array([1.0, -2.0, 0.5]),))


evaluate: Any = eqx.filter_jit(value_and_slope)


@pytest.mark.parametrize("made", SAME_CODE)
def test_closures_of_one_code_share_a_program_and_keep_their_numbers(made):
    before = compiled(evaluate)
    # powers of two, zero and one too, which must not become other programs
    for number in (0.7, 0.9, 1.0, 0.0, -2.0):
        plain = made(number)
        got, want = evaluate(take_apart(plain, SPACE), POINT), value_and_slope(plain, jnp.asarray(POINT))
        np.testing.assert_allclose(np.array(got), np.array(want), rtol=1e-14, atol=1e-14)
    assert compiled(evaluate) == before + 1


OTHER_CODE = {
    "another operation": (lambda a: lambda m: a * jnp.sin(m[0]), lambda a: lambda m: a * jnp.cos(m[0])),
    "another element": (lambda a: lambda m: a * m[0], lambda a: lambda m: a * m[1]),
    "another shape": (lambda a: lambda m: jnp.sum(a * m), lambda a: lambda m: jnp.sum(a * jnp.ones(3) * m)),
    "another whole power": (lambda a: lambda m: a * m[0] ** 2, lambda a: lambda m: a * m[0] ** 3),
    "another power": (lambda a: lambda m: a * m[1] ** 1.5, lambda a: lambda m: a * m[1] ** 2.5),
    "another branch of Python": (lambda a: lambda m: m[0] if a > 1.0 else m[1],
                                 lambda a: lambda m: m[0] if a < 1.0 else m[1]),
    "another index": (lambda a: lambda m: a * m[jnp.array([0, 1])].sum(),
                      lambda a: lambda m: a * m[jnp.array([0, 2])].sum()),
}  # fmt: skip


@pytest.mark.parametrize("pair", OTHER_CODE.values(), ids=OTHER_CODE)
def test_other_code_is_another_program(pair):
    one, other = (take_apart(make(0.7), SPACE) for make in pair)
    assert isinstance(one, Closure) and isinstance(other, Closure)
    assert one.code != other.code
    for closure, make in zip((one, other), pair, strict=True):
        assert float(evaluate(closure, POINT)[0]) == pytest.approx(float(make(0.7)(POINT)))


def test_what_is_changed_later_serves_the_next_system_alone():
    """No number of an earlier one may be left in a program; a system keeps those that it was made with."""
    weights, scale = np.array([1.0, 2.0, 3.0]), [2.0]
    energy = lambda m: scale[0] * jnp.sum(weights * m**2) * UNIT["field"]  # noqa: E731

    def slope(system):
        return np.asarray(system.velocity(jnp.asarray(POINT))), np.asarray(eqx.filter_jit(system.velocity)(POINT))

    first = LiePoisson(lie.SO3(), energy)
    before = slope(first)
    np.testing.assert_allclose(before[0], 4.0 * weights * POINT)
    weights[1], scale[0], UNIT["field"] = 5.0, 3.0, 0.5
    try:
        second = LiePoisson(lie.SO3(), energy)
        for got in slope(second):
            np.testing.assert_allclose(got, 3.0 * weights * POINT)
        for got, want in zip(slope(first), before, strict=True):
            np.testing.assert_array_equal(got, want)
    finally:
        UNIT["field"] = 1.0


def twice(x):
    return 2.0 * x


doubled: Any = jax.custom_jvp(twice)
doubled.defjvp(lambda at, changes: (2.0 * at[0], 5.0 * changes[0]))


def test_derivatives_of_a_users_own_stay():
    function = lambda m: doubled(m[0])  # noqa: E731
    assert take_apart(function, SPACE) is function
    assert float(LiePoisson(lie.SO3(), function).velocity(jnp.asarray(POINT))[0]) == 5.0


def test_modules_and_partial_are_data_already():
    for function in (jax.tree_util.Partial(lambda a, m: a * m[0], 0.7), eqx.nn.Lambda(lambda m: m[0])):
        assert take_apart(function, SPACE) is function


def energy_of_module(m):
    return 0.5 * jnp.sum(m**2 / WEIGHTS)


def test_functions_that_can_be_pickled_still_are():
    system = LiePoisson(lie.SO3(), energy_of_module)
    again = pickle.loads(pickle.dumps(system))
    assert again == system and hash(again) == hash(system)
    other = eqx.tree_at(lambda s: s.hamiltonian.arrays, system, (2.0 * jnp.asarray(WEIGHTS),))
    assert pickle.loads(pickle.dumps(other)) == other != system


QUADRATIC = [False]


def energy_that_branches(m):
    return 3.0 * m[0] + (5.0 * m[1] * m[1] if QUADRATIC[0] else 5.0 * m[1])


@pytest.mark.parametrize("copied", [copy.copy, copy.deepcopy])
def test_copies_do_as_the_system_they_are_copies_of(copied, monkeypatch):
    system = LiePoisson(lie.SO3(), energy_that_branches)
    monkeypatch.setattr(sys.modules[__name__], "QUADRATIC", [True])
    assert copied(system) == system and copied(system.hamiltonian) == system.hamiltonian
    assert float(copied(system).energy(jnp.asarray(POINT))) == float(system.energy(jnp.asarray(POINT)))


OTHER_ENERGIES = {
    "other operations": energy_that_branches,
    "more numbers": lambda m: 3.0 * m[0] + 5.0 * m[1] + 0.0,
    "derivatives of its own": lambda m: doubled(m[0]),
}


@pytest.mark.parametrize("other", OTHER_ENERGIES.values(), ids=OTHER_ENERGIES)
def test_pickled_numbers_do_not_go_with_other_operations(other, monkeypatch):
    system = LiePoisson(lie.SO3(), energy_that_branches)
    pickled = pickle.dumps(system)
    assert pickle.loads(pickled) == system
    here = sys.modules[__name__]
    monkeypatch.setattr(here, "QUADRATIC", [True])
    monkeypatch.setattr(here, "energy_that_branches", other)
    with pytest.raises(InvalidInput, match=r"operations that it had when it was pickled.*make the system anew"):
        pickle.loads(pickled)


def test_other_processes_compare_by_the_same_digest():
    """Of loops, branches, indices and solvers, whose parameters are enumerations, sharding and the like."""
    script = (
        "import sys, jax.numpy as jnp; sys.path.insert(0, sys.argv[1]); import test_closures as t; "
        "made = [*(one(0.7) for one in t.SAME_CODE), t.energy_of_many_kinds]; "
        "print(*(t.take_apart(one, t.SPACE).code.digest for one in made))"
    )
    found = []
    for seed in ("1", "2"):
        environment = {**os.environ, "PYTHONHASHSEED": seed}
        made = subprocess.run([sys.executable, "-c", script, str(Path(__file__).parent)], env=environment, check=True,
                              capture_output=True, text=True)  # fmt: skip
        found.append(made.stdout.split())
    assert found[0] == found[1] and len(set(found[0])) == len(SAME_CODE) + 1


def energy_of_many_kinds(m):
    matrix = jnp.outer(m, m) + jnp.eye(3)
    sorted_m = jnp.sort(m)[jnp.argmax(m)]
    return jnp.linalg.solve(matrix, m)[0] + jnp.linalg.eigvalsh(matrix)[2] + m[jnp.array([0, 2])].sum() + sorted_m


@pytest.mark.parametrize("point", [[1, 2, 3], jnp.array([1, 2, 3]), np.array([1.0, 2.0, 3.0], np.float32)])
def test_points_may_have_whole_numbers_and_other_precisions(point):
    system = LiePoisson(lie.SO3(), lambda m: 0.5 * jnp.sum(m**2), {"spin": lambda m: 1.5 * m[2]})
    assert (float(system.hamiltonian(point)), float(system.conserved["spin"](point))) == (7.0, 4.5)


def test_functions_of_one_point_refuse_many():
    system = LiePoisson(lie.SO3(), lambda m: jnp.sum(m**2))
    refusal = re.escape("takes an array of shape (3,); got an array of shape (5, 3).") + ".*jax.vmap"
    with pytest.raises(InvalidInput, match=refusal):
        system.hamiltonian(jnp.ones((5, 3)))
    np.testing.assert_array_equal(jax.vmap(system.hamiltonian)(jnp.ones((5, 3))), np.full(5, 3.0))
    with pytest.raises(InvalidInput, match="got arrays of shape"):
        system.hamiltonian(*jnp.ones((2, 3)))
    with pytest.raises(InvalidInput, match="must be real"):
        system.hamiltonian(jnp.ones(3) * 1j)


def test_closures_may_be_keys():
    one, same, other = (take_apart(by_array(a), SPACE) for a in (0.7, 0.7, 0.9))
    assert len({one, same, other}) == 2
    assert float(jax.jit(one)(POINT)) == pytest.approx(float(by_array(0.7)(POINT)))


@pytest.mark.parametrize("scale", [0.7, jnp.float64(0.7)])
def test_single_numbers_count_however_they_are_held(scale):
    closure = take_apart(lambda m: scale * m[0], SPACE)
    assert isinstance(closure, Closure) and closure.numbers.tolist() == [0.7] and closure.arrays == ()


# ---------------------------------------------------------------------- doors


def spin(axis):
    return lambda field: LiePoisson(lie.SO3(), lambda m: -axis * m[2] ** 2 - field * m[0])


def test_equilibria_of_a_second_closure_compile_nothing():
    search: Any = equilibria._solve
    found = []
    for field in (0.4, 0.7, 1.0):
        before = compiled(search)
        found.append(ph.analysis.find_equilibria(spin(0.5)(field), [0.0, 0.0, 1.0], starts=16))
        compiled_now = compiled(search) - before
        # m = (h, 0, ±√(1 − h²)) where the field is below the anisotropy's, and along the axis of the field
        assert min(np.abs(found[-1] - [field, 0.0, np.sqrt(1.0 - field**2)]).max(axis=1)) < 1e-6
    assert compiled_now == 0 and len(found[0]) == len(found[1]) == 4


@pytest.mark.long
def test_equilibria_of_a_second_family_compile_nothing():
    begin: Any = derivatives_along
    counts = []
    for axis in (0.5, 0.7):
        before = compiled(begin)
        continuation = ph.analysis.continue_equilibria(spin(axis), (0.0, 2.0), [0.0, 0.0, 1.0])
        counts.append(compiled(begin) - before)
        assert [b.value for b in continuation.bifurcations] == pytest.approx([2.0 * axis])
    assert counts == [1, 0]


def test_families_that_are_no_data_are_given_back():
    """No other family can use what is compiled for them: it must not keep them and what they hold."""

    def used():
        rectify: Any = jax.nn.relu  # has derivatives of its own
        family = Family(lambda field: LiePoisson(lie.SO3(), lambda m: rectify(0.5 * m[2] ** 2) - field * m[0]),
                        Own(lie.SO3()), POINT, 0.0, 1.0)  # fmt: skip
        assert family.equations(POINT, 0.5).energy == pytest.approx(0.5 * POINT[2] ** 2 - 0.5 * POINT[0])
        return weakref.ref(family)

    left = used()
    gc.collect()
    assert left() is None


def test_potentials_of_one_code_are_one_structure():
    potentials = [BodyInPotential((1.0, 2.0, 3.0), lambda up, a=a: a * up[2] ** 3) for a in (0.7, 1.0)]
    assert jax.tree.structure(potentials[0]) == jax.tree.structure(potentials[1])
    assert [float(p.energy(jnp.ones(6))) for p in potentials] == pytest.approx([0.7 + 11 / 12, 1.0 + 11 / 12])


def test_integrals_of_one_code_are_one_structure():
    from polhode.analysis._conserved import read_functions

    one, other = (read_functions("integrals", [lambda m, a=a: a * m[2]], lie.SO3()) for a in (0.7, 1.0))
    assert jax.tree.structure(one) == jax.tree.structure(other) and one != other
