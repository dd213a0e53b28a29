"""The top's kernel that Numba compiles: error bounds and answers of NumPy's evaluation, in every family."""

import numpy as np
import pytest

import polhode as ph
from oracle.lagrange_families import draw_tops
from oracle.test_lagrange_motion import WORST_ERROR, errors

pytest.importorskip("numba", reason="Numba is not installed; the extra `fast` has it")
from polhode.exact.lagrange_top import evaluation, kernel

PER_FAMILY = 3


def test_states_are_exact_in_every_family(announce):
    worst = {}
    for case in draw_tops(PER_FAMILY, 8):
        top = ph.LagrangeMotion(*case[1:5])
        columns = tuple(np.asarray(column).item() for column in top._columns)
        attitude, momentum = kernel.states_of_one(columns, np.array([case.time]), np.zeros(1))
        worst[case.family] = max(worst.get(case.family, 0.0), *errors(attitude[0], momentum[0], case))
    announce("\n".join(["the top's kernel against the oracle, eps:", *(f"  {k:26}{v:8.2f}" for k, v in worst.items())]))
    assert len(worst) >= 27 and max(worst.values()) <= WORST_ERROR


STARTS = [((0.0, 0.0, 2.5), 1.0), ((0.3, -0.5, 1.5), 0.4), ((2.0, 1.0, 0.0), 1.0), ((0.2, 0.1, 0.4), 1.0),
          ((0.0, 0.0, 5.0), 0.0), ((0.0, 0.0, 0.0), 2.0)]  # fmt: skip


@pytest.mark.parametrize(("momentum", "lean"), STARTS)
def test_long_runs_go_through_it_and_agree(momentum, lean, monkeypatch):
    """By threads, in blocks that are not full, with the epoch's rest, for times of any shape, on either side of mgl."""
    monkeypatch.setattr(kernel, "WORTH", 1000)
    times = np.linspace(-50.0, 1e3, 10_001)[:-1].reshape(2, -1)
    attitude = (np.cos(lean / 2), np.sin(lean / 2), 0.0, 0.0)
    tops = [ph.LagrangeMotion((1.0, 1.0, 0.5), mgl, momentum, attitude, epoch=0.1) for mgl in (1.0, -1.0)]
    calls = []
    monkeypatch.setattr(kernel, "states_of_one", lambda *x, run=kernel.states_of_one: calls.append(1) or run(*x))
    found = [top.state(times) for top in tops]
    monkeypatch.setattr(evaluation, "_kernel", lambda: None)
    assert len(calls) == 2 and found[0][0].shape == (2, 5000, 4)
    for top, states in zip(tops, found, strict=True):
        assert max(np.abs(a - b).max() for a, b in zip(states, top.state(times), strict=True)) < 6e-15
