"""From a system and a state to a trajectory."""

from __future__ import annotations

import math
import sys
import warnings
from typing import Any

import diffrax
import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np

from polhode.algebra.power import Power
from polhode.algebra.so3 import SO3
from polhode.arrays import refuse_single_precision
from polhode.errors import InvalidInput, NotConverged
from polhode.integrators.adaptive import solve_adaptively
from polhode.integrators.base import AbstractOrbitSolver
from polhode.integrators.lie_midpoint import LieMidpoint
from polhode.integrators.spherical_midpoint import SphericalMidpoint
from polhode.integrators.splitting import Splitting
from polhode.systems.agreement import MOMENTS_OF_TIME, check_agreement, moves_by_generator
from polhode.systems.base import AbstractLiePoissonSystem, AbstractSystem
from polhode.trajectory import Trajectory

Array = Any
STEP_ANGLE = 0.05  # rad by which the fastest rotation turns in a default step
TOO_LONG = 1.0  # rad in a step from which a given step draws a warning
LONG_RUN = 2_000_000  # steps from which progress is shown, on a terminal


def simulate(
    system: AbstractSystem,
    state: Array,
    times: Array,
    method: type[AbstractOrbitSolver] | diffrax.AbstractSolver | None = None,
    step: float | None = None,
    order: int | None = None,
    progress: bool | None = None,
    throw: bool = True,
) -> Trajectory:
    """Return the motion of a system from a state at the first time, sampled at all times.

    Methods of ours take equal steps from each time to the next, so that samples are steps; nothing is interpolated.
    diffrax's solvers step adaptively with tolerance 1e-12, and end where one of the system's events does: the last
    sample is then the event's own, and ``status`` names it.

    Args:
        system: what moves.
        state: packed (…, n) or (…, *element_shape): of a Lie–Poisson system a point of the dual, with the attitude in
            front where the system carries one and it is wanted. Leading axes are a batch.
        times: (T,) [s], in one direction.
        method: a class of ``polhode.integrators``, an object of one, made for this system with its own step and order,
            or any diffrax solver. By default splitting into exact flows where a Lie–Poisson system has them, the
            spherical midpoint rule for spins, else Lie's midpoint rule; diffrax's ``Dopri8`` for any other system, and
            for one that overrides ``vector_field``.
        step: largest step [s]; by default a twentieth of a radian of the fastest rotation at the start.
        order: of the method, by default its own.
        progress: whether to show it on standard error; by default for long runs on a terminal.
        throw: raise if an implicit step fails; otherwise the status says so, and states after it are infinite.

    Returns:
        Trajectory with ``invariants``, ``balances`` and their ``drift``, ``statistics`` of steps and iterations.

    Raises:
        InvalidInput: for wrong shapes, a state with NaN, times out of order, a step that is not positive, or a system
            whose energy, velocity, generator and flows disagree.
        NotConverged: if an implicit step does not converge, or adaptive steps shrink to nothing.
    """
    if not isinstance(system, AbstractSystem):
        raise InvalidInput(f"`system` must be one of polhode.systems; got {type(system).__name__}.")
    state, times = system.check_state(state), _checked_times(times)
    if step is not None and not (np.ndim(step) == 0 and math.isfinite(step) and step > 0):
        raise InvalidInput(f"`step` must be a positive finite time [s]; got {step!r}.")
    with warnings.catch_warnings():
        # diffrax warns of complex states in general; our solvers' arithmetic is tested on them
        warnings.filterwarnings("ignore", message="Complex dtype support in Diffrax")
        if isinstance(system, AbstractLiePoissonSystem):
            check_agreement(system, state, times, by_flows=_would_split(system, method))
            if _goes_along_orbit(system, method):
                return _by_equal_steps(system, state, times, method, step, order, progress, throw)
        solver = _adaptive_solver(system, method, order)
        motion = solve_adaptively(system, solver, state, times, _meter(bool(progress)), step)
    if throw and not motion.successful:
        raise NotConverged(
            f"{type(solver).__name__} could not hold its tolerance after {motion.steps} steps: the motion runs into a "
            "singularity or leaves the finite numbers. End it earlier."
        )
    status = motion.event or ("successful" if motion.successful else f"not converged: {_why(solver)}")
    return trajectory_of(system, motion.times, motion.states, status, {"steps": motion.steps}, motion.received)


