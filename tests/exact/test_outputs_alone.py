"""Every method and property of a motion alone in a compiled function: what is not asked for is dropped, and it ends.

Each runs in a process of its own, as nothing else stops XLA while it compiles.
"""

import inspect

import jax
import jax.numpy as jnp
import pytest

from limited import run_limited
from polhode.exact.free_body import FreeMotion
from polhode.exact.lagrange_top import LagrangeMotion
from starts import free_motion, lagrange_motion
from sweeping import first

LONG_ENOUGH = 1500.0
"""Seconds for a group; compiling takes half a minute to two."""
KINDS = {"FreeMotion": FreeMotion, "LagrangeMotion": LagrangeMotion}
MAKE = {"FreeMotion": free_motion, "LagrangeMotion": lagrange_motion}
LEFT_OUT = {
    "plot": "a picture",
    "save": "a file of samples",
    "show": "a page",
    "batch_shape": "a shape",
    "free_moments": "the moments as given, or None",
    "quantities": "units and names",
    "from_body": "takes a body, whose numbers are known",
    "along": "gives a motion, whose methods are tested",
    "cycle": "seconds to look at, of one known motion",
    "sample": "a trajectory for files and pictures, made of state",
    "closed_form": "is called by state, with columns of numbers",
    "checked_start": "is called by the constructor",
    "conserved_along": "is called by sample",
    "conserved_sizes": "is called by sample",
    "fastest_rate": "takes numbers that are known, to refuse times",
}
EVALUATIONS = {"state", "attitude", "momentum", "angular_velocity", "rotation_matrix"}

HEAD = """
import jax
jax.config.update("jax_enable_x64", True)
import jax.numpy as jnp
import numpy as np
import polhode as ph
from polhode._base.arrays.few_calls import quick_options

QUICKLY = quick_options()

kind, names, numbers = {kind!r}, {names!r}, {numbers!r}
way = ph.closed_forms({where!r})
way.__enter__()
given = dict(FreeMotion=([[1.0, 2.0, 3.3]] * 3,), LagrangeMotion=([[1.0, 1.0, 0.5]] * 3, [0.7] * 3))[kind]
attitudes = np.array([[0.5, 0.5, 0.5, 0.5], [0.5, -0.5, 0.5, -0.5], [0.8, 0.6, 0.0, 0.0]])
given += (np.array([[0.3, 1.8, 1.5], [0.9, 0.1, 0.2], [0.2, -0.3, 1.0]]), attitudes, np.array([0.0, 0.1, 0.2]))
given = tuple(map(np.asarray, given))
times = np.array([1.0, 2.0, 3.0])
inputs = ["mgl"] * (kind == "LagrangeMotion") + ["momentum", "attitude", "epoch"]
make = lambda moments, *rest: getattr(ph, kind)(moments, **dict(zip(inputs, rest)))
plain = make(*given)
flat = lambda found: jnp.concatenate([jnp.reshape(x, (3, -1)) * 1.0 for x in jax.tree.leaves(found)], axis=1)

def near(found, wanted, tolerance, name):
    wanted = np.concatenate([np.reshape(x, (3, -1)) * 1.0 for x in jax.tree.leaves(wanted)], axis=1)
    assert np.allclose(found, wanted, rtol=tolerance, atol=tolerance, equal_nan=True), (name, found, wanted)
"""
VALUES = """
motion = make(*map(jnp.asarray, given))
for name in names:
    alone = lambda m, t: getattr(m, name)(t)
    near(flat(jax.jit(alone)(motion, times)), alone(plain, times), 1e-13, name)
whole = lambda m, t: {name: getattr(m, name)(t) for name in names}
near(flat(jax.jit(jax.vmap(whole), compiler_options=QUICKLY)(motion, times)), whole(plain, times), 1e-13, "vmap")
read = lambda m: {name: getattr(m, name) for name in numbers}
near(flat(jax.jit(read, compiler_options=QUICKLY)(motion)), read(plain), 1e-12, "numbers")
near(flat(jax.jit(jax.vmap(read), compiler_options=QUICKLY)(motion)), read(plain), 1e-12, "numbers under vmap")
for name in numbers:
    read = jax.jit(lambda m: getattr(m, name), compiler_options=QUICKLY)
    near(flat(read(motion)), getattr(plain, name), 1e-12, name)
change = jax.jit(lambda m, t: jax.jvp(m.momentum, (t,), (jnp.ones(3),))[1], compiler_options=QUICKLY)(motion, times)
slope = (plain.momentum(times + 1e-5) - plain.momentum(times - 1e-5)) / 2e-5
near(change, slope, 1e-8, "jvp by time")
one = lambda m, t: jax.grad(lambda t: m.momentum(t)[1])(t)
near(flat(jax.jit(jax.vmap(one), compiler_options=QUICKLY)(motion, times)), slope[:, 1], 1e-8, "vmap of grad by time")
"""
SLOPES = """
is_float = lambda x: np.issubdtype(np.asarray(jax.tree.leaves(x)[0]).dtype, np.floating)
numbers = [n for n in numbers if is_float(getattr(plain, n))]
ways = [np.random.default_rng(1).normal(size=x.shape) * 0.3 for x in given]
if kind == "LagrangeMotion":
    ways[0][:, 1] = ways[0][:, 0]  # I1 = I2 is one quantity
ways = tuple(ways)
step = 1e-6

def agree(name, function, *, compiled):
    ahead, behind = (function(*(x + s * step * v for x, v in zip(given, ways))) for s in (1, -1))
    slope = jax.tree.map(lambda a, b: (a - b) / (2 * step), ahead, behind)
    whole = lambda *x: flat(function(*x))
    def both(x, v):
        return *jax.jvp(whole, x, v), jax.vjp(whole, *x)[1](jnp.ones(whole_shape))
    whole_shape = jax.eval_shape(whole, *map(jnp.asarray, given)).shape
    traced = jax.jit(both, compiler_options=QUICKLY) if compiled else both
    value, found, pull = traced(tuple(map(jnp.asarray, given)), tuple(map(jnp.asarray, ways)))
    near(value, function(*given), 1e-12, name)
    near(found, slope, 1e-6, "jvp of " + name)
    along = sum(np.sum((np.asarray(a) * v).reshape(3, -1), axis=1) for a, v in zip(pull, ways))
    near(along[:, None], np.asarray(found).sum(axis=1)[:, None], 1e-10, "vjp of " + name)

def numbers_and_momentum(*x):
    motion = make(*x)
    return [*(getattr(motion, n) for n in numbers), motion.momentum(times)]

agree("numbers and momentum", numbers_and_momentum, compiled=True)  # of one construction, the attitude dropped
for name in names:  # the stages are compiled by themselves, once for all
    agree(name, lambda *x: getattr(make(*x), name)(times), compiled=False)
"""


