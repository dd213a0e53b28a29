"""Confidence intervals of estimates."""

import numpy as np
import pytest

from polhode.errors import InvalidInput
from polhode.estimation import Estimate


def test_intervals_of_the_tables():
    """1.96 of the normal distribution and 2.571 of Student's t with five degrees of freedom."""
    value, covariance = np.array([1.0, -2.0]), np.diag([4.0, 0.25])
    known = Estimate(("a", "b"), value, covariance).interval()
    np.testing.assert_allclose(known, [[1 - 3.92, 1 + 3.92], [-2 - 0.98, -2 + 0.98]], atol=1e-3)
    few = Estimate(("a", "b"), value, covariance, 5.0).interval()
    np.testing.assert_allclose(few[:, 1] - value, [2 * 2.5706, 0.5 * 2.5706], rtol=1e-4)


def test_correlations_beside_what_has_no_error():
    correlation = Estimate(("a", "b", "c"), np.zeros(3), np.array([[4.0, 1, 0], [1, 1, 0], [0, 0, 0]])).correlation
    np.testing.assert_allclose(correlation, [[1, 0.5, 0], [0.5, 1, 0], [0, 0, 0]])


@pytest.mark.parametrize("confidence", [0.0, 1.0, -1.0, 95.0])
def test_a_confidence_that_is_none(confidence):
    with pytest.raises(InvalidInput, match="`confidence` must be between 0 and 1"):
        Estimate(("a",), np.zeros(1), np.eye(1)).interval(confidence)
