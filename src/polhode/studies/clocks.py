"""Aligns the clocks of two attitude histories: by their epochs, by ``offset``, or by assumption."""

from __future__ import annotations

import re
from decimal import Decimal
from typing import NamedTuple

import numpy as np

from polhode.analysis._clock_offset import ClockOffset
from polhode.analysis.comparison import SAME_TIME, align_clocks
from polhode.errors import InvalidInput, shown
from polhode.formats.header_words import TIME_UNITS, find_unit
from polhode.formats.stamps import IN_DECIMAL_SECONDS, exact_number, in_words
from polhode.formats.time_scales import terrestrial_time
from polhode.studies.sources import Source

START, ALIGN = "start", "align"
_TIME = re.compile(r"\s*(?P<number>[-+]?[0-9.]+(?:[eE][-+]?[0-9]+)?)\s*(?P<unit>[A-Za-zµμ]+)\s*")


class Laid(NamedTuple):
    """A's time at B's time zero [s] in the times of the two histories, how it is known, and its estimate, if it is one.
    """

    offset: float
    words: str
    aligned: ClockOffset | None = None


def parse_offset(text: str | None) -> Decimal | str | None:
    """Return the parsed offset: A's clock at B's zero [s], exactly, START or ALIGN; None where none is given.

    Raises:
        InvalidInput: for what is neither.
    """
    if text is None or text in (START, ALIGN):
        return text
    match = _TIME.fullmatch(text)
    unit = find_unit(match["unit"], TIME_UNITS) if match else None
    if match and unit and _is_number(match["number"]):
        try:
            return exact_number(match["number"]) * IN_DECIMAL_SECONDS[unit]
        except ValueError:
            raise InvalidInput(f"`offset` must be between 1e-30 and 1e30 in size, or 0; got {shown(text)}. Say A's "
                               "time at B's time zero.") from None  # fmt: skip
    raise InvalidInput(f"`offset` must be `{START}`, or a time with its unit like `-68.5 s`; got {shown(text)}.")


def join_offset(offset: object, align: bool) -> str | None:
    """Return the text that asks for an estimated offset, or the offset that was said.

    Raises:
        InvalidInput: where both are given.
    """
    if align and offset is not None:
        raise InvalidInput("`offset` says the offset that `align_clock` would find. Leave one out.")
    return ALIGN if align else None if offset is None else str(offset)


def _is_number(text: str) -> bool:
    try:
        float(text)
    except ValueError:
        return False
    return True


def lay_side_by_side(a: Source, b: Source, offset: Decimal | str | None) -> Laid:
    """Return the relation between A's and B's times.

    Args:
        a, b: the two.
        offset: what ``parse_offset`` returns.

    Raises:
        InvalidInput: where nothing shows that both share a clock, and they begin at different times.
    """
    begins = [side.begin + Decimal(float(side.history.times[0])) for side in (a, b)]
    if offset == ALIGN:
        return _align(a, b)
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
                   default=0.0)  # fmt: skip
    same = a.history.resolution + b.history.resolution + SAME_TIME * shortest
    if abs(float(begins[1] - begins[0])) > same:
        raise InvalidInput(
            f"nothing shows that A and B share a clock: A begins at {_seconds(begins[0])}, B at {_seconds(begins[1])}, "
            f"and {unsaid}. Say `align_clock=True` to find the offset from the attitudes, `offset=\"{START}\"` if both "
            f"begin at the same moment, `offset=\"0s\"` if the clocks are one, else A's time at B's time zero, like "
            f"`offset=\"{_seconds(begins[0] - begins[1]).replace(' ', '')}\"`."
        )
    return _make_laid(a, b, Decimal(0), f"assumed to be one: both begin at {_seconds(begins[0])}, and {unsaid}")


def _align(a: Source, b: Source) -> Laid:
    """Return the offset that the attitudes show."""
    found = align_clocks(a.history, b.history)
    begins = Decimal(found.offset) + a.begin - b.begin
    turned = ", with the axes of space turned by a constant" if found.turned else ""
    words = (f"B's time zero is at {_measured(begins, found.error)} s of A, by the attitudes{turned}, which leave "
             f"{found.left:.2g} rad rms")  # fmt: skip
    return Laid(found.offset, words, found._replace(offset=float(begins)))


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
