"""Numbers as text for people."""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from decimal import Context, Decimal
from typing import Any, NamedTuple

import numpy as np

MINUTE, HOUR, DAY, YEAR = 60.0, 3600.0, 86400.0, 365.25 * 86400.0
LONG = ((2.0 * YEAR, YEAR, "a"), (2.0 * DAY, DAY, "d"), (2.0 * HOUR, HOUR, "h"), (2.0 * MINUTE, MINUTE, "min"))
"""Least time [s] that is read in a unit, the unit [s], and its name; a year is Julian."""
PREFIXES = {1e-3: "m", 1e-6: "µ", 1e-9: "n", 1e-12: "p", 1e-15: "f"}
LARGE_PREFIXES = {1e15: "P", 1e12: "T", 1e9: "G", 1e6: "M", 1e3: "k"}
ARCSECONDS = math.radians(0.01)  # angles below it are read in them
KEPT = {"momentum_norm": "|L|", "momentum_space": "L in space"}
RAISED = str.maketrans("0123456789", "⁰¹²³⁴⁵⁶⁷⁸⁹")


class UnitLimits(NamedTuple):
    """Numbers that decide in which unit times and rates are printed."""

    short: float = 1e-2  # s; shorter times are read in ms, µs …
    slow: float = 1e-4  # rad/s; slower rates are read in degrees a day
    fast: float = 1e5  # rad/s; faster rates are read in turns a second


LIMITS = UnitLimits()


def number(value: float | None, unit: str = "", digits: int = 8) -> str | None:
    """Return a number with its unit; None where it is not defined, which is None or NaN.

    >>> number(0.5, "J"), number(float("inf")), number(float("nan"))
    ('0.5 J', 'infinite', None)
    """
    return _unless_infinite(value, lambda x: f"{x:.{digits}g} {unit}".rstrip())


def write_count(count: int, thing: str) -> str:
    """Return a count with its noun: "1 body", "3 bodies"."""
    return f"{count} {thing}" if count == 1 else f"{count} {thing}s"


def uncertain(value: float, error: float | None, unit: str = "", digits: int = 1) -> str:
    """Return a value with its uncertainty, with no digits finer than that; it has one digit, two if the first is a 1.

    Spectroscopists give two always, ``digits=2``, as constants go into further computations.

    >>> uncertain(81.39190987, 9.1, "s"), uncertain(-0.14827, 0.0642), uncertain(0.35792, 0.0134)
    ('81 ± 9 s', '-0.15 ± 0.06', '0.358 ± 0.013')
    >>> uncertain(1234.5, 90.0, "s"), uncertain(6.143323e-06, 2.2e-11), uncertain(0.3, 4.0), uncertain(0.5, None)
    ('1230 ± 90 s', '6.14332e-06 ± 2e-11', '0 ± 4', '0.5')
    >>> uncertain(81.39190987, 9.1, "s", 2), uncertain(0.35792, 0.0134, digits=2)
    ('81.4 ± 9.1 s', '0.358 ± 0.013')

    NaN means an unknown error, and few digits are then given:

    >>> uncertain(0.35792, float("nan"))
    'about 0.36'
    """
    rough = 2  # digits of an estimate whose error is not known
    if error is not None and math.isnan(error):
        return f"about {value:.{rough}g} {unit}".rstrip()
    if error is None or not (math.isfinite(error) and error > 0.0 and math.isfinite(value)):
        return f"{value:.8g} {unit}".rstrip()
    longer, short = f"{error:.1e}", f"{error:.0e}"
    if digits == 2:
        short = longer
    elif short.startswith("1"):
        short = longer if longer.startswith("1") else short.replace("e", ".0e")
    last = int(Decimal(short).as_tuple().exponent)  # the power of ten of the last digit that is known
    many = Context(prec=700)  # from the largest double down to the smallest
    rounded = many.add(many.quantize(Decimal(value), Decimal(1).scaleb(last)), Decimal(0))
    if -4 <= rounded.adjusted() < 6:
        words, said = f"{rounded:f}", f"{Decimal(short):f}"
    else:
        words, said = f"{float(rounded):.{min(max(rounded.adjusted() - last, 0), 16)}e}", short
    return f"{words} ± {said} {unit}".rstrip()


def count_known_digits(value: float, error: float | None, most: int = 8) -> int:
    """Return how many digits of a value, at least one, are no finer than its uncertainty.

    >>> count_known_digits(6.143323e-06, 2.2e-11), count_known_digits(0.5, 0.01), count_known_digits(0.5, None)
    (6, 2, 8)
    """
    if error is None or not (math.isfinite(error) and error > 0.0 and value and math.isfinite(value)):
        return most
    return min(max(math.floor(math.log10(abs(value))) - math.floor(math.log10(error)) + 1, 1), most)


