"""Each threshold of the judge decides: inputs on either side of it have different outcomes."""

from dataclasses import replace
from importlib import import_module

import numpy as np
import pytest

from judging.simulated_engines import equations, rk4
from polhode.errors import InvalidInput
from polhode.judging import _convergence as convergence
from polhode.judging import _run as run
from polhode.judging import _state_files as state_files
from polhode.judging import _stepping as stepping
from polhode.judging import _written_states as written
from polhode.judging import judge
from polhode.judging._convergence import judge_convergence
from polhode.judging._run import EngineRun, find_spin_end, measure_drift, measure_growth

INSIDE, OUTSIDE = 0.98, 1.02
MOMENTS = np.array([1.0, 2.0, 3.0])


def halved(order=2.0, limit=0.0, finest=0.0125, floor=1e-15):
    """The judgement on errors h^order + limit of steps whose finest is given, over one radian."""
    levels = [np.ones((4, 6)) * (h**order + limit) for h in (4 * finest, 2 * finest, finest)]
    return judge_convergence(levels, [floor] * 3, 1.0)


def test_an_order_must_be_near_a_whole_number_that_methods_have():
    off = convergence.LIMITS.order_tolerance
    assert halved(2.0 + INSIDE * off).limit is not None and halved(2.0 + OUTSIDE * off).limit is None
    highest = convergence.LIMITS.max_order
    assert halved(highest, finest=0.5).limit is not None and halved(highest + 1, finest=0.5).limit is None


def test_errors_that_still_fall_leave_the_verdict_open():
    """Their order, log2 of the ratio, is 0.58, none of a method."""
    ratio = convergence.LIMITS.min_error_ratio
    assert halved(np.log2(ratio * 1.001)).open and not halved(np.log2(ratio * 0.999)).open


def test_a_limit_of_large_uncertainty_gives_no_verdict():
    bound = convergence.LIMITS.max_uncertainty
    for factor, resolved in ((INSIDE, True), (OUTSIDE, False)):
        exact = judge_convergence([np.zeros((4, 6))] * 3, [factor * bound] * 3, 1.0)
        assert exact.converges == resolved and exact.open != resolved


def test_a_drift_beyond_the_largest_keeps_the_rate_before_it():
    """An invariant that jumps by more has the slope before the jump; one that jumps by less swings about a line."""
    angles = np.linspace(0.0, 100.0, 1001)
    for factor, steps in ((0.9, False), (1.1, True)):
        jump = factor * run.LIMITS.max_drift
        drift = measure_drift(np.where(angles < 60.0, 1.0 + 1e-6 * angles, 1.0 + jump), angles, 1e-12, 40.0)
        assert np.isclose(drift.per_radian, 1e-6, rtol=1e-3) == steps


def test_a_drift_needs_samples_and_periods():
    count, least = run.LIMITS.min_samples, run.LIMITS.min_periods
    for samples in (count, count - 1):
        angles = np.linspace(0.0, 10.0, samples)
        drift = measure_drift(1.0 + 1e-3 * angles, angles, 1e-12)
        assert np.isnan(drift.error) == (samples < count)
    angles = np.linspace(0.0, 10.0, 200)
    for periods in (INSIDE * least, OUTSIDE * least):
        assert measure_drift(1.0 + 1e-3 * angles, angles, 1e-12, periods).is_seen == (periods >= least)


def test_growth_has_a_word_within_the_tolerance_of_its_exponent():
    angles, off = np.linspace(0.0, 100.0, 1001), run.LIMITS.exponent_tolerance
    for power, word in ((1.0 + INSIDE * off, "linear"), (1.0 + OUTSIDE * off, "between linear and quadratic"),
                        (2.0 + INSIDE * off, "quadratic"), (2.0 + OUTSIDE * off, "faster than quadratic")):  # fmt: skip
        assert measure_growth(1e-6 * angles**power, angles, 1e-12).word == word


