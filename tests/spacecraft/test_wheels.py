"""Wheels with dry friction and limits, against closed forms about one axis."""

import numpy as np
import pytest

import polhode as ph
from polhode.errors import InvalidInput
from polhode.spacecraft import RigidBody, Wheel

WHOLE, OWN = 2.5, 0.1
PAIR = OWN * (WHOLE - OWN) / WHOLE  # σ̇ = torque/PAIR, as the body turns the other way
TIMES = np.linspace(0.0, 40.0, 9)
SERIES, STEPPED = 1e-12, 1e-9  # relative: by series, and by adaptive steps over a corner


def rate_of(wheel, rate):
    body = RigidBody((1.0, 2.0, WHOLE), [wheel])
    found = ph.simulate(body, body.pack(rates=[rate], attitude=(1.0, 0.0, 0.0, 0.0)), TIMES)
    assert found.drift["energy"] < 1e-9 and found.drift["momentum_space"] < 1e-12
    return found.part("rotor_momentum") / OWN - found.angular_velocity[:, 2]


@pytest.mark.long
def test_dry_friction_stops_a_wheel_as_a_hyperbolic_sine():
    """σ̇ = −(f/PAIR) tanh(σ/σ₀): sinh(σ/σ₀) falls exponentially."""
    got = rate_of(Wheel((0, 0, 1), OWN, coulomb_friction=0.01, sliding_rate=0.5), 2.0)
    wanted = 0.5 * np.arcsinh(np.sinh(2.0 / 0.5) * np.exp(-0.01 * TIMES / (PAIR * 0.5)))
    assert np.abs(got - wanted).max() < SERIES * 2.0 * 10


@pytest.mark.long
def test_a_motor_gives_no_more_than_it_can():
    got = rate_of(Wheel((0, 0, 1), OWN, lambda t, *more: 0.3 + 0.0 * t, max_torque=0.02), 1.0)
    assert np.abs(got - (1.0 + 0.02 * TIMES / PAIR)).max() < STEPPED * 10
    wheel = Wheel((0, 0, 1), OWN, 0.3, max_torque=0.02)
    assert wheel.limited and not wheel.without_limits().limited


@pytest.mark.long
def test_a_wheel_stays_below_its_largest_rate():
    """Up to 0.99 σ_max at full torque, then by exponentials towards σ_max; braking is not limited."""
    top, torque = 5.0, 0.05
    got = rate_of(Wheel((0, 0, 1), OWN, torque, max_rate=top), 1.0)
    corner = (0.99 * top - 1.0) * PAIR / torque
    slow = 0.01 * top * PAIR / torque
    wanted = np.where(TIMES < corner, 1.0 + torque * TIMES / PAIR, top - 0.01 * top * np.exp(-(TIMES - corner) / slow))
    assert np.abs(got - wanted).max() < STEPPED * top and got.max() <= top * (1 + STEPPED)
    braked = rate_of(Wheel((0, 0, 1), OWN, -0.01, max_rate=top), 5.0)
    assert np.abs(braked - (5.0 - 0.01 * TIMES / PAIR)).max() < STEPPED * top


@pytest.mark.parametrize("name", ["max_torque", "max_rate", "sliding_rate"])
def test_limits_are_positive(name):
    with pytest.raises(InvalidInput, match=f"`{name}` must be positive and finite"):
        Wheel((0, 0, 1), OWN, **{name: -1.0})
