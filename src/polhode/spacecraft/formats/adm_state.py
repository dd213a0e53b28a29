"""Attitude, angular velocity and inertia of CCSDS Attitude Parameter and Comprehensive Messages (APM, ACM).

An APM tells one instant, an ACM a history; both may have the inertia of the spacecraft. Off-diagonal entries are those
of the inertia matrix, as Orekit takes them.

Source: CCSDS 504.0-B-2, tables 3-3 and 5-3 to 5-5, annex F.
"""

from __future__ import annotations

from pathlib import Path
from typing import NamedTuple

import numpy as np

from polhode import rotation
from polhode.bodies.body import Body
from polhode.errors import FormatError, InvalidInput, shown
from polhode.formats.aem_attitudes import Meaning, attitudes
from polhode.formats.epochs import TIME_SYSTEMS, read_epoch, shortest, since
from polhode.formats.labels import AttitudeLabels, Recording, is_in_spacecraft, plain
from polhode.formats.numerals import read_number
from polhode.motion._layout import ATTITUDE, MOMENTUM, StateLayout
from polhode.motion._outcome import Ending, Outcome
from polhode.motion._trajectory import Trajectory
from polhode.motion.frame import BodyFrame
from polhode.spacecraft.formats.adm_blocks import Block, read_blocks
from polhode.types import Array

QUATERNION = ("Q1", "Q2", "Q3", "QC")
DERIVATIVE = tuple(f"{name}_DOT" for name in QUATERNION)
ANGLES, VELOCITY = ("ANGLE_1", "ANGLE_2", "ANGLE_3"), ("ANGVEL_X", "ANGVEL_Y", "ANGVEL_Z")
SPIN = ("SPIN_ALPHA", "SPIN_DELTA", "SPIN_ANGLE")
INERTIA = {"IXX": (0, 0), "IYY": (1, 1), "IZZ": (2, 2), "IXY": (0, 1), "IXZ": (0, 2), "IYZ": (1, 2)}
APART = 0.01  # rad; two attitudes of one instant that differ by more are no rounding
RATES = {"ANGVEL": "ANGVEL", "Q_DOT": "DERIVATIVE", "EULER_RATE": "DERIVATIVE", "GYRO_BIAS": "", "NONE": ""}
RATE_WIDTHS = {"ANGVEL": 3, "Q_DOT": 4, "EULER_RATE": 3, "GYRO_BIAS": 3, "NONE": 0}
SIGNS = "IXY, IXZ and IYZ are taken as entries of the inertia matrix, which are minus the products of inertia"
WIDTHS = {"QUATERNION": 4, "EULER_ANGLES": 3}


class _State(NamedTuple):
    """An attitude (4,), an angular velocity (3,) or None of both, in the frames that a block names.

    The velocity is along the body's axes, but along those of space where ``in_space`` says so.
    """

    block: Block
    space: str
    body: str
    attitude: Array | None
    velocity: Array | None
    in_space: bool = False


def read_apm(path: Path) -> Trajectory:
    """Return the one attitude of an APM, with the angular velocity and the body's inertia where it has them.

    Raises:
        InvalidInput: where the file is missing.
        FormatError: naming the line, for what is no APM of version 2.0, or has no attitude.
    """
    first, *blocks = read_blocks(path, "APM")
    whole, picoseconds = _epoch(first, "EPOCH")
    states = [state for block in blocks for state in _states(block)]
    known = [state for state in states if state.attitude is not None]
    if not known:
        raise FormatError(f"{path}: has no attitude, in blocks QUAT, EULER or SPIN. Check the file.")
    attitude = known[0].attitude
    assert attitude is not None
    rated = next((state for state in states if state.velocity is not None), None)
    velocity = None if rated is None else _along_body(rated, known[0])
    doubts = [doubt for state in known[1:] if (doubt := _doubt_attitude(known[0], state))]
    if rated is not None and plain(rated.space) != plain(known[0].space):
        doubts.append(f"its angular velocity is relative to {rated.space}, and the attitude to {known[0].space}")
    names = known[0].space, known[0].body
    rates = None if velocity is None else velocity[None]
    return _make(first, blocks, names, (whole, picoseconds), np.zeros(1), attitude[None], rates, doubts)


