"""The reasons for a verdict, as data; ``str`` turns them into a sentence.

Rates are in 1/s. Every deciding number has the threshold that it was compared with beside it.
"""

from __future__ import annotations

import abc
from collections.abc import Mapping
from dataclasses import dataclass, fields, replace
from typing import Any, ClassVar

import numpy as np

from polhode.analysis._conserved_function import ConservedFunction
from polhode.types import Array, Float64


@dataclass(frozen=True, eq=False)
class AbstractReason(abc.ABC):
    """The reason of a verdict, or why it is undecided.

    Attributes:
        title: the finding in a few words.
    """

    title: ClassVar[str]

    @abc.abstractmethod
    def __str__(self) -> str: ...

    @property
    def words(self) -> str:
        """The meaning without formulas; the whole sentence where there is none."""
        return str(self)

    @property
    def values(self) -> dict[str, Any]:
        """The numbers of the finding, by name, without the function of conserved quantities."""
        own = {field.name: getattr(self, field.name) for field in fields(self)}
        kept = {name: value for name, value in own.items() if not isinstance(value, ConservedFunction)}
        return {"title": self.title, **kept}

    def rename(self, names: Mapping[str, str]) -> AbstractReason:
        """Return the same reason with other names of the conserved quantities in its function."""
        own = {field.name: getattr(self, field.name) for field in fields(self)}
        functions = {name: value for name, value in own.items() if isinstance(value, ConservedFunction)}
        return replace(self, **{name: function.rename(names) for name, function in functions.items()})


@dataclass(frozen=True, eq=False)
class DefiniteVariation(AbstractReason):
    """The second variation of a function of conserved quantities is definite: +1 positive, −1 negative."""

    title: ClassVar[str] = "definite second variation"
    function: ConservedFunction
    sign: int

    def __str__(self) -> str:
        text = f"the second variation of {self.function} is {_sign(self.sign)} definite"
        if self.function.curvatures.size:
            text += f", on the leaf by {self.function.margin:.3g} of its largest term"
        return text + ("; Δ is the difference from the value at the equilibrium" if self.function.has_squares else "")

    @property
    def words(self) -> str:
        extreme, names = _extreme(self.sign), _list_names(self.function.names)
        if not self.function.weights[0]:
            return f"a combination of {names} is at its {extreme}: neighbours cannot leave"
        rest = f" among motions with the same {names}" if names else ": neighbours cannot leave"
        return f"the energy is at its {extreme}{rest}"


@dataclass(frozen=True, eq=False)
class OpenVariation(AbstractReason):
    """The second variation is not definite, and no exponent disproves stability.

    Attributes:
        function: the candidate that comes nearest to a proof.
        signs_differ: whether curvatures have both signs; else some vanish.
        real_part: the largest of the exponents'.
        sure_from: real part beyond what errors of the matrices can make of zero.
    """

    title: ClassVar[str] = "second variation not definite, no sure growth"
    function: ConservedFunction
    signs_differ: bool
    real_part: float
    sure_from: float

    def __str__(self) -> str:
        why, balance = ("indefinite", " a gyroscopic balance;") if self.signs_differ else ("degenerate", "")
        return (
            f"the second variation of {self.function} on the leaf is {why} and no exponent has a real part that is "
            f"surely positive:{balance} terms of higher order decide"
        )

    @property
    def words(self) -> str:
        why = "a gyroscopic balance" if self.signs_differ else "no sure growth"
        return f"{why}: no conserved quantity that is known holds neighbours, and terms of higher order decide"


@dataclass(frozen=True, eq=False)
class EquilibriaWithoutShear(AbstractReason):
    """The second variation vanishes along equilibria, and the flow across them drives no sure drift along them.

    Attributes:
        function: whose second variation it is.
        shear: the largest rate of drift by distance that the linearised flow has.
        sure_from: rate beyond what errors of the matrices can make of zero.
    """

    title: ClassVar[str] = "equilibria nearby, no sure shear"
    function: ConservedFunction
    shear: float
    sure_from: float

    def __str__(self) -> str:
        return (
            f"the second variation of {self.function} on the leaf is degenerate, along equilibria without shear: "
            "neighbours drift along them, if at all, at a rate of second order in the distance"
        )

    @property
    def words(self) -> str:
        return "one of a family of equilibria: neighbours drift along it, if at all, the slower the nearer they are"


@dataclass(frozen=True, eq=False)
class LeafOfEquilibria(AbstractReason):
    """All neighbours on the leaf are at rest, and those on other leaves have no sure drift; numbers as above."""

    title: ClassVar[str] = "leaf of equilibria, no sure shear"
    function: ConservedFunction
    shear: float
    sure_from: float

    def __str__(self) -> str:
        return (
            f"every neighbour on the leaf is an equilibrium, as {self.function} is constant there; "
            "on neighbouring leaves motions drift, if at all, at a rate of second order in the distance"
        )

    @property
    def words(self) -> str:
        return "all neighbours alike are equilibria: others drift, if at all, the slower the nearer they are"


