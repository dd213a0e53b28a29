"""Python and NumPy in place of compiled kernels: which of them computes, and that it does not matter for the digits."""

import os
import subprocess
import sys

import numpy as np
import pytest

import polhode as ph
from oracle.numpy_alone import python_alone
from polhode.exact import _closed_form
from polhode.exact import _kernel_loops as kernel_loops
from polhode.exact._closed_form import COMPILING, SET_UP, STATE, ClosedForm, Compiled
from polhode.exact.free_body import _kernel_setup as body_setup
from polhode.exact.free_body._evaluation import FORM as BODIES
from polhode.exact.lagrange_top import _kernel_setup as top_setup
from polhode.exact.lagrange_top._evaluation import FORM as TOPS
from twins.families_of_bodies import draw as draw_bodies
from twins.families_of_tops import FAMILIES as FAMILIES_OF_TOPS
from twins.families_of_tops import draw_tops

FEW = 8  # of each family: together enough for NumPy


@pytest.fixture
def nothing_compiled(monkeypatch):
    for form in (BODIES, TOPS):
        monkeypatch.setattr(form, "_ready", set[str]())
        monkeypatch.setattr(form, "_spent", dict.fromkeys(form._spent, -np.inf))


def columns_of(cases, *names):
    return (np.array([getattr(case, name) for case in cases]) for name in names)


def bodies():
    """Return motions of all families, and a time for each."""
    moments, momenta, times = columns_of(draw_bodies(FEW, 3), "moments", "momentum", "time")
    return ph.FreeMotion(moments, momentum=momenta), times


def tops(names=tuple(family.__name__ for family in FAMILIES_OF_TOPS)):
    cases = [case for case in draw_tops(FEW, 3) if case.family in names]
    moments, mgl, momenta, attitudes, times = columns_of(cases, "moments", "mgl", "momentum", "attitude", "time")
    return ph.LagrangeMotion(moments, mgl=mgl, momentum=momenta, attitude=attitudes), times


@pytest.mark.parametrize("make", [bodies, tops])
def test_numpy_and_python_give_the_same_bits(make, monkeypatch, nothing_compiled):
    """Of a chunk of a sweep NumPy computes many samples and Python few; the samples must not tell."""
    taken, own = [], ClosedForm._by_arrays
    monkeypatch.setattr(ClosedForm, "_by_arrays", lambda self, *given: taken.append(1) or own(self, *given))
    motion, times = make()
    by_numpy = motion.state(times)
    assert taken == [1]
    python_alone(monkeypatch)
    motion, times = make()
    by_python = motion.state(times)
    assert taken == [1]
    for found, wanted in zip(by_numpy, by_python, strict=True):
        assert np.array_equal(found, wanted, equal_nan=True)


@pytest.mark.parametrize("cost", [SET_UP, STATE])
def test_numpy_takes_many_and_python_few(cost):
    limit = next(count for count in range(10_000) if cost.is_for_numpy(count))
    assert 30 < limit < 100 and not cost.is_for_numpy(limit - 1)
    assert cost.time(limit - 1) == cost.one * (limit - 1) and cost.time(limit) == cost.calls + cost.each * limit


@pytest.fixture
def by_python(monkeypatch):
    """Have Python run the kernels of many bodies and tops, and return the numbers of those that each call sets up."""
    counts = []

    def counted(function):
        return lambda *given: counts.append(len(given[0])) or function(*given)

    for form, setup in ((BODIES, body_setup), (TOPS, top_setup)):
        spaces = form._modules.by_python()
        loops = (spaces[kernel_loops.__name__][name] for name in ("states_of_one", "states_of_many"))
        monkeypatch.setattr(form, "_compiled", Compiled(counted(spaces[setup.__name__]["set_up"]), *loops))
        monkeypatch.setattr(form, "_ready", set(COMPILING))
    return counts


def plain_tops():
    """Return tops for which Python can run the kernels of many: no number is divided by zero."""
    return tops(("generic", "wide_ratio", "fast_loop"))


@pytest.mark.parametrize(("make", "block"), [(bodies, 50), (plain_tops, 10)])
def test_constants_of_many_are_kept_from_the_second_call_on(make, block, by_python, monkeypatch):
    """Of bodies among which some are left to NumPy; a call that is the only one touches no memory for constants."""
    monkeypatch.setattr(_closed_form, "AT_ONCE", block)
    with np.errstate(all="ignore"):
        (motion, times), (other, _) = make(), make()
        first = motion.state(times)
        assert "_columns" not in vars(motion) and max(by_python) == block and sum(by_python) == len(times)
        by_python.clear()
        again, later = motion.state(times), motion.state(0.0)
        assert "_columns" in vars(motion) and by_python == [len(times)]
        assert all(np.array_equal(a, b, equal_nan=True) for a, b in zip(first, again, strict=True))
        at_one = other.state(0.0)
        assert "_columns" not in vars(other)
    assert all(np.array_equal(a, b, equal_nan=True) for a, b in zip(at_one, later, strict=True))
    python_alone(monkeypatch)  # one by one, without stores, of which no kernel reads what it did not put there
    alone = make()[0].state(times)
    assert all(np.array_equal(a, b, equal_nan=True) for a, b in zip(first, alone, strict=True))


def test_constants_are_kept_at_once_where_each_body_has_many_times(by_python):
    motion, times = bodies()
    with np.errstate(all="ignore"):
        attitude, _ = motion.state(np.zeros((2, 1)))
    assert attitude.shape == (2, len(times), 4) and "_columns" in vars(motion) and by_python == [len(times)]


FIRST = """
import sys
import numpy as np, polhode as ph
from polhode.exact._closed_form import ClosedForm
calls, own = [], ClosedForm._set_up_one
ClosedForm._set_up_one = lambda self, *given: calls.append(1) or own(self, *given)
rng, count = np.random.default_rng(0), 10_000
attitudes, momenta = rng.normal(size=(count, 4)), rng.normal(size=(count, 3))
attitudes /= np.linalg.norm(attitudes, axis=1, keepdims=True)
moments, times = rng.uniform(0.5, 3.0, (count, 2))[:, [0, 0, 1]], rng.uniform(0.0, 1e6, count)
ph.LagrangeMotion(moments, mgl=1.0, momentum=momenta, attitude=attitudes).state(times)
ph.FreeMotion(moments, momentum=momenta).state(times)
print(len(calls), "numba" in sys.modules, "llvmlite" in sys.modules)
"""


def test_nothing_is_compiled_for_the_first_ten_thousand(tmp_path):
    """It took 17 CPU s after an installation without images, of which NumPy needs a fifth of one."""
    code = f"from polhode._base.compiled import entries\nentries.SHIPPED = entries.Path({str(tmp_path)!r})\n{FIRST}"
    environment = os.environ | {"NUMBA_CACHE_DIR": str(tmp_path)}
    command = [sys.executable, "-c", code]
    said = subprocess.run(command, env=environment, check=True, capture_output=True, text=True).stdout
    assert said.split() == ["0", "False", "False"]
