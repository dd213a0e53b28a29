"""The check of functions alone catches broken ones."""

import jax.numpy as jnp
import numpy as np
import pytest

from polhode._base.arrays import is_traced
from transformed import check_alone

POINTS = np.array([[0.0, 1.0], [0.5, 2.0], [1.0, 3.0]])


def otherwise_when_traced(x):
    return jnp.sum(x, axis=-1) * (1.0 + 1e-9 if is_traced(x) else 1.0)


def mixes_the_batch(x):
    return jnp.sum(x, axis=-1) + 0.0 * jnp.sum(x) + (jnp.sum(x) if x.ndim > 1 else 0.0)


def no_derivative_at_zero(x):
    return jnp.sum(jnp.where(x > 0.0, jnp.sqrt(x), 0.0), axis=-1) + jnp.sum(x, axis=-1) ** 2


def constant_derivative(x):
    return jnp.round(x * 1e7).sum(axis=-1) / 1e7


@pytest.mark.parametrize(
    ("broken", "word"),
    [(otherwise_when_traced, "jit"), (mixes_the_batch, "batch"), (no_derivative_at_zero, "vmap of grad"),
     (constant_derivative, "jvp")],
)  # fmt: skip
def test_broken_functions_are_caught(broken, word):
    with pytest.raises(AssertionError, match=word):
        check_alone(broken, POINTS, ways=(np.array([[0.0, 1.0], [1.0, 1.0], [1.0, 2.0]]),))