def test_an_attitude_is_lost_beyond_the_largest_error():
    angles, most = np.linspace(0.0, 100.0, 1001), run.LIMITS.max_attitude_error
    assert measure_growth(INSIDE * most * angles / 100.0, angles, 1e-12).lost_after is None
    assert measure_growth(OUTSIDE * most * angles / 100.0, angles, 1e-12).lost_after > 95.0


def test_growth_needs_samples():
    count = run.LIMITS.min_growth_samples
    for samples in (count, count - 1):
        angles = 1.0 + np.arange(samples) / 10.0  # all of them later than an eighth of the last
        assert (measure_growth(1e-5 * angles, angles, 1e-12).exponent is None) == (samples < count)


def spinning_down(distance, growth=1.0):
    """A run from 2E/|L|² = 0.75 to a distance from its value at the third axis, where the second half stays."""
    n, last = 400, 1.0 / MOMENTS[2] + distance * (1.0 / MOMENTS[0] - 1.0 / MOMENTS[2])
    ratio = 0.75 + (last - 0.75) * 2.0 * np.linspace(0.0, 1.0, n).clip(max=0.5)
    share = (ratio - 1.0 / MOMENTS[0]) / (1.0 / MOMENTS[2] - 1.0 / MOMENTS[0])
    L = np.zeros((n, 3))
    L[:, 2], L[:, 0] = np.sqrt(share), np.sqrt(1.0 - share)
    L *= np.linspace(1.0, growth, n)[:, None]
    q = np.tile([1.0, 0.0, 0.0, 0.0], (n, 1))
    return EngineRun(np.diag(MOMENTS), np.arange(n) * 1.0, q, L, 1e-16, n)


def test_a_spin_ends_near_an_axis():
    reach = run.LIMITS.max_distance_from_axis
    assert find_spin_end(spinning_down(INSIDE * reach)).toward == "largest"
    assert find_spin_end(spinning_down(OUTSIDE * reach)).toward == "larger moments"


def test_states_after_the_momentum_has_grown_do_not_count():
    reach, most = 0.5 * run.LIMITS.max_distance_from_axis, run.LIMITS.max_momentum_growth
    assert find_spin_end(spinning_down(reach, INSIDE * most)).toward == "largest"
    assert find_spin_end(spinning_down(reach, 3.0 * most)).toward != "largest"


def test_a_sphere_has_no_axes_to_end_at():
    for factor, ends in ((10.0, True), (0.1, False)):
        apart, one = factor * run.LIMITS.min_anisotropy, spinning_down(0.01)
        whole = replace(one, inertia=np.diag([1.0, 1.0 + apart / 2.0, 1.0 + apart]), eps=1e-18, steps=1)
        assert (find_spin_end(whole).toward != "none") == ends


def test_a_length_is_mentioned_beyond_its_tolerance():
    off = stepping.LIMITS.length_tolerance
    for factor in (INSIDE, OUTSIDE):
        assert bool(stepping.find_length_change(np.array([1.0, 1.0 + factor * off]), 1e-16)) == (factor > 1.0)


def test_digits_count_as_printed_in_enough_numbers_of_few_digits():
    numbers, digits = stepping.LIMITS.min_numbers, stepping.LIMITS.max_printed_digits
    for count in (numbers - 1, numbers):
        short = np.array([round(0.1 + k / 1000.0, 3) for k in range(count)])
        assert (stepping.find_printed_unit(short) > 0.0) == (count >= numbers)
    for length in (digits, digits + 1):
        values = np.array([float(f"0.{'1' * (length - 2)}{k:02d}") for k in range(11, 31)])
        assert (stepping.find_printed_unit(values) > 0.0) == (length <= digits)


ARGUMENTS = import_module("polhode.judging.judge").LIMITS  # the package has the function under this name


