"""The stepped motions of `reference/stepped` are polhode's, keep what they should, and forget what was asked before."""

import math
import re
import shutil
import subprocess

import numpy as np
import pytest

import polhode as ph
from polhode.rolling import AirLayer, EulerDisk
from polhode.systems import HeavyTop
from reference.stepped import (
    CASES,
    DISK,
    EPOCH,
    GYROSTAT,
    KOVALEVSKAYA,
    MOMENTUM,
    NODE,
    REFERENCE,
    TOP,
    TURNED,
    UNIT,
    asked,
    in_javascript,
    in_python,
)

SAME = 1e-9  # of states, relative to their size: both integrate at 1e-12 a step or finer; measured are 4e-11
EXACT = 1e-11  # from closed forms after some turns; measured are 1e-12
KEPT = 1e-11  # drift of an invariant over 200 turns, relative; measured are 3e-12
BROKEN = 1e-6  # what a wrong formula must miss by at least
pytestmark = pytest.mark.skipif(NODE is None, reason="node is missing")


class WhenAsked(dict):
    """What a function makes of each name, made when it is first asked for."""

    def __init__(self, make):
        super().__init__()
        self.make = make

    def __missing__(self, name):
        self[name] = self.make(name)
        return self[name]


@pytest.fixture(scope="module")
def simulated():
    return WhenAsked(lambda name: in_python(CASES[name]))


def answered(simulated, folder=REFERENCE / "stepped"):
    """Return JavaScript's answers at the times of polhode's samples, by name."""
    questions = [asked(CASES[name].kind, CASES[name].given, found.times) for name, found in simulated.items()]
    return dict(zip(simulated, in_javascript(questions, folder), strict=True))


@pytest.fixture(scope="module")
def solved(simulated):
    return WhenAsked(lambda name: answered({name: simulated[name]})[name])


def column(answer, name):
    return np.array([state[name] for state in answer["states"]])


def miss(found, wanted):
    """Return the largest error of (T,) numbers or (T, n) vectors relative to the largest size."""
    found, wanted = (np.asarray(x, dtype=float).reshape(len(x), -1) for x in (found, wanted))
    size = np.linalg.norm(wanted, axis=-1).max() or 1.0
    return float(np.linalg.norm(found - wanted, axis=-1).max() / size)


def worst(answer, wanted):
    """Return the largest error of attitude, momentum and angular velocity."""
    pairs = (("attitude", wanted.attitude), ("momentum", wanted.momentum), ("velocity", wanted.angular_velocity))
    return max(miss(column(answer, name), np.asarray(values)) for name, values in pairs)


@pytest.mark.long_cases("top", "gyrostat", "thin disk", "circle", "drag", "to its end", "motor")
@pytest.mark.parametrize("name", CASES)
def test_states_are_those_of_polhode(name, solved, simulated):
    assert worst(solved[name], simulated[name]) < SAME


@pytest.mark.long_cases("top", "gyrostat", "thin disk", "circle", "drag", "to its end", "motor")
@pytest.mark.parametrize("name", CASES)
def test_invariants_and_balances_have_the_names_and_values_of_polhode(name, solved, simulated):
    wanted, states = simulated[name], solved[name]["states"]
    kept = {key: values for key, values in wanted.invariants.items() if key != "linear_space"}
    assert set(states[0]["invariants"]) == set(kept)
    for key, values in kept.items():
        assert miss([state["invariants"][key] for state in states], np.asarray(values)) < SAME, key
    assert set(states[0].get("balances", {})) == set(wanted.balances)
    for key, values in wanted.balances.items():
        assert miss([state["balances"][key]["value"] for state in states], np.asarray(values)) < SAME, key
        received = np.asarray(wanted.received[key])
        assert miss([state["balances"][key]["received"] for state in states], received) < SAME, key


