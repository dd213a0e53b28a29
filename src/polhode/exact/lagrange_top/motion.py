"""The Lagrange top, exact at any time."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, ClassVar

import numpy as np

from polhode import rotation
from polhode.arrays import as_float64, is_traced, known_false, namespace, register_node
from polhode.errors import InvalidInput
from polhode.exact.lagrange_top import evaluation, geometry
from polhode.motion.base import AbstractMotion
from polhode.motion.inputs import (
    by_attributes,
    cached_unless_traced,
    checked,
    checked_last_axis,
    checked_times,
    common_shape,
    momentum_of,
    plain_answer,
    refuse_not_finite,
    refuse_overflow,
    refuse_tensor,
    spin_of,
)
from polhode.motion.invariants import drift, norm
from polhode.motion.layout import ENERGY, Quantity
from polhode.special.doubledouble import two_sum

Array = Any
ROUNDING = 1e-12  # relative; what sums leave of equal moments


@dataclass(frozen=True, eq=False)
class LagrangeMotion(AbstractMotion):
    """Heavy symmetric tops in closed form: H = ½ L·I⁻¹L + mgl cos θ, dL/dt = L × Ω + mgl Γ × e3, dR/dt = R hat(Ω).

    θ is the tilt of the body's third axis from the vertical, space z, up; Γ = Rᵀe_z. The Cayley–Klein parameters are
    quotients of theta functions, regular also where Euler angles are not, with phases in double-double: no step, no
    drift, the same error at any time, from the sleeping top to the spherical pendulum (moments I1, I1, any I3; L3 = 0).

    Args:
        moments: (…, 3) principal moments about the pivot [kg m²], positive, the first two equal.
        mgl: (…) weight times the distance from pivot to centre of mass [N m], positive where that lies on the side of
            the third axis. A negative one is a top on the reversed axis, with answers about the axis as given; zero is
            the free symmetric body.
        momentum: (…, 3) angular momentum at the epoch [kg m²/s, body axes]; this or ``angular_velocity``.
        attitude: (…, 4) unit quaternion wxyz at the epoch, body → space; q/|q| is meant, exactly.
        epoch: (…) time at which these hold [s].
        angular_velocity: (…, 3) at the epoch [rad/s, body axes].

    Attributes may be given by their own names too, ``momentum_at_epoch`` and ``attitude_at_epoch``: so
    ``dataclasses.replace(top, epoch=1.0)`` works.

    Batch axes of all five are broadcast against each other, and times against them. JAX arrays in, JAX arrays out, with
    ``jit``, ``vmap`` and first derivatives.

    Scalar answers such as ``nutation_period`` are floats for one top, inf where infinite and None where undefined; in
    batches they are arrays, with NaN where undefined.

    Raises:
        InvalidInput: for moments that are not positive, finite and equal in the first two, values that are not finite,
            or a quaternion that is not of unit length. Traced JAX values cannot be looked at; bad ones give NaN.

    Source: Klein & Sommerfeld, *Theorie des Kreisels*, ch. IV and VI; Whittaker, *Analytical Dynamics*, §71–75.

    >>> top = LagrangeMotion((1.0, 1.0, 0.5), 1.0, (0.0, 0.0, 2.5), (3**0.5 / 2, 0.5, 0.0, 0.0))
    >>> top.regime, round(top.nutation_period, 12), round(top.precession_per_period, 12)
    ('cusp', 2.763928649428, 1.142288718976)
    """

    title: ClassVar[str] = "Lagrange top"
    has_vertical: ClassVar[bool] = True
    moments: Array
    mgl: Array
    momentum_at_epoch: Array
    attitude_at_epoch: Array
    epoch: Array
    axes: ClassVar[None] = None  # vectors are along the principal axes
    _columns: tuple[Array, ...] = field(default=(), repr=False, init=False)

    def __init__(
        self, moments: Array, mgl: Array, momentum: Array | None = None, attitude: Array = (1.0, 0.0, 0.0, 0.0),
        epoch: Array = 0.0, *, angular_velocity: Array | None = None, **attributes: Array,
    ) -> None:  # fmt: skip
        momentum, attitude, axes = by_attributes("LagrangeMotion", momentum, attitude, attributes)
        if axes is not None:
            raise InvalidInput("`axes` must be left out: vectors of a LagrangeMotion are along the principal axes.")
        name, vector = spin_of(momentum, angular_velocity)
        named = {"moments": moments, "mgl": mgl, name: vector, "attitude": attitude, "epoch": epoch}
        xp = namespace(*named.values())
        moments, mgl, vector, attitude, epoch = (as_float64(xp, value, key) for key, value in named.items())
        refuse_tensor(moments, vector)
        vector = checked_last_axis(name, vector, 3)
        spin = vector if angular_velocity is None else momentum_of(moments, vector)
        moments, spin, attitude = checked(xp, moments, spin, attitude, epoch)
        refuse_not_finite(xp, mgl=mgl)
        common_shape(moments=moments[..., 0], mgl=mgl, momentum=spin[..., 0], epoch=epoch)
        self._hold(_checked_symmetry(xp, moments), mgl, spin, attitude, epoch)

    def _hold(self, moments: Array, mgl: Array, momentum: Array, attitude: Array, epoch: Array) -> None:
        values = {"moments": moments, "mgl": mgl, "momentum_at_epoch": momentum, "attitude_at_epoch": attitude}
        for name, value in (values | {"epoch": epoch}).items():
            object.__setattr__(self, name, value)
        register_node(LagrangeMotion, (*values, "epoch", "_columns"), like=moments)
        object.__setattr__(self, "_columns", evaluation.motion_columns(self._arguments))

    @property
    def _arguments(self) -> tuple[Array, Array, Array, Array]:
        return self.moments, self.mgl[..., None], self.momentum_at_epoch, self.attitude_at_epoch

    # ------------------------------------------------------------------ evaluation

    def state(self, t: Array) -> tuple[Array, Array]:
        """Return attitude (…, 4) and momentum (…, 3) at the times [s]; one evaluation gives both.

        The quaternion equals the given one over its length at the epoch, sign included. Between, its sign is
        continuous in t except where a rate and time exceed 2⁵⁰ turns.

        Raises:
            InvalidInput: for times that are not finite.
        """
        xp = namespace(t, self.moments)
        t = checked_times(xp, t, self.batch_shape)
        elapsed, rest = two_sum(t, -self.epoch)
        attitude, momentum = evaluation.state(self._columns, self._arguments, elapsed, rest)
        spin = xp.max(xp.abs(self.momentum_at_epoch / self.moments), axis=-1)
        refuse_overflow(xp, attitude, t, spin + xp.sqrt(xp.abs(self.mgl) / self.moments[..., 0]))
        return attitude, momentum

    @property
    def quantities(self) -> dict[str, Quantity]:
        return {
            "energy": ENERGY,
            "vertical_momentum": Quantity("kg m2 s-1", "angular momentum about the vertical"),
            "axial_momentum": Quantity("kg m2 s-1", "angular momentum about the top's axis"),
        }

    def _invariants(self, attitude: Array, momentum: Array, velocity: Array) -> tuple[dict[str, Array], dict[str, Any]]:
        """Return energy and momenta; drifts are relative to the largest kinetic energy plus |mgl|, and to max |L|."""
        xp = namespace(momentum, self.moments)
        kinetic = _kinetic_energy(xp, self.moments, momentum)
        values = {
            "energy": kinetic + self.mgl * _vertical(xp, attitude),
            "vertical_momentum": rotation.rotate(attitude, momentum)[..., 2],
            "axial_momentum": momentum[..., 2],
        }
        of_momentum = xp.max(norm(xp, momentum), axis=-1, keepdims=True)
        of_energy = xp.max(kinetic + xp.abs(self.mgl), axis=-1, keepdims=True)
        sizes = {name: of_energy if name == "energy" else of_momentum for name in values}
        return values, {name: drift(xp, value, False, sizes[name]) for name, value in values.items()}

    def along_principal_axes(self) -> LagrangeMotion:
        """Return the motion itself, which is along the principal axes."""
        return self

    def _with_time_axis(self) -> LagrangeMotion:
        motion = object.__new__(LagrangeMotion)
        vectors = (self.moments, self.momentum_at_epoch, self.attitude_at_epoch)
        moments, momentum, attitude = (v[..., None, :] if v.ndim > 1 else v for v in vectors)
        mgl, epoch = (v[..., None] if v.ndim else v for v in (self.mgl, self.epoch))
        motion._hold(moments, mgl, momentum, attitude, epoch)
        return motion

    # ------------------------------------------------------------------ meaning

    @property
    def batch_shape(self) -> tuple[int, ...]:
        return self._common_shape(*self._arguments)

    @cached_unless_traced
    def _numbers(self) -> geometry.Characteristics:
        return evaluation.characteristics(self._columns, self._arguments)

    @property
    def energy(self) -> Any:
        """Energy ½ L·I⁻¹L + mgl cos θ [J]; zero potential is the axis level with the pivot."""
        xp = namespace(self.moments, self.momentum_at_epoch)
        kinetic = _kinetic_energy(xp, self.moments, self.momentum_at_epoch)
        return plain_answer(kinetic + self.mgl * _vertical(xp, self.attitude_at_epoch))

    @property
    def vertical_momentum(self) -> Any:
        """p_φ = (R L)_z [kg m²/s], kept because the vertical is a symmetry of the weight."""
        xp = namespace(self.attitude_at_epoch, self.momentum_at_epoch)
        attitude = self.attitude_at_epoch / norm(xp, self.attitude_at_epoch)[..., None]
        return plain_answer(rotation.rotate(attitude, self.momentum_at_epoch)[..., 2])

    @property
    def axial_momentum(self) -> Any:
        """p_ψ = L3 = I3 ω3 [kg m²/s], kept because the axis is a symmetry of the body."""
        return plain_answer(self.momentum_at_epoch[..., 2])

    @property
    def regime(self) -> Any:
        """One of "rest", "sleeping", "hanging", "steady", "free", "planar", "undulating", "cusp", "loop", "separatrix".

        "sleeping" and "hanging" spin upright, centre of mass above or below the pivot; "steady" keeps its tilt; "free"
        has no weight; "planar" swings or turns over like a pendulum; "separatrix" comes to rest upright in infinite
        time; the others nutate, and are told apart by the azimuth: always onward, halting, or turning back in loops.
        Exact signs on the given floats decide. In batches, integer codes in that order from 0.
        """
        code = self._numbers.regime
        return code if np.ndim(code) or is_traced(code) else geometry.REGIMES[int(code)]

    @property
    def nutation_limits(self) -> tuple[Any, Any]:
        """(min, max) of cos θ."""
        return plain_answer(self._numbers.lowest), plain_answer(self._numbers.highest)

    @property
    def nutation_period(self) -> Any:
        """T [s]: the tilt's period; of a steady top, that of its smallest nutations."""
        return plain_answer(self._numbers.period)

    @property
    def precession_per_period(self) -> Any:
        """Δφ [rad]: azimuth gained by the axis in a period, unreduced; half a turn where it passes a vertical."""
        return plain_answer(self._numbers.precession_per_period)

    @property
    def spin_per_period(self) -> Any:
        """Δψ [rad]: turn of the body about its axis in a period, from the line of nodes, unreduced."""
        return plain_answer(self._numbers.spin_per_period)

    @property
    def precession_rate(self) -> Any:
        """Mean rate of the azimuth Δφ/T [rad/s]."""
        return plain_answer(self._numbers.precession_rate)

    @property
    def spin_rate(self) -> Any:
        """Mean rate of the body's own turn Δψ/T [rad/s]; ω3 is this plus the precession's share along the axis."""
        return plain_answer(self._numbers.spin_rate)


