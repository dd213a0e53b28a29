"""The answers about the spin of a moon or planet on its orbit."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cached_property
from typing import ClassVar, NamedTuple

import numpy as np

from polhode.bodies.body import Body
from polhode.celestial.spin_orbit.motion import SpinMotion, spin_motion
from polhode.celestial.spin_orbit.resonances import (
    Resonance,
    libration_period,
    overlap_asphericity,
    overlap_threshold,
    resonances,
)
from polhode.celestial.spin_orbit.system import SpinOrbit
from polhode.celestial.spin_orbit.table import SpinOrbitTable
from polhode.errors import InvalidInput
from polhode.kinds.base import Spec
from polhode.kinds.stepping import Start
from polhode.motion._trajectory import Trajectory
from polhode.reports.about import about_body, about_orbital_rests, accuracy
from polhode.reports.answer import Answer, Group, Table
from polhode.reports.base import WITHOUT_MOTION, MotionReport
from polhode.reports.wording import number
from polhode.systems.kepler_orbit import KeplerOrbit
from polhode.types import Array, Float64

DAY = 86400.0


class OrbitLimits(NamedTuple):
    """What orbits are refused."""

    max_rate: float = 1e100  # rad/s, and of its inverse; their squares stay within the range of numbers


LIMITS = OrbitLimits()


@dataclass(frozen=True)
class SpinOrbitReport(MotionReport):
    """Resonances of a body on its orbit, and the motion of one spin.

    Attributes:
        body: None where the spec gives the asphericity itself.
        system: the spin-orbit problem.
        trajectory: samples of the motion by adaptive steps.
        resonances: p = 1/2, 1, … up to 3 or more.
        section_orbits: in the figure.
        remarks: on how the spec was understood.
    """

    kind: ClassVar[str] = "spin-orbit"
    body: Body | None
    system: SpinOrbit
    trajectory: Trajectory
    resonances: list[Resonance]
    section_orbits: int
    remarks: tuple[str, ...] = ()

    @property
    def start(self) -> Float64[Array, "2"]:
        """(2,) angle [rad] and rate [rad/s] at the first periapsis."""
        return np.asarray(self.trajectory.states)[0]

    @cached_property
    def motion(self) -> SpinMotion:
        """Exponent, verdict, mean rate and libration over thousands of orbits."""
        return spin_motion(self.system, self.start)

    @property
    def threshold(self) -> float | None:
        """Least asphericity at which neighbouring zones touch; None on a circular orbit, which has a single zone."""
        return overlap_asphericity(self.resonances)

    @property
    def chaos_expected(self) -> bool:
        """Whether zones overlap, by Chirikov's criterion."""
        return self.threshold is not None and float(self.system.asphericity) >= self.threshold

    @property
    def libration_period(self) -> float | None:
        """Period of libration about the radius on a circular orbit [s]; None on others, and for a spin past it."""
        return None if float(self.system.eccentricity) else libration_period(self.system, self.start)

    @property
    def predictable_time(self) -> float | None:
        """Time in which an error of the samples' tolerance grows to one radian in a chaotic motion [s]."""
        tolerance = 1e-12  # of the samples' adaptive steps
        return self.motion.predictable_time(tolerance)

    @property
    def answers(self) -> list[Group | Table]:
        of_motion = [*self._list_answers_of_start(), *self._list_answers_of_motion()]
        return [*self._before_motion(), Group("Motion", of_motion)]

    def iterate_answers(self) -> Iterator[Group | Table]:
        yield from self._before_motion()
        yield Group("Motion", self._list_answers_of_start())
        yield Group("", self._list_answers_of_motion())

    def _before_motion(self) -> list[Group | Table]:
        missing = [Group("", [Answer("mass", None), Answer("principal_moments", None)])] if self.body is None else []
        return [*missing, *self.without_motion()]

    def without_motion(self) -> list[Group | Table]:
        """Return the answers that need no trajectory."""
        body = [] if self.body is None else [about_body(self.body)]
        return [*body, self._orbit(), self._resonances(), *self._rests()]

    def _rests(self) -> list[Table]:
        """Return how the body can rest in space, with all its axes, on a circular orbit."""
        if self.body is None or float(self.system.eccentricity) or not float(self.body.principal_moments[0]):
            return []
        return [about_orbital_rests(self.body.principal_moments, float(self.system.mean_motion))]

    def _orbit(self) -> Group:
        system, asphericity = self.system, float(self.system.asphericity)
        e, period = float(system.eccentricity), float(system.orbit.period)
        if asphericity == 0.0:
            chaos = "no: A = B, and gravity has no hold on the spin"
        elif self.threshold is None:
            chaos = "no: on a circular orbit the spin is a pendulum, and no pendulum is chaotic"
        elif self.chaos_expected:
            chaos = f"yes: zones of resonances overlap from ω0 = {self.threshold:.4g} on"
        else:
            chaos = f"in thin layers at most: zones overlap from ω0 = {self.threshold:.4g} on"
        small, ratio_of = float(overlap_threshold(e)) if e > 0.0 else None, "√(3(B − A)/C)"
        return Group("Shape and orbit", [
            Answer("asphericity", asphericity, "", f"asphericity ω0 = {ratio_of}", ratio_of),
            Answer("eccentricity", e, "", "eccentricity"),
            Answer("orbital_period", period, "s", "orbital period", "", f"{period:.8g} s = {period / DAY:.6g} d"),
            Answer("mean_motion", float(system.mean_motion), "rad/s", "mean motion n", "",
                   number(float(system.mean_motion), "rad/s")),
            Answer("overlap_threshold", self.threshold, "", "", "as asphericity"),
            Answer("small_eccentricity_threshold", small, "", "", "as asphericity"),
            Answer("chaos_expected", self.chaos_expected, "", "chaos expected", "", chaos),
        ])

    def _resonances(self) -> Table:
        n = float(self.system.mean_motion)
        columns = {
            "turns : orbits": lambda row: ratio(row["order"]),
            "strength H": lambda row: f"{row['strength']:.6g}",
            "half-width": lambda row: f"{row['half_width'] / n:.4g} n",
            "long axis at periapsis": lambda row: f"{math.degrees(row['stable_angle']):.0f}°",
        }
        units = {"order": "turns per orbit", "rate": "rad/s", "half_width": "rad/s",
                 "stable_angle": "rad, at periapsis"}  # fmt: skip
        said = lambda row: row["stable_angle"] is not None and row["half_width"] > 0.0  # noqa: E731
        rows = [vars(resonance) for resonance in self.resonances]
        return Table("resonances", "Resonances of spin and orbit", columns, rows, units, shown=said)

    def _list_answers_of_start(self) -> list[Answer]:
        angle, rate = (float(self.trajectory.part(name)[0]) for name in ("angle", "rate"))
        spin_ratio = rate / float(self.system.mean_motion)
        return [
            Answer("start.angle", angle, "rad", "start, at periapsis", "long axis from the direction of the periapsis",
                   f"long axis {math.degrees(angle):.6g}° from the periapsis, {spin_ratio:.6g} turns an orbit"),
            Answer("start.rate", rate, "rad/s"),
            Answer("start.spin_ratio", spin_ratio, "", "", "turns per orbit"),
        ]

    def _list_answers_of_motion(self) -> list[Answer]:
        motion, n, held = self.motion, float(self.system.mean_motion), self.motion.libration
        # exponents have two digits, as they converge as slowly as ln t/t
        rate, chaotic = motion.exponent, motion.verdict == "chaotic"
        level = motion.regular_exponent(n)
        exponent = f"{rate:.2g} /s = {rate / n:.2g} n"
        if not chaotic:
            exponent += f"; a regular motion shows about {level:.2g} /s by then, falling as ln t/t"
        kept = "none" if held is None else (
            f"in {ratio(held.order)}, about {_clean_degrees(math.degrees(held.angle)):.5g}° by "
            f"±{_clean_degrees(math.degrees(held.amplitude)):.5g}° at periapsis"
        )
        # the weighted mean of a quasi-periodic motion has many digits, that of chaos as few as the square root says
        digits, lasting = 4 if chaotic else 8, motion.lyapunov_time
        mean, mean_ratio = motion.mean_rate, motion.mean_rate / n
        return [
            Answer("orbits", motion.orbits),
            Answer("verdict", motion.verdict, "", "verdict", "", f"{motion.verdict} over {motion.orbits} orbits"),
            Answer("lyapunov_exponent", rate, "1/s", "Lyapunov exponent", "", exponent),
            Answer("regular_level", level, "1/s"),
            Answer("lyapunov_time", lasting, "s", "its time 1/λ", "", _about(lasting)),
            Answer("predictable_time", self.predictable_time, "s", "predictable for about", "",
                   _about(self.predictable_time)),
            Answer("libration", None if held is None else held._asdict(), "rad", "libration", "at periapsis", kept),
            Answer("libration_period", self.libration_period, "s", "period of libration"),
            Answer("mean_rate", mean, "rad/s", "mean rotation", "",
                   f"{mean:.{digits}g} rad/s = {mean_ratio:.{digits}g} n"),
            Answer("mean_spin_ratio", mean_ratio, "", "", "turns per orbit"),
            *accuracy(self.trajectory),
        ]

    @property
    def notes(self) -> list[str]:
        notes = ["all this is planar: the axis of largest moment is taken to stay upright on the orbit."]
        if self.motion.verdict == "chaotic":
            notes[0] += " In chaos it often does not."
            if np.ptp(np.asarray(self.trajectory.times)) > (self.predictable_time or math.inf):
                notes.append("the samples outlast what can be predicted of this start; the last are of one like it.")
        elif float(self.system.eccentricity) and float(self.system.asphericity):
            notes.append(
                f"no more is known than {self.motion.orbits} orbits show; chaos may cling to an island for longer."
            )
        return [*self.remarks, *notes]

    @property
    def summary(self) -> str:
        motion, n = self.motion, float(self.system.mean_motion)
        if motion.verdict == "chaotic":
            tenfold = math.log(10.0) / motion.exponent * n / (2.0 * math.pi)
            return (
                f"Chaotic: two spins that start almost alike differ ten times as much {tenfold:.2g} orbits later."
            )
        sure = "Regular" if motion.verdict == "regular" else f"Undecided after {motion.orbits} orbits"
        if motion.libration is not None:
            held = motion.libration
            swing = _clean_degrees(math.degrees(held.amplitude))
            return f"{sure}: it librates by ±{swing:.4g}° in the {ratio(held.order)} resonance of spin and orbit."
        return f"{sure}: it turns {motion.mean_rate / n:.8g} times per orbit on average, caught in no resonance."


