"""Coning free bodies and caged gyroscopes, against Euler's equations, and through the spec."""

import math

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import polhode as ph
from polhode.analysis import coning_momentum, holding_torque, precession_with_fixed_frame
from polhode.errors import InvalidInput

SPEC = """
[body]
moments = ["300 kg*m^2", "300 kg*m^2", "500 kg*m^2"]
[spin]
"""


def write(tmp_path, lines, spec=SPEC):
    path = tmp_path / "spin.toml"
    path.write_text(spec + lines, encoding="utf-8")
    return path


@pytest.mark.parametrize("moments", [(300.0, 300.0, 500.0), (500.0, 300.0, 300.0), (1.0, 3.0, 1.0)])
@pytest.mark.parametrize(("nutation", "precession"), [(0.5, 3.0), (2.5, 3.0), (0.8, -2.0)])
def test_euler_equations_give_the_rates_back(moments, nutation, precession):
    """The axis, integrated in space, goes round L at φ̇ and keeps θ; a mark on the body turns by ψ̇ against it."""
    I = np.array(moments)  # noqa: E741
    k = next(k for k in range(3) if np.sum(I == I[k]) == 1)
    L = coning_momentum(I, nutation, None, precession)

    def rates(t, state):
        turn, momentum = state[:9].reshape(3, 3), state[9:]
        w = momentum / I
        hat = np.array([[0, -w[2], w[1]], [w[2], 0, -w[0]], [-w[1], w[0], 0]])
        return np.concatenate([(turn @ hat).ravel(), np.cross(momentum, w)])

    time = 0.1
    start = np.concatenate([np.eye(3).ravel(), L])
    end = solve_ivp(rates, (0.0, time), start, "DOP853", rtol=1e-12, atol=1e-12).y[:, -1]
    up = L / np.linalg.norm(L) * math.copysign(1.0, precession)
    axes = np.eye(3)[k], end[:9].reshape(3, 3)[:, k]
    assert [math.acos(float(axis @ up)) for axis in axes] == pytest.approx([nutation] * 2, rel=1e-9)
    flat = [axis - (axis @ up) * up for axis in axes]
    turned = math.atan2(float(up @ np.cross(*flat)), float(flat[0] @ flat[1]))
    assert turned == pytest.approx(precession * time, rel=1e-9)
    A, C = I[(k + 1) % 3], I[k]
    spin = L[k] / C - precession * math.cos(nutation)
    for pair in ({"nutation": nutation, "spin": spin}, {"spin": spin, "precession": precession}):
        np.testing.assert_allclose(coning_momentum(I, **pair), L, rtol=1e-9, atol=1e-9 * np.abs(L).max())
    # ψ̇ is the rate at which L goes round in the body, Euler's, with the other sign
    assert spin == pytest.approx(-(C - A) / A * L[k] / C, rel=1e-12)


def test_a_spec_by_nutation_and_precession(tmp_path):
    report = ph.report(write(tmp_path, 'nutation = "30 deg"\nprecession = "4 rev/s"\n'))
    values = report.values()
    assert abs(values["precession"]["space"]["rate"]) == pytest.approx(8.0 * math.pi, rel=1e-12)
    assert values["axes"][2]["angle_to_momentum"][0] == pytest.approx(math.radians(30.0), rel=1e-9)


@pytest.mark.parametrize(("nutation", "along"), [("90 deg", False), ("180 deg", True)])
def test_a_right_angle_is_one(tmp_path, nutation, along):
    """Its cosine in doubles, 6e-17, would let L come back in the body after 3e9 years."""
    report = ph.report(write(tmp_path, f'nutation = "{nutation}"\nprecession = "10 rpm"\n'))
    momentum = np.abs(np.asarray(report.trajectory.momentum))
    assert (np.count_nonzero(momentum[0]), "comes back" in report.summary) == (1, False)
    assert report.values()["regime"] == "permanent"


def test_a_body_with_losses_starts_the_same(tmp_path):
    spec = SPEC.replace("[spin]", '[system]\nkind = "damped-body"\ndamping = 0.01\n[time]\nuntil = "1 s"\n[spin]')
    report = ph.report(write(tmp_path, 'nutation = "30 deg"\nprecession = "4 rev/s"\n', spec))
    momentum = np.asarray(report.trajectory.momentum)[0]
    np.testing.assert_allclose(momentum, coning_momentum((300.0, 300.0, 500.0), math.radians(30.0), None, 8 * math.pi))


@pytest.mark.parametrize(
    ("lines", "words"),
    [
        ('spin = "2 rev/s"', "needs two of spin, precession and nutation"),
        ('spin = "2 rev/s"\nprecession = "4 rev/s"', "at most 10.0531 rad/s"),
        ('spin = "2 rev/s"\nprecession = "4 rev/s"\nnutation = "3 deg"', "needs two of"),
        ('spin = "2 rev/s"\nprecession = "slow"', "is of a top"),
        ('nutation = "3 deg"\nnutation_rate = "4 rev/s"', "nutation_rate is of a top"),
        ('nutation = "200 deg"\nprecession = "4 rev/s"', "from 0 to 180 deg"),
        ('nutation = "90 deg"\nspin = "4 rev/s"', "at a right angle has no spin"),
        ('nutation = "9 deg"\nspin = "4 rev/s"\nrate = "1 rpm"\nabout = 1', "needs exactly one of"),
    ],
)
def test_mistakes_in_a_spec(tmp_path, lines, words):
    with pytest.raises(InvalidInput, match=words):
        ph.report(write(tmp_path, lines + "\n"))