def _by_equal_steps(
    system: AbstractLiePoissonSystem, state: Array, times: np.ndarray, method: Any, step: float | None,
    order: int | None, progress: bool | None, throw: bool,
) -> Trajectory:  # fmt: skip
    rate = fastest_rate(system, state, times)
    size = float(step) if step is not None else (STEP_ANGLE / rate if rate > 0 else math.inf)
    size = min(size, float(np.abs(np.diff(times)).max()))  # no step is longer than from sample to sample
    if isinstance(method, AbstractOrbitSolver):
        _check_made(method, system, step, order)
    solver = _solver(system, method, size, order)
    if rate * float(solver.step_size) > TOO_LONG:
        warnings.warn(
            f"a step of {float(solver.step_size):.3g} s turns the fastest rotation by "
            f"{rate * float(solver.step_size):.3g} rad; below {TOO_LONG / rate:.3g} s it is resolved.",
            stacklevel=3,
        )
    expected = float(np.ptp(times)) / size
    meter = _meter(progress if progress is not None else expected > LONG_RUN and sys.stderr.isatty())
    solution = _solve(system, solver, state, jnp.asarray(times), meter)
    ended, memory = bool(solution.result == diffrax.RESULTS.successful), solution.solver_state
    statistics = {"steps": int(memory.steps), "iterations": int(memory.iterations)}
    if throw and not ended:
        raise NotConverged(
            f"the {type(solver).__name__} step did not converge, or the state left the finite numbers, after "
            f"{statistics['steps']} steps. Take a shorter `step`, or an explicit method such as MuntheKaas."
        )
    status = "successful" if ended else f"not converged: {_why(solver)}"
    return trajectory_of(system, times, solution.ys, status, statistics, {})


def fastest_rate(system: AbstractLiePoissonSystem, state: Array, times: Array = (0.0,)) -> float:
    """Return an upper estimate of the rate [rad/s] at which the group turns at a state, at some of the times."""
    point, first, last = system.parts(state).point, float(times[0]), float(times[-1])
    moments = {first + share * (last - first) for share in MOMENTS_OF_TIME} if _is_driven(system) else {first}
    return max(float(jnp.max(system.algebra.rate(system.generator(t, point)), initial=0.0)) for t in moments)


def _is_driven(system: AbstractLiePoissonSystem) -> bool:
    """Whether the generator may depend on time."""
    return type(system).generator is not AbstractLiePoissonSystem.generator


def _goes_along_orbit(system: AbstractLiePoissonSystem, method: Any) -> bool:
    return moves_by_generator(system) if method is None else not _is_adaptive(method)


def _would_split(system: AbstractLiePoissonSystem, method: Any) -> bool:
    if method is None:
        return bool(system.flows) and moves_by_generator(system)
    return isinstance(method, Splitting) or (isinstance(method, type) and issubclass(method, Splitting))


def _is_adaptive(method: Any) -> bool:
    return isinstance(method, diffrax.AbstractSolver) and not isinstance(method, AbstractOrbitSolver)


def _adaptive_solver(system: AbstractSystem, method: Any, order: int | None) -> diffrax.AbstractSolver:
    if method is not None and not _is_adaptive(method):
        raise InvalidInput(
            f"`method` must be a diffrax solver for {type(system).__name__}, which is not a Lie–Poisson system; "
            f"got {method!r}. Leave it out for diffrax.Dopri8()."
        )
    if order is not None:
        raise InvalidInput("`order` goes with a class of methods; the solver given has its own.")
    return diffrax.Dopri8() if method is None else method


