"""Classical spins on a lattice."""

from __future__ import annotations

from collections.abc import Sequence
from typing import ClassVar, NamedTuple

import equinox as eqx
import jax.numpy as jnp
import numpy as np

from polhode._base import check
from polhode._base.arrays import compiled_for_few_calls, is_traced, known_numbers_only
from polhode.algebra._functions import Function
from polhode.algebra.power import Power
from polhode.algebra.so3 import SO3
from polhode.errors import InvalidInput, shown
from polhode.fields._turns import dot, turn
from polhode.fields.spin_lattice._bonds import BondType, Matrix, bond_flows, checked_bonds, find_cells
from polhode.fields.spin_lattice._dipoles import dipole_field, dipole_kernel
from polhode.fields.spin_lattice.lattice import Bond, Lattice
from polhode.systems.base import AbstractLiePoissonSystem, Balance, Components, Flow
from polhode.types import Array, ArrayLike, Double, Float64, Real


class SpinLatticeLimits(NamedTuple):
    """What decides on symmetries of the Hamiltonian.

    Attributes:
        max_asymmetry: relative; what matrices break by less is their rounding: of their own symmetry, or of a component
            of the total spin that is conserved.
    """

    max_asymmetry: float = 1e-12


LIMITS = SpinLatticeLimits()


