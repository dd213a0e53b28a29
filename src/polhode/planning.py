"""``plan``: how a motion will be computed, decided from its system, its start and what is asked of it.

A motion with a Taylor series goes by that: to rounding, by the fewest steps. Other methods are for what series cannot
do: equal steps that can be resumed or have a given length, rates of too many operations, sliding along a jump, a
singularity on the way. ``simulate`` and ``solve`` take their methods from here.
"""

from __future__ import annotations

import contextlib
import math
import operator
import warnings
from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any, NamedTuple

import equinox as eqx
import jax.numpy as jnp
import numpy as np

from polhode import integrators
from polhode._base import check
from polhode._base.arrays import is_positive, known_numbers_only
from polhode._base.kept import kept_of_object
from polhode.errors import InvalidInput, shown
from polhode.integrators import _diffrax as diffrax
from polhode.integrators._adaptive import TOLERANCE, check_events
from polhode.integrators._choice import choose_solver, is_adaptive, name_class_for, step_angle, turning_rates
from polhode.integrators._difference import EPS
from polhode.integrators._series import Taylor, find_obstacle, goes_by_arrays, has_short_series, is_series
from polhode.integrators.probing import find_undeclared_jumps, name_jumps
from polhode.motion._plan import MotionPlan, Stepping
from polhode.systems._agreement import check_agreement, moves_by_generator
from polhode.systems._checks import advancing_times
from polhode.systems._forms import check_finite_rates, facts_of, refuse_other_objects
from polhode.systems.base import AbstractLiePoissonSystem, AbstractSystem
from polhode.taylor.runs import choose_precision
from polhode.types import Array, ArrayLike, ArrayOrFloat, Bool, Float64, Real

if TYPE_CHECKING:
    Method = type[integrators.AbstractOrbitSolver | Taylor] | diffrax.AbstractSolver[Any] | Taylor | None
else:  # naming the classes would import diffrax, which series do without
    Method = Any
ASKED = "as asked"
NUMBERS, ARRAYS, XLA = "on single numbers", "on whole arrays", "compiled by XLA"  # what computes a step


class Request(NamedTuple):
    """What is asked of a motion, checked; arguments as those of ``simulate``.

    Attributes:
        named: the system with those jumps named that were found at the start.
        every: which of the times are saved.
        among: which copies of a whole batch these are; None for all of them.
    """

    system: AbstractSystem
    named: AbstractSystem
    state: Array
    times: Float64[np.ndarray, "time"]
    method: Method = None
    step: float | None = None
    order: int | None = None
    tolerance: float | None = None
    every: int = 1
    resumable: bool = False
    memory: Sequence[Array] | None = None
    progress: Any = None
    throw: bool = True
    estimate_error: bool = True
    among: Bool[np.ndarray, "*whole"] | None = None

    @property
    def batch_shape(self) -> tuple[int, ...]:
        """The shape of the copies, () for one."""
        return np.shape(self.state)[: np.ndim(self.state) - facts_of(self.system).state_axes]

    @property
    def is_resumed(self) -> bool:
        """Whether the motion goes on from an earlier one, or is to be gone on from."""
        return self.resumable or self.memory is not None

    def of_copies(self, among: np.ndarray | np.bool_) -> Request:
        """Return the same request for some of the copies, which move as they do alone."""
        if among.all():
            return self
        state = self.state[among]
        named = name_jumps(self.system, find_undeclared_jumps(self.system, state, self.times))
        return self._replace(state=state, named=named, among=among)

    def name_copies(self, which: np.ndarray | np.bool_) -> str:
        """Return words for some copies, by their number and the indices of the first; "" without a batch."""
        if not np.ndim(which):
            return ""
        whole = np.asarray(which)
        if self.among is not None:
            whole = np.zeros(self.among.shape, bool)
            whole[self.among] = which
        first = np.argwhere(whole)[0].tolist()
        return f" in {int(whole.sum())} of {whole.size} copies, first {first[0] if len(first) == 1 else tuple(first)}"


class Prepared(NamedTuple):
    """A plan, and what its steps are made by.

    Attributes:
        plan: which is kept.
        solver: an object of ``Taylor``, of a method of ours, or of diffrax.
        sizes: of equal steps, the largest (batch…) [s], else None.
        rates: at which each copy turns, (batch…) [rad/s], likewise.
    """

    plan: MotionPlan
    solver: Any
    sizes: Float64[ArrayOrFloat, "*batch"] | None = None
    rates: Float64[ArrayOrFloat, "*batch"] | None = None