_NUMBER = r"[-+]?\d+(?:\.\d+)?(?:e[-+]?\d+)?"
_NUMBERS = re.compile(rf"\({_NUMBER}(?:, {_NUMBER})+\)|(?<![\w.,]){_NUMBER}(?![\w,]*\d)")


def round_words(words: str, error: float | None) -> str:
    """Return a text without digits in its numbers that are finer than an error relative to each number's size.

    The components of a vector have the size of the largest. Numbers with "±" before or after them say their own error.

    Args:
        words: with numbers.
        error: relative; zero where all digits are known, None where it is not estimated, which leaves three digits.

    >>> round_words("(-0.264371, 0.562968, 0.00078) T", 2e-3), round_words("28.6479° = 0.5 rad", 1e-3)
    ('(-0.264, 0.563, 0.001) T', '28.65° = 0.5 rad')
    >>> round_words("-1.0907448e-23 J of 1024 spins", None), round_words("1.3456 ± 0.0012 meV", None)
    ('-1.09e-23 J of 1024 spins', '1.3456 ± 0.0012 meV')
    """
    # digits of a number whose error is not estimated: fewer than people would copy, enough for a picture
    kept_digits = 3
    if error == 0.0:
        return words

    def rounded(match: re.Match[str]) -> str:
        begin, end = match.span()
        if "±" in words[max(begin - 2, 0) : end + 2]:
            return match[0]
        size = max(abs(float(x)) for x in re.findall(_NUMBER, match[0]))
        if not 0.0 < size < math.inf:
            return match[0]
        leading = math.floor(math.log10(size))
        if error is None:
            last = leading - kept_digits + 1
        else:
            last = leading if not math.isfinite(error) else min(math.floor(math.log10(error * size)), leading)
        return re.sub(_NUMBER, lambda one: _cut(one[0], last), match[0])

    return _NUMBERS.sub(rounded, words)


def _cut(text: str, last: int) -> str:
    """Return a number without digits finer than those of 10^last."""
    whole = 4  # digits up to which whole numbers in a text are counts, and stay unchanged
    mantissa, _, power = text.partition("e")
    finest = int(power or 0) - len(mantissa.partition(".")[2])
    if finest >= last or (finest == 0 and len(mantissa.lstrip("+-")) <= whole):
        return text
    number = round(Decimal(text), -last)
    if not number:
        return "0"
    return f"{float(number):.{max(number.adjusted() - last, 0)}e}" if power else f"{number:.{max(-last, 0)}f}"


def angle(value: float | None, error: float | None = None) -> str | None:
    """Return an angle [rad] in radians and degrees, or arcseconds, with no digits finer than its uncertainty.

    >>> angle(0.5), angle(-1e-8), angle(0.123456789, 0.002)
    ('0.5 rad = 28.6479°', '-1e-08 rad = -0.00206265″', '0.123 rad = 7.07°')
    """

    def words(x: float) -> str:
        digits = count_known_digits(x, error)
        return f"{x:.{digits}g} rad = {degrees(x, min(digits, 6))}"

    return _unless_infinite(value, words)


def angles(values: Any) -> str:
    """Return the range of an angle [rad] from its smallest and largest value, one number where both have one text.

    >>> angles((0.5, 0.75)), angles((0.5, 0.5))
    ('28.6479° to 42.9718°', '28.6479°')
    """
    first, last = (degrees(float(x)) for x in values)
    return first if first == last else f"{first} to {last}"


def degrees(value: float, digits: int = 6) -> str:
    """Return an angle [rad] in degrees, a small one in arcseconds."""
    angle = math.degrees(value)
    small = 0.0 < abs(value) < ARCSECONDS
    return f"{3600.0 * angle:.{digits}g}″" if small else f"{angle:.{digits}g}°"


def rate(value: float | None) -> str | None:
    """Return a rate [rad/s], with turns per minute, degrees per day or turns per second, by its size.

    >>> rate(7.292115e-5), rate(2.0), rate(3e12)
    ('7.292115e-05 rad/s = 360.986°/d', '2 rad/s = 19.0986 rpm', '3e+12 rad/s = 0.477465 THz')
    """
    return _unless_infinite(value, lambda x: f"{x:.8g} rad/s = {write_rate(x)}")


