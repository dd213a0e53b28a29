"""Long work says so by one line on standard error, on a terminal or not; short work says nothing."""

import threading
import time

import diffrax
import numpy as np
import pytest

import polhode as ph
from polhode._base import long_work
from polhode.analysis import equilibria
from polhode.taylor import advancing
from polhode.taylor.kernels import python_kernel

BODY = ph.systems.FreeRigidBody((1.0, 2.0, 3.0))
START, TIMES = [0.3, 1.8, 1.5], np.linspace(0.0, 2.0, 5)
LINE = "polhode: the motion goes on after 0 s …\n"


@pytest.fixture
def all_work_is_long(monkeypatch):
    """Series by Python's own steps, as compiled ones make as many in one call."""
    monkeypatch.setattr(advancing, "choose_kernel", lambda *_: python_kernel(1))
    monkeypatch.setattr(long_work, "LIMITS", long_work.LongWorkLimits(silence=0.0))


@pytest.mark.parametrize("method", [None, ph.integrators.LieMidpoint, diffrax.Dopri8()], ids=["series", "equal", "8th"])
@pytest.mark.parametrize("progress", [None, False])
def test_a_long_motion_says_so_once(all_work_is_long, capsys, method, progress):
    """Many calls of compiled code are one piece of work; where progress is not to be shown nothing is said."""
    times = np.linspace(0.0, 300.0, 5) if method is None else TIMES  # of series several calls
    ph.simulate(BODY, START, times, method=method, progress=progress)
    out, err = capsys.readouterr()
    assert out == "" and err == ("" if progress is False else LINE)


def test_a_short_motion_says_nothing(capsys):
    ph.simulate(BODY, START, TIMES)
    assert capsys.readouterr() == ("", "")


@pytest.mark.parametrize(("after", "said"), [(29.9, 0), (30.0, 1), (90.0, 1)])
def test_work_is_long_from_a_time_on(monkeypatch, capsys, after, said):
    now = [100.0]
    monkeypatch.setattr(long_work.time, "monotonic", lambda: now[0])
    work = long_work.LongWork("the motion")
    work.go_on()
    now[0] += after
    work.go_on()
    work.go_on()
    assert capsys.readouterr() == ("", said * "polhode: the motion goes on after 30 s …\n")


def test_a_long_search_says_so_while_compiled_code_runs(all_work_is_long, monkeypatch):
    said, solve, lines = threading.Event(), equilibria._solve, []

    def say(what):
        lines.append(what)
        said.set()

    def solve_slowly(*arguments):
        assert said.wait(60.0)
        return solve(*arguments)

    monkeypatch.setattr(long_work, "_say", say)
    monkeypatch.setattr(equilibria, "_solve", solve_slowly)
    assert len(ph.analysis.find_equilibria(BODY, START)) == 6
    assert lines == ["the search for equilibria"]


def test_silence_goes_for_what_is_within(all_work_is_long, capsys):
    with long_work.silent(True), long_work.silent(False), long_work.long_work("this"):
        long_work.LongWork("that").go_on()
    assert capsys.readouterr() == ("", "")


def test_motions_within_long_work_say_nothing_of_their_own(all_work_is_long, capsys):
    with long_work.long_work("a search"):
        ph.simulate(BODY, START, TIMES, method=ph.integrators.LieMidpoint)
        time.sleep(0.05)  # the line of the search comes from a thread
    assert capsys.readouterr().err == "polhode: a search goes on after 0 s …\n"
