"""Specs made to break the reader: every one ends soon, in one message."""

import os
import re
import socket
import warnings

import pytest

from polhode.errors import FormatError, InvalidInput
from polhode.kinds.reading import read_spec

GOOD = '[body]\nmoments = ["1 kg*m^2", "2 kg*m^2", "2.5 kg*m^2"]\n'
TOP = GOOD + 'mass = "1 kg"\n[system]\nkind = "heavy-top"\npivot = ["0 m", "0 m", "-1 m"]\n'
DISK = '[system]\nkind = "euler-disk"\nmass = "1 kg"\nradius = "1 m"\ntilt = "9 deg"\n'
LONGEST = 2000  # characters of a message
HUGE = "0x" + "1" * 20000  # hexadecimal numbers may have any length


def message_of(path):
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        with pytest.raises(InvalidInput) as caught:
            read_spec(path)
    text = str(caught.value)
    assert 0 < len(text) < LONGEST and all(line.isprintable() for line in text.splitlines())
    return text


@pytest.fixture
def refused(tmp_path):
    def refusal(content):
        path = tmp_path / "case.toml"
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return message_of(path)

    return refusal


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("a = " + "[" * 2000 + "]" * 2000, "deep inside each other"),
        ("a = " + "[" * 200 + "]" * 200, "deep inside each other"),
        ("a = " + "{a = " * 2000 + "1" + "}" * 2000, "deep inside each other"),
        ("a" + ".a" * 30 + " = 1", "deep inside each other"),
        ("[" + "a." * 40000 + "a]", "names with dots"),
        ("a" + ".a" * 40000 + " = 1", "names with dots"),
        ('"a="' + '."b="' * 40000 + " = 1", "names with dots"),
        ("a = " + "9" * 5000, "too many digits"),
        ("a = 1\na = 2", "not TOML"),
        ("[a]\n[a]", "not TOML"),
        ("a.b = 1\n[a.b.c]", "not TOML"),
        ("a = 2026-13-45", "not TOML"),
        ('a = "\\ud800"', "not TOML"),
        ("a = \x1b[31m", "not TOML"),
        (b"a = '\xff'", "UTF-8"),
        (GOOD.encode("utf-16"), "UTF-8"),
        (bytes(range(256)), "UTF-8"),
        (b"\0", "UTF-8"),
        ("#" * 2_000_000, "at most"),
        ("", "body: is missing"),
        (f"a = {HUGE}", "a: unknown key"),
        (GOOD + f"[time]\nsamples = {HUGE}", "samples: must be at most"),
        (GOOD + f"[time]\nsamples = {'9' * 400}", "samples: must be at most"),
        (GOOD + "[time]\nsamples = true", "must be a whole number"),
        (GOOD + "[time]\nuntil = 2026-01-01", "got 2026-01-01"),
        (GOOD + f"[spin]\nattitude = [{'9' * 400}, 0, 0, 0]", "four plain numbers"),
        (GOOD + f"[spin]\nattitude = [{HUGE}, 0, 0, 0]", "four plain numbers"),
        (GOOD + "[spin]\nattitude = [nan, 0, 0, 0]", "four plain numbers"),
        (GOOD + "[spin]\nattitude = [true, false, false, false]", "four plain numbers"),
        (GOOD + f"[spin]\nrate = '1 rpm'\nabout = {HUGE}", "must be one of 1, 2, 3"),
        (GOOD + f"[export]\nspice_id = -{'9' * 400}", "must be a negative whole number"),
        (GOOD + '[system]\nkind = ["x"]', "kind: must be one of"),
        (GOOD + "[system]\nkind = {a = 1}", "kind: must be one of"),
        (GOOD + "[system]\nkind = 2026-01-01", "kind: must be one of"),
        (f"system = {HUGE}\n{GOOD}", "must be a table"),
        ("system = true\n" + GOOD, "must be a table"),
        (TOP.replace("heavy", "heavy\\u0000"), "kind: must be one of"),
        (GOOD + f'[system]\nkind = "damped-body"\ndamping = {"9" * 400}', "plain finite number"),
        (GOOD + f'[system]\nkind = "spin-orbit"\neccentricity = {"9" * 400}', "plain finite number"),
        (DISK + f'dissipation = [{{law = "dry-contour-friction", coefficient = {"9" * 400}}}]', "plain finite number"),
        (DISK + 'dissipation = [{law = ["x"], coefficient = 1}]', "law: must be"),
        ("body = 1", "body: must be a table"),
        ("[[body]]\n[[body]]", "body: must be a table"),
        ('[body]\nparts = [{shape = ["box"], mass = {a = 1}}]', "must be one of"),
        ('[body]\nmesh = "a\\u0000.stl"\nmesh_unit = "m"\nmass = "1 kg"', "no such mesh file"),
        ('[body]\nmesh = "/dev/zero"\nmesh_unit = "m"\nmass = "1 kg"', "mesh file"),
        ('[body]\nmesh = ""\nmesh_unit = "m"\nmass = "1 kg"', "folder"),
        (f'[body]\nmolecule = "{"a" * 9999}.xyz"', "no such molecule file"),
        ('[body]\nurdf = "a\\u001b[31m\\u202e.urdf"', r"\\x1b\[31m\\u202e"),
        (GOOD + '"\\u001b[31m" = 1', r"\\x1b"),
        (GOOD + f'"{"k" * 10**5}" = 1', "unknown key"),
        (GOOD + "".join(f"k{k} = 1\n" for k in range(5000)), "5000 mistakes.*\n  and 49.. more"),
        ('[body]\nparts = [' + '{shape = "box"},' * 2000 + "]", "mistakes"),
        (GOOD + f'mass = "{"9" * 10**5} kg"', "at most 100 characters"),
        (GOOD + f"name = [{'1, ' * 10**5}]", "unknown key"),
    ],
    ids=lambda value: str(value)[:24] if isinstance(value, str) else "bytes",
)  # fmt: skip
def test_hostile_text(refused, text, words):
    assert re.search(words, refused(text), re.DOTALL)


