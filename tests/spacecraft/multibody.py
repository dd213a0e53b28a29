"""Newton's and Euler's laws for a hub with rotors and a ball of fuel, each a rigid body of its own, in space axes.

Nothing of the package is used: attitudes are matrices, every body has its full 3 × 3 inertia, the hub's and the rotors'
accelerations come from one linear system, and SciPy integrates.
"""

from dataclasses import dataclass, field

import numpy as np
from scipy.integrate import solve_ivp


@dataclass
class Wheel:
    """A rotor: axis along the hub's axes, axial and transverse moment, and what drives it, u(t, R, Ω, σ)."""

    axis: np.ndarray
    axial: float
    transverse: float
    torque: object

    def inertia(self, turn):
        axis = turn @ self.axis
        return self.transverse * np.eye(3) + (self.axial - self.transverse) * np.outer(axis, axis)


@dataclass
class Hub:
    """A hub with wheels and, where it has a moment, a ball in a viscous film.

    Attributes:
        locked: (3, 3) inertia of all together, along the hub's axes.
        torque: τ(t, R, Ω) from outside, along the hub's axes.
    """

    locked: np.ndarray
    wheels: list
    ball: float = 0.0
    film: float = 0.0
    torque: object = field(default=lambda t, turn, velocity: np.zeros(3))

    def alone(self):
        """The inertia of the hub without its parts."""
        still = sum((wheel.inertia(np.eye(3)) for wheel in self.wheels), self.ball * np.eye(3))
        return self.locked - still

    def bodies(self, turn, omega, rates, ball):
        """Inertia and angular velocity of every body, in space."""
        yield turn @ self.alone() @ turn.T, omega
        for wheel, rate in zip(self.wheels, rates, strict=True):
            yield wheel.inertia(turn), omega + rate * (turn @ wheel.axis)
        yield self.ball * np.eye(3), ball

    def momentum(self, *state):
        return sum(inertia @ velocity for inertia, velocity in self.bodies(*state))

    def energy(self, *state):
        return sum(0.5 * velocity @ inertia @ velocity for inertia, velocity in self.bodies(*state))

    def rates(self, t, packed):
        turn, omega, ball = packed[:9].reshape(3, 3), packed[9:12], packed[12:15]
        spins = packed[15:]
        velocity = turn.T @ omega
        count = len(self.wheels)
        drag = self.film * (omega - ball)  # on the ball
        matrix, right = np.zeros((3 + count, 3 + count)), np.zeros(3 + count)
        right[:3] = turn @ self.torque(t, turn, velocity) - drag
        inertia = turn @ self.alone() @ turn.T
        matrix[:3, :3] += inertia
        right[:3] -= np.cross(omega, inertia @ omega)
        for k, (wheel, spin) in enumerate(zip(self.wheels, spins, strict=True)):
            axis, inertia = turn @ wheel.axis, wheel.inertia(turn)
            whole = omega + spin * axis
            # of this wheel: I (ω̇ + σ̇ a + σ ω × a) + ω_k × I ω_k
            known = inertia @ (spin * np.cross(omega, axis)) + np.cross(whole, inertia @ whole)
            matrix[:3, :3] += inertia
            matrix[:3, 3 + k] += inertia @ axis
            right[:3] -= known
            matrix[3 + k, :3], matrix[3 + k, 3 + k] = axis @ inertia, axis @ inertia @ axis
            right[3 + k] = wheel.torque(t, turn, velocity, spin) - axis @ known
        found = np.linalg.solve(matrix, right)
        skew = np.array([[0, -omega[2], omega[1]], [omega[2], 0, -omega[0]], [-omega[1], omega[0], 0]])
        ball_rate = drag / self.ball if self.ball else np.zeros(3)
        return np.concatenate([(skew @ turn).ravel(), found[:3], ball_rate, found[3:]])

    def motion(self, times, turn, velocity, spins, ball=(0.0, 0.0, 0.0)):
        """Samples (R, ω, rates σ, ball's ω), all in space axes, from Ω and the ball's velocity in the hub's."""
        start = np.concatenate([turn.ravel(), turn @ velocity, turn @ np.asarray(ball), spins])
        found = solve_ivp(self.rates, (times[0], times[-1]), start, "DOP853", times, rtol=1e-12, atol=1e-13)
        assert found.success
        return [(y[:9].reshape(3, 3), y[9:12], y[15:], y[12:15]) for y in found.y.T]
