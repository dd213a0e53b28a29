"""The judge: right engines are called right, with their order; wrong ones never, and planted mistakes are named."""

import json
from pathlib import Path

import numpy as np
import pytest

from polhode.errors import FormatError, InvalidInput
from polhode.testing import judge, judge_file, reference_motions
from testing import engines
from testing.engines import equations, explicit_euler, midpoint, rk4, semi_implicit

MOMENTS = np.diag([1.0, 2.0, 3.0])
START = np.array([0.1, -0.7, 0.5, 0.5])
FEW = 64
RUNGE_KUTTA = (rk4, engines.rk4_by_mean_rate)
BODIES = 50
"""Over which no right engine is accused."""


def only(report):
    (judgement,) = report.judgements
    return judgement


@pytest.mark.parametrize("method", engines.ORDERS, ids=lambda method: method.__name__)
def test_orders_are_those_that_the_methods_have(method):
    found = only(judge(method(equations(MOMENTS)), 0.05, steps=FEW))
    assert found.right
    assert found.convergence.order == pytest.approx(engines.ORDERS[method], abs=0.06)
    of_momentum = 4 if method in RUNGE_KUTTA else engines.ORDERS[method]
    assert found.convergence.momentum_order == pytest.approx(of_momentum, abs=0.1)


@pytest.mark.long
@pytest.mark.parametrize("method", [semi_implicit, midpoint], ids=lambda method: method.__name__)
def test_no_right_engine_is_accused(method):
    rng = np.random.default_rng(32)
    for _ in range(BODIES // 2):
        inertia = engines.random_inertia(rng)
        L = rng.normal(size=3)
        rate = float(np.linalg.norm(np.linalg.solve(inertia, L)))
        report = judge(method(equations(inertia)), 0.05 / rate, inertia, momentum=L, steps=FEW,
                       attitude=engines.unit(rng.normal(size=4)))  # fmt: skip
        assert report.verdict == "right", (inertia, L, report.summary)


@pytest.mark.long
@pytest.mark.parametrize("size", [0.01, 0.1], ids=lambda size: f"{size:g}")
@pytest.mark.parametrize("method", [explicit_euler, rk4], ids=lambda method: method.__name__)
def test_no_wrong_engine_is_called_right(method, size):
    """An inertia that is off has no name among the mistakes, and must be called unexplained."""
    rng = np.random.default_rng(7)
    for _ in range(2):
        inertia = engines.random_inertia(rng)
        off = rng.normal(size=(3, 3))
        wrong = inertia + size * np.trace(inertia) * (off + off.T) / np.linalg.norm(off + off.T)
        found = judge(method(equations(wrong)), 0.05, inertia, steps=FEW)
        assert found.verdict == "unexplained", found.summary


@pytest.mark.long
@pytest.mark.parametrize("method", [semi_implicit, rk4], ids=lambda method: method.__name__)
@pytest.mark.parametrize("mistake, words", [
    ({"gyroscopic": 0.0}, "gyroscopic term missing"), ({"gyroscopic": -1.0}, "wrong sign"),
    ({"factor": 2.0}, "factor ½ missing"), ({"factor": 0.5}, "factor ½ twice"),
    ({"in_space": True}, "as if along space"), ({"damping": 0.05}, "L decays by 0.05 "),
], ids=lambda value: value if isinstance(value, str) else "")  # fmt: skip
def test_wrong_equations_are_named(method, mistake, words):
    (named,) = only(judge(method(equations(MOMENTS, **mistake)), 0.05, steps=FEW)).mistakes
    assert words in named


def in_other_words(change):
    """The engine of order 2 behind another convention: ``change`` turns quaternion and L to the right ones and back."""
    right = midpoint(equations(MOMENTS))

    def step(q, rate, h):
        return change(*right(*change(q, rate, -1), h), 1)

    return step


def last(q, L, way):
    return np.roll(q, -way), L


def inverted(q, L, way):
    return q * np.array([1.0, -1.0, -1.0, -1.0]), L


def in_degrees(q, L, way):
    return q, L * (180.0 / np.pi) ** way


def velocity(q, L, way):
    return q, np.linalg.matrix_power(np.linalg.inv(MOMENTS), way) @ L


def in_space(q, L, way):
    return q, engines.matrix(q) @ L if way == 1 else engines.matrix(q).T @ L


CONVENTIONS = {"xyzw": [last], "inverse": [inverted], "degrees": [in_degrees], "ω given for L": [velocity],
               "space axes for body": [in_space]}  # fmt: skip


@pytest.mark.long
@pytest.mark.parametrize("words", CONVENTIONS)
def test_wrong_conventions_are_named(words):
    (change,) = CONVENTIONS[words]
    (named,) = only(judge(in_other_words(change), 0.05, steps=FEW)).mistakes
    assert words in named


@pytest.mark.long
def test_two_mistakes_at_once_are_named():
    def both(q, L, way):
        return in_degrees(*last(q, L, way), way)

    (named,) = only(judge(in_other_words(both), 0.05, steps=FEW)).mistakes
    assert "xyzw" in named and "degrees" in named


@pytest.mark.long
def test_an_inertia_that_is_not_turned_is_named():
    step = engines.not_turned(MOMENTS, START)
    (named,) = only(judge(step, 0.05, axes="space", attitude=START, steps=FEW)).mistakes
    assert "not turned" in named


def test_engines_may_keep_rates_along_space_axes():
    found = only(judge(engines.in_space_axes(MOMENTS), 0.02, axes="space", steps=3000))
    assert found.right and not found.momentum.is_seen
    assert found.energy.is_seen


def test_single_precision_is_not_called_a_mistake():
    found = only(judge(engines.in_single_precision(MOMENTS), 0.05, steps=FEW))
    assert found.right and found.run.eps == np.finfo(np.float32).eps
    assert found.convergence.order == pytest.approx(1.0, abs=0.1)


@pytest.mark.long
def test_a_restored_length_pulls_all_spins_to_the_middle_axis():
    found = only(judge(engines.restoring(explicit_euler(equations(MOMENTS))), 0.05, steps=40_000))
    assert {end.toward for end in found.ends.values()} == {"middle"}
    assert all(end.end == pytest.approx(0.5, abs=0.01) for end in found.ends.values())
    assert not found.momentum.is_seen and found.energy.is_seen


def dissipating(sign):
    """RK4 of L̇ = L × ω + ε L × (L × ω), which keeps |L|; energy changes by −ε |L × ω|²."""
    right = equations(MOMENTS)

    def slopes(q, L):
        a, b = right(q, L)
        return a, b + sign * 0.1 * engines.cross(L, b)

    return rk4(slopes)


@pytest.mark.long
@pytest.mark.parametrize("sign, goal", [(1.0, "largest"), (-1.0, "least")])
def test_energy_that_is_lost_or_gained_with_l_kept_ends_at_an_outer_axis(sign, goal):
    report = judge(dissipating(sign), 0.05, steps=4000)
    found = only(report)
    assert report.verdict == "unexplained"
    other = {"largest": "least", "least": "largest"}[goal]
    assert {found.ends[f"near the axis of {name} moment"].toward for name in (goal, other)} == {goal}
    assert found.ends["the given start"].toward == goal
    assert (found.energy.per_radian < 0.0) == (goal == "largest")


@pytest.mark.long
def test_growth_of_errors():
    """Euler's energy drifts, so that its frequency does; an attitude that turns too fast is off in proportion."""
    assert only(judge(semi_implicit(equations(MOMENTS)), 0.01, steps=10_000)).growth.word == "quadratic"
    assert only(judge(rk4(equations(MOMENTS, factor=1.001)), 0.05, steps=2000)).growth.word == "linear"


def test_what_a_motion_cannot_show_is_said():
    ball = np.eye(3) * 2.0
    report = judge(rk4(equations(ball, gyroscopic=0.0)), 0.05, ball, steps=FEW)
    assert report.verdict == "right"
    assert any("gyroscopic" in note for note in report.notes)


@pytest.mark.long
def test_the_report_says_numbers_and_draws(tmp_path):
    report = judge(semi_implicit(equations(MOMENTS)), 0.05, steps=8000, name="mine")
    assert "order 1.0" in report.summary and "middle moment" in report.summary
    values = json.loads(report.json())
    assert values["verdict"] == "right" and values["motions"][0]["energy_per_radian"] == pytest.approx(0.0034, rel=0.1)
    (picture,) = report.draw(tmp_path)
    assert picture.stat().st_size > 5000


@pytest.mark.parametrize("wrong, words", [
    ({"step": 3}, "`step`"), ({"dt": 0.0}, "`dt`"), ({"dt": 2.0}, "0.5 rad"), ({"inertia": (1, 2, 4)}, "I1 + I2"),
    ({"inertia": (1, 2)}, "`inertia`"), ({"axes": "world"}, "`axes`"), ({"variable": "spin"}, "`variable`"),
    ({"attitude": (1, 1, 0, 0)}, "length 1"), ({"momentum": (0, 0, 0)}, "`momentum`"), ({"steps": 3}, "`steps`"),
    ({"step": lambda q, L, h: q}, "`step` must return"), ({"step": lambda q, L, h: (L, q)}, "shapes"),
])  # fmt: skip
def test_bad_input_is_refused_in_one_sentence(wrong, words, any_type):
    with pytest.raises(InvalidInput, match=words.replace("+", r"\+")):
        judge(**{"step": rk4(equations(MOMENTS)), "dt": 0.05, **wrong})


# ---------------------------------------------------------------- states in a file

FLIPS = "flips, 10 deg to the first axis"


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


def test_files_that_are_none_are_refused(tmp_path):
    for head, words in (({"version": 2}, "version"), ({}, "runs"), ({"format": "x"}, "format")):
        with pytest.raises(FormatError, match=words):
            judged(tmp_path, [], **head)
    (tmp_path / "states.json").write_text("{")
    with pytest.raises(FormatError, match="JSON"):
        judge_file(tmp_path / "states.json")
