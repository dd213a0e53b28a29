"""The Vlasov–Poisson plasma in one dimension, by particles without a grid."""

from __future__ import annotations

from collections.abc import Callable
from typing import ClassVar

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np

from polhode._base import check
from polhode._base.arrays import compiled_quickly, known_numbers_only, require_doubles
from polhode.algebra._functions import Function
from polhode.algebra.heisenberg import Heisenberg
from polhode.algebra.power import Power
from polhode.errors import InvalidInput, shown
from polhode.systems._checks import checked_number
from polhode.systems.base import AbstractLiePoissonSystem, Components, Flow, Kick
from polhode.types import Array, ArrayLike, Double, Float64, Real

GOLDEN = 0.5 * (np.sqrt(5.0) - 1.0)


class VlasovPoisson(AbstractLiePoissonSystem):
    """Electrons in a periodic box before a background at rest: μ_p = (v_p, x_p, 1/w_p) on copies of Heisenberg(1)*.

    H = ½ Σ w v² + (1/L) Σ_{j=1..M} |ρ_j|²/(jk)², ρ_j = Σ w e^{−ijkx}, k = 2π/L: then ẋ = v and
    v̇ = (2/L) Σ_j Im(ρ_j e^{ijkx})/(jk), by O(particles · modes) operations a step. The distribution Σ w δ(x − x_p)
    δ(v − v_p) solves the Vlasov equation with these modes of the field exactly; the weights are Casimirs. In units of
    Debye length, thermal speed and plasma frequency a mean density of one, Σw = L, has plasma frequency one; states
    (…, particles, 3) are made by ``quiet_start``. Drifts and kicks are exact: ``Splitting`` keeps Σwv to rounding.

    Args:
        length: L of the box.
        modes: M, how many Fourier modes the field has.
        particles: how many particles.

    Raises:
        InvalidInput: for a length that is not positive, or other than positive whole numbers.

    Source: Weinstein & Morrison, Phys. Lett. A 86 (1981) 235; Evstatiev & Shadwick, J. Comput. Phys. 245 (2013) 376.

    >>> box = VlasovPoisson(2.0 * np.pi, 1, 2)
    >>> state = box.pack([0.5 * np.pi, -0.5 * np.pi], [1.0, 0.0], [np.pi, np.pi])
    >>> box.vector_field(0.0, state).round(9)[:, 1].tolist()
    [1.0, 0.0]
    """

    kind: ClassVar[str] = "vlasov-poisson"
    title: ClassVar[str] = "Vlasov–Poisson plasma"
    algebra: Power
    length: Float64[Array, ""]
    modes: int = eqx.field(static=True)

    @known_numbers_only
    def __init__(self, length: float, modes: int, particles: int) -> None:
        modes, particles = check.whole("modes", modes, 1), check.whole("particles", particles, 1)
        self.length, self.modes = checked_number("length", length, above=0.0), modes
        self.algebra = Power(Heisenberg(1), particles)

    def pack(
        self,
        positions: Real[ArrayLike, "*batch n"],
        velocities: Real[ArrayLike, "*batch n"],
        weights: Real[ArrayLike, "*batch n"],
    ) -> Float64[Array, "*batch n 3"]:
        """Return states from positions, velocities and weights (…, particles)."""
        require_doubles(positions=positions, velocities=velocities, weights=weights)
        parts = [jnp.asarray(x, dtype=float) for x in (velocities, positions, weights)]
        return jnp.stack(jnp.broadcast_arrays(parts[0], parts[1], 1.0 / parts[2]), axis=-1)

    @known_numbers_only
    def check_state(self, state: Real[ArrayLike, "*shape"]) -> Double[Array, "*shape"]:
        state = super().check_state(state)
        if not (np.asarray(state)[..., 2] > 0.0).all():
            raise InvalidInput("`state` must have 1/w > 0 behind each v and x. Make it by `quiet_start` or `pack`.")
        return state

    @property
    def wavenumber(self) -> Float64[Array, ""]:
        """k = 2π/L of the longest wave."""
        return 2.0 * jnp.pi / self.length

    @compiled_quickly
    def density_modes(self, point: Float64[Array, "*batch n 3"]) -> Float64[Array, "*batch m 2"]:
        """Return real and imaginary parts (…, modes, 2) of ρ_j/L, j = 1, …, M; the mean density is ρ_0/L."""
        x, weight = point[..., 1], 1.0 / point[..., 2]
        angles = jnp.arange(1.0, self.modes + 1.0)[:, None] * (self.wavenumber * x)[..., None, :]
        parts = [weight[..., None, :] * jnp.cos(angles), -weight[..., None, :] * jnp.sin(angles)]
        return jnp.stack([jnp.sum(part, axis=-1) for part in parts], axis=-1) / self.length

    def field_amplitudes(self, point: Float64[Array, "*batch n 3"]) -> Float64[Array, "*batch m"]:
        """Return the amplitudes (…, modes) of the waves of v̇: E = Σ_j amplitude_j · cos(jkx + phase)."""
        size = jnp.sqrt(jnp.sum(self.density_modes(point) ** 2, axis=-1))
        return 2.0 * size / (self.wavenumber * jnp.arange(1.0, self.modes + 1.0))

    def energy(self, point: Float64[Array, "*batch n 3"]) -> Float64[Array, "*batch"]:
        v, weight = point[..., 0], 1.0 / point[..., 2]
        return 0.5 * jnp.sum(weight * v * v, axis=-1) + self._waves(point[..., 1], weight)[0]

    def velocity(self, point: Float64[Array, "*batch n 3"]) -> Float64[Array, "*batch n 3"]:
        v, weight = point[..., 0], 1.0 / point[..., 2]
        _, force, potential = self._waves(point[..., 1], weight)
        # w = 1/level: ∂H/∂level = −w² ∂H/∂w, ∂H/∂w = ½v² + potential
        by_level = -(weight**2) * (0.5 * v * v + potential)
        return jnp.stack([weight * v, -weight * force, by_level], axis=-1)

    @property
    def extra_invariants(self) -> dict[str, Function]:
        """Σwv, which the field keeps as the particles push each other only."""
        return {"momentum Σwv": lambda point: jnp.sum(point[..., 0] / point[..., 2], axis=-1)}

    @property
    def flows(self) -> dict[str, Flow]:
        return {"field": Kick(self._kick), "drift": self._drift}

    def _kick(self, time: Array, state: Components) -> Components:
        _, x, level = state
        still = jnp.zeros_like(x)
        return time * self._waves(x, 1.0 / level)[1], still, still

    def _drift(self, time: Array, state: Components) -> Components:
        still = jnp.zeros_like(state[0])
        return still, time * state[0], still

    def _waves(self, x: Array, weight: Array) -> tuple[Array, Array, Array]:
        """Return the field's energy (…), and force and potential (…, n) on the particles.

        Powers of e^{ikx} cost one complex product a mode; a loop keeps what is compiled as small for many modes.
        """
        angle = self.wavenumber * x
        first = jnp.cos(angle), jnp.sin(angle)

        def add(j: Array, carried: tuple[Array, ...]) -> tuple[Array, ...]:
            real, imaginary, energy, force, potential = carried
            # ρ_j = Σ w e^{−ijkx} as its real and imaginary part; −φ″ = ρ gives φ_j = ρ_j/(jk)², the energy |ρ_j|²/(jk)²
            # and the force −φ′, whose wave is Im(ρ_j e^{ijkx})/(jk)
            across, along = jnp.sum(weight * real, axis=-1), -jnp.sum(weight * imaginary, axis=-1)
            inverse = 1.0 / ((j + 1.0) * self.wavenumber)
            one, other = across[..., None], along[..., None]
            energy = energy + inverse**2 * (across**2 + along**2)
            force = force + inverse * (one * imaginary + other * real)
            potential = potential + inverse**2 * (one * real - other * imaginary)
            rotated = real * first[0] - imaginary * first[1], real * first[1] + imaginary * first[0]
            return *rotated, energy, force, potential

        nothing = jnp.zeros_like(x)
        start = (*first, nothing[..., 0], nothing, nothing)
        _, _, energy, force, potential = jax.lax.fori_loop(0, self.modes, add, start)
        return energy / self.length, 2.0 / self.length * force, 2.0 / self.length * potential


