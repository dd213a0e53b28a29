"""The definitions of which Rocq proves bounds of rounding are the code: the same order of operations, the same bits."""

from fractions import Fraction
from pathlib import Path

import jax
import jax.numpy as jnp
import numpy as np
import pytest
from numba import njit

from polhode._base.arrays import split_halves
from polhode.exact import _kernel_arithmetic as kernel
from polhode.exact._compiled_arithmetic import two_product as compiled_two_product
from polhode.special import _doubledouble as dd
from proofs.rocq_arithmetic import definitions, functions

ROUNDING = Path(__file__).parents[2] / "proofs" / "rounding"
TEXTS = {name: (ROUNDING / f"{name}.v").read_text("utf-8")
         for name in ("Sums", "Products", "Splitting", "DoubleDouble", "DoubleDoubleSum")}  # fmt: skip
ROCQ = functions(*TEXTS.values())
COUNT = 300


@njit
def fused_two_product(a, b):
    return compiled_two_product(a, b)


def jax_halves(a):
    with jax.enable_x64(True):
        return tuple(float(half) for half in split_halves(jnp.asarray(a)))


def jax_two_product(a, b):
    with jax.enable_x64(True):
        return tuple(float(x) for x in dd.two_product(jnp.asarray(a), jnp.asarray(b)))


def rocq_jax_two_product(a, b):
    halves = [Fraction(half) for x in (a, b) for half in jax_halves(float(x))]
    return ROCQ["jax_two_product"](*halves)


def doubles(seed, spread):
    """Return doubles of many sizes, with neighbours, opposites and ties among them."""
    random = np.random.default_rng(seed)
    values = random.normal(size=COUNT) * 2.0 ** random.integers(-spread, spread + 1, COUNT)
    values[::9] = 2.0 ** random.integers(-spread, spread + 1, len(values[::9]))
    values[1::9] = np.nextafter(values[::9][: len(values[1::9])], np.inf)
    values[2::9] = -values[1::9][: len(values[2::9])]
    values[3::9] = np.round(random.normal(size=len(values[3::9])), 2)
    return values


def pairs_of(seed):
    """Return operands with low parts of up to half a unit in the last place, some of them zero."""
    random = np.random.default_rng(seed + 100)
    high = doubles(seed, 60)
    low = high * 2.0**-53 * random.uniform(-1.0, 1.0, COUNT)
    low[::5] = 0.0
    return high, low


def same(found, expected):
    return all(float(x) == float(y) for x, y in zip(found, expected, strict=True))


FLOATS = {  # the Rocq definition, the code, which sizes of numbers, and whether tiny and zero ones belong to it
    "NumPy's two_sum": (ROCQ["numpy_two_sum"], dd.two_sum, 300, True),
    "the kernels' two_sum": (ROCQ["kernel_two_sum"], kernel.two_sum, 300, True),
    "fast_two_sum": (ROCQ["fast_two_sum"], dd.fast_two_sum, 300, True),
    "the kernels' fast_two_sum": (ROCQ["fast_two_sum"], kernel.fast_two_sum, 300, True),
    "NumPy's two_product": (ROCQ["numpy_two_product"], dd.two_product, 200, True),
    "the kernels' two_product": (ROCQ["numpy_two_product"], kernel.two_product, 200, True),
    "the compiled two_product": (ROCQ["fused_two_product"], fused_two_product, 200, True),
    "JAX's two_product": (rocq_jax_two_product, jax_two_product, 200, False),
}
TINY = [0.0, 5e-324, -5e-324, 2.2250738585072014e-308, 1.5e-310, 1.0, -1.0]


@pytest.mark.parametrize("name", FLOATS)
def test_the_order_of_operations_on_floats(name):
    rocq, code, spread, tiny = FLOATS[name]
    xs, ys = doubles(1, spread), doubles(2, spread)
    special = [(x, y) for x in TINY for y in TINY] if tiny else []
    count = 40 if "JAX" in name else COUNT
    for x, y in [*zip(xs[:count], ys[:count], strict=True), *zip(xs[:9], -xs[:9], strict=True), *special]:
        x, y = np.float64(x), np.float64(y)
        assert same(rocq(Fraction(x), Fraction(y)), code(x, y)), (x, y)


def test_the_order_of_operations_of_squares():
    for x in [*doubles(3, 200), *TINY]:
        assert same(ROCQ["numpy_two_square"](Fraction(x)), dd.two_square(np.float64(x))), x


@pytest.mark.long_after(1)
@pytest.mark.parametrize("module, two_sum, two_square", [(dd, "numpy_two_sum", "numpy_two_square"),
                                                        (kernel, "kernel_two_sum", None)])  # fmt: skip
