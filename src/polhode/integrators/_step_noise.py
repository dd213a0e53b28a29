"""Random numbers of a step, fixed by a seed and the step's place in time alone."""

from __future__ import annotations

import jax
import jax.numpy as jnp

from polhode.integrators.base import Scalar
from polhode.types import Array, Float64, Integer

TICKS = 1024  # of a largest step: steps that are not shorter have keys of their own
HALF_KEY = 2**31


def normals_of_step(
    seed: Integer[Array, ""], t: Scalar, largest: Scalar, shape: tuple[int, ...]
) -> Float64[Array, "..."]:
    """Return independent standard normal numbers for the step that begins at t, whose length is at most ``largest``."""
    place = jnp.round(jnp.asarray(t) / largest * TICKS).astype(int)
    key = jax.random.key(seed)
    for part in (place // HALF_KEY, place % HALF_KEY):
        key = jax.random.fold_in(key, part.astype(jnp.uint32))
    return jax.random.normal(key, shape)
