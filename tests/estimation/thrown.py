"""Synthetic throws, integrated by SciPy from Euler's equations with drag: nothing of the estimator is used."""

import numpy as np
from scipy.integrate import solve_ivp
from scipy.spatial.transform import Rotation

BODIES = {"phone": (0.22, 0.84, 1.0), "book": (0.35, 0.75, 1.0), "racket": (0.1, 0.93, 1.0)}
SPINS = {"short": (2.0, 3.0, 9.0), "middle": (0.9, 11.0, 0.9), "long": (10.0, 2.5, 2.0)}


def euler(moments, drag):
    moments, drag = np.asarray(moments), np.asarray(drag)

    def field(t, w):
        return (np.cross(moments * w, w) - drag * np.linalg.norm(w) * w) / moments

    return field


def throw(
    rng, moments, spin, axes=None, seconds=0.6, rate=100.0, noise=1e-3, bias=0.05, gain=0.01, drag=0.01, dropped=0.02,
    jitter=1e-4, start=0.0,
):  # fmt: skip
    """Return times and rates of a log with all that goes wrong, in the device frame; ``axes`` device from principal."""
    count = round(seconds * rate)
    told = start + np.arange(count) / rate
    true = told + jitter * rng.normal(size=count)
    drag = np.broadcast_to(drag, 3) * rng.uniform(0.5, 1.5, 3)
    done = solve_ivp(euler(moments, drag), (start - 0.01, start + seconds + 0.01), spin, method="DOP853", rtol=1e-10,
                     atol=1e-11, dense_output=True)  # fmt: skip
    axes = Rotation.random(rng=rng).as_matrix() if axes is None else axes
    rates = done.sol(true).T @ axes.T
    rates = rates * (1 + gain * rng.normal(size=3)) + rng.uniform(-bias, bias, 3) + noise * rng.normal(size=(count, 3))
    rates[rng.uniform(size=count) < dropped] = np.nan
    return told, rates, axes
