"""Parts that move mass, gyroscopes and burns, against Newton's and Euler's laws in 40 digits."""

import json

import jax.numpy as jnp
import mpmath as mp
import numpy as np
import pytest
from scipy.integrate import solve_ivp

import polhode as ph
from polhode import rotation
from polhode.errors import InvalidInput
from polhode.integrators import Taylor
from polhode.spacecraft import (
    AbstractMovingPart,
    ControlMomentGyroscope,
    GravityGradient,
    HeldWheel,
    HingedPart,
    LockedPart,
    Propellant,
    RigidBody,
    SphericalPendulum,
    SprungMass,
    Wheel,
)
from polhode.systems import KeplerOrbit
from spacecraft import hub_and_parts as laws
from spacecraft import hub_cases as cases
from systems.balances import worst_balance

STORED = {name: np.array([float(x) for x in row]) for name, row in json.loads(cases.STORED.read_text()).items()}
AGREES = 1e-13  # a motion by series against one in 40 digits
WRONG = 1e-6  # what a broken specimen is off by, at least
BALANCE = 1e-14
KEPT = 1e-12


def followed(name, kind=RigidBody):
    """Return how far body axes and Ω are from the oracle after two seconds, with the trajectory."""
    body, start, _, _ = cases.make(name, kind)
    found = ph.simulate(body, start, [0.0, cases.END])
    given, exact = found.along("given"), STORED[name]
    off = max(np.abs(given.attitude[-1] - exact[:4]).max(), np.abs(given.angular_velocity[-1] - exact[4:7]).max())
    return off, found


@pytest.mark.sweep
@pytest.mark.parametrize("name", ["slosh", "gyroscope", "all", "burn"])
def test_they_move_as_bodies_of_their_own(name):
    off, found = followed(name)
    assert off < AGREES and found.error_estimate < AGREES
    exact = STORED[name][7:]
    if name != "gyroscope":
        assert np.abs(found.part("displacement")[-1] - exact[:2]).max() < AGREES
    if name in ("all", "burn"):
        assert abs(found.part("hinge_angle")[-1] - exact[4]) < AGREES
    if name == "all":
        pendulum = found.source.mounts[2]
        place = pendulum.position(jnp.asarray(found.part("deflection")[-1])) - pendulum.pivot
        assert np.abs(place / jnp.linalg.norm(pendulum.arm) - exact[6:9]).max() < AGREES
    if name == "gyroscope":
        assert abs(found.part("gimbal_angle")[-1] - exact[0]) < AGREES


@pytest.mark.sweep
@pytest.mark.parametrize("name", ["panel", "pendulum"])
def test_each_alone_moves_as_a_body_of_its_own(name):
    assert followed(name)[0] < AGREES


@pytest.mark.sweep
@pytest.mark.parametrize("name", list(cases.CASES))
def test_what_is_stored_is_what_the_laws_give(name):
    """Over a tenth of a second in 25 digits, as two seconds take minutes."""
    body, start, hub, own = cases.make(name)
    with mp.workdps(25):
        steps = 3 if name == "gyroscope" else 2
        end = np.array([float(x) for x in laws.integrate(hub.rates, own, 0, mp.mpf("0.1"), steps, 8)])
    found = ph.simulate(body, start, [0.0, 0.1]).along("given")
    assert np.abs(found.attitude[-1] - end[:4]).max() < AGREES
    assert np.abs(found.angular_velocity[-1] - end[4:7]).max() < AGREES


class WithoutCentre(RigidBody):
    """A broken specimen: the carrier does not move through space as its parts move."""

    def _arranged(self, owns):
        right = super()._arranged(owns)
        pairs = zip(self.moving_parts, right.parts, strict=True)
        shifts = [part.mass * shift for part, at in pairs for shift in at.shifts]
        masses = [[m + jnp.sum(a * b, axis=-1) / right.mass for m, b in zip(row, shifts, strict=True)]
                  for row, a in zip(right.masses, shifts, strict=True)]  # fmt: skip
        return right._replace(masses=masses)


class WithoutOffset(RigidBody):
    """A broken specimen: its centre of mass stays where it was."""

    def _arranged(self, owns):
        right = super()._arranged(owns)
        return right._replace(offset=0.0 * right.offset)