@dataclass(frozen=True, eq=False)
class SteadyDrift(AbstractReason):
    """Neighbours leave at a steady rate [1/s, times their distance] along a unit direction (n,)."""

    title: ClassVar[str] = "steady drift"
    drift_rate: float
    direction: Float64[Array, "n"]

    def __str__(self) -> str:
        where = f"({_write(self.direction)}), {self.drift_rate:.6g}/s times their distance"
        return f"neighbours leave at a steady rate along {where}"

    @property
    def words(self) -> str:
        return f"neighbours leave at a steady rate, {self.drift_rate:.6g}/s times their distance"


@dataclass(frozen=True, eq=False)
class ExponentialGrowth(AbstractReason):
    """The linearised flow on the leaf grows at a rate along a unit direction (n,)."""

    title: ClassVar[str] = "exponential growth"
    rate: float
    direction: Float64[Array, "n"]

    def __str__(self) -> str:
        return f"the linearised flow on the leaf grows as exp({self.rate:.6g}/s · t) along ({_write(self.direction)})"

    @property
    def words(self) -> str:
        return "neighbours leave exponentially"


@dataclass(frozen=True, eq=False)
class NoCombination(AbstractReason):
    """The slope of the energy is no combination of the Casimirs' slopes, and no exponent disproves stability.

    Attributes:
        residual: of dH, relative to its terms.
        allowed: up to which it would count as none.
        real_part, sure_from: of the exponents, as above.
    """

    title: ClassVar[str] = "no function, no sure growth"
    residual: float
    allowed: float
    real_part: float
    sure_from: float

    def __str__(self) -> str:
        return (
            "dH is not a combination of the dC here, as on a singular leaf, and no exponent has a real part that is "
            "surely positive: another function must decide"
        )

    @property
    def words(self) -> str:
        return "no conserved quantity that is known has an extremum here, and no growth is sure"


@dataclass(frozen=True, eq=False)
class FieldVanishes(AbstractReason):
    """The field vanishes at all points."""

    title: ClassVar[str] = "no motion anywhere"

    def __str__(self) -> str:
        return "the field vanishes at all points: every neighbour is an equilibrium"


@dataclass(frozen=True, eq=False)
class DefiniteOnLeaf(AbstractReason):
    """The energy's second variation is definite on the leaf's own tangent space.

    Attributes:
        function: which, as "H".
        dimension: of the leaf.
        sign: +1 positive, −1 negative.
        leaves_nearby: "alike" at a regular point, "near" on a singular leaf of a compact group, "larger" on any other,
            where the proof does not reach motions on them.
    """

    title: ClassVar[str] = "definite second variation on the leaf"
    function: str
    dimension: int
    sign: int
    leaves_nearby: str

    def __str__(self) -> str:
        text = (
            f"the second variation of {self.function} on the leaf, of dimension {self.dimension}, is "
            f"{_sign(self.sign)} definite"
        )
        if self.leaves_nearby == "alike":
            return f"{text}; the point is regular, so that leaves nearby have such extrema too"
        if self.leaves_nearby == "near":
            return f"{text}; the leaf is singular, but the group compact, so that leaves nearby stay near it"
        return (
            f"on its own leaf the equilibrium is stable: {text}; but the leaf is singular, leaves nearby are larger, "
            "and motions on these are not confined by it"
        )

    @property
    def words(self) -> str:
        here = f"{self.function} is at its {_extreme(self.sign)} among motions with the same Casimirs"
        if self.leaves_nearby == "larger":
            return f"{here}; motions with other Casimirs are not held by it"
        return f"{here}: neighbours cannot leave"


@dataclass(frozen=True, eq=False)
class LeafIsPoint(AbstractReason):
    """The leaf is a point, on which nothing moves.

    Attributes:
        leaves_nearby: as for ``DefiniteOnLeaf``.
        what: the point: the leaf, or its quotient by the symmetries.
    """

    title: ClassVar[str] = "leaf of one point"
    leaves_nearby: str = "alike"
    what: str = "the leaf"

    def __str__(self) -> str:
        rest = {
            "near": ", and the group is compact, so that leaves nearby stay near it",
            "larger": ", on which nothing moves; but leaves nearby are larger, and motions on these may go far",
        }.get(self.leaves_nearby, "")
        return f"{self.what} is a point{rest}"

    @property
    def words(self) -> str:
        others = "motions with other Casimirs are not held by it" if self.leaves_nearby == "larger" else ""
        return f"nothing moves with the same Casimirs{'; ' + others if others else ', and neighbours cannot leave'}"


@dataclass(frozen=True, eq=False)
class Exponents(AbstractReason):
    """Real parts of the exponents of a flow that loses energy.

    Attributes:
        real_part: the largest.
        sure_from: size beyond what errors of the derivatives can make of zero.
        all_negative: whether all real parts surely are.
    """

    title: ClassVar[str] = "exponents of the linearised flow"
    real_part: float
    sure_from: float
    all_negative: bool

    def __str__(self) -> str:
        rate = f"{self.real_part:.6g}/s"
        if self.real_part > self.sure_from:
            return f"an exponent has the real part {rate}: neighbours grow as exp({rate} · t)"
        if self.all_negative:
            return f"every exponent has a negative real part, {rate} at most: neighbours return"
        why = "no exponent has a real part that is surely positive, but not all surely negative ones"
        return f"{why}: terms of higher order decide"

    @property
    def words(self) -> str:
        if self.real_part > self.sure_from:
            return "neighbours leave exponentially"
        if self.all_negative:
            return "neighbours return exponentially"
        return "neither growth nor return is certain: terms of higher order decide"


