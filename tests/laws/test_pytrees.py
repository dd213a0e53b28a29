"""Every class that JAX takes apart: what one argument of its constructor changes is one leaf, or what is static.

Then an object with another leaf is the one that the constructor makes of another argument, and a derivative by the
object is the constructor's: no leaf is a copy of another that would stay as it was. A class that only keeps its
arguments cannot break this; every other needs a specimen.
"""

import dataclasses
import importlib
import inspect
import pkgutil
from typing import NamedTuple

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np
import pytest

import polhode as ph
from polhode import algebra as lie
from polhode import celestial, fields, integrators, rolling, spacecraft, systems
from polhode.algebra.constants import ConstantsAlgebra, MatrixBasisAlgebra
from polhode.exact.free_body.motion import FreeMotion
from polhode.exact.lagrange_top.motion import LagrangeMotion
from polhode.fields.spin_lattice.thermal_noise import Bath
from polhode.integrators._diffrax_loop import EventBisection
from polhode.motion.base import AbstractMotion
from specimens import BONDS, EASY, OPEN

MOVED = 1e-9  # relative to a leaf's size: rounding leaves 1e-15, and arguments are changed by a tenth
MOMENTS = (1.0, 2.0, 2.5)
ORBIT = systems.KeplerOrbit(1e-3, 0.1, 0.2, 0.3, 0.4, 0.5, 7e6)
FIELD = spacecraft.EarthDipoleField(ORBIT, 0.3)
PLATES = {"areas": (1.0, 2.0), "normals": ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0)),
          "positions": ((0.1, 0.2, 0.3), (0.3, 0.2, 0.1))}  # fmt: skip
PENDULUM = {"pivot": (0.1, 0.2, 0.3), "arm": (0.0, 0.3, 0.4), "mass": 2.0, "stiffness": 0.3, "damping": 0.1}
BODY = systems.FreeRigidBody(MOMENTS)
SPINS = fields.SpinLattice(OPEN, 1.0, BONDS, EASY, (0.1, 0.0, 0.3))
AXES = ((1.0, 0.0, 0.0), (0.0, 0.6, 0.8), (0.0, 0.0, 1.0), (0.6, 0.0, 0.8))
OTHER_AXES = ((0.8, 0.6, 0.0), (0.0, 1.0, 0.0), (0.0, 0.6, 0.8), (0.0, 0.0, 1.0))
LOWER = jnp.asarray([[0.9, 0.1, 0.0], [0.1, 1.1, 0.0], [0.0, 0.0, 1.2]])
START = {"momentum": (0.3, 1.8, 1.5), "attitude": (0.8, 0.36, -0.48, 0.0), "epoch": 0.4, "axes": np.eye(3)}
TURNED = np.asarray(ph.rotation.as_matrix([0.8, 0.36, -0.48, 0.0]))
OTHER_START = {"attitude": (0.6, 0.0, 0.8, 0.0), "axes": TURNED, "moments": (1.1, 1.1, 0.7)}


class Specimen(NamedTuple):
    """Arguments of a constructor, and other ones in place of those that cannot just be a tenth larger."""

    arguments: dict
    others: dict = {}  # noqa: RUF012


def command(t, attitude, velocity, *own):
    return -0.1 * velocity


def one(**arguments):
    return Specimen(arguments)


