"""States of the reference table, from the oracles in ball arithmetic, and how they are written.

A state is computed twice, to two precisions, and every number is rounded from a ball so small that all of it rounds to
the same 17 digits. Attitudes q and −q are the same; the table has the one whose largest entry is positive.
"""

from __future__ import annotations

import json
from collections.abc import Sequence
from decimal import Context, Decimal
from math import hypot
from pathlib import Path

from flint import arb, ctx, fmpq

import polhode
from oracle.hard_free_bodies import FREE_FAMILIES
from oracle.hard_motions import FREE, HardMotion, rounded
from oracle.hard_tops import TOP_FAMILIES
from oracle.lagrange import reference_top
from oracle.reference import exact, reference_state

TABLE = Path(polhode.__file__).parent / "judging" / "reference_motions.json"
VERSION = 1
DIGITS = 17
BITS, MORE_BITS = 224, 320
"""Of accuracy: 67 digits, and 96; entries down to ``SMALLEST`` then have 27 digits or more."""
SMALLEST = 1e-40
"""Of an attitude's length, or of |L|: entries below are written as zero."""
AGREEMENT = 1e-22
WORK = 2000
"""Bits for what is done with states, so that it adds nothing to their radii."""
Balls = list[arb]
State = tuple[Balls, Balls]

CONVENTIONS = {
    "units": "SI: moments kg m^2, momentum kg m^2/s, times s, mgl N m. Any other consistent units do as well.",
    "axes": "moments, momentum and momenta are components along the body's principal axes, in the order given; the "
    "moments are in no particular order.",
    "attitude": "a quaternion (w, x, y, z), scalar first, Hamilton's product, that takes body components to space "
    "components: v_space = R v_body, dR/dt = R hat(W), dq/dt = q (0, W)/2, with the angular velocity W = L/I along the "
    "body axes. q and -q are the same attitude; the table has the one whose largest entry is positive. The given "
    "attitude is to be divided by its length, which is 1 to rounding.",
    "start": "momentum and attitude are those at time 0.",
    "free body": "dL/dt = L x W. mgl is 0.",
    "Lagrange top": "a heavy symmetric body on a fixed point: moments (I1, I1, I3) are those at the fixed point; the "
    "centre of mass is on the third axis; mgl is weight times its distance from the fixed point, negative where it is "
    "on the other side; space z points up. With u the third row of R, dL/dt = L x W + mgl (u2, -u1, 0); "
    "energy = sum L^2/(2 I) + mgl u3.",
    "numbers": "moments, mgl, momentum, attitude and times are doubles, and taken as the exact numbers that these are. "
    "attitudes and momenta are the exact motion of these numbers, correctly rounded to 17 significant digits; entries "
    "below 1e-40 of the quaternion's length or of |L| at the start (of 1 where it is 0) are 0.",
    "rate": "a rough bound of |W| over the whole motion, in rad/s: steps may be chosen by it.",
    "moderate": "times marked true are within reach of an engine that takes steps: rate |t| is 1000 rad at most.",
}


def hard_motions() -> list[HardMotion]:
    return [motion for family in (*FREE_FAMILIES, *TOP_FAMILIES) for motion in family()]


def families() -> dict[str, str]:
    """What each family is, in words: the docstring of what makes it."""
    return {next(make()).family: make.__doc__ or "" for make in (*FREE_FAMILIES, *TOP_FAMILIES)}


def state_of(motion: HardMotion, t: float, bits: int) -> State:
    """Attitude, up to its sign, and momentum at a time, from the oracle of the motion's kind."""
    if motion.kind != FREE:
        found = reference_top(motion.moments, motion.mgl, motion.momentum, motion.attitude, t, bits)
        return found.quaternion, found.momentum
    found = reference_state(motion.moments, motion.momentum, t, bits)
    size, start = _length(motion.momentum), [arb(exact(x)) for x in motion.attitude]
    length = _length(motion.attitude)
    turned = product([x / length for x in start], quaternion_of(found.rotation))
    return turned, [size * n for n in found.direction]


def _length(vector: Sequence[float]) -> arb:
    return arb(sum((exact(x) ** 2 for x in vector), fmpq(0))).sqrt()