@known_numbers_only
def plan(
    system: AbstractSystem,
    state: Real[ArrayLike, "..."],
    times: Real[ArrayLike, "time"],
    method: Method = None,
    step: float | None = None,
    order: int | None = None,
    *,
    tolerance: float | None = None,
    resumable: bool = False,
) -> MotionPlan:
    """Return how ``simulate`` would compute a motion, and why that way, without computing it.

    What only the motion itself shows, as a singularity on the way, is not in it: ``Trajectory.plan`` says how it went.

    Args:
        system, state, times, method, step, order, tolerance, resumable: as ``simulate`` has them.

    Raises:
        InvalidInput: as ``simulate`` does.

    >>> import numpy as np
    >>> import polhode as ph
    >>> top = ph.systems.HeavyTop((1.0, 1.2, 2.0), mgl=1.5, axis=(0.0, 0.0, 1.0))
    >>> print(plan(top, [0.3, 0.2, 4.0, 0.0, 0.6, 0.8], np.linspace(0.0, 5.0, 11)))
    Taylor series of order 24, one copy, on single numbers; not Splitting, as no step was given
    """
    with without_warnings():
        request = check_request(system, state, times, method=method, step=step, order=order, tolerance=tolerance,
                                resumable=resumable)
        first = prepare(request)
        if first.plan.stepping is not Stepping.EQUAL_STEPS:
            check_events(request.named, request.times[0], request.state)
        if first.plan.stepping is not Stepping.SERIES:
            return first.plan
        span = request.times[0], request.times[-1]
        obstacle = find_obstacle(request.named, request.state, span, first.solver.is_extended)
        if obstacle is None:
            return first.plan
        if method is not None:
            raise obstacle
        lost = np.ones(request.batch_shape, bool) if obstacle.copies is None else (
            np.reshape(obstacle.copies, request.batch_shape))
        rest = prepare_without_series(request.of_copies(lost), obstacle.why).plan
        return rest if lost.all() else replace(first.plan, copies=int((~lost).sum()), otherwise=rest)


@contextlib.contextmanager
def without_warnings() -> Iterator[None]:
    """Leave out diffrax's warning of complex states: our solvers' arithmetic is tested on them."""
    with warnings.catch_warnings():
        warnings.filterwarnings("ignore", message="Complex dtype support in Diffrax")
        yield


def check_request(
    system: AbstractSystem, state: Any, times: Any, *, method: Any = None, step: float | None = None,
    order: int | None = None, tolerance: float | None = None, save: int = 1, resumable: bool = False, **others: Any
) -> Request:
    """Return what is asked for, checked.

    Raises:
        InvalidInput: for wrong shapes, numbers that make no sense, options that exclude each other, and a system whose
            energy, velocity, generator and flows disagree.
    """
    refuse_other_objects(system)
    state, times = np.asarray(system.check_state(state)), advancing_times(times)
    facts = facts_of(system)
    if np.ndim(state) < facts.state_axes:
        raise InvalidInput(f"`state` must be a list of numbers, as [1.0]; got the single number {shown(float(state))}.")
    if 0 in np.shape(state):
        raise InvalidInput(f"`state` has no copies to move; got shape {np.shape(state)}. Give at least one.")
    for name, value, unit in (("step", step, " time [s]"), ("tolerance", tolerance, " number")):
        if value is not None and not is_positive(value):
            raise InvalidInput(f"`{name}` must be a positive finite{unit}; got {shown(value)}.")
    step, tolerance = (None if value is None else float(value) for value in (step, tolerance))
    try:
        order = None if order is None else operator.index(order)
    except TypeError:
        raise InvalidInput(f"`order` must be a whole number; got {shown(order)}.") from None
    if tolerance is not None and tolerance < EPS:
        check.refuse("tolerance", f"at least {EPS:.2g}, a rounding", tolerance, "Leave it out for the default.")
    if step is not None and tolerance is not None and not (is_adaptive(method) or is_series(method)):
        raise InvalidInput("give `step` or `tolerance`, which chooses the step, not both.")
    every = check_every(save, len(times))
    if resumable and (len(times) - 1) % every:
        raise InvalidInput(f"`resumable` needs the last time among the saved ones; `save` {every} leaves it out.")
    if isinstance(system, AbstractLiePoissonSystem) and not facts.is_of_package:
        check_agreement(system, jnp.asarray(state), times, by_flows=_would_split(system, method))
    named = name_jumps(system, find_undeclared_jumps(system, state, times))
    return Request(system, named, state, times, method, step, order, tolerance, every, resumable, **others)


def check_every(save: Any, count: int) -> int:
    """Return the stride of saved times, checked.

    Raises:
        InvalidInput: for what is not a whole number from 1 to one less than the count of times.
    """
    if isinstance(save, bool) or not isinstance(save, int | np.integer) or not 1 <= save < count:
        raise InvalidInput(
            f"`save` must say every how many-th of the {count} times is kept, 1 to {count - 1}; got {shown(save)}. "
            "`polhode.solve` takes functions of the states too."
        )
    return int(save)


def _would_split(system: AbstractLiePoissonSystem, method: Any) -> bool:
    if method is None:
        return bool(system.flows) and moves_by_generator(system)
    return isinstance(method, integrators.Splitting) or (
        isinstance(method, type) and issubclass(method, integrators.Splitting)
    )


# ---------------------------------------------------------------------- what a motion goes by


