"""A body with a magnetic moment and with torque rods beside Basilisk in one process, over 6000 s.

``python benchmarks/basilisk_magnetic.py`` needs Basilisk, the package ``bsk``, built with MuJoCo as that of PyPI is. It
prints for each case the largest angle between the two attitudes [rad], and the CPU seconds of both.

Basilisk's ``Spacecraft`` takes the field and the rods' commands from messages that are written once in a step, and
holds them for the step. So what it finds differs from the continuous law in proportion to the step. Its ``MJScene``
calls the models of its dynamics task in every stage of the integrator, and so finds the continuous law. Both are
compared here; the law b-dot and the rates of the field are ours on both sides, by different formulas.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from typing import Any

import numpy as np
from basilisk import EARTH, SAMPLES, UNTIL, apart, basilisk

import polhode as ph
from polhode.spacecraft import EarthDipoleField, MagneticDipole, RigidBody, TorqueRods
from polhode.spacecraft.torques.earth_field import EARTH_ROTATION, IGRF_2020, REFERENCE_RADIUS
from polhode.systems import KeplerOrbit

MASS = 50.0  # kg; the centre of mass is the origin, where Basilisk takes the field
INERTIA = np.diag([4.0, 3.0, 2.5])
VELOCITY = np.array([0.02, -0.03, 0.04])
MOMENT = np.array([0.8, -0.5, 0.6])  # A m²
GAIN = 1e6  # A m² s/T, with which the rotation falls to 1/e in some 3000 s
ORBIT = KeplerOrbit.from_semi_major_axis(7.0e6, EARTH, 0.02, 0.3, inclination=1.1, node=0.4, periapsis=0.7)
FIELD = EarthDipoleField(ORBIT, greenwich=0.5)
STAGED_STEPS = (4.0, 2.0)  # s, of MJScene
HELD_STEPS = (0.2, 0.1, 0.05)  # s, of Spacecraft; each half of the one before
COMPLEX_STEP = 1e-30  # s
LOOSE = 1e9  # tolerance with which RKF78 keeps to the step of the task
Moment = Callable[..., np.ndarray]


def turned(t: float) -> np.ndarray:
    """Return the matrix (3, 3) from space to the Earth's axes at a time [s]."""
    angle = float(FIELD.greenwich) + EARTH_ROTATION * t
    c, s = np.cos(angle), np.sin(angle)
    return np.array([[c, s, 0.0], [-s, c, 0.0], [0.0, 0.0, 1.0]])


def field_rate(t: float, place: np.ndarray, velocity: np.ndarray) -> np.ndarray:
    """Return dB/dt (3,) [T/s, space axes] at a moving point, by a complex step along its way and the Earth's turn."""
    dipole = turned(t).T @ np.array(IGRF_2020)
    turning = np.cross([0.0, 0.0, EARTH_ROTATION], dipole)
    r, g = place + 1j * COMPLEX_STEP * velocity, dipole + 1j * COMPLEX_STEP * turning
    square = r @ r
    return (REFERENCE_RADIUS**3 / square**1.5 * (3.0 * (g @ r) * r / square - g)).imag / COMPLEX_STEP


def constant(t: float, place: Any, attitude: Any, field: np.ndarray, to_body: np.ndarray) -> np.ndarray:
    """Return the moment that is fixed in the body (3,) [A m²]."""
    return MOMENT


def b_dot(t: float, place: Any, attitude: Any, field: np.ndarray, to_body: np.ndarray) -> np.ndarray:
    """Return −k Ḃ (3,) [A m²].

    Args:
        t: time [s].
        place, attitude: states of Basilisk, with the way in the orbit and with the rotation.
        field: that of Basilisk (3,) [T, body axes].
        to_body: matrix (3, 3) from space to the body.
    """
    change = to_body @ field_rate(t, np.array(place.r_BN_N), np.array(place.v_BN_N))
    return -GAIN * (change - np.cross(attitude.omega_BN_B, field))


def earth_and_field(state_message: Any) -> tuple[Any, Any]:
    """Return models of Basilisk: one that writes how the Earth lies, and its dipole along the way of a spacecraft."""
    from Basilisk.architecture import messaging, sysModel
    from Basilisk.simulation import magneticFieldCenteredDipole

    class Earth(sysModel.SysModel):
        def __init__(self) -> None:
            super().__init__()
            self.message = messaging.SpicePlanetStateMsg()

        def UpdateState(self, nanoseconds: int) -> None:
            content = messaging.SpicePlanetStateMsgPayload()
            content.J20002Pfix = turned(1e-9 * nanoseconds).tolist()
            self.message.write(content, nanoseconds, self.moduleID)

    earth = Earth()
    earth.ModelTag = "earth"
    earth.UpdateState(0)
    dipole = magneticFieldCenteredDipole.MagneticFieldCenteredDipole()
    dipole.ModelTag = "dipole"
    dipole.g11, dipole.h11, dipole.g10 = IGRF_2020
    dipole.planetRadius = REFERENCE_RADIUS
    dipole.addSpacecraftToModel(state_message)
    dipole.planetPosInMsg.subscribeTo(earth.message)
    return earth, dipole