def quaternion_of(R: list[Balls]) -> Balls:
    """Of a rotation matrix, from the largest of four candidates (Shepperd, J. Guid. Control 1 (1978) 223)."""
    a, b, c = (R[k][k] for k in range(3))
    p, q, r = R[2][1] - R[1][2], R[0][2] - R[2][0], R[1][0] - R[0][1]
    s, t, u = R[2][1] + R[1][2], R[0][2] + R[2][0], R[1][0] + R[0][1]
    rows = [[1 + a + b + c, p, q, r], [p, 1 + a - b - c, u, t], [q, u, 1 - a + b - c, s], [r, t, s, 1 - a - b + c]]
    best = max(range(4), key=lambda k: float(rows[k][k]))
    scale = 2 * rows[best][best].sqrt()
    return [x / scale for x in rows[best]]


def product(p: Balls, q: Balls) -> Balls:
    (a, b, c, d), (w, x, y, z) = p, q
    return [a * w - b * x - c * y - d * z, a * x + b * w + c * z - d * y,
            a * y - b * z + c * w + d * x, a * z + b * y - c * x + d * w]  # fmt: skip


def digits_of(ball: arb, size: float) -> Decimal:
    """The number correctly rounded to 17 significant digits, or zero."""
    if ball.abs_upper() < SMALLEST * size:
        return Decimal(0)
    low, high = (_decimal(end) for end in (ball.lower(), ball.upper()))
    if low != high:
        raise ArithmeticError(f"too few digits to round: {ball}")
    return low


def _decimal(value: arb) -> Decimal:
    mantissa, exponent = value.man_exp()
    number = Decimal(int(mantissa))
    wide = Context(prec=2000, Emin=-10**6, Emax=10**6)
    scaled = wide.multiply(number, wide.power(Decimal(2), Decimal(int(exponent))))
    return Context(prec=DIGITS).plus(scaled)


def rounded_state(motion: HardMotion, t: float) -> tuple[list[Decimal], list[Decimal]]:
    """The state as the table has it, after a second look with more digits.

    Raises:
        ArithmeticError: where the two precisions disagree.
    """
    size = hypot(*motion.momentum)
    with ctx.workprec(WORK):
        once, again = (_signed(state_of(motion, t, bits)) for bits in (BITS, MORE_BITS))
        for unit, parts in zip((1.0, size or 1.0), zip(once, again, strict=True), strict=True):
            for a, b in zip(*parts, strict=True):
                if not (a.overlaps(b) and abs(a - b) < AGREEMENT * max(unit * SMALLEST, float(abs(b)))):
                    raise ArithmeticError(f"{motion.name} at {t}: {a} and {b} disagree.")
        return [digits_of(x, 1.0) for x in again[0]], [digits_of(x, size or 1.0) for x in again[1]]


def _signed(state: State) -> State:
    attitude, momentum = state
    lead = max(attitude, key=lambda x: abs(float(x)))
    return (attitude if lead > 0 else [-x for x in attitude]), momentum


def motion_text(motion: HardMotion) -> str:
    """One motion in JSON."""
    states = [rounded_state(motion, t) for t in motion.times]
    lines = {
        "name": json.dumps(motion.name, ensure_ascii=False), "family": json.dumps(motion.family),
        "kind": json.dumps(motion.kind), "moments": json.dumps(motion.moments), "mgl": json.dumps(motion.mgl),
        "momentum": json.dumps(motion.momentum), "attitude": json.dumps(motion.attitude),
        "rate": json.dumps(rounded(motion.rate)), "times": json.dumps(motion.times),
        "moderate": json.dumps(motion.moderate),
        "attitudes": _rows([attitude for attitude, _ in states]), "momenta": _rows([L for _, L in states]),
    }  # fmt: skip
    return "{" + ",\n ".join(f'"{name}": {text}' for name, text in lines.items()) + "}"


def _rows(rows: Sequence[Sequence[Decimal]]) -> str:
    return "[" + ",\n  ".join("[" + ", ".join(_number(x) for x in row) + "]" for row in rows) + "]"


def _number(value: Decimal) -> str:
    return "0.0" if value == 0 else str(value).replace("E", "e")


def table_text(motions: Sequence[HardMotion]) -> str:
    head = {"format": "polhode reference motions", "version": VERSION, "conventions": CONVENTIONS,
            "families": families()}  # fmt: skip
    opening = json.dumps(head, indent=1, ensure_ascii=False).removesuffix("\n}")
    return opening + ',\n "motions": [\n' + ",\n".join(map(motion_text, motions)) + "\n ]\n}\n"
