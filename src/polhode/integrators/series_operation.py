"""Motions by Taylor series as one operation of JAX, with its derivatives by the start and by the numbers in a system.

These numbers stand beside the state and do not move, so that what is traced once serves all of their values. Tangents
go along with the motion by the same recurrences, and all in one run.
"""

from __future__ import annotations

import math
from functools import lru_cache
from typing import Any, NamedTuple

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np

from polhode.arrays.elementwise import Elementwise
from polhode.errors import InvalidInput
from polhode.integrators.series_adjoint import Returning, weights_back
from polhode.motion.outcome import Status
from polhode.systems.base import AbstractSystem
from polhode.systems.forms import rates_of_change
from polhode.taylor.expressions import Untraceable
from polhode.taylor.machine import TRACING, Form, machine_of
from polhode.taylor.runs import Precision, runs_of
from polhode.taylor.structure import Structure, parted
from polhode.types import Array, Double, Float64

TOGETHER = 13  # tangents that go along with one run
SAMPLES = 64  # at which it takes as long to come back as so many tangents take


class Series(NamedTuple):
    """A motion by series, traced or not.

    Attributes:
        states: (batch…, T, …).
        received: name → what each balance received, (batch…, T).
        failed: (batch…) whether steps shrank to nothing.
        steps: (batch…) how many were taken.
    """

    states: Double[Array, "..."]
    received: dict[str, Float64[Array, "*batch time"]]
    failed: Array
    steps: Array


class _Skeleton(NamedTuple):
    """How a system lies in real numbers without its own."""

    structure: Structure
    form: Form
    balances: tuple[str, ...]


class _Sensitive(AbstractSystem):
    """State, what balances received, numbers of a system, and some of their derivatives, as one flat state.

    Attributes:
        varied: by which of the numbers of state and system, one after the other, derivatives go along.
    """

    skeleton: _Skeleton = eqx.field(static=True)
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
        found = system.invariants(self.skeleton.form.state(state[:n]))
        return {name: value for name, value in found.items() if jnp.ndim(value) == 0}

    def __hash__(self) -> int:
        return hash((self.skeleton, self.varied))

    def __eq__(self, other: object) -> bool:
        return isinstance(other, _Sensitive) and (self.skeleton, self.varied) == (other.skeleton, other.varied)


def series_solution(
    system: AbstractSystem, state: Double[Array, "..."], times: Float64[Array, "time"], precision: Precision,
    longest: float,
) -> Series:  # fmt: skip
    """Return a motion from states (batch…, …) at times (T,), as a function that JAX batches and differentiates.

    Raises:
        InvalidInput: for a system with events or jumps, or one whose rates have no series in its numbers.
    """
    name = type(system).__name__
    if system.events or np.size(system.jumps):
        raise InvalidInput(
            f"Taylor moves {name} by `simulate` alone, as it has events or jumps. Leave out `method`, or give "
            "diffrax.Dopri8()."
        )
    try:
        structure, arrays = parted(system)
    except TypeError:
        raise InvalidInput(f"{name} has parts that cannot be hashed; make them arrays or fields of a module.") from None
    parameters = jnp.concatenate([jnp.zeros(0), *(jnp.ravel(x) for x in arrays)])
    form = Form(tuple(np.shape(state)[np.ndim(state) - system.state_axes :]), bool(jnp.iscomplexobj(state)))
    kind = complex if form.is_complex else float
    shape = jax.ShapeDtypeStruct((), float), jax.ShapeDtypeStruct(form.shape, kind)
    balances = tuple(jax.eval_shape(lambda t, x: system.balances(t, x), *shape))
    skeleton = _Skeleton(structure, form, balances)
    try:
        operation = _operation(_Sensitive(skeleton, range(0)), len(times), precision, longest)
    except (Untraceable, *TRACING) as error:
        raise InvalidInput(
            f"{name} has no Taylor series in its numbers, which `solve` needs: {str(error).splitlines()[0]}. Leave out "
            "`method`, or call `simulate`."
        ) from None
    return _placed(system, skeleton, operation, state, times, parameters)


