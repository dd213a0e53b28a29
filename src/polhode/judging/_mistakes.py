"""Mistakes of engines in conventions and equations, each given as the convention or equations used instead."""

from __future__ import annotations

from dataclasses import dataclass, replace
from itertools import combinations
from math import pi

import numpy as np
from scipy.integrate import solve_ivp

from polhode import rotation
from polhode.errors import InvalidInput, NotConverged, shown
from polhode.types import Array, Float64

VARIABLES, AXES = ("momentum", "angular velocity"), ("body", "space")


@dataclass(frozen=True)
class StateConvention:
    """How an engine writes attitude and rate.

    Attributes:
        variable: "momentum" L [kg m²/s] or "angular velocity" ω [rad/s].
        axes: "body" or "space", which its components are along.
        scalar_last: whether quaternions are xyzw.
        inverse: whether quaternions take space to body.
        degrees: whether the rate counts degrees for radians.

    Raises:
        InvalidInput: for other variables or axes.
    """

    variable: str = "momentum"
    axes: str = "body"
    scalar_last: bool = False
    inverse: bool = False
    degrees: bool = False

    def __post_init__(self) -> None:
        for name, known in (("variable", VARIABLES), ("axes", AXES)):
            if getattr(self, name) not in known:
                raise InvalidInput(f"`{name}` must be {' or '.join(known)}; got {shown(getattr(self, name))}.")

    def encode(
        self, attitude: Float64[Array, "*batch 4"], momentum: Float64[Array, "*batch 3"], inertia: Float64[Array, "3 3"]
    ) -> tuple[Float64[Array, "*batch 4"], Float64[Array, "*batch 3"]]:
        """Return quaternion (…, 4) and rate (…, 3) as the engine writes them.

        Args:
            attitude: (…, 4) unit quaternion wxyz, body → space.
            momentum: (…, 3) [kg m²/s, body axes].
            inertia: (3, 3) [kg m², body axes].
        """
        rate = momentum if self.variable == "momentum" else np.linalg.solve(inertia, momentum[..., None])[..., 0]
        rate = rotation.rotate(attitude, rate) if self.axes == "space" else rate
        q = rotation.conjugate(attitude) if self.inverse else attitude
        q = np.roll(q, -1, axis=-1) if self.scalar_last else q
        return np.asarray(q), np.asarray(rate) * (180.0 / pi if self.degrees else 1.0)

    def decode(
        self, quaternion: Float64[Array, "*batch 4"], rate: Float64[Array, "*batch 3"], inertia: Float64[Array, "3 3"]
    ) -> tuple[Float64[Array, "*batch 4"], Float64[Array, "*batch 3"]]:
        """Return attitude (…, 4), normalized, and momentum (…, 3, body axes) from the engine's numbers."""
        q = np.roll(quaternion, 1, axis=-1) if self.scalar_last else np.asarray(quaternion)
        q = q / np.linalg.norm(q, axis=-1, keepdims=True)
        q = q * np.array([1.0, -1.0, -1.0, -1.0]) if self.inverse else q
        rate = np.asarray(rate) * (pi / 180.0 if self.degrees else 1.0)
        rate = rotation.rotate(q * np.array([1.0, -1.0, -1.0, -1.0]), rate) if self.axes == "space" else rate
        return q, rate if self.variable == "momentum" else np.einsum("ij,...j->...i", inertia, rate)