SPECIMENS = {
    FreeMotion: Specimen({"moments": MOMENTS} | START, OTHER_START),
    LagrangeMotion: Specimen({"moments": (1.2, 1.2, 0.5), "mgl": 0.9} | START, OTHER_START),
    lie.Power: one(algebra=lie.SO3(), count=3, weights=(1.0, -2.0, 0.5)),
    **dict.fromkeys([lie.Product, lie.SOpq, lie.Semidirect, ConstantsAlgebra, MatrixBasisAlgebra]),  # static tables
    systems.FreeRigidBody: one(moments=MOMENTS),
    systems.BodyInPotential: one(moments=MOMENTS, potential=lambda up: 0.7 * up[2]),
    systems.HeavyTop: Specimen({"moments": MOMENTS, "mgl": 0.7, "axis": (0.6, 0.0, 0.8), "axes": np.eye(3)},
                               {"axis": (0.0, 0.6, 0.8)}),
    systems.BrunBody: one(moments=MOMENTS, strength=0.7),
    systems.Gyrostat: one(moments=MOMENTS, rotor=(0.1, 0.2, 0.5), rotor_moment=0.2, free=True),
    systems.TorquedGyrostat: Specimen(
        {"moments": MOMENTS, "axis": (0.0, 0.6, 0.8), "rotor_moment": 0.2, "torque": 0.1}, {"axis": (0.6, 0.0, 0.8)}),
    systems.DoubleBracket: one(moments=MOMENTS, rate=0.3),
    systems.DoubleBracketDamping: one(system=BODY, rate=0.3, metric=np.diag([1.0, 2.0, 3.0])),
    systems.Kirchhoff: one(inertia=(1.0, 2.0, 3.0, 2.0, 3.0, 5.0)),
    fields.SphereFluid: one(n=4, rotation=0.7),
    fields.SphereMHD: one(n=3, rotation=0.7),
    systems.Manakov: one(masses=(1.0, 2.0, 3.0)),
    systems.LiePoisson: one(algebra=lie.SO3(), hamiltonian=BODY.energy),
    fields.SpinLattice: one(lattice=OPEN, bonds=BONDS, field=(0.1, 0.0, 0.3), dipolar=0.1, damping=0.1),
    fields.SphereVortices: one(strengths=(1.0, -0.7, 0.4)),
    fields.PlaneVortices: one(strengths=(1.0, -0.7, 0.4)),
    fields.VlasovPoisson: one(length=5.0, modes=3, particles=4),
    fields.Toda: one(n=4),
    rolling.EulerDisk: one(mass=0.4, radius=0.04, axial_moment=3e-4, diametral_moment=2e-4,
                           gravity=9.8, dissipation=rolling.AirLayer(1.8e-5)),
    rolling.AirLayer: one(viscosity=1.8e-5),
    rolling.BoundaryLayer: one(coefficient=1e-3),
    rolling.ViscousContourFriction: one(coefficient=1e-3),
    rolling.DryContourFriction: one(coefficient=1e-3),
    rolling.RollingCouple: one(arm=1e-3),
    rolling.DrillingFriction: one(arm=1e-3),
    systems.KeplerOrbit: one(mean_motion=1e-3, eccentricity=0.1, mean_anomaly=0.2, inclination=0.3, node=0.4,
                             periapsis=0.5, semi_major_axis=7e6),
    celestial.SpinOrbit: one(asphericity=0.8, eccentricity=0.1, mean_motion=1.0, mean_anomaly=0.3),
    spacecraft.RigidBody: one(moments=MOMENTS, mounts=[spacecraft.HeldWheel((0.0, 0.0, 1.0), 0.1, 3.0)],
                           torques=[spacecraft.GravityGradient(ORBIT)]),
    spacecraft.TorquedBody: one(moments=MOMENTS, torques=[spacecraft.LinearDrag(0.1)]),
    spacecraft.QuaternionPD: Specimen({"gain": (1.0, 2.0, 3.0), "rate_gain": (0.1, 0.2, 0.3),
                                    "attitude": (0.8, 0.0, 0.6, 0.0)}, {"attitude": (0.6, 0.8, 0.0, 0.0)}),
    spacecraft.RateControl: one(angular_velocity=(0.1, 0.2, 0.3), rate_gain=(0.1, 0.2, 0.3)),
    spacecraft.UserLaw: one(command=command, jumps=(1.0, 2.0)),
    spacecraft.ControlTorque: one(law=spacecraft.UserLaw(command), limit=(1.0, 2.0, 3.0)),
    spacecraft.ControlledWheels: Specimen(
        {"axes": AXES, "moments": (0.1, 0.2, 0.3, 0.4), "law": spacecraft.UserLaw(command), "max_torque": 0.1,
         "max_rate": 100.0, "friction": 0.01}, {"axes": OTHER_AXES}),
    spacecraft.ControlMomentGyroscope: Specimen(
        {"gimbal_axis": (1.0, 0.0, 0.0), "rotor": spacecraft.HeldWheel((0.0, 0.0, 1.0), 0.1, 3.0),
         "moments": (0.2, 0.3, 0.25), "gimbal_rate": 0.1, "bandwidth": 2.0, "friction": 0.1, "jumps": (1.0, 2.0)},
        {"gimbal_axis": (0.0, 1.0, 0.0)}),
    spacecraft.HingedPart: Specimen(
        {"hinge": (0.1, 0.2, 0.3), "axis": (0.0, 0.0, 1.0), "center": (0.5, 0.2, 0.3), "mass": 2.0, "inertia": LOWER,
         "stiffness": 0.3, "damping": 0.1, "motor": 0.2, "jumps": (1.0, 2.0)}, {"axis": (0.0, 0.6, 0.8)}),
    spacecraft.LockedPart: Specimen({"part": spacecraft.SphericalPendulum(**PENDULUM), "coordinates": (0.1, 0.2, 0.3)},
                                 {"part": spacecraft.SphericalPendulum(**PENDULUM | {"mass": 3.0})}),
    spacecraft.SphericalPendulum: Specimen(PENDULUM, {"arm": (0.1, 0.3, 0.5)}),
    spacecraft.SprungMass: Specimen(
        {"position": (0.1, 0.2, 0.3), "directions": AXES[:2], "mass": 2.0, "stiffness": (3.0, 4.0),
         "damping": (0.1, 0.2)}, {"directions": ((0.8, 0.6, 0.0), (0.0, 0.0, 1.0))}),
    spacecraft.Propellant: one(position=(0.1, 0.2, 0.3), mass=5.0, nozzle=(0.0, 0.0, -1.0), flow=0.1,
                            exhaust_velocity=(0.0, 0.0, -300.0), at=1.0, lasting=2.0, inertia=LOWER, jumps=(4.0,)),
    spacecraft.EnergySink: one(rate=0.1),
    spacecraft.SphericalSlug: one(moment=0.1, damping=0.2),
    spacecraft.Wheel: Specimen(
        {"axis": (0.0, 0.6, 0.8), "moment": 0.1, "motor": 0.2, "friction": 0.1, "jumps": (1.0, 2.0),
         "coulomb_friction": 0.1, "sliding_rate": 0.3, "max_torque": 0.5, "max_rate": 100.0},
        {"axis": (0.6, 0.0, 0.8)}),
    spacecraft.HeldWheel: Specimen({"axis": (0.0, 0.6, 0.8), "moment": 0.1, "rate": 3.0}, {"axis": (0.6, 0.0, 0.8)}),
    spacecraft.EarthDipoleField: one(orbit=ORBIT, greenwich=0.3, coefficients=(-29e-6, -1.4e-6, 4.6e-6)),
    spacecraft.MagneticDipole: one(field=FIELD, moment=(0.1, 0.2, 0.3)),
    spacecraft.EddyCurrents: one(field=FIELD, coefficient=0.1),
    spacecraft.TorqueRods: Specimen({"field": FIELD, "gain": 0.1, "limit": (1.0, 2.0, 3.0), "axes": np.eye(3)},
                                 {"axes": OTHER_AXES[:3]}),
    spacecraft.GravityGradient: one(orbit=ORBIT, moments=MOMENTS),
    spacecraft.LaggedTorque: one(command=command, time_constant=2.0, jumps=(1.0, 2.0)),
    spacecraft.LinearDrag: one(coefficient=(0.1, 0.2, 0.3)),
    spacecraft.QuadraticDrag: one(coefficient=0.1),
    spacecraft.ConstantTorque: one(torque=(0.1, 0.2, 0.3)),
    spacecraft.DumpingThrusters: one(rate=0.1, limit=(1.0, 2.0, 3.0), dead_band=0.1),
    spacecraft.Thruster: one(at=(1.0, 3.0), lasting=(0.5, 0.25), force=(1.0, 2.0, 3.0), position=(0.1, 0.2, 0.3)),
    spacecraft.AerodynamicDrag: Specimen({"orbit": ORBIT, "density": 1e-11, "coefficient": 2.2} | PLATES,
                                      {"normals": ((0.0, 0.6, 0.8), (1.0, 0.0, 0.0))}),
    spacecraft.SolarPressure: Specimen(
        {"sun": (0.0, 0.6, 0.8), "specular": 0.3, "diffuse": 0.2, "pressure": 4.5e-6, "orbit": ORBIT,
         "shading_radius": 6e6} | PLATES,
        {"shading_radius": 5e6, "sun": (0.6, 0.0, 0.8), "normals": ((0.0, 0.6, 0.8), (1.0, 0.0, 0.0))}),
    integrators.IsospectralMidpoint: one(system=systems.LiePoisson(lie.SO(3), lambda m: jnp.sum(m**2)), step_size=0.1),
    integrators.LieMidpoint: one(system=BODY, step_size=0.1),
    integrators.MuntheKaas: one(system=BODY, step_size=0.1),
    integrators.SphericalMidpoint: one(system=BODY, step_size=0.1),
    integrators.Splitting: one(system=BODY, step_size=0.1),
    fields.SublatticeTurns: None,  # takes whole numbers, which stand for sites
    EventBisection: None,  # takes none
    fields.TransportNoise: one(system=BODY, step_size=0.1, fields=((0.1, 0.2, 0.3),)),
    fields.NoiseDriftNoise: one(system=SPINS, step_size=0.1, bath=Bath(0.1, 0.2, 1)),
}  # fmt: skip

