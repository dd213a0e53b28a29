"""Distributions of the inputs of a sweep: each turns uniform numbers, or a sample's index, into values.

They serve random and quasi-random points alike: every one is a map from the unit cube, so that values are monotonic
or at least smooth in each of its coordinates.
"""

from __future__ import annotations

import csv
import io
import math
from abc import ABC, abstractmethod
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any, ClassVar, NamedTuple

import numpy as np
from scipy.special import ndtri

from polhode.errors import PolhodeError, shown
from polhode.formats.opening import MB, read_text
from polhode.spec.keys import Number
from polhode.spec.units import QUANTITY, parse_quantity, parse_spectroscopic
from polhode.types import Float64

Values = Float64[np.ndarray, "sample *vector"]
Uniform = Float64[np.ndarray, "sample dimension"]


class DistributionThresholds(NamedTuple):
    """Numbers that decide which distributions are refused.

    Attributes:
        max_table: bytes of a table of values, which is read into memory.
        max_grid_values: along one input.
    """

    max_table: int = 1024 * MB
    max_grid_values: int = 10**6


LIMITS = DistributionThresholds()


class Reader:
    """Reads numbers with units into those of an input; of one whose unit is not known, all in the unit of the first.

    Attributes:
        number: what the input holds.
        unit: of the numbers it gives; "" for plain ones.
    """

    def __init__(self, number: Number) -> None:
        self.number, self.unit = number, number.unit

    def __call__(self, value: Any) -> float:
        """Return a number.

        Raises:
            ValueError: in words.
        """
        if self.unit == "" and self.number.unit == "":
            if isinstance(value, bool) or not isinstance(value, int | float) or not math.isfinite(value):
                raise ValueError(f"must be a plain finite number, without unit or quotes; got {shown(value)}")
            return float(value)
        if self.number.unit is not None:
            own = self.number.unit == "Hz"  # rotational constants, which may be wave numbers; rates are never in Hz
            return parse_spectroscopic(value) if own else parse_quantity(value, self.number.unit)
        parts = QUANTITY.fullmatch(value) if isinstance(value, str) else None
        if parts is None or not math.isfinite(float(parts["number"])):
            raise ValueError(f'needs a number with its unit in quotes, like "2e-7 W*s^2"; got {shown(value)}')
        self.unit = self.unit or parts["unit"]
        if parts["unit"] != self.unit:
            raise ValueError(f'must be in the unit of the other numbers here, {self.unit}; got {shown(value)}')
        return float(parts["number"])

    def difference(self, value: Any) -> float:
        """Return a difference of two numbers: 5 degC are 5 K then, and not 278.15 K.

        Raises:
            ValueError: in words.
        """
        number = self(value)
        parts = QUANTITY.fullmatch(value) if isinstance(value, str) and self.number.unit else None
        return number if parts is None else number - self(f"0 {parts['unit']}")

    def several(self, value: Any, names: tuple[str, ...]) -> list[float]:
        """Return as many numbers as there are names.

        Raises:
            ValueError: in words.
        """
        if not isinstance(value, list) or len(value) != len(names):
            raise ValueError(f"must be a list [{', '.join(names)}]; got {shown(value)}")
        return [self(item) for item in value]


class AbstractDistribution(ABC):
    """The distribution of one input.

    Attributes:
        key: how a spec names it.
        dimensions: how many uniform numbers a sample takes.
        length: of a value, 0 for a number.
    """

    key: ClassVar[str]
    dimensions: ClassVar[int] = 1
    length: int = 0

    @classmethod
    @abstractmethod
    def read(cls, value: Any, reader: Reader, folder: Path) -> AbstractDistribution:
        """Return the distribution that a spec gives.

        Raises:
            ValueError: in words.
        """


class AbstractRandom(AbstractDistribution):
    """One that draws values from uniform numbers in (0, 1)."""

    @abstractmethod
    def values(self, uniform: Uniform) -> Values:
        """Return the values (sample, …) of uniform numbers (sample, dimensions)."""


@dataclass(frozen=True)
class Normal(AbstractRandom):
    """``{ normal = [mean, standard deviation] }``."""

    key: ClassVar[str] = "normal"
    mean: float
    deviation: float

    @classmethod
    def read(cls, value: Any, reader: Reader, folder: Path) -> Normal:
        mean, _ = reader.several(value, ("mean", "standard deviation"))
        deviation = reader.difference(value[1])
        if not deviation > 0.0:
            raise ValueError(f"needs a positive standard deviation; got {shown(value)}")
        return cls(mean, deviation)

    def values(self, uniform: Uniform) -> Values:
        return self.mean + self.deviation * ndtri(uniform[:, 0])


