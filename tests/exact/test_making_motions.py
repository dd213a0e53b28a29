"""Ways to make a motion: by momentum or angular velocity, from a body or its tensor, and again with another value."""

import dataclasses

import numpy as np
import pytest

from polhode import Body, FreeMotion, LagrangeMotion, rotation, shapes
from polhode.errors import InvalidInput

TIMES = np.linspace(-3.0, 20.0, 12)


@pytest.mark.parametrize("turn", [(1.0, 0.0, 0.0, 0.0), (0.5, 0.5, 0.5, 0.5), (0.8, 0.0, 0.6, 0.0)])
def test_a_motion_is_made_again_with_another_value(turn):
    body = shapes.box(2.0, (1.0, 2.0, 3.0)).placed(turn)
    motion = FreeMotion.from_body(body, angular_velocity=(0.2, -0.4, 0.9), attitude=(0.0, 0.6, 0.0, 0.8))
    later = dataclasses.replace(motion, epoch=2.5)
    assert np.allclose(later.momentum(TIMES + 2.5), motion.momentum(TIMES), rtol=0.0, atol=1e-13)
    assert np.allclose(later.attitude(TIMES + 2.5), motion.attitude(TIMES), rtol=0.0, atol=1e-13)
    top = LagrangeMotion((1.0, 1.0, 0.5), mgl=1.0, momentum=(0.0, 0.0, 2.5), attitude=(3**0.5 / 2, 0.5, 0.0, 0.0))
    heavier = dataclasses.replace(top, mgl=2.0)
    other = LagrangeMotion((1.0, 1.0, 0.5), mgl=2.0, momentum=(0.0, 0.0, 2.5), attitude=(3**0.5 / 2, 0.5, 0.0, 0.0))
    assert np.array_equal(heavier.attitude(TIMES), other.attitude(TIMES))


def test_a_spin_may_be_an_angular_velocity():
    moments, velocity = np.array([1.0, 2.0, 3.0]), np.array([0.3, -0.9, 0.5])
    assert np.array_equal(FreeMotion(moments, angular_velocity=velocity).momentum_at_epoch, moments * velocity)
    top = (2.0, 2.0, 3.0)
    assert np.array_equal(LagrangeMotion(top, mgl=1.0, angular_velocity=velocity).momentum_at_epoch, [0.6, -1.8, 1.5])
    for make in (FreeMotion, lambda moments, **spin: LagrangeMotion(top, mgl=1.0, **spin)):
        for spin in ({}, {"momentum": velocity, "angular_velocity": velocity}):
            with pytest.raises(InvalidInput, match="exactly one of `angular_velocity` and `momentum`"):
                make(moments, **spin)
        with pytest.raises(TypeError, match="unexpected keyword argument 'speed'"):
            make(moments, momentum=velocity, speed=1.0)
        with pytest.raises(InvalidInput, match="not both"):
            make(moments, momentum=velocity, momentum_at_epoch=velocity)
    with pytest.raises(InvalidInput, match="finite"):
        FreeMotion(moments * 1e200, angular_velocity=velocity * 1e200)


def test_an_inertia_tensor_is_a_body_and_no_list_of_moments():
    tensor = [[2.0, 0.3, 0.0], [0.3, 1.5, 0.1], [0.0, 0.1, 2.5]]
    with pytest.raises(InvalidInput, match=r"inertia tensor\. Make a body of it, Body\.from_inertia"):
        FreeMotion(tensor, momentum=(0.1, 0.2, 0.3))
    with pytest.raises(InvalidInput, match="inertia tensor"):
        FreeMotion(np.diag([1.0, 2.0, 3.0]), momentum=(0.1, 0.2, 0.3))
    body = Body.from_inertia(tensor)
    motion = FreeMotion.from_body(body, momentum=(0.1, 0.2, 0.3))
    expected = np.linalg.solve(tensor, (0.1, 0.2, 0.3))  # Ω from L by the tensor itself
    assert np.allclose(motion.angular_velocity(0.0), expected, rtol=0.0, atol=1e-15)
    three = FreeMotion(tensor_of_three := [[1.0, 1.1, 1.2], [1.1, 1.3, 1.4], [1.2, 1.4, 1.5]], momentum=np.ones((3, 3)))
    assert three.batch_shape == (3,) and np.array_equal(three.moments, tensor_of_three)


def test_what_is_no_rotation_is_refused():
    for name, arguments in (("as_matrix", ()), ("rotate", ([1.0, 0.0, 0.0],))):
        function = getattr(rotation, name)
        with pytest.raises(InvalidInput, match="must have length 1; got length 2"):
            function([2.0, 0.0, 0.0, 0.0], *arguments)
        with pytest.raises(InvalidInput, match="must have length 1; got length 2"):
            function(np.array([[1.0, 0.0, 0.0, 0.0], [2.0, 0.0, 0.0, 0.0]]), *arguments)
        assert np.isnan(function(np.full(4, np.nan), *arguments)).all()
