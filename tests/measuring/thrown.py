"""Synthetic throws, integrated by SciPy from Euler's equations with air, rotors and wrong gyros: nothing of the
estimator is used."""

import numpy as np
from scipy.integrate import solve_ivp
from scipy.spatial.transform import Rotation

BODIES = {"phone": (0.22, 0.84, 1.0), "book": (0.35, 0.75, 1.0), "racket": (0.1, 0.93, 1.0)}
SPINS = {"short": (2.0, 3.0, 9.0), "middle": (0.9, 11.0, 0.9), "long": (10.0, 2.5, 2.0)}
# what goes wrong beside bias, gains of 1 %, drag along the axes and a clock that jitters
TROUBLES = {
    "gains 1 %": {},
    "cross-axis 1 %": dict(cross=0.01),
    "gains 3 %": dict(cross=0.01, gain=0.03),
    "clock 1 %": dict(cross=0.01, clock=0.01),
    "linear and quadratic drag": dict(cross=0.01, linear=0.1),
    "one-sided drag": dict(cross=0.01, one_sided=0.6),
    "drag across axes": dict(cross=0.01, across=0.01),
    "a bias of 0.15 rad/s, with rests": dict(cross=0.01, bias=0.15, rest=0.8),
}


def euler(moments, drag=0.0, linear=0.0, one_sided=0.0, across=0.0, rotor=0.0):
    """I ω' = (I ω + h) × ω − |ω| (c (1 + a sign ω) ω + C ω) − b ω, along the principal axes."""
    moments, drag, rotor = np.asarray(moments), np.asarray(drag), np.asarray(rotor) + np.zeros(3)
    across = np.asarray(across) * np.ones((3, 3))

    def field(t, w):
        size = np.linalg.norm(w)
        sides = 1.0 + one_sided * np.tanh(w / 0.1)
        return (np.cross(moments * w + rotor, w) - size * (drag * sides * w + across @ w) - linear * w) / moments

    return field


def throw(
    rng, moments, spin, axes=None, seconds=0.6, rate=100.0, noise=1e-3, bias=0.05, gain=0.01, drag=0.01, dropped=0.02,
    jitter=1e-4, start=0.0, cross=0.0, clock=0.0, linear=0.0, one_sided=0.0, across=0.0, rotor=0.0, rest=0.0,
):  # fmt: skip
    """Return times and rates of a log with all that goes wrong, in the device frame; ``axes`` device from principal.

    ``gain`` and ``cross`` are the standard deviations of the matrix that rates are multiplied by, ``clock`` by how
    much the clock runs fast or slow, ``rest`` for how long the body lies still before and after [s].
    """
    count = round(seconds * rate)
    told = start + np.arange(count) / rate
    true = told + jitter * rng.normal(size=count)
    drag = np.broadcast_to(drag, 3) * rng.uniform(0.5, 1.5, 3)
    linear = linear * rng.uniform(0.0, 1.0, 3) * moments if linear else 0.0
    if across:
        across = across * rng.uniform(-0.5, 0.5, (3, 3)) * (1 - np.eye(3))
    if one_sided:
        one_sided = one_sided * rng.uniform(-1.0, 1.0, 3)
    done = solve_ivp(euler(moments, drag, linear, one_sided, across, rotor), (start - 0.01, start + seconds + 0.01),
                     spin, method="DOP853", rtol=1e-10, atol=1e-11, dense_output=True)  # fmt: skip
    axes = Rotation.random(rng=rng).as_matrix() if axes is None else axes
    rates = done.sol(true).T @ axes.T
    matrix = np.diag(1 + gain * rng.normal(size=3))
    if cross:
        matrix = matrix + cross * rng.normal(size=(3, 3)) * (1 - np.eye(3))
    offset = rng.uniform(-bias, bias, 3)
    rates = rates @ matrix.T + offset + noise * rng.normal(size=(count, 3))
    rates[rng.uniform(size=count) < dropped] = np.nan
    if rest:
        still = np.arange(0.0, rest, 1.0 / rate)
        lying = lambda: offset + noise * rng.normal(size=(len(still), 3))  # noqa: E731
        told = np.concatenate([still - rest - 0.3 + start, told, still + start + seconds + 0.3])
        rates = np.concatenate([lying(), rates, lying()])
    if clock:
        told = told * (1.0 + clock * rng.choice([-1.0, 1.0]))
    return told, rates, axes
