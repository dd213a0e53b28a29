"""The judge: right engines are called right, with their order; wrong ones never, and planted mistakes are named."""

import json

import numpy as np
import pytest

from judging import simulated_engines as engines
from judging.simulated_engines import equations, explicit_euler, midpoint, product, rk4, semi_implicit, unit
from polhode.errors import InvalidInput
from polhode.judging import judge
from polhode.judging._run import LIMITS, EngineRun, find_spin_end, measure_drift
from polhode.judging._stepping import StateConvention, SteppedEngine

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


@pytest.mark.sweep
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


@pytest.mark.sweep
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


@pytest.mark.long
@pytest.mark.parametrize("gyroscopic", [0.0, 1.0])
@pytest.mark.parametrize("variable", ["momentum", "angular velocity"])
def test_an_inertia_along_space_axes_is_named_whatever_the_start(variable, gyroscopic):
    """Of a step that keeps nothing between calls, and so does not know the attitude of the start."""
    inverse = np.linalg.inv(MOMENTS)

    def slopes(q, L):
        w = inverse @ L
        return engines.product(np.array([0.0, *w]) / 2.0, q), gyroscopic * engines.cross(L, w)

    def step(q, rate, h):
        L = rate if variable == "momentum" else MOMENTS @ rate
        q, L = rk4(slopes)(q, L, h)
        return q, L if variable == "momentum" else inverse @ L

    (named,) = only(judge(step, 0.05, MOMENTS, axes="space", variable=variable, steps=FEW)).mistakes
    # ω that stays in space stays in the body, too
    words = "not turned" if gyroscopic or variable == "momentum" else "gyroscopic term missing"
    assert words in named and ("Euler's equations" in named) == bool(gyroscopic)


def test_engines_may_keep_rates_along_space_axes():
    found = only(judge(engines.in_space_axes(MOMENTS), 0.02, axes="space", steps=3000))
    assert found.right and not found.momentum.is_seen
    assert found.energy.is_seen


def test_single_precision_is_not_called_a_mistake():
    found = only(judge(engines.in_single_precision(MOMENTS), 0.05, steps=FEW))
    assert found.right and found.run.eps == np.finfo(np.float32).eps
    assert found.convergence.order == pytest.approx(1.0, abs=0.1)


@pytest.mark.sweep
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


@pytest.mark.sweep
@pytest.mark.parametrize("sign, goal", [(1.0, "largest"), (-1.0, "least")])
def test_energy_that_is_lost_or_gained_with_l_kept_ends_at_an_outer_axis(sign, goal):
    report = judge(dissipating(sign), 0.05, steps=4000)
    found = only(report)
    assert report.verdict == "unexplained"
    other = {"largest": "least", "least": "largest"}[goal]
    assert {found.ends[f"near the axis of {name} moment"].toward for name in (goal, other)} == {goal}
    assert found.ends["the given start"].toward == goal
    assert (found.energy.per_radian < 0.0) == (goal == "largest")


@pytest.mark.sweep
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
    # Euler's energy grows without bound, and the last of these steps have no numbers
    assert values["verdict"].startswith("right, but the square of its rate leaves double precision")
    assert values["motions"][0]["energy_per_radian"] == pytest.approx(0.0034, rel=0.1)
    (picture,) = report.draw(tmp_path)
    assert picture.stat().st_size > 5000


RIGHT = rk4(equations(MOMENTS))


def failing(change, since=0):
    """RK4 whose states are changed from one of its calls on, and how often it was called."""
    calls = [0]

    def step(q, L, h):
        calls[0] += 1
        q, L = RIGHT(q, L, h)
        return change(q, L) if calls[0] > since else (q, L)

    return step, calls


def without_rate(q, L):
    return q, L * np.nan


FAULTS = {
    "its rate is no longer finite": without_rate,
    "its quaternion is no longer finite": lambda q, L: (q * np.inf, L),
    "its quaternion and rate are no longer finite": lambda q, L: (q * np.nan, L * np.inf),
    "the square of its rate leaves double precision": lambda q, L: (q, L * 1e200),
    "its quaternion has length 0": lambda q, L: (q * 0.0, L),
}


