"""The Lagrange top, exact at any time."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, ClassVar, Generic, overload

import numpy as np

from polhode import rotation
from polhode._base.arrays import is_traced, known_false, namespace
from polhode.bodies._pivot import EQUAL, STANDARD_GRAVITY, about_pivot
from polhode.bodies.body import Body
from polhode.errors import InvalidInput
from polhode.exact.lagrange_top import _evaluation as evaluation
from polhode.exact.lagrange_top import _geometry as geometry
from polhode.exact.lagrange_top._symmetry import third_axis_to_centre
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
from polhode.motion._layout import ENERGY, Quantity
from polhode.motion.base import AbstractMotion
from polhode.types import Answer, Array, ArrayLike, Float64, Integer, Real

Spin = Real[ArrayLike, "*#batch 3"] | None
Attitude = Real[ArrayLike, "*#batch 4"]
Axes = Real[ArrayLike, "*#batch 3 3"]


@dataclass(frozen=True, eq=False, init=False)
class LagrangeMotion(AbstractMotion, Generic[Answer]):
    """Heavy symmetric tops in closed form: H = ½ L·I⁻¹L + mgl cos θ, dL/dt = L × Ω + mgl Γ × e3, dR/dt = R hat(Ω).

    θ is the tilt of the body's third axis from the vertical, space z, up; Γ = Rᵀe_z. The Cayley–Klein parameters are
    quotients of theta functions, regular also where Euler angles are not, with phases in double-double: no step, no
    drift, equal errors at all times, from the sleeping top to the spherical pendulum (moments I1, I1, any I3; L3 = 0).
    All components are along the principal axes. Those of a motion made by ``from_body`` are along the body's given
    axes, in every attribute; ``axes`` then has the principal axes by columns, the third from the pivot to the centre of
    mass, and ``moments`` refer to these. ``along("principal")`` gives the other view.

    Args:
        moments: (…, 3) principal moments about the pivot [kg m²], positive, the first two equal.
        mgl: (…) weight times the distance from pivot to centre of mass [N m], positive where that lies on the side of
            the third axis. A negative one is a top on the reversed axis, with answers about the axis as given; zero is
            the free symmetric body.
        momentum: (…, 3) angular momentum at the epoch [kg m²/s, body axes]; this or ``angular_velocity``.
        angular_velocity: (…, 3) at the epoch [rad/s, body axes].
        attitude: (…, 4) unit quaternion wxyz at the epoch, body → space; it is normalised exactly. The
            identity if not given.
        epoch: (…) time at which these hold [s].
        momentum_at_epoch, attitude_at_epoch: as ``momentum`` and ``attitude``, by the names of the attributes that keep
            them, so that ``dataclasses.replace(top, epoch=1.0)`` works.
        axes: (…, 3, 3) the principal axes by columns in the axes that vectors and attitude are along; the principal
            axes themselves if not given.

    Arguments after the moments are given by name: three numbers could be a momentum or an angular velocity.

    Batch axes of all five are broadcast against each other, and times against them. JAX arrays in, JAX arrays out, with
    ``jit``, ``vmap`` and first derivatives.

    Scalar answers such as ``nutation_period`` are floats for one top, inf where infinite and None where undefined; in
    batches they are arrays, with NaN where undefined.

    Raises:
        InvalidInput: for moments that are not positive, finite and equal in the first two, values that are not finite,
            or a quaternion that is not of unit length. Values that JAX traces are not checked: invalid ones give NaN.

    Source: Klein & Sommerfeld, *Theorie des Kreisels*, ch. IV and VI; Whittaker, *Analytical Dynamics*, §71–75.

    >>> top = LagrangeMotion((1.0, 1.0, 0.5), mgl=1.0, momentum=(0.0, 0.0, 2.5), attitude=(3**0.5 / 2, 0.5, 0.0, 0.0))
    >>> top.regime, round(top.nutation_period, 12), round(top.precession_per_period, 12)
    ('cusp', 2.763928649428, 1.142288718976)
    """

    kind: ClassVar[str] = "lagrange-top"
    page_solver: ClassVar[str] = "LagrangeMotion"
    title: ClassVar[str] = "Lagrange top"
    has_vertical: ClassVar[bool] = True
    body_numbers: ClassVar[tuple[str, ...]] = ("mgl",)
    mgl: Float64[Array, "*batch"]

    @overload
    def __init__(
        self: LagrangeMotion[float], moments: Sequence[float], *, mgl: float, momentum: Sequence[float] | None = None,
        angular_velocity: Sequence[float] | None = None, attitude: Sequence[float] | None = None, epoch: float = 0.0,
        momentum_at_epoch: Sequence[float] | None = None, attitude_at_epoch: Sequence[float] | None = None,
    ) -> None: ...
    @overload
    def __init__(
        self, moments: Real[ArrayLike, "*#batch 3"], *, mgl: Real[ArrayLike, "*#batch"], momentum: Spin = None,
        angular_velocity: Spin = None, attitude: Attitude | None = None, epoch: Real[ArrayLike, "*#batch"] = 0.0,
        momentum_at_epoch: Spin = None, attitude_at_epoch: Attitude | None = None, axes: Axes | None = None,
    ) -> None: ...
    def __init__(
        self, moments: Real[ArrayLike, "*#batch 3"], *, mgl: Real[ArrayLike, "*#batch"], momentum: Spin = None,
        angular_velocity: Spin = None, attitude: Attitude | None = None, epoch: Real[ArrayLike, "*#batch"] = 0.0,
        momentum_at_epoch: Spin = None, attitude_at_epoch: Attitude | None = None, axes: Axes | None = None,
    ) -> None:
        momentum = one_of("momentum", momentum, momentum_at_epoch)
        attitude = one_of("attitude", attitude, attitude_at_epoch)
        super().__init__(moments, {"mgl": mgl}, momentum, attitude, epoch, angular_velocity, axes)

    @overload
    @classmethod
    def from_body(
        cls, body: Body, *, pivot: Real[ArrayLike, "3"], angular_velocity: Sequence[float] | None = None,
        momentum: Sequence[float] | None = None, attitude: Sequence[float] | None = None,
        epoch: float = 0.0, gravity: float = STANDARD_GRAVITY,
    ) -> LagrangeMotion[float]: ...
    @overload
    @classmethod
    def from_body(
        cls, body: Body, *, pivot: Real[ArrayLike, "3"], angular_velocity: Spin = None, momentum: Spin = None,
        attitude: Attitude | None = None, epoch: Real[ArrayLike, "*#batch"] = 0.0, gravity: float = STANDARD_GRAVITY,
    ) -> LagrangeMotion: ...
    @classmethod
    def from_body(
        cls,
        body: Body,
        *,
        pivot: Real[ArrayLike, "3"],
        angular_velocity: Spin = None,
        momentum: Spin = None,
        attitude: Attitude | None = None,
        epoch: Real[ArrayLike, "*#batch"] = 0.0,
        gravity: float = STANDARD_GRAVITY,
    ) -> LagrangeMotion:
        """Return the top that a body makes about a fixed point, vectors and attitude along its given axes, in and out.

        Moments about the pivot are J + m (|d|² 1 − d dᵀ) with d from it to the centre of mass (Huygens and Steiner),
        mgl is m g |d|, and the third principal axis is along d. A pivot at the centre of mass leaves the free symmetric
        body; a warning says so.

        Args:
            body: with its mass.
            pivot: (3,) the fixed point [m, given body axes].
            angular_velocity: (…, 3) [rad/s, given body axes]; this or ``momentum``.
            momentum: (…, 3) about the pivot [kg m²/s, given body axes].
            attitude: (…, 4) unit quaternion wxyz, given body axes → space, z up.
            epoch: time at which these hold [s].
            gravity: [m/s²], positive.

        Raises:
            InvalidInput: for a body without mass; one that is not a Lagrange top about the pivot, two moments there
                equal and the centre of mass on the third axis, both to 1e-12; unless exactly one of angular velocity
                and momentum is given; or as the class does.

        Source: Klein & Sommerfeld, *Theorie des Kreisels*, ch. IV; Whittaker, *Analytical Dynamics*, §71.

        >>> import polhode as ph
        >>> cone = ph.shapes.cone(0.1, 0.03, 0.05).placed((0.0, 1.0, 0.0, 0.0))  # on its point, 37.5 mm below
        >>> top = LagrangeMotion.from_body(
        ...     cone, pivot=(0.0, 0.0, -0.0375), angular_velocity=(0.0, 0.0, 200.0), attitude=(0.8, 0.6, 0.0, 0.0)
        ... )
        >>> top.regime, round(top.nutation_period, 6)
        ('cusp', 0.188594)
        """
        spin_of(momentum, angular_velocity)
        pivoted = about_pivot(body, pivot, gravity)
        moments, axes = third_axis_to_centre(pivoted)
        return cls(moments, mgl=pivoted.mgl, momentum=momentum, angular_velocity=angular_velocity, attitude=attitude,
                   epoch=epoch, axes=axes)

    # ------------------------------------------------------------------ evaluation

    def checked_start(
        self, xp: Any, body: tuple[Array, ...], momentum: Array, attitude: Array
    ) -> tuple[tuple[Float64[Array, "..."], ...], Float64[Array, "... 3"], Float64[Array, "... 4"]]:
        moments, mgl = body
        moments = _checked_symmetry(xp, moments)
        if is_traced(moments):  # NaN in the momentum reaches whatever is computed of the top, as fields keep their own
            momentum = xp.where(xp.isnan(moments[..., :1]), math.nan, momentum)
        return (moments, mgl), momentum, attitude

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
        """(…) about how fast the tops turn [rad/s]: components of Ω, and the rate of small swings."""
        momentum, moments, mgl = known(self._principal[0], self.moments, self.mgl)
        if momentum.ndim == moments.ndim == 1 and mgl.ndim == 0 and not is_traced(momentum, moments, mgl):
            (x, y, z), (a, b, c) = momentum.tolist(), moments.tolist()
            return np.float64(max(abs(x / a), abs(y / b), abs(z / c)) + math.sqrt(abs(float(mgl)) / a))  # type: ignore[return-value]
        xp = namespace(momentum, moments, mgl)
        x, y, z = (xp.abs(momentum[..., k] / moments[..., k]) for k in range(3))  # NumPy is slow along short axes
        return xp.maximum(xp.maximum(x, y), z) + xp.sqrt(xp.abs(mgl) / moments[..., 0])

    @property
    def cycle(self) -> float:
        swings = self.mgl != 0
        swing = 2.0 * math.pi * float(self.moments[0] / abs(self.mgl)) ** 0.5 if swings else None
        return finite(self.nutation_period) or swing or self._turn()

    @property
    def quantities(self) -> dict[str, Quantity]:
        return {
            "energy": ENERGY,
            "vertical_momentum": Quantity("kg m2 s-1", "angular momentum about the vertical"),
            "axial_momentum": Quantity("kg m2 s-1", "angular momentum about the top's axis"),
        }

    def conserved_along(
        self, attitude: Array, momentum: Array, angular_velocity: Array
    ) -> dict[str, Float64[Array, "..."]]:
        xp = namespace(momentum, self.moments)
        kinetic = 0.5 * xp.sum(momentum * angular_velocity, axis=-1)
        return {
            "energy": kinetic + self.mgl * _vertical(xp, attitude),
            "vertical_momentum": rotation.rotate(attitude, momentum)[..., 2],
            "axial_momentum": momentum[..., 2],
        }

    def conserved_sizes(
        self, attitude: Array, momentum: Array, angular_velocity: Array
    ) -> dict[str, Float64[Array, "..."]]:
        """Return the largest kinetic energy plus |mgl|, and the largest |L|."""
        xp = namespace(momentum, self.moments)
        kinetic = 0.5 * xp.sum(momentum * angular_velocity, axis=-1)
        of_momentum = xp.max(norm(xp, momentum), axis=-1, keepdims=True)
        of_energy = xp.max(kinetic + xp.abs(self.mgl), axis=-1, keepdims=True)
        return {"energy": of_energy, "vertical_momentum": of_momentum, "axial_momentum": of_momentum}

    # ------------------------------------------------------------------ meaning

    @cached_unless_traced
    def _numbers(self) -> geometry.Characteristics:
        return evaluation.characteristics(self._arguments)

    @property
    def energy(self) -> Float64[Answer, "*batch"]:
        """Energy ½ L·I⁻¹L + mgl cos θ [J]; zero potential is the axis level with the pivot."""
        momentum, attitude = self._principal
        xp = namespace(self.moments, momentum)
        kinetic = 0.5 * xp.sum(momentum / self.moments * momentum, axis=-1)
        return plain_number(kinetic + self.mgl * _vertical(xp, attitude))

    @property
    def vertical_momentum(self) -> Float64[Answer, "*batch"]:
        """p_φ = (R L)_z [kg m²/s], kept because the vertical is a symmetry of the weight."""
        momentum, attitude = self._principal
        xp = namespace(attitude, momentum)
        return plain_number(rotation.rotate(attitude / norm(xp, attitude)[..., None], momentum)[..., 2])

    @property
    def axial_momentum(self) -> Float64[Answer, "*batch"]:
        """p_ψ = L3 = I3 ω3 [kg m²/s], kept because the axis is a symmetry of the body."""
        return plain_number(self._principal[0][..., 2])

    @property
    def regime(self) -> str | Integer[Array, "*batch"]:
        """One of "rest", "sleeping", "hanging", "steady", "free", "planar", "undulating", "cusp", "loop", "separatrix".

        "sleeping" and "hanging" spin upright, centre of mass above or below the pivot; "steady" keeps its tilt; "free"
        has no weight; "planar" swings or turns over like a pendulum; "separatrix" comes to rest upright in infinite
        time; the others nutate, and are classified by the azimuth: always onward, halting, or turning back in loops.
        Exact signs on the given floats decide. In batches, integer codes in that order from 0.
        """
        return named_code(self._numbers.regime, geometry.REGIMES)

    @property
    def nutation_limits(self) -> tuple[Float64[Answer, "*batch"] | None, Float64[Answer, "*batch"] | None]:
        """(min, max) of cos θ."""
        return plain_answer(self._numbers.lowest), plain_answer(self._numbers.highest)

    @property
    def nutation_period(self) -> Float64[Answer, "*batch"] | None:
        """T [s]: the tilt's period; of a steady top, that of its smallest nutations."""
        return plain_answer(self._numbers.period)

    @property
    def precession_per_period(self) -> Float64[Answer, "*batch"] | None:
        """Δφ [rad]: azimuth gained by the axis in a period, unreduced; half a turn where it passes a vertical."""
        return plain_answer(self._numbers.precession_per_period)

    @property
    def spin_per_period(self) -> Float64[Answer, "*batch"] | None:
        """Δψ [rad]: turn of the body about its axis in a period, from the line of nodes, unreduced."""
        return plain_answer(self._numbers.spin_per_period)

    @property
    def precession_rate(self) -> Float64[Answer, "*batch"] | None:
        """Mean rate of the azimuth Δφ/T [rad/s]."""
        return plain_answer(self._numbers.precession_rate)

    @property
    def spin_rate(self) -> Float64[Answer, "*batch"] | None:
        """Mean rate of the body's own turn Δψ/T [rad/s]; ω3 is this plus the precession's share along the axis."""
        return plain_answer(self._numbers.spin_rate)


def _checked_symmetry(xp: Any, moments: Array) -> Array:
    if type(moments) is np.ndarray and moments.ndim == 1 and moments[0] == moments[1]:
        return moments.copy()
    equal = (moments[..., 0] == moments[..., 1])[..., None]
    if known_false(xp.all(equal | xp.isnan(moments[..., :1]))):
        bad = np.asarray(moments)[~np.asarray(equal)[..., 0]][0]
        apart = abs(bad[0] - bad[1]) / max(bad[:2])
        remedy = (
            "They differ by rounding: give one of them twice." if apart <= EQUAL
            else "Other heavy tops have no closed form: put the axis third, or use HeavyTop with simulate."
        )
        raise InvalidInput(f"`moments` must be (I1, I1, I3), the first two equal; got {tuple(bad.tolist())} kg m², "
                           f"{apart:.1e} of their size apart. {remedy}")
    return xp.where(equal, moments, np.nan)


def _vertical(xp: Any, attitude: Array) -> Array:
    """Return cos θ = (w² + z² − x² − y²)/|q|²."""
    w, x, y, z = (attitude[..., k] for k in range(4))
    up, down = w * w + z * z, x * x + y * y
    return (up - down) / (up + down)
