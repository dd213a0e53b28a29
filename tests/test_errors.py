"""Messages: whatever a value is, they can be printed and have an end."""

import pickle

import numpy as np
import pytest

from polhode.errors import LIMITS, FormatError, InvalidInput, printable, shown


def nested(depth):
    value = []
    for _ in range(depth):
        value = [value]
    return value


class Mute:
    def __repr__(self):
        raise RuntimeError("no")


@pytest.mark.parametrize(
    "value",
    [10**5000, -(10**400), nested(20000), {"a": nested(9000)}, "x" * 10**7, "\x1b[31m\0\ud800\u202e", Mute(),
     [b"\xff"] * 9**6, np.zeros((99, 99)), [[["long" * 99] * 9] * 9] * 9],
    ids=lambda value: type(value).__name__,
)  # fmt: skip
def test_any_value_is_shown_shortly_and_printably(value):
    assert 0 < len(shown(value)) <= LIMITS.max_value and shown(value).isprintable()


@pytest.mark.parametrize("value", ["60 rpm", 3, 2.5, True, None, ["1 m", "2 m"], [[1.0, 2.0], [3.0, 4.0]], {"a": 1}])
def test_ordinary_values_are_shown_as_python_writes_them(value):
    assert shown(value) == repr(value)


def test_messages_escape_what_a_terminal_would_obey():
    error = InvalidInput("a\x1b]0;owned\x07.toml: \udcff \u202egnp.exe\r\nsecond line")
    assert str(error) == "a\\x1b]0;owned\\x07.toml: \\udcff \\u202egnp.exe\\r\\nsecond line"


def test_only_lines_of_the_message_itself_are_lines():
    error = InvalidInput("a\nb.toml has 2 mistakes:", "  c: d\ne")
    assert str(error) == "a\\nb.toml has 2 mistakes:\n  c: d\\ne"
    assert str(pickle.loads(pickle.dumps(error))) == str(error)
    assert str(pickle.loads(pickle.dumps(error))) == str(error)


def test_messages_end():
    text = str(FormatError("begin" + "x" * 10**7 + "end"))
    assert len(text) <= LIMITS.max_line and text.startswith("begin") and text.endswith("end")


def test_what_people_write_stays():
    for text in ("I₁ + I₂ ≥ I₃ – Körper Ω", "人工衛星", "نیم‌فاصله", "👩‍🚀"):
        assert printable(text) == text
