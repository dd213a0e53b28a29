"""Thermal spin, against integrals of the Boltzmann distribution."""

import mpmath
import numpy as np
import pytest
from scipy import constants

from polhode import analysis
from polhode.errors import InvalidInput

WATER = np.array([1.02051e-47, 1.91811e-47, 2.93863e-47])


def test_each_component_has_the_mean_square_of_the_distribution():
    """∫ L² exp(−L²/2IkT) dL over ∫ exp(−L²/2IkT) dL, in units of 1e-34 kg m²/s."""
    found = analysis.thermal_momentum(WATER, 300.0)
    for moment, component in zip(WATER, found, strict=True):
        width = moment * constants.k * 300.0 / 1e-68
        weight = lambda x, width=width: mpmath.exp(-x * x / (2 * width))  # noqa: E731
        mean = mpmath.quad(lambda x, w=weight: x * x * w(x), [-200, 0, 200]) / mpmath.quad(weight, [-200, 0, 200])
        assert (component / 1e-34) ** 2 == pytest.approx(float(mean), rel=1e-12)
    assert 0.5 * np.sum(found**2 / WATER) == pytest.approx(1.5 * constants.k * 300.0, rel=1e-15)


def test_the_rotational_temperature_is_that_of_the_rotational_constant():
    """h c B/k, with B of water in 1/cm from its moments by 16.857629206 u Å²/cm."""
    per_cm = 16.857629206 / (WATER / (constants.physical_constants["atomic mass constant"][0] * 1e-20))
    wanted = constants.h * constants.c * 100.0 * per_cm / constants.k
    assert analysis.rotational_temperature(WATER) == pytest.approx(wanted, rel=1e-8)


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda: analysis.thermal_momentum(WATER, 0.0), "`temperature` must be positive"),
        (lambda: analysis.thermal_momentum(WATER, np.inf), "`temperature` must be positive"),
        (lambda: analysis.thermal_momentum(-WATER, 1.0), "not negative"),
        (lambda: analysis.rotational_temperature((1.0, 0.0, 1.0)), "positive"),
        (lambda: analysis.rotational_temperature((1.0, 2.0)), "shape"),
    ],
)
def test_what_is_refused(call, words):
    with pytest.raises(InvalidInput, match=words):
        call()
