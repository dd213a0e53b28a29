"""Laws of an exact motion."""

from __future__ import annotations

from typing import Any, NamedTuple

import jax
import jax.numpy as jnp
import numpy as np

from polhode import rotation
from polhode.errors import InvalidInput, shown
from polhode.motion._fields import register_fields
from polhode.motion.base import AbstractMotion
from polhode.testing.laws import LawBroken, hold
from polhode.types import Array

TURN = np.array([0.8, 0.36, -0.48, 0.0])  # to other axes of the body


class MotionLimits(NamedTuple):
    """A tolerance of these checks."""

    rounding: float = 1e-9  # relative; a closed form some turns after its epoch, and more than a wrong one is off by


LIMITS = MotionLimits()


def check_motion(motion: AbstractMotion) -> None:
    """Check an exact motion of one body: its start, its kinematics, what it conserves, batches, other axes, and JAX.

    The torque is not known here; compare with ``simulate`` where there is a system that moves so.

    Args:
        motion: of one body, of NumPy arrays.

    Raises:
        LawBroken: naming the first law that fails.
        InvalidInput: for anything but a motion in closed form, and for a batch.

    >>> from polhode import FreeMotion
    >>> check_motion(FreeMotion((1.0, 2.0, 3.0), momentum=(0.3, 1.8, 1.5)))
    """
    cycles, samples = 2.0, 9
    if not isinstance(motion, AbstractMotion) or motion.batch_shape:
        raise InvalidInput(f"`motion` must be one motion in closed form; got {shown(motion)}.")
    times = float(motion.epoch) + np.linspace(-0.5, cycles, samples) * motion.cycle
    states = motion.state(times)
    start = motion.state(float(motion.epoch))
    given = motion.attitude_at_epoch, motion.momentum_at_epoch
    hold("the state at the epoch is the given one", start, given, LIMITS.rounding)
    hold("attitudes are unit quaternions", np.linalg.norm(states[0], axis=-1), np.ones(samples), LIMITS.rounding)
    one_by_one = tuple(map(np.stack, zip(*(motion.state(float(t)) for t in times), strict=True)))
    hold("many times = one after the other", states, one_by_one, LIMITS.rounding)
    _check_kinematics(motion, times)
    _check_conserved(motion, times)
    _check_batch(motion, times)
    _check_axes(motion, times)
    _check_jax(motion, times, states)


def _check_kinematics(motion: AbstractMotion, times: Array) -> None:
    # rad, by which the fastest of bodies turns in a step of differences of fourth order: they leave out 1e-12
    angle = 2e-3
    rate = float(motion.fastest_rate) or 1.0
    step = angle / rate
    one, two = ([motion.attitude(times + sign * k * step) for sign in (1, -1)] for k in (1, 2))
    change = (8.0 * (one[0] - one[1]) - (two[0] - two[1])) / (12.0 * angle)  # per rad
    velocity = np.concatenate([np.zeros((len(times), 1)), motion.angular_velocity(times) / rate], axis=-1)
    turning = 0.5 * rotation.multiply(motion.attitude(times), velocity)
    hold("the attitude turns at Ω: dq/dt = ½ q Ω", change, turning, LIMITS.rounding)


def _check_conserved(motion: AbstractMotion, times: Array) -> None:
    trajectory = motion.sample(times)
    names = set(trajectory.invariants), set(trajectory.drift)
    if not set(motion.quantities) == names[0] == names[1]:
        raise LawBroken(f"`quantities` names what `conserved_along` returns; it has {shown(list(motion.quantities))}, "
                        f"and that {shown(list(trajectory.invariants))}.")
    for name, drift in trajectory.drift.items():
        if not np.max(drift) <= LIMITS.rounding:
            raise LawBroken(f"{name} is conserved; it drifts by {float(np.max(drift)):.3g}, relative.")


def _check_batch(motion: AbstractMotion, times: Array) -> None:
    """Check two bodies of which one starts later against this one at other times."""
    register_fields(type(motion), motion.body_numbers)
    later = 0.3 * motion.cycle

    def two(path: Any, leaf: Array) -> Array:
        return np.stack([leaf, leaf + later * (path[-1].name == "epoch")])

    both = jax.tree_util.tree_map_with_path(two, motion)
    each = motion.state(np.stack([times[1], times[2] - later]))
    hold("a batch = one body after the other", both.state(times[1:3]), each, LIMITS.rounding)
    of_all = both.sample(times)
    each = motion.state(np.stack([times, times - later]))
    hold("a sampled batch = one body after the other", (of_all.attitude, of_all.momentum), each, LIMITS.rounding)


def _check_axes(motion: AbstractMotion, times: Array) -> None:
    axes = np.asarray(rotation.as_matrix(TURN))
    plain, rotated = motion.along("principal"), motion.along("principal").along(axes)
    if motion.given_axes is not None:
        axes = np.asarray(motion.given_axes).T @ axes
    momentum, matrices = plain.momentum(times) @ axes, plain.rotation_matrix(times) @ axes
    hold("other axes turn the momentum", rotated.momentum(times), momentum, LIMITS.rounding)
    hold("other axes turn the attitude", rotated.rotation_matrix(times), matrices, LIMITS.rounding)


def _check_jax(motion: AbstractMotion, times: Array, states: tuple[Array, Array]) -> None:
    try:
        with jax.enable_x64(True):
            by_jax = jax.jit(lambda m, t: m.state(t))(jax.tree.map(jnp.asarray, motion), jnp.asarray(times))
    except (jax.errors.JAXTypeError, jax.errors.JAXIndexError) as error:
        said = str(error).splitlines()[0]
        raise LawBroken(
            f"JAX arrays in, JAX arrays out: `closed_form` and `fastest_rate` cannot be traced ({said}). Write them by "
            "the arrays' own methods, polhode.rotation, or the namespace of the arrays."
        ) from error
    hold("JAX gives the states of NumPy", by_jax, states, LIMITS.rounding)
