"""The kernels, by Python and as Numba compiles them: what they take, and answers of arrays. tests/twins has their
errors."""

import os
import subprocess
import sys
from collections import Counter
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest

import polhode as ph
from oracle.numpy_alone import compiled_alone, numpy_alone, python_alone
from polhode.exact import _kernel_loops as kernel_loops
from polhode.exact._closed_form import COMPILING, ClosedForm
from polhode.exact.free_body import _kernel_setup as kernel_setup
from polhode.exact.free_body._evaluation import FORM
from starts import free_motion
from twins.families_of_bodies import draw

PER_FAMILY = 22  # together enough for the kernels to be chosen


def batch(cases):
    moments, momenta, times = (np.array([getattr(c, n) for c in cases]) for n in ("moments", "momentum", "time"))
    return ph.FreeMotion(moments, momentum=momenta), times


@pytest.mark.long
def test_which_bodies_it_takes(monkeypatch):
    """Of all families at once; those that it leaves to NumPy stand among them."""
    calls, taken, run = [], Counter(), ClosedForm._set_up_many

    def observed(self, flat, columns, left):
        run(self, flat, columns, left)
        calls.append(left.copy())

    compiled_alone(monkeypatch)
    monkeypatch.setattr(ClosedForm, "_set_up_many", observed)
    cases = draw(PER_FAMILY, 5)
    motion, _ = batch(cases)
    assert motion._columns.shape[1] == len(cases)
    for case, is_left in zip(cases, calls[0], strict=True):
        taken[case.family] += int(not is_left)
    wholly = ("generic", "short_axis", "long_axis", "near_oblate", "near_prolate", "near_sphere", "flat", "huge_scale")
    assert all(taken[name] == PER_FAMILY for name in wholly)
    assert taken["near_separatrix"] > 0 and taken["sphere"] == taken["permanent"] == taken["exact_separatrix"] == 0


def many_bodies(rng, count):
    attitude = rng.normal(size=(count, 4))
    moments, momentum = rng.uniform(0.5, 3.0, (count, 3)), rng.normal(size=(count, 3))
    moments[::7, 1] = moments[::7, 0]  # symmetric
    momentum[5], momentum[6], moments[7] = 0.0, (0.0, 0.0, 2.0), 1.0  # rest, a permanent rotation, a sphere
    moments[8], momentum[8] = (1e-200, 2e-200, 3e-200), (1e-200, 2e-200, 0.0)
    momentum[9], momentum[10] = (1e-310, 2e-310, 0.0), (1e-90, 1.0, 0.0)
    return moments, momentum, attitude / np.linalg.norm(attitude, axis=1, keepdims=True)




@pytest.mark.long
def test_many_bodies_agree_with_numpy(monkeypatch):
    """With attitudes and epochs, by several threads, in blocks that are not full; also at several times each."""
    rng = np.random.default_rng(3)
    arguments = many_bodies(rng, 1500)
    epoch, times = rng.normal(size=(500, 3)), rng.uniform(-50.0, 50.0, (4, 500, 3))
    shaped = [x.reshape(500, 3, -1) for x in arguments]
    compiled_alone(monkeypatch)
    monkeypatch.setattr(kernel_setup, "WORTH", 400)
    monkeypatch.setattr(kernel_loops, "WORTH", 1000)
    found = [free_motion(*shaped, epoch=epoch).state(times), free_motion(*arguments).state(1.5)]
    numpy_alone(monkeypatch)
    wanted = [free_motion(*shaped, epoch=epoch).state(times), free_motion(*arguments).state(1.5)]
    assert found[0][0].shape == (4, 500, 3, 4) and found[1][1].shape == (1500, 3)
    for a, b in zip(found, wanted, strict=True):
        scale = np.abs(b[1]).max(axis=-1, keepdims=True)
        assert np.abs(a[0] - b[0]).max() < 6e-15
        assert (np.abs(a[1] - b[1]) <= 6e-15 * scale + 2e-323).all()


