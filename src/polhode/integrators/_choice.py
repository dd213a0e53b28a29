"""Which method goes with a system, and how long its steps are by default."""

from __future__ import annotations

from typing import Any

import equinox as eqx
import jax
import jax.numpy as jnp

from polhode import integrators
from polhode.errors import InvalidInput, shown
from polhode.integrators import _diffrax as diffrax
from polhode.integrators._series import Taylor, is_series
from polhode.motion._plan import Stepping
from polhode.systems._agreement import MOMENTS_OF_TIME, moves_by_generator
from polhode.systems.base import AbstractLiePoissonSystem, AbstractSystem
from polhode.types import Array, Double, Float64

STEP_ANGLE = 0.05  # rad by which the fastest rotation turns in a default step of low order


def choose_solver(system: AbstractSystem, method: Any, order: int | None) -> tuple[Stepping, Any]:
    """Return how a method steps, and the object of it that moves the system.

    Args:
        system: what moves.
        method: a class of methods or an object; None for the one that goes with the system where there is no series.
        order: of the method, by default its own.

    Raises:
        InvalidInput: for a method that cannot move the system, or an order beside an object.
    """
    if is_series(method):
        solver = Taylor(order) if method is Taylor else method
        if order not in (None, solver.order):
            raise InvalidInput("Give `order` only with the class `Taylor`; `Taylor(order=…)` already has one.")
        return Stepping.SERIES, solver
    if not (isinstance(system, AbstractLiePoissonSystem) and goes_along_orbit(system, method)):
        return Stepping.ADAPTIVE_STEPS, adaptive_solver(system, method, order)
    made = isinstance(method, integrators.AbstractOrbitSolver)
    return Stepping.EQUAL_STEPS, method if made else orbit_solver(system, method, order)


def step_angle(order: int) -> float:
    """Return by how much [rad] the fastest rotation turns in a default step of a method."""
    return {6: 0.1, 8: 0.2}.get(order, STEP_ANGLE)


@eqx.filter_jit
def turning_rates(
    system: AbstractLiePoissonSystem, state: Double[Array, "..."], times: Float64[Array, "time"]
) -> Float64[Array, "*batch"]:
    """Return upper estimates of the rates (batch…) [rad/s] at which the group turns at states, at some times.

    These are some between the first and the last, and one between each two jumps.
    """
    point, (first, last) = system.parts(state).point, (times[0], times[-1])
    moments = jnp.reshape(first, (1,))
    if _is_driven(system):
        low, high = jnp.minimum(first, last), jnp.maximum(first, last)
        jumps = jnp.sort(jnp.clip(jnp.ravel(jnp.asarray(system.jumps, float)), low, high))
        borders = jnp.concatenate([jnp.reshape(low, (1,)), jumps, jnp.reshape(high, (1,))])
        shares = first + jnp.asarray(MOMENTS_OF_TIME) * (last - first)
        moments = jnp.concatenate([shares, 0.5 * (borders[1:] + borders[:-1])])
    rates = jax.lax.map(lambda t: system.algebra.rate(system.generator(t, point)), moments)
    return jnp.maximum(jnp.max(rates, axis=0), jnp.zeros(system.algebra.batch_shape(point)))


def _is_driven(system: AbstractLiePoissonSystem) -> bool:
    """Whether the generator may depend on time."""
    return type(system).generator is not AbstractLiePoissonSystem.generator


def goes_along_orbit(system: AbstractSystem, method: Any) -> bool:
    """Return whether a method of ours moves the system, as it does not with one of diffrax's."""
    if not isinstance(system, AbstractLiePoissonSystem):
        return False
    return moves_by_generator(system) if method is None else not is_adaptive(method)


def is_adaptive(method: Any) -> bool:
    """Return whether a method is one of diffrax's own solvers."""
    return isinstance(method, diffrax.AbstractSolver) and not isinstance(method, integrators.AbstractOrbitSolver)


def adaptive_solver(system: AbstractSystem, method: Any, order: int | None) -> diffrax.AbstractSolver:
    """Return diffrax's solver to use.

    Raises:
        InvalidInput: for a method of ours, which cannot move the system, one without adaptive steps, or an order.
    """
    if method is not None and not is_adaptive(method):
        raise InvalidInput(
            f"`method` must be a diffrax solver for {type(system).__name__}, which is not a Lie–Poisson system; "
            f"got {shown(method)}. Leave it out for diffrax.Dopri8()."
        )
    if order is not None:
        raise InvalidInput("`order` goes with a class of methods; the solver given has its own.")
    method = diffrax.Dopri8() if method is None else method
    whole = method.term_structure in (diffrax.AbstractTerm, diffrax.ODETerm)
    if not (whole and isinstance(method, diffrax.AbstractAdaptiveSolver)):
        raise InvalidInput(
            f"`method` must estimate the error of its steps and take the rates of change as one; diffrax's "
            f"{type(method).__name__} does not. Take diffrax.Dopri8(), or diffrax.Kvaerno5() for stiff systems."
        )
    return method


def orbit_solver(system: AbstractLiePoissonSystem, method: Any, order: int | None) -> Any:
    """Return a solver of the class, or of the one that goes with the system, with a step size to be replaced.

    Raises:
        InvalidInput: for what is not a class of methods.
    """
    method = class_for(system) if method is None else method
    if isinstance(method, type) and issubclass(method, integrators.AbstractOrbitSolver):
        any_size = jnp.asarray(1.0)
        return method(system, any_size) if order is None else method(system, any_size, order=order)  # type: ignore[call-arg]
    raise InvalidInput(f"`method` must be a class of polhode.integrators or a diffrax solver; got {shown(method)}.")


def class_for(system: AbstractLiePoissonSystem) -> Any:
    """Return the class of methods that goes with a system."""
    return getattr(integrators, name_class_for(system))


def name_class_for(system: AbstractLiePoissonSystem) -> str:
    """Return the name of ``class_for``, without importing it and diffrax."""
    if system.flows:
        return "Splitting"
    algebra = system.algebra
    of_spins = algebra.is_of_spins and len(algebra.element_shape) > 1
    return "SphericalMidpoint" if of_spins else "LieMidpoint"