def test_the_third_integrals_of_tops_are_those_of_polhode():
    oblique, level = [0.6, 0.8, 0.0], [0.0, 0.3, 0.4]  # momenta; Π·Γ = 0 with the second, which is across Γ
    tops = [([1.0, 2.0, 3.0], 0.0, oblique), ([2.0, 2.0, 1.0], 1.5, oblique), ([4.0, 1.0, 4.0], 1.5, oblique),
            ([4.0, 1.0, 4.0], 1.5, level), ([1.0, 1.0, 1.0], 1.5, oblique), ([2.0, 2.0, 1.0], 1.5, level)]  # fmt: skip
    axes = [[0.6, 0.8, 0.0], [0.6, 0.8, 0.0], [0.6, 0.0, 0.8], [0.6, 0.0, 0.8], [0.6, 0.0, 0.8], [0.0, 0.0, 1.0]]
    across = [0.5**0.5, 0.0, -(0.5**0.5), 0.0]  # Γ = e1
    givens = [{"moments": moments, "mgl": mgl, "axis": axis, "momentum": momentum, "attitude": across}
              for (moments, mgl, momentum), axis in zip(tops, axes, strict=True)]  # fmt: skip
    for given, answer in zip(givens, in_javascript([asked("HeavyTop", given, [0.0]) for given in givens]), strict=True):
        top = HeavyTop(given["moments"], given["mgl"], given["axis"])
        wanted = top.invariants(np.array([*across, *given["momentum"], 1.0, 0.0, 0.0]))
        found = answer["states"][0]["invariants"]
        assert set(found) == set(wanted) - {"linear_space"}
        for name, value in found.items():
            assert (np.isnan(wanted[name]) if value is None else abs(value - wanted[name]) < 1e-14), name


@pytest.mark.parametrize("name", [name for name in CASES if "disk" in name or "end" in name])
def test_a_disk_is_where_polhode_has_it(name, solved, simulated):
    wanted, system = simulated[name], CASES[name].system
    assert miss(column(solved[name], "parts"), np.asarray(wanted.states)) < SAME
    assert miss(column(solved[name], "contact"), np.asarray(wanted.states)[:, 3:5]) < SAME
    assert miss(column(solved[name], "center"), np.asarray(system.center(wanted.states))) < SAME
    assert miss(column(solved[name], "normalForce"), np.asarray(system.normal_force(wanted.states))) < SAME


def test_a_disk_ends_when_polhode_says_and_stays_so(simulated):
    wanted, case = simulated["to its end"], CASES["to its end"]
    end = float(wanted.times[-1])
    (answer,) = in_javascript([asked("EulerDisk", case.given, [end - 1e-6, 50.0, 1e6])])
    before, after, later = answer["states"]
    assert wanted.outcome.event == "flat" and end < case.times[-1]
    assert before["ended"] is None and after["ended"] == "flat" and after == later
    assert abs(after["tilt"] - 1e-6) < 1e-15


def test_what_a_system_has_of_its_own():
    free, bare = {**GYROSTAT, "rotor_moment": 0.5, "rotor_drive": "free"}, GYROSTAT
    driven = {**GYROSTAT, "rotor_moment": 0.5}
    damped = {"moments": [1.0, 3.0, 3.0], "rate": 0.1, **TURNED}
    motions = [("Gyrostat", free), ("Gyrostat", driven), ("Gyrostat", bare), ("DampedBody", damped)]
    answers = in_javascript([asked(kind, given, [EPOCH]) for kind, given in motions])
    loose, held, unknown, leaning = (answer["states"][0] for answer in answers)
    rotor = np.array(GYROSTAT["rotor"])
    rate = np.linalg.norm(rotor) / 0.5
    along = (np.array(MOMENTUM) - rotor) / GYROSTAT["moments"] @ rotor / np.linalg.norm(rotor)
    assert abs(held["rotorRate"] - rate) < 1e-14 and abs(loose["rotorRate"] - (rate - along)) < 1e-14
    assert unknown["rotorRate"] is None
    assert abs(leaning["angleToMajorAxis"] - math.atan2(1.0, math.hypot(2.0, 0.3))) < 1e-14


