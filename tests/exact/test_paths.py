"""Python and NumPy in place of compiled kernels: which of them computes, and that it does not matter for the digits."""

import os
import subprocess
import sys

import numpy as np
import pytest

import polhode as ph
from oracle.numpy_alone import python_alone
from polhode.exact._closed_form import SET_UP, STATE, ClosedForm
from polhode.exact.free_body._evaluation import FORM as BODIES
from polhode.exact.lagrange_top._evaluation import FORM as TOPS
from twins.families_of_bodies import draw as draw_bodies
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


def tops():
    cases = draw_tops(FEW, 3)
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
