"""The light curve of a tumbling ellipsoid, and its frequencies."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from polhode._base import check
from polhode._base.arrays import known_numbers_only
from polhode.errors import InvalidInput
from polhode.exact.free_body.motion import FreeMotion
from polhode.motion._inputs import number_of
from polhode.types import Array, ArrayLike, Float64, Integer, Real


class SeriesLimits(NamedTuple):
    """What decides how many orders of both angles a light curve is expanded in."""

    max_outermost: float = 1e-6  # of the brightness, in the outermost orders
    max_samples: int = 512  # of a rotation


LIMITS = SeriesLimits()


class LightCurveLines(NamedTuple):
    """The frequencies of a light curve, strongest first.

    Attributes:
        precession_order: (k,) m of the frequency m/P_φ + n/P_ψ, P_φ being of the encircled axis.
        rotation_order: (k,) n.
        frequency: (k,) [Hz], positive.
        amplitude: (k,) of the oscillation [mag].
    """

    precession_order: Integer[Array, "k"]
    rotation_order: Integer[Array, "k"]
    frequency: Float64[Array, "k"]
    amplitude: Float64[Array, "k"]


@known_numbers_only
def ellipsoid_brightness(
    semi_axes: Real[ArrayLike, "3"], to_sun: Real[ArrayLike, "*shape 3"], to_observer: Real[ArrayLike, "*shape 3"]
) -> Float64[Array, "*shape"]:
    """Return the light that an ellipsoid sends to an observer, over π a b times the light at full phase along c.

    Every point scatters by the law of Lommel and Seeliger, μ₀ μ/(μ₀ + μ) with the cosines of incidence and emission,
    and shadows need no search as the body is convex. The integral over the part that is both lit and visible is closed
    (Muinonen & Lumme, A&A 584, A23, 2015).

    Args:
        semi_axes: a, b, c along the body's x, y, z.
        to_sun: (…, 3) directions to the light, in body axes; their size does not matter.
        to_observer: (…, 3) directions to the observer, in body axes.

    Raises:
        InvalidInput: if a semi-axis is not positive and finite, or a direction is zero or not finite.

    Example:
        >>> round(float(ellipsoid_brightness([2.0, 1.0, 1.0], [0, 0, 1.0], [0, 0, 1.0])), 12)
        1.0
        >>> round(float(ellipsoid_brightness([2.0, 1.0, 1.0], [1.0, 0, 0], [1.0, 0, 0])), 12)
        0.5
    """
    axes = check.array("semi_axes", semi_axes, (3,), above=0)
    sun, observer = _directions("to_sun", to_sun) / axes, _directions("to_observer", to_observer) / axes
    view, lit = np.linalg.norm(observer, axis=-1), np.linalg.norm(sun, axis=-1)
    # the ellipsoid is a sphere in coordinates over its semi-axes: an angle there takes the place of the phase angle
    cross = np.linalg.norm(np.cross(sun, observer), axis=-1)
    phase = np.arctan2(cross, (sun * observer).sum(axis=-1))
    both = np.linalg.norm(sun + observer, axis=-1)
    # angles of light and observer from their sum in these coordinates; they add up to the phase angle (Muinonen & Lumme
    # 2015)
    toward = np.arctan2(view * np.sin(phase), lit + view * np.cos(phase))
    rest = phase - toward
    with np.errstate(divide="ignore", invalid="ignore"):
        bent = np.sin(toward) * np.sin(rest) * np.log(1.0 / (np.tan(0.5 * toward) * np.tan(0.5 * rest)))
    bent = np.where(np.isfinite(bent), bent, 0.0)
    with np.errstate(divide="ignore", invalid="ignore"):
        light = axes[2] * view * lit / both * (np.cos(rest) + np.cos(toward) - bent)
    return np.where(both > 0, np.maximum(light, 0.0), 0.0)


@known_numbers_only
def light_curve(
    motion: FreeMotion,
    times: Real[ArrayLike, "time"],
    semi_axes: Real[ArrayLike, "3"],
    to_sun: Real[ArrayLike, "3"],
    to_observer: Real[ArrayLike, "3"],
) -> Float64[Array, "time"]:
    """Return the magnitude of a tumbling ellipsoid at given times, over its mean brightness along c.

    Args:
        motion: of one body; ``semi_axes`` are along its axes.
        times: [s].
        semi_axes: of the ellipsoid, in any unit.
        to_sun: direction to the Sun, in space axes.
        to_observer: direction to the observer, in space axes.

    Raises:
        InvalidInput: if the observer sees the dark side (at a phase angle of 180°), or for bad semi-axes or directions.

    Example:
        >>> motion = FreeMotion([0.61, 0.965, 1.0], momentum=[0.0, 0.8, 0.6])
        >>> light_curve(motion, [0.0, 1.0], [1.0, 0.7, 0.65], [1.0, 0.2, 0.0], [1.0, 0.0, 0.0]).shape
        (2,)
    """
    R = np.asarray(motion.rotation_matrix(times))
    return _magnitude(R, semi_axes, _directions("to_sun", to_sun), _directions("to_observer", to_observer))


@known_numbers_only
def light_curve_lines(
    motion: FreeMotion,
    semi_axes: Real[ArrayLike, "3"],
    to_sun: Real[ArrayLike, "3"],
    to_observer: Real[ArrayLike, "3"],
    count: int = 12,
) -> LightCurveLines:
    """Return the strongest frequencies m/P_φ + n/P_ψ of a light curve.

    The attitude is periodic but for a steady turn about L, so the magnitude is a function of two angles, which rise by
    2π in P_φ and in P_ψ. Its Fourier series in both gives every frequency and amplitude without a window, however close
    they lie (for the method, with fitted series: Pravec et al., Icarus 173, 108, 2005).

    Args:
        motion: of one body that tumbles; ``semi_axes`` are along its axes.
        semi_axes: of the ellipsoid, in any unit.
        to_sun: direction to the Sun, in space axes.
        to_observer: direction to the observer, in space axes.
        count: of frequencies.

    Raises:
        InvalidInput: if the body does not tumble (rest, permanent rotation, a sphere) or is on the separatrix, or as
            ``light_curve`` does.

    Example:
        >>> motion = FreeMotion([0.61, 0.965, 1.0], momentum=[0.0, 0.8, 0.6])
        >>> lines = light_curve_lines(motion, [1.0, 0.69, 0.65], [1.0, 0.3, 0.0], [1.0, 0.0, 0.0], 1)
        >>> lines.precession_order.tolist(), lines.rotation_order.tolist()
        ([2], [-2])
    """
    sun, observer = _directions("to_sun", to_sun), _directions("to_observer", to_observer)
    period, turn = motion.period, motion.precession_per_period
    if period is None or turn is None or not np.isfinite(period):
        raise InvalidInput(f"the motion must tumble, with two periods; got one that is {motion.regime}.")
    turns, samples = 32, 64  # of the brightness over both angles; doubled until the outermost orders are small
    while True:
        series = _series(motion, semi_axes, sun, observer, turns, samples)
        largest = np.abs(series[:, 0]).max()
        edge = max(np.abs(series[turns // 2]).max(), np.abs(series[:, samples // 2]).max())
        if edge <= LIMITS.max_outermost * max(largest, 1.0) or samples >= LIMITS.max_samples:
            break
        turns, samples = 2 * turns, 2 * samples
    m, n = np.meshgrid(np.fft.fftfreq(turns, 1 / turns), np.fft.fftfreq(samples, 1 / samples), indexing="ij")
    # the magnitude is periodic in both angles, which grow at turn/P and 2π/P
    frequency = m * (float(turn) / (2 * np.pi * float(period))) + n / float(period)
    up = frequency > 0
    # c e^{iωt} and its conjugate together swing by 2|c|
    amplitude = 2.0 * np.abs(series[up])
    best = np.argsort(-amplitude, kind="stable")[:count]
    return LightCurveLines(m[up][best].astype(np.int64), n[up][best].astype(np.int64), frequency[up][best],
                           amplitude[best])


def _series(motion: FreeMotion, semi_axes: ArrayLike, sun: Array, observer: Array, turns: int, samples: int) -> Array:
    """Return the Fourier coefficients (turns, samples) of the magnitude over both angles."""
    period, turn = number_of(motion.period), number_of(motion.precession_per_period)
    begin = float(motion.epoch)
    times = begin + period * np.arange(samples) / samples
    R = np.asarray(motion.rotation_matrix(times))
    axis = R[0] @ np.asarray(motion.momentum(begin))
    axis = axis / np.linalg.norm(axis)
    # R(t) = (turn · t/P about L) R₀(t), R₀ of period P: the steady part is taken out of the samples, and its angle put
    # in
    angles = 2 * np.pi * np.arange(turns)[:, None] / turns - turn * np.arange(samples) / samples
    # for the body, rotated about L by an angle, directions are rotated back by it
    back = -angles
    rotated = [_rotate_about(axis, direction, back) for direction in (sun, observer)]
    magnitude = _magnitude(R, semi_axes, *rotated)
    return np.fft.fft2(magnitude) / (turns * samples)


def _rotate_about(axis: Array, direction: Array, angle: Array) -> Array:
    along = (axis @ direction) * axis
    c, s = np.cos(angle)[..., None], np.sin(angle)[..., None]
    return along + c * (direction - along) + s * np.cross(axis, direction)


def _magnitude(R: Array, semi_axes: ArrayLike, sun: Array, observer: Array) -> Array:
    directions = [np.einsum("...ji,...j->...i", R, direction) for direction in (sun, observer)]
    light = ellipsoid_brightness(semi_axes, *directions)
    if not (light > 0).all():
        raise InvalidInput("the observer must see something of the lit side; got a phase angle of 180°.")
    return -2.5 * np.log10(light)


def _directions(name: str, directions: ArrayLike) -> Array:
    value = check.array(name, directions, ("…", 3))
    size = np.linalg.norm(value, axis=-1, keepdims=True)
    if not (size > 0).all():
        raise InvalidInput(f"`{name}` must be a direction, not zero.")
    return value / size
