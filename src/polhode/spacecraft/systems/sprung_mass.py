"""Point masses on springs in a body: slosh particles, and booms by their first mode."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, ClassVar, NamedTuple

import equinox as eqx
import jax.numpy as jnp
import numpy as np

from polhode._base import check
from polhode._base.arrays import known_numbers_only
from polhode.motion._layout import StatePart
from polhode.spacecraft.systems.attachments import Argument, Attitude, Time, Velocity
from polhode.spacecraft.systems.moving_parts import AbstractMovingPart, Coordinates
from polhode.systems._checks import (
    checked_direction,
    checked_directions,
    checked_number,
    checked_numbers,
    checked_vector,
)
from polhode.types import Array, ArrayLike, Float64, Real

# of the first mode φ of a clamped beam: cos λ cosh λ = −1, (∫φ)²/∫φ² and ∫xφ/∫φ over its length
BEAM_ROOT, BEAM_MASS, BEAM_PLACE = 1.875104068711961, 0.613076090026017, 0.726477308761248


class SprungMassLimits(NamedTuple):
    """Which directions are refused."""

    max_cosine: float = 1e-9  # between directions that are given as perpendicular


LIMITS = SprungMassLimits()


class SprungMass(AbstractMovingPart):
    """A point mass on springs: a slosh particle, or the first mode of a boom.

    Its place is r = p + Σ_j q_j e_j, with e_j one to three perpendicular directions in the body, and on it act
    −k_j q_j − c_j q̇_j.

    Args:
        position: p (3,) at rest [m, body axes].
        directions: e_j (3,) or (n, 3), perpendicular to each other, normalised here.
        mass: m [kg], positive.
        stiffness: k [N/m], not negative; one for all directions, or (n,).
        damping: c [N s/m], not negative; one for all directions, or (n,).

    Raises:
        InvalidInput: for values out of range, directions that are not perpendicular, a body without mass.

    Source: Allard, Diaz-Ramos & Schaub, "Spacecraft Dynamics Integrating Hinged Solar Panels and Lumped-Mass Fuel Slosh
    Model", AIAA/AAS Astrodynamics Specialist Conference (2016); Dodge, *The New "Dynamic Behavior of Liquids in Moving
    Containers"* (2000), ch. 3.

    >>> import polhode as ph
    >>> from polhode.spacecraft import RigidBody
    >>> tank = SprungMass((0.0, 0.0, 0.4), (1.0, 0.0, 0.0), mass=5.0, stiffness=2.0, damping=0.1)
    >>> craft = RigidBody.from_body(ph.Body(100.0, (0, 0, 0), 20.0 * jnp.eye(3)), [tank])
    >>> craft.layout(craft.pack()).names
    ('momentum', 'displacement', 'displacement_momentum')
    """

    name: ClassVar[str] = "sprung-mass"
    arguments: ClassVar[dict[str, Argument]] = {
        "position": Argument("m", (3,)),
        "directions": Argument("", (3,), many=True),
        "mass": Argument("kg"),
        "stiffness": Argument("N/m", many=True),
        "damping": Argument("N*s/m", many=True),
    }
    start_arguments: ClassVar[dict[str, Argument]] = {
        "displacement": Argument("m", many=True),
        "speed": Argument("m/s", many=True),
    }

    place: Float64[Array, "3"]
    directions: Float64[Array, "n 3"]
    mass: Float64[Array, ""]
    stiffness: Float64[Array, "n"]
    damping: Float64[Array, "n"]
    is_lossless: bool = eqx.field(static=True)

    @known_numbers_only
    def __init__(
        self, position: Real[ArrayLike, "3"], directions: Real[ArrayLike, "..."], mass: float,
        stiffness: Real[ArrayLike, "..."], damping: Real[ArrayLike, "..."] = 0.0,
    ) -> None:
        self.place, self.mass = checked_vector("position", position), checked_number("mass", mass, 0.0, unit="kg")
        self.directions = _checked_axes(directions)
        count = len(self.directions)
        self.stiffness = jnp.broadcast_to(checked_numbers("stiffness", stiffness, count, least=0.0, unit="N/m"), count)
        self.damping = jnp.broadcast_to(checked_numbers("damping", damping, count, least=0.0, unit="N s/m"), count)
        self.is_lossless = not np.any(np.asarray(self.damping))

    def start_of(self, values: Mapping[str, Any]) -> tuple[Any, Any]:
        count = len(self.directions)
        given = {name: values[name] for name in self.start_arguments if values.get(name) is not None}
        each = {name: np.broadcast_to(checked_numbers(name, x, count), count) for name, x in given.items()}
        return each.get("speed"), each.get("displacement")

    @classmethod
    @known_numbers_only
    def from_beam(
        cls, root: Real[ArrayLike, "3"], direction: Real[ArrayLike, "3"], length: float, mass: float,
        bending_stiffness: float, damping_ratio: float = 0.0,
    ) -> SprungMass:
        """Return the first bending mode of a uniform cantilever, in both directions across it.

        The mode has the frequency λ² √(EI/(m l³)), λ = 1.8751, and shakes its root as .6131 m at .7265 l does, which is
        its effective mass and where this sits. The rest of the beam's mass stays with the body.

        Args:
            root: (3,) where it is clamped [m, body axes].
            direction: (3,) along it, of any length.
            length: l [m], positive.
            mass: m of the beam [kg], positive.
            bending_stiffness: E I [N m²], positive.
            damping_ratio: of the mode, not negative.

        Source: Blevins, *Formulas for Natural Frequency and Mode Shape* (1979), table 8-1; Wijker, *Mechanical
        Vibrations in Spacecraft Design* (2004), ch. 6, of effective masses.
        """
        along = np.asarray(checked_direction("direction", direction))
        extent = float(checked_number("length", length, 0.0, unit="m"))
        whole = float(checked_number("mass", mass, 0.0, unit="kg"))
        bending = float(checked_number("bending_stiffness", bending_stiffness, 0.0, unit="N m²"))
        ratio = float(checked_number("damping_ratio", damping_ratio, least=0.0))
        rate = BEAM_ROOT**2 * np.sqrt(bending / (whole * extent**3))
        effective = BEAM_MASS * whole
        first = np.cross(along, np.eye(3)[np.argmin(np.abs(along))])
        place = np.asarray(checked_vector("root", root)) + BEAM_PLACE * extent * along
        across = [first, np.cross(along, first)]
        return cls(place, across, effective, effective * rate**2, 2.0 * ratio * effective * rate)

    @property
    def coordinates(self) -> tuple[StatePart, ...]:
        return (StatePart("displacement", len(self.directions), "m", "displacement of a sprung mass"),)

    @property
    def names_all_jumps(self) -> bool:
        return True

    @property
    def conserves_energy(self) -> bool:
        return self.is_lossless

    def position(self, q: Coordinates) -> Float64[Array, "*batch 3"]:
        return self.place + jnp.sum(q[..., :, None] * self.directions, axis=-2)

    def potential(self, q: Coordinates) -> Float64[Array, "*batch"]:
        return 0.5 * jnp.sum(self.stiffness * q**2, axis=-1)

    def applied(
        self, t: Time, attitude: Attitude, angular_velocity: Velocity, own: Float64[Array, "*#batch {self.state_size}"],
        rate: Float64[Array, "*#batch {self.count}"],
    ) -> Float64[Array, "*batch {self.count}"]:
        return -self.damping * rate


def _checked_axes(directions: Real[ArrayLike, "..."]) -> Float64[Array, "n 3"]:
    rows = checked_directions("directions", [directions] if np.ndim(directions) == 1 else directions)
    if len(rows) > 3 or np.abs(rows @ rows.T - np.eye(len(rows))).max() > LIMITS.max_cosine:
        check.refuse("directions", "one to three that are perpendicular to each other", directions)
    return rows