def read_acm(path: Path) -> Trajectory:
    """Return the attitude history of an ACM, the first of its blocks ATT, with inertia where it has a block PHYS.

    Raises:
        InvalidInput: where the file is missing.
        FormatError: naming the line, for what is no ACM, or has no attitudes that are read.
    """
    first, *blocks = read_blocks(path, "ACM")
    zero = _epoch(first, "EPOCH_TZERO")
    histories = [block for block in blocks if block.name == "ATT"]
    if not histories:
        raise FormatError(f"{path}: has no block ATT, whose attitudes would be read. Check the file.")
    block = histories[0]
    kind, rate = block.text("ATT_TYPE").upper(), block.text("RATE_TYPE", "NONE").upper()
    if kind not in WIDTHS or rate not in RATES:
        block.wrong("ATT_TYPE", "must be QUATERNION or EULER_ANGLES to be read here, with the RATE_TYPE "
                                f"{', '.join(RATES)}")  # fmt: skip
    rates = RATES[rate]
    times, numbers = _rows(block, first.text("TIME_SYSTEM"), zero)
    family = "QUATERNION" if kind == "QUATERNION" else "EULER_ANGLE"
    space, body, backward = _frames(block)
    sequence = None if family == "QUATERNION" else _sequence(block)
    _check_width(block, kind, rate, numbers.shape[1])
    width = WIDTHS[kind] + (RATE_WIDTHS[rate] if rates else 0)
    # the velocity is along frame B, which is that of space where the rotation is from body to space
    meaning = Meaning(f"{family}/{rates}" if rates else family, sequence, False, backward, backward)
    attitude, velocity = _turn(block, meaning, numbers[:, :width])
    doubts = [f"it has {len(histories)} blocks of attitudes, of which the first is read"] if histories[1:] else []
    return _make(first, blocks, (space, body), zero, times, attitude, velocity, doubts)


def _check_width(block: Block, kind: str, rate: str, count: int) -> None:
    """Refuse lines of other numbers than the block announces.

    Raises:
        FormatError: for a count that is not NUMBER_STATES, or not that of the types of attitude and rate.
    """
    if rate == ("EULER_RATE" if kind == "QUATERNION" else "Q_DOT"):
        block.wrong("RATE_TYPE", f"must be ANGVEL, GYRO_BIAS, NONE or the derivative of {kind} to be read here; got "
                                 f"{rate}", "Have the rates written as ANGVEL.")  # fmt: skip
    said, wanted = block.text("NUMBER_STATES", str(count)), WIDTHS[kind] + RATE_WIDTHS[rate]
    if said.removeprefix("+").lstrip("0") != str(count):
        block.wrong("NUMBER_STATES", f"must be how many numbers follow the time in each line, {count}; got "
                                     f"{shown(said)}")  # fmt: skip
    if count != wanted:
        block.wrong("ATT_TYPE", f"{kind} with RATE_TYPE {rate} needs {wanted} numbers after the time; got {count}")


def _make(
    first: Block, blocks: list[Block], names: tuple[str, str], zero: tuple[int, int], times: Array, attitude: Array,
    velocity: Array | None, doubts: list[str],
) -> Trajectory:  # fmt: skip
    system = first.text("TIME_SYSTEM")
    frame, more = _body(blocks, names[1])
    momentum = None if frame is None or velocity is None else velocity @ frame.inertia
    states = attitude if momentum is None else np.concatenate([attitude, momentum], axis=1)
    layout = StateLayout((ATTITUDE,) if momentum is None else (ATTITUDE, MOMENTUM))
    identifier = first.text("OBJECT_ID", "") or first.text("INTERNATIONAL_DESIGNATOR", "")
    labels = AttitudeLabels(
        first.text("OBJECT_NAME"), identifier or None, first.text("CENTER_NAME", "") or None, *names,
        shortest(zero, system), system, first.text("ORIGINATOR", "") or None, None,
    )  # fmt: skip
    return Trajectory(
        times, states, layout, attitude, momentum, velocity, outcome=Outcome(Ending.RECORDED, message="; ".join(
            [*doubts, *more])), source=Recording(labels.object_name, labels), frame=frame,
        axes=None if frame is None else np.asarray(frame.axes),
    )  # fmt: skip


