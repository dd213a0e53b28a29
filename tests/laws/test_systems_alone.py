"""Every method of every system, orbit, torque and law of friction, alone under jit, vmap, jvp and grad."""

import inspect

import numpy as np
import pytest

import polhode
from polhode import celestial, fields, rolling, spacecraft, systems
from polhode.spacecraft.systems.attachments import AbstractAttachment
from polhode.systems.base import AbstractLiePoissonSystem, components
from registered import public_classes
from specimens import SYSTEMS
from transformed import check_alone

RNG = np.random.default_rng(4)
FIRST = RNG.bit_generator.state
MOMENTS = (1.0, 2.0, 2.5)
ORBIT = systems.KeplerOrbit(0.7, 0.3, 0.4, inclination=1.1, node=0.7, periapsis=0.3, semi_major_axis=2.0)
DISK = rolling.EulerDisk(0.4, 0.04, 0.01, dissipation=[rolling.AirLayer(1.8e-4)])
LAWS = [
    rolling.AirLayer(1.8e-4), rolling.BoundaryLayer(1e-9), rolling.ViscousContourFriction(1e-7),
    rolling.DryContourFriction(1e-5), rolling.RollingCouple(1e-6), rolling.DrillingFriction(1e-5),
]  # fmt: skip


def motor(t, attitude, angular_velocity, rate):
    return 0.3 * t - 0.1 * rate + 0.2 * attitude[..., 1] + 0.1 * angular_velocity[..., 0]


ROTOR, SLUG = spacecraft.Wheel((1.0, 2.0, 3.0), 0.3, motor, 0.1), spacecraft.SphericalSlug(0.2, 0.3)
SINK = spacecraft.EnergySink(0.1)
LAGGED = spacecraft.LaggedTorque(lambda t, attitude, velocity: t[..., None] * velocity + attitude[..., 1:], 0.7)
HELD = spacecraft.HeldWheel((0.0, 1.0, 1.0), 0.1, 5.0)
GRAVITY = spacecraft.GravityGradient(systems.KeplerOrbit(0.7, 0.0, 0.4), MOMENTS)
WAY = systems.KeplerOrbit.from_semi_major_axis(7e6, 3.986004418e14, 0.05, 0.4, inclination=1.1, node=0.7, periapsis=0.3)
FIELD = spacecraft.EarthDipoleField(WAY, 0.3)
PLATES = {"areas": [1.0, 2.0], "normals": np.eye(3)[:2], "positions": np.eye(3)[1:]}
POINTING = spacecraft.QuaternionPD(0.3, (0.2, 0.3, 0.4), target="nadir", orbit=WAY)
STEADYING = spacecraft.RateControl((0.1, 0.2, 0.3), 0.5)
OWN_LAW = spacecraft.UserLaw(lambda t, q, w, own: q[..., 1:] - w + own, lambda t, q, w, own: w - 0.1 * own, 3)
WHEELS = spacecraft.ControlledWheels(np.eye(3), 0.01, OWN_LAW, max_torque=0.9, max_rate=300.0, friction=0.1)
CONTROL = [
    FIELD, POINTING, STEADYING, OWN_LAW, WHEELS, spacecraft.ControlTorque(POINTING, 0.4),
    spacecraft.Thruster([0.6, 1.1], 0.4, (1.0, 2.0, 3.0), (0.1, 0.2, 0.3)),
    spacecraft.ConstantTorque((0.1, 0.2, 0.3), "space"), spacecraft.DumpingThrusters(0.2, 0.1, 0.3),
    spacecraft.MagneticDipole(FIELD, (1e3, 2e3, 3e3)),
    spacecraft.TorqueRods(FIELD, 1e7, "dump", limit=1e5), spacecraft.EddyCurrents(FIELD, 1e9),
    spacecraft.SolarPressure((1.0, 2.0, 3.0), **PLATES, specular=0.3, diffuse=0.2, pressure=1.0, orbit=WAY),
    spacecraft.AerodynamicDrag(WAY, 1e-8, **PLATES),
]
SLOSH = spacecraft.SprungMass((0.1, 0.2, 0.1), [(1.0, 0.0, 0.0), (0.0, 1.0, 1.0)], 0.3, 2.0, 0.1)
PANEL = spacecraft.HingedPart(
    (0.2, 0.0, 0.0), (0.0, 1.0, 0.0), (0.5, 0.0, 0.1), 0.2, np.diag([0.02, 0.03, 0.04]), 1.0, 0.1,
    motor=lambda t, attitude, velocity, angle, rate: 0.1 * t + attitude[..., 1] - rate,
)  # fmt: skip
PENDULUM = spacecraft.SphericalPendulum((0.0, 0.1, 0.2), (0.0, 0.1, -0.3), 0.2, 0.4, 0.05)
GYROSCOPE = spacecraft.ControlMomentGyroscope((0.0, 0.0, 1.0), spacecraft.Wheel((1.0, 0.0, 0.0), 0.02, motor),
                                           (0.05, 0.03, 0.04), 0.1, friction=0.2)  # fmt: skip
