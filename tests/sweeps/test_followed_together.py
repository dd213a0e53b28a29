"""Samples whose motions go by steps are followed together, and each has the answers of its own report."""

import weakref
from dataclasses import replace

import numpy as np
import pytest

from polhode.errors import InvalidInput, NotConverged
from polhode.kinds import stepping
from polhode.kinds.base import Spec
from polhode.reports.answer import plain
from polhode.reports.base import MotionReport
from polhode.sweeps import evaluation
from polhode.sweeps.columns import pick
from polhode.sweeps.evaluation import Evaluator
from polhode.sweeps.plan import read_plan

TIME = '[time]\nuntil = "3 s"\nsamples = 40\n'
SPIN = '[spin]\nangular_velocity = ["0.1 rad/s", "0.2 rad/s", "0.3 rad/s"]\n'
BODY = '[body]\nmoments = ["2 kg*m^2", "3 kg*m^2", "4 kg*m^2"]\n'
VARIED = '"spin.angular_velocity.1" = { uniform = ["0.1 rad/s", "0.5 rad/s"] }\n'
# with an answer each that is not known of many motions, so that each sample has a report
CASES = {
    "heavy-top": (
        ('[system]\nkind = "heavy-top"\npivot = ["0 m", "0 m", "0 m"]\n[body]\nmoments = ["2 kg*m^2", "3 kg*m^2", '
        f'"4 kg*m^2"]\nmass = "3 kg"\ncenter_of_mass = ["0.1 m", "0.2 m", "0.4 m"]\n{SPIN}'),
        VARIED, ["tilt.smallest", "tilt.largest", "rates.motion.precession", "invariants.energy", "axis"],
    ),
    "gyrostat": (
        ('[system]\nkind = "gyrostat"\nrotor_axis = [0.0, 0.0, 1.0]\nrotor_moment = "0.02 kg*m^2"\n'
        f'rotor_rate = "600 rpm"\n{BODY}{SPIN}'),
        VARIED, ["rotor_axis_to_momentum.largest", "final.energy", "final.angular_velocity", "rotor.moment"],
    ),
    "rigid-body": (
        (f'{BODY}{SPIN}[system]\nkind = "rigid-body"\n[[wheel]]\naxis = [0, 0, 1]\nmoment = "0.01 kg*m^2"\n'
        'rate = "600 rpm"\n'),
        VARIED, ["end.energy", "end.angular_velocity", "wheels.1.rate_end", "mass"],
    ),
    "spin-orbit": (
        '[system]\nkind = "spin-orbit"\neccentricity = 0.05\norbital_period = "1 s"\nasphericity = 0.2\n',
        '"system.spin_ratio" = { uniform = [0.8, 1.6] }\n"system.angle" = { uniform = ["0 deg", "40 deg"] }\n',
        ["start.spin_ratio", "chaos_expected", "resonances.2.strength"],
    ),
}  # fmt: skip


def evaluator(tmp_path, case, outputs=None):
    tables, varied, usual = CASES[case]
    path = tmp_path / "case.toml"
    names = ", ".join(f'"{name}"' for name in outputs or usual)
    path.write_text(f"{tables}{TIME}[sweep]\nsamples = 4\noutputs = [{names}]\n[sweep.inputs]\n{varied}")
    return Evaluator(read_plan(path))


def agree(found):
    """Check that a chunk has the answers of the report on each sample alone."""
    count = found.plan.design.count
    chunk, inputs = found.chunk(0, count).values, found.draw_inputs(0, count)
    for k in range(count):
        alone = plain(found.make_spec(inputs, k).report().values())
        for name in found.plan.outputs:
            value = pick(alone, name)
            if isinstance(value, bool):
                value = "yes" if value else "no"
            value = np.nan if value is None else value
            assert np.array_equal(chunk[name][k], value, equal_nan=not isinstance(value, str)), name


@pytest.mark.parametrize("case", CASES)
def test_as_alone(tmp_path, case):
    agree(evaluator(tmp_path, case))


def test_another_copy_is_noticed(tmp_path, monkeypatch):
    right = stepping.copy_of
    monkeypatch.setattr(stepping, "copy_of", lambda trajectory, k: right(trajectory, k - 1))
    with pytest.raises(AssertionError, match="tilt"):
        agree(evaluator(tmp_path, "heavy-top"))


