"""Legendre functions of complex degree against mpmath."""

import mpmath as mp
import numpy as np
import pytest

from polhode.special._legendre import legendre_function

CLOSE = 1e-13  # relative; where κ is small the constants of the far series cancel by 1/κ


@pytest.mark.parametrize("kappa", [0.01, 0.2, 0.25, 4 / 3, 1.9])
def test_values_and_derivatives(kappa):
    function = legendre_function(kappa)
    angles = np.array([1e-6, 0.1, 1.0, 1.57, 1.58, 2.0, 3.0, 3.14159])
    values, slopes = function.values(angles)
    with mp.workdps(30):
        nu = (-1 + mp.sqrt(1 - 4 * mp.mpf(kappa))) / 2

        def legendre(angle):
            return mp.re(mp.hyp2f1(-nu, nu + 1, 1, mp.sin(angle / 2) ** 2))

        for angle, value, slope in zip(angles, values, slopes, strict=True):
            assert abs(value / legendre(mp.mpf(angle)) - 1) < CLOSE
            assert abs(slope / mp.diff(legendre, mp.mpf(angle)) - 1) < CLOSE


def test_another_degree_is_noticed():
    value = float(legendre_function(4 / 3 + 1e-9).values(np.asarray(2.0))[0])
    assert abs(value / float(legendre_function(4 / 3).values(np.asarray(2.0))[0]) - 1) > 1e2 * CLOSE
