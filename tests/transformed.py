"""One function alone under jit, jit of vmap of jvp and of grad, against itself on plain numbers and differences."""

import jax
import jax.numpy as jnp
import numpy as np
import pytest

from polhode._base.arrays.few_calls import quick_options
from polhode.errors import InvalidInput

SAME = 1e-12
"""Relative to the largest value: two evaluations of one formula, of condition ten or so."""
BY_DIFFERENCES, STEP = 1e-6, 1e-5
"""Central differences leave h² = 1e-10 and rounding over h, 1e-11; with room for third derivatives of thousands."""
TRANSPOSED = 1e-9
"""Relative: forward and reverse derivative of one formula."""


def real_vector(outputs):
    """Return all numbers of nested outputs as one vector, real and imaginary parts apart."""
    parts = [jnp.zeros(0)]
    for leaf in jax.tree.leaves(outputs):
        leaf = jnp.asarray(leaf)
        both = (leaf.real, leaf.imag) if jnp.iscomplexobj(leaf) else (leaf.astype(jnp.float64),)
        parts += [jnp.reshape(x, (-1,)) for x in both]
    return jnp.concatenate(parts)


def rows(outputs, count):
    """Return what a batch gives, (count, n), from outputs with the batch along their first axes."""
    each = [jax.tree.map(lambda leaf, k=k: jnp.asarray(leaf)[k], outputs) for k in range(count)]
    return jnp.stack([real_vector(one) for one in each])


def check_alone(function, *inputs, batched=True, reverse=True, ways=None):
    """Check a function of real arrays whose first axis is the batch.

    The first point is computed operation by operation too, on plain numbers, before anything is compiled; the others
    and the differences by the function compiled alone.

    Args:
        function: of one point; with ``batched`` of batches too, along the leading axis.
        inputs: (count, …) each.
        batched: whether it takes batches itself.
        reverse: whether it has reverse-mode derivatives; else it must refuse them.
        ways: (count, …) each, directions of derivatives; random by default.
    """
    generator = np.random.default_rng(len(inputs))
    inputs = tuple(np.asarray(x, dtype=float) for x in inputs)
    count = len(inputs[0])
    ways = ways or tuple(generator.normal(size=x.shape) for x in inputs)
    one = lambda *x: real_vector(function(*x))  # noqa: E731
    compiled = jax.jit(one)
    every = lambda *x: np.stack([compiled(*(v[k] for v in x)) for k in range(count)])  # noqa: E731
    wanted = every(*inputs)
    size = 1.0 + np.abs(wanted).max(initial=0.0)
    weights = generator.normal(size=wanted.shape[1:])
    near = lambda found, value, tolerance: np.abs(np.asarray(found) - value).max(initial=0.0) <= tolerance  # noqa: E731

    assert near(wanted[0], np.asarray(one(*(x[0] for x in inputs))), SAME * size), "jit"
    if batched:
        in_rows = jax.jit(lambda *x: rows(function(*x), count), compiler_options=quick_options())
        assert near(in_rows(*inputs), wanted, SAME * size), "jit of a batch"
    if not wanted.size:
        return
    ahead, behind = (every(*(x + s * STEP * v for x, v in zip(inputs, ways, strict=True))) for s in (1, -1))
    slope = (ahead - behind) / (2.0 * STEP)
    gradient = jax.grad(lambda x: jnp.vdot(weights, one(*x)))

    def derivatives(x, v):
        return *jax.jvp(one, x, v), gradient(x) if reverse else ()

    value, change, slopes = jax.jit(jax.vmap(derivatives), compiler_options=quick_options())(inputs, ways)
    steepest = size + np.abs(slope).max()
    assert near(value, wanted, SAME * size), "vmap"
    assert near(change, slope, BY_DIFFERENCES * steepest), "jvp"
    if reverse:
        along = sum(np.sum((np.asarray(a) * v).reshape(count, -1), axis=1) for a, v in zip(slopes, ways, strict=True))
        assert near(along, np.asarray(change) @ weights, TRANSPOSED * steepest * weights.size), "vmap of grad"
    else:
        with pytest.raises(InvalidInput, match="forward derivatives only"):
            jax.eval_shape(jax.vmap(gradient), inputs)
