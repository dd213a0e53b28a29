"""Sizes near the ends of double precision: something finite is made, or one message says why not; no warnings."""

import random
import warnings
from typing import Any

import numpy as np
import pytest

import polhode as ph
from polhode import celestial, rolling, spacecraft, systems
from polhode.errors import PolhodeError

SIZES = (1e-320, 1e-300, 1e-200, 1e-155, 1e-60, 1.0, 2.0, 1e60, 1e155, 1e200, 1e300, 1.7e308)
UNIT = 1e-15  # two roundings
CASES = 12  # of each
NUMBER: Any = 1.0  # where something else belongs


def made(chance):
    """Return makers of a body, a system or a motion of random sizes, by name."""
    size = lambda: chance.choice(SIZES)  # noqa: E731
    signed = lambda: chance.choice((*SIZES, 0.0, -1.0, -1e300))  # noqa: E731
    vector = lambda: (signed(), signed(), signed())  # noqa: E731

    def body():
        s = size()
        return ph.Body.from_moments((s, min(1.5 * s, 1.7e308), min(2.0 * s, 1.7e308)), mass=size())

    return {
        "disk": lambda: rolling.EulerDisk(size(), size(), gravity=size()),
        "disk with moments": lambda: rolling.EulerDisk(size(), size(), 0.0, size(), size()),
        "top": lambda: systems.HeavyTop((size(), size(), size()), signed(), vector()),
        "gyrostat": lambda: systems.Gyrostat((size(), size(), size()), vector()),
        "masses": lambda: systems.Manakov((size(), size(), signed(), size())),
        "spin and orbit": lambda: celestial.SpinOrbit(signed(), signed()),
        "drag": lambda: spacecraft.TorquedBody((size(), size(), size()), [spacecraft.LinearDrag(signed())]),
        "rotor": lambda: spacecraft.RigidBody((size(), size(), size()), [spacecraft.Wheel(vector(), size(), signed())]),
        "body": lambda: ph.Body(size(), vector(), np.diag((size(), size(), size()))),
        "about": lambda: body().about(vector()),
        "placed": lambda: body().placed((1.0, 0.0, 0.0, 0.0), vector()),
        "combined": lambda: ph.combine([body(), body().placed((1.0, 0.0, 0.0, 0.0), vector())]),
        "points": lambda: ph.Body.from_points([size() for _ in range(4)], [vector() for _ in range(4)]),
        "box": lambda: ph.shapes.box(size(), (size(), size(), size())),
        "free": lambda: ph.FreeMotion.from_body(body(), angular_velocity=vector()),
    }


@pytest.mark.parametrize("name", made(random.Random(0)))
def test_any_size_is_taken_or_refused(name):
    maker = made(random.Random(f"sizes of {name}"))[name]
    for _ in range(CASES):
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            try:
                found = maker()
            except PolhodeError:
                continue
        parts = vars(found).values() if hasattr(found, "__dict__") else [found]
        numbers = [np.asarray(x) for x in parts if isinstance(x, float) or str(getattr(x, "dtype", "")) == "float64"]
        assert numbers and all(np.isfinite(x).all() for x in numbers), found


@pytest.mark.parametrize("call", [
    lambda: rolling.EulerDisk(1e-200, 1.0), lambda: rolling.EulerDisk(1.0, 1e100),
    lambda: rolling.EulerDisk(1e300, 1.0),
    lambda: rolling.EulerDisk(1.0, 1.0, axial_moment=1e-200, diametral_moment=1.0),
    lambda: ph.Body.from_moments((1.0, 2.0, 2.5), mass=1.0).about((1e200, 0.0, 0.0)),
    lambda: systems.Manakov((1.0, 1.7e308, 1.7e308)), lambda: spacecraft.GravityGradient(NUMBER, (1.0, 2.0, 3.0)),
    lambda: systems.LiePoisson(NUMBER, lambda x: x[0]), lambda: spacecraft.TorquedBody((1.0, 2.0, 3.0), NUMBER),
    lambda: systems.LiePoisson(ph.algebra.SO3(), lambda x: x[0], conserved=NUMBER),
])  # fmt: skip
@pytest.mark.usefixtures("any_type")
def test_refused(call):
    with pytest.raises(PolhodeError):
        call()


def test_a_direction_of_any_length():
    for size in (1e300, 1.0, 1e-300):
        direction = (3.0 * size, 0.0, 4.0 * size)
        top = systems.HeavyTop((1.0, 2.0, 3.0), 1.0, direction)
        driven = systems.TorquedGyrostat((1.0, 2.0, 3.0), direction, 0.1, 0.1)
        for axis in (top.axis, driven.axis):
            assert np.abs(np.asarray(axis) - [0.6, 0.0, 0.8]).max() < UNIT