@pytest.mark.parametrize("words", FAULTS)
def test_states_that_are_not_finite_are_called_so(tmp_path, words):
    report = judge(failing(FAULTS[words])[0], 0.05, steps=FEW)
    assert report.verdict == f"wrong: {words} from t = 0.05 s on"
    assert "(step 1)" in report.summary
    for claim in ("nan", "energy", "polhode"):
        assert claim not in report.summary
    (row,) = json.loads(report.json())["motions"]
    assert row["finite_until"] == 0.05 and row["energy_per_radian"] is None
    assert report.draw(tmp_path) == []


@pytest.mark.long
def test_an_engine_that_breaks_down_late_is_not_simply_right():
    _, calls = once = failing(without_rate, since=10**9)
    judge(once[0], 0.05, steps=FEW)
    short = calls[0] - 3 * FEW
    for since, words in ((40, "from t = 2.05 s on (step 41)"),
                         (FEW + 9, "from t = 0.5 s on (step 10), started near the axis of least moment")):  # fmt: skip
        report = judge(failing(without_rate, since=short + since)[0], 0.05, steps=FEW)
        assert report.verdict.startswith("right, but its rate is no longer finite from t = ")
        assert words in report.summary and "nan" not in report.summary
        assert report.summary.startswith("Right with short steps, but at dt = 0.05 s its rate")
    (picture,) = report.figures().values()
    assert picture() is not None


def test_an_engine_that_raises_late_is_told_its_own_words():
    def refuse(q, L):
        raise OverflowError("the state left its range")

    run = SteppedEngine(failing(refuse, since=36)[0], MOMENTS, StateConvention()).run(START, np.ones(3), 0.05, 60)
    assert run.stop.step == 37 and run.stop.words.startswith("it raises OverflowError (the state left its range) from")


def test_the_first_step_without_a_state_is_found_between_samples():
    run = SteppedEngine(failing(without_rate, since=36)[0], MOMENTS, StateConvention()).run(
        START, np.ones(3), 0.05, 60, every=10)  # fmt: skip
    part = run.finite_part()
    assert (run.stop.step, len(run.times), len(part.times), part.steps) == (37, 7, 4, 30)
    assert run.stop.time == pytest.approx(37 * 0.05)
    assert np.isfinite(part.momentum).all() and np.isfinite(part.attitude).all()


def test_energy_that_runs_away_does_not_swing():
    report = judge(explicit_euler(equations(MOMENTS)), 0.4, steps=400)
    assert report.verdict.startswith("right, but the square of its rate leaves double precision from t = ")
    assert "swings" not in report.summary and "energy grows to" in report.summary


def unnormalized(q, L, h):
    a, b = equations(MOMENTS)(q, L)
    return q + h * a, L + h * b


def test_a_quaternion_that_is_never_normalized_is_told_so():
    report = judge(unnormalized, 0.02, steps=1500)
    q, L = only(report).run.attitude[0], only(report).run.momentum[0]
    for _ in range(1500):
        q, L = unnormalized(q, L, 0.02)
    grown = np.sqrt(q @ q) - 1.0
    assert report.verdict == "right" and grown > 0.05
    assert f"The length of its quaternion grows by {100 * grown:.2g} % within 30" in report.summary
    assert "normalize it after each step" in report.summary
    (row,) = json.loads(report.json())["motions"]
    assert row["quaternion_length_change"] == pytest.approx(grown, rel=1e-9)


def test_nothing_is_said_of_lengths_that_stay():
    for step in (RIGHT, engines.in_single_precision(MOMENTS)):
        report = judge(step, 0.05, steps=FEW)
        assert "length" not in report.summary and only(report).length_change == 0.0


