"""Bodies with moving parts, each twice: of the package, and as a hub with parts by Newton's and Euler's laws.

Run as a script from the folder ``tests``, it writes where they are after two seconds, in 25 digits, to
``hub_cases.json``: ``python -m spacecraft.hub_cases``. That takes some minutes.
"""

import json
from pathlib import Path
from typing import Any, NamedTuple

import jax
import jax.numpy as jnp
import mpmath as mp
import numpy as np

import polhode as ph
from polhode import rotation
from polhode.spacecraft import (
    AbstractTorque,
    ControlMomentGyroscope,
    GravityGradient,
    HingedPart,
    Propellant,
    RigidBody,
    SphericalPendulum,
    SprungMass,
    Wheel,
)
from polhode.systems import KeplerOrbit
from spacecraft import hub_and_parts as laws

STORED = Path(__file__).with_name("hub_cases.json")
END = 2.0
TURN = rotation.as_matrix(rotation.normalize(np.array([0.7, 0.3, -0.5, 0.4])))
CENTER, INERTIA = np.array([0.03, -0.02, 0.05]), TURN @ np.diag([5.0, 8.0, 10.6]) @ TURN.T
INERTIA = 0.5 * (INERTIA + INERTIA.T)
BODY = ph.Body(40.0, CENTER, INERTIA)
ATTITUDE, VELOCITY = rotation.normalize(np.array([0.9, 0.1, -0.2, 0.3])), np.array([0.3, -0.9, 0.6])
MEAN_MOTION = 0.4
FORCE, PLACE = np.array([0.2, -0.3, 0.1]), np.array([1.0, 0.2, 0.3])


class Push(AbstractTorque):
    """A force F cos t at a place of the hub."""

    def force(self, t, attitude, angular_velocity, actuator=None):
        return FORCE * jnp.cos(t)[..., None] + 0.0 * angular_velocity

    def torque(self, t, attitude, angular_velocity, actuator=None):
        return jnp.cross(jnp.asarray(PLACE), self.force(t, attitude, angular_velocity))


class Both(NamedTuple):
    """A part twice, with its start.

    Attributes:
        ours: of the package.
        theirs: by Newton's and Euler's laws.
        rest: the oracle's state at rest.
        start: the oracle's state at the start.
        rates, coordinates: what ``pack`` takes.
    """

    ours: Any
    theirs: Any
    rest: list
    start: list
    rates: Any
    coordinates: Any


def slosh():
    given = (0.1, 0.4, 0.3), [[1, 0, 0], [0, 0.6, 0.8]], 3.0, [4.0, 6.0], 0.1
    start = [0.05, 0.02, 0.1, -0.2]
    return Both(SprungMass(*given), laws.SprungMass(*given), [0, 0, 0, 0], start, (0.1, -0.2), (0.05, 0.02))


def panel():
    inertia = np.array([[0.2, 0.01, 0.0], [0.01, 0.3, 0.02], [0.0, 0.02, 0.4]])
    given = (0.5, 0, 0), (0.6, 0.8, 0), (1.0, 0.1, 0.2), 1.5, inertia, 1.0, 0.02
    return Both(HingedPart(*given), laws.HingedPart(*given), [0, 0], [0.2, 0.3], 0.3, 0.2)


def pendulum():
    given = (0, 0.1, -0.3), (0.0, 0.1, -0.4), 2.0, 0.5, 0.05
    ours, theirs = SphericalPendulum(*given), laws.SphericalPendulum(*given)
    rest = np.array([0.0, 0.1, -0.4]) / np.hypot(0.1, 0.4)
    across = np.array([[1.0, 0.0, 0.0], np.cross(rest, [1.0, 0.0, 0.0])])

    def direction(x):  # from the plane onto the sphere
        quarter = 0.25 * x @ x
        return ((1.0 - quarter) * rest + x @ across) / (1.0 + quarter)

    place, speed = jax.jvp(direction, (jnp.array([0.3, -0.2]),), (jnp.array([0.3, 0.1]),))
    toward = 1.3 * np.asarray(place)  # of any length
    turning = np.cross(place, speed) + 0.7 * np.asarray(place)  # about itself it does not turn
    return Both(ours, theirs, [*theirs.rest, 0, 0, 0], [*np.asarray(place), *np.asarray(speed)], turning, toward - rest)