def write_rate(value: float) -> str:
    """Return a rate [rad/s] in the unit that it is read by."""
    size = abs(value)
    if 0.0 < size < LIMITS.slow:
        return f"{math.degrees(value) * DAY:.6g}°/d"
    if size < LIMITS.fast:
        return f"{value * 30.0 / math.pi:.6g} rpm"
    turns = value / (2.0 * math.pi)
    unit = next((unit for unit in LARGE_PREFIXES if abs(turns) >= 0.1 * unit), 1.0)
    return f"{turns / unit:.6g} {LARGE_PREFIXES.get(unit, '')}Hz"


def duration(value: float | None) -> str | None:
    """Return a time [s], with the unit that it is read by where that is another.

    >>> duration(2.5), duration(952564.67), duration(3.09e-12)
    ('2.5 s', '952564.67 s = 11.0251 d', '3.09e-12 s = 3.09 ps')
    """

    def words(x: float) -> str:
        read = in_its_unit(x)
        return f"{x:.8g} s" if read.endswith(" s") else f"{x:.8g} s = {read}"

    return _unless_infinite(value, words)


def in_its_unit(value: float) -> str:
    """Return a time [s] in the unit that it is read by: "3.09 ps", "2.5 s", "11.025 d"."""
    size = abs(value)
    for least, unit, name in LONG:
        if size >= least:
            return f"{value / unit:.6g} {name}"
    if not 0.0 < size < LIMITS.short:
        return f"{value:.6g} s"
    unit = next((unit for unit in PREFIXES if size >= unit), 1e-15)
    return f"{value / unit:.6g} {PREFIXES[unit]}s"


def write_value(value: Any, unit: str = "") -> str | None:
    """Return a value for people, by its unit; None for None and for text that is empty.

    >>> write_value(0.5, "rad"), write_value((1.0, 2.0), "m"), write_value("none")
    ('0.5 rad = 28.6479°', '(1, 2) m', 'none')
    """
    if value is None or isinstance(value, str):
        return value or None
    if isinstance(value, bool):
        return "yes" if value else "no"
    if np.ndim(value):
        return vector(value, unit)
    words = {"rad": angle, "rad/s": rate, "s": duration}.get(unit)
    return words(float(value)) if words else number(float(value), unit)


def _unless_infinite(value: float | None, words: Callable[[float], str]) -> str | None:
    if value is None or math.isnan(value):
        return None
    return "infinite" if math.isinf(value) else words(value)


def unit_in_words(unit: str) -> str:
    """Return a unit as people write it, from what CF metadata writes.

    >>> [unit_in_words(unit) for unit in ("kg m2 s-1", "s-4", "J", "1")]
    ['kg m²/s', '1/s⁴', 'J', '']
    """
    over, under = [], []
    for name, power in re.findall(r"([A-Za-z]+)(-?\d*)", unit):
        size = power.removeprefix("-")
        (under if power.startswith("-") else over).append(name + ("" if size in ("", "1") else size.translate(RAISED)))
    return " ".join(over) if not under else f"{' '.join(over) or '1'}/{' '.join(under)}"


def vector(values: Any, unit: str = "", size: float = 0.0, digits: int = 6) -> str:
    """Return components with ``digits`` digits, zero where small compared with a size or the largest."""
    largest = max(size, *(abs(x) for x in values))
    cleaned = [0.0 if abs(x) < 1e-15 * largest else x for x in values]
    return "(" + ", ".join(f"{x:.{digits}g}" for x in cleaned) + f") {unit}".rstrip()


def distinct(values: Any, unit: str = "") -> str:
    """Return numbers with as many digits as it takes to tell apart those that differ."""
    ways = ([f"{x:.{digits}g}" for x in values] for digits in range(6, 18))
    shown = next(way for way in ways if len(set(way)) == len({float(x) for x in values}))
    return f"({', '.join(shown)}) {unit}".rstrip()


def drifts(values: dict[str, Any]) -> str:
    """Return drifts by name, the largest where each copy has its own."""
    return ", ".join(f"{KEPT.get(name, name.replace('_', ' '))} {float(np.max(x)):.1e}" for name, x in values.items())


def order_words(m: int, n: int) -> str:
    """Return a frequency of a tumbler, m/P_φ + n/P_ψ, as people write it.

    >>> order_words(2, -2), order_words(1, 0), order_words(0, 2), order_words(-1, 3)
    ('2/P_φ − 2/P_ψ', '1/P_φ', '2/P_ψ', '3/P_ψ − 1/P_φ')
    """
    parts = [(m, "P_φ"), (n, "P_ψ")]
    if m < 0:
        parts.reverse()
    parts = [(k, name) for k, name in parts if k]
    words = f"{'−' if parts[0][0] < 0 else ''}{abs(parts[0][0])}/{parts[0][1]}"
    return words + "".join(f" {'−' if k < 0 else '+'} {abs(k)}/{name}" for k, name in parts[1:])
