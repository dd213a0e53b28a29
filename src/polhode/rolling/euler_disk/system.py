"""A disk that rolls without slipping on a horizontal plane, thick or thin, until it lies flat: Euler's disk."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import ClassVar

import jax
import jax.numpy as jnp
import numpy as np

from polhode import rotation
from polhode._base import check
from polhode._base.arrays import compiled_for_few_calls, known_numbers_only, require_doubles
from polhode.bodies._pivot import STANDARD_GRAVITY
from polhode.errors import InvalidInput, shown
from polhode.motion._layout import StateLayout, StatePart
from polhode.rolling.euler_disk._mechanics import LIMITS, RollingMechanics, check_size
from polhode.rolling.euler_disk._steady_motion import WITHOUT_DISSIPATION, differentiate_rolling
from polhode.rolling.euler_disk.dissipation import RollingDissipation, couples, slow_push
from polhode.special._legendre import LegendreFunction, legendre_function
from polhode.systems._checks import as_finite_state
from polhode.systems.base import AbstractSystem, Balance, Event, Vectors
from polhode.systems.steady_motion import SteadyMotion
from polhode.types import Array, ArrayLike, Float64, Real

States = Float64[Array, "*batch 8"]

LAYOUT = StateLayout((
    StatePart("tilt", 1, "rad", "angle between face and plane"),
    StatePart("heading", 1, "rad", "direction of the horizontal diameter"),
    StatePart("face", 1, "rad", "turn of what is printed on the face"),
    StatePart("contact_x", 1, "m", "point of contact"),
    StatePart("contact_y", 1, "m", "point of contact"),
    StatePart("tilt_rate", 1, "rad s-1", "angular velocity about the horizontal diameter"),
    StatePart("rise_rate", 1, "rad s-1", "angular velocity about the diameter up the face"),
    StatePart("spin", 1, "rad s-1", "angular velocity about the disk's axis"),
))  # fmt: skip


class EulerDisk(AbstractSystem):
    """Rolling of a disk or a flat cylinder on a plane, without slipping, under any sum of laws of dissipation.

    State (…, 8): (θ, φ, χ, X, Y, ω1, ω2, ω3). θ is the angle between the disk's face and the plane, φ the heading of
    the horizontal diameter, χ = φ + ψ the turn of what is printed on the face, (X, Y) the point of contact, ω1 = θ̇,
    ω2 = φ̇ sin θ, ω3 = ψ̇ + φ̇ cos θ along e1 (horizontal), e2 (up the face from the contact) and e3 (the axis). The
    attitude is Rz(φ) Rx(θ) Rz(ψ). These angles are singular only where the disk lies flat and no rim touches: there
    the motion ends anyway, and near it θ and χ keep their relative accuracy, which a quaternion's components lose.

    The equations of motion are in ``_mechanics``, the laws of dissipation in ``dissipation``.

    Args:
        mass: m [kg].
        radius: a [m].
        thickness: 2b [m]; zero is the thin disk, which may also stand upright.
        axial_moment: C [kg m²]; by default that of a uniform cylinder.
        diametral_moment: A [kg m²], about a diameter through the centre; by default likewise.
        gravity: g [m/s²].
        dissipation: laws of ``polhode.rolling.euler_disk.dissipation``, whose powers add up.

    Raises:
        InvalidInput: for sizes that are not positive, a disk thicker than it is wide, moments that no disk has.

    >>> from polhode.rolling import RollingCouple
    >>> disk = EulerDisk(mass=0.4, radius=0.04, dissipation=[RollingCouple(1e-5)])
    >>> start = disk.rolling_state(tilt=0.1)
    >>> print(f"{float(disk.precession(start)):.4f} rad/s, {float(disk.normal_force(start)):.4f} N")
    99.1111 rad/s, 3.9227 N

    Source: O'Reilly, Nonlinear Dyn. 10 (1996) 287; Le Saux, Leine & Glocker, J. Nonlinear Sci. 15 (2005) 27.
    """

    kind: ClassVar[str] = "euler-disk"
    title: ClassVar[str] = "Euler's disk"
    has_vertical: ClassVar[bool] = True
    mechanics: RollingMechanics
    dissipation: tuple[RollingDissipation, ...]
    legendre: LegendreFunction | None

    @known_numbers_only
    def __init__(
        self,
        mass: float,
        radius: float,
        thickness: float = 0.0,
        axial_moment: float | None = None,
        diametral_moment: float | None = None,
        gravity: float = STANDARD_GRAVITY,
        dissipation: Sequence[RollingDissipation] | RollingDissipation = (),
    ) -> None:
        m, a, g = (_positive(*x) for x in (("mass", mass, "kg"), ("radius", radius, "m"), ("gravity", gravity, "m/s²")))
        for name, value, unit in (("mass", m, "kg"), ("radius", a, "m"), ("gravity", g, "m/s²")):
            check_size(name, value, unit, LIMITS.max_size)
        remedy = "A disk is not thicker than wide: check whether it is half of it, or in millimetres."
        rule = f"from 0 to the diameter {2.0 * a:.6g}"
        h = check.number("thickness", thickness, "m", least=0, most=2.0 * a, rule=rule, remedy=remedy)
        C = 0.5 * m * a * a if axial_moment is None else _positive("axial_moment", axial_moment, "kg m²")
        uniform = m * (a * a / 4.0 + h * h / 12.0)
        A = uniform if diametral_moment is None else _positive("diametral_moment", diametral_moment, "kg m²")
        for name, value in (("axial_moment", C), ("diametral_moment", A)):
            check_size(name, value, "kg m²", LIMITS.max_size**3)
        if C > 2.0 * A * (1.0 + 1e-12):
            raise InvalidInput(
                f"`axial_moment` must be at most twice `diametral_moment`; got {C:.6g} and {A:.6g} kg m². "
                "No body has these; check units and order."
            )
        laws = (dissipation,) if isinstance(dissipation, RollingDissipation) else tuple(dissipation)
        if not all(isinstance(law, RollingDissipation) for law in laws):
            check.refuse("dissipation", "laws such as polhode.rolling.AirLayer(1.8e-5)", dissipation)
        self.mechanics = RollingMechanics(*(jnp.asarray(np.float64(x)) for x in (m, a, 0.5 * h, A, C, g)))
        self.dissipation = laws
        self.legendre = _as_jax(legendre_function(m * a * a * C / (A * (C + m * a * a)))) if h == 0.0 else None

    @property
    def is_thin(self) -> bool:
        """Whether the thickness is zero."""
        return self.legendre is not None

    # ------------------------------------------------------------------ motion

    def vector_field(self, t: Real[ArrayLike, "..."], state: States) -> States:
        disk = self.mechanics
        a, phi = disk.radius, LAYOUT.part(state, "heading")
        theta, w1, w2, w3 = rolling_parts(state)
        s, c = jnp.sin(theta), jnp.cos(theta)
        # Ẋ = −aψ̇ e1: the contact point goes round the rim at ψ̇ = ω3 − φ̇ cos θ, and along the plane by as much
        precession = w2 / s
        along_rim = w3 - precession * c
        push2, push3 = disk.accelerations(*couples(disk, self.dissipation, theta, w2, w3))
        d2, d3 = disk.transport(theta, w2, w3)
        rates = (
            w1, precession, self.face_rate(state), -a * along_rim * jnp.cos(phi), -a * along_rim * jnp.sin(phi),
            disk.tilt_acceleration(theta, w2, w3), d2 * w1 + push2, d3 * w1 + push3,
        )  # fmt: skip
        return jnp.stack(rates, axis=-1)

    # ------------------------------------------------------------------ what a state means

    @compiled_for_few_calls
    def energy(self, state: States) -> Float64[Array, "*batch"]:
        """Return kinetic and potential energy [J], above that of the disk lying flat."""
        return self.mechanics.energy(*rolling_parts(state))

    @compiled_for_few_calls
    def power(self, state: States) -> Float64[Array, "*batch"]:
        """Return the rate [W] at which the laws of dissipation take energy away."""
        theta, _, w2, w3 = rolling_parts(state)
        tau2, tau3 = couples(self.mechanics, self.dissipation, theta, w2, w3)
        return -(tau2 * w2 + tau3 * w3)

    @compiled_for_few_calls
    def precession(self, state: States) -> Float64[Array, "*batch"]:
        """Return φ̇ [rad/s], at which the horizontal diameter and the contact point go round."""
        return LAYOUT.part(state, "rise_rate") / jnp.sin(LAYOUT.part(state, "tilt"))

    @compiled_for_few_calls
    def face_rate(self, state: States) -> Float64[Array, "*batch"]:
        """Return χ̇ = ω3 + φ̇ (1 − cos θ) [rad/s], at which what is printed on the face turns."""
        slant = jnp.sin(0.5 * LAYOUT.part(state, "tilt"))
        return LAYOUT.part(state, "spin") + 2.0 * self.precession(state) * slant**2

    @compiled_for_few_calls
    def powers(self, state: States) -> Float64[Array, "*batch laws"]:
        """Return the power of each law (…, laws) [W] at the tilt towards the table and the rate of precession.

        Their sum is ``power`` unless the couple of a law is capped, see ``couples``.
        """
        tilt = LAYOUT.part(jnp.asarray(state), "tilt")
        tilt, rate = jnp.minimum(tilt, jnp.pi - tilt), jnp.abs(self.precession(state))
        powers = [jnp.broadcast_to(law.power(self.mechanics, tilt, rate), tilt.shape) for law in self.dissipation]
        return jnp.stack(powers, axis=-1) if powers else jnp.zeros((*tilt.shape, 0))

    @compiled_for_few_calls
    def normal_force(self, state: States) -> Float64[Array, "*batch"]:
        """Return the force [N] with which the plane pushes upwards."""
        return self.mechanics.normal_force(*rolling_parts(state))

    @compiled_for_few_calls
    def center(self, state: States) -> Float64[Array, "*batch 3"]:
        """Return the centre of mass (…, 3) [m, space]."""
        _, e2, e3 = _frame(state)
        x, y = LAYOUT.part(state, "contact_x"), LAYOUT.part(state, "contact_y")
        contact = jnp.stack([x, y, jnp.zeros_like(x)], axis=-1)
        return contact + self.mechanics.radius * e2 + self.mechanics.half_thickness * e3

    @compiled_for_few_calls
    def center_velocity(self, state: States) -> Float64[Array, "*batch 3"]:
        """Return the velocity (…, 3) [m/s, space] at which the centre moves if the disk rolls."""
        e1, e2, e3 = _frame(state)
        a, b = self.mechanics.radius, self.mechanics.half_thickness
        w1, w2, w3 = (rate[..., None] for rate in rolling_parts(state)[1:])
        return (b * w2 - a * w3) * e1 - b * w1 * e2 + a * w1 * e3

    @compiled_for_few_calls
    def vectors(self, state: States) -> Vectors:
        state = jnp.asarray(state)
        theta, w1, w2, w3 = rolling_parts(state)
        phi, face = LAYOUT.part(state, "heading"), LAYOUT.part(state, "face")
        s, c = jnp.sin(0.5 * theta), jnp.cos(0.5 * theta)
        half, other = 0.5 * face, phi - 0.5 * face
        # Rz(φ) Rx(θ) Rz(ψ) = (c cos ½(φ+ψ), s cos ½(φ−ψ), s sin ½(φ−ψ), c sin ½(φ+ψ)), with ½(φ+ψ) = χ/2
        parts = (c * jnp.cos(half), s * jnp.cos(other), s * jnp.sin(other), c * jnp.sin(half))
        psi = face - phi
        x, y = jnp.cos(psi) * w1 + jnp.sin(psi) * w2, jnp.cos(psi) * w2 - jnp.sin(psi) * w1
        A, C = self.mechanics.diametral_moment, self.mechanics.axial_moment
        momentum = jnp.stack([A * x, A * y, C * w3], axis=-1)
        return Vectors(jnp.stack(parts, axis=-1), momentum, jnp.stack([x, y, w3], axis=-1))

    def invariants(self, state: States) -> dict[str, Float64[Array, "*batch"]]:
        """Return the energy and, of a thin disk, the two linear integrals [rad/s]; with dissipation none of them."""
        if self.dissipation:
            return {}
        values = {"energy": self.energy(state)}
        if self.legendre is not None:
            first, second = self.linear_integrals(state)
            values |= {"linear_integral_1": first, "linear_integral_2": second}
        return values

    def linear_integrals(self, state: States) -> tuple[Float64[Array, "*batch"], Float64[Array, "*batch"]]:
        """Return c1, c2 of ω3 = c1 P_ν(cos θ) + c2 P_ν(−cos θ) [rad/s], ν(ν+1) = −ma²C/[A(C+ma²)], of a thin disk.

        Source: Appell, Rend. Circ. Mat. Palermo 14 (1900) 1; Korteweg, ibid. 14 (1900) 7.
        """
        (first, second), (third, fourth) = self._linear_terms(state)
        return first + second, third + fourth

    def invariant_sizes(self, state: States) -> dict[str, Float64[Array, "*batch"]]:
        """Return the sizes of both terms of the linear integrals; derivatives of Legendre functions cost more."""
        if self.dissipation or self.legendre is None:
            return {}
        sizes = (jnp.abs(first) + jnp.abs(second) for first, second in self._linear_terms(state))
        return dict(zip(("linear_integral_1", "linear_integral_2"), sizes, strict=True))

    def _linear_terms(self, state: States) -> tuple[tuple[Array, Array], tuple[Array, Array]]:
        if self.legendre is None:
            raise InvalidInput("linear integrals are Legendre functions of a thin disk only: `thickness` must be 0.")
        theta, _, w2, w3 = rolling_parts(state)
        return self.mechanics.linear_terms(self.legendre, theta, w2, w3)

    def balances(self, t: Real[ArrayLike, "..."], state: States) -> dict[str, Balance]:
        return {"energy": Balance(self.energy(state), -self.power(state))} if self.dissipation else {}

    @known_numbers_only
    def steady_motion(self, state: Real[ArrayLike, "8"]) -> SteadyMotion:
        """Return the derivatives that decide on a steady motion, in its tilt and rates; heading and place drift.

        Raises:
            InvalidInput: for a disk with dissipation, which has no steady motion, or a state that is not steady.
        """
        if self.dissipation:
            raise InvalidInput(WITHOUT_DISSIPATION)
        return differentiate_rolling(self.mechanics, rolling_parts(self.check_state(state)))

    @property
    def events(self) -> dict[str, Event]:
        """The disk lies flat, leaves the plane or, if thick, stands on its edge along a line."""
        weight = self.mechanics.mass * self.mechanics.gravity
        ends: dict[str, Event] = {
            "flat": lambda t, state: jnp.sin(LAYOUT.part(state, "tilt")) - LIMITS.flat_sine,
            "lift-off": lambda t, state: self.normal_force(state) / weight,
        }
        edge: dict[str, Event] = {"on edge": lambda t, state: jnp.cos(LAYOUT.part(state, "tilt"))}
        return ends if self.is_thin else ends | edge

    def layout(self, state: States) -> StateLayout:
        return LAYOUT

    # ------------------------------------------------------------------ where to start

    @known_numbers_only
    def check_state(self, state: Real[ArrayLike, "*shape"]) -> Float64[Array, "*shape"]:
        """Return a state as an array.

        Raises:
            InvalidInput: for a wrong shape, and for tilts at which the disk does not touch with one point of its rim.
        """
        state = jnp.asarray(as_finite_state(state, float))
        if jnp.shape(state)[-1:] != (8,):
            raise InvalidInput(
                f"`state` of EulerDisk must have shape (…, 8): θ, φ, χ, X, Y, ω1, ω2, ω3; got {jnp.shape(state)}. "
                "Make it by `state` or `rolling_state`."
            )
        self._check_tilt(LAYOUT.part(np.asarray(state), "tilt"))
        return state

    def scales(self, state: States) -> Float64[Array, "8"]:
        a = self.mechanics.radius
        rate = jnp.sqrt(self.mechanics.gravity / a)
        return jnp.stack([jnp.ones_like(a)] * 3 + [a] * 2 + [rate] * 3)

    @known_numbers_only
    def pack(
        self,
        attitude: Real[ArrayLike, "4"],
        angular_velocity: Real[ArrayLike, "3"],
        contact: Real[ArrayLike, "2"] = (0.0, 0.0),
        center_velocity: Real[ArrayLike, "3"] | None = None,
    ) -> Float64[Array, "8"]:
        """Return the state (8,) of a disk that rolls at an attitude with an angular velocity.

        Args:
            attitude: (4,) unit quaternion wxyz, body → space; the body's third axis is the disk's.
            angular_velocity: (3,) [rad/s, body axes].
            contact: (2,) where it touches [m].
            center_velocity: (3,) of the centre [m/s, space], if known; it follows from rolling and is checked.

        Raises:
            InvalidInput: for a disk that lies flat or on the wrong rim, or a velocity that does not roll.
        """
        require_doubles(attitude=attitude)
        w, x, y, z = (float(k) for k in np.asarray(rotation.normalize(np.asarray(attitude, dtype=float))))
        theta = 2.0 * math.atan2(math.hypot(x, y), math.hypot(w, z))
        self._check_tilt(np.asarray(theta))
        face, difference = 2.0 * math.atan2(z, w), 2.0 * math.atan2(y, x)
        phi = 0.5 * (face + difference)
        psi = face - phi
        o1, o2, o3 = (float(k) for k in as_finite_state(angular_velocity, float))
        w1, w2 = math.cos(psi) * o1 - math.sin(psi) * o2, math.sin(psi) * o1 + math.cos(psi) * o2
        X, Y = (float(k) for k in as_finite_state(contact, float))
        state = self.check_state([theta, phi, face, X, Y, w1, w2, o3])
        if center_velocity is not None:
            self._check_rolling(state, np.asarray(as_finite_state(center_velocity, float)))
        return state

    @known_numbers_only
    def state(
        self, tilt: float, tilt_rate: float, precession: float, spin: float, heading: float = 0.0, face: float = 0.0,
        contact: Real[ArrayLike, "2"] = (0.0, 0.0),
    ) -> Float64[Array, "8"]:
        """Return the state (8,) of a disk that rolls with any rates, steady or not: θ̇, φ̇ and ω3 [rad/s].

        Args as of ``rolling_state``.

        Raises:
            InvalidInput: for tilts at which the disk does not touch with one point of its rim.
        """
        return self.check_state([tilt, heading, face, *contact, tilt_rate, precession * math.sin(tilt), spin])

    @known_numbers_only
    def rolling_state(
        self,
        tilt: float,
        precession: float | None = None,
        spin: float | None = None,
        heading: float = 0.0,
        face: float = 0.0,
        contact: Real[ArrayLike, "2"] = (0.0, 0.0),
    ) -> Float64[Array, "8"]:
        """Return a steady motion (8,) or, with dissipation, its place on the slow manifold, where no nutation rings.

        Args:
            tilt: θ [rad].
            precession: φ̇ [rad/s]; the spin then follows. By default that at which the centre is at rest.
            spin: ω3 [rad/s]; needed only where it does not follow, as for straight rolling, and checked elsewhere.
            heading: φ [rad].
            face: χ [rad].
            contact: (2,) [m].

        Raises:
            InvalidInput: for tilts without steady motion, rates that are not steady, and a disk that would fall.
        """
        self._check_tilt(np.asarray(tilt))
        disk, theta = self.mechanics, jnp.asarray(np.float64(tilt))
        given = [None if rate is None else np.float64(rate) for rate in (precession, spin)]
        found = disk.steady_rates(theta, *given)
        if precession is None and not (np.isfinite(found[0]) and found[0] > 0.0):
            raise InvalidInput(f"no steady motion has its centre at rest at tilt {shown(tilt)} rad. Give `precession`.")
        precession, spin = map(float, found)
        if not math.isfinite(spin):
            raise InvalidInput("`spin` must be given where nothing precesses, as in straight rolling.")
        w2 = precession * math.sin(tilt)
        left = float(disk.tilt_acceleration(theta, jnp.asarray(w2), jnp.asarray(spin)))
        size = float(disk.gravity) / float(disk.radius) + w2 * w2 + spin * spin
        if not abs(left) <= LIMITS.relative_tilt_acceleration * size:
            raise InvalidInput(
                f"tilt {shown(tilt)} rad, `precession` {shown(precession)} and `spin` {shown(spin)} rad/s are not "
                "steady: the tilt "
                f"would accelerate by {left:.3g} rad/s². Give one of the rates only."
            )
        rate = self._slow_tilt_rate(tilt, w2, spin) if self.dissipation else 0.0
        return self.check_state([tilt, heading, face, *map(float, contact), rate, w2, spin])

    def _slow_tilt_rate(self, tilt: float, w2: float, w3: float) -> float:
        """Return the θ̇ at which the couples keep the motion steady, d(θ̈)/dt = 0, to first order."""
        rates = (jnp.asarray(x) for x in (tilt, w2, w3))
        push, square = (float(x) for x in slow_push(self.mechanics, self.dissipation, *rates))
        if not square > 0.0:
            raise InvalidInput(
                f"the steady motion at tilt {shown(tilt)} rad is unstable: no slow manifold to start on."
            )
        # 0 = d(θ̈)/dt = ∂f/∂ω·push − (nutation)² θ̇
        return push / square

    def _check_tilt(self, theta: np.ndarray) -> None:
        came = shown(np.asarray(theta).tolist())
        if not (np.sin(theta) > LIMITS.flat_sine).all() or not ((theta > 0.0) & (theta < math.pi)).all():
            raise InvalidInput(
                f"the tilt must lie between 1e-6 and π − 1e-6; got {came} rad. A disk that lies flat touches with all "
                "of its face and does not roll: start at a small tilt, such as 0.1 rad."
            )
        if not self.is_thin and not (theta < 0.5 * math.pi).all():
            raise InvalidInput(
                f"the tilt of a thick disk must be less than π/2; got {came} rad. Beyond it rolls on its other rim: "
                "turn it over."
            )

    def _check_rolling(self, state: Array, velocity: np.ndarray) -> None:
        wanted = np.asarray(self.center_velocity(state))
        off, size = np.linalg.norm(velocity - wanted), max(np.linalg.norm(wanted), np.linalg.norm(velocity))
        if off > LIMITS.relative_slip * size:
            wanted, came = wanted.round(6).tolist(), shown(velocity.tolist())
            raise InvalidInput(
                f"`center_velocity` does not roll: the point of contact would slip at {off:.4g} m/s. Rolling with this "
                f"angular velocity takes the centre along at {wanted} m/s; got {came}."
            )


def rolling_parts(state: States) -> tuple[Float64[Array, "*batch"], ...]:
    """Return θ, ω1, ω2, ω3 (…) of states (…, 8), on which the dynamics depend."""
    theta, w1, w2, w3 = (LAYOUT.part(state, name) for name in ("tilt", "tilt_rate", "rise_rate", "spin"))
    return theta, w1, w2, w3


@jax.jit
def _frame(state: Array) -> tuple[Array, Array, Array]:
    """Return e1, e2, e3 (…, 3) in space."""
    theta, phi = LAYOUT.part(state, "tilt"), LAYOUT.part(state, "heading")
    s, c, p, q = jnp.sin(theta), jnp.cos(theta), jnp.sin(phi), jnp.cos(phi)
    rows = ((q, p, jnp.zeros_like(s)), (-c * p, c * q, s), (s * p, -s * q, c))
    e1, e2, e3 = (jnp.stack(row, axis=-1) for row in rows)
    return e1, e2, e3


def _as_jax(function: LegendreFunction) -> LegendreFunction:
    return LegendreFunction(*(jnp.asarray(x) for x in function))


def _positive(name: str, value: float, unit: str) -> float:
    return check.number(name, value, unit, above=0)
