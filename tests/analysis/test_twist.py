"""The racket's twist where a needle's handle hurries, and how its integral is split."""

import numpy as np
import pytest

import polhode as ph
from polhode.analysis import twist
from polhode.errors import NotConverged

# a needle near rotation about its axis of largest moment, whose long axis hurries past once in a polhode's period
NEEDLE = ph.FreeMotion((2.25e-7, 1.0, 1.00000011), momentum=(0.0333, 3e-8, 1.0))


@pytest.mark.long
def test_a_needle_needs_finer_segments(monkeypatch):
    assert np.isfinite(twist.racket_twist(NEEDLE, 2))
    monkeypatch.setattr(twist, "LIMITS", twist.TwistLimits(max_refinements=1))
    with pytest.raises(NotConverged, match="too uneven"):
        twist.racket_twist(NEEDLE, 2)


def test_a_turn_as_long_as_it_can_be_is_followed():
    """Where L stays next to the axis of the largest moment, the turn takes the longest possible time to rounding."""
    moments = np.array((0.00027245432603122826, 1.0, 1.000030578124565))
    momentum = np.array((-3.5155574660358034e-10, 1.3927108853455511e-05, 1.0000033828077344))
    got = twist.racket_twist(ph.FreeMotion(moments, momentum=momentum))
    # Euler's equations with constant L₃, of which L₁² + L₂² is 2e-10: L̇₂ = a L₁, L̇₁ = b L₂
    long, middle, short = 1.0 / moments
    a, b = momentum[2] * (long - short), momentum[2] * (short - middle)
    frequency, time = np.sqrt(-a * b), 2.0 * np.pi * moments[2] / momentum[2]
    last = momentum[1] * np.cos(frequency * time) + a * momentum[0] / frequency * np.sin(frequency * time)
    assert got == pytest.approx(abs(last - momentum[1]) / momentum[2], rel=1e-7)


@pytest.mark.parametrize(("late", "good"), [(0.9e-6, True), (1.1e-6, False)])
def test_the_attitude_must_agree_with_the_integral(monkeypatch, late, good):
    motion = ph.FreeMotion((0.00121, 0.01638, 0.01748), momentum=(0.1 * 0.00121, 0.01638, 0.0))
    exact = twist.racket_twist(motion)
    monkeypatch.setattr(twist, "_azimuth", lambda *_: late)
    if good:
        assert abs(twist.racket_twist(motion) - exact) < 1e-3
    else:
        with pytest.raises(NotConverged, match="too uneven"):
            twist.racket_twist(motion)


@pytest.mark.parametrize(("share", "count"), [(0.9, 2), (1.1, 4)])
def test_segments_are_halved_where_their_sums_disagree(share, count):
    """Of t²⁴, one degree beyond Gauss's rule of twelve nodes, halves leave a 2⁻²⁴th of the error."""
    power = lambda t: np.stack([t**24, 0.0 * t])  # noqa: E731
    ends = np.array([0.0, 1.0])
    error = abs(twist._gauss(power, ends[:1], ends[1:])[0, 0] - 1.0 / 25.0)
    scale = share * twist.LIMITS.quadrature_error * twist.TURN / error
    edges, parts = twist._integrals(lambda t: scale * power(t), ends)
    assert len(edges) == count + 1 and abs(parts[0].sum() / (scale / 25.0) - 1.0) < 1e-6
