"""The judge of states in a file: verdicts by one step size and by three, and refusals that do not end the others."""

import json
from pathlib import Path

import numpy as np
import pytest

from judged import run as run_command
from judging import simulated_engines as engines
from judging.simulated_engines import equations, midpoint, rk4, semi_implicit
from polhode.errors import FormatError
from polhode.judging import judge_file, reference_motions

TENSOR = np.array([[2.0, 0.1, 0.2], [0.1, 2.6, -0.1], [0.2, -0.1, 3.1]])
NAMES = [motion.name for motion in reference_motions(kind="free body", up_to=20.0)]
FLIPS = "flips, 10 deg to the first axis"


def only(report):
    (judgement,) = report.judgements
    return judgement


def written(method, radians, name=FLIPS, until=8.0, change=lambda q, L: (q, L), **mistake):
    """Return a run of the table's motion, as an engine writes it."""
    (motion,) = (m for m in reference_motions(kind="free body") if m.name == name)
    step, dt = method(equations(np.diag(motion.moments), **mistake)), radians / motion.rate
    q, L = motion.attitude, motion.momentum
    rows = []
    for _ in range(int(until / radians)):
        q, L = step(q, L, dt)
        rows.append(change(q, L))
    attitudes, momenta = zip(*rows, strict=True)
    return {"motion": name, "dt": dt, "times": [dt * (k + 1) for k in range(len(rows))],
            "attitudes": np.array(attitudes).tolist(), "momenta": np.array(momenta).tolist()}  # fmt: skip


def judged(folder: Path, runs, **head):
    path = folder / "states.json"
    table = {"format": "polhode engine states", "version": 1, "engine": "mine", "runs": runs} | head
    path.write_text(json.dumps(table), "utf-8")
    return judge_file(path)


def test_three_steps_in_a_file_give_the_order(tmp_path):
    found = only(judged(tmp_path, [written(midpoint, h) for h in (0.04, 0.02, 0.01)]))
    assert found.right and found.convergence.order == pytest.approx(2.0, abs=0.05)


@pytest.mark.long_after(6)
@pytest.mark.parametrize("radians", [0.1, 0.04])
@pytest.mark.parametrize("name", [name for name in NAMES if "far apart" not in name][::10])  # where RK4 explodes
def test_a_right_engine_with_long_steps_is_not_called_wrong(tmp_path, name, radians):
    """At a motion's fastest, a step may turn the body by far more than on average; then more is left open."""
    found = judged(tmp_path, [written(rk4, radians / 2**k, name) for k in range(3)])
    assert found.verdict in ("right", "undecided"), found.summary
    if found.verdict == "undecided":
        assert "shorter steps" in found.summary


def rounded(run, write):
    return run | {key: [[float(write(x)) for x in row] for row in run[key]] for key in ("attitudes", "momenta")}


@pytest.mark.long_after(1)
@pytest.mark.parametrize("write", [lambda x: f"{x:.6f}", lambda x: f"{x:.6g}", lambda x: f"{np.float32(x):.9g}"])
def test_printed_digits_are_no_mistake(tmp_path, write):
    halved = [rounded(written(rk4, h), write) for h in (0.04, 0.02, 0.01)]
    assert judged(tmp_path, halved).verdict == "right"
    off = [rounded(written(rk4, h, gyroscopic=0.99), write) for h in (0.04, 0.02, 0.01)]
    assert judged(tmp_path, off).verdict == "unexplained"


@pytest.mark.long
def test_two_decimals_decide_nothing(tmp_path):
    report = judged(tmp_path, [rounded(written(rk4, h, "short-axis 4"), lambda x: f"{x:.2f}")
                               for h in (0.04, 0.02, 0.01)])
    assert report.verdict == "undecided" and "Write more digits" in report.summary


@pytest.mark.parametrize("digits", [17, 14])
def test_three_steps_of_a_motion_without_a_name_do_so_too(tmp_path, digits):
    runs = [written(semi_implicit, h) for h in (0.04, 0.02, 0.01)]
    (motion,) = (m for m in reference_motions(kind="free body") if m.name == FLIPS)
    start = {"inertia": motion.moments, "attitude": motion.attitude, "momentum": motion.momentum}
    for k, run in enumerate(runs):
        del run["motion"]
        run |= {key: [float(f"{x:.{digits - (k == 1)}g}") for x in np.ravel(value)] for key, value in start.items()}
    found = only(judged(tmp_path, runs))
    assert found.right and found.convergence.order == pytest.approx(1.0, abs=0.1)


def test_one_step_in_a_file_decides_nothing_of_a_right_engine(tmp_path):
    report = judged(tmp_path, [written(semi_implicit, 0.02)])
    assert report.verdict == "undecided" and "dt/4" in report.notes[-1]


