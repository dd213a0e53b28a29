"""Both sides of the thresholds of spacecraft, their comparisons and files: values just within, and just beyond."""

import math
from pathlib import Path
from types import SimpleNamespace

import jaxtyping
import numpy as np
import pytest

import polhode as ph
from polhode.analysis._mechanics import Mechanics
from polhode.errors import FormatError, InvalidInput
from polhode.motion.frame import BodyFrame
from polhode.spacecraft import ControlledWheels, GravityGradient, QuaternionPD, SprungMass, Wheel
from polhode.spacecraft.comparing import comparison, study
from polhode.spacecraft.comparing.alignment import Alignment, fit_alignment
from polhode.spacecraft.comparing.report import ComparisonReport
from polhode.spacecraft.damped_body import answers as damped_answers
from polhode.spacecraft.damped_body.damped_motion import settling_time
from polhode.spacecraft.formats import spice_checks, spice_reading
from polhode.spacecraft.formats.spice_kernels import Clock
from polhode.spacecraft.rigid_body import gravity
from polhode.spacecraft.rigid_body.answers import RigidBodyReport
from polhode.spacecraft.systems.gyroscopes import ControlMomentGyroscope
from polhode.spacecraft.torques import surfaces
from polhode.systems import KeplerOrbit


def accepted(call):
    try:
        call()
    except (InvalidInput, FormatError):
        return False
    return True


def both(call, within, beyond):
    """Whether a call is accepted within a threshold, and beyond it."""
    return accepted(lambda: call(within)), accepted(lambda: call(beyond))


def compared(angle, left=None, **known):
    """Return a comparison with some angles and, of a fit, residual angles."""
    angle, zero = np.asarray(angle, float), np.zeros(3)
    fit = None if left is None else Alignment(zero, zero, zero, np.broadcast_to(float(left), angle.shape), True)
    times = np.arange(float(len(angle)))
    return comparison.Comparison(("a", "b"), times, angle, 0.0, fit, (None, None), "", None, **known)


@pytest.mark.parametrize("rms, peak, is_noise", [(1.99, 5.9, True), (2.01, 5.9, False), (1.99, 6.1, False)])
def test_angles_that_are_noise(rms, peak, is_noise):
    """One angle of a hundred is the largest; the others make up the rms."""
    rest = math.sqrt((100.0 * rms**2 - peak**2) / 99.0)
    assert compared(1e-4 * np.append(np.full(99, rest), peak), noise=1e-4).is_noise == is_noise


@pytest.mark.parametrize("angle, words", [(0.9e-12, "to rounding"), (1.1e-12, "They differ by up to")])
def test_angles_that_are_rounding(angle, words):
    assert words in ComparisonReport(compared([angle] * 2), "").summary


@pytest.mark.parametrize("angle, left, words", [
    (0.2, 0.0099, "explain most of it"), (0.2, 0.0101, "do not explain it"),
    (0.05, 0.00499, "explain most of it"), (0.05, 0.00501, "do not explain it"),
])  # fmt: skip
def test_differences_that_a_fit_explains(angle, left, words):
    assert words in ComparisonReport(compared([angle] * 20, left), "").summary


def test_times_that_are_one():
    own = np.arange(5.0)
    between = [comparison._nearest(own, np.array([2.0 + off]), 0.0)[1].tolist() for off in (0.9e-9, 1.1e-9)]
    assert between == [[False], [True]]


def test_samples_that_an_alignment_needs():
    attitude = ph.FreeMotion((1.0, 2.0, 3.0), momentum=(0.3, 1.8, 1.5)).sample(np.arange(10.0)).attitude
    fits = [fit_alignment(np.arange(float(n)), attitude[:n], attitude[:n]) for n in (10, 9)]
    assert [fit is None for fit in fits] == [False, True]


def test_moments_that_differ(monkeypatch):
    monkeypatch.setattr(jaxtyping.config, "jaxtyping_disable", True)
    side = SimpleNamespace(history=SimpleNamespace(mechanics=Mechanics(np.diag([1.0, 2.0, 4.0]))))
    other = lambda off: study._has_other_moments(side, Mechanics(np.diag([1.0, 2.0, 4.0 + 4.0 * off])))  # noqa: E731
    assert [other(0.9e-6), other(1.1e-6)] == [False, True]


def test_starts_on_an_axis(monkeypatch):
    """Off an unstable axis the time has a part in which the body leaves it."""
    monkeypatch.setattr(jaxtyping.config, "jaxtyping_disable", True)
    axes = [SimpleNamespace(verdict="unstable", rate=0.5), *[SimpleNamespace(verdict="stable", rate=-1.0)] * 2]
    time = [settling_time(axes, (1.0, off, 0.0), (1.0, 2.0, 3.0)) for off in (0.9e-9, 1.1e-9)]
    assert time[0] == 12.0 and time[1] > 50.0


def test_motions_that_are_cut_short(monkeypatch):
    """Drag acts for five time constants of C/c, unless 20 000 turns of the start end before."""
    monkeypatch.setattr(jaxtyping.config, "jaxtyping_disable", True)
    moments, momentum = np.array([1.0, 2.0, 3.0]), np.array([0.0, 0.0, 3.0])
    drag = 5.0 * 3.0 / (20_000.0 * 2.0 * math.pi)
    tables = [SimpleNamespace(inside=False, linear_drag=drag * part, quadratic_drag=None) for part in (1.001, 0.999)]
    assert [damped_answers._end(table, moments, momentum, (None,))[1] for table in tables] == [False, True]


