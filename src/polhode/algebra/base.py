"""The base class of Lie algebras: bracket, coadjoint map, pairing, Casimirs, and the group's action on the dual.

Elements of the algebra and of its dual are arrays of one shape, ``element_shape``, behind any batch axes. A dual
element μ and an element x are paired by ⟨μ, x⟩; ⟨ad*_x μ, y⟩ = ⟨μ, [x, y]⟩ and ⟨Ad*_g μ, y⟩ = ⟨μ, Ad_g y⟩, so that
μ(t) = Ad*_{exp(tξ)} μ solves μ̇ = ad*_ξ μ.
Source: Marsden & Ratiu, *Introduction to Mechanics and Symmetry*, ch. 9, 13.
"""

from __future__ import annotations

import abc
import itertools
import math
from functools import cache, cached_property, partial
from types import MethodType
from typing import TYPE_CHECKING, Any
from weakref import WeakKeyDictionary

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np

from polhode._base.arrays import is_traced
from polhode._base.arrays.operation import Operation, along
from polhode.errors import InvalidInput
from polhode.motion._layout import StatePart
from polhode.types import Array, ArrayLike, Double, Float64

# of algebras whose elements are vectors; operands broadcast
Vector = Float64[Array, "*batch {self.dim}"]
Operand = Float64[Array, "*#batch {self.dim}"]


_methods: WeakKeyDictionary[Any, tuple[type, dict[str, Any]]] = WeakKeyDictionary()


@cache
def _calling_at_once(kind: type) -> type:
    """Return a class of methods that are called by their function and object, without Equinox's look at attributes."""

    class Method(kind):
        def __call__(self, *args: Any, **kwargs: Any) -> Any:
            own = object.__getattribute__(self, "__dict__")
            return own["__func__"](own["__self__"], *args, **kwargs)

        def __reduce__(self) -> Any:  # as pickle finds no class made here
            own = object.__getattribute__(self, "__dict__")
            return getattr, (own["__self__"], own["__func__"].__name__)

    Method.__name__, Method.__qualname__, Method.__module__ = kind.__name__, kind.__qualname__, kind.__module__
    return Method


def _without_self(method: Any) -> tuple[type, dict[str, Any]]:
    """Return a class of methods that are pytrees, and the fields of one but function and object, which are not kept."""
    fields = {name: x for name, x in vars(method).items() if name not in ("__func__", "__self__")}
    return _calling_at_once(type(method)), fields


def _are_equal(one: Any, other: Any) -> Any:
    """Return whether modules are of one class, of equal parts and numbers, without an operation of JAX for each array.

    Arrays are compared as the hash has them, by their bytes: 0.0 and −0.0 differ, and what holds a NaN equals itself.
    Machines of a system are found by one that is equal.
    """
    if type(one) is not type(other):
        return False
    (leaves, tree), (others, other_tree) = jax.tree.flatten(one), jax.tree.flatten(other)
    if tree != other_tree:
        return False
    if is_traced(*leaves, *others):
        return eqx.tree_equal(one, other)
    return all(itertools.starmap(_is_same, zip(leaves, others, strict=True)))


def _is_same(leaf: Any, other: Any) -> bool:
    if leaf is other:
        return True
    arrays = _is_array(leaf), _is_array(other)
    if not all(arrays):
        return not any(arrays) and bool(leaf == other)
    alike = leaf.shape == other.shape and leaf.dtype == other.dtype
    return alike and np.asarray(leaf).tobytes() == np.asarray(other).tobytes()


def _is_array(leaf: Any) -> bool:
    return isinstance(leaf, np.ndarray | jax.Array)


