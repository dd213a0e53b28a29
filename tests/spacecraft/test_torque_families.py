"""Torques against numbers that come from elsewhere: potentials differentiated with 40 digits, geometry by hand."""

import math

import jax.numpy as jnp
import mpmath as mp
import numpy as np
import pytest

import polhode as ph
from polhode import rotation
from polhode.errors import InvalidInput
from polhode.spacecraft import (
    AerodynamicDrag,
    ConstantTorque,
    ControlledWheels,
    DumpingThrusters,
    EarthDipoleField,
    EddyCurrents,
    MagneticDipole,
    QuaternionPD,
    RigidBody,
    SolarPressure,
    Thruster,
    TorqueRods,
    Wheel,
)
from polhode.spacecraft.torques.earth_field import EARTH_ROTATION, IGRF_2020
from polhode.systems import KeplerOrbit

MU = 3.986004418e14
ORBIT = KeplerOrbit.from_semi_major_axis(7.0e6, MU, 0.05, 0.4, inclination=1.1, node=0.7, periapsis=-0.5)
FIELD = EarthDipoleField(ORBIT, greenwich=0.3)
ATTITUDE = np.array(rotation.normalize(np.array([0.3, -0.5, 0.7, 0.2])))
SPIN = np.array([0.02, -0.01, 0.03])
SAME = 1e-13  # relative: some tens of roundings
TIMES = (0.0, 1234.5, 5000.0)
H = mp.mpf(10) ** -8  # s, of differences with 40 digits


def place_with_40_digits(t, digits=40):
    """Return position of the orbit by Kepler's equation and rotation matrices, and its velocity, in mpmath."""
    mp.mp.dps = digits
    a, e = mp.mpf(7.0e6), mp.mpf(0.05)
    n = mp.sqrt(mp.mpf(MU) / a**3)
    M = n * t + mp.mpf(0.4)
    E = mp.findroot(lambda E: E - e * mp.sin(E) - M, M)
    flat = mp.matrix([a * (mp.cos(E) - e), a * mp.sqrt(1 - e * e) * mp.sin(E), 0])

    def about_z(x):
        return mp.matrix([[mp.cos(x), -mp.sin(x), 0], [mp.sin(x), mp.cos(x), 0], [0, 0, 1]])

    i = mp.mpf(1.1)
    about_x = mp.matrix([[1, 0, 0], [0, mp.cos(i), -mp.sin(i)], [0, mp.sin(i), mp.cos(i)]])
    return about_z(mp.mpf(0.7)) * about_x * about_z(mp.mpf(-0.5)) * flat


def field_with_40_digits(t):
    """Return −∇V of the first degree of the IGRF in mpmath, V differentiated numerically in the Earth's own axes."""
    mp.mp.dps = 40
    place, angle = place_with_40_digits(t), mp.mpf(0.3) + mp.mpf(EARTH_ROTATION) * t
    turn = mp.matrix([[mp.cos(angle), -mp.sin(angle), 0], [mp.sin(angle), mp.cos(angle), 0], [0, 0, 1]])
    g11, h11, g10 = map(mp.mpf, IGRF_2020)
    radius = mp.mpf(6371.2e3)

    def potential(x, y, z):
        r = mp.sqrt(x * x + y * y + z * z)
        longitude, colatitude = mp.atan2(y, x), mp.acos(z / r)
        degree = g10 * mp.cos(colatitude) + (g11 * mp.cos(longitude) + h11 * mp.sin(longitude)) * mp.sin(colatitude)
        return radius * (radius / r) ** 2 * degree

    own = turn.T * place
    gradient = [mp.diff(potential, tuple(own), tuple(int(j == k) for j in range(3))) for k in range(3)]
    return turn * mp.matrix([-x for x in gradient])


@pytest.mark.parametrize("t", TIMES)
def test_the_field_is_minus_the_gradient_of_the_igrf_of_degree_one(t):
    wanted = np.array([float(x) for x in field_with_40_digits(t)])
    found = np.asarray(FIELD.field(t))
    assert np.abs(found - wanted).max() < 1e-12 * np.abs(wanted).max()
    # the north pole of the rotation is near the pole where needles point down: B along −z there
    over = EarthDipoleField(KeplerOrbit.from_semi_major_axis(7e6, MU, 0.0, math.pi / 2, inclination=math.pi / 2))
    assert np.asarray(over.field(0.0))[2] < -4e-5


