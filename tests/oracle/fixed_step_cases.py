"""Fixed-step cases in single precision with full inertias: their exact states, thresholds, and how they are written.

What is given are numbers of float32, taken as exact. The principal frame of the rounded tensor is found to 80 digits,
and the oracle in ball arithmetic moves the body along its principal axes.
"""

from __future__ import annotations

import json
from math import ceil, log10
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from flint import arb, ctx, fmpq
from mpmath import mp

import polhode
from judging.simulated_engines import cross, rk4, semi_implicit
from judging.simulated_engines import midpoint as midpoint_method
from oracle.reference import exact, reference_state
from oracle.reference_table import product, quaternion_of

ROOT = Path(polhode.__file__).parents[2]
TABLE, HEADER = ROOT / "src" / "polhode" / "judging" / "fixed_step_cases.json", ROOT / "reference" / "polhode_cases.h"
FORMAT, VERSION = "polhode fixed-step cases", 1
STEPS = (1, 16, 128, 640)
DIGITS = 80
WORK = 600  # bits
METHODS = {"order_1": semi_implicit, "order_2": midpoint_method, "order_4": rk4}
MARGIN = 2.0  # on what the method of that order, written plainly in float32, is off by
LOST = 1.0  # rad; no threshold is above: what is off by more is lost
GIVEN = {
    "box about no axis": ((1.0, 2.0, 2.5), (0.9, 0.3, -0.2, 0.1), (0.8, -0.5, 0.6)),
    "box near its middle axis": ((1.0, 2.0, 2.5), (0.7, -0.3, 0.4, 0.5), (0.02, 1.5, 0.01)),
    "box near its axis of least moment": ((1.0, 2.0, 2.5), (0.2, 0.6, -0.5, 0.4), (1.5, 0.05, 0.02)),
    "box near its axis of largest moment": ((1.0, 2.0, 2.5), (0.4, 0.1, 0.8, -0.3), (0.03, 0.05, 1.2)),
    "rod": ((0.1, 2.0, 2.02), (0.8, 0.2, 0.5, -0.1), (2.0, 0.7, 0.3)),
    "plate": ((1.0, 1.4, 2.39), (0.3, 0.7, 0.2, 0.6), (0.5, 0.9, -0.7)),
    "nearly a ball": ((1.0, 1.01, 1.02), (0.6, -0.6, 0.1, 0.5), (1.0, 1.0, 1.0)),
    "symmetric, long": ((0.5, 2.0, 2.0), (0.9, -0.1, 0.4, 0.2), (1.5, 0.4, 0.2)),
    "symmetric, flat": ((1.2, 1.2, 2.2), (0.5, 0.5, -0.6, 0.3), (0.3, -0.4, 1.5)),
    "small and fast": ((1e-4, 2.2e-4, 3e-4), (0.1, 0.9, 0.2, -0.4), (6.0, -4.0, 5.0)),
    "large and slow": ((4e5, 7e5, 9e5), (0.8, -0.4, -0.3, 0.3), (0.1, 0.12, -0.08)),
    "T-handle that flips": ((0.0232, 0.0349, 0.0377), (0.3, -0.2, 0.9, 0.25), (0.05, 7.0, -0.04)),
}
"""Principal moments, the quaternion of the principal axes, and the angular velocity along them, before rounding."""


class FixedStepCase(NamedTuple):
    """One case before its states are known: numbers of float32, all along the body's axes."""

    name: str
    inertia: np.ndarray
    attitude: np.ndarray
    angular_velocity: np.ndarray
    dt: float


def cases() -> list[FixedStepCase]:
    found = []
    for k, (name, (moments, axes, spin)) in enumerate(GIVEN.items()):
        axes = np.array(axes) / np.linalg.norm(axes)
        A = polhode.rotation.as_matrix(axes)
        tensor = (A @ np.diag(moments) @ A.T).astype(np.float32)
        tensor = np.triu(tensor) + np.triu(tensor, 1).T
        start = np.array([(1.0, 0.0, 0.0, 0.0), (0.5, -0.5, 0.5, 0.5), (0.5, 0.5, 0.5, -0.5)][k % 3], np.float32)
        rate = (A @ spin).astype(np.float32)
        dt = 2.0 ** -ceil(np.log2(60.0 * np.linalg.norm(spin) / 1.2))  # a power of two: exact, and 1.2 rad/s at 60 Hz
        found.append(FixedStepCase(name, tensor, start, rate, float(dt)))
    return found


