"""Tells JAX the derivatives of closed forms."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from polhode._base.arrays.namespaces import is_jax
from polhode.errors import InvalidInput

COMPLEX_STEP = 1e-150  # its square is negligible beside one


def stop_gradient(value: Any) -> Any:
    """Return the value as a constant of differentiation."""
    if not is_jax(*(value if isinstance(value, tuple) else (value,))):
        return value
    import jax

    return jax.lax.stop_gradient(value)


def custom_derivative(function: Callable[..., Any], rule: Callable[..., Any]) -> Callable[..., Any]:
    """Return the function for JAX arrays with its derivative given by a rule (primals, tangents) → (value, change)."""
    import jax

    wrapped = jax.custom_jvp(function)
    wrapped.defjvp(rule)
    return wrapped


def forward_columns(function: Callable[..., tuple[Any, ...]], name: str) -> Callable[..., tuple[Any, ...]]:
    """Return a function of JAX arrays (…, n) → tuple of (…) whose Jacobian is taken forward, a column at a time.

    Either mode then only multiplies by this Jacobian, so that reverse mode passes through loops of unknown length. A
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

        # J e_k for each unit vector e_k
        columns = jax.vmap(column)(jnp.eye(sum(sizes)))
        # df = Σ_k (∂f/∂x_k) dx_k
        changes = [jnp.sum(jnp.moveaxis(c, 0, -1) * jnp.concatenate(tangents, axis=-1), axis=-1) for c in columns]
        # where there is no value there is no derivative
        return value, tuple(jnp.where(jnp.isfinite(v), c, jnp.nan) for v, c in zip(value, changes, strict=True))

    return custom_derivative(function, rule)


def first_order_only(values: Any, name: str) -> Any:
    """Return the values unchanged, but refuse to differentiate them: a second derivative would be wrong."""
    leaf = values
    while isinstance(leaf, tuple):
        leaf = leaf[0]
    if not is_jax(leaf):
        return values

    def refuse(primals: Any, tangents: Any) -> Any:
        raise InvalidInput(f"`{name}` has first derivatives only; take second ones by differences of the first.")

    return custom_derivative(lambda x: x, refuse)(values)


def derivative_columns(
    function: Callable[..., tuple[Any, ...]], arguments: tuple[Any, ...], step: Any = COMPLEX_STEP
) -> tuple[tuple[Any, ...], tuple[Any, ...]]:
    """Return an elementwise function of equally shaped real arrays and its derivatives by each of them.

    The columns lie along a new first axis of every derivative. On NumPy they come from complex steps, exact to
    rounding: there the function must be analytic, without absolute values or comparisons of what depends on its
    arguments.
    ``step``, one or an array, times the magnification by the function must be far below rounding.

    Source: Squire & Trapp, SIAM Review 40 (1998) 110.
    """
    count = len(arguments)
    if not is_jax(*arguments):
        # f(x + ih) = f(x) + ih f′(x) − ½h² f″(x) − …: the imaginary part over h is f′ without any difference, up to h²
        # f‴/6, which for h = 1e-150 is far below rounding
        unit = np.eye(count).reshape(count, count, *(1,) * np.ndim(arguments[0]))
        values = function(*(a + 1j * step * unit[j] for j, a in enumerate(arguments)))
        return tuple(np.real(x[0]) for x in values), tuple(np.imag(x) / step for x in values)
    import jax
    import jax.numpy as jnp

    def along(k: Any) -> tuple[tuple[Any, ...], tuple[Any, ...]]:
        changes = tuple(jnp.where(k == j, 1.0, 0.0) + jnp.zeros_like(a) for j, a in enumerate(arguments))
        return jax.jvp(function, arguments, changes)

    return jax.vmap(along, out_axes=(None, 0))(jnp.arange(count))
