"""Functions of rotations, elliptic integrals and theta functions alone under jit, vmap, jvp and grad, against NumPy.

Functions are found, not listed: a new one without arguments here fails. ``test_outputs_alone`` does motions.
"""

import importlib
import inspect

import jax
import jax.numpy as jnp
import numpy as np
import pytest

from polhode._base.arrays.few_calls import quick_options

ROOMS = ("rotation", "special.carlson", "special.elliptic", "special.theta")
LEFT_OUT = {
    "rotation.product_of_parts": "takes columns, and is called by multiply",
    "rotation.product_with_vector": "takes columns, and is called by quaternion_rate",
    "rotation.cross_of_parts": "takes columns, and is called by shortest_between",
    "rotation.as_scipy": "gives an object of SciPy, which no tracer can be in",
    "rotation.from_euler_angles": "takes a word too; a product of three of from_axis_angle",
    "rotation.from_scipy": "takes an object of SciPy",
    "special.elliptic.jacobi_at_reduced_phase": "inner part of jacobi, with flags",
    "special.elliptic.sd_squared_over_half_period": "inner part of the motions' derivatives, with flags",
    "special.theta.theta": "takes the number of a theta function; theta1 to theta4 call it",
}
SAME = 1e-13
"""Relative to 1: two evaluations of one formula, of a size of one or so."""
BY_DIFFERENCES, STEP = 1e-7, 1e-6
"""Central differences leave h² = 1e-12 and rounding over h, 1e-10; with room for third derivatives of ten."""
RNG = np.random.default_rng(5)
TURN = RNG.normal(size=(3, 4))
VECTOR = RNG.normal(size=(3, 3))
UPPER = RNG.uniform(0.2, 0.8, 3)
BY_NAME = {
    "quaternion": TURN / np.linalg.norm(TURN, axis=-1, keepdims=True), "p": UPPER + 1.0, "q": 0.1 * UPPER,
    "vector": VECTOR, "angular_velocity": VECTOR, "axis": VECTOR, "start": VECTOR, "end": VECTOR[[1, 2, 0]],
    "angle": UPPER, "x": UPPER,
    "y": UPPER[::-1] + 0.3, "z": UPPER + 0.5, "u": UPPER, "m1": UPPER, "n": 0.5 * UPPER, "parameter": 0.5 * UPPER,
    "k": np.sqrt(1.0 - 0.5 * UPPER),
}  # fmt: skip
AT_ONCE = ("special.carlson.carlson_rd", "special.theta.theta1")
"""Of the functions that are compiled for seconds; the others in the sweep."""
QUATERNIONS = {"p": BY_NAME["quaternion"], "q": BY_NAME["quaternion"][[1, 2, 0]]}


def arguments_of(room, function):
    found = []
    for parameter in inspect.signature(function).parameters:
        if parameter == "matrix":
            rotation = importlib.import_module("polhode.rotation")
            found.append(np.asarray(rotation.as_matrix(BY_NAME["quaternion"])))
        else:
            found.append((QUATERNIONS if room == "rotation" and parameter in QUATERNIONS else BY_NAME)[parameter])
    return found


def public_functions():
    for room in ROOMS:
        module = importlib.import_module(f"polhode.{room}")
        for name, function in vars(module).items():
            own = inspect.isfunction(function) and function.__module__ == module.__name__
            if own and not name.startswith("_") and f"{room}.{name}" not in LEFT_OUT:
                costly = room.startswith("special.") and f"{room}.{name}" not in AT_ONCE
                yield pytest.param(f"{room}.{name}", marks=[pytest.mark.sweep] if costly else [])


def flat(values, xp):
    values = values if isinstance(values, tuple) else (values,)
    return xp.concatenate([xp.reshape(v, (-1,)) for v in values])


@pytest.mark.long_after(6)
@pytest.mark.long_cases("rotation.shortest_between", "special.carlson.carlson_rd")
@pytest.mark.parametrize("name", list(public_functions()))
def test_alone_under_every_transformation(name):
    room, _, last = name.rpartition(".")
    function = getattr(importlib.import_module(f"polhode.{room}"), last)
    arguments = arguments_of(room, function)
    ways = [RNG.normal(size=x.shape) for x in arguments]
    if last == "from_matrix":  # only changes that leave it a rotation have a meaning
        ways = [arguments[0] @ np.cross(np.eye(3), VECTOR[:, None, :])]
    if last in ("as_matrix", "rotate"):  # only those that leave the quaternion of unit length
        ways[0] = ways[0] - np.sum(ways[0] * arguments[0], axis=-1, keepdims=True) * arguments[0]
    wanted = flat(function(*arguments), np)
    weights = RNG.normal(size=wanted.shape)

    with jax.enable_x64(True):
        inputs, directions = tuple(map(jnp.asarray, arguments)), tuple(map(jnp.asarray, ways))
        for k in range(len(arguments)):  # one traced, the others NumPy's, as under a derivative by one
            jax.eval_shape(lambda x, k=k: function(*arguments[:k], x, *arguments[k + 1 :]), inputs[k])
        whole = lambda *x: flat(function(*x), jnp)  # noqa: E731
        value = jax.jit(whole)(*inputs)
        every = tuple(range(len(inputs)))
        weighed = lambda *x: jnp.vdot(jnp.asarray(weights), whole(*x))  # noqa: E731
        of_vmap_and_both_modes = jax.jit(
            lambda x, v: (jax.vmap(function)(*x), jax.jvp(whole, x, v)[1], jax.grad(weighed, argnums=every)(*x)),
            compiler_options=quick_options(),
        )
        by_vmap, change, slopes = of_vmap_and_both_modes(inputs, directions)
        assert np.abs(np.asarray(value) - wanted).max() < SAME
        assert np.abs(np.asarray(flat(by_vmap, jnp)) - wanted).max() < SAME
        if last != "from_matrix":
            ahead, behind = (flat(function(*(x + s * STEP * v for x, v in zip(arguments, ways, strict=True))), np)
                             for s in (1, -1))  # fmt: skip
            slope = (ahead - behind) / (2 * STEP)
            assert np.abs(np.asarray(change) - slope).max() < BY_DIFFERENCES * (1.0 + np.abs(slope).max())
        there = sum(float(jnp.vdot(a, b)) for a, b in zip(slopes, directions, strict=True))
        assert there == pytest.approx(float(weights @ np.asarray(change)), rel=1e-10, abs=1e-10)
