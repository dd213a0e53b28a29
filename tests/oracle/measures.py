"""How far float64 answers are from the oracle and from the conservation laws, in units of eps = 2^-52.

Floats are taken as the exact numbers they are. The rotation matrix is formed from the quaternion without
normalising it, so that a wrong length counts as an error.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from functools import lru_cache
from typing import NamedTuple

from flint import arb, ctx

from oracle.reference import Reference, reference_state
from twins.families_of_bodies import Case

EPS = 2.0**-52
WORKING_BITS = 192
Matrix = list[list[arb]]


class Errors(NamedTuple):
    """Largest error of an entry of the attitude, matrix and signed quaternion, and of an entry of L/|L|, in eps."""

    attitude: float
    momentum: float


class Drifts(NamedTuple):
    """Departures from the conservation laws, in eps.

    ``energy`` is |E - E0| / (|Ω| |L|) with the larger |Ω| of the two times, since dE = Ω·dL: relative to E it could not
    be kept where one moment is far smaller than the others. ``norm`` is relative, ``space_momentum`` is
    |R L - L0| / |L|, ``orthogonality`` the largest entry of R Rᵀ - 1.
    """

    energy: float
    norm: float
    space_momentum: float
    orthogonality: float


@lru_cache(maxsize=50_000)
def _reference(case: Case) -> Reference:
    return reference_state(case.moments, case.momentum, case.time)


def error_in_eps(attitude: Sequence[float], momentum: Sequence[float], case: Case) -> Errors:
    """Return the errors of one answer for ``case``, whose attitude at time 0 is the identity."""
    reference = _reference(case)
    with ctx.workprec(WORKING_BITS):
        rotation, norm = rotation_of(attitude), _norm(case.momentum)
        entries = [rotation[i][j] - reference.rotation[i][j] for i in range(3) for j in range(3)]
        entries += [arb(float(x)) - y for x, y in zip(attitude, reference.quaternion, strict=True)]
        directions = (arb(float(x)) / norm - n for x, n in zip(momentum, reference.direction, strict=True))
        return Errors(_largest(entries), _largest(directions))


def drift_in_eps(attitude: Sequence[float], momentum: Sequence[float], case: Case) -> Drifts:
    """Return how well one answer for ``case`` keeps energy, |L|, space momentum R L and orthogonality."""
    with ctx.workprec(WORKING_BITS):
        rotation, norm = rotation_of(attitude), _norm(case.momentum)
        now, start = [arb(float(x)) for x in momentum], [arb(x) for x in case.momentum]
        moments = [arb(x) for x in case.moments]
        energy_change = sum(((a - b) * (a + b) / i for a, b, i in zip(now, start, moments, strict=True)), arb(0)) / 2
        spin = arb.max(*(_norm([x / i for x, i in zip(vector, moments, strict=True)]) for vector in (start, now)))
        space = [sum((r * x for r, x in zip(row, now, strict=True)), arb(0)) for row in rotation]
        product = (
            sum((a * b for a, b in zip(rotation[i], rotation[j], strict=True)), arb(-int(i == j)))
            for i in range(3) for j in range(3)
        )  # fmt: skip
        return Drifts(
            _largest([energy_change / (spin * norm)]),
            _largest([_norm(now) / norm - 1]),
            _largest((a - b) / norm for a, b in zip(space, start, strict=True)),
            _largest(product),
        )


def rotation_of(quaternion: Sequence[float | arb]) -> Matrix:
    """Matrix of a quaternion wxyz, homogeneous of degree two: scaled by the square of the quaternion's length."""
    w, x, y, z = (value if isinstance(value, arb) else arb(float(value)) for value in quaternion)
    return [
        [w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z],
    ]


def _norm(vector: Iterable[float | arb]) -> arb:
    return sum((arb(x) ** 2 for x in vector), arb(0)).sqrt()


def _largest(differences: Iterable[arb]) -> float:
    """Largest magnitude in eps; NaN and infinities count as infinite."""
    sizes = [float(abs(x)) / EPS for x in differences]
    return max(size if size == size else float("inf") for size in sizes)
