"""Rest and steady spin of a rigid satellite on a circular orbit: all equilibria, their regions, rates and verdicts.

In the frame that turns with the orbit, gravity and the turn leave a Lie–Poisson system for L, the orbit's normal γ and
the radius r along the body's axes, whose Hamiltonian is Jacobi's integral. A body at rest in that frame has its
principal axes along radius, velocity and normal: 24 attitudes, of which four look alike to gravity. A symmetric body
may also spin about its axis, which then rests in the frame in one of three ways: along the normal (cylindrical,
Thomson), across the radius (hyperbolic) or across the velocity (conical; names by the surface that the axis sweeps).

Source: DeBra & Delp, J. Astronaut. Sci. 8 (1961) 14; Likins & Roberson, J. Astronaut. Sci. 13 (1966) 87; Thomson, J.
Astronaut. Sci. 9 (1962) 31; Likins, J. Astronaut. Sci. 12 (1965) 18; Hughes, *Spacecraft Attitude Dynamics*, ch. 9.
"""

from __future__ import annotations

import itertools
import math
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import jax.numpy as jnp
import numpy as np

from polhode._base import check
from polhode._base.arrays import known_numbers_only
from polhode.algebra.semidirect import Semidirect
from polhode.algebra.so3 import SO3
from polhode.analysis._printing import print_answer, write_numbers
from polhode.analysis.energy_casimir import Stability
from polhode.analysis.stability import stability
from polhode.errors import InvalidInput
from polhode.rotation import hat
from polhode.special.elliptic import complete_k
from polhode.systems._checks import checked_number
from polhode.systems.free_rigid_body import checked_moments
from polhode.systems.lie_poisson import LiePoisson
from polhode.types import Array, ArrayLike, Float64, Real

LAGRANGE, DEBRA_DELP, UNSTABLE, DEGENERATE = "Lagrange", "DeBra–Delp", "unstable", "degenerate"
STATIC, GYROSCOPIC = "static", "gyroscopic"
CYLINDRICAL, HYPERBOLIC, CONICAL = "cylindrical", "hyperbolic", "conical"


class GravityGradientLimits(NamedTuple):
    """What decides that a quantity has a sign."""

    relative_rounding: float = 1e-12  # of the sum of its terms: a quantity that small has no certain sign


LIMITS = GravityGradientLimits()


@dataclass(frozen=True)
class OrbitalEquilibrium:
    """A rest of a rigid body in the frame of its circular orbit.

    Attributes:
        moments: (3,) principal moments of the body [kg m²].
        mean_motion: n of the orbit [rad/s].
        roll, pitch, yaw: numbers 1, 2, 3 of the principal axes along velocity, orbit normal and radius.
        region: "Lagrange" where Jacobi's integral has its least value, which proves stability and which losses keep;
            "DeBra–Delp" where all motions near it oscillate, held by the turn of the frame, though the integral is
            indefinite, and losses drive it away; else "unstable", or "degenerate" on the borders.
        pitch_rate: n √(3 (I_roll − I_yaw)/I_pitch), the frequency of small librations in pitch [rad/s]; None where
            they grow.
        roll_yaw_rates: the two frequencies of coupled small librations in roll and yaw [rad/s]; None where one grows.
        growth: largest rate at which neighbours leave [1/s].
    """

    moments: Float64[np.ndarray, "3"]
    mean_motion: float
    roll: int
    pitch: int
    yaw: int
    region: str
    pitch_rate: float | None
    roll_yaw_rates: tuple[float, float] | None
    growth: float

    @property
    def attitudes(self) -> Float64[np.ndarray, "4 3 3"]:
        """(4, 3, 3) rotation matrices, principal axes → radius, velocity and normal, that look alike to gravity."""
        columns = np.zeros((3, 3))
        for place, axis in enumerate((self.yaw, self.roll, self.pitch)):
            columns[place, axis - 1] = 1.0
        signs = np.array([s for s in itertools.product((1.0, -1.0), repeat=3)])
        rotations = signs[:, :, None] * columns
        return rotations[np.linalg.det(rotations) > 0.0]

    @cached_property
    def stability(self) -> Stability:
        """The verdict of ``polhode.stability`` with its certificate, by Jacobi's integral and the Casimirs."""
        point = _rest(self.moments, self.mean_motion, self.attitudes[0])
        return stability(orbiting_body(self.moments, self.mean_motion), point)

    def libration_period(self, amplitude: float) -> float:
        """Return the period [s] of a libration in pitch, 4 K(sin θ₀)/ω, exact at any amplitude θ₀ [rad].

        Raises:
            InvalidInput: for an equilibrium that has no libration in pitch, or an amplitude that is not below π/2.
        """
        if self.pitch_rate is None:
            raise InvalidInput("this attitude has no libration in pitch: the body leaves it when rotated by a little.")
        rule = "from 0 to below π/2"
        amplitude = check.number("amplitude", amplitude, "rad", least=0, below=0.5 * math.pi, rule=rule)
        return 4.0 * float(complete_k(math.cos(amplitude) ** 2)) / self.pitch_rate

    def __str__(self) -> str:
        return print_answer(
            f"a rest in the orbit's frame, {self.region}",
            axes_in_roll_pitch_yaw=f"{self.roll}, {self.pitch}, {self.yaw}",
            pitch=write_numbers(self.pitch_rate, "rad/s"), roll_and_yaw=write_numbers(self.roll_yaw_rates, "rad/s"),
            fastest_growth=write_numbers(self.growth, "1/s") if self.growth else None,
        )


