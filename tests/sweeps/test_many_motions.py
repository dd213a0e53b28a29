"""Samples of one system that goes by steps are one run, and have the answers of their own reports without any."""

import json
from dataclasses import replace

import numpy as np
import pytest

from polhode.errors import NotConverged
from polhode.kinds import many_motions, stepping
from polhode.kinds.base import Spec
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
RIGID = '[system]\nkind = "rigid-body"\n'
GRAVITY = '[[torque]]\ntype = "gravity-gradient"\n'
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
    "wheel": (f"{PARTS}{SPIN}{RIGID}{WHEEL}{TIME}", VARIED, [*OF_ALL_BODIES, *OF_WHEEL, *STATES]),
    "held wheel": (f'{BODY}{SPIN}{RIGID}{WHEEL}drive = "constant-rate"\n{TIME}', TURNS,
                   [*OF_ALL_BODIES, *OF_WHEEL, *STATES]),
    "control": (f"{PARTS}{SPIN}{RIGID}{WHEELS}{CONTROL}{TIME}", VARIED,
                [*OF_ALL_BODIES, *OF_WHEEL, *OF_CONTROL, *STATES]),
    "orbit": (f"{PARTS}{SPIN}{RIGID}{ORBIT}{GRAVITY}{TIME}", VARIED,
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
    asked = f"[sweep]\nseed = 3\nsamples = {samples}\n{times}outputs = {json.dumps(names)}\n[sweep.inputs]\n"
    path.write_text(change(f"{tables}{asked}{varied}"))
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
        sampled = replace(spec, until=3.0, samples=len(times) + 1, instants=(0.0, *times)).motion().trajectory
        for name in found.plan.outputs:
            value = state_part(name, sampled, times) if name.startswith("states.") else pick(alone, name)
            if isinstance(value, str):
                assert chunk[name][k] == value, name
                continue
            value = np.nan if value is None else np.asarray(value, dtype=float)
            size = np.max(np.abs(value))
            np.testing.assert_allclose(chunk[name][k], value, rtol=ROUNDING, atol=ROUNDING * size, err_msg=name)


@pytest.mark.parametrize("case", CASES)
def test_as_the_report_on_each(tmp_path, case):
    agree(evaluator(tmp_path, case))


@pytest.mark.parametrize("case", ["rotor", "top", "wheel", "disk at rest"])
def test_a_chunk_is_one_run_without_reports(tmp_path, monkeypatch, case):
    outputs = [name for name in CASES[case][2] if not name.startswith(("states.", "normal_force"))]
    found, runs = evaluator(tmp_path, case, outputs, samples=20), []
    found.chunk(0, 1)
    simulate = stepping.simulate
    monkeypatch.setattr(stepping, "simulate", lambda *args, **more: runs.append(args[1]) or simulate(*args, **more))
    for owner, name in ((Evaluator, "make_spec"), (Spec, "report"), (type(found.plan.kind), "reports")):
        monkeypatch.setattr(owner, name, lambda *_: pytest.fail("a sample has a report of its own"))
    assert (found.chunk(0, 20).values["sample_status"] == "done").all()
    assert [len(state) for state in runs] == [20]


@pytest.mark.parametrize(("factor", "alone"), [(0.99, True), (1.01, False)])
def test_numbers_that_a_report_may_refuse_are_left_to_it(tmp_path, monkeypatch, factor, alone):
    found, made, make = evaluator(tmp_path, "rotor", ["final.energy"]), [], Evaluator.make_spec
    usual, motion = found.chunk(0, 1).values, found.make_spec(found.draw_inputs(0, 1), 0).motion().trajectory
    assert motion.angular_velocity is not None
    largest = max(np.abs(motion.states).max(), np.abs(motion.angular_velocity).max())
    monkeypatch.setattr(many_motions, "LIMITS", many_motions.ManyMotionsLimits(factor * largest))
    monkeypatch.setattr(Evaluator, "make_spec", lambda *args: made.append(args[2]) or make(*args))
    assert np.allclose(found.chunk(0, 1).values["final.energy"], usual["final.energy"], rtol=ROUNDING)
    assert bool(made) is alone


def test_what_may_not_start_is_refused_by_its_own_report(tmp_path):
    leans = '"system.lean" = { grid = ["-5 deg", "20 deg", "190 deg"] }'
    found = evaluator(tmp_path, "top", ["tilt.largest"], samples=1,
                      change=lambda text: text.replace('"system.lean" = { uniform = ["5 deg", "60 deg"] }', leans))
    chunk = found.chunk(0, 3)
    assert chunk.values["sample_status"].tolist() == ["refused", "done", "refused"]
    assert [k for k, _ in chunk.reasons] == [0, 2] and all("lean" in why for _, why in chunk.reasons)


def test_copies_that_do_not_arrive_are_found_among_the_others(tmp_path, monkeypatch):
    found, simulate, runs = evaluator(tmp_path, "rotor", ["final.energy"], samples=8), stepping.simulate, []
    usual = found.chunk(0, 8).values["final.energy"]
    starts = []

    def failing(system, state, times, **more):
        runs.append(np.asarray(state))
        starts.append(runs[0][5])
        if any(np.array_equal(row, starts[0]) for row in np.atleast_2d(state)):
            raise NotConverged("the sixth does not arrive")
        return simulate(system, state, times, **more)

    monkeypatch.setattr(stepping, "simulate", failing)
    chunk = found.chunk(0, 8)
    assert chunk.values["sample_status"].tolist() == ["done"] * 5 + ["not converged"] + ["done"] * 2
    assert np.allclose(np.delete(chunk.values["final.energy"], 5), np.delete(usual, 5), rtol=ROUNDING)
    assert [len(run) for run in runs[:5]] == [8, 4, 4, 2, 1] and chunk.reasons == [(5, "the sixth does not arrive")]


@pytest.mark.parametrize(("case", "key"), [
    ("rotor", '"system.rotor_rate" = { uniform = ["500 rpm", "600 rpm"] }\n'),
    ("control", TURNS),
])  # fmt: skip
def test_samples_of_several_systems_take_reports(tmp_path, case, key):
    found = evaluator(tmp_path, case, ["momentum_norm" if case == "rotor" else "end.energy"], samples=2,
                      change=lambda text: text.replace(CASES[case][1], key))
    assert not found.at_once


@pytest.mark.parametrize(("factor", "sizes"), [(0.99, [2, 2]), (1.01, [3, 1])])
def test_samples_kept_at_once_have_room(tmp_path, monkeypatch, factor, sizes):
    found, runs, simulate = evaluator(tmp_path, "rotor", ["final.energy"]), [], stepping.simulate
    usual, numbers = found.chunk(0, 4).values["final.energy"], 40 * 7  # of samples and components of one motion
    monkeypatch.setattr(many_motions, "STEPPING", stepping.SteppingLimits(max_numbers=factor * 3 * numbers))
    monkeypatch.setattr(stepping, "simulate", lambda *args, **more: runs.append(args[1]) or simulate(*args, **more))
    assert np.array_equal(found.chunk(0, 4).values["final.energy"], usual)
    assert [len(state) for state in runs] == sizes
