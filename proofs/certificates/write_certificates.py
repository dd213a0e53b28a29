"""Write the certificates in this folder: `python proofs/certificates/write_certificates.py`.

Each is what `polhode.proving.write_proof` writes of
`ph.stability(system, point).certificate.as_rational("decimal")`. A test compares them with these files.
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np

import polhode as ph
from polhode.certificates.rational import RationalCertificate
from polhode.proving.verdicts.rocq import THEORY, proof_text, theory

FOLDER = Path(__file__).parent
BODY = ph.systems.FreeRigidBody((1.0, 2.0, 3.0))
TOP = ph.systems.HeavyTop((1.0, 2.0, 3.0), 1.0)
LAGRANGE = ph.systems.HeavyTop((1.0, 1.0, 0.5), 1.0)
HULL = ph.systems.Kirchhoff((1.0, 2.0, 4.0, 4.0, 2.0, 1.0))
FOUR = ph.systems.Manakov((1.0, 2.0, 3.0, 4.0))


def plane(*turns: tuple[int, int, float]) -> np.ndarray:
    """Return a rotation of so(4) in coordinate planes."""
    m = np.zeros((4, 4))
    for i, j, value in turns:
        m[i, j], m[j, i] = value, -value
    return m


def hyperbolic(weight: float) -> ph.systems.LiePoisson:
    """Return a quadratic energy on so(2, 1), given by structure constants: [a, b] = c, [b, c] = a, [c, a] = −b."""
    c = np.zeros((3, 3, 3))
    for i, j, k, value in ((0, 1, 2, 1.0), (1, 2, 0, 1.0), (2, 0, 1, -1.0)):
        c[i, j, k], c[j, i, k] = value, -value
    algebra = ph.algebra.from_structure_constants(c)
    return ph.systems.LiePoisson(algebra, lambda m: 0.5 * (m[0] ** 2 + weight * m[1] ** 2 + 3.0 * m[2] ** 2))


CASES = {
    "free_axis_1": (BODY, [1.0, 0.0, 0.0]),
    "free_axis_2": (BODY, [0.0, 1.0, 0.0]),
    "free_axis_3": (BODY, [0.0, 0.0, 1.0]),
    "free_equator": (ph.systems.FreeRigidBody((1.0, 1.0, 2.0)), [1.0, 0.0, 0.0]),
    "sphere": (ph.systems.FreeRigidBody((1.0, 1.0, 1.0)), [0.0, 0.3, 1.5]),
    "top_upright": (TOP, [0.0, 0.0, 12.0, 0.0, 0.0, 1.0]),
    "top_upright_slow": (TOP, [0.0, 0.0, 0.5, 0.0, 0.0, 1.0]),
    "top_hanging": (TOP, [0.0, 0.0, 1.0, 0.0, 0.0, -1.0]),
    "top_sleeping": (LAGRANGE, [0.0, 0.0, 2.5, 0.0, 0.0, 1.0]),
    "top_falling": (LAGRANGE, [0.0, 0.0, 1.5, 0.0, 0.0, 1.0]),
    "gyrostat": (ph.systems.Gyrostat((1.0, 2.0, 3.0), (0.0, 2.0, 0.0)), [0.0, 1.0, 0.0]),
    "gyrostat_slow": (ph.systems.Gyrostat((1.0, 2.0, 3.0), (0.0, 0.25, 0.0)), [0.0, 1.0, 0.0]),
    "hull_broadside": (HULL, [0.0, 0.0, 0.0, 1.0, 0.0, 0.0]),
    "hull_spinning": (HULL, [0.0, 0.0, 4.0, 0.0, 0.0, 0.5]),
    "hull_lengthwise": (HULL, [0.0, 0.0, 0.0, 0.0, 0.0, 1.0]),
    "so4_two_planes": (FOUR, plane((0, 1, 1.0), (2, 3, 0.3))),
    "so4_one_plane": (FOUR, plane((0, 2, 1.0))),
    "top_on_leaf": (TOP, [0.0, 0.0, 1.0, 0.0, 0.0, 0.0]),
    "top_precessing": (LAGRANGE, [1.2, 0.0, 2.1, 0.6, 0.0, 0.8], [lambda point: point[2]]),
    "symmetric_body": (ph.systems.FreeRigidBody((1.0, 1.0, 2.0)), [0.6, 0.0, 0.8], [lambda L: L[2]]),
    "own_unstable": (hyperbolic(-2.0), [0.0, 0.0, 1.0]),
    "own_stable": (hyperbolic(4.0), [0.0, 1.0, 0.0]),
}


def certificates(names: list[str] | None = None) -> dict[str, RationalCertificate]:
    """Return the certificates by name, computed anew."""
    wanted = {name: CASES[name] for name in names or CASES}
    return {name: ph.stability(system, np.array(point), *integrals).certificate.as_rational("decimal")
            for name, (system, point, *integrals) in wanted.items()}  # fmt: skip


def texts(names: list[str] | None = None) -> dict[str, str]:
    """Return what the files must hold, by file."""
    return {THEORY: theory()} | {f"{name}.v": proof_text(c, name) for name, c in certificates(names).items()}


if __name__ == "__main__":
    for file, text in texts(sys.argv[1:]).items():
        (FOLDER / file).write_text(text, "utf-8")
        print(file)