# ------------------------------------------------------------------ starts


@known_numbers_only
def quiet_start(
    system: VlasovPoisson,
    distribution: Callable[[Float64[Array, "beams"]], Float64[Array, "beams"]],
    beams: int,
    amplitude: float,
    mode: int = 1,
    fastest: float = 6.0,
) -> Float64[Array, "n 3"]:
    """Return particles (n, 3) of f(x, v) = f₀(v) (1 + A cos(jkx)) without noise, Σw = L.

    Velocities are equally spaced, each a beam of particles equally spaced in mass and shifted by a golden ratio from
    beam to beam. What free streaming does is then exact until 2π/(kΔv), when the beams are in step again: field and
    growth are those of f until then. Random particles would need a hundred thousand times as many.

    Args:
        system: whose particles are a multiple of ``beams``.
        distribution: f₀ of velocities (beams,) → (beams,), not negative; it is scaled to ∫f₀ dv = 1.
        beams: how many velocities.
        amplitude: A, −1 < A < 1.
        mode: j, of the perturbed wave.
        fastest: speeds up to this one, in the middle of whose steps the beams are.

    Raises:
        InvalidInput: for beams that do not divide the particles, an amplitude out of range, or a distribution that is
            negative, not finite or zero.
    """
    count = system.algebra.copies
    if not isinstance(beams, int) or beams < 1 or count % beams:
        raise InvalidInput(f"`beams` must divide the system's {count} particles; got {shown(beams)}.")
    amplitude = check.number("amplitude", amplitude, above=-1, below=1)
    mode = check.whole("mode", mode, 1)
    fastest = check.number("fastest", fastest, above=0)
    speeds = fastest * (2.0 * (np.arange(beams) + 0.5) / beams - 1.0)
    shares = np.asarray(distribution(speeds), dtype=float)
    if shares.shape != speeds.shape or not np.isfinite(shares).all() or (shares < 0.0).any() or not shares.any():
        raise InvalidInput("`distribution` must give finite values (beams,), none negative and some positive.")
    used = shares > 0.0
    if not used.all():
        raise InvalidInput(
            f"`distribution` is zero at {int((~used).sum())} of {beams} velocities, e.g. {speeds[~used][0]:.3g}, and "
            "particles must have weights. Take a smaller `fastest`, or another number of `beams`."
        )
    each, length = count // beams, float(system.length)
    offsets = (GOLDEN * np.arange(beams)) % 1.0
    masses = 2.0 * np.pi * (np.arange(each)[None, :] + offsets[:, None]) / each
    # one period of the perturbed wave after another, so that each beam is equally spaced in mass over the box
    angles = _by_mass(mode * masses, amplitude) / mode
    weights = np.broadcast_to((length * shares / shares.sum() / each)[:, None], angles.shape)
    velocities = np.broadcast_to(speeds[:, None], angles.shape)
    places = length * angles / (2.0 * np.pi)
    return system.pack(places.ravel(), velocities.ravel(), weights.ravel())


def _by_mass(masses: Array, amplitude: float) -> Array:
    """Return angles θ with θ + A sin θ = mass, by Newton's method between bounds."""
    # |θ − mass| ≤ |A|; the left side grows with θ, as |A| < 1
    low, high, angles = masses - abs(amplitude), masses + abs(amplitude), masses.copy()
    most_steps = 60  # with halvings: a density of contrast below one is solved long before
    for _ in range(most_steps):
        off = angles + amplitude * np.sin(angles) - masses
        low, high = np.where(off < 0.0, angles, low), np.where(off > 0.0, angles, high)
        tried = angles - off / (1.0 + amplitude * np.cos(angles))
        angles = np.where((tried < low) | (tried > high), 0.5 * (low + high), tried)
    return angles