@pytest.mark.long_after(1)
@pytest.mark.parametrize("change, words", [
    (lambda q, L: (np.roll(q, -1), L), "xyzw"), (lambda q, L: (q * np.array([1, -1, -1, -1]), L), "inverse"),
    (lambda q, L: (q, np.degrees(L)), "degrees"), (lambda q, L: (q, engines.matrix(q) @ L), "space axes for body"),
])  # fmt: skip
def test_mistakes_in_a_file_are_named(tmp_path, change, words):
    halved = [written(midpoint, h, change=change) for h in (0.04, 0.02, 0.01)]
    for runs in ([written(rk4, 0.02, change=change)], halved):
        (named,) = only(judged(tmp_path, runs)).mistakes
        assert words in named


@pytest.mark.long_after(1)
@pytest.mark.parametrize("change, words", [
    (lambda q, L: (np.roll(q, -1), L), "xyzw"), (lambda q, L: (q * np.array([1, -1, -1, -1]), L), "inverse"),
    (lambda q, L: (q, np.degrees(L)), "degrees"), (lambda q, L: (q, engines.matrix(q) @ L), "space axes for body"),
    (lambda q, L: (q, np.linalg.solve(TENSOR, L)), "ω given for L"),
])  # fmt: skip
def test_mistakes_that_the_start_has_too_are_named(tmp_path, change, words):
    """As of an engine that writes everything in one convention."""
    q, L = engines.unit(np.array([0.1, 0.7, -0.3, 0.5])), np.array([0.6, -0.9, 1.1])
    halved = []
    for dt in (0.04, 0.02, 0.01):
        step, rows, state = rk4(equations(TENSOR)), [], (q, L)
        for _ in range(round(6.0 / dt)):
            state = step(*state, dt)
            rows.append(change(*state))
        attitudes, momenta = zip(*rows, strict=True)
        start = dict(zip(("attitude", "momentum"), (x.tolist() for x in change(q, L)), strict=True))
        halved.append({"inertia": TENSOR.tolist(), **start, "dt": dt,
                       "times": [dt * (k + 1) for k in range(len(rows))],
                       "attitudes": np.array(attitudes).tolist(), "momenta": np.array(momenta).tolist()})  # fmt: skip
    for runs in (halved, halved[2:]):
        (named,) = only(judged(tmp_path, runs)).mistakes
        assert words in named and "in the start too" in named


def test_wrong_equations_in_a_file_are_named(tmp_path):
    (named,) = only(judged(tmp_path, [written(rk4, 0.02, gyroscopic=0.0)])).mistakes
    assert "gyroscopic term missing" in named
    assert judged(tmp_path, [written(rk4, 0.02, gyroscopic=0.7)]).verdict == "unexplained"


def test_a_refused_case_does_not_end_the_run(tmp_path):
    late = written(rk4, 0.02) | {"times": [1e3, 2e3]}
    far = {**written(rk4, 0.02), "attitudes": (5 * np.array(written(rk4, 0.02)["attitudes"])).tolist()}
    wrong = [{"motion": "none such"}, {"motion": "cusps of a toy top"}, late, far, 7, {"times": []}]
    report = judged(tmp_path, [*wrong, written(rk4, 0.02)])
    assert len(report.judgements) == 1 and len(report.refused) == len(wrong)
    assert all(reason.rstrip().endswith((".", "]")) for _, reason in report.refused)


@pytest.mark.long_cases("momenta-attitudes-nan-NaN")
@pytest.mark.parametrize("number, said", [(float("nan"), "NaN"), (None, "null"), (-float("inf"), "-Infinity"),
                                          (1e200, "1e+200")])  # fmt: skip
@pytest.mark.parametrize("key, other", [("attitudes", "momenta"), ("momenta", "attitudes")])
def test_a_run_with_a_number_that_is_none_is_refused(tmp_path, key, other, number, said):
    broken, whole = written(rk4, 0.02, until=2.0), written(rk4, 0.02, until=2.0)
    broken[key][3][1] = number
    report = judged(tmp_path, [whole, broken])
    (refused,) = report.refused
    assert only(report).right is None
    assert refused[0] == f"run 2 ({FLIPS})"
    for word in (f"`{key}`", said, "in state 4", f"at t = {broken['times'][3]:.6g} s"):
        assert word in refused[1]
    assert other not in refused[1] and "nan" not in report.summary
    assert report.summary.endswith("1 run was refused.")


def own_start():
    (motion,) = (m for m in reference_motions(kind="free body") if m.name == FLIPS)
    return {"inertia": list(motion.moments), "attitude": list(motion.attitude), "momentum": list(motion.momentum)}


def without_motion():
    return {key: value for key, value in written(rk4, 0.02, until=2.0).items() if key != "motion"}


