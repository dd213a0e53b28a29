"""From a system and a state to a trajectory."""

from __future__ import annotations

import math
import sys
import warnings
from typing import Any

import diffrax
import equinox as eqx
import jax.numpy as jnp
import numpy as np

from polhode.algebra.power import Power
from polhode.algebra.so3 import SO3
from polhode.errors import InvalidInput, NotConverged
from polhode.integrators.base import AbstractOrbitSolver, Memory
from polhode.integrators.lie_midpoint import LieMidpoint
from polhode.integrators.spherical_midpoint import SphericalMidpoint
from polhode.integrators.splitting import Splitting
from polhode.systems.base import AbstractLiePoissonSystem
from polhode.trajectory import Trajectory

Array = Any
STEP_ANGLE = 0.05  # rad by which the fastest rotation turns in a default step
TOO_LONG = 1.0  # rad in a step from which a given step draws a warning
LONG_RUN = 2_000_000  # steps from which progress is shown, on a terminal
REFERENCE_TOLERANCE = 1e-12  # of diffrax's own adaptive solvers


def simulate(
    system: AbstractLiePoissonSystem,
    state: Array,
    times: Array,
    method: type[AbstractOrbitSolver] | diffrax.AbstractSolver | None = None,
    step: float | None = None,
    order: int | None = None,
    progress: bool | None = None,
    throw: bool = True,
) -> Trajectory:
    """Return the motion of a system from a state at the first time, sampled at all times.

    The method takes equal steps from each time to the next, so that samples are steps; nothing is interpolated.

    Args:
        system: what moves.
        state: packed (…, n) or (…, *element_shape): point of the dual, with the attitude in front where the system
            carries one and it is wanted. Leading axes are a batch.
        times: (T,) [s], in one direction.
        method: a class of ``polhode.integrators``, an object of one, made for this system with its own step and order,
            or any diffrax solver, which then steps adaptively with tolerance 1e-12. By default splitting into exact
            flows where the system has them, the spherical midpoint rule for spins, else Lie's midpoint rule.
        step: largest step [s]; by default a twentieth of a radian of the fastest rotation at the start.
        order: of the method, by default its own.
        progress: whether to show it on standard error; by default for long runs on a terminal.
        throw: raise if an implicit step fails; otherwise the status says so, and states after it are infinite.

    Returns:
        Trajectory with ``invariants`` and their ``drift``, ``statistics`` of steps and iterations.

    Raises:
        InvalidInput: for wrong shapes, a state with NaN, times out of order, a step that is not positive.
        NotConverged: if an implicit step does not converge.
    """
    state, times = _checked_state(system, state), _checked_times(times)
    if step is not None and not (np.ndim(step) == 0 and math.isfinite(step) and step > 0):
        raise InvalidInput(f"`step` must be a positive finite time [s]; got {step!r}.")
    rate = fastest_rate(system, state)
    size = float(step) if step is not None else (STEP_ANGLE / rate if rate > 0 else math.inf)
    size = min(size, float(np.ptp(times)))
    if isinstance(method, AbstractOrbitSolver):
        _check_made(method, system, step, order)
    solver = _solver(system, method, size, order)
    ours = isinstance(solver, AbstractOrbitSolver)
    if ours and rate * float(solver.step_size) > TOO_LONG:
        warnings.warn(
            f"a step of {float(solver.step_size):.3g} s turns the fastest rotation by "
            f"{rate * float(solver.step_size):.3g} rad; below {TOO_LONG / rate:.3g} s it is resolved.",
            stacklevel=2,
        )
    expected = float(np.ptp(times)) / size
    meter = _meter(progress if progress is not None else expected > LONG_RUN and sys.stderr.isatty())
    with warnings.catch_warnings():
        # diffrax warns of complex states in general; our solvers' arithmetic is tested on them
        warnings.filterwarnings("ignore", message="Complex dtype support in Diffrax")
        solution = (_solve if ours else _adaptive)(system, solver, state, jnp.asarray(times), meter)
    return _trajectory(system, solution, times, solver, throw, state)


def fastest_rate(system: AbstractLiePoissonSystem, state: Array) -> float:
    """Return an upper estimate of the rate [rad/s] at which the group turns at a state."""
    generator = system.generator(system.parts(state).point)
    return float(jnp.max(system.algebra.rate(generator), initial=0.0))


def _solver(system: AbstractLiePoissonSystem, method: Any, step: float, order: int | None) -> Any:
    if method is None:
        algebra = system.algebra
        spins = isinstance(algebra, Power) and isinstance(algebra.algebra, SO3)
        method = Splitting if system.flows else SphericalMidpoint if spins else LieMidpoint
    if isinstance(method, type) and issubclass(method, AbstractOrbitSolver):
        size = jnp.asarray(step, dtype=float)
        return method(system, size) if order is None else method(system, size, order=order)  # type: ignore[call-arg]
    if isinstance(method, diffrax.AbstractSolver):
        if order is not None:
            raise InvalidInput("`order` goes with a class of methods; the solver given has its own.")
        return method
    raise InvalidInput(f"`method` must be a class of polhode.integrators or a diffrax solver; got {method!r}.")


def _rhs(t: Array, state: Array, system: AbstractLiePoissonSystem) -> Array:
    return system.vector_field(t, state)