@pytest.mark.parametrize("case", CASES)
def test_one_run_for_copies_of_one_system(tmp_path, monkeypatch, case):
    found, runs = evaluator(tmp_path, case), []
    found.chunk(0, 4)
    simulate = stepping.simulate
    monkeypatch.setattr(stepping, "simulate", lambda *args, **more: runs.append(args[1]) or simulate(*args, **more))
    found.chunk(0, 4)
    assert [np.shape(state)[0] for state in runs] == [4]


@pytest.mark.parametrize(("factor", "sizes"), [(0.99, [2, 2]), (1.01, [3])])
def test_samples_kept_at_once_have_room(tmp_path, monkeypatch, factor, sizes):
    found, runs = evaluator(tmp_path, "heavy-top"), []
    found.chunk(0, 4)
    simulate, numbers = stepping.simulate, 40 * 10  # of samples and components of one motion
    monkeypatch.setattr(stepping, "LIMITS", stepping.SteppingLimits(max_numbers=factor * 3 * numbers))
    monkeypatch.setattr(stepping, "simulate", lambda *args, **more: runs.append(args[1]) or simulate(*args, **more))
    found.chunk(0, 4)
    assert [len(state) for state in runs if np.ndim(state) == 2] == sizes  # one that is left goes alone


TWO_SYSTEMS = '"body.moments.3" = { grid = ["4 kg*m^2", "4.5 kg*m^2"] }\n'
ORDERS = {
    "one system": ("", range(8), [4, 4]),
    "two one after the other": (TWO_SYSTEMS, range(8), [4, 4]),
    "two by turns": (TWO_SYSTEMS, (0, 4, 1, 5, 2, 6, 3, 7), [2, 2, 2, 2]),
}


@pytest.mark.parametrize("case", ORDERS)
def test_batches_are_made_when_due_and_leave_when_they_are_over(tmp_path, monkeypatch, case):
    grid, order, sizes = ORDERS[case]
    path, runs, numbers = tmp_path / "case.toml", [], 40 * 10  # of samples and components of one motion
    kept = weakref.WeakValueDictionary()
    tables, varied, _ = CASES["heavy-top"]
    samples = 4 if grid else 8
    path.write_text(f'{tables}{TIME}[sweep]\nsamples = {samples}\noutputs = ["tilt.largest"]\n'
                    f"[sweep.inputs]\n{varied}{grid}")  # fmt: skip
    found = Evaluator(read_plan(path))
    inputs = found.draw_inputs(0, 8)
    specs = [found.make_spec(inputs, k) for k in order]
    room, simulate = 4, stepping.simulate
    monkeypatch.setattr(stepping, "LIMITS", stepping.SteppingLimits(max_numbers=1.01 * room * numbers))

    def watched(*args, **more):
        trajectory = simulate(*args, **more)
        trajectory = replace(trajectory, states=np.array(trajectory.states))  # views of which keep it
        kept[len(runs)] = trajectory.states
        runs.append(trajectory.states.size)
        return trajectory

    monkeypatch.setattr(stepping, "simulate", watched)
    reports = []
    for k, report in enumerate(found.plan.kind.reports(specs)):
        assert isinstance(report, MotionReport)
        reports.append(report)
        assert len(runs) <= k + 1, "a run was made before its first report was due"
        assert sum(runs[run] for run in kept) <= room * numbers
    assert runs == [size * numbers for size in sizes] and not kept
    for spec, report in zip(specs, reports, strict=True):
        assert np.array_equal(report.trajectory.states, spec.motion().trajectory.states)


HUGE = """
[system]
kind = "gyrostat"
rotor_axis = [0.0, 0.0, 1.0]
rotor_moment = "1e79 kg*m^2"
rotor_rate = "1e73 rad/s"
[body]
moments = ["2e80 kg*m^2", "3e80 kg*m^2", "4e80 kg*m^2"]
[spin]
about = 3
tilt = "10 deg"
[time]
until = "1e-74 s"
samples = 5
[sweep]
outputs = [OUTPUT]
[sweep.inputs]
"spin.rate" = { grid = ["1e70 rad/s", "2e70 rad/s", "1e74 rad/s", "2e74 rad/s"] }
"""


