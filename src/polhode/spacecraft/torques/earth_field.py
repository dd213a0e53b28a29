"""The Earth's magnetic field along an orbit, as that of a tilted dipole which turns with the Earth."""

from __future__ import annotations

import equinox as eqx
import jax.numpy as jnp

from polhode._base import check
from polhode._base.arrays import known_numbers_only
from polhode.systems._checks import checked_number, checked_vector
from polhode.systems.kepler_orbit import KeplerOrbit
from polhode.types import Array, ArrayLike, Float64, Real

IGRF_2020 = (-1450.9e-9, 4652.5e-9, -29404.8e-9)
"""g11, h11, g10 of the International Geomagnetic Reference Field at 2020.0 [T].

Source: Alken et al., Earth Planets Space 73 (2021) 49, IGRF-13, table 2.
"""
REFERENCE_RADIUS = 6371.2e3  # m, at which the coefficients of the IGRF hold
EARTH_ROTATION = 7.292115e-5  # rad/s, against the stars; IERS Conventions (2010), table 1.1


class EarthDipoleField(eqx.Module):
    """B = (a/r)³ [3 (g·r̂) r̂ − g] at the place of a body in its orbit, with g = (g11, h11, g10) along the Earth's axes.

    This is −∇V of the first degree of the IGRF: V = a (a/r)² g·r̂. Space has its z axis along the Earth's axis of
    rotation, northward, so that the orbit's ``inclination`` and ``node`` are those against the equator. The Earth turns
    about z; its meridian of Greenwich is at the angle ``greenwich`` from space x at t = 0. The dipole is about nine
    tenths of the field at the ground; higher degrees are left out.

    Args:
        orbit: of the body, with its semi-major axis.
        greenwich: angle of Greenwich from space x at t = 0 [rad].
        coefficients: g (3,) [T], g11, h11, g10; IGRF-13 at 2020.0 by default.

    Raises:
        InvalidInput: for an orbit of unknown size.

    Source: Wertz (ed.), *Spacecraft Attitude Determination and Control* (1978), appendix H.
    """

    orbit: KeplerOrbit
    greenwich: Float64[Array, ""]
    coefficients: Float64[Array, "3"]

    @known_numbers_only
    def __init__(
        self, orbit: KeplerOrbit, greenwich: float = 0.0, coefficients: Real[ArrayLike, "3"] = IGRF_2020
    ) -> None:
        check.instance("orbit", orbit, KeplerOrbit, "a polhode.systems.KeplerOrbit")
        orbit.check_size("the field of the Earth's dipole")
        self.orbit, self.greenwich = orbit, checked_number("greenwich", greenwich, unit="rad")
        self.coefficients = checked_vector("coefficients", coefficients)

    def field(self, t: Real[ArrayLike, "*shape"]) -> Float64[Array, "*shape 3"]:
        """Return B (…, 3) at times (…) [T, space axes]."""
        place, dipole = self.orbit.position(t), self._dipole(t)[0]
        square = jnp.sum(place**2, axis=-1, keepdims=True)
        along = jnp.sum(dipole * place, axis=-1, keepdims=True)
        return REFERENCE_RADIUS**3 / (square * jnp.sqrt(square)) * (3.0 * along / square * place - dipole)

    def field_rate(self, t: Real[ArrayLike, "*shape"]) -> Float64[Array, "*shape 3"]:
        """Return dB/dt (…, 3) at the moving body [T/s, space axes], by its motion and the Earth's rotation together."""
        place, velocity = self.orbit.position(t), self.orbit.velocity(t)
        dipole, turning = self._dipole(t)
        dot = lambda a, b: jnp.sum(a * b, axis=-1, keepdims=True)  # noqa: E731
        square, along, outward = dot(place, place), dot(dipole, place), dot(place, velocity)
        # d/dt [3 (g·r) r/r⁵ − g/r³], term by term
        change = 3.0 * ((dot(turning, place) + dot(dipole, velocity)) * place + along * velocity) / square
        change = change - 15.0 * along * outward * place / square**2 - turning + 3.0 * outward * dipole / square
        return REFERENCE_RADIUS**3 / (square * jnp.sqrt(square)) * change

    def _dipole(self, t: Real[ArrayLike, "*shape"]) -> tuple[Array, Array]:
        """Return g (…, 3) [T] and its rate (…, 3) [T/s] in space."""
        angle = self.greenwich + EARTH_ROTATION * jnp.asarray(t)
        x, y, z = self.coefficients
        cosine, sine = jnp.cos(angle), jnp.sin(angle)
        east, north = x * cosine - y * sine, x * sine + y * cosine
        still = jnp.zeros_like(east)
        dipole = jnp.stack([east, north, z + still], axis=-1)
        return dipole, EARTH_ROTATION * jnp.stack([-north, east, still], axis=-1)
