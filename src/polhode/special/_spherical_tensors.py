"""Spherical tensors T_kq of a spin: matrices that rotate as spherical harmonics do.

Source: Varshalovich, Moskalev & Khersonskii, *Quantum Theory of Angular Momentum*, §2.4; Hoppe & Yau, Commun. Math.
Phys. 195 (1998) 67, for the tridiagonal matrix.
"""

from __future__ import annotations

import math

import numpy as np

from polhode._base.arrays import known_numbers_only
from polhode.errors import InvalidInput, shown
from polhode.types import Array, Float64


def magnetic_numbers(s: float) -> Float64[Array, "n"]:
    """Return m = s, s − 1, …, −s, as floats (2s+1,).

    Raises:
        InvalidInput: for a number that is negative, or not half a whole one.
    """
    if not (np.ndim(s) == 0 and isinstance(s, int | float | np.integer | np.floating) and math.isfinite(s)):
        raise InvalidInput(f"`s` must be one number, 0, 1/2, 1, …; got {shown(s)}.")
    if s < 0 or 2.0 * s != round(2.0 * s):
        raise InvalidInput(f"`s` must be half a whole number, 0, 1/2, 1, …; got {shown(s)}.")
    return float(s) - np.arange(round(2.0 * s) + 1)


@known_numbers_only
def spherical_tensor(s: float, q: int) -> Float64[np.ndarray, "n diagonal"]:
    """Return the entries ⟨m+q|T_kq|m⟩ of all k = |q|, …, 2s as rows (2s+1−|q|, 2s+1−|q|), m falling along a row.

    tr T†T = 1, and T_kq transforms like Y_kq. Each row is an eigenvector of a symmetric tridiagonal matrix, so that
    nothing cancels or overflows at large k.

    Args:
        s: 0, 1/2, 1, …
        q: from 0 to 2s; T_{k,−q} = (−1)^q T_kq†.

    Raises:
        InvalidInput: for an s that is no spin, or a q out of range.
    """
    m = magnetic_numbers(s)
    if not (isinstance(q, int | np.integer) and 0 <= q <= len(m) - 1):
        raise InvalidInput(f"`q` must be a whole number from 0 to 2s = {len(m) - 1}; got {shown(q)}.")
    # T_kq are the eigenvectors of Σ_a [S_a, [S_a, T]] = k(k+1) T. On entries t_m = ⟨m+q|T|m⟩ the left side is 2s(s+1)
    # t_m − 2 ⟨m+q|S·T S|m⟩, of which S_z T S_z gives m(m+q) t_m, and S_± T S_∓ couple t_m to t_{m∓1}:
    # cut(m) = ⟨m+1|S_+|m⟩².
    m = m[q:]  # T raises m by q
    cut = lambda m: (s - m) * (s + m + 1.0)  # noqa: E731
    diagonal = 2.0 * s * (s + 1.0) - 2.0 * m * (m + q)
    beside = -np.sqrt(cut(m[1:] + q) * cut(m[1:]))
    if len(m) == 1:
        return np.array([[(-1.0) ** q]])
    from scipy.linalg import eigh_tridiagonal

    rows = eigh_tridiagonal(diagonal, beside)[1].T
    k = q + np.arange(len(m))
    return rows * ((-1.0) ** q * _signs(rows, k * (k + 1.0), diagonal, beside))[:, None]


def _signs(rows: Array, values: Array, diagonal: Array, beside: Array) -> Array:
    """Return the factors of eigenvectors with which their first entries are positive, even where these underflow.

    From the first entry the three-term recurrence grows, and so is stable, to where the entries are large; there it
    tells the sign.
    """
    place = np.argmax(np.abs(rows) > 1e-6 * np.abs(rows).max(axis=1, keepdims=True), axis=1)
    before, now = np.zeros(len(rows)), np.ones(len(rows))
    signs = np.sign(rows[:, 0])
    for i in range(int(place.max(initial=0))):
        # row i of (M − k(k+1)) t = 0, solved for its last entry
        after = ((values - diagonal[i]) * now - (beside[i - 1] * before if i else 0.0)) / beside[i]
        size = np.maximum(np.abs(after), np.abs(now))
        before, now = now / size, after / size
        here = place == i + 1
        signs[here] = np.sign(rows[here, i + 1]) * np.sign(now[here])
    return signs
