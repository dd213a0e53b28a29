"""The motion and the parts of a top that its figures draw."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, NamedTuple, TypeGuard

import numpy as np

from polhode import rotation
from polhode.analysis.top_motion import is_steady_precession
from polhode.errors import InvalidInput
from polhode.errors import shown as in_words
from polhode.motion._inputs import finite
from polhode.motion._trajectory import Trajectory
from polhode.motion.exact import ExactMotion
from polhode.systems.heavy_top import HeavyTop
from polhode.types import Array, Float64

if TYPE_CHECKING:
    from polhode.exact.lagrange_top import LagrangeMotion

PERIODS = 4  # drawn at most
SAMPLES = 6000
REMEDY = "Sample a LagrangeMotion, or simulate a HeavyTop with its attitude."


@dataclass(frozen=True, eq=False)
class TopShown:
    """One top's motion, along the principal axes at its fixed point.

    Attributes:
        trajectory: its samples.
        exact: the motion in closed form, or None.
        axis: (3,) unit vector from the fixed point to the centre of mass; of a Lagrange top its third axis.
        weightless: whether nothing pulls at it.
    """

    trajectory: Trajectory
    exact: LagrangeMotion | None
    axis: Float64[Array, "3"]
    weightless: bool

    @property
    def constant_tilt(self) -> bool:
        """Whether the axis goes round at constant tilt."""
        return self.exact is not None and is_steady_precession(self.exact)

    @property
    def axis_in_space(self) -> Float64[Array, "time 3"]:
        """(T, 3) of the samples."""
        return rotation.rotate(np.asarray(self.trajectory.attitude), self.axis)


def take_top(shown: LagrangeMotion | Trajectory) -> TopShown:
    """Return one top's motion as the figures draw it.

    Args:
        shown: samples, or a motion, of which four nutations are taken; four turns where it does not nutate.

    Raises:
        InvalidInput: for the motion of anything but a top, a batch, or one without samples.
    """
    if not (isinstance(shown, Trajectory) or _is_lagrange(shown)):
        raise InvalidInput(f"the figure is of a top; got {in_words(shown)}. {REMEDY}")
    trajectory = (shown if isinstance(shown, Trajectory) else _sample(shown)).along("principal")
    if trajectory.batch_shape or not len(trajectory):
        raise InvalidInput(
            f"the figure is of one top at one time at least; got {len(trajectory)} samples of a batch of shape "
            f"{trajectory.batch_shape}. Take one top, and give it times."
        )
    source = trajectory.source
    if _is_lagrange(source):
        return TopShown(trajectory, source, np.array([0.0, 0.0, 1.0]), float(source.mgl) == 0.0)
    if not isinstance(source, HeavyTop) or trajectory.attitude is None:
        origin = "a file" if source is None else type(source).__name__
        without = " without attitude" if isinstance(source, HeavyTop) else ""
        raise InvalidInput(f"the figure is of a top; got a trajectory of {origin}{without}. {REMEDY}")
    return TopShown(trajectory, None, np.asarray(source.axis), float(source.mgl) == 0.0)


def _is_lagrange(shown: Any) -> TypeGuard[LagrangeMotion]:
    """Whether it is a Lagrange top's motion, whose closed form is imported for other exact motions alone."""
    if not isinstance(shown, ExactMotion):
        return False
    from polhode.exact.lagrange_top import LagrangeMotion

    return isinstance(shown, LagrangeMotion)


def _sample(motion: LagrangeMotion) -> Trajectory:
    if motion.batch_shape:
        raise InvalidInput(f"the figure is of one top; got a batch of shape {motion.batch_shape}. Take one of it.")
    return motion.sample(float(motion.epoch) + np.linspace(0.0, PERIODS * motion.cycle, SAMPLES))


class Followed(NamedTuple):
    """The part of a top's motion that is drawn, space axes.

    Attributes:
        attitude: (T, 4).
        axis: (T, 3) unit vector from the pivot to the centre of mass.
        momentum: (T, 3) about the pivot [kg m²/s].
        velocity: (T, 3) angular velocity [rad/s].
        limits: heights of the circles that bound the axis, where known.
        words: which part it is, beginning with a comma; empty for all of it.
    """

    attitude: Float64[Array, "time 4"]
    axis: Float64[Array, "time 3"]
    momentum: Float64[Array, "time 3"]
    velocity: Float64[Array, "time 3"]
    limits: list[float]
    words: str


def sample_axis(top: TopShown) -> Followed:
    """Return the first nutations of a Lagrange top, finely sampled, or all samples of another top."""
    exact = top.exact
    if exact is None:
        motion = top.trajectory
        attitude = np.asarray(motion.attitude)
        momentum = rotation.rotate(attitude, np.asarray(motion.momentum))
        velocity = rotation.rotate(attitude, np.asarray(motion.angular_velocity))
        return Followed(attitude, top.axis_in_space, momentum, velocity, [], "")
    start, end = float(top.trajectory.times[0]), float(top.trajectory.times[-1])
    words = ""
    period = finite(exact.nutation_period)
    if period is not None and end - start > PERIODS * period:
        end = start + PERIODS * period
        words = f", first {end - start:.3g} s" if top.constant_tilt else f", first {PERIODS} nutations"
    attitude, momentum = exact.state(np.linspace(start, end, SAMPLES))
    # at constant tilt the path itself is the circle
    limits = [] if top.constant_tilt else [float(x) for x in exact.nutation_limits if x is not None and abs(x) < 1.0]
    up, L, omega = (rotation.rotate(attitude, v) for v in ([0.0, 0.0, 1.0], momentum, momentum / exact.moments))
    return Followed(attitude, up, L, omega, limits, words)