def rods(
    moment: Moment, place_message: Any, attitude_message: Any, field_message: Any, torque: bool
) -> tuple[Any, Any]:  # fmt: skip
    """Return a model of Basilisk that writes the moment (3,) [A m²] or its torque (3,) [N m], and its message."""
    from Basilisk.architecture import messaging, sysModel
    from Basilisk.utilities import RigidBodyKinematics

    message = messaging.TorqueAtSiteMsg() if torque else messaging.MTBCmdMsg()
    read_place, read_attitude = messaging.SCStatesMsgReader(), messaging.SCStatesMsgReader()
    read_field = messaging.MagneticFieldMsgReader()
    read_place.subscribeTo(place_message)
    read_attitude.subscribeTo(attitude_message)
    read_field.subscribeTo(field_message)

    class Rods(sysModel.SysModel):
        def UpdateState(self, nanoseconds: int) -> None:
            attitude = read_attitude()
            to_body = RigidBodyKinematics.MRP2C(np.array(attitude.sigma_BN))
            field = to_body @ np.array(read_field().magField_N)
            found = moment(1e-9 * nanoseconds, read_place(), attitude, field, to_body)
            if torque:
                content = messaging.TorqueAtSiteMsgPayload()
                content.torque_S = np.cross(found, field).tolist()
            else:
                content = messaging.MTBCmdMsgPayload()
                content.mtbDipoleCmds = found.tolist()
            message.write(content, nanoseconds, self.moduleID)

    model = Rods()
    model.ModelTag = "rods"
    return model, message


def held(moment: Moment, step: float) -> np.ndarray:
    """Return the attitudes as MRPs of a Spacecraft with an MtbEffector, which hold B and m for each step [s]."""

    def add(sim: Any, craft: Any, task: str) -> Any:
        from Basilisk.architecture import messaging
        from Basilisk.simulation import MtbEffector
        from Basilisk.utilities import simIncludeGravBody

        column = lambda x: np.asarray(x).reshape(3, 1).tolist()  # noqa: E731
        craft.hub.mHub, craft.hub.r_BcB_B = MASS, column(np.zeros(3))
        craft.hub.IHubPntBc_B, craft.hub.omega_BN_BInit = INERTIA.tolist(), column(VELOCITY)
        craft.hub.r_CN_NInit, craft.hub.v_CN_NInit = column(ORBIT.position(0.0)), column(ORBIT.velocity(0.0))
        factory = simIncludeGravBody.gravBodyFactory()
        factory.createCustomGravObject("earth", EARTH).isCentralBody = True
        factory.addBodiesTo(craft)
        earth, dipole = earth_and_field(craft.scStateOutMsg)
        law, command = rods(moment, craft.scStateOutMsg, craft.scStateOutMsg, dipole.envOutMsgs[0], torque=False)
        layout = messaging.MTBArrayConfigMsgPayload()
        layout.numMTB, layout.GtMatrix_B, layout.maxMtbDipoles = 3, np.eye(3).ravel().tolist(), [1e9] * 3
        layout_message = messaging.MTBArrayConfigMsg().write(layout)
        effector = MtbEffector.MtbEffector()
        effector.mtbParamsInMsg.subscribeTo(layout_message)
        effector.mtbCmdInMsg.subscribeTo(command)
        effector.magInMsg.subscribeTo(dipole.envOutMsgs[0])
        craft.addDynamicEffector(effector)
        for model in (earth, dipole, law, effector):
            sim.AddModelToTask(task, model)
        return factory, earth, dipole, law, command, layout_message, effector

    return basilisk(add, step)


def orbit_model() -> Any:
    """Return a model of Basilisk that has the place [m] and velocity [m/s] in the orbit as states, and writes them."""
    from Basilisk.architecture import messaging
    from Basilisk.simulation import StatefulSysModel

    class Orbit(StatefulSysModel.StatefulSysModel):
        def registerStates(self, registerer: Any) -> None:
            self.place, self.velocity = (registerer.registerState(3, 1, name) for name in ("place", "velocity"))

        def UpdateState(self, nanoseconds: int) -> None:
            place, velocity = (np.array(state.getState()).ravel() for state in (self.place, self.velocity))
            self.place.setDerivative(velocity.reshape(3, 1))
            self.velocity.setDerivative((-EARTH / (place @ place) ** 1.5 * place).reshape(3, 1))
            content = messaging.SCStatesMsgPayload()
            content.r_BN_N, content.v_BN_N = place.tolist(), velocity.tolist()
            self.message.write(content, nanoseconds, self.moduleID)

    orbit = Orbit()
    orbit.ModelTag, orbit.message = "orbit", messaging.SCStatesMsg()
    orbit.message.write(messaging.SCStatesMsgPayload())
    return orbit


