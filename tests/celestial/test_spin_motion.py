"""Verdicts, mean rates and librations of spins, against the pendulum's elliptic integrals and adaptive steps."""

import math

import mpmath
import numpy as np
import pytest

import polhode as ph
from polhode.celestial import SpinOrbit
from polhode.celestial.spin_orbit.motion import _verdict, spin_motion
from polhode.errors import InvalidInput
from sweeping import first

MEAN = 1e-10  # of θ̇/n by weighted means over thousands of orbits
SEEN = 2e-3  # relative, by which the largest of thousands of samples falls short of the amplitude


@pytest.mark.long
def test_a_pendulum_that_turns_over():
    """On a circle φ = 2(θ − nt) is a pendulum of frequency n ω0; beyond its separatrix <φ̇> = π k n ω0/K(1/k)."""
    n, asphericity = 2.5e-6, 0.3
    for ratio in (1.5, 1.32, -0.4):
        k = abs(ratio - 1.0) / asphericity
        mean = math.pi * k * asphericity / float(mpmath.ellipk(1 / mpmath.mpf(k) ** 2))
        found = spin_motion(SpinOrbit(asphericity, 0.0, n), [0.0, ratio * n], 4000)
        assert found.verdict == "regular" and found.libration is None
        assert abs(found.mean_rate / n - (1.0 + math.copysign(0.5 * mean, ratio - 1.0))) < MEAN


@pytest.mark.long
def test_a_pendulum_that_swings():
    n = 2.5e-6
    found = spin_motion(SpinOrbit(0.3, 0.0, n), [0.4, n], 4000)
    assert found.verdict == "regular" and abs(found.mean_rate / n - 1.0) < MEAN
    assert found.libration is not None and found.libration.order == 1.0
    assert abs(found.libration.angle) < 1e-9 and found.libration.amplitude == pytest.approx(0.4, rel=SEEN)
    # as far as its rate at the bottom carries it: sin γ = (θ̇/n − 1)/ω0
    found = spin_motion(SpinOrbit(0.3, 0.0, n), [np.pi, 1.2 * n], 4000).libration
    assert found is not None and found.amplitude == pytest.approx(math.asin(0.2 / 0.3), rel=SEEN)


@pytest.mark.long
@pytest.mark.parametrize(("order", "middle"), first(2, [(0.5, 90.0), (1.0, 0.0), (1.5, 0.0), (2.0, 0.0)]))
def test_each_resonance_holds_a_spin_about_its_stable_angle(order, middle):
    """H(1/2) alone is negative, its spins across the periapsis; published by Goldreich & Peale (1966)."""
    # θ̇ at periapsis differs from its mean by about n ω0²/2, beside a half-width of n ω0 √|H|
    found = spin_motion(SpinOrbit(0.015, 0.2), [np.radians(middle + 8.0), order], 10_000)
    assert found.verdict == "regular" and found.libration is not None and found.libration.order == order
    off = math.degrees(found.libration.angle) - middle
    assert abs(off - 180.0 * round(off / 180.0)) < 0.1
    assert math.degrees(found.libration.amplitude) == pytest.approx(8.0, rel=0.05)
    assert abs(found.mean_rate - order) < 1e-8


@pytest.mark.sweep
def test_a_spin_between_resonances_is_held_by_none():
    system, start = SpinOrbit(0.05, 0.2), np.array([0.3, 1.27])
    longer, shorter = (spin_motion(system, start, orbits) for orbits in (6000, 3000))
    assert longer.libration is None and abs(longer.mean_rate - shorter.mean_rate) < MEAN
    turned = ph.simulate(system, start, 2 * np.pi * np.array([0.0, 300.0])).states[:, 0]
    assert abs((turned[1] - turned[0]) / (600 * np.pi) - longer.mean_rate) < 0.2 / 300


@pytest.mark.sweep
def test_hyperion_s_sea_and_islands():
    hyperion = SpinOrbit(0.89, 0.1, 3.4e-6)
    sea = spin_motion(hyperion, np.array([np.pi / 2, 3.4e-6]), 2000)
    assert sea.verdict == "chaotic" and sea.libration is None and sea.exponents.shape == (2000,)
    assert sea.exponents[-1] / 3.4e-6 == pytest.approx(0.12, abs=0.02)
    island = spin_motion(hyperion, np.array([0.0, 0.55 * 3.4e-6]), 2000)
    assert island.verdict == "regular" and island.libration is not None and island.libration.order == 1.0
    assert spin_motion(hyperion, np.array([0.2, 3.5 * 3.4e-6]), 2000).verdict == "regular"


def test_verdicts_on_growth_made_by_hand():
    orbits = np.arange(1, 5001)
    line, late = np.log(2 * np.pi * orbits), np.where(orbits > 2500, 0.004 * (orbits - 2500), 0.0)
    wave = 2.0 * np.sin(0.01 * orbits)
    assert [_verdict(line + x) for x in (0.0, 3.0, wave)] == ["regular"] * 3
    assert [_verdict(x) for x in (0.1 * orbits, line + 3 * late, 0.005 * orbits + line)] == ["chaotic"] * 3
    # growing, but not for long enough; or much, and then no more
    assert [_verdict(line + x) for x in (late, 12.0)] == ["undecided"] * 2


@pytest.mark.long
def test_no_chaos_where_there_is_none():
    """At the pendulum's upper rest neighbours part exponentially for ever; it is not chaotic."""
    found = spin_motion(SpinOrbit(0.3, 0.0), [0.5 * np.pi, 1.0], 1000)
    assert found.verdict == "regular"
    free = spin_motion(SpinOrbit(0.0, 0.3), [0.2, 1.0], 500)
    assert (free.verdict, free.libration) == ("regular", None) and abs(free.mean_rate - 1.0) < 1e-13


def test_orbits_are_counted():
    with pytest.raises(InvalidInput, match="`orbits` must be a whole number, at least 1; got 0"):
        spin_motion(SpinOrbit(0.1, 0.1), [0.0, 1.0], 0)


@pytest.mark.sweep
def test_times_of_chaos_are_those_of_its_exponent():
    """Neighbours that part as exp(λt) are e times as far after 1/λ, and a radian from 1e-12 after 12 ln 10/λ."""
    found = spin_motion(SpinOrbit(0.89, 0.1), [np.pi / 2, 1.0], 2000)
    assert found.verdict == "chaotic" and found.lyapunov_time is not None
    assert found.exponent == found.exponents[-1] == pytest.approx(1.0 / found.lyapunov_time)
    assert found.predictable_time(1e-12) == pytest.approx(12.0 * np.log(10.0) * found.lyapunov_time, rel=1e-14)
    calm = spin_motion(SpinOrbit(0.1, 0.05), [0.2, 1.0], 300)
    assert calm.lyapunov_time is None and calm.predictable_time(1e-12) is None
    span = 600 * mpmath.pi
    assert calm.exponent < calm.regular_exponent(1.0) == pytest.approx(float(mpmath.log(span) / span), rel=1e-14)
