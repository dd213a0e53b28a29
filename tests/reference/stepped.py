"""The motions of `reference/stepped` and the same in polhode, and one process that answers for all of them."""

import json
import shutil
import subprocess
from pathlib import Path
from typing import Any, NamedTuple

import diffrax
import numpy as np

import polhode as ph
from polhode.motion._trajectory import Trajectory
from polhode.rolling import (
    AirLayer,
    BoundaryLayer,
    DrillingFriction,
    DryContourFriction,
    EulerDisk,
    RollingCouple,
    ViscousContourFriction,
)
from polhode.spacecraft import GravityGradient, LinearDrag, QuadraticDrag, TorquedBody
from polhode.systems import DoubleBracket, Gyrostat, HeavyTop, KeplerOrbit, TorquedGyrostat

REFERENCE = Path(__file__).parents[2] / "reference"
HERE = Path(__file__).parent
NODE = shutil.which("node")

UNIT = np.array([0.8, 0.0, 0.6, 0.0])
MOMENTUM = [1.0, 2.0, 0.3]
EPOCH = 2.5
TURNED = {"attitude": UNIT.tolist(), "momentum": MOMENTUM, "epoch": EPOCH}
TOP = {"moments": [1.0, 2.0, 2.7], "mgl": 3.0, "axis": [1.0, 2.0, 2.0], **TURNED}
GYROSTAT = {"moments": [1.0, 2.0, 3.0], "rotor": [0.3, 0.1, 1.0], **TURNED}
KOVALEVSKAYA = {"moments": [2.0, 2.0, 1.0], "mgl": 1.5, "axis": [0.6, 0.8, 0.0], **TURNED}
DISK = {"mass": 0.4, "radius": 0.04}
LAWS = {
    "air-layer": ("viscosity", 1.8e-3, AirLayer), "boundary-layer": ("coefficient", 2e-7, BoundaryLayer),
    "viscous-contour-friction": ("coefficient", 2e-6, ViscousContourFriction),
    "dry-contour-friction": ("coefficient", 1e-4, DryContourFriction),
    "rolling-couple": ("arm", 1e-5, RollingCouple), "drilling-friction": ("arm", 1e-4, DrillingFriction),
}  # fmt: skip


class Case(NamedTuple):
    """One motion in both languages: class and arguments in JavaScript, system and packed state in Python."""

    kind: str
    given: dict[str, Any]
    system: Any
    state: np.ndarray
    times: np.ndarray


def in_javascript(cases, folder=REFERENCE / "stepped"):
    """Return what run_stepped.mjs answers, all in one process."""
    done = subprocess.run([NODE, HERE / "run_stepped.mjs", folder.as_uri()], input=json.dumps(cases), text=True,
                          capture_output=True, timeout=300, check=False)  # fmt: skip
    assert not done.returncode, done.stderr
    return json.loads(done.stdout)


def asked(kind, given, times, **more):
    return {"kind": kind, "given": given, "times": list(times), **more}


def turning(kind, given, system, own=(), times=(0.0, 1.0, 4.0)):
    up = [2 * UNIT[1] * UNIT[3] - 2 * UNIT[0] * UNIT[2], 0.0, UNIT[0] ** 2 - UNIT[2] ** 2] if kind == "HeavyTop" else []
    state = np.array([*UNIT, *MOMENTUM, *up, *own])
    return Case(kind, {**given, **TURNED}, system, state, EPOCH + np.array(times))


def rolling(laws, half_thickness, parts, until):
    given = {**DISK, "half_thickness": half_thickness, "start": list(parts), "epoch": EPOCH,
             "dissipation": [{"law": law, LAWS[law][0]: LAWS[law][1]} for law in laws]}  # fmt: skip
    disk = EulerDisk(**DISK, thickness=2 * half_thickness, dissipation=[LAWS[law][2](LAWS[law][1]) for law in laws])
    return Case("EulerDisk", given, disk, np.array(parts), EPOCH + np.linspace(0.0, until, 3))


def cases():
    """Return one motion of every class, with everything that a class can have."""
    moments, axis = [1.0, 2.0, 3.0], [1.0, 2.0, 2.0]
    orbit = {"mean_motion": 0.7, "eccentricity": 0.4, "mean_anomaly_at_start": 0.3}
    circle = {"mean_motion": 0.7}
    wobbling = (0.5, 0.2, 0.1, 0.01, -0.02, 0.3, 7.0, 3.0)
    return {
        "top": turning("HeavyTop", TOP, HeavyTop(TOP["moments"], TOP["mgl"], TOP["axis"])),
        "gyrostat": turning("Gyrostat", GYROSTAT, Gyrostat(GYROSTAT["moments"], GYROSTAT["rotor"])),
        "motor": turning(
            "TorquedGyrostat",
            {"moments": moments, "axis": axis, "rotor_moment": 0.4, "torque": 0.3, "rotor_momentum": 0.5},
            TorquedGyrostat(moments, axis, 0.4, 0.3), [0.5],
        ),
        "double bracket": turning("DampedBody", {"moments": moments, "rate": 0.1}, DoubleBracket(moments, 0.1)),
        "drag": turning(
            "DampedBody", {"moments": moments, "linear_drag": [0.1, 0.2, 0.3], "quadratic_drag": 0.05, "orbit": orbit},
            TorquedBody(moments, [LinearDrag([0.1, 0.2, 0.3]), QuadraticDrag(0.05),
                                  GravityGradient(KeplerOrbit(0.7, 0.4, 0.3), moments)]),
        ),
        "circle": turning(
            "DampedBody", {"moments": moments, "linear_drag": 0.1, "orbit": circle},
            TorquedBody(moments, [LinearDrag(0.1), GravityGradient(KeplerOrbit(0.7, 0.0), moments)]),
        ),
        "thin disk": rolling([], 0.0, wobbling, 0.5),
        "thick disk": rolling(["air-layer", "boundary-layer", "viscous-contour-friction"], 0.005, wobbling, 0.5),
        "to its end": rolling(["dry-contour-friction", "rolling-couple", "drilling-friction", "air-layer"], 0.0,
                              (0.02, 0.2, 0.1, 0.01, -0.02, 0.0, 2.7, 0.0), 2.0),
    }  # fmt: skip


CASES = cases() if NODE else {}


def in_python(case: Case) -> Trajectory:
    return ph.simulate(
        case.system, case.state, case.times, method=diffrax.Dopri8(), tolerance=1e-13, estimate_error=False
    )
