"""What reports on fits say: about which axis a body turned, and that residuals are not noise."""

import numpy as np
import pytest
import xarray as xr

from measuring.thrown import BODIES, SPINS, throw
from polhode import FreeMotion
from polhode.measuring import Window, clean_log, fit_throw
from polhode.measuring.answers import describe_turning
from polhode.measuring.throws._throw_fit import rms
from polhode.measuring.throws.flight import Flights
from polhode.measuring.throws.gyro_logs import ReadLog
from polhode.measuring.throws.report import ThrowReport
from polhode.measuring.throws.throw import FittedThrow, ModelScore, _find_misfit

BOOK = (0.35, 0.75, 1.0)
TIMES = np.linspace(0.0, 3.0, 200)
MIDDLE = "turning about the middle axis, over which it flips"


@pytest.mark.parametrize(("rates", "until", "equal", "words"), [
    ((9.0, 0.5, 0.3), 3.0, None, "turning about the axis of the smallest moment"),
    ((0.3, 0.5, 9.0), 3.0, None, "turning about the axis of the largest moment"),
    ((0.05, 9.0, 0.4), 3.0, None, MIDDLE),  # short-axis mode: it was said to turn about the largest moment's axis
    ((0.4, 9.0, 0.05), 3.0, None, MIDDLE),  # long-axis mode
    ((0.05, 9.0, 0.05), 0.2, None, "turning about the middle axis"),  # too short for a flip
    ((9.0, 5.0, 4.0), 3.0, None, "turning about none of its axes for long"),
    ((0.0, 0.0, 9.0), 3.0, None, "a steady spin"),
    ((0.4, 9.0, 0.05), 3.0, "I1 = I2", "turning about an axis of two moments that are equal within their errors"),
    ((0.3, 0.5, 9.0), 3.0, "I1 = I2", "turning about the axis of the largest moment"),
])  # fmt: skip
def test_the_axis_is_that_of_most_of_the_momentum(rates, until, equal, words):
    motion = FreeMotion(BOOK, angular_velocity=rates)
    assert describe_turning(motion, TIMES * until / 3.0, equal) == words


def test_without_a_motion_nothing_is_said():
    assert describe_turning(None, TIMES, None) == "–"


def fitted(left, step=0.01):
    times = step * np.arange(len(left))
    rates = np.tile([1.0, 9.0, 1.0], (len(left), 1))
    return [FittedThrow(0, Window(0.0, 1.0), times, rates + left, rates, None, None)]


def score(drag, rotor):
    return ModelScore(drag, rotor, True, 20, 0.0, 0.0, 0.0, False)


def test_a_throws_residuals_are_tested():
    rng = np.random.default_rng(4)
    noise, t = 1e-3 * rng.normal(size=(80, 3)), 0.01 * np.arange(80)
    assert _find_misfit(fitted(noise), []) is None
    swing = 2e-3 * np.sin(2 * np.pi * 3 * t)[:, None]
    found = _find_misfit(fitted(noise + swing), [score("none", False), score("quadratic", True)])
    assert found is not None and found.tried == ("air", "wheel") and found.cause is None


@pytest.mark.long
def test_a_throw_that_nothing_explains_has_no_errors(tmp_path):
    """A part that swings by itself at 6 Hz: it had errors, and the exit code was 0."""
    times, rates, _ = throw(np.random.default_rng(2), BODIES["book"], SPINS["long"], dropped=0.0, drag=0.0)
    rates = rates + 0.03 * np.sin(2 * np.pi * 6 * times)[:, None] * [1.0, -0.5, 0.7]
    fit = fit_throw(clean_log(times, rates), [[Window(-1.0, 2.0)]], drag=False, rotor=False)
    assert fit.misfit is not None and fit.ratios is not None and fit.beside_wheel is None
    assert all(np.isnan(one.standard_error).all() for one in (fit.ratios, fit.bias, fit.gain, fit.axes_error))
    read = [ReadLog(clean_log(times, rates), "a mapping", "rad/s", None, ())]
    report = ThrowReport(fit, ["log"], read, [Flights([], [])], None)
    assert not report.determined and report.summary.startswith("1 throw: something else acts on the body")
    lines = [line for group in report.answers if hasattr(group, "lines") for _, line in group.lines]
    assert "±" not in report.summary + " ".join(lines) and rms(fit.residuals) > 5e-3
    assert report.as_json_dict()["ratios"]["I1/I3"]["standard_error"] is None
    assert "corner" not in report.figures() and "interval" not in " ".join(report.notes)
    with xr.open_dataset(report.save(tmp_path / "fit.nc"), engine="h5netcdf") as data:
        assert data.misfit == "residuals are not noise: no estimate has an error"
        covariances = [name for name in data.variables if str(name).endswith("_covariance")]
        assert len(covariances) >= 3 and all(np.isnan(data[name]).all() for name in covariances)


@pytest.mark.long
def test_a_wheel_that_is_asked_for_has_no_error_where_it_does_not_explain():
    """A part that swings by itself at 6 Hz, fitted as a wheel: h had an error, and notes said that a wheel turns."""
    times, rates, _ = throw(np.random.default_rng(2), BODIES["book"], SPINS["long"], dropped=0.0, drag=0.0)
    rates = rates + 0.03 * np.sin(2 * np.pi * 6 * times)[:, None] * [1.0, -0.5, 0.7]
    fit = fit_throw(clean_log(times, rates), [[Window(-1.0, 2.0)]], drag=False, rotor=True)
    assert fit.misfit is not None and "wheel" in fit.misfit.tried
    assert fit.rotor is not None and np.isfinite(fit.rotor.value).all() and np.isnan(fit.rotor.standard_error).all()
    read = [ReadLog(clean_log(times, rates), "a mapping", "rad/s", None, ())]
    report = ThrowReport(fit, ["log"], read, [Flights([], [])], None)
    assert not report.determined and "indicate a wheel" not in " ".join(report.notes)
    assert "interval" not in " ".join(report.notes)
    assert not {"corner", "polhode"} & report.figures().keys() and "residuals" in report.figures()
    values = report.as_json_dict()
    assert values["rotor"]["standard_error"] is values["unmodelled"] is values["gain_spread"] is None
