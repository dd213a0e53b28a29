"""Pressure on the outside of a body: of sunlight, and of thin air."""

from __future__ import annotations

import abc
from typing import Any, ClassVar, NamedTuple

import equinox as eqx
import jax.numpy as jnp
import numpy as np

from polhode._base import check
from polhode._base.arrays import known_numbers_only, require_doubles
from polhode.errors import InvalidInput, shown
from polhode.spacecraft.systems.attachments import Argument, Attitude, Own, Time, Velocity
from polhode.spacecraft.torques.base import NEEDED, AbstractEnvironmentTorque, in_body
from polhode.spacecraft.torques.earth_field import EARTH_ROTATION
from polhode.systems._checks import checked_direction, checked_directions, checked_number, checked_vector
from polhode.systems.kepler_orbit import KeplerOrbit
from polhode.types import Array, ArrayLike, Float64, Real

EARTH, EARTH_RADIUS = 3.986004418e14, 6378.137e3
"""GM [m³/s²] and radius of the equator [m], WGS 84."""
SUNLIGHT = 4.5391e-6
"""Pressure of sunlight at one astronomical unit [N/m²]: 1360.8 W/m² over the speed of light.

Source: Kopp & Lean, Geophys. Res. Lett. 38 (2011) L01706.
"""
PLATES: dict[str, Argument] = {
    "areas": Argument("m^2", many=True),
    "normals": Argument("", (3,), many=True),
    "positions": Argument("m", (3,), many=True),
    "box": Argument("m", (3,)),
    "center": Argument("m", (3,)),
}


class OrbitLimits(NamedTuple):
    """Which orbits are about the Earth."""

    relative_parameter: float = 0.01  # difference of GM from the Earth's


LIMITS = OrbitLimits()


class Plates(eqx.Module):
    """Flat plates that a stream from outside meets on one side, the side of their normal.

    Attributes:
        areas: (n,) [m²].
        normals: (n, 3) outward unit vectors [body axes].
        positions: (n, 3) of their centres [m, body axes].
    """

    areas: Float64[Array, "n"]
    normals: Float64[Array, "n 3"]
    positions: Float64[Array, "n 3"]


class AbstractSurfaceTorque(AbstractEnvironmentTorque):
    """Forces on plates, of which none shades another; a box is six plates.

    Each plate's force acts at its centre and depends on the cosine c between its normal and the direction from which
    the stream comes; on the far side there is none.
    """

    plates: eqx.AbstractVar[Plates]

    @abc.abstractmethod
    def forces(
        self, t: Time, attitude: Attitude, angular_velocity: Velocity
    ) -> Float64[Array, "*batch n 3"]:
        """Return the force on each plate (…, n, 3) [N, body axes]."""

    def force(
        self, t: Time, attitude: Attitude, angular_velocity: Velocity, actuator: Own | None = None
    ) -> Float64[Array, "*batch 3"]:
        return jnp.sum(self.forces(t, attitude, angular_velocity), axis=-2)

    def torque(
        self, t: Time, attitude: Attitude, angular_velocity: Velocity, actuator: Own | None = None
    ) -> Float64[Array, "*batch 3"]:
        each = jnp.cross(self.plates.positions, self.forces(t, attitude, angular_velocity))
        return jnp.sum(each, axis=-2)


