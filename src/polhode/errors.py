"""What can go wrong, in three kinds; every message names the value, the rule and the remedy."""

import reprlib
from typing import Any, NamedTuple

__all__ = ["FormatError", "InvalidInput", "NotConverged", "PolhodeError"]
JOINERS = "\u200c\u200d"  # invisible, but Persian, Hindi and emoji are spelt with them


class MessageLimits(NamedTuple):
    """Lengths [characters] from which on messages are shortened."""

    max_value: int = 120  # of a value in a message
    max_line: int = 1900


LIMITS = MessageLimits()


class _ShortRepr(reprlib.Repr):
    def __init__(self) -> None:
        super().__init__()
        self.maxstring = self.maxother = 90

    def repr_int(self, x: int, level: int) -> str:
        # Python itself refuses to write whole numbers of more than some thousand digits
        return super().repr_int(x, level) if x.bit_length() < 1000 else f"<whole number of {x.bit_length()} bits>"

    def repr_datetime(self, x: object, level: int) -> str:
        return str(x)

    repr_date = repr_time = repr_datetime


_SHORT = _ShortRepr()


def shown(value: Any) -> str:
    """Return a user's value for a message: as Python writes it, shortened, without control characters.

    >>> shown("60 rpm")
    "'60 rpm'"
    >>> len(shown("x" * 10**6)) <= LIMITS.max_value
    True
    """
    one_line = " ".join(line.strip() for line in _SHORT.repr(value).split("\n"))  # arrays are written in several
    return _cut(printable(one_line), LIMITS.max_value)


def printable(text: str) -> str:
    """Return text whose control characters, undecodable bytes and reversals of direction are escaped; lines stay.

    >>> printable("\\x1b[31mred")
    '\\\\x1b[31mred'
    """
    if text.isprintable():
        return text
    return "".join(c if c.isprintable() or c == "\n" or c in JOINERS else _escape_character(c) for c in text)


def one_line(text: str) -> str:
    """Return text for one line: as ``printable`` does, with ends of lines escaped too.

    >>> one_line("a\\nb.csv")
    'a\\\\nb.csv'
    """
    return printable(text).replace("\n", "\\n")


def _escape_character(character: str) -> str:
    return " " if character.isspace() and ord(character) > 127 else repr(character)[1:-1]


def _cut(text: str, longest: int) -> str:
    """Return text of at most so many characters, shortened before its end."""
    if len(text) <= longest:
        return text
    end = longest // 4
    return f"{text[: longest - end - 3]} … {text[len(text) - end :]}"


class PolhodeError(Exception):
    """Base of every error that polhode raises on purpose; its message is printable and of bounded length.

    Args:
        lines: of the message, each of which is printed in one.
    """

    def __init__(self, *lines: str) -> None:
        super().__init__(*(_cut(one_line(str(line)), LIMITS.max_line) for line in lines))

    def __str__(self) -> str:
        return "\n".join(self.args)


class InvalidInput(PolhodeError, ValueError):
    """A value that breaks a rule; the message names the rule, the value and the remedy."""


class NotConverged(PolhodeError, RuntimeError):
    """An iteration that did not reach its tolerance."""


class FormatError(InvalidInput):
    """A file that breaks its format; the message adds the path and, where known, the line."""


class NotInstalled(InvalidInput, ModuleNotFoundError):
    """A library that is missing, of those that polhode can do without; the message says how to install it."""

    def __init__(self, *lines: str, name: str | None = None) -> None:
        super().__init__(*lines)
        self.name = name


def __dir__() -> list[str]:
    return __all__
