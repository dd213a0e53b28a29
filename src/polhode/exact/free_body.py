"""The free rigid body, exact at any time."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import numpy as np

from polhode import rotation
from polhode.arrays import as_float64, is_traced, namespace, register_node
from polhode.bodies.body import Body
from polhode.errors import InvalidInput
from polhode.exact import evaluation, geometry
from polhode.special.doubledouble import two_sum
from polhode.trajectory import Trajectory

Array = Any
UNIT_TOLERANCE = 1e-6  # a quaternion further from unit length is taken for a mistake, not for rounding


@dataclass(frozen=True, eq=False)
class FreeMotion:
    """Torque-free motion of rigid bodies in closed form: dL/dt = L × Ω, L = IΩ, dR/dt = R hat(Ω).

    The attitude quaternion is evaluated as a quotient of theta functions whose phases are kept in double-double, so
    that the error is a few units in the last place at any time and for any positive moments: no step, no drift. All
    components are along the principal axes, in the order of ``moments``; they may come in any order.

    Args:
        moments: (…, 3) principal moments [kg m²], positive.
        momentum: (…, 3) angular momentum at the epoch [kg m²/s, principal axes].
        attitude: (…, 4) unit quaternion wxyz at the epoch, body → space.
        epoch: (…) time at which these hold [s].

    Batch axes of all four are broadcast against each other, and times against them: one body at many times t (T,);
    many bodies each at its time t (N,); all with all: momentum (N, 1, 3), t (T,). JAX arrays in, JAX arrays out, with
    ``jit``, ``vmap`` and derivatives through moments, momentum, attitude, epoch and time.

    Scalar answers such as ``period`` are floats for one body, None where infinite or undefined; in batches they are
    arrays with inf where infinite and NaN where undefined.

    Raises:
        InvalidInput: for moments that are not positive and finite, values that are not finite, or a quaternion that is
            not of unit length. Traced JAX values cannot be looked at; bad ones give NaN.

    Source: Jacobi 1849; Klein & Sommerfeld, *Theorie des Kreisels*; van Zon & Schofield, J. Comput. Phys. 225 (2007)
    145.

    >>> motion = FreeMotion((1.0, 2.0, 3.0), (0.3, 1.8, 1.5))
    >>> motion.regime, round(motion.period, 12)
    ('short-axis', 10.680120081384)
    """

    moments: Array
    momentum_at_epoch: Array
    attitude_at_epoch: Array
    epoch: Array
    axes: Array | None = None
    _columns: tuple[Array, ...] = field(default=(), repr=False)

    def __init__(
        self, moments: Array, momentum: Array, attitude: Array = (1.0, 0.0, 0.0, 0.0), epoch: Array = 0.0
    ) -> None:
        xp = namespace(moments, momentum, attitude, epoch)
        named = {"moments": moments, "momentum": momentum, "attitude": attitude, "epoch": epoch}
        moments, momentum, attitude, epoch = (as_float64(xp, value, name) for name, value in named.items())
        moments, momentum, attitude = _checked(xp, moments, momentum, attitude, epoch)
        self._hold(moments, momentum, attitude, epoch, None)

    def _hold(self, moments: Array, momentum: Array, attitude: Array, epoch: Array, axes: Array | None) -> None:
        values = {"moments": moments, "momentum_at_epoch": momentum, "attitude_at_epoch": attitude, "epoch": epoch}
        for name, value in (values | {"axes": axes}).items():
            object.__setattr__(self, name, value)
        register_node(FreeMotion, (*values, "axes", "_columns"), like=moments)
        object.__setattr__(self, "_columns", evaluation.motion_columns(moments, momentum, attitude))

    @classmethod
    def from_body(
        cls,
        body: Body,
        angular_velocity: Array | None = None,
        momentum: Array | None = None,
        attitude: Array = (1.0, 0.0, 0.0, 0.0),
        epoch: Array = 0.0,
    ) -> FreeMotion:
        """Return the motion of a body, with vectors and attitude along the body's given axes, in and out.

        Args:
            body: the body.
            angular_velocity: (…, 3) [rad/s, given body axes]; this or ``momentum``.
            momentum: (…, 3) [kg m²/s, given body axes].
            attitude: (…, 4) unit quaternion wxyz, given body axes → space.
            epoch: time at which these hold [s].

        Raises:
            InvalidInput: unless exactly one of angular velocity and momentum is given, or as the class does.
        """
        if (angular_velocity is None) == (momentum is None):
            raise InvalidInput("give exactly one of `angular_velocity` and `momentum` to say how the body spins.")
        if not isinstance(body, Body):
            raise InvalidInput(f"`body` must be a Body; got {body!r}. Make one with polhode.shapes, from_mesh or Body.")
        axes = body.principal_axes
        vector = angular_velocity if momentum is None else momentum
        xp = namespace(vector, attitude, epoch, axes)
        axes = as_float64(xp, axes, "principal axes")
        name = "momentum" if angular_velocity is None else "angular_velocity"
        vector = _last_axis(name, as_float64(xp, vector, name), 3) @ axes
        moments = as_float64(xp, body.principal_moments, "moments")
        principal = vector if angular_velocity is None else vector * moments
        frame = rotation.from_matrix(axes)
        motion = cls(moments, principal, rotation.multiply(as_float64(xp, attitude, "attitude"), frame), epoch)
        object.__setattr__(motion, "axes", axes)
        return motion

    # ------------------------------------------------------------------ evaluation

    def state(self, t: Array) -> tuple[Array, Array]:
        """Return attitude (…, 4) and momentum (…, 3) at the times [s]; one evaluation gives both.

        The quaternion equals the given one at the epoch, sign included. Between, its sign is continuous in t except
        where a rate and time exceed 2⁵⁰ turns.

        Raises:
            InvalidInput: for times that are not finite.
        """
        xp = namespace(t, self.moments)
        t = as_float64(xp, t, "t")
        if not is_traced(t) and not bool(xp.all(xp.isfinite(t))):
            raise InvalidInput("`t` must be finite; got NaN or an infinity. Give times in seconds.")
        _common_shape({"the motion's batch": self.batch_shape, "`t`": tuple(t.shape)})
        elapsed, rest = two_sum(t, -self.epoch)
        arguments = (self.moments, self.momentum_at_epoch, self.attitude_at_epoch)
        attitude, momentum = evaluation.state(self._columns, *arguments, elapsed, rest)
        if not is_traced(attitude) and not bool(xp.all(xp.isfinite(attitude[..., 0]))):
            raise InvalidInput(
                "`t` times the rate of rotation must be within the range of numbers; "
                f"got times up to {float(xp.max(xp.abs(t))):g} s. Check times and rates."
            )
        if self.axes is None:
            return attitude, momentum
        frame = rotation.conjugate(rotation.from_matrix(self.axes))
        return rotation.multiply(attitude, frame), momentum @ xp.asarray(self.axes).T

    def attitude(self, t: Array) -> Array:
        """Return the attitude (…, 4), unit quaternions wxyz, body → space."""
        return self.state(t)[0]

    def momentum(self, t: Array) -> Array:
        """Return the angular momentum (…, 3) [kg m²/s, body axes]."""
        return self.state(t)[1]

    def angular_velocity(self, t: Array) -> Array:
        """Return the angular velocity (…, 3) [rad/s, body axes]."""
        return self._angular_velocity_of(self.state(t)[1])

    def rotation_matrix(self, t: Array) -> Array:
        """Return the rotation matrix (…, 3, 3), body → space."""
        return rotation.as_matrix(self.state(t)[0])

    def _angular_velocity_of(self, momentum: Array) -> Array:
        if self.axes is None:
            return momentum / self.moments
        axes = namespace(momentum, self.axes).asarray(self.axes)
        return ((momentum @ axes) / self.moments) @ axes.T

    def sample(self, times: Array) -> Trajectory:
        """Return the motion at times (T,) [s] as a trajectory, with what its invariants drift by."""
        xp = namespace(times, self.moments)
        times = as_float64(xp, times, "times")
        if times.ndim != 1 or times.shape[0] == 0:
            raise InvalidInput(f"`times` must be one-dimensional and not empty; got shape {tuple(times.shape)}.")
        motion = self._with_time_axis()
        attitude, momentum = motion.state(times)
        velocity = motion._angular_velocity_of(momentum)
        invariants = {
            "energy": 0.5 * xp.sum(momentum * velocity, axis=-1),
            "momentum_norm": _norm(xp, momentum),
            "momentum_space": rotation.rotate(attitude, momentum),
        }
        return Trajectory(
            system=self,
            times=times,
            states=xp.concat([attitude, momentum], axis=-1),
            attitude=attitude,
            momentum=momentum,
            angular_velocity=velocity,
            invariants=invariants,
            drift={name: _drift(xp, value, name == "momentum_space") for name, value in invariants.items()},
        )

    def _with_time_axis(self) -> FreeMotion:
        motion = object.__new__(FreeMotion)
        vectors = (self.moments, self.momentum_at_epoch, self.attitude_at_epoch)
        moments, momentum, attitude = (v[..., None, :] if v.ndim > 1 else v for v in vectors)
        epoch = self.epoch[..., None] if self.epoch.ndim else self.epoch
        motion._hold(moments, momentum, attitude, epoch, self.axes)
        return motion

    # ------------------------------------------------------------------ meaning

    @property
    def batch_shape(self) -> tuple[int, ...]:
        """The common shape of the bodies, () for one."""
        return _batch_shape(self.moments, self.momentum_at_epoch, self.attitude_at_epoch, self.epoch)

    @cached_property
    def _numbers(self) -> geometry.Characteristics:
        return evaluation.characteristics(self.moments, self.momentum_at_epoch)

    def _answer(self, value: Array) -> Any:
        """Return a float or None for one concrete body, the array as it is otherwise."""
        if np.ndim(value) or is_traced(value):
            return value
        number = float(value)
        return number if math.isfinite(number) else None

    @property
    def energy(self) -> Any:
        """Kinetic energy E = Σ L_i²/2I_i [J]."""
        xp = namespace(self.moments, self.momentum_at_epoch)
        with np.errstate(all="ignore"):
            energy = 0.5 * xp.sum(self.momentum_at_epoch / self.moments * self.momentum_at_epoch, axis=-1)
        return self._answer(energy)

    @property
    def momentum_norm(self) -> Any:
        """|L| [kg m²/s], the Casimir's root."""
        return self._answer(_norm(namespace(self.momentum_at_epoch), self.momentum_at_epoch))

    @property
    def regime(self) -> Any:
        """One of "rest", "spherical", "permanent", "symmetric", "short-axis", "long-axis", "separatrix".

        Exact comparisons on the given floats decide. In batches, integer codes in that order from 0.
        """
        code = self._numbers.regime
        return code if np.ndim(code) or is_traced(code) else geometry.REGIMES[int(code)]

    @property
    def encircled_axis(self) -> Any:
        """Index 0, 1, 2 of the principal axis that the polhode encircles; None (in batches −1) where there is none."""
        axis = self._numbers.encircled_axis
        return axis if np.ndim(axis) or is_traced(axis) else (int(axis) if axis >= 0 else None)

    @property
    def modulus(self) -> Any:
        """Modulus k of the elliptic functions, k² = AP/BQ."""
        return self._answer(self._numbers.modulus)

    @property
    def period(self) -> Any:
        """Polhode period T = 4K/λ [s], after which L is back along the body's axes."""
        return self._answer(self._numbers.period)

    @property
    def flip_interval(self) -> Any:
        """T/2 [s]: the time from one reversal along the intermediate axis to the next; none for a symmetric body."""
        xp = namespace(self._numbers.period)
        symmetric = self._numbers.regime == geometry.SYMMETRIC
        return self._answer(xp.where(symmetric, math.nan, 0.5 * self._numbers.period))

    @property
    def precession_rate(self) -> Any:
        """Mean rate ω at which the encircled axis turns about L, in space [rad/s], positive along L."""
        return self._answer(self._numbers.precession_rate)

    @property
    def precession_per_period(self) -> Any:
        """ωT [rad]: azimuth about L gained by the encircled axis in a period, unreduced, positive."""
        return self._answer(self._numbers.precession_per_period)

    @property
    def solid_angle(self) -> Any:
        """Solid angle Ω ∈ [0, 2π) of the cap that the polhode cuts off about the encircled axis [sr]."""
        return self._answer(self._numbers.solid_angle)

    @property
    def geometric_phase(self) -> Any:
        """−Ω (short-axis mode) or +Ω (long-axis mode) [rad]; with 2ET/|L| it makes ωT, up to 2π (Montgomery 1991)."""
        xp = namespace(self._numbers.period)
        sense = xp.where(self._encircles_smallest(), 1.0, -1.0)
        return self._answer(sense * self._numbers.solid_angle)

    @property
    def action(self) -> Any:
        """|L| Ω/2π [J s]: the area of the cap on the momentum sphere over 2π|L|."""
        norm = _norm(namespace(self.momentum_at_epoch), self.momentum_at_epoch)
        return self._answer(norm * self._numbers.solid_angle / (2.0 * math.pi))

    @property
    def tumbling_periods(self) -> tuple[Any, Any]:
        """(P_φ, P_ψ) = (2π/ω, T) [s], the convention of asteroid observers in either mode."""
        return self._answer(2.0 * math.pi / self._numbers.precession_rate), self.period

    @property
    def long_axis_period(self) -> Any:
        """P1 [s]: mean period of the axis of least inertia about L; 1/P1 = 1/P_φ − 1/P_ψ if it is not encircled."""
        xp = namespace(self._numbers.period)
        rate = self._numbers.precession_rate - xp.where(
            self._encircles_smallest(), 0.0, 2.0 * math.pi / self._numbers.period
        )
        return self._answer(2.0 * math.pi / xp.abs(rate))

    def _encircles_smallest(self) -> Array:
        """Whether the polhode goes round the axis of least inertia (long-axis mode; prolate bodies too)."""
        xp = namespace(self.moments, self._numbers.period)
        twice_energy_times = xp.argmin(self.moments, axis=-1)
        return self._numbers.encircled_axis == twice_energy_times


