"""Arrangements of point vortices that turn as a whole: how fast, and whether they are stable."""

from __future__ import annotations

import math
from collections.abc import Callable

import jax.numpy as jnp
import numpy as np

from polhode.analysis.energy_casimir import Stability
from polhode.analysis.stability import stability
from polhode.arrays import known_numbers_only, refuse_single_precision
from polhode.errors import InvalidInput, shown
from polhode.systems.point_vortices import PlaneVortices, SphereVortices
from polhode.types import Array, ArrayLike, Complex128, Real

TURNING = 1e-8  # of the field: what is left of it besides a turn is rounding, up to the solver that found the state


@known_numbers_only
def vortex_turning_rate(system: SphereVortices | PlaneVortices, state: Real[ArrayLike, "n 3"]) -> float:
    """Return the rate Ω [rad/s] at which vortices turn as a whole about the third axis, or about the origin of a plane.

    Args:
        system: the vortices.
        state: (n, 3) as ``system.pack`` gives it.

    Raises:
        InvalidInput: if they do not turn as a whole about it.

    >>> ring = SphereVortices(np.ones(5))
    >>> round(vortex_turning_rate(ring, ring.ring(1.0)), 9)  # (n − 1) cos θ/(4π sin² θ)
    0.242889453
    """
    point = _one_state(system, state)
    field = np.asarray(system.vector_field(0.0, point))
    turn = np.asarray(point) @ _generator_of_turns(system).T
    size = float(np.sum(turn * turn))
    rate = float(np.sum(turn * field)) / size if size else 0.0
    left, whole = float(np.linalg.norm(field - rate * turn)), float(np.linalg.norm(_terms(system, point)))
    if left > TURNING * whole:
        raise InvalidInput(
            f"the vortices do not turn as a whole about {_axis(system)}: {left / whole:.3g} of their motion is "
            "something else. Solve for an arrangement that does, or move their centre there."
        )
    return rate


@known_numbers_only
def vortex_stability(system: SphereVortices | PlaneVortices, state: Real[ArrayLike, "n 3"]) -> Stability:
    """Return the verdict on vortices that turn as a whole about the third axis, or about the origin of a plane.

    It is that of ``stability`` with the integral whose flow is this turn: J_z, or ΣΓ|z|². "Stable" is Lyapunov's up to
    turns about the axis, proved by a definite second variation; "unstable" has the rate of growth.

    Args:
        system: the vortices.
        state: (n, 3) as ``system.pack`` gives it.

    Raises:
        InvalidInput: if they do not turn as a whole about it.

    >>> ring = SphereVortices(np.ones(4))
    >>> [vortex_stability(ring, ring.ring(angle)).verdict for angle in (0.9, 1.0)]  # cos² θ = 1/3 at 0.9553
    ['stable', 'unstable']
    """
    vortex_turning_rate(system, state)
    return stability(system, _one_state(system, state), integrals=[_moment_of_turns(system)])


@known_numbers_only
def ring_exponents(count: int, colatitude: float, strength: float = 1.0) -> Complex128[Array, "m"]:
    """Return λ_m (n − 1,) [1/s], m = 1, …, n − 1, of a ring of equal vortices: −λ_m is an exponent too.

    λ_m = (Γ/4π sin²θ) √(q(q − (n − 1)(1 + cos²θ))), q = m(n − m). Real ones grow; the imaginary ones turn.

    Args:
        count: n ≥ 2.
        colatitude: θ [rad], 0 < θ < π.
        strength: Γ.

    Raises:
        InvalidInput: for another count or angle.

    Source: Polvani & Dritschel, J. Fluid Mech. 255 (1993) 35; Boatto & Cabral, SIAM J. Appl. Math. 64 (2003) 216.

    >>> round(float(ring_exponents(7, 0.3).real.max()), 10)
    2.2849105472
    """
    _check_count(count)
    if not 0.0 < colatitude < math.pi:
        raise InvalidInput(f"`colatitude` must be between 0 and π; got {shown(colatitude)}. Give it in rad.")
    sine, cosine = math.sin(colatitude), math.cos(colatitude)
    return _exponents(count, strength / (4.0 * math.pi * sine * sine), (count - 1) * (1.0 + cosine * cosine))


@known_numbers_only
def polygon_exponents(count: int, radius: float, strength: float = 1.0) -> Complex128[Array, "m"]:
    """Return λ_m (n − 1,) [1/s], m = 1, …, n − 1, of a regular polygon of equal vortices: −λ_m is an exponent too.

    λ_m = (Γ/4πR²) √(q(q − 2(n − 1))), q = m(n − m). Real ones grow; seven vortices are neutral.

    Args:
        count: n ≥ 2.
        radius: R [m].
        strength: Γ [m²/s].

    Raises:
        InvalidInput: for another count or radius.

    Source: Thomson, *A Treatise on the Motion of Vortex Rings* (1883); Havelock, Phil. Mag. 11 (1931) 617.

    >>> round(float(polygon_exponents(8, 1.3).real.max()), 10)
    0.266365774
    """
    _check_count(count)
    if not (math.isfinite(radius) and radius > 0.0):
        raise InvalidInput(f"`radius` must be positive and finite; got {shown(radius)}.")
    return _exponents(count, strength / (4.0 * math.pi * radius * radius), 2.0 * (count - 1))


def _exponents(count: int, unit: float, bound: float) -> Array:
    m = np.arange(1, count)
    q = (m * (count - m)).astype(float)
    return unit * np.sqrt((q * (q - bound)).astype(complex))


def _check_count(count: int) -> None:
    if not isinstance(count, int) or count < 2:
        raise InvalidInput(f"`count` must be a whole number of vortices, at least 2; got {shown(count)}.")


def _one_state(system: SphereVortices | PlaneVortices, state: Real[ArrayLike, "n 3"]) -> Array:
    if not isinstance(system, SphereVortices | PlaneVortices):
        raise InvalidInput(f"`system` must be SphereVortices or PlaneVortices; got {type(system).__name__}.")
    refuse_single_precision(state=state)
    point = system.check_state(state)
    if point.ndim != 2:
        raise InvalidInput(f"`state` must be one state {system.algebra.element_shape}; got shape {point.shape}.")
    return point


def _terms(system: SphereVortices | PlaneVortices, point: Array) -> Array:
    """Return Γ_i Γ_j/(2π|x_i − x_j|) in units of the state: the terms of the field, which may cancel in it."""
    places, strengths = np.asarray(system.positions(point)), np.asarray(system.strengths)
    apart = np.linalg.norm(places[:, None] - places[None], axis=-1) + np.eye(len(strengths))
    own = np.abs(strengths)[:, None] if isinstance(system, SphereVortices) else 1.0
    return own * np.abs(strengths) * (1.0 - np.eye(len(strengths))) / (2.0 * np.pi * apart)


def _generator_of_turns(system: SphereVortices | PlaneVortices) -> Array:
    """Return the matrix (3, 3) of the rate of a state's components in a turn by 1 rad/s."""
    if isinstance(system, SphereVortices):
        return np.array([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 0.0]])
    return np.array([[0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 0.0, 0.0]])  # of (y, x, 1/Γ)


def _moment_of_turns(system: SphereVortices | PlaneVortices) -> Callable[[Array], Array]:
    if isinstance(system, SphereVortices):
        return lambda point: jnp.sum(point[..., 2], axis=-1)
    return lambda point: jnp.sum(jnp.sum(point[..., :2] ** 2, axis=-1) / point[..., 2], axis=-1)


def _axis(system: SphereVortices | PlaneVortices) -> str:
    return "the third axis" if isinstance(system, SphereVortices) else "the origin"
