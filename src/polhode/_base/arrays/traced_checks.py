"""Checks the jaxpr of a user's function: its indices, and single precision that its results would hide."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from polhode._base.arrays.indices import refuse_beyond
from polhode._base.jaxprs import types_within
from polhode.errors import InvalidInput

FEW_DIGITS = frozenset({"float32", "float16", "bfloat16", "complex64"})


def check_function(what: str, function: Callable[..., Any], *arguments: Any) -> None:
    """Refuse a function that takes or sets elements which its arrays do not have, or computes in single precision.

    Indices are followed that do not depend on the arguments; those that do are known only when it is too late.

    Args:
        what: the function, in messages.
        function: to be traced at these arguments.
        arguments: arrays, or shapes and types.

    Raises:
        InvalidInput: naming the index and the size, or the type.
    """
    import jax

    check_traced(what, jax.make_jaxpr(function)(*arguments))


def check_traced(what: str, closed: Any) -> None:
    """Refuse a jaxpr as ``check_function`` does.

    Raises:
        InvalidInput: as there.
    """
    refuse_beyond(what, closed)
    refuse_single_precision_within(what, closed)


def refuse_single_precision_within(what: str, closed: Any) -> None:
    """Refuse a jaxpr that computes with fewer digits than float64, which no result shows.

    Args:
        what: its name, in messages.
        closed: the closed jaxpr.

    Raises:
        InvalidInput: naming the type.
    """
    for dtype in types_within(closed):
        if dtype in FEW_DIGITS:
            raise InvalidInput(
                f"{what} computes in single precision, as an array that it holds or makes is {dtype}. Make its "
                "arrays float64: JAX makes float32 ones until jax.config.update('jax_enable_x64', True), which "
                "importing the systems and algebras of polhode does."
            )