@dataclass(frozen=True)
class Even(AbstractRandom):
    """``{ uniform = [from, to] }``."""

    key: ClassVar[str] = "uniform"
    low: float
    high: float

    @classmethod
    def read(cls, value: Any, reader: Reader, folder: Path) -> Even:
        low, high = reader.several(value, ("from", "to"))
        if not low < high:
            raise ValueError(f"must go from a smaller to a larger value; got {shown(value)}")
        return cls(low, high)

    def values(self, uniform: Uniform) -> Values:
        return self.low * (1.0 - uniform[:, 0]) + self.high * uniform[:, 0]


@dataclass(frozen=True)
class LogEven(AbstractRandom):
    """``{ log-uniform = [from, to] }``: the logarithm is uniform."""

    key: ClassVar[str] = "log-uniform"
    low: float
    high: float

    @classmethod
    def read(cls, value: Any, reader: Reader, folder: Path) -> LogEven:
        low, high = reader.several(value, ("from", "to"))
        if not 0.0 < low < high:
            raise ValueError(f"must go from a smaller to a larger positive value; got {shown(value)}")
        return cls(low, high)

    def values(self, uniform: Uniform) -> Values:
        return self.low * np.exp(uniform[:, 0] * math.log(self.high / self.low))


def _read_length(value: Any, reader: Reader, folder: Path) -> AbstractRandom | float:
    """Return the length of vectors: a quantity, or itself spread."""
    if not isinstance(value, dict):
        length = reader(value)
        if not length > 0.0:
            raise ValueError(f"needs a positive length; got {shown(value)}")
        return length
    distribution = read_distribution(value, reader, folder, lengths=True)
    assert isinstance(distribution, AbstractRandom)
    return distribution


def _lengths(length: AbstractRandom | float, uniform: Uniform) -> Any:
    return length.values(uniform)[:, None] if isinstance(length, AbstractRandom) else length


@dataclass(frozen=True)
class OnSphere(AbstractRandom):
    """``{ sphere = length }``: vectors uniform over all directions; the length may have a distribution of its own.

    By Archimedes' theorem the height on a sphere is uniform, and so is the azimuth.
    """

    key: ClassVar[str] = "sphere"
    dimensions: ClassVar[int] = 3
    of_length: AbstractRandom | float
    length: int = 3

    @classmethod
    def read(cls, value: Any, reader: Reader, folder: Path) -> OnSphere:
        return cls(_read_length(value, reader, folder))

    def values(self, uniform: Uniform) -> Values:
        height = 2.0 * uniform[:, 0] - 1.0
        return _lengths(self.of_length, uniform[:, 2:]) * _at_heights(height, 1.0 - height * height, uniform[:, 1])


@dataclass(frozen=True)
class VonMisesFisher(AbstractRandom):
    """``{ von-mises-fisher = { mean = [x, y, z], concentration = κ, length = "60 rpm" } }``: about a direction.

    The density is proportional to exp(κ cos θ); 1/√κ rad is about the spread of each component across the mean. The
    cosine's distribution function inverts in closed form: 1 − cos θ = −ln(1 − u (1 − e^(−2κ)))/κ.
    Source: Mardia & Jupp, *Directional Statistics*, §9.3; Jakob, *Numerically stable sampling of the vMF distribution*.
    """

    key: ClassVar[str] = "von-mises-fisher"
    dimensions: ClassVar[int] = 3
    mean: tuple[float, float, float]
    concentration: float
    of_length: AbstractRandom | float
    length: int = 3

    @classmethod
    def read(cls, value: Any, reader: Reader, folder: Path) -> VonMisesFisher:
        plain = Reader(Number(""))
        wanted = {"mean", "concentration", "length"}
        if not isinstance(value, dict) or set(value) != wanted:
            raise ValueError('must be like { mean = [0, 0, 1], concentration = 100, length = "60 rpm" }; got '
                             f"{shown(value)}")
        mean = plain.several(value["mean"], ("x", "y", "z"))
        size = math.hypot(*mean)
        concentration = plain(value["concentration"])
        if not (size > 0.0 and math.isfinite(size)) or not concentration > 0.0:
            raise ValueError(f"needs a direction and a positive concentration; got {shown(value)}")
        x, y, z = (part / size for part in mean)
        return cls((x, y, z), concentration, _read_length(value["length"], reader, folder))

    def values(self, uniform: Uniform) -> Values:
        below = -np.log1p(uniform[:, 0] * np.expm1(-2.0 * self.concentration)) / self.concentration  # 1 − cos θ
        below = np.minimum(below, 2.0)
        about = _at_heights(1.0 - below, below * (2.0 - below), uniform[:, 1])
        return _lengths(self.of_length, uniform[:, 2:]) * (about @ _frame_along(np.array(self.mean)))


