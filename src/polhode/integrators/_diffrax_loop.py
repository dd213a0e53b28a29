"""Motions by diffrax's own loop, which goes back from checkpoints and takes implicit methods."""

from __future__ import annotations

from typing import Any

import diffrax
import jax
import jax.numpy as jnp
import optimistix

from polhode.integrators import _embedded as embedded
from polhode.integrators._sampled import (
    MOST_STEPS,
    Carried,
    Observe,
    Sampled,
    scale_system,
    scales,
    start,
    unscale_run,
)
from polhode.motion._outcome import Status
from polhode.systems.base import AbstractSystem
from polhode.types import Array, Bool, Double, Float64


def sample_by_diffrax(
    system: AbstractSystem, solver: Any, state: Double[Array, "..."], times: Float64[Array, "time"],
    kept: Float64[Array, "kept"], largest: Float64[Array, ""] | None, tolerance: Float64[Array, ""], meter: Any,
    observe: Observe | None, reverse: bool,
) -> Sampled:  # fmt: skip
    """Return the motion of one state; see ``sample_motion``."""
    by = scales(system, times[0], state)
    own = scale_system(system, by, observe)

    def lowest(t: Array, y: Carried, args: Any, **more: Any) -> Array:
        return own.margin(t, y)  # type: ignore[misc]

    times, kept = jnp.asarray(times), jnp.asarray(kept)
    control = PresentTimeControl(rtol=tolerance, atol=tolerance, dtmax=largest)
    # what is not between the first and the last time is moved behind it, as diffrax steps over each
    jumps = jnp.ravel(jnp.asarray(system.jumps, float))
    between = (jumps - times[0]) * (times[-1] - jumps) > 0.0
    at_jumps = jnp.where(between, jumps, 2.0 * times[-1] - times[0]) if jumps.size else None
    saving = diffrax.SubSaveAt(ts=kept, fn=lambda t, y, args: own.seen(t, y))
    # samples are steps: interpolation between steps costs three digits
    solution: Any = diffrax.diffeqsolve(
        diffrax.ODETerm(lambda t, y, args: own.rates(jnp.asarray(t), y)), solver, times[0], times[-1], None,
        start(by, state),
        stepsize_controller=diffrax.ClipStepSizeController(control, step_ts=times, jump_ts=at_jumps),
        saveat=diffrax.SaveAt(subs=[saving, diffrax.SubSaveAt(t1=True)]),
        event=diffrax.Event(lowest, EventBisection(), direction=False) if own.margin else None,
        max_steps=MOST_STEPS, progress_meter=diffrax.NoProgressMeter() if meter is None else meter, throw=False,
        adjoint=diffrax.RecursiveCheckpointAdjoint() if reverse else diffrax.ForwardMode(),
    )  # fmt: skip
    results: Any = diffrax.RESULTS
    ended = solution.result == results.event_occurred
    status = jnp.where(solution.result == results.successful, Status.COMPLETED, Status.NOT_CONVERGED)
    status = jnp.where(ended, Status.EVENT, status)
    saved, last = solution.ys
    last = jax.tree.map(lambda y: y[0], last)
    steps = solution.stats["num_steps"]
    return unscale_run(system, by, saved, solution.ts[1][0], last, status, steps, observe is None)


class EventBisection(optimistix.Bisection):
    """Bisection until the time is known to rounding, whatever the scale of the function that vanishes there."""

    def __init__(self) -> None:
        # events fall from positive values; a copy of a batch without one runs the same search, with no change of sign
        super().__init__(rtol=embedded.EVENT_TOLERANCE, atol=0.0, flip=True)

    def terminate(
        self, fn: Any, y: Float64[Array, ""], args: Any, options: Any, state: Any, tags: Any
    ) -> tuple[Bool[jax.Array, ""], optimistix.RESULTS]:
        width = jnp.abs(state.upper - state.lower)
        narrow = width <= self.rtol * jnp.maximum(jnp.abs(state.upper), jnp.abs(state.lower))
        return narrow, optimistix.RESULTS.successful


class PresentTimeControl(diffrax.PIDController):
    """Step control whose shortest step is a rounding of the present time, whatever the last time is.

    A motion that ends after a minute must not depend on whether it was asked for up to an hour or up to an age.
    """

    def _at(self, *times: Any) -> diffrax.PIDController:
        present = jnp.max(jnp.abs(jnp.stack([jnp.asarray(t) for t in times])))
        least = jnp.maximum(embedded.TIME_ROUNDING * present, embedded.SHORTEST_STEP)
        return diffrax.PIDController(rtol=self.rtol, atol=self.atol, dtmin=least, dtmax=self.dtmax, force_dtmin=False)

    def init(self, terms: Any, t0: Any, *args: Any, **named: Any) -> Any:
        return self._at(t0).init(terms, t0, *args, **named)

    def adapt_step_size(self, t0: Any, t1: Any, *args: Any, **named: Any) -> Any:
        return self._at(t0, t1).adapt_step_size(t0, t1, *args, **named)