@pytest.mark.parametrize("t", TIMES)
def test_the_rate_of_the_field_is_its_derivative(t):
    mp.mp.dps = 40
    wanted = [float(mp.diff(lambda s, k=k: field_with_40_digits(s)[k], mp.mpf(t), h=H)) for k in range(3)]
    found = np.asarray(FIELD.field_rate(t))
    assert np.abs(found - wanted).max() < 1e-10 * np.abs(wanted).max()
    velocity = [float(mp.diff(lambda s, k=k: place_with_40_digits(s)[k], mp.mpf(t), h=H)) for k in range(3)]
    assert np.abs(np.asarray(ORBIT.velocity(t)) - velocity).max() < SAME * np.abs(velocity).max()


@pytest.mark.sweep
def test_axes_that_look_down():
    for t in (*TIMES, 40000.0):
        axes = np.asarray(rotation.as_matrix(ORBIT.frame(t)))
        down = -np.asarray(ORBIT.direction(t))
        assert np.abs(axes[:, 2] - down).max() < 1e-14 and np.abs(axes[:, 1] + np.asarray(ORBIT.normal)).max() < 1e-14
        assert axes[:, 0] @ np.asarray(ORBIT.velocity(t)) > 0
        # they turn at ḟ about the normal
        close = 0.1
        turned = rotation.multiply(rotation.conjugate(ORBIT.frame(t - close)), ORBIT.frame(t + close))
        rate = np.asarray(rotation.as_rotation_vector(turned)) / (2.0 * close)
        wanted = axes.T @ np.asarray(ORBIT.normal) * float(ORBIT.turning_rate(t))
        assert np.abs(rate - wanted).max() < 1e-7 * np.abs(wanted).max()  # axes turn a little in between
    times = np.linspace(0.0, 3 * float(ORBIT.period), 400)
    frames = np.asarray(ORBIT.frame(times))
    assert np.sum(frames[1:] * frames[:-1], axis=1).min() > 0.99  # of either sign, but never jumping


@pytest.mark.long
def test_dipole_and_eddy_currents_by_hand():
    t = 1234.5
    field = np.asarray(rotation.rotate(rotation.conjugate(ATTITUDE), np.asarray(FIELD.field(t))))
    moment = np.array([0.1, -0.2, 0.05])
    found = np.asarray(MagneticDipole(FIELD, moment).torque(jnp.asarray(t), ATTITUDE, SPIN))
    assert np.abs(found - np.cross(moment, field)).max() < SAME * np.abs(found).max()
    still = np.asarray(rotation.rotate(rotation.conjugate(ATTITUDE), np.asarray(FIELD.field_rate(t))))
    change = still - np.cross(SPIN, field)
    eddy = np.asarray(EddyCurrents(FIELD, 5e3).torque(jnp.asarray(t), ATTITUDE, SPIN))
    assert np.abs(eddy + 5e3 * np.cross(change, field)).max() < SAME * np.abs(eddy).max()
    # the field's rate along the body is what a sensor on the body sees
    close = 1e-4
    later = rotation.multiply(ATTITUDE, rotation.from_rotation_vector(close * SPIN))
    seen = np.asarray(rotation.rotate(rotation.conjugate(later), np.asarray(FIELD.field(t + close))))
    assert np.abs((seen - field) / close - change).max() < 1e-5 * np.abs(change).max()
    rods = TorqueRods(FIELD, 2e4, limit=(1e-3, 10.0, 10.0))
    moments = np.clip(-2e4 * change, [-1e-3, -10, -10], [1e-3, 10, 10])
    assert np.abs(np.asarray(rods.torque(jnp.asarray(t), ATTITUDE, SPIN)) - np.cross(moments, field)).max() < 1e-16
    load = float(rods.load(jnp.asarray(t), ATTITUDE, SPIN, jnp.zeros(0), jnp.zeros(3)))
    assert load == pytest.approx(np.max(np.abs(-2e4 * change) / [1e-3, 10, 10]))