OTHER_PARAMETERS = {
    (spacecraft.HingedPart, "hinge"): "the arm, from there to the centre, is a leaf",
    (spacecraft.Thruster, "at"): "the end of each pulse is a leaf",
}
"""Arguments in place of which other numbers are leaves, as many and independent of each other."""
PINV = "the pseudoinverse of the axes, which has no derivatives where they do not span space"
LEGENDRE = "coefficients of the disk's Legendre function, made with the numbers in 30 digits"
STEP = "normal numbers are of the step that the solver is made with, which a run makes shorter between samples"
COPIES = {
    (spacecraft.ControlledWheels, "axes"): PINV,
    (spacecraft.TorqueRods, "axes"): PINV,
    **{(rolling.EulerDisk, name): LEGENDRE for name in ("mass", "radius", "axial_moment", "diametral_moment")},
    (spacecraft.RigidBody, "moments"): "torques are bound to a body, which checks them, and keep its moments",
    (fields.TransportNoise, "step_size"): STEP,
    (fields.NoiseDriftNoise, "step_size"): STEP,
}
"""Arguments of which leaves are copies all the same: such an object is made anew, not edited, as the docs say."""


def registered():
    """Return every class of the package that JAX takes apart by its fields."""
    for info in pkgutil.walk_packages(ph.__path__, "polhode."):
        if not info.name.endswith("__main__"):
            importlib.import_module(info.name)
    found, waiting = set(), [eqx.Module, AbstractMotion]
    while waiting:
        for kind in waiting.pop().__subclasses__():
            if kind not in found and not inspect.isabstract(kind):
                found.add(kind)
            waiting.append(kind)
    return sorted((k for k in found if k.__module__.startswith("polhode.")), key=lambda k: k.__qualname__)


