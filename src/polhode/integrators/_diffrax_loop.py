"""Events and step control for diffrax's own loop."""

from __future__ import annotations

from typing import Any

import diffrax
import jax
import jax.numpy as jnp
import optimistix

from polhode.integrators import _embedded as embedded
from polhode.types import Array, Bool, Float64


class EventBisection(optimistix.Bisection):
    """Bisection until the time is known to rounding, whatever the scale of the function that vanishes there."""

    def __init__(self) -> None:
        # events fall from positive values; a copy of a batch without one runs this search too, with no change of sign
        super().__init__(rtol=embedded.LIMITS.event_tolerance, atol=0.0, flip=True)

    def terminate(
        self, fn: Any, y: Float64[Array, ""], args: Any, options: Any, state: Any, tags: Any
    ) -> tuple[Bool[jax.Array, ""], optimistix.RESULTS]:
        width = jnp.abs(state.upper - state.lower)
        narrow = width <= self.rtol * jnp.maximum(jnp.abs(state.upper), jnp.abs(state.lower))
        return narrow, optimistix.RESULTS.successful


class PresentTimeControl(diffrax.PIDController):
    """Step control whose shortest step is a rounding of the present time, whatever the last time is.

    A motion that ends after a minute must not depend on whether its last time is an hour or an age.
    """

    def _at(self, *times: Any) -> diffrax.PIDController:
        present = jnp.max(jnp.abs(jnp.stack([jnp.asarray(t) for t in times])))
        least = jnp.maximum(embedded.LIMITS.min_relative_step * present, embedded.LIMITS.min_step)
        return diffrax.PIDController(rtol=self.rtol, atol=self.atol, dtmin=least, dtmax=self.dtmax, force_dtmin=False)

    def init(self, terms: Any, t0: Any, *args: Any, **named: Any) -> Any:
        return self._at(t0).init(terms, t0, *args, **named)

    def adapt_step_size(self, t0: Any, t1: Any, *args: Any, **named: Any) -> Any:
        return self._at(t0, t1).adapt_step_size(t0, t1, *args, **named)