class SolarPressure(AbstractSurfaceTorque):
    """F = −P A c [(1 − s) u + 2 (s c + d/3) n] on each plate, c = n·u > 0, u the direction of the Sun.

    s of the light is reflected as by a mirror, d scattered evenly, and the rest absorbed. The direction of the Sun
    stays in space. On an orbit it is dark in the cylinder that the attracting body shades; between full light and full
    shade, where a part of the Sun is visible, there is no transition: 8 s twice an orbit near the Earth, 2 min on a
    geostationary one.

    Args:
        sun: direction from the body to the Sun (3,) [space axes].
        areas: (n,) of plates [m²], or one; with ``normals`` and ``positions``, or a ``box`` instead of the three.
        normals: (n, 3) outward [body axes].
        positions: (n, 3) of their centres [m, body axes].
        specular: s, from 0 to 1.
        diffuse: d, from 0 to 1 − s.
        box: (3,) edges of a box along the body's axes [m], whose six faces are the plates.
        center: (3,) of the box [m, body axes].
        pressure: P [N/m²], at one astronomical unit by default.
        orbit: of the body, with its semi-major axis; None where nothing shades it.
        shading_radius: of the attracting body [m], the Earth's on an orbit about it; 0 for no shade.

    Raises:
        InvalidInput: for plates that are not complete, reflectivities that together exceed one, an orbit of unknown
            size or through the body that it goes round, or a radius without an orbit.

    Source: Markley & Crassidis, *Fundamentals of Spacecraft Attitude Determination and Control* (2014), eq. 3.167;
    Montenbruck & Gill, *Satellite Orbits* (2000), §3.4.2.
    """

    name: ClassVar[str] = "solar-pressure"
    arguments: ClassVar[dict[str, Argument]] = {
        "sun": Argument("", (3,)), **PLATES, "specular": Argument(), "diffuse": Argument(),
        "pressure": Argument("N/m^2"), "shading_radius": Argument("m"),
    }  # fmt: skip

    plates: Plates
    sun: Float64[Array, "3"]
    specular: Float64[Array, ""]
    diffuse: Float64[Array, ""]
    pressure: Float64[Array, ""]
    orbit: KeplerOrbit | None
    shading_radius: Float64[Array, ""]

    @known_numbers_only
    def __init__(
        self, sun: Real[ArrayLike, "3"], areas: Real[ArrayLike, "..."] | None = None,
        normals: Real[ArrayLike, "n 3"] | None = None, positions: Real[ArrayLike, "n 3"] | None = None,
        specular: float = 0.0, diffuse: float = 0.0, box: Real[ArrayLike, "3"] | None = None,
        center: Real[ArrayLike, "3"] | None = None, pressure: float = SUNLIGHT, orbit: KeplerOrbit | None = None,
        shading_radius: float | None = None,
    ) -> None:
        self.sun, self.plates = checked_direction("sun", sun), make_plates(areas, normals, positions, box, center)
        self.specular = checked_number("specular", specular, least=0.0)
        self.diffuse = checked_number("diffuse", diffuse, least=0.0)
        self.pressure = checked_number("pressure", pressure, least=0.0, unit="N/m²")
        if float(self.specular + self.diffuse) > 1.0:
            raise InvalidInput(
                f"`specular` and `diffuse` are parts of the light and together at most 1; got {shown(specular)} and "
                f"{shown(diffuse)}."
            )
        radius = _earth_radius(orbit) if shading_radius is None else shading_radius
        self.shading_radius = checked_number("shading_radius", radius, least=0.0, unit="m")
        self.orbit = orbit if self.shading_radius > 0.0 else None
        if orbit is None and shading_radius is not None:
            raise InvalidInput(
                "`shading_radius` goes with an `orbit`, on which the body is shaded. Give one, or leave it out."
            )
        if self.orbit is not None:
            self.orbit.check_size("the shade on it")
            assert self.orbit.semi_major_axis is not None
            lowest = float(self.orbit.semi_major_axis * (1.0 - self.orbit.eccentricity))
            if lowest <= float(self.shading_radius):
                raise InvalidInput(
                    f"the orbit comes within {lowest:.6g} m of the centre of a body whose `shading_radius` is "
                    f"{float(self.shading_radius):.6g} m. Check both, as for a diameter in place of a radius."
                )

    @property
    def names_all_jumps(self) -> bool:
        return self.orbit is None  # steps have to end where the shade does, and those places are searched for

    def remark(self, times: Float64[Array, "time"]) -> str:
        if self.orbit is None:
            return ""
        dark = 1.0 - float(jnp.mean(self.light(times)))
        return f"is in the shade of a radius of {float(self.shading_radius) / 1e3:.6g} km at {dark:.1%} of the samples"

    def light(self, t: Time) -> Float64[Array, "*batch"]:
        """Return 1 where it is lit and 0 in the shade (…)."""
        if self.orbit is None:
            return jnp.ones(jnp.shape(t))
        place = self.orbit.position(jnp.asarray(t, float))
        along = jnp.sum(place * self.sun, axis=-1)
        aside = jnp.sum(place * place, axis=-1) - along * along
        return jnp.where((along < 0.0) & (aside < self.shading_radius**2), 0.0, 1.0)

    def forces(
        self, t: Time, attitude: Attitude, angular_velocity: Velocity
    ) -> Float64[Array, "*batch n 3"]:
        assert attitude is not None, NEEDED
        sun, normals = in_body(attitude, self.sun)[..., None, :], self.plates.normals
        cosine = jnp.maximum(jnp.sum(normals * sun, axis=-1, keepdims=True), 0.0)
        share = (1.0 - self.specular) * sun + 2.0 * (self.specular * cosine + self.diffuse / 3.0) * normals
        lit = self.pressure * jnp.asarray(self.light(t))[..., None, None]
        return -lit * self.plates.areas[:, None] * cosine * share


def _earth_radius(orbit: KeplerOrbit | None) -> float:
    """Return the radius of the Earth [m], or refuse an orbit about something else."""
    if orbit is not None and orbit.semi_major_axis is not None:
        about = float(orbit.mean_motion**2 * orbit.semi_major_axis**3)
        if abs(about / EARTH - 1.0) > LIMITS.relative_parameter:
            raise InvalidInput(
                f"the orbit is about a body of GM = {about:.6g} m³/s², not the Earth, and has its own shade: give "
                "`shading_radius`, the radius of that body, or a zero one for no shade."
            )
    return EARTH_RADIUS


