"""Absolute moments from their ratios and one more number, as free motion gives ratios only."""

from __future__ import annotations

import numpy as np
from scipy.spatial.transform import Rotation

from polhode._base import check
from polhode._base.arrays import known_numbers_only
from polhode.errors import InvalidInput
from polhode.estimation._estimate import Estimate
from polhode.measuring.attitudes.attitude_fit import AttitudeFit
from polhode.measuring.throws.throw import ThrowFit
from polhode.types import Array, ArrayLike, Real

NAMES = ("I1", "I2", "I3")
# entries across the diagonal count twice, so that the norm of six numbers is that of the matrix
ROOT = np.array([1.0, 1.0, 1.0, 2.0, 2.0, 2.0]) ** 0.5
ENTRIES = (0, 1, 2, 0, 0, 1), (0, 1, 2, 1, 2, 2)


@known_numbers_only
def moments_from_one(
    fit: ThrowFit | AttitudeFit, axis: int, moment: float, standard_error: float = 0.0
) -> Estimate:
    """Return I1, I2, I3 [kg m²] of a body one of whose principal moments is given.

    Args:
        fit: of its throws.
        axis: 1, 2 or 3, the axis of the given moment, in the order of the moments.
        moment: I_axis [kg m²].
        standard_error: of the moment [kg m²].

    Raises:
        InvalidInput: for a degenerate fit, or a moment that is not positive.

    Example:
        >>> import numpy as np
        >>> from polhode import FreeMotion
        >>> from polhode.measuring import fit_attitude
        >>> t = np.arange(0.0, 2.0, 0.02)
        >>> turns = FreeMotion((0.2, 0.8, 1.0), angular_velocity=(1.0, 5.0, 1.0)).attitude(t)
        >>> moments_from_one(fit_attitude(t, turns), 3, 2.0).value.round(6).tolist()
        [0.4, 1.6, 2.0]
    """
    joint = _joint(fit)
    axis = check.whole("axis", axis, 1, 3)
    moment = check.number("moment", moment, "kg m²", above=0)
    standard_error = check.number("standard_error", standard_error, "kg m²", least=0)
    ratios = np.r_[joint.value[:2], 1.0]
    value = moment * ratios / ratios[axis - 1]
    # derivatives of moment · ratio_i/ratio_axis by the ratios and the moment
    by = np.zeros((3, 3))  # of the two ratios and the moment
    by[:2, :2] = np.eye(2) * moment / ratios[axis - 1]
    if axis < 3:
        by[:, axis - 1] -= value / ratios[axis - 1]
    by[:, 2] = value / moment
    known = np.zeros((3, 3))
    known[:2, :2], known[2, 2] = joint.covariance[:2, :2], standard_error**2
    return Estimate(NAMES, value, by @ known @ by.T, joint.degrees_of_freedom)


@known_numbers_only
def moments_from_weight(
    fit: ThrowFit | AttitudeFit, with_weight: ThrowFit | AttitudeFit, mass: float, weight: float,
    place: Real[ArrayLike, "3"],
) -> Estimate:
    """Return I1, I2, I3 [kg m²] of a body that was thrown without and with a small weight on it.

    About the common centre of mass the weight adds μ (|r|² − r rᵀ), μ = m M/(m + M): six equations for the two scales.

    Args:
        fit: of throws of the body alone.
        with_weight: of throws with the weight.
        mass: M of the body [kg].
        weight: m of the weight [kg].
        place: (3,) r of the weight from the body's own centre of mass [m, device frame].

    Raises:
        InvalidInput: for degenerate fits, masses that are not positive, or a weight at the centre of mass.
    """
    joints = _joint(fit), _joint(with_weight)
    mass = check.number("mass", mass, "kg", above=0)
    weight = check.number("weight", weight, "kg", above=0)
    r = check.array("place", place, (3,), "m", not_all_zero=True)
    added = mass * weight / (mass + weight) * ((r @ r) * np.eye(3) - np.outer(r, r))
    values = np.concatenate([joint.value for joint in joints])
    covariance = np.zeros((10, 10))
    covariance[:5, :5], covariance[5:, 5:] = (joint.covariance for joint in joints)
    axes = _axes(fit), _axes(with_weight)

    def scales(x: Array, weights: Array) -> Array:
        # I3′ j′ − I3 j = what the weight adds, with j and j′ the inertia over I3: linear in the scales I3, I3′
        columns = np.stack([-_entries(x[:5], axes[0]), _entries(x[5:], axes[1])], axis=1)
        return np.linalg.lstsq(weights @ columns, weights @ (_six(added)), rcond=None)[0]

    first = scales(values, np.eye(6))
    mismatch = lambda x: first[1] * _entries(x[5:], axes[1]) - first[0] * _entries(x[:5], axes[0])  # noqa: E731
    by = _slopes(mismatch, values)
    noise = by @ covariance @ by.T
    weights = np.eye(6)
    if np.isfinite(noise).all():  # not so where one of the fits has no errors
        weights = np.linalg.inv(np.linalg.cholesky(noise + 1e-9 * np.trace(noise) * np.eye(6)))
    moments = lambda x: scales(x, weights)[0] * np.r_[x[:2], 1.0]  # noqa: E731
    slopes = _slopes(moments, values)
    freedom = [joint.degrees_of_freedom for joint in joints if joint.degrees_of_freedom is not None]
    return Estimate(NAMES, moments(values), slopes @ covariance @ slopes.T, min(freedom) if freedom else None)


def _joint(fit: ThrowFit | AttitudeFit) -> Estimate:
    if fit.joint is None:
        raise InvalidInput("the fit is degenerate, so that it has no ratios to scale. Throw the body with a tumble.")
    return fit.joint


def _axes(fit: ThrowFit | AttitudeFit) -> Array:
    assert fit.axes is not None, "a fit with ratios has axes"
    return fit.axes


def _six(J: Array) -> Array:
    return J[ENTRIES] * ROOT


def _entries(x: Array, axes: Array) -> Array:
    """Return the entries of the inertia over I3, of two ratios and a turn of the axes."""
    rotated = axes @ Rotation.from_rotvec(x[2:]).as_matrix()
    return _six(rotated @ np.diag(np.r_[x[:2], 1.0]) @ rotated.T)


def _slopes(function: object, x: Array) -> Array:
    """Return the Jacobian by central differences, of functions that are smooth over the errors of their inputs."""
    step = 1e-6
    return np.stack([(function(x + step * e) - function(x - step * e)) / (2 * step) for e in np.eye(len(x))], axis=1)  # pyright: ignore[reportCallIssue]
