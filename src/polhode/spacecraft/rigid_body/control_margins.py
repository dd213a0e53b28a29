"""How a controlled body returns to its target: eigenvalues of the linearised loop, gain and phase margins."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import jax
import jax.numpy as jnp
import numpy as np

from polhode import rotation
from polhode._base.arrays import compiled_for_few_calls
from polhode.spacecraft.systems.control_laws import AbstractControlLaw, AbstractLawActuator, target_at
from polhode.spacecraft.systems.rigid_body import RigidBody
from polhode.spacecraft.torques.base import in_body
from polhode.types import Array, Complex128, Float64


class LinearLoop(NamedTuple):
    """The motion about a target to first order: ẋ = A x, x = (θ, w), with θ the small turn from it and w its rate.

    Attributes:
        plant: (6, 6) A without control [1/s and the like].
        input: (6, 3) the effect of a torque of one N m about each axis.
        law: (3, 6) the torque that the law asks for, about the axes that its actuators reach.
        rest: (3,) angular acceleration at the target itself [rad/s²], zero where it is an equilibrium.
    """

    plant: Float64[Array, "6 6"]
    input: Float64[Array, "6 3"]
    law: Float64[Array, "3 6"]
    rest: Float64[Array, "3"]

    @property
    def eigenvalues(self) -> Complex128[Array, "6"]:
        """(6,) of the closed loop, complex [1/s], slowest decay first."""
        values = np.linalg.eigvals(self.plant + self.input @ self.law).astype(complex)
        return values[np.argsort(-np.real(values), kind="stable")]


class Margins(NamedTuple):
    """Margins of the loop about one axis, the loops about the others being closed.

    Attributes:
        crossover: where the loop's gain is one [rad/s], the highest; None where it never is.
        phase: smallest phase margin at such places [rad]; None without one.
        delay: the smallest delay that makes the loop unstable [s]; None without one.
        gain_up: the factor by which the gain may grow before the loop is unstable; infinite where it may grow without
            bound.
        gain_down: the factor by which it may fall, zero where it may vanish.
    """

    crossover: float | None
    phase: float | None
    delay: float | None
    gain_up: float
    gain_down: float


def has_linear_loop(system: RigidBody, law: AbstractControlLaw) -> bool:
    """Whether a law has a target and no state of its own, in a body without parts that move their mass."""
    return not system.moving_parts and target_at(law, np.zeros(())) is not None and not law.state_size


def linearize_loop(
    system: RigidBody, law: AbstractControlLaw, time: float, state: Float64[Array, "n"]
) -> LinearLoop | None:
    """Return the motion about the law's target to first order, at a time, with the states of mounts as they are.

    The stored momentum is held at its value: it changes slowly, and enters by its gyroscopic torque alone.

    Args:
        system: the body with its actuators, without limits.
        law: of control, as it is in the system.
        time: of the target [s].
        state: packed (n,), whose mounts and torques count.

    Returns:
        None where there is none; see ``has_linear_loop``.
    """
    step = 1e-3  # of differences of fourth order, whose error is of the size of its fourth power
    if not has_linear_loop(system, law):
        return None
    where, at = jnp.asarray(float(time)), jnp.asarray(state)
    scale = np.repeat([step, step * _pace(law)], 3)  # of a turn, and of a rate
    steps = np.concatenate([k * np.diag(scale) for k in (-2.0, -1.0, 1.0, 2.0)] + [np.zeros((1, 6))])
    rates, asked, carrier = (np.asarray(x) for x in _rates(system, law, where, at, jnp.asarray(steps)))
    given = np.concatenate([np.zeros((3, 3)), np.linalg.inv(np.diag(carrier) if carrier.ndim == 1 else carrier)])
    closed, wanted = _slope(rates, scale), _slope(asked, scale)
    return LinearLoop(closed - given @ wanted, given, wanted, rates[-1, 3:])


def _pace(law: AbstractControlLaw) -> float:
    """Return a rate [rad/s] of the size of those at which the law works."""
    stiffness, damping = getattr(law, "gain", None), getattr(law, "rate_gain", None)
    if stiffness is None or damping is None:
        return 1.0
    return float(np.abs(stiffness).max() / np.abs(damping).max())


def _slope(values: Array, scale: Array) -> Array:
    """Return the derivative (n, 6) by differences of fourth order, of values (25, n) at two steps to either side."""
    low, less, more, high = np.split(values[:-1], 4)
    return ((low - high) / 12.0 + 2.0 * (more - less) / 3.0).T / scale


@compiled_for_few_calls
def _rates(
    system: RigidBody, law: AbstractControlLaw, time: Array, state: Array, near: Array
) -> tuple[Array, Array, Array]:
    """Return ẋ (…, 6) and the torque asked for (…, 3) at x (…, 6) near the target, and the carrier's inertia."""
    target, turning = law.target(time), law.target_rate(time)
    assert target is not None and turning is not None
    small = jnp.concatenate([jnp.ones((*near.shape[:-1], 1)), 0.5 * near[..., :3]], axis=-1)
    attitude = rotation.multiply(target, small / jnp.linalg.norm(small, axis=-1, keepdims=True))
    attitude = attitude * getattr(law, "sign", 1.0)  # of the target's two quaternions, the one that the law steers to
    aim = in_body(attitude, turning)
    velocity = aim + near[..., 3:]
    packed = system.packed_as_given(attitude, velocity, jnp.broadcast_to(state, (*near.shape[:-1], state.size)))
    change = system.vector_field(time, packed)
    # Ω is an affine function of the momenta, whose rates are those of the state
    moved = jnp.concatenate([packed[..., :4], packed[..., 4:] + change[..., 4:]], axis=-1)
    acceleration = system.velocity(moved) - system.velocity(packed)
    # ẇ = Ω̇ − d/dt Rᵀω_t = Ω̇ − Rᵀ ω̇_t + Ω × Rᵀω_t
    _, faster = jax.jvp(law.target_rate, (time,), (jnp.ones(()),))
    relative = acceleration - in_body(attitude, faster) + jnp.cross(velocity, aim)
    asked = law.wanted(time, attitude, velocity, jnp.zeros((*near.shape[:-1], 0)))
    for part in (*system.mounts, *system.torques):
        if isinstance(part, AbstractLawActuator):
            asked = asked @ part.reached
    return jnp.concatenate([near[..., 3:], relative], axis=-1), asked, system.carrier