def _norm(xp: Any, vector: Array) -> Array:
    """Return |v| without overflow or underflow."""
    largest = xp.max(xp.abs(vector), axis=-1, keepdims=True)
    unit = vector / xp.where(largest > 0, largest, 1.0)
    return largest[..., 0] * xp.sqrt(xp.sum(unit * unit, axis=-1))


def _drift(xp: Any, value: Array, vector: bool) -> Array:
    """Return the largest deviation from the first sample relative to the first sample's size."""
    if vector:
        size, deviation = _norm(xp, value[..., :1, :]), _norm(xp, value - value[..., :1, :])
    else:
        size, deviation = xp.abs(value[..., :1]), xp.abs(value - value[..., :1])
    return xp.max(deviation / xp.where(size > 0, size, 1.0), axis=-1)


def _last_axis(name: str, value: Array, size: int) -> Array:
    if value.ndim == 0 or value.shape[-1] != size:
        raise InvalidInput(f"`{name}` must have shape (..., {size}); got {tuple(value.shape)}.")
    return value


def _batch_shape(moments: Array, momentum: Array, attitude: Array, epoch: Array) -> tuple[int, ...]:
    vectors = {"moments": moments, "momentum": momentum, "attitude": attitude}
    return _common_shape({f"`{k}`": tuple(v.shape[:-1]) for k, v in vectors.items()} | {"`epoch`": tuple(epoch.shape)})


