"""Kepler's orbit: where the body that goes round is, and how its orbit lies in space."""

from __future__ import annotations

import math

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np

from polhode import rotation
from polhode._base import check
from polhode._base.arrays import compiled_for_few_calls, known_numbers_only
from polhode.errors import InvalidInput
from polhode.systems._checks import checked_number
from polhode.types import Array, ArrayLike, ArrayOrFloat, Float64, Real

TURN = 2.0 * math.pi
DOWNWARD = np.array([0.5, -0.5, -0.5, 0.5])  # quaternion of the axes θ̂, −n̂ and −r̂, in components along r̂, θ̂ and n̂
# E − sin E = Σ ± E^(2k+1)/(2k+1)!, k = 1, 2, …, of which nine terms give it up to one radian to rounding
SERIES = tuple((-1.0) ** (k + 1) / math.factorial(2 * k + 1) for k in range(1, 10))


class KeplerOrbit(eqx.Module):
    """Two bodies under gravity: E − e sin E = M, r/a = 1 − e cos E, M = n t + M0.

    In space the orbit lies in the x-y plane, runs towards +y at the periapsis on +x, and has its normal along +z,
    unless it is rotated by Rz(node) Rx(inclination) Rz(periapsis).

    Args:
        mean_motion: n [rad/s], positive.
        eccentricity: 0 ≤ e < 1.
        mean_anomaly: M0 at t = 0 [rad].
        inclination: of the orbit against the x-y plane [rad].
        node: from x to where the orbit goes up through that plane [rad].
        periapsis: from the node to the periapsis, along the orbit [rad].
        semi_major_axis: a [m], which positions, fields and drag need; None where it is not known.

    Raises:
        InvalidInput: outside these ranges.

    Source: Murray & Dermott, *Solar System Dynamics* (1999), sections 2.3–2.4.

    >>> halley = KeplerOrbit(mean_motion=2 * math.pi / 75.3, eccentricity=0.967)
    >>> round(float(halley.distance_ratio(0.0)), 6), round(float(halley.distance_ratio(0.5 * 75.3)), 6)
    (0.033, 1.967)
    """

    mean_motion: Float64[Array, ""]
    eccentricity: Float64[Array, ""]
    mean_anomaly_at_start: Float64[Array, ""]
    plane: Float64[Array, "4"] | None
    semi_major_axis: Float64[Array, ""] | None

    @known_numbers_only
    def __init__(
        self, mean_motion: float, eccentricity: float = 0.0, mean_anomaly: float = 0.0, inclination: float = 0.0,
        node: float = 0.0, periapsis: float = 0.0, semi_major_axis: float | None = None,
    ) -> None:
        self.mean_motion = checked_number("mean_motion", mean_motion, above=0.0, unit="rad/s")
        self.eccentricity = checked_number("eccentricity", eccentricity, least=0.0)
        if not float(self.eccentricity) < 1.0:
            check.refuse("eccentricity", "below 1", eccentricity, "Only ellipses come round again.")
        self.mean_anomaly_at_start = checked_number("mean_anomaly", mean_anomaly, unit="rad")
        angles = {"inclination": inclination, "node": node, "periapsis": periapsis}
        turns = [float(checked_number(name, angle, unit="rad")) for name, angle in angles.items()]
        inclined, ascending, along = turns
        lies = rotation.from_euler_angles(np.array([ascending, inclined, along]), "ZXZ")
        self.plane = jnp.asarray(lies) if any(turns) else None
        size = semi_major_axis
        self.semi_major_axis = None if size is None else checked_number("semi_major_axis", size, above=0.0, unit="m")

    @classmethod
    @known_numbers_only
    def from_semi_major_axis(
        cls, semi_major_axis: float, gravitational_parameter: float, eccentricity: float = 0.0,
        mean_anomaly: float = 0.0, inclination: float = 0.0, node: float = 0.0, periapsis: float = 0.0,
    ) -> KeplerOrbit:
        """Return the orbit with n² a³ = GM.

        Args:
            semi_major_axis: a [m].
            gravitational_parameter: GM of both bodies together [m³/s²].
            eccentricity: 0 ≤ e < 1.
            mean_anomaly: M0 at t = 0 [rad].
            inclination, node, periapsis: how the orbit lies in space [rad].
        """
        a = checked_number("semi_major_axis", semi_major_axis, above=0.0, unit="m")
        gm = checked_number("gravitational_parameter", gravitational_parameter, above=0.0, unit="m³/s²")
        rate = float(jnp.sqrt(gm / a) / a)
        return cls(rate, eccentricity, mean_anomaly, inclination, node, periapsis, float(a))

    def check_size(self, what: str) -> None:
        """Refuse what needs the size of the orbit, where that is not known.

        Raises:
            InvalidInput: naming what needs it.
        """
        if self.semi_major_axis is None:
            raise InvalidInput(
                f"{what} needs the size of the orbit; give `semi_major_axis`, as by `KeplerOrbit.from_semi_major_axis`."
            )

    @property
    def normal(self) -> Float64[Array, "3"]:
        """(3,) unit vector of the orbit's angular momentum, in space."""
        return self._in_space(jnp.array([0.0, 0.0, 1.0]))

    @property
    def rate_at_periapsis(self) -> Float64[Array, ""]:
        """ḟ [rad/s] where it is fastest, n √(1 + e)/(1 − e)^(3/2), Kepler's second law."""
        return _rate_at_periapsis(self.mean_motion, self.eccentricity)

    @property
    def period(self) -> Float64[Array, ""]:
        """2π/n [s]."""
        return TURN / self.mean_motion

    def mean_anomaly(self, t: Real[ArrayLike, "*shape"]) -> Float64[Array, "*shape"]:
        """Return M at times (…) [rad], growing without bound."""
        return self.mean_motion * t + self.mean_anomaly_at_start

    def eccentric_anomaly(self, t: Real[ArrayLike, "*shape"]) -> Float64[Array, "*shape"]:
        """Return E at times (…) [rad], growing without bound."""
        within, turns = _reduce_anomaly(self.mean_anomaly(t))
        return solve_kepler(within, self.eccentricity) + turns

    def true_anomaly(self, t: Real[ArrayLike, "*shape"]) -> Float64[Array, "*shape"]:
        """Return f at times (…) [rad], growing without bound."""
        within, turns = _reduce_anomaly(self.mean_anomaly(t))
        return true_from_eccentric(solve_kepler(within, self.eccentricity), self.eccentricity) + turns

    def distance_ratio(self, t: Real[ArrayLike, "*shape"]) -> Float64[Array, "*shape"]:
        """Return r/a at times (…)."""
        within, _ = _reduce_anomaly(self.mean_anomaly(t))
        return ratio_from_eccentric(solve_kepler(within, self.eccentricity), self.eccentricity)

    def direction(self, t: Real[ArrayLike, "*shape"]) -> Float64[Array, "*shape 3"]:
        """Return the unit vector (…, 3) from the attracting centre to the body, in space."""
        within, _ = _reduce_anomaly(self.mean_anomaly(t))
        e, half = self.eccentricity, 0.5 * solve_kepler(within, self.eccentricity)
        # (cos E − e)/(1 − e cos E) and √(1−e²) sin E/(1 − e cos E), with cos E = 1 − 2 sin²(E/2) put in so that nothing
        # cancels at the periapsis (Murray & Dermott, §2.4)
        sine, cosine = jnp.sin(half), jnp.cos(half)
        ratio = (1.0 - e) + 2.0 * e * sine * sine
        x = ((1.0 - e) - 2.0 * sine * sine) / ratio
        y = 2.0 * jnp.sqrt((1.0 - e) * (1.0 + e)) * sine * cosine / ratio
        return self._in_space(jnp.stack([x, y, jnp.zeros_like(x)], axis=-1))

    def position(self, t: Real[ArrayLike, "*shape"]) -> Float64[Array, "*shape 3"]:
        """Return where the body is (…, 3) from the attracting centre [m, space axes].

        Raises:
            InvalidInput: where the semi-major axis is not known.
        """
        self.check_size("`position`")
        assert self.semi_major_axis is not None
        return (self.semi_major_axis * self.distance_ratio(t))[..., None] * self.direction(t)

    def velocity(self, t: Real[ArrayLike, "*shape"]) -> Float64[Array, "*shape 3"]:
        """Return how fast it moves (…, 3) [m/s, space axes]: n a (−sin E, √(1−e²) cos E)/(1 − e cos E) in its plane.

        Raises:
            InvalidInput: where the semi-major axis is not known.
        """
        self.check_size("`velocity`")
        assert self.semi_major_axis is not None
        within, _ = _reduce_anomaly(self.mean_anomaly(t))
        e, E = self.eccentricity, solve_kepler(within, self.eccentricity)
        speed = self.mean_motion * self.semi_major_axis / ratio_from_eccentric(E, e)
        x, y = -speed * jnp.sin(E), speed * jnp.sqrt((1.0 - e) * (1.0 + e)) * jnp.cos(E)
        return self._in_space(jnp.stack([x, y, jnp.zeros_like(x)], axis=-1))

    def turning_rate(self, t: Real[ArrayLike, "*shape"]) -> Float64[Array, "*shape"]:
        """Return ḟ = n √(1−e²)/(r/a)² (…) [rad/s], Kepler's second law."""
        e = self.eccentricity
        return self.mean_motion * jnp.sqrt((1.0 - e) * (1.0 + e)) / self.distance_ratio(t) ** 2

    def frame(self, t: Real[ArrayLike, "*shape"]) -> Float64[Array, "*shape 4"]:
        """Return the attitude (…, 4) of the axes that look down: z to the centre, y against the normal, x ahead.

        Its sign does not jump: after one turn of the orbit it is the other one.

        Source: Wertz (ed.), *Spacecraft Attitude Determination and Control* (1978), §2.3, "roll, pitch and yaw".
        """
        within, turns = _reduce_anomaly(self.mean_anomaly(t))
        E, e = solve_kepler(within, self.eccentricity), self.eccentricity
        half, root = 0.5 * (E + turns), jnp.sqrt(ratio_from_eccentric(E, e))
        # cos f/2 and sin f/2, from tan f/2 = √((1+e)/(1−e)) tan E/2
        cosine, sine = jnp.sqrt(1.0 - e) * jnp.cos(half) / root, jnp.sqrt(1.0 + e) * jnp.sin(half) / root
        still = jnp.zeros_like(cosine)
        in_plane = rotation.multiply(jnp.stack([cosine, still, still, sine], axis=-1), DOWNWARD)
        return in_plane if self.plane is None else rotation.multiply(self.plane, in_plane)

    def _in_space(self, vector: Array) -> Array:
        """Return vectors (…, 3) of the orbit's own axes along those of space."""
        return vector if self.plane is None else rotation.rotate(self.plane, vector)


