"""FreeMotion down to the smallest numbers: components beside the leading one whose squares, or they, underflow."""

import math

import numpy as np
import pytest

import polhode as ph
from oracle.measures import error_in_eps
from starts import free_motion
from twins.families_of_bodies import Case

WORST_ERROR = 16.0
"""eps, the promise of the library."""
SMALLEST = -323
"""Power of ten of the smallest number but zero."""
COUNT = 30
FLIPPING = 1e-3
"""Part of L that is away from the middle axis where a flip is seen, less than a hundredth of a period."""


def draw(rng, leading):
    """Return moments, momentum and a time; about the middle axis in the midst of a flip."""
    moments = np.sort(rng.uniform(0.1, 1.0, 3)) * 10.0 ** rng.uniform(-1, 1)
    momentum = rng.choice((-1.0, 1.0), 3) * 10.0 ** rng.uniform(SMALLEST, -130, 3)
    momentum[leading] = rng.choice((-1.0, 1.0)) * 10.0 ** rng.uniform(-1, 1)
    motion = ph.FreeMotion(moments, momentum=momentum)
    time = 10.0 ** rng.uniform(-2, 4) / np.abs(momentum / moments).max()
    if leading == 1:
        ahead = np.linspace(0.0, motion.period, 20_001)
        away = np.abs(motion.momentum(ahead)[:, [0, 2]]).max(axis=1) / motion.momentum_norm
        time = ahead[rng.choice(np.flatnonzero(away > FLIPPING))] + motion.period * rng.integers(-3, 4)
    order = rng.permutation(3)
    return tuple(moments[order].tolist()), tuple(momentum[order].tolist()), float(time)


@pytest.mark.long_cases("1")
@pytest.mark.parametrize("leading", [0, 1, 2])
def test_tiny_components_down_to_the_smallest_numbers(leading):
    rng = np.random.default_rng(leading)
    worst = 0.0
    for _ in range(COUNT):
        case = Case("tiny", *draw(rng, leading))
        worst = max(worst, *error_in_eps(*free_motion(*case[1:3]).state(case.time), case))
    assert worst <= WORST_ERROR


@pytest.mark.parametrize("exponent", [-150, -156, -200, -310, SMALLEST])
@pytest.mark.parametrize(("leading", "beside"), [(0, 1), (1, 2), (2, 0), (2, 1)])
def test_answers_beside_a_principal_axis(leading, beside, exponent):
    moments, momentum = (1.0, 2.0, 3.0), np.zeros(3)
    momentum[leading], momentum[beside] = 1.0, 10.0**exponent
    motion = ph.FreeMotion(moments, momentum=momentum)
    if leading == 1:
        # the pair of real exponents ±λ: T = 4K/λ, K = ln(4/k'), k' the size of what is beside in units of its axis
        rate = math.sqrt(1.0 / 12.0)
        gap = math.log(4.0) - math.log(momentum[beside]) - 0.5 * math.log(4.0 / 3.0 if beside == 2 else 4.0)
        assert motion.regime == ("short-axis" if beside == 2 else "long-axis")
        assert motion.period == pytest.approx(4.0 * gap / rate, rel=1e-14)
    else:
        first, second = (moments[k] for k in range(3) if k != leading)
        I = moments[leading]  # noqa: E741
        wanted = 2.0 * math.pi / math.sqrt((I - first) / first * (I - second) / second) * I
        assert motion.regime == ("long-axis" if leading == 0 else "short-axis")
        assert motion.period == pytest.approx(wanted, rel=1e-14)
        assert motion.encircled_axis == leading


@pytest.mark.long
def test_one_such_body_does_not_fail_a_batch():
    momentum = np.array([[0.0, 1e-156, 1.0], [0.3, 1.8, 1.5], [5e-324, 1.0, 0.0]])
    attitude, found = ph.FreeMotion((1.0, 2.0, 3.0), momentum=momentum).state(1.0)
    alone = ph.FreeMotion((1.0, 2.0, 3.0), momentum=momentum[1]).state(1.0)
    assert attitude[1] == pytest.approx(alone[0], abs=1e-15) and found[1] == pytest.approx(alone[1], abs=1e-15)
    turned = math.cos(0.5 / 3.0), 0.0, 0.0, math.sin(0.5 / 3.0)
    assert attitude[0] == pytest.approx(turned, abs=1e-15)


@pytest.mark.parametrize("time", [1e30, -1e35, 1e300])
def test_times_at_which_no_digit_is_left_are_refused(time):
    free = ph.FreeMotion((1.0, 2.0, 3.0), momentum=(0.3, 1.8, 1.5))
    top = ph.LagrangeMotion((1.0, 1.0, 0.5), mgl=1.0, momentum=(0.0, 0.0, 2.5), attitude=(3**0.5 / 2, 0.5, 0.0, 0.0))
    for motion in (free, top):
        for times in (time, [0.0, time]):
            with pytest.raises(ph.InvalidInput, match=r"at most 1e\+27 rad, beyond which a phase has hardly a digit"):
                motion.state(times)
    slow = ph.FreeMotion((1.0, 2.0, 3.0), momentum=np.array([0.3, 1.8, 1.5]) / abs(time))
    assert np.isfinite(slow.momentum(time)).all()  # a fast body of a batch does not speak for a slow one
    both = ph.FreeMotion((1.0, 2.0, 3.0), momentum=[(0.3, 1.8, 1.5), np.array([0.3, 1.8, 1.5]) / abs(time)])
    assert np.isfinite(both.momentum(np.array([1.0, time]))).all()
