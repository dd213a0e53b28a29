"""Torques of given size: thrusters that fire at given times, and constant couples."""

from __future__ import annotations

from typing import ClassVar

import equinox as eqx
import jax.numpy as jnp
import numpy as np

from polhode._base import check
from polhode._base.arrays import known_numbers_only, require_doubles
from polhode.errors import InvalidInput
from polhode.spacecraft.systems.attachments import Argument, Attitude, Own, Time, Velocity
from polhode.spacecraft.torques.base import NEEDED, AbstractTorque, in_body
from polhode.systems._checks import checked_number, checked_numbers, checked_times, checked_vector
from polhode.types import Array, ArrayLike, Float64, Real, Self

FRAMES = ("body", "space")


class Thruster(AbstractTorque):
    """A thruster that fires one or more pulses: F while it fires, and r × F about the origin of the body's axes.

    Its pulses begin and end at ``jumps``, so that steps end there and no pulse is missed, however short it is. Where
    times are rounded, the impulse of a pulse stays F times how long it lasts.

    Args:
        at: (P,) times [s] at which it begins to fire, or one.
        lasting: (P,) how long each pulse lasts [s], or one for all, positive.
        force: F (3,) on the body [N, body axes], opposite to the jet.
        position: r (3,) of the nozzle [m, body axes].

    Raises:
        InvalidInput: for pulses that last no time or overlap, or values that are not finite.

    >>> jet = Thruster(at=[10.0, 20.0], lasting=0.5, force=(0.0, 0.0, 2.0), position=(0.1, 0.0, 0.0))
    >>> jet.torque(10.25, None, jnp.zeros(3)).tolist(), jet.torque(10.5, None, jnp.zeros(3)).tolist()
    ([0.0, -0.2, 0.0], [0.0, 0.0, 0.0])
    >>> jet.jumps.tolist()
    [10.0, 10.5, 20.0, 20.5]
    """

    name: ClassVar[str] = "thruster"
    arguments: ClassVar[dict[str, Argument]] = {
        "at": Argument("s", many=True),
        "lasting": Argument("s", many=True),
        "force": Argument("N", (3,)),
        "position": Argument("m", (3,)),
    }

    begins: Float64[Array, "pulses"]
    ends: Float64[Array, "pulses"]
    shares: Float64[Array, "pulses"]
    thrust: Float64[Array, "3"]
    position: Float64[Array, "3"]

    @known_numbers_only
    def __init__(
        self, at: Real[ArrayLike, "..."], lasting: Real[ArrayLike, "..."], force: Real[ArrayLike, "3"],
        position: Real[ArrayLike, "3"],
    ) -> None:
        require_doubles(at=at, lasting=lasting)
        begins = checked_times("at", at)
        spans = checked_times("lasting", lasting)
        if len(spans) not in (1, len(begins)):
            raise InvalidInput(
                f"`lasting` must be one time or one for each of the {len(begins)} pulses; got {len(spans)}."
            )
        check.array("lasting", spans, ("n",), "s", above=0, remedy="Leave out what never fires.")
        order = np.argsort(begins)
        begins, ends = begins[order], (begins + spans)[order]
        if not (ends > begins).all():
            raise InvalidInput(
                f"`lasting` {spans.min():g} s is less than a rounding of the time {begins.max():g} s. Count the time "
                "from nearer to the pulse."
            )
        if over := np.flatnonzero(begins[1:] < ends[:-1]).tolist():
            raise InvalidInput(
                f"`at` has a pulse that begins at {begins[over[0] + 1]:g} s, before the one from {begins[over[0]]:g} s "
                f"ends at {ends[over[0]]:g} s. A thruster fires one pulse at a time: make them one, or two thrusters."
            )
        self.begins, self.ends = jnp.asarray(begins), jnp.asarray(ends)
        # late in time the end of a pulse is rounded: the force makes up for it, so that the impulse is the given one
        self.shares = jnp.asarray(np.broadcast_to(spans, begins.shape)[order] / (ends - begins))
        self.thrust, self.position = checked_vector("force", force), checked_vector("position", position)

    @property
    def jumps(self) -> Float64[Array, "jumps"]:
        return jnp.ravel(jnp.stack([self.begins, self.ends], axis=-1))

    @property
    def names_all_jumps(self) -> bool:
        return True

    def force(
        self, t: Time, attitude: Attitude, angular_velocity: Velocity, actuator: Own | None = None
    ) -> Float64[Array, "*batch 3"]:
        time = jnp.asarray(t)[..., None]
        # each pulse adds one from its beginning, and takes it back at its end
        begun, ended = (jnp.where(time >= at, self.shares, 0.0) for at in (self.begins, self.ends))
        firing = jnp.sum(begun - ended, axis=-1)
        return firing[..., None] * self.thrust + jnp.zeros_like(angular_velocity)

    def torque(
        self, t: Time, attitude: Attitude, angular_velocity: Velocity, actuator: Own | None = None
    ) -> Float64[Array, "*batch 3"]:
        return jnp.cross(self.position, self.force(t, attitude, angular_velocity))


