"""The seam between NumPy and JAX: the only file of the closed-form half that may touch JAX, and only once a
JAX array has come in."""

from __future__ import annotations

import contextlib
import functools
import sys
from collections.abc import Callable, Iterator
from functools import cache
from typing import Any, ParamSpec, TypeVar

import numpy as np

from polhode.errors import InvalidInput, PolhodeError, shown
from polhode.types import Array, ArrayLike, Float64

Parameters = ParamSpec("Parameters")
Result = TypeVar("Result")


@cache
def _library(kind: type) -> str:
    """Return which library an array type belongs to; numbers and lists count as NumPy's."""
    if "jax" in sys.modules:
        import jax
        from jax.core import Tracer

        if issubclass(kind, jax.Array | Tracer):
            return "jax"
    foreign = hasattr(kind, "__array_namespace__") and not issubclass(kind, np.ndarray | np.generic)
    return "foreign" if foreign else "numpy"


def is_jax(*values: Any) -> bool:
    """Whether any of the values is a JAX array or tracer."""
    return any(_library(type(value)) == "jax" for value in values)


def is_traced(*values: Any) -> bool:
    """Whether any of the values is a JAX tracer, whose numbers cannot be looked at."""
    if not is_jax(*values):
        return False
    from jax.core import Tracer

    return any(isinstance(value, Tracer) for value in values)


def known_false(condition: Any) -> bool:
    """Whether a condition is known not to hold; what a traced function computes, of known arrays too, is not known."""
    return not is_traced(condition) and not bool(condition)


def namespace(*values: Any) -> Any:
    """Return the array namespace shared by mixed inputs: JAX if any is JAX, NumPy for scalars and lists.

    A tracer together with NumPy constants is the normal case of ``jax.grad``; everything is then lifted to JAX.
    """
    libraries = [_library(type(value)) for value in values]
    if "jax" in libraries:
        import jax.numpy

        return jax.numpy
    if "foreign" in libraries:
        import array_api_compat

        foreign = (value for value, library in zip(values, libraries, strict=True) if library == "foreign")
        return array_api_compat.array_namespace(*foreign)
    return np


def refuse_single_precision(**named: Any) -> None:
    """Refuse arrays, and nests of them, with fewer digits than float64: seven cannot carry a phase or an invariant.

    JAX makes such arrays until 64 bits are switched on, which importing ``polhode.algebra`` does; those from before
    stay as they are. Traced arrays are refused too, as their types are known.
    """
    for name, value in named.items():
        if isinstance(value, list | tuple):
            for part in value:
                refuse_single_precision(**{name: part})
            continue
        dtype = str(getattr(value, "dtype", ""))
        if dtype in ("float16", "bfloat16", "float32", "complex64") or dtype.startswith("float8"):
            raise InvalidInput(f"`{name}` must be float64; got {dtype}. {_remedy(is_jax(value))}")


def _remedy(jax_array: bool) -> str:
    if not jax_array:
        return "Convert it with astype(float) if seven digits are all there is to know."
    return (
        "Call jax.config.update('jax_enable_x64', True) before the first JAX array is made; one made before has lost "
        "digits and must be made again."
    )


def as_float64(xp: Any, value: ArrayLike, name: str) -> Float64[Array, "..."]:
    """Return ``value`` as a float64 array of the namespace.

    Raises:
        InvalidInput: if it is a float32 or complex array, or not numeric at all. Single precision cannot carry
            phases, so it is refused instead of silently widened.
    """
    refuse_single_precision(**{name: value})
    if "complex" in str(getattr(value, "dtype", "")):
        raise InvalidInput(f"`{name}` must be real; got {value.dtype}. Take its real part if that is meant.")
    try:
        native = _library(type(value)) != "numpy"
        kind = "f" if native else np.asarray(value).dtype.kind
        if kind in "SUMm" or (kind == "O" and any(x is None for x in np.asarray(value).flat)):
            raise TypeError("text, dates and None are not numbers")
        if "jax" in str(getattr(xp, "__name__", "")):
            _refuse_disabled_double_precision(name)
        return xp.asarray(value if native else np.asarray(value, dtype=np.float64), dtype=xp.float64)
    except InvalidInput:
        raise
    except (TypeError, ValueError, OverflowError) as error:
        raise InvalidInput(f"`{name}` must be an array of numbers; got {shown(value)} ({error}).") from None