@dataclass(frozen=True, eq=False)
class AxisOfFreeBody(AbstractReason):
    """Rotation about a principal axis, judged by H − |L|²/(2I).

    Attributes:
        moment: I about the axis [kg m²].
        curvatures: second derivatives [1/(kg m²)] of the function by δL of the other two axes, by their numbers.
        rate: of exponential growth; zero without.
        growth: as of the verdict.
        at_rest: whether the body does not turn.
    """

    title: ClassVar[str] = "second variation about a principal axis"
    moment: float
    curvatures: dict[int, float]
    rate: float
    growth: str | None
    at_rest: bool

    def __str__(self) -> str:
        if self.at_rest:
            return "the body is at rest: |L| = 0 is kept"
        function = f"H − |L|²/(2·{self.moment:.6g})"
        if not any(self.curvatures.values()):
            return f"every L of a sphere is at rest: {function} is zero everywhere"
        terms = _quadratic_form({f"δL{axis}²": value for axis, value in self.curvatures.items()})
        if self.growth == "exponential":
            return f"neighbours grow as exp({self.rate:.6g}/s · t): {function} has the saddle {terms}"
        if self.growth == "linear":
            return f"neighbours drift away in proportion to time: every axis of the equator is at rest, {terms}"
        return f"{function} has an extremum on the sphere: {terms}"

    @property
    def words(self) -> str:
        if self.at_rest or not any(self.curvatures.values()):
            return "the body is at rest" if self.at_rest else "every axis keeps its direction, as all moments are equal"
        if self.growth == "exponential":
            return "the energy is neither at its greatest nor at its least for this |L|: neighbours leave exponentially"
        if self.growth == "linear":
            return "every axis of this equator keeps its direction: neighbours drift along it, in proportion to time"
        if max(self.curvatures.values()) > 0.0:
            return "the energy is at its least for this |L|"
        return "the energy is at its greatest for this |L|; any internal loss of energy makes the spin leave this axis"


@dataclass(frozen=True, eq=False)
class SphereOfRests(AbstractReason):
    """All moments are equal."""

    title: ClassVar[str] = "every axis at rest"

    def __str__(self) -> str:
        return "every axis of a sphere is a rest of L"


@dataclass(frozen=True, eq=False)
class SettlesOnCircle(AbstractReason):
    """Neighbours settle, at a negative rate, on a circle of axes of equal moment."""

    title: ClassVar[str] = "approach to a circle of rests"
    rate: float

    def __str__(self) -> str:
        return (
            "a neighbour comes to turn about an axis of the same moment, no farther off than it started: "
            f"{self.rate:.6g}/s"
        )


@dataclass(frozen=True, eq=False)
class Restriction:
    """The restriction of "stable".

    Attributes:
        flows: of integrals, along which neighbours may move away.
        within: quantities that stay close, where others do not.
        without: quantities that need not stay close.
    """

    flows: tuple[str, ...] = ()
    within: tuple[str, ...] = ()
    without: tuple[str, ...] = ()

    def __str__(self) -> str:
        if self.flows:
            return f"up to the flow{'s' if len(self.flows) > 1 else ''} of {', '.join(self.flows)}"
        return f"in {' and '.join(self.within)}, not in {' and '.join(self.without)}"


@dataclass(frozen=True, eq=False)
class MissingCasimirs:
    """Casimirs that would be needed and are not known.

    Attributes:
        count: of those that there are.
        needed: the algebra's index.
        searched: where they are from, in words.
    """

    count: int
    needed: int
    searched: str

    def __str__(self) -> str:
        how = f"{self.searched.rstrip('.)')}{')' if '(' in self.searched else ''}"
        return f"only {self.count} of {self.needed} Casimirs {how}: give them by `casimirs=`"


def _sign(sign: int) -> str:
    return "positive" if sign > 0 else "negative"


def _list_names(names: tuple[str, ...]) -> str:
    return " and ".join(filter(None, (", ".join(names[:-1]), *names[-1:])))


def _extreme(sign: int) -> str:
    return "least" if sign > 0 else "greatest"


def _write(vector: Array) -> str:
    rounding = 1e-12  # components of a unit direction below it are rounding errors
    return ", ".join(f"{x:.4g}" for x in np.where(np.abs(vector) > rounding, vector, 0.0))


def _quadratic_form(coefficients: dict[str, float]) -> str:
    """Return ½ Σ c x² in words, without the terms that vanish."""
    terms = [(value, name) for name, value in coefficients.items() if value]
    first, *rest = (f"{'−' if value < 0 else '+'} {abs(value):.6g} {name}" for value, name in terms)
    first = first.removeprefix("+ ").replace("− ", "−")
    return f"½ ({' '.join([first, *rest])})"
