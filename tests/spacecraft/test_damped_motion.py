"""Times and angles of bodies that lose energy, against the motion itself and by hand."""

import math

import numpy as np
import pytest

import polhode as ph
from polhode import analysis, spacecraft, systems
from polhode.analysis.precession import fastest_rate
from polhode.errors import InvalidInput


def test_angles_to_axes():
    vectors = [[1.0, 0.0, 1.0], [0.0, 2.0, -2.0], [0.0, 0.0, -3.0], [0.0, 1.0, 0.0]]
    wanted = [math.pi / 4, math.pi / 4, 0.0, math.pi / 2]
    assert spacecraft.angle_to_major_axis(vectors, (1.0, 2.0, 3.0)) == pytest.approx(wanted, abs=1e-15)
    assert spacecraft.angle_to_major_axis(vectors, (1.0, 3.0, 3.0)) == pytest.approx([math.pi / 4, 0.0, 0.0, 0.0])
    assert spacecraft.angle_to_axis((3.0, 0.0, -4.0), 0) == pytest.approx(math.atan2(4.0, 3.0), rel=1e-15)


@pytest.mark.long
def test_drag_leaves_one_e_th():
    """Linear drag about a principal axis: Ω = Ω0 exp(−t/T); a quadratic one is as strong only at first."""
    body = spacecraft.TorquedBody((1.0, 2.0, 3.0), [spacecraft.LinearDrag(0.5)])
    time = spacecraft.drag_time_constant(3.0, 2.0, linear=0.5)
    found = ph.simulate(body, body.pack(momentum=(0.0, 0.0, 6.0)), [0.0, time])
    assert found.momentum[1, 2] == pytest.approx(6.0 / math.e, rel=1e-9)
    other = spacecraft.TorquedBody((1.0, 2.0, 3.0), [spacecraft.QuadraticDrag(0.25)])
    slope = float(other.vector_field(0.0, other.pack(momentum=(0.0, 0.0, 6.0)))[2])
    assert spacecraft.drag_time_constant(3.0, 2.0, quadratic=0.25) == pytest.approx(-6.0 / slope, rel=1e-14)
    with pytest.raises(InvalidInput, match="drag must brake"):
        spacecraft.drag_time_constant(1.0, 2.0)


@pytest.mark.long
def test_a_body_has_settled_by_its_time():
    """From 1e-3 off the least axis it leaves, turns over and approaches the major one, to 6e-6 of a radian or so."""
    moments, momentum = np.array([1.0, 2.0, 3.0]), 2.0 * np.array([1.0, 1e-3, 0.0])
    system = systems.DoubleBracket(moments, 0.05)
    axes = spacecraft.damped_axis_stability(system, float(np.linalg.norm(momentum)))
    end = spacecraft.settling_time(axes, momentum, moments)
    found = ph.simulate(system, np.array([1.0, 0.0, 0.0, 0.0, *momentum]), [0.0, 0.1 * end, end])
    off = spacecraft.angle_to_major_axis(found.momentum, moments)
    assert off[1] > 1.0 and off[2] < 1e-4
    # neighbours of the major axis come nearer by e in its time constant, on an ellipse of axes 2 : 1
    time = spacecraft.time_constant(axes[2])
    near = ph.simulate(system, np.array([1.0, 0, 0, 0, 0.0, 2e-4, 2.0]), [0.0, 6.0 * time])
    shrunk = np.divide(*spacecraft.angle_to_major_axis(near.momentum, moments)[::-1])
    assert abs(np.log(shrunk) + 6.0) < 1.01 * math.log(2.0)


def test_rates_of_free_bodies():
    """A steady turn comes back in its period; a tumbling one flips by half of the turn in a polhode's period."""
    steady = ph.FreeMotion((1.0, 2.0, 3.0), momentum=(0.0, 0.0, 6.0))
    assert analysis.rotation_period(steady) == pytest.approx(math.pi, rel=1e-15)
    assert fastest_rate(steady) == pytest.approx(2.0, rel=1e-15) and analysis.turn_per_flip(steady) is None
    tumbling = ph.FreeMotion((1.0, 2.0, 3.0), momentum=(0.01, 4.0, 0.02))
    assert analysis.rotation_period(tumbling) is None
    turn = analysis.turn_per_flip(tumbling)
    assert turn == pytest.approx(tumbling.precession_rate * tumbling.flip_interval, rel=1e-12)
    assert fastest_rate(tumbling) == max(tumbling.precession_rate, 2.0 * math.pi / tumbling.period)
