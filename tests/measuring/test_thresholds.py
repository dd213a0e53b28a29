"""Thresholds of fits of throws, attitudes and pendulums decide: inputs on either side have different outcomes."""

import numpy as np
import pytest

from polhode import FreeMotion
from polhode.errors import InvalidInput
from polhode.estimation._estimate import Estimate
from polhode.measuring import clean_log, fit_attitude, free_flights
from polhode.measuring.pendulum import _swing_moments as swing_moments
from polhode.measuring.pendulum import swings
from polhode.measuring.pendulum.fitting import Measured
from polhode.measuring.throws import _momentum_flight as momentum_flight
from polhode.measuring.throws import _principal as principal
from polhode.measuring.throws import _saturation as saturation
from polhode.measuring.throws import _throw_doubts as doubts
from polhode.measuring.throws import _throw_fit as throw_fit
from polhode.measuring.throws import _throw_search as search
from polhode.measuring.throws import _weightless_flight as weightless
from polhode.measuring.throws import flight, gyro_log, rest

INSIDE, OUTSIDE = 0.98, 1.02


def refuses(call, *arguments):
    try:
        call(*arguments)
    except InvalidInput:
        return True
    return False


def test_logs_are_refused_beyond_their_thresholds():
    limits = gyro_log.LIMITS
    for count in (limits.min_samples, limits.min_samples - 1):
        assert refuses(clean_log, np.arange(count) * 0.01, np.ones((count, 3))) == (count < limits.min_samples)
    for factor in (INSIDE, OUTSIDE):
        large = np.full((9, 3), factor * limits.max_value)
        assert refuses(clean_log, np.arange(9) * 0.01, large) == (factor > 1.0)
        assert refuses(clean_log, np.arange(9) * factor * limits.min_step, np.ones((9, 3))) == (factor < 1.0)


def rests(rates, acceleration=None, step=0.01):
    t = step * np.arange(len(rates))
    both = (t, acceleration) if acceleration is not None else (None, None)
    return rest.rest_stretches(clean_log(t, np.asarray(rates, dtype=float), *both))


def handled(first, last, peak):
    """Rates of a device that rests with one bias, is moved, and rests with another."""
    rates = np.zeros((300, 3))
    rates[:100], rates[200:] = first, last
    rates[100:200, 0] = peak * np.sin(np.linspace(0.0, np.pi, 100)) + first[0]
    rates[100:200, 1] = peak * np.sin(np.linspace(0.0, 20.0, 100))
    return rates


def test_a_single_rest_shows_a_small_bias_alone():
    most = rest.LIMITS.max_bias
    for factor in (INSIDE, OUTSIDE):
        assert bool(rests(np.tile([0.0, 0.0, factor * most], (200, 1)))) == (factor < 1.0)


def test_two_rests_show_a_larger_bias_up_to_that_of_an_axis_if_the_device_was_moved_between():
    most, handling = rest.LIMITS.max_bias_per_axis, rest.LIMITS.min_handling
    for factor in (INSIDE, OUTSIDE):
        bias = np.array([factor * most, 0.0, 0.0])
        assert (len(rests(handled(bias, bias, 3.0))) == 2) == (factor < 1.0)
    bias = np.array([0.9 * most, 0.0, 0.0])
    assert len(rests(handled(bias, bias, 1.1 * handling))) == 2 and not rests(handled(bias, bias, 0.5 * handling))


def test_rests_of_one_log_have_about_one_bias():
    for factor in (INSIDE, OUTSIDE):
        other = np.array([factor * rest.LIMITS.max_bias_change, 0.0, 0.0])
        assert len(rests(handled(np.zeros(3), other, 3.0))) == (2 if factor < 1.0 else 1)


def test_a_rest_lasts_and_does_not_wander():
    for factor in (0.8, 1.4):
        ramp = np.linspace(0.0, factor * rest.LIMITS.max_wander * 100 / 30, 100)
        assert bool(rests(np.stack([ramp, 0 * ramp, 0 * ramp], axis=1))) == (factor < 1.0)
    for seconds in (0.6, 1.5):
        count = int(seconds * rest.LIMITS.min_duration / 0.01)
        rates = 9.0 * np.cos(np.arange(200))[:, None] * np.ones(3)
        rates[100 : 100 + count] = 0.0
        assert bool(rests(rates)) == (seconds > 1.0)


