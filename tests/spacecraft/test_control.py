"""Laws of control, wheels under them and their limits, against 40 digits and by hand."""

import math

import jax.numpy as jnp
import mpmath as mp
import numpy as np
import pytest
from scipy.integrate import solve_ivp

import polhode as ph
from polhode import rotation
from polhode.errors import InvalidInput
from polhode.spacecraft import (
    ControlledWheels,
    ControlTorque,
    EarthDipoleField,
    GravityGradient,
    QuaternionPD,
    RateControl,
    RigidBody,
    TorqueRods,
    UserLaw,
    Wheel,
)
from polhode.spacecraft.rigid_body.control_margins import linearize_loop, loop_margins
from polhode.spacecraft.torques.earth_field import EARTH_ROTATION, IGRF_2020, REFERENCE_RADIUS
from polhode.systems import KeplerOrbit
from spacecraft import controlled_craft

MU = 3.986004418e14
INERTIA = [[0.19, 0.002, 0.004], [0.002, 0.17, -0.003], [0.004, -0.003, 0.12]]
AXES = [[1, 1, 1], [-1, 1, 1], [-1, -1, 1], [1, -1, 1]]
MOMENT, FRICTION = 3e-5, 1e-8
STIFF, DAMP = np.diag([2e-4, 3e-4, 2.5e-4]), np.diag([6e-3, 7e-3, 5e-3])
ELEMENTS = (7.0e6, MU, 0.05, 0.4, 1.1, 0.7, -0.5)
RATES = np.array([50.0, -50.0, 40.0, -60.0])
SPIN = np.array([0.002, -0.003, 0.004])
LEAN = np.array(rotation.from_rotation_vector(np.array([0.4, -0.3, 0.5])))
BODY = ph.Body(12.0, (0.01, -0.02, 0.03), INERTIA)
SAME = 1e-11
"""Of the attitude and relative to momenta: what a run by Taylor series is held to."""


def orbit():
    a, mu, e, start, i, node, peri = ELEMENTS
    return KeplerOrbit.from_semi_major_axis(a, mu, e, start, i, node, peri)


def craft(law=None, rods=True, gravity=True, **limits):
    way = orbit()
    law = law or QuaternionPD(STIFF, DAMP, target="nadir", orbit=way)
    attitude = np.asarray(rotation.multiply(way.frame(0.0), LEAN))
    law = law.started(0.0, attitude)
    torques = [GravityGradient(way)] if gravity else []
    torques += [TorqueRods(EarthDipoleField(way, 0.3), 1e-3, law="dump")] if rods else []
    body = RigidBody.from_body(BODY, [ControlledWheels(AXES, MOMENT, law, friction=FRICTION, **limits)], torques)
    return body, body.pack(attitude, SPIN, rates=[RATES])


def without_friction(law):
    return RigidBody.from_body(BODY, [ControlledWheels(AXES, MOMENT, law)])


@pytest.mark.sweep
def test_wheels_gravity_rods_and_law_against_40_digits():
    mp.mp.dps = 40
    span = 120
    system, start = craft()
    run = ph.simulate(system, start, [0.0, float(span)])
    dump = (1e-3, IGRF_2020, EARTH_ROTATION, REFERENCE_RADIUS, 0.3)
    known = controlled_craft.Craft(INERTIA, AXES, MOMENT, FRICTION, STIFF.tolist(), DAMP.tolist(), ELEMENTS, dump)
    attitude = np.asarray(rotation.multiply(orbit().frame(0.0), LEAN)).tolist()
    first = system.as_given(start)
    begin = [*map(mp.mpf, attitude), *map(mp.mpf, SPIN.tolist()), *map(mp.mpf, np.asarray(first.mounts[0]).tolist())]
    norm = mp.sqrt(sum(x * x for x in begin[:4]))
    begin[:4] = [x / norm for x in begin[:4]]
    end = controlled_craft.integrate(known.rates, begin, span, steps=6, columns=16)
    again = controlled_craft.integrate(known.rates, begin, span, steps=5, columns=16)
    assert max(abs(x - y) for x, y in zip(end, again, strict=True)) < 1e-15  # the oracle itself has converged
    wanted, last = np.array([float(x) for x in end]), system.as_given(run.states[-1])
    turned = np.asarray(last.attitude)
    assert min(np.abs(turned - wanted[:4]).max(), np.abs(turned + wanted[:4]).max()) < SAME
    assert np.abs(np.asarray(system.velocity(run.states[-1])) - wanted[4:7]).max() < SAME * np.abs(SPIN).max()
    assert np.abs(np.asarray(last.mounts[0]) - wanted[7:]).max() < SAME * np.abs(wanted[7:]).max()
    # a specimen whose law has the wrong gain is far off
    wrong, at = craft(QuaternionPD(1.0001 * STIFF, DAMP, target="nadir", orbit=orbit()))
    off = ph.simulate(wrong, at, [0.0, float(span)])
    assert np.abs(np.asarray(off.states[-1]) - np.asarray(run.states[-1])).max() > 1e-6