@pytest.mark.parametrize(
    ("epoch", "system", "words"),
    [
        ("0001-01-01T00:00:00+14:00", "UTC", "outside the years 1 to 9999"),
        ("9999-12-31T23:59:59-23:59", "UTC", "outside the years 1 to 9999"),
        ("0001-01-01T00:00:00Z", "UTC", "before 1972"),
        ("2026-01-01T00:00:00+01:00", "TAI", "has a zone"),
        ("12:00:00", "UTC", "must be a date and time"),
        ('"2026-01-01T00:00:00+01:00"', "UTC", "must be an epoch"),
        ('"0000-00-00T00:00:00"', "UTC", "no such day"),
        ('"\\u0000\\u001b[2J"', "UTC", "must be an epoch"),
        ('"T"', "UTC", "must be an epoch"),
        (f'"2026-01-01T00:00:00.{"9" * 10**5}x"', "UTC", "must be an epoch"),
    ],
)
def test_epochs_beyond_the_calendar(refused, epoch, system, words):
    assert words in refused(f'{GOOD}[export]\nepoch = {epoch}\ntime_system = "{system}"')


@pytest.mark.parametrize("epoch", ["9999-12-31T23:59:59", "0001-01-01T00:00:00", "2026-01-01T00:00:00.5", "2026-01-01"])
def test_epochs_at_the_ends_of_the_calendar_are_right_in_tai(tmp_path, epoch):
    (tmp_path / "case.toml").write_text(f'{GOOD}[export]\nepoch = {epoch}\ntime_system = "TAI"')
    assert read_spec(tmp_path / "case.toml").labels.epoch == (epoch if "T" in epoch else f"{epoch}T00:00:00")


@pytest.mark.parametrize("name", ["a\\u001b[31mb", "two\\nlines", "back\\bspace"])
def test_names_hold_nothing_that_a_terminal_obeys(tmp_path, name):
    (tmp_path / "case.toml").write_text(f'name = "{name}"\n{GOOD}')
    assert read_spec(tmp_path / "case.toml").name.isprintable()


def test_names_of_files_that_are_not_utf8(tmp_path):
    path = tmp_path / os.fsdecode(b"\xff\x1b.toml")
    path.write_text(GOOD)
    assert read_spec(path).name == "\\udcff\\x1b"
    path.write_text("[body]")
    assert "\\udcff\\x1b.toml has 1 mistake" in message_of(path)


def test_what_is_no_file(tmp_path):
    (tmp_path / "loop.toml").symlink_to(tmp_path / "loop.toml")
    os.mkfifo(tmp_path / "pipe.toml")
    with socket.socket(socket.AF_UNIX) as listening:
        listening.bind(str(tmp_path / "socket.toml"))
        for path in (tmp_path, tmp_path / "pipe.toml", tmp_path / "socket.toml", tmp_path / "loop.toml",
                     tmp_path / "a\0b", tmp_path / ("a" * 9999), "/dev/zero", "/dev/full", "/dev/tty", ""):  # fmt: skip
            assert "file" in message_of(path)


def test_what_is_wrong_as_a_file_is_said_to_be_so(tmp_path):
    (tmp_path / "case.toml").write_text("a = [")
    with pytest.raises(FormatError):
        read_spec(tmp_path / "case.toml")