def _epoch(first: Block, keyword: str) -> tuple[int, int]:
    system = plain(first.text("TIME_SYSTEM"))
    if system not in TIME_SYSTEMS:
        first.wrong("TIME_SYSTEM", f"must be one of {', '.join(TIME_SYSTEMS)} to be read here; got {shown(system)}")
    try:
        return read_epoch(first.text(keyword), system)
    except ValueError as error:
        first.wrong(keyword, str(error))


def _frames(block: Block) -> tuple[str, str, bool]:
    """Return the space frame, the body's, and whether the rotation is from body to space."""
    a, b = block.text("REF_FRAME_A"), block.text("REF_FRAME_B")
    backward = is_in_spacecraft(a) and not is_in_spacecraft(b)
    return (b, a, True) if backward else (a, b, False)


def _sequence(block: Block) -> str:
    sequence = block.text("EULER_ROT_SEQ").upper().translate(str.maketrans("123", "XYZ"))
    if len(sequence) != 3 or set(sequence) - set("XYZ") or sequence[0] == sequence[1] or sequence[1] == sequence[2]:
        block.wrong("EULER_ROT_SEQ", f"must be three axes, neighbours different, like ZXZ; got {shown(sequence)}")
    return sequence


def _turn(block: Block, meaning: Meaning, columns: Array) -> tuple[Array, Array | None]:
    try:
        return attitudes(meaning, columns)
    except ValueError as error:
        raise FormatError(f"{block.path}, line {block.line}: {error.args[0]}. Check the file.") from None


def _states(block: Block) -> list[_State]:
    """Return what a block of an APM says about attitude and angular velocity; none for other blocks."""
    if block.name not in ("QUAT", "EULER", "ANGVEL", "SPIN"):
        return []
    space, body, backward = _frames(block)
    if block.name == "ANGVEL":
        along = plain(block.text("ANGVEL_FRAME", body))
        if along not in (plain(body), plain(space)):
            block.wrong("ANGVEL_FRAME", f"must be one of the two frames, {space} or {body}, to be read here; got "
                                        f"{shown(along)}", f"Have the rates written along {body}.")  # fmt: skip
        velocity = np.radians(block.numbers(VELOCITY, "deg/s"))
        return [_State(block, space, body, None, -velocity if backward else velocity, along != plain(body))]
    if block.name == "QUAT":
        rated = block.has(*DERIVATIVE)
        columns = block.numbers(QUATERNION, "") + (block.numbers(DERIVATIVE, "1/s") if rated else [])
        meaning = Meaning("QUATERNION/DERIVATIVE" if rated else "QUATERNION", backward=backward)
    elif block.name == "EULER":
        rates = tuple(f"{name}_DOT" for name in ANGLES)
        rated = block.has(*rates)
        columns = block.numbers(ANGLES, "deg") + (block.numbers(rates, "deg/s") if rated else [])
        kind = "EULER_ANGLE/DERIVATIVE" if rated else "EULER_ANGLE"
        meaning = Meaning(kind, _sequence(block), backward=backward)
    else:
        if backward:
            block.wrong("REF_FRAME_A", "must be the space frame for spin data, and REF_FRAME_B the body's")
        columns, meaning = _spin(block)
    attitude, velocity = _turn(block, meaning, np.array([columns]))
    return [_State(block, space, body, attitude[0], None if velocity is None else velocity[0])]


def _doubt_attitude(taken: _State, other: _State) -> str:
    """Return what is to be said of another attitude of the instant than the one that is taken; empty for nothing."""
    assert taken.attitude is not None and other.attitude is not None
    pairs = [(plain(state.space), plain(state.body)) for state in (taken, other)]
    if pairs[0] != pairs[1]:
        return (f"it has attitudes between other frames too, {other.space} and {other.body}, and that between "
                f"{taken.space} and {taken.body} is taken")  # fmt: skip
    apart = float(rotation.angle_between(taken.attitude, other.attitude))
    return f"its attitudes differ by {apart:.3g} rad, and the first is taken" if apart > APART else ""


