"""Sines in turns and phases reduced to a fraction of a turn, against mpmath and exact rationals."""

from fractions import Fraction

import jax
import mpmath
import numpy as np
import pytest

from polhode._base.arrays import split_halves
from polhode.special._circular import reduced_phase, sine_cosine_turns, split_rate

SINE_ERROR = 4e-16
"""Two roundings of the tangent's or polynomial's last operations, on values up to 1."""
PHASE_ERROR = 5e-17
"""Turns; what the three parts leave of the exact phase."""


@pytest.mark.parametrize("engine", ["numpy", "jax"])
def test_sines_and_cosines(engine):
    x = np.concatenate([np.linspace(-0.5, 0.5, 997), [0.0, 0.125, 0.25, -0.25, 0.5, -0.5, 1e-300]])
    if engine == "jax":
        with jax.enable_x64(True):
            s, c = map(np.asarray, jax.jit(sine_cosine_turns)(jax.numpy.asarray(x)))
    else:
        s, c = sine_cosine_turns(x)
    for k, value in enumerate(x):
        angle = mpmath.mpf(float(value)) * 2
        assert abs(s[k] - mpmath.sinpi(angle)) < SINE_ERROR
        assert abs(c[k] - mpmath.cospi(angle)) < SINE_ERROR


@pytest.mark.parametrize("engine", ["numpy", "jax"])
def test_phases_stay_exact_for_long_times(engine):
    rng = np.random.default_rng(1)
    high = rng.uniform(0.1, 1.0, 400)
    low = high * rng.uniform(-1, 1, 400) * 2.0**-54
    time = 10.0 ** rng.uniform(-3, 15, 400) * rng.choice([-1, 1], 400)

    def reduced(high, low, time):
        return reduced_phase(split_rate(high, low), split_halves(time))

    if engine == "jax":
        with jax.enable_x64(True):
            parts = [np.asarray(p) for p in jax.jit(reduced)(*map(jax.numpy.asarray, (high, low, time)))]
    else:
        parts = reduced(high, low, time)
    for k in range(400):
        wanted = (Fraction(high[k]) + Fraction(low[k])) * Fraction(time[k])
        found = sum(Fraction(float(p[k])) for p in parts)
        assert abs(found - wanted) < PHASE_ERROR


def test_a_phase_in_plain_double_would_be_caught():
    high, time = 0.3, 1e12 + 0.1
    assert abs(Fraction(high * time) - Fraction(high) * Fraction(time)) > PHASE_ERROR
