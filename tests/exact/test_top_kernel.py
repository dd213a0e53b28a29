"""The tops' kernels, by Python and as Numba compiles them: what they take, and answers of arrays. tests/twins has their
errors."""

from collections import Counter
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest

import polhode as ph
from oracle.numpy_alone import compiled_alone, numpy_alone
from polhode.errors import InvalidInput
from polhode.exact import _kernel_loops as kernel_loops
from polhode.exact._closed_form import ClosedForm
from polhode.exact.lagrange_top import _kernel_integrals as kernel_integrals
from polhode.exact.lagrange_top import _kernel_setup as kernel_setup
from polhode.exact.lagrange_top._evaluation import FORM
from polhode.exact.lagrange_top._formulas import COLUMNS
from starts import lagrange_motion
from twins.families_of_tops import draw_tops
from twins.motions import PROMISE, by_oracle, drawn, errors
from twins.motions_implementations import columns, motion_of

PER_FAMILY_OF_MANY = 20
AGREEMENT = 8e-15
"""Between two evaluations that both are within ``PROMISE`` of the truth, on the scale of the largest |L|."""
WHOLLY = ("generic", "wide_ratio", "cusp", "fast_loop", "spherical_pendulum", "planar_pendulum", "through_top",
          "through_bottom", "huge_spin")  # fmt: skip
"""Families that the kernel takes whole; in others some tops are left to NumPy, and in these all:"""
LEFT = ("steady", "sleeping", "hanging", "separatrix", "weightless_special")


STARTS = [((0.0, 0.0, 2.5), 1.0), ((0.3, -0.5, 1.5), 0.4), ((2.0, 1.0, 0.0), 1.0), ((0.2, 0.1, 0.4), 1.0),
          ((0.0, 0.0, 5.0), 0.0), ((0.0, 0.0, 0.0), 2.0)]  # fmt: skip


@pytest.mark.long
@pytest.mark.parametrize(("momentum", "lean"), STARTS)
def test_long_runs_go_through_it_and_agree(momentum, lean, monkeypatch):
    """By threads, in blocks that are not full, with the epoch's rest, for times of any shape, on either side of mgl."""
    monkeypatch.setattr(kernel_loops, "WORTH", 1000)
    times = np.linspace(-50.0, 1e3, 10_001)[:-1].reshape(2, -1)
    attitude = (np.cos(lean / 2), np.sin(lean / 2), 0.0, 0.0)

    def tops():
        return [
            ph.LagrangeMotion((1.0, 1.0, 0.5), mgl=mgl, momentum=momentum, attitude=attitude, epoch=0.1)
            for mgl in (1.0, -1.0)
        ]

    calls = []
    monkeypatch.setattr(ClosedForm, "_of_one", lambda *x, run=ClosedForm._of_one: calls.append(1) or run(*x))
    monkeypatch.setattr(FORM, "_ready", {"states_of_one"})  # alone, as the set-up is compiled for half a minute
    found = [top.state(times) for top in tops()]
    numpy_alone(monkeypatch)
    assert len(calls) == 2 and found[0][0].shape == (2, 5000, 4)
    for top, states in zip(tops(), found, strict=True):
        assert max(np.abs(a - b).max() for a, b in zip(states, top.state(times), strict=True)) < 6e-15


def batch(cases):
    """Return moments, mgl, momentum, attitude and times of the cases as arrays."""
    return tuple(np.array([case[k] for case in cases]) for k in range(1, 6))


@pytest.fixture
def left(monkeypatch):
    """What the set-up's kernel left to NumPy, of each call; batches of any size go to it."""
    calls, run = [], ClosedForm._set_up_many

    def observed(self, flat, columns, left):
        run(self, flat, columns, left)
        calls.append(left.copy())

    compiled_alone(monkeypatch)
    monkeypatch.setattr(ClosedForm, "_set_up_many", observed)
    return calls