def _at_heights(height: Any, square: Any, turns: Any) -> Any:
    """Return unit vectors (sample, 3) of these heights, whose squared distances from the axis are given too."""
    across = np.sqrt(np.maximum(square, 0.0))
    return np.stack([across * np.cos(2.0 * np.pi * turns), across * np.sin(2.0 * np.pi * turns), height], axis=1)


def _frame_along(mean: Any) -> Any:
    """Return a rotation matrix whose third row is a unit vector."""
    other = np.eye(3)[int(np.argmin(np.abs(mean)))]
    first = np.cross(other, mean)
    first /= np.linalg.norm(first)
    return np.stack([first, np.cross(mean, first), mean])


@dataclass(frozen=True)
class OnSO3(AbstractRandom):
    """``{ so3 = "uniform" }``: uniform over all attitudes, as unit quaternions wxyz.

    Source: Shoemake, Uniform random rotations, *Graphics Gems III* (1992) 124.
    """

    key: ClassVar[str] = "so3"
    dimensions: ClassVar[int] = 3
    length: int = 4

    @classmethod
    def read(cls, value: Any, reader: Reader, folder: Path) -> OnSO3:
        if value != "uniform":
            raise ValueError(f'must be "uniform"; got {shown(value)}')
        return cls()

    def values(self, uniform: Uniform) -> Values:
        first, second = np.sqrt(uniform[:, 0]), np.sqrt(1.0 - uniform[:, 0])
        one, other = 2.0 * np.pi * uniform[:, 1], 2.0 * np.pi * uniform[:, 2]
        return np.stack([first * np.cos(one), second * np.sin(other), second * np.cos(other), first * np.sin(one)], 1)


class AbstractPlaced(AbstractDistribution):
    """One whose values stand in an order."""

    dimensions: ClassVar[int] = 0

    @property
    @abstractmethod
    def count(self) -> int:
        """How many values there are."""

    @abstractmethod
    def at(self, places: np.ndarray) -> Values:
        """Return the values at places, from 0 on."""


@dataclass(frozen=True)
class Grid(AbstractPlaced):
    """``{ grid = ["1 rpm", "2 rpm"] }`` or ``{ grid = { from = "1 rpm", to = "9 rpm", count = 5 } }``.

    With ``spacing = "log"`` the ratios are equal instead of the differences. Several grids are combined all with all.
    """

    key: ClassVar[str] = "grid"
    points: tuple[float, ...]

    @classmethod
    def read(cls, value: Any, reader: Reader, folder: Path) -> Grid:
        if isinstance(value, list) and value:
            return cls(tuple(reader(item) for item in value))
        needed = {"from", "to", "count"}
        if not isinstance(value, dict) or not needed <= set(value) <= {*needed, "spacing"}:
            raise ValueError('must be a list of values, or like { from = "1 rpm", to = "9 rpm", count = 5 }, with or '
                             f'without spacing = "log"; got {shown(value)}')
        low, high = reader(value["from"]), reader(value["to"])
        count, spacing = value["count"], value.get("spacing", "even")
        if type(count) is not int or not 2 <= count <= LIMITS.max_grid_values:
            raise ValueError(f"needs a count from 2 to {LIMITS.max_grid_values:,}; got {shown(count)}")
        if spacing not in ("even", "log") or (spacing == "log" and not (low > 0.0 and high > 0.0)):
            raise ValueError(f'has spacing "even" or, between positive values, "log"; got {shown(value)}')
        points = np.geomspace(low, high, count) if spacing == "log" else np.linspace(low, high, count)
        return cls(tuple(points.tolist()))

    @property
    def count(self) -> int:
        return len(self.points)

    def at(self, places: np.ndarray) -> Values:
        return np.asarray(self.points)[places]


