"""Laws of dissipation of a rolling disk: one class for each law that has been proposed; laws can be added.

A law states a power P as a function of the tilt α towards the table and of the rate Ω at which the contact point goes
round. On the slow manifold of a thin disk, E = (3/2) mga α and Ω = √(mga/(Aα)), so that P ∝ α^(−q) gives
α ∝ (t0 − t)^n with n = 1/(1 + q): each law has its own exponent, which is written here alone.

Source: Moffatt, Nature 404 (2000) 833; Bildsten, Phys. Rev. E 66 (2002) 056309; Leine, Arch. Appl. Mech. 79 (2009)
1063.
"""

from __future__ import annotations

import abc
import math
from collections.abc import Sequence
from typing import ClassVar

import equinox as eqx
import jax
import jax.numpy as jnp

from polhode._base import check
from polhode._base.arrays import known_numbers_only
from polhode.rolling.euler_disk._mechanics import RollingMechanics
from polhode.types import Array, ArrayOrFloat, Float64

Operand = Float64[ArrayOrFloat, "*#shape"]


class RollingDissipation(eqx.Module):
    """A law of dissipation.

    Attributes:
        name: of the law in specs and on pages; empty for one that they do not know.
        exponent: n of α ∝ (t0 − t)^n; negative where there is no finite t0 and α ∝ t^n.
        vertical: whether its couple is vertical and brakes the turning of the disk on its contact; otherwise the couple
            is horizontal and brakes the contact point on its way round the rim.
    """

    name: ClassVar[str] = ""
    exponent: eqx.AbstractClassVar[float]
    vertical: eqx.AbstractClassVar[bool]

    @abc.abstractmethod
    def power(self, disk: RollingMechanics, tilt: Operand, precession: Operand) -> Float64[Array, "*shape"]:
        """Return P ≥ 0 [W] at tilt α [rad] and rate of precession Ω ≥ 0 [rad/s], any shape."""


class AirLayer(RollingDissipation):
    """P = πμga²/α²: shear of the air under the disk, laminar through the whole gap; n = 1/3.

    Args:
        viscosity: μ of the air, dynamic [Pa s]; 1.8e-5 at room temperature.

    Source: Moffatt (2000), eq. 4.
    """

    name: ClassVar[str] = "air-layer"
    exponent: ClassVar[float] = 1 / 3
    vertical: ClassVar[bool] = False
    viscosity: Float64[Array, ""]

    @known_numbers_only
    def __init__(self, viscosity: float) -> None:
        self.viscosity = _positive("viscosity", viscosity, "Pa s")

    def power(self, disk: RollingMechanics, tilt: Operand, precession: Operand) -> Float64[Array, "*shape"]:
        # P ∝ α^−2, q = 2: n = 1/3
        return math.pi * self.viscosity * disk.gravity * disk.radius**2 / tilt**2


class BoundaryLayer(RollingDissipation):
    """P = kΩ^(5/2): shear of the air in a layer thinner than the gap; n = 4/9.

    Args:
        coefficient: k [W s^(5/2)].

    Source: Bildsten (2002).
    """

    name: ClassVar[str] = "boundary-layer"
    exponent: ClassVar[float] = 4 / 9
    vertical: ClassVar[bool] = False
    coefficient: Float64[Array, ""]

    @known_numbers_only
    def __init__(self, coefficient: float) -> None:
        self.coefficient = _positive("coefficient", coefficient, "W s^(5/2)")

    def power(self, disk: RollingMechanics, tilt: Operand, precession: Operand) -> Float64[Array, "*shape"]:
        # Ω^(5/2) ∝ α^(−5/4), q = 5/4: n = 4/9
        return self.coefficient * precession**2 * jnp.sqrt(precession)


class ViscousContourFriction(RollingDissipation):
    """P = kΩ²: a couple against the contact's way round the rim, in proportion to its rate; n = 1/2.

    Args:
        coefficient: k [W s²].

    Source: Leine (2009), §4.
    """

    name: ClassVar[str] = "viscous-contour-friction"
    exponent: ClassVar[float] = 1 / 2
    vertical: ClassVar[bool] = False
    coefficient: Float64[Array, ""]

    @known_numbers_only
    def __init__(self, coefficient: float) -> None:
        self.coefficient = _positive("coefficient", coefficient, "W s²")

    def power(self, disk: RollingMechanics, tilt: Operand, precession: Operand) -> Float64[Array, "*shape"]:
        # Ω² ∝ 1/α, q = 1: n = 1/2
        return self.coefficient * precession**2


class DryContourFriction(RollingDissipation):
    """P = k mga Ω: a constant couple against the contact's way round the rim; n = 2/3.

    Args:
        coefficient: k, without unit.

    Source: Leine (2009), §4.
    """

    name: ClassVar[str] = "dry-contour-friction"
    exponent: ClassVar[float] = 2 / 3
    vertical: ClassVar[bool] = False
    coefficient: Float64[Array, ""]

    @known_numbers_only
    def __init__(self, coefficient: float) -> None:
        self.coefficient = _positive("coefficient", coefficient, "1")

    def power(self, disk: RollingMechanics, tilt: Operand, precession: Operand) -> Float64[Array, "*shape"]:
        # Ω ∝ α^(−1/2), q = 1/2: n = 2/3
        return self.coefficient * disk.mass * disk.gravity * disk.radius * precession


