"""Tells JAX the derivatives of closed forms."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from polhode._base.arrays.namespaces import is_jax

COMPLEX_STEP = 1e-150  # its square is negligible beside one


def stop_gradient(value: Any) -> Any:
    """Return the value as a constant of differentiation."""
    if not is_jax(*(value if isinstance(value, tuple) else (value,))):
        return value
    import jax

    return jax.lax.stop_gradient(value)


def forward_columns(function: Callable[[Any], Any], name: str) -> Callable[[Any], Any]:
    """Return a function of JAX arrays (…, n) → (…) whose gradient is taken forward, a component at a time.

    Either mode then only multiplies by it, so that reverse mode passes through loops of unknown length. A second
    derivative is refused, with the name.
    """
    import jax
    import jax.numpy as jnp

    from polhode._base.arrays.operation import Operation, Point, first_order_only

    def forward(at: Point, value: Any, changes: list[Any]) -> Any:
        (x,) = first_order_only(at.arguments, name)
        # ∂f/∂x_k for each unit vector e_k
        column = lambda unit: jax.jvp(function, (x,), (jnp.broadcast_to(unit, x.shape),))[1]  # noqa: E731
        columns = jax.vmap(column)(jnp.eye(x.shape[-1]))
        # df = Σ_k (∂f/∂x_k) dx_k
        change = jnp.sum(jnp.moveaxis(columns, 0, -1) * changes[0], axis=-1)
        # where there is no value there is no derivative
        return jnp.where(jnp.isfinite(value), change, jnp.nan)

    return Operation(name, function, forward)


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