@dataclass(frozen=True)
class EngineEquations:
    """The equations that an engine solves, by default the right ones: L̇ = g L × ω − c L, q̇ = f q (0, ω)/2.

    Attributes:
        gyroscopic: g.
        factor: f.
        in_space: whether q̇ = f (0, ω) q/2, as if body rates were along space axes.
        damping: c [1/s].
        frozen: whether L stays in space while ω = I⁻¹L is constant in space, as if the inertia did not rotate.
        along_space: what the engine writes, "momentum" or "angular velocity", if it uses the body's inertia along space
            axes: L̇ = g L × ω and q̇ = (0, ω) q/2 with all components in space. Empty if it does not.
    """

    gyroscopic: float = 1.0
    factor: float = 1.0
    in_space: bool = False
    damping: float = 0.0
    frozen: bool = False
    along_space: str = ""

    def solve(
        self, inertia: Float64[Array, "3 3"], attitude: Float64[Array, "4"], momentum: Float64[Array, "3"],
        times: Float64[Array, "time"],
    ) -> tuple[Float64[Array, "time 4"], Float64[Array, "time 3"]]:
        """Return attitudes (T, 4) and momenta (T, 3, body axes) at rising times (T,), the first that of the start [s].

        By Dormand and Prince's method of order 8 with a tolerance of 1e-12.

        Raises:
            NotConverged: where the equations cannot be followed.
        """
        inverse = np.linalg.inv(inertia)
        size = float(np.linalg.norm(momentum)) or 1.0
        if self.frozen:
            spin = np.outer(times - times[0], inverse @ momentum)
            q = rotation.multiply(attitude, rotation.from_rotation_vector(spin))
            space = rotation.rotate(attitude, momentum)
            return np.asarray(q), np.asarray(rotation.rotate(rotation.conjugate(q), space))

        def slope(_: float, y: Float64[Array, "7"]) -> Float64[Array, "7"]:
            (w, x, y_, z), L = y[:4], y[4:] * size
            omega = inverse @ L
            a, b, c = 0.5 * self.factor * omega
            s = -1.0 if self.in_space or self.along_space else 1.0
            turn = [-x * a - y_ * b - z * c, w * a + s * (y_ * c - z * b), w * b + s * (z * a - x * c),
                    w * c + s * (x * b - y_ * a)]  # fmt: skip
            return np.concatenate([turn, (self.gyroscopic * np.cross(L, omega) - self.damping * L) / size])

        by_rate, first = self.along_space == "angular velocity", momentum
        if self.along_space:
            first = rotation.rotate(attitude, inverse @ momentum if by_rate else momentum)
            first = inertia @ first if by_rate else first
        start = np.concatenate([attitude, first / size])
        done = solve_ivp(slope, (times[0], times[-1]), start, "DOP853", t_eval=times, rtol=1e-12, atol=1e-13)
        if not done.success:
            raise NotConverged(f"the equations could not be followed: {done.message}")
        q, L = done.y[:4].T, done.y[4:].T * size
        q = q / np.linalg.norm(q, axis=-1, keepdims=True)
        if self.along_space:  # as a reader decodes it, who rotates what the engine writes
            L = rotation.rotate(rotation.conjugate(q), L @ inverse if by_rate else L)
            L = L @ inertia if by_rate else L
        return q, np.asarray(L)


def list_convention_mistakes(declared: StateConvention) -> dict[str, StateConvention]:
    """Return conventions that an engine may use instead of the declared one, by name: single mistakes, then pairs."""
    other = {"momentum": "angular velocity", "angular velocity": "momentum"}[declared.variable]
    elsewhere = {"body": "space", "space": "body"}[declared.axes]
    symbols = {"momentum": "L", "angular velocity": "ω"}
    single = {
        f"{symbols[other]} given for {symbols[declared.variable]}": {"variable": other},
        "quaternion xyzw for wxyz": {"scalar_last": True},
        "inverse rotation (space to body for body to space)": {"inverse": True},
        f"rate along {elsewhere} axes for {declared.axes} axes": {"axes": elsewhere},
        "degrees for radians": {"degrees": True},
    }
    pairs = {f"{a} and {b}": {**single[a], **single[b]} for a, b in combinations(single, 2)}
    return {name: replace(declared, **change) for name, change in {**single, **pairs}.items()}


def list_equation_mistakes(
    variable: str, attitude: Float64[Array, "4"], damping: float = 0.0
) -> dict[str, EngineEquations]:
    """Return wrong equations that engines solve, each under its name in words.

    Args:
        variable: which an engine writes, see ``StateConvention``.
        attitude: (4,) of the start; if it is the identity, two of the mistakes give equal states.
        damping: rate at which |L| decays in the engine [1/s]; 0 leaves damping out.
    """
    kept = EngineEquations(gyroscopic=0.0, along_space=variable)
    equations = {
        "gyroscopic term missing: ω constant along body axes": EngineEquations(gyroscopic=0.0),
        "inertia not turned with the body: ω constant while L is": EngineEquations(frozen=True),
        "inertia not turned with the body: used along space axes": kept,
        "inertia not turned with the body: Euler's equations along space axes": replace(kept, gyroscopic=1.0),
        "gyroscopic term with the wrong sign": EngineEquations(gyroscopic=-1.0),
        "factor ½ missing in the quaternion's rate": EngineEquations(factor=2.0),
        "factor ½ twice in the quaternion's rate": EngineEquations(factor=0.5),
        "rates along body axes turn the attitude as if along space axes": EngineEquations(in_space=True),
    }
    if variable == "angular velocity":  # equal moments give just such states
        first, *others = equations.items()
        equations = {"gyroscopic term missing, or one moment for all axes: ω constant along body axes": first[1],
                     **dict(others)}  # fmt: skip
    # where the engine writes ω, it stays along body axes as well
    rounding = 1e-9  # of the scalar part of the identity
    if variable == "angular velocity" or abs(attitude[0]) > 1.0 - rounding:
        equations = {name: one for name, one in equations.items() if one is not kept}
    if damping:
        equations[f"angular damping: L decays by {damping:.4g} of itself a second"] = EngineEquations(damping=damping)
    return equations
