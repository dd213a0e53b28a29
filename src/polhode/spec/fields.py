"""The types of value in a spec: each converts to SI, and its error gives the expected form."""

from __future__ import annotations

import math
import sys
from collections.abc import Callable
from typing import Annotated, Any, Literal

import numpy as np
from pydantic import AfterValidator, BeforeValidator, Field, StrictBool, StrictInt

from polhode import rotation
from polhode.errors import shown
from polhode.spec.units import find_example, parse_quantity, parse_spectroscopic

LARGEST = sys.float_info.max
UNIT = "unit"  # attribute of validators that read quantities


def mark_unit(unit: str) -> Callable[[Callable[[Any], Any]], Callable[[Any], Any]]:
    """Attach to a validator the SI unit of the numbers that it returns, "" for plain ones; see ``spec.keys``."""

    def mark(read: Callable[[Any], Any]) -> Callable[[Any], Any]:
        setattr(read, UNIT, unit)
        return read

    return mark


def quantity(unit: str, *, positive: bool = False) -> BeforeValidator:
    """Return the validator by which a field takes quantities in any unit: a text like "3 N/m" becomes a number in SI.

    Args:
        unit: in SI, as Pint reads it.
        positive: whether zero and less are refused.

    >>> from typing import Annotated
    >>> from pydantic import TypeAdapter
    >>> TypeAdapter(Annotated[float, quantity("N/m")]).validate_python("2 mN/m")
    0.002
    """

    @mark_unit(unit)
    def read(value: Any) -> float:
        number = parse_quantity(value, unit)
        if positive and not number > 0:
            raise ValueError(f"must be positive; got {shown(value)}. Check number and unit")
        return number

    return BeforeValidator(read)


def _radius(value: Any) -> Any:
    number = parse_quantity(value, "m")
    if not number > 0:
        remedy = 'A point mass is shape = "point", a thin rod shape = "rod"' if number == 0 else "Check number and unit"
        raise ValueError(f"must be positive; got {shown(value)}. {remedy}")
    return value


def _outline(value: Any) -> Any:
    if not isinstance(value, list) or not all(isinstance(one, list) and len(one) == 2 for one in value):
        raise ValueError(
            f'must be a list of corners, like [["0 mm", "0 mm"], ["20 mm", "0 mm"], …]; got {shown(value)}'
        )
    return value


def _joint(value: Any) -> tuple[float, str]:
    """Return the position of a joint with its SI unit: an angle or a distance, which the kind of joint must fit."""
    for unit in ("rad", "m"):
        try:
            return parse_quantity(value, unit), unit
        except ValueError:
            continue
    raise ValueError(f'must be an angle like "30 deg" or a distance like "10 cm"; got {shown(value)}')


def _joints(value: Any) -> Any:
    if isinstance(value, dict):
        return value
    raise ValueError(f'must be a table of positions, like {{ elbow = "30 deg" }}; got {shown(value)}')


def _digits(value: Any) -> int:
    """Return how many digits a text like "6 digits" says."""
    number, _, word = str(value).partition(" ")
    if not isinstance(value, str) or word not in ("digits", "digit") or not (number.isascii() and number.isdigit()):
        raise ValueError(f'must say how many significant digits were kept, like "6 digits"; got {shown(value)}')
    if not 3 <= int(number[:3]) <= 15:
        raise ValueError(f"must be from 3 to 15 digits; got {shown(value)}. Fewer say nothing about a body")
    return int(number)


def three(unit: str) -> BeforeValidator:
    """Return a check for three quantities in a list; its message has an example."""
    example = find_example(unit)

    def check(value: Any) -> Any:
        if not isinstance(value, list) or len(value) != 3:
            raise ValueError(f'needs three quantities in a list, like ["{example}", "{example}", "{example}"]; '
                             f"got {shown(value)}")
        return value

    return BeforeValidator(check)


def _rows(value: Any) -> Any:
    if not isinstance(value, list) or len(value) != 3:
        raise ValueError(f"needs three rows of three moments each, [[…], […], […]]; got {shown(value)}")
    return value