def _refuse_disabled_double_precision(name: str) -> None:
    """Refuse what JAX would turn to float32, be it whole numbers or NumPy's float64 together with JAX arrays."""
    import jax

    if not jax.config.jax_enable_x64:  # pyright: ignore[reportAttributeAccessIssue]
        raise InvalidInput(
            f"`{name}` would become float32: it goes together with an array of JAX, whose float64 is switched off. "
            f"{_remedy(True)}"
        )


def known_numbers_only(function: Callable[Parameters, Result]) -> Callable[Parameters, Result]:
    """Have a function that decides on numbers refuse traced ones; known ones are good within a traced function too.

    There JAX would trace whatever is computed from them, so they are computed with at once.
    """
    name = function.__qualname__.removesuffix(".__init__")

    @functools.wraps(function)
    def checked(*args: Parameters.args, **kwargs: Parameters.kwargs) -> Result:
        if "jax" not in sys.modules:
            return function(*args, **kwargs)
        import jax
        import jax.numpy as jnp

        refusal = InvalidInput(
            f"the arguments of `{name}` must be known numbers, not traced by JAX: it decides on them. Call it outside "
            "of jit, vmap and derivatives, and put traced numbers into what it returns."
        )
        if is_traced(*jax.tree.leaves((args, kwargs))):
            raise refusal
        if not is_traced(jnp.zeros(())):
            with in_jax_numpy(f"functions and systems given to `{name}`"):
                return function(*args, **kwargs)
        try:
            with jax.ensure_compile_time_eval():
                return function(*args, **kwargs)
        except PolhodeError:
            raise
        except (TypeError, RuntimeError) as error:  # JAX's and Equinox's, where something within is traced
            raise refusal from error

    return checked


@contextlib.contextmanager
def in_jax_numpy(what: str) -> Iterator[None]:
    """Word JAX's errors about what cannot be traced, such as a user's function that calls NumPy.

    Args:
        what: subject of the message, in the plural.

    Raises:
        InvalidInput: in their place.
    """
    try:
        yield
    except TypeError as error:
        import jax

        if not isinstance(error, jax.errors.JAXTypeError):
            raise
        raise InvalidInput(
            f"{what} must be written with jax.numpy, as JAX compiles and differentiates them: no NumPy, `float` or "
            "`if` on what depends on the state or the time. Write jnp.sum for np.sum, and jnp.where for `if`."
        ) from error


def barrier(values: Any) -> Any:
    """Have XLA finish a nest of tuples of arrays before it goes on; return arrays that are not traced as they are.

    When XLA on the CPU fuses a stack with what its parts share, it recomputes the shared values for every part, and so
    on down: the cost grows exponentially with the length of the computation. An optimization barrier does not help,
    because XLA for CPU removes it before it fuses. A loop it cannot see through stays.
    """
    if not is_traced(*_leaves(values)):
        return values
    import jax

    def finished(whole: Any) -> Any:
        return jax.lax.platform_dependent(whole, cpu=_loop_once, default=jax.lax.optimization_barrier)

    return custom_derivative(finished, lambda primals, changes: (finished(*primals), changes[0]))(values)


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

    number = next(x for x in _leaves(values) if jnp.issubdtype(jnp.result_type(x), jnp.floating))
    never = jnp.any(jnp.ravel(number)[:1] > jnp.inf)
    empty = jax.tree.map(jnp.zeros_like, values)
    return jax.lax.while_loop(lambda now: now[0], lambda now: (now[0] & never, values), (~never, empty))[1]


def stop_gradient(value: Any) -> Any:
    """Return the value as a constant of differentiation."""
    if not is_jax(*(value if isinstance(value, tuple) else (value,))):
        return value
    import jax

    return jax.lax.stop_gradient(value)