@dataclass(frozen=True)
class SpinningEquilibrium:
    """A symmetric body on a circular orbit whose axis rests in the orbit's frame while it spins about it.

    Attributes:
        transverse, axial: moments A, C [kg m²].
        mean_motion: n of the orbit [rad/s].
        spin: the axial component of the angular velocity against the stars [rad/s].
        case: "cylindrical", "hyperbolic" or "conical".
        axis: (3,) of symmetry, along radius, velocity and normal.
        region: "static" where the energy at this spin has its least value, which proves stability; "gyroscopic" where
            it has not, yet all motions near it oscillate, and losses drive it away; else "unstable", or "degenerate".
        rates: the two frequencies of small motions of the axis [rad/s]; None where one grows.
        growth: largest rate at which neighbours leave [1/s].
    """

    transverse: float
    axial: float
    mean_motion: float
    spin: float
    case: str
    axis: Float64[np.ndarray, "3"]
    region: str
    rates: tuple[float, float] | None
    growth: float

    @cached_property
    def stability(self) -> Stability:
        """The verdict of ``polhode.stability`` with its certificate, up to the spin's own turn."""
        moments = np.array([self.transverse, self.transverse, self.axial])
        across = np.cross(self.axis, np.eye(3)[int(np.argmin(np.abs(self.axis)))])
        across /= np.linalg.norm(across)
        R = np.stack([across, np.cross(self.axis, across), self.axis], axis=1)
        point = _rest(moments, self.mean_motion, R)
        point[2] = self.axial * self.spin
        return stability(orbiting_body(moments, self.mean_motion), point, [lambda x: x[2]])

    def __str__(self) -> str:
        return print_answer(
            f"a {self.case} rest of a spinning body's axis, {self.region}", axis=write_numbers(self.axis),
            spin=write_numbers(self.spin, "rad/s"), rates=write_numbers(self.rates, "rad/s"),
            fastest_growth=write_numbers(self.growth, "1/s") if self.growth else None,
        )