def _mesh_unit(value: Any) -> float:
    wrong = ValueError(f'must be a unit of length alone, in quotes, like "mm"; got {shown(value)}')
    if not isinstance(value, str) or not value or any(c.isdigit() for c in value):
        raise wrong
    try:
        return parse_quantity(f"1 {value}", "m")
    except ValueError:
        raise wrong from None


def is_number(value: Any) -> bool:
    """Whether a value is a plain number in the range of doubles; whole numbers in TOML may have any size."""
    return type(value) in (int, float) and -LARGEST <= value <= LARGEST


@mark_unit("")
def _attitude(value: Any) -> tuple[float, ...]:
    """Return the quaternion (4,) of an attitude in any of its three forms."""
    if isinstance(value, dict):
        forms = {("angles", "sequence"): _by_euler_angles, ("angle", "axis"): _by_axis_and_angle}
        form = forms.get(tuple(sorted(value)))
        if form is None:
            raise ValueError(
                'must be a quaternion [w, x, y, z], { sequence = "ZXZ", angles = ["10 deg", "20 deg", "30 deg"] } or '
                f'{{ axis = [0, 0, 1], angle = "30 deg" }}; got a table with {", ".join(sorted(value)) or "nothing"}'
            )
        return form(value)
    plain = isinstance(value, list) and len(value) == 4 and all(map(is_number, value))
    if not plain or not any(value):
        raise ValueError(f"must be a quaternion [w, x, y, z] of four plain numbers, not all zero; got {shown(value)}")
    return tuple(float(x) for x in value)


def _by_euler_angles(table: dict[str, Any]) -> tuple[float, ...]:
    """Return the turns about the body's own axes, one after the other (capitals), or about those of space."""
    sequence, angles = table["sequence"], table["angles"]
    if not isinstance(angles, list) or len(angles) != 3:
        raise ValueError(f'angles must be three, like ["10 deg", "20 deg", "30 deg"]; got {shown(angles)}')
    sizes = [_within_turns(angle) for angle in angles]
    return tuple(rotation.from_euler_angles(sizes, str(sequence)).tolist())


def _within_turns(value: Any) -> float:
    """Return an angle [rad], less whole turns where there are many of them."""
    angle = parse_quantity(value, "rad")
    return angle if abs(angle) < 4.0 * math.pi else math.remainder(angle, 2.0 * math.pi)


def _by_axis_and_angle(table: dict[str, Any]) -> tuple[float, ...]:
    axis = np.array(_direction(table["axis"]))
    axis = axis / np.abs(axis).max()  # squares of extreme lengths overflow
    angle = _within_turns(table["angle"])
    return tuple(rotation.from_rotation_vector(angle * axis / np.linalg.norm(axis)).tolist())


@mark_unit("")
def _direction(value: Any) -> tuple[float, ...]:
    good = isinstance(value, list) and len(value) == 3 and all(map(is_number, value))
    if not good or not any(value):
        raise ValueError(f"must be a direction [x, y, z] of three plain numbers, not all zero; got {shown(value)}")
    return tuple(float(x) for x in value)


@mark_unit("")
def _plain(value: Any) -> float:
    if not is_number(value):
        raise ValueError(f"must be a plain finite number, without unit or quotes; got {shown(value)}")
    return float(value)


def within(least: float, most: float, what: str) -> Callable[[float], float]:
    """Return a check of bounds; its message names the quantity."""

    def check(value: float) -> float:
        if not least <= value <= most:
            raise ValueError(f"must be from {least:g} to {most:.6g}, {what}; got {shown(value)}. Check it")
        return value

    return check


def _ruled(holds: Callable[[float], bool], rule: str, written: Callable[[float], str], remedy: str) -> AfterValidator:
    """Return a check of a number that has been read, whose message says the rule, the number and the remedy."""

    def check(value: float) -> float:
        if not holds(value):
            raise ValueError(f"must {rule}; got {written(value)}. {remedy}")
        return value

    return AfterValidator(check)


def _in_degrees(value: float) -> str:
    """Return an angle [rad] in degrees; in radians where that many degrees overflow."""
    angle = math.degrees(value)
    return f"{angle:g} deg" if math.isfinite(angle) else f"{value:g} rad"


