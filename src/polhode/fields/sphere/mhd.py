"""An ideal conducting fluid on a sphere with its magnetic field, by matrices over the dual numbers."""

from __future__ import annotations

from typing import Any, ClassVar

import jax
import jax.numpy as jnp
import numpy as np

from polhode._base.arrays import known_numbers_only
from polhode.algebra._functions import Function
from polhode.algebra.dual_numbers import DualNumbers
from polhode.fields.sphere._harmonics import (
    checked_coefficients,
    checked_energies,
    inverse_squares,
    on_map,
    random_coefficients,
)
from polhode.fields.sphere._laplacian import inverse_laplacian, laplacian
from polhode.fields.sphere.algebra import QuantizedSphere
from polhode.fields.sphere.fluid import SphereFluid
from polhode.motion._layout import Quantity
from polhode.systems.base import AbstractLiePoissonSystem
from polhode.types import Array, ArrayLike, Complex128, Float64, Real

Pairs = Complex128[Array, "*batch 2 n n"]
Matrices = Complex128[Array, "*batch n n"]


class SphereMHD(AbstractLiePoissonSystem):
    """q̇ = {q, ψ} + {A, j}, Ȧ = {A, ψ} on the unit sphere, by matrices: Ẇ = ([P, W] + [B, Θ])/ħ, Θ̇ = [P, Θ]/ħ.

    Θ is the potential A of the field b = x × ∇A, which the fluid carries along, B = ΔΘ the current j; W,
    P and F are those of ``SphereFluid``. H = −½⟨W − F, P⟩ − ½⟨Θ, B⟩ is the sum of kinetic and magnetic energy. States
    Z = Θ + d W are (…, 2, N, N), Θ first, of the algebra ``DualNumbers(QuantizedSphere(N))``. Every tr Θ^k is kept, as
    every ∫ f(A), and every tr WΘ^k, as ∫ q f(A), among them the cross-helicity; and the angular momentum as of
    ``SphereFluid``.

    ``IsospectralMidpoint`` keeps all of these to rounding. The fluid is ideal: field lines do not reconnect, and sheets
    of current get thinner until they meet the resolution, l < N.

    Args:
        n: N, at least 3.
        rotation: Ω of the sphere [rad/s].

    Raises:
        InvalidInput: for an N that is too small or a rotation that is not finite.

    >>> fluid = SphereMHD(8, 0.5)
    >>> state = fluid.from_harmonics({(3, 0): 1.0}, {(2, 1): 0.3})
    >>> round(float(fluid.energy_spectrum(state)[1, 2]), 6)          # ½ l(l+1) (|f₂₁|² + |f₂,₋₁|²)
    0.54

    Source: Zeitlin, Phys. Rev. Lett. 93 (2004) 264501; Modin & Roop, IMA J. Numer. Anal. (2025), arXiv 2311.16045.
    """

    kind: ClassVar[str] = "sphere-mhd"
    title: ClassVar[str] = "Ideal conducting fluid on a sphere"
    algebra: DualNumbers
    fluid: SphereFluid

    @known_numbers_only
    def __init__(self, n: int, rotation: float = 0.0) -> None:
        self.fluid = SphereFluid(n, rotation)
        self.algebra = DualNumbers(self.fluid.algebra)

    @property
    def series_of_arrays(self) -> bool:
        return self.fluid.series_of_arrays

    @property
    def size(self) -> int:
        """N."""
        return self.fluid.size

    @property
    def sphere(self) -> QuantizedSphere:
        """The algebra of W and of Θ alone."""
        return self.fluid.algebra

    def stream_function(self, point: Pairs) -> Matrices:
        """Return P = Δ⁻¹(W − F) (…, N, N)."""
        return self.fluid.stream_function(jnp.asarray(point)[..., 1, :, :])

    def current(self, point: Pairs) -> Matrices:
        """Return B = ΔΘ (…, N, N)."""
        return laplacian(jnp.asarray(point)[..., 0, :, :])

    @property
    def quantities(self) -> dict[str, Quantity]:
        return super().quantities | {"energy": Quantity("rad2 s-2", "energy on the unit sphere, per density")}

    def energy(self, point: Pairs) -> Float64[Array, "*batch"]:
        theta = jnp.asarray(point)[..., 0, :, :]
        relative = jnp.asarray(point)[..., 1, :, :] - self.fluid.planetary
        # ½ ∫|∇ψ|² + ½ ∫|∇A|² by parts
        both = self.sphere.pairing(relative, inverse_laplacian(relative)) + self.sphere.pairing(theta, laplacian(theta))
        return -0.5 * both

    def velocity(self, point: Pairs) -> Pairs:
        return -jnp.stack([self.stream_function(point), self.current(point)], axis=-3)

    @property
    def extra_invariants(self) -> dict[str, Function]:
        """∫ x₃ ω and the square of the other two components, which turn where the sphere does."""
        of_fluid = self.fluid.extra_invariants
        return {name: lambda point, f=f: f(jnp.asarray(point)[..., 1, :, :]) for name, f in of_fluid.items()}

    def invariant_sizes(self, state: Pairs) -> dict[str, Float64[Array, "*batch"]]:
        return self.fluid.invariant_sizes(jnp.asarray(state)[..., 1, :, :])

    # ------------------------------------------------------------------ starts, and what a state looks like

    @known_numbers_only
    def from_harmonics(
        self, vorticity: dict[tuple[int, int], complex] | Any, potential: dict[tuple[int, int], complex] | Any
    ) -> Complex128[jax.Array, "2 n n"]:
        """Return the state whose relative vorticity ω and potential A have given coefficients of harmonics Y_lm.

        Args:
            vorticity: (l, m) → f_lm with 0 ≤ m ≤ l and 1 ≤ l < N; or an array (N, N) of them, l by rows. The real
                function's f_{l,−m} = (−1)^m f̄_lm follow.
            potential: likewise.

        Raises:
            InvalidInput: for degrees and orders outside, f_l0 that are not real, or values that are not finite.
        """
        table = checked_coefficients(self.size, potential, "potential")
        w = checked_coefficients(self.size, vorticity, "vorticity")
        pair = self.sphere.from_harmonics(jnp.asarray(np.stack([table, w])))
        return pair.at[1].add(self.fluid.planetary)

    def to_harmonics(self, state: Pairs) -> Complex128[Array, "*batch 2 n n"]:
        """Return f_lm (…, 2, N, N) of potential and relative vorticity, l by rows, m ≥ 0 by columns."""
        return self.sphere.to_harmonics(jnp.asarray(state).at[..., 1, :, :].add(-self.fluid.planetary))

    @known_numbers_only
    def random(
        self, kinetic: Real[ArrayLike, "degrees"], magnetic: Real[ArrayLike, "others"], seed: int = 0
    ) -> Complex128[Array, "2 n n"]:
        """Return a state of random phases with energies by degree, l = 0, 1, …, of which the first is ignored.

        Args:
            kinetic: (k,) k ≤ N, not negative.
            magnetic: (k',) likewise.
            seed: of the random numbers.

        Raises:
            InvalidInput: for energies that are negative or not finite, or too many.
        """
        n, rng = self.size, np.random.default_rng(seed)
        energies = checked_energies(n, kinetic, "kinetic"), checked_energies(n, magnetic, "magnetic")
        degree = np.arange(n)
        vorticity = random_coefficients(n, energies[0], inverse_squares(n), rng)
        potential = random_coefficients(n, energies[1], degree * (degree + 1.0), rng)
        return self.from_harmonics(vorticity, potential)

    def energy_spectrum(self, state: Pairs) -> Float64[Array, "*batch 2 n"]:
        """Return kinetic and magnetic energies (…, 2, N) by degree; all of them add up to ``energy``."""
        f = self.to_harmonics(state)
        squares = jnp.abs(f[..., 0]) ** 2 + 2.0 * jnp.sum(jnp.abs(f[..., 1:]) ** 2, axis=-1)
        degree = np.arange(self.size)
        weights = np.stack([inverse_squares(self.size), degree * (degree + 1.0)])
        return 0.5 * weights * squares[..., ::-1, :]

    @known_numbers_only
    def on_grid(
        self, state: Pairs, colatitude: Real[ArrayLike, "rows"], azimuth: Real[ArrayLike, "columns"]
    ) -> Float64[Array, "*batch 2 rows columns"]:
        """Return potential and relative vorticity (…, 2, rows, columns) at colatitudes and azimuths [rad]."""
        return on_map(self.to_harmonics(state), colatitude, azimuth)