@known_numbers_only
def orbiting_body(moments: Real[ArrayLike, "3"], mean_motion: float) -> LiePoisson:
    """Return the rigid body on a circular orbit, in the orbit's frame, with Jacobi's integral as its energy.

    H = ½ L·I⁻¹L − n L·γ + (3/2) n² r·Ir of points (L, γ, r) (9,): angular momentum against the stars [kg m²/s], the
    orbit's normal and the direction away from the attracting centre, along principal axes.

    Args:
        moments: (3,) principal moments [kg m²], in any order.
        mean_motion: n [rad/s].

    Raises:
        InvalidInput: for moments or a mean motion that are not positive.
    """
    I = checked_moments(moments)  # noqa: E741
    n = checked_number("mean_motion", mean_motion, above=0.0, unit="rad/s")
    turns = np.asarray(hat(np.eye(3)))
    generators = np.zeros((3, 6, 6))
    generators[:, :3, :3], generators[:, 3:, 3:] = turns, turns
    casimirs = (
        lambda x: jnp.dot(x[3:6], x[3:6]),
        lambda x: jnp.dot(x[6:], x[6:]),
        lambda x: jnp.dot(x[3:6], x[6:]),
    )

    def energy(x: Array) -> Array:
        L, normal, radius = x[:3], x[3:6], x[6:]
        return 0.5 * jnp.sum(L * L / I) - n * jnp.dot(L, normal) + 1.5 * n**2 * jnp.sum(I * radius * radius)

    return LiePoisson(Semidirect(SO3(), generators, casimirs), energy)


@known_numbers_only
def orbital_equilibria(moments: Real[ArrayLike, "3"], mean_motion: float) -> tuple[OrbitalEquilibrium, ...]:
    """Return the rests of a rigid body in the frame of its circular orbit: six, each of four attitudes.

    With k₁ = (I_pitch − I_yaw)/I_roll and k₃ = (I_pitch − I_roll)/I_yaw, librations in pitch need I_roll > I_yaw; those
    in roll and yaw are roots of (s/n)⁴ + (1 + 3k₁ + k₁k₃)(s/n)² + 4k₁k₃ = 0. Bodies with equal moments have more rests,
    in between these.

    Args:
        moments: (3,) principal moments [kg m²], in any order, which numbers the axes.
        mean_motion: n [rad/s].

    Raises:
        InvalidInput: for moments or a mean motion that are not positive.

    >>> body = orbital_equilibria((85.0, 2500.0, 2530.0), 0.001)
    >>> [(one.roll, one.pitch, one.yaw, one.region) for one in body if one.region != "unstable"]
    [(2, 3, 1, 'Lagrange')]
    """
    I, n = np.asarray(checked_moments(moments)), float(checked_number("mean_motion", mean_motion, above=0.0))  # noqa: E741
    equilibria = []
    for roll, pitch, yaw in itertools.permutations((1, 2, 3)):
        Ir, Ip, Iy = (float(I[axis - 1]) for axis in (roll, pitch, yaw))
        k1, k3, kp = (Ip - Iy) / Ir, (Ip - Ir) / Iy, 3.0 * (Ir - Iy) / Ip
        squares = _roots(1.0 + 3.0 * k1 + k1 * k3, 4.0 * k1 * k3)
        held = kp > 0.0 and squares is not None
        growth = max(_growth(1.0 + 3.0 * k1 + k1 * k3, 4.0 * k1 * k3), math.sqrt(max(-kp, 0.0)))
        if abs(Ir - Iy) <= LIMITS.relative_rounding * Ip or abs(k1 * k3) <= LIMITS.relative_rounding:
            region = UNSTABLE if growth > math.sqrt(LIMITS.relative_rounding) else DEGENERATE
        else:
            region = (LAGRANGE if k3 > 0.0 else DEBRA_DELP) if held else UNSTABLE
        rates = None if squares is None else (n * math.sqrt(squares[0]), n * math.sqrt(squares[1]))
        equilibria.append(OrbitalEquilibrium(I, n, roll, pitch, yaw, region, n * math.sqrt(kp) if kp > 0.0 else None,
                                        rates, n * growth))
    return tuple(equilibria)


