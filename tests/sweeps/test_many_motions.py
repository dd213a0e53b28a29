"""Samples of one system that goes by steps are one run, and have the answers of their own reports without any."""

import json
from dataclasses import replace

import numpy as np
import pytest

from polhode.errors import InvalidInput, NotConverged
from polhode.kinds import many_motions, stepping
from polhode.kinds.gyrostat.ensemble import NUMBERS as OF_GYROSTATS
from polhode.kinds.heavy_top.ensemble import NUMBERS as OF_TOPS
from polhode.reports.answer import plain
from polhode.rolling.euler_disk.ensemble import NUMBERS as OF_DISKS
from polhode.spacecraft.rigid_body.ensemble import NUMBERS as OF_BODIES
from polhode.sweeps.columns import pick, state_part
from polhode.sweeps.evaluation import Evaluator
from polhode.sweeps.plan import read_plan

ROUNDING = 1e-12  # of an answer's size: a batch may be summed in another order than one motion
TIME = '[time]\nuntil = "3 s"\nsamples = 40\n'
BODY = '[body]\nmoments = ["2 kg*m^2", "3 kg*m^2", "4 kg*m^2"]\n'
PARTS = """[body]
parts = [{shape = "cylinder", mass = "30 kg", radius = "0.3 m", height = "2 m"},
{shape = "box", mass = "10 kg", size = ["0.9 m", "0.7 m", "0.5 m"], at = ["0.8 m", "0.3 m", "0 m"], axis = "x"}]
"""
SPIN = '[spin]\nangular_velocity = ["0.1 rad/s", "0.2 rad/s", "0.3 rad/s"]\n'
VARIED = '"spin.angular_velocity.1" = { uniform = ["0.1 rad/s", "0.5 rad/s"] }\n'
ABOUT = '[spin]\nabout = "y"\nrate = "9 rpm"\nattitude = [0.9, 0.3, 0.1, 0.0]\n'
LEANING = '[spin]\nabout = "y"\nrate = "9 rpm"\n'
TILT = '"spin.tilt" = { uniform = ["1 deg", "80 deg"] }\n'
TURNS = '"spin.attitude" = { so3 = "uniform" }\n'
ROTOR = ('[system]\nkind = "gyrostat"\nrotor_axis = [0.0, 0.6, 0.8]\nrotor_moment = "0.02 kg*m^2"\n'
         'rotor_rate = "600 rpm"\n')  # fmt: skip
