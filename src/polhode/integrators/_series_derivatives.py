"""A motion by Taylor series as a function of arrays, with derivatives by its start and by the system's numbers.

These numbers are components beside the state that do not move, so that one trace serves all of their values. Tangents
are integrated with the motion by its recurrences, all in one run or few; gradients by the adjoint equations.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace
from functools import lru_cache
from typing import Any, NamedTuple

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np

from polhode._base.arrays.elementwise import Elementwise
from polhode.integrators._series_adjoint import Returning, weights_back
from polhode.motion._outcome import Status
from polhode.systems._forms import rates_of_change
from polhode.systems.base import AbstractSystem
from polhode.taylor.expressions import Untraceable
from polhode.taylor.machine import Form, build_machine
from polhode.taylor.runs import Precision, run_copies
from polhode.taylor.structure import Structure
from polhode.types import Array, Bool, Float64, Integer


class DerivativeLimits(NamedTuple):
    """Which way to derivatives takes the least time."""

    tangents_together: int = 13  # in one run
    max_directions: int = 4  # for each state, which take a run each; more take the Jacobian
    max_samples: int = 64  # to each run of tangents: with more, going back takes longer than the Jacobian


LIMITS = DerivativeLimits()


class Skeleton(NamedTuple):
    """How a system lies in real numbers without its own."""

    structure: Structure
    form: Form
    balances: tuple[str, ...]


class Sensitive(AbstractSystem):
    """State, integrals of balances, numbers of a system, and some of their derivatives, as one flat state.

    Attributes:
        varied: by which of the numbers of state and system, one after the other, derivatives go along.
    """

    skeleton: Skeleton = eqx.field(static=True)
    varied: range = eqx.field(static=True)

    @property
    def rows(self) -> int:
        """How many numbers move."""
        return self.skeleton.form.size + len(self.skeleton.balances)

    def flow(self, t: Any, numbers: Any, parameters: Any) -> Any:
        """Return the rates of change of state and balances."""
        form, system = self.skeleton.form, self.skeleton.structure.with_numbers(parameters)
        state = form.state(numbers)
        received = [jnp.ravel(b.rate) for b in system.balances(t, state).values()]
        return jnp.concatenate([form.numbers(rates_of_change(system, t, state)), *received])

    def vector_field(self, t: Any, state: Any) -> Any:
        n, m, rows = self.skeleton.form.size, self.skeleton.structure.size, self.rows
        numbers, parameters = state[:n], state[rows : rows + m]
        if not self.varied:
            return jnp.concatenate([self.flow(t, numbers, parameters), jnp.zeros(m)])
        rates, pushed = jax.linearize(lambda x, p: self.flow(t, x, p), numbers, parameters)
        tangents = jnp.reshape(state[rows + m :], (len(self.varied), rows))
        ways = jnp.concatenate([jnp.zeros((n, m)), jnp.eye(m)])[self.varied.start : self.varied.stop]
        changes = jax.vmap(pushed)(tangents[:, :n], ways)
        return jnp.concatenate([rates, jnp.zeros(m), jnp.ravel(changes)])

    def invariants(self, state: Any) -> dict[str, Any]:
        n, m, rows = self.skeleton.form.size, self.skeleton.structure.size, self.rows
        system = self.skeleton.structure.with_numbers(state[rows : rows + m])
        invariants = system.invariants(self.skeleton.form.state(state[:n]))
        return {name: value for name, value in invariants.items() if jnp.ndim(value) == 0}

    def __hash__(self) -> int:
        return hash((self.skeleton, self.varied))

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Sensitive) and (self.skeleton, self.varied) == (other.skeleton, other.varied)


class Directed(AbstractSystem):
    """State, integrals of balances, and numbers of a system, and a change of each of these.

    Attributes:
        flow: (t, x, p) → rates of change of state and balances.
        sizes: how many numbers state, balances and system are.
    """

    flow: Any = eqx.field(static=True)
    sizes: tuple[int, int, int] = eqx.field(static=True)

    def vector_field(self, t: Any, state: Any) -> Any:
        (x, _, p), (dx, _, dp) = (jnp.split(half, np.cumsum(self.sizes[:2])) for half in jnp.split(state, 2))
        rates, changes = jax.jvp(lambda x, p: self.flow(t, x, p), (x, p), (dx, dp))
        return jnp.concatenate([rates, jnp.zeros_like(p), changes, jnp.zeros_like(p)])

    def invariants(self, state: Any) -> dict[str, Any]:
        return {}


class Runs(NamedTuple):
    """Samples of motions, and of their tangents.

    Attributes:
        states: (batch…, T, n) infinite after a failure; NaN where the start is not finite or times do not advance.
        failed: (batch…) whether steps shrank to nothing.
        steps: (batch…) how many were taken.
    """

    states: Float64[Array, "*batch time n"]
    failed: Integer[Array, "*batch"]
    steps: Integer[Array, "*batch"]


class Motion:
    """The motion of one structure at so many times, as a function of start, times, numbers and sizes of components.

    Args:
        plain: the motion without derivatives.
        count: of times.
        precision, longest: of steps.

    Raises:
        Untraceable: if rates have no series.
    """

    def __init__(self, plain: Sensitive, count: int, precision: Precision, longest: float) -> None:
        n, m = plain.skeleton.form.size, plain.skeleton.structure.size
        sizes = n, plain.rows - n, m
        self.plain, self.count, self.precision, self.longest = plain, count, precision, longest
        self.n, self.m, self.rows, self.inputs = n, m, plain.rows, (n, count, m, n)
        # some at a time, which is a little faster than all at once
        width = LIMITS.tangents_together
        ranges = [range(low, min(low + width, n + m)) for low in range(0, n + m, width)]
        self.varied = [Sensitive(plain.skeleton, some) for some in ranges]
        self.directed, self.back = Directed(plain.flow, sizes), Returning(plain.flow, sizes)
        # traced now, as JAX must not be called from within its own computations
        with jax.ensure_compile_time_eval():
            build_machine(plain, np.zeros(self.rows + m), None)
            along = [(part, self.rows + m + self.rows * len(part.varied)) for part in self.varied]
            self.has_derivatives = all(_is_traced(*each) for each in [*along, (self.directed, 2 * (self.rows + m))])
            self.comes_back = _is_traced(self.back, self.n + self.rows + 2 * m)

    def operation(self) -> Elementwise:
        """Return the JAX operation for the moving numbers at the times, whether the run failed, and its steps."""
        outputs = ((self.count * self.rows,), float), ((), np.int64), ((), np.int64)
        inputs = tuple((size,) for size in self.inputs)
        plain = Elementwise("solve by Taylor", self.values, inputs, outputs, positive=0, on_host=True)
        if not self.has_derivatives:
            return plain
        return replace(plain, jacobian=self.jacobian, forward=self.ahead, back=self.weights_of)

    def values(self, *arguments: Array) -> tuple[Any, ...]:
        """Return the values of the operation."""
        runs = self.run(self.plain, arguments, np.zeros(0))
        return _flat(runs.states[..., : self.rows]), runs.failed, runs.steps

    def jacobian(self, *arguments: Array) -> tuple[tuple[Any, ...], Float64[Array, "*batch moved given"]]:
        """Return ``values``, and the derivatives of the moving numbers."""
        n, m, rows, count = self.n, self.m, self.rows, self.count
        every = np.eye(n + m, rows)
        every[n:] = 0.0
        runs = [self.run(part, arguments, every[part.varied.start : part.varied.stop].ravel()) for part in self.varied]
        batch = runs[0].failed.shape
        blocks = [run.states[..., rows + m :].reshape(*batch, count, len(part.varied), rows)
                 for part, run in zip(self.varied, runs, strict=True)]
        by = np.swapaxes(np.concatenate(blocks, axis=-2), -1, -2).reshape(*batch, count * rows, n + m)
        zeros = np.zeros((*batch, count * rows, count))
        columns = np.concatenate([by[..., :n], zeros, by[..., n:], zeros[..., :1].repeat(n, axis=-1)], axis=-1)
        return (_flat(runs[0].states[..., :rows]), runs[0].failed, runs[0].steps), columns

    def ahead(self, *arguments: Array) -> tuple[Float64[Array, "*batch moved"]]:
        """Return the tangents of the moving numbers, from the arguments and theirs; times and sizes have none."""
        primals, changes = arguments[:4], arguments[4:]
        own, asked = _batch(primals), _batch(arguments)
        if math.prod(asked) > LIMITS.max_directions * math.prod(own):
            moved = np.concatenate([np.broadcast_to(x, (*asked, x.shape[-1])) for x in changes], axis=-1)
            return (np.einsum("...mn,...n->...m", self.jacobian(*primals)[1], moved),)
        of_start, of_numbers = (np.broadcast_to(x, (*asked, x.shape[-1])) for x in (changes[0], changes[2]))
        tangent = np.concatenate([of_start, np.zeros((*asked, self.rows - self.n)), of_numbers], axis=-1)
        runs = self.run(self.directed, [np.broadcast_to(x, (*asked, x.shape[-1])) for x in primals], tangent)
        return (_flat(runs.states[..., self.rows + self.m : 2 * self.rows + self.m]),)

    def weights_of(self, *arguments: Array) -> tuple[Float64[Array, "..."], ...]:
        """Return the weights of the arguments, from those of the moving numbers; times and sizes have none."""
        primals, weights = arguments[:4], arguments[4]
        own, asked = _batch(primals), _batch(arguments)
        many = self.count - 1 > LIMITS.max_samples * len(self.varied)
        if many or not self.comes_back or math.prod(asked) > math.prod(own):
            return self._by_columns(primals, weights)
        start, late, numbers, scales, weights = (
            np.broadcast_to(x, (*asked, x.shape[-1])).reshape(math.prod(asked), x.shape[-1]) for x in arguments
        )
        cotangents = [np.full((len(start), size), np.nan) for size in self.inputs]
        good = np.ones(len(start), bool)
        for times, some in _by_times(late, _finite(late, start, numbers)):
            these, weighed = (start[some], numbers[some], scales[some]), weights[some]
            weighed = weighed.reshape(-1, self.count, self.rows)
            of_start, of_numbers, good[some] = weights_back(
                self.plain, self.back, these, times, weighed, self.precision, self.longest
            )
            for x, part in zip(cotangents, (of_start, 0.0, of_numbers, 0.0), strict=True):
                x[some] = part
        if not good.all():  # fast damping has no way back
            rest = [x[~good] for x in (start, late, numbers, scales)]
            for x, part in zip(cotangents, self._by_columns(rest, weights[~good]), strict=True):
                x[~good] = part
        return tuple(x.reshape(*asked, x.shape[-1]) for x in cotangents)

    def _by_columns(self, arguments: Any, weights: Array) -> tuple[Array, ...]:
        cotangents = np.einsum("...mn,...m->...n", self.jacobian(*arguments)[1], weights)
        return tuple(np.split(cotangents, np.cumsum(self.inputs)[:-1], axis=-1))

    def run(self, moving: AbstractSystem, arguments: Any, tangents: Array) -> Runs:
        """Return a motion with tangents, common or those of each copy."""
        start, times, numbers, scales = arguments
        batch, copies = _batch(arguments), math.prod(_batch(arguments))
        flat = lambda x: np.broadcast_to(x, (*batch, x.shape[-1])).reshape(copies, x.shape[-1])  # noqa: E731
        late, none = flat(times), np.zeros((copies, self.rows - self.n))
        y = np.concatenate([flat(start), none, flat(numbers), flat(tangents)], axis=1)
        sizes = np.full(y.shape, np.inf)
        sizes[:, : self.n] = flat(scales)
        samples = np.full((copies, self.count, y.shape[1]), np.nan)
        failed, steps = np.ones(copies, np.int64), np.zeros(copies, np.int64)
        for times_of_some, some in _by_times(late, _finite(late, y)):
            runs = run_copies(moving, y[some], times_of_some, self.precision, self.longest, scales=sizes[some])
            samples[some], steps[some] = runs.states, runs.steps
            failed[some] = runs.status == Status.NOT_CONVERGED
        return Runs(samples.reshape(*batch, self.count, -1), failed.reshape(batch), steps.reshape(batch))


@lru_cache(maxsize=32)
def make_operation(plain: Sensitive, count: int, precision: Precision, longest: float) -> Elementwise:
    """Return the operation of start, times, numbers and sizes of components; see ``Motion``."""
    return Motion(plain, count, precision, longest).operation()


def _is_traced(system: AbstractSystem, size: int) -> bool:
    """Return whether a system has a series, now that it is traced; it may have too many operations."""
    try:
        build_machine(system, np.zeros(size), None)
    except Untraceable:
        return False
    return True


def _batch(arguments: Any) -> tuple[int, ...]:
    return np.broadcast_shapes(*(x.shape[:-1] for x in arguments))


def _flat(x: Array) -> Array:
    """Return an array whose last two axes are one."""
    return x.reshape(*x.shape[:-2], -1)


def _finite(times: Float64[Array, "copies time"], *arrays: Array) -> Bool[Array, "copies"]:
    """Return for which copies all is a number, and times advance in one direction."""
    with np.errstate(invalid="ignore"):
        gaps = np.diff(times, axis=1)
        fine = np.isfinite(gaps).all(axis=1) & (gaps * gaps[:, :1] > 0.0).all(axis=1)
    return fine & np.all([np.isfinite(x).all(axis=1) for x in arrays], axis=0)


def _by_times(
    times: Float64[Array, "copies time"], fine: Bool[Array, "copies"]
) -> Iterator[tuple[np.ndarray, np.ndarray]]:
    """Yield times and which of the fine copies have them."""
    known, which = np.unique(times[fine], axis=0, return_inverse=True)
    for number, some in enumerate(known):
        yield some, np.flatnonzero(fine)[which.ravel() == number]
