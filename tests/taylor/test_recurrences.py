"""The table of recurrences: every function has a row, and every implementation takes it from there."""

import ctypes

import flint
import jax.numpy as jnp
import numpy as np
import pytest

from polhode import systems
from polhode.proving.enclosures._taylor_balls import BallSystem
from polhode.taylor import array_series, kernels, straight_line
from polhode.taylor.elementary import exponential
from polhode.taylor.expressions import Tape
from polhode.taylor.kernel_space import series_for
from polhode.taylor.loops import write_function
from polhode.taylor.operations import ALONG, COMPANIONS, Operation
from polhode.taylor.program import make_program
from polhode.taylor.recurrences import RECURRENCES

ORDER, START = 9, 0.5
EPS = 2.0**-52
# of ẏ = e^y: y = −log(e^−y₀ − t), of which the k-th coefficient is e^(k y₀)/k
COEFFICIENTS = np.array([START, *(np.exp(k * START) / k for k in range(1, ORDER + 1))])


class Own(systems.base.AbstractSystem):
    field: object

    def vector_field(self, t, state):
        return self.field(state)

    def invariants(self, state):
        return {}


def growth():
    """Return a system of its own, for which nothing is compiled."""
    return Own(lambda y: jnp.exp(y))


def by_program(patch, compute):
    tape = Tape(1)
    program = make_program(tape, [exponential(*tape.state())])
    space, series = kernels.python_kernel(1).advance.__globals__, series_for(program, ORDER + 1, 1)
    patch.setitem(space, "function", write_function(space))
    series.flat[0] = START
    compute(space, program, series)
    return series.flat[: (ORDER + 1) * program.slots : program.slots]


def by_loops(patch):
    return by_program(patch, lambda space, program, series: space["coefficients"](series, ORDER, np.ones(1)))


def by_machine_code(patch):
    def compute(space, program, series):
        straight_line._compile.cache_clear()
        code, unit = straight_line.generate(program, 1), np.ones(1)
        straight_line._compile.cache_clear()
        space["nodes"](series, 0)
        run = ctypes.CFUNCTYPE(None, *[ctypes.c_void_p] * 4, ctypes.c_int64, ctypes.c_void_p)
        addresses = (x.ctypes.data for x in (series.flat, series.a, series.b, series.number))
        run(code.address)(*addresses, ORDER, unit.ctypes.data)

    return by_program(patch, compute)


def by_arrays(patch):
    return np.ravel(array_series.coefficients(growth(), np.array([START]), np.float64(0.0), np.float64(1.0), ORDER))


def by_balls(patch):
    enclosed = BallSystem(growth(), np.array([START]))
    return np.array([float(x.mid()) for x in enclosed.coefficients([flint.arb(START)], [], ORDER)[0]])


def test_every_function_has_a_row():
    others = {Operation.AFFINE, Operation.PRODUCT, *ALONG}
    assert set(RECURRENCES) == set(Operation) - others
    for operation, recurrence in RECURRENCES.items():
        assert recurrence.results >= 1 + len(COMPANIONS.get(operation, ()))


@pytest.mark.parametrize("by", [by_loops, by_machine_code, by_arrays, by_balls])
def test_a_wrong_row_is_wrong_in_each_implementation(by, monkeypatch):
    """The weight j in place of k − j."""
    assert by(monkeypatch) == pytest.approx(COEFFICIENTS, rel=30.0 * EPS)

    def wrong(w, k, x, own, number):
        (u,) = own
        yield w.total(0, k, 0.0, lambda j: j * (u[j] * x[k - j])) / k

    row = RECURRENCES[Operation.EXPONENTIAL]._replace(coefficients=wrong)
    monkeypatch.setitem(RECURRENCES, Operation.EXPONENTIAL, row)
    assert by(monkeypatch)[2:] != pytest.approx(COEFFICIENTS[2:], rel=0.1)
