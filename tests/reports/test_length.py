"""Runs that would take far too long are ended as soon as that is known; long ones say so."""

from contextlib import nullcontext
from pathlib import Path

import diffrax
import numpy as np
import pytest

from polhode.celestial.spin_orbit.system import SpinOrbit
from polhode.errors import InvalidInput, NotConverged
from polhode.integrators import _adaptive as adaptive
from polhode.kinds.reading import read_spec
from polhode.reports import length
from sweeping import first

EXAMPLES = Path(__file__).parents[2] / "examples"
EACH = 2e-5  # s a step

GYROSTAT = """
[body]
moments = ["{first} kg*m^2", "1 kg*m^2", "1 kg*m^2"]
[system]
kind = "gyrostat"
rotor_axis = [0.0, 0.0, 1.0]
rotor_moment = "1e-14 kg*m^2"
rotor_rate = "60 rpm"
[spin]
angular_velocity = ["1 rad/s", "1 rad/s", "0 rad/s"]
"""
MOTOR = GYROSTAT.format(first="1.2").replace('1e-14 kg*m^2"', '0.1 kg*m^2"\nmotor_torque = "1 N*m"')
DISK = """
[system]
kind = "euler-disk"
mass = "0.4 kg"
radius = "4 cm"
tilt = "20 deg"
"""


def made(folder, text, until=None, **keys):
    """Write an example or a text as a spec, with an end and keys of the system changed."""
    text = (EXAMPLES / text).read_text("utf-8") if text.endswith(".toml") else text
    for key, value in keys.items():
        text = text.replace("[system]", f"[system]\n{key} = {value}")
    end = "" if until is None else f'\n[time]\nuntil = "{until}"\nsamples = 50\n'
    (folder / "case.toml").write_text(text + end, "utf-8")
    return read_spec(folder / "case.toml")


ENDLESS = {
    "a dual-spin satellite for a thousand years": ("dual_spin.toml", "1000 year"),
    "a damped satellite for a thousand years": ("explorer_1.toml", "1000 year"),
    "a moon for a billion years": ("hyperion.toml", "1e9 year"),
    "moments far apart": (GYROSTAT.format(first="5e-13"), "10 year"),
    "a motor for a year": (MOTOR, "1 year"),
    "a disk without losses for a century": (DISK, "100 year"),
    "a top for a century": ((EXAMPLES / "top.toml").read_text("utf-8").split("[time]")[0], "100 year"),
}


@pytest.mark.long_cases("moments far apart", "a moon for a billion years")
@pytest.mark.parametrize("name", first(4, ENDLESS))
def test_runs_without_end_are_ended_soon(tmp_path, monkeypatch, name):
    monkeypatch.setattr(length, "LIMITS", length.LengthLimits(watched_seconds=0.1))
    text, until = ENDLESS[name]
    spec = made(tmp_path, text.replace("lagrange-top", "heavy-top"), until)
    with pytest.raises(InvalidInput, match=r"`time\.until` of .* would take about \S+ \S+; at most some ten minutes"):
        spec.report()


class Clock:
    """A processor's clock that advances by so much at each look."""

    def __init__(self, seconds):
        self.seconds, self.now = seconds, 0.0

    def process_time(self):
        self.now += self.seconds
        return self.now


def looked(monkeypatch, seconds, shares, until=100.0, remedy=""):
    """Let a watch look at shares of a run, so many seconds of work apart."""
    monkeypatch.setattr(length, "time", Clock(seconds))
    watch = length.Watch(until, np.linspace(0.0, 100.0, 50), remedy)
    shown = watch.init()
    for share in shares:
        shown = watch.step(shown, share)
    watch.close(shown)


def test_short_runs_say_nothing(monkeypatch, capsys):
    looked(monkeypatch, 0.2, np.linspace(0.0, 1.0, 4))
    assert capsys.readouterr() == ("", "")


def test_long_runs_say_so_once_on_standard_error(monkeypatch, capsys):
    looked(monkeypatch, 0.25, np.linspace(0.0, 1.0, 41))
    assert capsys.readouterr() == ("", "polhode: this takes about 50 s. Ctrl-C ends it.\n")  # five runs of 10 s


def test_what_was_compiled_before_the_first_look_does_not_count(monkeypatch, capsys):
    monkeypatch.setattr(length, "LIMITS", length.LengthLimits(long_seconds=2.0))
    clock = Clock(0.0)
    monkeypatch.setattr(length, "time", clock)
    watch = length.Watch(100.0, np.linspace(0.0, 100.0, 50))
    shown, clock.now = watch.init(), 1000.0
    for now, share in ((1000.0, 0.5), (1000.4, 0.9), (1000.6, 1.0)):
        clock.now = now
        shown = watch.step(shown, share)
    assert capsys.readouterr().err == "polhode: this takes about 3 s. Ctrl-C ends it.\n"


def at_times(monkeypatch, looks):
    """Let a watch look at (time [s], share) of a run."""
    clock = Clock(0.0)
    monkeypatch.setattr(length, "time", clock)
    watch = length.Watch(100.0, np.linspace(0.0, 100.0, 50))
    shown = watch.init()
    for clock.now, share in looks:
        shown = watch.step(shown, share)