def test_a_device_at_rest_has_weight_and_does_not_tilt():
    still = np.zeros((200, 3))
    for limit, outside in ((rest.LIMITS.min_gravity, -1), (rest.LIMITS.max_gravity, 1)):
        for sign in (-1, 1):
            weight = np.tile([0.0, 0.0, limit + 0.05 * sign], (200, 1))
            assert bool(rests(still, weight)) == (sign != outside)
    for factor in (0.8, 1.4):
        tilt = np.linspace(0.0, factor * rest.LIMITS.max_tilt * 200 / 30, 200)
        weight = np.stack([tilt, 0 * tilt, np.full(200, 9.8)], axis=1)
        assert bool(rests(still, weight)) == (factor < 1.0)


def weighed(seconds, felt, more=0.0):
    """A log of a device that is held, thrown and caught, once or twice, with the acceleration that it measures."""
    t = np.arange(0.0, 4.0, 0.005)
    free = (np.abs(t - 1.0) < seconds / 2.0) | (np.abs(t - 3.0) < more / 2.0)
    acceleration = np.where(free[:, None], [0.0, 0.0, felt], [0.0, 0.0, 9.8])
    return clean_log(t, np.tile([0.1, 0.2, 3.0], (len(t), 1)), t, acceleration)


def test_a_flight_lasts_and_a_much_shorter_one_is_not_listed():
    least, listed = flight.LIMITS.min_duration, flight.LIMITS.min_duration_left_out
    for seconds in (0.9 * listed, 1.1 * listed, 0.9 * least, 1.1 * least):
        windows, left = flight.find_flights(weighed(1.0, 0.0, seconds + 0.005))
        assert (len(windows), len(left)) == (1 + (seconds > least), int(listed < seconds < least))


def test_an_accelerometer_in_flight_measures_little():
    most = weightless.LIMITS.max_acceleration
    assert len(free_flights(weighed(1.0, 0.9 * most))) == 1 and not free_flights(weighed(1.0, 1.1 * most))


def test_inertias_are_possible_within_what_a_bias_makes_of_them():
    limits = momentum_flight.LIMITS
    for factor in (INSIDE, OUTSIDE):
        thin = [factor * limits.min_moment_ratio, 1.0, 1.0]
        flat = [0.3, factor * limits.min_triangle_ratio - 0.3, 1.0]
        for moments in (thin, flat):
            (possible,) = momentum_flight._possible(np.array([[*moments, 0.0, 0.0, 0.0]]))
            assert possible == (factor > 1.0)


def test_parts_of_a_log_turn_and_have_no_gaps():
    t = 0.01 * np.arange(100)
    for factor in (INSIDE, OUTSIDE):
        speeds = np.full(100, factor * momentum_flight.LIMITS.min_rate)
        assert bool(momentum_flight._find_turning_parts(t, speeds)) == (factor > 1.0)
        gap = t + np.where(np.arange(100) < 50, 0.0, factor * momentum_flight.LIMITS.max_gap - 0.01)
        assert len(momentum_flight._find_turning_parts(gap, np.full(100, 9.0))) == (1 if factor < 1.0 else 2)


def ratios(values, errors):
    return Estimate(("I1/I3", "I2/I3"), np.array(values), np.diag(np.square(errors)))


def test_intervals_are_narrow_and_moments_equal_within_their_thresholds():
    for factor in (INSIDE, OUTSIDE):
        error = factor * principal.LIMITS.max_half_width / 1.959964
        assert principal._is_narrow(ratios([0.4, 0.8], [error, 0.01])) == (factor < 1.0)
        gap = factor * principal.LIMITS.equal_errors * 0.01
        assert (principal._equal(ratios([0.5, 0.5 + gap], [0.01, 0.0])) == "I1 = I2") == (factor < 1.0)
        assert (principal._equal(ratios([0.5, 1.0 - gap], [0.001, 0.01])) == "I2 = I3") == (factor < 1.0)


