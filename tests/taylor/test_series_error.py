"""Which further runs are made for the error of series, of which copies, and that each copy has what it has alone."""

from typing import Any

import numpy as np
import pytest

import polhode as ph
from polhode.integrators import Taylor, _series_comparison, _series_error
from polhode.integrators._difference import EPS
from polhode.integrators._series import NoSeries
from polhode.integrators._series_comparison import (
    LIMITS,
    choose_coarse,
    choose_first,
    in_batch,
    make_finer,
    truncation,
)
from polhode.taylor.runs import choose_precision

BODY = ph.systems.FreeRigidBody((1.0, 2.0, 3.0))
QUIET = np.array([0.2, 0.3, 3.0])  # about the longest axis
SADDLE = np.array([1e-7, 2.0, 1e-8])
MIXED = np.array([QUIET, SADDLE, 1.1 * QUIET, [0.0, 0.0, 0.0], 3.0 * QUIET, 0.7 * SADDLE])
TIMES = np.array([0.0, 60.0])


@pytest.fixture
def made(monkeypatch):
    """Which copies were moved in which order, with companions of which orders and how many samples of each."""
    runs, own = [], _series_error.run_or_refuse

    def run(system, states, times, last, precision, *more, companions=None, **others):
        runs.append((len(states), precision.order, () if companions is None else companions.orders, len(times)))
        return own(system, states, times, last, precision, *more, companions=companions, **others)

    for module in (_series_error, _series_comparison):
        monkeypatch.setattr(module, "run_or_refuse", run)
    return runs


@pytest.fixture
def without_companions(monkeypatch):
    monkeypatch.setattr(_series_error, "takes_companions", lambda *asked: False)


def limit(monkeypatch, **changed):
    monkeypatch.setattr(_series_comparison, "LIMITS", LIMITS._replace(**changed))
    monkeypatch.setattr(_series_error, "COMPARING", LIMITS._replace(**changed))


def in_parts(monkeypatch, numbers=1):
    """Let two copies be moved side by side."""
    limits = _series_error.LIMITS._replace(max_numbers_together=numbers, min_copies_together=2)
    monkeypatch.setattr(_series_error, "LIMITS", limits)


def test_quiet_copies_are_run_once_and_others_once_more(made):
    found: Any = ph.simulate(BODY, MIXED, TIMES)
    error = found.error_estimate
    assert made == [(6, 24, (21, 4), 2), (2, 24, (28, 28, 28), 2)]
    assert (error[[0, 2, 3, 4]] < 1e-13).all() and (error[[1, 5]] > 1e-13).all()


def test_without_companions_quiet_copies_are_run_three_times_and_others_six_times(made, without_companions):
    ph.simulate(BODY, MIXED, TIMES)
    assert made == [(6, 24, (), 65), (6, 21, (), 65), (4, 8, (), 65), *[(2, 28, (), 65)] * 3]


@pytest.mark.parametrize("changed", [{"max_roundings": 1e-3}, {"max_coarse_gap": 0.0}])
def test_either_sign_of_growth_has_copies_run_again(made, monkeypatch, changed):
    limit(monkeypatch, **changed)
    ph.simulate(BODY, QUIET[None], TIMES)
    assert [orders for *_, orders, _ in made].count((28, 28, 28)) == 1


@pytest.mark.parametrize(("seen", "max_coarse_gap"), [(True, LIMITS.max_coarse_gap), (False, np.inf)])
def test_growth_that_one_companion_does_not_show_by_chance_is_shown_by_the_coarse_one(
    monkeypatch, seen, max_coarse_gap
):
    """One companion was off by 20 roundings beside this saddle, and the motion by 60,000; it has no say here."""
    limit(monkeypatch, max_roundings=np.inf, max_coarse_gap=max_coarse_gap)
    rng = np.random.default_rng(7)
    momenta, off = rng.normal(size=(1500, 3)), 10.0 ** rng.uniform(-14.0, -2.0, 1500)
    momenta[:, 2] = momenta[:, 0] * np.sqrt((1.0 - 1.0 / 2.0) / (1.0 / 2.0 - 1.0 / 3.0)) * (1.0 + off)
    times = np.array([0.0, 40.0])
    found: Any = ph.simulate(BODY, momenta, times)
    exact = ph.FreeMotion((1.0, 2.0, 3.0), momentum=momenta).momentum(40.0)
    error = np.abs(found.states[:, -1] - exact).max(axis=1) / np.abs(exact).max(axis=1)
    assert (error < 30.0 * found.error_estimate).all() == seen