@dataclass(frozen=True)
class FromTable(AbstractPlaced):
    """``{ table = "runs.csv", column = "rate", unit = "rpm" }``: the rows of a CSV file in their order.

    Several columns of a file go together, row by row.
    """

    key: ClassVar[str] = "table"
    column: Any

    @classmethod
    def read(cls, value: Any, reader: Reader, folder: Path) -> FromTable:
        wanted = {"table", "column"} | (set() if reader.number.unit == "" else {"unit"})
        if set(value) != wanted:
            raise ValueError(f"must have the keys {', '.join(sorted(wanted))}; got {', '.join(sorted(value))}")
        if not all(isinstance(item, str) for item in value.values()):
            raise ValueError(f"must have text in quotes for {', '.join(sorted(wanted))}; got {shown(value)}")
        scale = _scale(value.get("unit", ""), reader)
        return cls(_Column(*_column(folder / value["table"], value["column"], scale)))

    @property
    def count(self) -> int:
        return len(self.column.values)

    def at(self, places: np.ndarray) -> Values:
        return self.column.values[places]


@dataclass(frozen=True, eq=False)
class _Column:
    values: np.ndarray
    source: str


def _scale(unit: str, reader: Reader) -> Callable[[float], float]:
    """Return the conversion of numbers of a unit into those of the input; affine, as that of degrees Celsius."""
    if not unit:
        return lambda number: number
    zero, one = reader(f"0 {unit}"), reader(f"1 {unit}")
    return lambda number: zero + (one - zero) * number


def _column(path: Path, name: str, scale: Callable[[float], float]) -> tuple[np.ndarray, str]:
    try:
        rows = list(csv.reader(io.StringIO(read_text(path, "table", LIMITS.max_table))))
    except PolhodeError as error:
        raise ValueError(str(error)) from None
    head = [cell.strip() for cell in rows[0]] if rows else []
    if head.count(name) != 1:
        raise ValueError(f"{path} needs one column {shown(name)}; its first row is {shown(head)}")
    at, numbers = head.index(name), []
    for line, row in enumerate(rows[1:], 2):
        if not row:
            continue
        try:
            numbers.append(scale(float(row[at])))
        except (ValueError, IndexError):
            cell = row[at] if at < len(row) else "nothing"
            raise ValueError(f"{path}, line {line}: {shown(name)} must be a number; got {shown(cell)}") from None
        if not math.isfinite(numbers[-1]):
            raise ValueError(f"{path}, line {line}: {shown(name)} must be finite; got {shown(row[at])}")
    if not numbers:
        raise ValueError(f"{path} has no rows below its head")
    return np.array(numbers), str(path)


def _list_subclasses(base: type) -> list[type]:
    return [each for sub in base.__subclasses__() for each in ([sub] if hasattr(sub, "key") else _list_subclasses(sub))]


def read_distribution(
    value: Any, reader: Reader, folder: Path, lengths: bool = False
) -> AbstractDistribution:
    """Return the distribution of an input from a spec.

    Args:
        value: a table with one of the keys of the distributions.
        reader: of the input's numbers.
        folder: that paths count from.
        lengths: whether it is that of the length of vectors, which is one random number.

    Raises:
        ValueError: in words.
    """
    known = {each.key: each for each in _list_subclasses(AbstractDistribution)}
    if lengths:
        known = {key: each for key, each in known.items() if issubclass(each, AbstractRandom) and each.dimensions == 1}
    keys = [key for key in known if isinstance(value, dict) and key in value]
    if len(keys) != 1:
        ways, example = ", ".join(known), '{ normal = ["120 rpm", "5 rpm"] }'
        raise ValueError(f"must be a table with one of {ways}, like {example}; got {shown(value)}")
    whole = known[keys[0]]
    if whole is not FromTable and set(value) != {keys[0]}:
        raise ValueError(f"has more keys than {keys[0]}: {', '.join(sorted(set(value) - {keys[0]}))}; leave them out")
    law = whole.read(value if whole is FromTable else value[keys[0]], reader, folder)
    wanted = 0 if lengths else reader.number.length
    if law.length != wanted:
        sizes = {0: "one number", 3: "a vector of three", 4: "a quaternion"}
        raise ValueError(f"{keys[0]} gives {sizes[law.length]}, and {sizes.get(wanted, 'a list')} is there")
    return law
