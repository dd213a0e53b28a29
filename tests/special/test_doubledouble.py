"""Double-double arithmetic against exact rationals, in NumPy and under XLA's contractions."""

from fractions import Fraction

import jax
import numpy as np
import pytest

from polhode.special import _doubledouble as dd

BOUND = Fraction(1, 2**100)
"""About 8e-31; the operations promise 1e-31 or better."""


def exact(pair, k):
    return Fraction(float(np.asarray(pair[0])[k])) + Fraction(float(np.asarray(pair[1])[k]))


def numbers(seed, count=300):
    rng = np.random.default_rng(seed)
    high = rng.uniform(0.5, 2.0, count) * 2.0 ** rng.integers(-40, 40, count)
    return high, high * rng.uniform(-1.0, 1.0, count) * 2.0**-54


def relative(found, wanted):
    return abs(found - wanted) / abs(wanted)


@pytest.mark.parametrize("engine", ["numpy", "jax"])
@pytest.mark.parametrize(
    ("operation", "law"),
    [
        (dd.add, lambda x, y: x + y),
        (dd.multiply, lambda x, y: x * y),
        (dd.divide, lambda x, y: x / y),
        (lambda x, y: dd.square(x), lambda x, y: x * x),
        (lambda x, y: dd.multiply(dd.divide(dd.square(x), y), x), lambda x, y: x**3 / y),
    ],
)
def test_operations_keep_thirty_digits(engine, operation, law):
    x, y = numbers(1), numbers(2)
    if engine == "jax":
        with jax.enable_x64(True):
            found = jax.jit(operation)(tuple(map(jax.numpy.asarray, x)), tuple(map(jax.numpy.asarray, y)))
    else:
        found = operation(x, y)
    worst = max(relative(exact(found, k), law(exact(x, k), exact(y, k))) for k in range(len(x[0])))
    assert worst < BOUND


@pytest.mark.parametrize("engine", ["numpy", "jax"])
def test_products_are_exact(engine):
    a, b = numbers(3)[0], numbers(4)[0]
    if engine == "jax":
        with jax.enable_x64(True):
            found = jax.jit(dd.two_product)(jax.numpy.asarray(a), jax.numpy.asarray(b))
    else:
        found = dd.two_product(a, b)
    assert all(exact(found, k) == Fraction(a[k]) * Fraction(b[k]) for k in range(len(a)))


def test_a_product_without_its_error_is_caught():
    a, b = numbers(3)[0], numbers(4)[0]
    broken = (a * b, 0.0 * a)
    assert any(exact(broken, k) != Fraction(a[k]) * Fraction(b[k]) for k in range(len(a)))


def test_square_root_squares_back():
    x = numbers(5)
    root = dd.sqrt(x)
    assert max(relative(exact(root, k) ** 2, exact(x, k)) for k in range(len(x[0]))) < BOUND
    assert dd.sqrt((np.zeros(1), np.zeros(1)))[0] == 0.0


@pytest.mark.parametrize("engine", ["numpy", "jax"])
def test_sums_survive_cancellation(engine):
    rng = np.random.default_rng(6)
    terms = [rng.uniform(1.0, 2.0, 50) * 2.0**e for e in (0, -50, -110, -160)]
    terms = (*terms, *(-t for t in terms[:3]))
    if engine == "jax":
        with jax.enable_x64(True):
            found = jax.jit(dd.distil)(tuple(map(jax.numpy.asarray, terms)))
    else:
        found = dd.distil(terms)
    for k in range(50):
        assert exact(found, k) == sum(Fraction(float(t[k])) for t in terms)
