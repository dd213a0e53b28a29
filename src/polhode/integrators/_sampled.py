"""A motion at given times by adaptive steps, up to an event: explicit Runge–Kutta methods, and any of diffrax's.

States are divided by their scales, and what balances receive by its own, so that one tolerance holds for all.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial
from typing import Any, NamedTuple

import jax
import jax.numpy as jnp

from polhode._base.arrays.operation import Operation, along, transposed
from polhode.integrators import _diffrax as diffrax
from polhode.integrators import _embedded as embedded
from polhode.motion._outcome import Status
from polhode.systems._forms import distances, rates_of_change
from polhode.systems.base import AbstractSystem
from polhode.types import Array, Bool, Double, Float64, Integer

Observe = Callable[[Float64[Array, ""], Double[Array, "..."]], Any]
MOST_STEPS = 15_000_000  # of a run, some ten minutes


class Sampled(NamedTuple):
    """The result for one copy, or for each copy of a batch.

    Attributes:
        saved: (batch…, K, …) states at the times to save, or what was observed; infinite after the end.
        received: name → what each balance received since the first time, (batch…, K); empty with observations.
        status: (batch…) numbers of ``Status``.
        event: (batch…) which of the system's events ended it, −1 where none did.
        end: (batch…) [s] the event's own time, or the last; NaN where the solver failed.
        end_state: (batch…, …) the state then.
        end_received: name → (batch…) what each balance received until then.
        steps: (batch…) how many were taken.
    """

    saved: Any
    received: Mapping[str, Float64[Array, "*batch kept"]]
    status: Integer[Array, "*batch"]
    event: Integer[Array, "*batch"]
    end: Float64[Array, "*batch"]
    end_state: Double[Array, "..."]
    end_received: Mapping[str, Float64[Array, "*batch"]]
    steps: Integer[Array, "*batch"]


class Carried(NamedTuple):
    """State over its scales, and what the balances received over theirs, one after the other."""

    state: Array
    received: Array


class Scales(NamedTuple):
    """The scales of a state, and of what each balance received."""

    state: Array
    received: Mapping[str, Array]


def scales(system: AbstractSystem, t: Float64[Array, ""], state: Double[Array, "..."]) -> Scales:
    """Return the scales that go with a start."""
    balances = system.balances(t, state)
    sizes = {name: jnp.where(balance.value != 0, jnp.abs(balance.value), 1.0) for name, balance in balances.items()}
    own = jnp.asarray(system.scales(state))
    # of what has no size of its own, that at the start: at an equilibrium nothing else would limit a step
    largest = jnp.max(jnp.where(jnp.isinf(own), jnp.abs(state), 0.0), initial=0.0)
    return Scales(jnp.where(jnp.isinf(own), jnp.where(largest > 0.0, largest, 1.0), own), sizes)


def scale_system(system: AbstractSystem, by: Scales, observe: Observe | None = None) -> embedded.Problem:
    """Return a system's equations of motion in scaled states, with the first of its events."""

    @jax.jit  # so that it is traced once, however often it is asked for
    def rates(t: Array, y: Carried) -> Carried:
        now = y.state * by.state
        balances = system.balances(t, now)
        received = [balances[name].rate / size for name, size in by.received.items()]
        field = rates_of_change(system, t, now)
        return Carried(field / by.state, jnp.asarray(received, float))

    # one function whose zero is the first of all, as one zero is sought
    nearest = jax.jit(lambda t, now: jnp.min(distances(system, t, now)))

    def margin(t: Array, y: Carried) -> Array:
        return nearest(t, y.state * by.state)

    def seen(t: Array, y: Carried) -> Any:
        return y if observe is None else as_floats(observe(t, y.state * by.state))

    return embedded.Problem(rates, margin if system.events else None, seen)


def start(by: Scales, state: Double[Array, "..."]) -> Carried:
    """Return a state with nothing received."""
    return Carried(state / by.state, jnp.zeros(len(by.received)))


