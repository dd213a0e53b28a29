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
from polhode.formats.aem_attitudes import COLUMNS, VELOCITY, Meaning
from polhode.formats.epochs import read_epoch, shortest, since
from polhode.formats.labels import AttitudeLabels, Recording, plain
from polhode.formats.numerals import read_number
from polhode.motion._layout import ATTITUDE, MOMENTUM, StateLayout
from polhode.motion._outcome import Ending, Outcome
from polhode.motion._trajectory import Trajectory
from polhode.motion.frame import BodyFrame
from polhode.spacecraft.formats.adm_blocks import CHECK, Block, refuse
from polhode.spacecraft.formats.adm_keywords import ACM, APM
from polhode.spacecraft.formats.adm_reading import read_blocks
from polhode.types import Array

INERTIA = {"IXX": (0, 0), "IYY": (1, 1), "IZZ": (2, 2), "IXY": (0, 1), "IXZ": (0, 2), "IYZ": (1, 2)}
FAMILIES = {"QUATERNION": "QUATERNION", "EULER_ANGLES": "EULER_ANGLE"}
RATES = {"ANGVEL": ("ANGVEL", 3), "Q_DOT": ("DERIVATIVE", 4), "EULER_RATE": ("DERIVATIVE", 3), "GYRO_BIAS": ("", 3),
         "NONE": ("", 0)}  # fmt: skip
"""Rates of an ACM: as an AEM calls them, and how many numbers they are."""
SIGNS = "IXY, IXZ and IYZ are taken as entries of the inertia matrix, which are minus the products of inertia"


class AgreementLimits(NamedTuple):
    """Differences within which two blocks of one instant agree; more is no rounding.

    Attributes:
        max_angle: [rad] between two attitudes.
        max_relative: between two angular velocities or matrices of inertia, of the larger one.
    """

    max_angle: float = 0.01
    max_relative: float = 0.01


LIMITS = AgreementLimits()


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


class _History(NamedTuple):
    """Attitudes (n, 4) and angular velocities (n, 3) along the body's axes, or None.

    Attributes:
        zero: the instant from which times count.
        times: (n,) [s].
        lines: (n,) of the file.
        attitude: (n, 4).
        velocity: (n, 3) or None.
    """

    zero: tuple[int, int]
    times: Array
    lines: Array
    attitude: Array
    velocity: Array | None


def read_apm(path: Path) -> Trajectory:
    """Return the one attitude of an APM, with the angular velocity and the body's inertia where it has them.

    Raises:
        InvalidInput: where the file is missing.
        FormatError: naming the line, for what is no APM of version 2.0, or has no attitude.
    """
    first, *blocks = read_blocks(path, APM)
    zero = first.epoch("EPOCH")
    states = [state for block in blocks for state in _states(block)]
    taken, *others = [state for state in states if state.attitude is not None] or [None]
    if taken is None:
        refuse(path, None, f"has no attitude, in blocks QUAT, EULER or SPIN. {CHECK}")
    assert taken.attitude is not None
    rated = next((state for state in states if state.velocity is not None), None)
    velocity = None if rated is None else _along_body(rated, taken)[None]
    doubts = [doubt for state in others if state and (doubt := _doubt_attitude(taken, state))]
    doubts += [doubt for block in blocks if (doubt := _doubt_derivatives(block))]
    if rated is not None:
        more = [state for state in states if state.velocity is not None and state is not rated]
        doubts += [doubt for state in more if (doubt := _doubt_velocity(rated, state, taken))]
    if rated is not None and plain(rated.space) != plain(taken.space):
        doubts.append(f"its angular velocity is relative to {rated.space}, and the attitude to {taken.space}")
    lines = np.array([(taken if rated is None else rated).block.line])
    history = _History(zero, np.zeros(1), lines, taken.attitude[None], velocity)
    return _make(first, blocks, (taken.space, taken.body), history, doubts)


