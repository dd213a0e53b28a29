"""An ideal fluid on a sphere, by Zeitlin's matrices."""

from __future__ import annotations

import math
from typing import Any, ClassVar, NamedTuple

import equinox as eqx
import jax.numpy as jnp
import numpy as np

from polhode._base import check
from polhode._base.arrays import compiled_for_few_calls, known_numbers_only
from polhode.algebra._functions import Function
from polhode.fields.sphere._harmonics import (
    checked_coefficients,
    checked_energies,
    inverse_squares,
    on_map,
    random_coefficients,
)
from polhode.fields.sphere._laplacian import inverse_laplacian
from polhode.fields.sphere.algebra import QuantizedSphere
from polhode.motion._layout import Quantity
from polhode.systems._checks import checked_number
from polhode.systems.base import AbstractLiePoissonSystem
from polhode.types import Array, ArrayLike, Complex128, Float64, Real

Matrices = Complex128[Array, "*batch n n"]


class FluidLimits(NamedTuple):
    """What decides which method computes a run.

    Attributes:
        max_series_size: N up to which runs go by Taylor series, where they cost about twice as much as
            IsospectralMidpoint of order 2.
    """

    max_series_size: int = 128


LIMITS = FluidLimits()


class RunCost(NamedTuple):
    """The approximate cost of a run.

    Attributes:
        seconds: on one core.
        bytes: of memory.
    """

    seconds: float
    bytes: float


