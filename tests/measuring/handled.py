"""Logs of things that are handled, thrown and caught: flights by SciPy's DOP853, hands by smooth curves around them."""

from typing import NamedTuple

import numpy as np
from scipy.integrate import solve_ivp
from scipy.spatial.transform import Rotation

from measuring.thrown import euler

HANDS = {"rest": 0.0, "held": 0.3, "waved": 1.2, "wild": 3.0}  # rad/s
PHONE = (0.1914, 0.8131, 1.0)


class Handled(NamedTuple):
    """Times, rates and what is felt of a log, and the beginnings and ends of its flights."""

    times: np.ndarray
    rates: np.ndarray
    felt: np.ndarray | None
    flights: list[tuple[float, float]]


def _fade(x):
    return x**3 * (10 - 15 * x + 6 * x**2)


def handled(
    rng, throws=1, rate=100.0, seconds=10.0, hand="rest", noise=0.004, bias=0.01, step=0.0, drag=0.005,
    lever=None, moments=PHONE, duration=(0.4, 1.0),
):  # fmt: skip
    """Return a log with throws in equal parts of it, in a random place of each.

    A hand accelerates for some 0.2 s, its torque ending smoothly with the release, and a catch stops the turning with
    a blow. An accelerometer at the place ``lever`` feels gravity and the hand's force whenever the body is held.
    """
    t = np.arange(int(seconds * rate)) / rate
    axes = Rotation.random(rng=rng).as_matrix()
    frequencies, phases = rng.uniform(0.4, 1.5, (3, 3)), rng.uniform(0, 6.3, (3, 3))
    waves = sum(np.sin(2 * np.pi * f * t[:, None] + p) for f, p in zip(frequencies, phases, strict=True))
    w = HANDS[hand] / 1.5 * waves
    held = np.ones(len(t), dtype=bool)
    flights = []
    for k in range(throws):
        long = rng.uniform(*duration)
        begin = seconds / throws * k + rng.uniform(0.6, seconds / throws - long - 0.6)
        spin = rng.normal(size=3)
        spin *= rng.uniform(6, 14) / np.linalg.norm(spin)
        spin[1] += 5 * np.sign(spin[1])
        field = euler(moments, drag * np.asarray(moments))
        done = solve_ivp(field, (0, long), spin, method="DOP853", rtol=1e-9, atol=1e-10, dense_output=True)
        free = (t >= begin) & (t <= begin + long)
        w[free] = done.sol(t[free] - begin).T @ axes.T
        held &= ~free
        up, down = rng.uniform(0.12, 0.3), rng.uniform(0.06, 0.2)
        part = (t >= begin - up) & (t < begin)
        x = ((t[part] - begin) / up + 1)[:, None]
        slope = field(0, spin) @ axes.T
        w[part] = ((1 - _fade(x)) * w[part] + np.sin(np.pi / 2 * x) ** 1.5 * (spin @ axes.T)
                   + slope * (x - 1) * up * x**3)  # fmt: skip
        part = (t > begin + long) & (t <= begin + long + down)
        x = ((t[part] - begin - long) / down)[:, None]
        blow = 2 * np.sin(np.pi * x) * rng.normal(size=3)
        w[part] = _fade(x) * w[part] + (1 - x) ** 1.5 * (done.y[:, -1] @ axes.T) + blow
        flights.append((begin, begin + long))
    felt = None if lever is None else _felt(rng, t, w, held, np.asarray(lever), HANDS[hand] > 0)
    seen = w + rng.uniform(-bias, bias, 3) + noise * rng.normal(size=w.shape)
    return Handled(t, step * np.round(seen / step) if step else seen, felt, flights)


def _felt(rng, t, w, held, lever, moved):
    turning = np.gradient(w, t, axis=0)
    felt = np.cross(w, np.cross(w, lever)) + np.cross(turning, lever) + 0.05 * rng.normal(size=w.shape)
    attitude, down = Rotation.identity(), np.empty_like(w)
    for k, step in enumerate(Rotation.from_rotvec(w * (t[1] - t[0]))):
        down[k] = attitude.inv().apply([0.0, 0.0, 9.81])
        attitude = attitude * step
    hand = 3.0 * moved * np.stack([np.sin(10.7 * t), np.cos(13.2 * t), np.sin(6.9 * t + 1)], axis=1)
    felt[held] += (down + hand)[held]
    return felt