def _along_body(state: _State, known: _State) -> Array:
    """Return the angular velocity of a block along the body's axes, by the attitude of another.

    Raises:
        FormatError: where it is of another body, or along axes of space that the attitude is not relative to.
    """
    assert state.velocity is not None and known.attitude is not None
    if plain(state.body) != plain(known.body):
        keyword = "REF_FRAME_B" if state.block.text("REF_FRAME_B") == state.body else "REF_FRAME_A"
        state.block.wrong(keyword, f"must be that of the attitude, {known.body}, for its rates to be read; got "
                                   f"{shown(state.body)}", f"Have the rates written for {known.body}.")  # fmt: skip
    if not state.in_space:
        return state.velocity
    if plain(state.space) != plain(known.space):
        state.block.wrong("ANGVEL_FRAME", f"must be the body's frame, or the one that the attitude is relative to, "
                                          f"{known.space}; got {shown(state.space)}",
                          f"Have the rates written along {state.body}.")  # fmt: skip
    return rotation.rotate(rotation.conjugate(known.attitude), state.velocity)


def _spin(block: Block) -> tuple[list[float], Meaning]:
    columns = [*block.numbers(SPIN, "deg"), block.number("SPIN_ANGLE_VEL", "deg/s")]
    if block.has("NUTATION"):
        nutation = [block.number("NUTATION", "deg"), block.number("NUTATION_PER", "s"),
                    block.number("NUTATION_PHASE", "deg")]  # fmt: skip
        return columns + nutation, Meaning("SPIN/NUTATION")
    if block.has("MOMENTUM_ALPHA"):
        momentum = block.numbers(("MOMENTUM_ALPHA", "MOMENTUM_DELTA"), "deg")
        return [*columns, *momentum, block.number("NUTATION_VEL", "deg/s")], Meaning("SPIN/NUTATION_MOM")
    return columns, Meaning("SPIN")


def _rows(block: Block, system: str, zero: tuple[int, int]) -> tuple[Array, Array]:
    """Return times [s] from the message's zero and the numbers of an ACM's lines."""
    times, rows = [], []
    for line, words in block.rows:
        try:
            if "T" in words[0]:
                whole, picoseconds = read_epoch(words[0], plain(system))
                times.append(float(since(zero, np.array([whole]), np.array([picoseconds]))[0]))
            else:
                times.append(read_number(words[0]))
            rows.append([read_number(word) for word in words[1:]])
            if len(rows[-1]) != len(rows[0]):
                raise ValueError(f"has {len(rows[-1])} numbers, and the first line has {len(rows[0])}")
        except ValueError as error:
            raise FormatError(f"{block.path}, line {line}: {error}. Check the file.") from None
    if not rows:
        raise FormatError(f"{block.path}, line {block.line}: has no attitudes. Check the file.")
    return np.array(times), np.array(rows)


def _body(blocks: list[Block], body: str) -> tuple[BodyFrame | None, list[str]]:
    """Return the mass properties along the body's axes, None without an inertia, and what to say about them."""
    block = next((block for block in blocks if block.name in ("INERTIA", "PHYS") and block.has("IXX")), None)
    if block is None:
        return None, []
    axes = block.text("INERTIA_REF_FRAME", body)
    if plain(axes) != plain(body):
        return None, [f"the inertia is left out, as it is along {axes}, and the attitude is that of {body}"]
    matrix = np.zeros((3, 3))
    for keyword, (i, j) in INERTIA.items():
        matrix[i, j] = matrix[j, i] = block.number(keyword, "kg*m**2", 0.0 if i != j else None)
    mass = block.number("WET_MASS", "kg") if block.has("WET_MASS") else None
    try:
        known = Body.from_inertia(matrix, mass)
    except InvalidInput as error:
        raise FormatError(f"{block.path}, line {block.line}: {error}") from None
    return known.frame, [] if np.count_nonzero(matrix) == 3 else [SIGNS]