@mark_unit("Hz")
def _rotational_constant(value: Any) -> float:
    number = parse_spectroscopic(value)
    if not number > 0:
        raise ValueError(f"must be positive; got {shown(value)}. Check number and unit")
    return number


@mark_unit("Hz")
def _spectroscopic(value: Any) -> float:
    return parse_spectroscopic(value)


def _constants(value: Any) -> Any:
    if isinstance(value, list) and len(value) == 1:
        return [value[0]]
    if not isinstance(value, list) or len(value) != 3:
        raise ValueError('needs three constants A ≥ B ≥ C in a list, like ["835.8 GHz", "435.4 GHz", "278.1 GHz"], or '
                         f"one, of a linear molecule; got {shown(value)}")
    return value


@mark_unit("rad/s")
def _precession(value: Any) -> float | str:
    if isinstance(value, str) and value in ("slow", "fast"):
        return value
    if value == "steady":
        raise ValueError('must say which of the two steady precessions: "slow", the usual one, or "fast"')
    try:
        return parse_quantity(value, "rad/s")
    except ValueError as error:
        raise ValueError(f'{error}; or "slow" or "fast", for steady precession') from None


def not_zero(value: float) -> float:
    if value == 0.0:
        raise ValueError("must not be zero; leave it out, or give another number")
    return value


def one_of(*choices: str | int) -> BeforeValidator:
    """Accept one of the choices exactly: 2, but neither 2.0 nor true in its place."""
    known = ", ".join(str(c) if isinstance(c, int) else f'"{c}"' for c in choices)

    def check(value: Any) -> Any:
        if not any(value == c and type(value) is type(c) for c in choices):
            raise ValueError(f"must be one of {known}; got {shown(value)}")
        return value

    return BeforeValidator(check)