@pytest.mark.sweep
@pytest.mark.parametrize("name", ["slosh", "panel", "pendulum", "burn"])
@pytest.mark.parametrize("kind", [WithoutCentre, WithoutOffset])
def test_without_the_motion_of_the_centre_of_mass_they_are_found_out(name, kind):
    if (name, kind) == ("burn", WithoutCentre):
        pytest.skip("the same term as with slosh")
    assert followed(name, kind)[0] > WRONG


class Deaf(ControlMomentGyroscope):
    """A broken specimen: the rotor does not push its gimbal."""

    carries_spin = False


@pytest.mark.sweep
def test_a_gimbal_that_does_not_feel_its_rotor_is_found_out():
    gyroscope = Deaf((0.0, 0.0, 1.0), Wheel((1.0, 0.0, 0.0), 0.1), (0.25, 0.17, 0.2))
    body = RigidBody((5.0, 8.0, 10.6), [gyroscope])
    state = body.pack(cases.ATTITUDE, cases.VELOCITY, rates=[(0.5, 30.0)])
    found = ph.simulate(body, state, np.linspace(0.0, 2.0, 5), estimate_error=False)
    assert found.drift["energy"] > WRONG


PARTS = [
    SprungMass((0.1, 0.4, 0.3), [(1, 0, 0), (0, 1, 1)], 3.0, [4.0, 6.0], 0.1),
    SphericalPendulum((0, 0.1, -0.3), (0.0, 0.1, -0.4), 2.0, 0.5, 0.05),
    HingedPart((0.5, 0, 0), (0, 1, 0), (1.0, 0.1, 0), 1.5, np.diag([0.2, 0.3, 0.4]), 1.0, 0.02, motor=0.03),
    Wheel((1, 2, 3), 0.05, friction=0.01, coulomb_friction=0.02),
    ControlMomentGyroscope((0, 0, 1), HeldWheel((1, 0, 0), 0.1, 30.0), (0.2, 0.1, 0.15), friction=0.1),
    ControlMomentGyroscope((0, 1, 0), Wheel((1, 0, 0), 0.1, friction=0.01), (0.2, 0.1, 0.15),
                           gimbal_rate=lambda t, attitude, velocity, angle, rate: 0.3 * jnp.cos(t) - 0.1 * angle,
                           bandwidth=5.0),
    LockedPart(HingedPart((0, 0.5, 0), (0, 0, 1), (0.1, 1.0, 0), 1.0), 0.7),
]  # fmt: skip
RATES = [(0.1, -0.2), (0.3, 0.1, -0.2), 0.2, 40.0, 0.4, (0.2, 50.0), None]
PLACES = [(0.05, 0.02), (0.3, -0.2, 0.1), 0.2, None, 0.3, -0.5, None]
EVERYTHING = RigidBody.from_body(cases.BODY, PARTS, cases.torques())


def everything(**more):
    return EVERYTHING.pack(cases.ATTITUDE, cases.VELOCITY, rates=RATES, coordinates=PLACES, **more)


@pytest.mark.sweep
def test_with_everything_at_once_every_balance_holds():
    worst = worst_balance(EVERYTHING, 0.8, everything())
    assert set(worst) == {"kinetic_energy", "|L|²", "jacobi_integral"} and max(worst.values()) < BALANCE


@pytest.mark.long
def test_power_is_that_of_the_damper_alone():
    """−c |q̇|² with the momentum in space kept, and with a wrong slope of the energy both would tell."""
    slosh = SprungMass((0.1, 0.4, 0.3), (0, 1, 0), 3.0, 4.0, 0.5)
    body = RigidBody.from_body(cases.BODY, [slosh])
    start = body.pack(cases.ATTITUDE, cases.VELOCITY, rates=[0.3], coordinates=[0.1])
    assert float(body.power(0.0, start)) == pytest.approx(-0.5 * 0.3**2, rel=1e-13)
    found = ph.simulate(body, start, np.linspace(0.0, 60.0, 7), Taylor)
    assert found.drift["momentum_space"] < KEPT and found.drift["energy"] < KEPT
    assert found.received["energy"][-1] < -0.1
    assert str(found.outcome) == "successful" and set(found.invariants) == {"|L|²", "momentum_space"}


