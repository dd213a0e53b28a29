"""Time stamps with more digits than a double holds, as seconds from the first of them.

A clock that counts nanoseconds since 1970 has nineteen digits, and doubles are 2.4e-7 s apart there. Differences of
stamps are short again, so they are formed before anything is rounded.
"""

from __future__ import annotations

from decimal import Context, Decimal, InvalidOperation
from pathlib import Path
from typing import NamedTuple

import numpy as np

from polhode.formats.header_words import IN_SECONDS, PER_SECOND
from polhode.formats.plain_table import read_texts
from polhode.formats.table_form import TableForm
from polhode.types import Array, Float64

_EXACT = Context(prec=400)  # digits; more than any stamp has that is read
IN_DECIMAL_SECONDS = {
    "s": Decimal(1), "ms": Decimal("1e-3"), "us": Decimal("1e-6"), "ns": Decimal("1e-9"), "min": Decimal(60),
    "h": Decimal(3600), "d": Decimal(86400),
}  # fmt: skip


class ClockLimits(NamedTuple):
    """A number that decides whether stamps are read as doubles or as exact decimals."""

    # s between doubles; a body at 100 rad/s turns by 1e-8 rad meanwhile. Stamps below six days are as fine
    max_spacing: float = 1e-10


LIMITS = ClockLimits()


class Clock(NamedTuple):
    """The times of a table.

    Attributes:
        times: (n,) [s], NaN where there is none.
        begin: the stamp that they count from [s]; 0 for unchanged stamps, and where there is an epoch.
        epoch: calendar date and time system of time zero; None where the stamps have none.
        resolution: uncertainty of the times by the digits of the stamps [s].
        remarks: on how stamps were read.
    """

    times: Float64[Array, "rows"]
    begin: Decimal
    epoch: tuple[str, str] | None = None
    resolution: float = 0.0
    remarks: tuple[str, ...] = ()

    @property
    def notes(self) -> tuple[str, ...]:
        """Notes on the zero of the times and on how stamps were read; none where times are the stamps themselves."""
        if not self.begin:
            return self.remarks
        apart = float(np.spacing(float(abs(self.begin))))
        note = (f"its times count from its first stamp, {in_words(self.begin)} s; from its clock's own zero numbers of "
                f"double precision tell only {apart:.2g} s apart.")
        return (note, *self.remarks)


def read_clock(
    path: Path, form: TableForm, column: int, unit: str, decimal: str, stamps: Float64[Array, "rows"],
    begin: Decimal | None = None,
) -> Clock:
    """Return times from a table's stamps, counted from the first where they have too many digits for doubles.

    Args:
        path, form: of the table.
        column: of the stamps, from 0.
        unit: of the stamps, one of ``header_words.TIME_UNITS``.
        decimal: "point" or "comma".
        stamps: (n,) as ``read_cells`` gives them, NaN where a cell is blank.
        begin: the stamp [s] that a file beside this one counts from, to count from it too; None to choose one.

    Raises:
        InvalidInput, FormatError: as reading the table does.
    """
    rounded = stamps / PER_SECOND[unit] if unit in PER_SECOND else stamps * IN_SECONDS[unit]
    finite = np.isfinite(rounded)
    largest = float(np.abs(rounded[finite]).max(initial=0.0))
    if float(np.spacing(largest)) <= LIMITS.max_spacing if begin is None else not begin:
        return Clock(rounded, Decimal(0))
    scale = IN_DECIMAL_SECONDS[unit]
    texts = (text.replace(",", ".") if decimal == "comma" else text for text in read_texts(path, form, column))
    times = np.full(len(stamps), np.nan)
    for k, text in enumerate(texts):
        if finite[k]:
            exact = _EXACT.multiply(Decimal(text), scale)
            begin = exact if begin is None else begin
            times[k] = float(_EXACT.subtract(exact, begin))
    return Clock(times, begin or Decimal(0))


def in_words(seconds: Decimal) -> str:
    """Return an exact number of seconds with all its digits, without trailing zeros.

    >>> in_words(Decimal("1605400445005000000") * Decimal("1e-9")), in_words(Decimal("-0E-9"))
    ('1605400445.005', '0')
    """
    text = f"{seconds:f}" if abs(seconds.adjusted()) < 25 else str(seconds)
    text = text.rstrip("0").rstrip(".") if "." in text and "E" not in text else text
    return "0" if text in ("-0", "") else text


def exact_number(text: str) -> Decimal:
    """Return the number that a text is, with every digit.

    Raises:
        ValueError: for anything but a finite number of digits, a point, a sign and a small exponent.
    """
    try:
        number = Decimal(text)
    except InvalidOperation:
        number = None
    if number is None or not text.isascii() or "_" in text or not number.is_finite() or abs(number.adjusted()) > 30:
        raise ValueError("must be a number in decimal digits")
    return number
