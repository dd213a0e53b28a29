"""What the playground's stories say, computed: every number in them, and what the body is said to do."""

import math
import re
from pathlib import Path

import numpy as np
import pytest

import polhode as ph
from polhode.analysis.cone import axis_angles, rotation_form
from polhode.analysis.twist import racket_twist
from polhode.kinds.playground import presets
from polhode.kinds.reading import read_spec
from polhode.rolling.euler_disk.spin_down import spin_down

EXAMPLES = Path(__file__).parents[2] / "examples"
PHONE_LONG = 0  # the phone's long axis, of least moment
CHANDLER = 433.0
"""Days; Gross, in *Treatise on Geophysics* 3 (2015) 215: 433.0 ± 1.1."""
NUMBER = r"(\d+(?:\.\d+)?)"


def story(example):
    """Return what is said, in one text without the brackets of buttons, and the tables that steps set."""
    (found,) = [words for words in presets() if words["example"] == example]
    steps = found["story"]
    words = " ".join(step["say"] for step in steps)
    return words.replace("[", "").replace("]", ""), {step.get("label"): step.get("set") for step in steps}


def motion_of(example):
    return read_spec(EXAMPLES / f"{example}.toml").report().motion


def spun(motion, spin):
    """Return the body spun as the page does by a step: about an axis, tilted from it."""
    moments, axis = np.asarray(motion.moments), spin["about"] - 1
    velocity = np.zeros(3)
    velocity[axis], velocity[(axis + 1) % 3] = math.cos(spin["tilt"]), math.sin(spin["tilt"])
    return ph.FreeMotion(moments, momentum=moments * velocity * spin["rate"])


def coned(example, label):
    """Return the largest angle [degrees] of the axis that a step spins about from L."""
    spin = story(example)[1][label]["spin"]
    return math.degrees(axis_angles(spun(motion_of(example), spin))[spin["about"] - 1].max())


def tilt_of(example, label):
    tables = story(example)[1][label]
    return math.degrees(tables["spin"]["tilt"] if "spin" in tables else tables["system"]["tilt"])


def phone_turns():
    """Return when the phone has turned once, and when it turns over [s]."""
    motion, times = motion_of("smartphone"), np.linspace(0.0, 1.0, 1001)
    middle = motion.momentum(times)[:, 1]
    return 2.0 * math.pi / motion.precession_rate, times[np.argmax(middle * middle[0] < 0.0)]


def polar_circle():
    """Return the radius [m] of the circle of Ω at the pole: of L about the axis, and a 304th more."""
    motion = motion_of("earth")
    return axis_angles(motion)[2].max() * (1.0 + 86400.0 / motion.period) * 6356752.0


def stopped():
    """Return the dual-spin satellite as one rigid body, with the momentum that it has while its drum turns."""
    report = read_spec(EXAMPLES / "dual_spin.toml").report()
    return ph.FreeMotion(report.trajectory.frame.moments, momentum=np.asarray(report.trajectory.momentum)[0])


def drum():
    """Return how far L gets from the rotor's axis, and with the rotor at rest the rate [rpm] and again how far [°]."""
    motion = stopped()
    momentum = np.asarray(motion.momentum(0.0))
    first = math.degrees(math.acos(abs(momentum[0]) / np.linalg.norm(momentum)))
    turning = np.linalg.norm(momentum / np.asarray(motion.moments)) * 30.0 / math.pi
    return first, turning, math.degrees(axis_angles(motion)[0].max())


def half_the_rate():
    """Return how far the top nods down [degrees], let go at half of its steady rate, at the same spin and lean."""
    report = read_spec(EXAMPLES / "precessing_top.toml").report()
    top = report.trajectory.motion
    _, sets = story("precessing_top")
    rate, lean = sets["Half the rate"]["spin"]["precession"], math.radians(30.0)
    velocity = np.array([0.0, rate * math.sin(lean), rate * math.cos(lean) + 253.0 * math.pi / 30.0])
    start = (math.cos(0.5 * lean), math.sin(0.5 * lean), 0.0, 0.0)
    moved = ph.LagrangeMotion(top.moments, mgl=top.mgl, momentum=np.asarray(top.moments) * velocity, attitude=start)
    return [math.degrees(math.acos(min(moved.nutation_limits)))]