def test_what_is_compiled_on_the_way_does_not_count(monkeypatch):
    """Twenty seconds of it once let a run without end go on, as it was too late to end it."""
    compiled = [(0.0, 0.0), (0.2, 1e-3), (20.0, 2e-3)]
    at_times(monkeypatch, [*compiled, *((20.0 + 0.1 * k, 2e-3 + 1e-3 * k) for k in range(1, 900))])
    endless = ((20.0 + 0.1 * k, 2e-3 + 1e-9 * k) for k in range(1, 900))
    with pytest.raises(InvalidInput, match="would take about"):
        at_times(monkeypatch, [*compiled, *endless])
    with pytest.raises(InvalidInput, match="would take about"):  # where every part takes long, it is none of compiling
        at_times(monkeypatch, [(30.0 * k, 1e-9 * k) for k in range(5)])


def test_what_may_yet_be_refused_is_not_announced(monkeypatch, capsys):
    with pytest.raises(InvalidInput, match=r"would take about 12 min"):
        looked(monkeypatch, 1.0, np.arange(1000) / 150.0)
    assert capsys.readouterr() == ("", "")


def test_the_longer_a_run_was_watched_the_less_it_may_exceed_the_limit(monkeypatch):
    with pytest.raises(InvalidInput, match=r"^`time\.until` of 100 s would take about 2\.9 days; at most some ten m"):
        looked(monkeypatch, 1.0, [0.0, 2e-5])
    with pytest.raises(InvalidInput, match=r"100 s, the usual one, would take about 12 min; .* \[time\]\. Or less\.$"):
        looked(monkeypatch, 1.0, np.arange(1000) / 150.0, None, "Or less.")
    looked(monkeypatch, 1.0, [0.0, *np.linspace(0.0012, 1.0, 30)])  # 69 min by the first look, 2.5 by the last


def test_runs_without_end_and_without_progress_are_told_in_numbers(monkeypatch):
    with pytest.raises(InvalidInput, match=r"would take about 1\.6e\+08 years"):
        looked(monkeypatch, 1.0, [0.0, 0.0])


@pytest.mark.sweep
def test_a_step_given_in_the_spec_is_watched_too(tmp_path, monkeypatch):
    monkeypatch.setattr(length, "LIMITS", length.LengthLimits(watched_seconds=0.1))
    with pytest.raises(InvalidInput, match=r"would take about .* A longer `system\.step` takes less"):
        made(tmp_path, "dual_spin.toml", "300 day", step='"0.01 s"').report()


def test_steps_counted_beforehand_say_so_on_standard_error(capsys):
    times = np.linspace(0.0, 100.0, 50)
    assert not length.check_length(100.0, times, 4e5, EACH)  # nobody watches
    out, err = capsys.readouterr()
    assert out == "" and err == "polhode: about 4.0e+05 steps, up to 8 s. Ctrl-C ends it.\n"
    assert not length.check_length(100.0, times, 1e5, EACH) and capsys.readouterr().err == ""
    with pytest.raises(InvalidInput, match=r"of 100 s, the usual one, would take about 1\.0e\+10 steps, about 2\.3 da"):
        length.check_length(None, times, 1e10, EACH)
    with pytest.raises(InvalidInput, match=r"4\.0e\+07 steps"):  # one to each sample at least
        length.check_length(100.0, np.linspace(0.0, 1.0, 40_000_000), 0.0, EACH)


@pytest.mark.parametrize("steps", [1e300, np.inf, np.nan])
def test_what_cannot_be_counted_is_said_in_finite_numbers(steps):
    """It was "about inf steps, inf years"."""
    with pytest.raises(InvalidInput) as caught:
        length.check_length(1e300, np.array([0.0, 1e300]), steps, EACH, "Sentence.")
    said = str(caught.value)
    assert "more than 1.0e+15 steps, more than 630 years; at most" in said and said.endswith("[time]. Sentence.")
    assert "inf" not in said and "nan" not in said


@pytest.mark.long
def test_adaptive_steps_are_bounded(monkeypatch):
    monkeypatch.setattr(adaptive, "MOST_STEPS", 40)
    system, start, times = SpinOrbit(0.5, 0.1), np.array([0.3, 1.1]), np.linspace(0.0, 400.0, 11)
    with pytest.raises(NotConverged, match=r"4\.0e\+01 steps did not reach the last time, 400 s"):
        adaptive.solve_adaptively(system, diffrax.Tsit5(), system.check_state(start), times)


@pytest.mark.parametrize("factor", (0.99, 1.01))
def test_a_run_of_ten_minutes_is_the_longest(factor):
    times, steps = np.linspace(0.0, 1.0, 2), 1000.0
    each = factor * length.LIMITS.max_seconds / steps
    with pytest.raises(InvalidInput, match="some ten minutes") if factor > 1.0 else nullcontext():
        length.check_length(1.0, times, steps, each, "")


@pytest.mark.parametrize("factor", (0.99, 1.01))
def test_a_run_is_announced_from_five_seconds_on(factor, capsys):
    length.check_length(1.0, np.linspace(0.0, 1.0, 2), 1000.0, factor * length.LIMITS.long_seconds / 1000.0, "")
    assert (capsys.readouterr().err != "") == (factor > 1.0)