@pytest.mark.long
def test_several_threads_may_use_it_at_once(monkeypatch):
    compiled_alone(monkeypatch)
    moments, momentum, attitude = many_bodies(np.random.default_rng(4), 700)
    once = ph.FreeMotion(moments, momentum=momentum, attitude=attitude).state(3.0)
    with ThreadPoolExecutor(4) as pool:
        for again in pool.map(
            lambda _: ph.FreeMotion(moments, momentum=momentum, attitude=attitude).state(3.0), range(8)
        ):
            assert all((a == b).all() for a, b in zip(again, once, strict=True))


@pytest.mark.long
def test_each_kernel_is_compiled_once_whatever_arrays_it_is_given(monkeypatch):
    """Such as JAX's, which may not be written, and slices; by one thread and by several."""
    compiled_alone(monkeypatch)
    monkeypatch.setattr(kernel_setup, "WORTH", 400)
    monkeypatch.setattr(kernel_loops, "WORTH", 400)
    plenty = many_bodies(np.random.default_rng(12), 1000)
    frozen = [v.copy() for v in plenty]
    for v in frozen:
        v.flags.writeable = False
    swapped = [np.asfortranarray(v) for v in plenty]
    few = [v[:9] for v in plenty]
    for arguments in (plenty, frozen, swapped, few, [v[::3] for v in plenty], [plenty[0][0], *plenty[1:]]):
        columns = FORM.columns(tuple(arguments))
        count = columns.shape[1]
        times = np.linspace(0.0, 9.0, count)
        for elapsed in (times, np.broadcast_to(3.0, count), times[::-1]):
            FORM.states(columns, elapsed, np.zeros(count))
            FORM.states(columns[:, ::-1], elapsed, np.broadcast_to(0.0, count))
            FORM.states(columns[:, :1], elapsed, np.zeros(1))
    for kernel in ("set_up", "states_of_one", "states_of_many"):
        assert len(getattr(FORM._compiled, kernel)._runs) == 1, kernel


AT_ONCE = """
import numpy as np
from polhode._base.compiled import objects
made, own = [], objects.build_image
objects.build_image = lambda *given: made.append(1) or own(*given)
from polhode.exact._closed_form import COMPILING
from polhode.exact.free_body._evaluation import FORM
COMPILING["states_of_one"] = 0.0
columns = FORM.columns((np.array([1.0, 2.0, 3.0]), np.array([0.3, 1.8, 1.5]), np.array([1.0, 0.0, 0.0, 0.0])))
FORM.states(columns, np.linspace(0.0, 9.0, 100), np.zeros(100))
print(len(made))
"""


@pytest.mark.sweep
def test_of_processes_that_start_at_once_one_compiles(tmp_path):
    """As workers of a sweep do; the others wait for it, and load what it has kept."""
    environment = os.environ | {"NUMBA_CACHE_DIR": str(tmp_path)}
    started = [subprocess.Popen([sys.executable, "-c", AT_ONCE], env=environment, stdout=subprocess.PIPE, text=True)
               for _ in range(3)]  # fmt: skip
    assert sorted(process.communicate()[0].strip() for process in started) == ["0", "0", "1"]


STARTS = [(0.3, 0.1, 3.0), (0.3, 1.8, 1.5), (0.9, 1.6, 0.3), (1e-6, 2.0, 3e-6), (0.0, 2.0, 0.0)]


@pytest.mark.parametrize("momentum", STARTS)
def test_long_runs_go_through_it_and_agree(momentum, monkeypatch):
    """By threads, in blocks that are not full, with the epoch's rest, for times of any shape."""
    motion = ph.FreeMotion((1.0, 2.0, 3.0), momentum=momentum, epoch=0.1)
    times = np.linspace(-50.0, 1e4, 70_001)[:-1].reshape(2, -1)
    calls = []
    monkeypatch.setitem(FORM._spent, "states_of_one", COMPILING["states_of_one"])  # else it depends on earlier tests
    monkeypatch.setattr(ClosedForm, "_of_one", lambda *x, run=ClosedForm._of_one: calls.append(1) or run(*x))
    found = motion.state(times)
    motion = ph.FreeMotion((1.0, 2.0, 3.0), momentum=momentum, epoch=0.1)
    numpy_alone(monkeypatch)
    wanted = motion.state(times)
    assert calls and found[0].shape == (2, 35_000, 4)
    assert max(np.abs(a - b).max() for a, b in zip(found, wanted, strict=True)) < 4e-15