def split_halves(a: Any) -> tuple[Any, Any]:
    """Split float64 numbers into a high and a low half of at most 26 bits and a sign each, whose products are exact.

    NumPy multiplies by 2²⁷ + 1 [Veltkamp]; XLA would fuse that product away, so JAX arrays are split by rounding
    their mantissa, as an integer, to its upper 26 bits.
    """
    if not is_jax(a):
        c = 134217729.0 * a
        high = c - (c - a)
        return high, a - high
    import jax

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
    if "foreign" in map(_library, map(type, state)):
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
        pairs = zip(when_true(*columns), when_false(*columns), strict=True)
        return tuple(jnp.where(condition, yes, no) for yes, no in pairs)
    condition = np.asarray(condition)
    if condition.ndim == 0 or condition.all() or not condition.any():
        return when_true(*columns) if condition.all() else when_false(*columns)
    result: list[Any] = []
    for mask, function in ((condition, when_true), (~condition, when_false)):
        values = function(*(column[mask] if np.ndim(column) else column for column in columns))
        result = result or [np.empty(condition.shape) for _ in values]
        for whole, part in zip(result, values, strict=True):
            whole[mask] = part
    return tuple(result)


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


def custom_derivative(function: Callable[..., Any], rule: Callable[..., Any]) -> Callable[..., Any]:
    """Return the function for JAX arrays with its derivative given by a rule (primals, tangents) → (value, change)."""
    import jax

    wrapped = jax.custom_jvp(function)
    wrapped.defjvp(rule)
    return wrapped


def forward_columns(function: Callable[..., tuple[Any, ...]], name: str) -> Callable[..., tuple[Any, ...]]:
    """Return a function of JAX arrays (…, n) → tuple of (…) whose Jacobian is taken forward, a column at a time.

    Multiplying by it is all that is left to either mode, so reverse mode passes through loops of unknown length. A
    second derivative is refused, with the name.
    """
    import jax
    import jax.numpy as jnp

    def rule(primals: tuple[Any, ...], tangents: tuple[Any, ...]) -> tuple[Any, Any]:
        value, primals = function(*primals), first_order_only(primals, name)
        sizes = [x.shape[-1] for x in primals]
        starts = [sum(sizes[:k]) for k in range(len(sizes))]

        def column(unit: Any) -> tuple[Any, ...]:
            parts = (unit[k : k + n] for k, n in zip(starts, sizes, strict=True))
            tangents = tuple(jnp.broadcast_to(part, x.shape) for part, x in zip(parts, primals, strict=True))
            return jax.jvp(function, primals, tangents)[1]

        columns = jax.vmap(column)(jnp.eye(sum(sizes)))
        changes = [jnp.sum(jnp.moveaxis(c, 0, -1) * jnp.concatenate(tangents, axis=-1), axis=-1) for c in columns]
        # where there is no value there is no derivative
        return value, tuple(jnp.where(jnp.isfinite(v), c, jnp.nan) for v, c in zip(value, changes, strict=True))

    return custom_derivative(function, rule)


def first_order_only(values: Any, name: str) -> Any:
    """Return the values; differentiating them, which a second derivative would, is refused instead of being wrong."""
    leaf = values
    while isinstance(leaf, tuple):
        leaf = leaf[0]
    if not is_jax(leaf):
        return values

    def refuse(primals: Any, tangents: Any) -> Any:
        raise InvalidInput(f"`{name}` has first derivatives only; take second ones by differences of the first.")

    return custom_derivative(lambda x: x, refuse)(values)


_nodes: set[type] = set()


def register_node(kind: type, fields: tuple[str, ...], like: Any) -> None:
    """Let JAX pass objects of a frozen class through its transformations, once a JAX array has come in."""
    if kind in _nodes or not is_jax(like):
        return
    import jax

    def build(_: Any, children: Any) -> Any:
        made = object.__new__(kind)
        for name, child in zip(fields, children, strict=True):
            object.__setattr__(made, name, child)
        return made

    jax.tree_util.register_pytree_node(kind, lambda x: (tuple(getattr(x, name) for name in fields), None), build)
    _nodes.add(kind)


def derivative_columns(
    function: Callable[..., tuple[Any, ...]], arguments: tuple[Any, ...]
) -> tuple[tuple[Any, ...], tuple[Any, ...]]:
    """Return an elementwise function of equally shaped JAX arrays and its derivatives by each of them.

    The columns lie along a new first axis of every derivative.
    """
    import jax
    import jax.numpy as jnp

    count = len(arguments)

    def along(k: Any) -> tuple[tuple[Any, ...], tuple[Any, ...]]:
        changes = tuple(jnp.where(k == j, 1.0, 0.0) + jnp.zeros_like(a) for j, a in enumerate(arguments))
        return jax.jvp(function, arguments, changes)

    return jax.vmap(along, out_axes=(None, 0))(jnp.arange(count))
