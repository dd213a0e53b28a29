"""Derivatives of a Lagrange top that sleeps, hangs or rests: its linear equations in body axes, by matrix exponential.

δL' = δL × Ω + L × δΩ + mgl δΓ × e3 + δmgl Γ × e3 and ξ' = ξ × Ω + δΩ, with δR = R hat(ξ) and δΓ = Γ × ξ, have
constant coefficients there. Nothing is shared with Cayley–Klein parameters. Source: Whittaker, *Analytical Dynamics*,
ch. VI–VII.
"""

from __future__ import annotations

import mpmath as mp
import numpy as np

from twins.families_of_tops import TopCase

DIGITS = 60


def standing_jacobian(case: TopCase) -> np.ndarray:
    """Return (11, 7): changes of quaternion and momentum by I1, I3, mgl, momentum (3), attitude (4) and time."""
    I1, I3 = (mp.mpf(case.moments[k]) for k in (0, 2))
    growth = abs(case.time) * (abs(case.mgl / case.moments[0]) ** 0.5 + abs(case.momentum[2]) / min(case.moments))
    with mp.workdps(DIGITS + int(np.log10(1.0 + growth)) + int(min(growth, 800.0))):
        q0 = mp.matrix([mp.mpf(x) for x in case.attitude])
        size = mp.norm(q0)
        q0 = q0 / size
        spin = mp.mpf(case.momentum[2]) / I3
        e3, omega = mp.matrix([0, 0, 1]), mp.matrix([0, 0, spin])
        momentum = mp.matrix([mp.mpf(x) for x in case.momentum])
        vertical = _rotate(_conjugate(q0), e3)
        to_omega = mp.zeros(3, 9)
        for k, moment in enumerate((I1, I1, I3)):
            to_omega[k, k] = 1 / moment
        to_omega[2, 7] = -spin / I3
        step = mp.zeros(9)
        pull = mp.mpf(case.mgl)
        for j in range(9):
            unit = [mp.mpf(int(i == j)) for i in range(9)]
            dL, xi = mp.matrix(unit[:3]), mp.matrix(unit[3:6])
            turn = to_omega[:, j]
            d_momentum = _cross(dL, omega) + _cross(momentum, turn) + pull * _cross(_cross(vertical, xi), e3)
            d_momentum += unit[8] * _cross(vertical, e3)
            d_xi = _cross(xi, omega) + turn
            for i in range(3):
                step[i, j], step[3 + i, j] = d_momentum[i], d_xi[i]
        later = mp.expm(step * mp.mpf(case.time))
        half = spin * mp.mpf(case.time) / 2
        q = _product(q0, mp.matrix([mp.cos(half), 0, 0, mp.sin(half)]))
        rows = []
        for k in range(11):
            start = mp.zeros(9, 1)
            if k < 3:
                start[6 + k] = 1
            elif k < 6:
                start[k - 3] = 1
            elif k < 10:
                unit = mp.matrix([int(i == k - 6) for i in range(4)])
                turn = _product(_conjugate(q0), (unit - q0 * q0[k - 6]) / size)
                for i in range(3):
                    start[3 + i] = 2 * turn[1 + i]
            end = later * start
            xi = mp.matrix([end[3], end[4], end[5]]) + (omega if k == 10 else 0 * omega)
            change = _product(q, mp.matrix([0, xi[0] / 2, xi[1] / 2, xi[2] / 2]))
            rows.append([float(x) for x in (*change, end[0], end[1], end[2])])
        return np.array(rows)


def _cross(x: mp.matrix, y: mp.matrix) -> mp.matrix:
    return mp.matrix([x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]])


def _product(p: mp.matrix, q: mp.matrix) -> mp.matrix:
    a, b, c, d = p
    w, x, y, z = q
    return mp.matrix([a * w - b * x - c * y - d * z, a * x + b * w + c * z - d * y,
                      a * y - b * z + c * w + d * x, a * z + b * y - c * x + d * w])  # fmt: skip


def _conjugate(q: mp.matrix) -> mp.matrix:
    return mp.matrix([q[0], -q[1], -q[2], -q[3]])


def _rotate(q: mp.matrix, v: mp.matrix) -> mp.matrix:
    return _product(_product(q, mp.matrix([0, *v])), _conjugate(q))[1:4]
