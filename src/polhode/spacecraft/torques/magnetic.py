"""Magnetic torques: a dipole in the Earth's field, torque rods under a law, and eddy currents."""

from __future__ import annotations

from typing import ClassVar

import equinox as eqx
import jax.numpy as jnp
import numpy as np

from polhode._base import check
from polhode._base.arrays import known_numbers_only
from polhode.errors import InvalidInput, shown
from polhode.spacecraft.systems.attachments import Argument, Attitude, Own, Time, Velocity
from polhode.spacecraft.torques.base import NEEDED, AbstractEnvironmentTorque, in_body
from polhode.spacecraft.torques.earth_field import EarthDipoleField
from polhode.systems._checks import checked_directions, checked_number, checked_numbers, checked_vector
from polhode.types import Array, ArrayLike, Float64, Real, Self

LAWS = ("b-dot", "dump")


class MagneticDipole(AbstractEnvironmentTorque):
    """τ = m × B of a moment fixed in the body, as of a permanent magnet or of residual currents.

    Args:
        field: B along the orbit.
        moment: m (3,) [A m², body axes].
    """

    name: ClassVar[str] = "magnetic-dipole"
    arguments: ClassVar[dict[str, Argument]] = {"moment": Argument("A*m^2", (3,))}

    field: EarthDipoleField
    moment: Float64[Array, "3"]

    @known_numbers_only
    def __init__(self, field: EarthDipoleField, moment: Real[ArrayLike, "3"]) -> None:
        self.field, self.moment = _checked_field(field), checked_vector("moment", moment)

    @property
    def rate(self) -> Float64[Array, ""]:
        return self.field.orbit.mean_motion

    def torque(
        self, t: Time, attitude: Attitude, angular_velocity: Velocity, actuator: Own | None = None
    ) -> Float64[Array, "*batch 3"]:
        assert attitude is not None, NEEDED
        return jnp.cross(self.moment, in_body(attitude, self.field.field(t)))


