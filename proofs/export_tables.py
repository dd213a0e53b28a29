"""Write the structure constants and named Casimirs of polhode's algebras as tables that Rocq proves to be such.

    python proofs/export_tables.py            # writes Algebras.v, AlgebrasOfMatrices.v and AlgebrasComposed.v
    python proofs/export_tables.py --check    # says whether these files are what the code gives now

Floating-point constants become the fractions they stand for: one with a denominator above 10,000, or further than
1e-13 from the float, is refused. Where constants have denominators, the basis is stretched by their least common
multiple; the quantised sphere, whose harmonics have irrational norms, is given in the basis of harmonics whose
constants are rational (``stretches``). Casimirs are read off the code's own functions, by a fit at random points that
is checked at others.
"""

from __future__ import annotations

import math
import sys
from collections.abc import Callable
from fractions import Fraction
from itertools import combinations_with_replacement
from pathlib import Path

import numpy as np

from polhode import algebra as lie
from polhode import fields

Terms = dict[tuple[int, ...], Fraction]  # coefficients of products of coordinates, by their numbers
HERE = Path(__file__).resolve().parent
LARGEST_DENOMINATOR = 10_000
TOLERANCE = 1e-13  # of a constant, against its fraction
FIT = 1e-9  # of a Casimir's value, against that of the polynomial with fractions
HIGHEST_DEGREE = 4
WIDTH = 110

so3 = lie.SO3()
SL2_MATRICES = np.array([[[0, 1], [0, 0]], [[0, 0], [1, 0]], [[1, 0], [0, -1]]], float)
FILES: dict[str, dict[str, lie.AbstractLieAlgebra]] = {
    "Algebras": {
        "so3": so3, "se2": lie.SE2(), "se3": lie.SE3(), "affine_line": lie.AffineLine(),
        "heisenberg1": lie.Heisenberg(1), "heisenberg2": lie.Heisenberg(2),
        "bidiagonal3": fields.Bidiagonal(3), "bidiagonal4": fields.Bidiagonal(4),
    },
    "AlgebrasOfMatrices": {
        "so_2": lie.SO(2), "so_3": lie.SO(3), "so_4": lie.SO(4), "so_5": lie.SO(5), "so_2_1": lie.SOpq(2, 1),
        "so_3_1": lie.SOpq(3, 1), "su_2": lie.SU(2), "su_3": lie.SU(3), "u_1": lie.U(1), "u_2": lie.U(2),
        "sl_2": lie.SL(2), "sl_3": lie.SL(3), "sp_1": lie.Sp(1), "sp_2": lie.Sp(2),
        "sphere_2": fields.QuantizedSphere(2), "sphere_3": fields.QuantizedSphere(3),
    },
    "AlgebrasComposed": {
        "dual_numbers_su_2": lie.DualNumbers(lie.SU(2)), "power_of_so3": lie.Power(so3, 3),
        "weighted_power_of_so3": lie.Power(so3, 3, (1.0, -2.0, 0.5)),
        "product": lie.Product(so3, lie.SU(2), lie.AffineLine()),
        "so3_on_space": lie.Semidirect(so3, so3.structure_constants().transpose(0, 2, 1)),
        "sl2_on_plane": lie.Semidirect(lie.SL(2), np.asarray(lie.SL(2).basis)),
        "own_constants": lie.from_structure_constants(lie.SL(3).structure_constants()),
        "own_matrices": lie.from_matrices(SL2_MATRICES),
    },
}  # fmt: skip
HEADER = """(** * {title}

    Written by [export_tables.py] from [polhode.algebra]; a test compares the two.  [_brackets] are the structure
    constants in the basis of the class, [_casimir1] and so on its named Casimirs, where these are polynomials. *)
From Coq Require Import ZArith.
From mathcomp Require Import all_ssreflect.
From Polhode Require Import Tables.
Local Open Scope Z_scope.
"""
TITLES = {"Algebras": "Algebras of bodies, waves and chains", "AlgebrasOfMatrices": "Algebras of matrices",
          "AlgebrasComposed": "Algebras made of others, and a user's own"}  # fmt: skip


def fraction(value: float) -> Fraction:
    """Return the simple fraction that a float stands for.

    Raises:
        ValueError: if there is none with a denominator up to 10,000 within rounding.
    """
    exact = Fraction(value).limit_denominator(LARGEST_DENOMINATOR)
    if abs(float(exact) - value) > TOLERANCE * max(1.0, abs(value)):
        raise ValueError(f"a structure constant must be rational; got {value!r}. Stretch the basis in `stretches`.")
    return exact


def stretches(algebra: lie.AbstractLieAlgebra) -> np.ndarray:
    """Return factors (dim,) by which basis elements are multiplied so that the constants become rational.

    Orthonormal spherical harmonics are solid harmonics with rational coefficients, times the root of
    (2l+1) (2−δ_m0) (l−m)!/(l+m)!; their matrices for spin (N−1)/2 have squared norms ∝ ∏_{k≤l} (N²−k²) beside that.
    """
    if not isinstance(algebra, fields.QuantizedSphere):
        return np.ones(algebra.dim)
    n = algebra.n
    factors = []
    for degree in range(1, n):
        size = math.prod(n**2 - k**2 for k in range(1, degree + 1))
        for m in [0, *(k for k in range(1, degree + 1) for _ in "cs")]:
            norm = (2 * degree + 1) * (2 - (m == 0)) * math.factorial(degree - m) / math.factorial(degree + m)
            factors.append(math.sqrt(size / norm))
    found = _stretched(algebra, np.array(factors))
    return np.array(factors) / abs(found[np.abs(found) > 1e-12][0])