def _common_shape(shapes: dict[str, tuple[int, ...]]) -> tuple[int, ...]:
    try:
        return tuple(np.broadcast_shapes(*shapes.values()))
    except ValueError:
        raise InvalidInput(
            f"batch axes must broadcast; got {', '.join(f'{name} {shape}' for name, shape in shapes.items())}. "
            "For all bodies at all times give the bodies a last batch axis of length 1: momentum (N, 1, 3), t (T,)."
        ) from None


def _checked(xp: Any, moments: Array, momentum: Array, attitude: Array, epoch: Array) -> tuple[Array, Array, Array]:
    """Return the inputs with the attitude normalised; refuse bad concrete ones, turn bad traced ones to NaN."""
    for name, value, size in (("moments", moments, 3), ("momentum", momentum, 3), ("attitude", attitude, 4)):
        _last_axis(name, value, size)
    _batch_shape(moments, momentum, attitude, epoch)
    length = xp.sqrt(xp.sum(attitude * attitude, axis=-1, keepdims=True))
    good_moments = xp.all((moments > 0) & xp.isfinite(moments), axis=-1, keepdims=True)
    good_length = xp.abs(length - 1.0) < UNIT_TOLERANCE
    if not is_traced(moments, momentum, attitude, epoch):
        _refuse(xp, moments, momentum, attitude, epoch, good_moments, good_length)
    nan = math.nan
    return (
        xp.where(good_moments, moments, nan),
        xp.where(good_moments, momentum, nan),
        xp.where(good_length, attitude / length, nan),
    )


def _refuse(
    xp: Any, moments: Array, momentum: Array, attitude: Array, epoch: Array, good_moments: Array, good_length: Array
) -> None:
    def first(values: Array, good: Array) -> str:
        return np.array2string(np.asarray(values)[~np.asarray(good)[..., 0]][0], separator=", ")

    if not bool(xp.all(good_moments)):
        raise InvalidInput(
            f"`moments` must be positive and finite; got {first(moments, good_moments)} kg m². "
            "A body with a zero moment (a thin rod) has no free motion about that axis; check values and units."
        )
    for name, value in (("momentum", momentum), ("epoch", epoch)):
        if not bool(xp.all(xp.isfinite(value))):
            raise InvalidInput(f"`{name}` must be finite; got NaN or an infinity. Check where it comes from.")
    if not bool(xp.all(good_length)):
        raise InvalidInput(
            f"`attitude` must be a unit quaternion (w, x, y, z); got {first(attitude, good_length)}. "
            "Divide it by its norm, and check that the scalar comes first."
        )
