"""Checks of arguments: what each lets through, what it refuses, and the sentence that says so."""

from decimal import Decimal
from fractions import Fraction

import jax
import jax.numpy as jnp
import numpy as np
import pytest

import polhode.algebra  # noqa: F401  switches on float64
from polhode import systems
from polhode._base import check
from polhode.errors import FormatError, InvalidInput

pytestmark = pytest.mark.usefixtures("any_type")
NO_NUMBERS = [True, np.True_, None, "1", b"1", 1j, np.complex128(1), np.array(1j), [1.0], np.ones(1), [[1], [2, 3]],
              np.datetime64("2026-01-01"), np.float32(1), np.float16(1), jnp.float32(1),
              np.array(True), np.array("5"), np.timedelta64(5, "s"), 10**400, Fraction(10**400),
              Decimal("1e99999999"), float("nan"), float("inf"), -np.inf, {}]  # fmt: skip


def said(function, *arguments, **options):
    with pytest.raises(InvalidInput) as refused:
        function("x", *arguments, **options)
    return str(refused.value)


@pytest.mark.parametrize("value", NO_NUMBERS, ids=lambda value: f"{type(value).__name__}-{str(value)[:9]}")
def test_what_is_no_number_is_refused_by_name(value):
    assert said(check.number, value).startswith("`x` must be ")
    assert said(check.number, value, above=-1e300).startswith("`x` must be ")


@pytest.mark.parametrize(
    "value", [1, 1.0, np.float64(1), np.int8(1), np.array(1), np.array(1.0), jnp.float64(1), Fraction(1), Decimal(1)]
)
def test_a_number_comes_back_as_a_float(value):
    assert type(check.number("x", value)) is float and check.number("x", value) == 1.0


def test_all_digits_of_a_number_stay():
    for value in (np.nextafter(0, 1), np.nextafter(1, 2), 2**53 - 1, Fraction(1, 3), -1.7976931348623157e308):
        assert check.number("x", value) == float(value)


@pytest.mark.parametrize(("bounds", "good", "bad", "rule"), [
    ({}, (-1e308, 0), (np.inf,), "a finite number"),
    ({"above": 0}, (5e-324,), (0, -0.0, -1, np.inf, np.nan), "positive and finite"),
    ({"above": 0, "infinite": True}, (1, np.inf), (0, -np.inf, np.nan), "positive"),
    ({"least": 0}, (0, -0.0, 1), (-5e-324, np.inf, np.nan), "finite and not negative"),
    ({"above": 0, "below": 1}, (0.5,), (0, 1), "between 0 and 1"),
    ({"least": 0, "most": 1}, (0, 1), (-1, 1.1), "from 0 to 1"),
    ({"least": 0, "below": 1}, (0,), (1,), "at least 0 and below 1"),
    ({"above": 0, "most": 1}, (1,), (0,), "above 0 and at most 1"),
    ({"least": 3}, (3,), (2.9, np.inf), "a finite number at least 3"),
    ({"most": 3, "infinite": True}, (3, -np.inf), (3.1, np.inf), "a number at most 3"),
    ({"least": 0, "infinite": True}, (0, np.inf), (-1,), "a number that is not negative"),
    ({"above": 0, "rule": "a period"}, (1,), (0,), "a period"),
])  # fmt: skip
def test_bounds_and_their_words(bounds, good, bad, rule):
    assert [check.number("x", value, **bounds) for value in good] == list(good)
    for value in bad:
        message = said(check.number, value, "s", remedy="Look.", **bounds)
        assert message == f"`x` must be {rule} [s]; got {value!r}. Look."


@pytest.mark.parametrize("value", [True, np.True_, 2.0, np.float64(2), "2", None, Fraction(2), [2], np.array([2]),
                                   np.timedelta64(2, "s")],
                         ids=repr)  # fmt: skip
def test_what_is_no_whole_number_is_refused(value):
    assert said(check.whole, value).startswith("`x` must be a whole number; got ")


def test_whole_numbers_and_their_bounds():
    assert [check.whole("x", n, 1, 2000) for n in (1, np.int64(2000))] == [1, 2000]
    assert type(check.whole("x", np.int8(3))) is int
    assert said(check.whole, 0, 1) == "`x` must be a whole number, at least 1; got 0."
    assert said(check.whole, 3, most=2) == "`x` must be a whole number, at most 2; got 3."
    got = said(check.whole, 2001, 1, 2000, what="lines", remedy="Look.")
    assert got == "`x` must be a whole number of lines from 1 to 2,000; got 2001. Look."
    assert "bits" in said(check.whole, 10**5000, 1, 9)


def test_objects_of_a_class():
    assert check.instance("x", 1, int, "a whole number") == 1
    assert said(check.instance, "1", (int, float), "a number", "Go.") == "`x` must be a number; got '1'. Go."


def test_words():
    assert check.one_of("x", "b", {"a": 1, "b": 2}) == "b"
    assert said(check.one_of, "c", ("a", "b")) == "`x` must be \"a\" or \"b\"; got 'c'."
    assert said(check.one_of, ["a"], "abc", "Choose.") == '`x` must be one of "a", "b", "c"; got [\'a\']. Choose.'
    with pytest.raises(FormatError, match=r"^f\.toml, line 3: its type must be"):
        check.one_of("f.toml, line 3: its type", "c", ("a", "b"), error=FormatError)


