"""Quantities as people write them, in SI; and what is refused."""

import math
from fractions import Fraction

import pytest

from polhode.spec.units import parse_exactly, parse_quantity

TURN = 2.0 * math.pi
LONGEST = 300  # characters of a message, whatever came


@pytest.mark.parametrize(
    ("text", "unit", "wanted"),
    [
        ("60 rpm", "rad/s", TURN),
        ("1 rev/s", "rad/s", TURN),
        ("60 cpm", "rad/s", TURN),
        ("180 dps", "rad/s", math.pi),
        ("180 deg/s", "rad/s", math.pi),
        ("360 arcsec/s", "rad/s", math.pi / 1800),
        ("-2 rad/s", "rad/s", -2.0),
        ("0.5 turn/day", "rad/s", math.pi / 86400),
        ("12 g*cm^2", "kg*m^2", 1.2e-6),
        ("12 g cm**2", "kg*m^2", 1.2e-6),
        ("12 g·cm²", "kg*m^2", 1.2e-6),
        ("1 u*angstrom^2", "kg*m^2", 1.66053906892e-47),
        ("1 N*m*s", "kg*m^2/s", 1.0),
        ("1 J*s", "kg*m^2/s", 1.0),
        ("2.7 g/cm^3", "kg/m^3", 2700.0),
        ("1 inch", "m", 0.0254),
        ("1 hour", "s", 3600.0),
        ("90 deg", "rad", math.pi / 2),
        ("1e3 g", "kg", 1.0),
        ("2.5kg", "kg", 2.5),
        ("+.5 * kg", "kg", 0.5),
        ("3. m", "m", 3.0),
        ("5 kg/m**3", "kg/m^3", 5.0),
        ("2 rad * s^-1", "rad/s", 2.0),
        ("2 kg m²·s⁻¹", "kg*m^2/s", 2.0),
        ("2 m^(2/1)⋅kg", "kg*m^2", 2.0),
        ("2 kg*(m/s)^2*s", "kg*m^2/s", 2.0),
        ("2 W*s^2.5", "W*s^2.5", 2.0),
        ("2 µg", "kg", 2e-9),
        ("2 N.m", "N*m", 2.0),
        ("180 °", "rad", math.pi),
        ("1e-300 kg", "kg", 1e-300),
        ("0e-999 kg", "kg", 0.0),
    ],
)
def test_values(text, unit, wanted):
    assert parse_quantity(text, unit) == pytest.approx(wanted, rel=1e-9)


@pytest.mark.parametrize(
    ("value", "unit", "words"),
    [
        (60, "rad/s", "unit in quotes"),
        (True, "kg", "unit in quotes"),
        (None, "kg", "unit in quotes"),
        ("60", "kg", "needs a unit"),
        ("1 Hz", "rad/s", "turns or radians"),
        ("1 kHz", "rad/s", "turns or radians"),
        ("1 /s", "rad/s", "names no angle"),
        ("1 m", "kg", "wrong unit"),
        ("nan kg", "kg", "finite"),
        ("1e400 kg", "kg", "finite"),
        ("1e300 yottagram", "kg", "out of range"),
        ("", "kg", "cannot be read"),
        ("kg kg 3 (", "kg", "cannot be read"),
        ("1 blorp", "kg", "not known, 'blorp'"),
        ("1 KG", "kg", "did you mean kg"),
        ("1 sr/s", "rad/s", "names no angle"),
        ("1 kg*m^2*Hz", "kg*m^2/s", "ambiguous"),
        ("60 rpm 2", "rad/s", "cannot be read"),
        ("60 2 rpm", "rad/s", "cannot be read"),
        ("60 + 2 kg", "kg", "cannot be read"),
        ("kg", "kg", "cannot be read"),
        ("2 degC", "kg", "wrong unit|cannot be read"),
        # a power that would be computed for ever, in each way that pint knows to write one
        ("1 kg*m^(9^9^9)", "kg*m^2", "cannot be read"),
        ("1 kg*m^9^9^9", "kg*m^2", "cannot be read"),
        ("1 kg*9**9**9", "kg", "cannot be read"),
        ("1 kg*m**99999999999", "kg", "power beyond 9"),
        ("1 m²²²²", "m", "power beyond 9"),
        ("1 km^(999999999)", "m", "power beyond 9"),
        ("1 (((km^9)^9)^9)^9", "m", "power beyond 9"),
        ("1 kg^1e400", "kg", "cannot be read"),
        ("1 kg^(1/0)", "kg", "cannot be read"),
        ("1 m^1.2.3", "m", "cannot be read"),
        # length
        ("1 " + "k" * 10**6, "kg", "at most 100 characters"),
        ("1 " + "(" * 5000 + "kg" + ")" * 5000, "kg", "at most 100 characters"),
        ("9" * 10**5 + " kg", "kg", "at most 100 characters"),
        ("1 " + "(" * 98, "kg", "cannot be read"),
        # what Python takes for a number, and people do not
        ("2_5 kg", "kg", "cannot be read"),
        ("0x10 kg", "kg", "not known, 'x10'"),
        ("\u0663 kg", "kg", "cannot be read"),
        ("inf", "kg", "finite"),
        (" nan ", "kg", "finite"),
        ("1e999999999 kg", "kg", "finite"),
        ("1e-999999999 kg", "kg", "out of range"),
        ("1e-322 kg", "kg", "out of range"),
        # what pint read past: a comment, a NUL, a second sign
        ("1 kg #x", "kg", "cannot be read"),
        ("1 kg\0", "kg", "cannot be read"),
        ("1 kg//1", "kg", "cannot be read"),
        ("1 kg.__class__", "kg", "cannot be read"),
        ("1 \ud800", "kg", "cannot be read"),
        ("1 \x1b[31mkg", "kg", "cannot be read"),
    ],
)
def test_what_is_refused(value, unit, words):
    with pytest.raises(ValueError, match=words) as caught:
        parse_quantity(value, unit)
    assert len(str(caught.value)) < LONGEST and str(caught.value).isprintable()


@pytest.mark.parametrize(("text", "unit", "exact"), [
    ("0.3 kg*m^2/s", "kg*m^2/s", "3/10"), ("1.2 g*cm^2", "kg*m^2", "12e-8"), ("7 inch", "m", "0.1778"),
    ("-.5e3 rad/s", "rad/s", "-500"),
    ("0.1 h", "s", "360"), ("1 deg", "rad", None), ("60 rpm", "rad/s", None), ("1 deg", "deg", "1"),
])  # fmt: skip
def test_decimals_are_exact_in_units_that_are_decimals(text, unit, exact):
    """The nearest double of 12e-8 is not 12e-8; that of a degree is no degree."""
    assert parse_exactly(text, unit) == (None if exact is None else Fraction(exact))


def test_what_is_no_quantity_has_no_exact_number():
    with pytest.raises(ValueError, match="has the wrong unit"):
        parse_exactly("3 kg", "s")
