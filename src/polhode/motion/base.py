"""The base class of exact motions."""

from __future__ import annotations

import abc
import math
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any, ClassVar, NamedTuple, TypeVar

import numpy as np

from polhode import rotation
from polhode._base.arrays import always, as_float64, compiled, is_jax, namespace
from polhode.errors import InvalidInput
from polhode.motion._axes import PlainTurn, Turn, chosen_axes, shared_axes
from polhode.motion._fields import broadcast_fields, register_fields
from polhode.motion._inputs import (
    MOST_RADIANS,
    cached_unless_traced,
    checked,
    checked_last_axis,
    checked_sample_times,
    checked_times,
    common_shape,
    momentum_of,
    refuse_not_finite,
    refuse_overflow,
    refuse_tensor,
    spin_of,
)
from polhode.motion._invariants import drift
from polhode.motion._layout import ATTITUDE, MOMENTUM, Quantity, StateLayout
from polhode.motion._plan import MotionPlan, Stepping
from polhode.motion._trajectory import Trajectory
from polhode.motion.exact import ExactMotion
from polhode.special._doubledouble import two_sum
from polhode.types import Array, ArrayLike, Float64, Real

MOST_TIME = 1e300  # s, where a body at rest, or hardly turning, is too
PLAIN = (float, int, np.float64)  # numbers that are one time
CYCLES, SAMPLES = 10, 2000  # of a motion without times


class _Alone(NamedTuple):
    """Constants from which the states of one body at one time are computed, without the overhead of arrays."""

    column: tuple[float, ...]
    epoch: float
    fastest: float
    turn: PlainTurn | None

    def holds(self, t: float) -> bool:
        """Return whether a time is within the range of phases; the code for arrays refuses other times."""
        return bool(abs(t) <= min(MOST_RADIANS / max(self.fastest, 1e-300), MOST_TIME))


Motion = TypeVar("Motion", bound="AbstractMotion")


def _elapsed(t: Array, epoch: Array) -> tuple[Array, Array]:
    """Return the time since the epoch, in two parts."""
    # t − epoch exactly, as a sum of two doubles: its rounding, 1e-16 of the times, would become one of the phase
    return (t, np.zeros(())) if always(epoch, 0.0) and isinstance(t, np.ndarray) else two_sum(t, -epoch)