def ratio(order: float) -> str:
    """Return turns to orbits of a resonance, like 3:2."""
    fraction = Fraction(order)
    return f"{fraction.numerator}:{fraction.denominator}"


def begin_motion(spec: Spec[SpinOrbitTable]) -> Start:
    """Return the motion of a spin that starts at periapsis.

    Raises:
        InvalidInput: for an orbit so slow or fast that the squares of its rates overflow or vanish.
    """
    periods = 30
    table, times = spec.system, spec.times
    system = _system(spec, table)
    n = float(system.mean_motion)
    if times is None:
        times = np.linspace(0.0, periods * 2.0 * math.pi / n, spec.samples)
    frame = None if spec.body is None else spec.body.frame

    def report(trajectory: Trajectory, _: tuple[str, ...]) -> SpinOrbitReport:
        listed = _list_resonances(system, table)
        return SpinOrbitReport(
            spec.body, system, replace(trajectory, frame=frame), listed, table.section_orbits, spec.remarks
        )

    return Start(system, np.array([table.angle, table.spin_ratio * n]), times, report, spec.until)


def make_report(spec: Spec[SpinOrbitTable]) -> SpinOrbitReport:
    """Return the report on a spin that starts at periapsis.

    Raises:
        InvalidInput: as ``begin_motion`` does.
    """
    return begin_motion(spec).make_report()


