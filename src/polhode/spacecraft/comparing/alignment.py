"""Constant misalignments and a constant rate between two attitude histories, by a best fit."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from polhode import rotation
from polhode._base.arrays import known_numbers_only
from polhode.analysis._attitude_noise import root_mean_square
from polhode.analysis._printing import print_answer, write_numbers
from polhode.types import Array, ArrayLike, Float64, Real


class AlignmentLimits(NamedTuple):
    """What decides whether there is an alignment, and whether it is determined."""

    min_samples: int = 10  # for nine unknowns
    settled_step: float = 1e-14  # rad; smaller steps no longer change the angles
    min_singular_value: float = 1e-7  # of the largest; below, two unknowns have one effect, as far as steps resolve it


LIMITS = AlignmentLimits()


class Alignment(NamedTuple):
    """The best alignment of history B with A: q_A(t) ≈ exp(ω (t − t₀)) S q_B(t) M.

    Attributes:
        body: (3,) rotation vector of M, between the body axes [rad, body axes of A].
        space: (3,) rotation vector of S, between the space axes at the first time [rad].
        rate: (3,) ω, at which the space axes turn against each other [rad/s].
        remaining: (T,) residual angle [rad].
        determined: whether the motion determines all nine numbers; if not, others would explain as much.
    """

    body: Float64[Array, "3"]
    space: Float64[Array, "3"]
    rate: Float64[Array, "3"]
    remaining: Float64[Array, "time"]
    determined: bool

    @property
    def rms(self) -> float:
        """Root mean square of the remaining angle [rad]."""
        return float(np.sqrt(np.mean(self.remaining**2)))

    def __str__(self) -> str:
        determined = "" if self.determined else "; others would explain as much"
        return print_answer(
            f"aligned, {write_numbers(self.rms, 'rad')} are left (rms){determined}",
            turn_of_the_body_axes=write_numbers(self.body, "rad"),
            turn_of_the_space_axes=write_numbers(self.space, "rad"),
            rate_of_the_space_axes=write_numbers(self.rate, "rad/s"),
        )


@known_numbers_only
def fit_alignment(
    times: Real[ArrayLike, "time"], a: Real[ArrayLike, "time 4"], b: Real[ArrayLike, "time 4"]
) -> Alignment | None:
    """Return the best alignment of attitude b (T, 4) with a (T, 4) at times [s]; None for fewer than ten samples.

    Means of quaternions start it, Gauss and Newton's steps on the remaining rotation vectors end it.

    Source: Markley et al., J. Guid. Control Dyn. 30 (2007) 1193, for the means.
    """
    most = 20_000  # samples of the fit, evenly chosen
    rounds = 30
    if len(times) < LIMITS.min_samples:
        return None
    chosen = np.unique(np.linspace(0, len(times) - 1, min(len(times), most)).round().astype(int))
    middle, half = 0.5 * (times[0] + times[-1]), 0.5 * (times[-1] - times[0])
    some = (times[chosen] - middle) / half, a[chosen], b[chosen]
    candidate = min(_guess_start(*some), key=lambda fit: root_mean_square(_remainder(*fit, *some)))
    best, rank = candidate, 0
    for _ in range(rounds):
        candidate, step, rank = _improve(*candidate, *some)
        if root_mean_square(_remainder(*candidate, *some)) <= root_mean_square(_remainder(*best, *some)):
            best = candidate
        if step < LIMITS.settled_step:
            break
    body, space, turn = best
    rest = _remainder(*best, (times - middle) / half, a, b)
    first = rotation.multiply(rotation.from_rotation_vector(-turn), space)
    return Alignment(
        rotation.as_rotation_vector(body), rotation.as_rotation_vector(first), turn / half,
        np.linalg.norm(rest, axis=-1), rank == 9,
    )


@known_numbers_only
def mean_quaternion(quaternions: Real[ArrayLike, "count 4"]) -> Float64[Array, "4"]:
    """Return the quaternion (4,) nearest to many (T, 4), whatever their signs."""
    return np.linalg.eigh(quaternions.T @ quaternions)[1][:, -1]


def _guess_start(scaled: Array, a: Array, b: Array) -> list[tuple[Array, Array, Array]]:
    """Return first guesses of body and space misalignment, each first alone, then in turns."""
    one, still = np.array([1.0, 0.0, 0.0, 0.0]), np.zeros(3)
    guesses: list[tuple[Array, Array, Array]] = [(one, one, still)]
    for body_first in (True, False):
        body = space = one
        for k in range(8):
            if (k % 2 == 0) == body_first:
                body = mean_quaternion(rotation.multiply(rotation.conjugate(rotation.multiply(space, b)), a))
            else:
                space = mean_quaternion(rotation.multiply(a, rotation.conjugate(rotation.multiply(b, body))))
            guesses.append((body, space, still))
    return guesses


def _apply_fit(body: Array, space: Array, turn: Array, scaled: Array, b: Array) -> tuple[Array, Array]:
    """Return b rotated by the fit, and the rotation of space by the rate alone."""
    drift = rotation.from_rotation_vector(turn * scaled[:, None])
    return rotation.multiply(rotation.multiply(drift, rotation.multiply(space, b)), body), drift


def _remainder(body: Array, space: Array, turn: Array, scaled: Array, a: Array, b: Array) -> Array:
    """Return the residual rotation vectors (T, 3), along the body axes."""
    fitted, _ = _apply_fit(body, space, turn, scaled, b)
    return rotation.as_rotation_vector(rotation.multiply(rotation.conjugate(fitted), a))


def _improve(
    body: Array, space: Array, turn: Array, scaled: Array, a: Array, b: Array
) -> tuple[tuple[Array, Array, Array], float, int]:
    """Return a fit improved by one step, the step's size [rad], and the number of unknowns that the motion determines.

    To first order the residual is δm + Cᵀ(D δs + J τ δω), with C the fitted attitude, D the drift's rotation and J its
    left Jacobian.
    """
    fitted, drift = _apply_fit(body, space, turn, scaled, b)
    left = rotation.as_rotation_vector(rotation.multiply(rotation.conjugate(fitted), a))
    back = np.swapaxes(rotation.as_matrix(fitted), -1, -2)
    by_rate = _left_jacobian(turn * scaled[:, None]) * scaled[:, None, None]
    design = np.concatenate(
        [np.broadcast_to(np.eye(3), back.shape), back @ rotation.as_matrix(drift), back @ by_rate], axis=-1
    )
    step, _, rank, _ = np.linalg.lstsq(design.reshape(-1, 9), left.reshape(-1), rcond=LIMITS.min_singular_value)
    fit = (
        rotation.normalize(rotation.multiply(body, rotation.from_rotation_vector(step[:3]))),
        rotation.normalize(rotation.multiply(rotation.from_rotation_vector(step[3:6]), space)),
        turn + step[6:],
    )
    return fit, float(np.abs(step).max()), int(rank)


def _left_jacobian(vectors: Array) -> Array:
    """Return J (T, 3, 3) with exp(v + δ) ≈ exp(J δ) exp(v)."""
    angle = np.linalg.norm(vectors, axis=-1)[:, None, None]
    safe = np.where(angle > 0.0, angle, 1.0)
    first = np.where(angle < 1e-4, 0.5, (1.0 - np.cos(safe)) / safe**2)
    second = np.where(angle < 1e-3, 1.0 / 6.0, (safe - np.sin(safe)) / safe**3)
    skew = rotation.hat(vectors)
    return np.eye(3) + first * skew + second * (skew @ skew)
