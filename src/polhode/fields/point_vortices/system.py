"""Point vortices on the sphere and in the plane."""

from __future__ import annotations

from functools import partial
from typing import ClassVar, NamedTuple

import jax.numpy as jnp
import numpy as np

from polhode._base import check
from polhode._base.arrays import compiled_for_few_calls, is_traced, known_numbers_only, require_doubles
from polhode.algebra._functions import Function
from polhode.algebra.heisenberg import Heisenberg
from polhode.algebra.power import Power
from polhode.algebra.so3 import SO3
from polhode.errors import InvalidInput, shown
from polhode.fields._turns import dot, turn
from polhode.motion._layout import Quantity
from polhode.systems.base import AbstractLiePoissonSystem, Components, Flow, Round
from polhode.types import Array, ArrayLike, Double, Float64, Integer, Real


class VortexStateLimits(NamedTuple):
    """How far a state may be from the orbit of its strengths.

    Attributes:
        max_orbit_error: relative, of |μ_i| or 1/Γ_i.
    """

    max_orbit_error: float = 1e-9


LIMITS = VortexStateLimits()
HALF_TURN = 0.5 / np.pi


class SphereVortices(AbstractLiePoissonSystem):
    """Point vortices x_i on the unit sphere: μ_i = Γ_i x_i on n copies of so(3)*, with the bracket's sign +1.

    H = −(1/4π) Σ_{i<j} Γ_i Γ_j ln|x_i − x_j|², with ẋ_i = Σ_j Γ_j x_j × x_i/(2π|x_i − x_j|²). States (…, n, 3) are made
    by ``pack``. Two vortices alone turn about Γ_i x_i + Γ_j x_j at a constant rate; the flows are rounds of
    disjoint pairs, each of which turns so. ``Splitting``, their product, keeps every |μ_i| and J = Σ μ_i to rounding.

    Args:
        strengths: (n,) circulations Γ, none of them zero, n ≥ 2. On a closed surface a uniform vorticity −ΣΓ/4π, which
            moves nothing, makes up for a sum other than zero.

    Raises:
        InvalidInput: for fewer than two strengths, or one that is zero or not finite.

    Source: Bogomolov, Fluid Dyn. 12 (1977) 863; Kidambi & Newton, Physica D 116 (1998) 143.

    >>> pair = SphereVortices((1.0, 2.0))
    >>> state = pair.pack([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]])
    >>> (np.pi * pair.vector_field(0.0, state))[:, 2].round(9).tolist()
    [-0.5, 0.5]
    """

    kind: ClassVar[str] = "point-vortices"
    title: ClassVar[str] = "Point vortices on the sphere"
    algebra: Power
    strengths: Float64[Array, "n"]

    @known_numbers_only
    def __init__(self, strengths: Real[ArrayLike, "n"]) -> None:
        self.strengths = _checked_strengths(strengths)
        self.algebra = Power(SO3(), len(self.strengths))

    @property
    def sign(self) -> int:
        return 1

    def pack(self, positions: Real[ArrayLike, "*batch n 3"]) -> Float64[Array, "*batch n 3"]:
        """Return states from directions (…, n, 3) from the centre, of any length.

        Raises:
            InvalidInput: for a direction that is zero or not finite.
        """
        require_doubles(positions=positions)
        xp = jnp if is_traced(positions) else np
        places = xp.asarray(positions, dtype=float)
        size = xp.linalg.norm(places, axis=-1, keepdims=True)
        if xp is np and not (np.isfinite(size).all() and (size > 0).all()):
            raise InvalidInput(f"`positions` must be finite directions other than zero; got {shown(positions)}.")
        return self.strengths[:, None] * (places / size)

    @compiled_for_few_calls
    def positions(self, point: Real[ArrayLike, "*batch n 3"]) -> Float64[Array, "*batch n 3"]:
        """Return the unit vectors x (…, n, 3) at which the vortices are."""
        return jnp.asarray(point) / self.strengths[:, None]

    @compiled_for_few_calls
    def stream_function(
        self, point: Real[ArrayLike, "n 3"], places: Real[ArrayLike, "*places 3"]
    ) -> Float64[Array, "*places"]:
        """Return ψ = (1/4π) Σ Γ_j ln(1 − x · x_j) (…): the fluid at x moves by x × ∇ψ.

        Args:
            point: (n, 3) a state.
            places: (…, 3) unit vectors x; at a vortex ψ is infinite.
        """
        # |x − x_j|² = 2(1 − x·x_j); the factor 2 is a constant of ψ
        cosines = jnp.asarray(places) @ self.positions(point).T
        return 0.5 * HALF_TURN * jnp.sum(self.strengths * jnp.log(1.0 - cosines), axis=-1)

    def ring(self, colatitude: Real[ArrayLike, ""]) -> Float64[Array, "n 3"]:
        """Return the state (n, 3) of vortices at equal distances on a circle of latitude, the first at longitude 0.

        Args:
            colatitude: θ [rad], from the north pole. With equal strengths Γ the ring turns at
                (n − 1) Γ cos θ/(4π sin² θ) [rad/s] about the pole.
        """
        azimuth = 2.0 * np.pi * np.arange(len(self.strengths)) / len(self.strengths)
        xp = jnp if is_traced(colatitude) else np
        require_doubles(colatitude=colatitude)
        sine, cosine = xp.sin(colatitude), xp.cos(colatitude)
        return self.pack(xp.stack([sine * np.cos(azimuth), sine * np.sin(azimuth), cosine + 0.0 * azimuth], axis=-1))

    @known_numbers_only
    def check_state(self, state: Real[ArrayLike, "*shape"]) -> Double[Array, "*shape"]:
        state = super().check_state(state)
        off = np.abs(np.linalg.norm(np.asarray(self.positions(state)), axis=-1) - 1.0)
        if off.max(initial=0.0) > LIMITS.max_orbit_error:
            raise InvalidInput(
                "`state` must be Γ_i x_i with unit vectors x_i; one is off by "
                f"{off.max():.3g}. Make it by `vortices.pack(positions)`."
            )
        _check_apart(np.asarray(self.positions(state)))
        return state

    @property
    def quantities(self) -> dict[str, Quantity]:
        return super().quantities | {"energy": Quantity("rad2 s-2", "energy on the unit sphere, per density")}

    def energy(self, point: Float64[Array, "*batch n 3"]) -> Float64[Array, "*batch"]:
        return _pair_energy(self.strengths, self.positions(point))

    def velocity(self, point: Float64[Array, "*batch n 3"]) -> Float64[Array, "*batch n 3"]:
        # dH = ∂H/∂μ_i = (1/Γ_i) ∂H/∂x_i
        return -HALF_TURN * _pulls(self.strengths, self.positions(point))

    @property
    def extra_invariants(self) -> dict[str, Function]:
        """Components of J = Σ μ_i, the moment of vorticity."""
        return {f"moment of vorticity, {'xyz'[k]}": partial(_total, k) for k in range(3)}

    @property
    def flows(self) -> dict[str, Flow]:
        count = len(rounds_of_pairs(len(self.strengths)))
        return {f"pairs, round {k + 1}": Round(self._turn_pairs, k) for k in range(count)}

    def _turn_pairs(self, number: Integer[Array, ""], time: Array, state: Components) -> Components:
        partners = jnp.asarray(np.stack(rounds_of_pairs(len(self.strengths))))[number]
        other = tuple(x[..., partners] for x in state)
        ratios = 1.0 / self.strengths
        # ẋ_i = Γ_j x_j × x_i/(2πd²) = (μ_i + μ_j) × x_i/(2πd²): both turn about μ_i + μ_j, which stays, as d does
        apart = [x * ratios - y * ratios[partners] for x, y in zip(state, other, strict=True)]
        angle = HALF_TURN * time * _active(partners) / _square_apart(partners, dot(apart, apart))
        return turn(state, [angle * (x + y) for x, y in zip(state, other, strict=True)])


