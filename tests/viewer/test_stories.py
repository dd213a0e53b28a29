"""What the playground's stories say, computed: each number in them, and what the body is said to do."""

import math
import re
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import polhode as ph
from polhode.analysis.cone import axis_angles, rotation_form
from polhode.analysis.twist import racket_twist
from polhode.kinds.page import page_of_answers
from polhode.kinds.playground import SAMPLES, presets
from polhode.kinds.reading import read_spec

EXAMPLES = Path(__file__).parents[2] / "examples"
PHONE_LONG = 0  # the phone's long axis, of least moment


def story(example):
    """Return what is said, in one text, and the tables that steps set."""
    (found,) = [words for words in presets() if words["example"] == example]
    steps = found["story"]
    return " ".join(step["say"] for step in steps), {step.get("label"): step.get("set") for step in steps}


def motion_of(example):
    return read_spec(EXAMPLES / f"{example}.toml").report().motion


def spun(motion, spin):
    """Return the body spun as the page does by a step: about an axis, tilted from it."""
    moments, axis = np.asarray(motion.moments), spin["about"] - 1
    velocity = np.zeros(3)
    velocity[axis], velocity[(axis + 1) % 3] = math.cos(spin["tilt"]), math.sin(spin["tilt"])
    return ph.FreeMotion(moments, momentum=moments * velocity * spin["rate"])


def numbers(words, pattern):
    return [float(found) for found in re.findall(pattern, words)]


@pytest.mark.parametrize(("example", "label"), [
    ("t_handle", "Spin about axis 3"), ("book", "About axis 1"), ("book", "About axis 3"),
])  # fmt: skip
def test_what_cones_is_said_to_cone(example, label):
    words, sets = story(example)
    spin = sets[label]["spin"]
    motion = spun(motion_of(example), spin)
    farthest = math.degrees(axis_angles(motion)[spin["about"] - 1].max())
    assert rotation_form(motion) == "coning" and "stays where it is" not in words
    said = numbers(words, r"within ([\d.]+)°")
    assert min(abs(farthest - bound) for bound in said) < 0.1


def test_the_t_handle_turns_over_from_every_tilt_and_sooner_from_the_larger():
    _, sets = story("t_handle")
    motion = motion_of("t_handle")
    five, little = (spun(motion, sets[label]["spin"]) for label in ("Tilt by 5°", "Tilt by 0.001°"))
    assert all(rotation_form(one) == "flipping" for one in (motion, five, little))
    assert five.flip_interval < motion.flip_interval < little.flip_interval


def test_the_phone_is_twisted_by_little_after_one_turn():
    """It was said to make half a twist with one turn."""
    words, _ = story("smartphone")
    motion = motion_of("smartphone")
    assert numbers(words, r"only (\d+)°") == [round(math.degrees(racket_twist(motion, PHONE_LONG)))] == [14.0]
    once, over = numbers(words, r"at ([\d.]+) s")
    assert once == pytest.approx(2.0 * math.pi / motion.precession_rate, abs=0.005)
    times = np.linspace(0.0, 1.0, 1001)
    middle = motion.momentum(times)[:, 1]
    assert over == pytest.approx(times[np.argmax(middle * middle[0] < 0.0)], abs=0.005)
    assert 1.0 < over * motion.precession_rate / (2.0 * math.pi) < 2.0  # in the second turn


def test_the_earths_circle():
    words, _ = story("earth")
    motion = motion_of("earth")
    assert f"some {motion.period / 86400.0:.0f} days" in words
    (radius,) = numbers(words, r"radius of (\d+) m")
    nearest = axis_angles(motion)[2].max() * (1.0 + 1.0 / 304.0)  # of Ω from the axis, the sum of both
    assert radius == round(nearest * 6356752.0)


def test_the_stopped_drum_leaves_a_spin_about_the_major_axis():
    """It was said to tumble."""
    words, _ = story("dual_spin")
    spec = read_spec(EXAMPLES / "dual_spin.toml")
    momentum, _ = spec.start(spec.body.principal_moments, spec.body.principal_axes)
    stopped = ph.FreeMotion(spec.body.principal_moments, momentum=momentum)
    away = axis_angles(stopped)[2]
    assert rotation_form(stopped) == "coning" and "tumbles" not in words
    held, most = numbers(words, r"within ([\d.]+)°")
    assert most == pytest.approx(math.degrees(min(away.max(), math.pi - away.min())), abs=0.005)
    report = spec.report()
    assert numbers(report.summary, r"and ([\d.]+)° from the rotor")[0] <= held < 6.3 + 1e-9


def test_explorer_takes_ten_times_as_long_with_a_tenth_of_the_losses():
    spec = read_spec(EXAMPLES / "explorer_1.toml")
    _, sets = story("explorer_1")
    assert sets["A tenth"]["system"]["damping"] == pytest.approx(0.1 * spec.system.damping)


@pytest.mark.sweep
def test_the_disks_last_turns():
    words, _ = story("euler_disk")
    report = replace(read_spec(EXAMPLES / "euler_disk.toml"), samples=SAMPLES).report()
    opens = page_of_answers(report, "disk", None).data["model"]  # at the first of the last turns
    states = np.array([opens["start"], np.asarray(report.trajectory.states)[0]])
    rounds = np.abs(np.asarray(report.disk.precession(states))) / (2.0 * math.pi)
    assert numbers(words, r"round (\d+) times a second") == np.round(rounds).tolist()
    assert numbers(words, r"at (\d+)° and less") == [round(math.degrees(opens["start"][0]))]
    assert numbers(words, r"(\d+) s before") == [round(opens["epoch"])]