class ConstantTorque(AbstractTorque):
    """A constant couple, as of a leak or a constant thrust, along the body or in space.

    Args:
        torque: (3,) [N m].
        frame: "body", if it turns with the body, or "space".

    Raises:
        InvalidInput: for another frame, or anything but a vector.
    """

    name: ClassVar[str] = "constant"
    arguments: ClassVar[dict[str, Argument]] = {
        "torque": Argument("N*m", (3,)),
        "frame": Argument("text", choices=FRAMES),
    }

    vector: Float64[Array, "3"]
    frame: str = eqx.field(static=True)

    @known_numbers_only
    def __init__(self, torque: Real[ArrayLike, "3"], frame: str = "body") -> None:
        self.vector, self.frame = checked_vector("torque", torque), check.one_of("frame", frame, FRAMES)

    @property
    def names_all_jumps(self) -> bool:
        return True

    @property
    def needs_attitude(self) -> bool:
        return self.frame == "space"

    def torque(
        self, t: Time, attitude: Attitude, angular_velocity: Velocity, actuator: Own | None = None
    ) -> Float64[Array, "*batch 3"]:
        if self.frame == "body":
            return self.vector + jnp.zeros_like(angular_velocity)
        assert attitude is not None, NEEDED
        return in_body(attitude, self.vector)


class DumpingThrusters(AbstractTorque):
    """τ = −k h of thrusters in pairs, which take the momentum h = L − IΩ out of wheels where no field is strong enough.

    Their pulses are much shorter than everything else here and averaged, so that they deliver the command, up
    to a limit. Inside a dead band of h about each axis nothing fires: τ = −k (h − the nearest h in the band).

    Args:
        rate: k [1/s], positive.
        limit: largest torque about each axis of the body [N m], one for all or three; None for no limit.
        dead_band: momentum about each axis [N m s] up to which nothing fires; 0 by default.

    Raises:
        InvalidInput: for a rate or limit that is not positive, or a negative dead band.

    Source: Wertz (ed.), *Spacecraft Attitude Determination and Control* (1978), §19.1, "momentum dumping".

    >>> jets = DumpingThrusters(rate=0.01, limit=0.02, dead_band=0.5)
    >>> jets.torque(0.0, None, jnp.zeros(3), stored=jnp.array([0.4, -1.5, 40.0])).tolist()
    [0.0, 0.01, -0.02]
    """

    name: ClassVar[str] = "dumping-thrusters"
    arguments: ClassVar[dict[str, Argument]] = {
        "rate": Argument("1/s"),
        "limit": Argument("N*m", many=True),
        "dead_band": Argument("N*m*s"),
    }

    gain: Float64[Array, ""]
    limit: Float64[Array, "3"] | None
    dead_band: Float64[Array, ""] | None

    @known_numbers_only
    def __init__(
        self, rate: float, limit: Real[ArrayLike, "..."] | None = None, dead_band: float = 0.0
    ) -> None:
        self.gain = checked_number("rate", rate, above=0.0, unit="1/s")
        band = checked_number("dead_band", dead_band, least=0.0, unit="N m s")
        self.dead_band = band if band > 0.0 else None  # a band of no width would still have corners
        self.limit = None if limit is None else checked_numbers("limit", limit, 3, above=0.0, unit="N m")

    @property
    def names_all_jumps(self) -> bool:
        return True

    @property
    def needs_stored(self) -> bool:
        return True

    @property
    def limited(self) -> bool:
        return self.limit is not None

    def without_limits(self) -> Self:
        return eqx.tree_at(lambda jets: jets.limit, self, None, is_leaf=lambda x: x is None)

    def load(
        self, t: Time, attitude: Attitude, angular_velocity: Velocity, own: Own, stored: Velocity
    ) -> Float64[Array, "*batch"]:
        if self.limit is None:
            return jnp.zeros(angular_velocity.shape[:-1])
        return jnp.max(jnp.abs(self._find_wanted(stored)) / self.limit, axis=-1)

    def torque(
        self, t: Time, attitude: Attitude, angular_velocity: Velocity, actuator: Own | None = None,
        stored: Float64[Array, "*#batch 3"] | None = None,
    ) -> Float64[Array, "*batch 3"]:
        """Return τ (…, 3) [N m, body axes]; ``stored`` is L − IΩ (…, 3)."""
        assert stored is not None, "this law needs the momentum stored inside"
        asked = self._find_wanted(stored) + jnp.zeros_like(angular_velocity)
        return asked if self.limit is None else jnp.clip(asked, -self.limit, self.limit)

    def _find_wanted(self, stored: Array) -> Array:
        band = self.dead_band
        return -self.gain * (stored if band is None else stored - jnp.clip(stored, -band, band))