@pytest.mark.parametrize("factor", [INSIDE, OUTSIDE])
def test_the_advice_depends_on_how_far_the_rates_go_from_their_mean(factor):
    def rates(angle):
        around = np.radians(np.array([-angle, angle]))
        return [np.stack([np.sin(around), 0.0 * around, np.cos(around)], axis=1)]

    steady = principal.explain_undetermined(rates(factor * principal.LIMITS.max_steady_angle), None)
    assert ("spins about a principal axis" in steady) == (factor < 1.0)
    assert (principal._tumble(factor * principal.LIMITS.max_upright_angle) == "") == (factor > 1.0)


def inertia_of(values, errors):
    one = ratios(values, errors)
    return type("Inertia", (), {"ratios": one})()


def test_a_body_misses_the_triangle_inequality_by_errors_alone(any_type):
    for factor in (INSIDE, OUTSIDE):
        excess = factor * doubts.LIMITS.max_errors * 0.01
        assert (doubts.why_impossible(inertia_of([0.4, 0.6 - excess], [0.01, 0.0])) is None) == (factor < 1.0)


def solution_at(**parameters):
    model = throw_fit.Model(("drag",), False, 1, 0.01)
    x = np.zeros(model.size)
    x[model.places["shape"]] = 0.3, 0.2
    for name, value in parameters.items():
        x[model.places[name]] = value
    return type("Solution", (), {"parameters": x, "model": model})()


def test_fits_end_at_bounds_within_their_thresholds(any_type):
    limits, low = search.LIMITS, throw_fit.PARAMETER_BOUNDS["drag"][0][0]
    assert search.find_bound(solution_at()) is None
    for factor in (INSIDE, OUTSIDE):
        assert (search.find_bound(solution_at(shape=(factor * limits.max_length, 0.2))) == "shape") == (factor > 1.0)
        assert (search.find_bound(solution_at(shape=(0.3, factor * limits.min_flatness))) == "shape") == (factor > 1.0)
        near = low + factor * limits.bound_distance
        assert (search.find_bound(solution_at(drag=near)) == "drag") == (factor < 1.0)


