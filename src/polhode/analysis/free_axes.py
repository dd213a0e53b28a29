"""Verdicts on permanent rotation about each principal axis of a free body."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from polhode._base import check
from polhode._base.arrays import known_numbers_only
from polhode.analysis._conserved_function import ConservedFunction
from polhode.analysis._reasons import AxisOfFreeBody
from polhode.analysis.certificate import Subject
from polhode.analysis.energy_casimir import Stability, energy_casimir
from polhode.errors import InvalidInput
from polhode.types import ArrayLike, ArrayOrFloat, Float64, Real


@known_numbers_only
def axis_stability(moments: Real[ArrayLike, "3"], momentum_norm: float) -> tuple[Stability, Stability, Stability]:
    """Return the verdicts on rotation about the three principal axes at the given |L|.

    About axis i, H − C/I_i with C = ½|L|² is critical; its second variation on the sphere is ½ Σ (1/I_j − 1/I_i) δL_j²
    over the other two axes. Positive about the axis of largest inertia, negative about that of least: both prove
    stability. About the middle axis the signs differ and neighbours leave at the rate
    |L| √((I_i−I_j)(I_k−I_i)/(I_j I_k)) / I_i. The differences are taken before they enter the matrices, so that
    moments one unit in the last place apart are still distinguished.

    Args:
        moments: (3,) principal moments [kg m²], positive, any order.
        momentum_norm: |L| [kg m²/s].

    Raises:
        InvalidInput: for moments or |L| that are not positive, or not finite.

    Source: Marsden & Ratiu, *Introduction to Mechanics and Symmetry*, theorem 15.3.1 (with its converse).
    """
    I = check.array("moments", moments, (3,), "kg m²", above=0)  # noqa: E741
    norm = check.number("momentum_norm", momentum_norm, "kg m²/s", least=0)
    point = norm * np.eye(3)
    subjects = [Subject(tuple(I.tolist()), point[i]) for i in range(3)]
    return tuple(replace(_about(I, norm, i), subject=subjects[i]) for i in range(3))  # type: ignore[return-value]


def _about(I: np.ndarray, norm: float, i: int) -> Stability:  # noqa: E741
    """Judge axis i in units where I_i = |L| = 1; the Casimir has been taken out of the energy beforehand."""
    j, k = (i + 1) % 3, (i + 2) % 3
    curvature = np.zeros((3, 3))
    with np.errstate(over="ignore", under="ignore"):
        curvature[j, j], curvature[k, k] = (I[i] - I[j]) / I[j], (I[i] - I[k]) / I[k]
        rate = norm / I[i]
    if not (np.isfinite(curvature).all() and np.isfinite(rate) and (rate > 0.0) == (norm > 0.0)):
        raise InvalidInput(
            f"`moments` {I.tolist()} and |L| = {norm:g} give numbers that overflow or underflow; choose other units."
        )
    flow = np.zeros((3, 3))
    flow[j, k], flow[k, j] = -curvature[k, k], curvature[j, j]
    axis = np.eye(3)[i]
    stability = energy_casimir(
        flow, np.zeros(3), curvature, axis[None], np.eye(3)[None], ["½|L|²"], on_equilibria=True, tolerance=0.0
    )
    bends = np.array([curvature[j, j], curvature[k, k]])
    used = ConservedFunction(("|L|²",), np.array([1.0, -0.5 / I[i]]), bends / (np.abs(bends).max() or 1.0), 0.0)
    terms = {n + 1: float(curvature[n, n] / I[i]) for n in (j, k)}
    leaving = float(leaving_rates(I[i], I[j], I[k], norm)) if stability.growth == "exponential" else 0.0
    reason = AxisOfFreeBody(float(I[i]), terms, leaving, stability.growth, norm == 0.0)
    stability = replace(stability, function=used, reason=reason)
    if norm == 0.0:
        return replace(stability, verdict="stable", rate=0.0, growth=None, direction=None, function=None,
                       spectrum=0.0 * stability.spectrum,
                       reason=AxisOfFreeBody(float(I[i]), terms, 0.0, None, True))
    if not curvature.any():
        return replace(stability, verdict="stable")
    return replace(stability, rate=leaving, spectrum=stability.spectrum * rate)


def leaving_rates(
    about: Float64[ArrayOrFloat, "*#batch"], one: Float64[ArrayOrFloat, "*#batch"],
    other: Float64[ArrayOrFloat, "*#batch"], momentum_norm: Float64[ArrayOrFloat, "*#batch"],
) -> Float64[np.ndarray, "*batch"]:
    """Return the rates |L| √((I_i − I_j)(I_k − I_i)/(I_j I_k))/I_i (…) at which motions leave axis i, or zero.

    Args:
        about: I_i (…) [kg m²].
        one, other: the other two moments (…) [kg m²].
        momentum_norm: |L| (…) [kg m²/s].
    """
    product = ((about - one) / one) * ((other - about) / other)
    return np.asarray(momentum_norm / about * np.sqrt(np.maximum(product, 0.0)))