def test_rods_take_momentum_out_across_the_field():
    t, stored = 1234.5, np.array([0.01, 0.02, -0.005])
    field = np.asarray(rotation.rotate(rotation.conjugate(ATTITUDE), np.asarray(FIELD.field(t))))
    rods = TorqueRods(FIELD, 1e-3, law="dump")
    found = np.asarray(rods.torque(jnp.asarray(t), ATTITUDE, SPIN, stored=stored))
    across = stored - field * (field @ stored) / (field @ field)
    assert np.abs(found + 1e-3 * across).max() < SAME * np.abs(found).max()
    # skewed rods span space as well
    skewed = TorqueRods(FIELD, 1e-3, law="dump", axes=[(1, 1, 0), (0, 1, 1), (1, 0, 1), (1, 1, 1)])
    assert np.abs(np.asarray(skewed.torque(jnp.asarray(t), ATTITUDE, SPIN, stored=stored)) - found).max() < 1e-17


@pytest.mark.long
def test_sunlight_on_a_plate_and_a_box():
    sun = np.array([1.0, 2.0, -0.5])
    toward = np.asarray(rotation.rotate(rotation.conjugate(ATTITUDE), sun / np.linalg.norm(sun)))
    still = jnp.zeros(3)
    mirror = SolarPressure(sun, [2.0], [toward], [(0.1, 0.2, 0.3)], specular=1.0)
    force = np.asarray(mirror.force(0.0, ATTITUDE, still))
    assert np.abs(force + 2 * 4.5391e-6 * 2.0 * toward).max() < 1e-20  # a mirror that faces the Sun gives 2 P A
    assert np.abs(np.asarray(mirror.torque(0.0, ATTITUDE, still)) - np.cross((0.1, 0.2, 0.3), force)).max() < 1e-20
    black = SolarPressure(sun, [2.0], [-toward], [(0.1, 0.2, 0.3)])
    assert not np.asarray(black.force(0.0, ATTITUDE, still)).any()  # turned away
    # a black box shows its shadow: P times the area across
    edges = np.array([0.1, 0.2, 0.3])
    box = SolarPressure(sun, box=edges, center=(0.5, 0.0, 0.0))
    shadow = np.abs(toward) @ (edges.prod() / edges)
    found = np.asarray(box.force(0.0, ATTITUDE, still))
    assert np.abs(found + 4.5391e-6 * shadow * toward).max() < 1e-20
    # and no torque about its own centre
    about = np.asarray(box.torque(0.0, ATTITUDE, still)) - np.cross((0.5, 0, 0), found)
    assert np.abs(about).max() < 1e-20


@pytest.mark.long_cases("1.3")
@pytest.mark.parametrize("beta", [0.0, 0.5, 1.3])
def test_shade_lasts_as_long_as_spheres_say(beta):
    """Of a circle of radius a, with the Sun β above its plane: cos of half the dark arc is √(1 − (R/a)²)/cos β."""
    a, radius = 7.0e6, 6.378137e6
    circle = KeplerOrbit.from_semi_major_axis(a, MU)
    light = SolarPressure((-math.cos(beta), 0.0, math.sin(beta)), box=(1, 1, 1), orbit=circle).light
    cosine = math.sqrt(1.0 - (radius / a) ** 2) / math.cos(beta)
    if cosine >= 1.0:
        assert (np.asarray(light(np.linspace(0.0, float(circle.period), 1000))) == 1.0).all()
        return
    leaves = math.acos(cosine) / float(circle.mean_motion)  # after the middle of the shade, which is at t = 0
    around = np.array([-1e-6, 1e-6])
    assert np.asarray(light(leaves + around)).tolist() == [0.0, 1.0]
    assert np.asarray(light(float(circle.period) - leaves + around)).tolist() == [1.0, 0.0]


