"""The heavy top: a body turning about a fixed point under its weight."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any, ClassVar, NamedTuple

import equinox as eqx
import jax.numpy as jnp
import numpy as np

from polhode import rotation
from polhode._base import check
from polhode._base.arrays import is_traced, known_numbers_only, require_doubles
from polhode.algebra.base import AbstractLieAlgebra
from polhode.algebra.se3 import SE3
from polhode.bodies._pivot import STANDARD_GRAVITY, about_pivot
from polhode.bodies.body import Body
from polhode.errors import InvalidInput
from polhode.motion._inputs import refuse_not_finite
from polhode.motion._layout import Quantity
from polhode.systems._checks import as_floats, checked_number
from polhode.systems._top_integrals import INTEGRAL_UNITS, Integral, integrable_case, leaf_integral
from polhode.systems.base import AbstractLiePoissonSystem, Components, Flow
from polhode.systems.free_rigid_body import axis_flows, checked_moments
from polhode.types import Array, ArrayLike, ArrayOrFloat, Float64, Real

if TYPE_CHECKING:
    from polhode.exact.lagrange_top import LagrangeMotion


class HeavyTopLimits(NamedTuple):
    """Numbers that decide what is along a principal axis, and upright."""

    axis_sine: float = 1e-9  # of the angle up to which the line to the centre of mass counts as a principal axis
    upward_error: float = 1e-6  # by which components of Γ may differ from the direction that the attitude gives


LIMITS = HeavyTopLimits()


class HeavyTop(AbstractLiePoissonSystem):
    """H = ½ Π·I⁻¹Π + mgl Γ·χ on se(3)*: Π̇ = Π × Ω + mgl Γ × χ, Γ̇ = Γ × Ω.

    Γ = Rᵀe_z is the upward direction along the body's axes, χ the direction from the fixed point to the centre of mass.
    State (Π, Γ) (…, 6), or with the attitude (…, 10). The orbits |Γ|², Π·Γ = const have four dimensions, so a third
    integral other than H makes a top integrable; where one is known, ``invariants`` has it under its name. Flows: the
    rotation about each axis, and the weight, which kicks Π.

    Args:
        moments: (3,) principal moments about the fixed point [kg m²].
        mgl: weight times the distance from fixed point to centre of mass [N m]; zero is the free body.
        axis: (3,) χ along the principal axes, normalised here.
        axes: (3, 3) principal axes by columns in some given frame, for ``state``; the identity if left out.

    Raises:
        InvalidInput: for moments that are not positive, an axis of no direction, or values that are not finite.

    Source: Audin, *Spinning Tops*, ch. I; Marsden & Ratiu, *Introduction to Mechanics and Symmetry*, §1.4 and §15.10.
    """

    kind: ClassVar[str] = "heavy-top"
    title: ClassVar[str] = "Heavy top"
    has_vertical: ClassVar[bool] = True
    algebra: AbstractLieAlgebra
    moments: Float64[Array, "3"]
    mgl: Float64[Array, ""]
    axis: Float64[Array, "3"]
    axes: Float64[Array, "3 3"]
    case: tuple[str, int] | None = eqx.field(static=True)

    @known_numbers_only
    def __init__(self, moments: Real[ArrayLike, "3"], mgl: float, axis: Real[ArrayLike, "3"] = (0.0, 0.0, 1.0),
                 axes: Real[ArrayLike, "3 3"] | None = None) -> None:
        require_doubles(axis=axis, axes=axes)
        direction = as_floats(axis)
        largest = np.abs(direction).max() if direction.shape == (3,) else np.nan
        if not (np.isfinite(largest) and largest > 0):
            check.refuse("axis", "a direction (3,), from fixed point to centre of mass", axis)
        self.algebra, self.moments = SE3(), checked_moments(moments)
        direction = np.ldexp(direction, -np.frexp(largest)[1])  # squares of extreme lengths overflow
        self.mgl, self.axis = checked_number("mgl", mgl, unit="N m"), jnp.asarray(direction / np.linalg.norm(direction))
        self.axes = jnp.eye(3) if axes is None else jnp.asarray(axes, dtype=float)
        self.case = integrable_case(np.asarray(self.moments), float(mgl), np.asarray(self.axis))

    @classmethod
    @known_numbers_only
    def from_body(cls, body: Body, pivot: Real[ArrayLike, "3"], gravity: float = STANDARD_GRAVITY) -> HeavyTop:
        """Return the top that a body makes about a fixed point, along its principal axes there.

        A fixed point at the centre of mass leaves the free body; a warning says so.

        Args:
            body: with its mass.
            pivot: (3,) the fixed point [m, given axes of the body].
            gravity: [m/s²], positive.

        Raises:
            InvalidInput: for a body without mass, or gravity that is not positive.
        """
        pivoted = about_pivot(body, pivot, gravity)
        return cls(pivoted.moments, pivoted.mgl, pivoted.arm if pivoted.mgl else (0.0, 0.0, 1.0), pivoted.axes)

    @classmethod
    @known_numbers_only
    def from_motion(cls, motion: LagrangeMotion) -> HeavyTop:
        """Return the top of an exact motion, to simulate it or judge its stability, with the same third axis.

        Raises:
            InvalidInput: for a batch.
        """
        if np.ndim(motion.moments) != 1 or np.ndim(motion.mgl):
            raise InvalidInput(f"`motion` must be of one top; got a batch of shape {motion.batch_shape}. Take one.")
        axes = None if motion.axes is None else np.asarray(motion.axes)
        return cls(np.asarray(motion.moments), float(motion.mgl), (0.0, 0.0, 1.0), axes)

    @property
    def given_axes(self) -> Float64[Array, "3 3"]:
        """The principal axes by columns in the given ones."""
        return self.axes

    @property
    def weight(self) -> Float64[Array, "3"]:
        """mgl χ (3,): weight times the centre of mass from the fixed point [N m, given axes]."""
        return self.mgl * (self.axes @ self.axis)

    @known_numbers_only
    def leaning(self, angle: float) -> Float64[Array, "4"]:
        """Return the attitude (4,), principal axes → space, in which the axis leans towards −y from upright.

        Upright is reached from the given axes by the shortest turn; quarter turns are exact.

        Args:
            angle: from the upward vertical [rad], 0 to π.

        Raises:
            InvalidInput: for a top whose centre of mass is its fixed point, or an angle that is not finite.
        """
        if float(self.mgl) == 0.0:
            raise InvalidInput("the top must have a centre of mass apart from the fixed point to lean; it has mgl = 0.")
        return lean_from_upright(np.asarray(self.axes), np.asarray(self.axis), check.number("angle", angle, "rad"))

    def pack(
        self,
        attitude: Real[ArrayLike, "*#batch 4"] = (1.0, 0.0, 0.0, 0.0),
        angular_velocity: Real[ArrayLike, "*#batch 3"] | None = None,
        momentum: Real[ArrayLike, "*#batch 3"] | None = None,
    ) -> Float64[Array, "*batch 10"]:
        """Return packed states (…, 10) from attitude and spin in the given axes.

        Args:
            attitude: (…, 4) unit quaternion wxyz, given axes → space, z up.
            angular_velocity: (…, 3) [rad/s, given axes]; this, ``momentum``, or neither for rest.
            momentum: (…, 3) about the fixed point [kg m²/s, given axes].

        Raises:
            InvalidInput: if both are given, or one is not finite.
        """
        if angular_velocity is not None and momentum is not None:
            raise InvalidInput("give `angular_velocity` or `momentum`, not both.")
        given = {"attitude": attitude, "angular_velocity": angular_velocity, "momentum": momentum}
        require_doubles(**given)
        refuse_not_finite(**{name: jnp.asarray(x, dtype=float) for name, x in given.items() if x is not None})
        vector = angular_velocity if momentum is None else momentum
        # known numbers by NumPy, as JAX would compile every operation by itself
        xp: Any = jnp if is_traced(self.axes, self.moments, attitude, vector) else np
        axes = xp.asarray(self.axes)
        normalized = rotation.normalize(xp.asarray(attitude, dtype=float))
        body_attitude = rotation.multiply(normalized, rotation.from_matrix(axes))
        spin = xp.zeros(3) if vector is None else xp.asarray(vector, dtype=float) @ axes
        spin = spin if momentum is not None else spin * xp.asarray(self.moments)
        # Γ = Rᵀ e_z
        up = rotation.rotate(rotation.conjugate(body_attitude), xp.asarray([0.0, 0.0, 1.0]))
        shape = np.broadcast_shapes(body_attitude.shape[:-1], spin.shape[:-1])
        parts = (xp.broadcast_to(x, (*shape, x.shape[-1])) for x in (body_attitude, spin, up))
        return jnp.asarray(xp.concatenate(list(parts), axis=-1))

    @known_numbers_only
    def upright(self, spin: float = 0.0, hanging: bool = False) -> Float64[Array, "6"]:
        """Return the point (6,) of steady rotation about the vertical axis to the centre of mass, up or down.

        Args:
            spin: about χ [rad/s]; other than zero only where χ is a principal axis.
            hanging: with the centre of mass below.

        Raises:
            InvalidInput: for a spin about a line that is not a principal axis.
        """
        axis = np.asarray(self.axis)
        momentum = np.asarray(self.moments) * spin * axis
        if np.linalg.norm(np.cross(momentum, axis)) > LIMITS.axis_sine * np.linalg.norm(momentum):
            raise InvalidInput(
                f"`spin` must be zero: the line to the centre of mass, {axis.tolist()}, is not a principal axis, and "
                "the body does not stand spinning about it."
            )
        return jnp.asarray(np.concatenate([momentum, -axis if hanging else axis]))

    @known_numbers_only
    def check_state(self, state: Real[ArrayLike, "*shape"]) -> Float64[Array, "*shape"]:
        state = super().check_state(state)
        known = np.asarray(state)
        if known.shape[-1] == 10:
            w, x, y, z = (known[..., k] for k in range(4))
            up = 2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y)  # Rᵀe_z
            off = [np.abs(one - known[..., k]).max() for k, one in enumerate(up, 7)]
            if not max(off) < LIMITS.upward_error:
                raise InvalidInput(
                    "`state` must end with Γ, the upward direction along the body's axes as its attitude has it, "
                    "Rᵀe_z. Make it by `top.pack(attitude, angular_velocity)`."
                )
        return state

    def energy(self, point: Float64[Array, "*batch 6"]) -> Float64[Array, "*batch"]:
        # the height of the centre of mass is l Γ·χ
        angular, up = point[..., :3], point[..., 3:]
        return 0.5 * jnp.sum(angular * angular / self.moments, axis=-1) + self.mgl * jnp.sum(up * self.axis, axis=-1)

    def velocity(self, point: Float64[Array, "*batch 6"]) -> Float64[Array, "*batch 6"]:
        angular = point[..., :3]
        return jnp.concatenate([angular / self.moments, jnp.broadcast_to(self.mgl * self.axis, angular.shape)], axis=-1)

    @property
    def quantities(self) -> dict[str, Quantity]:
        if self.case is None:
            return super().quantities
        name = leaf_integral(self.case, self.moments, self.mgl, self.axis)[0]
        return super().quantities | {name: Quantity(INTEGRAL_UNITS[self.case[0]], name)}

    @property
    def extra_invariants(self) -> dict[str, Integral]:
        return {} if self.case is None else self._integral_of(self.case)

    def _integral_of(self, case: tuple[str, int]) -> dict[str, Integral]:
        name, function, on_leaf = leaf_integral(case, self.moments, self.mgl, self.axis)
        return {} if on_leaf else {name: function}

    def invariants(self, state: Float64[Array, "..."]) -> dict[str, Float64[Array, "..."]]:
        """Return energy, Casimirs and the third integral; one that holds on Π·Γ = 0 alone is NaN elsewhere."""
        values = super().invariants(state)
        if self.case is not None:
            name, function, on_leaf = leaf_integral(self.case, self.moments, self.mgl, self.axis)
            values |= {name: function(self.parts(state).point)} if on_leaf else {}
        return values

    @property
    def flows(self) -> dict[str, Flow]:
        return {"weight": self._kick} | axis_flows(self.moments, vectors=2)

    def _kick(self, time: Array, state: Components) -> Components:
        # under mgl Γ·χ alone Γ stays, and Π̇ = Γ × mgl χ is constant
        turn = rotation.cross_of_parts(state[-3:], [time * self.mgl * self.axis[k] for k in range(3)])
        still = jnp.zeros_like(state[-1])
        return (*[still] * (len(state) - 6), *turn, still, still, still)


def lean_from_upright(
    axes: Float64[np.ndarray, "3 3"], axis: Float64[np.ndarray, "3"], angle: Float64[ArrayOrFloat, "*batch"]
) -> Float64[Array, "*batch 4"]:
    """Return attitudes (…, 4) as ``HeavyTop.leaning`` does, of one top by many angles (…) [rad] from 0 to π."""
    upright = rotation.shortest_between(axes @ axis, (0.0, 0.0, 1.0))
    # one by one, as NumPy's cosine of an array may differ in its last digit
    halves = np.reshape([_half_turn(one) for one in np.ravel(angle).tolist()], (*np.shape(angle), 2))
    turn = rotation.multiply(np.concatenate([halves, np.zeros_like(halves)], axis=-1), upright)
    return rotation.multiply(turn, rotation.from_matrix(axes))


def _half_turn(angle: float) -> tuple[float, float]:
    """Return cosine and sine of half an angle from 0 to π, exact at its ends and alike at π/2."""
    if abs(angle - 0.5 * math.pi) < 1e-15:
        return math.sqrt(0.5), math.sqrt(0.5)
    return (0.0, 1.0) if abs(angle - math.pi) < 1e-15 else (math.cos(0.5 * angle), math.sin(0.5 * angle))
