"""The motion of a tumbler from its two periods, against integration of Euler's equations, papers and closed forms."""

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import polhode as ph
from polhode.celestial import fit_tumbling, least_period_ratios
from polhode.celestial.tumbling import estimation as tumbling
from polhode.celestial.tumbling.known_tumblers import known_tumbler

APOPHIS = (27.38, 263.0, [0.61, 0.965, 1.0])
CASES = [(*APOPHIS, "short-axis"), (*APOPHIS, "long-axis"), (7.35, 5.41, [1.0, 3.09, 3.22], "long-axis"),
         (67.27, 368.7, [0.36, 0.96, 1.0], "short-axis"), (1.0, 4.2, [1.0, 1.9, 2.5], "short-axis")]  # fmt: skip


def of_mode(motions, mode):
    return next(motion for motion in motions if motion.mode == mode)


def integrated(moments, momentum, span, encircled):
    """Return L after a time, and by how much the encircled axis has gone round L, by integration."""
    one, two = (k for k in range(3) if k != encircled)

    def field(t, y):
        L = y[:3]
        turn = np.linalg.norm(L) * (L[one] ** 2 / moments[one] + L[two] ** 2 / moments[two])
        return [*np.cross(L, L / moments), turn / (L[one] ** 2 + L[two] ** 2)]

    return solve_ivp(field, (0.0, span), [*momentum, 0.0], method="DOP853", rtol=1e-12, atol=1e-13).y[:, -1]


def misfit(motion, momentum):
    """Return how far L is from where it was after P_ψ, and how far the turn of the axis is from P_ψ/P_φ turns."""
    end = integrated(motion.moments, momentum, motion.rotation, 2 if motion.mode == "short-axis" else 0)
    turns = end[3] / (2 * np.pi) - motion.rotation / motion.precession
    return max(np.abs(end[:3] - momentum).max() / np.linalg.norm(momentum), abs(turns))


@pytest.mark.long_after(2)
@pytest.mark.parametrize("case", CASES)
def test_integration_has_the_given_periods(case):
    motion = of_mode(fit_tumbling(*case[:3]), case[3])
    momentum = np.asarray(motion.motion.momentum(0.0))
    assert (motion.precession, motion.rotation) == pytest.approx(case[:2], rel=1e-12)
    assert misfit(motion, momentum) < 1e-8
    assert misfit(motion, momentum * 1.0001) > 1e-5  # and notices a state that is wrong
    energy = (momentum**2 / motion.moments).sum() / motion.momentum_rate**2
    assert energy == pytest.approx(motion.energy_ratio, rel=1e-13)


def test_apophis_as_published():
    motion = fit_tumbling(*APOPHIS)[0]
    assert motion.mode == "short-axis"
    assert motion.energy_ratio == pytest.approx(1.023637, abs=5e-7)
    assert np.degrees(motion.cone_angle) == pytest.approx(11.0857, abs=5e-5)
    assert motion.long_axis == pytest.approx(30.56, abs=5e-3)


@pytest.mark.parametrize(("key", "mode", "energy"), [
    ("apophis", "short-axis", 1.024), ("krylov", "short-axis", 1.02), ("toutatis", "long-axis", None),
    ("apophis-2021", "short-axis", None), ("toutatis-2012", "long-axis", None),
])  # fmt: skip
def test_known_tumblers_have_their_published_modes(key, mode, energy):
    known = known_tumbler(key)
    first = [float(text.split()[0]) for text in (known.precession, known.rotation, *known.moments)]
    motions = fit_tumbling(first[0], first[1], first[2:])
    assert mode in [motion.mode for motion in motions]
    assert known.mode == mode
    if energy is not None:
        assert of_mode(motions, mode).energy_ratio == pytest.approx(energy, abs=5e-3)


@pytest.mark.long_after(2)
@pytest.mark.parametrize("case", CASES)
def test_tilts_are_those_of_the_motion(case):
    motion = of_mode(fit_tumbling(*case[:3]), case[3])
    axis = 2 if motion.mode == "short-axis" else 0
    L = np.asarray(motion.motion.momentum(np.linspace(0.0, motion.rotation, 20001)))
    tilt = np.arccos(np.abs(L[:, axis]) / np.linalg.norm(L, axis=1))
    assert (tilt.min(), tilt.max()) == pytest.approx(motion.tilts, abs=1e-7)
    crossing = np.abs(L[:, 1]).argmin()
    assert tilt[crossing] == pytest.approx(motion.cone_angle, abs=1e-4)


