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

LONG_ENOUGH = 1500.0
"""Seconds for a group; compiling takes half a minute to two."""
KINDS = {"FreeMotion": FreeMotion, "LagrangeMotion": LagrangeMotion}
LEFT_OUT = {
    "batch_shape": "a shape",
    "from_body": "takes a body, whose numbers are known",
    "along_principal_axes": "gives a motion, whose methods are tested",
    "sample": "a trajectory for files and pictures, made of state",
}
EVALUATIONS = {"state", "attitude", "momentum", "angular_velocity", "rotation_matrix"}

HEAD = """
import jax
jax.config.update("jax_enable_x64", True)
import jax.numpy as jnp
import numpy as np
import polhode as ph

kind, names = {kind!r}, {names!r}
given = dict(FreeMotion=([[1.0, 2.0, 3.3]] * 3,), LagrangeMotion=([[1.0, 1.0, 0.5]] * 3, [0.7] * 3))[kind]
attitudes = np.array([[0.5, 0.5, 0.5, 0.5], [0.5, -0.5, 0.5, -0.5], [0.8, 0.6, 0.0, 0.0]])
given += (np.array([[0.3, 1.8, 1.5], [0.9, 0.1, 0.2], [0.2, -0.3, 1.0]]), attitudes, np.array([0.0, 0.1, 0.2]))
given = tuple(map(np.asarray, given))
times, h = np.array([1.0, 2.0, 3.0]), 1e-5
make = getattr(ph, kind)
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
    wanted = alone(plain, times)
    near(flat(jax.jit(alone)(motion, times)), wanted, 1e-13, name)
    near(flat(jax.jit(jax.vmap(alone))(motion, times)), wanted, 1e-13, "vmap " + name)
"""
NUMBERS = """
motion = make(*map(jnp.asarray, given))
for name in names:
    near(flat(jax.jit(lambda m: getattr(m, name))(motion)), getattr(plain, name), 1e-12, name)
"""
SLOPES_OF_NUMBERS = """
motion = make(*map(jnp.asarray, given))
names = [n for n in names if np.issubdtype(np.asarray(jax.tree.leaves(getattr(plain, n))[0]).dtype, np.floating)]
arrays = given[:-1]
ways = tuple(np.random.default_rng(1).normal(size=x.shape) * 0.3 for x in arrays)
numbers = lambda *x: [getattr(make(*x, given[-1]), n) for n in names]
step = 1e-6
ahead, behind = (numbers(*(x + s * step * v for x, v in zip(arrays, ways))) for s in (1, -1))
slope = jax.tree.map(lambda a, b: (a - b) / (2 * step), ahead, behind)
whole = lambda *x: flat(numbers(*x))
both = lambda x, v: (jax.jvp(whole, x, v)[1], jax.vjp(whole, *x)[1](jnp.ones_like(whole(*x))))
found, pull = jax.jit(both)(arrays, ways)
near(found, slope, 1e-6, "jvp of " + ", ".join(names))
along = sum(np.sum((np.asarray(a) * v).reshape(3, -1), axis=1) for a, v in zip(pull, ways))
near(along[:, None], np.asarray(found).sum(axis=1)[:, None], 1e-10, "vjp of " + ", ".join(names))
"""
DERIVATIVES = """
motion = make(*map(jnp.asarray, given))
for name in names:
    alone = lambda m, t: getattr(m, name)(t)
    slope = (alone(plain, times + h) - alone(plain, times - h)) / (2 * h)
    change = jax.jit(lambda m, t: jax.jvp(lambda t: alone(m, t), (t,), (jnp.ones(3),))[1])(motion, times)
    near(change, slope, 1e-8, "jvp " + name)
    one = lambda m, t: jax.grad(lambda t: alone(m, t)[1])(t)
    near(flat(jax.jit(jax.vmap(one))(motion, times)), slope[:, 1], 1e-8, "vmap of grad " + name)
"""
MADE_WITHIN = """
alone = lambda *x: getattr(make(*x[:-1]), names[0])(x[-1])
near(jax.jit(alone)(*given, times), alone(*given, times), 1e-13, names[0])
"""


def public(kind):
    """Return the names of methods and of properties."""
    found = {name: inspect.getattr_static(kind, name) for name in dir(kind) if not name.startswith("_")}
    of = lambda sort: {name for name, x in found.items() if sort(x)} - set(LEFT_OUT)  # noqa: E731
    return of(inspect.isfunction), of(lambda x: isinstance(x, property))


@pytest.mark.parametrize("kind", KINDS)
def test_no_method_is_forgotten(kind):
    assert public(KINDS[kind])[0] == EVALUATIONS


def cases():
    for kind in KINDS:
        yield kind, VALUES, sorted(EVALUATIONS), f"{kind} evaluations"
        yield kind, NUMBERS, sorted(public(KINDS[kind])[1]), f"{kind} properties"
        yield kind, DERIVATIVES, ["momentum"], f"{kind} derivatives by time"
        yield kind, MADE_WITHIN, ["momentum"], f"{kind} made within"
    yield "FreeMotion", SLOPES_OF_NUMBERS, sorted(public(FreeMotion)[1]), "FreeMotion slopes of properties"


@pytest.mark.sweep
@pytest.mark.parametrize(("kind", "code", "names"), [pytest.param(*c[:3], id=c[3]) for c in cases()])
def test_alone_in_a_compiled_batch(kind, code, names):
    run_limited(HEAD.format(kind=kind, names=names) + code, LONG_ENOUGH)


GIVEN = {"FreeMotion": ((1.0, 2.0, 3.3), (0.3, 1.8, 1.5)), "LagrangeMotion": ((1.0, 1.0, 0.5), 0.7, (0.3, 1.8, 1.5))}


@pytest.mark.parametrize("kind", KINDS)
def test_a_known_motion_keeps_no_traced_numbers(kind):
    """What a property computes within a traced function ends with it; kept, it would be the answer ever after."""
    with jax.enable_x64(True):
        arrays = tuple(map(jnp.asarray, GIVEN[kind]))
        jax.eval_shape(lambda *x: KINDS[kind](*x).energy, *arrays)  # lets JAX take motions apart
        motion = jax.tree.map(jnp.asarray, KINDS[kind](*GIVEN[kind]))
        jax.eval_shape(lambda x: x * motion.precession_rate, 1.0)
        assert not [x for x in jax.tree.leaves(vars(motion)) if isinstance(x, jax.core.Tracer)]


BROKEN = """
plain, motion = np.ones((3, 1)), jnp.ones((3, 1)) * (1.0 + 1e-9)
near(motion, plain, 1e-13, "a value that differs where it is traced")
"""


def test_a_broken_specimen_is_caught():
    with pytest.raises(AssertionError, match="differs where it is traced"):
        run_limited(HEAD.format(kind="FreeMotion", names=[]) + BROKEN, LONG_ENOUGH)
