"""Both sides of the thresholds of a rolling disk: sizes, tilts and rates just within them, and just beyond."""

import math

import jax.numpy as jnp
import numpy as np
import pytest

from polhode.errors import InvalidInput
from polhode.rolling import EulerDisk, ViscousContourFriction
from polhode.rolling.euler_disk import spin_down
from polhode.rolling.euler_disk.spin_down import LIMITS

DISK = EulerDisk(mass=0.4, radius=0.04)
FALLING = EulerDisk(mass=0.4, radius=0.04, dissipation=[ViscousContourFriction(2e-7)])


def accepted(call):
    try:
        call()
    except InvalidInput:
        return False
    return True


def both(call, within, beyond):
    """Whether a call is accepted within a threshold, and beyond it."""
    return accepted(lambda: call(within)), accepted(lambda: call(beyond))


def test_sizes_whose_products_overflow():
    assert both(lambda mass: EulerDisk(mass=mass, radius=0.04), 0.99e30, 1.01e30) == (True, False)
    assert both(lambda mass: EulerDisk(mass=mass, radius=0.04), 1.01e-30, 0.99e-30) == (True, False)


def test_tilts_at_which_a_disk_lies_flat():
    assert both(lambda tilt: DISK.rolling_state(tilt=tilt), 1.01e-6, 0.99e-6) == (True, False)


def test_velocities_that_slip():
    attitude, rate = (math.cos(0.2), math.sin(0.2), 0.0, 0.0), (0.3, 2.0, -1.0)
    velocity = np.asarray(DISK.center_velocity(DISK.pack(attitude, rate)))
    call = lambda slip: DISK.pack(attitude, rate, center_velocity=velocity * (1.0 + slip))  # noqa: E731
    assert both(call, 0.9e-6, 1.1e-6) == (True, False)


def test_rates_that_are_not_steady():
    state = np.asarray(DISK.rolling_state(tilt=0.3, precession=20.0))
    spin, tilt, w2 = (float(state[k]) for k in (7, 0, 6))
    slope = 1e3 * (float(DISK.mechanics.tilt_acceleration(jnp.asarray(tilt), jnp.asarray(w2), jnp.asarray(spin + 1e-3)))
                   - float(DISK.mechanics.tilt_acceleration(jnp.asarray(tilt), jnp.asarray(w2), jnp.asarray(spin))))
    off = (9.80665 / 0.04 + w2 * w2 + spin * spin) / slope
    call = lambda part: DISK.rolling_state(tilt=0.3, precession=20.0, spin=spin + part * off)  # noqa: E731
    assert both(call, 0.9e-9, 1.1e-9) == (True, False)
    rate = math.sqrt(9.80665 / 0.04 + w2 * w2 + spin * spin)
    moved = lambda part: DISK.steady_motion(state + np.eye(8)[5] * part * rate)  # noqa: E731
    assert both(moved, 0.9e-8, 1.1e-8) == (True, False)


def test_the_asymptotic_regime_ends():
    state = np.asarray(FALLING.rolling_state(tilt=0.05))
    rate = 0.05 * abs(float(FALLING.precession(state)))
    call = lambda ratio: spin_down._check_start(FALLING, np.where(np.arange(8) == 5, -ratio * rate, state), 4.0, 32)  # noqa: E731
    assert both(call, 0.299, 0.301) == (True, False)


@pytest.mark.parametrize("ratio, count, fits", [(0.0199, 8, True), (0.0201, 8, False), (0.0199, 7, False)])
def test_samples_that_are_fitted(ratio, count, fits):
    assert accepted(lambda: spin_down._choose_samples(np.append(np.full(count, ratio), 0.1))) == fits


def test_samples_that_one_law_rules():
    """Of 24 samples the last are fitted in which one law takes four fifths of the power, if they are eight."""
    share = lambda value, last: np.where(np.arange(24) >= 24 - last, value, 0.5)  # noqa: E731
    chosen = [spin_down._ruled_by_one(slice(0, 24), np.stack([share(value, last), 1.0 - share(value, last)], axis=-1))
              for value, last in ((0.81, 8), (0.79, 8), (0.81, 7))]  # fmt: skip
    assert chosen == [slice(16, 24), slice(0, 24), slice(0, 24)]


def test_a_motion_that_takes_too_many_steps():
    """A sample is computed where the estimate of its steps is within those that are allowed."""
    length = jnp.asarray(math.log(10.0) / 32)
    state = FALLING.rolling_state(tilt=0.05)
    estimate = LIMITS.steps_per_radian * float(spin_down._turn(FALLING, state, length))
    counts = [spin_down._Run([state], [0.0], [0.0], 0) for _ in range(2)]
    for run, steps in zip(counts, (math.ceil(estimate), math.floor(estimate)), strict=True):
        assert not spin_down._asymptotic(FALLING, run, 1.0 / 32, 32, steps)
    assert [len(run.states) for run in counts] == [2, 1]
