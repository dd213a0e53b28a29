"""Tells which library an array belongs to, and refuses numbers that float64 cannot carry."""

from __future__ import annotations

import contextlib
import functools
import sys
from collections.abc import Callable
from functools import cache
from numbers import Rational
from typing import Any, ParamSpec, TypeGuard, TypeVar

import numpy as np

from polhode._base.kept import is_kept
from polhode.errors import InvalidInput, PolhodeError, shown
from polhode.types import Array, ArrayLike, Float64

CALLED = frozenset({"jax", "jaxlib", "numpy", "scipy", "equinox", "diffrax", "optimistix", "lineax", "beartype",
                    "jaxtyping", "contextlib", "functools", "typing", "inspect"})  # fmt: skip
"""Packages between polhode's code, or a user's, and an error."""
ENCLOSED = (
    "must not enclose a number that JAX traces, as a variable of a lambda: no derivative goes by it. Make it a field "
    "of the system, or give jax.tree_util.Partial(function, number) instead of the function."
)
PLAIN = frozenset({np.ndarray, float, int, bool, str, type(None)})
"""Types whose values are known numbers, or none."""
LARGEST = float(np.finfo(np.float64).max)
Parameters = ParamSpec("Parameters")
Result = TypeVar("Result")


@cache
def _library(kind: type) -> str:
    """Return which library an array type belongs to; numbers and lists count as NumPy's."""
    if "jax" in sys.modules:
        import jax

        from polhode._base.jax_inner import Tracer

        if issubclass(kind, jax.Array | Tracer):
            return "jax"
    foreign = hasattr(kind, "__array_namespace__") and not issubclass(kind, np.ndarray | np.generic)
    return "foreign" if foreign else "numpy"


def is_jax(*values: Any) -> bool:
    """Whether any of the values is a JAX array or tracer."""
    return any(_library(type(value)) == "jax" for value in values)


def is_foreign(*values: Any) -> bool:
    """Whether any of the values is of a library that is neither NumPy nor JAX."""
    return any(_library(type(value)) == "foreign" for value in values)


def is_traced(*values: Any) -> bool:
    """Whether any of the values is a JAX tracer, whose numbers are not known."""
    if not is_jax(*values):
        return False
    from polhode._base.jax_inner import Tracer

    return any(isinstance(value, Tracer) for value in values)


def is_tracing() -> bool:
    """Whether JAX is tracing a function now, so that whatever it computes is traced, even from known numbers."""
    return not _inner().evaluates_at_once() and is_traced(_quickest_operation()(0.0))


@cache
def _inner() -> Any:
    """Return the module, as an import takes longer than what is asked of it."""
    from polhode._base import jax_inner

    return jax_inner


@cache
def _quickest_operation() -> Callable[[float], Any]:
    """Return the function of JAX whose calls take the least time among those that are traced."""
    import jax
    import jax.numpy as jnp

    values: list[Any] = []
    jax.make_jaxpr(lambda: values.append(jnp.asarray(0.0)))()
    # unlike ``negative`` it need not be compiled, but releases of JAX differ in whether they trace it
    return jnp.asarray if is_traced(*values) else jnp.negative


def known_false(condition: Any) -> bool:
    """Whether a condition is known not to hold; results in a traced function, even of known arrays, are not known."""
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


def is_positive(value: Any) -> bool:
    """Return whether something is one positive finite number, and no truth value or text."""
    if isinstance(value, bool | np.bool_ | str | bytes) or np.ndim(value) != 0:
        return False
    try:
        return 0.0 < float(value) < np.inf
    except (TypeError, ValueError):
        return False


def refuse_complex(name: str, value: Any) -> None:
    """Refuse complex numbers where real ones are meant: making these real would drop their imaginary parts.

    Raises:
        InvalidInput: naming the argument.
    """
    try:
        is_complex = np.iscomplexobj(value if hasattr(value, "dtype") else np.asarray(value))
    except (TypeError, ValueError):  # ragged, which is refused elsewhere in other words
        return
    if is_complex:
        raise InvalidInput(f"`{name}` must be real; got complex numbers. Give their real parts, if that is meant.")


def always(x: Any, value: float) -> bool:
    """Return whether x is a single NumPy number equal to ``value``, so that an operation with it may be left out."""
    return isinstance(x, np.ndarray) and x.ndim == 0 and bool(x == value)


def nearest(x: Any) -> Any:
    """Return the nearest whole numbers, as ``round`` of the array's namespace, which in NumPy has a slow wrapper."""
    return np.rint(x) if isinstance(x, np.ndarray | float) else namespace(x).round(x)


def require_doubles(**named: Any) -> None:
    """Refuse what float64 cannot carry: arrays with fewer digits, text, and Python's numbers beyond any double.

    Seven digits cannot carry a phase or an invariant. JAX makes such arrays until 64 bits are switched on, which
    importing ``polhode.algebra`` does; those from before stay as they are. Traced arrays are refused too, as their
    types are known. Lists are searched; None alone is an argument that was left out.
    """
    for name, value in named.items():
        if _is_doubles(value):
            continue
        if isinstance(value, list | tuple):
            for part in value:
                if type(part) is not float:
                    require_doubles(**{name: part})
            continue
        dtype = str(getattr(value, "dtype", ""))
        if dtype in ("float16", "bfloat16", "float32", "complex64") or dtype.startswith("float8"):
            raise InvalidInput(f"`{name}` must be float64; got {dtype}. {_remedy(is_jax(value))}")
        if dtype == "object":
            require_doubles(**{name: value.ravel().tolist()})
        elif isinstance(value, str | bytes):
            why = "Functions take SI numbers; text with units is for specs."
            raise InvalidInput(f"`{name}` must be numbers; got {shown(value)}. {why}")
        elif isinstance(value, Rational) and not _has_double(value):
            raise InvalidInput(f"`{name}` must be at most {LARGEST:.2g}, as a double is; got {shown(value)}.")