@known_numbers_only
def spinning_equilibria(
    transverse: float, axial: float, mean_motion: float, spin: float
) -> tuple[SpinningEquilibrium, ...]:
    """Return how the axis of a symmetric body that spins on a circular orbit can rest in the orbit's frame.

    At the constant spin s the axis χ moves in V = −C s n χ·γ − ½ A n² (1 − (χ·γ)²) + (3/2) n² (C − A)(χ·r)², with a
    gyroscopic force of C s − 2 A n χ·γ. Along the normal it always rests, both ways; where |C s| < A n also with
    χ·γ = C s/(A n) across the radius, and where |C s| < |4A − 3C| n with χ·γ = C s/((4A − 3C) n) across the velocity.

    Args:
        transverse: A, the moment across the axis [kg m²].
        axial: C, the moment about it [kg m²].
        mean_motion: n of the orbit [rad/s].
        spin: axial component of the angular velocity against the stars [rad/s]; n for a body at rest in the frame.

    Raises:
        InvalidInput: for moments of no body, a mean motion that is not positive, or a spin that is not finite.

    >>> fast = spinning_equilibria(2.0, 1.0, 0.001, 0.02)
    >>> [(one.case, one.axis.tolist(), one.region) for one in fast]
    [('cylindrical', [0.0, 0.0, 1.0], 'static'), ('cylindrical', [0.0, 0.0, -1.0], 'gyroscopic')]
    """
    A, _, C = (float(x) for x in np.asarray(checked_moments((transverse, transverse, axial))))
    n, s = float(checked_number("mean_motion", mean_motion, above=0.0)), float(checked_number("spin", spin))
    axes = [(CYLINDRICAL, np.array([0.0, 0.0, 1.0])), (CYLINDRICAL, np.array([0.0, 0.0, -1.0]))]
    p = C * s / n
    if abs(p) < A:
        up = p / A
        axes += [(HYPERBOLIC, np.array([0.0, side * math.sqrt(1.0 - up * up), up])) for side in (1.0, -1.0)]
    if C != A and abs(p) < abs(4.0 * A - 3.0 * C):
        up = p / (4.0 * A - 3.0 * C)
        axes += [(CONICAL, np.array([side * math.sqrt(1.0 - up * up), 0.0, up])) for side in (1.0, -1.0)]
    return tuple(_judge_spin(A, C, n, s, case, axis) for case, axis in axes)


@dataclass(frozen=True)
class NearestRest:
    """The rest nearest to an attitude.

    Attributes:
        equilibrium: what it is.
        turn: (3, 3) the principal axes by columns in the orbit's frame, one along each axis.
        angle: to it [rad].
    """

    equilibrium: OrbitalEquilibrium
    turn: Float64[np.ndarray, "3 3"]
    angle: float


def nearest_rest(axes: Real[ArrayLike, "3 3"], moments: Real[ArrayLike, "3"], mean_motion: float) -> NearestRest:
    """Return the rest nearest to a body on a circular orbit.

    Args:
        axes: (3, 3) principal axes by columns in the orbit's frame, which looks ahead, against the normal, and down.
        moments: (3,) about them [kg m²].
        mean_motion: n [rad/s].

    >>> near = nearest_rest(np.eye(3)[[1, 0, 2]] * [1.0, 1.0, -1.0], (1.0, 2.0, 2.5), 0.001)
    >>> near.equilibrium.roll, near.equilibrium.pitch, near.equilibrium.yaw, near.equilibrium.region
    (2, 1, 3, 'unstable')
    """
    matrix, rests = np.asarray(axes, dtype=float), []
    for equilibrium in orbital_equilibria(moments, mean_motion):
        order = [equilibrium.roll - 1, equilibrium.pitch - 1, equilibrium.yaw - 1]
        chosen = matrix[range(3), order]
        turn = np.zeros((3, 3))
        turn[range(3), order] = np.where(chosen < 0, -1.0, 1.0)
        if np.linalg.det(turn) < 0:  # the sign that costs least makes it a rotation
            weakest = int(np.argmin(np.abs(chosen)))
            turn[weakest, order[weakest]] *= -1.0
        rests.append((float(np.sum(turn * matrix)), turn, equilibrium))
    trace, turn, equilibrium = max(rests, key=lambda rest: rest[0])
    return NearestRest(equilibrium, turn, math.acos(min(1.0, max(-1.0, 0.5 * (trace - 1.0)))))