def _placed(
    system: AbstractSystem, skeleton: _Skeleton, operation: Elementwise, state: Array, times: Array, parameters: Array
) -> Series:
    form, still = skeleton.form, jax.lax.stop_gradient
    batch = jnp.shape(state)[: jnp.ndim(state) - len(form.shape)]
    flat = jnp.reshape(jnp.asarray(state), (*batch, -1))
    if form.is_complex:
        flat = jnp.reshape(jnp.stack([jnp.real(flat), jnp.imag(flat)], axis=-1), (*batch, -1))
    times = jnp.asarray(times)
    one = _Sensitive(skeleton, range(0))

    def scales(numbers: Any) -> Any:
        sizes = jnp.ravel(system.scales(form.state(numbers)) * jnp.ones(form.shape))
        return jnp.repeat(sizes, 2) if form.is_complex else sizes

    def rates(t: Any, numbers: Any) -> Any:
        return one.flow(t, numbers, parameters)

    over = scales
    for _ in batch:
        over = jax.vmap(over)
    sizes = still(over(flat))
    # where the first time moves, the start moves against it; each sample moves along with its own time
    n, moved = form.size, rates
    for _ in batch:
        moved = jax.vmap(moved, (None, 0))
    first = moved(times[0], flat)
    start = flat - first[..., :n] * (times[0] - still(times[0]))
    found, lost, steps = operation(start, still(times), parameters, sizes)
    found = jnp.reshape(found, (*batch, len(times), -1))
    along = jax.vmap(rates)
    for _ in batch:
        along = jax.vmap(along, (None, 0))
    late = (times - still(times)).at[0].set(0.0)[:, None]
    found = found + along(still(times), found[..., :n]) * late
    at_first = jnp.zeros_like(found[..., 0, :]).at[..., :n].set(first[..., :n] * (times[0] - still(times[0])))
    found = found.at[..., 0, :].add(at_first)
    received = {name: found[..., n + k] - first[..., None, n + k] * (times[0] - still(times[0]))
                for k, name in enumerate(skeleton.balances)}  # fmt: skip
    numbers = found[..., :n]
    if form.is_complex:
        pairs = jnp.reshape(numbers, (*numbers.shape[:-1], -1, 2))
        numbers = jax.lax.complex(pairs[..., 0], pairs[..., 1])
    return Series(jnp.reshape(numbers, (*batch, len(times), *form.shape)), received, lost > 0, steps)


def _flat(x: Array) -> Array:
    """Return an array whose last two axes are one."""
    return x.reshape(*x.shape[:-2], -1)


def _returning(plain: _Sensitive) -> Returning | None:
    """Return what moves weights back; None where it has no series."""
    n, m, rows = plain.skeleton.form.size, plain.skeleton.structure.size, plain.rows
    back = Returning(plain.flow, (n, rows - n, m))
    try:
        machine_of(back, np.zeros(n + rows + 2 * m), None)
    except Untraceable:
        return None
    return back


