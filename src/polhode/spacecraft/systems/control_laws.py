"""Laws of attitude control: the torque commanded for a body, from its attitude and rates."""

from __future__ import annotations

import abc
from collections.abc import Callable
from typing import Any, ClassVar, NamedTuple

import equinox as eqx
import jax.numpy as jnp
import numpy as np

from polhode import rotation
from polhode._base import check
from polhode._base.arrays import compiled_for_few_calls, known_numbers_only, require_doubles
from polhode.errors import InvalidInput, shown
from polhode.motion._layout import StatePart
from polhode.motion.frame import BodyFrame
from polhode.spacecraft.systems.attachments import (
    AbstractAttachment,
    Argument,
    Attitude,
    Own,
    Time,
    Velocity,
    checked_jumps,
)
from polhode.spacecraft.torques.base import NEEDED, in_body
from polhode.systems._checks import checked_number, checked_vector
from polhode.systems.kepler_orbit import KeplerOrbit
from polhode.types import Array, ArrayLike, Float64, Real, Self

TARGETS = ("inertial", "nadir")
LawFunction = Callable[..., Any]


class GainLimits(NamedTuple):
    """Which matrices of gains are refused."""

    relative_asymmetry: float = 1e-12  # of the largest entry


LIMITS = GainLimits()


class AbstractControlLaw(AbstractAttachment):
    """A law that commands a torque on the body, which wheels or an ideal actuator then deliver.

    A new law gives ``wanted`` and, where it has a state of its own, ``state_parts`` and ``state_rate``. A spec names it
    by ``law`` of ``[control]``; that of another package registers its class in the entry-point group
    ``polhode.control``.
    """

    @property
    def needs_attitude(self) -> bool:
        return True

    @abc.abstractmethod
    def wanted(
        self, t: Time, attitude: Attitude, angular_velocity: Velocity, own: Own
    ) -> Float64[Array, "*batch 3"]:
        """Return the commanded torque on the body (…, 3) [N m, body axes]."""

    def state_rate(
        self, t: Time, attitude: Attitude, angular_velocity: Velocity, own: Own
    ) -> Float64[Array, "*batch {self.state_size}"]:
        """Return the rate of its own state (…, n); zero by default."""
        return jnp.zeros_like(own)

    def target(self, t: Real[ArrayLike, "*shape"]) -> Float64[Array, "*shape 4"] | None:
        """Return the attitude that it is to hold (…, 4); None where it holds none."""
        return None

    def target_rate(self, t: Real[ArrayLike, "*shape"]) -> Float64[Array, "*shape 3"] | None:
        """Return the angular velocity that it is to hold (…, 3) [rad/s, space axes]; None where it holds none."""
        return None

    def started(self, t: float, attitude: Real[ArrayLike, "4"]) -> Self:
        """Return this law for a motion that begins so, as the shorter way to a target depends on it."""
        return self


class AbstractLawActuator(AbstractAttachment):
    """An actuator that delivers a law's torque: it jumps, and needs the attitude, where its law does."""

    law: eqx.AbstractVar[AbstractControlLaw]

    def bound(self, frame: BodyFrame) -> Self:
        return eqx.tree_at(lambda one: one.law, self, self.law.bound(frame))

    @property
    def reached(self) -> Float64[Array, "3 3"]:
        """(3, 3) projection of a commanded torque onto the deliverable; the identity by default."""
        return jnp.eye(3)

    @property
    def jumps(self) -> Float64[Array, "jumps"]:
        return self.law.jumps

    @property
    def names_all_jumps(self) -> bool:
        return self.law.names_all_jumps

    @property
    def needs_attitude(self) -> bool:
        return self.law.needs_attitude


def checked_law(law: Any) -> AbstractControlLaw:
    """Return a control law.

    Raises:
        InvalidInput: for anything else.
    """
    check.instance("law", law, AbstractControlLaw, "a control law, such as polhode.spacecraft.QuaternionPD",
                   "For a function of your own give UserLaw(function).")
    return law