@pytest.mark.filterwarnings("ignore:.*beyond double precision")
@pytest.mark.parametrize("output", ["momentum_norm", "final.angular_velocity", "rotor.momentum"])
def test_a_sample_whose_own_report_is_refused_is_refused(tmp_path, output):
    path = tmp_path / "huge.toml"
    path.write_text(HUGE.replace("OUTPUT", f'"{output}"'))
    found = Evaluator(read_plan(path))
    chunk, inputs = found.chunk(0, 4), found.draw_inputs(0, 4)
    for k in range(2):
        assert found.make_spec(inputs, k).report().summary
    said = []
    for k in range(2, 4):
        with pytest.raises(InvalidInput, match="momentum_norm") as refusal:
            found.make_spec(inputs, k).report()
        said.append((k, str(refusal.value)))
    assert chunk.values["sample_status"].tolist() == ["done", "done", "refused", "refused"]
    assert chunk.reasons == said


@pytest.mark.parametrize(("usual", "whole"), [(62.0, 4), (63.0, 0)])  # 600 rpm are 62.8 rad/s
def test_unusual_numbers_take_the_whole_report(tmp_path, monkeypatch, usual, whole):
    found, made, report = evaluator(tmp_path, "gyrostat"), [], Spec.report
    found.chunk(0, 1)
    monkeypatch.setattr(evaluation, "LIMITS", evaluation.LIMITS._replace(usual_size=usual))
    monkeypatch.setattr(Spec, "report", lambda spec: made.append(spec) or report(spec))
    assert (found.chunk(0, 4).values["sample_status"] == "done").all()
    assert len(made) == whole


def test_an_infinite_answer_that_no_sentence_says_is_undefined(tmp_path, monkeypatch):
    from polhode.kinds.heavy_top.answers import HeavyTopReport
    from polhode.reports.answer import Answer, Group

    usual = HeavyTopReport.iterate_answers
    monkeypatch.setattr(HeavyTopReport, "iterate_answers",
                        lambda report: [Group("", [Answer("flip_interval", np.inf)]), *usual(report)])  # fmt: skip
    found = evaluator(tmp_path, "heavy-top", ["tilt.largest", "axis"])
    assert found.chunk(0, 4).values["sample_status"].tolist() == ["done"] * 4
    monkeypatch.setattr(HeavyTopReport, "summary", "It leans by inf°.")
    chunk = found.chunk(0, 4)
    assert chunk.values["sample_status"].tolist() == ["refused"] * 4 and "would say inf" in chunk.reasons[0][1]


def test_verdicts_are_left_out_where_no_output_asks_for_them(tmp_path, monkeypatch):
    from polhode.kinds.gyrostat.answers import GyrostatReport

    found = evaluator(tmp_path, "gyrostat", ["final.energy", "rotor.moment"])
    found.chunk(0, 4)  # the first makes certain that no answer without a motion will do
    monkeypatch.setattr(GyrostatReport, "equilibria", property(lambda report: pytest.fail("were computed")))
    assert np.isfinite(found.chunk(0, 4).values["final.energy"]).all()


def test_what_fails_among_others_fails_alone(tmp_path, monkeypatch):
    found = evaluator(tmp_path, "heavy-top")
    whole, simulate, starts = found.chunk(0, 4).values["tilt.largest"], stepping.simulate, []

    def failing(system, state, times, **more):
        starts.append(np.asarray(state))
        if any(np.array_equal(row, starts[0][1]) for row in np.atleast_2d(state)):
            raise NotConverged("the second does not arrive")
        return simulate(system, state, times, **more)

    monkeypatch.setattr(stepping, "simulate", failing)
    chunk = found.chunk(0, 4)
    assert chunk.values["sample_status"].tolist() == ["done", "not converged", "done", "done"]
    assert np.array_equal(chunk.values["tilt.largest"][[0, 2, 3]], whole[[0, 2, 3]])
    assert chunk.reasons == [(1, "the second does not arrive")]
