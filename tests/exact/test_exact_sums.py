"""Words of exact sums by rational numbers, in every arithmetic; and the invariants of tops that are made of them."""

from fractions import Fraction
from math import prod

import numpy as np
import pytest

from polhode.exact import _kernel_arithmetic as words
from polhode.exact._array_arithmetic import FOR_ARRAYS
from polhode.exact.lagrange_top import _formulas_reduction as formulas
from twins.families_of_tops import draw_tops

CANCELLED = 2.0**-200
"""What is left of the sums here; of double-double alone nothing would be."""
SHARP = 2.0**-104
"""Relative error of a double-double number."""
LOST = 2.0**-90
"""Of an invariant, which ``NEAR`` allows double-double to lose 10 of 104 places of, and a few roundings."""


def sums(count=60):
    """Yield sums of 3 to 48 terms of any size, of which most cancel."""
    rng = np.random.default_rng(5)
    for _ in range(count):
        terms = (rng.normal(size=rng.integers(1, 24)) * 2.0 ** rng.integers(-40, 40)).tolist()
        yield (*terms, *(-x for x in rng.permutation(terms).tolist()), rng.normal() * CANCELLED)


def exactly(terms):
    return sum(map(Fraction, terms))


def is_sharp(found, wanted, error):
    return abs(exactly(found) - wanted) <= error * abs(wanted)


def test_sums_and_products_are_exact():
    for x, y in zip(sums(), sums(), strict=True):
        factor = y[0]
        assert exactly(words.join(x, y)) == exactly(x) + exactly(y)
        assert exactly(words.negated(x)) == -exactly(x)
        assert exactly(words.multiply_terms(x, factor)) == exactly(x) * Fraction(factor)


@pytest.mark.parametrize("count", [4, 5, 6])
def test_compressed_sums_have_so_many_terms_and_digits(count):
    for x in sums():
        found = words.compress(x, count)
        assert len(found) == min(count, len(x))
        assert is_sharp(found, exactly(x), 2.0 ** (-52 * (count - 1)))
    assert not any(words.compress((1.0, *x, *words.negated(x), -1.0), count)[0] for x in sums())


def test_distilled_sums_are_sharp_whatever_cancels():
    assert all(is_sharp(words.distil(x), exactly(x), SHARP) for x in sums())


def test_too_few_sweeps_are_noticed(monkeypatch):
    monkeypatch.setattr(words, "SWEEPS", 1)
    assert not all(is_sharp(words.distil(x), exactly(x), SHARP) for x in sums())


def calls():
    """Yield words and what they are given."""
    for x in sums():
        yield "join", (x, x[:3])
        yield "negated", (x,)
        yield "multiply_terms", (x, x[0])
        yield "compress", (x, 4)
        yield "distil", (x,)


def test_arrays_have_the_same_bits():
    for name, (x, *more) in calls():
        array = lambda value: tuple(map(np.array, value)) if isinstance(value, tuple) else value  # noqa: E731
        found = FOR_ARRAYS[name](tuple(np.array([term, -term]) for term in x), *map(array, more))
        assert [np.ravel(part)[0] for part in found] == list(getattr(words, name)(x, *more)), name


@pytest.mark.long
def test_compiled_code_has_the_same_bits():
    numba = pytest.importorskip("numba")
    from polhode.exact._compiled_arithmetic import FOR_NUMBA

    join, negated, multiply_terms, compress, distil = (
        FOR_NUMBA[name] for name in ("join", "negated", "multiply_terms", "compress", "distil")
    )

    @numba.njit
    def run(x, factor):
        product = join(multiply_terms(x, factor), negated(x))
        return product, compress(product, 3), distil(product), compress(x, 9)

    for x in ((1.0, 3.0**0.5, -1.0, 1e-20, 7.1), (1e16, 1.1, -1e16, -1.1, 1e-30)):
        product = words.join(words.multiply_terms(x, 0.1), words.negated(x))
        assert run(x, 0.1) == (product, words.compress(product, 3), words.distil(product), words.compress(x, 9))


# ---------------------------------------------------------------------- invariants of tops


def tops():
    """Yield scaled tops of many families, none with a displacement to be scaled up."""
    for case in draw_tops(12, 3):
        top = formulas.scaled(case.moments, case.mgl, case.momentum, case.attitude)
        if formulas.lifted(top, case.momentum).lift == 0.0:
            yield top


def by_rationals(top):
    """Return c, F and D of a scaled top."""
    w, x, y, z = map(Fraction, top.quaternion)
    l1, l2, l3 = map(Fraction, top.momentum)
    n, g, s = w * w + x * x + y * y + z * z, exactly(top.G), x * x + y * y
    c = (2 * (l2 * (x * w + y * z) + l1 * (x * z - y * w)) - 2 * l3 * s) / n
    energy = l1 * l1 + l2 * l2 - 2 * g * s / n
    return c, energy - c * l3, 2 * g - l3 * l3 - energy


def test_invariants_are_sharp_however_much_cancels():
    """And where double-double is said to do, it does; where it is not, it would not, as near the separatrix."""
    lost, plain = 0, 0
    for top in tops():
        wanted = by_rationals(top)
        exact = formulas.exactly_reduced(top, formulas.size_of(top))
        found, spare = formulas.plainly_reduced(top)
        assert all(is_sharp(x, y, 8 * SHARP) for x, y in zip((exact.c, exact.F, exact.D), wanted, strict=True))
        is_near = all(is_sharp(x, y, LOST) for x, y in zip((found.c, found.F, found.D), wanted, strict=True))
        tiny = prod(abs(x) > 0.0 for x in (*top.momentum, *top.quaternion)) == 0 or spare < 0.0
        assert is_near or tiny
        lost, plain = lost + (not is_near), plain + (spare >= 0.0)
    assert lost > 20 and plain > 100


def test_a_top_that_lies_below_is_turned_and_scaled():
    """By a half turn about the first axis and powers of two, exactly."""
    given = (3.0, 3.0, 1.0), (0.5, -1.0, 40.0), (0.6, 0.0, 0.8, 0.0)
    above, below = (formulas.scaled(given[0], mgl, *given[1:]) for mgl in (7.0, -7.0))
    assert (above.momentum, below.momentum) == ((0.5 / 64, -1.0 / 64, 40.0 / 64), (0.5 / 64, 1.0 / 64, -40.0 / 64))
    assert below.quaternion == (0.0, 0.6, 0.0, -0.8) and above.quaternion == given[2]
    assert (below.reversed, above.reversed, above.momentum_scale, above.rate_scale) == (True, False, 64.0, 16.0)
    assert above.G == below.G == (2 * 7.0 * 3.0 / 64**2, 0.0)


@pytest.mark.parametrize(("exponent", "lift"), [(-200, 0.0), (-201, 51.0)])
def test_displacements_are_scaled_up_below_the_threshold_alone(exponent, lift):
    """To one number whatever they were; exactly at the threshold of sleeping they are dropped."""
    x = 1.5 * 2.0 ** (exponent - 1)
    for l3, kept in ((1.0, 1.0), (2.0, 0.0 if lift else 1.0)):
        given = (1.0, 1.0, 1.0), 1.0, (0.0, 0.0, l3), (1.0, x, 0.0, 0.0)
        top = formulas.reduction(*given)
        assert top.lift == lift * kept
        assert top.quaternion == (1.0, kept * x * 2.0 ** (lift * kept), 0.0, 0.0)