LOCKED = spacecraft.LockedPart(PANEL, 0.4)
FUEL = spacecraft.Propellant((0.0, 0.1, 0.0), 0.5, (0.0, 0.0, -0.7), lambda t: 0.01 * t, (0.0, 0.0, -3.0))
CRAFT = polhode.Body(12.0, (0.01, 0.02, -0.03), np.diag(MOMENTS))
SPECIMENS = [
    SLOSH, PANEL, PENDULUM, GYROSCOPE, LOCKED, FUEL,
    *{type(system): system for system in reversed(SYSTEMS)}.values(), DISK, celestial.SpinOrbit(0.89, 0.4), ORBIT,
    *LAWS,
    spacecraft.LinearDrag((0.1, 0.2, 0.3)), spacecraft.QuadraticDrag(0.05), spacecraft.GravityGradient(ORBIT, MOMENTS),
    ROTOR, HELD, SLUG, SINK, LAGGED, spacecraft.RigidBody.from_body(
        CRAFT, [ROTOR, HELD, SLUG, SINK, SLOSH, PANEL, PENDULUM, GYROSCOPE, LOCKED, FUEL], [GRAVITY, LAGGED]),
    spacecraft.TorquedBody(MOMENTS, [spacecraft.LinearDrag(0.3), spacecraft.GravityGradient(ORBIT, MOMENTS)]),
    systems.TorquedGyrostat(MOMENTS, (1.0, 2.0, 3.0), 0.3, 0.1), systems.Variations(systems.FreeRigidBody(MOMENTS), 2),
    *CONTROL, spacecraft.RigidBody(MOMENTS, [WHEELS], [spacecraft.TorqueRods(FIELD, 1e7, "dump", limit=1e5)]),
]  # fmt: skip
NOT_MOVING = {spacecraft.AbstractControlLaw, spacecraft.Argument, spacecraft.AbstractMovingPart,
              systems.AbstractLiePoissonSystem, systems.AbstractSystem, spacecraft.AbstractTorque,
              spacecraft.AbstractMount, spacecraft.AbstractRigidBody, rolling.RollingDissipation,
              systems.Balance, systems.RotorInBody,
              fields.Bond, fields.Lattice, fields.exchange_matrix, fields.quiet_start,
              systems.rotor_in_body}  # fmt: skip
