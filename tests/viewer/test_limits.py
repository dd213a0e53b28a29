"""Limits of a page: on either side of each, a motion is shown in one way or another."""

import numpy as np
import pytest

from polhode.bodies.surface import cuboid
from polhode.exact.free_body import FreeMotion
from polhode.viewer import panels, samples, shapes

LEVEL = np.tile([1.0, 0.0, 0.0, 0.0], (2, 1))


@pytest.mark.parametrize("factor, celestial", [(0.99, False), (1.01, True)])
def test_a_body_with_the_moments_of_an_asteroid_is_round(factor, celestial):
    assert shapes.is_celestial(np.full(3, factor * shapes.LIMITS.max_moment)) == celestial


@pytest.mark.parametrize("factor, stem", [(0.99, True), (1.01, False)])
def test_a_top_that_leans_from_its_principal_axis_has_no_stem(factor, stem):
    axis = (factor * shapes.LIMITS.max_lean, 0.0, 1.0)
    assert ("stem" in shapes.top_shape((2.0, 2.0, 1.0), axis, None)[1]) == stem


@pytest.mark.parametrize("factor, support", [(1.01, "ground"), (0.99, "post")])
def test_a_top_of_unknown_shape_that_leans_far_is_on_a_post(factor, support):
    cosine = factor * panels.LIMITS.min_cosine
    axis = np.array([np.sqrt(1.0 - cosine**2), 0.0, cosine])
    assert panels._pivot(LEVEL, axis, None) == support


@pytest.mark.parametrize("factor, support", [(0.9, "ground"), (1.1, "post")])
def test_a_top_whose_tip_dips_into_the_ground_is_on_a_post(factor, support):
    dip = factor * panels.LIMITS.max_dip
    body = cuboid((0.2, 0.2, 1.0 + dip))
    up = np.array([0.0, 0.0, 0.5 * (1.0 - dip)])  # so that it reaches from −dip to 1
    vertices = np.asarray(body.vertices) + up
    assert panels._pivot(LEVEL, np.array([0.0, 0.0, 1.0]), type(body)(vertices, body.faces)) == support


@pytest.mark.parametrize("turns, shown", [(0.99, False), (1.01, True)])
def test_of_a_motion_of_too_many_turns_the_beginning_is_shown(turns, shown):
    most = samples.LIMITS.max_turn * (samples.LIMITS.max_samples - 1)
    motion = FreeMotion((1.0, 1.0, 1.0), momentum=(0.0, 0.0, 1.0))
    taken = samples.take_samples(motion.sample(np.linspace(0.0, turns * most, 5)))
    assert any(note.startswith("Shown: the first") for note in taken.notes) == shown