@lru_cache(maxsize=32)
def _operation(plain: _Sensitive, count: int, precision: Precision, longest: float) -> Elementwise:
    """Return the operation: of start, times, numbers and scales, what moved at the times, whether it failed, steps.

    Raises:
        Untraceable: if rates have no series.
    """
    skeleton, rows = plain.skeleton, plain.rows
    n, m = skeleton.form.size, skeleton.structure.size
    # some at a time, which is a little faster than all at once
    parts = [range(low, min(low + TOGETHER, n + m)) for low in range(0, n + m, TOGETHER)]
    varied, has_derivatives = [_Sensitive(skeleton, part) for part in parts], True
    # traced now, as JAX must not be called from within its own computations
    with jax.ensure_compile_time_eval():
        machine_of(plain, np.zeros(rows + m), None)
        try:
            for part in varied:
                machine_of(part, np.zeros(rows + m + rows * len(part.varied)), None)
        except Untraceable:  # too many operations
            has_derivatives = False
        back = _returning(plain)

    def run(moving: _Sensitive, given: list[Array], tangents: Array) -> tuple[Any, Array, tuple[Array, Array]]:
        start, times, numbers, scales = given
        batch = np.broadcast_shapes(start.shape[:-1], times.shape[:-1], numbers.shape[:-1])
        copies = math.prod(batch)
        parts = [np.broadcast_to(x, (*batch, x.shape[-1])).reshape(copies, -1 if x.size else 0)
                 for x in (start, numbers, scales)]  # fmt: skip
        late = np.broadcast_to(times, (*batch, count)).reshape(copies, count)
        y = np.concatenate([parts[0], np.zeros((copies, rows - n)), parts[1],
                            np.broadcast_to(tangents, (copies, tangents.size))], axis=1)  # fmt: skip
        sizes = np.full(y.shape, np.inf)
        sizes[:, :n] = parts[2]
        samples = np.full((copies, count, y.shape[1]), np.nan)
        failed, steps = np.ones(copies, np.int64), np.zeros(copies, np.int64)
        with np.errstate(invalid="ignore"):
            gaps = np.diff(late, axis=1)
            fine = np.isfinite(y).all(axis=1) & np.isfinite(gaps).all(axis=1) & (gaps * gaps[:, :1] > 0.0).all(axis=1)
        known, which = np.unique(late[fine], axis=0, return_inverse=True)
        for number, times_of_some in enumerate(known):
            some = np.flatnonzero(fine)[which.ravel() == number]
            found = runs_of(moving, y[some], times_of_some, precision, longest, scales=sizes[some])
            samples[some], steps[some] = found.states, found.steps
            failed[some] = found.status == Status.NOT_CONVERGED
        return batch, samples.reshape(*batch, count, -1), (failed.reshape(batch), steps.reshape(batch))

    def values(start: Array, times: Array, numbers: Array, scales: Array) -> tuple[Any, ...]:
        _, samples, (failed, steps) = run(plain, [np.asarray(x) for x in (start, times, numbers, scales)], np.zeros(0))
        return _flat(samples[..., :rows]), failed, steps

    def jacobian(start: Array, times: Array, numbers: Array, scales: Array) -> tuple[tuple[Any, ...], Array]:
        given, every = [np.asarray(x) for x in (start, times, numbers, scales)], np.eye(n + m, rows)
        every[n:] = 0.0
        runs = [run(part, given, every[part.varied.start : part.varied.stop].ravel()) for part in varied]
        batch, samples, ends = runs[0]
        found = [moved[..., rows + m :].reshape(*batch, count, len(part.varied), rows)
                 for part, (_, moved, _) in zip(varied, runs, strict=True)]  # fmt: skip
        by = np.swapaxes(np.concatenate(found, axis=-2), -1, -2).reshape(*batch, count * rows, n + m)
        zeros = np.zeros((*batch, count * rows, count))
        columns = np.concatenate([by[..., :n], zeros, by[..., n:], zeros[..., :1].repeat(n, axis=-1)], axis=-1)
        return (_flat(samples[..., :rows]), *ends), columns

    def pullback(start: Array, times: Array, numbers: Array, scales: Array, weights: Array) -> tuple[Any, ...]:
        given = [np.asarray(x) for x in (start, times, numbers, scales)]
        own, asked = np.broadcast_shapes(*(x.shape[:-1] for x in given)), np.shape(weights)[:-1]
        shapes = [(*np.broadcast_shapes(own, asked), size) for size in (n, count, m, n)]
        if back is None or math.prod(shapes[0][:-1]) > math.prod(own) or count - 1 > SAMPLES * len(parts):
            return _by_columns(jacobian(*given)[1], np.asarray(weights), (n, count, m, n))
        flat = [np.broadcast_to(x, (*shapes[0][:-1], x.shape[-1])).reshape(-1, x.shape[-1]) for x in (*given, weights)]
        start, late, numbers, scales, weights = flat
        found = [np.full((len(start), size), np.nan) for size in (n, count, m, n)]
        found[1][:], found[3][:] = 0.0, 0.0
        known, which = np.unique(late, axis=0, return_inverse=True)
        for number, times_of_some in enumerate(known):
            some = np.flatnonzero(which.ravel() == number)
            these, weighed = (start[some], numbers[some], scales[some]), weights[some].reshape(-1, count, rows)
            *ways, good = weights_back(plain, back, these, times_of_some, weighed, precision, longest)
            found[0][some], found[2][some] = ways
            if not good.all():  # what is damped fast has no way back
                rest = some[~good]
                columns = jacobian(*(x[rest] for x in (start, late, numbers, scales)))[1]
                for x, part in zip(found, _by_columns(columns, weights[rest], (n, count, m, n)), strict=True):
                    x[rest] = part
        return tuple(x.reshape(shape) for x, shape in zip(found, shapes, strict=True))

    outputs = ((count * rows,), float), ((), np.int64), ((), np.int64)
    return Elementwise("solve by Taylor", values, ((n,), (count,), (m,), (n,)), outputs,
                       jacobian if has_derivatives else None, positive=0,
                       pullback=pullback if has_derivatives else None)  # fmt: skip


def _by_columns(columns: Array, weights: Array, sizes: tuple[int, ...]) -> tuple[Array, ...]:
    """Return the weights of arguments by the Jacobian (…, M, N) and weights (…, M) of its rows."""
    return tuple(np.split(np.einsum("...mn,...m->...n", columns, weights), np.cumsum(sizes)[:-1], axis=-1))