class QuaternionPD(AbstractControlLaw):
    """τ = −2 P v − D (Ω − Ω_t), with v the vector part of the quaternion from the target to the body.

    Near the target 2 v is the vector of the small remaining turn, so that P is the stiffness against it, and
    I θ̈ = −P θ − D θ̇. The sign of the quaternion is chosen at the start, for the shorter way; it then stays, so that
    nothing jumps, and a body that is disturbed by more than half a turn comes back the way it went.

    Args:
        gain: P [N m/rad], one for all axes, (3,), or (3, 3) symmetric; with ``rate_gain``.
        rate_gain: D [N m s/rad], likewise.
        bandwidth: ω [rad/s] instead of both, for P = ω² I and D = 2 ζ ω I of the body that it is put on, mounts locked.
        damping: ζ, with ``bandwidth``; 0.7 by default.
        target: "inertial" for an attitude that is fixed in space, "nadir" for axes that look down along the orbit:
            z to the centre, y against the normal, x ahead.
        attitude: (4,) of the body against these axes; in space, or of the axes that look down, the identity by default.
        orbit: for "nadir".

    Raises:
        InvalidInput: for gains that are not positive, both or neither kind of them, or an unknown target.

    Source: Wie, Weiss & Arapostathis, J. Guid. Control Dyn. 12 (1989) 375; Markley & Crassidis (2014), §7.2.
    """

    name: ClassVar[str] = "quaternion-pd"
    arguments: ClassVar[dict[str, Argument]] = {
        "gain": Argument("N*m/rad", many=True),
        "rate_gain": Argument("N*m*s/rad", many=True),
        "bandwidth": Argument("rad/s"),
        "damping": Argument(),
        "target": Argument("text", choices=TARGETS),
        "attitude": Argument("attitude"),
    }

    gain: Float64[Array, "3 3"] | None
    rate_gain: Float64[Array, "3 3"] | None
    bandwidth: Float64[Array, ""] | None
    damping: Float64[Array, ""]
    attitude: Float64[Array, "4"]
    orbit: KeplerOrbit | None
    sign: Float64[Array, ""]

    @known_numbers_only
    def __init__(
        self, gain: Real[ArrayLike, "..."] | None = None, rate_gain: Real[ArrayLike, "..."] | None = None,
        bandwidth: float | None = None, damping: float | None = None,
        target: str = "inertial", attitude: Real[ArrayLike, "4"] = (1.0, 0.0, 0.0, 0.0),
        orbit: KeplerOrbit | None = None,
    ) -> None:
        check.one_of("target", target, TARGETS)
        if target == "nadir" and not isinstance(orbit, KeplerOrbit):
            raise InvalidInput('`target` "nadir" looks down along an orbit; give `orbit`, a KeplerOrbit.')
        if (gain is None) != (rate_gain is None) or (gain is None) == (bandwidth is None):
            raise InvalidInput("give `gain` and `rate_gain` together, or `bandwidth` instead of both.")
        if damping is not None and bandwidth is None:
            raise InvalidInput("`damping` goes with `bandwidth`; with gains it is `rate_gain` that damps.")
        self.gain = None if gain is None else checked_gain("gain", gain, "N m/rad")
        self.rate_gain = None if rate_gain is None else checked_gain("rate_gain", rate_gain, "N m s/rad")
        self.bandwidth = None if bandwidth is None else checked_number("bandwidth", bandwidth, 0.0, unit="rad/s")
        self.damping = checked_number("damping", 0.7 if damping is None else damping, above=0.0)
        self.attitude = jnp.asarray(rotation.normalize(np.asarray(attitude, dtype=float)))
        self.orbit, self.sign = orbit if target == "nadir" else None, jnp.ones(())

    def bound(self, frame: BodyFrame) -> QuaternionPD:
        if self.bandwidth is None:
            return self
        inertia, known = np.asarray(frame.inertia), lambda law: (law.gain, law.rate_gain)
        bandwidth, damping = float(self.bandwidth), float(self.damping)
        gains = jnp.asarray(bandwidth**2 * inertia), jnp.asarray(2.0 * damping * bandwidth * inertia)
        return eqx.tree_at(known, self, gains, is_leaf=lambda x: x is None)

    @property
    def names_all_jumps(self) -> bool:
        return True

    def target(self, t: Real[ArrayLike, "*shape"]) -> Float64[Array, "*shape 4"]:
        if self.orbit is None:
            return jnp.broadcast_to(self.attitude, (*jnp.shape(t), 4))
        return rotation.multiply(self.orbit.frame(t), self.attitude)

    def target_rate(self, t: Real[ArrayLike, "*shape"]) -> Float64[Array, "*shape 3"]:
        if self.orbit is None:
            return jnp.zeros((*jnp.shape(t), 3))
        return self.orbit.turning_rate(t)[..., None] * self.orbit.normal

    def started(self, t: float, attitude: Real[ArrayLike, "4"]) -> QuaternionPD:
        same = float(np.sum(np.asarray(target_at(self, jnp.asarray(float(t)))) * np.asarray(attitude)))
        return eqx.tree_at(lambda law: law.sign, self, jnp.asarray(-1.0 if same < 0.0 else 1.0))

    def wanted(
        self, t: Time, attitude: Attitude, angular_velocity: Velocity, own: Own
    ) -> Float64[Array, "*batch 3"]:
        assert attitude is not None, NEEDED
        if self.gain is None or self.rate_gain is None:
            raise InvalidInput("a law with a `bandwidth` has its gains once it is put on a body, by `RigidBody`.")
        left = rotation.multiply(rotation.conjugate(self.target(jnp.asarray(t))), attitude)[..., 1:]
        rate = angular_velocity
        if self.orbit is not None:
            rate = rate - in_body(attitude, self.target_rate(jnp.asarray(t)))
        return -2.0 * self.sign * (left @ self.gain) - rate @ self.rate_gain


