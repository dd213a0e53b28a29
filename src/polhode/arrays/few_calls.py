"""Compiles functions that are called a few times on few numbers, where compiling costs more than running."""

from __future__ import annotations

from collections.abc import Callable
from functools import wraps
from typing import Any, TypeVar

import numpy as np

from polhode.arrays.namespaces import is_traced, is_tracing

Function = TypeVar("Function", bound=Callable[..., Any])
QUICKLY = {"xla_cpu_use_fusion_emitters": False, "xla_backend_optimization_level": 0}  # a third of the time
KNOWN_TO = ("0.10.",)  # releases of jaxlib; others may not know an option, and refuse it
FEW = 1 << 18  # numbers that a call takes: of more, what runs slower counts


def compiled_for_few_calls(function: Function) -> Function:
    """Return the function compiled by JAX; for calls on few numbers on a processor, without XLA's costly optimizations.

    Arguments that are not arrays are static. Inside a function that is being traced, the call becomes part of it.
    """
    import equinox as eqx
    import jax

    thoroughly = eqx.filter_jit(function)
    quickly = eqx.filter_jit(function, compiler_options=QUICKLY)  # type: ignore[call-overload]

    @wraps(function)
    def call(*args: Any, **kwargs: Any) -> Any:
        if is_tracing():
            return function(*args, **kwargs)
        arrays = [x for x in jax.tree.leaves((args, kwargs)) if eqx.is_array(x)]
        few = sum(map(np.size, arrays)) <= FEW
        # JAX takes no options of the compiler where it differentiates
        return (quickly if few and compiles_quickly() and not is_traced(*arrays) else thoroughly)(*args, **kwargs)

    return call  # type: ignore[return-value]


def compiles_quickly() -> bool:
    """Return whether the options are for this processor and known to its compiler."""
    import jax
    from jaxlib.version import __version__

    return jax.default_backend() == "cpu" and __version__.startswith(KNOWN_TO)
