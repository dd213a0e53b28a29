"""Motions by Taylor series as one operation of JAX, for use inside traced functions."""

from __future__ import annotations

from typing import Any, NamedTuple

import jax
import jax.numpy as jnp
import numpy as np

from polhode._base.arrays import is_traced
from polhode._base.arrays.elementwise import Elementwise
from polhode._base.arrays.namespaces import ENCLOSED
from polhode.errors import InvalidInput
from polhode.integrators._series_derivatives import Sensitive, Skeleton, make_operation
from polhode.systems.base import AbstractSystem
from polhode.taylor.expressions import Untraceable
from polhode.taylor.machine import TRACING, Form
from polhode.taylor.runs import Precision
from polhode.taylor.structure import Structure, split_numbers
from polhode.types import Array, Double, Float64


class Series(NamedTuple):
    """A motion by series, traced or not.

    Attributes:
        states: (batch…, T, …).
        received: name → the integral of each balance, (batch…, T).
        failed: (batch…) whether steps shrank to nothing.
        steps: (batch…) how many were taken.
    """

    states: Double[Array, "..."]
    received: dict[str, Float64[Array, "*batch time"]]
    failed: Array
    steps: Array


def series_solution(
    system: AbstractSystem, state: Double[Array, "..."], times: Float64[Array, "time"], precision: Precision,
    longest: float,
) -> Series:
    """Return a motion from states (batch…, …) at times (T,), as a function that JAX batches and differentiates.

    Raises:
        InvalidInput: for a system with events or jumps, or one whose rates have no series in its numbers; for extended
            precision.
    """
    if precision.extended:
        raise InvalidInput("`precision` \"extended\" of Taylor is for `simulate`; `solve` has that of doubles alone.")
    name = type(system).__name__
    if system.events or np.size(system.jumps):
        raise InvalidInput(
            f"Taylor moves {name} by `simulate` alone, as it has events or jumps. Leave out `method`, or give "
            "diffrax.Dopri8()."
        )
    try:
        structure, arrays = split_numbers(system)
    except TypeError:
        raise InvalidInput(f"{name} has parts that cannot be hashed; make them arrays or fields of a module.") from None
    parameters = jnp.concatenate([jnp.zeros(0), *(jnp.ravel(x) for x in arrays)])
    form = Form(tuple(np.shape(state)[np.ndim(state) - system.state_axes :]), bool(jnp.iscomplexobj(state)))
    kind = complex if form.is_complex else float
    shape = jax.ShapeDtypeStruct((), float), jax.ShapeDtypeStruct(form.shape, kind)
    balances = tuple(jax.eval_shape(lambda t, x: system.balances(t, x), *shape))
    skeleton = Skeleton(structure, form, balances)
    try:
        operation = make_operation(Sensitive(skeleton, range(0)), len(times), precision, longest)
    except (Untraceable, *TRACING) as error:
        if isinstance(error, TRACING) and _encloses_traced(structure, form):
            raise InvalidInput(f"the functions of {name} {ENCLOSED}") from None
        raise InvalidInput(
            f"{name} has no Taylor series in its numbers, which `solve` needs: {str(error).splitlines()[0]}. Leave out "
            "`method`, or call `simulate`."
        ) from None
    return _place(system, skeleton, operation, state, times, parameters)


def _encloses_traced(structure: Structure, form: Form) -> bool:
    """Whether rates of change contain traced numbers that are not fields of the system."""

    def rates(t: Any, numbers: Any, parameters: Any) -> Any:
        return structure.with_numbers(parameters).vector_field(t, form.state(numbers))

    shapes = [jax.ShapeDtypeStruct(shape, float) for shape in ((), (form.size,), (structure.size,))]
    try:
        return is_traced(*jax.make_jaxpr(rates)(*shapes).consts)
    except TRACING:
        return False


def _place(
    system: AbstractSystem, skeleton: Skeleton, operation: Elementwise, state: Array, times: Array, parameters: Array
) -> Series:
    form, still = skeleton.form, jax.lax.stop_gradient
    batch = jnp.shape(state)[: jnp.ndim(state) - len(form.shape)]
    flat = jnp.reshape(jnp.asarray(state), (*batch, -1))
    if form.is_complex:
        flat = jnp.reshape(jnp.stack([jnp.real(flat), jnp.imag(flat)], axis=-1), (*batch, -1))
    times = jnp.asarray(times)
    one = Sensitive(skeleton, range(0))

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
    samples, lost, steps = operation(start, still(times), parameters, sizes)
    samples = jnp.reshape(samples, (*batch, len(times), -1))
    along = jax.vmap(rates)
    for _ in batch:
        along = jax.vmap(along, (None, 0))
    late = (times - still(times)).at[0].set(0.0)[:, None]
    samples = samples + along(still(times), samples[..., :n]) * late
    at_first = jnp.zeros_like(samples[..., 0, :]).at[..., :n].set(first[..., :n] * (times[0] - still(times[0])))
    samples = samples.at[..., 0, :].add(at_first)
    received = {name: samples[..., n + k] - first[..., None, n + k] * (times[0] - still(times[0]))
                for k, name in enumerate(skeleton.balances)}
    numbers = samples[..., :n]
    if form.is_complex:
        pairs = jnp.reshape(numbers, (*numbers.shape[:-1], -1, 2))
        numbers = jax.lax.complex(pairs[..., 0], pairs[..., 1])
    return Series(jnp.reshape(numbers, (*batch, len(times), *form.shape)), received, lost > 0, steps)