def answers_without_motion(spec: Spec[SpinOrbitTable]) -> Iterator[Group | Table]:
    """Yield the answers of the report that need neither trajectory nor exponent."""
    table = spec.system
    system = _system(spec, table)
    listed = _list_resonances(system, table)
    yield from SpinOrbitReport(
        spec.body, system, WITHOUT_MOTION, listed, table.section_orbits, spec.remarks
    ).without_motion()


def _list_resonances(system: SpinOrbit, table: SpinOrbitTable) -> list[Resonance]:
    """Return the resonances that the report lists."""
    # strengths are largest near the orbit's own rate at periapsis
    fastest = max(abs(table.spin_ratio), float(system.orbit.rate_at_periapsis) / float(system.mean_motion))
    highest = min(max(3.0, 0.5 * math.ceil(2.0 * fastest)), 10.0)
    return resonances(system, highest)


def _system(spec: Spec[SpinOrbitTable], table: SpinOrbitTable) -> SpinOrbit:
    if table.orbital_period is not None:
        orbit = KeplerOrbit(2.0 * math.pi / table.orbital_period, table.eccentricity)
    else:
        assert table.semi_major_axis is not None and table.gravitational_parameter is not None
        orbit = KeplerOrbit.from_semi_major_axis(
            table.semi_major_axis, table.gravitational_parameter, table.eccentricity
        )
    n = float(orbit.mean_motion)
    if not 1.0 / LIMITS.max_rate < n < LIMITS.max_rate:
        raise InvalidInput(
            f"the orbit must have a mean motion within 1e±100 rad/s; it is {n:g} rad/s. Check `system.orbital_period`, "
            "or `system.semi_major_axis` and `system.gravitational_parameter`, and their units."
        )
    if table.asphericity is not None:
        return SpinOrbit(table.asphericity, table.eccentricity, n)
    assert spec.body is not None
    return SpinOrbit.from_body(spec.body, orbit)


def _about(seconds: float | None) -> str | None:
    """Return a time in words, with as few digits as exponents have."""
    if seconds is None:
        return None
    short = lambda x: f"{float(f'{x:.2g}'):g}"  # noqa: E731
    return f"{short(seconds)} s = {short(seconds / DAY)} d"


def _clean_degrees(degrees: float) -> float:
    return 0.0 if abs(degrees) < 1e-9 else degrees