@pytest.mark.parametrize("name, value", [
    ("steps", ARGUMENTS.max_steps + 1), ("steps", ARGUMENTS.min_steps - 1), ("dt", OUTSIDE * ARGUMENTS.max_step_angle),
    ("attitude", (1.0 + OUTSIDE * ARGUMENTS.length_tolerance, 0.0, 0.0, 0.0)),
])  # fmt: skip
def test_arguments_beyond_their_limits_are_refused(name, value):
    with pytest.raises(InvalidInput, match=f"`{name}`"):
        judge(rk4(equations(np.diag(MOMENTS))), **{"dt": 0.05, "steps": 64, name: value})


def test_arguments_within_their_limits_are_judged():
    """A step of the largest angle is too long for an order, and is judged all the same."""
    almost = 1.0 + INSIDE * ARGUMENTS.length_tolerance
    report = judge(rk4(equations(np.diag(MOMENTS))), INSIDE * ARGUMENTS.max_step_angle, steps=ARGUMENTS.min_steps,
                   attitude=(almost, 0.0, 0.0, 0.0))  # fmt: skip
    assert report.judgements


def table_of(**run_of):
    times = 0.1 * np.arange(1, 6)
    q = np.tile([1.0, 0.0, 0.0, 0.0], (5, 1))
    table = {"inertia": [1.0, 2.0, 3.0], "attitude": [1.0, 0.0, 0.0, 0.0], "momentum": [1.0, 0.0, 0.0],
             "times": times.tolist(), "attitudes": q.tolist(), "momenta": [[1.0, 0.0, 0.0]] * 5, "dt": 0.1}  # fmt: skip
    return table | run_of


def reads(**run_of):
    try:
        state_files._read_run(table_of(**run_of), {}, None, 1)
    except InvalidInput:
        return False
    return True


def test_files_are_refused_beyond_their_thresholds():
    limits = state_files.LIMITS
    for factor in (INSIDE, OUTSIDE):
        inside = factor < 1.0
        assert reads(attitudes=[[1.0 + factor * limits.length_tolerance, 0.0, 0.0, 0.0]] * 5) == inside
        assert reads(attitude=[1.0 + factor * limits.start_length_tolerance, 0.0, 0.0, 0.0]) == inside
        assert reads(momenta=[[factor * limits.max_number, 0.0, 0.0]] * 5) == inside
        assert reads(dt=factor * limits.max_step) == inside
        off = factor * limits.tensor_tolerance * 3.0
        assert reads(inertia=[[1.0, off, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 3.0]]) == inside
        assert reads(inertia=[1.0, 2.0, 3.0 * (1.0 + factor * limits.tensor_tolerance)]) == inside


def test_a_file_of_too_many_bytes_is_refused(tmp_path, monkeypatch):
    path = tmp_path / "states.json"
    path.write_text('{"format": "polhode engine states", "version": 1, "runs": [{}]}', encoding="utf-8")
    for factor, fits in ((1, True), (-1, False)):
        size = path.stat().st_size + factor
        monkeypatch.setattr(state_files, "LIMITS", state_files.LIMITS._replace(max_bytes=size))
        if fits:
            assert state_files.read_engine_states(path)[1] == []
        else:
            with pytest.raises(InvalidInput, match=r"states\.json"):
                state_files.read_engine_states(path)


def of_file(**run_of):
    return state_files._read_run(table_of(**run_of), {}, None, 1)


def test_runs_are_of_one_motion_within_the_tolerance_of_their_starts():
    off = written.LIMITS.start_tolerance
    for factor in (0.9, 1.1):
        other = of_file(momentum=[1.0 + factor * off, 0.0, 0.0])
        assert written._are_of_one_motion(of_file(), other) == (factor < 1.0)


def test_steps_are_halved_within_the_tolerance_of_their_ratio():
    off = written.LIMITS.step_ratio_tolerance
    for factor in (INSIDE, OUTSIDE):
        pair = [of_file(dt=0.1), of_file(dt=0.1 / (2.0 + factor * off))]
        assert bool(written._by_halved_steps(pair)) == (factor < 1.0)
