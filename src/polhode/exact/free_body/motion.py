"""The free rigid body, exact at any time."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, ClassVar, Generic, overload

import numpy as np

from polhode import rotation
from polhode._base.arrays import compiled, is_traced, namespace
from polhode.bodies.body import Body, check_is_body
from polhode.exact.free_body import _evaluation as evaluation
from polhode.exact.free_body import _geometry as geometry
from polhode.motion._inputs import (
    cached_unless_traced,
    finite,
    known,
    named_code,
    one_of,
    plain_answer,
    plain_number,
    spin_of,
)
from polhode.motion._invariants import norm
from polhode.motion._layout import ENERGY, MOMENTUM_NORM, MOMENTUM_SPACE, Quantity
from polhode.motion.base import AbstractMotion
from polhode.types import Answer, Array, ArrayLike, Float64, Integer, Real

Spin = Real[ArrayLike, "*#batch 3"] | None
Attitude = Real[ArrayLike, "*#batch 4"]
Axes = Real[ArrayLike, "*#batch 3 3"]


def _of_unit_length(attitude: Array) -> Array:
    if type(attitude) is np.ndarray and attitude.ndim == 1:  # the same sum and root, in a third of the time
        return attitude / math.sqrt(np.add.reduce(attitude * attitude))
    xp = namespace(attitude)
    return attitude / xp.sqrt(xp.sum(attitude * attitude, axis=-1, keepdims=True))


@dataclass(frozen=True, eq=False, init=False)
class FreeMotion(AbstractMotion, Generic[Answer]):
    """Torque-free motion of rigid bodies in closed form: dL/dt = L × Ω, L = IΩ, dR/dt = R hat(Ω).

    The attitude quaternion is evaluated as a quotient of theta functions whose phases are kept in double-double, so
    that the error is a few units in the last place at any time and for any positive moments: no step, no drift. All
    components are along the principal axes, in the order of ``moments``; they may come in any order. Those of a motion
    made by ``from_body`` are along the body's given axes, in every attribute; ``axes`` then has the principal axes by
    columns, and ``moments`` and ``encircled_axis`` refer to these. ``along("principal")`` gives the other view.

    Args:
        moments: (…, 3) principal moments [kg m²], positive.
        momentum: (…, 3) angular momentum at the epoch [kg m²/s, principal axes]; this or ``angular_velocity``.
        angular_velocity: (…, 3) at the epoch [rad/s, principal axes].
        attitude: (…, 4) unit quaternion wxyz at the epoch, body → space; the identity if not given.
        epoch: (…) time at which these hold [s].
        momentum_at_epoch, attitude_at_epoch: as ``momentum`` and ``attitude``, by the names of the attributes that keep
            them, so that ``dataclasses.replace(motion, epoch=1.0)`` works.
        axes: (…, 3, 3) the principal axes by columns in the axes that vectors and attitude are along; the principal
            axes themselves if not given.

    Arguments after the moments are given by name: three numbers could be a momentum or an angular velocity.

    Batch axes of all four are broadcast against each other, and times against them: one body at many times t (T,);
    many bodies each at its time t (N,); all with all: momentum (N, 1, 3), t (T,). JAX arrays in, JAX arrays out, with
    ``jit``, ``vmap`` and derivatives through moments, momentum, attitude, epoch and time. Derivatives are NaN of
    motions that start closer than 1e-153 |L| to the unstable axis. JAX on the CPU treats numbers below 2e-308 as zero.

    Scalar answers such as ``period`` are floats for one body, inf where infinite and None where undefined; in batches
    they are arrays, with NaN where undefined.

    Raises:
        InvalidInput: for moments that are not positive and finite, values that are not finite, or a quaternion that is
            not of unit length. Values that JAX traces are not checked: invalid ones give NaN.

    Source: Jacobi 1849; Klein & Sommerfeld, *Theorie des Kreisels*; van Zon & Schofield, J. Comput. Phys. 225 (2007)
    145.

    >>> motion = FreeMotion((1.0, 2.0, 3.0), momentum=(0.3, 1.8, 1.5))
    >>> motion.regime, round(motion.period, 12)
    ('short-axis', 10.680120081384)
    """

    kind: ClassVar[str] = "free-body"
    page_solver: ClassVar[str] = "FreeMotion"
    title: ClassVar[str] = "Free motion"

    @overload
    def __init__(
        self: FreeMotion[float], moments: Sequence[float], *, momentum: Sequence[float] | None = None,
        angular_velocity: Sequence[float] | None = None, attitude: Sequence[float] | None = None, epoch: float = 0.0,
        momentum_at_epoch: Sequence[float] | None = None, attitude_at_epoch: Sequence[float] | None = None,
    ) -> None: ...
    @overload
    def __init__(
        self, moments: Real[ArrayLike, "*#batch 3"], *, momentum: Spin = None,
        angular_velocity: Spin = None, attitude: Attitude | None = None, epoch: Real[ArrayLike, "*#batch"] = 0.0,
        momentum_at_epoch: Spin = None, attitude_at_epoch: Attitude | None = None, axes: Axes | None = None,
    ) -> None: ...
    def __init__(
        self, moments: Real[ArrayLike, "*#batch 3"], *, momentum: Spin = None, angular_velocity: Spin = None,
        attitude: Attitude | None = None, epoch: Real[ArrayLike, "*#batch"] = 0.0,
        momentum_at_epoch: Spin = None, attitude_at_epoch: Attitude | None = None, axes: Axes | None = None,
    ) -> None:
        momentum = one_of("momentum", momentum, momentum_at_epoch)
        attitude = one_of("attitude", attitude, attitude_at_epoch)
        super().__init__(moments, {}, momentum, attitude, epoch, angular_velocity, axes)

    @overload
    @classmethod
    def from_body(
        cls, body: Body, *, angular_velocity: Sequence[float] | None = None,
        momentum: Sequence[float] | None = None, attitude: Sequence[float] | None = None,
        epoch: float = 0.0,
    ) -> FreeMotion[float]: ...
    @overload
    @classmethod
    def from_body(
        cls, body: Body, *, angular_velocity: Spin = None, momentum: Spin = None,
        attitude: Attitude | None = None, epoch: Real[ArrayLike, "*#batch"] = 0.0,
    ) -> FreeMotion: ...
    @classmethod
    def from_body(
        cls,
        body: Body,
        *,
        angular_velocity: Spin = None,
        momentum: Spin = None,
        attitude: Attitude | None = None,
        epoch: Real[ArrayLike, "*#batch"] = 0.0,
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
        check_is_body(body)
        spin_of(momentum, angular_velocity)
        return cls(body.principal_moments, momentum=momentum, angular_velocity=angular_velocity, attitude=attitude,
                   epoch=epoch, axes=body.principal_axes)

    # ------------------------------------------------------------------ evaluation

    def checked_start(
        self, xp: Any, body: tuple[Array, ...], momentum: Array, attitude: Array
    ) -> tuple[tuple[Float64[Array, "..."], ...], Float64[Array, "... 3"], Float64[Array, "... 4"]]:
        return body, momentum, compiled(_of_unit_length, attitude)(attitude)

    def _columns_of(self) -> Any:
        return evaluation.motion_columns(self._arguments)

    def _state_of(self, column: tuple[float, ...], elapsed: float, rest: float) -> tuple[float, ...]:
        return evaluation.FORM.state(column, elapsed, rest)

    def closed_form(
        self, elapsed: Float64[Array, "..."], rest: Float64[Array, "..."]
    ) -> tuple[Float64[Array, "... 4"], Float64[Array, "... 3"]]:
        return evaluation.state(self, elapsed, rest)

    @property
    def fastest_rate(self) -> Float64[Array, "*batch"]:
        """(…) about how fast the bodies turn [rad/s]: the largest component of Ω."""
        momentum, moments = known(self._principal[0], self.moments)
        if momentum.ndim == moments.ndim == 1 and not is_traced(momentum, moments):
            (x, y, z), (a, b, c) = momentum.tolist(), moments.tolist()
            return np.float64(max(abs(x / a), abs(y / b), abs(z / c)))  # type: ignore[return-value]
        xp = namespace(momentum, moments)
        x, y, z = (xp.abs(momentum[..., k] / moments[..., k]) for k in range(3))  # NumPy is slow along short axes
        return xp.maximum(xp.maximum(x, y), z)

    @property
    def free_moments(self) -> Float64[Array, "*batch 3"]:
        return self.moments

    @property
    def quantities(self) -> dict[str, Quantity]:
        return {"energy": ENERGY, "momentum_norm": MOMENTUM_NORM, "momentum_space": MOMENTUM_SPACE}

    def conserved_along(
        self, attitude: Array, momentum: Array, angular_velocity: Array
    ) -> dict[str, Float64[Array, "..."]]:
        xp = namespace(momentum, angular_velocity)
        return {
            "energy": 0.5 * xp.sum(momentum * angular_velocity, axis=-1),
            "momentum_norm": norm(xp, momentum),
            "momentum_space": rotation.rotate(attitude, momentum),
        }

    # ------------------------------------------------------------------ meaning

    @property
    def cycle(self) -> float:
        return finite(self.period) or self._turn()

    @cached_unless_traced
    def _numbers(self) -> geometry.Characteristics:
        return evaluation.characteristics(self.moments, self._principal[0])

    @property
    def energy(self) -> Float64[Answer, "*batch"]:
        """Kinetic energy E = Σ L_i²/2I_i [J]."""
        momentum = self._principal[0]
        xp = namespace(self.moments, momentum)
        with np.errstate(all="ignore"):
            energy = 0.5 * xp.sum(momentum / self.moments * momentum, axis=-1)
        return plain_number(energy)

    @property
    def momentum_norm(self) -> Float64[Answer, "*batch"]:
        """|L| [kg m²/s], the Casimir's root."""
        return plain_number(self._size)

    @property
    def regime(self) -> str | Integer[Array, "*batch"]:
        """One of "rest", "spherical", "permanent", "symmetric", "short-axis", "long-axis", "separatrix".

        "spherical": all moments are equal; "permanent": the body turns steadily about a principal axis; "symmetric":
        two moments are equal; "short-axis" and "long-axis": L circles the axis of largest and of least moment;
        "separatrix": between both, where L tends to the middle axis. Exact comparisons on the given floats decide. In
        batches, integer codes in that order from 0.
        """
        return named_code(self._numbers.regime, geometry.REGIMES)

    @property
    def encircled_axis(self) -> int | Integer[Array, "*batch"] | None:
        """Index 0, 1, 2 of the principal axis that the polhode encircles; None (in batches −1) where there is none."""
        axis = self._numbers.encircled_axis
        return axis if np.ndim(axis) or is_traced(axis) else (int(axis) if axis >= 0 else None)

    @property
    def modulus(self) -> Float64[Answer, "*batch"] | None:
        """Modulus k of the elliptic functions, k² = AP/BQ."""
        return plain_answer(self._numbers.modulus)

    @property
    def period(self) -> Float64[Answer, "*batch"] | None:
        """Polhode period T = 4K/λ [s], after which L is back along the body's axes."""
        return plain_answer(self._numbers.period)

    @property
    def flip_interval(self) -> Float64[Answer, "*batch"] | None:
        """T/2 [s]: from one reversal of L along the intermediate axis to the next; none for a symmetric body.

        L of a body that only cones swings so too; ``analysis.cone.rotation_form`` tells which body turns over.
        """
        xp = namespace(self._numbers.period)
        symmetric = self._numbers.regime == geometry.SYMMETRIC
        return plain_answer(xp.where(symmetric, math.nan, 0.5 * self._numbers.period))

    @property
    def precession_rate(self) -> Float64[Answer, "*batch"] | None:
        """Mean rate ω at which the encircled axis turns about L, in space [rad/s], positive along L."""
        return plain_answer(self._numbers.precession_rate)

    @property
    def precession_per_period(self) -> Float64[Answer, "*batch"] | None:
        """ωT [rad]: azimuth about L gained by the encircled axis in a period, unreduced, positive."""
        return plain_answer(self._numbers.precession_per_period)

    @property
    def solid_angle(self) -> Float64[Answer, "*batch"] | None:
        """Solid angle Ω ∈ [0, 2π) of the cap that the polhode cuts off about the encircled axis [sr]."""
        return plain_answer(self._numbers.solid_angle)

    @property
    def geometric_phase(self) -> Float64[Answer, "*batch"] | None:
        """−Ω (short-axis mode) or +Ω (long-axis mode) [rad]; with 2ET/|L| it makes ωT, up to 2π (Montgomery 1991)."""
        xp = namespace(self._numbers.period)
        sense = xp.where(self._encircles_smallest(), 1.0, -1.0)
        return plain_answer(sense * self._numbers.solid_angle)

    @property
    def action(self) -> Float64[Answer, "*batch"] | None:
        """|L| Ω/2π [J s]: the area of the cap on the momentum sphere over 2π|L|."""
        return plain_answer(self._size * self._numbers.solid_angle / (2.0 * math.pi))

    @property
    def tumbling_periods(self) -> tuple[Float64[Answer, "*batch"] | None, Float64[Answer, "*batch"] | None]:
        """(P_φ, P_ψ) = (2π/ω, T) [s], the convention of asteroid observers in either mode."""
        with np.errstate(over="ignore", divide="ignore"):  # slower than numbers go: infinite
            return plain_answer(2.0 * math.pi / self._numbers.precession_rate), self.period

    @property
    def long_axis_period(self) -> Float64[Answer, "*batch"] | None:
        """P1 [s]: mean period of the axis of least inertia about L; 1/P1 = 1/P_φ − 1/P_ψ where L does not circle it."""
        xp = namespace(self._numbers.period)
        with np.errstate(over="ignore", divide="ignore"):  # slower than numbers go: infinite
            own = xp.where(self._encircles_smallest(), 0.0, 2.0 * math.pi / self._numbers.period)
            return plain_answer(2.0 * math.pi / xp.abs(self._numbers.precession_rate - own))

    @property
    def _size(self) -> Array:
        return norm(namespace(self._principal[0]), self._principal[0])

    def _encircles_smallest(self) -> Array:
        """Whether the polhode goes round the axis of least inertia (long-axis mode; prolate bodies too)."""
        xp = namespace(self.moments, self._numbers.period)
        return self._numbers.encircled_axis == xp.argmin(self.moments, axis=-1)