@pytest.mark.long
def test_wheels_give_the_body_what_the_law_asks():
    system, start = craft(rods=False, gravity=False)
    wheels, body = system.mounts[0], system.as_given(start)
    given = body.attitude, jnp.asarray(SPIN), body.mounts[0]
    wanted = np.asarray(wheels.law.wanted(0.0, *given[:2], jnp.zeros(0)))
    motors = np.asarray(wheels.commanded(0.0, *given))
    axes = np.asarray(wheels.axes)
    assert np.abs(-motors @ axes - wanted).max() < 1e-15 * np.abs(wanted).max() * 10
    assert np.linalg.matrix_rank(axes) == 3
    # of all that give this torque the pseudo-inverse has the least squares: nothing of it is in the null space
    null = np.array([1, -1, 1, -1.0])
    assert abs(null @ axes).max() < 1e-15 and abs(motors @ null) < 1e-16


@pytest.mark.sweep
def test_limits_cut_off_each_motor_and_no_wheel_exceeds_its_rate():
    system, start = craft(rods=False, max_torque=2e-5, max_rate=62.0)
    run = ph.simulate(system, start, np.linspace(0.0, 300.0, 301), estimate_error=False)
    own, velocity = run.layout.part(run.states, "wheel_momentum"), np.asarray(system.velocity(run.states))
    rates = np.asarray(system.mounts[0].rotor_rates(velocity, own))
    assert np.abs(rates).max() <= 62.0
    assert np.abs(rates).max() > 0.98 * 62.0  # it does come near
    assert float(np.max(np.asarray(system.load(run.times, run.states)))) > 1.0
    assert run.drift["kinetic_energy"] < 1e-7
    free = system.without_limits()
    assert not free.limited and system.limited


@pytest.mark.long
def test_eigenvalues_and_margins_of_a_plain_loop_are_those_of_the_textbook():
    inertia, frequency, damping = 2.0, 0.3, 0.6
    law = QuaternionPD(inertia * frequency**2, 2 * damping * frequency * inertia)
    body = RigidBody((inertia,) * 3, torques=[ControlTorque(law)])
    loop = linearize_loop(body, body.torques[0].law, 0.0, np.asarray(body.pack((1, 0, 0, 0), (0, 0, 0))))
    wanted = frequency * (-damping + 1j * math.sqrt(1 - damping**2))
    assert np.abs(loop.eigenvalues[np.argsort(loop.eigenvalues.imag)][-3:] - wanted).max() < 1e-9
    # |ℓ|² = (4 ζ² x² + 1)/x⁴ = 1 with x = ω/ω_n, the phase margin is arctan 2 ζ x
    x = math.sqrt(2 * damping**2 + math.sqrt(4 * damping**4 + 1))
    for margins in loop_margins(loop):
        assert margins.crossover == pytest.approx(frequency * x, rel=1e-7)
        assert margins.phase == pytest.approx(math.atan(2 * damping * x), rel=1e-6)
        assert margins.delay == pytest.approx(math.atan(2 * damping * x) / (frequency * x), rel=1e-6)
        assert (margins.gain_up, margins.gain_down) == (math.inf, 0.0)