@pytest.mark.parametrize("changed", [{}, {"min_compared_times": 16}, {"max_compared_times": 16}])
@pytest.mark.parametrize("beside", [True, False])
def test_flips_between_samples_are_in_the_estimate(monkeypatch, request, beside, changed):
    """Over a long time beside a saddle runs are apart in its flips, and near each other again between them.

    Companions are compared where steps end, however few samples there are.
    """
    if not beside:
        request.getfixturevalue("without_companions")
    limit(monkeypatch, **changed)
    starts = (np.array([0.0, 1.0, 0.0]) + 1e-3 * np.random.default_rng(1).normal(size=(100, 3))) * [1.0, 2.0, 3.0]
    times, worst = np.linspace(0.0, 300.0, 1001), []
    body = ph.systems.FreeRigidBody((1.0, 2.0, 3.0))
    exact = ph.FreeMotion((1.0, 2.0, 3.0), momentum=starts[:, None]).momentum(times)
    error = np.abs(np.asarray(ph.simulate(body, starts, times, estimate_error=False).states) - exact).max(axis=(1, 2))
    for samples in (times[:: 1 if "max_compared_times" in changed else 200], times):
        said = np.asarray(ph.simulate(body, starts, samples).error_estimate)
        worst.append((error / np.abs(starts).max(axis=1) / said)[said < 0.05].max())
    assert (max(worst) < 3.0) == (beside or not changed)


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


def test_no_more_samples_are_stored_than_those_of_a_part(made, monkeypatch, request):
    in_parts(monkeypatch, 4 * 65 * 3)
    ph.simulate(BODY, np.tile(QUIET, (12, 1)), np.linspace(0.0, 60.0, 65))
    assert [copies for copies, *_ in made] == [4] * 3
    made.clear()
    request.getfixturevalue("without_companions")
    ph.simulate(BODY, np.tile(QUIET, (12, 1)), TIMES)
    assert [copies for copies, *_ in made] == [4] * 9  # motion, first and coarse run of each part
    made.clear()
    ph.simulate(BODY, QUIET, np.linspace(0.0, 60.0, 1001))
    assert [samples for *_, samples in made] == [1001, 251, 251]  # every fourth is compared


def test_no_samples_are_stored_but_those_that_are_kept(made):
    ph.simulate(BODY, MIXED, np.linspace(0.0, 60.0, 101), save=10)
    assert [samples for *_, samples in made] == [11, 2]
    made.clear()
    ph.simulate(BODY, QUIET, np.linspace(0.0, 60.0, 102), save=10)  # 11 are kept, and the last time is not
    assert [samples for *_, samples in made] == [12]


def test_only_copies_that_miss_the_tolerance_are_run_again(made):
    found: Any = ph.simulate(BODY, MIXED, TIMES, tolerance=1e-7)
    assert (found.error_estimate <= 1e-7).all()
    assert made[0] == (6, 10, (14,), 2) and made[1:] and all(copies < 6 for copies, *_ in made[1:])


def test_runs_are_chosen_by_what_truncation_shows():
    """Default steps are so short that three orders fewer do not show; those of order 16 would."""
    fine, low = choose_precision(None), choose_precision(None, 16)
    assert truncation(fine._replace(order=21)) < LIMITS.max_unseen_truncation < truncation(low._replace(order=13))
    assert choose_first(fine).order == 21 and choose_first(low) == make_finer(low)
    assert choose_first(low).order == 20 and truncation(make_finer(low)) < 0.1 * truncation(low)


@pytest.mark.parametrize(
    ("tolerance", "orders"), [(1e-8, (15,)), (1e-12, (19, 4)), (1e-13, (20, 4)), (1e-14, (22, 5))]
)
def test_coarse_companions_are_left_out_where_truncation_outweighs_all(made, tolerance, orders):
    _series_error.solve_with_error(BODY, Taylor(), QUIET, np.array([0.0, 10.0]), tolerance=tolerance)
    assert [beside for *_, beside, _ in made] == [orders]


@pytest.mark.parametrize(("tolerance", "runs"), [(1e-12, 1), (1e-13, 2)])
def test_one_companion_is_enough_where_truncation_is_all_that_grows(made, tolerance, runs):
    _series_error.solve_with_error(BODY, Taylor(), SADDLE, np.array([0.0, 30.0]), tolerance=tolerance)
    assert len(made) == runs


def test_thresholds_of_truncation_have_two_sides():
    sizes = [truncation(choose_precision(tolerance)) for tolerance in (1e-8, 1e-12, 1e-13, 1e-14)]
    assert sizes[0] > LIMITS.min_plain_truncation > sizes[1] > LIMITS.min_pure_truncation > sizes[2]
    assert sizes[2] > LIMITS.max_roundings * EPS > sizes[3]


@pytest.mark.parametrize("tolerance", [None, 1e-8, 1e-14])
def test_a_coarse_companion_is_of_the_lowest_order_with_a_small_truncation(tolerance):
    precision = choose_precision(tolerance)
    order = choose_coarse(precision)
    assert precision.reach ** (order + 1) <= LIMITS.coarse_truncation < precision.reach**order


def test_refusals_of_parts_are_those_of_a_batch():
    parts = [NoSeries("", "why", np.array([False, True])), NoSeries("", "why", np.array([True, False]))]
    first = in_batch(parts[0], np.array([0, 1]), 5, None)
    both = in_batch(parts[1], np.array([3, 4]), 5, first)
    assert both.copies is not None and both.copies.tolist() == [False, True, False, True, False]
