"""Closed forms as single operations of JAX.

XLA needs about a millisecond for each operation that it compiles, and a closed form has thousands. As one operation
it is evaluated on the CPU by NumPy, at once and without compilation, within compiled functions by a call back to
Python; on other devices it is compiled. Its derivative is a second operation that gives the Jacobian, so that forward
and reverse mode are products with it.
"""

from __future__ import annotations

import contextlib
import math
from collections.abc import Callable, Iterator
from contextvars import ContextVar
from dataclasses import dataclass
from typing import Any

import numpy as np

from polhode._base.arrays.namespaces import is_jax
from polhode.errors import InvalidInput, shown

WAYS = ("host", "compiled")
_where: ContextVar[str] = ContextVar("where", default="host")


@contextlib.contextmanager
def closed_forms(where: str) -> Iterator[None]:
    """Choose how JAX evaluates closed forms on the CPU, in functions that are traced within this context.

    ``"host"``, the default: by NumPy, called back from compiled functions. It compiles in a tenth of a second, and is
    as fast as NumPy is. ``"compiled"``: by XLA, which takes seconds to compile, and is faster only where one function
    is called very often with few bodies; such a function can be exported too. GPUs and TPUs always compile.

    A function that has been traced keeps its choice.

    Args:
        where: "host" or "compiled".

    Raises:
        InvalidInput: for any other word.

    >>> import jax, polhode as ph
    >>> with ph.closed_forms("compiled"):
    ...     momentum_at = jax.jit(ph.FreeMotion((1.0, 2.0, 3.0), momentum=jax.numpy.ones(3)).momentum).lower(5.0)
    """
    if where not in WAYS:
        raise InvalidInput(f"`where` must be one of {', '.join(map(repr, WAYS))}; got {shown(where)}.")
    before = _where.set(where)
    try:
        yield
    finally:
        _where.reset(before)


@dataclass(frozen=True)
class Elementwise:
    """A function of arrays whose leading axes are batch axes, which broadcast.

    Attributes:
        name: of the public class, for messages.
        values: arrays of any library → tuple of arrays.
        inputs: trailing shape of each argument, () or (k,); the other axes are of the batch.
        outputs: trailing shape and type of each value; only those that are float have derivatives.
        jacobian: arrays → ``(values, columns)``, where ``columns`` (batch…, M, N) has the derivatives of all float
            values, one after the other, by all arguments, one after the other; None where there is none.
        positive: how many of the first arguments consist of positive numbers, each with a scale of its own.
        order: of the derivatives that the Jacobian gives.
        forward: J dx without its Jacobian: arguments, and a change of each → a tuple of the change (batch…, M) of all
            float values, one after the other; None where that takes no less time.
        back: Jᵀw, with ``forward``: arguments, and weights w (batch…, M) of these values → the weights of each of the
            arguments, with its trailing shape.
        on_host: whether the values are NumPy's alone: JAX calls them on the host, whichever way is chosen for closed
            forms, and wherever its own arrays are.
    """

    name: str
    values: Callable[..., tuple[Any, ...]]
    inputs: tuple[tuple[int, ...], ...]
    outputs: tuple[tuple[tuple[int, ...], type], ...]
    jacobian: Callable[..., tuple[tuple[Any, ...], Any]] | None = None
    positive: int = 1
    order: int = 1
    forward: Callable[..., tuple[Any, ...]] | None = None
    back: Callable[..., tuple[Any, ...]] | None = None
    on_host: bool = False

    def __call__(self, *arguments: Any) -> tuple[Any, ...]:
        """Return the values, NumPy arrays for NumPy arrays and JAX arrays for JAX arrays."""
        if not is_jax(*arguments):
            return self.values(*arguments)
        import jax.numpy as jnp

        from polhode._base.arrays.host_calls import operation

        return tuple(operation(self, _where.get() == "compiled")(*(jnp.asarray(a, float) for a in arguments)))

    @property
    def smooth(self) -> tuple[int, ...]:
        """Which values have derivatives."""
        return tuple(k for k, (_, kind) in enumerate(self.outputs) if kind is float)

    @property
    def width(self) -> int:
        """The number of scalars in the arguments of one element of the batch."""
        return sum(math.prod(shape) for shape in self.inputs)

    @property
    def height(self) -> int:
        """The number of scalars that have derivatives in the values of one element of the batch."""
        return sum(math.prod(self.outputs[k][0]) for k in self.smooth)

    def shapes(self, arguments: tuple[Any, ...]) -> list[tuple[tuple[int, ...], Any]]:
        """Return shape and type of each value."""
        batch = self.batch(arguments)
        return [((*batch, *shape), np.dtype(kind)) for shape, kind in self.outputs]

    def batch(self, arguments: tuple[Any, ...]) -> tuple[int, ...]:
        """Return the common batch shape of arguments."""
        shapes = (a.shape[: a.ndim - len(core)] for a, core in zip(arguments, self.inputs, strict=True))
        return np.broadcast_shapes(*shapes)