def principal_frame(tensor: np.ndarray) -> tuple[list[fmpq], list[list[fmpq]]]:
    """Return moments and axes, by columns and right-handed, of a tensor of doubles, rounded to 80 digits."""
    with mp.workdps(DIGITS):
        values, vectors = mp.eigsy(mp.matrix([[mp.mpf(float(x)) for x in row] for row in tensor]))
        if mp.det(vectors) < 0:
            vectors[:, 2] = -vectors[:, 2]
        return [_rational(x) for x in values], [[_rational(vectors[i, j]) for j in range(3)] for i in range(3)]


def _rational(value: Any) -> fmpq:
    sign, mantissa, exponent, _ = value._mpf_
    size = fmpq(int(mantissa)) * fmpq(2) ** int(exponent)
    return -size if sign else size


def states_of(case: FixedStepCase, steps: int, oracle: Any = reference_state) -> tuple[list[arb], list[arb]]:
    """Return attitude wxyz, up to its sign, and momentum along the body's axes after so many steps."""
    moments, A = principal_frame(case.inertia)
    tensor = [[exact(x) for x in row] for row in case.inertia]
    L = [sum((tensor[i][j] * exact(case.angular_velocity[j]) for j in range(3)), fmpq(0)) for i in range(3)]
    started = [sum((A[i][k] * L[i] for i in range(3)), fmpq(0)) for k in range(3)]
    with ctx.workprec(WORK):
        found = oracle(moments, started, exact(case.dt) * steps)
        turn, direction = found.rotation, found.direction
        size = arb(sum((x * x for x in L), fmpq(0))).sqrt()
        R = [[sum((A[i][a] * turn[a][b] * A[j][b] for a in range(3) for b in range(3)), arb(0)) for j in range(3)]
             for i in range(3)]  # fmt: skip
        q = product([arb(exact(x)) for x in case.attitude], quaternion_of(R))
        length = arb(sum((exact(x) ** 2 for x in case.attitude), fmpq(0))).sqrt()
        along = [sum((A[i][k] * direction[k] for k in range(3)), arb(0)) for i in range(3)]
        return [x / length for x in q], [size * x for x in along]


def thresholds(case: FixedStepCase, attitudes: np.ndarray, momenta: np.ndarray) -> dict[str, dict[str, list[float]]]:
    """Return, for each order, twice the errors of a plain method of it in float32."""
    inverse, f = np.linalg.inv(case.inertia.astype(float)).astype(np.float32), np.float32

    def slopes(q: Any, L: Any) -> Any:
        w = inverse @ L
        a, b, c, d = q
        x, y, z = w / f(2)
        turn = np.array([-b * x - c * y - d * z, a * x + c * z - d * y, a * y + d * x - b * z, a * z + b * y - c * x])
        return turn, cross(L, w)

    found = {}
    for order, method in METHODS.items():
        step, q, L = method(slopes), case.attitude, case.inertia @ case.angular_velocity
        angles, lengths = [], []
        for k in range(1, STEPS[-1] + 1):
            q, L = step(q, L, f(case.dt))
            if k in STEPS:
                n = STEPS.index(k)
                angles.append(float(polhode.rotation.angle_between(np.asarray(q, float), attitudes[n])))
                lengths.append(float(np.linalg.norm(np.asarray(L, float) - momenta[n]) / np.linalg.norm(momenta[n])))
        found[order] = {"attitude": [_up(x) for x in angles], "momentum": [_up(x) for x in lengths]}
    return found


def _up(error: float) -> float:
    """Return twice an error, rounded up to two digits, no less than some units of float32 and no more than LOST."""
    wide = min(LOST, max(MARGIN * error, 16.0 * float(np.finfo(np.float32).eps)))
    unit = 10.0 ** (int(np.floor(log10(wide))) - 1)
    return float(f"{ceil(wide / unit * (1 - 1e-12)) * unit:.1e}")


def as_dict(case: FixedStepCase) -> dict[str, Any]:
    """Return a case as JSON has it."""
    exactly = [states_of(case, n) for n in STEPS]
    attitudes, momenta = (np.array([[float(x.mid()) for x in state[part]] for state in exactly]) for part in (0, 1))
    lead = np.take_along_axis(attitudes, np.abs(attitudes).argmax(axis=1, keepdims=True), axis=1)
    attitudes = attitudes * np.sign(lead)
    given = {key: getattr(case, key).astype(float) for key in ("inertia", "attitude", "angular_velocity")}
    start = given["inertia"] @ given["angular_velocity"]
    return {
        "name": case.name, **{key: value.tolist() for key, value in given.items()}, "momentum": start.tolist(),
        "dt": case.dt, "steps": list(STEPS), "attitudes": attitudes.tolist(), "momenta": momenta.tolist(),
        "thresholds": thresholds(case, attitudes, momenta),
    }  # fmt: skip