class RateControl(AbstractControlLaw):
    """τ = −D (Ω − Ω_t): brings the body to an angular velocity along its own axes, as for spin-up or to stop it.

    Args:
        angular_velocity: Ω_t (3,) [rad/s, body axes]; rest by default.
        rate_gain: D [N m s/rad], one for all axes, (3,), or (3, 3) symmetric.
        bandwidth: 1/T [rad/s] instead, for D = I/T of the body that it is put on.

    Raises:
        InvalidInput: for gains that are not positive, or both or neither kind of them.
    """

    name: ClassVar[str] = "rate"
    arguments: ClassVar[dict[str, Argument]] = {
        "angular_velocity": Argument("rad/s", (3,)),
        "rate_gain": Argument("N*m*s/rad", many=True),
        "bandwidth": Argument("rad/s"),
    }

    aim: Float64[Array, "3"]
    rate_gain: Float64[Array, "3 3"] | None
    bandwidth: Float64[Array, ""] | None

    @known_numbers_only
    def __init__(
        self, angular_velocity: Real[ArrayLike, "3"] = (0.0, 0.0, 0.0), rate_gain: Real[ArrayLike, "..."] | None = None,
        bandwidth: float | None = None,
    ) -> None:
        if (rate_gain is None) == (bandwidth is None):
            raise InvalidInput("give `rate_gain` or `bandwidth`, one of the two.")
        self.aim = checked_vector("angular_velocity", angular_velocity)
        self.rate_gain = None if rate_gain is None else checked_gain("rate_gain", rate_gain, "N m s/rad")
        self.bandwidth = None if bandwidth is None else checked_number("bandwidth", bandwidth, 0.0, unit="rad/s")

    def bound(self, frame: BodyFrame) -> RateControl:
        if self.bandwidth is None:
            return self
        gain = jnp.asarray(float(self.bandwidth) * np.asarray(frame.inertia))
        return eqx.tree_at(lambda law: law.rate_gain, self, gain, is_leaf=lambda x: x is None)

    @property
    def names_all_jumps(self) -> bool:
        return True

    @property
    def needs_attitude(self) -> bool:
        return False

    def wanted(
        self, t: Time, attitude: Attitude, angular_velocity: Velocity, own: Own
    ) -> Float64[Array, "*batch 3"]:
        if self.rate_gain is None:
            raise InvalidInput("a law with a `bandwidth` has its gain once it is put on a body, by `RigidBody`.")
        return -(angular_velocity - self.aim) @ self.rate_gain