LEFT_OUT = {
    "ring": "takes an angle, and is tested in tests/fields/point_vortices/test_system.py",
    "polygon": "takes a radius, and is tested in tests/fields/point_vortices/test_system.py",
    "SphereVortices.pack": "takes positions, and is tested in tests/fields/point_vortices/test_system.py",
    "PlaneVortices.pack": "takes positions, and is tested in tests/fields/point_vortices/test_system.py",
    "VlasovPoisson.pack": "takes positions, and is tested in tests/fields/vlasov_poisson/test_system.py",
    "aligned": "takes directions, and is tested in tests/fields/spin_lattice/test_system.py",
    "check_state": "refuses traced numbers, see test_refused_when_traced",
    "upright": "refuses traced numbers, see test_refused_when_traced",
    "rolling_state": "refuses traced numbers, see test_refused_when_traced",
    "EulerDisk.steady_motion": "refuses traced numbers, see test_refused_when_traced",
    "EulerDisk.state": "refuses traced numbers, see test_refused_when_traced",
    "EulerDisk.pack": "refuses traced numbers, see test_refused_when_traced",
    "EulerDisk.linear_integrals": "of thin disks only, by Legendre functions of a table",
    "HeavyTop.from_body": "takes a body, whose numbers are known",
    "HeavyTop.from_motion": "refuses traced numbers, see test_refused_when_traced",
    "HeavyTop.leaning": "refuses traced numbers, see test_refused_when_traced",
    "from_harmonics": "refuses traced numbers, see test_refused_when_traced",
    "random": "refuses traced numbers, see test_refused_when_traced",
    "on_grid": "refuses traced numbers, see test_refused_when_traced",
    "zonal_velocity": "refuses traced numbers, see test_refused_when_traced",
    "vortex": "refuses traced numbers, see test_refused_when_traced",
    "SphereFluid.cost": "takes whole numbers, and is tested in tests/fields/sphere_fluid/test_system.py",
    "Variations.scales": "are infinite for changes",
    "start_of": "takes the table of a spec, whose numbers are known",
    "from_table": "takes the table of a spec, whose numbers are known",
    "bound": "takes the axes of a body, whose numbers are known",
    "started": "chooses a sign by numbers that are known",
    "check_size": "refuses an orbit of unknown size",
    "without_limits": "returns a system",
    "as_given": "takes a state apart, and is called by the others",
    "torques_apart": "returns a list, whose sum is tested by external_torque",
    "at_rest": "takes nothing, and is called by the equations of motion",
    "Propellant.start": "takes no rate, and is tested in tests/spacecraft/test_moving_parts.py",
    "from_beam": "refuses traced numbers, see test_refused_when_traced",
    "RigidBody.from_body": "takes a body, whose numbers are known",
    "layout": "says what numbers mean, and returns none",
    "part": "takes the name of a part of a state",
    "remark": "returns a sentence",
    "parts": "takes a state apart, and is called by the others",
    "space_vectors": "is called by invariants, with an attitude",
}
DISK_START = np.array([0.4, 0.3, 0.2, 0.01, 0.02, 0.1, 6.0, 1.0])
AT_ONCE = systems.FreeRigidBody
BATCH_OF_TIMES_ONLY = ("vector_field", "balances", "generator", "torque", "relative_velocity",
                       "force", "forces", "load", "wanted", "commanded", "motor_torques", "state_rate", "power",
                       "moments_of_rods", "packed_as_given", "rotor_rates")  # fmt: skip


def unit(rows):
    return rows / np.linalg.norm(rows, axis=-1, keepdims=True)


def starts(system):
    """Return three states, with an attitude in front where the system may have one."""
    if isinstance(system, rolling.EulerDisk):
        return DISK_START * (1.0 + 0.1 * RNG.uniform(size=(3, 8)))
    if isinstance(system, celestial.SpinOrbit):
        return RNG.normal(size=(3, 2))
    if isinstance(system, systems.Variations):
        return RNG.normal(size=(3, 1 + system.count, 3))
    attitude = unit(RNG.normal(size=(3, 4)))
    if not isinstance(system, AbstractLiePoissonSystem):
        torqued = isinstance(system, systems.TorquedGyrostat)  # which has its rotor's momentum behind that of all
        own = 1 if torqued else sum(part.size for part in system.own_parts)
        return np.concatenate([attitude, RNG.normal(size=(3, 3 + own))], axis=1)
    point = points(system)
    if not system.carries_attitude:
        return point
    return np.concatenate([attitude, point], axis=1)


def points(system):
    """Return three points of the dual: vortices apart, particles with weights, where H has no singularity nearby."""
    if isinstance(system, VORTICES):
        places = np.asarray(system.positions(getattr(system, "ring", getattr(system, "polygon", None))(1.0)))
        return np.asarray(system.pack(places + 0.1 * RNG.normal(size=(3, *places.shape))))
    if isinstance(system, fields.VlasovPoisson):
        own = RNG.normal(size=(2, 3, system.algebra.copies))
        return np.asarray(system.pack(*own, RNG.uniform(0.5, 2.0, own.shape[1:])))
    return np.asarray(system.algebra.from_dual_vector(RNG.normal(size=(3, system.algebra.dim))))