def test_a_disk_starts_steadily_as_in_polhode():
    thick = {**DISK, "half_thickness": 0.005, "dissipation": [{"law": "air-layer", "viscosity": 1.8e-3}]}
    givens = [{**thick, "tilt": 0.15}, {**thick, "tilt": 0.3, "precession": 30.0, "heading": 0.4, "face": 0.2},
              {**DISK, "tilt": 0.5}, {**DISK, "tilt": 0.5 * math.pi, "precession": 0.0, "spin": 20.0}]  # fmt: skip
    lossy, ideal = EulerDisk(**DISK, thickness=0.01, dissipation=AirLayer(1.8e-3)), EulerDisk(**DISK)
    wanted = [lossy.rolling_state(0.15), lossy.rolling_state(0.3, 30.0, heading=0.4, face=0.2),
              ideal.rolling_state(0.5), ideal.rolling_state(0.5 * math.pi, 0.0, 20.0)]  # fmt: skip
    found = in_javascript([{"kind": "rollingStart", "given": given} for given in givens])
    np.testing.assert_allclose(found, wanted, rtol=1e-13, atol=1e-13)


@pytest.mark.long
def test_what_has_a_closed_form_is_that():
    top = {"moments": [1.0, 1.0, 0.5], "mgl": 1.0, **TURNED}
    body = {"moments": [1.0, 2.0, 3.0], **TURNED}
    times = EPOCH + np.array([0.5, 20.0, -15.0])
    answers = in_javascript([asked("HeavyTop", top, times), asked("Gyrostat", {**body, "rotor": [0.0] * 3}, times),
                             asked("HeavyTop", {**body, "mgl": 0.0}, times)])  # fmt: skip
    exact = [ph.LagrangeMotion(**top), ph.FreeMotion(**body), ph.FreeMotion(**body)]
    for answer, motion in zip(answers, exact, strict=True):
        attitude, momentum = motion.state(times)
        assert miss(column(answer, "attitude"), np.asarray(attitude)) < EXACT
        assert miss(column(answer, "momentum"), np.asarray(momentum)) < EXACT


@pytest.mark.long
def test_invariants_hold_over_200_turns():
    given = [("HeavyTop", TOP), ("HeavyTop", KOVALEVSKAYA), ("Gyrostat", GYROSTAT)]
    given += [("EulerDisk", {**DISK, "start": CASES["thin disk"].given["start"]})]
    rates = [np.linalg.norm(np.array(MOMENTUM) / g["moments"]) for _, g in given[:3]] + [15.0]
    spans = [200 * 2 * math.pi / rate for rate in rates]
    answers = in_javascript([asked(kind, g, [g.get("epoch", 0.0), g.get("epoch", 0.0) + sense * span])
                             for (kind, g), span in zip(given, spans, strict=True) for sense in (1, -1)])  # fmt: skip
    names = [set(answer["states"][0]["invariants"]) for answer in answers[::2]]
    top = {"energy", "|P|²", "Π·P"}
    assert names == [top, top | {"Kovalevskaya's integral"}, {"energy", "|L|²", "momentum_space"},
                     {"energy", "linear_integral_1", "linear_integral_2"}]  # fmt: skip
    for answer in answers:
        first, last = (state["invariants"] for state in answer["states"])
        for name, value in first.items():
            drift = np.linalg.norm(np.subtract(last[name], value)) / np.linalg.norm(value)
            assert drift < KEPT, name


# ------------------------------------------------------------------ the method


def test_the_tableau_has_order_8_where_order_conditions_are_simple():
    (tableau,) = in_javascript([{"kind": "tableau"}])
    A, b, c = np.zeros((12, 12)), np.zeros(12), np.array(tableau["TIMES"])
    for row, entries in enumerate(tableau["STAGES"]):
        for column, weight in entries:
            A[row, column] = weight
    for stage, weight in tableau["WEIGHTS"]:
        b[stage] = weight
    assert np.allclose(A.sum(axis=1), c, rtol=0, atol=1e-14)
    for k in range(1, 9):  # bushy trees
        assert abs(b @ c ** (k - 1) - 1 / k) < 1e-14, k
    for k in range(7):
        for n in range(7 - k):  # one branch on the root, besides k leaves
            assert abs(b @ (c**k * (A @ c**n)) - 1 / ((n + 1) * (n + k + 2))) < 1e-14, (k, n)
    tall = b
    for k in range(1, 8):  # trees without branches
        tall = tall @ A
        assert abs(tall.sum() - 1 / math.factorial(k + 1)) < 1e-14, k


