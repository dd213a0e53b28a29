"""The derivative of a Lagrange top's numbers against central differences, on NumPy, where tops are special too."""

import math

import numpy as np
import pytest

from polhode.exact.lagrange_top._geometry import REGIMES, characteristics
from polhode.exact.lagrange_top._geometry_tangent import changed_numbers
from polhode.exact.lagrange_top._preparation import prepare
from polhode.exact.lagrange_top._tangent import tangent_data
from polhode.exact.lagrange_top.steady_precession import steady_precession

STEP, BY_DIFFERENCES = 1e-5, 3e-8
"""Central differences leave h² times third derivatives of up to a hundred, 1e-8, and rounding over h, 1e-11."""
TILTED, UPRIGHT, DOWN = (0.75**0.5, 0.5, 0.0, 0.0), (1.0, 0.0, 0.0, 0.0), (0.0, 1.0, 0.0, 0.0)
TURNS = 2, 3, 4
"""Period, precession and spin per period: of a steady top turning points part like a root."""
ALL = 0, 1, 2, 3, 4, 5, 6
UP_TO_HALF_TURNS = 0, 1, 2, 3, 4
"""Where the axis passes a vertical the azimuth jumps by half a turn, and with it the rates."""
STEADY = steady_precession((1.0, 1.0, 0.5), 1.0, math.pi / 3, 5.0)
TOPS = {
    "generic": (1.0, (0.3, 0.4, 1.0), TILTED, ALL),
    "below": (-0.7, (0.3, 0.4, 1.0), TILTED, ALL),
    "free": (0.0, (0.3, 0.4, 1.0), TILTED, ALL),
    "all but steady": (1.0, (0.0, STEADY.slow * math.sin(math.pi / 3), 2.5), TILTED, TURNS),
    "planar": (0.7, (0.3, 0.0, 0.0), TILTED, UP_TO_HALF_TURNS),
    "turning over": (0.7, (3.0, 0.0, 0.0), TILTED, UP_TO_HALF_TURNS),
    "through the vertical": (0.7, (0.3, 0.1, 0.5), UPRIGHT, UP_TO_HALF_TURNS),
}
NONE = {
    "sleeping": (0.7, (0.0, 0.0, 3.0), UPRIGHT), "hanging": (0.7, (0.0, 0.0, 3.0), DOWN),
    "rest": (0.0, (0.0, 0.0, 0.0), TILTED), "separatrix": (1.0, (2.0, 0.0, 0.0), DOWN),
}  # fmt: skip


def arrays(mgl, momentum, attitude):
    return [np.array([x]) for x in ((1.0, 1.0, 0.5), (mgl,), momentum, attitude)]


@np.errstate(all="ignore")
def found_and_differences(name, factor=1.0):
    top = arrays(*TOPS[name][:3])
    ways = [np.random.default_rng(3).normal(size=x.shape) * 0.3 for x in top]
    ways[0][:, 1] = ways[0][:, 0]

    def numbers(step):
        return np.array(characteristics(*(x + step * v for x, v in zip(top, ways, strict=True)))[1:])[:, 0]

    change = numbers(STEP) - numbers(-STEP)
    change[3:5] = np.remainder(change[3:5] + math.pi / 2, math.pi) - math.pi / 2
    values = tuple(characteristics(*top)[1:])
    found = np.array(changed_numbers(tangent_data(prepare(*top)), values, tuple(ways)))
    which = list(TOPS[name][3])
    return factor * found[which, 0], change[which] / (2 * STEP)


def deviation(found, wanted):
    return np.abs(found - wanted).max() / (1.0 + np.abs(wanted).max())


@pytest.mark.parametrize("name", TOPS)
def test_derivatives_agree_with_differences(name):
    assert deviation(*found_and_differences(name)) < BY_DIFFERENCES


def test_a_wrong_derivative_is_caught():
    assert deviation(*found_and_differences("generic", factor=1.0 + 1e-6)) > BY_DIFFERENCES


@pytest.mark.parametrize("name", NONE)
def test_numbers_that_are_undefined_have_no_derivative(name):
    top = arrays(*NONE[name])
    with np.errstate(all="ignore"):
        values = characteristics(*top)
        assert REGIMES[int(values.regime[0])] == name
        ways = tuple(np.ones_like(x) for x in top)
        assert np.isnan(changed_numbers(tangent_data(prepare(*top)), tuple(values[1:]), ways)).all()