class Tilted(SprungMass):
    """A broken specimen: its spring pulls otherwise than its energy says."""

    def energy(self, own):
        return (1.0 + 1e-6) * super().energy(own)


@pytest.mark.long
def test_a_spring_whose_energy_is_another_is_found_out():
    body = RigidBody.from_body(cases.BODY, [Tilted((0.1, 0.4, 0.3), (0, 1, 0), 3.0, 4.0, 0.5)])
    state = body.pack(cases.ATTITUDE, cases.VELOCITY, rates=[0.3], coordinates=[0.1])
    assert worst_balance(body, 0.0, state)["energy"] > 1e-9


@pytest.mark.long
def test_states_are_packed_from_velocity_or_momentum():
    state = everything()
    momentum = np.asarray(EVERYTHING.vectors(state).momentum) @ cases.BODY.principal_axes.T
    packed = EVERYTHING.pack(cases.ATTITUDE, momentum=momentum, rates=RATES, coordinates=PLACES)
    assert np.abs(np.asarray(packed - state)).max() < 1e-13
    along = np.asarray(EVERYTHING.vectors(state).angular_velocity) @ cases.BODY.principal_axes.T
    assert np.abs(along - cases.VELOCITY).max() < 1e-14
    two = EVERYTHING.pack(cases.ATTITUDE, [cases.VELOCITY, -cases.VELOCITY], rates=RATES, coordinates=PLACES)
    assert two.shape == (2, len(state)) and np.abs(np.asarray(two[0] - state)).max() == 0.0
    names = EVERYTHING.layout(state).names
    assert names[:6] == ("attitude", "momentum", "displacement", "displacement_momentum", "deflection",
                         "deflection_momentum")  # fmt: skip
    assert {"gimbal_angle_1", "gimbal_angle_2", "rotor_momentum_2"} < set(names)


def test_a_locked_part_is_a_part_of_another_body():
    panel = HingedPart((0.0, 0.5, 0.0), (0.0, 0.0, 1.0), (0.1, 1.0, 0.0), 2.0, np.diag([0.1, 0.2, 0.25]))
    locked = RigidBody.from_body(cases.BODY, [LockedPart(panel, 0.7)])
    turn = np.array([[np.cos(0.7), -np.sin(0.7), 0.0], [np.sin(0.7), np.cos(0.7), 0.0], [0.0, 0.0, 1.0]])
    arm, hinge = np.array([0.1, 0.5, 0.0]), np.array([0.0, 0.5, 0.0])
    spread = lambda x: (x @ x) * np.eye(3) - np.outer(x, x)  # noqa: E731
    own, center, moved = np.diag([0.1, 0.2, 0.25]), cases.CENTER, hinge + turn @ arm
    about = cases.INERTIA + 40.0 * spread(center) - own - 2.0 * spread(hinge + arm)
    about = about + turn @ own @ turn.T + 2.0 * spread(moved)
    center = center + 2.0 * (moved - hinge - arm) / 40.0
    momentum = (about - 40.0 * spread(center)) @ cases.VELOCITY
    state = locked.pack(angular_velocity=cases.VELOCITY)
    assert np.abs(np.asarray(state) - momentum @ cases.BODY.principal_axes).max() < 1e-14


def test_a_heavy_beam_shakes_its_root_as_its_first_mode_does():
    """Of the mode of a clamped beam, by quadrature: frequency, effective mass, and where that sits."""
    with mp.workdps(20):
        root = mp.findroot(lambda x: mp.cos(x) * mp.cosh(x) + 1, 1.875)
        share = (mp.cosh(root) + mp.cos(root)) / (mp.sinh(root) + mp.sin(root))

        def mode(x):
            return mp.cosh(root * x) - mp.cos(root * x) - share * (mp.sinh(root * x) - mp.sin(root * x))

        moved, square = mp.quad(mode, [0, 1]), mp.quad(lambda x: mode(x) ** 2, [0, 1])
        place = mp.quad(lambda x: x * mode(x), [0, 1]) / moved
        wanted = [float(x) for x in (root**4 * 6.0 / (2.0 * 1.5**3), moved**2 / square, place)]
    beam = SprungMass.from_beam((0.2, 0.0, 0.0), (0.0, 0.0, 2.0), 1.5, 2.0, 6.0, damping_ratio=0.01)
    found = [float(beam.stiffness[0] / beam.mass), float(beam.mass) / 2.0, float(beam.place[2]) / 1.5]
    assert found == pytest.approx(wanted, rel=1e-14) and len(beam.directions) == 2
    assert float(beam.damping[0]) == pytest.approx(0.02 * np.sqrt(wanted[0]) * float(beam.mass), rel=1e-14)