def staged(moment: Moment, step: float) -> np.ndarray:
    """Return the attitudes as MRPs of an MJScene, whose field and rods are evaluated in each stage of RKF78.

    The body stays at the origin of the scene, and its way is the state of a model of its own: MuJoCo would take the
    torque of the weight about the centre of mass from places 7000 km away, with a rounding of 1e-9 m.
    """
    from Basilisk.simulation import mujoco, svIntegrators
    from Basilisk.utilities import SimulationBaseClass, macros

    sim = SimulationBaseClass.SimBaseClass()
    sim.CreateNewProcess("process").addTask(sim.CreateNewTask("task", macros.sec2nano(step)))
    moments = " ".join(repr(float(x)) for x in np.diag(INERTIA))
    scene = mujoco.MJScene(
        f'<mujoco><option gravity="0 0 0"/><worldbody><body name="hub"><freejoint/>'
        f'<inertial pos="0 0 0" mass="{MASS}" diaginertia="{moments}"/></body></worldbody></mujoco>'
    )
    scene.extraEoMCall = scene.highOrderAttitudeIntegration = True
    integrator = svIntegrators.svIntegratorRKF78(scene)
    integrator.relTol = integrator.absTol = LOOSE
    scene.setIntegrator(integrator)
    sim.AddModelToTask("task", scene)
    hub = scene.getBody("hub")
    site, orbit = hub.getOrigin(), orbit_model()
    earth, dipole = earth_and_field(orbit.message)
    law, message = rods(moment, orbit.message, site.stateOutMsg, dipole.envOutMsgs[0], torque=True)
    scene.addTorqueActuator("rods", site).torqueInMsg.subscribeTo(message)
    for place, model in enumerate((orbit, earth, dipole, law)):
        scene.AddModelToDynamicsTask(model, 10 - place)  # the higher number runs first
    recorder = site.stateOutMsg.recorder(macros.sec2nano(UNTIL / (SAMPLES - 1)))
    sim.AddModelToTask("task", recorder)
    sim.InitializeSimulation()
    for state in ("mujocoQpos", "mujocoQvel"):  # a scene with a free body sets these to zero
        integrator.setRelativeTolerance(state, LOOSE)
    orbit.place.setState(np.asarray(ORBIT.position(0.0)).reshape(3, 1))
    orbit.velocity.setState(np.asarray(ORBIT.velocity(0.0)).reshape(3, 1))
    hub.setAttitudeRate(VELOCITY.tolist())
    sim.ConfigureStopTime(macros.sec2nano(UNTIL))
    sim.ExecuteSimulation()
    return np.array(recorder.sigma_BN)


def extrapolated(runs: list[np.ndarray]) -> np.ndarray:
    """Return the MRPs at step zero from those at a step, its half and its quarter: without its first two powers."""
    quaternions = []
    for modified in runs:
        square = np.sum(modified**2, axis=-1, keepdims=True)
        found = np.concatenate([1.0 - square, 2.0 * modified], axis=-1) / (1.0 + square)
        near = found if not quaternions else found * np.sign(np.sum(found * quaternions[0], axis=-1, keepdims=True))
        quaternions.append(near)
    coarse, middle, fine = quaternions
    limit = (coarse - 6.0 * middle + 8.0 * fine) / 3.0
    limit *= np.where(limit[:, :1] < 0.0, -1.0, 1.0) / np.linalg.norm(limit, axis=-1, keepdims=True)
    return limit[:, 1:] / (1.0 + limit[:, :1])


def main() -> None:
    """Print the table."""
    times = np.linspace(0.0, UNTIL, SAMPLES)
    print("| case | Basilisk | largest angle, rad | CPU s of polhode | CPU s of Basilisk |\n|---|---|---|---|---|")
    for moment, torque in ((constant, MagneticDipole(FIELD, MOMENT)), (b_dot, TorqueRods(FIELD, GAIN))):
        body = RigidBody.from_body(ph.Body(MASS, np.zeros(3), INERTIA), torques=[torque])
        start = body.pack((1.0, 0.0, 0.0, 0.0), VELOCITY)
        begun = time.process_time()
        found = ph.simulate(body, start, times)
        ours = time.process_time() - begun

        def show(name: str, modified: np.ndarray, begun: float, case: str = moment.__name__) -> None:
            spent = time.process_time() - begun
            print(f"| {case} | {name} | {apart(found, modified):.1e} | {ours:.1f} | {spent:.1f} |", flush=True)  # noqa: B023

        for step in STAGED_STEPS:
            begun = time.process_time()
            show(f"in each stage, steps of {step:g} s", staged(moment, step), begun)
        runs, all_begun = [], time.process_time()
        for step in HELD_STEPS:
            begun = time.process_time()
            runs.append(held(moment, step))
            show(f"held for {step:g} s", runs[-1], begun)
        show("held, extrapolated from the three", extrapolated(runs), all_begun)


if __name__ == "__main__":
    main()
