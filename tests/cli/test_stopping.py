"""Signals that stop a command."""

import signal
import subprocess
import sys

import pytest

from polhode.cli import main as entry
from polhode.cli.stopping import SIGNALS, Stopped, stop_on_signals

PATIENCE = 60  # s until a process of the tests counts as hanging
CODES = {signal.SIGINT: 130, signal.SIGTERM: 143, signal.SIGHUP: 129}


@pytest.fixture(autouse=True)
def handlers():
    """Handlers are as before in the end."""
    before = [signal.getsignal(number) for number in SIGNALS]
    yield
    assert [signal.getsignal(number) for number in SIGNALS] == before
    assert signal.set_wakeup_fd(-1) == -1


@pytest.mark.parametrize("number", CODES)
def test_the_exit_code_is_the_shell_s(monkeypatch, capsys, number):
    def run(arguments):
        signal.raise_signal(number)
        pytest.fail("the signal was lost")

    monkeypatch.setattr(entry, "_run", run)
    before = signal.signal(number, signal.SIG_DFL)  # tests under nohup inherit an ignored SIGHUP, which stays ignored
    try:
        with pytest.raises(SystemExit) as ended:
            entry.main(["report"])
    finally:
        signal.signal(number, before)
    out, err = capsys.readouterr()
    assert ended.value.code == CODES[number] and out == "" and err == f"polhode: stopped by {number.name}.\n"


def test_a_signal_that_is_lost_in_a_callback_stops_the_command_at_its_end():
    with pytest.raises(Stopped), stop_on_signals():
        try:
            signal.raise_signal(signal.SIGINT)
        except BaseException:
            pass
        signal.raise_signal(signal.SIGINT)  # more of them change nothing


def test_nothing_is_printed_of_what_is_lost_in_a_callback(capsys):
    """Python prints what is raised in a finalizer, with a traceback, and goes on."""

    class Finalized:
        def __init__(self, act):
            self.act = act

        def __del__(self):
            self.act()

    with pytest.raises(Stopped), stop_on_signals():
        Finalized(lambda: signal.raise_signal(signal.SIGTERM))
    assert capsys.readouterr().err == ""
    before = sys.unraisablehook
    said = []
    sys.unraisablehook = said.append
    try:
        with stop_on_signals():
            Finalized(lambda: 1 / 0)
        assert sys.unraisablehook == said.append
    finally:
        sys.unraisablehook = before
    assert [type(lost.exc_value) for lost in said] == [ZeroDivisionError]  # other mistakes are still told


def test_what_a_library_makes_of_a_signal_is_the_signal():
    with pytest.raises(Stopped), stop_on_signals():
        try:
            signal.raise_signal(signal.SIGTERM)
        except Stopped:
            raise RuntimeError("a callback failed") from None
    with pytest.raises(ZeroDivisionError), stop_on_signals():
        raise ZeroDivisionError


def test_what_is_ignored_stays_so(monkeypatch):
    before = signal.signal(signal.SIGHUP, signal.SIG_IGN)
    try:
        with stop_on_signals():
            signal.raise_signal(signal.SIGHUP)
    finally:
        signal.signal(signal.SIGHUP, before)


DEAF = """
import os, signal
from polhode.cli import stopping
from polhode.formats.paths import write_whole
stopping.LIMITS = stopping.StoppingLimits(grace=0.2)
with stopping.stop_on_signals(), write_whole("a") as draft:
    draft.write_text("half")
    while True:
        try:
            os.kill(os.getpid(), signal.SIGTERM)
            signal.pause()
        except stopping.Stopped:
            pass
"""


def test_a_command_that_does_not_listen_is_ended_from_beside(tmp_path):
    (tmp_path / "a").write_text("earlier")
    command = [sys.executable, "-c", DEAF]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, timeout=PATIENCE, check=False)
    assert done.returncode == 143 and done.stderr == b"polhode: stopped by SIGTERM.\n"
    assert [path.name for path in tmp_path.iterdir()] == ["a"] and (tmp_path / "a").read_text() == "earlier"


HELD = """
import os, signal, time
from polhode.cli.stopping import Stopped, stop_on_signals
from polhode.formats.drafts import hold_signals
try:
    with stop_on_signals():
        with hold_signals():
            os.kill(os.getpid(), signal.SIGTERM)
            time.sleep(0.3)  # the watching thread has seen it
except Stopped as stop:
    print(stop.number == signal.SIGTERM)
"""


def test_a_signal_that_is_held_and_raised_again_says_nothing():
    done = subprocess.run([sys.executable, "-c", HELD], capture_output=True, text=True, timeout=PATIENCE, check=False)
    assert done.stdout == "True\n" and done.stderr == ""