@pytest.mark.long
def test_nothing_pushes_in_the_shade_and_steps_end_at_it():
    """A plate that always faces the Sun: the momentum is the lever times P A times the time in the light."""
    orbit = KeplerOrbit.from_semi_major_axis(7.0e6, MU)
    plate = SolarPressure((-1, 0, 0), [2.0], [(-1, 0, 0)], [(0, 0.3, 0)], orbit=orbit)
    heavy = RigidBody((1e9, 1e9, 1e9), torques=[plate])  # hardly turns
    period = float(orbit.period)
    run = ph.simulate(heavy, heavy.pack((1, 0, 0, 0), (0, 0, 0)), [0.0, 3.0 * period])
    dark = 2.0 * math.asin(6.378137 / 7.0) / float(orbit.mean_motion)
    assert run.momentum[-1, 2] == pytest.approx(-0.3 * 2.0 * 4.5391e-6 * 3.0 * (period - dark), rel=1e-12)
    assert run.error_estimate < 1e-12


def test_another_body_has_another_shade():
    moon = KeplerOrbit.from_semi_major_axis(1.9e6, 4.9028e12)
    with pytest.raises(InvalidInput, match=r"not the Earth.*`shading_radius`"):
        SolarPressure((1, 0, 0), box=(1, 1, 1), orbit=moon)
    assert float(SolarPressure((-1, 0, 0), box=(1, 1, 1), orbit=moon, shading_radius=1.7374e6).light(0.0)) == 0.0
    assert float(SolarPressure((-1, 0, 0), box=(1, 1, 1), orbit=moon, shading_radius=0.0).light(0.0)) == 1.0
    with pytest.raises(InvalidInput, match=r"comes within 1.9e\+06 m of the centre.*diameter"):
        SolarPressure((-1, 0, 0), box=(1, 1, 1), orbit=moon, shading_radius=2 * 1.7374e6)
    with pytest.raises(InvalidInput, match="`shading_radius` goes with an `orbit`"):
        SolarPressure((-1, 0, 0), box=(1, 1, 1), shading_radius=1.7374e6)


@pytest.mark.parametrize("limit, left", [(None, 2.0 - 0.001 * 2.0 * 300.0), (1e-4, 2.0 - 1e-4 * 300.0)])
def test_thrusters_take_out_what_wheels_hold(limit, left):
    """Of a free wheel in a body that hardly turns: its momentum stays, and the whole falls by k h, or the limit."""
    craft = RigidBody((1e9, 1e9, 1e9), [Wheel((0, 0, 1), 0.01)], [DumpingThrusters(0.001, limit)])
    run = ph.simulate(craft, craft.pack((1, 0, 0, 0), (0, 0, 0), rates=[200.0]), [0.0, 300.0])
    assert run.momentum[-1] == pytest.approx([0.0, 0.0, left], rel=1e-9, abs=1e-12)


def test_wheels_that_point_a_body_are_emptied_to_the_dead_band():
    law = QuaternionPD(0.2, (0.2, 0.3, 0.4))
    wheels = ControlledWheels(np.eye(3), 0.01, law)
    craft = RigidBody((0.2, 0.3, 0.4), [wheels], [DumpingThrusters(0.05, dead_band=0.3)])
    run = ph.simulate(craft, craft.pack((1, 0, 0, 0), (0, 0, 0), rates=[(100.0, 20.0, -90.0)]), np.linspace(0, 400, 5))
    # that about y stays in the band, but for what the body swings meanwhile
    assert run.momentum[-1, ::2] == pytest.approx([0.3, -0.3], rel=1e-6) and abs(run.momentum[-1, 1] - 0.2) < 0.01
    assert abs(run.attitude[-1, 0]) == pytest.approx(1.0, abs=1e-9)


def test_drag_against_the_air_that_turns_with_the_earth():
    t, edges = 100.0, np.array([0.1, 0.2, 0.3])
    drag = AerodynamicDrag(ORBIT, 1e-12, box=edges, coefficient=2.0)
    through = np.asarray(ORBIT.velocity(t)) - np.cross([0, 0, EARTH_ROTATION], np.asarray(ORBIT.position(t)))
    along = np.asarray(rotation.rotate(rotation.conjugate(ATTITUDE), through))
    speed = np.linalg.norm(along)
    shadow = np.abs(along / speed) @ (edges.prod() / edges)
    found = np.asarray(drag.force(jnp.asarray(t), ATTITUDE, jnp.zeros(3)))
    assert np.abs(found + 0.5 * 1e-12 * 2.0 * shadow * speed * along).max() < 1e-12 * np.abs(found).max()