@compiled_for_few_calls
def _rate_at_periapsis(mean_motion: Array, e: Array) -> Array:
    return mean_motion * jnp.sqrt(1.0 + e) / ((1.0 - e) * jnp.sqrt(1.0 - e))


def ratio_from_eccentric(
    eccentric: Float64[ArrayOrFloat, "*#shape"], eccentricity: Float64[ArrayOrFloat, "*#shape"]
) -> Float64[Array, "*shape"]:
    """Return r/a = 1 − e cos E, without cancellation at the periapsis of a needle."""
    sine = jnp.sin(0.5 * eccentric)
    return (1.0 - eccentricity) + 2.0 * eccentricity * sine * sine


def true_from_eccentric(
    eccentric: Float64[ArrayOrFloat, "*#shape"], eccentricity: Float64[ArrayOrFloat, "*#shape"]
) -> Float64[Array, "*shape"]:
    """Return f of E in [−π, π]: tan f/2 = √((1+e)/(1−e)) tan E/2."""
    half = 0.5 * eccentric
    y = jnp.sqrt(1.0 + eccentricity) * jnp.sin(half)
    return 2.0 * jnp.arctan2(y, jnp.sqrt(1.0 - eccentricity) * jnp.cos(half))


@jax.custom_jvp
@jax.jit  # so that it is traced once for all that asks for it
def solve_kepler(
    mean_anomaly: Float64[ArrayOrFloat, "*#shape"], eccentricity: Float64[ArrayOrFloat, "*#shape"]
) -> Float64[Array, "*shape"]:
    """Return E of M in [−π, π] by Kepler's equation.

    On [0, π] the equation is convex, so that Newton's steps from above its root go down to it and never past it, for
    any e < 1. The start is the least of three bounds from above: sin E ≤ 1, sin E ≤ E and E − sin E ≥ E³/π². The
    equation is written (1−e) E + e (E − sin E) = M, in which nothing cancels where e is near one and M near zero.
    """
    newton_steps = 6  # from the start below five come within three roundings for any e < 1
    M, e = jnp.abs(mean_anomaly), eccentricity
    cubic = jnp.cbrt(math.pi**2 * M / jnp.where(e > 0, e, 1.0))
    E = jnp.minimum(jnp.minimum(M + e, M / (1.0 - e)), jnp.where(e > 0, cubic, jnp.inf))
    E = jnp.minimum(E, math.pi)

    def improve(k: Array, E: Array) -> Array:
        sine = jnp.sin(0.5 * E)
        # 1 − e cos E, the derivative of the equation by E
        slope = (1.0 - e) + 2.0 * e * sine * sine
        return E - (((1.0 - e) * E - M) + e * _less_sine(E)) / slope

    E = jax.lax.fori_loop(0, newton_steps, improve, E)
    return jnp.copysign(jnp.clip(E, 0.0, math.pi), mean_anomaly)