def test_the_order_of_operations_on_pairs(module, two_sum, two_square):
    product = ROCQ["numpy_two_product"]
    square = ROCQ[two_square] if two_square else lambda x: product(x, x)
    for x, xl, y, yl in zip(*pairs_of(4), *pairs_of(5), strict=True):
        exact = [Fraction(v) for v in (x, xl, y, yl)]
        left, right = (np.float64(x), np.float64(xl)), (np.float64(y), np.float64(yl))
        assert same(ROCQ["add"](ROCQ[two_sum], *exact), module.add(left, right)), (left, right)
        assert same(ROCQ["multiply"](product, *exact), module.multiply(left, right)), (left, right)
        assert same(ROCQ["multiply_float"](product, *exact[:3]), module.multiply_float(left, right[0])), (left, right)
        assert same(ROCQ["divide"](product, *exact), module.divide(left, right)), (left, right)
        assert same(ROCQ["square"](square, *exact[:2]), module.square(left)), left


def test_the_bits_that_are_split():
    """``masked_bits`` as Rocq has it, of the bits of a number, are those of the half that JAX takes."""
    assert "Z.land (bits + 2 ^ 26) (- 2 ^ 27)" in TEXTS["Splitting"]
    assert "IZR (2 ^ 52 + bits mod 2 ^ 52) * pow2 (bits / 2 ^ 52 - 1075)" in TEXTS["Splitting"]

    def number_of_bits(bits):
        return Fraction(2**52 + bits % 2**52) * Fraction(2) ** (bits // 2**52 - 1075)

    for a in [*np.abs(doubles(6, 200))[:60], 1.0, np.nextafter(2.0, 0.0), 2.2250738585072014e-308]:
        bits = int(np.float64(a).view(np.int64))
        high = number_of_bits((bits + 2**26) & -(2**27))
        assert number_of_bits(bits) == Fraction(a)
        assert jax_halves(a) == (float(high), float(Fraction(a) - high))
        assert jax_halves(-a) == (-float(high), -float(Fraction(a) - high))


@pytest.mark.parametrize("old, new", [("let t := rnd (t - a) in", "let t := rnd (a - t) in"),
                                      ("(s, rnd (e - t))", "(s, rnd (e + t))"),
                                      ("let s := rnd (a + b) in", "let s := a + b in")])  # fmt: skip
def test_another_order_is_noticed(old, new):
    changed = TEXTS["Sums"].replace(old, new, 1)
    assert changed != TEXTS["Sums"]
    broken = functions(changed)["numpy_two_sum"]
    found = [same(broken(Fraction(x), Fraction(y)), dd.two_sum(np.float64(x), np.float64(y)))
             for x, y in zip(doubles(1, 30), doubles(2, 30), strict=True)]  # fmt: skip
    assert not all(found)


def test_errors_keep_within_the_bounds_and_use_much_of_them():
    """Measured against exact fractions; a bound that were ten times too large would say little."""
    u = Fraction(1, 2**53)
    worst = dict.fromkeys(("multiply", "divide", "add"), Fraction(0))
    for x, xl, y, yl in zip(*pairs_of(7), *pairs_of(8), strict=True):
        left, right = (np.float64(x), np.float64(xl)), (np.float64(y), np.float64(yl))
        a, b = Fraction(x) + Fraction(xl), Fraction(y) + Fraction(yl)
        operands = abs(Fraction(x)) + abs(Fraction(y))
        sizes = {"multiply": (a * b, abs(a * b)), "divide": (a / b, abs(a / b)), "add": (a + b, operands)}
        for name, (exact, size) in sizes.items():
            high, low = getattr(dd, name)(left, right)
            worst[name] = max(worst[name], abs(Fraction(float(high)) + Fraction(float(low)) - exact) / size / u**2)
    bounds = {"multiply": 9, "divide": 16, "add": 6}
    assert all(bounds[name] / 10 < worst[name] <= bounds[name] for name in bounds), worst


def test_all_definitions_are_read():
    """A definition that the reader passed over would be compared with nothing."""
    named = {"numpy_two_sum", "kernel_two_sum", "fast_two_sum", "numpy_high", "numpy_low", "numpy_two_product", "add",
             "numpy_two_square", "fused_two_product", "product_by_halves", "jax_sum_of_partial_products", "multiply",
             "jax_two_product", "multiply_float", "square", "divide"}  # fmt: skip
    assert named <= {name for text in TEXTS.values() for name in definitions(text)}