class SpinLattice(AbstractLiePoissonSystem):
    """Ṡ = S × B, B = −∂H/∂S, with the bracket's sign +1.

    H = −Σ_bonds S_iᵀ J S_j − Σ Sᵀ A S − Σ B·S − (g/2) Σ_{a≠b} S_aᵀ (3 d̂ d̂ᵀ − 1) S_b/|d|³, where each bond counts once.
    States are spins (…, L1, L2, L3, b, 3) of the cells and the sites of the basis, angular momenta in units of ħ or
    whatever the energies are in; easy axes are positive A. With damping λ, Ṡ = S × B − (λ/|S|) S × (S × B).

    Without dipoles and damping it moves by exact flows of bonds, ``Splitting``; with them by ``SphericalMidpoint``.

    Args:
        lattice: of the sites.
        spin: length |S| of the spins, one for all or (b,); states made by ``aligned`` have it.
        bonds: each listed once.
        onsite: (3, 3) symmetric A, or (b, 3, 3).
        field: B (3,), or what broadcasts to (L1, L2, L3, b, 3); zero is kept as None.
        dipolar: strength g; needs open boundaries.
        damping: λ, a pure number.

    Raises:
        InvalidInput: for shapes that do not fit, and dipoles on a periodic lattice.

    >>> chain = SpinLattice(Lattice([[1.0]], shape=(4,)), bonds=[Bond(0, 0, (1,), 1.0)])
    >>> float(chain.energy(chain.aligned((0.0, 0.0, 1.0))))
    -4.0
    """

    kind: ClassVar[str] = "spin-lattice"
    lattice: Lattice = eqx.field(static=True)
    spin: tuple[float, ...] = eqx.field(static=True)
    bonds: tuple[BondType, ...] = eqx.field(static=True)
    onsite: tuple[Matrix, ...] | None = eqx.field(static=True)
    field: Array | None
    damping: Array | None
    dipolar: Array
    kernel: Array | None
    algebra: Power
    kept: tuple[tuple[float, ...], ...] = eqx.field(static=True)

    @known_numbers_only
    def __init__(
        self,
        lattice: Lattice,
        spin: Real[ArrayLike, "..."] = 1.0,
        bonds: Sequence[Bond] = (),
        onsite: Real[ArrayLike, "..."] | None = None,
        field: Real[ArrayLike, "..."] = (0.0, 0.0, 0.0),
        dipolar: float = 0.0,
        damping: float = 0.0,
    ) -> None:
        self.lattice = check.instance("lattice", lattice, Lattice, "a polhode.fields.Lattice")
        count = lattice.sites
        self.spin = tuple(np.broadcast_to(check.array("spin", spin, above=0), (count,)).tolist())
        self.bonds = checked_bonds(lattice, bonds)
        self.algebra = Power(SO3(), (*lattice.shape, count))
        self.onsite = _checked_onsite(onsite, count)
        numbers = check.array("field", field)
        try:
            np.broadcast_to(numbers, self.algebra.element_shape)
        except ValueError:
            raise InvalidInput(f"`field` must fit {self.algebra.element_shape}; got {numbers.shape}.") from None
        dipolar = check.number("dipolar", dipolar)
        damping = check.number("damping", damping, least=0)
        if dipolar and any(lattice.periodic):
            raise InvalidInput("`dipolar` needs open boundaries; give the lattice periodic=False.")
        # without a field there is none to turn about, which saves a turn of every spin in each step
        self.field = jnp.asarray(numbers) if numbers.any() else None
        # None where there is no damping, so that no leaf can be set to a value that is ignored elsewhere
        self.damping, self.dipolar = jnp.asarray(damping) if damping else None, jnp.asarray(dipolar)
        self.kernel = jnp.asarray(dipole_kernel(lattice)) if dipolar else None
        self.kept = _find_conserved(self.bonds, self.onsite, numbers) if not dipolar else ()

    @property
    def sign(self) -> int:
        return 1

    @property
    def is_damped(self) -> bool:
        """Whether spins lose energy."""
        return self.damping is not None

    @property
    def conserves_energy(self) -> bool:
        return self.damping is None

    def aligned(self, direction: Real[ArrayLike, "..."]) -> Float64[Array, "..."]:
        """Return spins (…, L1, L2, L3, b, 3) of the system's lengths along directions that broadcast to them.

        Raises:
            InvalidInput: for a direction that is zero or not finite.
        """
        xp = jnp if is_traced(direction) else np
        vectors = xp.asarray(direction, dtype=float)
        size = xp.linalg.norm(vectors, axis=-1, keepdims=True)
        if xp is np and not (np.isfinite(size).all() and (size > 0).all()):
            raise InvalidInput(f"`direction` must be finite and not zero; got {shown(direction)}.")
        spins = vectors / size * xp.asarray(self.spin)[:, None]
        shape = np.broadcast_shapes(spins.shape, self.algebra.element_shape)
        return jnp.asarray(xp.broadcast_to(spins, shape))

    def effective_field(self, point: Real[ArrayLike, "*shape"]) -> Float64[Array, "*shape"]:
        """Return B = −∂H/∂S at every site, for states (…, L1, L2, L3, b, 3)."""
        point = jnp.asarray(point)
        total = self._of_bonds(point, both=True)
        if self.field is not None:
            total = total + self.field
        if self.onsite is not None:
            # ∂/∂S of Sᵀ A S is 2 A S, A symmetric
            total = total + 2.0 * jnp.einsum("aij,...aj->...ai", jnp.asarray(self.onsite), point)
        if self.kernel is not None:
            total = total + self.dipolar * dipole_field(self.kernel, point)
        return total

    @compiled_for_few_calls
    def energy(self, point: Real[ArrayLike, "..."]) -> Float64[Array, "..."]:
        point = jnp.asarray(point)
        half = self._of_bonds(point, both=False)
        if self.field is not None:
            half = half + self.field
        if self.onsite is not None:
            half = half + jnp.einsum("aij,...aj->...ai", jnp.asarray(self.onsite), point)
        if self.kernel is not None:
            half = half + 0.5 * self.dipolar * dipole_field(self.kernel, point)
        return -jnp.sum(half * point, axis=(-5, -4, -3, -2, -1))

    def velocity(self, point: Real[ArrayLike, "*shape"]) -> Float64[Array, "*shape"]:
        return -self.effective_field(point)

    def generator(self, t: Real[ArrayLike, "..."], point: Double[Array, "..."]) -> Double[Array, "..."]:
        field = self.effective_field(point)
        return field if self.damping is None else add_damping(field, point, self.damping)

    def _of_bonds(self, point: Array, both: bool) -> Array:
        """Return Σ J S_j at first ends and, if wanted, Σ Jᵀ S_i at second ends."""
        sites: list[Array] = [jnp.zeros_like(point[..., 0, :]) for _ in range(self.lattice.sites)]
        for bond in self.bonds:
            matrix, mask = jnp.asarray(bond.matrix), find_cells(self.lattice, bond)
            inside = 1.0 if mask is None else mask[..., None].astype(float)
            further = (*bond.cell, 0)
            there = _roll(point[..., bond.j, :], further)
            sites[bond.i] = sites[bond.i] + inside * (there @ matrix.T)
            if both:
                pulled = inside * (point[..., bond.i, :] @ matrix)
                sites[bond.j] = sites[bond.j] + _roll(pulled, tuple(-n for n in further))
        return jnp.stack(sites, axis=-2)

    @property
    def flows(self) -> dict[str, Flow]:
        """Turns of bonds in classes without common sites, of on-site terms and about the field: all exact."""
        if self.is_damped or self.kernel is not None:
            return {}
        flows: dict[str, Flow] = {}
        for k, bond in enumerate(self.bonds):
            flows |= {f"bond {k}, part {n}": flow for n, flow in enumerate(bond_flows(self.lattice, bond))}
        if self.onsite is not None:
            sizes, axes = np.linalg.eigh(np.array(self.onsite))
            own = [k for k in range(3) if sizes[:, k].any()]
            flows |= {f"on site, axis {k}": _onsite_flow(sizes[:, k], axes[:, :, k]) for k in own}
        if self.field is not None:
            flows["field"] = self._field_flow
        return flows

    def _field_flow(self, time: Array, state: Components) -> Components:
        assert self.field is not None
        return turn(state, [-time * self.field[..., k] for k in range(3)])

    @property
    def extra_invariants(self) -> dict[str, Function]:
        """The conserved components of the total spin: all three, one along an axis, or none."""
        if self.is_damped or not self.kept:
            return {}
        axes = np.array(self.kept)
        if len(axes) == 3:
            return {"total spin": lambda point: jnp.sum(point, axis=(-5, -4, -3, -2))}
        return {"total spin along the axis": lambda point: jnp.sum(point * axes[0], axis=(-5, -4, -3, -2, -1))}

    def balances(self, t: Real[ArrayLike, "..."], state: Double[Array, "..."]) -> dict[str, Balance]:
        """Return the energy and the power that damping takes, where there is damping."""
        if self.damping is None:
            return {}
        field = self.effective_field(state)
        # Ḣ = −B·Ṡ = −(λ/|S|) |S × B|² at each spin
        square = jnp.sum(jnp.cross(state, field) ** 2, axis=-1)
        length = jnp.linalg.norm(state, axis=-1)
        power = -self.damping * jnp.sum(square / jnp.where(length > 0, length, 1.0), axis=(-4, -3, -2, -1))
        return {"energy": Balance(self.energy(state), power)}


