"""Hard motions with the oracle's values, which every implementation of the closed forms has to give.

``motions.json`` has 100 of each family; sweeps draw others. What is asked for is the state at a time that may be 1e15
rad after an epoch that need not be 0, of bodies that need not start at the identity. The oracles are in ball arithmetic
and share nothing with the solvers; errors are counted in eps = 2^-52.
"""

from __future__ import annotations

import json
from collections import defaultdict
from collections.abc import Sequence
from functools import cache
from pathlib import Path
from typing import NamedTuple

import numpy as np
from flint import arb, ctx

from oracle.lagrange import largest_momentum, reference_top
from oracle.measures import EPS
from oracle.reference import exact, reference_state
from oracle.reference_table import SMALLEST, product
from twins.families import KINDS
from twins.families_of_bodies import draw
from twins.families_of_tops import draw_tops

TABLE = Path(__file__).with_name("motions.json")
COMMITTED, SEED = 100, 46
"""Of each family."""
LONGEST_TURN = {"body": 15.0, "top": 14.0}
"""Powers of ten of the angle in rad; of a top that of its tilt and azimuth, which its spin may exceed by 1e6."""
LONGEST_SPIN = 1e15
"""rad that a top spins at most; beyond it phases lose digits."""
PROMISE = 16.0
"""eps from the truth, at any time: of every entry of the attitude's matrix and signed quaternion, and of L over its
largest in the motion."""
ATTITUDES = ((1.0, 0.0, 0.0, 0.0), (0.5, -0.5, 0.5, 0.5))
"""Of bodies at the epoch, in turn; their lengths are exactly 1."""
WORK = 400
"""Bits for what is done with the oracle's balls."""
WEIGHTS = np.zeros((9, 4, 4))
"""Of the products of a quaternion's entries in its matrix, by rows."""
for _row, _terms in enumerate((
    {(0, 0): 1, (1, 1): 1, (2, 2): -1, (3, 3): -1}, {(1, 2): 2, (0, 3): -2}, {(1, 3): 2, (0, 2): 2},
    {(1, 2): 2, (0, 3): 2}, {(0, 0): 1, (1, 1): -1, (2, 2): 1, (3, 3): -1}, {(2, 3): 2, (0, 1): -2},
    {(1, 3): 2, (0, 2): -2}, {(2, 3): 2, (0, 1): 2}, {(0, 0): 1, (1, 1): -1, (2, 2): -1, (3, 3): 1},
)):  # fmt: skip
    for (_i, _j), _weight in _terms.items():
        WEIGHTS[_row, _i, _j] += 0.5 * _weight
        WEIGHTS[_row, _j, _i] += 0.5 * _weight


class Motion(NamedTuple):
    """What is given, and the time asked for; ``mgl`` of a top."""

    family: str
    moments: tuple[float, ...]
    momentum: tuple[float, ...]
    attitude: tuple[float, ...]
    epoch: float
    mgl: float | None
    time: float

    @property
    def numbers(self) -> tuple[float, ...]:
        """The given numbers in the order of the table."""
        shape = self.moments if self.mgl is None else (*self.moments[1:], self.mgl)
        return (*shape, *self.momentum, *self.attitude, self.epoch, self.time)


class Answers(NamedTuple):
    """States (N, 7) of N motions, attitude and momentum, as sums of two doubles; and the largest |L| of each motion."""

    states: np.ndarray
    rests: np.ndarray
    sizes: np.ndarray


class Errors(NamedTuple):
    """Largest errors (N,) of an entry in eps: of the attitude's matrix and signed quaternion, of L over its largest."""

    attitude: np.ndarray
    quaternion: np.ndarray
    momentum: np.ndarray

    @property
    def worst(self) -> np.ndarray:
        return np.maximum.reduce(self)


def drawn(kind: str, count: int, seed: int, names: Sequence[str] = ()) -> list[Motion]:
    """Return ``count`` motions of every family of a kind, or of those named; the epoch of every third is not 0."""
    cases = (draw if kind == "body" else draw_tops)(count, seed, LONGEST_TURN[kind], names)
    motions = []
    for k, case in enumerate(cases):
        attitude, mgl, time = ATTITUDES[k % 2], None, case.time
        if kind == "top":
            attitude, mgl, spin = case.attitude, case.mgl, abs(case.momentum[2] / case.moments[2])
            time *= min(1.0, LONGEST_SPIN / (spin * abs(time) or LONGEST_SPIN))
        epoch = 0.25 * time if k % 3 == 0 else 0.0
        motions.append(Motion(case.family, case.moments, case.momentum, attitude, epoch, mgl, time))
    return motions


def by_oracle(motions: Sequence[Motion]) -> Answers:
    rows = [_state(motion) for motion in motions]
    with ctx.workprec(WORK):
        states = np.array([[float(x) for x in row[:7]] for row in rows])
        rests = [[float(x - arb(y)) for x, y in zip(row, state, strict=False)] for row, state in
                 zip(rows, states.tolist(), strict=True)]  # fmt: skip
    return Answers(states, np.array(rests), np.array([float(row[7]) for row in rows]))


def _state(motion: Motion) -> list[arb]:
    """Attitude, momentum and largest |L| as balls."""
    elapsed = exact(motion.time) - exact(motion.epoch)
    if motion.mgl is not None:
        top = (motion.moments, motion.mgl, motion.momentum, motion.attitude)
        found = reference_top(*top, elapsed)
        with ctx.workprec(WORK):
            return [*found.quaternion, *found.momentum, largest_momentum(*top)]
    found = reference_state(motion.moments, motion.momentum, elapsed)
    with ctx.workprec(WORK):
        norm = sum((arb(x) ** 2 for x in motion.momentum), arb(0)).sqrt()
        attitude = product([arb(x) for x in motion.attitude], found.quaternion)
        return [*attitude, *(norm * n for n in found.direction), norm]


