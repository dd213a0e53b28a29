"""How a controlled body returns to its target: eigenvalues of the linearised loop, gain and phase margins."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np

from polhode import rotation
from polhode.systems.control_laws import AbstractControlLaw
from polhode.systems.rigid_body import RigidBody
from polhode.systems.torques.base import in_body
from polhode.types import Array, Float64

DECADES, POINTS = 5.0, 4001  # of frequencies that are searched, about the fastest eigenvalue
NEGLIGIBLE = 1e-9  # of the largest entry of a matrix


class LinearLoop(NamedTuple):
    """The motion about a target to first order: ẋ = A x, x = (θ, w), with θ the small turn from it and w its rate.

    Attributes:
        plant: (6, 6) A without control [1/s and the like].
        input: (6, 3) what a torque of one N m about each axis does.
        law: (3, 6) the torque that the law asks for.
        rest: (3,) angular acceleration at the target itself [rad/s²], zero where it is an equilibrium.
    """

    plant: Float64[Array, "6 6"]
    input: Float64[Array, "6 3"]
    law: Float64[Array, "3 6"]
    rest: Float64[Array, "3"]

    @property
    def eigenvalues(self) -> Float64[Array, "6"]:
        """(6,) of the closed loop, complex [1/s], slowest decay first."""
        values = np.linalg.eigvals(self.plant + self.input @ self.law)
        return values[np.argsort(-values.real, kind="stable")]


class Margins(NamedTuple):
    """Margins of the loop about one axis, the loops about the others being closed.

    Attributes:
        crossover: where the loop's gain is one [rad/s], the highest; None where it never is.
        phase: smallest phase margin at such places [rad]; None without one.
        delay: the smallest delay that makes the loop unstable [s]; None without one.
        gain_up: by how much the gain may grow before the loop is unstable; infinite where it may grow without bound.
        gain_down: by which factor it may fall, zero where it may vanish.
    """

    crossover: float | None
    phase: float | None
    delay: float | None
    gain_up: float
    gain_down: float


def linearize_loop(
    system: RigidBody, law: AbstractControlLaw, time: float, state: Float64[Array, "n"]
) -> LinearLoop | None:
    """Return the motion about the law's target to first order, at a time, with the states of mounts as they are.

    What wheels store is held at its value: it changes slowly, and enters by its gyroscopic torque alone.

    Args:
        system: the body with its actuators, without limits.
        law: of control, as it is in the system.
        time: of the target [s].
        state: packed (n,), whose mounts and torques count.

    Returns:
        None for a law without a target, or with a state of its own, and with parts that move their mass.
    """
    if system.moving_parts or law.target(jnp.zeros(())) is None or law.state_size:
        return None
    values = _derivatives(system, law, jnp.asarray(float(time)), jnp.asarray(state))
    closed, asked, given, rest = (np.asarray(value) for value in values)
    return LinearLoop(closed - given @ asked, given, asked, rest)


@eqx.filter_jit
def _derivatives(system: RigidBody, law: AbstractControlLaw, time: Array, state: Array) -> tuple[Array, ...]:
    body, no_state = system.as_given(state), jnp.zeros(0)
    target, turning = law.target(time), law.target_rate(time)
    assert target is not None and turning is not None and body.attitude is not None

    def place(x: Array) -> tuple[Array, Array]:
        small = jnp.concatenate([jnp.ones(1), 0.5 * x[:3]])
        attitude = rotation.multiply(target, small / jnp.linalg.norm(small))
        return attitude, in_body(attitude, turning) + x[3:]

    def rate(x: Array) -> Array:
        attitude, velocity = place(x)
        packed = system.packed_as_given(attitude, velocity, state)
        change = system.vector_field(time, packed)
        # ẇ = Ω̇ − d/dt Rᵀ ω_t along the motion
        _, acceleration = jax.jvp(system.velocity, (packed,), (change,))
        turn = jnp.concatenate([change[:4]])

        def aim(t: Array, packed_attitude: Array) -> Array:
            moved = system.as_given(jnp.concatenate([packed_attitude, packed[4:]])).attitude
            wanted = law.target_rate(t)
            assert moved is not None and wanted is not None
            return in_body(moved, wanted)

        _, moving = jax.jvp(aim, (time, packed[:4]), (jnp.ones(()), turn))
        return jnp.concatenate([x[3:], acceleration - moving])

    def asked(x: Array) -> Array:
        attitude, velocity = place(x)
        return law.wanted(time, attitude, velocity, no_state)

    still = jnp.zeros(6)
    carrier = system.carrier
    matrix = jnp.diag(carrier) if carrier.ndim == 1 else carrier
    given = jnp.concatenate([jnp.zeros((3, 3)), jnp.linalg.inv(matrix)])
    return jax.jacfwd(rate)(still), jax.jacfwd(asked)(still), given, rate(still)[3:]


def loop_margins(loop: LinearLoop) -> list[Margins]:
    """Return gain and phase margins of the loop about each axis, broken one at a time.

    With ℓ(s) the gain round the broken loop, 1 + ℓ = 0 is the closed loop: the phase margin is how far ℓ(iω) is from −1
    where |ℓ| = 1, the gain margins tell where ℓ is real and negative.

    Source: Franklin, Powell & Emami-Naeini, *Feedback Control of Dynamic Systems*, §6.4; Skogestad & Postlethwaite,
    *Multivariable Feedback Control*, §9.2.

    >>> plant = np.zeros((6, 6)); plant[:3, 3:] = np.eye(3)
    >>> law = -np.concatenate([np.eye(3), 1.4 * np.eye(3)], axis=1)
    >>> one = loop_margins(LinearLoop(plant, np.concatenate([np.zeros((3, 3)), np.eye(3)]), law, np.zeros(3)))[0]
    >>> round(one.crossover, 4), round(math.degrees(one.phase), 2), one.gain_up, one.gain_down
    (1.5678, 65.51, inf, 0.0)
    """
    return [_margins(loop, k) for k in range(3)]


def _margins(loop: LinearLoop, k: int) -> Margins:
    others = loop.law.copy()
    others[k] = 0.0
    inside = loop.plant + loop.input @ others
    fastest = float(np.abs(loop.eigenvalues).max())
    if not fastest > 0:
        return Margins(None, None, None, math.inf, 0.0)
    frequencies = fastest * np.logspace(-DECADES, DECADES, POINTS)

    def gain(frequency: Any) -> Any:
        shifted = 1j * np.atleast_1d(frequency)[:, None, None] * np.eye(6) - inside
        answer = np.linalg.solve(shifted, np.broadcast_to(loop.input[:, k], (len(shifted), 6))[..., None])[..., 0]
        return -(answer @ loop.law[k])

    crossings = _roots(lambda w: np.log(np.abs(gain(w))), frequencies)
    phases = [math.pi - abs(float(np.angle(gain(w)[0]))) for w in crossings]
    # how far the phase may fall, at which frequency: that is a delay
    delays = [(float(np.angle(gain(w)[0])) % (2.0 * math.pi) - math.pi) % (2.0 * math.pi) / w for w in crossings]
    turns = [gain(w)[0] for w in _roots(lambda w: gain(w).imag / np.abs(gain(w)), frequencies)]
    factors = [-1.0 / value.real for value in turns if value.real < 0.0]
    return Margins(
        max(crossings, default=None), min(phases, default=None), min(delays, default=None),
        min((x for x in factors if x > 1.0), default=math.inf), max((x for x in factors if x < 1.0), default=0.0),
    )  # fmt: skip


def _roots(function: Any, frequencies: Array) -> list[float]:
    """Return where a function changes its sign along frequencies, to rounding."""
    from scipy.optimize import brentq

    values = function(frequencies)
    found = np.flatnonzero(np.isfinite(values[:-1] * values[1:]) & (values[:-1] * values[1:] < 0.0))
    # a jump of a phase by a turn is no root: there the values are far from zero on both sides
    near = [k for k in found if min(abs(values[k]), abs(values[k + 1])) < 0.5]
    at = lambda w: float(function(np.array([w]))[0])  # noqa: E731
    return [float(brentq(at, frequencies[k], frequencies[k + 1], xtol=1e-14 * frequencies[k])) for k in near]
