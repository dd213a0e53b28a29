"""What NumPy does in place of JAX with the known numbers of a jaxpr."""

import jax
import jax.numpy as jnp
import numpy as np
import pytest

from polhode.taylor._known_numbers import BY_NUMPY, by_numbers

A = np.random.default_rng(0).uniform(0.2, 1.5, (2, 3, 4))
B = np.random.default_rng(1).uniform(0.2, 1.5, (2, 3, 4))
WHOLE = np.array([7, -7, 5])
OPERATIONS = {
    "div": (lambda a, b: a / b, A, B),
    "div of whole numbers": (lambda a: jax.lax.div(a, jnp.array([2, 2, -3])), WHOLE),
    "integer_pow": (lambda a: a**-3, A),
    "square": (jnp.square, A),
    "sqrt": (jnp.sqrt, A),
    "sin": (jnp.sin, A),
    "cos": (jnp.cos, A),
    "abs": (jnp.abs, A - 1.0),
    "max": (jnp.maximum, A, B),
    "min": (jnp.minimum, A, B),
    "reduce_max": (lambda a: jnp.max(a, axis=(0, 2)), A),
    "reduce_sum": (lambda a: jnp.sum(a, axis=1), A),
    "dot_general": (lambda a, b: jnp.einsum("kij,klj->kil", a, b), A, B),
    "dot_general of vectors": (jnp.dot, A[0, 0], B[0, 0]),
    "dot_general of matrices": (jnp.matmul, A[0], B[0].T),
    "eq": (lambda a, b: a == b, A, B),
    "ne": (lambda a, b: a != b, A, B),
    "le": (lambda a, b: a <= b, A, B),
    "gt": (lambda a, b: a > b, A, B),
    "and": (lambda a: (a > 0.3) & (a < 1.0), A),
    "or": (lambda a: (a < 0.3) | (a > 1.0), A),
    "not": (lambda a: ~(a < 0.3), A),
    "iota": (lambda a: a + jax.lax.broadcasted_iota(float, (2, 3, 4), 1), A),
    "stack": (lambda a, b: jnp.stack([a, b], axis=-1), A, B),
}


def evaluate(closed, arguments):
    known = dict(zip(closed.jaxpr.invars, arguments, strict=True)) | dict(
        zip(closed.jaxpr.constvars, map(np.asarray, closed.consts), strict=True))  # fmt: skip
    for equation in closed.jaxpr.eqns:
        operands = [np.asarray(known.get(v) if not hasattr(v, "val") else v.val) for v in equation.invars]
        inner = equation.params.get("jaxpr")
        values = by_numbers(equation, operands) if inner is None else evaluate(inner, operands)
        known.update(zip(equation.outvars, values, strict=True))
    return [known[v] for v in closed.jaxpr.outvars]


@pytest.mark.parametrize("name", OPERATIONS)
def test_numbers_are_those_of_jax(name):
    assert name.partition(" ")[0] in BY_NUMPY
    function, *arguments = OPERATIONS[name]
    [value], wanted = evaluate(jax.make_jaxpr(function)(*arguments), arguments), np.asarray(function(*arguments))
    assert value.dtype == wanted.dtype and value.shape == wanted.shape
    np.testing.assert_allclose(value, wanted, rtol=1e-15 if wanted.dtype == float else 0.0)
