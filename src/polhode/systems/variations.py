"""A system together with tangent vectors of its motion, moved by the linearised flow."""

from __future__ import annotations

import equinox as eqx
import jax
import jax.numpy as jnp

from polhode._base import check
from polhode._base.arrays import known_numbers_only, require_doubles
from polhode.errors import InvalidInput
from polhode.systems._forms import rates_of_change
from polhode.systems.base import AbstractSystem, Balance, Event
from polhode.types import Array, ArrayLike, Double, Float64, Real


class Variations(AbstractSystem):
    """A system, and changes of its state that move as small differences of two motions do: δ̇ = Df(x) δ.

    A state (1 + count, …) is one of the system, and after it the changes. Each moves by itself, so that they
    may have any size. Of a complex state a change is a direction in its real and imaginary parts.

    Args:
        system: what moves.
        count: how many changes there are.

    >>> import polhode as ph
    >>> body = ph.systems.FreeRigidBody((1.0, 2.0, 3.0))
    >>> varied = Variations(body, 1)  # of a turn about the middle axis, pushed off it
    >>> trajectory = ph.simulate(varied, [[0.0, 2.0, 0.0], [1.0, 0.0, 0.0]], [0.0, 1.0])
    >>> bool(abs(trajectory.states[-1, 1, 0] - jnp.cosh(3.0**-0.5)) < 1e-14)
    True
    """

    system: AbstractSystem
    count: int = eqx.field(static=True)

    def __check_init__(self) -> None:
        check.whole("count", self.count, 1, what="changes")

    @property
    def state_axes(self) -> int:
        return self.system.state_axes + 1

    @property
    def count_of_changes(self) -> int:
        return self.count

    @property
    def events(self) -> dict[str, Event]:
        return {name: lambda t, state, event=event: event(t, self.first(state))
                for name, event in self.system.events.items()}

    @property
    def jumps(self) -> Float64[Array, "jumps"]:
        return self.system.jumps

    def first(self, state: Double[Array, "..."]) -> Double[Array, "..."]:
        """Return the system's own state of states (…, 1 + count, …)."""
        return jnp.take(state, 0, axis=jnp.ndim(state) - self.state_axes)

    def vector_field(self, t: Real[ArrayLike, "..."], state: Double[Array, "*shape"]) -> Double[Array, "*shape"]:
        axis = jnp.ndim(state) - self.state_axes
        own, *changes = jnp.moveaxis(state, axis, 0)
        # δ̇ = Df(x) δ: f is linearised once for all changes
        rates, pushed = jax.linearize(lambda x: rates_of_change(self.system, t, x), own)
        return jnp.moveaxis(jnp.concatenate([rates[None], jax.vmap(pushed)(jnp.stack(changes))]), 0, axis)

    def invariants(self, state: Double[Array, "..."]) -> dict[str, Float64[Array, "..."]]:
        return self.system.invariants(self.first(state))

    def balances(self, t: Real[ArrayLike, "..."], state: Double[Array, "..."]) -> dict[str, Balance]:
        return self.system.balances(t, self.first(state))

    @known_numbers_only
    def check_state(self, state: Real[ArrayLike, "*shape"]) -> Double[Array, "*shape"]:
        """Return states as an array of the system's kind.

        Raises:
            InvalidInput: for wrong shapes, changes that are not finite, or where the system cannot start.
        """
        require_doubles(state=state)
        state = jnp.asarray(state)
        axis = state.ndim - self.state_axes
        if axis < 0 or jnp.shape(state)[axis] != 1 + self.count:
            raise InvalidInput(
                f"`state` must be a state of {type(self.system).__name__} and {self.count} changes of it, stacked; got "
                f"shape {jnp.shape(state)}."
            )
        own = self.system.check_state(jnp.take(state, 0, axis=axis))
        changes = jnp.moveaxis(state, axis, 0)[1:]
        if not bool(jnp.isfinite(changes).all()):
            raise InvalidInput("`state` has changes that are not finite. Give finite ones; they may have any size.")
        return jnp.moveaxis(jnp.concatenate([jnp.asarray(own)[None], changes.astype(own.dtype)]), 0, axis)

    def scales(self, state: Double[Array, "..."]) -> Float64[Array, "..."]:
        """Return those of the system, and infinite ones for changes, which may have any size."""
        own = jnp.broadcast_to(self.system.scales(state[0]), jnp.shape(state[0]))
        return jnp.concatenate([own[None], jnp.full((self.count, *own.shape), jnp.inf)])
