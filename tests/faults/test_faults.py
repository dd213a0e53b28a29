"""Commands that are killed, stopped, unheard or unreadable end as promised, and lose nothing.

After each: its exit code, the older file as it was or the newer one whole, nothing left behind, one message and no
traceback. After a kill that nothing can catch, what is left goes with the next command that writes there.
"""

import os
import random
import signal
import sys

import pytest

from faults.harness import CODES, COMMANDS, PATIENCE, Reference, environment, moments, prepare, start, strike
from sweeping import first

pytestmark = [
    pytest.mark.skipif(not sys.platform.startswith("linux"), reason="signals are told by /proc"),
    pytest.mark.timeout(10 * PATIENCE),
]
SEED = 20261121
EACH = 6  # moments of each command in the sweep: 60 in all
CSV, CK = ("export", "case.toml", "--to", "csv"), ("export", "case.toml", "--to", "ck")
# free bodies are evaluated at once; this one is integrated for minutes
LONG = """
[system]
kind = "spin-orbit"
eccentricity = 0.1
orbital_period = "21.28 day"
asphericity = 0.89
[time]
until = "{until}"
samples = 50
"""


@pytest.mark.sweep
@pytest.mark.parametrize(
    ("command", "numbers"), first(1, [(CK, [signal.SIGINT, signal.SIGKILL]), (CSV, [signal.SIGTERM, signal.SIGHUP])])
)
def test_signals_at_a_few_moments(tmp_path, command, numbers):
    reference = Reference(command, tmp_path / command[-1])
    for k, number in enumerate(numbers):
        moment = None if k else random.Random(SEED).uniform(0.0, reference.seconds)
        reference.attack(tmp_path / f"{command[-1]}-{k}", number, moment)


@pytest.mark.sweep
@pytest.mark.parametrize("command", COMMANDS, ids=" ".join)
def test_signals_at_many_moments(tmp_path, command):
    reference, ended = Reference(command, tmp_path / "reference"), set()
    chance = random.Random(SEED)
    for k, moment in enumerate(moments(SEED, EACH, reference.seconds)):
        number = chance.choice([*CODES, signal.SIGKILL])
        ended.add(reference.attack(tmp_path / str(k), number, moment))
    assert ended & {*CODES.values(), -signal.SIGKILL}  # some at least came in time


@pytest.mark.sweep
@pytest.mark.parametrize("command", ["report", "view", "export"])
def test_a_long_run_can_be_stopped(tmp_path, command):
    (tmp_path / "long.toml").write_text(LONG.format(until="30000 year"), "utf-8")
    more = {"view": ["--no-open"], "export": ["--to", "csv"]}.get(command, [])
    code, err = strike([command, "long.toml", *more], tmp_path, signal.SIGINT, 25.0)  # after compiling
    lines = err.splitlines()
    assert code == 130 and lines[-1] == "polhode: stopped by SIGINT."
    assert len(lines) == 2 and "this takes about" in lines[0] and "Ctrl-C ends it" in lines[0]
    assert [path.name for path in tmp_path.iterdir()] == ["long.toml"]


@pytest.mark.sweep
def test_a_run_without_end_is_refused(tmp_path):
    prepare(tmp_path / "a")
    (tmp_path / "a" / "case.toml").write_text(LONG.format(until="1e6 year"), "utf-8")
    done = start(["report", "case.toml"], tmp_path / "a")
    out, err = (text.decode() for text in done.communicate(timeout=PATIENCE))
    assert done.returncode == 2 and out == "" and err.count("\n") == 1
    assert err.startswith("polhode: case.toml: `time.until` of ") and "at most" in err
    assert sorted(path.name for path in (tmp_path / "a").iterdir()) == ["case.toml", "other.toml"]


def run(folder, *command, **more):
    done = start(command, folder, **more)
    out, err = done.communicate(timeout=PATIENCE)
    return done.returncode, out, err


@pytest.mark.long_after(1)
@pytest.mark.parametrize("command", [("body", "case.toml"), ("body", "case.toml", "--json")], ids=["people", "json"])
def test_output_that_nobody_reads_ends_quietly(tmp_path, command):
    read, write = os.pipe()
    os.close(read)
    code, _, err = run(prepare(tmp_path / "a"), *command, stdout=write)
    os.close(write)
    assert code == 1 and err == b""


@pytest.mark.long
def test_output_that_cannot_be_written_is_one_message(tmp_path):
    with open("/dev/full", "wb") as full:  # noqa: PTH123
        code, _, err = run(prepare(tmp_path / "a"), "body", "case.toml", stdout=full)
    assert code == 2 and err.decode().count("\n") == 1 and b"No space left on device" in err


@pytest.mark.long
@pytest.mark.parametrize("encoding", first(1, ["ascii", "cp1252"]))
def test_terminals_with_few_letters(tmp_path, encoding):
    folder = prepare(tmp_path / "a")
    code, out, err = run(folder, "body", "case.toml", env=environment(PYTHONIOENCODING=encoding))
    assert code == 0 and err == b"" and out.decode(encoding)
    text = (folder / "case.toml").read_text("utf-8").replace("samples", "samplés")
    (folder / "case.toml").write_text(text, "utf-8")
    code, out, err = run(folder, "body", "case.toml", env=environment(PYTHONIOENCODING=encoding))
    assert code == 2 and out == b"" and b"Traceback" not in err and err.decode(encoding).startswith("polhode: ")
