"""Quaternions wxyz of balls or rationals: products and rotations."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from polhode.analysis._exact_arithmetic import Ball, Rational, total


def multiply(p: Sequence[Any], q: Sequence[Any]) -> list[Any]:
    """Return pq by Hamilton's rule."""
    a, b, c, d = p
    w, x, y, z = q
    return [a * w - b * x - c * y - d * z, a * x + b * w + c * z - d * y,
            a * y - b * z + c * w + d * x, a * z + b * y - c * x + d * w]  # fmt: skip


def conjugate(q: Sequence[Any]) -> list[Any]:
    """Return the conjugate."""
    w, x, y, z = q
    return [w, -x, -y, -z]


def square_of(q: Sequence[Rational]) -> Rational:
    """Return |q|²."""
    return total(x * x for x in q)


def as_matrix(q: Sequence[Any]) -> list[list[Any]]:
    """Return the matrix by rows of a quaternion, times |q|²."""
    w, x, y, z = q
    return [
        [w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z],
    ]


def turn_vector(q: Sequence[Rational], vector: Sequence[Ball]) -> list[Ball]:
    """Return a vector of balls rotated by q/|q|, whose matrix is rational."""
    from flint import arb

    square = square_of(q)
    rows = [[arb(x / square) for x in row] for row in as_matrix(q)]
    return [total(a * x for a, x in zip(row, vector, strict=True)) for row in rows]