def errors(found: np.ndarray, answers: Answers) -> Errors:
    """Return the errors of states (N, 7); what is not finite is off by infinity.

    Differences of states are exact to a part in 1e16 of themselves, and so are those of matrices, which are quadratic.
    """
    with np.errstate(all="ignore"):
        off = (found - answers.states) - answers.rests
        turn, middle = off[:, :4], 2.0 * answers.states[:, :4] + off[:, :4]
        entries = np.einsum("kij,ni,nj->nk", WEIGHTS, turn, middle)
        moved = off[:, 4:] / np.where(answers.sizes > 0.0, answers.sizes, 1.0)[:, None]
        parts = (np.abs(x).max(axis=1) / EPS for x in (entries, turn, moved))
        return Errors(*(np.where(np.isnan(x), np.inf, x) for x in parts))


def worst_per_family(motions: Sequence[Motion], found: Errors) -> dict[str, tuple[float, ...]]:
    rows: dict[str, list[int]] = defaultdict(list)
    for k, motion in enumerate(motions):
        rows[motion.family].append(k)
    return {family: tuple(float(x[own].max()) for x in found) for family, own in rows.items()}


def as_text(title: str, worst: dict[str, tuple[float, ...]]) -> str:
    lines = [f"{title}, worst in eps:", " " * 28 + "".join(f"{name:>12}" for name in Errors._fields)]
    return "\n".join([*lines, *(f"  {name:26}" + "".join(f"{x:12.2f}" for x in v) for name, v in worst.items())])


@cache
def committed(kind: str) -> tuple[list[Motion], Answers]:
    """Return the motions of the table and the oracle's values, rounded to doubles."""
    families = json.loads(TABLE.read_text("utf-8"))[kind]
    motions, rows = [], []
    for family, given in families.items():
        for row in given:
            motions.append(_motion(kind, family, row))
            rows.append(row)
    states = np.array([_values(kind, motion, row) for motion, row in zip(motions, rows, strict=True)])
    return motions, Answers(states[:, :7], np.zeros((len(rows), 7)), states[:, 7])


def _motion(kind: str, family: str, row: list[float]) -> Motion:
    moments, mgl = (row[:3], None) if kind == "body" else ([row[0], *row[:2]], row[2])
    return Motion(family, tuple(moments), tuple(row[3:6]), tuple(row[6:10]), row[10], mgl, row[11])


def _values(kind: str, motion: Motion, row: list[float]) -> list[float]:
    """Attitude, momentum and largest |L|; the table leaves out what stays: L3 of a top, and |L| of a body."""
    if kind == "top":
        return [*row[12:18], motion.momentum[2], row[18]]
    return [*row[12:19], float(np.abs(motion.momentum).max() * np.linalg.norm(_unit(motion.momentum)))]


def _unit(vector: Sequence[float]) -> np.ndarray:
    return np.array(vector) / (np.abs(vector).max() or 1.0)


def table_text() -> str:
    """The table, one motion a line."""
    parts = []
    for kind, families in table_lines(COMMITTED).items():
        text = ",\n".join(f'"{name}": [\n' + ",\n".join(rows) + "\n]" for name, rows in families.items())
        parts.append(f'"{kind}": {{\n{text}\n}}')
    head = json.dumps({"about": ABOUT, "columns": COLUMNS}, indent=1, ensure_ascii=False).removesuffix("\n}")
    return head + ",\n" + ",\n".join(parts) + "\n}\n"


def table_lines(count: int) -> dict[str, dict[str, list[str]]]:
    """Return the first ``count`` lines of each family of each kind."""
    found: dict[str, dict[str, list[str]]] = {kind: {name: [] for name in names} for kind, names in KINDS.items()}
    for kind in KINDS:
        for motion in drawn(kind, COMMITTED, SEED):
            lines = found[kind][motion.family]
            if len(lines) < count:
                lines.append(line_of(motion))
    return found


ABOUT = (
    "Hard motions of free bodies and Lagrange tops and their exact states, written by tests/twins/motions_writer.py. "
    "Conventions are those of docs/conventions.md; what is given are doubles, taken as exact numbers. The states are "
    "Legendre's forms of the motions in ball arithmetic, rounded to doubles; the quaternion is the one that goes "
    "continuously from the given one. Entries below 1e-40 of the quaternion's length, or of |L|, are 0. L3 of a top "
    "stays. `size` is the largest |L| of the motion, to 4 digits, to which errors of L are relative."
)
_START = ["L1", "L2", "L3", "q0", "q1", "q2", "q3", "epoch", "time"]
COLUMNS = {
    "body": ["I1", "I2", "I3", *_START, *(f"{x} at the time" for x in ("q0", "q1", "q2", "q3", "L1", "L2", "L3"))],
    "top": ["I1 = I2", "I3", "mgl", *_START, *(f"{x} at the time" for x in ("q0", "q1", "q2", "q3", "L1", "L2")),
            "size"],
}  # fmt: skip


def line_of(motion: Motion) -> str:
    """Return a motion as a row of the table."""
    answers = by_oracle([motion])
    units = [1.0] * 4 + [float(answers.sizes[0])] * 3
    state = [x if abs(x) >= SMALLEST * unit else 0.0 for x, unit in zip(answers.states[0].tolist(), units, strict=True)]
    values = state if motion.mgl is None else [*state[:6], float(f"{answers.sizes[0]:.3e}")]
    return json.dumps([*motion.numbers, *values], separators=(",", ":"))