def explorer():
    """Return by how much losses are enlarged, to a digit, the time to the flat spin [s], and an orbit's [min]."""
    flat = read_spec(EXAMPLES / "explorer_1.toml").report().values()["flat_spin_time"]["motion"]
    return float(f"{115.0 * 60.0 / flat:.0e}"), flat, 115.0


def disk(tilt):
    """Return how often a disk's contact goes round per second, and how long it takes to lie flat [s]."""
    spec = read_spec(EXAMPLES / "euler_disk.toml")
    table = spec.system
    body = ph.rolling.EulerDisk(
        table.mass, table.radius, table.thickness, table.axial_moment, table.diametral_moment, table.gravity,
        dissipation=[law.build() for law in table.dissipation],
    )  # fmt: skip
    start = body.rolling_state(tilt)
    return abs(float(body.precession(start))) / (2.0 * math.pi), spin_down(body, start).events["flat"]


# example, what is said with its numbers in place, and what they are; the slow ones compute a disk's end
SAID = [
    ("t_handle", f"Tilt it by {NUMBER}°", lambda: [tilt_of("t_handle", "Tilt by 5°")]),
    ("t_handle", f"the axis cones, within {NUMBER}° of L", lambda: [coned("t_handle", "Spin about axis 3")]),
    ("book", f"longest axis it keeps to it: the axis cones, within {NUMBER}° of L",
     lambda: [coned("book", "About axis 1")]),
    ("book", f"like a tray, it keeps that axis as well, within {NUMBER}°", lambda: [coned("book", "About axis 3")]),
    ("smartphone", f"twisted by only {NUMBER}°",
     lambda: [math.degrees(racket_twist(motion_of("smartphone"), PHONE_LONG))]),
    ("smartphone", f"turned once, at {NUMBER} s.*turns over at {NUMBER} s", phone_turns),
    ("earth", f"some {NUMBER} days; measured, it is {NUMBER}", lambda: [motion_of("earth").period / 86400.0, CHANDLER]),
    ("earth", f"radius of {NUMBER} m", lambda: [polar_circle()]),
    ("dual_spin", f"holds L within {NUMBER}° of its axis.*at {NUMBER} rpm and within {NUMBER}° of its axis", drum),
    ("precessing_top", f"down to {NUMBER}°", half_the_rate),
    ("explorer_1", f"enlarged some {NUMBER} times: here it takes {NUMBER} s, .* an orbit, {NUMBER} minutes", explorer),
    ("euler_disk", f"^Tilted by {NUMBER}° ",
     lambda: [math.degrees(read_spec(EXAMPLES / "euler_disk.toml").system.tilt)]),
    ("euler_disk", f"contact goes round {NUMBER} times a second\\. Rolling.*after {NUMBER} s it",
     lambda: disk(math.radians(12.0))),
    ("euler_disk", f"begun at {NUMBER}°", lambda: [tilt_of("euler_disk", "Begin at 1°")]),
    ("euler_disk", f"contact goes round {NUMBER} times a second\\. Its face.*flat {NUMBER} s later",
     lambda: disk(math.radians(1.0))),
    ("quantum_racket", f"with {NUMBER} quanta.*its {NUMBER} levels", lambda: [20, 2 * 20 + 1]),
]  # fmt: skip
SLOW = {"euler_disk"}


def as_marked(case):
    return pytest.param(*case, marks=[pytest.mark.sweep] if case[0] in SLOW else [], id=f"{case[0]}: {case[1][:30]}")


def differing(words, pattern, values):
    """Return the numbers in words that are not the values, at the digits that are written; "within" says a bound."""
    found = re.search(pattern, words)
    assert found, f"{pattern} is not said"
    wrong = []
    for k, (said, value) in enumerate(zip(found.groups(), values, strict=True), 1):
        unit = 10.0 ** -len(said.partition(".")[2])
        above = float(said) - value
        bounds = words[: found.start(k)].endswith("within ")
        if not (0.0 <= above < unit if bounds else abs(above) <= 0.51 * unit):
            wrong.append((said, value))
    return wrong


def not_computed(words, patterns):
    """Return the numbers in words that no pattern has as a number of its own."""
    known = {found.span(k + 1) for pattern in patterns for found in [re.search(pattern, words)] if found
             for k in range(len(found.groups()))}  # fmt: skip
    return [found.group() for found in re.finditer(f"(?<!axis ){NUMBER}", words) if found.span() not in known]