class UserLaw(AbstractControlLaw):
    """A law by functions of one's own.

    Args:
        command: (t, attitude, angular_velocity, own) → the commanded torque (…, 3) [N m, body axes], of the time (…)
            [s], the attitude (…, 4), Ω (…, 3) and the law's own state (…, n); batched and written with ``jax.numpy``.
        state_rate: these arguments → the rate of the own state (…, n); None for a law without one.
        state_size: n.
        jumps: (J,) times [s] at which the command jumps; see ``AbstractSystem.jumps``.

    Raises:
        InvalidInput: for anything but a function, or a state without its rate.

    >>> law = UserLaw(lambda t, attitude, rates, own: -0.1 * rates - own, lambda t, attitude, rates, own: rates, 3)
    >>> law.wanted(0.0, jnp.array([1.0, 0.0, 0.0, 0.0]), jnp.array([1.0, 0.0, 0.0]), jnp.ones(3)).tolist()
    [-1.1, -1.0, -1.0]
    """

    command: LawFunction
    own_rate: LawFunction | None
    size: int = eqx.field(static=True)
    jump_times: Float64[Array, "jumps"]

    @known_numbers_only
    def __init__(
        self, command: Any, state_rate: Any = None, state_size: int = 0,
        jumps: Real[ArrayLike, "jumps"] = (),
    ) -> None:
        for name, function in (("command", command), ("state_rate", state_rate)):
            if not callable(function) and not (name == "state_rate" and function is None):
                check.refuse(name, "a function (t, attitude, angular_velocity, own)", function)
        if type(state_size) is not int or state_size < 0 or (state_size > 0) != (state_rate is not None):
            check.refuse("state_size", "how many numbers the own state has, with `state_rate` to say how they change",
                         state_size)
        self.command, self.own_rate, self.size = command, state_rate, state_size
        self.jump_times = checked_jumps(jumps)

    @property
    def jumps(self) -> Float64[Array, "jumps"]:
        return self.jump_times

    @property
    def state_parts(self) -> tuple[StatePart, ...]:
        return (StatePart("law_state", self.size, "", "own state of the law"),) if self.size else ()

    def wanted(
        self, t: Time, attitude: Attitude, angular_velocity: Velocity, own: Own
    ) -> Float64[Array, "*batch 3"]:
        return self.command(t, attitude, angular_velocity, own)

    def state_rate(
        self, t: Time, attitude: Attitude, angular_velocity: Velocity, own: Own
    ) -> Float64[Array, "*batch {self.state_size}"]:
        if self.own_rate is None:
            return jnp.zeros_like(own)
        return self.own_rate(t, attitude, angular_velocity, own)


@compiled_for_few_calls
def target_at(law: AbstractControlLaw, t: Real[ArrayLike, "*shape"]) -> Float64[Array, "*shape 4"] | None:
    """Return the law's target, by a compiled function."""
    return law.target(t)


def checked_gain(name: str, value: Real[ArrayLike, "..."], unit: str) -> Float64[Array, "3 3"]:
    """Return a positive gain of one number, three or nine as a matrix (3, 3).

    Raises:
        InvalidInput: for another shape, or a matrix that is not symmetric and positive definite.
    """
    require_doubles(**{name: value})
    try:
        gain = np.asarray(value, dtype=float)
    except (TypeError, ValueError):
        gain = np.full(2, np.nan)
    gain = gain.reshape(()) if gain.size == 1 else gain
    if gain.shape in ((), (3,)):
        gain = np.diag(np.broadcast_to(gain, 3))
    if gain.shape != (3, 3) or not np.isfinite(gain).all():
        raise InvalidInput(f"`{name}` must be one, three or (3, 3) finite numbers [{unit}]; got {shown(value)}.")
    symmetric = np.abs(gain - gain.T).max() <= LIMITS.relative_asymmetry * np.abs(gain).max()
    if not symmetric or not np.linalg.eigvalsh(gain).min() > 0:
        check.refuse(name, f"positive [{unit}], as a matrix symmetric and positive definite", value,
                     "A gain of the wrong sign drives the body away.")
    return jnp.asarray(gain)
