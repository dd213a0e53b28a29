"""Rates of balances against derivatives along the motion."""

import jax
import jax.numpy as jnp


def worst_balance(system, t, state):
    """How far the balances' rates are from the derivatives of their values along the motion, relative."""
    t, state = jnp.asarray(t), jnp.asarray(state)
    values, slopes = jax.jvp(
        lambda t, y: {name: balance.value for name, balance in system.balances(t, y).items()},
        (t, state), (jnp.ones_like(t), system.vector_field(t, state)),
    )  # fmt: skip
    rates = {name: balance.rate for name, balance in system.balances(t, state).items()}
    return {name: float(jnp.max(jnp.abs(slopes[name] - rates[name]) / jnp.abs(values[name]))) for name in values}
