"""Checks of what comes in from outside: numbers, whole numbers, arrays, words; each in one sentence of one form.

The sentence names the argument, the rule, the value and the remedy. What is checked is returned, as a float, a whole
number, an array of float64 or the word. What no double holds is refused as everywhere, by ``require_doubles``.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Sequence
from typing import Any, NoReturn, TypeVar

import numpy as np

from polhode._base.arrays.namespaces import as_float64, is_traced, namespace, require_doubles
from polhode.errors import InvalidInput, shown

MOST_SHOWN = 9
"""Numbers of an array up to which a message shows them all; of more it shows the first wrong one."""
NO_NUMBERS = bool, np.bool_, str, bytes, np.datetime64, np.timedelta64  # though ``float`` makes some of them
REAL_KINDS = "iufO"  # of NumPy's types
_WORDS = ("no", "one", "two", "three", "four", "five", "six")
Kind = TypeVar("Kind")
_ARGUMENT = re.compile(r"[^\W\d][\w.\[\]…]*")


def subject(name: str) -> str:
    """Return what a sentence begins with: an argument in backticks; a phrase or an option as it is.

    >>> subject("times"), subject("the amplitude"), subject("--to")
    ('`times`', 'the amplitude', '--to')
    """
    return f"`{name}`" if _ARGUMENT.fullmatch(name) else name


def refuse(name: str, rule: str, value: Any, remedy: str = "", error: type[InvalidInput] = InvalidInput) -> NoReturn:
    """Raise the sentence of all checks, about an argument or a phrase, what it must be, what it is and the remedy."""
    _raise(name, rule, shown(value.item() if isinstance(value, np.generic) else value), remedy, error)


def number(
    name: str, value: Any, unit: str = "", *, above: float | None = None, least: float | None = None,
    below: float | None = None, most: float | None = None, infinite: bool = False, rule: str = "", remedy: str = "",
) -> float:
    """Return one real number as a float.

    Args:
        name: of the argument, or a phrase for it.
        value: Python's, NumPy's or JAX's number, an array of no axes, a Fraction or a Decimal.
        unit: for the message.
        above, least, below, most: bounds; the number may equal the second and the last.
        infinite: whether an infinity is one.
        rule: in place of the words that the bounds give.
        remedy: one or more sentences.

    Raises:
        InvalidInput: for a number out of these bounds, NaN, and all that is not one known real number of 64 bits; truth
            values and text among them.

    >>> number("rate", 2, above=0)
    2.0
    >>> number("rate", -1, "rad/s", above=0)
    Traceback (most recent call last):
    polhode.errors.InvalidInput: `rate` must be positive and finite [rad/s]; got -1.
    """
    if is_traced(value):
        _raise(name, "a known number, not one traced by JAX", "a traced one", remedy)
    x = _as_float(value)
    if isinstance(value, str | bytes):
        remedy = "Functions take SI numbers; text with units is for specs."
    elif not isinstance(value, NO_NUMBERS) and (not math.isfinite(x) or hasattr(value, "dtype")):
        require_doubles(**{name: value})
    low = (above is None or x > above) and (least is None or x >= least)
    high = (below is None or x < below) and (most is None or x <= most)
    if not (low and high and (math.isfinite(x) or (infinite and not math.isnan(x)))):
        refuse(name, (rule or _bounds(above, least, below, most, infinite)) + _in(unit), value, remedy)
    return x


def positive(**named: Any) -> list[float]:
    """Return numbers that are positive and finite, as ``number`` does."""
    return [number(name, value, above=0) for name, value in named.items()]


def whole(
    name: str, value: Any, least: int | None = None, most: int | None = None, *, what: str = "", remedy: str = ""
) -> int:
    """Return one whole number as an int.

    Args:
        name, value, remedy: as for ``number``.
        least, most: bounds that it may equal.
        what: it counts, for the message.

    Raises:
        InvalidInput: for anything else, truth values and 2.0 among it.

    >>> whole("count", 2.5, 1, what="vortices")
    Traceback (most recent call last):
    polhode.errors.InvalidInput: `count` must be a whole number of vortices, at least 1; got 2.5.
    """
    if isinstance(value, int | np.integer) and not isinstance(value, bool | np.timedelta64):
        n = int(value)
        if (least is None or n >= least) and (most is None or n <= most):
            return n
    low = f" from {least:,} to {most:,}" if least is not None and most is not None else ""
    low = low or (f", at least {least:,}" if least is not None else f", at most {most:,}" if most is not None else "")
    refuse(name, f"a whole number{f' of {what}' if what else ''}{low}", value, remedy)


def one_of(
    name: str, value: Any, names: Iterable[str], remedy: str = "", error: type[InvalidInput] = InvalidInput
) -> str:
    """Return a word, one of several.

    Raises:
        InvalidInput: or the kind ``error``, for anything else.

    >>> one_of("frame", "orbit", ("body", "space"))
    Traceback (most recent call last):
    polhode.errors.InvalidInput: `frame` must be "body" or "space"; got 'orbit'.
    """
    known = tuple(names)
    if not isinstance(value, str) or value not in known:
        quoted = [f'"{one}"' for one in known]
        refuse(name, " or ".join(quoted) if len(known) < 3 else f"one of {', '.join(quoted)}", value, remedy, error)
    return value


def instance(name: str, value: Any, kinds: type[Kind] | tuple[type[Kind], ...], rule: str, remedy: str = "") -> Kind:
    """Return an object of a class, or of one of several.

    Raises:
        InvalidInput: for anything else, with the rule and the remedy.
    """
    if not isinstance(value, kinds):
        refuse(name, rule, value, remedy)
    return value


def array(
    name: str, value: Any, shape: Sequence[int | str] | None = None, unit: str = "", *, above: float | None = None,
    least: float | None = None, ascending: bool = False, not_all_zero: bool = False, traced: bool = False,
    rule: str = "", remedy: str = "",
) -> Any:
    """Return finite numbers as an array of float64.

    Args:
        name, unit, remedy: as for ``number``.
        value: array or nested lists.
        shape: sizes of the axes; a letter is any size, the same wherever it stands; "…" in front is any axes. None is
            any shape.
        above, least: bounds of every number, which may equal the second.
        ascending: whether none along the last axis may be below the one before.
        not_all_zero: whether one of them must not be zero.
        traced: whether arrays that JAX traces are let through, of which nothing but the shape is known; JAX's arrays
            then stay JAX's.
        rule: in place of the words that the shape and the bounds give.

    Raises:
        InvalidInput: for another shape, numbers that are not finite or out of bounds, and all that is no array of real
            numbers of 64 bits.

    >>> array("moments", [1, 2, 0], (3,), "kg m²", above=0)
    Traceback (most recent call last):
    polhode.errors.InvalidInput: `moments` must be three positive finite numbers [kg m²]; got [1, 2, 0].
    >>> array("rows", [1, 2], ("n", 3))
    Traceback (most recent call last):
    polhode.errors.InvalidInput: `rows` must be finite numbers of shape (n, 3); got shape (2,).
    """
    if is_traced(value) and not traced:
        _raise(name, "known numbers, not traced by JAX", "traced ones", remedy)
    if not is_traced(value) and _has_no_numbers(value):
        refuse(name, (rule or _numbers(shape, above, least, ascending, not_all_zero)) + _in(unit), value, remedy)
    values = as_float64(namespace(value) if traced else np, value, name)
    rule = (rule or _numbers(shape, above, least, ascending, not_all_zero)) + _in(unit)
    if shape is not None and not _fits(values.shape, shape):
        _raise(name, rule, f"shape {tuple(values.shape)}", remedy)
    if is_traced(values):
        return values
    known = np.asarray(values)
    good = np.asarray(np.isfinite(known))
    if above is not None:
        good &= known > above
    if least is not None:
        good &= known >= least
    if ascending and good.all():
        good[..., 1:] &= np.diff(known) >= 0.0
    if not good.all() or (not_all_zero and not known.any()):
        _raise(name, rule, _wrong(value, known, good), remedy)
    return values


def _raise(name: str, rule: str, got: str, remedy: str, error: type[InvalidInput] = InvalidInput) -> NoReturn:
    raise error(f"{subject(name)} must be {rule}; got {got}.{f' {remedy}' if remedy else ''}")


def _as_float(value: Any) -> float:
    """Return the double of one real number; of anything else NaN, which no rule lets through."""
    if isinstance(value, NO_NUMBERS):
        return math.nan
    try:
        return float(value) if np.ndim(value) == 0 and np.asarray(value).dtype.kind in REAL_KINDS else math.nan
    except (TypeError, ValueError, OverflowError):
        return math.nan


def _has_no_numbers(value: Any) -> bool:
    """Return whether truth values or complex numbers are among those of an array or of nested lists."""
    if hasattr(value, "dtype"):
        # whole arrays of complex numbers are refused with the words of ``as_float64``
        return value.dtype == bool or (not np.ndim(value) and np.iscomplexobj(value))
    if isinstance(value, list | tuple):
        return any(map(_has_no_numbers, value))
    return isinstance(value, bool | np.bool_ | complex)


def _fits(got: Sequence[int], wanted: Sequence[int | str]) -> bool:
    if wanted and wanted[0] == "…":
        wanted = wanted[1:]
        got = got[max(0, len(got) - len(wanted)) :]
    letters: dict[str, int] = {}
    return len(got) == len(wanted) and all(
        n == (letters.setdefault(one, n) if isinstance(one, str) else one) for n, one in zip(got, wanted, strict=True)
    )


def _wrong(value: Any, known: np.ndarray, good: np.ndarray) -> str:
    """Return what a message shows of an array."""
    if known.size <= MOST_SHOWN:
        return shown(value.tolist() if hasattr(value, "tolist") else value)
    if good.all():
        return "zeros alone"
    first = tuple(np.argwhere(~good)[0].tolist())
    return f"{known[first]:g} at index {first[0] if len(first) == 1 else first}"


def _bounds(above: float | None, least: float | None, below: float | None, most: float | None, infinite: bool) -> str:
    """Return the words of one number's bounds."""
    least_, above_, most_, below_ = map(_shortly, (least, above, most, below))
    low = f"above {above_}" if above_ else f"at least {least_}" if least_ else ""
    high = f"below {below_}" if below_ else f"at most {most_}" if most_ else ""
    if low and high:
        if above_ and below_:
            return f"between {above_} and {below_}"
        return f"from {least_} to {most_}" if least_ and most_ else f"{low} and {high}"
    if above == 0:
        return "positive" if infinite else "positive and finite"
    if least == 0:
        return "a number that is not negative" if infinite else "finite and not negative"
    kind = "a number" if infinite else "a finite number"
    return f"{kind} {low or high}".rstrip()


def _shortly(bound: float | None) -> str:
    """Return a bound in as few digits as say it."""
    if bound is None:
        return ""
    return f"{bound:g}" if float(f"{bound:g}") == bound else repr(float(bound))


def _numbers(
    shape: Sequence[int | str] | None, above: float | None, least: float | None, ascending: bool, not_all_zero: bool
) -> str:
    """Return the words of an array's shape and bounds."""
    kind = "positive finite" if above == 0 else "finite"
    match shape:
        case None:
            words = f"{kind} numbers"
        case ():
            words = f"a {kind} number"
        case (int(n),):
            words = f"{_WORDS[n] if n < len(_WORDS) else n} {kind} numbers"
        case _:
            words = f"{kind} numbers of shape ({', '.join(map(str, shape))}{',' * (len(shape) == 1)})"
    if above:
        words += f" above {above:g}"
    if least is not None:
        words += f" at least {least:g}" if least else ", not negative"
    return words + (" in ascending order" if ascending else "") + (", not all zero" if not_all_zero else "")


def _in(unit: str) -> str:
    return f" [{unit}]" if unit else ""