def add_damping(
    field: Float64[Array, "*shape"], spins: Float64[Array, "*shape"], damping: Real[ArrayLike, ""]
) -> Float64[Array, "*shape"]:
    """Return B − (λ/|S|) S × B, about which spins turn with damping λ."""
    # S × (B − (λ/|S|) S × B) = S × B − (λ/|S|) S × (S × B)
    length = jnp.linalg.norm(spins, axis=-1, keepdims=True)
    return field - damping / jnp.where(length > 0, length, 1.0) * jnp.cross(spins, field)


def _roll(values: Array, further: Sequence[int]) -> Array:
    moved = [(-n, axis) for n, axis in zip(further, (-4, -3, -2, -1), strict=True) if n]
    return jnp.roll(values, [n for n, _ in moved], [axis for _, axis in moved]) if moved else values


def _onsite_flow(sizes: np.ndarray, axes: np.ndarray) -> Flow:
    """Return the flow of −Σ a (n·S)², with a (b,) and n (b, 3) of the sites: turns about n by −2a n·S."""

    def flow(time: Array, state: Components) -> Components:
        n = [jnp.asarray(axes[:, k]) for k in range(3)]
        speed = -2.0 * time * jnp.asarray(sizes) * dot(n, state)
        return turn(state, [speed * x for x in n])

    return flow


def _checked_onsite(onsite: ArrayLike | None, count: int) -> tuple[Matrix, ...] | None:
    if onsite is None:
        return None
    matrices = np.asarray(onsite, float)
    if matrices.shape not in ((3, 3), (count, 3, 3)) or not np.isfinite(matrices).all():
        raise InvalidInput(f"`onsite` must be finite, (3, 3) or ({count}, 3, 3); got shape {matrices.shape}.")
    if np.abs(matrices - np.swapaxes(matrices, -1, -2)).max() > LIMITS.max_asymmetry * np.abs(matrices).max():
        raise InvalidInput("`onsite` must be symmetric matrices, as Sᵀ A S has no other part.")
    matrices = np.broadcast_to(matrices, (count, 3, 3))
    return tuple(tuple(map(tuple, one)) for one in matrices.tolist())


def _find_conserved(bonds: Sequence[BondType], onsite: Sequence[Matrix] | None, field: np.ndarray) -> tuple:
    """Return rows c with c·ΣS constant: those about which turns of all spins change no term of H."""
    hats = np.stack([np.cross(np.eye(3)[k], np.eye(3)).T for k in range(3)])
    matrices = [np.array(bond.matrix) for bond in bonds] + [np.array(one) for one in onsite or ()]
    # turning all spins about c changes S_iᵀ J S_j by S_iᵀ (J ĉ − ĉ J) S_j, and B·S by −(c × B)·S: both linear in c, so
    # that a null space decides
    lines = [np.stack([(m @ hat - hat @ m).ravel() for hat in hats], axis=1) for m in matrices]
    fields = field.reshape(-1, 3)
    fields = np.unique(fields, axis=0)
    lines += [np.stack([hat @ one for hat in hats], axis=1) for one in fields]
    lines = [one / size for one, size in ((x, np.abs(x).max()) for x in lines) if size > 0.0]
    if not lines:
        return tuple(map(tuple, np.eye(3).tolist()))
    _, sizes, rows = np.linalg.svd(np.concatenate(lines))
    return tuple(map(tuple, rows[sizes <= LIMITS.max_asymmetry * sizes[0]].tolist()))
