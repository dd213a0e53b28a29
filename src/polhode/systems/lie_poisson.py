"""Any Hamiltonian on the dual of any algebra."""

from __future__ import annotations

from types import NoneType

import equinox as eqx
import jax
import jax.numpy as jnp

from polhode._base import check
from polhode._base.arrays import require_doubles
from polhode.algebra._closures import take_apart
from polhode.algebra._functions import Function, check_scalar
from polhode.algebra.base import AbstractLieAlgebra
from polhode.errors import InvalidInput, shown
from polhode.systems.base import AbstractLiePoissonSystem
from polhode.types import Array, ArrayLike, Float64, Real


class LiePoisson(AbstractLiePoissonSystem):
    """The motion of a Hamiltonian given as a function of one point.

    Numbers in a function, its variables' too, are read when the system is made (of a jitted function, when JAX first
    traced it), and are data from then on: what is compiled serves all functions that do the same with other numbers,
    and derivatives go by numbers that JAX traces. To have parameters by name, give them next to the function, as
    ``jax.tree_util.Partial(function, parameters)`` with H(parameters, point), or as the fields of an
    ``equinox.Module`` with ``__call__``. Functions with derivatives of their own (``jax.custom_jvp``) or callbacks stay
    as they are, and each of them is compiled.

    Args:
        algebra: the Lie algebra.
        hamiltonian: H of one point of the dual, a real scalar; differentiable by JAX.
        conserved: other functions of one point that the motion keeps, by name; watched, not enforced.
        sign: −1 for the left-invariant (minus) bracket, +1 for the other.

    Raises:
        InvalidInput: if H is not a real scalar at one point, or the sign is not ±1.

    >>> from polhode.algebra import SO3
    >>> body = LiePoisson(SO3(), lambda L: 0.5 * jnp.sum(L**2 / jnp.array([1.0, 2.0, 3.0])))
    >>> (6.0 * body.vector_field(0.0, jnp.array([1.0, 1.0, 1.0]))).round(9).tolist()
    [-1.0, 4.0, -3.0]
    """

    algebra: AbstractLieAlgebra
    hamiltonian: Function
    conserved: dict[str, Function] = eqx.field(default_factory=dict)
    orientation: int = eqx.field(static=True, default=-1)

    def __init__(
        self,
        algebra: AbstractLieAlgebra,
        hamiltonian: Function,
        conserved: dict[str, Function] | None = None,
        sign: int = -1,
    ) -> None:
        if sign not in (-1, 1):
            raise InvalidInput(f"`sign` must be −1 (left-invariant) or +1 (right-invariant); got {shown(sign)}.")
        check.instance("algebra", algebra, AbstractLieAlgebra, "one of polhode.algebra")
        check.instance("conserved", conserved, (dict, NoneType), "functions by name, {name: function}")
        for name, function in {"hamiltonian": hamiltonian, **(conserved or {})}.items():
            check_scalar(name, function, algebra.element_shape, algebra.dtype)
        point = jax.ShapeDtypeStruct(algebra.element_shape, algebra.dtype)
        self.algebra, self.hamiltonian, self.orientation = algebra, take_apart(hamiltonian, point), sign
        self.conserved = {name: take_apart(function, point) for name, function in (conserved or {}).items()}

    @property
    def sign(self) -> int:
        return self.orientation

    @property
    def extra_invariants(self) -> dict[str, Function]:
        return {name: self._batch(function) for name, function in self.conserved.items()}

    def energy(self, point: Real[ArrayLike, "..."]) -> Float64[Array, "..."]:
        return self._batch(self.hamiltonian)(point)

    def _batch(self, function: Function) -> Function:
        def values(point: Array) -> Array:
            require_doubles(point=point)
            point = jnp.asarray(point, dtype=self.algebra.dtype)
            batched = function
            for _ in self.algebra.batch_shape(point):
                batched = jax.vmap(batched)
            return batched(point)

        return values