@pytest.mark.long
def test_which_tops_it_takes(left):
    """Of all families at once; those that it leaves to NumPy stand among them."""
    cases, taken = draw_tops(PER_FAMILY_OF_MANY, 8), Counter()
    *top, _ = batch(cases)
    assert lagrange_motion(*top)._columns.shape[1] == len(cases)
    for case, is_left in zip(cases, left[0], strict=True):
        taken[case.family] += int(not is_left)
    assert len(left) == 1
    assert all(taken[name] == PER_FAMILY_OF_MANY for name in WHOLLY) and all(taken[name] == 0 for name in LEFT)
    assert taken["near_separatrix"] > 0


@pytest.mark.long
def test_what_rounding_leaves_of_the_separatrix_is_summed_exactly(left):
    """Double-double alone is wrong by 1e7 eps here: c, F and D vanish together, and how long tops linger tells them."""
    motions = drawn("top", 60, 1, ("rounded_separatrix",))
    tops = columns(motions)
    times = tops.pop("time")
    motion = motion_of(**tops)
    assert motion._columns.shape[1] == len(motions)
    states = np.concatenate(motion.state(times), axis=-1)
    swing = np.sqrt(motion.mgl / motion.moments[:, 0])
    assert not left[0].any() and np.median(motion.nutation_period * swing) > 30.0
    assert errors(states, by_oracle(motions)).worst.max() <= PROMISE


@pytest.mark.long
def test_columns_and_numbers_agree_with_numpy_in_every_family(left, monkeypatch):
    """The form, the regime and the numbers of each top are the same, rates and states to rounding."""
    *top, times = batch(draw_tops(PER_FAMILY_OF_MANY, 9))
    motion = lagrange_motion(*top)
    found, columns = motion.state(times), motion._columns
    numpy_alone(monkeypatch)
    alone = lagrange_motion(*top)
    wanted = alone.state(times)
    size = np.maximum(np.abs(wanted[1]).max(axis=1), np.abs(top[2]).max(axis=1)) + 1e-300
    assert 0 < left[0].sum() < len(times) and len(left) == 1
    assert np.abs(found[0] - wanted[0]).max() < AGREEMENT
    assert (np.abs(found[1] - wanted[1]).max(axis=1) < 4.0 * AGREEMENT * size).all()
    assert (columns[0] == alone._columns[0])[~left[0]].mean() > 0.99  # equal parameters may fall on either side
    for first in (1, 4):
        rate, other = (np.add.reduce(parts[first : first + 2]) for parts in (columns, alone._columns))
        assert (np.abs(rate - other) <= 1e-15 * np.abs(other)).all()
    names = ("regime", "nutation_limits", "nutation_period", "precession_per_period", "spin_per_period", "spin_rate")
    assert len(set(motion.regime.tolist())) >= 9
    for name in names:
        np.testing.assert_array_equal(getattr(motion, name), getattr(alone, name))


def many_tops(rng, count):
    moments, attitude = rng.uniform(0.5, 3.0, (count, 3)), rng.normal(size=(count, 4))
    moments[:, 1] = moments[:, 0]
    mgl, momentum = rng.uniform(-3.0, 3.0, count), rng.normal(size=(count, 3))
    momentum[::9, :2] = 0.0  # cusps
    attitude /= np.linalg.norm(attitude, axis=1, keepdims=True)
    attitude[3], attitude[4], attitude[5] = (1.0, 0.0, 0.0, 0.0), (0.0, 1.0, 0.0, 0.0), (0.6, 0.0, 0.0, 0.8)
    momentum[4], momentum[5], momentum[6], mgl[7] = (0.0, 0.0, 1.0), (0.0, 0.0, -2.0), 0.0, 0.0
    moments[8], momentum[8] = (1e-200, 1e-200, 3e-200), (1e-200, 2e-200, 0.0)
    return moments, mgl, momentum, attitude