def test_errors_fall_with_the_eighth_power_of_the_step():
    given = {"moments": [1.0, 2.0, 3.0], "rotor": [0.0, 0.0, 0.0], "attitude": UNIT.tolist(), "momentum": MOMENTUM}
    counts = [12, 16, 24, 32]
    (found,) = in_javascript([{"kind": "fixedSteps", "given": given, "until": 8.0, "counts": counts}])
    wanted = np.concatenate(
        ph.FreeMotion(given["moments"], momentum=given["momentum"], attitude=given["attitude"]).state(8.0)
    )
    errors = np.linalg.norm(np.array(found) - wanted, axis=-1)
    assert errors.min() > 1e-12  # above rounding
    slope = -np.polyfit(np.log(counts), np.log(errors), 1)[0]
    assert abs(slope - 8.0) < 0.5, (slope, errors)


@pytest.mark.long
def test_a_state_does_not_depend_on_what_was_asked_before():
    late = 4000.0
    order = [late, 3.0, 1234.5, 1234.4, -500.0, 10.0, -3.0, 777.7, late]
    one = {**GYROSTAT, "epoch": 0.0}
    answers = in_javascript([asked("Gyrostat", one, order), *(asked("Gyrostat", one, [t]) for t in order)])
    assert answers[0]["states"] == [answer["states"][0] for answer in answers[1:]]
    assert answers[0]["steps"] > 0 and max(answers[0]["kept"]) <= 2048
    assert answers[1]["steps"] > 2 * 16 * 2048 / 2  # far enough for places to be dropped


@pytest.mark.long
def test_a_time_too_far_is_refused_and_reached_by_asking_again():
    far = 17_000.0
    (answer,) = in_javascript([asked("Gyrostat", GYROSTAT, [far], tries=1)])
    (said,) = answer["refusals"]
    assert re.match(r"t = 17000 s is more than 200000 steps away; t = [\d.]+ s is reached, and kept\.", said)
    assert answer["steps"] > 200_000 and max(answer["kept"]) <= 2048
    first = in_javascript([asked("Gyrostat", GYROSTAT, [EPOCH])])[0]["states"][0]["energy"]
    assert abs(answer["states"][0]["energy"] / first - 1.0) < 10 * KEPT


# ------------------------------------------------------------------ mistakes

WRONG = [
    ("HeavyTop", {**TOP, "moments": [1.0, -2.0, 3.0]}, "`moments` must be positive"),
    ("HeavyTop", {**TOP, "mgl": "inf"}, "`mgl` must be a finite number"),
    ("HeavyTop", {**TOP, "axis": [0.0, 0.0, 0.0]}, "`axis` must have a direction"),
    ("HeavyTop", {**TOP, "attitude": [1.0, 1.0, 0.0, 0.0]}, "`attitude` must be a unit quaternion"),
    ("Gyrostat", {**GYROSTAT, "rotor": [1.0, 2.0]}, "`rotor` must be 3 finite numbers"),
    ("Gyrostat", {**GYROSTAT, "rotor_drive": "held"}, '`rotor_drive` must be "constant-rate" or "free"; got "held"'),
    ("Gyrostat", {**GYROSTAT, "momentum": ["nan", 0.0, 0.0]}, "`momentum` must be 3 finite numbers"),
    ("TorquedGyrostat", {"moments": [1.0, 2.0, 3.0], "axis": [0.0, 0.0, 1.0], "rotor_moment": 0.0, "torque": 1.0,
                         "rotor_momentum": 0.0, **TURNED}, "`rotor_moment` must be positive"),
    ("DampedBody", {"moments": [1.0, 2.0, 3.0], "rate": -1.0, **TURNED}, "`rate` must not be negative; got -1"),
    ("DampedBody", {"moments": [1.0, 2.0, 3.0], "linear_drag": -1.0, **TURNED}, "`linear_drag` must not be negative"),
    ("DampedBody", {"moments": [1.0, 2.0, 3.0], "orbit": {"mean_motion": 1.0, "eccentricity": 1.0}, **TURNED},
     "`eccentricity` must be below 1"),
    ("EulerDisk", {**DISK, "start": [0.0] * 8}, "the tilt at the start must lie between 0.000001 rad"),
    ("EulerDisk", {**DISK, "start": [0.1] * 7}, "`start` must be 8 finite numbers"),
    ("EulerDisk", {**DISK, "half_thickness": 0.05, "start": [0.1] * 8}, "`half_thickness` must be at most the radius"),
    ("EulerDisk", {**DISK, "dissipation": [{"law": "mud"}], "start": [0.1] * 8}, "`dissipation[0].law` must be one of"),
    ("EulerDisk", {**DISK, "dissipation": [{"law": "air-layer"}], "start": [0.1] * 8},
     "`dissipation[0].viscosity` must be a finite number"),
    ("EulerDisk", {**DISK, "axial_moment": 1.0, "start": [0.1] * 8}, "`axial_moment` must be at most twice"),
    ("rollingStart", {**DISK, "tilt": 0.5, "precession": 20.0, "spin": 5.0}, "are not steady: the tilt would"),
]  # fmt: skip