@pytest.mark.parametrize(("shape", "good", "bad", "rule"), [
    ((3,), [1, 2, 3], [1, 2], "three finite numbers"),
    ((7,), range(7), [1], "7 finite numbers"),
    ((), 3, [3], "a finite number"),
    (("T",), [], [[1]], "finite numbers of shape (T,)"),
    (("n", 3), [[1, 2, 3]], [1, 2, 3], "finite numbers of shape (n, 3)"),
    (("n", "n"), np.eye(4), np.ones((3, 4)), "finite numbers of shape (n, n)"),
    (("…", 3), np.ones((4, 2, 3)), np.ones((3, 2)), "finite numbers of shape (…, 3)"),
    (("…", 3), [1, 2, 3], 1.0, "finite numbers of shape (…, 3)"),
    (("…", 2, 3), np.ones((2, 3)), np.ones(3), "finite numbers of shape (…, 2, 3)"),
])  # fmt: skip
def test_shapes_and_their_words(shape, good, bad, rule):
    values = check.array("x", good, shape)
    assert values.dtype == np.float64 and values.shape == np.shape(good) and (values == np.asarray(good)).all()
    assert said(check.array, bad, shape, "m") == f"`x` must be {rule} [m]; got shape {np.shape(bad)}."


def test_numbers_of_arrays_and_their_words():
    assert said(check.array, [1, np.nan]) == "`x` must be finite numbers; got [1, nan]."
    assert said(check.array, -1.0, above=0) == "`x` must be positive finite numbers; got -1.0."
    assert said(check.array, [0, 1], above=0) == "`x` must be positive finite numbers; got [0, 1]."
    assert said(check.array, [-1, 1], least=0) == "`x` must be finite numbers, not negative; got [-1, 1]."
    assert said(check.array, [1, 1], (2,), least=2) == "`x` must be two finite numbers at least 2; got [1, 1]."
    assert said(check.array, [1], above=2).startswith("`x` must be finite numbers above 2;")
    assert said(check.array, np.zeros(3), (3,), not_all_zero=True).startswith("`x` must be three finite numbers, not a")
    assert said(check.array, np.zeros(30), not_all_zero=True).endswith("got zeros alone.")
    assert said(check.array, [*range(20), np.inf]).endswith("got inf at index 20.")
    assert said(check.array, [[*range(9), -2]] * 3, above=-1).endswith("got -2 at index (0, 9).")
    assert said(check.array, [1, 3, 2], (3,), above=0, ascending=True).startswith(
        "`x` must be three positive finite numbers in ascending order; got"
    )
    assert check.array("x", [0, 0], least=0, ascending=True).tolist() == [0, 0]


@pytest.mark.parametrize("value", ["1", [1, None], [1, "2"], [1j], np.ones(2, np.float32), [10**400], [[1], [2, 3]],
                                   np.array(["2026-01-01"], "M8[s]"), jnp.ones(2, jnp.float32)], ids=repr)  # fmt: skip
def test_what_is_no_array_of_doubles_is_refused_by_name(value):
    assert said(check.array, value).startswith("`x` must be ")


def test_an_array_is_not_copied_and_becomes_numpys_unless_it_may_be_traced():
    values = np.arange(3.0)
    assert check.array("x", values) is values
    assert isinstance(check.array("x", jnp.arange(3.0)), np.ndarray)
    assert isinstance(check.array("x", jnp.arange(3.0), traced=True), jax.Array)


def test_traced_numbers():
    """They are refused by name; where they may pass, their shapes are known."""
    for function in (check.number, check.whole, check.array):
        with pytest.raises(InvalidInput, match="`x` must be"):
            jax.jit(lambda value, function=function: function("x", value))(1.0)
    traced = jax.jit(lambda value: check.array("x", value, (3,), above=0, traced=True) * 2)
    assert traced(-np.ones(3)).tolist() == [-2, -2, -2]
    with pytest.raises(InvalidInput, match=r"three positive finite numbers; got shape \(2,\)"):
        traced(np.ones(2))


@pytest.mark.parametrize(
    "value", [[True, True, 1], np.array([True, False, True]), [np.complex128(1j), 2, 3], [1j, 0, 0]]
)
def test_truth_values_and_complex_numbers_are_no_numbers_of_an_array(value):
    assert said(check.array, value, (3,)).startswith("`x` must be three finite numbers; got ")


def test_traced_numbers_are_told_what_they_are():
    with pytest.raises(InvalidInput, match="`x` must be a known number, not one traced by JAX; got a traced one"):
        jax.jit(lambda x: check.number("x", x, remedy="Outside."))(1.0)


def test_bounds_are_written_in_the_digits_that_they_need():
    assert said(check.number, 1.0, above=1.0000002) == "`x` must be a finite number above 1.0000002; got 1.0."
    assert said(check.number, np.float64(-1.0), above=0) == "`x` must be positive and finite; got -1.0."


def test_numbers_of_systems_are_not_weakly_typed():
    """JAX would compile again for a strongly typed one, and compute with it in single precision."""
    assert not systems.HeavyTop((1.0, 2.0, 3.0), 2).mgl.weak_type