@pytest.mark.long
def test_many_tops_agree_with_numpy(monkeypatch):
    """With epochs, by several threads, in blocks that are not full; also at several times each."""
    rng = np.random.default_rng(3)
    arguments = many_tops(rng, 1500)
    epoch, times = rng.normal(size=(500, 3)), rng.uniform(-50.0, 50.0, (4, 500, 3))
    times[:, 2, 2] = 0.0  # the tiny top, whose rate is large
    shaped = [x.reshape(500, 3, *x.shape[1:]) for x in arguments]
    compiled_alone(monkeypatch)
    monkeypatch.setattr(kernel_setup, "WORTH", 400)
    monkeypatch.setattr(kernel_loops, "WORTH", 1000)

    def states():
        tops = lagrange_motion(*shaped, epoch=epoch), lagrange_motion(*(x[9:] for x in arguments))
        return tops[0].state(times), tops[1].state(1.5)

    found = states()
    numpy_alone(monkeypatch)
    assert found[0][0].shape == (4, 500, 3, 4) and found[1][1].shape == (1491, 3)
    for a, b in zip(found, states(), strict=True):
        scale = np.abs(b[1]).max(axis=-1, keepdims=True)
        assert np.abs(a[0] - b[0]).max() < AGREEMENT
        assert (np.abs(a[1] - b[1]) <= 4.0 * AGREEMENT * scale + 2e-323).all()


@pytest.mark.long
def test_mistakes_among_many_are_refused_in_the_same_words(monkeypatch):
    good = [np.array(x) for x in many_tops(np.random.default_rng(5), 600)]
    changes = ((0, (10, 0), 0.1), (0, (10, 2), -1.0), (1, 11, np.nan), (2, (12, 1), np.inf), (3, (13, 0), 5.0))
    said = []
    for _ in range(2):
        for which, where, value in changes:
            wrong = [x.copy() for x in good]
            wrong[which][where] = value
            with pytest.raises(InvalidInput) as caught:
                lagrange_motion(*wrong).state(1.0)
            said.append(str(caught.value))
        with pytest.raises(InvalidInput) as caught:
            lagrange_motion(*good).state(1e300)
        said.append(str(caught.value))
        numpy_alone(monkeypatch)
    assert said[:6] == said[6:] and len(set(said)) == 6


@pytest.mark.long
def test_several_threads_may_set_up_at_once(monkeypatch):
    compiled_alone(monkeypatch)
    arguments = many_tops(np.random.default_rng(4), 700)
    once = lagrange_motion(*arguments)._columns
    with ThreadPoolExecutor(4) as pool:
        for again in pool.map(lambda _: lagrange_motion(*arguments)._columns, range(8)):
            assert all((a == b).all() for a, b in zip(again, once, strict=True))


def test_a_wrong_column_is_noticed():
    """The tests of agreement would see an error of a rate in its fourteenth digit."""
    arguments = [x[9:] for x in many_tops(np.random.default_rng(6), 609)]
    top = lagrange_motion(*arguments)
    columns = top._columns.copy()
    columns[4] *= 1.0 + 1e-14
    found, _ = FORM.states(columns, np.full(600, 20.0), np.zeros(600))
    assert np.abs(found - top.attitude(20.0)).max() > AGREEMENT


def test_only_tops_whose_integrals_do_not_converge_are_left_to_numpy(monkeypatch):
    """Of a block, where few steps of the duplication are allowed; the others keep their bits."""
    tops = [case for case in draw_tops(5, 11) if case.family in ("generic", "wide_ratio", "fast_loop")]
    inputs = [[np.ravel(case[k]).tolist() for case in tops] for k in range(1, 5)]

    def columns_and_left(steps):
        monkeypatch.setattr(kernel_integrals, "MOST_STEPS", steps)
        space = FORM._modules.by_python()[kernel_setup.__name__]
        columns = [[0.0] * len(tops) for _ in range(COLUMNS)]
        left = [True] * len(tops)
        space["set_up"](*inputs, columns, left, 0)
        return np.array(columns), np.array(left)

    whole, none_left = columns_and_left(40)
    assert not none_left.any()
    for steps in range(8, 0, -1):
        some, left = columns_and_left(steps)
        np.testing.assert_array_equal(some[:, ~left], whole[:, ~left])
        if left.any():
            break
    assert left.any() and not left.all()
