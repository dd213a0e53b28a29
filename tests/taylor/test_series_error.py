"""Which further runs are made for the error of series, of which copies, and that each copy has what it has alone."""

from typing import Any

import numpy as np
import pytest

import polhode as ph
from polhode.integrators import Taylor, _series_error
from polhode.integrators._difference import EPS
from polhode.integrators._series import NoSeries
from polhode.integrators._series_error import LIMITS, _in_batch, choose_first, make_finer, truncation
from polhode.taylor.runs import choose_precision

BODY = ph.systems.FreeRigidBody((1.0, 2.0, 3.0))
QUIET = np.array([0.2, 0.3, 3.0])  # about the longest axis
SADDLE = np.array([1e-7, 2.0, 1e-8])
MIXED = np.array([QUIET, SADDLE, 1.1 * QUIET, [0.0, 0.0, 0.0], 3.0 * QUIET, 0.7 * SADDLE])
TIMES = np.array([0.0, 60.0])


@pytest.fixture
def made(monkeypatch):
    """Which copies were moved in which order, one entry a run, and with how many samples of each."""
    runs, own = [], _series_error.run_or_refuse

    def run(system, states, times, last, precision, *more, **others):
        runs.append((len(states), precision.order, len(times)))
        return own(system, states, times, last, precision, *more, **others)

    monkeypatch.setattr(_series_error, "run_or_refuse", run)
    return runs


def in_parts(monkeypatch, numbers=1):
    """Let two copies be moved side by side."""
    limits = LIMITS._replace(max_numbers_together=numbers, min_copies_together=2)
    monkeypatch.setattr(_series_error, "LIMITS", limits)


def test_quiet_copies_are_run_twice_more_and_others_five_times(made):
    found: Any = ph.simulate(BODY, MIXED, TIMES)
    error = found.error_estimate
    assert made == [(6, 24, 65), (6, 21, 65), (4, 8, 65), *[(2, 28, 65)] * 3]
    assert (error[[0, 2, 3, 4]] < 1e-13).all() and (error[[1, 5]] > 1e-13).all()


@pytest.mark.parametrize("changed", [{"max_roundings": 1e-3}, {"max_growth": 0.0}])
def test_either_sign_of_growth_has_copies_run_again(made, monkeypatch, changed):
    monkeypatch.setattr(_series_error, "LIMITS", LIMITS._replace(**changed))
    ph.simulate(BODY, QUIET[None], TIMES)
    assert [order for _, order, _ in made].count(28) == 3


@pytest.mark.parametrize(("seen", "max_growth"), [(True, LIMITS.max_growth), (False, np.inf)])
def test_growth_that_one_run_does_not_show_by_chance_is_shown_by_the_coarse_one(monkeypatch, seen, max_growth):
    """The first run was off by 69 roundings beside this saddle, and the motion by 670,000; it has no say here."""
    monkeypatch.setattr(_series_error, "LIMITS", LIMITS._replace(max_roundings=np.inf, max_growth=max_growth))
    moments, start = (1.0, 2.0, 3.0), np.array([-1.02810009e-04, 1.53158817, -1.10815122e-04])
    cases = start * (1.0 + 1e-6 * np.random.default_rng(0).normal(size=(40, 3)))
    found: Any = ph.simulate(ph.systems.FreeRigidBody(moments), cases, [0.0, 60.0])
    exact = np.stack([ph.FreeMotion(moments, momentum=one).momentum(60.0) for one in cases])
    error = np.abs(found.states[:, -1] - exact).max(axis=1) / 1.5
    assert (error < 3.0 * found.error_estimate).all() == seen


@pytest.mark.parametrize(
    ("honest", "changed"),
    [(True, {}), (False, {"min_compared_times": 16}), (False, {"max_compared_times": 16})],
)
def test_flips_between_samples_are_in_the_estimate(monkeypatch, honest, changed):
    """Over a long time beside a saddle runs are apart in its flips, and near each other again between them."""
    monkeypatch.setattr(_series_error, "LIMITS", LIMITS._replace(**changed))
    starts = (np.array([0.0, 1.0, 0.0]) + 1e-3 * np.random.default_rng(1).normal(size=(100, 3))) * [1.0, 2.0, 3.0]
    times, worst = np.linspace(0.0, 300.0, 1001), []
    body = ph.systems.FreeRigidBody((1.0, 2.0, 3.0))
    exact = ph.FreeMotion((1.0, 2.0, 3.0), momentum=starts[:, None]).momentum(times)
    error = np.abs(np.asarray(ph.simulate(body, starts, times, estimate_error=False).states) - exact).max(axis=(1, 2))
    for samples in (times[:: 1 if "max_compared_times" in changed else 200], times):
        said = np.asarray(ph.simulate(body, starts, samples).error_estimate)
        worst.append((error / np.abs(starts).max(axis=1) / said)[said < 0.05].max())
    assert (max(worst) < 3.0) == honest