class TorqueRods(AbstractEnvironmentTorque):
    """τ = m × B of rods whose moment follows a law: "b-dot" stops tumbling, "dump" takes momentum out of wheels.

    b-dot: m = −k Ḃ, with Ḃ = Rᵀ dB/dt − Ω × B the exact rate of the field along the body: that which it has in space
    by the way of the body and the Earth's rotation, and that of the body's own turning. Nothing is filtered.

    dump: m = k h × B/|B|², with h the momentum stored inside, L − IΩ. The torque is −k times the part of h
    across the field.

    Each rod gives the part of m along it by the pseudo-inverse of the rods' directions, and at most ``limit``;
    a law beyond that is cut off for each rod.

    Args:
        field: B along the orbit.
        gain: k, of b-dot [A m² s/T], of dump [1/s], positive.
        law: "b-dot" or "dump".
        limit: largest moment of each rod [A m²], one for all or one each; None for no limit.
        axes: (rods, 3) directions of the rods [body axes]; three along the body's axes by default.

    Raises:
        InvalidInput: for a gain or a limit that is not positive, another law, or a direction of no length.

    Source: Stickler & Alfriend, J. Spacecraft and Rockets 13 (1976) 282; Wertz (1978), §19.2; Markley & Crassidis,
    *Fundamentals of Spacecraft Attitude Determination and Control* (2014), §7.5.
    """

    name: ClassVar[str] = "torque-rods"
    arguments: ClassVar[dict[str, Argument]] = {
        "gain": Argument("A*m^2*s/T"),
        "rate": Argument("1/s"),
        "law": Argument("text", choices=LAWS),
        "limit": Argument("A*m^2", many=True),
        "axes": Argument("", (3,), many=True),
    }

    field: EarthDipoleField
    gain: Float64[Array, ""]
    limit: Float64[Array, "*rods"] | None
    axes: Float64[Array, "rods 3"]
    shares: Float64[Array, "rods 3"]
    law: str = eqx.field(static=True)

    @known_numbers_only
    def __init__(
        self, field: EarthDipoleField, gain: float, law: str = "b-dot",
        limit: Real[ArrayLike, "*rods"] | None = None, axes: Real[ArrayLike, "rods 3"] | None = None,
    ) -> None:
        self.field, self.law = _checked_field(field), check.one_of("law", law, LAWS)
        self.gain = checked_number("gain", gain, above=0.0, unit="A m² s/T" if law == "b-dot" else "1/s")
        self.axes = checked_directions("axes", np.eye(3) if axes is None else axes)
        self.shares = jnp.asarray(np.linalg.pinv(np.asarray(self.axes)).T)
        self.limit = None if limit is None else checked_numbers("limit", limit, len(self.axes), above=0.0, unit="A m²")

    @classmethod
    def from_table(
        cls, field: EarthDipoleField, law: str = "b-dot", gain: float | None = None, rate: float | None = None,
        limit: Real[ArrayLike, "*rods"] | None = None, axes: Real[ArrayLike, "rods 3"] | None = None,
    ) -> Self:
        """Return the rods of a spec, whose k has a name and a unit for each law.

        Raises:
            InvalidInput: also where the law's own is missing, or the other's is there.
        """
        own, other, needed, example = (
            ("gain", "rate", gain, "5e4 A*m^2*s/T") if law == "b-dot" else ("rate", "gain", rate, "0.001 1/s")
        )
        if needed is None or None not in (gain, rate):
            raise InvalidInput(f'law = "{law}" takes `{own}`, like "{example}", and no `{other}`.')
        return cls(field, needed, law, limit, axes)

    @property
    def needs_stored(self) -> bool:
        return self.law == "dump"

    @property
    def rate(self) -> Float64[Array, ""]:
        return self.field.orbit.mean_motion

    def moments_of_rods(
        self, t: Time, attitude: Attitude, angular_velocity: Velocity,
        stored: Float64[Array, "*#batch 3"] | None = None,
    ) -> Float64[Array, "*batch rods"]:
        """Return the moment of each rod (…, rods) [A m²]."""
        assert attitude is not None, NEEDED
        field = in_body(attitude, self.field.field(t))
        if self.law == "b-dot":
            change = in_body(attitude, self.field.field_rate(t)) - jnp.cross(angular_velocity, field)
            wanted = -self.gain * change
        else:
            assert stored is not None, "this law needs the momentum stored inside"
            wanted = self.gain * jnp.cross(stored, field) / jnp.sum(field**2, axis=-1, keepdims=True)
        moments = jnp.sum(wanted[..., None, :] * self.shares, axis=-1)
        return moments if self.limit is None else jnp.clip(moments, -self.limit, self.limit)

    @property
    def limited(self) -> bool:
        return self.limit is not None

    def load(
        self, t: Time, attitude: Attitude, angular_velocity: Velocity, own: Own, stored: Velocity
    ) -> Float64[Array, "*batch"]:
        if self.limit is None:
            return jnp.zeros(angular_velocity.shape[:-1])
        asked = self.without_limits().moments_of_rods(t, attitude, angular_velocity, stored)
        return jnp.max(jnp.abs(asked) / self.limit, axis=-1)

    def without_limits(self) -> Self:
        return eqx.tree_at(lambda rods: rods.limit, self, None, is_leaf=lambda x: x is None)

    def torque(
        self, t: Time, attitude: Attitude, angular_velocity: Velocity, actuator: Own | None = None,
        stored: Float64[Array, "*#batch 3"] | None = None,
    ) -> Float64[Array, "*batch 3"]:
        """Return τ (…, 3) [N m, body axes]; ``stored`` is L − IΩ (…, 3), which "dump" needs."""
        assert attitude is not None, NEEDED
        moments = self.moments_of_rods(t, attitude, angular_velocity, stored)
        moment = jnp.sum(moments[..., None] * self.axes, axis=-2)
        return jnp.cross(moment, in_body(attitude, self.field.field(t)))


class EddyCurrents(AbstractEnvironmentTorque):
    """τ = −k Ḃ × B of currents that the field drives in conducting parts of a body that turns in it.

    Ḃ = Rᵀ dB/dt − Ω × B is the field's rate along the body. Of a thin spherical shell of radius r, thickness d and
    conductivity s, k = (2π/3) s d r⁴. The torque is as of the law b-dot, with no rods to be limited.

    Args:
        field: B along the orbit.
        coefficient: k [N m s/T², that is m⁴/Ω], not negative.

    Source: Wertz (ed.), *Spacecraft Attitude Determination and Control* (1978), §17.1 and table 17-2.
    """

    name: ClassVar[str] = "eddy-currents"
    arguments: ClassVar[dict[str, Argument]] = {"coefficient": Argument("N*m*s/T^2")}

    field: EarthDipoleField
    coefficient: Float64[Array, ""]

    @known_numbers_only
    def __init__(self, field: EarthDipoleField, coefficient: float) -> None:
        self.field = _checked_field(field)
        self.coefficient = checked_number("coefficient", coefficient, least=0.0, unit="N m s/T²")

    def torque(
        self, t: Time, attitude: Attitude, angular_velocity: Velocity, actuator: Own | None = None
    ) -> Float64[Array, "*batch 3"]:
        assert attitude is not None, NEEDED
        field = in_body(attitude, self.field.field(t))
        change = in_body(attitude, self.field.field_rate(t)) - jnp.cross(angular_velocity, field)
        return -self.coefficient * jnp.cross(change, field)


def _checked_field(field: EarthDipoleField) -> EarthDipoleField:
    if not hasattr(field, "field") or not hasattr(field, "field_rate"):
        raise InvalidInput(f"`field` must be a polhode.spacecraft.EarthDipoleField; got {shown(field)}.")
    return field