def keeps_its_arguments(kind):
    """Whether the constructor is the one that dataclasses write, and nothing follows it."""
    own = [base for base in kind.__mro__ if base.__module__ == __name__ or base.__module__.startswith("polhode.")]
    written = any(word in inspect.getsource(base) for base in own for word in ("def __init__(", "def __post_init__("))
    return not written and all(f.init for f in dataclasses.fields(kind))


def is_numbers(value):
    if isinstance(value, bool | int | str | np.integer | Bath):
        return False
    try:
        return np.asarray(value, dtype=float).dtype == float
    except (TypeError, ValueError):
        return False


def leaves_of(thing):
    flat, structure = jax.tree_util.tree_flatten_with_path(thing)
    return {jax.tree_util.keystr(path): x for path, x in flat}, structure


def moved_by(make, arguments, others):
    """Yield each argument with the leaves that another value of it changes, and whether what is static changes too."""
    before, structure = leaves_of(make(**arguments))
    for name, value in arguments.items():
        if name not in others and not is_numbers(value):
            continue
        other = others[name] if name in others else (1.1 * np.asarray(value, dtype=float)).tolist()
        after, again = leaves_of(make(**arguments | {name: other}))
        moved = [path for path in before if path not in after or differ(before[path], after[path])]
        yield name, moved, structure != again


def differ(one, other):
    if not eqx.is_array(one) and not isinstance(one, np.ndarray):
        return one != other
    one, other = np.asarray(one), np.asarray(other)
    return one.shape != other.shape or bool((np.abs(one - other) > MOVED * np.abs(one).max(initial=0.0)).any())


def test_every_class_has_a_specimen():
    missing = [kind.__qualname__ for kind in registered() if kind not in SPECIMENS and not keeps_its_arguments(kind)]
    assert not missing


@pytest.mark.parametrize("kind", [kind for kind, specimen in SPECIMENS.items() if specimen], ids=lambda k: k.__name__)
def test_an_argument_is_one_leaf(kind):
    specimen = SPECIMENS[kind]
    as_given = jnp.asarray if issubclass(kind, AbstractMotion) else lambda x: x
    make = lambda **arguments: kind(**{name: as_given(x) for name, x in arguments.items()})  # noqa: E731
    bad = {}
    for name, moved, static in moved_by(make, specimen.arguments, specimen.others):
        if (kind, name) in COPIES or (kind, name) in OTHER_PARAMETERS:
            assert len(moved) > 1  # else the reason is gone
            continue
        if not (len(moved) == 1 and not static) and not (static and not moved):
            bad[name] = (moved, static)
    assert not bad


class Hidden(eqx.Module):
    """What the law is there to find: the inverse stays as it was where somebody edits the moments."""

    moments: jax.Array
    inverse: jax.Array

    def __init__(self, moments):
        self.moments = jnp.asarray(moments)
        self.inverse = 1.0 / self.moments


def test_the_law_finds_a_hidden_copy():
    ((name, moved, static),) = moved_by(Hidden, {"moments": (1.0, 2.0)}, {})
    assert (name, moved, static) == ("moments", [".moments", ".inverse"], False)
    assert not keeps_its_arguments(Hidden) and keeps_its_arguments(systems.Variations)
