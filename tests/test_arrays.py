"""The seam to JAX: what a compiler may do with the closed forms."""

import pytest

from limited import run_limited

FAR_MORE_THAN_IT_TAKES = 120.0
"""Seconds; some three are needed. Fused into the stack, the chain takes ten times as long for each link but the first
seven, which take 0.1 s: an hour and a half."""

STACKED_CHAIN = """
import jax
jax.config.update("jax_enable_x64", True)
import jax.numpy as jnp
import numpy as np
import pytest
from polhode._base.arrays import stack_last
from polhode.special import _doubledouble as dd

def chain(a, b):
    x, y, z = dd.from_float(a), dd.from_float(b), dd.two_product(a, b)
    for _ in range(12):
        x, y, z = dd.add(dd.multiply(y, z), x), dd.add(dd.multiply(z, x), y), dd.add(dd.multiply(x, y), z)
    return stack_last((x[0], y[0], z[0]))

a, b = np.array([0.1, 0.2, 0.3]), np.array([0.3, -0.2, 0.1])
wanted = chain(a, b)
assert wanted.shape == (3, 3)
for way in (chain, jax.vmap(chain)):
    assert np.allclose(jax.jit(way)(jnp.asarray(a), jnp.asarray(b)), wanted, rtol=1e-14, atol=0.0)
"""


@pytest.mark.sweep
def test_a_stack_is_not_fused_with_a_long_computation_that_its_parts_share():
    run_limited(STACKED_CHAIN, FAR_MORE_THAN_IT_TAKES)


BARRIER = """
import jax
jax.config.update("jax_enable_x64", True)
import jax.numpy as jnp
import numpy as np
from polhode._base.arrays import barrier

plain = lambda x: (jnp.sin(x), (jnp.cos(x) * x, x > 0.5))
held = lambda x: barrier(plain(x))
for x in (0.3, [0.2, 0.9], [], [np.nan, 1.0], [np.inf, np.nan]):
    x = jnp.asarray(x, dtype=float)
    way = jax.jit(jax.vmap(held)) if x.ndim else jax.jit(held)
    assert jax.tree.all(jax.tree.map(lambda a, b: np.array_equal(a, b, equal_nan=a.dtype == float), way(x), plain(x)))
x, v = jnp.array([0.2, 0.9]), jnp.array([1.0, 2.0])
first = lambda f: lambda x: jnp.sum(f(x)[0] * f(x)[1][0])
assert np.allclose(jax.jit(jax.grad(first(held)))(x), jax.grad(first(plain))(x), rtol=1e-15)
assert np.allclose(jax.jit(lambda x, v: jax.jvp(first(held), (x,), (v,))[1])(x, v), first(plain)(x) * 0
                   + jax.jvp(first(plain), (x,), (v,))[1], rtol=1e-15)
assert "while" in jax.jit(held).lower(x).as_text()
"""


@pytest.mark.sweep
def test_a_barrier_changes_nothing_and_lets_derivatives_through():
    run_limited(BARRIER, FAR_MORE_THAN_IT_TAKES)
