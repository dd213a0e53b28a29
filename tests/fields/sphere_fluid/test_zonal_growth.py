"""Growth of waves on zonal flows: published numbers, waves that go round westward, and what is refused."""

import math

import numpy as np
import pytest

from polhode.errors import InvalidInput
from polhode.fields import SphereFluid, SphereMHD, zonal_growth
from polhode.systems import FreeRigidBody

JET = {(3, 0): math.sqrt(4.0 * math.pi)}  # √7 P₃ of the sine of latitude


@pytest.mark.long_cases("1-0.0758683-0.0760157614")
@pytest.mark.parametrize(("order", "of_32", "exact"), [(1, 0.0758683, 0.0760157614), (2, 0.2582766, 0.2589748314)])
def test_a_jet_has_the_published_growth(order, of_32, exact):
    fluid = SphereFluid(32)
    rate = zonal_growth(fluid, fluid.from_harmonics(JET), order).rate
    assert rate == pytest.approx(of_32, abs=1e-7) and 0.0 < exact - rate < 1.0 / 32**2


@pytest.mark.long
def test_a_field_that_vanishes_changes_nothing_and_a_strong_one_holds():
    fluid, magnetic = SphereFluid(12), SphereMHD(12)
    alone = zonal_growth(fluid, fluid.from_harmonics(JET), 2)
    assert zonal_growth(magnetic, magnetic.from_harmonics(JET, {}), 2).rate == pytest.approx(alone.rate, rel=1e-12)
    held = zonal_growth(magnetic, magnetic.from_harmonics(JET, {(1, 0): 20.0}), 2)
    assert abs(held.rate) < 0.2 * alone.rate


@pytest.mark.long_cases("1")
@pytest.mark.parametrize("order", [1, 2])
def test_planetary_waves_go_round_westward(order):
    """Of a fluid at rest on a rotating sphere c = −2Ω/(l(l + 1)); waves that are not zonal do not count."""
    fluid = SphereFluid(4, 1.3)
    result = zonal_growth(fluid, fluid.from_harmonics({(2, 1): 3.0}), order)
    speeds = np.array([-2.6 / (degree * (degree + 1)) for degree in range(order, 4)])
    assert abs(result.rate) < 1e-14 and np.abs(result.frequency / order - speeds).min() < 1e-14


@pytest.mark.usefixtures("any_type")
def test_what_is_refused():
    fluid = SphereFluid(6)
    for order in (0, 6, 1.5, True):
        with pytest.raises(InvalidInput, match="`order` must be a whole number from 1 to 5"):
            zonal_growth(fluid, fluid.from_harmonics(JET), order)
    with pytest.raises(InvalidInput, match="SphereFluid or a SphereMHD; got FreeRigidBody"):
        zonal_growth(FreeRigidBody((1.0, 2.0, 3.0)), np.zeros(3), 1)
