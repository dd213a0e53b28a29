"""Loops of unknown length have forward derivatives only, and say so in words instead of by JAX's own error."""

from __future__ import annotations

from typing import Any

import jax
from jax.extend.core import Primitive
from jax.interpreters import ad, batching, mlir

from polhode.errors import InvalidInput


def forward_only(values: Any, name: str) -> Any:
    """Return a loop's results; reverse-mode derivatives of them are refused, with the name of what they are.

    Args:
        values: arrays or nests of them.
        name: of the public function or class.
    """
    return jax.tree.map(lambda value: _identity.bind(value, name=name), values)


def _refuse(cotangent: Any, value: Any, *, name: str) -> Any:
    raise InvalidInput(
        f"`{name}` loops as often as its numbers ask, and has forward derivatives only; got a reverse-mode one "
        "(jax.grad, jax.vjp, jax.jacrev). Take jax.jvp or jax.jacfwd."
    )


_identity = Primitive("forward_only")
_identity.def_impl(lambda value, *, name: value)
_identity.def_abstract_eval(lambda value, *, name: value)
ad.deflinear2(_identity, _refuse)
batching.primitive_batchers[_identity] = lambda values, axes, *, name: (_identity.bind(*values, name=name), axes[0])
mlir.register_lowering(_identity, lambda context, value, *, name: [value])