@pytest.mark.long
def test_a_jet_damps_the_nutation_and_a_spin_about_the_jet_stays():
    """From a point at the centre: L_t = L_t(0) exp(−ṁ l² t/A) across, and L_z where the nozzle is on the axis."""
    body = ph.Body(50.0, (0.0, 0.0, 0.0), np.diag([8.0, 8.0, 5.0]))
    craft = RigidBody.from_body(body, [Propellant((0.0, 0.0, 0.0), 20.0, (0.0, 0.0, -1.2), 0.1)])
    times = np.linspace(0.0, 150.0, 4)
    found = ph.simulate(craft, craft.pack(cases.ATTITUDE, (0.1, 0.0, 2.0)), times).along("given")
    across = np.linalg.norm(found.momentum[:, :2], axis=-1)
    assert np.abs(across - 0.8 * np.exp(-0.1 * 1.2**2 * times / 8.0)).max() < KEPT
    assert np.abs(found.momentum[:, 2] - 10.0).max() < KEPT
    assert np.abs(found.part("propellant_mass") - (20.0 - 0.1 * times)).max() < KEPT


@pytest.mark.long
def test_a_burn_ends_where_it_says_or_where_the_tank_is_empty():
    thrust, nozzle = np.array([0.0, 0.0, -2000.0]), np.array([0.1, 0.0, -1.0])
    body = ph.Body(50.0, (0.0, 0.0, 0.0), np.diag([8.0, 8.0, 5.0]))
    pulse = Propellant((0.0, 0.0, 0.0), 2.0, nozzle, 1e-3, thrust, at=500.0, lasting=0.02)
    craft = RigidBody.from_body(body, [pulse])
    found = ph.simulate(craft, craft.pack(), [0.0, 1000.0]).along("given")
    # ΔL = r × F Δt with F = −ṁ u, less ∫ ṁ r² Ω dt that the jet damps
    damped = 0.5 * 1e-3 * (nozzle @ nozzle) / 8.0 * 0.02
    wanted = 0.02 * np.cross(nozzle, -1e-3 * thrust) * (1.0 - damped)
    assert damped > 1e-6 and np.abs(found.momentum[-1] - wanted).max() < 3e-12 * np.linalg.norm(wanted)
    assert found.part("propellant_mass")[-1] == pytest.approx(2.0 - 2e-5, abs=1e-15)
    always = RigidBody.from_body(body, [Propellant((0.0, 0.0, 0.0), 2.0, nozzle, 0.01)])
    ended = ph.simulate(always, always.pack(angular_velocity=(0.0, 0.0, 0.1)), [0.0, 1000.0])
    assert ended.times[-1] == pytest.approx(200.0, rel=1e-12) and "tank empty" in str(ended.outcome)


@pytest.mark.long
@pytest.mark.long
def test_a_gyroscope_gives_the_torque_of_its_turning_momentum():
    """A body of great inertia hardly turns, and feels −h γ̇ g × s; a servo of great bandwidth follows its rate."""
    gyroscope = ControlMomentGyroscope((0, 0, 1), HeldWheel((1, 0, 0), 0.1, 100.0), (0.2, 0.1, 0.15),
                                       gimbal_rate=0.5, bandwidth=200.0)  # fmt: skip
    heavy = RigidBody((1e6, 2e6, 2.5e6), [gyroscope])
    start = heavy.pack(cases.ATTITUDE, (0.0, 0.0, 0.0), rates=[0.5])
    found = ph.simulate(heavy, start, [0.0, 1.0])
    gained = found.angular_velocity[-1] * [1e6, 2e6, 2.5e6]
    # L of the body is the rotor's at first less the rotor's then
    wanted = 10.0 * np.array([1.0 - np.cos(0.5), -np.sin(0.5), 0.0])
    assert np.abs(gained - wanted).max() < 1e-4 and found.part("gimbal_angle")[-1] == pytest.approx(0.5, abs=1e-5)


