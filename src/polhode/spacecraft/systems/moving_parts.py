"""Parts with mass that move in a body, so that its inertia and its centre of mass change: slosh, panels, booms."""

from __future__ import annotations

import abc
from typing import Any, ClassVar

import equinox as eqx
import jax.numpy as jnp
import numpy as np

from polhode._base import check
from polhode._base.arrays import known_numbers_only
from polhode.errors import InvalidInput, shown
from polhode.motion._layout import StatePart
from polhode.motion.frame import BodyFrame
from polhode.spacecraft.systems.attachments import Attitude, Time, Velocity, checked_attachments
from polhode.spacecraft.systems.mounts import AbstractMount, AbstractMounted
from polhode.types import Array, ArrayLike, Float64, Real, Self

MOMENTUM_UNITS = {"m": "kg m s-1", "rad": "kg m2 s-1", "1": "kg m2 s-1"}
Coordinates = Float64[Array, "*batch {self.count}"]


class AbstractMovingPart(AbstractMounted):
    """A part with mass whose place in the body depends on coordinates q, with canonical momenta π = ∂T/∂q̇.

    Its own state is q, then π, then the rest of its state. q = 0 is its rest, at which the body's mass properties,
    those of all together, are given; the body must have a mass. Positions count from the origin of the body's axes. The
    body makes the equations of motion from ``position``, ``tensor``, ``turning_axes`` and ``potential`` by
    differentiation, see ``_moving_masses.py``: momentum in space stays, and the energy changes by ``applied`` · q̇
    alone. Forces of torques act on the carrier.

    A new part gives ``coordinates`` and ``position``; one that turns also ``tensor`` and ``turning_axes``; and
    ``potential``, ``applied`` and ``conserves_energy`` where springs, dampers or motors act on it. One with more
    coordinates than ways to move gives ``gauge``.
    """

    mass: eqx.AbstractVar[Float64[Array, ""]]
    carries_spin: ClassVar[bool] = False  # whether it has a momentum p, across all w_j
    moves_mass: ClassVar[bool] = True  # whether its centre of mass moves

    @property
    @abc.abstractmethod
    def coordinates(self) -> tuple[StatePart, ...]:
        """The parts of q, with the unit of each."""

    @property
    def further_parts(self) -> tuple[StatePart, ...]:
        """The parts of its own state behind q and π; none by default."""
        return ()

    @property
    def state_parts(self) -> tuple[StatePart, ...]:
        momenta = [
            part._replace(
                name=f"{part.name}_momentum",
                unit=MOMENTUM_UNITS.get(part.unit, ""),
                meaning=f"canonical momentum of the {part.meaning}",
            )
            for part in self.coordinates
        ]
        return (*self.coordinates, *momenta, *self.further_parts)

    @property
    def count(self) -> int:
        """Its number of coordinates."""
        return sum(part.size for part in self.coordinates)

    @property
    def rate_count(self) -> int:
        """The number of rates that ``pack`` takes for it: those of q, and of rotors in it."""
        return self.count

    @property
    def further_count(self) -> int:
        """The number of components of its own state behind q and π."""
        return sum(part.size for part in self.further_parts)

    def coordinates_of(self, own: Float64[Array, "*batch {self.state_size}"]) -> Coordinates:
        """Return q (…, n) of its own state."""
        return own[..., : self.count]

    def bound(self, frame: BodyFrame) -> Self:
        if self.moves_mass and frame.mass is None:
            raise InvalidInput(
                f"a {type(self).__name__} moves the centre of mass, and so needs the mass of the whole body. Give the "
                "body its `mass` beside the moments; in Python that is of the `Body` for `RigidBody.from_body`."
            )
        return self

    @abc.abstractmethod
    def position(self, q: Coordinates) -> Float64[Array, "*batch 3"]:
        """Return its centre of mass (…, 3) [m, body axes]."""

    def at_rest(self) -> tuple[Float64[Array, "3"], Float64[Array, "3 3"] | None]:
        """Return the position (3,) and the ``tensor`` (3, 3) with which the body's mass properties are given."""
        return self.position(jnp.zeros(self.count)), self.tensor(jnp.zeros(self.count))

    def tensor(self, q: Coordinates) -> Float64[Array, "*batch 3 3"] | None:
        """Return its inertia about its centre of mass (…, 3, 3) [kg m², body axes]; None for a point."""
        return None

    def turning_axes(self, q: Coordinates) -> list[Float64[Array, "*batch 3"]] | None:
        """Return w_j (…, 3) of each coordinate, with Σ w_j q̇_j its angular velocity against the body; None for zero."""
        return None

    def spin_inertia(self, q: Coordinates) -> Float64[Array, "*batch 3 3"] | None:
        """Return the inertia (…, 3, 3) [kg m², body axes] that the rest of its own state turns, not in ``tensor``."""
        return None

    @property
    def inertia(self) -> Float64[Array, "3 3"] | None:
        return self.spin_inertia(jnp.zeros(self.count))

    def gauge(self, q: Coordinates) -> Float64[Array, "*batch"] | None:
        """Return f (…) [kg^½ m], a function of q that moves nothing; None where all coordinates move something.

        ½ ḟ² is added to the kinetic energy. As nothing else depends on f, ḟ stays zero and the motion is unchanged, but
        the mass matrix is regular.
        """
        return None

    def coordinate_rates(
        self, q: Float64[Array, "*#batch {self.count}"], rate: Float64[Array, "*#batch rates"]
    ) -> Float64[Array, "*batch {self.count}"]:
        """Return q̇ (…, n) of the rates that ``pack`` takes; by default they are its first ones."""
        return rate[..., : self.count]

    def potential(self, q: Coordinates) -> Float64[Array, "*batch"]:
        """Return V (…) [J]."""
        return jnp.zeros(q.shape[:-1])

    def applied(
        self, t: Time, attitude: Attitude, angular_velocity: Velocity, own: Float64[Array, "*#batch {self.state_size}"],
        rate: Float64[Array, "*#batch {self.count}"],
    ) -> Float64[Array, "*batch {self.count}"]:
        """Return the generalised forces (…, n) on it that have no potential, as of dampers and motors."""
        return jnp.zeros_like(rate)

    def further_rate(
        self, t: Time, attitude: Attitude, angular_velocity: Velocity, own: Float64[Array, "*#batch {self.state_size}"],
        rate: Float64[Array, "*#batch {self.count}"],
    ) -> Float64[Array, "*batch {self.further_count}"]:
        """Return the rate of the rest of its own state."""
        return jnp.zeros((*rate.shape[:-1], self.further_count))

    def further_power(
        self, t: Time, attitude: Attitude, angular_velocity: Velocity, own: Float64[Array, "*#batch {self.state_size}"],
        rate: Float64[Array, "*#batch {self.count}"],
    ) -> Float64[Array, "*batch"]:
        """Return the power (…) [W] of the forces on the rest of its own state."""
        return jnp.zeros(rate.shape[:-1])

    def energy(self, own: Float64[Array, "*batch {self.state_size}"]) -> Float64[Array, "*batch"]:
        return self.potential(self.coordinates_of(own))

    def start_further(
        self, q: Float64[Array, "*#batch {self.count}"], rate: Float64[Array, "*#batch rates"],
        angular_velocity: Float64[Array, "*#batch 3"],
    ) -> Float64[Array, "*batch {self.further_count}"]:
        """Return the rest of its own state at the start, of q, all rates that ``pack`` got for it, and Ω."""
        return jnp.zeros((*q.shape[:-1], self.further_count))


