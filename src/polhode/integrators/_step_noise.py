"""Random numbers of a step, fixed by a seed and the step's place in time alone."""

from __future__ import annotations

import jax
import jax.numpy as jnp

from polhode.integrators.base import Scalar
from polhode.types import Array, Float64, Integer


def normals_of_step(
    seed: Integer[Array, ""], t: Scalar, largest: Scalar, shape: tuple[int, ...]
) -> Float64[Array, "..."]:
    """Return independent standard normal numbers for the step that begins at t, whose length is at most ``largest``."""
    ticks, half_key = 1024, 2**31  # of a largest step: steps that are not shorter than a tick have keys of their own
    place = jnp.round(jnp.asarray(t) / largest * ticks).astype(int)
    key = jax.random.key(seed)
    for part in (place // half_key, place % half_key):
        key = jax.random.fold_in(key, part.astype(jnp.uint32))
    return jax.random.normal(key, shape)