@pytest.mark.parametrize("more, words", [
    ({"attitude_s": 1}, "unknown key 'attitude_s'; did you mean attitudes?"),
    ({"Times": [], "w": 1}, "unknown key 'Times'; did you mean times? unknown key 'w'; known there are motion, "),
    ({"engine": "mine"}, "unknown key 'engine'; it belongs beside `runs`."),
    ({"motion": FLIPS} | own_start(), f"not both; got '{FLIPS}' and inertia, attitude, momentum"),
    (own_start() | {"angular_velocity": [0.1, 0.2, 0.3]}, "`momentum` or `angular_velocity`, not both"),
    ({"attitude": [1, 0, 0, 0], "momentum": [1, 2, 3]}, "`inertia`; got attitude, momentum alone"),
    (own_start() | {"attitude": [float("nan"), 0, 0, 0]}, "`attitude` must have length 1"),
    (own_start() | {"momentum": [10**400, 0, 0]}, "`momentum` must be 3 numbers"),
    (own_start() | {"dt": True}, "`dt` must be"), (own_start() | {"dt": 10**400}, "`dt` must be"),
])  # fmt: skip
def test_keys_that_are_unknown_or_contradict_are_refused(tmp_path, more, words):
    report = judged(tmp_path, [without_motion() | more, written(rk4, 0.02, until=2.0)])
    ((_, reason),) = report.refused
    assert words in reason and len(report.judgements) == 1


def test_keys_that_are_null_are_as_if_not_there(tmp_path):
    empty = dict.fromkeys(("motion", "angular_velocity", "axes"))
    report = judged(tmp_path, [without_motion() | own_start() | empty], axes=None, engine=None)
    assert not report.refused and report.name == "states"


@pytest.mark.parametrize("head, words", [
    ({"axis": "space"}, "unknown key 'axis'; did you mean axes?"), ({"inertia": [1, 2, 3]}, "belongs in a run"),
])  # fmt: skip
def test_unknown_keys_at_the_top_end_all(tmp_path, head, words):
    with pytest.raises(FormatError, match=words.replace("?", r"\?")):
        judged(tmp_path, [written(rk4, 0.02, until=2.0)], **head)


@pytest.mark.long
def test_a_motion_of_which_a_run_is_refused_counts_once(tmp_path):
    runs = [written(midpoint, h, until=2.0) for h in (0.04, 0.02, 0.01)]
    runs[1]["attitudes"].pop()
    report = judged(tmp_path, runs)
    assert report.summary == "Of 2 runs of 1 motion: undecided in 2. 1 run was refused."
    assert [one.name for one in report.judgements] == [f"run {k} ({FLIPS})" for k in (1, 3)]
    other = written(midpoint, 0.02, name="flips, 1 deg to the first axis", until=2.0)
    assert judged(tmp_path, [*runs, other]).summary.startswith("Of 3 runs of 2 motions: ")
    assert judged(tmp_path, [runs[0], other]).summary == "Of 2 motions: undecided in 2."


def test_a_file_of_refused_runs_alone_ends_with_exit_code_2(tmp_path):
    runs = [written(midpoint, h, until=2.0) | {"times": [1, 2]} for h in (0.04, 0.02)]
    judged(tmp_path, runs)
    outcome = run_command(["judge", "states.json", "--figures", "pictures"], tmp_path)
    assert outcome.code == 2 and not outcome.raised and not outcome.left
    assert "Nothing was judged: 2 runs were refused." in outcome.out
    assert f"states.json: no run could be judged; run 1 ({FLIPS}): `times` must be four" in outcome.error
    assert "the others" in outcome.error and outcome.error.count("\n") == 1
    judged(tmp_path, [*runs, written(rk4, 0.02, until=2.0)])
    assert run_command(["judge", "states.json"], tmp_path).code == 0


def test_what_a_mistake_leaves_is_not_called_exact(tmp_path):
    def rolled(q, L):
        return np.roll(q, -1), L

    report = judged(tmp_path, [written(semi_implicit, h, until=2.0, change=rolled) for h in (0.02, 0.01, 0.005)])
    assert "its errors shrink with shorter steps as those of order 1.01 do." in report.summary
    single = judged(tmp_path, [written(semi_implicit, 0.01, until=2.0, change=rolled)])
    assert "xyzw for wxyz" in single.summary
    assert single.summary.endswith("With that, its states are off by 7.3e-05, and by 3.1 without.")
    assert "exact" not in report.summary + single.summary


def test_lengths_that_drift_in_a_file_are_told(tmp_path):
    def stretched(q, L):
        return 1.004 * q, L

    runs = [written(midpoint, h, until=2.0) for h in (0.04, 0.02)] + [written(midpoint, 0.01, until=2.0,
                                                                             change=stretched)]  # fmt: skip
    assert "length of its quaternion grows by 0.4 %" in judged(tmp_path, runs).summary
    assert any("grows by 0.4 %" in note for note in judged(tmp_path, runs[1:]).notes)


def test_files_that_are_none_are_refused(tmp_path):
    for head, words in (({"version": 2}, "version"), ({}, "runs"), ({"format": "x"}, "format")):
        with pytest.raises(FormatError, match=words):
            judged(tmp_path, [], **head)
    for text, words in (("{", "JSON"), ("[" + "1" * 5000 + "]", "a number of too many digits")):
        (tmp_path / "states.json").write_text(text)
        with pytest.raises(FormatError, match=words):
            judge_file(tmp_path / "states.json")
