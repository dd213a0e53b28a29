"""Rolling without slipping, the herpolhode's radii, precession's senses, and the tennis racket."""

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import polhode as ph
from polhode.analysis.poinsot import contact_point, ellipsoid_semi_axes, herpolhode, herpolhode_curve
from polhode.analysis.precession import body_precession, space_precession
from polhode.analysis.twist import racket_twist
from polhode.errors import InvalidInput

SAM, LAM = (0.3, 1.8, 1.5), (0.9, 1.6, 0.3)
EXACT = 1e-13


@pytest.mark.parametrize("momentum", [SAM, LAM])
@pytest.mark.parametrize("scale", [1.0, 1e-9, 3e7])
def test_radii_are_the_extremes_of_the_curve(momentum, scale):
    motion = ph.FreeMotion(scale * np.array([1.0, 2.0, 3.0]), momentum=scale * np.array(momentum))
    found = herpolhode(motion)
    times = np.linspace(0.0, motion.period, 20001)
    radii = np.linalg.norm(herpolhode_curve(motion, times), axis=1)
    assert found.inner_radius <= radii.min() * (1 + EXACT) and found.outer_radius >= radii.max() * (1 - EXACT)
    assert radii.min() == pytest.approx(found.inner_radius, rel=1e-6)
    assert radii.max() == pytest.approx(found.outer_radius, rel=1e-6)


def test_ellipsoid_rolls_without_slipping():
    motion = ph.FreeMotion((1.0, 2.0, 3.0), momentum=SAM)
    times = np.linspace(0.0, 5.0, 40001)
    point = contact_point(motion.angular_velocity(times), motion.energy)
    assert np.abs((point / ellipsoid_semi_axes(motion.moments)) ** 2 @ np.ones(3) - 1.0).max() < EXACT
    height = np.sum(ph.rotation.rotate(motion.attitude(times), point) * np.array(SAM) / motion.momentum_norm, axis=1)
    assert np.abs(height - herpolhode(motion).plane_distance).max() < EXACT
    on_ellipsoid = np.linalg.norm(np.diff(point, axis=0), axis=1).sum()
    on_plane = np.linalg.norm(np.diff(herpolhode_curve(motion, times), axis=0), axis=1).sum()
    assert on_plane == pytest.approx(on_ellipsoid, rel=1e-7)
    slipping = np.linalg.norm(np.diff(point[:, :2], axis=0), axis=1).sum()
    assert on_plane != pytest.approx(slipping, rel=1e-3)


def test_radii_in_the_limits():
    assert herpolhode(ph.FreeMotion((1.0, 2.0, 3.0), momentum=(0.0, 0.0, 2.0)))[:2] == (0.0, 0.0)
    assert herpolhode(ph.FreeMotion((1.0, 2.0, 3.0), momentum=(0.0, 2.0, 0.0)))[:2] == (0.0, 0.0)
    assert herpolhode(ph.FreeMotion((2.0, 2.0, 2.0), momentum=SAM))[:2] == (0.0, 0.0)
    assert herpolhode(ph.FreeMotion((3.0, 4.0, 6.0), momentum=(1.0, 2.0, 1.0))).inner_radius == 0.0
    circle = herpolhode(ph.FreeMotion((1.0, 1.0, 2.0), momentum=(0.3, 0.4, 1.0)))
    assert circle.inner_radius == pytest.approx(circle.outer_radius, rel=EXACT)
    assert herpolhode(ph.FreeMotion((1.0, 2.0, 3.0), momentum=(0.0, 0.0, 0.0))) is None


@pytest.mark.parametrize(("moments", "sense"), [((1.0, 1.0, 2.0), "with"), ((2.0, 2.0, 1.0), "against")])
def test_symmetric_bodies_precess_as_the_book_says(moments, sense):
    momentum = np.array([0.3, 0.4, 1.0])
    motion = ph.FreeMotion(moments, momentum=momentum)
    in_body, in_space = body_precession(motion), space_precession(motion)
    spin = momentum[2] / moments[2]
    assert in_body.rate == pytest.approx(abs(moments[2] - moments[0]) / moments[0] * spin, rel=EXACT)
    assert in_body.sense.startswith(sense)
    assert in_space.rate == pytest.approx(np.linalg.norm(momentum) / moments[0], rel=EXACT)
    # the sense, seen in the motion itself over a short time
    early = motion.momentum(1e-3)
    turned = momentum[0] * early[1] - momentum[1] * early[0]
    assert np.sign(turned) == (np.sign(spin) if sense == "with" else -np.sign(spin))
    assert motion.encircled_axis == 2


@pytest.mark.parametrize(
    ("ratio", "degrees"), [(0.3, 193.0), (0.1, 166.3), (0.05, 151.4), (0.02, 113.2), (0.01, 71.8), (0.001, 7.9)]
)
def test_tennis_racket(ratio, degrees):
    motion = ph.FreeMotion((0.00121, 0.01638, 0.01748), momentum=(0.00121 * ratio, 0.01638, 0.0))
    assert np.degrees(racket_twist(motion)) == pytest.approx(degrees, abs=0.05)


def test_a_racket_spun_about_its_handle_has_no_twist():
    with pytest.raises(InvalidInput, match="handle"):
        racket_twist(ph.FreeMotion((1.0, 2.0, 3.0), momentum=(1.0, 0.0, 0.0)))


@pytest.mark.parametrize("handle", [0, 1, 2])
@pytest.mark.parametrize("momentum", [(0.3, 1.8, 1.5), (0.9, 1.6, 0.3), (1e-3, 2.0, 2e-3), (0.02, 0.01, 2.0)])
def test_twist_is_that_of_an_integration(handle, momentum):
    moments, norm = np.array([1.0, 2.0, 3.0]), np.linalg.norm(momentum)
    j, k = (handle + 1) % 3, (handle + 2) % 3

    def field(_, y):
        L = y[:3]
        across = (L[j] ** 2 / moments[j] + L[k] ** 2 / moments[k]) / (L[j] ** 2 + L[k] ** 2)
        return [*np.cross(L, L / moments), norm * across, L[handle] * (across - 1.0 / moments[handle])]

    def turned_once(_, y):
        return y[3] - 2.0 * np.pi

    turned_once.terminal = True
    path = solve_ivp(field, (0.0, 100.0), [*momentum, 0.0, 0.0], "DOP853", events=turned_once, rtol=1e-12, atol=1e-14)
    twist = abs(path.y_events[0][0, 4])
    assert racket_twist(ph.FreeMotion(moments, momentum=momentum), handle) == pytest.approx(twist, abs=1e-9)
