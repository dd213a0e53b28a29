"""Attitudes at the steps that users of Basilisk take: ``python benchmarks/basilisk_steps.py [free] ["three wheels"]``.

It needs Basilisk, the package ``bsk``. The spacecraft of ``basilisk.py`` tumbles at 6 °/s for 6000 s, free, then with
three wheels of which two are driven. Basilisk takes its default, RK4 at steps of 1 to .01 s, and RKF78; polhode its
default, at a tolerance as large as RK4's error and to rounding, and of the free body the closed form. Told are the
largest angle to the true attitude at 61 times [rad], and CPU seconds of all that a user writes, medians of five after a
first that compiles, or of one from two seconds on. The truth is a system of its own by series with twice as many
digits.
"""

from __future__ import annotations

import statistics
import sys
from collections.abc import Callable, Iterator
from functools import partial
from typing import Any

import basilisk as peer
import jax.numpy as jnp
import numpy as np
from measure import seconds

import polhode as ph
from polhode import rotation
from polhode.integrators import Taylor
from polhode.spacecraft import RigidBody
from polhode.systems.base import AbstractSystem

STEPS = 1.0, 0.5, 0.1, 0.01  # s
FINE = 0.1  # s, between which RKF78 takes its own steps
VELOCITY = np.array([0.06, -0.07, 0.05])  # rad/s
TIMES = np.linspace(0.0, peer.UNTIL, peer.SAMPLES)
TURNS, LONG_CALL = 5, 2.0  # s
TOLERANCES = 10.0 ** -np.arange(1.0, 13.0)
UPRIGHT = (1.0, 0.0, 0.0, 0.0)


class Truth(AbstractSystem):
    """Attitude and momentum (7,) along the given axes of a body whose wheels have momenta h + u t about fixed axes.

    Attributes:
        inverse: (3, 3) of the inertia without that of the wheels about their axes.
        held: Σ h a (3,), h with the body's own turning.
        driven: Σ u a (3,).
    """

    inverse: np.ndarray
    held: np.ndarray
    driven: np.ndarray

    def vector_field(self, t: Any, state: Any) -> Any:
        """Return ½ q Ω and L × Ω."""
        w, x, y, z = state[:4]
        L = state[4:]
        a, b, c = (jnp.asarray(row) @ (L - self.held - self.driven * t) for row in self.inverse)
        turn = [-x * a - y * b - z * c, w * a + y * c - z * b, w * b + z * a - x * c, w * c + x * b - y * a]
        return jnp.stack([*(0.5 * r for r in turn), L[1] * c - L[2] * b, L[2] * a - L[0] * c, L[0] * b - L[1] * a])

    def invariants(self, state: Any) -> dict[str, Any]:
        """Return none, as none is projected on."""
        return {}


def find_truth(wheels: bool) -> np.ndarray:
    """Return the attitudes (T, 4)."""
    axes, moment = peer.WHEEL_AXES, peer.WHEEL_MOMENT * wheels
    momenta = moment * (peer.WHEEL_RATES + axes @ VELOCITY)
    inertia = peer.INERTIA - moment * axes.T @ axes
    system = Truth(np.linalg.inv(inertia), momenta @ axes, (peer.WHEEL_TORQUES * wheels) @ axes)
    start = np.concatenate([UPRIGHT, inertia @ VELOCITY + momenta @ axes])
    found = ph.simulate(system, start, TIMES, Taylor(precision="extended"), estimate_error=False)
    return np.asarray(found.states)[:, :4]


def free(**options: Any) -> np.ndarray:
    """Return the attitudes of the free spacecraft by ``ph.simulate``."""
    body = RigidBody.from_body(peer.whole([]))
    return _attitudes(body, body.pack(UPRIGHT, VELOCITY), **options)


def wheeled(**options: Any) -> np.ndarray:
    """Return those of the one with wheels."""
    body, start, _ = peer.wheels(VELOCITY)
    return _attitudes(body, start, **options)


def exact() -> np.ndarray:
    """Return those of the free one by the closed form."""
    body = peer.whole([])
    turn = np.asarray(body.principal_axes)
    principal = rotation.from_matrix(turn)
    motion = ph.FreeMotion(body.principal_moments, angular_velocity=turn.T @ VELOCITY, attitude=principal)
    return np.asarray(rotation.multiply(motion.state(TIMES)[0], rotation.conjugate(principal)))


def _attitudes(body: RigidBody, start: Any, **options: Any) -> np.ndarray:
    return np.asarray(ph.simulate(body, start, TIMES, **options).along("given").attitude)


def find_rows(ours: Callable[..., np.ndarray], add: Callable[..., Any]) -> Iterator[tuple[str, float, float]]:
    """Yield who moves the spacecraft, the error and the CPU seconds."""
    truth = find_truth(ours is wheeled)

    def told(who: str, run: Callable[[], np.ndarray]) -> tuple[str, float, float]:
        error, times = peer.angle(truth, run()), [seconds(run)]
        if times[0] < LONG_CALL:
            times += [seconds(run) for _ in range(TURNS - 1)]
        return who, error, statistics.median(times)

    tried = [(float(t), peer.angle(truth, ours(tolerance=float(t), estimate_error=False))) for t in TOLERANCES]
    for step in STEPS:
        by = partial(peer.basilisk, add, step, VELOCITY, default=True)
        row = told(f"Basilisk, RK4, step {step:g} s", lambda by=by: peer.quaternions(by()))
        yield row
        fitting = [t for t, error in tried if error <= row[1]]
        if fitting:
            at = {"tolerance": fitting[0]}
            yield told(f"polhode, tolerance of steps {fitting[0]:g}", partial(ours, estimate_error=False, **at))
            yield told(f"polhode, tolerance {fitting[0]:g}, with its error estimate", partial(ours, **at))
    by = partial(peer.basilisk, add, FINE, VELOCITY)
    yield told(f"Basilisk, RKF78, tolerance 1e-13, step {FINE:g} s", lambda: peer.quaternions(by()))
    yield told("polhode, to rounding", partial(ours, estimate_error=False))
    yield told("polhode, its default: to rounding, with its error estimate", ours)
    if ours is free:
        yield told("polhode, `FreeMotion`", exact)


def main() -> None:
    """Print the table."""
    print("| spacecraft | by | largest angle, rad | CPU s |\n|---|---|---|---|")
    craft = {"free": (free, lambda *_: None), "three wheels": (wheeled, peer.wheels(VELOCITY)[2])}
    for name in sys.argv[1:] or craft:
        ours, add = craft[name]
        for who, error, taken in find_rows(ours, add):
            print(f"| {name} | {who} | {error:.1e} | {taken:.2g} |", flush=True)


if __name__ == "__main__":
    main()