def read_acm(path: Path) -> Trajectory:
    """Return the attitude history of an ACM, the first of its blocks ATT, with inertia where it has a block PHYS.

    Raises:
        InvalidInput: where the file is missing.
        FormatError: naming the line, for what is no ACM, or has no attitudes that are read.
    """
    first, *blocks = read_blocks(path, ACM)
    zero = first.epoch("EPOCH_TZERO")
    block, *others = [block for block in blocks if block.name == "ATT"] or [None]
    if block is None:
        refuse(path, None, f"has no block ATT, whose attitudes would be read. {CHECK}")
    written, rate = block.text("ATT_TYPE").upper(), block.text("RATE_TYPE", "NONE").upper()
    if written not in FAMILIES or rate not in RATES:
        block.wrong("ATT_TYPE", f"must be {' or '.join(FAMILIES)} to be read here, with the RATE_TYPE "
                                f"{', '.join(RATES)}")
    _check_span(first, zero)
    times, numbers, lines = _rows(block, first.time_system, zero)
    family, (rates, _) = FAMILIES[written], RATES[rate]
    space, body, backward = block.frames()
    sequence = None if family == "QUATERNION" else block.sequence()
    _check_width(block, written, rate, numbers.shape[1])
    kind = f"{family}/{rates}" if rates else family
    # the velocity is along frame B, which is that of space where the rotation is from body to space
    meaning = Meaning(kind, sequence, False, backward, backward)
    attitude, velocity = block.turn(meaning, numbers[:, : len(COLUMNS[kind])], lines)
    doubts = [f"it has {len(others) + 1} blocks of attitudes, of which the first is read"] if others else []
    history = _History(zero, times, lines, attitude, velocity)
    return _make(first, blocks, (space, body), history, doubts)


def _check_width(block: Block, written: str, rate: str, count: int) -> None:
    """Refuse lines of other numbers than the block announces.

    Raises:
        FormatError: for a count that is not NUMBER_STATES, or not that of the types of attitude and rate.
    """
    if rate == ("EULER_RATE" if written == "QUATERNION" else "Q_DOT"):
        block.wrong("RATE_TYPE", f"must be ANGVEL, GYRO_BIAS, NONE or the derivative of {written} to be read here; got "
                                 f"{rate}", "Have the rates written as ANGVEL.")
    given, wanted = block.text("NUMBER_STATES", str(count)), len(COLUMNS[FAMILIES[written]]) + RATES[rate][1]
    if given.removeprefix("+").lstrip("0") != str(count):
        block.wrong("NUMBER_STATES", f"must be how many numbers follow the time in each line, {count}; got "
                                     f"{shown(given)}")
    if count != wanted:
        block.wrong("ATT_TYPE", f"{written} with RATE_TYPE {rate} needs {wanted} numbers after the time; got {count}")


def _make(
    first: Block, blocks: list[Block], names: tuple[str, str], history: _History, doubts: list[str],
) -> Trajectory:
    system, (zero, times, lines, attitude, velocity) = first.time_system, history
    frame, more = _body(blocks, names[1])
    momentum = energy = None
    if frame is not None and velocity is not None:
        with np.errstate(all="ignore"):  # what overflows is not finite, and refused
            momentum = velocity @ frame.inertia
            energy = (velocity * momentum).sum(axis=-1, keepdims=True)
    first.check_finite("a rate, an angular momentum or an energy", lines, attitude, velocity, momentum, energy)
    states = attitude if momentum is None else np.concatenate([attitude, momentum], axis=1)
    layout = StateLayout((ATTITUDE,) if momentum is None else (ATTITUDE, MOMENTUM))
    identifier = first.text("OBJECT_ID", "") or first.text("INTERNATIONAL_DESIGNATOR", "")
    labels = AttitudeLabels(
        first.text("OBJECT_NAME"), identifier or None, first.text("CENTER_NAME", "") or None, *names,
        shortest(zero, system), system, first.text("ORIGINATOR", "") or None, None,
    )
    return Trajectory(
        times, states, layout, attitude, momentum, velocity, outcome=Outcome(Ending.RECORDED, message="; ".join(
            [*doubts, *more])), source=Recording(labels.object_name, labels), frame=frame,
        axes=None if frame is None else np.asarray(frame.axes),
    )