def _check_made(
    solver: AbstractOrbitSolver, system: AbstractLiePoissonSystem, step: float | None, order: int | None
) -> None:
    if step is not None or order is not None:
        raise InvalidInput("`step` and `order` go with a class of methods; the solver given was made with its own.")
    if not bool(eqx.tree_equal(solver.system, system)):
        raise InvalidInput("`method` was made for another system; make it with the one that is simulated.")


@eqx.filter_jit
def _solve(system: Any, solver: Any, state: Array, times: Array, meter: Any) -> Any:
    return diffrax.diffeqsolve(
        diffrax.ODETerm(_rhs), solver, times[0], times[-1], None, state, args=system, throw=False,
        stepsize_controller=diffrax.StepTo(times), saveat=diffrax.SaveAt(t0=True, steps=True, solver_state=True),
        max_steps=len(times) - 1, progress_meter=meter, adjoint=diffrax.ForwardMode(),
    )  # fmt: skip


def _adaptive(system: Any, solver: Any, state: Array, times: Array, meter: Any) -> Any:
    controller = diffrax.PIDController(rtol=REFERENCE_TOLERANCE, atol=REFERENCE_TOLERANCE * float(jnp.abs(state).max()))
    return eqx.filter_jit(diffrax.diffeqsolve)(
        diffrax.ODETerm(_rhs), solver, times[0], times[-1], None, state, args=system, throw=False,
        stepsize_controller=controller, saveat=diffrax.SaveAt(ts=times), max_steps=None,
        progress_meter=meter, adjoint=diffrax.ForwardMode(),
    )  # fmt: skip


def _trajectory(
    system: AbstractLiePoissonSystem, solution: Any, times: np.ndarray, solver: Any, throw: bool, state: Array
) -> Trajectory:
    ended = solution.result == diffrax.RESULTS.successful
    memory = solution.solver_state
    statistics = {"steps": int(solution.stats["num_steps"])}
    if isinstance(memory, Memory):
        statistics = {"steps": int(memory.steps), "iterations": int(memory.iterations)}
    status = "successful" if bool(ended) else "not converged: " + _why(solver)
    if throw and not bool(ended):
        raise NotConverged(
            f"the {type(solver).__name__} step did not converge, or the state left the finite numbers, after "
            f"{statistics['steps']} steps. Take a shorter `step`, or an explicit method such as MuntheKaas."
        )
    axis = jnp.ndim(state) - len(system.algebra.element_shape)
    states = jnp.moveaxis(solution.ys, 0, axis)
    attitude, point = system.parts(states)
    invariants = {name: np.asarray(value) for name, value in eqx.filter_jit(system.invariants)(states).items()}
    vectors = system.carries_attitude
    velocity = system.velocity(point)[..., :3] if vectors else None
    return Trajectory(
        system=system,
        times=times,
        states=np.asarray(states),
        attitude=None if attitude is None else np.asarray(attitude),
        momentum=np.asarray(point[..., :3]) if vectors else None,
        angular_velocity=None if velocity is None else np.asarray(velocity),
        invariants=invariants,
        drift={name: _drift(value, axis) for name, value in invariants.items()},
        status=status,
        statistics=statistics,
    )


def _why(solver: Any) -> str:
    return f"{type(solver).__name__} failed"


def _drift(values: np.ndarray, axis: int) -> Array:
    """Return the largest deviation from the first sample, relative to the larger of its size and that of the motion."""
    vector = values.ndim > axis + 1
    first = np.take(values, [0], axis=axis)
    off, size = np.abs(values - first), np.abs(first)
    if vector:
        off, size = np.linalg.norm(off, axis=-1), np.linalg.norm(size, axis=-1)
    size = np.take(size, 0, axis=axis)
    return np.max(off, axis=axis) / np.where(size > 0, size, 1.0)


def _meter(wanted: bool) -> Any:
    return diffrax.TqdmProgressMeter() if wanted else diffrax.NoProgressMeter()


def _checked_state(system: AbstractLiePoissonSystem, state: Array) -> Array:
    if not isinstance(system, AbstractLiePoissonSystem):
        raise InvalidInput(f"`system` must be one of polhode.systems; got {type(system).__name__}.")
    try:
        state = jnp.asarray(state, dtype=system.algebra.dtype)
    except (TypeError, ValueError):
        raise InvalidInput(f"`state` must be numbers; got {state!r}.") from None
    attitude, _ = system.parts(state)
    if not bool(jnp.isfinite(state).all()):
        raise InvalidInput("`state` must be finite; got NaN or an infinity. Check where it comes from.")
    if attitude is not None and not bool(jnp.all(jnp.abs(jnp.linalg.norm(attitude, axis=-1) - 1.0) < 1e-6)):
        raise InvalidInput("`state` must begin with a unit quaternion (w, x, y, z); divide it by its norm.")
    return state


def _checked_times(times: Array) -> np.ndarray:
    try:
        values = np.asarray(times, dtype=float)
    except (TypeError, ValueError):
        raise InvalidInput(f"`times` must be numbers [s]; got {times!r}.") from None
    if values.ndim != 1 or len(values) < 2 or not np.isfinite(values).all():
        raise InvalidInput(f"`times` must be at least two finite times (T,); got shape {values.shape}.")
    gaps = np.sign(np.diff(values))
    if not (gaps * gaps[0] > 0).all():
        raise InvalidInput("`times` must advance in one direction, without repetitions.")
    return values