@dataclass(frozen=True, eq=False, init=False)
class AbstractMotion(ExactMotion):
    """A motion of rigid bodies in closed form, at any time: no step, no drift.

    Subclasses are final, frozen, and pytrees of JAX: their leaves are the fields below, from which all else is computed
    when it is needed. JAX arrays among them all have the axes of a batch, as ``vmap`` takes them apart. All vectors
    are along the body's axes that ``axes`` tells, ``moments`` alone are about the principal ones.

    A motion of one's own is a subclass. It names by ``body_numbers`` what a body is made of beyond its moments, has a
    constructor that hands these to this one, and gives its closed form along the principal axes: ``closed_form``,
    ``fastest_rate``, ``cycle``, ``quantities`` and ``conserved_along``, from ``moments``, its own numbers and
    ``principal_start``. ``checked_start`` and ``conserved_sizes`` may be left as they are.
    ``polhode.testing.check_motion`` checks it.

    Attributes:
        title: name of such a motion.
        kind: the kind of spec whose pictures show it, by its name; empty for none.
        page_solver: the page's name of the solver for such a motion; empty for none.
        has_vertical: whether space has an upward direction, as under gravity.
        body_numbers: the attributes (…) that say, with the moments, what the body is.
        moments: (…, 3) principal moments [kg m²].
        momentum_at_epoch: (…, 3) [kg m²/s, body axes].
        attitude_at_epoch: (…, 4) unit quaternion wxyz, body → space.
        epoch: (…) time at which these hold [s].
        axes: (3, 3) principal axes by columns in those that vectors and attitude are along, or (…, 3, 3) for each body;
            None where these are the principal axes themselves.
        given_axes: (3, 3) principal axes by columns in the body's given ones; None where no others are known.
    """

    title: ClassVar[str] = "Motion"
    kind: ClassVar[str] = ""
    page_solver: ClassVar[str] = ""
    has_vertical: ClassVar[bool] = False
    body_numbers: ClassVar[tuple[str, ...]] = ()
    moments: Float64[Array, "... 3"]
    momentum_at_epoch: Float64[Array, "... 3"]
    attitude_at_epoch: Float64[Array, "... 4"]
    epoch: Float64[Array, "..."]
    axes: Float64[Array, "*turns 3 3"] | None
    given_axes: Float64[Array, "*turns 3 3"] | None = field(repr=False, init=False)

    def __init__(
        self, moments: ArrayLike, numbers: dict[str, ArrayLike], momentum: ArrayLike | None, attitude: ArrayLike | None,
        epoch: ArrayLike, angular_velocity: ArrayLike | None, axes: ArrayLike | None,
    ) -> None:
        """Check the arguments, and set all fields.

        Args:
            moments: (…, 3) [kg m²].
            numbers: (…) those of ``body_numbers``, by name and in that order.
            momentum: (…, 3) at the epoch [kg m²/s, body axes]; None where ``angular_velocity`` is given.
            attitude: (…, 4) at the epoch; None for the identity.
            epoch: (…) [s].
            angular_velocity: (…, 3) [rad/s, body axes], or None.
            axes: (…, 3, 3) the principal axes by columns in those that vectors and attitude are along, or None.

        Raises:
            InvalidInput: for values that no motion has, and those that ``checked_start`` refuses.
        """
        attitude = (1.0, 0.0, 0.0, 0.0) if attitude is None else attitude
        name, vector = spin_of(momentum, angular_velocity)
        named = {"moments": moments, **numbers, name: vector, "attitude": attitude, "epoch": epoch}
        xp = namespace(*named.values())
        arrays = {key: as_float64(xp, value, key) for key, value in named.items()}
        moments, vector, attitude, epoch = (arrays[key] for key in ("moments", name, "attitude", "epoch"))
        refuse_tensor(moments, vector)
        vector = checked_last_axis(name, vector, 3)
        if axes is not None:
            axes = as_float64(xp, axes, "axes")
            to_principal = Turn.to(axes)
            with np.errstate(over="ignore", invalid="ignore"):  # what is not finite is refused below
                attitude = to_principal.attitude(checked_last_axis("attitude", attitude, 4))
                vector = to_principal.vector(vector)
        momentum = vector if angular_velocity is None else momentum_of(moments, vector)
        moments, momentum, attitude = checked(xp, moments, momentum, attitude, epoch)
        own = {key: arrays[key] for key in numbers}
        if own:
            refuse_not_finite(**own)
            common_shape(moments=moments[..., 0], **own, momentum=momentum[..., 0], epoch=epoch)
        self._hold(*self.checked_start(xp, (moments, *own.values()), momentum, attitude), epoch, axes, axes)

    def checked_start(
        self, xp: Any, body: tuple[Array, ...], momentum: Array, attitude: Array
    ) -> tuple[tuple[Float64[Array, "..."], ...], Float64[Array, "... 3"], Float64[Array, "... 4"]]:
        """Return body, momentum and attitude along the principal axes as the closed form takes them.

        A subclass overrides it to refuse what it does not cover; what JAX traces has no values to look at.

        Args:
            xp: the namespace of the arrays, as NumPy or ``jax.numpy``.
            body: moments (…, 3) and the own numbers (…), finite.
            momentum: (…, 3) [kg m²/s].
            attitude: (…, 4).

        Raises:
            InvalidInput: for values that this motion does not cover.
        """
        return body, momentum, attitude

    def _hold(self, body: tuple[Array, ...], momentum: Array, attitude: Array, epoch: Array,
              axes: Array | None, given_axes: Array | None) -> None:
        """Set all fields from momentum and attitude along the principal axes."""
        if is_jax(momentum):
            cores, same = (1, *(0 for _ in self.body_numbers), 1, 1, 0, 2, 2), given_axes is axes
            *numbers, momentum, attitude, epoch, axes, given_axes = broadcast_fields(
                (*body, momentum, attitude, epoch, axes, given_axes), cores
            )
            body, given_axes = tuple(numbers), axes if same else given_axes
        vars(self).update(axes=axes, given_axes=given_axes, epoch=epoch, _principal=(momentum, attitude))
        vars(self).update(zip(("moments", *self.body_numbers), body, strict=True))
        attitude, momentum = self._turned(attitude, momentum)
        vars(self).update(momentum_at_epoch=momentum, attitude_at_epoch=attitude)
        register_fields(type(self), self.body_numbers)

    @cached_unless_traced
    def _principal(self) -> tuple[Array, Array]:
        """Momentum and attitude along the principal axes, which the constructor sets.

        JAX makes motions of fields alone, of anything while it looks at their structure. Their momentum and attitude
        are computed here, when they are first needed, with the checks of the constructor.
        """
        for name in (*self.body_numbers, "epoch"):
            if isinstance(value := getattr(self, name), float | int):  # as somebody has put it there
                vars(self)[name] = np.asarray(float(value))
        numbers = {name: getattr(self, name) for name in self.body_numbers}
        new = object.__new__(type(self))
        AbstractMotion.__init__(new, self.moments, numbers, self.momentum_at_epoch, self.attitude_at_epoch, self.epoch,
                                None, self.axes)
        return new._principal

    # ------------------------------------------------------------------ the closed form, along the principal axes

    @property
    def _arguments(self) -> tuple[Array, ...]:
        """Arguments of the closed form, each (…, k): moments, numbers of the body, momentum and attitude at epoch."""
        principal = self._principal
        numbers = (getattr(self, name)[..., None] for name in self.body_numbers)
        return (self.moments, *numbers, *principal)

    @property
    def principal_start(self) -> tuple[Float64[Array, "... 4"], Float64[Array, "... 3"]]:
        """Attitude (…, 4) and momentum (…, 3) [kg m²/s] at the epoch, along the principal axes."""
        momentum, attitude = self._principal
        return attitude, momentum

    @cached_property
    def _columns(self) -> Any:
        """The constants of the motion, found when they are first needed; None where there are no compiled kernels."""
        return self._columns_of()

    @cached_property
    def _alone(self) -> _Alone | None:
        """Constants from which states of one body are computed with plain numbers; None for other motions."""
        if self.batch_shape or is_jax(*self._arguments, self.epoch) or self._columns is None:
            return None
        # the same turn as of arrays, in plain numbers
        turn = None if self.axes is None else self._from_principal.plain()
        return _Alone(tuple(self._columns.tolist()), float(self.epoch), float(self.fastest_rate), turn)

    def _columns_of(self) -> Any:
        """Return the constants of the motion, flat columns of the bodies' common shape; None without kernels."""
        return None

    def _state_of(self, column: tuple[float, ...], elapsed: float, rest: float) -> tuple[float, ...]:
        """Return attitude and momentum, seven numbers, of one body with these constants."""
        raise NotImplementedError(f"{type(self).__name__} has constants of one body, and no `_state_of` for them.")

    @abc.abstractmethod
    def closed_form(
        self, elapsed: Float64[Array, "..."], rest: Float64[Array, "..."]
    ) -> tuple[Float64[Array, "... 4"], Float64[Array, "... 3"]]:
        """Return attitude (…, 4) and momentum (…, 3) [kg m²/s] at a time since the epoch, along the principal axes.

        Args:
            elapsed: (…) time since the epoch [s], which broadcasts against the bodies' numbers (…).
            rest: what the difference of time and epoch has beyond a double's digits [s]; a closed form that is to have
                all digits at 10⁹ turns adds it to its phases.
        """

    @property
    @abc.abstractmethod
    def fastest_rate(self) -> Float64[Array, "..."]:
        """(…) about how fast the bodies turn [rad/s], by which times are refused that are beyond all phases."""

    @property
    @abc.abstractmethod
    def cycle(self) -> float:
        """One period of one body's motion [s]; a swing or a turn where it has none, a tenth of a second at rest."""

    def _turn(self) -> float:
        velocity = float(np.linalg.norm(np.asarray(self._principal[0]) / np.asarray(self.moments)))
        return 2.0 * math.pi / velocity if velocity else 0.1

    @property
    @abc.abstractmethod
    def quantities(self) -> dict[str, Quantity]:
        """Unit and meaning of what the motion conserves, by name."""

    @abc.abstractmethod
    def conserved_along(
        self, attitude: Array, momentum: Array, angular_velocity: Array
    ) -> dict[str, Float64[Array, "..."]]:
        """Return what is conserved at samples, numbers (…, T) or vectors (…, T, 3), by the names of ``quantities``.

        Args:
            attitude: (…, T, 4).
            momentum: (…, T, 3) [kg m²/s, principal axes].
            angular_velocity: (…, T, 3) [rad/s, principal axes].
        """

    def conserved_sizes(
        self, attitude: Array, momentum: Array, angular_velocity: Array
    ) -> dict[str, Float64[Array, "..."]]:
        """Return the sizes (…, 1) to which drifts are relative, by name; the first sample's own for names left out."""
        return {}

    def _drift(self, xp: Any, values: dict[str, Array], sizes: dict[str, Array], axes: int) -> dict[str, Any]:
        """Return the drift of what is conserved; a vector has an axis more than the ``axes`` of samples."""
        return {name: drift(xp, value, value.ndim > axes, sizes.get(name)) for name, value in values.items()}

    # ------------------------------------------------------------------ what every motion offers

    @property
    def batch_shape(self) -> tuple[int, ...]:
        """The common shape of the bodies, () for one."""
        vectors = (self.moments, self.momentum_at_epoch, self.attitude_at_epoch)
        numbers = (self.epoch, *(getattr(self, name) for name in self.body_numbers))
        turns = () if self.axes is None else np.shape(self.axes)[:-2]
        shapes = {turns, *(np.shape(v)[:-1] for v in vectors), *map(np.shape, numbers)}
        return () if shapes == {()} else tuple(np.broadcast_shapes(*shapes))  # of one body in a loop the call counts

    @property
    def free_moments(self) -> Float64[Array, "... 3"] | None:
        """(…, 3) principal moments of a body without torques; None for others."""
        return None

    def state(self, t: Real[ArrayLike, "..."]) -> tuple[Float64[Array, "*batch 4"], Float64[Array, "*batch 3"]]:
        """Return attitude (…, 4) and momentum (…, 3) at the times [s]; one evaluation gives both.

        The quaternion equals the given one over its length at the epoch, sign included. At other times its
        sign is continuous in t, except where a rate times t exceeds 2⁵⁰ turns.

        Raises:
            InvalidInput: for times that are not finite.
        """
        if (numbers := self._numbers_at(t)) is None:
            return self._turned(*self._principal_state(t))
        turn = self._alone.turn  # type: ignore[union-attr]
        components = np.array(numbers if turn is None else (*turn.attitude(numbers[:4]), *turn.vector(numbers[4:])))
        return components[:4], components[4:]

    def _numbers_at(self, t: Any) -> tuple[float, ...] | None:
        """Return attitude and momentum along the principal axes at one time; None where arrays are needed."""
        if type(t) not in PLAIN or (one := self._alone) is None or not one.holds(t):
            return None
        numbers = self._state_of(one.column, *two_sum(float(t), -one.epoch))
        return numbers if math.isfinite(numbers[0]) else None

    def _principal_state(self, t: Real[ArrayLike, "..."]) -> tuple[Array, Array]:
        """Return attitude (…, 4) and momentum (…, 3) along the principal axes."""
        xp = namespace(t, self.moments)
        t = checked_times(xp, t, self.batch_shape)
        attitude, momentum = self.closed_form(*compiled(_elapsed, t if is_jax(t) else self.epoch)(t, self.epoch))
        if attitude.shape[:-1] != momentum.shape[:-1]:  # where only one of them changes with time
            shape = np.broadcast_shapes(attitude.shape[:-1], momentum.shape[:-1])
            attitude, momentum = (xp.broadcast_to(v, (*shape, v.shape[-1])) for v in (attitude, momentum))
        refuse_overflow(attitude, t, lambda: self.fastest_rate)
        return attitude, momentum

    def attitude(self, t: Real[ArrayLike, "..."]) -> Float64[Array, "... 4"]:
        """Return the attitude (…, 4), unit quaternions wxyz, body → space."""
        return self.state(t)[0]

    def momentum(self, t: Real[ArrayLike, "..."]) -> Float64[Array, "... 3"]:
        """Return the angular momentum (…, 3) [kg m²/s, body axes]."""
        return self.state(t)[1]

    def angular_velocity(self, t: Real[ArrayLike, "..."]) -> Float64[Array, "... 3"]:
        """Return the angular velocity (…, 3) [rad/s, body axes]."""
        numbers = self._numbers_at(t)
        velocity = (self._principal_state(t)[1] if numbers is None else np.array(numbers[4:])) / self.moments
        if self.axes is None:
            return velocity
        if numbers is None:
            return self._from_principal.vector(velocity)
        return np.array(self._from_principal.plain().vector(velocity.tolist()))

    def rotation_matrix(self, t: Real[ArrayLike, "..."]) -> Float64[Array, "... 3 3"]:
        """Return the rotation matrix (…, 3, 3), body → space."""
        return rotation.as_matrix(self.state(t)[0])

    def sample(self, times: Real[ArrayLike, "time"] | None = None) -> Trajectory:
        """Return the motion at times (T,) [s] as a trajectory, with the drift of its invariants.

        Without times, of one body: 2000 samples of ten cycles from the epoch on, as of a spec without ``[time]``.

        Raises:
            InvalidInput: for times that are not finite, not one-dimensional, or none, and without times for a batch.
        """
        own, given = shared_axes(self.axes), shared_axes(self.given_axes)
        if times is None:
            if self.batch_shape:
                raise InvalidInput(
                    f"`times` must be given for a batch of bodies, here of shape {self.batch_shape}: each has its own "
                    "periods."
                )
            times = float(self.epoch) + np.linspace(0.0, CYCLES * self.cycle, SAMPLES)
        xp = namespace(times, self.moments)
        times = checked_sample_times(xp, times)
        motion = self._with_time_axis()
        attitude, momentum = motion._principal_state(times)
        velocity = momentum / motion.moments
        invariants = motion.conserved_along(attitude, momentum, velocity)
        sizes = motion.conserved_sizes(attitude, momentum, velocity)
        trajectory = Trajectory(
            times=times,
            states=xp.concat([attitude, momentum], axis=-1),
            layout=StateLayout((ATTITUDE, MOMENTUM)),
            attitude=attitude,
            momentum=momentum,
            angular_velocity=velocity,
            invariants=invariants,
            drift=motion._drift(xp, invariants, sizes, momentum.ndim - 1),
            quantities=self.quantities,
            source=self._standing(None),
            plan=MotionPlan(Stepping.CLOSED_FORM, type(self).__name__, copies=math.prod(self.batch_shape)),
            given_axes=given,
        )
        return trajectory.turn_to(own)

    def along(self: Motion, axes: str | Real[ArrayLike, "3 3"]) -> Motion:
        """Return the same motion with vectors and attitude along other axes of the body.

        Args:
            axes: "principal" for the principal axes, in the order of ``moments``; "given" for the body's given ones; or
                axes by columns in the given ones. Of a motion that is not made from a body both are the same.

        Raises:
            InvalidInput: for axes that are none of these.
        """
        return self._standing(chosen_axes(axes, self.given_axes))

    def _standing(self: Motion, axes: Array | None) -> Motion:
        """Return the same motion along other axes, in which the columns of ``axes`` are the principal ones."""
        if axes is self.axes:
            return self
        body = (self.moments, *(getattr(self, name) for name in self.body_numbers))
        return self._of(body, *self._principal, self.epoch, axes, self.given_axes)

    def _with_time_axis(self: Motion) -> Motion:
        """Return the same motion along the principal axes, with a last batch axis of length 1 for times."""
        vectors = (self.moments, *self._principal)
        moments, momentum, attitude = (v[..., None, :] if v.ndim > 1 else v for v in vectors)
        numbers = (*(getattr(self, name) for name in self.body_numbers), self.epoch)
        *numbers, epoch = (v[..., None] if v.ndim else v for v in numbers)
        return self._of((moments, *numbers), momentum, attitude, epoch, None, None)

    @classmethod
    def _of(cls: type[Motion], *fields: Any) -> Motion:
        """Return the motion of checked fields, as ``_hold`` takes them."""
        motion = object.__new__(cls)
        motion._hold(*fields)
        return motion

    @cached_unless_traced
    def _from_principal(self) -> Turn:
        """The turn from the principal axes to those of vectors and attitude."""
        return Turn.to(namespace(self._principal[0], self.axes).asarray(self.axes)).back

    def _turned(self, attitude: Array, momentum: Array) -> tuple[Array, Array]:
        """Return attitude and momentum of the principal axes as those of the motion's own."""
        if self.axes is None:
            return attitude, momentum
        return self._from_principal.attitude(attitude), self._from_principal.vector(momentum)