def public(kind):
    """Return the names of methods and of properties."""
    found = {name: inspect.getattr_static(kind, name) for name in dir(kind) if not name.startswith("_")}
    of = lambda sort: {name for name, x in found.items() if sort(x)} - set(LEFT_OUT)  # noqa: E731
    return of(inspect.isfunction), of(lambda x: isinstance(x, property))


@pytest.mark.parametrize("kind", KINDS)
def test_no_method_is_forgotten(kind):
    assert public(KINDS[kind])[0] == EVALUATIONS


@pytest.mark.sweep
@pytest.mark.parametrize("where", first(1, ["host", "compiled"]))
@pytest.mark.parametrize("code", [VALUES, pytest.param(SLOPES, marks=pytest.mark.sweep)], ids=["values", "slopes"])
@pytest.mark.parametrize("kind", first(1, KINDS))
def test_alone_in_a_compiled_batch(kind, code, where):
    names, numbers = (sorted(found) for found in public(KINDS[kind]))
    run_limited(HEAD.format(kind=kind, names=names, numbers=numbers, where=where) + code, LONG_ENOUGH)


GIVEN = {"FreeMotion": ((1.0, 2.0, 3.3), (0.3, 1.8, 1.5)), "LagrangeMotion": ((1.0, 1.0, 0.5), 0.7, (0.3, 1.8, 1.5))}


@pytest.mark.parametrize("kind", KINDS)
def test_a_known_motion_keeps_no_traced_numbers(kind):
    """What a property computes within a traced function ends with it; kept, it would be the answer ever after."""
    with jax.enable_x64(True):
        arrays = tuple(map(jnp.asarray, GIVEN[kind]))
        jax.eval_shape(lambda *x: MAKE[kind](*x).energy, *arrays)  # lets JAX take motions apart
        motion = jax.tree.map(jnp.asarray, MAKE[kind](*GIVEN[kind]))
        jax.eval_shape(lambda x: x * motion.precession_rate, 1.0)
        assert not [x for x in jax.tree.leaves(vars(motion)) if isinstance(x, jax.core.Tracer)]


BROKEN = """
plain, motion = np.ones((3, 1)), jnp.ones((3, 1)) * (1.0 + 1e-9)
near(motion, plain, 1e-13, "a value that differs where it is traced")
"""


@pytest.mark.long
def test_a_broken_specimen_is_caught():
    with pytest.raises(AssertionError, match="differs where it is traced"):
        run_limited(HEAD.format(kind="FreeMotion", names=[], numbers=[], where="host") + BROKEN, LONG_ENOUGH)
