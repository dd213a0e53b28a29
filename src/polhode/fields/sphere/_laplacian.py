"""The Laplacian of functions on the quantised sphere, and its inverse, in O(N²).

(ΔP)_{m m'} = −2(s(s+1) − m m') P_{m m'} + c(m)c(m') P_{m+1,m'+1} + c(m−1)c(m'−1) P_{m−1,m'−1} with c(m) = √(s(s+1) −
m(m+1)) leaves every diagonal alone. Diagonals are stored wrapped, D[k, i] = P[(i+k) mod N, i]: c(s) = 0 cuts them
where they wrap, so that all are one batch of N tridiagonal systems of N equations. Source: Modin & Viviani, J. Fluid
Mech. 884 (2020) A22; Cifani, Viviani & Modin, J. Comput. Phys. 473 (2023) 111772.
"""

from __future__ import annotations

from functools import lru_cache
from typing import NamedTuple

import jax
import jax.numpy as jnp
import numpy as np

from polhode.types import Array, Complex128, Float64


class Factors(NamedTuple):
    """LDLᵀ of the Laplacian's diagonals (N, N), by place along them and diagonal: D⁻¹ and L's entries below one."""

    inverse: Float64[np.ndarray, "n n"]
    below: Float64[np.ndarray, "n n"]


def diagonals(n: int) -> tuple[Float64[np.ndarray, "n n"], Float64[np.ndarray, "n n"]]:
    """Return the entries of Δ on wrapped diagonals, and their couplings to the next, by place i and diagonal k."""
    s = 0.5 * (n - 1)
    m = np.arange(n) - s
    c = np.sqrt(np.maximum((s - m) * (s + m + 1.0), 0.0))
    # the row m′ = m + k of place i on diagonal k, wrapped
    rows = (np.arange(n)[:, None] + np.arange(n)) % n
    return -2.0 * (s * (s + 1.0) - m[rows] * m[:, None]), c[rows] * c[:, None]


@lru_cache(maxsize=8)
def factors(n: int) -> Factors:
    """Return the factors for N; −1 in the main diagonal's first equation makes Δ regular on the constant function."""
    entries, beside = diagonals(n)
    entries[0, 0] -= 1.0
    inverse, below = np.empty((n, n)), np.zeros((n, n))
    # a diagonal is LDLᵀ with l_i = b_{i−1}/d_{i−1} and d_i = a_i − l_i b_{i−1}; −Δ is positive, which needs no pivots
    inverse[0] = 1.0 / entries[0]
    for i in range(1, n):
        below[i] = beside[i - 1] * inverse[i - 1]
        inverse[i] = 1.0 / (entries[i] - below[i] * beside[i - 1])
    return Factors(inverse, below)


def wrap_diagonals(matrix: Complex128[Array, "*batch n n"]) -> Complex128[jax.Array, "n n *batch"]:
    """Return D[i, k] = P[(i+k) mod N, i] (N, N, …), places first."""
    n = matrix.shape[-1]
    i = np.arange(n)
    return jnp.moveaxis(matrix[..., (i[:, None] + i) % n, i[:, None]], (-2, -1), (0, 1))


def unwrap_diagonals(places: Complex128[Array, "n n *batch"]) -> Complex128[Array, "*batch n n"]:
    """Return the matrix of wrapped diagonals."""
    n = places.shape[0]
    i = np.arange(n)
    return jnp.moveaxis(places[i[None, :], (i[:, None] - i) % n], (0, 1), (-2, -1))


def laplacian(matrix: Complex128[Array, "*batch n n"]) -> Complex128[Array, "*batch n n"]:
    """Return ΔP of matrices (…, N, N)."""
    entries, beside = (jnp.asarray(x) for x in diagonals(matrix.shape[-1]))
    places = wrap_diagonals(matrix)
    wide = (..., *[None] * (places.ndim - 2))
    # c(m)c(m′) couples place i to i + 1, and as much i + 1 to i
    ahead = beside[wide] * jnp.roll(places, -1, axis=0)
    behind = jnp.roll(beside[wide] * places, 1, axis=0)
    return unwrap_diagonals(entries[wide] * places + ahead + behind)


def inverse_laplacian(matrix: Complex128[Array, "*batch n n"]) -> Complex128[Array, "*batch n n"]:
    """Return the traceless P with ΔP = W − (tr W/N) 1, for matrices (…, N, N)."""
    n = matrix.shape[-1]
    inverse, below = factors(n)
    places = wrap_diagonals(matrix)
    wide = (..., *[None] * (places.ndim - 2))
    places = places.at[:, 0].add(-jnp.mean(places[:, 0], axis=0))

    def forward(before: jax.Array, row: tuple[jax.Array, jax.Array]) -> tuple[jax.Array, jax.Array]:
        own, low = row
        now = own - low[wide] * before
        return now, now

    start = jnp.zeros_like(places[0])
    _, solution = jax.lax.scan(forward, start, (places, jnp.asarray(below)))
    solution = solution * jnp.asarray(inverse)[wide]

    def backward(after: jax.Array, row: tuple[jax.Array, jax.Array]) -> tuple[jax.Array, jax.Array]:
        own, low = row
        now = own - low[wide] * after
        return now, now

    above = np.roll(below, -1, axis=0)
    above[-1] = 0.0
    _, solution = jax.lax.scan(backward, start, (solution, jnp.asarray(above)), reverse=True)
    solution = solution.at[:, 0].add(-jnp.mean(solution[:, 0], axis=0))
    return unwrap_diagonals(solution)
