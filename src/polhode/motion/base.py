"""What every exact motion offers."""

from __future__ import annotations

import abc
from typing import TYPE_CHECKING, Any, ClassVar

import numpy as np

from polhode import rotation
from polhode.arrays import namespace
from polhode.motion.inputs import checked_sample_times
from polhode.motion.layout import ATTITUDE, MOMENTUM, Quantity, StateLayout
from polhode.types import Array, ArrayLike, Float64, Real

if TYPE_CHECKING:
    from polhode.motion.trajectory import Trajectory



class AbstractMotion(abc.ABC):
    """A motion of rigid bodies in closed form, at any time: no step, no drift.

    Subclasses are final, frozen, and pytrees of JAX where their arrays are JAX's. All vectors are along the body's axes
    that ``axes`` tells, ``moments`` alone are about the principal ones.

    Attributes:
        title: what such a motion is called.
        has_vertical: whether space has an up of its own, as under gravity.
        moments: (…, 3) principal moments [kg m²].
        momentum_at_epoch: (…, 3) [kg m²/s, body axes].
        attitude_at_epoch: (…, 4) unit quaternion wxyz, body → space.
        epoch: (…) time at which these hold [s].
        axes: (3, 3) principal axes by columns in the body's given ones, which vectors and attitude are then along; None
            where they are along the principal axes themselves.
    """

    title: ClassVar[str] = "Motion"
    has_vertical: ClassVar[bool] = False
    moments: Float64[Array, "... 3"]
    momentum_at_epoch: Float64[Array, "... 3"]
    attitude_at_epoch: Float64[Array, "... 4"]
    epoch: Float64[Array, "..."]
    axes: Float64[Array, "3 3"] | None

    @abc.abstractmethod
    def state(self, t: Real[ArrayLike, "..."]) -> tuple[Float64[Array, "*batch 4"], Float64[Array, "*batch 3"]]:
        """Return attitude (…, 4) and momentum (…, 3) at the times [s]; one evaluation gives both."""

    @property
    @abc.abstractmethod
    def batch_shape(self) -> tuple[int, ...]:
        """The common shape of the bodies, () for one."""

    @property
    def free_moments(self) -> Float64[Array, "... 3"] | None:
        """(…, 3) principal moments of a body that nothing acts on; None of any other."""
        return None

    @property
    @abc.abstractmethod
    def quantities(self) -> dict[str, Quantity]:
        """Unit and meaning of what the motion conserves, by name."""

    @abc.abstractmethod
    def along_principal_axes(self) -> AbstractMotion:
        """Return the same motion with vectors and attitude along the principal axes, in the order of ``moments``."""

    @abc.abstractmethod
    def _with_time_axis(self) -> AbstractMotion:
        """Return the same motion with a last batch axis of length 1 for times."""

    @abc.abstractmethod
    def _invariants(self, attitude: Array, momentum: Array, velocity: Array) -> tuple[dict[str, Array], dict[str, Any]]:
        """Return what is conserved at samples (…, T, k), by name, and by how much it drifts."""

    def attitude(self, t: Real[ArrayLike, "..."]) -> Float64[Array, "... 4"]:
        """Return the attitude (…, 4), unit quaternions wxyz, body → space."""
        return self.state(t)[0]

    def momentum(self, t: Real[ArrayLike, "..."]) -> Float64[Array, "... 3"]:
        """Return the angular momentum (…, 3) [kg m²/s, body axes]."""
        return self.state(t)[1]

    def angular_velocity(self, t: Real[ArrayLike, "..."]) -> Float64[Array, "... 3"]:
        """Return the angular velocity (…, 3) [rad/s, body axes]."""
        return self._angular_velocity_of(self.state(t)[1])

    def rotation_matrix(self, t: Real[ArrayLike, "..."]) -> Float64[Array, "... 3 3"]:
        """Return the rotation matrix (…, 3, 3), body → space."""
        return rotation.as_matrix(self.state(t)[0])

    def sample(self, times: Real[ArrayLike, "time"]) -> Trajectory:
        """Return the motion at times (T,) [s] as a trajectory, with what its invariants drift by.

        Raises:
            InvalidInput: for times that are not finite, not one-dimensional, or none.
        """
        from polhode.motion.trajectory import Trajectory  # a trajectory knows what an exact motion is

        xp = namespace(times, self.moments)
        times = checked_sample_times(xp, times)
        motion = self._with_time_axis()
        attitude, momentum = motion.state(times)
        velocity = motion._angular_velocity_of(momentum)
        invariants, drift = motion._invariants(attitude, momentum, velocity)
        return Trajectory(
            times=times,
            states=xp.concat([attitude, momentum], axis=-1),
            layout=StateLayout((ATTITUDE, MOMENTUM)),
            attitude=attitude,
            momentum=momentum,
            angular_velocity=velocity,
            invariants=invariants,
            drift=drift,
            quantities=self.quantities,
            source=self,
        )

    def _angular_velocity_of(self, momentum: Float64[Array, "*#batch 3"]) -> Float64[Array, "*batch 3"]:
        if self.axes is None:
            return momentum / self.moments
        axes = namespace(momentum, self.axes).asarray(self.axes)
        return ((momentum @ axes) / self.moments) @ axes.T

    def _common_shape(self, *vectors: Array) -> tuple[int, ...]:
        return tuple(np.broadcast_shapes(*(v.shape[:-1] for v in vectors), self.epoch.shape))