@pytest.mark.long
def test_pulled_by_gravity_its_parts_move_as_points_in_orbit():
    """A mass on a rod along the radius feels 3 n² z: at rest in the orbit's frame, k z = 3 n² m (z₀ + z) (1 − m/M)."""
    n, mass, stiffness, place = 1e-3, 5.0, 1e-2, 4.0
    body = ph.Body(100.0, (0.0, 0.0, 0.0), np.diag([900.0, 1000.0, 400.0]))
    craft = RigidBody.from_body(body, [SprungMass((0.0, 0.0, place), (0, 0, 1), mass, stiffness)],
                                [GravityGradient(KeplerOrbit(n, 0.0))])  # fmt: skip
    # against the centre of mass, which has moved by m z/M
    factor = 3.0 * n**2 * mass
    still = factor * place / (stiffness * 1.0 - factor * (1.0 - mass / 100.0))
    turn = rotation.from_matrix(np.array([[0.0, 0.0, 1.0], [-1.0, 0.0, 0.0], [0.0, -1.0, 0.0]]))
    state = craft.pack(turn, (0.0, -n, 0.0), coordinates=[still])
    rates = craft.layout(state).part(craft.vector_field(0.0, state), "displacement_momentum")
    assert abs(float(rates)) < 1e-15


class Unplaced(SprungMass):
    def position(self, q):
        return q


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda: RigidBody((1.0, 2.0, 2.5), [PARTS[0]]), "needs the mass of the whole body"),
        (lambda: RigidBody.from_body(ph.Body(None, (0, 0, 0), np.eye(3)), [PARTS[1]]), "needs the mass of the whole"),
        (lambda: RigidBody.from_body(cases.BODY, [Unplaced((0, 0, 0), (1, 0, 0), 1.0, 1.0)]), "must give `position`"),
        (lambda: RigidBody.from_body(cases.BODY, [3]), "Derive your own from AbstractMount or AbstractMovingPart"),
        (lambda: RigidBody.from_body(cases.BODY, [SprungMass((3, 0, 0), (1, 0, 0), 30.0, 1.0)]), "parts of the body"),
        (lambda: SprungMass((0, 0, 0), [(1, 0, 0), (1, 1, 0)], 1.0, 1.0), "perpendicular to each other"),
        (lambda: SprungMass((0, 0, 0), (1, 0), 1.0, 1.0), "`directions` must be a list of directions"),
        (lambda: SprungMass((0, 0, 0), (1, 0, 0), 1.0, -1.0), "`stiffness` must be one finite number not below 0"),
        (lambda: SprungMass((0, 0, 0), (1, 0, 0), 0.0, 1.0), "`mass` must be positive and finite"),
        (lambda: HingedPart((0, 0, 0), (1, 0, 0), (1, 0, 0), 1.0), "off the hinge's axis"),
        (lambda: ControlMomentGyroscope((1, 0, 0), Wheel((1, 0, 0), 0.1), (1, 1, 1)), "perpendicular to the rotor"),
        (lambda: ControlMomentGyroscope((1, 0, 0), 3, (1, 1, 1)), "`rotor` must be"),
        (lambda: ControlMomentGyroscope((0, 0, 1), Wheel((1, 0, 0), 0.3), (0.2, 1, 1)), "above the rotor's 0.3"),
        (lambda: ControlMomentGyroscope((0, 0, 1), Wheel((1, 0, 0), 0.1), (1, 1, 1), gimbal_rate=1.0), "go together"),
        (lambda: ControlMomentGyroscope((0, 0, 1), Wheel((1, 0, 0), 0.1), (1, 1, 1), 1.0, 1.0, 1.0), "not both"),
        (lambda: LockedPart(PARTS[3], 0.1), "`part` must be a moving part"),
        (lambda: LockedPart(PARTS[0], 0.1), "`coordinates` must be two finite numbers"),
        (lambda: Propellant((0, 0, 0), 1.0, (0, 0, 0), 0.1, at=0.0, lasting=20.0), "must be less than the mass in"),
        (lambda: Propellant((0, 0, 0), 1.0, (0, 0, 0), 0.1, at=0.0), "`at` and `lasting` go together"),
        (lambda: RigidBody.from_body(cases.BODY, [Propellant((0, 0, 0), 41.0, (0, 0, 0), 0.1)]), "part of the body"),
        (lambda: RigidBody((1.0, 2.0, 2.5), [Propellant((0, 0, 0), 1.0, (0, 0, 0), 0.1)]), "needs that of the whole"),
        (lambda: EVERYTHING.pack(coordinates=[None] * 3 + [0.1] + [None] * 3), r"`coordinates\[3\]` is for a Wheel"),
        (lambda: EVERYTHING.pack(angular_velocity=(0, 0, np.nan)), "`angular_velocity` must be finite"),
        (lambda: EVERYTHING.pack(coordinates=[(np.nan, 0.0)] + [None] * 6), r"`coordinates\[0\]` must be finite"),
        (lambda: EVERYTHING.pack(coordinates=[0.1] + [None] * 6), r"`coordinates\[0\]` must have shape"),
        (lambda: EVERYTHING.pack(rates=[(0.1, 0.2, 0.3)] + [None] * 6), r"`rates\[0\]` must have shape"),
    ],
)  # fmt: skip
@pytest.mark.usefixtures("any_type")
def test_bad_input(call, words):
    with pytest.raises(InvalidInput, match=words):
        call()