GIMBAL, SPIN = np.array([0.0, 0.0, 1.0]), np.array([0.6, 0.8, 0.0])


def gyroscope():
    third, side = np.cross(GIMBAL, SPIN), 0.06
    ours = ControlMomentGyroscope(
        GIMBAL, Wheel(SPIN, 0.1, lambda t, attitude, velocity, rate: 0.02 - 0.001 * rate), (0.25, 0.17, 0.2),
        gimbal_torque=lambda t, attitude, velocity, angle, rate: 0.3 * jnp.sin(2.0 * t) - 0.1 * rate,
    )  # fmt: skip
    moments = ((0.25 - 0.1, SPIN), (0.17 - side, third), (0.2 - side, GIMBAL))
    frame = sum(moment * np.outer(axis, axis) for moment, axis in moments)
    theirs = laws.Gyroscope(
        (0.2, 0.1, 0.0), GIMBAL, SPIN, frame, 0.1, side, 0.0,
        lambda t, own: mp.mpf(0.3) * mp.sin(2 * t) - mp.mpf(0.1) * own[1],
        lambda t, own: mp.mpf(0.02) - mp.mpf(0.001) * own[2],
    )  # fmt: skip
    return Both(ours, theirs, [0, 0, 0], [0.4, 0.5, 30.0], (0.5, 30.0), 0.4)


CASES = {"slosh": (slosh,), "panel": (panel,), "pendulum": (pendulum,), "gyroscope": (gyroscope,),
         "all": (slosh, panel, pendulum), "burn": (slosh, panel)}  # fmt: skip
TANK, NOZZLE, EXHAUST = np.array([0.2, -0.1, 0.3]), np.array([0.1, 0.05, -0.8]), np.array([3.0, -2.0, -9.0])
FLOW, FULL, CONTENTS = 0.8, 5.0, np.diag([0.3, 0.2, 0.25])
STEPS = {"gyroscope": 24}


def torques():
    return [GravityGradient(KeplerOrbit(MEAN_MOTION, 0.0)), Push()]


def make(name, kind=RigidBody):
    """Return the body with its start, and the hub with its own."""
    parts = [part() for part in CASES[name]]
    mounts, rates, places = ([getattr(x, key) for x in parts] for key in ("ours", "rates", "coordinates"))
    burn = None
    if name == "burn":
        mounts.append(Propellant(TANK, FULL, NOZZLE, FLOW, EXHAUST, inertia=CONTENTS))
        rates, places = [*rates, None], [*places, None]
        burn = FLOW, TANK, NOZZLE, EXHAUST, CONTENTS / FULL
    body = kind.from_body(BODY, mounts, torques())
    state = body.pack(ATTITUDE, VELOCITY, rates=rates, coordinates=places)

    def push(t):
        return [x * mp.cos(t) for x in laws.numbers(FORCE)], laws.numbers(PLACE)

    hub = laws.Hub(40.0, CENTER, INERTIA, [x.theirs for x in parts], [laws.numbers(x.rest) for x in parts], push,
                   MEAN_MOTION, burn)  # fmt: skip
    return body, state, hub, laws.numbers([*ATTITUDE, *VELOCITY, *(y for x in parts for y in x.start)])


def main():
    with mp.workdps(laws.DIGITS):
        found = {}
        for name in CASES:
            _, _, hub, start = make(name)
            end = laws.integrate(hub.rates, start, 0, END, STEPS.get(name, 10))
            found[name] = [mp.nstr(x, 25) for x in end]
            print(name, flush=True)
    STORED.write_text(json.dumps(found, indent=1) + "\n")


if __name__ == "__main__":
    main()
