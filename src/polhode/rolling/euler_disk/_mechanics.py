"""The Newton–Euler equations of a disk that rolls on a plane, in the frame of its contact, and their consequences.

e1 is horizontal, e2 leads up the face from the contact, e3 is the disk's axis; s, c stand for sin θ, cos θ. With the
moments A, C about the centre, half the thickness b and M = [[A+mb², −mab], [−mab, C+ma²]]:

(A+ma²+mb²) θ̈ = (A+mb²) ω2² c/s + mab ω2² − (C+ma²) ω2ω3 − mab ω2ω3 c/s − mg(ac − bs),
M (ω2, ω3)˙ = θ̇ (Cω3 − (A+mb²) ω2 c/s − mab ω2, ma² ω2 + mab ω2 c/s) + (τ2, τ3).

Source: Routh, *Advanced Rigid Dynamics* (1905), §244; thick: Le Saux, Leine & Glocker, J. Nonlinear Sci. 15 (2005) 27.
"""

from __future__ import annotations

from typing import NamedTuple

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np

from polhode.errors import InvalidInput
from polhode.special._legendre import LegendreFunction
from polhode.types import Array, ArrayOrFloat, Float64

# elementwise; operands broadcast
Operand = Float64[ArrayOrFloat, "*#shape"]
Result = Float64[Array, "*shape"]


class DiskLimits(NamedTuple):
    """What states of a disk are refused, and where it counts as lying flat."""

    max_size: float = 1e30  # of mass, radius, gravity, and of their inverses: products of five stay within numbers
    # sin θ: the rim of a coin is then lifted by tens of nanometres, less than any table is rough
    flat_sine: float = 1e-6
    relative_slip: float = 1e-6  # of the speeds; a given velocity that misses the rolling one by more is a mistake
    # of g/a + ω2² + ω3²; given rates that leave more are not steady, rounding leaves less
    relative_tilt_acceleration: float = 1e-9


LIMITS = DiskLimits()


