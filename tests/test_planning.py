"""Plans: what is said beforehand is what moves the system, and what moved it is kept."""

from fractions import Fraction
from typing import Any

import diffrax
import jax.numpy as jnp
import numpy as np
import pytest

import polhode as ph
from polhode import fields, planning
from polhode.errors import InvalidInput, NotConverged
from polhode.formats.dataset_reading import make_plan
from polhode.integrators import LieMidpoint, MuntheKaas, Splitting, Taylor
from polhode.motion import MotionPlan, Stepping

TIMES = np.linspace(0.0, 1.0, 5)
TOP = ph.systems.HeavyTop((1.0, 1.2, 2.0), mgl=1.3, axis=(0.1, 0.0, 1.0))
START = np.array([0.3, 1.8, 1.5, 0.1, 0.2, 0.97])
FALL = ph.systems.LiePoisson(ph.algebra.Heisenberg(1), lambda m: 0.5 * m[1] ** 2 - 1.0 / m[0])
SORTED = ph.systems.LiePoisson(ph.algebra.SO3(), lambda L: jnp.sum(jnp.array([0.5, 0.3, 0.2]) * jnp.sort(L) ** 2))


class OwnField(ph.systems.FreeRigidBody):
    """A body that orbit methods do not move, as its field is its own."""

    def vector_field(self, t, state):
        return super().vector_field(t, state)


OWN: Any = OwnField
BODY = OWN((1.0, 2.0, 3.0))


@pytest.mark.parametrize(("system", "state", "options", "stepping", "method", "reason"), [
    (TOP, START, {}, Stepping.SERIES, "Taylor", "not Splitting, as no step was given"),
    (TOP, np.stack([START, 1.1 * START]), {}, Stepping.SERIES, "Taylor", "not Splitting, as no step was given"),
    (TOP, START, {"tolerance": 1e-9}, Stepping.SERIES, "Taylor", "not Splitting, as no step was given"),
    (TOP, START, {"method": Taylor(order=12)}, Stepping.SERIES, "Taylor", "as asked"),
    (TOP, START, {"step": 0.05}, Stepping.EQUAL_STEPS, "Splitting", "no Taylor series, as `step` was given"),
    (TOP, START, {"order": 4}, Stepping.EQUAL_STEPS, "Splitting", "no Taylor series, as `order` was given"),
    (TOP, START, {"resumable": True}, Stepping.EQUAL_STEPS, "Splitting",
     "no Taylor series, as only equal steps are resumed to the same bits"),
    (TOP, START, {"method": LieMidpoint, "step": 0.05}, Stepping.EQUAL_STEPS, "LieMidpoint", "as asked"),
    (TOP, START, {"method": diffrax.Dopri5()}, Stepping.ADAPTIVE_STEPS, "Dopri5", "as asked"),
    (SORTED, START[:3], {}, Stepping.EQUAL_STEPS, "LieMidpoint", "no Taylor series, as its rates contain `sort` of"),
    (BODY, START[:3], {}, Stepping.SERIES, "Taylor", "not Dopri8, as no step was given"),
    (BODY, START[:3], {"step": 0.1}, Stepping.ADAPTIVE_STEPS, "Dopri8",
     "no Taylor series, as `step` was given"),
    (TOP, 1e-170 * START, {}, Stepping.EQUAL_STEPS, "Splitting",
     "no Taylor series, as its state is so large or small that products of its numbers overflow or vanish"),
])  # fmt: skip
@pytest.mark.filterwarnings("ignore:.*beyond double precision")
def test_the_plan_is_what_moves_the_system(system, state, options, stepping, method, reason):
    before = ph.plan(system, state, TIMES, **options)
    assert (before.stepping, before.method) == (stepping, method)
    assert before.reason.startswith(reason)
    assert ph.simulate(system, state, TIMES, **options).plan == before


