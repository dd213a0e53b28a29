"""Decay of nutation by the energy sink, against integrated bodies with dampers inside."""

import math

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from polhode.analysis import dual_spin_damping
from polhode.errors import InvalidInput
from polhode.spacecraft import damper_loss, nutation_time_constant, slosh_frequency

LEAN = 0.02  # rad at the start


def dual_spinner(A, C, w, slugs, span):
    """Return times and nutation angles of two parts on one axis, each with a ball of fluid that rubs.

    By Newton's laws, along axes fixed in space: the axis a, the transverse velocity, both spins, both balls (J, c).
    """

    def torques(state):
        a, across, spins = state[:3], state[3:6], state[6:8]
        parts = zip(slugs, spins, state[8:].reshape(2, 3), strict=True)
        return [c * (across + spin * a - ball) for (_, c), spin, ball in parts]

    def rates(t, state):
        a, across, spins = state[:3], state[3:6], state[6:8]
        pulls = torques(state)
        faster = [-pull @ a / moment for pull, moment in zip(pulls, C, strict=True)]
        turning = np.cross(across, a)
        # d(A across + h a)/dt = −Σ pulls, with across ⊥ a: its part along a follows from that
        h, gain = C[0] * spins[0] + C[1] * spins[1], C[0] * faster[0] + C[1] * faster[1]
        push = (-sum(pulls) - gain * a - h * turning) / A
        balls = [pull / J for pull, (J, _) in zip(pulls, slugs, strict=True)]
        return np.concatenate([turning, push, faster, *balls])

    h = C[0] * w[0] + C[1] * w[1]
    a = np.array([math.sin(LEAN), 0.0, math.cos(LEAN)])
    across = np.array([0.0, 0.0, h / A / math.cos(LEAN)])
    across -= (across @ a) * a
    upright = np.array([0.0, 0.0, 1.0])
    start = np.concatenate([a, across, w, w[0] * upright, w[1] * upright])
    times = np.linspace(0.0, span, 400)
    path = solve_ivp(rates, (0.0, span), start, "DOP853", times, rtol=1e-10, atol=1e-12).y.T
    L = A * path[:, 3:6] + (path[:, 6:8] @ np.asarray(C))[:, None] * path[:, :3]
    L += sum(J * path[:, 8 + 3 * k : 11 + 3 * k] for k, (J, _) in enumerate(slugs))
    assert np.ptp(L, axis=0).max() < 1e-8 * np.linalg.norm(L[0])
    across = np.linalg.norm(np.cross(path[:, :3], L), axis=1) / np.linalg.norm(L, axis=1)
    return times, np.arcsin(across)


def slug_loss(J, c, felt, nutation):
    """Return the mean power over θ² of a ball of fluid: the part turns by −λθ across L, and the ball lags by J/c."""
    lag = nutation * J / c
    return c * felt**2 * lag**2 / (1.0 + lag**2)


@pytest.mark.long
@pytest.mark.parametrize(
    ("spins", "rubs"),
    [((0.0, 6.0), (0.02, 1e-9)), ((0.0, 6.0), (1e-9, 0.005)), ((0.0, 6.0), (0.02, 0.002)), ((2.0, -7.0), (0.02, 4e-3))],
)
def test_dampers_on_both_sides(spins, rubs):
    """The rate of decay or growth to some per cent, which the size of the balls bounds, and its sign."""
    A, C, J = 10.0, (8.0, 4.0), 0.01
    nutation = (C[0] * spins[0] + C[1] * spins[1]) / A
    losses = [slug_loss(J, c, nutation - w, nutation) for c, w in zip(rubs, spins, strict=True)]
    expected = dual_spin_damping(A, C, spins, losses)
    times, angles = dual_spinner(A, C, spins, [(J, c) for c in rubs], 200.0)
    late = times > 20.0  # the balls have settled into their motion
    slope = np.polyfit(times[late], np.log(angles[late]), 1)[0]
    assert slope == pytest.approx(expected.growth, rel=0.03)
    assert expected.stable == (slope < 0.0)


@pytest.mark.long
def test_the_wrong_rate_would_be_seen():
    """With the spin in place of the felt rate λ₀ − ω a rotor's damper would calm, and the motion says it raises."""
    A, C, spins, c, J = 10.0, (8.0, 4.0), (0.0, 6.0), 0.005, 0.01
    nutation = C[1] * spins[1] / A
    loss = slug_loss(J, c, nutation - spins[1], nutation)
    times, angles = dual_spinner(A, C, spins, [(J, 1e-9), (J, c)], 100.0)
    wrong = -loss / spins[1] / (A * nutation)
    assert np.polyfit(times, np.log(angles), 1)[0] > 0.0 > wrong