@pytest.mark.long_after(1)
@pytest.mark.parametrize("count", [1, 2])
def test_a_wheel_controls_about_its_own_axis_alone(count):
    """Along principal axes, by the textbook's oscillator about each wheel's axis; across them nothing happens."""
    moments, frequency, damping = np.array([2.0, 3.0, 2.5]), 0.3, 0.6
    turned = moments - 0.01 * (np.arange(3) < count)  # of the body without the wheels, which do not turn with it
    law = QuaternionPD(turned * frequency**2, 2 * damping * frequency * turned)
    body = RigidBody(moments, [ControlledWheels(np.eye(3)[:count], 0.01, law)])
    loop = linearize_loop(body, body.mounts[0].law, 0.0, np.asarray(body.pack((1, 0, 0, 0), (0, 0, 0))))
    wanted = frequency * (-damping + 1j * math.sqrt(1 - damping**2))
    settled = loop.eigenvalues[np.abs(loop.eigenvalues) > 1e-6]
    assert len(settled) == 2 * count and np.abs(settled[settled.imag > 0] - wanted).max() < 1e-9
    margins = loop_margins(loop)
    assert [each.crossover is None for each in margins] == [k >= count for k in range(3)]
    times = np.linspace(0.0, 20.0, 5)
    for k in range(3):
        turned = rotation.from_rotation_vector(0.5 * np.eye(3)[k])
        run = ph.simulate(body, body.pack(turned, (0, 0, 0)), times)
        angles = np.linalg.norm(rotation.as_rotation_vector(run.attitude), axis=1)
        fall = lambda t, y: [y[1], -2 * frequency * (frequency * math.sin(y[0] / 2) + damping * y[1])]  # noqa: E731
        pendulum = solve_ivp(fall, (0, 20), [0.5, 0], "DOP853", times, rtol=1e-12, atol=1e-12)
        assert angles == pytest.approx(np.abs(pendulum.y[0]) if k < count else 0.5 * np.ones(5), abs=1e-9)


@pytest.mark.long
def test_what_the_linear_loop_says_is_how_small_errors_decay():
    # wheels against whose friction the law works are no longer at the rate at which they are held here
    system = without_friction(QuaternionPD(STIFF, DAMP, attitude=LEAN))
    start = system.pack(LEAN, (0, 0, 0), rates=[0 * RATES])
    loop = linearize_loop(system, system.mounts[0].law, 0.0, np.asarray(start))
    small = 1e-6
    turned = rotation.multiply(LEAN, rotation.from_rotation_vector(np.array([small, 0.0, 0.0])))
    run = ph.simulate(system, system.pack(turned, (0, 0, 0), rates=[0 * RATES]), [0.0, 40.0])
    from scipy.linalg import expm

    moved = expm(40.0 * (loop.plant + loop.input @ loop.law)) @ np.array([small, 0, 0, 0, 0, 0])
    left = rotation.multiply(rotation.conjugate(LEAN), np.asarray(system.as_given(run.states[-1]).attitude))
    found = np.asarray(rotation.as_rotation_vector(left * np.sign(left[0])))
    assert np.abs(found - moved[:3]).max() < 1e-5 * small


@pytest.mark.long
def test_spin_up_by_wheels_keeps_the_momentum_in_space():
    law = RateControl((0.0, 0.0, 0.05), bandwidth=0.1)
    body = RigidBody.from_body(BODY, [ControlledWheels(AXES, MOMENT, law)])
    run = ph.simulate(body, body.pack((1, 0, 0, 0), (0.0, 0.0, 0.0)), [0.0, 300.0])
    assert np.abs(np.asarray(body.velocity(run.states[-1])) - (0, 0, 0.05)).max() < 1e-12
    assert run.drift["momentum_space"] < 1e-12


