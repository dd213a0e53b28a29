"""The heavy tops with a third integral: Euler's, Lagrange's, Kovalevskaya's and Goryachev and Chaplygin's.

No others have one on every orbit that is algebraic (Husson 1906), or single-valued (Ziglin 1983).
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import jax.numpy as jnp

from polhode.bodies._pivot import EQUAL, axis_of_symmetry
from polhode.types import Array, Float64

Integral = Callable[[Float64[Array, "*batch 6"]], Float64[Array, "*batch"]]

INTEGRAL_UNITS = {"Euler": "kg2 m4 s-2", "Lagrange": "kg m2 s-1", "Kovalevskaya": "s-4", "Goryachev-Chaplygin": "s-3"}


class LeafLimits(NamedTuple):
    """What decides that a point is on the leaf of the Goryachev–Chaplygin integral."""

    leaf_distance: float = 1e-12  # of |Π| |Γ|: Π·Γ below it is zero but for rounding


LIMITS = LeafLimits()


def integrable_case(moments: Float64[Array, "3"], mgl: float, axis: Float64[Array, "3"]) -> tuple[str, int] | None:
    """Return the case by name and the index of the axis of symmetry, or None for a top that is not integrable."""
    if mgl == 0.0:
        return "Euler", 0
    symmetric = axis_of_symmetry(moments, axis)
    if symmetric is not None:
        return "Lagrange", symmetric
    for k in range(3):
        i, j = (k + 1) % 3, (k + 2) % 3
        if abs(moments[i] - moments[j]) > EQUAL * moments[i]:
            continue
        if abs(axis[k]) <= EQUAL:
            for name, ratio in (("Kovalevskaya", 2.0), ("Goryachev-Chaplygin", 4.0)):
                if abs(moments[i] / ratio - moments[k]) <= EQUAL * moments[k]:
                    return name, k
    return None


def leaf_integral(
    case: tuple[str, int], moments: Float64[Array, "3"], mgl: Float64[Array, ""], axis: Float64[Array, "3"]
) -> tuple[str, Integral, bool]:
    """Return the third integral's name, the integral, and whether it holds on Π·Γ = 0 alone.

    With k the axis of symmetry, I3 its moment, μ = mgl/I3, and χ across it:
    Euler |Π|²; Lagrange Π·χ; Kovalevskaya |(Ω1 + iΩ2)² − μ (γ1 + iγ2)(χ1 + iχ2)|²;
    Goryachev–Chaplygin Ω3 (Ω1² + Ω2²) − μ (Ω·χ) γ3.

    Source: Audin, *Spinning Tops*, ch. I and VI; Bolsinov & Fomenko, *Integrable Hamiltonian Systems*, ch. 14.
    """
    name, k = case
    i, j = (k + 1) % 3, (k + 2) % 3
    if name == "Euler":
        return "Euler's |Π|²", lambda point: jnp.sum(point[..., :3] ** 2, axis=-1), False
    if name == "Lagrange":
        return "Lagrange's Π·χ", lambda point: jnp.sum(point[..., :3] * axis, axis=-1), False
    strength = mgl / moments[k]

    def kovalevskaya(point: Array) -> Array:
        # z = (Ω1 + iΩ2)² − μ (γ1 + iγ2)(χ1 + iχ2) moves by ż = −iΩ3 z, so that |z| stays (Audin, ch. VI)
        velocity, up = point[..., :3] / moments, point[..., 3:]
        real = velocity[..., i] ** 2 - velocity[..., j] ** 2 - strength * (up[..., i] * axis[i] - up[..., j] * axis[j])
        imaginary = 2.0 * velocity[..., i] * velocity[..., j] - strength * (up[..., i] * axis[j] + up[..., j] * axis[i])
        return real**2 + imaginary**2

    def goryachev_chaplygin(point: Array) -> Array:
        velocity, up = point[..., :3] / moments, point[..., 3:]
        # its derivative is μ (χ2 Ω1 − χ1 Ω2) Π·Γ/I1
        across = velocity[..., i] ** 2 + velocity[..., j] ** 2
        value = velocity[..., k] * across - strength * jnp.sum(velocity * axis, axis=-1) * up[..., k]
        sizes = jnp.sum(point[..., :3] ** 2, axis=-1) * jnp.sum(up**2, axis=-1)
        on_leaf = jnp.sum(point[..., :3] * up, axis=-1) ** 2 <= LIMITS.leaf_distance**2 * sizes
        return jnp.where(on_leaf, value, jnp.nan)

    if name == "Kovalevskaya":
        return "Kovalevskaya's integral", kovalevskaya, False
    return "Goryachev and Chaplygin's integral", goryachev_chaplygin, True