@solve_kepler.defjvp
def _solve_kepler_jvp(primals: tuple[Array, Array], tangents: tuple[Array, Array]) -> tuple[Array, Array]:
    # (1 − e cos E) dE = dM + sin E de, so that no step is differentiated
    E = solve_kepler(*primals)
    return E, (tangents[0] + jnp.sin(E) * tangents[1]) / ratio_from_eccentric(E, primals[1])


def _less_sine(angle: Array) -> Array:
    """Return E − sin E to its last digits."""
    square = jnp.where(angle < 1.0, angle, 0.0) ** 2
    series = jnp.zeros_like(square)
    for term in SERIES[::-1]:
        series = term + square * series
    return jnp.where(angle < 1.0, angle * square * series, angle - jnp.sin(angle))


def _reduce_anomaly(mean_anomaly: Array) -> tuple[Array, Array]:
    """Return M within [−π, π] and the whole turns left out [rad]."""
    turns = _whole_turns(jax.lax.stop_gradient(mean_anomaly))
    return mean_anomaly - turns, turns


@jax.jit  # as one step, which series know by its name
def _whole_turns(mean_anomaly: Float64[ArrayOrFloat, "*shape"]) -> Float64[Array, "*shape"]:
    """Return the whole turns [rad] nearest to M."""
    return TURN * jnp.round(mean_anomaly / TURN)
