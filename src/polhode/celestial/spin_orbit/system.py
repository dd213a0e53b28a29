"""The spin of a moon or planet on an eccentric orbit."""

from __future__ import annotations

import math
from typing import ClassVar

import jax.numpy as jnp

from polhode._base import check
from polhode._base.arrays import known_numbers_only
from polhode.bodies.body import Body
from polhode.motion._layout import Quantity, StateLayout, StatePart
from polhode.systems._checks import as_finite_state, checked_number
from polhode.systems.base import AbstractSystem, Balance
from polhode.systems.kepler_orbit import KeplerOrbit
from polhode.types import Array, ArrayLike, Float64, Real

LAYOUT = StateLayout((
    StatePart("angle", 1, "rad", "angle of the long axis from the direction of the periapsis"),
    StatePart("rate", 1, "rad s-1", "rate of that angle"),
))  # fmt: skip


class SpinOrbit(AbstractSystem):
    """θ̈ + ½ n² ω0² (a/r)³ sin 2(θ − f) = 0, ω0² = 3(B − A)/C; state (θ, θ̇) (…, 2).

    The body turns about its axis of largest moment C, which stays along the orbit's normal; θ is the angle of its axis
    of least moment A from the direction of the periapsis [rad], θ̇ its rate in space [rad/s]. Nothing is conserved: the
    energy per C, ½ θ̇² − ¼ n² ω0² (a/r)³ cos 2(θ − f), changes as r and f do.

    Args:
        asphericity: ω0, not negative; at most √3, as no body has B − A > C.
        eccentricity: 0 ≤ e < 1.
        mean_motion: n [rad/s].
        mean_anomaly: of the orbit at t = 0 [rad]; zero is the periapsis.

    Raises:
        InvalidInput: outside these ranges.

    Source: Goldreich & Peale, Astron. J. 71 (1966) 425; Wisdom, Peale & Mignard, Icarus 58 (1984) 137.

    >>> hyperion = SpinOrbit(asphericity=0.89, eccentricity=0.1)
    >>> [round(float(x), 6) for x in hyperion.vector_field(0.0, jnp.array([math.pi / 4, 1.0]))]
    [1.0, -0.543278]
    """

    kind: ClassVar[str] = "spin-orbit"
    title: ClassVar[str] = "Spin on an orbit"
    asphericity: Float64[Array, ""]
    orbit: KeplerOrbit

    @known_numbers_only
    def __init__(
        self, asphericity: float, eccentricity: float, mean_motion: float = 1.0, mean_anomaly: float = 0.0
    ) -> None:
        self.asphericity = checked_number("asphericity", asphericity, least=0.0)
        if not float(self.asphericity) <= math.sqrt(3.0) * (1.0 + 1e-12):
            check.refuse("asphericity", "at most √3, as B − A ≤ C", asphericity, "It is √(3(B − A)/C).")
        self.orbit = KeplerOrbit(mean_motion, eccentricity, mean_anomaly)

    @classmethod
    @known_numbers_only
    def from_body(cls, body: Body, orbit: KeplerOrbit) -> SpinOrbit:
        """Return the system of a body on an orbit, its axis of largest moment along the orbit's normal."""
        least, middle, largest = (float(moment) for moment in body.principal_moments)
        # ω0² = 3(B − A)/C, the frequency of librations on a circular orbit over n
        asphericity = math.sqrt(3.0 * (middle - least) / largest)
        return cls(asphericity, float(orbit.eccentricity), float(orbit.mean_motion), float(orbit.mean_anomaly_at_start))

    @property
    def names_all_jumps(self) -> bool:
        return type(self).vector_field is SpinOrbit.vector_field  # which is smooth

    @property
    def eccentricity(self) -> Float64[Array, ""]:
        """Eccentricity e of the orbit."""
        return self.orbit.eccentricity

    @property
    def mean_motion(self) -> Float64[Array, ""]:
        """Mean motion n of the orbit [rad/s]."""
        return self.orbit.mean_motion

    def vector_field(
        self, t: Real[ArrayLike, "*#batch"], state: Float64[Array, "*#batch 2"]
    ) -> Float64[Array, "*batch 2"]:
        angle, rate = LAYOUT.part(state, "angle"), LAYOUT.part(state, "rate")
        return jnp.stack([rate, -0.5 * self._strength(t) * self._phase(t, angle)[0]], axis=-1)

    def _phase(self, t: Array, angle: Array) -> tuple[Array, Array]:
        """Return sine and cosine of 2(θ − f)."""
        centre = self.orbit.direction(t)
        x, y = centre[..., 0], centre[..., 1]
        # sin and cos of 2θ − 2f with sin 2f = 2xy, cos 2f = x² − y²: no angle f is formed
        sine, cosine, twice_sine, twice_cosine = jnp.sin(2.0 * angle), jnp.cos(2.0 * angle), 2.0 * x * y, x * x - y * y
        return sine * twice_cosine - cosine * twice_sine, cosine * twice_cosine + sine * twice_sine

    def _strength(self, t: Array) -> Array:
        return (self.mean_motion * self.asphericity) ** 2 / self.orbit.distance_ratio(t) ** 3

    def invariants(self, state: Float64[Array, "*batch 2"]) -> dict[str, Float64[Array, "*batch"]]:
        """Return none; the energy is among the balances."""
        return {}

    def balances(self, t: Real[ArrayLike, "*#batch"], state: Float64[Array, "*#batch 2"]) -> dict[str, Balance]:
        """Return the energy per moment C [rad²/s²], which changes by ∂H/∂t along the orbit.

        With ḟ = n √(1−e²) (a/r)² and ṙ/a = n e sin f/√(1−e²).
        """
        angle, rate = LAYOUT.part(state, "angle"), LAYOUT.part(state, "rate")
        n, e, ratio = self.mean_motion, self.eccentricity, self.orbit.distance_ratio(t)
        sine, cosine = self._phase(t, angle)
        root, depth = jnp.sqrt((1.0 - e) * (1.0 + e)), 0.25 * self._strength(t)
        # ∂H/∂t of −depth cos 2(θ − f) with depth ∝ r⁻³: depth (3ṙ/r cos 2(θ−f) − 2ḟ sin 2(θ−f))
        outward, around = n * e * self.orbit.direction(t)[..., 1] / root, n * root / ratio**2
        energy = 0.5 * rate**2 - depth * cosine
        growth = depth * (3.0 * outward / ratio * cosine - 2.0 * around * sine)
        return {"energy_per_moment": Balance(energy, growth)}

    @known_numbers_only
    def check_state(self, state: Real[ArrayLike, "*shape"]) -> Float64[Array, "*shape"]:
        """Return states as an array.

        Raises:
            InvalidInput: for a wrong last axis or values that are not finite.
        """
        return as_finite_state(state, float, length=2)

    @property
    def quantities(self) -> dict[str, Quantity]:
        return {"energy_per_moment": Quantity("rad2 s-2", "energy per moment about the spin's axis")}

    def layout(self, state: Float64[Array, "*batch 2"]) -> StateLayout:
        return LAYOUT

    def scales(self, state: Float64[Array, "*batch 2"]) -> Float64[Array, "2"]:
        """Return one radian, and one radian in the time 1/n."""
        return jnp.stack([jnp.ones(()), self.mean_motion])
