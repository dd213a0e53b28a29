"""LagrangeMotion over every nasty family: mixed batches, and errors that do not grow. tests/twins has all errors."""

from __future__ import annotations

import numpy as np
import pytest

from oracle.numpy_alone import compiled_alone, numpy_alone, python_alone, under
from starts import lagrange_motion
from twins.families_of_tops import TopCase, draw_tops
from twins.motions import PROMISE, by_oracle, drawn, errors
from twins.motions_implementations import at_once

MIXED_PER_FAMILY = 3
FAST = ("scaled", "wide_ratio", "huge_spin")
"""Families whose spin may be far faster than what their times are drawn by."""


def many_states(cases: list[TopCase]) -> tuple[np.ndarray, np.ndarray]:
    *top, times = (np.array([case[i] for case in cases], dtype=np.float64) for i in range(1, 6))
    return lagrange_motion(*top).state(times)


@pytest.mark.long
def test_a_mixed_batch_equals_its_tops_one_by_one():
    """By Numba and by Python, to the bit."""
    cases = draw_tops(MIXED_PER_FAMILY, 5)
    attitudes, momenta = under(compiled_alone, many_states)(cases)
    others = under(python_alone, many_states)(cases)
    assert np.array_equal(attitudes, others[0]) and np.array_equal(momenta, others[1])
    for case, attitude, momentum in zip(cases, attitudes, momenta, strict=True):
        alone = lagrange_motion(*case[1:5]).state(case.time)
        assert np.array_equal(alone[0], attitude) and np.array_equal(alone[1], momentum), case


def test_the_error_does_not_grow_with_time():
    """One top of each regime at 1, 1e4, 1e8 and 1e12."""
    motions = [motion._replace(time=time, epoch=0.0) for motion in drawn("top", 1, 3) for time in (1.0, 1e4, 1e8, 1e12)
               if motion.family not in FAST]  # fmt: skip
    assert errors(under(numpy_alone, at_once)(motions), by_oracle(motions)).worst.max() <= PROMISE