def _stretched(algebra: lie.AbstractLieAlgebra, factors: np.ndarray) -> np.ndarray:
    return np.einsum("ijk,i,j,k->ijk", np.asarray(algebra.structure_constants()), factors, factors, 1.0 / factors)


def integer_constants(algebra: lie.AbstractLieAlgebra) -> list[tuple[int, int, int, int]]:
    """Return rows (i, j, k, c) with [e_i, e_j] = Σ_k c e_k, in a basis stretched until all are whole numbers."""
    constants = _stretched(algebra, stretches(algebra))
    exact = {tuple(map(int, place)): fraction(float(constants[tuple(place)]))
             for place in np.argwhere(np.abs(constants) > 1e-12)}  # fmt: skip
    common = math.lcm(1, *(c.denominator for c in exact.values()))
    return [(*place, int(c * common)) for place, c in sorted(exact.items())]


def polynomial(function: Callable[[np.ndarray], np.ndarray], dim: int) -> Terms | None:
    """Return the polynomial, homogeneous up to degree 4, that a function of points (count, dim) is; None if it is none.

    Coefficients are fractions, up to a factor that makes the first one 1 where they are not as they stand.
    """
    random = np.random.default_rng(0)
    points = random.normal(size=(2, dim))
    ratio = np.asarray(function(2.0 * points)) / np.asarray(function(points))
    degree = round(float(np.log2(np.abs(ratio[0])))) if np.isfinite(ratio).all() and ratio[0] else 0
    if not 1 <= degree <= HIGHEST_DEGREE or not np.allclose(ratio, 2.0**degree):
        return None
    products = list(combinations_with_replacement(range(dim), degree))
    points = random.normal(size=(2 * len(products) + 10, dim))
    columns = np.stack([points[:, list(p)].prod(axis=1) for p in products], axis=1)
    values = np.asarray(function(points))
    found = np.linalg.lstsq(columns, values, rcond=None)[0]
    found[np.abs(found) < 1e-9 * np.abs(found).max()] = 0.0
    for scale in (1.0, float(found[np.flatnonzero(found)[0]])):
        exact = [Fraction(c / scale).limit_denominator(LARGEST_DENOMINATOR) for c in found]
        others = random.normal(size=(20, dim))
        there = np.stack([others[:, list(p)].prod(axis=1) for p in products], axis=1) @ np.array(exact, float)
        wanted = np.asarray(function(others)) / scale
        if np.abs(there - wanted).max() < FIT * np.abs(wanted).max():
            return {p: c for p, c in zip(products, exact, strict=True) if c}
    return None


def casimir_polynomials(algebra: lie.AbstractLieAlgebra) -> dict[str, Terms]:
    """Return the named Casimirs that are polynomials up to degree 4, in the stretched basis."""
    factors = stretches(algebra)

    def values(points: np.ndarray) -> np.ndarray:
        return np.asarray(algebra.casimirs(algebra.from_dual_vector(np.asarray(points) / factors)))

    found = {name: polynomial(lambda points, k=k: values(points)[..., k], algebra.dim)
             for k, name in enumerate(algebra.casimir_names)}  # fmt: skip
    return {name: terms for name, terms in found.items() if terms is not None}


def _lines(items: list[str]) -> str:
    """Return items of a list, as many on a line as there is room for."""
    lines = ["  "]
    for n, item in enumerate(items):
        text = item + ("; " if n < len(items) - 1 else "].")
        if len(lines[-1]) + len(text.rstrip()) > WIDTH:
            lines.append("  ")
        lines[-1] += text
    return "\n".join(line.rstrip() for line in lines)


def algebra_text(name: str, algebra: lie.AbstractLieAlgebra) -> str:
    """Return the definitions and theorems about one algebra."""
    n, rows = algebra.dim, integer_constants(algebra)
    title = f"{type(algebra).__name__}: {algebra.name}"
    text = f"\n(** ** {title}, dimension {n} *)\n\nDefinition {name}_brackets : brackets := [::\n"
    text += _lines([f"({', '.join(map(str, row))})" for row in rows] or [""]) + "\n\n"
    text += f"Definition {name} := dense {n} {name}_brackets.\n\n"
    text += f"Theorem {name}_is_lie : lie_algebra {n} {name}.\nProof. by apply: table_is_lie; vm_compute. Qed.\n"
    for number, (title, terms) in enumerate(casimir_polynomials(algebra).items(), start=1):
        common = math.lcm(*(c.denominator for c in terms.values()))
        written = [f"([:: {'; '.join(map(str, p))}], {int(c * common)})" for p, c in terms.items()]
        times = ", up to a factor" if common > 1 or isinstance(algebra, fields.QuantizedSphere) else ""
        text += f"\n(* {title}{times} *)\nDefinition {name}_casimir{number} : written_polynomial := [::\n"
        text += _lines(written) + "\n\n"
        text += f"Theorem {name}_casimir{number}_commutes : casimir {n} {name} {name}_casimir{number}.\n"
        text += "Proof. by apply: table_casimir; vm_compute. Qed.\n"
    return text


def file_texts() -> dict[str, str]:
    """Return the texts of the files by name."""
    return {f"{file}.v": HEADER.format(title=TITLES[file]) + "".join(algebra_text(*item) for item in algebras.items())
            for file, algebras in FILES.items()}  # fmt: skip


def main(arguments: list[str]) -> int:
    different = []
    for file, text in file_texts().items():
        path = HERE / file
        if not path.exists() or path.read_text(encoding="utf-8") != text:
            different.append(file)
            if "--check" not in arguments:
                path.write_text(text, encoding="utf-8")
    if "--check" not in arguments:
        print("written:", ", ".join(different) or "nothing, all files were up to date")
        return 0
    print(f"not what the code gives: {', '.join(different)}" if different else "all files are what the code gives")
    return int(bool(different))


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