def arguments(system, method):
    state = starts(system) if not isinstance(system, NO_STATE) else None
    values = {"t": RNG.uniform(0.5, 2.0, 3), "state": state, "attitude": unit(RNG.normal(size=(3, 4))),
              "tilt": RNG.uniform(0.2, 0.5, 3), "precession": RNG.uniform(1.0, 2.0, 3)}  # fmt: skip
    values |= {name: RNG.normal(size=(3, 3)) for name in ("acceleration", "angular_velocity", "velocity", "momentum")}
    if isinstance(system, ATTACHED):
        values["own"] = values["actuator"] = RNG.normal(size=(3, system.state_size))
        values["rate"] = RNG.normal(size=(3, 3) if system in (SLUG, WHEELS) else 3)
        values["stored"] = RNG.normal(size=(3, 3))
    if isinstance(system, spacecraft.AbstractMovingPart):
        values["q"] = 0.3 * RNG.normal(size=(3, system.count))
        count = system.rate_count if method.__name__ == "start_further" else system.count
        values["rate"] = RNG.normal(size=(3, count))
    if isinstance(system, AbstractLiePoissonSystem):
        values["point"] = points(system)
    flat = isinstance(system, fields.PlaneVortices)
    values["places"] = 3.0 + RNG.normal(size=(3, 2)) if flat else unit(RNG.normal(size=(3, 3)))
    names = list(inspect.signature(method).parameters)
    if method.__name__ == "pack":  # angular velocity or momentum; mounts at rest
        names = [name for name in names if name not in ("momentum", "rates", "actuators", "coordinates")]
    return [None if name == "disk" else values[name] for name in names]


VORTICES = (fields.SphereVortices, fields.PlaneVortices)
ATTACHED = (spacecraft.AbstractMount, spacecraft.AbstractMovingPart, spacecraft.AbstractTorque,
            spacecraft.AbstractControlLaw)
NO_STATE = (systems.KeplerOrbit, spacecraft.EarthDipoleField, rolling.RollingDissipation, *ATTACHED)


def methods():
    """Each function once with an attitude and once without; heirs share it."""
    tested = set()
    for system in [*(s for s in SPECIMENS if isinstance(s, AT_ONCE)), *SPECIMENS]:
        kind = type(system).__name__
        for name in dir(type(system)):
            plain = inspect.isfunction(inspect.getattr_static(type(system), name))
            one = inspect.getattr_static(type(system), name), getattr(system, "carries_attitude", None)
            new = plain and one not in tested and name not in LEFT_OUT and f"{kind}.{name}" not in LEFT_OUT
            if new and not name.startswith("_"):
                tested.add(one)
                slow = [] if isinstance(system, AT_ONCE) else [pytest.mark.sweep]
                yield pytest.param(system, name, id=f"{kind} {name}", marks=slow)


@pytest.fixture(autouse=True)
def same_numbers():
    """Each test has the same numbers, whatever ran before it."""
    RNG.bit_generator.state = FIRST


def test_no_public_class_is_forgotten():
    classes = public_classes(systems, systems.AbstractSystem, rolling.RollingDissipation, AbstractAttachment,
                             spacecraft.EarthDipoleField)  # fmt: skip
    assert classes - NOT_MOVING == {type(system) for system in SPECIMENS}


@pytest.mark.parametrize(("system", "name"), list(methods()))
def test_method_alone(system, name):
    method = getattr(system, name)
    given = arguments(system, method)
    if name == "scales":  # of a whole batch at once
        return check_alone(method, *given, batched=False)
    if given[0] is None:  # the disk
        return check_alone(lambda *x: method(DISK.mechanics, *x), *given[1:])
    if np.iscomplexobj(given[-1]):
        real = [np.asarray(system.algebra.to_dual_vector(x)) if np.iscomplexobj(x) else x for x in given]
        last = system.algebra.from_dual_vector
        return check_alone(lambda *x: method(*x[:-1], last(x[-1])), *real, batched=name not in BATCH_OF_TIMES_ONLY)
    one_state = isinstance(system, VORTICES) and name == "stream_function"
    return check_alone(method, *given, batched=name not in BATCH_OF_TIMES_ONLY and not one_state)


@pytest.mark.parametrize("system", [s for s in SPECIMENS if isinstance(s, AbstractLiePoissonSystem) and s.flows],
                         ids=lambda s: type(s).__name__)  # fmt: skip
@pytest.mark.sweep
def test_flows_alone(system):
    """Each flow, and each further invariant: functions that a property gives."""
    for name, flow in system.flows.items():
        if name == "free body" and not isinstance(system, systems.HeavyTop):
            continue  # one function does them all
        check_alone(lambda t, state, flow=flow: flow(t, components(state)), RNG.uniform(0.5, 2.0, 3), starts(system),
                    batched=False, reverse=name != "free body")  # fmt: skip
    for integral in system.extra_invariants.values():
        check_alone(integral, arguments(system, system.energy)[0], batched=False)


@pytest.mark.sweep
def test_events_alone():
    for event in DISK.events.values():
        check_alone(event, RNG.uniform(0.5, 2.0, 3), starts(DISK), batched=False)
