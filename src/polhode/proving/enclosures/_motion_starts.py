"""The exact numbers from which a motion starts, and the interface to balls of its states."""

from __future__ import annotations

import abc
from collections.abc import Callable, Mapping
from fractions import Fraction
from typing import Any, NamedTuple

import numpy as np

from polhode import rotation
from polhode._base.rational.numbers import nearest_double
from polhode.analysis._exact_arithmetic import Ball, Rational, Wanted, exact_rationals, refine
from polhode.errors import InvalidInput, shown
from polhode.motion.base import AbstractMotion
from polhode.proving.enclosures.enclosed_numbers import EnclosedNumber

DOUBLES, GIVEN = "the nearest doubles", "the exact numbers given"


class StartLimits(NamedTuple):
    """How far exact numbers may be from the motion that they describe.

    Attributes:
        max_rounding: over the largest of the motion's doubles: four ulps.
    """

    max_rounding: float = 4.0 * 2.0**-52


LIMITS = StartLimits()


class MotionStart(NamedTuple):
    """A motion's numbers, exact, along the principal axes.

    Attributes:
        moments, momentum: three rationals each.
        attitude: four rationals; the quaternion over its length is meant.
        epoch: a rational.
        numbers: further numbers of the body by name, such as "mgl".
        axes: quaternion of the turn from the principal axes to the motion's own, four rationals; None where they
            coincide.
        taken: name of an argument → how it was read.
    """

    moments: list[Rational]
    momentum: list[Rational]
    attitude: list[Rational]
    epoch: Rational
    numbers: dict[str, Rational]
    axes: list[Rational] | None
    taken: dict[str, str]


class Values(NamedTuple):
    """Balls of a state along the principal axes, and the size of the momentum that its radius counts by."""

    attitude: list[Ball]
    momentum: list[Ball]
    size: Ball


class ExactBody(abc.ABC):
    """A body in exact numbers, and balls computed from them at the present precision."""

    start: MotionStart

    @abc.abstractmethod
    def values_at(self, elapsed: Rational) -> Values:
        """Return the state a time after the epoch."""

    @abc.abstractmethod
    def lost_bits(self, elapsed: Rational) -> float:
        """Return about how many bits of phases are whole turns by then."""


def exact_start(motion: AbstractMotion, exact: Mapping[str, Any] | None) -> MotionStart:
    """Return a motion's numbers as rationals, those in ``exact`` in place of its doubles.

    Raises:
        InvalidInput: for a batch, or exact numbers that are not those of the motion.
    """
    if motion.batch_shape:
        raise InvalidInput(f"`system` must be one motion, no batch; got {motion.batch_shape} of them. Certify one.")
    plain = motion.along("principal")
    doubles: dict[str, Any] = {"moments": plain.moments, "momentum": plain.momentum_at_epoch,
                               "attitude": plain.attitude_at_epoch, "epoch": plain.epoch}  # fmt: skip
    doubles |= {name: getattr(plain, name) for name in plain.body_numbers}
    doubles = {name: np.asarray(value, dtype=float).ravel() for name, value in doubles.items()}
    numbers = {name: exact_rationals(name, value.tolist(), len(value)) for name, value in doubles.items()}
    taken = dict.fromkeys(numbers, DOUBLES)
    for name, given in _check_exact(exact, numbers).items():
        _check_near(name, given, doubles[name])
        numbers[name], taken[name] = given, GIVEN
    axes = None
    if motion.axes is not None:
        quaternion = rotation.from_matrix(np.asarray(motion.axes))
        axes = exact_rationals("axes", quaternion.tolist(), 4)
    return MotionStart(numbers["moments"], numbers["momentum"], numbers["attitude"], numbers["epoch"][0],
                       {name: numbers[name][0] for name in plain.body_numbers}, axes, taken)


def _check_exact(exact: Mapping[str, Any] | None, doubles: dict[str, list[Rational]]) -> dict[str, list[Rational]]:
    """Return exact numbers by the names of the motion's own; an angular velocity becomes a momentum."""
    exact = {} if exact is None else exact
    names = [*doubles, "angular_velocity"]
    if not isinstance(exact, Mapping) or not set(exact) <= set(names) or {"momentum", "angular_velocity"} <= set(exact):
        raise InvalidInput(f"`exact` must be exact numbers by the names of what the motion was made of, some of "
                           f"{', '.join(names)}, one of the last and momentum; got {shown(exact)}.")
    sizes = {name: len(value) for name, value in doubles.items()} | {"angular_velocity": 3}
    rationals = {name: exact_rationals(f"exact[{name}]", value, sizes[name]) for name, value in exact.items()}
    if (velocity := rationals.pop("angular_velocity", None)) is not None:
        moments = rationals.get("moments", doubles["moments"])
        rationals["momentum"] = [w * i for w, i in zip(velocity, moments, strict=True)]
    return rationals


def _check_near(name: str, given: list[Rational], doubles: np.ndarray) -> None:
    """Refuse exact numbers that are not those of the motion."""
    nearest = np.array([nearest_double(Fraction(int(x.p), int(x.q))) for x in given])
    if name == "attitude":
        norm = float(np.linalg.norm(nearest))
        nearest = nearest / (norm or 1.0)
    if not (np.abs(nearest - doubles) <= LIMITS.max_rounding * np.abs(doubles).max()).all():
        raise InvalidInput(f"`exact[{name}]` must be the numbers that the motion was made of, to the last digit of "
                           f"doubles; got {nearest.tolist()} in place of {doubles.tolist()}. Give them along the "
                           "principal axes, in the order of `moments`.")


def refine_named(compute: Callable[[], dict[str, Wanted]], digits: int) -> dict[str, EnclosedNumber]:
    """Return enclosed numbers by name, as ``refine`` computes them."""
    names: list[str] = []

    def compute_balls() -> list[Wanted]:
        wanted = compute()
        names[:] = wanted
        return list(wanted.values())

    balls = refine(compute_balls, digits)
    return {name: EnclosedNumber(ball, digits) for name, ball in zip(names, balls, strict=True)}