@pytest.mark.long
def test_a_part_of_ones_own():
    """A bead on a ring in the body, which only says where it is."""

    class Bead(AbstractMovingPart):
        mass: jnp.ndarray

        @property
        def coordinates(self):
            return (ph.motion.StatePart("bead_angle", 1, "rad", "angle of a bead"),)

        def position(self, q):
            return jnp.concatenate([jnp.cos(q), jnp.sin(q), jnp.zeros_like(q)], axis=-1)

    body = RigidBody.from_body(cases.BODY, [Bead(jnp.asarray(2.0))])
    found = ph.simulate(body, body.pack(cases.ATTITUDE, cases.VELOCITY, rates=[0.5]), np.linspace(0.0, 20.0, 5))
    assert set(found.invariants) == {"energy", "|L|²", "momentum_space"} and max(found.drift.values()) < KEPT


@pytest.mark.long
@pytest.mark.parametrize("rate", [(0.0, 40.0, 0.0), (0.0, 40.0, 1e-9), (0.3, 40.0, 0.0)])
def test_a_pendulum_goes_over_its_top(rate):
    """Over the top exactly, or nearly: its angle from rest against the pendulum's own equation, in a heavy hub."""
    length, mass, stiffness = 0.3, 0.1, 1.0
    hub = ph.Body(1e9, (0.0, 0.0, 0.0), np.diag([2e9, 3e9, 2.5e9]))
    swing = SphericalPendulum((0.0, 0.0, 0.0), (0.0, 0.0, -length), mass, stiffness)
    body = RigidBody.from_body(hub, [swing])
    times = np.linspace(0.0, 2.0, 201)
    found = ph.simulate(body, body.pack((1.0, 0.0, 0.0, 0.0), (0.0, 0.0, 0.0), rates=[rate]), times)
    assert found.outcome.ending.value == "successful" and found.drift["energy"] < KEPT
    toward = found.part("deflection") + np.array([0.0, 0.0, -1.0])
    speed = np.hypot(rate[0], rate[1])  # about the arm itself it does not turn
    plane = solve_ivp(lambda t, x: [x[1], -stiffness / (mass * length**2) * np.sin(x[0])], (0.0, 2.0), [0.0, speed],
                      "DOP853", times, rtol=1e-13, atol=1e-13).y[0]  # fmt: skip
    assert plane[-1] > 4.0 * np.pi
    assert -toward[:, 2] / np.linalg.norm(toward, axis=1) == pytest.approx(np.cos(plane), abs=1e-8)
    assert np.linalg.norm(toward, axis=1) == pytest.approx(np.ones(201), abs=1e-12)
