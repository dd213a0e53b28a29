"""Machine code for programs, against the kernel that reads them from tables: the same bits of whatever they are."""

import ctypes

import numpy as np
import pytest

from polhode.taylor import kernels, lanes, straight_line
from polhode.taylor.elementary import (
    exponential,
    exponential_minus_one,
    hyperbolic_tangent,
    logarithm,
    logarithm_of_one_plus,
    sine_and_cosine,
)
from polhode.taylor.expressions import Tape
from polhode.taylor.kernel_space import series_for
from polhode.taylor.program import make_program

ORDER = 11
POINTER = ctypes.POINTER(ctypes.c_double)


def random_program(seed, kinds=11):
    """Return a program of random operations on random ones before them; the first three kinds are sums and products."""
    rng = np.random.default_rng(seed)
    tape = Tape(int(rng.integers(1, 6)))
    known = tape.state()
    for _ in range(int(rng.integers(1, 40))):
        x, y = (known[k] for k in rng.integers(len(known), size=2))
        known.append({
            0: lambda x=x, y=y: x * float(rng.choice([1.0, -1.0, 0.3])) + y * float(rng.normal()) + float(rng.normal()),
            1: lambda x=x, y=y: x * y, 2: lambda x=x, y=y: x * y,
            3: lambda x=x: (x * x + 1.0) ** -1.5, 4: lambda x=x: exponential((x * x + 1.0) ** -1.0),
            5: lambda x=x: logarithm(x * x + 2.0), 6: lambda x=x: sine_and_cosine(x)[int(rng.integers(2))],
            7: lambda x=x: x * x, 8: lambda x=x: hyperbolic_tangent(x),
            9: lambda x=x: exponential_minus_one((x * x + 1.0) ** -1.0), 10: lambda x=x: logarithm_of_one_plus(x * x),
        }[int(rng.integers(kinds))]())  # fmt: skip
    return make_program(tape, [known[k] * (1.0 / (k + 1.0)) + 0.1 for k in rng.integers(len(known), size=tape.size)])


def call(code, series, units):
    run = ctypes.CFUNCTYPE(None, *[POINTER] * 4, ctypes.c_int64, POINTER)
    arrays = (x.ctypes.data_as(POINTER) for x in (series.flat, series.a, series.b, series.number))
    run(code.address)(*arrays, ORDER, units.ctypes.data_as(POINTER))


def by_tables_and_by_code(program, width):
    """Return the coefficients as the kernel of plain Python has them, and as the code has them."""
    space = kernels.python_kernel(width).advance.__globals__
    start = np.random.default_rng(1).normal(size=program.size * width)
    units, found = np.full(width, 0.25), []
    for by_code in (False, True):
        series = series_for(program, ORDER + 1, width)
        series.flat[: start.size] = start
        seen = series._replace(z=space["vectors"](series.flat))
        if by_code:
            code = straight_line.generate(program, width)
            if code.begins:
                space["nodes"](seen, 0)
            call(code, series, units)
        else:
            space["coefficients"](seen, ORDER, units)
        found.append(series.flat)
    return found


@pytest.mark.long_after(15)
@pytest.mark.parametrize("width", [1, lanes.LANES])
@pytest.mark.parametrize("seed", range(25))
def test_random_programs_have_the_same_bits(seed, width):
    by_tables, by_code = by_tables_and_by_code(random_program(seed), width)
    np.testing.assert_array_equal(by_code, by_tables)
    assert np.isfinite(by_tables).all()


@pytest.mark.parametrize("width", [1, lanes.LANES])
@pytest.mark.parametrize("seed", range(5))
def test_sums_and_products_begin_with_order_zero(seed, width):
    program = random_program(seed, kinds=3)
    assert program.is_of_products and straight_line.generate(program, width).begins == 0
    by_tables, by_code = by_tables_and_by_code(program, width)
    np.testing.assert_array_equal(by_code, by_tables)


