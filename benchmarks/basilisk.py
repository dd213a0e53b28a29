"""Bodies with wheels, gravity and slosh beside Basilisk in one process: how far apart after 6000 s.

``python benchmarks/basilisk.py`` needs Basilisk, the package ``bsk``. It prints for each case the largest angle between
the two attitudes [rad], and the CPU seconds of both.

Source: Kenneally, Piggott & Schaub, "Basilisk: A Flexible, Scalable and Modular Astrodynamics Simulation Framework",
J. Aerosp. Inf. Syst. 17 (2020) 496.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from typing import Any

import numpy as np

import polhode as ph
from polhode import rotation
from polhode.spacecraft import GravityGradient, HingedPart, RigidBody, SphericalPendulum, SprungMass, Thruster, Wheel
from polhode.systems import KeplerOrbit

UNTIL, SAMPLES = 6000.0, 61
STEP = 0.05  # s, of Basilisk's RKF78
MASS, CENTER = 750.0, np.array([0.02, -0.01, 0.04])
INERTIA = np.array([[900.0, 12.0, -8.0], [12.0, 800.0, 15.0], [-8.0, 15.0, 600.0]])
VELOCITY = np.array([0.002, -0.003, 0.004])
EARTH, RADIUS = 3.986004418e14, 7.0e6


def spread(place: np.ndarray) -> np.ndarray:
    """Return |x|² 1 − x xᵀ."""
    return place @ place * np.eye(3) - np.outer(place, place)


def whole(parts: list[tuple[float, np.ndarray, np.ndarray]]) -> ph.Body:
    """Return the body of the hub and parts of a mass, a place and an inertia."""
    mass = MASS + sum(m for m, _, _ in parts)
    center = (MASS * CENTER + sum((m * r for m, r, _ in parts), np.zeros(3))) / mass
    added = (inertia + m * spread(r) for m, r, inertia in parts)
    about = INERTIA + MASS * spread(CENTER) + sum(added, np.zeros((3, 3)))
    return ph.Body(mass, center, about - mass * spread(center))


def basilisk(
    add: Callable[..., Any], step: float = STEP, velocity: np.ndarray = VELOCITY, default: bool = False
) -> np.ndarray:
    """Return the attitudes as MRPs of the hub's frame at the samples.

    Args:
        add: puts effectors onto (simulation, spacecraft, task), and returns what has to live as long as these.
        step: of the task and of the integrator [s].
        velocity: (3,) at the start [rad/s, hub's axes].
        default: whether to take Basilisk's own integrator, RK4, in place of RKF78.
    """
    from Basilisk.simulation import spacecraft, svIntegrators
    from Basilisk.utilities import SimulationBaseClass, macros

    sim = SimulationBaseClass.SimBaseClass()
    process = sim.CreateNewProcess("process")
    process.addTask(sim.CreateNewTask("task", macros.sec2nano(step)))
    craft = spacecraft.Spacecraft()
    craft.ModelTag = "craft"
    craft.hub.mHub, craft.hub.r_BcB_B = MASS, CENTER.reshape(3, 1).tolist()
    craft.hub.IHubPntBc_B, craft.hub.omega_BN_BInit = INERTIA.tolist(), velocity.reshape(3, 1).tolist()
    craft.hub.sigma_BNInit = [[0.0], [0.0], [0.0]]
    kept = [add(sim, craft, "task")]
    if not default:
        integrator = svIntegrators.svIntegratorRKF78(craft)
        integrator.relTol, integrator.absTol = 1e-13, 1e-14
        craft.setIntegrator(integrator)
    sim.AddModelToTask("task", craft)
    recorder = craft.scStateOutMsg.recorder(macros.sec2nano(UNTIL / (SAMPLES - 1)))
    sim.AddModelToTask("task", recorder)
    sim.InitializeSimulation()
    for when, switch in getattr(kept[0], "switches", []):  # at whole steps
        sim.ConfigureStopTime(macros.sec2nano(when))
        sim.ExecuteSimulation()
        switch()
    sim.ConfigureStopTime(macros.sec2nano(UNTIL))
    sim.ExecuteSimulation()
    kept.clear()
    return np.array(recorder.sigma_BN)


def apart(found: ph.Trajectory, modified: np.ndarray) -> float:
    """Return the largest angle between attitudes along the given axes and MRPs [rad]."""
    return angle(np.asarray(found.along("given").attitude), quaternions(modified))


def quaternions(modified: np.ndarray) -> np.ndarray:
    """Return unit quaternions of MRPs (…, 3)."""
    square = np.sum(modified**2, axis=-1, keepdims=True)
    return np.concatenate([1.0 - square, 2.0 * modified], axis=-1) / (1.0 + square)


def angle(ours: np.ndarray, theirs: np.ndarray) -> float:
    """Return the largest angle between unit quaternions [rad]."""
    between = rotation.multiply(rotation.conjugate(ours), theirs[: len(ours)])
    return float(2.0 * np.arcsin(np.minimum(np.linalg.norm(between[:, 1:], axis=-1), 1.0)).max())


WHEEL_AXES = np.array([[1.0, 0.0, 0.0], [0.6, 0.8, 0.0], [0.48, 0.6, 0.64]])
WHEEL_RATES, WHEEL_TORQUES, WHEEL_MOMENT = np.array([100.0, -50.0, 30.0]), np.array([1e-3, -2e-3, 0.0]), 0.159


def wheels(velocity: np.ndarray = VELOCITY) -> tuple[RigidBody, Any, Callable[..., Any]]:
    """Three wheels on skew axes, two of them driven by constant torques."""
    axes, rates, torques, moment = WHEEL_AXES, WHEEL_RATES, WHEEL_TORQUES, WHEEL_MOMENT
    body = RigidBody.from_body(whole([]), [Wheel(a, moment, u) for a, u in zip(axes, torques, strict=True)])

    def add(sim: Any, craft: Any, task: str) -> Any:
        from Basilisk.architecture import messaging
        from Basilisk.simulation import reactionWheelStateEffector
        from Basilisk.utilities import simIncludeRW

        factory = simIncludeRW.rwFactory()
        for axis, rate in zip(axes, rates, strict=True):
            factory.create("custom", axis.tolist(), Omega=rate / 2.0 / np.pi * 60.0, Js=moment, maxMomentum=1e6,
                           RWModel=messaging.BalancedWheels, useMaxTorque=False)  # fmt: skip
        effector = reactionWheelStateEffector.ReactionWheelStateEffector()
        factory.addToSpacecraft("wheels", effector, craft)
        content = messaging.ArrayMotorTorqueMsgPayload()
        content.motorTorque = torques.tolist()
        message = messaging.ArrayMotorTorqueMsg().write(content)
        effector.rwMotorCmdInMsg.subscribeTo(message)
        sim.AddModelToTask(task, effector)
        return factory, effector, message

    return body, body.pack((1.0, 0.0, 0.0, 0.0), velocity, rates=list(rates)), add


def gravity() -> tuple[RigidBody, Any, Callable[..., Any]]:
    """Gravity's gradient on a circular orbit."""
    orbit = KeplerOrbit.from_semi_major_axis(RADIUS, EARTH, 0.0)
    body = RigidBody.from_body(whole([]), torques=[GravityGradient(orbit)])

    def add(sim: Any, craft: Any, task: str) -> Any:
        from Basilisk.simulation import GravityGradientEffector
        from Basilisk.utilities import simIncludeGravBody

        factory = simIncludeGravBody.gravBodyFactory()
        earth = factory.createEarth()
        earth.isCentralBody, earth.mu = True, EARTH
        factory.addBodiesTo(craft)
        # the hub's origin is CENTER from the centre of mass, which moves on the orbit
        speed = np.sqrt(EARTH / RADIUS)
        craft.hub.r_CN_NInit = (np.array([RADIUS, 0.0, 0.0])).reshape(3, 1).tolist()
        craft.hub.v_CN_NInit = (np.array([0.0, speed, 0.0])).reshape(3, 1).tolist()
        effector = GravityGradientEffector.GravityGradientEffector()
        effector.addPlanetName(earth.planetName)
        craft.addDynamicEffector(effector)
        sim.AddModelToTask(task, effector)
        return factory, effector

    return body, body.pack((1.0, 0.0, 0.0, 0.0), VELOCITY), add


class Pulses:
    """A jet of Basilisk that is switched between two runs: as a force at the hub's origin, and its torque about it."""

    def __init__(self, sim: Any, craft: Any, task: str, jet: Thruster) -> None:
        from Basilisk.simulation import extForceTorque

        self.effector = extForceTorque.ExtForceTorque()
        craft.addDynamicEffector(self.effector)
        sim.AddModelToTask(task, self.effector)
        force = np.asarray(jet.thrust)
        torque, column = np.cross(np.asarray(jet.position), force), lambda x: x.reshape(3, 1).tolist()

        def put(size: float) -> None:
            self.effector.extForce_B, self.effector.extTorquePntB_B = column(size * force), column(size * torque)

        put(0.0)
        pairs = zip(jet.begins.tolist(), jet.ends.tolist(), strict=True)
        self.switches = [one for begin, end in pairs for one in ((begin, lambda: put(1.0)), (end, lambda: put(0.0)))]


def pulses() -> tuple[RigidBody, Any, Callable[..., Any]]:
    """Pulses of a jet off the centre of mass."""
    jet = Thruster([500.0, 2000.0, 4000.0], [0.5, 20.0, 1.0], (0.3, -0.2, 0.1), (0.5, 0.4, -0.3))
    body = RigidBody.from_body(whole([]), torques=[jet])
    return body, body.pack((1.0, 0.0, 0.0, 0.0), VELOCITY), lambda sim, craft, task: Pulses(sim, craft, task, jet)


def slosh() -> tuple[RigidBody, Any, Callable[..., Any]]:
    """Two slosh particles on springs."""
    places, directions = np.array([[0.4, 0.1, 0.3], [-0.2, 0.3, -0.5]]), np.array([[1.0, 0.0, 0.0], [0.0, 0.6, 0.8]])
    mass, stiffness, damping = 20.0, 0.5, 0.02
    starts = [0.05, -0.03]
    body = RigidBody.from_body(
        whole([(mass, place, np.zeros((3, 3))) for place in places]),
        [SprungMass(place, along, mass, stiffness, damping) for place, along in zip(places, directions, strict=True)],
    )

    def add(sim: Any, craft: Any, task: str) -> Any:
        from Basilisk.simulation import linearSpringMassDamper

        particles = []
        for place, along, start in zip(places, directions, starts, strict=True):
            particle = linearSpringMassDamper.LinearSpringMassDamper()
            particle.k, particle.c, particle.massInit = stiffness, damping, mass
            particle.r_PB_B, particle.pHat_B = place.reshape(3, 1).tolist(), along.reshape(3, 1).tolist()
            particle.rhoInit, particle.rhoDotInit = start, 0.0
            craft.addStateEffector(particle)
            particles.append(particle)
        return particles

    return body, body.pack((1.0, 0.0, 0.0, 0.0), VELOCITY, coordinates=starts), add


def pendulum() -> tuple[RigidBody, Any, Callable[..., Any]]:
    """A pendulum, whose angles Basilisk takes as φ about its third and θ about the turned second direction.

    It starts along the body's first axis, where both angles are zero. So the angular velocity of its arm against the
    body is then (0, θ̇, φ̇).
    """
    pivot, length, mass, damping = np.array([0.1, 0.0, 0.5]), 0.8, 20.0, 0.5
    rest = np.array([1.0, 0.0, 0.0])
    phi_rate, theta_rate = 4e-3, -3e-3
    part = SphericalPendulum(pivot, length * rest, mass, 0.0, damping * length**2)
    body = RigidBody.from_body(whole([(mass, pivot + length * rest, np.zeros((3, 3)))]), [part])

    def add(sim: Any, craft: Any, task: str) -> Any:
        from Basilisk.simulation import sphericalPendulum

        swing = sphericalPendulum.SphericalPendulum()
        swing.pendulumRadius, swing.massInit, swing.d = length, mass, pivot.reshape(3, 1).tolist()
        swing.D = (damping * np.eye(3)).tolist()
        swing.phiDotInit, swing.thetaDotInit = phi_rate, theta_rate
        swing.pHat_01, swing.pHat_02, swing.pHat_03 = ([[float(x)] for x in row] for row in np.eye(3))
        craft.addStateEffector(swing)
        return swing

    return body, body.pack((1.0, 0.0, 0.0, 0.0), VELOCITY, rates=[(0.0, theta_rate, phi_rate)]), add


def panels() -> tuple[RigidBody, Any, Callable[..., Any]]:
    """Two sprung solar panels."""
    mass, length, inertia = 30.0, 1.5, np.diag([25.0, 15.0, 10.0])
    stiffness, damping = 8.0, 0.5
    hinges, outs = np.array([[0.5, 0.0, 1.0], [-0.5, 0.0, 1.0]]), np.array([[1.0, 0.0, 0.0], [-1.0, 0.0, 0.0]])
    axis, starts = np.array([0.0, 1.0, 0.0]), [0.1, -0.05]
    parts, pieces = [], []
    for hinge, out in zip(hinges, outs, strict=True):
        frame = np.column_stack([out, axis, np.cross(out, axis)])
        own = frame @ inertia @ frame.T
        parts.append(HingedPart(hinge, axis, hinge + length * out, mass, own, stiffness, damping))
        pieces.append((mass, hinge + length * out, own))
    body = RigidBody.from_body(whole(pieces), parts)

    def add(sim: Any, craft: Any, task: str) -> Any:
        from Basilisk.simulation import hingedRigidBodyStateEffector

        kept = []
        for hinge, out, start in zip(hinges, outs, starts, strict=True):
            panel = hingedRigidBodyStateEffector.HingedRigidBodyStateEffector()
            panel.mass, panel.d, panel.k, panel.c = mass, length, stiffness, damping
            panel.IPntS_S, panel.r_HB_B = inertia.tolist(), hinge.reshape(3, 1).tolist()
            # Basilisk's panel lies along −ŝ1 from its hinge and turns about ŝ2
            panel.dcm_HB = np.array([-out, axis, np.cross(-out, axis)]).tolist()
            panel.thetaInit, panel.thetaDotInit = start, 0.0
            craft.addStateEffector(panel)
            sim.AddModelToTask(task, panel)
            kept.append(panel)
        return kept

    return body, body.pack((1.0, 0.0, 0.0, 0.0), VELOCITY, coordinates=starts), add


def main() -> None:
    """Print the table."""
    times = np.linspace(0.0, UNTIL, SAMPLES)
    print("| case | largest angle, rad | CPU s of polhode | CPU s of Basilisk |\n|---|---|---|---|")
    for case in (wheels, gravity, pulses, slosh, pendulum, panels):
        body, start, add = case()
        begun = time.process_time()
        found = ph.simulate(body, start, times)
        between = time.process_time()
        modified = basilisk(add)
        print(f"| {case.__name__} | {apart(found, modified):.1e} | {between - begun:.1f} | "
              f"{time.process_time() - between:.1f} |", flush=True)  # fmt: skip


if __name__ == "__main__":
    main()