@pytest.mark.parametrize("at", [5003.0, 1e6 / 3.0, 1e9 / 7.0])
def test_late_pulses_have_their_impulse_though_their_ends_are_rounded(at):
    jet = Thruster([at], 0.02, (0, 1, 0), (0.5, 0, 0))
    body = RigidBody((2.0, 2.0, 2.0), torques=[jet])
    run = ph.simulate(body, body.pack((1, 0, 0, 0), (0, 0, 0)), [at - 1.0, at + 1.0])
    assert run.momentum[-1, 2] == pytest.approx(0.5 * 0.02, rel=1e-12)


@pytest.mark.long
def test_pulses_change_the_momentum_by_torque_times_time_however_short():
    body = ph.shapes.box(10.0, (0.2, 0.3, 0.4)).placed(np.eye(3), (0.05, 0.0, 0.0))
    jet = Thruster(at=[500.0, 700.0], lasting=[0.02, 20.0], force=(0.0, 0.0, 2.5), position=(0.1, 0.2, 0.0))
    craft = RigidBody.from_body(body, [Wheel((0, 0, 1), 1e-3)], [jet])
    run = ph.simulate(craft, craft.pack((1, 0, 0, 0), (0, 0, 0), rates=[0.0]), [0.0, 600.0])
    # about the centre of mass, and before the body has turned much
    wanted = np.cross(np.array([0.1, 0.2, 0.0]) - [0.05, 0, 0], (0, 0, 2.5)) * 0.02
    found = np.asarray(rotation.rotate(run.attitude, run.momentum))[-1] - 0.0
    turned = float(np.linalg.norm(wanted)) / body.principal_moments[0] * 0.02
    assert np.abs(found - wanted).max() < turned * np.abs(wanted).max()
    assert run.drift["kinetic_energy"] < 1e-12
    plain = RigidBody((2.0, 2.0, 2.0), torques=[ConstantTorque((0.0, 0.0, 0.5), "space")])
    ended = ph.simulate(plain, plain.pack((1, 0, 0, 0), (0, 0, 0)), [0.0, 100.0])
    assert ended.momentum[-1, 2] == pytest.approx(50.0, rel=1e-13)
    about_its_axis = RigidBody((2.0, 2.0, 2.0), torques=[Thruster([3.0, 900.0], [0.02, 20.0], (0, 1, 0), (0.5, 0, 0))])
    spun = ph.simulate(about_its_axis, about_its_axis.pack((1, 0, 0, 0), (0, 0, 0)), [0.0, 1000.0])
    assert spun.momentum[-1, 2] == pytest.approx(0.5 * 20.02, rel=1e-12)


@pytest.mark.parametrize(
    "make, said",
    [
        (lambda: Thruster(5.0, 0.0, (1, 0, 0), (0, 0, 0)), "`lasting` must be positive"),
        (lambda: Thruster([5.0, 6.0], 2.0, (1, 0, 0), (0, 0, 0)), "begins at 6 s, before the one from 5 s ends"),
        (lambda: Thruster([5.0, 6.0], [1, 1, 1], (1, 0, 0), (0, 0, 0)), "one for each of the 2 pulses; got 3"),
        (lambda: ConstantTorque((1, 0, 0), "orbit"), '"body" or "space"'),
        (lambda: DumpingThrusters(0.0), "`rate` must be"),
        (lambda: DumpingThrusters(0.1, [1.0, 2.0]), "one for each of 3"),
        (lambda: DumpingThrusters(0.1, dead_band=-1.0), "`dead_band` must be"),
        (lambda: EarthDipoleField(KeplerOrbit(1e-3, 0.0)), "needs the size of the orbit"),
        (lambda: TorqueRods(FIELD, -1.0), "`gain` must be positive and finite"),
        (lambda: TorqueRods(FIELD, 1.0, limit=[1.0, 2.0]), "or one for each of 3"),
        (lambda: SolarPressure((1, 0, 0), [1.0]), "`areas`, `normals` and `positions` together"),
        (lambda: SolarPressure((1, 0, 0), box=(1, 1, 1), specular=0.8, diffuse=0.3), "together at most 1"),
    ],
)
def test_what_is_wrong_is_refused_in_words(make, said):
    with pytest.raises(InvalidInput) as caught:
        make()
    assert said in str(caught.value)