@pytest.mark.parametrize("width", [1, lanes.LANES])
@pytest.mark.parametrize("seed", range(5))
def test_values_have_the_same_bits(seed, width):
    program = random_program(seed, kinds=3)
    space, count = kernels.python_kernel(width).advance.__globals__, program.outputs
    series = series_for(program, 1, width, None, count)
    series.flat[: program.size * width] = np.random.default_rng(seed).normal(size=program.size * width)
    seen = series._replace(z=space["vectors"](series.flat))
    space["compute_outputs"](seen, space["vectors"](series.flat.copy()))
    wanted = np.ravel([np.asarray(space["output"](seen, o)) for o in range(count)])
    call(straight_line.generate_values(program, width), series, np.ones(width))
    begin = program.slots * width
    np.testing.assert_array_equal(series.flat[begin : begin + count * width], wanted)
    assert np.isfinite(wanted).all() and np.ptp(wanted) > 0.0


@pytest.mark.parametrize("width", [1, lanes.LANES])
def test_functions_of_limited_length_change_no_bit(width, monkeypatch):
    program = random_program(7, kinds=3)
    results = []
    for terms in (1, 10_000):
        straight_line._compile.cache_clear()
        monkeypatch.setattr(straight_line, "LIMITS", straight_line.LIMITS._replace(terms_of_part=terms))
        series = series_for(program, 1, width, None, program.outputs)
        series.flat[: program.size * width] = np.random.default_rng(7).normal(size=program.size * width)
        call(straight_line.generate_values(program, width), series, np.ones(width))
        results.append(series.flat.copy())
    straight_line._compile.cache_clear()
    np.testing.assert_array_equal(*results)


def test_functions_are_of_limited_length(monkeypatch):
    monkeypatch.setattr(straight_line, "LIMITS", straight_line.LIMITS._replace(terms_of_part=10))
    assert straight_line.divide([4, 6, 1, 11, 9, 1]) == [range(2), range(2, 3), range(3, 4), range(4, 6)]
    assert straight_line.divide([]) == [range(0)] and straight_line.divide([12]) == [range(1)]


@pytest.mark.parametrize(("width", "registers"), [
    (1, (16, 4)), (lanes.LANES, (8, 2)), (lanes.LANES, (32, 2)), (lanes.LANES, (16, 4)), (lanes.LANES, (32, 8)),
])  # fmt: skip
def test_registers_change_no_bit(width, registers, monkeypatch):
    """On a machine with fewer of them, fewer products are summed together."""
    program = random_program(7)
    straight_line._compile.cache_clear()
    monkeypatch.setattr(straight_line, "find_registers", lambda: straight_line.Registers(*registers))
    monkeypatch.setattr(straight_line, "LIMITS", straight_line.LIMITS._replace(blocks_together=1))
    by_tables, by_code = by_tables_and_by_code(program, width)
    straight_line._compile.cache_clear()
    np.testing.assert_array_equal(by_code, by_tables)


@pytest.mark.parametrize(("most", "factors"), [(12, 7), (8, 6), (1, 2)])
def test_products_with_common_factors_are_together(most, factors):
    """Those of a quaternion and an angular velocity, among others: twelve products of seven numbers."""
    products = [(i, j, 0) for i in range(4) for j in (4, 5, 6)] + [(10 + i, 20 + i, 0) for i in range(8)]
    shuffled = [products[0], *(products[k] for k in 1 + np.random.default_rng(0).permutation(19))]
    groups = straight_line._group_products(shuffled, most)
    first = groups[0]
    assert len({i for i, _, _ in first}) + len({j for _, j, _ in first}) == factors and len(first) == most
    assert sorted(p for group in groups for p in group) == sorted(products) and max(map(len, groups)) == most


def test_products_are_sought_among_those_that_follow(monkeypatch):
    products = [(0, 1, 0), (2, 3, 0), (4, 5, 0), (0, 6, 0)]
    assert straight_line._group_products(products, 2)[0] == [(0, 1, 0), (0, 6, 0)]
    monkeypatch.setattr(straight_line, "LIMITS", straight_line.LIMITS._replace(products_sought=2))
    assert straight_line._group_products(products, 2)[0] == [(0, 1, 0), (2, 3, 0)]
