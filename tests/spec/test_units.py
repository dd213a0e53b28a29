"""Quantities as people write them, in SI; and what is refused."""

import math

import pytest

from polhode.spec.units import parse_quantity

TURN = 2.0 * math.pi


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
    ],
)
def test_what_is_refused(value, unit, words):
    with pytest.raises(ValueError, match=words):
        parse_quantity(value, unit)