@pytest.mark.parametrize("more", [{}, {"tolerance": 1e-9}, {"save": 3}])
def test_a_batch_is_its_copies_to_the_bit_with_their_errors(monkeypatch, more):
    times = np.linspace(0.0, 30.0, 7)
    together: Any = ph.simulate(BODY, MIXED, times, **more)
    in_parts(monkeypatch)
    parts: Any = ph.simulate(BODY, MIXED, times, **more)
    for k, start in enumerate(MIXED):
        alone: Any = ph.simulate(BODY, start, times, **more)
        for some in (together, parts):
            np.testing.assert_array_equal(alone.states, some.states[k])
            assert alone.error_estimate == some.error_estimate[k]


def test_a_comparison_changes_no_bit_of_the_motion():
    for times in (TIMES, np.linspace(0.0, -30.0, 40)):
        one, other = (ph.simulate(BODY, MIXED, times, estimate_error=wanted).states for wanted in (True, False))
        np.testing.assert_array_equal(one, other)


def test_no_more_samples_are_stored_than_those_of_a_part(made, monkeypatch):
    in_parts(monkeypatch, 4 * 65 * 3)
    ph.simulate(BODY, np.tile(QUIET, (12, 1)), TIMES)
    assert [copies for copies, *_ in made] == [4] * 9  # motion, first and coarse run of each part
    made.clear()
    ph.simulate(BODY, QUIET, np.linspace(0.0, 60.0, 1001))
    assert [samples for *_, samples in made] == [1001, 251, 251]  # every fourth is compared


def test_only_copies_that_miss_the_tolerance_are_run_again(made):
    found: Any = ph.simulate(BODY, MIXED, TIMES, tolerance=1e-7)
    assert (found.error_estimate <= 1e-7).all()
    assert made[:2] == [(6, 10, 65), (6, 14, 65)] and made[2:] and all(copies < 6 for copies, *_ in made[2:])


def test_runs_are_chosen_by_what_truncation_shows():
    """Default steps are so short that three orders fewer do not show; those of order 16 would."""
    fine, low = choose_precision(None), choose_precision(None, 16)
    assert truncation(fine._replace(order=21)) < LIMITS.max_unseen_truncation < truncation(low._replace(order=13))
    assert choose_first(fine).order == 21 and choose_first(low) == make_finer(low)
    assert choose_first(low).order == 20 and truncation(make_finer(low)) < 0.1 * truncation(low)


@pytest.mark.parametrize(
    ("tolerance", "orders"), [(1e-8, [11, 15]), (1e-12, [15, 19, 8]), (1e-13, [16, 20, 8]), (1e-14, [18, 22, 8])]
)
def test_coarse_runs_are_left_out_where_truncation_outweighs_all(made, tolerance, orders):
    _series_error.solve_with_error(BODY, Taylor(), QUIET, np.array([0.0, 10.0]), tolerance=tolerance)
    assert [order for _, order, _ in made] == orders


def test_thresholds_of_truncation_have_two_sides():
    sizes = [truncation(choose_precision(tolerance)) for tolerance in (1e-8, 1e-12, 1e-13, 1e-14)]
    assert sizes[0] > LIMITS.min_plain_truncation > sizes[1]
    assert sizes[2] > LIMITS.max_roundings * EPS > sizes[3]


def test_refusals_of_parts_are_those_of_a_batch():
    parts = [NoSeries("", "why", np.array([False, True])), NoSeries("", "why", np.array([True, False]))]
    first = _in_batch(parts[0], np.array([0, 1]), 5, None)
    both = _in_batch(parts[1], np.array([3, 4]), 5, first)
    assert both.copies is not None and both.copies.tolist() == [False, True, False, True, False]