class PlaneVortices(AbstractLiePoissonSystem):
    """Point vortices z_i = x_i + iy_i in the plane: μ_i = (y_i, x_i, 1/Γ_i) on n copies of the dual of Heisenberg(1).

    H = −(1/2π) Σ_{i<j} Γ_i Γ_j ln|z_i − z_j|, so that ż_i = (i/2π) Σ_j Γ_j (z_i − z_j)/|z_i − z_j|². States are μ
    (…, n, 3), made by ``pack``. Two vortices alone turn about their centre, or move straight where Γ_i + Γ_j = 0; the
    flows are rounds of disjoint pairs, each of which moves so. ``Splitting`` keeps ΣΓz and ΣΓ|z|² to rounding.

    Args:
        strengths: (n,) circulations Γ [m²/s], none of them zero, n ≥ 2.

    Raises:
        InvalidInput: for fewer than two strengths, or one that is zero or not finite.

    Source: Kirchhoff, *Vorlesungen über mathematische Physik*, 20; Aref, Annu. Rev. Fluid Mech. 15 (1983) 345.

    >>> pair = PlaneVortices((1.0, -1.0))
    >>> state = pair.pack([[0.0, 0.5], [0.0, -0.5]])
    >>> (2.0 * np.pi * pair.vector_field(0.0, state))[:, 1].round(9).tolist()
    [1.0, 1.0]
    """

    kind: ClassVar[str] = "point-vortices"
    title: ClassVar[str] = "Point vortices in the plane"
    algebra: Power
    strengths: Float64[Array, "n"]

    @known_numbers_only
    def __init__(self, strengths: Real[ArrayLike, "n"]) -> None:
        self.strengths = _checked_strengths(strengths)
        self.algebra = Power(Heisenberg(1), len(self.strengths))

    def pack(self, positions: Real[ArrayLike, "*batch n 2"]) -> Float64[Array, "*batch n 3"]:
        """Return states from positions (…, n, 2) [m].

        Raises:
            InvalidInput: for numbers that are not finite.
        """
        places = jnp.asarray(check.array("positions", positions, None, "m", traced=True))
        levels = jnp.broadcast_to(1.0 / self.strengths, places.shape[:-1])
        return jnp.stack([places[..., 1], places[..., 0], levels], axis=-1)

    @compiled_for_few_calls
    def positions(self, point: Real[ArrayLike, "*batch n 3"]) -> Float64[Array, "*batch n 2"]:
        """Return the positions (…, n, 2) [m] of the vortices."""
        return jnp.asarray(point)[..., 1::-1]

    @compiled_for_few_calls
    def stream_function(
        self, point: Real[ArrayLike, "n 3"], places: Real[ArrayLike, "*places 2"]
    ) -> Float64[Array, "*places"]:
        """Return ψ = (1/2π) Σ Γ_j ln|z − z_j| (…) [m²/s]: the fluid at z moves by (−∂ψ/∂y, ∂ψ/∂x).

        Args:
            point: (n, 3) a state.
            places: (…, 2) [m]; at a vortex ψ is infinite.
        """
        apart = jnp.asarray(places)[..., None, :] - self.positions(point)
        return 0.5 * HALF_TURN * jnp.sum(self.strengths * jnp.log(jnp.sum(apart * apart, axis=-1)), axis=-1)

    def scales(self, state: Double[Array, "..."]) -> Float64[Array, "..."]:
        """Return the size of the positions, and that of 1/Γ, which may be many powers of ten apart."""
        sizes = [jnp.max(jnp.abs(part), initial=0.0) for part in (state[..., :2], state[..., 2:])]
        return jnp.stack([jnp.where(size > 0.0, size, 1.0) for size in (sizes[0], *sizes)])

    def polygon(self, radius: Real[ArrayLike, ""]) -> Float64[Array, "n 3"]:
        """Return the state (n, 3) of vortices at the corners of a regular polygon about the origin.

        Args:
            radius: R [m], of the circle through them. With equal strengths Γ it turns at (n − 1) Γ/(4πR²) [rad/s].
        """
        require_doubles(radius=radius)
        azimuth = 2.0 * np.pi * np.arange(len(self.strengths)) / len(self.strengths)
        return self.pack(radius * np.stack([np.cos(azimuth), np.sin(azimuth)], axis=-1))

    @known_numbers_only
    def check_state(self, state: Real[ArrayLike, "*shape"]) -> Double[Array, "*shape"]:
        state = super().check_state(state)
        off = np.abs(np.asarray(state)[..., 2] * np.asarray(self.strengths) - 1.0)
        if off.max(initial=0.0) > LIMITS.max_orbit_error:
            raise InvalidInput(
                f"`state` must have 1/Γ of each vortex behind its y and x; one is off by {off.max():.3g}. Make it by "
                "`vortices.pack(positions)`."
            )
        _check_apart(np.asarray(state)[..., :2])
        return state

    @property
    def quantities(self) -> dict[str, Quantity]:
        return super().quantities | {"energy": Quantity("m4 s-2", "interaction energy, per density and depth")}

    def energy(self, point: Float64[Array, "*batch n 3"]) -> Float64[Array, "*batch"]:
        return _pair_energy(self.strengths, jnp.asarray(point)[..., :2])

    def velocity(self, point: Float64[Array, "*batch n 3"]) -> Float64[Array, "*batch n 3"]:
        pulled = -HALF_TURN * self.strengths[:, None] * _pulls(self.strengths, jnp.asarray(point)[..., :2])
        return jnp.concatenate([pulled, jnp.zeros_like(pulled[..., :1])], axis=-1)

    @property
    def extra_invariants(self) -> dict[str, Function]:
        """ΣΓx, ΣΓy and ΣΓ|z|², with Γ = 1/γ of the state."""
        return {
            "impulse ΣΓx": lambda point: jnp.sum(point[..., 1] / point[..., 2], axis=-1),
            "impulse ΣΓy": lambda point: jnp.sum(point[..., 0] / point[..., 2], axis=-1),
            "angular impulse ΣΓ|z|²": lambda point: jnp.sum(
                jnp.sum(point[..., :2] ** 2, axis=-1) / point[..., 2], axis=-1
            ),
        }

    @property
    def flows(self) -> dict[str, Flow]:
        count = len(rounds_of_pairs(len(self.strengths)))
        return {f"pairs, round {k + 1}": Round(self._turn_pairs, k) for k in range(count)}

    def _turn_pairs(self, number: Integer[Array, ""], time: Array, state: Components) -> Components:
        partners = jnp.asarray(np.stack(rounds_of_pairs(len(self.strengths))))[number]
        y, x, level = state
        # ż_i = (iΓ_j/2πd²)(z_i − z_j), so that z_i − z_j turns at (Γ_i + Γ_j)/(2πd²)
        dy, dx = y - y[..., partners], x - x[..., partners]
        product = self.strengths * self.strengths[partners]
        own, other = level * product, level[..., partners] * product  # Γ_j and Γ_i where the levels are 1/Γ
        share = HALF_TURN * time * _active(partners) / _square_apart(partners, dx * dx + dy * dy)
        half = 0.5 * (own + other) * share
        # (e^{2i half} − 1)/(own + other) = i share e^{i half} sin(half)/half, regular where strengths add up to zero
        size = own * share * jnp.sinc(half / np.pi)
        sine, cosine = jnp.sin(half), jnp.cos(half)
        return size * (cosine * dx - sine * dy), -size * (cosine * dy + sine * dx), jnp.zeros_like(level)