CONVENTIONS = {
    "units": "SI: inertia kg m^2, angular velocity rad/s, momentum kg m^2/s, dt s.",
    "axes": "inertia, angular velocity and momentum are along the body's axes, which are not principal.",
    "attitude": "a quaternion (w, x, y, z) that takes body components to space components; q and -q are the same.",
    "given": "inertia, attitude, angular_velocity and dt are numbers of float32, taken as exact. momentum is their "
    "product, in double precision; round it where an engine keeps L.",
    "steps": "attitudes and momenta are the exact ones after so many steps of dt, rounded to doubles.",
    "thresholds": "what a method of order 1, 2 or 4 in float32 may be off by after each of the steps: twice the error "
    "of semi-implicit Euler, midpoint, and Runge-Kutta 4 written plainly; attitude in rad, momentum relative to |L|. "
    "1 means that the attitude may be lost.",
}


def table_text(found: list[dict[str, Any]]) -> str:
    head = {"format": FORMAT, "version": VERSION, "conventions": CONVENTIONS}
    opening = json.dumps(head, indent=1, ensure_ascii=False).removesuffix("\n}")
    return opening + ',\n "cases": [\n' + ",\n".join(json.dumps(case) for case in found) + "\n ]\n}\n"


def header_text(found: list[dict[str, Any]]) -> str:
    """Return the same as a C header."""

    def numbers(value: Any, suffix: str = "") -> str:
        if isinstance(value, list):
            return "{" + ", ".join(numbers(x, suffix) for x in value) + "}"
        digits = f"{float(value):.9g}" if suffix else repr(float(value))
        return digits + ("" if "." in digits or "e" in digits else ".0") + suffix

    rows = []
    for case in found:
        limits = [[case["thresholds"][order][part] for order in METHODS] for part in ("attitude", "momentum")]
        given = [numbers(case[key], "f") for key in ("inertia", "attitude", "angular_velocity", "dt")]
        states = [numbers(case[key]) for key in ("momentum", "attitudes", "momenta")]
        parts = [f'"{case["name"]}"', *given, *states, *(numbers(limit) for limit in limits)]
        rows.append("    {" + ",\n     ".join(parts) + "}")
    return HEAD + ",\n".join(rows) + "\n};\n\n#endif\n"


HEAD = f"""/* SPDX-License-Identifier: MIT
   Fixed-step cases for rigid-body engines in single precision, with full inertias and exact states.

   All along the body's axes, which are not principal; SI units; quaternions (w, x, y, z) take body to space. inertia,
   attitude, angular_velocity and dt are floats, taken as exact. attitudes and momenta are exact after
   polhode_case_steps steps of dt. Thresholds are for methods of order 1, 2 and 4: twice the errors of semi-implicit
   Euler, midpoint and Runge-Kutta 4 in float, the attitude's in rad and the momentum's relative to |L|; 1 means that
   the attitude may be lost. Written by tests/oracle/write_fixed_step_cases.py. */
#ifndef POLHODE_CASES_H
#define POLHODE_CASES_H

#define POLHODE_CASES_VERSION {VERSION}
#define POLHODE_CASE_COUNT {len(GIVEN)}
#define POLHODE_CASE_TIMES {len(STEPS)}

typedef struct {{
    const char *name;
    float inertia[3][3];                              /* kg m2 */
    float attitude[4], angular_velocity[3], dt;       /* at the start; rad/s; s */
    double momentum[3];                               /* inertia times angular_velocity, kg m2/s */
    double attitudes[POLHODE_CASE_TIMES][4];
    double momenta[POLHODE_CASE_TIMES][3];
    double attitude_thresholds[3][POLHODE_CASE_TIMES]; /* of order 1, 2, 4; rad */
    double momentum_thresholds[3][POLHODE_CASE_TIMES]; /* relative */
}} polhode_case;

static const int polhode_case_steps[POLHODE_CASE_TIMES] = {{{", ".join(map(str, STEPS))}}};

static const polhode_case polhode_cases[POLHODE_CASE_COUNT] = {{
"""