def _checked_symmetry(xp: Any, moments: Array) -> Array:
    equal = (moments[..., 0] == moments[..., 1])[..., None]
    if known_false(xp.all(equal | xp.isnan(moments[..., :1]))):
        bad = np.asarray(moments)[~np.asarray(equal)[..., 0]][0]
        apart = abs(bad[0] - bad[1]) / max(bad[:2])
        remedy = (
            "They differ by rounding: give one of them twice." if apart <= ROUNDING
            else "Other heavy tops have no closed form: put the axis third, or use HeavyTop with simulate."
        )  # fmt: skip
        raise InvalidInput(f"`moments` must be (I1, I1, I3), the first two equal; got {tuple(bad.tolist())} kg m², "
                           f"{apart:.1e} of their size apart. {remedy}")  # fmt: skip
    return xp.where(equal, moments, np.nan)


def _kinetic_energy(xp: Any, moments: Array, momentum: Array) -> Array:
    return 0.5 * xp.sum(momentum / moments * momentum, axis=-1)


def _vertical(xp: Any, attitude: Array) -> Array:
    """Return cos θ = (w² + z² − x² − y²)/|q|²."""
    w, x, y, z = (attitude[..., k] for k in range(4))
    up, down = w * w + z * z, x * x + y * y
    return (up - down) / (up + down)