def loop_margins(loop: LinearLoop) -> list[Margins]:
    """Return gain and phase margins of the loop about each axis, broken one at a time.

    With ℓ(s) the gain round the broken loop, 1 + ℓ = 0 is the closed loop: the phase margin is how far ℓ(iω) is from −1
    where |ℓ| = 1, the gain margins are taken where ℓ is real and negative.

    Source: Franklin, Powell & Emami-Naeini, *Feedback Control of Dynamic Systems*, §6.4; Skogestad & Postlethwaite,
    *Multivariable Feedback Control*, §9.2.

    >>> zero, one = np.zeros((3, 3)), np.eye(3)
    >>> plant, law = np.block([[zero, one], [zero, zero]]), -np.concatenate([one, 1.4 * one], axis=1)
    >>> about_x = loop_margins(LinearLoop(plant, np.concatenate([zero, one]), law, np.zeros(3)))[0]
    >>> round(about_x.crossover, 4), round(math.degrees(about_x.phase), 2), about_x.gain_up, about_x.gain_down
    (1.5428, 65.16, inf, 0.0)
    """
    return [_margins(loop, k) for k in range(3)]


def _margins(loop: LinearLoop, k: int) -> Margins:
    decades = 5.0  # of frequencies that are searched, about the fastest eigenvalue
    points = 4001
    others = loop.law.copy()
    others[k] = 0.0
    inside = loop.plant + loop.input @ others
    fastest = float(np.abs(loop.eigenvalues).max())
    if not (fastest > 0 and loop.law[k].any()):  # nothing moves, or no actuator reaches this axis
        return Margins(None, None, None, math.inf, 0.0)
    frequencies = fastest * np.logspace(-decades, decades, points)

    def gain(frequency: Any) -> Any:
        shifted = 1j * np.atleast_1d(frequency)[:, None, None] * np.eye(6) - inside
        answer = np.linalg.solve(shifted, np.broadcast_to(loop.input[:, k], (len(shifted), 6))[..., None])[..., 0]
        return -(answer @ loop.law[k])

    values = gain(frequencies)
    crossings = _roots(lambda w: np.log(np.abs(gain(w))), np.log(np.abs(values)), frequencies)
    phases = [math.pi - abs(float(np.angle(gain(w)[0]))) for w in crossings]
    # how far the phase may fall, at which frequency: that is a delay
    delays = [(float(np.angle(gain(w)[0])) % (2.0 * math.pi) - math.pi) % (2.0 * math.pi) / w for w in crossings]
    imaginary = lambda value: value.imag / np.abs(value)  # noqa: E731
    turns = [gain(w)[0] for w in _roots(lambda w: imaginary(gain(w)), imaginary(values), frequencies)]
    factors = [-1.0 / value.real for value in turns if value.real < 0.0]
    return Margins(
        max(crossings, default=None), min(phases, default=None), min(delays, default=None),
        min((x for x in factors if x > 1.0), default=math.inf), max((x for x in factors if x < 1.0), default=0.0),
    )


def _roots(function: Any, values: Array, frequencies: Array) -> list[float]:
    """Return where a function changes its sign along frequencies, at which its values are given, to rounding."""
    halvings = 60  # of an interval in which a root is, down to its rounding
    changes = np.flatnonzero(np.isfinite(values[:-1] * values[1:]) & (values[:-1] * values[1:] < 0.0))
    # where a phase jumps by a whole turn its sign changes without a root, from values far from zero
    near = np.array([k for k in changes if min(abs(values[k]), abs(values[k + 1])) < 0.5], int)
    low, high, positive = frequencies[near], frequencies[near + 1], values[near] > 0.0
    for _ in range(halvings if near.size else 0):  # all at once, in less time than SciPy's are imported
        middle = 0.5 * (low + high)
        before = (function(middle) > 0.0) == positive
        low, high = np.where(before, middle, low), np.where(before, high, middle)
    return (0.5 * (low + high)).tolist()