def test_a_wrong_column_is_noticed():
    motion = ph.FreeMotion((1.0, 2.0, 3.0), momentum=(0.3, 1.8, 1.5))
    columns = motion._columns.tolist()
    columns[4] *= 1.0 + 1e-13
    assert np.abs(FORM.state(tuple(columns), 100.0, 0.0)[4:] - motion.momentum(100.0)).max() > 1e-13


def test_what_python_cannot_divide_goes_elsewhere(monkeypatch):
    """Numba's numbers become infinite where Python's raise errors; of a set-up NumPy's do, which need no compiling."""
    python_alone(monkeypatch)
    wanted = ph.FreeMotion((1.0, 2.0, 3.0), momentum=(0.3, 1.8, 1.5)).state(2.0)

    def broken(*given):
        raise ZeroDivisionError

    right = FORM._python
    monkeypatch.setattr(FORM, "_python", right._replace(state_at=broken))
    found = ph.FreeMotion((1.0, 2.0, 3.0), momentum=(0.3, 1.8, 1.5)).state(2.0)
    assert (found[0] == wanted[0]).all() and (found[1] == wanted[1]).all()
    monkeypatch.setattr(FORM, "_python", right._replace(set_up_one=broken))
    found = ph.FreeMotion((1.0, 2.0, 3.0), momentum=(0.3, 1.8, 1.5)).state(2.0)
    assert np.abs(np.concatenate(found) - np.concatenate(wanted)).max() < 1e-15


@pytest.mark.parametrize("make", [
    lambda: ph.FreeMotion((1.0, 2.0, 3.0), momentum=(0.0, 0.0, 0.0)),
    lambda: ph.LagrangeMotion((1.0, 1.0, 2.0), mgl=1.0, momentum=(0.0, 1.0, 0.0)),
    lambda: ph.LagrangeMotion((1.0, 1.0, 2.0), mgl=1.0, momentum=(0.3, 1.0, 2.0)),
    lambda: ph.LagrangeMotion((1.0, 1.0, 2.0), mgl=1.0, momentum=(0.3, 1.0, 2.0), attitude=(0.0, 1.0, 0.0, 0.0)),
    lambda: ph.LagrangeMotion((1.0, 1.0, 2.0), mgl=0.0, momentum=(0.0, 0.0, 0.0)),
], ids=["at rest", "pushed over", "upright", "hanging", "top at rest"])  # fmt: skip
def test_one_body_in_a_special_place_is_not_compiled_for(monkeypatch, make):
    """Its set-up took ten seconds at the default attitude of a top, and at rest."""

    def compiled(self):
        raise AssertionError("Numba was asked to compile")

    monkeypatch.setattr(type(FORM), "_is_worth", lambda self, name, seconds: False)
    monkeypatch.setattr(type(FORM), "_compiled", property(compiled))
    assert np.isfinite(np.concatenate(make().state(3.0))).all()


@pytest.mark.long
def test_a_process_that_has_used_it_may_fork():
    code = """
import multiprocessing, numpy as np, polhode as ph
motion = ph.FreeMotion((1.0, 2.0, 3.0), momentum=(0.3, 1.8, 1.5))
times = np.linspace(0.0, 9.0, 100_000)
before = motion.momentum(times)[-1]
many = ph.FreeMotion((1.0, 2.0, 3.0), momentum=times[3:99_999].reshape(-1, 3))
many_before = many.momentum(7.0)
with multiprocessing.get_context("fork").Pool(2) as pool:
    for after in pool.map(motion.momentum, [times] * 2):
        assert (after[-1] == before).all()
    for after in pool.map(many.momentum, [7.0] * 2):
        assert (after == many_before).all()
"""
    subprocess.run([sys.executable, "-c", code], check=True, timeout=120)