def test_quaternions_of_kernels():
    def check(length):
        values = np.array([length, 0.0, 0.0, 0.0, 5.0, 1.0])  # of one record: quaternion, tick, count
        spice_checks._check_segment(Path("a.bc"), spice_checks.Segment(0.0, 9.0, -1, 1, 1, False, 1, 6), values)

    assert both(check, 1.00099, 1.00101) == (True, False) and both(check, 0.99901, 0.99899) == (True, False)


def test_clocks_of_kernels():
    assert [Clock.of(0.0, last).bits for last in (4095.0, 4096.0)] == [40, 39]
    assert both(lambda last: Clock.of(0.0, last), 2.0**51 - 1.0, 2.0**51) == (True, False)
    assert both(lambda seconds: spice_reading._zero(Path("a.bc"), seconds), 5.99e10, 6.01e10) == (True, False)


def test_slews_that_go_the_longer_way():
    law = QuaternionPD(gain=1.0, rate_gain=1.0)

    def notes(past):
        report = SimpleNamespace(history=SimpleNamespace(slew=np.array([math.pi + past])), trajectory=SimpleNamespace(
            times=np.zeros(1)), craft=SimpleNamespace(law=law), _rate_margins=list)  # fmt: skip
        return list(RigidBodyReport._notes_on_slew(report))

    assert [len(notes(past)) for past in (0.9e-6, 1.1e-6)] == [0, 1]


@pytest.mark.parametrize("off, reach", [(0.9e-9, "about one axis only"), (1.1e-9, "about axes in one plane only")])
def test_directions_of_wheels_in_notes(off, reach):
    """Two axes apart by a small angle have the singular values √2 and the angle over √2."""
    angle = math.sqrt(2.0) * off
    wheels = SimpleNamespace(axes=np.array([[1.0, 0.0, 0.0], [math.cos(angle), math.sin(angle), 0.0]]))
    (note,) = RigidBodyReport._notes_on_reach(SimpleNamespace(craft=SimpleNamespace(wheels=wheels)))
    assert reach in note


@pytest.mark.parametrize("off, rank", [(0.9e-9, 1), (1.1e-9, 2)])
def test_directions_that_wheels_reach(off, rank):
    """The smaller singular value over the larger is half of a small angle between two axes."""
    axes = [[1.0, 0.0, 0.0], [1.0, 2.0 * off, 0.0]]
    wheels = ControlledWheels(axes, 1e-3, QuaternionPD(gain=1.0, rate_gain=1.0))
    assert np.trace(np.asarray(wheels.reached)) == pytest.approx(rank, rel=1e-6)


def test_bodies_that_are_symmetric():
    axes = [gravity._axis_of_symmetry(np.array([1.0, 1.0 + off, 2.0])) for off in (0.9e-9, 1.1e-9)]
    assert axes == [2, None]


def test_gains_that_are_symmetric():
    gain = lambda off: QuaternionPD(gain=np.eye(3) + off * np.eye(3, k=1), rate_gain=1.0)  # noqa: E731
    assert both(gain, 0.9e-12, 1.1e-12) == (True, False)


def test_directions_that_are_perpendicular():
    rotor, tilted = Wheel((1.0, 0.0, 0.0), 1e-3), lambda off: (off, 0.0, 1.0)
    gyroscope = lambda off: ControlMomentGyroscope(tilted(off), rotor, (2e-3, 2e-3, 2e-3))  # noqa: E731
    mass = lambda off: SprungMass((0.0, 0.0, 0.4), [(1.0, 0.0, 0.0), tilted(off)], mass=5.0, stiffness=2.0)  # noqa: E731
    assert both(gyroscope, 0.9e-9, 1.1e-9) == (True, False) and both(mass, 0.9e-9, 1.1e-9) == (True, False)


def test_rates_at_which_a_motor_fades():
    wheel = Wheel((1.0, 0.0, 0.0), 1.0, motor=1.0, max_rate=100.0)
    torques = [float(wheel._limited(np.float64(1.0), np.float64(rate))) for rate in (98.9, 99.1, 100.0)]
    assert torques == pytest.approx([1.0, 0.9, 0.0], abs=1e-12)
    assert [float(wheel.load(0.0, None, np.zeros(3), np.array([rate]), np.zeros(3))) > 1.0
            for rate in (98.9, 99.1)] == [False, True]  # fmt: skip


def test_moments_of_a_gravity_gradient():
    torque = GravityGradient(KeplerOrbit(1e-3), (1.0, 2.0, 3.0))
    frame = lambda off: BodyFrame(np.array([1.0, 2.0, 3.0 + 3.0 * off]), np.eye(3), np.zeros(3), None)  # noqa: E731
    assert both(lambda off: torque.bound(frame(off)), 0.9e-12, 1.1e-12) == (True, False)


def test_orbits_about_the_earth():
    orbit = lambda part: KeplerOrbit.from_semi_major_axis(7e6, surfaces.EARTH * part)  # noqa: E731
    assert both(lambda part: surfaces._earth_radius(orbit(part)), 1.0099, 1.0101) == (True, False)
    assert both(lambda part: surfaces._earth_radius(orbit(part)), 0.9901, 0.9899) == (True, False)
