"""What the page says of tops and gyrostats, against Python's analysis, eigenvalues and motions."""

import json
import math
import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest

import polhode as ph
from polhode import rotation
from polhode.analysis.gyrostat_rotations import steady_rotations
from polhode.systems import Gyrostat

HERE = Path(__file__).parent
SETTINGS = HERE.parents[1] / "viewer" / "src" / "settings"
NODE = shutil.which("node")
pytestmark = pytest.mark.skipif(NODE is None, reason="node is missing")
SAID = 2e-3
"""Relative: facts have four digits, and means over whole nods of sixty turns."""


def page_says(asked):
    done = subprocess.run([NODE, HERE / "run_settings.mjs", SETTINGS.as_uri()], input=json.dumps(asked), text=True,
                          capture_output=True, timeout=120, check=False)  # fmt: skip
    assert not done.returncode, done.stderr
    return json.loads(done.stdout)


# ---------------------------------------------------------------- upright tops


def grows(moments, mgl, k, spin):
    """Whether an upright top leaves its place: by eigenvalues of Euler's and Poisson's equations, by differences."""
    moments, axis = np.asarray(moments), np.eye(3)[k]
    rest = np.concatenate([moments * spin * axis, axis])

    def rate(state):
        momentum, up = state[:3], state[3:]
        turn = momentum / moments
        # the centre of mass lies along the axis, the weight along −up
        return np.concatenate([np.cross(momentum, turn) + mgl * np.cross(up, axis), np.cross(up, turn)])

    step = 1e-6
    matrix = np.column_stack([(rate(rest + step * e) - rate(rest - step * e)) / (2.0 * step) for e in np.eye(6)])
    return bool(np.linalg.eigvals(matrix).real.max() > 1e-3)


def some_tops(seed, count):
    generator = np.random.default_rng(seed)
    for _ in range(count):
        squares = generator.uniform(0.2, 1.0, 3)
        moments = squares.sum() - squares
        mgl, k, spin = generator.uniform(0.5, 2.0), int(generator.integers(3)), generator.uniform(-6.0, 6.0)
        yield [moments.tolist(), float(mgl), k, float(spin)]


def test_upright_tops_stand_where_no_eigenvalue_grows():
    tops = list(some_tops(1, 200))
    stands = page_says([["heavy_top.js", "standsUpright", top] for top in tops])
    truth = [not grows(*top) for top in tops]
    assert stands == truth and 20 < sum(truth) < 180
    # Lagrange's condition (I₃ω)² > 4 mgl I₁ with one of the moments in the other's place is noticed
    slip = [(moments[(k + 1) % 3] * spin) ** 2 > 4.0 * mgl * moments[k] for moments, mgl, k, spin in tops]
    assert slip != truth


# ---------------------------------------------------------------- gyrostats


@pytest.mark.sweep
def test_spins_about_the_rotor_are_judged_as_in_python():
    generator = np.random.default_rng(2)
    cases = []
    for _ in range(60):
        squares = generator.uniform(0.2, 1.0, 3)
        moments = squares.sum() - squares
        k, h, size = int(generator.integers(3)), generator.uniform(-3.0, 3.0), generator.uniform(0.5, 3.0)
        cases.append((moments, k, float(h), float(size)))
    given = [({"moments": m.tolist(), "axis": np.eye(3)[k].tolist(), "spin": h}, size) for m, k, h, size in cases]
    asked = [["gyrostat.js", "spinAboutRotor", one] for one in given]
    seen = set()
    for (moments, k, h, size), said in zip(cases, page_says(asked), strict=True):
        along = np.eye(3)[k]
        found = steady_rotations(Gyrostat(moments, h * along), size)
        (own,) = [one for one in found if np.asarray(one.along) @ along > 1.0 - 1e-9]
        assert said["extremum"] == own.extremum
        seen.add(own.extremum)
        if own.nutation is not None and said["nutation"] is not None:
            assert said["nutation"] == pytest.approx(own.nutation, rel=1e-9)
    assert seen == {"minimum", "maximum", "saddle"}


# ---------------------------------------------------------------- precession and nutation


def numbers(facts):
    return {name: value for name, value in facts}


def leading(text):
    return float(text.split()[0].rstrip("°").replace("−", "-"))


def test_a_gyroscope_goes_round_and_nods_as_the_closed_form_says():
    moments, mgl = (2.2e-4, 2.2e-4, 8e-5), 0.05
    lean = math.radians(70.0)
    attitude = [math.cos(0.5 * lean), math.sin(0.5 * lean), 0.0, 0.0]
    momentum = [0.0, 0.0, 8e-5 * 300.0]
    exact = ph.LagrangeMotion(moments, mgl=mgl, momentum=momentum, attitude=attitude)
    model = {"moments": moments, "mgl": mgl, "axis": [0.0, 0.0, 1.0], "momentum": momentum, "attitude": attitude}
    (facts,) = page_says([["heavy_top.js", "facts", [model]]])
    said = numbers(facts)
    unit = {"ms": 1e-3, "s": 1.0}[said["nutation: nods every"].split()[1]]
    assert leading(said["nutation: nods every"]) * unit == pytest.approx(exact.nutation_period, rel=SAID)
    around = leading(said["mean precession"]) * math.pi / 30.0
    assert around == pytest.approx(exact.precession_per_period / exact.nutation_period, rel=SAID)
    assert leading(said["a gyroscope's, mgl/I₃ω"]) * math.pi / 30.0 == pytest.approx(mgl / momentum[2], rel=SAID)
    least, most = (leading(part) for part in said["axis leans"].split(" to "))
    low, high = (math.degrees(math.acos(x)) for x in reversed(exact.nutation_limits))
    assert (least, most) == pytest.approx((low, high), abs=0.05)


@pytest.mark.long
def test_a_dual_spin_satellite_goes_round_as_its_motion_does():
    moments, rotor = np.array([3.0, 2.8, 2.0]), np.array([0.0, 0.0, 6.0])
    momentum, attitude = np.array([0.8, 0.1, 6.2]), np.array([1.0, 0.0, 0.0, 0.0])
    given = {"moments": moments, "rotor": rotor, "momentum": momentum, "attitude": attitude}
    model = {name: value.tolist() for name, value in given.items()} | {"rotor_moment": 0.5}
    (facts,) = page_says([["gyrostat.js", "facts", [model]]])
    said = numbers(facts)
    system = Gyrostat(moments, rotor)
    times = np.linspace(0.0, 60.0, 6001)
    run = ph.simulate(system, np.concatenate([attitude, momentum]), times)
    L = momentum / np.linalg.norm(momentum)  # in space, as the body starts along the axes there
    axis = rotation.rotate(np.asarray(run.attitude), np.array([0.0, 0.0, 1.0]))
    away = np.degrees(np.arccos(axis @ L))
    least, most = (leading(part) for part in said["rotor's axis leans from L"].split(" to "))
    assert (least, most) == pytest.approx((away.min(), away.max()), abs=0.02)
    across = np.cross(L, [1.0, 0.0, 0.0])
    across /= np.linalg.norm(across)
    angle = np.unwrap(np.arctan2(axis @ np.cross(L, across), axis @ across))
    around = (angle[-1] - angle[0]) / times[-1]
    assert leading(said["precession of the rotor's axis about L"]) * math.pi / 30.0 == pytest.approx(around, rel=0.01)
    assert "stable" in said["a spin about the rotor's axis"]
