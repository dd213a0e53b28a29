"""From the parameters of a fit to sorted ratios and axes with errors, or the reason why they are undetermined."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np
from scipy.spatial.transform import Rotation

from polhode.estimation._estimate import Estimate
from polhode.measuring.throws._throw_models import D_MOMENTS, compute_moments
from polhode.types import Array, Float64

FORCES = {"drag": "c", "linear_drag": "b", "one_sided_drag": "d", "rotor": "h"}
HALF_TURNS = ((1.0, 1.0, 1.0), (1.0, -1.0, -1.0), (-1.0, 1.0, -1.0), (-1.0, -1.0, 1.0))
DIRECTED = ("one_sided_drag", "rotor")


class PrincipalThresholds(NamedTuple):
    """Numbers that decide whether moments are determined, and what is said where they are not.

    Attributes:
        max_half_width: of the interval of a ratio; a wider one is no result, as ratios lie between 0 and 1.
        max_steady_angle: degrees; rates that stay as near to one direction are those of a steady spin.
        max_upright_angle: degrees; rates that deviate more from their mean are those of a body that tumbles.
        equal_errors: standard errors of a difference of ratios, within which they are equal.
    """

    max_half_width: float = 0.1
    max_steady_angle: float = 5.0
    max_upright_angle: float = 90.0
    equal_errors: float = 2.0


LIMITS = PrincipalThresholds()


@dataclass(frozen=True, eq=False)
class Principal:
    """Sorted moments and axes of a solution.

    Attributes:
        ratios: I1/I3, I2/I3.
        moments: (3,) over the largest.
        axes: (3, 3) by columns [device frame].
        turn: error of the axes [rad, principal axes].
        joint: ratios and turn together, with all their correlations.
        forces: coefficients over I3 of the torques, along the sorted axes, by name.
        order: (3, 3) columns are the sorted axes along the fit's own.
        equal: neighbours that are equal within their errors, or None.
        determined: whether the intervals of the ratios are narrow enough to be useful.
    """

    ratios: Estimate
    moments: Float64[Array, "3"]
    axes: Float64[Array, "3 3"]
    turn: Estimate
    joint: Estimate
    forces: dict[str, Estimate]
    order: Float64[Array, "3 3"]
    equal: str | None
    determined: bool


def principal(
    parameters: Float64[Array, "p"], covariance: Float64[Array, "p p"], places: dict[str, slice],
    axes: Float64[Array, "3 3"], freedom: float,
) -> Principal:
    """Return moments ascending over the largest, with axes, forces and errors in their order.

    Args:
        parameters: of the fit.
        covariance: of these, the turn along the fit's principal axes.
        places: of "shape", "turn" and perhaps forces among them.
        axes: the fit's principal axes by columns [device frame].
        freedom: degrees of freedom of the residuals.
    """
    unsorted = compute_moments(parameters[places["shape"]])
    which = np.argsort(unsorted, kind="stable")
    order = np.eye(3)[:, which]
    order[:, 2] *= np.linalg.det(order)
    largest = unsorted[which[2]]
    moments = unsorted[which] / largest
    # d(m_i/m_3) = (dm_i − (m_i/m_3) dm_3)/m_3
    slopes = (D_MOMENTS[:, which].T - np.outer(moments, D_MOMENTS[:, which[2]])) / largest
    by = np.zeros((5, 5))
    by[:2, :2], by[2:, 2:] = slopes[:2], order.T
    both = np.r_[places["shape"], places["turn"]]
    names = ("I1/I3", "I2/I3", "turn about 1", "turn about 2", "turn about 3")
    joint = Estimate(names, np.r_[moments[:2], np.zeros(3)], by @ covariance[np.ix_(both, both)] @ by.T, freedom)
    ratios = Estimate(names[:2], moments[:2], joint.covariance[:2, :2], freedom)
    turn = Estimate(names[2:], np.zeros(3), joint.covariance[2:, 2:], freedom)
    forces = {}
    for name in FORCES:
        if name not in places:
            continue
        both = np.r_[places[name], places["shape"]]
        # the components of a vector change sign with their axes
        to_sorted = order.T if name in DIRECTED else np.eye(3)[which]
        values = to_sorted @ parameters[places[name]] / largest
        # the fit's coefficients are over its own third moment
        by = np.concatenate([to_sorted / largest, -np.outer(values, D_MOMENTS[:, which[2]]) / largest], axis=1)
        names = tuple(f"{FORCES[name]}{k}/I3" for k in (1, 2, 3))
        forces[name] = Estimate(names, values, by @ covariance[np.ix_(both, both)] @ by.T, freedom)
    return Principal(ratios, moments, axes @ order, turn, joint, forces, order, _equal(ratios), _is_narrow(ratios))


def widen_errors(inertia: Principal, other: Principal) -> Principal:
    """Return a solution with errors of ratios and axes widened to cover another solution that may be the true one."""
    between = Rotation.from_matrix(inertia.axes.T @ other.axes)
    halves = [between * Rotation.from_matrix(np.diag(signs)) for signs in HALF_TURNS]  # all of the axes up to sign
    apart = min((half.as_rotvec() for half in halves), key=np.linalg.norm)
    apart = np.concatenate([other.ratios.value - inertia.ratios.value, apart])
    joint = replace(inertia.joint, covariance=inertia.joint.covariance + np.outer(apart, apart))
    ratios = replace(inertia.ratios, covariance=joint.covariance[:2, :2])
    turn = replace(inertia.turn, covariance=joint.covariance[2:, 2:])
    return replace(inertia, joint=joint, ratios=ratios, turn=turn, equal=_equal(ratios), determined=_is_narrow(ratios))


def _is_narrow(ratios: Estimate) -> bool:
    half = 0.5 * np.diff(ratios.interval(), axis=1)[:, 0]
    return bool(np.isfinite(half).all() and half.max() < LIMITS.max_half_width)


def _equal(ratios: Estimate) -> str | None:
    between = np.array([-1.0, 1.0])
    gap = float(between @ ratios.value)
    if gap < LIMITS.equal_errors * np.sqrt(between @ ratios.covariance @ between):
        return "I1 = I2"
    return "I2 = I3" if 1.0 - ratios.value[1] < LIMITS.equal_errors * ratios.standard_error[1] else None


def explain_undetermined(rates: list[Float64[Array, "n 3"]], inertia: Principal | None) -> str:
    """Return why throws do not determine the inertia, in a sentence.

    Args:
        rates: of each throw [rad/s, device frame].
        inertia: the fit with too wide intervals, or None where the linear method already failed.
    """
    sizes = [float(np.linalg.norm(r, axis=1).mean()) for r in rates]
    means = [r.mean(axis=0) for r in rates]
    away = []
    for r, mean in zip(rates, means, strict=True):
        cosine = (r @ mean) / np.maximum(np.linalg.norm(r, axis=1) * np.linalg.norm(mean), 1e-300)
        away.append(float(np.degrees(np.arccos(np.clip(cosine, -1, 1)).max())))
    k = int(np.argmax(away))
    toward = means[k] / max(float(np.linalg.norm(means[k])), 1e-300)
    text = ", ".join(f"{x:.2f}" for x in toward)
    if away[k] < LIMITS.max_steady_angle:
        return (
            f"the rates ({sizes[k]:.3g} rad/s) stay within {away[k]:.2g}° of one direction of the device, ({text}): "
            "the body spins about a principal axis, or is a sphere; either way the log does not determine the moments. "
            "Throw it with a tumble, best about its middle axis."
        )
    if inertia is None:
        return (
            f"within the noise, bodies of quite different moments fit the rates ({sizes[k]:.3g} rad/s, up to "
            f"{away[k]:.0f}° from ({text})). Throw it longer or faster{_tumble(away[k])}, or give more throws of it."
        )
    half = 0.5 * np.diff(inertia.ratios.interval(), axis=1)[:, 0]
    return (
        f"the intervals of I1/I3 and I2/I3 are ±{half[0]:.2g} and ±{half[1]:.2g}, too wide to say something; the rates "
        f"stay within {away[k]:.0f}° of ({text}). Throw it longer{_tumble(away[k])}, or give more throws of it."
    )


def _tumble(away: float) -> str:
    """Return the advice to let a body tumble, unless it did."""
    return "" if away > LIMITS.max_upright_angle else ", with a tumble about its middle axis"