def _total(k: int, point: Array) -> Array:
    return jnp.sum(point[..., k], axis=-1)


# ------------------------------------------------------------------ pairs


def rounds_of_pairs(count: int) -> list[np.ndarray]:
    """Return rounds (count,) of partners: in each round a vortex has one or rests, and every pair meets once.

    A vortex that rests is its own partner.
    """
    seats = list(range(count)) + [-1] * (count % 2)
    rounds, size = [], len(seats)
    for _ in range(size - 1):
        partners = np.arange(count)
        for one, other in zip(seats[: size // 2], seats[: size // 2 - 1 : -1], strict=True):
            if one >= 0 and other >= 0:
                partners[one], partners[other] = other, one
        rounds.append(partners)
        # the circle method of tournaments: all but the first seat move on by one
        seats = [seats[0], seats[-1], *seats[1:-1]]
    return rounds


def _active(partners: Integer[Array, "n"]) -> Float64[Array, "n"]:
    """Return 1 where a vortex has a partner, 0 where it rests."""
    return (partners != np.arange(len(partners))).astype(float)


def _square_apart(partners: Integer[Array, "n"], square: Float64[Array, "*batch n"]) -> Float64[Array, "*batch n"]:
    """Return squared distances to the partners, and 1 for vortices that rest."""
    return jnp.where(_active(partners) > 0, square, 1.0)


@compiled_for_few_calls
def _pair_energy(strengths: Float64[Array, "n"], places: Float64[Array, "*batch n k"]) -> Float64[Array, "*batch"]:
    """Return −(1/4π) Σ_{i<j} Γ_i Γ_j ln|x_i − x_j|² (…)."""
    _, square = _differences(places)
    # the sum over all i, j counts every pair twice
    products = strengths[:, None] * strengths[None, :]
    return -0.25 * HALF_TURN * jnp.sum(products * jnp.log(square), axis=(-2, -1))


@compiled_for_few_calls
def _pulls(strengths: Float64[Array, "n"], places: Float64[Array, "*batch n k"]) -> Float64[Array, "*batch n k"]:
    """Return Σ_j Γ_j (x_i − x_j)/|x_i − x_j|² (…, n, k)."""
    apart, square = _differences(places)
    return jnp.sum(strengths[:, None] * apart / square[..., None], axis=-2)


def _differences(places: Array) -> tuple[Array, Array]:
    """Return x_i − x_j (…, n, n, k) and their squares, 1 on the diagonal."""
    apart = places[..., :, None, :] - places[..., None, :, :]
    return apart, jnp.sum(apart * apart, axis=-1) + jnp.eye(places.shape[-2])


def _checked_strengths(strengths: Real[ArrayLike, "n"]) -> Float64[Array, "n"]:
    """Return at least two finite strengths other than zero.

    Raises:
        InvalidInput: otherwise.
    """
    require_doubles(strengths=strengths)
    values = np.asarray(strengths, dtype=float)
    if values.ndim != 1 or len(values) < 2 or not np.isfinite(values).all() or not values.all():
        check.refuse("strengths", "at least two finite numbers other than zero (n,)", strengths)
    return jnp.asarray(values)


def _check_apart(places: Float64[np.ndarray, "*batch n k"]) -> None:
    """Refuse vortices at one place.

    Raises:
        InvalidInput: where two are.
    """
    count = places.shape[-2]
    for step in range(1, count):
        same = (places[..., step:, :] == places[..., :-step, :]).all(axis=-1)
        if same.any():
            first = int(np.argwhere(same)[0][-1])
            raise InvalidInput(
                f"`state` must have every vortex at a place of its own; vortices {first} and {first + step}, counted "
                "from 0, are at one. Move one of them, or give one vortex their sum."
            )