class LockedPart(AbstractMovingPart):
    """A moving part that is held at a place, as a panel before it is deployed; it has no state of its own.

    At rest it is equivalent to no part at all. A wheel is locked by leaving it out: it then turns with the body.

    Args:
        part: the held one.
        coordinates: q (n,) of it.

    Raises:
        InvalidInput: for anything but a moving part, one that has more than q and π, or coordinates that do not fit.

    >>> from polhode.spacecraft import HingedPart
    >>> folded = LockedPart(HingedPart((1.0, 0.0, 0.0), (0.0, 0.0, 1.0), (2.0, 0.0, 0.0), mass=3.0), np.pi / 2)
    >>> [round(float(x), 9) for x in folded.position(jnp.zeros(0))]
    [1.0, 1.0, 0.0]
    """

    held: AbstractMovingPart
    held_at: Float64[Array, "n"]

    @known_numbers_only
    def __init__(self, part: AbstractMovingPart, coordinates: Real[ArrayLike, "..."]) -> None:
        if not isinstance(part, AbstractMovingPart) or part.further_count:
            raise InvalidInput(f"`part` must be a moving part with coordinates alone; got {shown(part)}. Leave out a "
                               "wheel that is locked, and put a `Wheel` in place of a gyroscope.")
        held = check.array("coordinates", coordinates, (part.count,) if np.ndim(coordinates) or part.count != 1 else ())
        self.held, self.held_at = part, jnp.asarray(np.atleast_1d(held))

    @property
    def mass(self) -> Float64[Array, ""]:
        return self.held.mass

    @property
    def coordinates(self) -> tuple[StatePart, ...]:
        return ()

    @property
    def names_all_jumps(self) -> bool:
        return True

    def _held(self, q: Array) -> Array:
        return jnp.broadcast_to(self.held_at, (*q.shape[:-1], self.held.count))

    def position(self, q: Coordinates) -> Float64[Array, "*batch 3"]:
        return self.held.position(self._held(q))

    def tensor(self, q: Coordinates) -> Float64[Array, "*batch 3 3"] | None:
        return self.held.tensor(self._held(q))

    def at_rest(self) -> tuple[Float64[Array, "3"], Float64[Array, "3 3"] | None]:
        return self.held.at_rest()