@pytest.mark.parametrize("case", CASES[:3])
def test_each_axis_goes_round_as_said_and_is_a_way_to_say_it(case):
    motion = of_mode(fit_tumbling(*case[:3]), case[3])
    span = 300 * motion.rotation
    axes = np.asarray(motion.motion.rotation_matrix(np.linspace(0.0, span, 60001)))  # L is along z
    for k, period, word in ((0, motion.long_axis, "long"), (2, motion.short_axis, "short")):
        azimuth = np.unwrap(np.arctan2(axes[:, 1, k], axes[:, 0, k]))
        assert (azimuth[-1] - azimuth[0]) / (2 * np.pi) == pytest.approx(span / period, abs=1e-6)
        again = of_mode(fit_tumbling(period, motion.rotation, case[2], word), motion.mode)
        assert again.energy_ratio == pytest.approx(motion.energy_ratio, rel=1e-12)


def test_an_oblate_body_follows_its_closed_form():
    motion = fit_tumbling(2.0, 6.0, [0.6, 0.6, 1.0])[0]
    cosine = 1.0 / (0.4 * 3.0)
    assert motion.energy_ratio == pytest.approx(cosine**2 + (1 - cosine**2) / 0.6, rel=1e-12)
    assert motion.momentum_rate == pytest.approx(2 * np.pi * 0.6 / 2.0, rel=1e-12)
    assert least_period_ratios([0.6, 0.6, 1.0])[1] == np.inf


@pytest.mark.long
def test_near_the_least_ratio_the_wobble_is_small():
    short, long = least_period_ratios(APOPHIS[2])
    assert fit_tumbling(1.0, short * (1 + 1e-9), APOPHIS[2])[0].tilts[1] < 1e-3
    assert of_mode(fit_tumbling(1.0, long * (1 + 1e-9), APOPHIS[2]), "long-axis").tilts[1] < 1e-3
    assert [motion.mode for motion in fit_tumbling(1.0, short * (1 - 1e-9), APOPHIS[2])] == ["long-axis"]


@pytest.mark.long
def test_errors_are_those_of_draws_and_leave_the_motion_as_it_is():
    plain, told = (fit_tumbling(*APOPHIS, errors=errors)[0] for errors in (None, (0.02, 2.0, 0.0, 0.0, 0.0)))
    assert plain.interval is None
    assert told.energy_ratio == plain.energy_ratio
    low, high = (fit_tumbling(27.38, 263.0 + x, APOPHIS[2])[0].energy_ratio for x in (-1.96 * 2.0, 1.96 * 2.0))
    assert told.interval.low[0] == pytest.approx(low, abs=2e-4)
    assert told.interval.high[0] == pytest.approx(high, abs=2e-4)
    assert told.interval.admissible == 1.0


@pytest.mark.usefixtures("any_type")
@pytest.mark.parametrize(("change", "words"), [
    ({"precession": -1.0}, "positive and finite"), ({"rotation": np.nan}, "positive and finite"),
    ({"moments": [1.0, 1.0, 1.0]}, "sphere"), ({"moments": [1.0, 2.0, 4.0]}, "I1 \\+ I2"),
    ({"moments": [2.0, 1.0, 2.5]}, "in ascending order"), ({"moments": [1.0, np.inf, 2.5]}, "finite"),
    ({"axis": "middle"}, "axis"),
    ({"errors": [1.0, -1.0, 0.0, 0.0, 0.0]}, "five finite numbers, not negative"),
    ({"rotation": 30.0}, "short-axis mode needs"),
])  # fmt: skip
def test_bad_input_is_refused(change, words):
    given = {"precession": 27.38, "rotation": 263.0, "moments": [0.61, 0.965, 1.0], **change}
    with pytest.raises(ph.InvalidInput, match=words):
        fit_tumbling(**given)


@pytest.mark.sweep
@pytest.mark.parametrize("mode", ["short-axis", "long-axis"])
def test_intervals_cover_the_truth(mode, monkeypatch):
    monkeypatch.setattr(tumbling, "DRAWS", 512)  # enough for ends of 95 %, and four times as quick
    rng = np.random.default_rng(7)
    inside, runs = np.zeros(3), 120
    for run in range(runs):
        i1, i2 = rng.uniform(0.55, 0.7), rng.uniform(0.76, 0.9)
        moments = np.array([i1, i2, 1.0])
        short, long = least_period_ratios(moments)
        ratio = short * rng.uniform(1.25, 2.0) if mode == "short-axis" else (long + 1) * rng.uniform(1.25, 2.0) - 1
        true = of_mode(fit_tumbling(1.0, ratio, moments), mode)
        sizes = np.array([1e-3, 1e-2 * ratio, 2e-3, 2e-3, 0.0])
        seen = np.array([1.0, ratio, *moments]) + sizes * rng.standard_normal(5)
        found = fit_tumbling(seen[0], seen[1], np.sort(seen[2:]), errors=sizes, seed=run)
        interval = of_mode(found, mode).interval
        numbers = np.array([true.energy_ratio, true.cone_angle, true.momentum_rate])
        inside += (interval.low <= numbers) & (numbers <= interval.high)
    assert (inside / runs > 0.91).all()
    assert (inside / runs < 0.99).all()