def throw_of(motion, step, count=60):
    t = step * (np.arange(count) - count // 2)
    return throw_fit.Throw(t, np.asarray(motion.angular_velocity(t)), 0.0)


def test_throws_are_refused_that_turn_too_little_or_too_fast():
    motion = FreeMotion((0.2, 0.8, 1.0), angular_velocity=(2.0, 9.0, 1.0))
    speed = float(np.median(np.linalg.norm(throw_of(motion, 0.01).rates, axis=1)))
    for factor in (0.8, 1.3):
        little = search.Start.of([throw_of(motion, factor * search.LIMITS.min_turn / speed / 60)]).degenerate
        assert ("nothing can be said" in (little or "")) == (factor < 1.0)
        far = search.Start.of([throw_of(motion, factor * search.LIMITS.max_turn_per_sample / speed)]).degenerate
        assert ("from sample to sample" in (far or "")) == (factor > 1.0)


def test_fast_rates_are_refused_of_a_round_body():
    for factor in (0.9, 1.1):
        for roundness in (0.9, 1.1):
            size, first = factor * search.LIMITS.max_rate, roundness * search.LIMITS.max_roundness
            spin = np.array([0.5, 0.7, 0.5]) * size / np.linalg.norm([0.5, 0.7, 0.5])
            motion = FreeMotion((first, 0.9, 1.0), angular_velocity=spin)
            said = search.Start.of([throw_of(motion, 0.002, 400)]).degenerate or ""
            assert ("beyond what gyros can tell" in said) == (factor > 1.0 and roundness > 1.0)


def test_rivals_and_handicaps(any_type):
    def fitted(aicc, forces):
        model = throw_fit.Model(forces, False, 1, 0.01)
        return type("Solution", (), {"aicc": aicc, "model": model})()

    handicap, distance = search.LIMITS.wheel_handicap, search.LIMITS.rival_distance
    air = fitted(100.0, ("drag",))
    for factor in (INSIDE, OUTSIDE):
        wheel = fitted(100.0 - factor * handicap, ("rotor",))
        assert (search.criterion(wheel) < search.criterion(air)) == (factor > 1.0)
        other = fitted(100.0 - handicap + factor * distance, ("rotor",))
        assert (search.rival([air, other]) is other) == (factor < 1.0)


def test_plateaus_of_known_ranges_and_of_enough_samples():
    range_ = float(saturation.KNOWN[0])
    for factor in (INSIDE, OUTSIDE):
        assert saturation._is_known(range_ * (1.0 + factor * saturation.LIMITS.range_tolerance)) == (factor < 1.0)
    least = saturation.LIMITS.min_plateau
    for count in (least - 1, least):
        ramp = np.arange(4.0, 100.0, 6.0)
        values = np.concatenate([ramp, np.full(count, 100.0), ramp[::-1]])
        assert bool(saturation._count_visits(values, 100.0, 1.0)) == (count >= least)
    share = saturation.LIMITS.max_share
    for factor in (0.97, 1.03):
        at_top = int(1000 * factor * share)
        values = np.concatenate([np.zeros(1000 - at_top), np.full(at_top, 100.0)])
        assert bool(saturation._count_visits(values, 100.0, 1.0)) == (factor < 1.0)
    for depth in (saturation.LIMITS.min_depth - 1, saturation.LIMITS.min_depth):
        values = np.concatenate([np.full(20, 100.0 - depth), np.full(20, 100.0)])
        assert bool(saturation._count_visits(values, 100.0, 1.0)) == (depth >= saturation.LIMITS.min_depth)


def attitudes(count, length=1.0):
    t = 0.05 * np.arange(count)
    q = np.asarray(FreeMotion((0.2, 0.8, 1.0), angular_velocity=(1.0, 5.0, 1.0)).attitude(t))
    q[0] *= length
    return t, q


def test_attitudes_are_refused_beyond_their_thresholds():
    assert refuses(fit_attitude, *attitudes(11)) and not refuses(fit_attitude, *attitudes(12))
    assert refuses(fit_attitude, *attitudes(40, 1.011)) and not refuses(fit_attitude, *attitudes(40, 1.009))


def test_axes_of_swings_are_one_within_their_tolerance():
    moments = Estimate(("swing 1", "swing 2"), np.array([1.0, 1.0]), 1e-4 * np.eye(2))
    for factor in (0.9, 1.1):
        tilt = factor * swing_moments.LIMITS.axis_tolerance
        axes = np.array([[0.0, 0.0, 1.0], [tilt, 0.0, 1.0]])
        assert len(swing_moments.combine_moments(moments, axes)[0]) == (1 if factor < 1.0 else 2)


def test_six_axes_determine_a_tensor_if_they_are_apart(monkeypatch):
    axes = np.array([[1.0, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 0], [1, 0, 1], [0, 1, 1]])
    axes /= np.linalg.norm(axes, axis=1)[:, None]
    moments = Estimate(tuple(f"axis {k}" for k in range(6)), np.ones(6), 1e-4 * np.eye(6))
    least = float(np.linalg.svd(swing_moments._directions(axes), compute_uv=False)[5])
    for factor in (INSIDE, OUTSIDE):
        changed = swing_moments.LIMITS._replace(min_singular_value=factor * least)
        monkeypatch.setattr(swing_moments, "LIMITS", changed)
        assert (swing_moments.fit_tensor(axes, moments) is None) == (factor > 1.0)


def test_timings_are_refused_that_deviate_or_are_too_few():
    off = swings.LIMITS.max_deviation
    for factor in (INSIDE, OUTSIDE):
        timings = [Measured(10.0), Measured(10.01), Measured(10.01 * (1.0 + factor * off))]  # the median is 10.01
        assert bool(list(swings._faults(timings))) == (factor > 1.0)
    assert list(swings._faults([Measured(10.0)])) and not list(swings._faults([Measured(10.0), Measured(10.1)]))

