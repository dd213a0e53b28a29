"""Aligns the clocks of two attitude histories: by their epochs, by ``offset``, or by assumption."""

from __future__ import annotations

import re
from decimal import Decimal
from typing import NamedTuple

import numpy as np

from polhode.errors import InvalidInput, shown
from polhode.formats.header_words import TIME_UNITS, find_unit
from polhode.formats.stamps import IN_DECIMAL_SECONDS, exact_number, in_words
from polhode.formats.time_scales import terrestrial_time
from polhode.spacecraft.comparing._clock_offset import ClockOffset
from polhode.spacecraft.comparing.comparison import LIMITS as COMPARISON
from polhode.spacecraft.comparing.comparison import align_clocks
from polhode.studies.sources import Source

START = "start"
SUPPOSED = ("; it supposes that both have the same body axes, as the motion does not tell a turn of these from an "
            "offset")
_TIME = re.compile(r"\s*(?P<number>[-+]?[0-9.]+(?:[eE][-+]?[0-9]+)?)\s*(?P<unit>[A-Za-zµμ]+)\s*")


class ClockWording(NamedTuple):
    """What the sentence on an offset mentions."""

    worthwhile_error: float = 0.5  # of the error; an offset that supposes more and gains less is not worth a line


WORDING = ClockWording()


class Align(NamedTuple):
    """That the offset is estimated from the attitudes; of several, the one nearest to another [s]."""

    near: Decimal | None = None


class Laid(NamedTuple):
    """A's time at B's time zero [s] in the times of the two histories, how it is known, and its estimate, if estimated.
    """

    offset: float
    words: str
    aligned: ClockOffset | None = None


def parse_clocks(offset: str | float | None, align: bool) -> Decimal | str | Align | None:
    """Return how clocks are related: A's clock at B's zero [s], exactly, START, or that it is to be estimated; None
    where nothing is given.

    Raises:
        InvalidInput: for an offset that is neither a time nor START, and for START where it is to be estimated.
    """
    parsed = _parse_offset(offset) if offset is None or isinstance(offset, str) else Decimal(offset)
    if not align:
        return parsed
    if isinstance(parsed, str):
        raise InvalidInput(f"`offset` says by `{START}` the offset that `align_clock` would find. Leave one out, or "
                           "say a time that it is near.")
    return Align(parsed)


def _parse_offset(text: str | None) -> Decimal | str | None:
    """Return the parsed offset: A's clock at B's zero [s], exactly, or START; None where none is given.

    Raises:
        InvalidInput: for anything else.
    """
    if text is None or text == START:
        return text
    match = _TIME.fullmatch(text)
    unit = find_unit(match["unit"], TIME_UNITS) if match else None
    if match and unit and _is_number(match["number"]):
        try:
            return exact_number(match["number"]) * IN_DECIMAL_SECONDS[unit]
        except ValueError:
            raise InvalidInput(f"`offset` must be between 1e-30 and 1e30 in size, or 0; got {shown(text)}. Say A's "
                               "time at B's time zero.") from None
    raise InvalidInput(f"`offset` must be `{START}`, or a time with its unit like `-68.5 s`; got {shown(text)}.")


def _is_number(text: str) -> bool:
    try:
        float(text)
    except ValueError:
        return False
    return True


def lay_side_by_side(a: Source, b: Source, offset: Decimal | str | Align | None) -> Laid:
    """Return the relation between A's and B's times.

    Args:
        a, b: the two.
        offset: as ``parse_clocks`` returns it.

    Raises:
        InvalidInput: where nothing shows that both share a clock, and they begin at different times.
    """
    begins = [side.begin + Decimal(float(side.history.times[0])) for side in (a, b)]
    if isinstance(offset, Align):
        return _align(a, b, offset.near)
    if offset == START:
        return _make_laid(a, b, begins[0] - begins[1], "both begin at the same moment, as `offset` says")
    if isinstance(offset, Decimal):
        return _make_laid(a, b, offset, f"B's time zero is at {in_words(offset)} s of A, as `offset` says")
    if a.labels is not None and b.labels is not None:
        epochs = [terrestrial_time(side.labels.epoch, side.labels.time_system) for side in (a, b) if side.labels]
        words = [f"{side.labels.epoch} {side.labels.time_system}" for side in (a, b) if side.labels]
        known = f"both count from {words[0]}" if words[0] == words[1] else f"by their epochs, {' and '.join(words)}"
        return Laid(float(epochs[1] - epochs[0]), known)
    silent = [name for name, side in (("A", a), ("B", b)) if side.labels is None]
    unsaid = f"{' and '.join(silent)} {'has' if len(silent) == 1 else 'have'} no epoch"
    shortest = min((float(np.diff(side.history.times).min()) for side in (a, b) if len(side.history.times) > 1),
                   default=0.0)
    same = a.history.resolution + b.history.resolution + COMPARISON.equal_times * shortest
    if abs(float(begins[1] - begins[0])) > same:
        raise InvalidInput(
            f"nothing shows that A and B share a clock: A begins at {_seconds(begins[0])}, B at {_seconds(begins[1])}, "
            f"and {unsaid}. Say `align_clock=True` to find the offset from the attitudes, `offset=\"{START}\"` if both "
            f"begin at the same moment, `offset=\"0s\"` if the clocks are one, else A's time at B's time zero, like "
            f"`offset=\"{_seconds(begins[0] - begins[1]).replace(' ', '')}\"`."
        )
    return _make_laid(a, b, Decimal(0), f"assumed to be one: both begin at {_seconds(begins[0])}, and {unsaid}")


def _align(a: Source, b: Source, near: Decimal | None) -> Laid:
    """Return the offset that the attitudes show, of several the one nearest to another."""
    shift = a.begin - b.begin
    aligned = align_clocks(a.history, b.history, near=None if near is None else float(near - shift), shift=shift)
    begins, agreeing = Decimal(aligned.offset) + shift, None
    axes = "turned by a constant" if aligned.turned else "as given"
    beside = SUPPOSED if aligned.supposed else " beside a constant turn of the body axes"
    if aligned.agreeing is not None:
        alone, error = Decimal(aligned.agreeing[0]) + shift, aligned.agreeing[1]
        agreeing = float(alone), error
        if error < WORDING.worthwhile_error * aligned.error:
            beside += f"; if both have the same body axes, at {_measured(alone, error)} s"
    chosen = "" if near is None else f"; of several, the nearest to the {in_words(near)} s of `offset` is taken"
    words = (f"B's time zero is at {_measured(begins, aligned.error)} s of A, by the attitudes with the axes of space "
             f"{axes}, which leave {aligned.left:.2g} rad rms{beside}{chosen}")
    return Laid(aligned.offset, words, aligned._replace(offset=float(begins), agreeing=agreeing))


def _measured(value: Decimal, error: float) -> str:
    """Return a value with its error, both to the error's second digit, and no finer than a picosecond."""
    digits = int(np.clip(1 - np.floor(np.log10(max(error, 1e-12))), 0, 12))
    return f"{value:.{digits}f} ± {max(error, 1e-12):.2g}"


def _make_laid(a: Source, b: Source, offset: Decimal, words: str) -> Laid:
    """Return the offset between the stored times, each of which may count from its file's first stamp."""
    return Laid(float(offset + b.begin - a.begin), words)


def _seconds(time: Decimal) -> str:
    """Return a time to the nanosecond, without the digits that only double precision adds."""
    return f"{in_words(time.quantize(Decimal('1e-9')) if abs(time) < Decimal('1e15') else time)} s"
