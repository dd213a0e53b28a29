"""A motion made and asked for one thing within one compiled function: what is not asked for is dropped, and it ends."""

import pytest

from limited import run_limited

LONG_ENOUGH = 400.0
"""Seconds; compiling takes half a minute."""

ALONE = """
import jax
jax.config.update("jax_enable_x64", True)
import jax.numpy as jnp
import numpy as np
import polhode as ph

kind, method = {kind!r}, {method!r}
given = dict(FreeMotion=((1.0, 2.0, 3.3),), LagrangeMotion=((1.0, 1.0, 0.5), 0.7))[kind]
momenta, times = np.array([[0.3, 1.8, 1.5], [0.9, 0.1, 0.2]]), np.array([1.0, 2.0])
alone = lambda L, t: getattr(getattr(ph, kind)(*map(jnp.asarray, given), L), method)(t)
found = jax.jit(alone)(jnp.asarray(momenta), jnp.asarray(times))
wanted = getattr(getattr(ph, kind)(*given, momenta), method)(times)
assert np.abs(np.asarray(found) - wanted).max() < 1e-14, (found, wanted)
"""


@pytest.mark.sweep
@pytest.mark.parametrize(("kind", "method"), [("FreeMotion", "momentum"), ("LagrangeMotion", "momentum")])
def test_one_method_alone_in_a_compiled_batch(kind, method):
    run_limited(ALONE.format(kind=kind, method=method), LONG_ENOUGH)