Mass = Annotated[float, quantity("kg", positive=True)]
Density = Annotated[float, quantity("kg/m^3", positive=True)]
Length = Annotated[float, quantity("m", positive=True)]
Radius = Annotated[float, quantity("m", positive=True), BeforeValidator(_radius)]
Rate = Annotated[float, quantity("rad/s")]
PositiveRate = Annotated[float, quantity("rad/s", positive=True)]
Precession = Annotated[float | Literal["slow", "fast"], BeforeValidator(_precession)]
Angle = Annotated[float, quantity("rad")]
Duration = Annotated[float, quantity("s", positive=True)]
Coordinate = Annotated[float, quantity("m")]
Moment = Annotated[float, quantity("kg*m^2")]
NotNegative = Annotated[
    Moment, _ruled(lambda x: x >= 0.0, "not be negative", "{:g} kg m²".format, "Check its sign")
]
MomentumComponent = Annotated[float, quantity("kg*m^2/s")]
Corner = tuple[Coordinate, Coordinate]
Outline = Annotated[list[Corner], Field(min_length=3), BeforeValidator(_outline)]
Joints = Annotated[dict[str, Annotated[tuple[float, str], BeforeValidator(_joint)]], BeforeValidator(_joints)]
Sides = Annotated[StrictInt, Field(ge=3, le=10_000)]
Digits = Annotated[int, BeforeValidator(_digits)]
Lengths = Annotated[tuple[Length, Length, Length], three("m")]
Position = Annotated[tuple[Coordinate, Coordinate, Coordinate], three("m")]
Moments = Annotated[tuple[NotNegative, NotNegative, NotNegative], three("kg*m^2")]
InertiaRow = Annotated[tuple[Moment, Moment, Moment], three("kg*m^2")]
three_rows = BeforeValidator(_rows)
Inertia = Annotated[tuple[InertiaRow, InertiaRow, InertiaRow], three_rows]
RotationalConstant = Annotated[float, BeforeValidator(_rotational_constant)]
RotationalConstants = Annotated[tuple[RotationalConstant, RotationalConstant, RotationalConstant], three("1/m")]
SpectroscopicConstant = Annotated[float, BeforeValidator(_spectroscopic)]
RotorConstants = Annotated[tuple[RotationalConstant, ...], BeforeValidator(_constants)]  # one or three
DipoleComponent = Annotated[float, quantity("C*m")]
Dipole = Annotated[tuple[DipoleComponent, DipoleComponent, DipoleComponent], three("C*m")]
Temperature = Annotated[float, quantity("K", positive=True)]
Momentum = Annotated[tuple[MomentumComponent, MomentumComponent, MomentumComponent], three("kg*m^2/s")]
Rates = Annotated[tuple[Rate, Rate, Rate], three("rad/s")]
MeshUnit = Annotated[float, BeforeValidator(_mesh_unit)]
Attitude = Annotated[tuple[float, float, float, float], BeforeValidator(_attitude)]
Flag = StrictBool
Direction = Annotated[tuple[float, float, float], BeforeValidator(_direction)]
Acceleration = Annotated[float, quantity("m/s^2", positive=True)]
Torque = Annotated[float, quantity("N*m")]
PositiveTorque = Annotated[float, quantity("N*m", positive=True)]
BearingFriction = Annotated[
    float, quantity("N*m*s"),
    _ruled(lambda x: x >= 0.0, "not be negative", "{:g} N m s".format, "Friction is given without a sign"),
]
NutationLoss = Annotated[float, quantity("W/rad^2", positive=True)]
LinearDragCoefficient = Annotated[float, quantity("N*m*s", positive=True)]
QuadraticDragCoefficient = Annotated[float, quantity("N*m*s^2", positive=True)]
PositiveMoment = Annotated[float, quantity("kg*m^2", positive=True)]
Plain = Annotated[float, BeforeValidator(_plain)]
Samples = Annotated[StrictInt, Field(ge=2, le=10_000_000)]
PositivePlain = Annotated[
    Plain, _ruled(lambda x: x > 0.0, "be positive", "{:g}".format, "Check its sign, or leave it out")
]
GravitationalParameter = Annotated[float, quantity("m^3/s^2", positive=True)]
Eccentricity = Annotated[Plain, AfterValidator(within(0.0, 0.99, "an ellipse that is not almost a line"))]
Asphericity = Annotated[Plain, AfterValidator(within(0.0, math.sqrt(3.0), "√(3(B − A)/C), as B − A ≤ C"))]
SpinRatio = Annotated[Plain, AfterValidator(within(-30.0, 30.0, "turns per orbit, where resonances may be felt"))]
Orbits = Annotated[StrictInt, Field(ge=1, le=100_000)]
Thickness = Annotated[
    float, quantity("m"),
    _ruled(lambda x: x >= 0.0, "not be negative", "{:g} m".format, "Check its sign, or leave it out for a thin disk"),
]
Lean = Annotated[
    Angle, _ruled(lambda x: 0.0 <= x <= math.pi * (1.0 + 1e-15), "lie from 0 to 180 deg", _in_degrees, "Check it")
]
RacketTilt = Annotated[
    Angle,
    _ruled(lambda x: 0.0 <= x <= math.radians(85.0), "be from 0 to 85 deg", _in_degrees, "At 90 L is on another axis"),
]
Tilt = Annotated[
    Angle, _ruled(
        lambda x: 0.0 < x < math.pi, "lie between 0 and 180 deg", _in_degrees, "A disk that lies flat touches with all "
        "of its face and does not roll: start at a small tilt, such as 5 deg",
    )
]
Power = Annotated[float, quantity("W", positive=True)]
Viscosity = Annotated[float, quantity("Pa*s", positive=True)]
Speed = Annotated[float, quantity("m/s")]
Energy = Annotated[float, quantity("J")]
MagneticFlux = Annotated[float, quantity("T")]
MagneticField = Annotated[tuple[MagneticFlux, MagneticFlux, MagneticFlux], three("T")]
Latitude = Annotated[
    Angle,
    _ruled(lambda x: abs(x) <= 0.5 * math.pi * (1.0 + 1e-15), "lie from -90 to 90 deg", _in_degrees, "Check it"),
]
Circulation = Annotated[float, quantity("m^2/s"), AfterValidator(not_zero)]
Velocity = Annotated[tuple[Speed, Speed, Speed], three("m/s")]