def _is_doubles(value: Any) -> TypeGuard[np.ndarray]:
    """Return whether this is NumPy's array of doubles, which is quickly known; names of types take long to make."""
    return type(value) is np.ndarray and value.dtype == np.float64


def _has_double(value: Rational) -> bool:
    try:
        float(value)
    except OverflowError:
        return False
    return True


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
    if xp is np and _is_doubles(value):
        return value
    require_doubles(**{name: value})
    if "complex" in str(getattr(value, "dtype", "")):
        raise InvalidInput(f"`{name}` must be real; got {value.dtype}. Take its real part if that is meant.")
    try:
        native = _library(type(value)) != "numpy"
        array = None if native else np.asarray(value)
        if xp is np and _is_doubles(array):
            return array
        kind = "f" if array is None else array.dtype.kind
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
    """Make a function that branches on its numbers refuse traced ones.

    Known numbers are accepted inside a traced function too. There JAX would trace whatever is computed from them, so
    the function is evaluated at once.
    """
    name = function.__qualname__.removesuffix(".__init__")
    what = f"functions and systems given to `{name}`"

    @functools.wraps(function)
    def checked(*args: Parameters.args, **kwargs: Parameters.kwargs) -> Result:
        if "jax" not in sys.modules:
            return function(*args, **kwargs)
        if _holds_traced(*args, *kwargs.values()):
            raise _refusal(name)
        if not is_tracing():
            with in_jax_numpy(what):
                return function(*args, **kwargs)
        import jax

        try:
            with jax.ensure_compile_time_eval():
                return function(*args, **kwargs)
        except PolhodeError:
            raise
        except (TypeError, RuntimeError) as error:  # JAX's and Equinox's, where something within is traced
            raise _refusal(name) from error

    return checked


def _holds_traced(*values: Any) -> bool:
    """Whether anything in some trees is traced; of what is known not to hold such no tree is made."""
    others = [value for value in values if type(value) not in PLAIN and not is_kept(value)]
    if not others:
        return False
    import jax

    return is_traced(*jax.tree.leaves(others))


def _refusal(name: str) -> InvalidInput:
    return InvalidInput(
        f"the arguments of `{name}` must be known numbers, not traced by JAX: it decides on them. Call it outside of "
        "jit, vmap and derivatives, and put traced numbers into what it returns."
    )


class _Rewording:
    """The context of ``in_jax_numpy``, written as a class as generators take several times as long."""

    def __init__(self, what: str) -> None:
        self.what = what

    def __enter__(self) -> None:
        return None

    def __exit__(self, kind: Any, error: BaseException | None, trace: Any) -> None:
        if isinstance(error, TypeError):
            _reword(self.what, error)


def in_jax_numpy(what: str) -> contextlib.AbstractContextManager[None]:
    """Reword JAX's errors about what cannot be traced, such as a user's function that calls NumPy.

    The message blames the user's function only where the error comes from there; for an error in polhode's own code it
    gives file and line.

    Args:
        what: subject of the message, in the plural.

    Raises:
        InvalidInput: in their place.
    """
    return _Rewording(what)


def _reword(what: str, error: TypeError) -> None:
    import jax

    place = _own_place(error)
    if _is_of_enclosed(error, place):
        raise InvalidInput(f"{what} {ENCLOSED}") from error
    if not isinstance(error, jax.errors.JAXTypeError):
        return
    if place is not None:
        raise InvalidInput(
            f"JAX cannot compile what polhode does at {place}. If one of the {what} is a function of NumPy itself, "
            "give that of jax.numpy; else this is a fault of polhode: please report it, with this line: "
            f"{str(error).splitlines()[0]}"
        ) from error
    raise InvalidInput(
        f"{what} must be written with jax.numpy, as JAX compiles and differentiates them: no NumPy, `float` or "
        "`if` on what depends on the state or the time. Write jnp.sum for np.sum, and jnp.where for `if`."
    ) from error


def _is_of_enclosed(error: TypeError, place: str | None) -> bool:
    """Whether an error is about a traced number that a compiled function encloses from outside."""
    import jax

    said = str(error)
    if "No constant handler for type" in said and "Tracer" in said:
        return True
    # of a number of its own JAX adds in which function it is traced
    return isinstance(error, jax.errors.JAXTypeError) and place is not None and "while tracing the function" not in said


def _own_place(error: BaseException) -> str | None:
    """Return file and line where an error comes from, if that is polhode's own code; None if it is a user's.

    Both call JAX, NumPy and others, whose frames say nothing: the last one before them does.
    """
    rooms, frame, innermost = __name__.partition(".")[0], error.__traceback__, None
    while frame is not None:
        module = str(frame.tb_frame.f_globals.get("__name__", "")).partition(".")[0]
        if module not in CALLED:
            innermost = module, frame
        frame = frame.tb_next
    if innermost is None or innermost[0] != rooms:
        return None
    path = innermost[1].tb_frame.f_code.co_filename.replace("\\", "/")
    return f"{path[path.rfind(f'{rooms}/') :]}, line {innermost[1].tb_lineno}"