def _states(block: Block) -> list[_State]:
    """Return what a block of an APM says about attitude and angular velocity; none for other blocks."""
    family = {"QUAT": "QUATERNION", "EULER": "EULER_ANGLE", "SPIN": "SPIN", "ANGVEL": "ANGVEL"}.get(block.name)
    if family is None:
        return []
    space, body, backward = block.frames()
    if family == "ANGVEL":
        along = plain(block.text("ANGVEL_FRAME", body))
        if along not in (plain(body), plain(space)):
            block.wrong("ANGVEL_FRAME", f"must be one of the two frames, {space} or {body}, to be read here; got "
                                        f"{shown(along)}", f"Have the rates written along {body}.")
        velocity = np.radians(block.numbers(VELOCITY))
        return [_State(block, space, body, None, -velocity if backward else velocity, along != plain(body))]
    if family == "SPIN" and backward:
        block.wrong("REF_FRAME_A", "must be the space frame for spin data, and REF_FRAME_B the body's")
    kind = _kind_of_spin(block) if family == "SPIN" else f"{family}/DERIVATIVE"
    kind = kind if family == "SPIN" or block.has([*COLUMNS[kind]]) else family
    meaning = Meaning(kind, block.sequence() if family == "EULER_ANGLE" else None, backward=backward)
    attitude, velocity = block.turn(meaning, np.array([block.numbers(COLUMNS[kind])]), np.array([block.line]))
    return [_State(block, space, body, attitude[0], None if velocity is None else velocity[0])]


def _kind_of_spin(block: Block) -> str:
    """Return the type of spin data, whose nutation is given in one of two ways or not at all (504.0-B-2, 3.2.4.6).

    Raises:
        FormatError: for both of them.
    """
    kinds = {kind: [name for name in COLUMNS[kind] if name in block.values and name not in COLUMNS["SPIN"]]
             for kind in ("SPIN/NUTATION", "SPIN/NUTATION_MOM")}  # fmt: skip
    given = [kind for kind, names in kinds.items() if names]
    if len(given) == 2:
        (nutation, *_), (momentum, *_) = kinds.values()
        block.wrong(momentum, f"must not be with {nutation}, as a block SPIN gives the nutation in one of two ways",
                    "Leave out one.")
    return given[0] if given else "SPIN"


def _doubt_derivatives(block: Block) -> str:
    """Return that derivatives are left out which are too few to give a velocity; empty where none are."""
    family = {"QUAT": "QUATERNION", "EULER": "EULER_ANGLE"}.get(block.name)
    wanted = [name for name in COLUMNS[f"{family}/DERIVATIVE"] if name.endswith("_DOT")] if family else []
    given = [name for name in wanted if name in block.values]
    if len(given) in (0, len(wanted)):
        return ""
    missing = ", ".join(name for name in wanted if name not in given)
    return f"{', '.join(given)} of its block {block.name} left out, as it has no {missing}"


def _doubt_velocity(rated: _State, other: _State, taken: _State) -> str:
    """Return what is to be said of another angular velocity than the one that is taken; empty for nothing."""
    if (plain(rated.space), plain(rated.body)) != (plain(other.space), plain(other.body)):
        return f"it has the angular velocity of {other.body} against {other.space} too, which is left out"
    if other.in_space and plain(other.space) != plain(taken.space):
        return f"it has the angular velocity along {other.space} too, which is left out"
    pair = np.stack([_along_body(state, taken) for state in (rated, other)])
    with np.errstate(all="ignore"):  # what overflows is refused later
        apart = float(np.linalg.norm(pair[1] - pair[0]))
        if apart <= LIMITS.max_relative * np.linalg.norm(pair, axis=-1).max():
            return ""
    return f"its angular velocities differ by {apart:.3g} rad/s, and the first is taken"


def _doubt_attitude(taken: _State, other: _State) -> str:
    """Return what is to be said of another attitude of the instant than the one that is taken; empty for nothing."""
    assert taken.attitude is not None and other.attitude is not None
    pairs = [(plain(state.space), plain(state.body)) for state in (taken, other)]
    if pairs[0] != pairs[1]:
        return (f"it has attitudes between other frames too, {other.space} and {other.body}, and that between "
                f"{taken.space} and {taken.body} is taken")
    apart = float(rotation.angle_between(taken.attitude, other.attitude))
    return f"its attitudes differ by {apart:.3g} rad, and the first is taken" if apart > LIMITS.max_angle else ""


