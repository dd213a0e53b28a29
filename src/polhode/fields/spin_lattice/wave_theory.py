"""Linear spin waves: the small motions of a spin lattice about a state of least energy, by wave vector."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from polhode._base.arrays import known_numbers_only
from polhode.errors import InvalidInput
from polhode.fields.spin_lattice.system import SpinLattice
from polhode.types import ArrayLike, Float64, Real


class GroundStateLimits(NamedTuple):
    """What a state must satisfy as a ground state of spin waves.

    Attributes:
        max_torque: |S × B| over |S| and the largest of couplings and |B|: with more the state moves.
        max_negative_curvature: over the largest curvature: with a more negative one the state is no minimum.
    """

    max_torque: float = 1e-8
    max_negative_curvature: float = 1e-9


LIMITS = GroundStateLimits()


@known_numbers_only
def spin_waves(
    system: SpinLattice, ground_state: Real[ArrayLike, "..."], wave_vectors: Real[ArrayLike, "..."]
) -> Float64[np.ndarray, "..."]:
    """Return angular frequencies (…, modes), ascending, of an infinite lattice with the system's bonds.

    The linear equations on the Bloch space of a magnetic cell, ẋ = ΩKx with the Hessian K of H on the tangent planes of
    the spheres and the Poisson matrix Ω. With K = RR they have the frequencies of the hermitian iRΩR, so that they are
    real to the last digit; where a frequency is zero, the square root of K's rounding is left.

    Args:
        system: without dipoles, its field one for all cells.
        ground_state: (M1, M2, M3, b, 3) spins of one magnetic cell, which repeats; or (b, 3) of a crystal's cell.
        wave_vectors: (…, e) q, Cartesian like the lattice's vectors, in radians per unit of length.

    Raises:
        InvalidInput: for a state that does not rest or is not a minimum, and for systems with dipoles.

    >>> from polhode.fields import Bond, Lattice
    >>> chain = SpinLattice(Lattice([[1.0]], shape=(4,)), bonds=[Bond(0, 0, (1,), 1.0)])
    >>> spin_waves(chain, [[0.0, 0.0, 1.0]], [np.pi]).round(12).tolist()
    [4.0]
    """
    if system.kernel is not None:
        raise InvalidInput("`system` must have no dipoles: their sums over an infinite lattice are not computed.")
    state = np.asarray(ground_state, float)
    state = state[None, None, None] if state.ndim == 2 else state
    if state.ndim != 5 or state.shape[-2:] != (system.lattice.sites, 3):
        raise InvalidInput(f"`ground_state` must be (M1, M2, M3, b, 3) or (b, 3); got shape {state.shape}.")
    q = np.asarray(wave_vectors, float)
    q = np.pad(q, [(0, 0)] * (q.ndim - 1) + [(0, 3 - q.shape[-1])])
    lengths, frames = _frames(state.reshape(-1, 3))
    field = _fields(system, state.shape[:4])
    couplings = _couplings(system, state.shape[:3])
    spins = state.reshape(-1, 3)
    uniform = field + sum((m @ spins[b])[None] * (np.arange(len(spins)) == a)[:, None] for a, b, _, m in couplings)
    largest = max([np.abs(m).max() for *_, m in couplings] + [np.abs(field).max()], default=0.0)
    torque = np.abs(np.cross(spins, uniform)).max()
    if torque > LIMITS.max_torque * lengths.max() * max(largest, np.abs(uniform).max()):
        raise InvalidInput(f"`ground_state` must rest; it feels a torque of {torque:.3g}. Relax it by damping first.")
    frequencies = [_frequencies(one, couplings, uniform, spins, lengths, frames) for one in q.reshape(-1, 3)]
    return np.array(frequencies).reshape(*q.shape[:-1], -1)


def _frames(spins: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return lengths (n,) and tangent frames (n, 3, 2), right-handed with the spin."""
    lengths = np.linalg.norm(spins, axis=1)
    if not (np.isfinite(lengths).all() and (lengths > 0).all()):
        raise InvalidInput("`ground_state` must hold finite spins, none of them zero.")
    z = spins / lengths[:, None]
    x = np.cross(z, np.eye(3)[np.abs(z).argmin(axis=1)])
    x /= np.linalg.norm(x, axis=1, keepdims=True)
    return lengths, np.stack([x, np.cross(z, x)], axis=-1)


def _fields(system: SpinLattice, shape: tuple[int, ...]) -> np.ndarray:
    field = np.zeros(3) if system.field is None else np.asarray(system.field)
    try:
        return np.broadcast_to(field, (*shape, 3)).reshape(-1, 3)
    except ValueError:
        raise InvalidInput(
            f"`system` must have a field that repeats with the cell; its shape is {field.shape}."
        ) from None


def _couplings(system: SpinLattice, cells: tuple[int, ...]) -> list[tuple[int, int, np.ndarray, np.ndarray]]:
    """Return (a, b, how far, matrix) with B_a = Σ matrix S_b, of sites of the magnetic cell, by both ways of a bond."""
    vectors = np.zeros((3, 3))
    vectors[: system.lattice.dimension] = system.lattice.vectors
    sites, couplings = system.lattice.sites, []
    for place in np.ndindex(*cells):
        here = int(np.ravel_multi_index(place, cells)) * sites
        for bond in system.bonds:
            end = tuple((np.add(place, bond.cell) % cells).tolist())
            there = int(np.ravel_multi_index(end, cells)) * sites
            far, matrix = np.array(bond.cell) @ vectors, np.array(bond.matrix)
            couplings.append((here + bond.i, there + bond.j, far, matrix))
            couplings.append((there + bond.j, here + bond.i, -far, matrix.T))
        for a, matrix in enumerate(system.onsite or ()):
            couplings.append((here + a, here + a, np.zeros(3), 2.0 * np.array(matrix)))
    return couplings


def _frequencies(
    q: np.ndarray, couplings: list, field: np.ndarray, spins: np.ndarray, lengths: np.ndarray, frames: np.ndarray
) -> np.ndarray:
    count = len(spins)
    hessian = np.zeros((count, 2, count, 2), complex)
    # on the sphere S = S₀ √(1 − |x|²/|S|²) + x: −B·S has the second derivative B·S₀/|S|² in each direction across
    pull = np.sum(field * spins, axis=1) / lengths**2
    for a in range(count):
        hessian[a, :, a, :] += pull[a] * np.eye(2)  # of the sphere's curvature
    for a, b, far, matrix in couplings:
        hessian[a, :, b, :] -= frames[a].T @ matrix @ frames[b] * np.exp(1j * (far @ q))
    hessian = hessian.reshape(2 * count, 2 * count)
    sizes, axes = np.linalg.eigh(hessian)
    if sizes[0] < -LIMITS.max_negative_curvature * np.abs(sizes).max():
        raise InvalidInput(
            "`ground_state` must be a minimum of the energy; "
            f"at q = {q.round(6).tolist()} its curvature is {sizes[0]:.3g}."
        )
    # ΩK = R⁻¹ (RΩR) R has the eigenvalues of RΩR, which is antihermitian
    root = axes * np.sqrt(np.maximum(sizes, 0.0)) @ axes.conj().T
    # δṠ = S × δB: x and y of the tangent plane with {x, y} = |S|
    poisson = np.kron(np.diag(lengths), np.array([[0.0, 1.0], [-1.0, 0.0]]))
    return np.linalg.eigvalsh(1j * root @ poisson @ root)[count:]