def _try_mount(mount: AbstractMounted, t: Array, attitude: Array, velocity: Array, own: Array) -> dict[str, Any]:
    values = {"momentum": (mount.momentum(own), (3,)), "energy": (mount.energy(own), ())}
    if isinstance(mount, AbstractMount):
        return values | {
            "state_rate": (mount.state_rate(t, attitude, velocity, own), (mount.state_size,)),
            "power": (mount.power(t, attitude, velocity, own), ()),
            "drift": (mount.drift(velocity, velocity), (3,)),
        }
    assert isinstance(mount, AbstractMovingPart)
    q = rate = mount.coordinates_of(own)
    acting = t, attitude, velocity, own, rate
    values |= {
        "position": (mount.position(q), (3,)),
        "potential": (mount.potential(q), ()),
        "applied": (mount.applied(*acting), (mount.count,)),
        "further_rate": (mount.further_rate(*acting), (mount.further_count,)),
        "further_power": (mount.further_power(*acting), ()),
    }
    if (gauge := mount.gauge(q)) is not None:
        values["gauge"] = gauge, ()
    if (tensor := mount.tensor(q)) is not None:
        values["tensor"] = tensor, (3, 3)
    if (axes := mount.turning_axes(q)) is not None:
        values["turning_axes"] = jnp.stack(axes, axis=-2), (mount.count, 3)
    return values


def checked_mounts(mounts: Any, frame: BodyFrame) -> tuple[AbstractMounted, ...]:
    """Return a list of mounts and moving parts in a body.

    Raises:
        InvalidInput: for anything else, and for one whose methods fail or give wrong shapes.
    """
    kinds = (AbstractMount, AbstractMovingPart)
    return checked_attachments("mounts", mounts, kinds, frame, _try_mount)