def test_a_plan_moves_nothing(monkeypatch):
    def refuse(*arguments):
        raise AssertionError("a plan does not run")

    monkeypatch.setattr("polhode.taylor.runs._advance_through", refuse)
    assert ph.plan(TOP, START, TIMES).method == "Taylor"
    with pytest.raises(AssertionError, match="does not run"):
        ph.simulate(TOP, START, TIMES)


def test_steps_that_were_shortened_are_those_of_the_plan():
    coarse: Any
    fine: Any
    coarse, fine = (ph.simulate(TOP, START, TIMES, MuntheKaas, tolerance=each).plan for each in (1e-2, 1e-9))
    assert fine.step < 0.6 * coarse.step and coarse.tolerance == 1e-2
    loose: Any
    tight: Any
    loose, tight = (ph.simulate(TOP, START, TIMES, tolerance=each).plan for each in (1e-4, 1e-12))
    assert loose.order < tight.order


def test_copies_that_go_another_way_have_their_own_plan():
    times = np.linspace(0.0, 5.0, 6)
    mixed: Any = ph.simulate(FALL, np.array([[1.0, 0.0, 1.0], [1.0, -9.0, 1.0]]), times, throw=False).plan
    assert (mixed.method, mixed.copies) == ("Taylor", 1)
    assert (mixed.otherwise.method, mixed.otherwise.copies) == ("LieMidpoint", 1)
    assert "it comes to a singularity between 1 and 2 s" in mixed.otherwise.reason  # at π/√8 = 1.11
    assert "; where these end, LieMidpoint" in str(mixed)


def test_series_of_whole_arrays_are_named():
    fluid = fields.SphereFluid(24)  # whose rates are some 60,000 operations
    state = fluid.random([0.0, 1.0, 2.0], seed=7)
    assert ph.plan(fluid, state, TIMES).engine == planning.ARRAYS


@pytest.mark.parametrize(("options", "message"), [
    ({"step": -1.0}, "`step` must be a positive finite"), ({"step": 0.1, "tolerance": 1e-9}, "not both"),
    ({"method": Taylor(order=8), "order": 9}, "Give `order` only with the class"),
    ({"method": diffrax.Euler()}, "must estimate the error of its steps"), ({"method": "rk4"}, "must be a class of"),
])  # fmt: skip
def test_a_plan_is_refused_as_the_run_would_be(options, message, any_type):
    for call in (ph.plan, ph.simulate):
        with pytest.raises(InvalidInput, match=message):
            call(TOP, START, TIMES, **options)


def test_closed_forms_have_a_plan():
    motion = ph.FreeMotion((1.0, 2.0, 3.0), momentum=np.ones((4, 1, 3)))
    plan: Any = motion.sample(TIMES).plan
    assert (plan.stepping, plan.copies, str(plan)) == (Stepping.CLOSED_FORM, 4, "closed form, FreeMotion, 4 copies")


def test_json_of_a_plan_is_read_back():
    rest = MotionPlan(Stepping.ADAPTIVE_STEPS, "Dopri8", 8, None, 1e-12, 2, planning.XLA, "no Taylor series")
    plan = MotionPlan(Stepping.SERIES, "Taylor", 24, 0.5, None, 3, planning.NUMBERS, "as asked", rest)
    assert make_plan(plan.as_json_dict()) == plan
    assert plan.as_json_dict()["otherwise"]["tolerance"] == 1e-12


def test_a_trajectory_and_its_parts_say_their_plan():
    moved = ph.simulate(TOP, START, TIMES, Splitting, step=0.05)
    assert str(moved.plan) == (
        "Splitting of order 8, equal steps of at most 0.05 s, one copy, compiled by XLA; as asked"
    )
    assert repr(moved).splitlines()[-2].split(maxsplit=1) == ["plan", str(moved.plan)]
    assert moved.between(0.2, 0.8).plan == moved.plan


SLIDING = ph.systems.LiePoisson(ph.algebra.SO3(), lambda L: jnp.sum(L % 0.7))