@known_numbers_only
def escape_energy(moments: Real[ArrayLike, "3"], mean_motion: float) -> float:
    """Return the Jacobi integral [J] below which a body on a circular orbit cannot leave the rest that it is near.

    It is ½ w·Iw + ½ n² (3 R̂·IR̂ − ẑ·Iẑ), whose second part has its least values, at the four attitudes with the largest
    moment across the orbit and the least one down, ½ n² (3 I1 − I3). Its next critical values are those with two axes
    exchanged; below the lower of them, the attitudes within reach form four separate regions, one about each rest.

    Args:
        moments: (3,) principal moments [kg m²].
        mean_motion: n [rad/s].

    Source: Hughes, *Spacecraft Attitude Dynamics* (1986), §9.3; Likins & Roberson, J. Astronaut. Sci. 13 (1966) 87.
    """
    first, second, third = np.sort(np.asarray(moments, dtype=float)).tolist()
    lowest = 3.0 * first - third
    return 0.5 * float(mean_motion) ** 2 * (lowest + min(third - second, 3.0 * (second - first)))


def _judge_spin(
    A: float, C: float, n: float, s: float, case: str, axis: Float64[np.ndarray, "3"]
) -> SpinningEquilibrium:
    p, up = C * s / n, axis[2]
    # V/n² with its gradient 2λχ at rest, and its second variation ∇²V − 2λ on the sphere's tangent plane
    slope = np.array([3.0 * (C - A) * axis[0], 0.0, A * up - p])
    curve = np.diag([3.0 * (C - A), 0.0, A]) - float(slope @ axis) * np.eye(3)
    across = np.linalg.svd(axis[None, :])[2][1:]
    inner, gyro = across @ curve @ across.T, p - 2.0 * A * up
    trace, det, size = float(np.trace(inner)), float(np.linalg.det(inner)), A + abs(p) + 3.0 * abs(C - A)
    middle, last = (gyro**2 + A * trace) / A**2, det / A**2
    squares, growth = _roots(middle, last), _growth(middle, last)
    if abs(det) <= LIMITS.relative_rounding * size**2:
        region = UNSTABLE if growth > math.sqrt(LIMITS.relative_rounding) else DEGENERATE
    elif det > 0.0 and trace > 0.0:
        region = STATIC
    else:
        region = UNSTABLE if squares is None else GYROSCOPIC
    rates = None if squares is None else (n * math.sqrt(squares[0]), n * math.sqrt(squares[1]))
    return SpinningEquilibrium(A, C, n, s, case, axis, region, rates, n * growth)


def _rest(moments: Array, mean_motion: float, attitude: Array) -> Array:
    """Return the point (L, γ, r) of a body that rests in the frame, by its matrix principal axes → frame."""
    radius, _, normal = attitude
    return np.concatenate([moments * mean_motion * normal, normal, radius])


def _roots(middle: float, last: float) -> tuple[float, float] | None:
    """Return the squares of frequencies, −x of x² + middle x + last = 0, ascending; None if no frequency has one."""
    root = middle**2 - 4.0 * last
    if last < 0.0 or middle < 0.0 or root < 0.0:
        return None
    large = 0.5 * (middle + math.sqrt(root))
    return (last / large if large else 0.0), large


def _growth(middle: float, last: float) -> float:
    """Return the largest real part of the roots s of s⁴ + middle s² + last = 0."""
    root = np.sqrt(complex(middle**2 - 4.0 * last))
    return float(max(abs(np.sqrt(0.5 * (-middle + sign * root)).real) for sign in (1.0, -1.0)))