class AerodynamicDrag(AbstractSurfaceTorque):
    """F = −½ ρ C A c |v|² v̂ on each plate, c = n·v̂ > 0, v the velocity of the body through the air.

    The air turns with the Earth and has the given density everywhere on the orbit. The body's own turning is slow
    against v and left out.

    Args:
        orbit: of the body, with its semi-major axis.
        density: ρ [kg/m³].
        areas, normals, positions, box, center: as of ``SolarPressure``.
        coefficient: C of drag, 2.2 by default.

    Raises:
        InvalidInput: for plates that are not complete, or an orbit of unknown size.

    Source: Markley & Crassidis (2014), eqs. 3.160–3.162.
    """

    name: ClassVar[str] = "aerodynamic-drag"
    arguments: ClassVar[dict[str, Argument]] = {"density": Argument("kg/m^3"), **PLATES, "coefficient": Argument()}

    plates: Plates
    orbit: KeplerOrbit
    density: Float64[Array, ""]
    coefficient: Float64[Array, ""]

    @known_numbers_only
    def __init__(
        self, orbit: KeplerOrbit, density: float, areas: Real[ArrayLike, "..."] | None = None,
        normals: Real[ArrayLike, "n 3"] | None = None, positions: Real[ArrayLike, "n 3"] | None = None,
        box: Real[ArrayLike, "3"] | None = None, center: Real[ArrayLike, "3"] | None = None, coefficient: float = 2.2,
    ) -> None:
        orbit.check_size("aerodynamic drag")
        self.orbit, self.plates = orbit, make_plates(areas, normals, positions, box, center)
        self.density = checked_number("density", density, least=0.0, unit="kg/m³")
        self.coefficient = checked_number("coefficient", coefficient, least=0.0)

    def forces(
        self, t: Time, attitude: Attitude, angular_velocity: Velocity
    ) -> Float64[Array, "*batch n 3"]:
        assert attitude is not None, NEEDED
        place, velocity = self.orbit.position(t), self.orbit.velocity(t)
        through = velocity - jnp.cross(jnp.array([0.0, 0.0, EARTH_ROTATION]), place)
        stream = in_body(attitude, through)[..., None, :]
        # ½ ρ C A (n·v̂) |v|² v̂ = ½ ρ C A (n·v) v
        facing = jnp.maximum(jnp.sum(self.plates.normals * stream, axis=-1, keepdims=True), 0.0)
        return -0.5 * self.density * self.coefficient * self.plates.areas[:, None] * facing * stream


def make_plates(areas: Any, normals: Any, positions: Any, box: Any, center: Any) -> Plates:
    """Return plates, given one by one or as the faces of a box.

    Args:
        areas, normals, positions, box, center: as of ``SolarPressure``; None where left out.

    Raises:
        InvalidInput: unless there are areas, normals and positions of equal number, or a box alone.
    """
    require_doubles(areas=areas, normals=normals, positions=positions, box=box, center=center)
    single = (areas, normals, positions)
    if (box is None) == all(x is None for x in single) or (box is None and any(x is None for x in single)):
        raise InvalidInput(
            "plates are given by `areas`, `normals` and `positions` together, or as the faces of a `box`; got "
            + (", ".join(name for name, x in zip(("areas", "normals", "positions", "box"), (*single, box), strict=True)
                         if x is not None) or "none of these") + "."
        )
    if box is not None:
        return _faces(check.array("box", box, (3,), "m", above=0), center)
    if center is not None:
        raise InvalidInput("`center` goes with a `box`; plates have `positions`.")
    outward = checked_directions("normals", normals)
    sizes = np.atleast_1d(np.asarray(areas, dtype=float))
    places = np.atleast_2d(np.asarray(positions, dtype=float))
    if sizes.shape != (len(outward),) or places.shape != outward.shape:
        raise InvalidInput(
            f"plates need as many `areas` and `positions` as `normals`; got {len(sizes)}, {len(places)} and "
            f"{len(outward)}."
        )
    if not (np.isfinite(places).all() and np.isfinite(sizes).all() and (sizes > 0).all()):
        raise InvalidInput(f"`areas` must be positive and all `positions` finite; got {shown(sizes.tolist())} m².")
    return Plates(jnp.asarray(sizes), outward, jnp.asarray(places))


def _faces(box: np.ndarray, center: Any) -> Plates:
    middle = np.zeros(3) if center is None else np.asarray(checked_vector("center", center))
    normals = np.concatenate([np.eye(3), -np.eye(3)])
    areas = np.prod(box) / box
    return Plates(jnp.asarray(np.tile(areas, 2)), jnp.asarray(normals), jnp.asarray(middle + 0.5 * box * normals))