def spinner_with_mass(A, C, w, mass, radius, frequency, damping, span):
    """Return the nutation angle at the ends of a body with a mass that moves along its axis at a distance from it.

    Lagrange's equations along body axes, the mass at (r, 0, z) beside a counterweight that keeps the centre of mass.
    """
    inertia = np.diag([A, A, C])

    def momentum(omega, z, speed):
        place = np.array([radius, 0.0, z])
        rest = np.array([radius, 0.0, 0.0])
        moving, resting = np.cross(omega, place) + np.array([0.0, 0.0, speed]), np.cross(omega, rest)
        return inertia @ omega + mass * (np.cross(place, moving) - np.cross(rest, resting))

    def rates(t, state):
        omega, z, speed = state[:3], state[3], state[4]
        place, along = np.array([radius, 0.0, z]), np.array([0.0, 0.0, 1.0])
        M = np.zeros((4, 4))
        for k in range(4):
            turn, push = (np.eye(3)[k], 0.0) if k < 3 else (np.zeros(3), 1.0)
            M[:3, k] = momentum(turn, z, push)
            M[3, k] = mass * (np.cross(turn, place) @ along + push)
        # rates of momentum with ω̇ = z̈ = 0: changes of the inertia by z, then ω × L
        step = 1e-6
        drift = (momentum(omega, z + step, speed) - momentum(omega, z - step, speed)) / (2 * step) * speed
        L = momentum(omega, z, speed)
        pull = -mass * (frequency**2 * z + 2.0 * damping * frequency * speed)
        swing = np.cross(omega, np.cross(omega, place)) + 2.0 * np.cross(omega, speed * along)
        force = np.concatenate([-drift - np.cross(omega, L), [pull - mass * swing @ along]])
        change = np.linalg.solve(M, force)
        return np.concatenate([change[:3], [speed, change[3]]])

    h = C * w
    start = np.array([h / A * LEAN, 0.0, w, 0.0, 0.0])
    times = np.linspace(0.0, span, 1000)
    path = solve_ivp(rates, (0.0, span), start, "DOP853", times, rtol=1e-8, atol=1e-11).y.T
    L = np.array([momentum(state[:3], state[3], state[4]) for state in path])
    assert np.ptp(np.linalg.norm(L, axis=1)) < 1e-6 * abs(h)
    return times, np.arctan2(np.linalg.norm(L[:, :2], axis=1), L[:, 2])


@pytest.mark.parametrize(("A", "C", "frequency"), [(8.0, 12.0, 2.4), (12.0, 8.0, 1.8), (12.0, 8.0, 1.2)])
def test_a_light_mass_on_a_spring(A, C, frequency):
    """The exponent of the linear equations of body and mass together, which the method meets as the mass goes to 0."""
    w, m, r, damping = 4.0, 1e-5, 0.8, 0.1
    left = np.array([[A, 0, 0, 0], [0, A, 0, -m * r], [0, 0, 1, 0], [0, -r, 0, 1.0]])
    right = np.array([[0, (A - C) * w, 0, 0], [(C - A) * w, 0, m * r * w * w, 0], [0, 0, 0, 1],
                      [-w * r, 0, -(frequency**2), -2 * damping * frequency]])  # fmt: skip
    spectrum = np.linalg.eigvals(np.linalg.solve(left, right))
    mode = spectrum[np.argmin(np.abs(spectrum - 1j * abs(C / A - 1.0) * w))]
    time = nutation_time_constant(A, C, w, damper_loss(A, C, w, m, r, frequency, damping))
    assert mode.real == pytest.approx(-1.0 / time, rel=1e-3)


@pytest.mark.sweep
def test_a_mass_on_a_spring():
    A, C, frequency = 8.0, 12.0, 2.4
    w, mass, radius, damping = 4.0, 0.01, 0.8, 0.1
    loss = damper_loss(A, C, w, mass, radius, frequency, damping)
    time = nutation_time_constant(A, C, w, loss)
    times, angles = spinner_with_mass(A, C, w, mass, radius, frequency, damping, 75.0)
    late = times > 30.0  # the mass has settled into its motion, which takes 1/(ζω)
    felt, t = (C / A - 1.0) * w, times[late]  # the angle ripples as the mass swings
    ripple = [wave(n * felt * t) for n in (1, 2) for wave in (np.cos, np.sin)]
    slope = np.linalg.lstsq(np.stack([t, np.ones_like(t), *ripple], axis=1), np.log(angles[late]), rcond=None)[0][0]
    assert slope == pytest.approx(-1.0 / time, rel=0.03)


def test_fuel_swings_faster_than_the_body_spins():
    """A pendulum at radius b + ℓ under the centrifugal force, integrated: ℓφ̈ = −ω² (b + ℓ cos φ) sin φ."""
    w, b, length = 3.0, 0.2, 0.3
    force = lambda t, s: [s[1], -(w**2) * (b + length * math.cos(s[0])) * math.sin(s[0]) / length]  # noqa: E731
    crossing = lambda t, s: s[0]  # noqa: E731
    found = solve_ivp(force, (0.0, 20.0), (1e-4, 0.0), "DOP853", events=crossing, rtol=1e-11, atol=1e-15).t_events[0]
    assert slosh_frequency(w, b, length) == pytest.approx(math.pi / np.diff(found).mean(), rel=1e-7)
    assert slosh_frequency(w, b, length) > w


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda: dual_spin_damping(-1.0, (1.0, 1.0), (0.0, 1.0), (0.1, 0.1)), "transverse moment must be positive"),
        (lambda: dual_spin_damping(2.0, (1.0, 1.0), (0.0, 0.0), (0.1, 0.1)), "axial momentum must not be zero"),
        (lambda: dual_spin_damping(2.0, (1.0, 1.0), (1.0, 1.0), (0.1, 0.1)), "spins at the nutation's own rate"),
        (lambda: nutation_time_constant(1.0, 1.0, 1.0, 0.1), "must differ"),
        (lambda: nutation_time_constant(1.0, 2.0, 1.0, 0.0), "`loss` must be positive"),
        (lambda: slosh_frequency(1.0, -1.0, 1.0), "`pivot` must be finite and not negative"),
    ],
)
def test_bad_input(call, words):
    with pytest.raises(InvalidInput, match=words):
        call()
