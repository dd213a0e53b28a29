"""Turns of a rolling disk, its steady motions, and what each law takes: against closed forms and against the motion."""

import mpmath
import numpy as np
import pytest

import polhode as ph
from polhode import rolling
from polhode.errors import InvalidInput
from polhode.motion._outcome import Ending
from polhode.rolling.euler_disk.spin_down import predicted_exponents
from polhode.rolling.euler_disk.system import LAYOUT

M, A, G = 0.4, 0.04, 9.80665
DISK = rolling.EulerDisk(M, A)
LOSING = rolling.EulerDisk(M, A, dissipation=[rolling.AirLayer(1.8e-4), rolling.ViscousContourFriction(2e-6)])


@pytest.mark.long
def test_the_state_has_the_rates_that_were_asked_for():
    """φ̇ = ω2/sin θ, and what is printed on the face turns by ψ̇ + φ̇ = ω3 + φ̇ (1 − cos θ)."""
    state = DISK.state(0.3, 0.7, 11.0, 2.0, 0.4)
    assert float(DISK.precession(state)) == pytest.approx(11.0, rel=1e-15)
    wanted = 2 + 11 * (1 - mpmath.cos(mpmath.mpf("0.3")))
    assert float(DISK.face_rate(state)) == pytest.approx(float(wanted), rel=1e-15)
    field = np.asarray(DISK.vector_field(0.0, state))
    assert LAYOUT.part(field, "tilt") == 0.7 and LAYOUT.part(field, "face") == pytest.approx(float(wanted), rel=1e-15)
    with pytest.raises(InvalidInput, match="the tilt must lie between"):
        DISK.state(0.0, 0.0, 1.0, 1.0)


@pytest.mark.sweep
def test_a_steady_motion_stays_and_nutates_as_it_says():
    """With the centre at rest φ̇² = mga/(A sin θ); beside it the tilt is back after the nutation's period."""
    tilt = 0.2
    found = rolling.steady_rolling(DISK, tilt)
    assert found is not None and found.nutation is not None and found.verdict.verdict == "stable"
    square = M * G * A / (0.25 * M * A**2 * mpmath.sin(tilt))
    assert float(DISK.precession(found.state)) == pytest.approx(float(mpmath.sqrt(square)), rel=1e-14)
    period = rolling.rolling_period(DISK, found.state, found)
    start = np.array(found.state)
    start[LAYOUT.place("tilt")] += 1e-6
    near = ph.simulate(DISK, start, [0.0, 0.5 * period, period])
    off = near.part("tilt") - LAYOUT.part(near.states[0], "tilt")
    assert abs(off[2]) < 1e-3 * abs(off[1]) and abs(off[1]) > 1e-7
    with pytest.raises(InvalidInput, match="without `dissipation`"):
        rolling.steady_rolling(LOSING, tilt)
    # rates that are not steady give way to the precession alone; what does not precess needs a spin
    given = rolling.steady_rolling(DISK, tilt, 100.0, 3.0)
    assert given is not None and float(LAYOUT.part(given.state, "spin")) != 3.0
    assert rolling.steady_rolling(DISK, tilt, 0.0) is None


def test_times_of_rolling():
    state = DISK.state(0.3, 3.0, 0.0, 4.0)
    assert rolling.fastest_rolling_rate(DISK, state) == pytest.approx(5.0)
    swing = 2 * mpmath.pi * mpmath.sqrt(mpmath.mpf(A) / mpmath.mpf(G))  # √(g/a) is faster
    assert rolling.rolling_period(DISK, state) == pytest.approx(float(swing), rel=1e-14)


@pytest.mark.long
def test_each_law_takes_what_its_formula_says():
    tilt, rate = mpmath.mpf("0.1"), mpmath.mpf("80")
    state = LOSING.state(0.1, 0.0, 80.0, 0.0)
    wanted = [mpmath.pi * mpmath.mpf("1.8e-4") * G * A**2 / tilt**2, mpmath.mpf("2e-6") * rate**2]
    assert np.asarray(LOSING.powers(state)) == pytest.approx([float(x) for x in wanted], rel=1e-14)
    # past the vertical the tilt towards the table counts, and neither direction of going round differs
    other = LOSING.state(np.pi - 0.1, 0.0, -80.0, 0.0)
    assert np.asarray(LOSING.powers(other)) == pytest.approx([float(x) for x in wanted], rel=1e-12)
    assert float(LOSING.power(LOSING.rolling_state(0.1))) == pytest.approx(
        float(np.sum(LOSING.powers(LOSING.rolling_state(0.1)))), rel=1e-12
    )
    assert DISK.powers(np.stack([state] * 3)).shape == (3, 0)


def test_exponents_of_one_law_satisfy_its_balance():
    """With E ∝ α, Ω ∝ α^(−1/2) and P ∝ α^(−q): α ∝ (t0 − t)^n asks for n − 1 = −q n."""
    laws = (rolling.AirLayer(1e-5), 2), (rolling.ViscousContourFriction(1e-7), 1), (rolling.RollingCouple(1e-5), -0.5)
    for law, q in laws:
        tilt, precession, by_tilt = predicted_exponents(law)
        assert tilt - 1 == pytest.approx(-q * tilt, abs=1e-15)
        assert precession == pytest.approx(tilt * by_tilt, abs=1e-15)


@pytest.mark.sweep
def test_turns_are_counted_by_the_contact():
    start = DISK.rolling_state(0.2)
    turn = 2.0 * np.pi / float(DISK.precession(start))
    motion = ph.simulate(DISK, start, np.linspace(0.0, 8.0 * turn, 60))
    first = rolling.first_turns(motion, 3.0, 40)
    assert len(first.times) == 40 and np.ptp(first.part("heading")) / (2.0 * np.pi) == pytest.approx(3.0, abs=0.15)
    whole = rolling.first_turns(motion, 9.0, 40)
    assert np.array_equal(whole.states, motion.states) and whole.contact.shape == (60, 2)
    last = rolling.last_turns(motion, 2.0, 40)
    assert last.times[0] > 5.0 * turn and last.outcome.ending is Ending.COMPLETED
    # sampled anew, it is the same motion
    k = int(np.flatnonzero(np.asarray(motion.times) == last.times[0])[0])
    again = ph.simulate(DISK, motion.states[k], np.asarray(last.times) - last.times[0])
    assert np.abs(last.states - np.asarray(again.states)).max() < 1e-7
    with pytest.raises(InvalidInput, match="must be of one EulerDisk"):
        rolling.first_turns(ph.FreeMotion((1.0, 2.0, 3.0), momentum=(0.0, 0.0, 1.0)).sample([0.0, 1.0]), 1.0, 5)
    with pytest.raises(InvalidInput, match="`span` must be positive"):
        rolling.rolling_path(DISK, start, 0.0, 5)


@pytest.mark.long
def test_a_motion_that_ends_early_is_filled():
    """Falling over, it lies flat long before the times are over; all samples then lie before that."""
    start = DISK.state(0.05, -0.5, 0.0, 0.0)
    motion = ph.simulate(DISK, start, np.linspace(0.0, 5.0, 40))
    assert motion.outcome.event == "flat" and len(motion.times) < 20
    filled = rolling.resample_until_end(motion, 40)
    assert len(filled.times) >= 39 and filled.outcome.event == "flat"
    assert filled.times[-1] == pytest.approx(motion.times[-1], rel=1e-9)
    path = rolling.rolling_path(DISK, start, 1.0, 300)
    assert path.outcome.event == "flat" and path.times[-1] == pytest.approx(motion.times[-1], rel=1e-7)
