"""Limits of kinds: on either side of each, a spin is taken or refused, or described in one way or another."""

from contextlib import nullcontext

import numpy as np
import pytest

import polhode as ph
from polhode.errors import InvalidInput
from polhode.kinds.free_body import answers
from polhode.kinds.gyrostat import losses
from polhode.kinds.gyrostat.table import GyrostatTable
from polhode.reports import top_starts
from polhode.systems.heavy_top import HeavyTop

INSIDE, OUTSIDE = 0.99, 1.01  # of a limit
IDENTITY = (1.0, 0.0, 0.0, 0.0)


@pytest.mark.parametrize("factor", (INSIDE, OUTSIDE))
def test_energy_and_momentum_of_a_free_body_have_products(factor):
    body = ph.Body.from_moments((1.0, 1.0, 1.0), mass=1.0)
    for energy in (factor * answers.LIMITS.largest, 1.0 / (factor * answers.LIMITS.largest)):
        momentum = (0.0, 0.0, np.sqrt(2.0 * energy))
        with pytest.raises(InvalidInput, match="within 1e±200") if factor > 1.0 else nullcontext():
            answers.free_body_report(body, momentum, IDENTITY, times=np.zeros(1))


@pytest.mark.parametrize("factor", (INSIDE, OUTSIDE))
def test_a_phase_of_many_turns_is_doubted(factor):
    body = ph.Body.from_moments((1.0, 1.0, 1.0), mass=1.0)
    until = factor * answers.LIMITS.max_exact_turns * 2.0 * np.pi  # at 1 rad/s
    report = answers.free_body_report(body, (0.0, 0.0, 1.0), IDENTITY, times=np.array([0.0, until]))
    assert any("beyond 2⁵⁰" in note for note in report.notes) == (factor > 1.0)


@pytest.mark.parametrize("factor", (INSIDE, OUTSIDE))
def test_losses_are_judged_for_bodies_of_revolution_within_a_per_cent(factor):
    table = GyrostatTable(kind="gyrostat", rotor_axis=[0.0, 0.0, 1.0], rotor_moment="0.1 kg*m^2", rotor_rate="10 rad/s")
    off = factor * losses.LIMITS.max_asymmetry
    body = ph.Body(1.0, np.zeros(3), np.diag([1.0 + off, 1.0 - off, 1.5]))
    judged = losses.judge_losses(table, body, np.array([0.0, 0.0, 1.0]))
    assert (judged is None) == (factor > 1.0)


@pytest.mark.parametrize("factor", (INSIDE, OUTSIDE))
def test_the_energy_of_a_top_has_squares(factor):
    heavy = HeavyTop((1.0, 1.0, 1.0), mgl=1.0, axis=(0.0, 0.0, 1.0))
    momentum = np.array([0.0, 0.0, np.sqrt(factor * top_starts.LIMITS.max_energy)])
    with pytest.raises(InvalidInput, match="energy below 1e\\+200 J") if factor > 1.0 else nullcontext():
        assert np.array_equal(top_starts.build_start(heavy, None, momentum, np.array(IDENTITY), None)[0], momentum)
