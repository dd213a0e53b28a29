"""The figure of a comparison, also where there is nothing to see."""

import numpy as np
import pytest

from polhode import FreeMotion, rotation
from polhode.analysis import AttitudeHistory, Mechanics
from polhode.spacecraft import compare
from polhode.spacecraft.comparing.figure import LIMITS, comparison

MOTION = FreeMotion((1.0, 2.0, 3.0), momentum=(0.3, 1.8, 1.5))
BODY = Mechanics(np.diag([1.0, 2.0, 3.0]))


def history(times, turn=0.0, mechanics=BODY):
    attitude = rotation.multiply(rotation.from_rotation_vector((0.0, 0.0, turn)), MOTION.attitude(times))
    return AttitudeHistory("samples", times, attitude, MOTION.angular_velocity(times), mechanics=mechanics)


@pytest.mark.long_after(4)
@pytest.mark.parametrize("count", [1, 2, 200, 5000])
@pytest.mark.parametrize("turn", [0.0, 1e-9, 2.0])
def test_every_curve_lies_within_its_axes(count, turn):
    times = np.linspace(0.0, 30.0, count)
    figure = comparison(compare(history(times), history(times, turn)))
    figure.canvas.draw()
    assert [axes.get_ylabel() for axes in figure.axes] == ["angle  [rad]", "change, relative"]
    assert figure.axes[-1].get_xlabel() == "time of A  [s]"
    for axes in figure.axes:
        low, high = axes.get_ylim()
        assert axes.get_yscale() == "log" and 0.0 < low < high
        for line in axes.get_lines():
            assert np.isfinite(line.get_ydata()).all()
            assert (np.min(line.get_ydata()) > low) and (np.max(line.get_ydata()) < high)


def test_no_error_hides_between_the_points_drawn():
    times = np.linspace(0.0, 30.0, 5000)
    other = history(times)
    other.attitude[3210] = rotation.multiply(rotation.from_rotation_vector((0.1, 0.0, 0.0)), other.attitude[3210])
    figure = comparison(compare(history(times), other))
    angle = next(line for line in figure.axes[0].get_lines() if line.get_label().startswith("angle between"))
    assert angle.get_label() == "angle between them, largest of each stretch"
    assert np.max(angle.get_ydata()) == pytest.approx(0.1) and len(angle.get_ydata()) < 1000


def test_zero_is_drawn_as_zero_and_without_moments_there_is_one_picture():
    times = np.linspace(0.0, 30.0, 50)
    identical = AttitudeHistory("identity", times, np.tile([1.0, 0.0, 0.0, 0.0], (50, 1)))
    figure = comparison(compare(identical, identical))
    (axes,) = figure.axes
    assert np.all(axes.get_lines()[0].get_ydata() == LIMITS.drawn_zero)
    figure.canvas.draw()
    assert [tick.get_text() for tick in axes.get_yticklabels()] == ["0"]


@pytest.mark.parametrize("largest", [1e-3, 6e-16])  # the second's least is 1.2e-17
def test_zeros_stand_next_below_what_is_not_zero(largest):
    times = np.linspace(0.0, 30.0, 50)
    turns = rotation.from_rotation_vector(np.linspace(0.0, largest, 50)[:, None] * np.array([0.0, 0.0, 1.0]))
    still = AttitudeHistory("still", times, np.tile([1.0, 0.0, 0.0, 0.0], (50, 1)))
    figure = comparison(compare(AttitudeHistory("$turning", times, turns), still))
    figure.canvas.draw()
    (axes,) = figure.axes
    low, high = axes.get_ylim()
    assert high / low < 1e5 and axes.get_yticklabels()[0].get_text() == "0"
    assert sum(tick.get_text() == "0" for tick in axes.get_yticklabels()) == 1
    assert axes.get_lines()[0].get_ydata()[0] == axes.get_yticks()[0]
    assert figure.get_suptitle() == "A: $turning\nB: still"


def test_one_sample_has_its_time_on_the_axis():
    figure = comparison(compare(history(np.array([7.0])), history(np.array([7.0]), 1e-3)))
    assert np.array_equal(figure.axes[-1].get_xticks(), [7.0])