class RollingMechanics(eqx.Module):
    """A disk's constants and its equations of motion.

    Attributes:
        mass: m [kg].
        radius: a [m].
        half_thickness: b [m].
        diametral_moment: A [kg m²], about a diameter through the centre.
        axial_moment: C [kg m²].
        gravity: g [m/s²].
    """

    mass: Float64[Array, ""]
    radius: Float64[Array, ""]
    half_thickness: Float64[Array, ""]
    diametral_moment: Float64[Array, ""]
    axial_moment: Float64[Array, ""]
    gravity: Float64[Array, ""]

    @property
    def _constants(self) -> tuple[Array, ...]:
        return self.mass, self.radius, self.half_thickness, self.diametral_moment, self.axial_moment

    @jax.jit
    def tilt_acceleration(self, theta: Operand, w2: Operand, w3: Operand) -> Result:
        """Return θ̈ [rad/s²], on which neither θ̇ nor the couples act; it vanishes in steady motion."""
        m, a, b, A, C = self._constants
        s, c = jnp.sin(theta), jnp.cos(theta)
        inner = (A + m * b * b) * w2 * w2 * c / s + m * a * b * w2 * (w2 - w3 * c / s) - (C + m * a * a) * w2 * w3
        return (inner - m * self.gravity * (a * c - b * s)) / (A + m * a * a + m * b * b)

    def linear_terms(
        self, legendre: LegendreFunction, theta: Result, w2: Result, w3: Result
    ) -> tuple[tuple[Result, Result], tuple[Result, Result]]:
        """Return the two terms [rad/s] of each linear integral of the thin disk whose Legendre function is given."""
        (p, dp), (q, dq) = legendre.values(theta), legendre.values(jnp.pi - theta)
        mr = self.mass * self.radius**2
        # thin disk: dω3/dθ = ma² ω2/(C + ma²) and A (dω2/dθ + ω2 cot θ) = C ω3 make ω3″ + cot θ ω3′ = κ ω3, Legendre
        # with ν(ν+1) = −κ; c1, c2 follow from ω3 and this slope
        slope = mr * w2 / (self.axial_moment + mr)
        # p·(dq/dθ) − q·(dp/dθ) with dq/dθ = −q′(π − θ) is the Wronskian, known in closed form
        wronskian = -2.0 * legendre.sine / jnp.sin(theta)
        return (-dq * w3 / wronskian, -q * slope / wronskian), (p * slope / wronskian, -dp * w3 / wronskian)

    def transport(self, theta: Operand, w2: Operand, w3: Operand) -> tuple[Result, Result]:
        """Return d(ω2, ω3)/dθ without couples: linear in both, so that there are two linear integrals."""
        m, a, b, A, C = self._constants
        cot = jnp.cos(theta) / jnp.sin(theta)
        # the second and third equations divided by θ̇, a factor of their right-hand sides
        tau2 = C * w3 - (A + m * b * b) * w2 * cot - m * a * b * w2
        return self.accelerations(tau2, m * a * (a + b * cot) * w2)

    def accelerations(self, tau2: Operand, tau3: Operand) -> tuple[Result, Result]:
        """Return M⁻¹τ, the effect of couples along e2 and e3 on ω2 and ω3."""
        m, a, b, A, C = self._constants
        p, q, r = A + m * b * b, C + m * a * a, m * a * b
        det = A * C + m * a * a * A + m * b * b * C  # pq − r² without cancellation
        return (q * tau2 + r * tau3) / det, (r * tau2 + p * tau3) / det

    @jax.jit
    def nutation_squared(self, theta: Operand, w2: Operand, w3: Operand) -> Result:
        """Return the square of the nutation's frequency [rad²/s²] about a steady motion; negative where unstable."""
        # ω2 and ω3 follow θ by ``transport``: δθ̈ = (∂f/∂θ + ∂f/∂ω2 dω2/dθ + ∂f/∂ω3 dω3/dθ) δθ for θ̈ = f(θ, ω2, ω3)
        by_theta, by_w2, by_w3 = jax.grad(self.tilt_acceleration, argnums=(0, 1, 2))(theta, w2, w3)
        d2, d3 = self.transport(theta, w2, w3)
        return -(by_theta + by_w2 * d2 + by_w3 * d3)

    def energy(self, theta: Operand, w1: Operand, w2: Operand, w3: Operand) -> Result:
        """Return kinetic and potential energy [J], above that of the disk lying flat."""
        m, a, b, A, C = self._constants
        # rolling: v = ω × (a e2 + b e3) = (bω2 − aω3, −bω1, aω1)
        speed = (b * w2 - a * w3) ** 2 + (a * a + b * b) * w1 * w1
        return 0.5 * (A * (w1 * w1 + w2 * w2) + C * w3 * w3 + m * speed) + self.potential_energy(theta)

    def potential_energy(self, theta: Operand) -> Result:
        """Return V [J], zero for the disk lying flat."""
        # a sin θ + b cos θ − b, the cosine as 1 − 2 sin²(θ/2), which does not cancel for a disk nearly flat
        height = self.radius * jnp.sin(theta) - 2.0 * self.half_thickness * jnp.sin(0.5 * theta) ** 2
        return self.mass * self.gravity * height

    @jax.jit
    def normal_force(self, theta: Operand, w1: Operand, w2: Operand, w3: Operand) -> Result:
        """Return N = m [g + (ac − bs) θ̈ − (as + bc) θ̇²] [N], with which the plane pushes."""
        a, b = self.radius, self.half_thickness
        s, c = jnp.sin(theta), jnp.cos(theta)
        # the second derivative of the height a sin θ + b cos θ of the centre
        lift = (a * c - b * s) * self.tilt_acceleration(theta, w2, w3) - (a * s + b * c) * w1 * w1
        return self.mass * (self.gravity + lift)

    @jax.jit
    def precession_at_rest(self, theta: Operand) -> Result:
        """Return φ̇² [rad²/s²] of the steady motion whose centre is at rest: mga/(A sin θ) of a thin disk."""
        m, a, b, A, C = self._constants
        s, c = jnp.sin(theta), jnp.cos(theta)
        # v = 0 asks for ω1 = 0 and aω3 = bω2; θ̈ = 0 then leaves ω2² (A c/s − C b/a) = mg (ac − bs), with ω2 = φ̇ s
        return m * self.gravity * (a * c - b * s) / (A * s * c - C * s * s * b / a)

    @jax.jit
    def precession_without_spin(self, theta: Operand, precession: Operand, spin: Operand) -> Result:
        """Return |φ̇| [rad/s] without the contribution of the spin ω3 in steady motion: ∝ θ^(−1/2) for small tilts.

        Not finite where the spin's own torque holds more than the weight.
        """
        m, a, b, _, C = self._constants
        s, c = jnp.sin(theta), jnp.cos(theta)
        # θ̈ = 0 is ((A + mb²) c + mab s) s φ̇² = mg (ac − bs) + ω3 ((C + ma²) s + mabc) φ̇
        held = 1.0 + spin * ((C + m * a * a) * s + m * a * b * c) * precession / (m * self.gravity * (a * c - b * s))
        return jnp.abs(precession) / jnp.sqrt(held)

    @jax.jit
    def steady_spin(self, theta: Operand, precession: Operand) -> Result:
        """Return ω3 [rad/s] of steady motion at φ̇; not finite where nothing precesses."""
        m, a, b, A, C = self._constants
        s, c = jnp.sin(theta), jnp.cos(theta)
        # θ̈ = 0 with ω2 = φ̇ s is linear in ω3
        forced = ((A + m * b * b) * c + m * a * b * s) * s * precession**2 - m * self.gravity * (a * c - b * s)
        return forced / (((C + m * a * a) * s + m * a * b * c) * precession)


    def steady_rates(
        self, theta: Float64[ArrayOrFloat, "*#shape"], precession: Float64[ArrayOrFloat, "*#shape"] | None = None,
        spin: Float64[ArrayOrFloat, "*#shape"] | None = None,
    ) -> tuple[Float64[Array, "*shape"], Float64[Array, "*shape"]]:
        """Return φ̇ and ω3 [rad/s] of steady motions, as far as not given; not finite where there is none.

        Without a precession the centre is at rest.
        """
        with np.errstate(invalid="ignore", divide="ignore"):
            if precession is None:
                precession = np.sqrt(np.asarray(self.precession_at_rest(theta)))
                at_rest = precession * np.sin(theta) * float(self.half_thickness) / float(self.radius)
                spin = at_rest if spin is None else spin
            elif spin is None:
                spin = np.asarray(self.steady_spin(theta, precession))
        return np.asarray(precession), np.asarray(spin)


def check_size(name: str, value: float, unit: str, largest: float) -> None:
    """Refuse constants of a disk, and their powers, whose products overflow.

    Raises:
        InvalidInput: for a value above the largest, or below its inverse.
    """
    if not 1.0 / largest <= value <= largest:
        raise InvalidInput(f"`{name}` must be within {1.0 / largest:.0e} and {largest:.0e} {unit}; got {value:g}. "
                           "Check its unit.")