class HashableModule(eqx.Module):
    """A module whose hash is that of its contents, arrays included, so that ``jax.jit`` takes its methods."""

    def __eq__(self, other: object, /) -> Any:
        return self is other or _are_equal(self, other)

    if not TYPE_CHECKING:

        def __getattribute__(self, name: str) -> Any:
            """Return an attribute; methods are pytrees as Equinox has them, copies of the first, which it makes slowly.

            A short motion asks for some three hundred methods: making each anew took a third of its time.
            """
            value = object.__getattribute__(self, name)
            if type(value) is not MethodType or value.__self__ is not self or name.startswith("__"):
                return value
            known = _methods.get(value.__func__)
            if known is None:
                known = _methods[value.__func__] = _without_self(super().__getattribute__(name))
            kind, fields = known
            method = object.__new__(kind)
            object.__getattribute__(method, "__dict__").update(fields, __func__=value.__func__, __self__=self)
            return method

    def __hash__(self) -> int:
        leaves, structure = jax.tree.flatten(self)
        return hash((structure, *((x.shape, np.asarray(x).tobytes()) if _is_array(x) else x for x in leaves)))


class AbstractLieAlgebra(HashableModule):
    """A finite-dimensional real Lie algebra.

    Subclasses give ``dim``, ``element_shape``, ``bracket`` and ``coadjoint``, structured and batched; the rest follows,
    and is overridden where a closed form is faster.
    """

    @property
    @abc.abstractmethod
    def dim(self) -> int:
        """Dimension over the reals."""

    @property
    def element_shape(self) -> tuple[int, ...]:
        """Shape of an element, (dim,) unless elements are matrices."""
        return (self.dim,)

    @property
    def dtype(self) -> Any:
        """Type of an element's entries."""
        return jnp.float64

    @property
    def name(self) -> str:
        return type(self).__name__

    @property
    def casimir_names(self) -> tuple[str, ...]:
        """Names of the known Casimirs, in the order of ``casimirs``."""
        return ()

    @property
    def fractions(self) -> Any:
        """Structure constants as nested tuples of Fractions, where these are known and no doubles; else None."""
        return None

    @property
    def unwatched(self) -> str:
        """A run's note on Casimirs that ``casimirs`` lacks; "" where that is not looked at."""
        return ""

    @property
    def element_rule(self) -> str:
        """What arrays of ``element_shape`` are in the algebra, as "antisymmetric"; empty where all of them are."""
        return "" if self._is_filled else f"combinations of the {self.dim} of a basis"

    @property
    def _is_filled(self) -> bool:
        """Whether every array of an element's shape is one."""
        parts = 2 if jnp.issubdtype(self.dtype, jnp.complexfloating) else 1
        return parts * math.prod(self.element_shape) == self.dim

    @property
    def body_parts(self) -> tuple[StatePart, ...]:
        """The parts of a point of the dual for a rigid body, whose attitude is in the group; else empty."""
        return ()

    @property
    def rotations(self) -> tuple[int, ...]:
        """Three components one behind the other that are an so(3), [e_i, e_j] = ε_ijk e_k, and turn a body; else none.

        A state of a left-invariant system may then have the attitude in front, R' = R hat(Ω) with Ω = dH along these.
        """
        return (0, 1, 2) if self.body_parts else ()

    def of_rotations(self, vector: Double[Array, "..."]) -> Float64[Array, "... 3"]:
        """Return the components ``rotations`` of an element, or of a point of the dual.

        Raises:
            InvalidInput: for an algebra without.
        """
        if not self.rotations:
            raise InvalidInput(f"{self.name} has no so(3) that turns a body. Name its components by `rotations=`.")
        return vector[..., self.rotations[0] : self.rotations[2] + 1]

    @property
    def is_of_spins(self) -> bool:
        """Whether a point of the dual is a spin with three components, or an array of such."""
        return False

    # ------------------------------------------------------------------ the algebra and its dual

    @abc.abstractmethod
    def bracket(self, x: Double[Array, "..."], y: Double[Array, "..."]) -> Double[Array, "..."]:
        """Return [x, y]."""

    @abc.abstractmethod
    def coadjoint(self, x: Double[Array, "..."], mu: Double[Array, "..."]) -> Double[Array, "..."]:
        """Return ad*_x μ, ⟨ad*_x μ, y⟩ = ⟨μ, [x, y]⟩."""

    def pairing(self, mu: Double[Array, "..."], x: Double[Array, "..."]) -> Float64[Array, "..."]:
        """Return ⟨μ, x⟩ (…)."""
        return jnp.sum(self.to_dual_vector(mu) * self.to_vector(x), axis=-1)

    def casimirs(self, mu: Double[Array, "..."]) -> Float64[Array, "... k"]:
        """Return the known Casimirs (…, k) at μ: k of them may be zero."""
        mu = jnp.asarray(mu)
        return jnp.zeros((*self.batch_shape(mu), 0))

    def named_casimirs(self, mu: Double[Array, "..."]) -> dict[str, Float64[Array, "..."]]:
        """Return the known Casimirs at μ by name: (…) each, or (…, count) where a ``Power`` has one in every copy."""
        values = self.casimirs(mu)
        return {name: values[..., k] for k, name in enumerate(self.casimir_names)}

    @property
    def casimirs_of_copies(self) -> tuple[str, ...]:
        """Which of ``named_casimirs`` have a value for each copy."""
        return ()

    # ------------------------------------------------------------------ coordinates

    def to_vector(self, x: Double[Array, "..."]) -> Float64[Array, "... {self.dim}"]:
        """Return the coordinates (…, dim) of an element in the stated basis."""
        return x

    def from_vector(self, vector: Float64[Array, "... {self.dim}"]) -> Double[Array, "..."]:
        """Return the element with the given coordinates (…, dim)."""
        return vector

    def to_dual_vector(self, mu: Double[Array, "..."]) -> Float64[Array, "... {self.dim}"]:
        """Return ⟨μ, e_i⟩ (…, dim): coordinates in the dual basis."""
        return mu

    def from_dual_vector(self, vector: Float64[Array, "... {self.dim}"]) -> Double[Array, "..."]:
        """Return the dual element with ⟨μ, e_i⟩ as given (…, dim)."""
        return vector

    def from_gradient(self, gradient: Double[Array, "..."]) -> Double[Array, "..."]:
        """Return the element x with δF = ⟨δμ, x⟩ from a function's partial derivatives as JAX gives them."""
        return gradient

    def project(self, matrix: Double[Array, "..."]) -> Double[Array, "..."]:
        """Return the part of any array (…, *element_shape) that lies in the dual."""
        return matrix if self._is_filled else self.from_dual_vector(self.to_dual_vector(matrix))

    def batch_shape(self, value: ArrayLike) -> tuple[int, ...]:
        """Return the leading axes of an array of elements.

        Raises:
            InvalidInput: if its last axes are not an element's.
        """
        shape, own = jnp.shape(value), self.element_shape
        if shape[len(shape) - len(own) :] != own:
            raise InvalidInput(f"an element of {self.name} has shape (…, {', '.join(map(str, own))}); got {shape}.")
        return shape[: len(shape) - len(own)]

    @cached_property
    def _structure_constants(self) -> np.ndarray:
        # compiled beforehand, as it may be asked for inside a jitted function
        constants = np.array(jax.jit(self._brackets_of_basis).lower().compile()())
        constants.flags.writeable = False
        return constants

    def _brackets_of_basis(self) -> Array:
        basis = self.from_vector(jnp.eye(self.dim))
        return self.to_vector(self.bracket(basis[:, None], basis[None, :]))

    def structure_constants(self) -> Float64[Array, "{self.dim} {self.dim} {self.dim}"]:
        """Return c (dim, dim, dim), [e_i, e_j] = Σ_k c[i,j,k] e_k; for small algebras."""
        # of an algebra whose own numbers are traced they are traced too
        return self._brackets_of_basis() if is_traced(*jax.tree.leaves(self)) else self._structure_constants

    def rate(self, x: Double[Array, "..."]) -> Float64[Array, "..."]:
        """Return how fast exp(tx) turns (…) [rad per unit of t]: the spectral radius of ad_x, or a bound of it."""
        # no eigenvalue of ad_x exceeds the largest row sum of absolute values
        constants = jnp.abs(self.structure_constants())
        return jnp.max(jnp.einsum("...i,ijk->...jk", jnp.abs(self.to_vector(x)), constants).sum(axis=-1), axis=-1)

    # ------------------------------------------------------------------ the group

    def exp(self, x: Double[Array, "..."]) -> Any:
        """Return the group element exp x; here as the matrix of Ad (…, dim, dim) in the stated basis."""
        # column j of ad_x is [x, e_j], and Ad_{exp x} = exp(ad_x)
        ad = jnp.einsum("...i,ijk->...kj", self.to_vector(x), self.structure_constants())
        return jax.scipy.linalg.expm(ad)

    def compose(self, g: Any, h: Any) -> Any:
        """Return the product g h of group elements as ``exp`` gives them; Ad*_{gh} μ = Ad*_h Ad*_g μ."""
        return g @ h

    def coadjoint_action(self, g: Any, mu: Double[Array, "..."]) -> Double[Array, "..."]:
        """Return Ad*_g μ for g as ``exp`` gives it."""
        # ⟨Ad*_g μ, e_i⟩ = ⟨μ, Ad_g e_i⟩: the transposed matrix
        return self.from_dual_vector(jnp.einsum("...ji,...j->...i", g, self.to_dual_vector(mu)))

    def cayley(self, x: Double[Array, "..."]) -> Any:
        """Return (1 − x/2)⁻¹ (1 + x/2) as a group element, where the group is one of those whose Cayley map exists."""
        raise InvalidInput(f"the group of {self.name} has no Cayley map here; use `exp`.")

    def exp_change(self, x: Double[Array, "..."], mu: Double[Array, "..."]) -> Double[Array, "..."]:
        """Return Ad*_{exp x} μ − μ without cancellation, so that many small steps round little.

        By Σ_{k≥1} (ad*_x)ᵏ μ/k!, summed until the terms are negligible, each copy of a batch to its own: exact to
        rounding for |ad_x| up to about 2π. Beyond, what does not converge comes out as NaN.
        """
        max_terms = 60  # of Σ ad*ᵏμ/k!: enough for a turn by 2π and more in one step
        own = tuple(range(-len(self.element_shape), 0))

        def is_significant(term: Array, total: Array) -> Array:
            size, whole = (jnp.max(jnp.abs(a), axis=own, keepdims=True, initial=0.0) for a in (term, total))
            return size > 1e-18 * whole

        def unfinished(carried: tuple[Any, Array, Array]) -> jax.Array:
            k, term, total = carried
            return (k < max_terms) & jnp.any(is_significant(term, total))

        # of an algebra with numbers of its own these are arguments too: no derivative knows what a rule encloses
        numbers, rest = eqx.partition(self, eqx.is_inexact_array)

        def sum_series(numbers: Any, x: Array, mu: Array, known_count: bool) -> Array:
            coadjoint = eqx.combine(numbers, rest).coadjoint

            def add(carried: tuple[Any, Array, Array]) -> tuple[Any, Array, Array]:
                k, term, total = carried
                term = jnp.where(is_significant(term, total), coadjoint(x, term) / (k + 1), 0.0)
                return k + 1, term, total + term

            first = coadjoint(x, mu)
            start = (1, first, first)
            if known_count:
                _, term, total = jax.lax.fori_loop(1, max_terms, lambda _, now: add(now), start)
            else:
                _, term, total = jax.lax.while_loop(unfinished, add, start)
            return jnp.where(is_significant(term, total), jnp.nan, total)

        # reverse mode needs a known number of terms, of which most vanish
        sums, counted = (partial(sum_series, known_count=known) for known in (False, True))
        return Operation("exp_change", sums, along(counted))(numbers, jnp.asarray(x), jnp.asarray(mu))

    def cayley_change(self, x: Double[Array, "..."], mu: Double[Array, "..."]) -> Double[Array, "..."]:
        """Return Ad*_{cay x} μ − μ."""
        return self.coadjoint_action(self.cayley(x), mu) - mu