def prepare(request: Request) -> Prepared:
    """Return how a motion goes, at first where that is by series.

    Raises:
        InvalidInput: for options that do not go with the method.
    """
    method = request.method
    if method is None or is_series(method):
        by_series = _prepare_by_series(
            request.system, np.shape(request.state), np.iscomplexobj(request.state), method, request.step,
            request.order, request.tolerance, request.is_resumed,
        )
        if by_series is not None:
            return by_series
        if method is None and not request.is_resumed and (request.step, request.order) == (None, None):
            return prepare_without_series(request, "its rates are too many operations")
    return prepare_without_series(request)


@kept_of_object
def _prepare_by_series(
    system: AbstractSystem, shape: tuple[int, ...], is_complex: bool, method: Any, step: float | None,
    order: int | None, tolerance: float | None, is_resumed: bool,
) -> Prepared | None:
    """Return how a motion goes by series; None where it does not, at first."""
    axes = facts_of(system).state_axes
    one = np.zeros(shape[len(shape) - axes :], complex if is_complex else float)
    by_arrays = goes_by_arrays(system, one)
    reason = ASKED
    if method is None:
        by_default = (step, order) == (None, None) and (facts_of(system).series_of_arrays or not is_resumed)
        if not (by_default and has_short_series(system, one)):
            return None
        reason = f"not {_name_of_other(system)}, as no step was given"
    elif is_resumed and not by_arrays:
        return None
    _, solver = choose_solver(system, method or Taylor, order)
    own_order = int(choose_precision(tolerance, solver.order, solver.is_extended).order)
    plan = MotionPlan(Stepping.SERIES, "Taylor", own_order, step, tolerance, math.prod(shape[: len(shape) - axes]),
                      ARRAYS if by_arrays else NUMBERS, reason)
    return Prepared(plan, solver)


@kept_of_object
def _name_of_other(system: AbstractSystem) -> str:
    if isinstance(system, AbstractLiePoissonSystem) and moves_by_generator(system):
        return name_class_for(system)
    return "Dopri8"


def prepare_without_series(request: Request, obstacle: str = "") -> Prepared:
    """Return how a motion goes that has no series, or is not to go by one.

    Args:
        request: with all options.
        obstacle: why it has no series, a clause; "" where the options say so.

    Raises:
        InvalidInput: for options that do not go with the method.
    """
    resumed, method = request.is_resumed, request.method
    stepping, solver = choose_solver(request.system, method, request.order)
    if resumed and stepping is not Stepping.EQUAL_STEPS:
        raise InvalidInput(
            "`resumable` and `memory` go with methods of equal steps, and Taylor series of large arrays; others "
            "start over."
        )
    reason = ASKED if method is not None else _reason(request, obstacle)
    if stepping is Stepping.EQUAL_STEPS:
        return _prepare_equal_steps(request, solver, reason)
    tolerance = TOLERANCE if request.tolerance is None else request.tolerance
    return Prepared(MotionPlan(stepping, type(solver).__name__, solver.order(None), request.step, tolerance,
                               _count(request), XLA, reason), solver)


def _reason(request: Request, obstacle: str) -> str:
    """Return why series do not make the motion."""
    if not obstacle:
        options = [name for name in ("step", "order") if getattr(request, name) is not None]
        obstacle = f"`{options[0]}` was given" if options else "only equal steps are resumed to the same bits"
    return f"no Taylor series, as {obstacle}"


def _count(request: Request) -> int:
    return math.prod(request.batch_shape)


def _prepare_equal_steps(request: Request, solver: Any, reason: str) -> Prepared:
    """Return the method with each copy's largest step, which is not longer than from sample to sample."""
    own, system, times = request.system, request.named, request.times
    assert isinstance(system, AbstractLiePoissonSystem)
    is_made = solver is request.method
    if is_made and not bool(eqx.tree_equal(solver.system, own)):
        raise InvalidInput("`method` was made for another system; make it with the one that is simulated.")
    if is_made and not is_positive(solver.step_size):
        raise InvalidInput(f"the step of `method` must be a positive finite time [s], whichever way the times go; got "
                           f"{shown(float(solver.step_size))}.")  # fmt: skip
    span = jnp.asarray([times[0], times[-1]], float)
    rates = np.asarray(turning_rates(system, jnp.asarray(request.state), span), dtype=float)
    if not np.isfinite(rates).all():
        check_finite_rates(system, times[0], request.state)
        raise InvalidInput(
            f"`state` is too large: the rate of turning of {type(system).__name__} at it overflows. "
            "Choose units in which it is nearer to one."
        )
    if is_made and (request.step, request.order, request.tolerance) != (None, None, None):
        raise InvalidInput(
            "`step`, `order` and `tolerance` go with a class of methods; the solver given was made with its own."
        )
    solver = eqx.tree_at(lambda each: each.system, solver, system)
    step = float(solver.step_size) if is_made else request.step
    with np.errstate(divide="ignore"):
        sizes = step_angle(solver.order(None)) / rates if step is None else np.full(rates.shape, float(step))
    sizes = np.minimum(sizes, float(np.abs(np.diff(times)).max()))
    return Prepared(MotionPlan(Stepping.EQUAL_STEPS, type(solver).__name__, solver.order(None), float(np.max(sizes)),
                               request.tolerance, _count(request), XLA, reason), solver, sizes, rates)
