"""Closed forms by arrays of NumPy alone, as JAX has them; and by kernels that Numba has compiled."""

import numpy as np
import pytest

from polhode.exact._blocks import columns_in_blocks
from polhode.exact._closed_form import COMPILING, Cost
from polhode.exact.free_body import _evaluation as free_body
from polhode.exact.free_body import _preparation as of_free_body
from polhode.exact.lagrange_top import _evaluation as lagrange_top
from polhode.exact.lagrange_top import _preparation as of_lagrange_top


class ByArrays:
    """What ``ClosedForm`` offers, without its kernels."""

    def __init__(self, prepare, evaluate):
        self.prepare, self.evaluate = prepare, evaluate

    def columns(self, arguments):
        return np.array([np.asarray(x, float) for x in columns_in_blocks(self.prepare, arguments)])

    def states(self, columns, elapsed, rest):
        shape = np.broadcast_shapes(columns.shape[1:], np.shape(elapsed))
        full, *numbers, times, rests = (np.broadcast_to(x, shape).ravel() for x in (*columns, elapsed, rest))
        with np.errstate(all="ignore"):
            found = np.array(self.evaluate((full != 0.0, *numbers), times, rests))
        return np.moveaxis(found[:4], 0, -1).reshape(*shape, 4), np.moveaxis(found[4:], 0, -1).reshape(*shape, 3)

    def states_of(self, motion, elapsed, rest):
        return self.states(motion._columns, elapsed, rest)

    def state(self, column, time, rest):
        return np.concatenate(self.states(np.array(column), np.array(time), np.array(rest)))


def numpy_alone(monkeypatch: pytest.MonkeyPatch) -> None:
    """Leave all bodies and times to NumPy."""
    for module, prepare, states in (
        (free_body, "_columns_of_bodies", of_free_body.STATES),
        (lagrange_top, "_columns_of_tops", of_lagrange_top.STATES),
    ):  # fmt: skip
        monkeypatch.setattr(module, "FORM", ByArrays(getattr(module, prepare), states.evaluate))


def compiled_alone(monkeypatch: pytest.MonkeyPatch) -> None:
    """Leave all bodies and times to the compiled kernels, however few they are."""
    for module in (free_body, lagrange_top):
        monkeypatch.setattr(module.FORM, "_ready", set(COMPILING))


def python_alone(monkeypatch: pytest.MonkeyPatch) -> None:
    """Leave all bodies and times to the kernels as Python runs them."""
    monkeypatch.setattr(Cost, "is_for_numpy", lambda self, count: False)
    for module in (free_body, lagrange_top):
        monkeypatch.setattr(module.FORM, "_ready", set())
        monkeypatch.setattr(module.FORM, "_spent", dict.fromkeys(COMPILING, -np.inf))


def under(alone, states):
    """Return a function of cases that gives their states with one of the above in force."""

    def computed(cases):
        with pytest.MonkeyPatch.context() as patch:
            alone(patch)
            return states(cases)

    return computed