@pytest.mark.long
def test_a_first_order_engine_in_other_words_is_not_called_exact():
    rough = semi_implicit(equations(MOMENTS))
    report = judge(lambda q, L, h: last(*rough(*last(q, L, -1), h), 1), 0.05, steps=FEW)
    assert "xyzw" in report.summary and "exact" not in report.summary
    assert "its errors shrink with shorter steps as those of order 1.0" in report.summary


@pytest.mark.parametrize("wrong, words", [
    ({"step": 3}, "`step`"), ({"dt": 0.0}, "`dt`"), ({"dt": 2.0}, "0.5 rad"), ({"inertia": (1, 2, 4)}, "I1 + I2"),
    ({"inertia": (1, 2)}, "`inertia`"), ({"axes": "world"}, "`axes`"), ({"variable": "spin"}, "`variable`"),
    ({"attitude": (1, 1, 0, 0)}, "length 1"), ({"momentum": (0, 0, 0)}, "`momentum`"), ({"steps": 3}, "`steps`"),
    ({"step": lambda q, L, h: q}, "`step` must return"), ({"step": lambda q, L, h: (L, q)}, "shapes"),
])  # fmt: skip
def test_bad_input_is_refused_in_one_sentence(wrong, words, any_type):
    with pytest.raises(InvalidInput, match=words.replace("+", r"\+")):
        judge(**{"step": rk4(equations(MOMENTS)), "dt": 0.05, **wrong})


def states_of(step, momentum, h, span):
    q, L = np.array([1.0, 0.0, 0.0, 0.0]), np.array(momentum)
    states = [(q, L)]
    for _ in range(round(span / h)):
        q, L = step(q, L, h)
        states.append((q, L))
    attitude, momenta = (np.array(part) for part in zip(*states, strict=True))
    times = h * np.arange(len(states))
    return EngineRun(np.diag([1.0, 2.0, 3.0]), times, attitude, momenta, 2.2e-16, len(states) - 1)


@pytest.mark.long
def test_where_a_spin_goes_is_not_said_of_a_part_of_a_swing():
    """From 4 s, a quarter of a period, it was said to drift towards larger moments; within 160 s it goes to smaller."""
    run = states_of(rk4(equations(np.diag([1.0, 2.0, 3.0]))), (-0.895, 0.304, 1.256), 0.2, 160.0)
    n = 21
    short = EngineRun(run.inertia, run.times[:n], run.attitude[:n], run.momentum[:n], run.eps, n - 1)
    assert find_spin_end(run).toward == "smaller moments"
    assert find_spin_end(short).toward == "undecided" and short.periods < LIMITS.min_periods < run.periods
    drifts = [measure_drift(each.energy, each.turned, 1e-14, each.periods) for each in (short, run)]
    assert not drifts[0].is_seen and np.isnan(drifts[0].error)
    assert drifts[1].is_seen and drifts[1].per_radian < -30 * drifts[1].error


def test_a_large_swing_is_no_growth():
    """Its first rise to a tenth was taken for a growth by .098 of itself a radian and more."""
    turned = np.linspace(0.0, 200.0, 20001)
    found = measure_drift(1.0 + 0.3 * np.sin(turned) - 4e-4 * turned, turned, 1e-12, 40.0)
    assert not found.is_seen and np.isclose(found.swing, 0.3, rtol=0.05)
    assert abs(found.per_radian + 4e-4) < 3 * found.error < 1e-3
    gone = measure_drift(np.exp(-0.05 * turned), turned, 1e-12, 40.0)  # what does not come back falls
    assert gone.is_seen and np.isclose(gone.per_radian, -0.05, rtol=0.1)


def test_one_moment_for_all_axes_is_named_beside_the_missing_term():
    """An engine that writes ω does the same with both mistakes: it keeps ω."""

    def step(q, w, h):
        return unit(product(q, np.array([1.0, *(0.5 * h * w)]))), w

    report = judge(step, 0.02, (1.0, 2.0, 3.0), variable="angular velocity", steps=200)
    assert "gyroscopic term missing, or one moment for all axes" in report.verdict