def sample_motion(
    system: AbstractSystem, solver: Any, state: Double[Array, "..."], times: Float64[Array, "time"],
    kept: Float64[Array, "kept"], largest: Float64[Array, ""] | None, tolerance: Float64[Array, ""],
    meter: Any = None, observe: Observe | None = None, reverse: bool = False,
) -> Sampled:
    """Return the motion of one state, stepping at all times (T,) and saving at those to be kept (K,).

    Args:
        system: what moves.
        solver: one of diffrax's.
        state: one.
        times: (T,) [s], in one direction.
        kept: (K,) some of them.
        largest: step [s], or None.
        tolerance: of a step, relative.
        meter: of diffrax, for progress; explicit Runge–Kutta methods show none here.
        observe: function of time and state to save instead of the state.
        reverse: whether derivatives are to be of reverse mode, instead of forward mode.
    """
    if reverse or not embedded.is_embedded(solver):
        return _by_diffrax(system, solver, state, times, kept, largest, tolerance, meter, observe, reverse)
    by = scales(system, times[0], state)
    own = scale_system(system, by, observe)
    run = embedded.begin(start(by, state), times, kept, own.seen)
    ends, at_jumps = with_jumps(system, times)
    run = embedded.advance(run, solver, own, ends, kept, largest, tolerance, MOST_STEPS, at_jumps)
    ending = run.end, run.end_state
    if own.margin:
        ending = embedded.at_event(run, own.rates, own.margin)
    return unscale_run(system, by, run.saved, *ending, run.status, run.steps, observe is None)


def unscale_run(
    system: AbstractSystem, by: Scales, saved: Any, time: Float64[Array, ""], last: Carried,
    status: Integer[Array, ""], steps: Integer[Array, ""], of_states: bool = True,
) -> Sampled:
    """Return the result of a run in the system's own units."""
    # after the end there is infinity, which a derivative of zero must not meet
    grown = lambda x, size: jnp.where(jnp.isinf(x), x, jnp.where(jnp.isinf(x), 1.0, x) * size)  # noqa: E731
    whole = lambda y: {name: grown(y.received[..., k], size) for k, (name, size) in enumerate(by.received.items())}  # noqa: E731
    state = last.state * by.state
    ended = status == Status.EVENT
    first = jnp.argmin(distances(system, time, state)) if system.events else jnp.asarray(-1)
    status = jnp.where(status == embedded.RUNNING, Status.NOT_CONVERGED, status)
    time = jnp.where(status == Status.NOT_CONVERGED, jnp.nan, time)
    return Sampled(
        grown(saved.state, by.state) if of_states else saved, whole(saved) if of_states else {}, status,
        jnp.where(ended, first, -1), time, state, whole(last), steps,
    )


def _by_diffrax(
    system: AbstractSystem, solver: Any, state: Array, times: Array, kept: Array, largest: Array | None,
    tolerance: Array, meter: Any, observe: Observe | None, reverse: bool,
) -> Sampled:
    """Return the motion by diffrax's own loop, which goes back from checkpoints and takes implicit methods."""
    from polhode.integrators._diffrax_loop import EventBisection, PresentTimeControl

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
    )
    results: Any = diffrax.RESULTS
    ended = solution.result == results.event_occurred
    status = jnp.where(solution.result == results.successful, Status.COMPLETED, Status.NOT_CONVERGED)
    status = jnp.where(ended, Status.EVENT, status)
    saved, last = solution.ys
    last = jax.tree.map(lambda y: y[0], last)
    steps = solution.stats["num_steps"]
    return unscale_run(system, by, saved, solution.ts[1][0], last, status, steps, observe is None)


def with_jumps(
    system: AbstractSystem, times: Float64[Array, "time"]
) -> tuple[Float64[Array, "ends"], Bool[Array, "ends"] | None]:
    """Return at which times steps end, and which of them are jumps; those outside of the times fall on their ends."""
    jumps = jnp.ravel(jnp.asarray(system.jumps, float))
    if not jumps.size:
        return times, None
    forth = jnp.sign(times[-1] - times[0])
    first, last = forth * times[0], forth * times[-1]
    whole = jnp.concatenate([forth * times, jnp.clip(forth * jumps, first, last)])
    order = jnp.argsort(whole, stable=True)  # of equal times the sample comes first
    return forth * whole[order], order >= times.shape[0]


def sample_by_either_mode(
    system: AbstractSystem, solver: Any, state: Double[Array, "..."], times: Float64[Array, "time"],
    kept: Float64[Array, "kept"], largest: Float64[Array, ""] | None, tolerance: Float64[Array, ""],
    observe: Observe | None,
) -> Sampled:
    """Return what ``sample_motion`` does, with derivatives of either mode."""

    def sample(reverse: bool, *arguments: Any) -> Sampled:
        return sample_motion(*arguments[:-1], observe=arguments[-1], reverse=reverse)

    forward, back = (partial(sample, reverse) for reverse in (False, True))
    operation = Operation("solve by adaptive steps", forward, along(forward), transposed(back))
    return operation(system, solver, state, times, kept, largest, tolerance, observe)


def as_floats(observed: Any) -> Any:
    """Return a nest of observations as arrays that can be infinite where there is none."""
    return jax.tree.map(lambda x: x if jnp.issubdtype(jnp.result_type(x), jnp.inexact) else jnp.asarray(x, float),
                        jax.tree.map(jnp.asarray, observed))