@pytest.mark.long
def test_a_law_of_the_user_with_its_own_state():
    # a PI law about one axis on a ball against a constant couple: ω → 0, and the integral holds the couple
    law = UserLaw(lambda t, q, w, own: -2.0 * w - own, lambda t, q, w, own: 1.5 * w, 3)
    body = RigidBody((2.0,) * 3, torques=[ControlTorque(law), ph.spacecraft.ConstantTorque((0.3, 0.0, 0.0))])
    run = ph.simulate(body, body.pack((1, 0, 0, 0), (0, 0, 0)), [0.0, 60.0])
    assert np.abs(run.angular_velocity[-1]).max() < 1e-9
    assert run.layout.part(run.states, "law_state")[-1, 0] == pytest.approx(0.3, abs=1e-9)
    # 2 ω̇ = 0.3 − 2 ω − s, ṡ = 1.5 ω, solved by hand: ω = (0.3/2) e^{−t/2} sin(βt)/β, β² = 3/4 − 1/4
    beta, at = math.sqrt(0.5), 2.0
    early = ph.simulate(body, body.pack((1, 0, 0, 0), (0, 0, 0)), [0.0, at])
    wanted = 0.15 * math.exp(-0.5 * at) * math.sin(beta * at) / beta
    assert early.angular_velocity[-1, 0] == pytest.approx(wanted, rel=1e-12)


@pytest.mark.long
def test_control_goes_the_shorter_way_from_either_sign():
    for sign in (1.0, -1.0):
        law = QuaternionPD(1.0, 2.0)
        start = sign * np.array([math.cos(0.5), math.sin(0.5), 0, 0])
        body = RigidBody((1.0,) * 3, torques=[ControlTorque(law.started(0.0, start))])
        run = ph.simulate(body, body.pack(start, (0, 0, 0)), np.linspace(0.0, 20.0, 50))
        assert abs(float(run.attitude[-1] @ (sign, 0, 0, 0)) - 1.0) < 1e-9
        assert np.abs(run.attitude[:, 1]).max() <= math.sin(0.5) + 1e-12


@pytest.mark.parametrize(
    "make, said",
    [
        (lambda: QuaternionPD(), "`bandwidth` instead of both"),
        (lambda: QuaternionPD(1.0, -1.0), "`rate_gain` must be positive"),
        (lambda: QuaternionPD(bandwidth=1.0, target="nadir"), "give `orbit`"),
        (lambda: QuaternionPD(bandwidth=1.0, target="sun"), '"inertial" or "nadir"'),
        (lambda: RateControl(), "one of the two"),
        (lambda: UserLaw(3.0), "must be a function"),
        (lambda: UserLaw(lambda *x: 0, None, 2), "with `state_rate`"),
        (lambda: ControlledWheels(AXES, -1.0, RateControl(bandwidth=1.0)), "`moments` must be one finite number ab"),
        (lambda: ControlledWheels(AXES, 1.0, RateControl(bandwidth=1.0), max_rate=3.0), "needs `max_torque`"),
        (lambda: ControlledWheels(AXES, 1.0, "pd"), "must be a control law"),
        (lambda: ControlTorque(RateControl(bandwidth=1.0), limit=0.0), "`limit` must be one finite number above 0"),
    ],
)
def test_what_is_wrong_is_refused_in_words(make, said):
    with pytest.raises(InvalidInput) as caught:
        make()
    assert said in str(caught.value)


@pytest.mark.long
def test_one_wheel_among_others_may_run_free():
    system = RigidBody.from_body(
        BODY, [ControlledWheels(AXES, MOMENT, RateControl(bandwidth=0.05)), Wheel((0, 0, 1), 1e-4)]
    )
    run = ph.simulate(system, system.pack((1, 0, 0, 0), SPIN, rates=[RATES, 10.0]), [0.0, 50.0])
    assert run.drift["momentum_space"] < 1e-12 and run.drift["energy"] < 1e-12