@pytest.mark.long_cases("smartphone: twisted by only (\\\\d+(?:\\\\.\\\\d+)?")
@pytest.mark.parametrize(("example", "pattern", "values"), [as_marked(case) for case in SAID])
def test_numbers_in_stories(example, pattern, values):
    assert not differing(story(example)[0], pattern, values())


@pytest.mark.parametrize("example", [words["example"] for words in presets()])
def test_every_number_in_a_story_is_computed(example):
    assert not not_computed(story(example)[0], [pattern for name, pattern, _ in SAID if name == example])


def test_a_wrong_number_and_one_that_nobody_computes_are_noticed():
    words, pattern = story("smartphone")[0], f"twisted by only {NUMBER}°"
    assert differing(words, pattern, [180.0]) == [("14", 180.0)]  # it was said to make half a twist with one turn
    assert not_computed(f"{words} After 3 s it is caught.", [p for name, p, _ in SAID if name == "smartphone"]) == ["3"]


@pytest.mark.parametrize("words", presets(), ids=lambda words: words["example"])
def test_buttons_set_what_they_are_called(words):
    for step in words["story"]:
        for said in re.findall(f"{NUMBER}°", step.get("label", "")):
            assert tilt_of(words["example"], step["label"]) == pytest.approx(float(said))
        for said in re.findall(r"axis (\d)$", step.get("label", "")):
            assert step["set"]["spin"]["about"] == int(said)


@pytest.mark.parametrize(("example", "label"), [
    ("t_handle", "Spin about axis 3"), ("book", "About axis 1"), ("book", "About axis 3"),
])  # fmt: skip
def test_what_cones_is_said_to_cone(example, label):
    words, sets = story(example)
    assert rotation_form(spun(motion_of(example), sets[label]["spin"])) == "coning"
    assert "stays where it is" not in words


def test_the_t_handle_turns_over_from_every_tilt_and_sooner_from_the_larger():
    _, sets = story("t_handle")
    motion = motion_of("t_handle")
    five, little = (spun(motion, sets[label]["spin"]) for label in ("Tilt by 5°", "Tilt by 0.001°"))
    assert all(rotation_form(one) == "flipping" for one in (motion, five, little))
    assert five.flip_interval < motion.flip_interval < little.flip_interval


def test_a_coning_body_has_no_flip_interval_in_its_report():
    """About its third axis the T-handle was said to turn over."""
    spec = read_spec(EXAMPLES / "earth.toml")
    values = spec.report().as_json_dict()
    assert values["form"] == "coning" and values["flip_interval"] is None and values["twist_per_flip"] is None
    assert "turns over" not in values["summary"]
    assert read_spec(EXAMPLES / "t_handle.toml").report().as_json_dict()["flip_interval"] is not None


def test_the_phone_turns_over_in_its_second_turn():
    once, over = phone_turns()
    assert 1.0 < over / once < 2.0


def test_the_rotor_s_own_motor_keeps_the_momentum():
    """|L| fell from 764.8 to 82.9: the story's start had the body's velocity, and not its momentum."""
    words, sets = story("dual_spin")
    chosen = sets["Stop the rotor"]
    motion = stopped()
    assert "L stays" in words and chosen["system"] == {"rotor_rate": 0.0}
    assert chosen["spin"]["momentum"] == pytest.approx(np.asarray(motion.momentum(0.0)), rel=1e-12)
    assert motion.regime == "long-axis"  # about the axis of least moment: the most energy for its L


def test_half_the_rate_is_half_the_rate():
    """"A little slower" was slower by a factor of 24."""
    top = read_spec(EXAMPLES / "precessing_top.toml").report().trajectory.motion
    _, sets = story("precessing_top")
    steady = top.precession_per_period / top.nutation_period
    assert sets["Half the rate"]["spin"]["precession"] == pytest.approx(0.5 * steady, rel=1e-3)


@pytest.mark.sweep
def test_the_drum_holds_l_where_it_is_said_to():
    report = read_spec(EXAMPLES / "dual_spin.toml").report()
    assert math.degrees(float(report.axis_to_momentum.max())) < 6.3


def test_explorer_takes_ten_times_as_long_with_a_tenth_of_the_losses():
    spec = read_spec(EXAMPLES / "explorer_1.toml")
    _, sets = story("explorer_1")
    assert sets["A tenth"]["system"]["damping"] == pytest.approx(0.1 * spec.system.damping)