def _solver(system: AbstractLiePoissonSystem, method: Any, step: float, order: int | None) -> Any:
    if method is None:
        algebra = system.algebra
        spins = isinstance(algebra, Power) and isinstance(algebra.algebra, SO3)
        method = Splitting if system.flows else SphericalMidpoint if spins else LieMidpoint
    if isinstance(method, type) and issubclass(method, AbstractOrbitSolver):
        size = jnp.asarray(step, dtype=float)
        return method(system, size) if order is None else method(system, size, order=order)  # type: ignore[call-arg]
    if isinstance(method, AbstractOrbitSolver):
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


def trajectory_of(
    system: AbstractSystem, times: np.ndarray, states: Array, status: str, statistics: dict[str, int],
    received: dict[str, Array],
) -> Trajectory:  # fmt: skip
    """Return samples, time first, as a trajectory with all that the system says of them."""
    axis = jnp.ndim(states) - 1 - system.state_axes
    states = jnp.moveaxis(states, 0, axis)
    invariants = {name: np.asarray(value) for name, value in _invariants(system, states).items()}
    # what holds on other leaves only is NaN on this one
    invariants = {name: value for name, value in invariants.items() if not np.isnan(value).all()}
    balances = eqx.filter_jit(system.balances)(jnp.asarray(times), states)
    values = {name: np.asarray(balance.value) for name, balance in balances.items()}
    got = {name: np.moveaxis(np.asarray(value), 0, axis) for name, value in received.items()}
    vectors = [None if x is None else np.asarray(x) for x in system.vectors(states)]
    terms = _terms(system, jnp.take(states, 0, axis=axis)) if jnp.isrealobj(states) else {}
    drift = {name: _drift(value, axis, terms.get(name)) for name, value in invariants.items()}
    return Trajectory(
        system=system,
        times=times,
        states=np.asarray(states),
        attitude=vectors[0],
        momentum=vectors[1],
        angular_velocity=vectors[2],
        invariants=invariants,
        balances=values,
        received=got,
        drift=drift | {name: _drift(values[name] - value, axis) for name, value in got.items()},
        status=status,
        statistics=statistics,
    )


@eqx.filter_jit
def _invariants(system: AbstractSystem, states: Array) -> dict[str, Array]:
    return system.invariants(states)


@eqx.filter_jit
def _terms(system: AbstractSystem, state: Array) -> dict[str, Array]:
    """Return Σ |x ∂C/∂x| of each scalar invariant C at states: the size of its terms, which may cancel in its value."""

    def of_one(x: Array) -> dict[str, Array]:
        slopes = jax.jacfwd(system.invariants)(x)
        return {k: jnp.sum(jnp.abs(s * x)) for k, s in slopes.items() if jnp.ndim(s) == jnp.ndim(x)}

    for _ in range(jnp.ndim(state) - system.state_axes):
        of_one = jax.vmap(of_one)
    return of_one(state)


def _why(solver: Any) -> str:
    return f"{type(solver).__name__} failed"


def _drift(values: np.ndarray, axis: int, terms: Array | None = None) -> Array:
    """Return the largest deviation from the first sample, relative to its size, or that of its terms if larger."""
    vector = values.ndim > axis + 1
    first = np.take(values, [0], axis=axis)
    off, size = np.abs(values - first), np.abs(first)
    if vector:
        off, size = np.linalg.norm(off, axis=-1), np.linalg.norm(size, axis=-1)
    size = np.take(size, 0, axis=axis)
    if terms is not None:
        size = np.maximum(size, np.nan_to_num(np.asarray(terms)))
    return np.max(off, axis=axis) / np.where(size > 0, size, 1.0)


def _meter(wanted: bool) -> Any:
    return diffrax.TqdmProgressMeter() if wanted else diffrax.NoProgressMeter()


def _checked_times(times: Array) -> np.ndarray:
    refuse_single_precision(times=times)
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

