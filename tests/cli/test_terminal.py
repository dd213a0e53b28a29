"""What is printed: nothing that a terminal obeys, in any encoding, and JSON that is JSON."""

import json
import os
import re
import subprocess
import sys
import threading

import pytest

from cli.specs import SPEC
from polhode.cli.main import main
from polhode.cli.terminal import in_ascii, say_if_long
from sweeping import first

WAIT = 120  # s, of a command in a process of its own
NAMED = f'name = "[red]b[/red] [link=file:///x]c[/link] :bomb: \\u001b]0;owned\\u0007 \\u202e Ω人"{SPEC}'
PRINTED = "[red]b[/red] [link=file:///x]c[/link] :bomb: \\x1b]0;owned\\x07 \\u202e "
ENCODINGS = ["ascii", "latin-1:strict", "cp1252", "utf-8", "cp437"]


@pytest.fixture
def spec(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "case.toml").write_text(NAMED, "utf-8")
    return "case.toml"


def run(arguments, capfd):
    with pytest.raises(SystemExit) as stopped:
        main(arguments)
    out, err = capfd.readouterr()
    return stopped.value.code or 0, out, err


def in_process(arguments, encoding="utf-8", **more):
    command = [sys.executable, "-m", "polhode.cli.main", *arguments]
    environment = os.environ | {"PYTHONIOENCODING": encoding}
    return subprocess.run(command, capture_output=True, timeout=WAIT, env=environment, check=False, **more)


def test_names_are_printed_as_they_stand(spec, capfd):
    code, out, _ = run(["body", spec], capfd)
    assert code == 0 and out.startswith(PRINTED) and "\x1b" not in out


def test_names_of_files_stay_in_their_line(spec, capfd):
    code, out, _ = run(["export", spec, "--to", "csv", "--out", "a\nb\x1b[31m.csv"], capfd)
    assert code == 0 and out.startswith("a\\nb\\x1b[31m.csv: 20 samples") and out.count("\n") == 1
    code, _, err = run(["body", "no\nsuch.toml"], capfd)
    assert code == 2 and err.startswith("polhode: no\\nsuch.toml: ") and err.count("\n") == 1


@pytest.mark.parametrize("arguments", ["body case.toml", "body case.toml --json", "--help", "report case.toml"])
def test_a_closed_output_is_an_error(spec, tmp_path, arguments):
    """Python then has no standard output at all; everything was computed, nothing was said, and the code was 0."""
    command = f'"{sys.executable}" -m polhode.cli.main {arguments} >&-'
    found = subprocess.run(["sh", "-c", command], capture_output=True, timeout=WAIT, check=False, text=True)
    assert found.returncode == 2 and found.stderr.startswith("polhode: standard output is closed")
    assert found.stderr.count("\n") == 1 and [path.name for path in tmp_path.iterdir()] == ["case.toml"]


@pytest.mark.parametrize("arguments", [["body", "no\x1b[31m.toml"], ["body", os.fsdecode(b"\xff\x1b.toml")],
                                       ["export", "case.toml", "--to", "\x1b[31mcsv"], ["bo\x1bdy"],
                                       ["body", "--\x1b[31mx"],
                                       ["report", "case.toml", "--figure-format", "[red]\x1b"]])  # fmt: skip
def test_messages_hold_nothing_that_a_terminal_obeys(spec, capfd, arguments):
    code, out, err = run(arguments, capfd)
    assert code == 2 and out == "" and err and "\x1b" not in err and "Traceback" not in err


@pytest.mark.long
@pytest.mark.parametrize("encoding", first(2, ENCODINGS))
def test_every_encoding_holds_the_output(spec, encoding):
    done = in_process(["body", spec], encoding)
    assert done.returncode == 0 and done.stderr == b""
    text = done.stdout.decode(encoding.split(":")[0])
    assert text.startswith(PRINTED) and re.search(r"kg m(²|\^2)", text)


@pytest.mark.long
def test_json_is_ascii_in_every_encoding(spec):
    done = in_process(["body", spec, "--json"], "ascii")
    assert done.returncode == 0 and json.loads(done.stdout.decode("ascii"))["name"].endswith("Ω人")


def test_names_of_files_that_are_not_utf8(spec, tmp_path, capfd):
    name = os.fsdecode(b"a\xff\x1b.toml")
    (tmp_path / "case.toml").rename(tmp_path / name)
    (tmp_path / name).write_text(NAMED.replace("name =", "#"), "utf-8")
    code, out, err = run(["export", name, "--to", "csv"], capfd)
    assert (code, err) == (0, "") and out.startswith("a\\udcff\\x1b.csv: ")
    assert (tmp_path / os.fsdecode(b"a\xff\x1b.csv")).is_file()
    code, out, err = run(["body", name, "--json"], capfd)
    assert (code, err) == (0, "") and json.loads(out)["name"] == "a\\udcff\\x1b"


def test_signs_have_names_in_ascii():
    assert in_ascii("−1.5 kg m² ≥ 30°, Ω·L, µ, naïve, 人") == "-1.5 kg m^2 >= 30 deg, Omega*L, u, naive, \\u4eba"


def test_a_command_that_takes_long_says_what_it_does(capsys):
    """Fits took half a minute and judgements a minute without a word."""
    with say_if_long("it waits", after=0.0):
        for thread in threading.enumerate():
            if isinstance(thread, threading.Timer):
                thread.join(10.0)
    with say_if_long("it is quick", after=60.0):
        pass
    said = capsys.readouterr()
    assert said.err == "polhode: it waits; Ctrl-C ends it\n" and not said.out
    assert not any(isinstance(thread, threading.Timer) and not thread.finished.is_set() for thread in
                   threading.enumerate())  # fmt: skip