def test_mistakes_are_refused_in_words():
    answers = in_javascript([asked(kind, given, [3.0]) for kind, given, _ in WRONG])
    for answer, (_, _, said) in zip(answers, WRONG, strict=True):
        assert said in answer.get("refused", ""), (said, answer)


def test_losses_cannot_be_followed_far_backward():
    given = {"moments": [1.0, 2.0, 3.0], "quadratic_drag": 1.0, **TURNED}
    (answer,) = in_javascript([asked("DampedBody", given, [-1e4])])
    assert re.match(r"the motion cannot be followed beyond t = -?[\d.]+ s", answer["refused"])


SPECIMENS = {  # file, what stands there, what is put there, the case that it breaks
    "weight": ("heavy_top.js", "+ h * c - k * b", "+ k * b - h * c", "top"),
    "rotor": ("gyrostat.js", "(q - b) / J", "q / J", "gyrostat"),
    "motor": ("gyrostat.js", "out[7] = torque;", "out[7] = 0;", "motor"),
    "drift": ("damped_body.js", "this.rate * x", "-this.rate * x", "double bracket"),
    "gravity": ("damped_body.js", "(3 * this.orbit.meanMotion ** 2)", "this.orbit.meanMotion ** 2", "circle"),
    "kepler": ("kepler.js", "angle - Math.sin(angle)", "angle", "drag"),
    "disk": ("rolling_mechanics.js", "- (C + m * a * a) * w2 * w3", "- C * w2 * w3", "thin disk"),
    "loss": ("rolling_dissipation.js", "k * rate * rate * Math.sqrt(rate)", "k * rate * rate", "thick disk"),
    "tableau": ("dormand_prince.js", "0.054293734116568765", "0.054393734116568765", "gyrostat"),
}  # fmt: skip


@pytest.mark.long_cases("weight")
@pytest.mark.parametrize("name", SPECIMENS)
def test_a_broken_formula_is_found(name, tmp_path, simulated):
    file, there, instead, case = SPECIMENS[name]
    shutil.copytree(REFERENCE, tmp_path / "reference")
    path = tmp_path / "reference" / "stepped" / file
    assert there in path.read_text()
    path.write_text(path.read_text().replace(there, instead))
    answers = answered({case: simulated[case]}, path.parent)
    assert worst(answers[case], simulated[case]) > BROKEN


def test_nothing_of_node_or_a_browser_is_used():
    for path in (REFERENCE / "stepped").glob("*.js"):
        text = path.read_text()
        imported = re.findall(r'from "([^"]+)"', text)
        assert all(name.startswith(("./", "../")) for name in imported), path
        assert not re.search(r"\b(require|process|window|document|globalThis|performance|Date)\b\s*[.(]", text), path


def test_the_example_prints_what_its_comments_say():
    folder = REFERENCE / "stepped"
    (code,) = re.findall(r"```js\n(.*?)```", (folder / "README.md").read_text(), re.DOTALL)
    done = subprocess.run([NODE, "--input-type=module"], input=code, text=True, capture_output=True, cwd=folder,
                          timeout=60, check=True)  # fmt: skip
    assert done.stdout.splitlines() == re.findall(r"; // (.*)", code)