class SphereFluid(AbstractLiePoissonSystem):
    """q̇ = {q, ψ} on the unit sphere, q = ω + 2Ω x₃, ω = Δψ, v = x × ∇ψ, by matrices: Ẇ = [P, W]/ħ, ΔP = W − F.

    W is the absolute vorticity q, P the stream function, F = 2ΩX₃ the sphere's rotation;
    H = −½⟨W − F, P⟩ is the energy of the motion relative to it, and dH = −P. Every power of W keeps its trace, as
    every ∫ f(q) is kept by the fluid: N − 1 Casimirs, the spectrum. The angular momentum L_a = ∫ x_a ω is kept, of a
    rotating sphere its third component, while the others turn. States are W (…, N, N).

    Resolution is that of harmonics l < N, errors of smooth flows fall as 1/N². ``IsospectralMidpoint`` keeps spectrum
    and angular momentum to rounding.

    Args:
        n: N, at least 3.
        rotation: Ω of the sphere [rad/s].

    Raises:
        InvalidInput: for an N that is too small or a rotation that is not finite.

    >>> fluid = SphereFluid(8, 0.5)
    >>> state = fluid.from_harmonics({(2, 1): 0.3, (3, 0): 1.0})
    >>> bool(jnp.abs(fluid.to_harmonics(state)[2, 1] - 0.3) < 1e-14)
    True

    Source: Zeitlin, Phys. Rev. Lett. 93 (2004) 264501; Modin & Viviani, J. Fluid Mech. 884 (2020) A22.
    """

    kind: ClassVar[str] = "sphere-fluid"
    title: ClassVar[str] = "Ideal fluid on a sphere"
    algebra: QuantizedSphere
    rotation: Float64[Array, ""]
    size: int = eqx.field(static=True)

    @known_numbers_only
    def __init__(self, n: int, rotation: float = 0.0) -> None:
        self.size = check.whole("n", n, 3)
        self.algebra = QuantizedSphere(self.size)
        self.rotation = checked_number("rotation", rotation, unit="rad/s")

    @property
    def series_of_arrays(self) -> bool:
        """Up to N = 128, where they cost about twice as much as IsospectralMidpoint of order 2."""
        return self.size <= LIMITS.max_series_size

    @property
    def planetary(self) -> Complex128[Array, "n n"]:
        """F = 2ΩX₃, the vorticity of the rotating sphere."""
        return 2.0 * self.rotation * jnp.asarray(self.algebra.coordinates[2])

    def cost(self, steps: int = 1, samples: int = 1, iterations: float = 7.0) -> RunCost:
        """Return estimates of a run's time and memory before it starts.

        Of ``solve`` with ``IsospectralMidpoint`` of order 2; order 8 costs seventeen times as much. ``simulate``
        also computes the invariants of all samples, which takes several times the memory of each.

        Args:
            steps: how many, at least 1.
            samples: how many states are saved.
            iterations: of a step: 7 where it turns the fastest rotation by 1/4 rad, 10 for 1/2, 19 for 1. A flow whose
                energy gathers at large scales gets faster.

        Raises:
            InvalidInput: for numbers that are not whole or too small.

        >>> cost = SphereFluid(256).cost(steps=10_000, samples=100)
        >>> round(cost.seconds / 60.0, 1), round(cost.bytes / 2**20)         # minutes, MiB
        (6.0, 217)
        """
        for name, value in (("steps", steps), ("samples", samples)):
            check.whole(name, value, 1)
        iterations = check.number("iterations", iterations, above=0)
        # s per step, per N² and per N³ in 7 iterations, from 5.5 ms measured at N = 128 and 35 ms at N = 256
        step, square, cube = 1e-4, 1.4e-7, 1.6e-9
        each = step + (square * self.size**2 + cube * self.size**3) * iterations / 7.0
        held, per_sample = 17, 2  # matrices, by XLA's analysis of its programs
        return RunCost(steps * each, 16.0 * self.size**2 * (held + per_sample * samples))

    @compiled_for_few_calls
    def stream_function(self, point: Matrices) -> Matrices:
        """Return P = Δ⁻¹(W − F) (…, N, N)."""
        return inverse_laplacian(jnp.asarray(point) - self.planetary)

    @property
    def quantities(self) -> dict[str, Quantity]:
        return super().quantities | {"energy": Quantity("rad2 s-2", "energy ½∫v² on the unit sphere, per density")}

    def energy(self, point: Matrices) -> Float64[Array, "*batch"]:
        relative = jnp.asarray(point) - self.planetary
        # ½ ∫|∇ψ|² = −½ ∫ψ Δψ
        return -0.5 * self.algebra.pairing(relative, inverse_laplacian(relative))

    def velocity(self, point: Matrices) -> Matrices:
        return -self.stream_function(point)

    @property
    def extra_invariants(self) -> dict[str, Function]:
        """∫ x₃ ω and the square of the other two components, which turn where the sphere does."""
        axes = jnp.asarray(self.algebra.coordinates)

        def momentum(point: Array) -> Array:
            return self.algebra.pairing(jnp.asarray(point)[..., None, :, :] - self.planetary, axes)

        return {"L3": lambda point: momentum(point)[..., 2],
                "L1² + L2²": lambda point: jnp.sum(momentum(point)[..., :2] ** 2, axis=-1)}  # fmt: skip

    def invariant_sizes(self, state: Matrices) -> dict[str, Float64[Array, "*batch"]]:
        """Return (∫ |x₁ω| + |x₂ω|)² for the square of the momenta, which may begin at zero."""
        relative = jnp.abs(jnp.asarray(state) - self.planetary)
        terms = self.algebra.scale * jnp.sum(relative[..., None, :, :] * np.abs(self.algebra.coordinates[:2]), (-2, -1))
        return {"L1² + L2²": jnp.sum(terms**2, axis=-1)}

    # ------------------------------------------------------------------ starts, and what a state looks like

    @known_numbers_only
    def from_harmonics(self, coefficients: dict[tuple[int, int], complex] | Any) -> Complex128[Array, "n n"]:
        """Return the state whose relative vorticity ω has given coefficients of spherical harmonics Y_lm.

        Args:
            coefficients: (l, m) → f_lm with 0 ≤ m ≤ l and 1 ≤ l < N; or an array (N, N) of them, l by rows. The real
                function's f_{l,−m} = (−1)^m f̄_lm follow.

        Raises:
            InvalidInput: for degrees and orders outside, f_l0 that are not real, or values that are not finite.
        """
        table = checked_coefficients(self.size, coefficients)
        return self.algebra.from_harmonics(jnp.asarray(table)) + self.planetary

    @compiled_for_few_calls
    def to_harmonics(self, state: Matrices) -> Complex128[Array, "*batch n n"]:
        """Return f_lm (…, N, N) of the relative vorticity, l by rows, m ≥ 0 by columns."""
        return self.algebra.to_harmonics(jnp.asarray(state) - self.planetary)

    @known_numbers_only
    def random(self, spectrum: Real[ArrayLike, "degrees"], seed: int = 0) -> Complex128[Array, "n n"]:
        """Return a state of random phases with energies E_l by degree, l = 0, 1, …, of which the first is ignored.

        Args:
            spectrum: (k,) k ≤ N, not negative.
            seed: of the random numbers.

        Raises:
            InvalidInput: for energies that are negative or not finite, or too many.
        """
        wanted, rng = checked_energies(self.size, spectrum), np.random.default_rng(seed)
        return self.from_harmonics(random_coefficients(self.size, wanted, inverse_squares(self.size), rng))

    @known_numbers_only
    def vortex(self, strength: float, direction: Real[ArrayLike, "3"]) -> Complex128[Array, "n n"]:
        """Return the smallest vortex of circulation Γ, with −Γ/4π everywhere: a relative vorticity to add to a state.

        Args:
            strength: Γ.
            direction: (3,) of its centre, normalised here.

        Raises:
            InvalidInput: for a direction that is zero or not finite.
        """
        axis = check.array("direction", direction, (3,), not_all_zero=True)
        # the coherent state is the top eigenvector of the spin along the direction
        spin = np.einsum("k,kij->ij", axis / np.linalg.norm(axis), self.algebra.coordinates) / (1j * self.algebra.hbar)
        state = np.linalg.eigh(spin)[1][:, -1]
        # ∫ω = (4π/N) tr(−iW), which is Γ of the projector and −Γ of the rest
        n = self.size
        return jnp.asarray(1j * strength * n / (4.0 * math.pi) * (np.outer(state, state.conj()) - np.eye(n) / n))

    @compiled_for_few_calls
    def energy_spectrum(self, state: Matrices) -> Float64[Array, "*batch n"]:
        """Return the energies E_l (…, N) by degree; they add up to ``energy``."""
        f = self.to_harmonics(state)
        # ½ Σ_m |f_lm|²/(l(l+1)), orders −m as m
        squares = jnp.abs(f[..., 0]) ** 2 + 2.0 * jnp.sum(jnp.abs(f[..., 1:]) ** 2, axis=-1)
        return 0.5 * squares * inverse_squares(self.size)

    @compiled_for_few_calls
    def energy_transfer(self, state: Matrices) -> Float64[Array, "*batch n"]:
        """Return the rates (…, N) at which each degree's E_l gains energy from the others; they add up to zero.

        Minus the sum over l ≤ k is the flux from degrees up to k to those beyond.
        """
        # dE/dt = −∫ψ ω̇, as Δ⁻¹ is symmetric, by degree: −Re Σ_m ψ̄_lm ω̇_lm
        stream = self.algebra.to_harmonics(self.stream_function(state))
        changes = self.algebra.to_harmonics(self.vector_field(0.0, jnp.asarray(state)))
        products = (jnp.conj(stream) * changes).real
        return -products[..., 0] - 2.0 * jnp.sum(products[..., 1:], axis=-1)

    @known_numbers_only
    def zonal_velocity(
        self, state: Matrices, colatitude: Real[ArrayLike, "rows"]
    ) -> Float64[Array, "*batch rows"]:
        """Return the eastward velocity ∂ψ/∂θ (…, rows), averaged over longitude, at colatitudes θ [rad]."""
        # Y_l0 = √((2l+1)/4π) P_l(cos θ), and ∂/∂θ = −sin θ d/d cos θ
        stream = self.algebra.to_harmonics(self.stream_function(state))[..., 0].real
        theta, degree = np.asarray(colatitude, float), np.arange(self.size)
        series = np.asarray(stream) * np.sqrt((2.0 * degree + 1.0) / (4.0 * math.pi))
        slopes = np.polynomial.legendre.legder(np.moveaxis(series, -1, 0))
        return -np.sin(theta) * np.polynomial.legendre.legval(np.cos(theta), slopes)

    @known_numbers_only
    def on_grid(
        self, state: Matrices, colatitude: Real[ArrayLike, "rows"], azimuth: Real[ArrayLike, "columns"]
    ) -> Float64[Array, "*batch rows columns"]:
        """Return the relative vorticity (…, rows, columns) at colatitudes and azimuths [rad]."""
        return on_map(self.to_harmonics(state), colatitude, azimuth)
