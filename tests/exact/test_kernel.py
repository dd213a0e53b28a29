"""The kernel that Numba compiles: error bounds and answers of NumPy's evaluation, in every family."""

import subprocess
import sys

import numpy as np
import pytest

import polhode as ph
from oracle.families import draw
from oracle.measures import error_in_eps

pytest.importorskip("numba", reason="Numba is not installed; the extra `fast` has it")
from polhode.exact.free_body import evaluation, kernel

WORST_ERROR = 16.0
"""eps, as of every evaluation."""
PER_FAMILY = 20


def states(case):
    motion = ph.FreeMotion(case.moments, case.momentum)
    columns = tuple(np.asarray(column).item() for column in motion._columns)
    attitude, momentum = kernel.states_of_one(columns, np.array([case.time]), np.zeros(1))
    return attitude[0], momentum[0]


def test_states_are_exact_in_every_family(announce):
    worst = {}
    for case in draw(PER_FAMILY, 5):
        worst[case.family] = max(worst.get(case.family, 0.0), *error_in_eps(*states(case), case))
    announce("\n".join(["the kernel against the oracle, eps:", *(f"  {k:26}{v:8.2f}" for k, v in worst.items())]))
    assert len(worst) >= 23 and max(worst.values()) <= WORST_ERROR


STARTS = [(0.3, 0.1, 3.0), (0.3, 1.8, 1.5), (0.9, 1.6, 0.3), (1e-6, 2.0, 3e-6), (0.0, 2.0, 0.0)]


@pytest.mark.parametrize("momentum", STARTS)
def test_long_runs_go_through_it_and_agree(momentum, monkeypatch):
    """By threads, in blocks that are not full, with the epoch's rest, for times of any shape."""
    motion = ph.FreeMotion((1.0, 2.0, 3.0), momentum, epoch=0.1)
    times = np.linspace(-50.0, 1e4, 70_001)[:-1].reshape(2, -1)
    calls = []
    monkeypatch.setattr(kernel, "states_of_one", lambda *x, run=kernel.states_of_one: calls.append(1) or run(*x))
    found = motion.state(times)
    monkeypatch.setattr(evaluation, "_kernel", lambda: None)
    wanted = motion.state(times)
    assert calls and found[0].shape == (2, 35_000, 4)
    assert max(np.abs(a - b).max() for a, b in zip(found, wanted, strict=True)) < 4e-15


def test_a_wrong_column_is_noticed():
    motion = ph.FreeMotion((1.0, 2.0, 3.0), (0.3, 1.8, 1.5))
    columns = [np.asarray(column).item() for column in motion._columns]
    columns[4] *= 1.0 + 1e-13
    found = kernel.states_of_one(tuple(columns), np.array([100.0]), np.zeros(1))
    assert np.abs(found[1][0] - motion.momentum(100.0)).max() > 1e-13


def test_a_process_that_has_used_it_may_fork():
    code = """
import multiprocessing, numpy as np, polhode as ph
motion = ph.FreeMotion((1.0, 2.0, 3.0), (0.3, 1.8, 1.5))
times = np.linspace(0.0, 9.0, 100_000)
before = motion.momentum(times)[-1]
with multiprocessing.get_context("fork").Pool(2) as pool:
    for after in pool.map(motion.momentum, [times] * 2):
        assert (after[-1] == before).all()
"""
    subprocess.run([sys.executable, "-c", code], check=True, timeout=120)