def _along_body(state: _State, known: _State) -> Array:
    """Return the angular velocity of a block along the body's axes, by the attitude of another.

    Raises:
        FormatError: where it is of another body, or along axes of space that the attitude is not relative to.
    """
    assert state.velocity is not None and known.attitude is not None
    if plain(state.body) != plain(known.body):
        keyword = "REF_FRAME_B" if state.block.text("REF_FRAME_B") == state.body else "REF_FRAME_A"
        state.block.wrong(keyword, f"must be that of the attitude, {known.body}, for its rates to be read; got "
                                   f"{shown(state.body)}", f"Have the rates written for {known.body}.")
    if not state.in_space:
        return state.velocity
    if plain(state.space) != plain(known.space):
        state.block.wrong("ANGVEL_FRAME", f"must be the body's frame, or the one that the attitude is relative to, "
                                          f"{known.space}; got {shown(state.space)}",
                          f"Have the rates written along {state.body}.")
    with np.errstate(all="ignore"):  # what overflows is refused later
        return rotation.rotate(rotation.conjugate(known.attitude), state.velocity)


def _rows(block: Block, time_system: str, zero: tuple[int, int]) -> tuple[Array, Array, Array]:
    """Return ascending times [s] from the message's zero, the numbers of an ACM's lines, and where the lines are."""
    def instant(word: str) -> float:
        return _elapsed(read_epoch(word, time_system), zero) if "T" in word else read_number(word)

    if not block.rows:
        refuse(block.path, block.line, f"has no attitudes. {CHECK}")
    times, numbers, lines = block.read_rows(instant, None, "as in the first line")
    block.check_ascending(np.diff(times) > 0, lines)
    return times, numbers, lines


def _elapsed(epoch: tuple[int, int], zero: tuple[int, int]) -> float:
    return float(since(zero, np.array(epoch[:1]), np.array(epoch[1:]))[0])


def _check_span(first: Block, zero: tuple[int, int]) -> None:
    """Refuse a span of an ACM that ends before it begins, or whose ends are no times.

    Raises:
        FormatError: naming the line.
    """
    ends = {keyword: _elapsed(first.epoch(keyword), zero) if "T" in first.text(keyword) else first.number(keyword, "s")
            for keyword in ("START_TIME", "STOP_TIME") if keyword in first.values}  # fmt: skip
    if len(ends) == 2 and ends["STOP_TIME"] < ends["START_TIME"]:
        first.wrong("STOP_TIME", f"must not lie before START_TIME; got {first.text('STOP_TIME')}, and "
                                 f"{first.text('START_TIME')} there")


def _body(blocks: list[Block], body: str) -> tuple[BodyFrame | None, list[str]]:
    """Return the mass properties along the body's axes, None without an inertia, and what to say about them."""
    tensors = [(block, matrix) for block in blocks if (matrix := _tensor(block)) is not None]
    axes = [block.text("INERTIA_REF_FRAME", body) for block, _ in tensors]
    along = [tensor for tensor, frame in zip(tensors, axes, strict=True) if plain(frame) == plain(body)]
    if not along:
        return None, [f"the inertia is left out, as it is along {frame}, and the attitude is that of {body}"
                      for frame in axes]  # fmt: skip
    (block, matrix), *others = along
    with np.errstate(all="ignore"):  # what overflows differs
        differ = any(np.abs(other - matrix).max() > LIMITS.max_relative * max(np.abs(other).max(), np.abs(matrix).max())
                     for _, other in others)  # fmt: skip
    doubts = ["its blocks of inertia differ, and the first is taken"] if differ else []
    mass = block.number("WET_MASS", "kg") if "WET_MASS" in block.values else None
    try:
        known = Body.from_inertia(matrix, mass)
    except InvalidInput as error:
        raise FormatError(f"{block.path}, line {block.line}: {error}") from None
    return known.frame, doubts if np.count_nonzero(matrix) == 3 else [*doubts, SIGNS]


def _tensor(block: Block) -> Array | None:
    """Return the matrix of inertia (3, 3) of a block, None without one.

    Raises:
        FormatError: where a part of it is missing other than the entries off the diagonal, which are zero then.
    """
    if block.name != "INERTIA" and not any(keyword in block.values for keyword in INERTIA):
        return None
    matrix = np.zeros((3, 3))
    for keyword, (i, j) in INERTIA.items():
        matrix[i, j] = matrix[j, i] = block.number(keyword, "kg*m**2", 0.0 if i != j else None)
    return matrix
