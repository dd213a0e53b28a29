"""Relative equilibria of point vortices: rate of rotation and stability."""

from __future__ import annotations

import math
from typing import NamedTuple

import jax.numpy as jnp
import numpy as np

from polhode._base import check
from polhode._base.arrays import known_numbers_only, require_doubles
from polhode.algebra._functions import Function
from polhode.analysis.energy_casimir import Stability
from polhode.analysis.stability import stability
from polhode.errors import InvalidInput
from polhode.fields.point_vortices.system import PlaneVortices, SphereVortices
from polhode.types import Array, ArrayLike, Complex128, Float64, Real


class VortexTurnLimits(NamedTuple):
    """Relative numbers that decide whether vortices turn as a whole, and about what.

    Attributes:
        min_singular_value: of the turns about three axes, over the largest; two antipodal vortices fix no turn about
            the line through them.
        max_resting_field: a rigid motion whose field is at most this share of the terms that cancel in it is their
            rounding: the vortices rest.
        max_other_field: share of the field besides a rigid motion that is still attributed to rounding and to the
            solver that computed the state; with a turn below this share, vortices in a plane move straight.
    """

    min_singular_value: float = 1e-12
    max_resting_field: float = 1e-14
    max_other_field: float = 1e-8


LIMITS = VortexTurnLimits()


class VortexTurn(NamedTuple):
    """The rigid motion of vortices.

    Attributes:
        rate: Ω [rad/s] about ``axis`` or ``center``; of vortices in a plane zero where they move straight.
        axis: unit vector (3,), on a sphere; zero where all are at rest.
        center: (2,) [m] of the turn, in a plane; None where they do not turn.
        velocity: (2,) [m/s] of a straight motion, in a plane; zero where they turn.
    """

    rate: float
    axis: Float64[Array, "3"] | None = None
    center: Float64[Array, "2"] | None = None
    velocity: Float64[Array, "2"] | None = None


@known_numbers_only
def vortex_turn(system: SphereVortices | PlaneVortices, state: Real[ArrayLike, "n 3"]) -> VortexTurn:
    """Return how vortices turn as a whole: rate, and axis or centre; in a plane they may move straight instead.

    Args:
        system: the vortices.
        state: (n, 3) as ``system.pack`` gives it.

    Raises:
        InvalidInput: if the distances between them change.

    >>> ring = SphereVortices(np.ones(5))
    >>> round(vortex_turn(ring, ring.ring(1.0)).rate, 9)  # (n − 1) cos θ/(4π sin² θ)
    0.242889453
    """
    point = _one_state(system, state)
    pair = _turn_on_sphere(system, point) if isinstance(system, SphereVortices) else _turn_in_plane(system, point)
    turn, left = pair
    whole = float(np.linalg.norm(_terms(system, point)))
    if left > LIMITS.max_other_field * whole:
        raise InvalidInput(
            f"the vortices do not turn as a whole: {left / whole:.3g} of their motion changes the distances between "
            "them. Give an arrangement that turns, such as a ring."
        )
    return turn


@known_numbers_only
def vortex_stability(system: SphereVortices | PlaneVortices, state: Real[ArrayLike, "n 3"]) -> Stability:
    """Return the verdict on vortices that turn, or move, as a whole.

    The verdict is that of ``stability`` with the momentum map of the symmetries: J on a sphere, ΣΓ|z − c|² about the
    centre c of a turn in a plane, ΣΓ v × z where they move straight by v. "Stable" is Lyapunov's up to these turns or
    shifts, by a definite second variation; "unstable" has the rate of growth.

    Args:
        system: the vortices.
        state: (n, 3) as ``system.pack`` gives it.

    Raises:
        InvalidInput: if the distances between them change.

    >>> ring = SphereVortices(np.ones(4))
    >>> [vortex_stability(ring, ring.ring(angle)).verdict for angle in (0.9, 1.0)]  # cos² θ = 1/3 at 0.9553
    ['stable', 'unstable']
    """
    turn = vortex_turn(system, state)
    return stability(system, _one_state(system, state), integrals=_momentum_map(system, turn))


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
    count = check.whole("count", count, 2, what="vortices")
    colatitude = check.number("colatitude", colatitude, "rad", above=0, below=math.pi, rule="between 0 and π")
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
    count = check.whole("count", count, 2, what="vortices")
    radius = check.number("radius", radius, "m", above=0)
    return _exponents(count, strength / (4.0 * math.pi * radius * radius), 2.0 * (count - 1))


def _exponents(count: int, unit: float, bound: float) -> Array:
    m = np.arange(1, count)
    q = (m * (count - m)).astype(float)
    return unit * np.sqrt((q * (q - bound)).astype(complex))


def _one_state(system: SphereVortices | PlaneVortices, state: Real[ArrayLike, "n 3"]) -> Array:
    check.instance("system", system, (SphereVortices, PlaneVortices), "SphereVortices or PlaneVortices")
    require_doubles(state=state)
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


def _turn_on_sphere(system: SphereVortices, point: Array) -> tuple[VortexTurn, float]:
    """Return the rigid motion that fits the field best, and the norm of the residual."""
    state, field = np.asarray(point), np.asarray(system.vector_field(0.0, point))
    # μ̇_i = ω × μ_i for all i, by least squares
    turns = np.cross(np.eye(3)[:, None], state).reshape(3, -1).T  # (3n, 3), of unit rate about each axis
    omega = np.linalg.lstsq(turns, field.ravel(), rcond=LIMITS.min_singular_value)[0]
    rate = float(np.linalg.norm(omega))
    if rate * float(np.linalg.norm(state)) <= LIMITS.max_resting_field * float(np.linalg.norm(_terms(system, point))):
        return VortexTurn(0.0, axis=np.zeros(3)), float(np.linalg.norm(field))
    axis = omega / rate
    return VortexTurn(rate, axis=axis), float(np.linalg.norm(field.ravel() - turns @ omega))


def _turn_in_plane(system: PlaneVortices, point: Array) -> tuple[VortexTurn, float]:
    places, field = np.asarray(system.positions(point)), np.asarray(system.vector_field(0.0, point))[:, 1::-1]
    middle = places.mean(axis=0)
    apart = places - middle
    quarter = apart @ np.array([[0.0, 1.0], [-1.0, 0.0]])  # of each place, rotated by a right angle
    drift = field.mean(axis=0)
    rate = float(np.sum(quarter * field) / np.sum(quarter * quarter))
    left = float(np.linalg.norm(field - drift - rate * quarter))
    size = float(np.linalg.norm(apart))
    if abs(rate) * size <= LIMITS.max_other_field * float(np.linalg.norm(_terms(system, point))):
        return VortexTurn(0.0, velocity=drift), left
    return VortexTurn(rate, center=middle + np.array([-drift[1], drift[0]]) / rate, velocity=np.zeros(2)), left


def _momentum_map(system: SphereVortices | PlaneVortices, turn: VortexTurn) -> list[Function]:
    """Return the conserved functions whose flows are the rigid motion; on a sphere all those of the rotation group."""
    if isinstance(system, SphereVortices):
        return list(system.extra_invariants.values())
    if turn.center is None:
        assert turn.velocity is not None
        vx, vy = turn.velocity.tolist()  # ΣΓ(v × z), whose flow moves all along v
        return [lambda point: jnp.sum((vx * point[..., 0] - vy * point[..., 1]) / point[..., 2], axis=-1)]
    y, x = float(turn.center[1]), float(turn.center[0])
    return [lambda point: jnp.sum(((point[..., 0] - y) ** 2 + (point[..., 1] - x) ** 2) / point[..., 2], axis=-1)]
