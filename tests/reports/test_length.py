"""Runs that would take far too long are refused before they start; long ones say so."""

from pathlib import Path

import diffrax
import numpy as np
import pytest

from polhode.errors import InvalidInput, NotConverged
from polhode.integrators import adaptive
from polhode.kinds.reading import read_spec
from polhode.reports import length
from polhode.systems.spin_orbit import SpinOrbit

EXAMPLES = Path(__file__).parents[2] / "examples"
ABOUT = 3.0  # a factor within which a number of steps is told beforehand

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
    "a satellite for a month": ("dual_spin.toml", "30 day"),
    "a satellite for ten years": ("explorer_1.toml", "10 year"),
    "a moon for a million years": ("hyperion.toml", "1e6 year"),
    "moments far apart": (GYROSTAT.format(first="5e-13"), None),
    "a motor for a month": (MOTOR, "30 day"),
    "a disk without losses for a year": (DISK, "1 year"),
    "a top for a year": ((EXAMPLES / "top.toml").read_text("utf-8").split("[time]")[0], "1 year"),
}


@pytest.mark.parametrize("name", ENDLESS)
def test_runs_without_end_are_refused_at_once(tmp_path, name):
    text, until = ENDLESS[name]
    spec = made(tmp_path, text.replace("lagrange-top", "heavy-top"), until)
    with pytest.raises(InvalidInput, match=r"`time\.until` of .* would take about \S+ steps, .*; at most \S+ steps"):
        spec.report()


def test_a_long_step_does_not_hide_what_it_costs(tmp_path):
    with pytest.raises(InvalidInput, match="would take about"):
        made(tmp_path, "dual_spin.toml", "300 day", step='"1 day"').report()


def test_long_runs_say_so_on_standard_error(capsys):
    times = np.linspace(0.0, 100.0, 50)
    assert not length.check_length(100.0, times, 4e5, length.SPLITTING)  # nobody watches
    out, err = capsys.readouterr()
    assert out == "" and err == "polhode: about 4.0e+05 steps, up to 8 s. Ctrl-C ends it.\n"
    assert not length.check_length(100.0, times, 1e5, length.SPLITTING) and capsys.readouterr().err == ""
    with pytest.raises(InvalidInput, match=r"of 100 s, the usual one, would take about 1\.0e\+10 steps, about 2\.3 da"):
        length.check_length(None, times, 1e10, length.SPLITTING)
    with pytest.raises(InvalidInput, match=r"4\.0e\+07 steps"):  # one to each sample at least
        length.check_length(100.0, np.linspace(0.0, 1.0, 40_000_000), 0.0, length.ADAPTIVE)


@pytest.mark.parametrize("steps", [1e300, np.inf, np.nan])
def test_what_cannot_be_counted_is_said_in_finite_numbers(steps):
    """It was "about inf steps, inf years"."""
    with pytest.raises(InvalidInput) as caught:
        length.check_length(1e300, np.array([0.0, 1e300]), steps, length.SPLITTING, "Sentence.")
    said = str(caught.value)
    assert "more than 1.0e+15 steps, more than 630 years; at most" in said and said.endswith("[time]. Sentence.")
    assert "inf" not in said and "nan" not in said


def test_adaptive_steps_are_bounded(monkeypatch):
    monkeypatch.setattr(adaptive, "MOST_STEPS", 40)
    system, start, times = SpinOrbit(0.5, 0.1), np.array([0.3, 1.1]), np.linspace(0.0, 400.0, 11)
    with pytest.raises(NotConverged, match=r"4\.0e\+01 steps did not reach the last time, 400 s"):
        adaptive.solve_adaptively(system, diffrax.Tsit5(), system.check_state(start), times)


@pytest.mark.sweep
@pytest.mark.parametrize(
    ("text", "until", "kind"),
    [("dual_spin.toml", "2 h", "SPLITTING"), ("explorer_1.toml", "3 day", "ADAPTIVE"),
     ("hyperion.toml", "60 year", "ADAPTIVE"), (MOTOR, "5 min", "ADAPTIVE"), (DISK, "10 min", "ADAPTIVE")],
)  # fmt: skip
def test_steps_are_about_as_many_as_told(tmp_path, monkeypatch, text, until, kind):
    told = []
    monkeypatch.setattr(length, "SAID_FROM", 0.0)
    monkeypatch.setattr(length.sys.stderr, "write", told.append)
    report = made(tmp_path, text, until).report()
    monkeypatch.undo()
    expected = float(told[0].split()[2])
    assert expected / ABOUT <= report.trajectory.statistics["steps"] <= expected * ABOUT