def test_other_bodies_and_kinds_say_what_they_take(tmp_path):
    spec = SPEC.replace('"300 kg*m^2", "500', '"310 kg*m^2", "500')
    with pytest.raises(InvalidInput, match="two equal principal moments"):
        ph.report(write(tmp_path, 'nutation = "9 deg"\nprecession = "4 rev/s"\n', spec))
    spec = SPEC.replace("[spin]", '[system]\nkind = "heavy-top"\npivot = ["0 m", "0 m", "-1 m"]\n[spin]')
    with pytest.raises(InvalidInput, match=r"a top takes system\.lean"):
        ph.report(write(tmp_path, 'nutation = "9 deg"\n', spec))
    spec = SPEC.replace("[spin]", '[system]\nkind = "gyrostat"\n[spin]')
    with pytest.raises(InvalidInput, match="nutation is of a free symmetric body"):
        ph.report(write(tmp_path, 'nutation = "9 deg"\n', spec))


def axis_rates(A, Cr, Cf, mgl, tilt, spin, precession, torque):
    """Return θ̈ of rotor and frame by Lagrange's equation, with the energies of both written out."""
    h = 1e-4

    def lagrangian(theta, rate):
        both = 0.5 * A * (rate**2 + (precession * math.sin(theta)) ** 2)
        along = precession * math.cos(theta)
        return both + 0.5 * Cr * (spin + along) ** 2 + 0.5 * Cf * along**2 - mgl * math.cos(theta)

    force = (lagrangian(tilt + h, 0.0) - lagrangian(tilt - h, 0.0)) / (2 * h)
    return (force + torque) / A


@pytest.mark.parametrize("tilt", [0.4, 0.5 * math.pi, 2.0])
def test_a_caged_gyroscope(tilt):
    """Neither rate moves the axis; and the torque that holds another precession is Lagrange's generalised force."""
    A, Cr, Cf, mgl, spin = 2.0e-3, 3.0e-4, 1.0e-4, 0.17, 280.0
    found = precession_with_fixed_frame(A, Cr, Cf, mgl, tilt, spin)
    for rate in (found.slow, *(() if found.fast is None else (found.fast,))):
        small = 1e-5 * mgl / A * max(1.0, abs(rate / found.slow))
        assert abs(axis_rates(A, Cr, Cf, mgl, tilt, spin, rate, 0.0)) < small
        assert holding_torque(A, Cr, Cf, mgl, tilt, spin, rate) == pytest.approx(0.0, abs=1e-10 * abs(rate))
    torque = holding_torque(A, Cr, Cf, mgl, tilt, spin, 7.0)
    assert abs(axis_rates(A, Cr, Cf, mgl, tilt, spin, 7.0, torque)) < 1e-4 * mgl / A
    assert abs(axis_rates(A, Cr, Cf, mgl, tilt, spin, 7.0, -torque)) > 0.1 * mgl / A  # a torque of the wrong sign


def test_the_frame_matters_where_the_axis_leans():
    args = (2.0e-3, 3.0e-4, 0.17, 0.4, 280.0)
    A, Cr, mgl, tilt, spin = args
    free, caged = (precession_with_fixed_frame(A, Cr, Cf, mgl, tilt, spin) for Cf in (0.0, 5e-4))
    assert caged.slow != pytest.approx(free.slow, rel=1e-4)


def test_a_level_toy():
    """170 g, 5.5 cm, in the middle of a 21 cm axle at 45 rev/s: 2π (½mR²)ψ̇/(mgl) = 2.6095 s, whatever the frame."""
    disk, place = 0.5 * 0.17 * 0.055**2, 0.17 * 0.105**2
    for frame in (0.0, 1e-4):
        weight = 0.17 * 9.80665 * 0.105
        level = precession_with_fixed_frame(0.5 * disk + place, disk, frame, weight, 0.5 * math.pi, 90 * math.pi)
        around = 2.0 * math.pi / level.slow
        assert around == pytest.approx(math.pi * 0.055**2 * 90 * math.pi / (9.80665 * 0.105), rel=1e-12)
        assert around == pytest.approx(2.6095, abs=5e-5)


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda: precession_with_fixed_frame(1.0, 0.0, 0.1, 1.0, 1.0, 1.0), "rotor's moment must be positive"),
        (lambda: holding_torque(1.0, 0.1, 0.1, 1.0, math.nan, 1.0, 1.0), "finite numbers"),
        (lambda: coning_momentum((1.0, 1.0, 1.0), 0.1, None, 1.0), "two equal"),
        (lambda: coning_momentum((1.0, 1.0, 1.5), 0.1), "two of nutation"),
    ],
)
def test_bad_input(call, words):
    with pytest.raises(InvalidInput, match=words):
        call()
