"""The field of dipoles on a lattice with open boundaries, by Fourier transforms of twice its size."""

from __future__ import annotations

import jax.numpy as jnp
import numpy as np

from polhode.fields.spin_lattice.lattice import Lattice
from polhode.types import Array, Complex128, Float64


def dipole_kernel(lattice: Lattice) -> Complex128[np.ndarray, "..."]:
    """Return the transform (2L1, 2L2, L3 + 1, b, b, 3, 3) of (3 d̂ d̂ᵀ − 1)/|d|³, d from the second site to the first.

    The box is twice the lattice, so that no site sees an image of another. Zero where d = 0.
    """
    vectors = np.zeros((3, 3))
    vectors[: lattice.dimension] = lattice.vectors
    counts = [np.fft.fftfreq(2 * n, 1.0 / (2 * n)) for n in lattice.shape]
    cells = np.stack(np.meshgrid(*counts, indexing="ij"), axis=-1)
    sites = np.array(lattice.basis)
    # shifts n = −L, …, L − 1 of cells along each axis, in the order of the transform; d = R(n) + r_a − r_b
    gaps = (cells @ vectors)[..., None, None, :] + (sites[:, None] - sites[None])
    distance = np.linalg.norm(gaps, axis=-1)[..., None, None]
    # where all shifts are ±L no two sites are that far apart; any value serves there
    safe = np.where(distance > 0.0, distance, 1.0)
    unit = gaps / safe[..., 0]
    kernel = (3.0 * unit[..., :, None] * unit[..., None, :] - np.eye(3)) / safe**3
    kernel = np.where(distance > 0.0, kernel, 0.0)
    return np.fft.rfftn(kernel, axes=(0, 1, 2))


def dipole_field(kernel: Complex128[Array, "..."], spins: Float64[Array, "*shape"]) -> Float64[Array, "*shape"]:
    """Return Σ_b (3 d̂ d̂ᵀ − 1) S_b/|d|³ at every site, (…, L1, L2, L3, b, 3)."""
    shape = spins.shape[-5:-2]
    box = tuple(2 * n for n in shape)
    # a sum over shifts of cells is a convolution; padded with zeros to twice the size, the cyclic one of the transforms
    # is the open one
    transform = jnp.fft.rfftn(spins, s=box, axes=(-5, -4, -3))
    field = jnp.fft.irfftn(jnp.einsum("xyzabij,...xyzbj->...xyzai", kernel, transform), s=box, axes=(-5, -4, -3))
    return field[..., : shape[0], : shape[1], : shape[2], :, :]