class RollingCouple(RollingDissipation):
    """P = k mg Ω sin α: the classical couple of rolling friction, on the rate at which the disk itself turns; n = 2.

    Args:
        arm: k, its lever arm [m].
    """

    name: ClassVar[str] = "rolling-couple"
    exponent: ClassVar[float] = 2.0
    vertical: ClassVar[bool] = False
    arm: Float64[Array, ""]

    @known_numbers_only
    def __init__(self, arm: float) -> None:
        self.arm = _positive("arm", arm, "m")

    def power(self, disk: RollingMechanics, tilt: Operand, precession: Operand) -> Float64[Array, "*shape"]:
        # Ω sin α ∝ α^(1/2), q = −1/2: n = 2
        return self.arm * disk.mass * disk.gravity * precession * jnp.sin(tilt)


class DrillingFriction(RollingDissipation):
    """P = k mg Ω α²: dry friction of the contact patch on which the disk turns; no finite end.

    By energy alone α ∝ t^(−2). In the full motion the couple stops the turning about the vertical long before the tilt
    has changed, and takes nothing from then on.

    Args:
        arm: k, its lever arm, a size of the patch [m].

    Source: Leine (2009), §4.
    """

    name: ClassVar[str] = "drilling-friction"
    exponent: ClassVar[float] = -2.0
    vertical: ClassVar[bool] = True
    arm: Float64[Array, ""]

    @known_numbers_only
    def __init__(self, arm: float) -> None:
        self.arm = _positive("arm", arm, "m")

    def power(self, disk: RollingMechanics, tilt: Operand, precession: Operand) -> Float64[Array, "*shape"]:
        # Ωα² ∝ α^(3/2), q = −3/2: n = −2
        return self.arm * disk.mass * disk.gravity * precession * tilt**2


LAWS: tuple[type[RollingDissipation], ...] = (
    AirLayer, BoundaryLayer, ViscousContourFriction, DryContourFriction, RollingCouple, DrillingFriction,
)  # fmt: skip


def couples(
    disk: RollingMechanics, laws: Sequence[RollingDissipation], theta: Operand, w2: Operand, w3: Operand
) -> tuple[Float64[Array, "*shape"], Float64[Array, "*shape"]]:
    """Return (τ2, τ3) [N m], the couples of all laws along e2 and e3.

    A horizontal couple Q (e3 − c/s e2) works on the rate ψ̇ = ω3 − ω2 c/s, a vertical one on ω·z, and Q = −P/rate.
    Where the rate vanishes this diverges; there the couple is capped so that it brakes the rate no faster than by
    e in a thirtieth of the time √(a sin θ/g). A disk that still precesses loses exactly P.

    Args:
        disk: its constants.
        laws: any.
        theta: tilt [rad], any shape.
        w2: ω2 [rad/s].
        w3: ω3 [rad/s].
    """
    fastest_braking = 30.0  # in √(g/(a sin θ)): no couple brakes a rate faster, see below
    s, c = jnp.sin(theta), jnp.cos(theta)
    tau2 = tau3 = jnp.zeros_like(w2)
    # a step may try θ < 0 before the event there is located: all must stay finite
    size = jnp.abs(s)
    tilt, precession = jnp.minimum(theta, jnp.pi - theta), jnp.abs(w2) / size
    for law in laws:
        # the directions in the plane of e2 and e3: z = s e2 + c e3, and e3 − (c/s) e2 = (s e3 − c e2)/s, which is
        # horizontal; a couple Q n has power Q n·ω
        n2, n3 = (s, c) if law.vertical else (-c / s, jnp.ones_like(s))
        rate = n2 * w2 + n3 * w3
        response = disk.accelerations(n2, n3)
        # Q n alone changes the rate by Q n·M⁻¹n: with Q = −cap · rate it falls by e in 1/30 of √(a sin θ/g)
        cap = fastest_braking * jnp.sqrt(disk.gravity / (disk.radius * size)) / (n2 * response[0] + n3 * response[1])
        power, square = law.power(disk, tilt, precession), rate * rate
        capped = power >= cap * square
        Q = -rate * jnp.where(capped, cap, power / jnp.where(capped, 1.0, square))
        tau2, tau3 = tau2 + n2 * Q, tau3 + n3 * Q
    return tau2, tau3


@eqx.filter_jit
def slow_push(
    disk: RollingMechanics, laws: Sequence[RollingDissipation], theta: Array, w2: Array, w3: Array
) -> tuple[Float64[Array, "..."], Float64[Array, "..."]]:
    """Return the rate at which the couples change θ̈, and the square of the nutation's frequency."""
    _, by_w2, by_w3 = jax.grad(disk.tilt_acceleration, argnums=(0, 1, 2))(theta, w2, w3)
    push2, push3 = disk.accelerations(*couples(disk, laws, theta, w2, w3))
    return by_w2 * push2 + by_w3 * push3, disk.nutation_squared(theta, w2, w3)


def _positive(name: str, value: float, unit: str) -> Array:
    return jnp.asarray(check.number(name, value, unit, above=0, remedy="Leave the law out where it is zero."), float)
