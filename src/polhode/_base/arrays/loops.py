"""Loops and branches that NumPy runs as they are and JAX compiles."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

import numpy as np

from polhode._base.arrays.namespaces import is_foreign, is_jax, is_traced, namespace


def barrier(values: Any) -> Any:
    """Have XLA finish a nest of tuples of arrays before it goes on; return arrays that are not traced as they are.

    When XLA on the CPU fuses a stack with the values that its parts share, it recomputes these for every part, and so
    on down: the cost grows exponentially with the length of the computation. An optimization barrier does not help,
    because XLA for CPU removes it before it fuses. A loop it cannot see through stays.
    """
    if not is_traced(*_leaves(values)):
        return values
    import jax
    import jax.numpy as jnp

    from polhode._base.arrays.operation import Operation

    def finished(whole: Any) -> Any:
        return jax.lax.platform_dependent(whole, cpu=_loop_once, default=jax.lax.optimization_barrier)

    arrays = jax.tree.map(jnp.asarray, values)
    return Operation("barrier", finished, lambda at, results, changes: at.spread(changes))(arrays)


def _leaves(values: Any) -> Iterator[Any]:
    if not isinstance(values, tuple):
        yield values
        return
    for value in values:
        yield from _leaves(value)


def _loop_once(values: Any) -> Any:
    """Return the values from the one pass of a loop whose count XLA cannot foretell."""
    import jax
    import jax.numpy as jnp

    # a comparison that is false for all numbers, but that XLA cannot know to be
    number = next(x for x in _leaves(values) if jnp.issubdtype(jnp.result_type(x), jnp.floating))
    never = jnp.any(jnp.ravel(number)[:1] > jnp.inf)
    empty = jax.tree.map(jnp.zeros_like, values)
    return jax.lax.while_loop(lambda now: now[0], lambda now: (now[0] & never, values), (~never, empty))[1]


def split_halves(a: Any) -> tuple[Any, Any]:
    """Split float64 numbers into a high and a low half of at most 26 bits and a sign each, whose products are exact.

    NumPy multiplies by 2²⁷ + 1 [Veltkamp]; XLA would fuse that product away, so JAX arrays are split by rounding
    their mantissa, as an integer, to its upper 26 bits.
    """
    if not is_jax(a):
        # c = (2²⁷ + 1) a, high = c − (c − a): Dekker, Numer. Math. 18 (1971) 224
        high = 134217729.0 * a
        high -= high - a
        return high, a - high
    import jax

    # float64 has 52 bits of mantissa: 2²⁶, half a unit of the last kept bit, is added, the lower 27 are cut off:
    # 25 and the implicit one stay
    bits = jax.lax.bitcast_convert_type(a, np.int64)
    high = jax.lax.bitcast_convert_type((bits + np.int64(1 << 26)) & np.int64(-(1 << 27)), np.float64)
    return high, a - high


def iterate(count: Any, step: Callable[[Any], Any], state: Any, like: Any) -> Any:
    """Apply ``step`` ``count`` times: a rolled loop where ``like`` is a JAX array, as unrolled loops compile slowly.

    There the count may itself be a traced integer.
    """
    if not is_jax(like):
        for _ in range(count):
            state = step(state)
        return state
    import jax

    return jax.lax.fori_loop(0, count, lambda _, carried: step(carried), state)


def iterate_until(
    step: Callable[..., tuple[Any, ...]], finished: Callable[..., Any], state: tuple[Any, ...], at_once: int, most: int
) -> tuple[Any, ...]:
    """Repeat ``step`` elementwise on a tuple of equally shaped arrays until ``finished`` holds for each element.

    An element that has finished is not stepped again. The first ``at_once`` steps are taken by all together; NumPy
    then gathers the unfinished few, JAX rolls one loop.
    """
    if is_jax(*state):
        import jax
        import jax.numpy as jnp

        def body(carried: Any) -> Any:
            count, now = carried
            done = finished(*now)
            return count + 1, tuple(jnp.where(done, old, new) for old, new in zip(now, step(*now), strict=True))

        def unfinished(carried: Any) -> Any:
            return (carried[0] < most) & jnp.any(~finished(*carried[1]))

        return jax.lax.while_loop(unfinished, body, (0, state))[1]
    if is_foreign(*state):
        xp = namespace(*state)
        for _ in range(most):
            done = finished(*state)
            if bool(xp.all(done)):
                break
            state = tuple(xp.where(done, old, new) for old, new in zip(state, step(*state), strict=True))
        return state
    for _ in range(at_once):
        state = step(*state)
    left = np.flatnonzero(~finished(*state))
    if left.size == 0:
        return state
    state = tuple(np.array(column) for column in state)
    part = tuple(column.reshape(-1)[left] for column in state)
    for _ in range(most - at_once):
        part = step(*part)
        for column, values in zip(state, part, strict=True):
            column.reshape(-1)[left] = values
        keep = ~finished(*part)
        if not keep.any():
            break
        left, part = left[keep], tuple(values[keep] for values in part)
    return state


def choose(
    condition: Any, when_true: Callable[..., tuple[Any, ...]], when_false: Callable[..., tuple[Any, ...]], *columns: Any
) -> tuple[Any, ...]:
    """Evaluate one of two elementwise functions of ``columns`` per element of ``condition``.

    NumPy gathers each side's elements, so that only what is needed is computed; JAX takes one branch for a scalar
    condition and selects between both otherwise.
    """
    if is_jax(condition, *columns):
        import jax
        import jax.numpy as jnp

        if jnp.ndim(condition) == 0:
            return jax.lax.cond(condition, when_true, when_false, *columns)
        # both sides are evaluated on all elements, so that each must be finite where it is not chosen: a NaN times a
        # derivative of zero is NaN
        pairs = zip(when_true(*columns), when_false(*columns), strict=True)
        return tuple(jnp.where(condition, yes, no) for yes, no in pairs)
    condition = np.asarray(condition)
    if condition.ndim == 0 or condition.all() or not condition.any():
        return when_true(*columns) if condition.all() else when_false(*columns)
    result: list[Any] = []
    for mask, function in ((condition, when_true), (~condition, when_false)):
        chosen = np.flatnonzero(mask)  # by indices, as masks are read again for every column
        values = function(*(np.take(column, chosen) if np.ndim(column) else column for column in columns))
        result = result or [np.empty(condition.size) for _ in values]
        for whole, part in zip(result, values, strict=True):
            whole[chosen] = part
    return tuple(whole.reshape(condition.shape) for whole in result)


_compiled: dict[Callable[..., Any], Callable[..., Any]] = {}


def compiled(function: Callable[..., Any], like: Any) -> Callable[..., Any]:
    """Return the function as it is for NumPy, jitted once per process where ``like`` is a JAX array."""
    if not is_jax(like):
        return function
    import jax

    return _compiled.setdefault(function, jax.jit(function))


def stack_last(parts: tuple[Any, ...]) -> Any:
    """Stack arrays along a new last axis, broadcasting them. Traced parts are finished first, as ``barrier`` says."""
    xp = namespace(*parts)
    return xp.stack(xp.broadcast_arrays(*barrier(parts)), axis=-1)
