"""Functions written with JAX whose calls take less time than compiling them."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache, lru_cache, wraps
from typing import Any, NamedTuple, TypeVar

import numpy as np

from polhode._base.arrays.namespaces import is_traced, is_tracing

Function = TypeVar("Function", bound=Callable[..., Any])
QUICKLY = {"xla_cpu_use_fusion_emitters": False, "xla_backend_optimization_level": 0}  # a third of the time


class CallLimits(NamedTuple):
    """Numbers that decide how a function is compiled and how much of it is kept."""

    max_numbers: int = 1 << 18  # numbers that a call takes; of more the time of the run counts
    max_shapes: int = 128  # of a function, for which its steps are kept


LIMITS = CallLimits()


def compiled_quickly(function: Function) -> Function:
    """Return the function compiled by JAX; for calls on few numbers on a processor, without XLA's costly optimizations.

    Meant for up to some thousand calls. Arguments that are not arrays are static. Inside a function that is being
    traced, the call becomes part of it.
    """
    import equinox as eqx
    import jax

    thoroughly = eqx.filter_jit(function)
    # options are asked for when the function is first called: JAX's backend, which they are for, starts slowly
    quickly = cache(lambda: eqx.filter_jit(function, compiler_options=quick_options()))  # type: ignore[call-overload]

    @wraps(function)
    def call(*args: Any, **kwargs: Any) -> Any:
        if is_tracing():
            return function(*args, **kwargs)
        few = _are_few(list(filter(eqx.is_array, jax.tree.leaves((args, kwargs)))))
        return (quickly() if few else thoroughly)(*args, **kwargs)

    return call  # type: ignore[return-value]


def compiled_for_few_calls(function: Function) -> Function:
    """Return the function as NumPy computes it, operation by operation; compiled quickly where NumPy lacks one.

    Meant for a few calls. Shapes alone decide on the way, so that equal calls give equal bits.
    """
    import jax.numpy as jnp

    return _computed_by_numpy(function, jnp.array, lambda x: x)  # copies: a value may be one of the arguments


def arrays_for_few_calls(function: Function) -> Function:
    """Return the function with NumPy's arrays as results, made faster than JAX's; with JAX's while it traces."""
    return _computed_by_numpy(function, np.array, np.asarray)


def _computed_by_numpy(
    function: Function, convert: Callable[[Any], Any], of_compiled: Callable[[Any], Any]
) -> Function:
    import jax

    compiled = compiled_quickly(function)
    written = lru_cache(maxsize=LIMITS.max_shapes)(lambda tree, kinds: _write(function, tree, kinds, convert))

    def compile_and_call(*args: Any, **kwargs: Any) -> Any:
        results = compiled(*args, **kwargs)
        return results if is_tracing() else jax.tree.map(lambda x: of_compiled(x) if _is_array(x) else x, results)

    @wraps(function)
    def call(*args: Any, **kwargs: Any) -> Any:
        leaves, tree = jax.tree.flatten((args, kwargs))
        arrays = list(filter(_is_array, leaves))
        if is_tracing() or not _are_few(arrays):
            return compile_and_call(*args, **kwargs)
        compute = written(tree, tuple(map(_kind, leaves)))
        return compile_and_call(*args, **kwargs) if compute is None else compute(arrays)

    return call  # type: ignore[return-value]


def _is_array(leaf: Any) -> bool:
    import equinox as eqx

    return eqx.is_array(leaf) or isinstance(leaf, np.ndarray)


def _are_few(arrays: list[Any]) -> bool:
    """Whether arrays are small, and none is differentiated: there JAX takes no options of the compiler."""
    return sum(map(np.size, arrays)) <= LIMITS.max_numbers and not is_traced(*arrays)


def _kind(leaf: Any) -> tuple[Any, ...]:
    """Return shape and type of an array, or type and value of a static argument, as 1, 1.0 and True are equal."""
    return (leaf.shape, leaf.dtype) if _is_array(leaf) else (type(leaf), leaf, None)


def _write(
    function: Callable[..., Any], tree: Any, kinds: tuple[tuple[Any, ...], ...], convert: Callable[[Any], Any]
) -> Callable[..., Any] | None:
    """Return a function of the arrays among the leaves of arguments, computed by NumPy; None where NumPy cannot."""
    import equinox as eqx
    import jax

    from polhode._base.arrays.steps import Steps
    from polhode._base.jaxprs import Listing, NoRule

    static: list[Any] = []

    def of_arrays(*arrays: Any) -> Any:
        each = iter(arrays)
        leaves = [next(each) if len(kind) == 2 else kind[1] for kind in kinds]
        args, kwargs = jax.tree.unflatten(tree, leaves)
        dynamic, fixed = eqx.partition(function(*args, **kwargs), eqx.is_array)
        static[:] = [fixed]
        return dynamic

    shapes = [jax.ShapeDtypeStruct(*kind) for kind in kinds if len(kind) == 2]
    closed, results = jax.make_jaxpr(of_arrays, return_shape=True)(*shapes)
    try:
        steps = Steps(Listing(closed))
    except NoRule:
        return None
    structure = jax.tree.structure(results)

    def compute(arrays: list[Any]) -> Any:
        values = [convert(x) for x in steps(arrays)]
        return eqx.combine(jax.tree.unflatten(structure, values), static[0])

    return compute


@cache
def quick_options() -> dict[str, bool | int]:
    """Return the options with which XLA compiles quickly, those that it knows; none on a GPU.

    Releases of XLA add and remove options, and one that is unknown ends the compilation with an error.
    """
    import jax

    return {name: value for name, value in QUICKLY.items() if jax.default_backend() == "cpu" and _takes(name, value)}


def _takes(option: str, value: bool | int) -> bool:
    import jax

    try:
        jax.jit(lambda x: x, compiler_options={option: value}).lower(0.0).compile()
    except jax.errors.JaxRuntimeError:
        return False
    return True
