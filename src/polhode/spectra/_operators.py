"""The rotational Hamiltonian of Watson as a list of terms in |J, K⟩: rigid rotor and centrifugal distortion.

A term is a number times ½ [J^{2m} J_z^{2n}, J₊^{2q} + J₋^{2q}]₊, or J^{2m} J_z^{2n} for q = 0. J₊ = J_x + i J_y raises
K, with phases in which ⟨K+2|H|K⟩ of the rigid rotor is ¼ (X − Y) f > 0 for X > Y. Which of the principal axes a, b, c
is z, x, y is the representation. Source: Watson, in *Vibrational Spectra and Structure* 6 (1977) 1; Pickett, J. Mol.
Spectrosc. 148 (1991) 371.
"""

from __future__ import annotations

import enum
from collections.abc import Mapping
from typing import NamedTuple

import numpy as np

from polhode._base import check
from polhode.errors import InvalidInput
from polhode.types import Array, Float64


class Representation(enum.Enum):
    """Which principal axes x, y and z are."""

    Ir = "bca"
    Il = "cba"
    IIr = "cab"
    IIl = "acb"
    IIIr = "abc"
    IIIl = "bac"


class Reduction(enum.Enum):
    """Watson's reduction of the distortion: A (asymmetric) or S (symmetric)."""

    A = "A"
    S = "S"


class Term(NamedTuple):
    """A constant's operator: its sign, and the powers of J², of J_z² and of J±²."""

    sign: float
    of_J: int
    of_Jz: int
    of_ladder: int = 0


_DIAGONAL = {
    "J": (2, 0), "JK": (1, 1), "K": (0, 2),
}  # fmt: skip
_SEXTIC = {"J": (3, 0), "JK": (2, 1), "KJ": (1, 2), "K": (0, 3)}
_OCTIC = {"J": (4, 0), "JJK": (3, 1), "JK": (2, 2), "KKJ": (1, 3), "K": (0, 4)}
_OCTIC_TERMS = {f"L_{k}": Term(1.0, *v) for k, v in _OCTIC.items()}
TERMS: dict[Reduction, dict[str, Term]] = {
    Reduction.A: {f"Delta_{k}": Term(-1.0, *v) for k, v in _DIAGONAL.items()}
    | {"delta_J": Term(-1.0, 1, 0, 1), "delta_K": Term(-1.0, 0, 1, 1)}
    | {f"Phi_{k}": Term(1.0, *v) for k, v in _SEXTIC.items()}
    | {"phi_J": Term(1.0, 2, 0, 1), "phi_JK": Term(1.0, 1, 1, 1), "phi_K": Term(1.0, 0, 2, 1)}
    | _OCTIC_TERMS
    | {"l_J": Term(1.0, 3, 0, 1), "l_JK": Term(1.0, 2, 1, 1), "l_KJ": Term(1.0, 1, 2, 1), "l_K": Term(1.0, 0, 3, 1)},
    Reduction.S: {f"D_{k}": Term(-1.0, *v) for k, v in _DIAGONAL.items()}
    | {"d1": Term(1.0, 1, 0, 1), "d2": Term(1.0, 0, 0, 2)}
    | {f"H_{k}": Term(1.0, *v) for k, v in _SEXTIC.items()}
    | {"h1": Term(1.0, 2, 0, 1), "h2": Term(1.0, 1, 0, 2), "h3": Term(1.0, 0, 0, 3)}
    | _OCTIC_TERMS
    | {"l1": Term(1.0, 3, 0, 1), "l2": Term(1.0, 2, 0, 2), "l3": Term(1.0, 1, 0, 3), "l4": Term(1.0, 0, 0, 4)},
}  # fmt: skip
"""Constants by reduction and name. H = Σ sign · constant · operator."""


def rigid_terms(constants: tuple[float, float, float], representation: Representation) -> list[tuple[float, Term]]:
    """Return H = ½(X+Y) J² + (Z − ½(X+Y)) J_z² + ¼(X−Y) (J₊² + J₋²) from A, B, C."""
    by_axis = dict(zip("abc", constants, strict=True))
    X, Y, Z = (by_axis[axis] for axis in representation.value)
    # X J_x² + Y J_y² = ½(X+Y)(J² − J_z²) + ½(X−Y)(J_x² − J_y²), and J_x² − J_y² = ½(J₊² + J₋²)
    half = 0.5 * (X + Y)
    return [(half, Term(1.0, 1, 0)), (Z - half, Term(1.0, 0, 1)), (0.25 * (X - Y), Term(1.0, 0, 0, 1))]


def distortion_terms(
    distortion: Mapping[str, float], reduction: Reduction | None, representation: Representation | None
) -> list[tuple[float, Term]]:
    """Return the terms of distortion constants.

    Raises:
        InvalidInput: for constants without a reduction and a representation, names that the reduction does not have, or
            values that are not finite.
    """
    if not distortion:
        return []
    if reduction is None or representation is None:
        raise InvalidInput(
            "`distortion` must come with its `reduction`, 'A' or 'S', and `representation`, such as 'Ir': the same "
            "numbers mean another molecule in another one. The source of the constants has them."
        )
    known = TERMS[reduction]
    for name in distortion:
        if name not in known:
            rule = f"names of constants of the {reduction.value} reduction, {', '.join(known)}"
            check.refuse("distortion", rule, name)
    return [(check.number(f"distortion[{name}]", value, "Hz"), known[name]) for name, value in distortion.items()]


def matrix_elements(
    terms: list[tuple[float, Term]], J: float, K: Float64[Array, "k"], step: int
) -> Float64[Array, "k"]:
    """Return ⟨J, K + 2 step| H |J, K⟩ (k,) of a list of terms.

    Args:
        terms: numbers and operators.
        J: of the block.
        K: (k,).
        step: how often K rises by two, from 0.
    """
    j, above = J * (J + 1.0), K + 2.0 * step
    total = np.zeros_like(K)
    for value, term in terms:
        if term.of_ladder != step:
            continue
        # the anticommutator: J_z acts before J₊^2q, on K, and after it, on K + 2q
        power = K ** (2 * term.of_Jz) if step == 0 else 0.5 * (K ** (2 * term.of_Jz) + above ** (2 * term.of_Jz))
        total = total + (term.sign * value * j**term.of_J) * power
    return total * ladder(J, K, step)


def ladder(J: float, K: Float64[Array, "k"], step: int) -> Float64[Array, "k"]:
    """Return ⟨K + 2 step| J₊^{2 step} |K⟩ (k,), zero where K leaves −J to J."""
    # ⟨K+1|J₊|K⟩² = (J − K)(J + K + 1), multiplied step by step
    product = np.ones_like(K)
    for n in range(2 * step):
        # each factor as a product, which is exactly zero at the end
        product = product * np.maximum((J - (K + n)) * (J + (K + n) + 1.0), 0.0)
    return np.sqrt(product)