TOP = '[system]\nkind = "heavy-top"\npivot = ["0 m", "0 m", "-1 m"]\nlean = "20 deg"\n'
WHEEL = '[[wheel]]\naxis = [0, 0, 1]\nmoment = "0.01 kg*m^2"\nrate = "600 rpm"\n'
WHEELS = "".join(
    f'[[wheel]]\naxis = {axis}\nmoment = "0.01 kg*m^2"\nmax_torque = "0.05 N*m"\n'
    for axis in ("[1, 0, 0]", "[0, 1, 0]", "[0, 0, 1]")
)
ORBIT = '[orbit]\naltitude = "500 km"\nrelative = true\n'
CONTROL = '[control]\nlaw = "quaternion-pd"\nbandwidth = "0.8 rad/s"\nby = "wheels"\ntarget = "inertial"\n'
DISK = '[system]\nkind = "euler-disk"\nmass = "400 g"\nradius = "40 mm"\ntilt = "30 deg"\n'
ROLLED = 'precession = "60 rad/s"\n'
THROWN = 'precession = "20 rad/s"\nspin = "1 rad/s"\ntilt_rate = "0.1 rad/s"\n'
LOSSES = 'thickness = "10 mm"\ndissipation = [{ law = "rolling-couple", arm = "1 mm" }]\n'
TILTS = '"system.tilt" = { uniform = ["10 deg", "60 deg"] }\n"system.heading" = { uniform = ["0 deg", "90 deg"] }\n'
STATES = ["states.attitude", "states.momentum", "states.angular_velocity"]
OF_PARTS = ["states.tilt", "states.contact_x", "states.angular_velocity"]
OF_WHEEL = ["wheels.1.rate_start", "wheels.1.rate_end", "wheels.1.rate_largest", "wheels.1.torque_largest"]
OF_CONTROL = [name for name in OF_BODIES if name.startswith("control.")]
OF_NADIR = ["from_nadir.start", "from_nadir.largest", "torques.1.largest", "torques.1.mean"]
OF_ALL_BODIES = [name for name in OF_BODIES if not name.startswith(("control.", "from_nadir."))]
CASES = {
    "rotor": (f"{ROTOR}{BODY}{SPIN}{TIME}", VARIED, [*OF_GYROSTATS, *STATES]),
    "rotor, turned": (f"{ROTOR}{PARTS}{SPIN}{TIME}", TURNS, [*OF_GYROSTATS, *STATES]),
    "motor": (f'{ROTOR}motor_torque = "0.1 N*m"\n{PARTS}{ABOUT}{TIME}', TILT,
              [*OF_GYROSTATS, *STATES, "states.rotor_momentum"]),
    "top": (f"{TOP}{PARTS}{LEANING}{TIME}",
            TILT + '"system.lean" = { uniform = ["5 deg", "60 deg"] }\n', [*OF_TOPS, *STATES]),
    "wheel": (f'{PARTS}{SPIN}[system]\nkind = "rigid-body"\n{WHEEL}{TIME}', VARIED, [*OF_ALL_BODIES, *OF_WHEEL, *STATES]),
    "held wheel": (f'{BODY}{SPIN}[system]\nkind = "rigid-body"\n{WHEEL}drive = "constant-rate"\n{TIME}', TURNS,
                   [*OF_ALL_BODIES, *OF_WHEEL, *STATES]),
    "control": (f'{PARTS}{SPIN}[system]\nkind = "rigid-body"\n{WHEELS}{CONTROL}{TIME}', VARIED,
                [*OF_ALL_BODIES, *OF_WHEEL, *OF_CONTROL, *STATES]),
    "orbit": (f'{PARTS}{SPIN}[system]\nkind = "rigid-body"\n{ORBIT}[[torque]]\ntype = "gravity-gradient"\n{TIME}', VARIED,
              [*OF_ALL_BODIES, *OF_NADIR, *STATES]),
    "disk at rest": (f"{DISK}{TIME}", TILTS, [*OF_DISKS, *OF_PARTS]),
    "disk": (f"{DISK}{ROLLED}{TIME}", TILTS, [*OF_DISKS, "states.tilt"]),
    "disk, thrown": (f"{DISK}{THROWN}{TIME}", TILTS + '"system.spin" = { uniform = ["0.5 rad/s", "3 rad/s"] }\n',
                     [*OF_DISKS, *OF_PARTS]),
    "disk, falling": (f"{DISK}{THROWN}{TIME}", '"system.precession" = { uniform = ["5 rad/s", "30 rad/s"] }\n',
                      [*OF_DISKS, *OF_PARTS]),
    "disk, damped": (f"{DISK}{LOSSES}{TIME}", TILTS, [*OF_DISKS, *OF_PARTS]),
}  # fmt: skip


def evaluator(tmp_path, case, outputs=None, samples=4, change=lambda text: text):
    tables, varied, usual = CASES[case]
    path, names = tmp_path / "case.toml", usual if outputs is None else outputs
    times = 'times = ["0.5 s", "2 s"]\n' if any(name.startswith("states.") for name in names) else ""
    text = f"{tables}[sweep]\nseed = 3\nsamples = {samples}\n{times}outputs = {json.dumps(names)}\n[sweep.inputs]\n{varied}"
    path.write_text(change(text))
    return Evaluator(read_plan(path))


def agree(found):
    """Check that a chunk has the answers of the report on each sample alone."""
    assert found.at_once and found.by_steps
    count = found.plan.design.count
    chunk, inputs = found.chunk(0, count).values, found.draw_inputs(0, count)
    assert (chunk["sample_status"] == "done").all()
    times = found.plan.times
    for k in range(count):
        spec = found.make_spec(inputs, k)
        alone = plain(spec.report().values())
        motion = replace(spec, until=3.0, samples=len(times) + 1, instants=(0.0, *times)).motion() if times else None
        for name in found.plan.outputs:
            value = state_part(name, motion.trajectory, times) if name.startswith("states.") else pick(alone, name)
            if isinstance(value, str):
                assert chunk[name][k] == value, name
                continue
            value = np.nan if value is None else np.asarray(value, dtype=float)
            size = np.max(np.abs(value))
            np.testing.assert_allclose(chunk[name][k], value, rtol=ROUNDING, atol=ROUNDING * size, err_msg=name)


@pytest.mark.parametrize("case", CASES)
def test_as_the_report_on_each(tmp_path, case):
    agree(evaluator(tmp_path, case))