class Braked(ph.systems.AbstractSystem):
    """v̇ = −sign v, which comes to rest, along which no series goes."""

    def vector_field(self, t, state):
        return -jnp.sign(state)

    def invariants(self, states):
        return {}


class Falling(Braked):
    """Falls from a height at unit speed, down to the ground."""

    events = property(lambda self: {"ground": lambda t, state: state[0]})

    def vector_field(self, t, state):
        return -jnp.ones(1)


def raised(call, *arguments, **options):
    with pytest.raises(InvalidInput) as error:
        call(*arguments, **options)
    return str(error.value)


@pytest.mark.parametrize(("system", "state", "options", "words"), [
    (SLIDING, START[:3], {"method": Taylor()}, "cannot be moved by Taylor series: its rates of change contain"),
    (SLIDING, START[:3], {"method": Taylor(precision="extended")}, 'Give `precision` "double"'),
    (Falling(), [-1.0], {}, "at or past the event that ends the motion: ground"),
    (TOP, START, {"method": LieMidpoint(TOP, jnp.asarray(0.0))}, "the step of `method` must be a positive finite"),
    (TOP, START, {"method": LieMidpoint(TOP, jnp.asarray(-0.01))}, "whichever way the times go; got -0.01"),
    (TOP, START, {"method": LieMidpoint(TOP, jnp.asarray(jnp.nan))}, "the step of `method` must be a positive"),
    (TOP, START, {"order": 4.0}, "`order` must be a whole number; got 4.0"),
    (TOP, START + 0j, {}, "`state` must be real; got complex numbers"),
])  # fmt: skip
def test_what_the_start_shows_is_refused_by_both(system, state, options, words, any_type):
    messages = {raised(call, system, state, TIMES, **options) for call in (ph.plan, ph.simulate)}
    assert len(messages) == 1 and words in messages.pop()


def test_complex_times_are_refused(any_type):
    for call in (ph.plan, ph.simulate, ph.solve):
        assert "`times` must be real; got complex numbers" in raised(call, TOP, START, TIMES + 0j)


def test_numbers_of_any_kind_are_kept_as_plain_ones(tmp_path, any_type):
    options = {"order": np.arange(2, 9, 2)[1], "step": np.array(0.25)}
    moved = ph.simulate(TOP, START, TIMES, **options)
    read = ph.formats.read_dataset(moved.save(tmp_path / "motion.nc"))
    assert read.plan == moved.plan and read.plan.order == 4 and read.plan.step == 0.25
    for tolerance in (np.float32(1e-6), jnp.asarray(1e-6), Fraction(1, 10**6)):
        assert "of order 8, steps to 1e-06" in str(ph.plan(TOP, START, TIMES, tolerance=tolerance))
    assert ph.plan(TOP, START, TIMES, Taylor(order=np.int64(12))).as_json_dict()["order"] == 12


def test_copies_are_named_by_their_place_in_the_whole_batch():
    with pytest.raises(NotConverged, match="in 1 of 3 copies, first 2"):
        ph.simulate(Braked(), np.array([[30.0], [40.0], [0.3]]), TIMES)


def test_a_state_beyond_series_leaves_the_others_theirs():
    both: Any = ph.simulate(TOP, np.stack([START, 1e-170 * START]), TIMES, estimate_error=False, throw=False)
    alone: Any = ph.simulate(TOP, START, TIMES, estimate_error=False)
    assert (both.states[0] == alone.states).all()
    assert both.plan.method == "Taylor" and "overflow or vanish" in both.plan.otherwise.reason
    assert ph.plan(TOP, np.stack([START, 1e-170 * START]), TIMES) == both.plan


def test_solve_refuses_memory_that_is_none(any_type):
    assert "`memory` goes with" in raised(ph.solve, TOP, START, TIMES, Taylor(), memory=(1.0,))
    for call in (ph.solve, ph.simulate):
        assert "`memory` must be that of an earlier run" in raised(
            call, TOP, START, TIMES, LieMidpoint, 0.1, memory=("junk",))  # fmt: skip
