"""Numbers with seven digits are refused wherever they come in, whoever made them, with a word on what to do."""

import jax
import jax.numpy as jnp
import numpy as np
import pytest
from jaxtyping import config

import polhode as ph
from limited import run_limited
from polhode import algebra, poisson, rolling, spacecraft, systems
from polhode.errors import InvalidInput
from polhode.spacecraft.torques import LinearDrag
from polhode.special.carlson import carlson_rf
from polhode.special.theta import theta3
from polhode.systems.kepler_orbit import KeplerOrbit

LONG_ENOUGH = 120.0
"""Seconds; some four are needed."""
THREE, FOUR, SIX, MATRIX = (1.0, 2.0, 2.5), (1.0, 0.0, 0.0, 0.0), (1.0, 2.0, 3.0, 2.0, 3.0, 5.0), np.eye(3)
BODY = systems.FreeRigidBody(THREE)
BALL = ph.shapes.sphere(1.0, 1.0)
SO3 = algebra.SO3()


def half(point):
    return 0.5 * jnp.sum(point**2)


ENTRIES = {
    "FreeMotion moments": (THREE, lambda x: ph.FreeMotion(x, momentum=THREE)),
    "FreeMotion momentum": (THREE, lambda x: ph.FreeMotion(THREE, momentum=x)),
    "FreeMotion attitude": (FOUR, lambda x: ph.FreeMotion(THREE, momentum=THREE, attitude=x)),
    "FreeMotion epoch": (0.0, lambda x: ph.FreeMotion(THREE, momentum=THREE, attitude=FOUR, epoch=x)),
    "FreeMotion time": (1.0, lambda x: ph.FreeMotion(THREE, momentum=THREE).state(x)),
    "FreeMotion times": (THREE, lambda x: ph.FreeMotion(THREE, momentum=THREE).sample(x)),
    "FreeMotion.from_body": (THREE, lambda x: ph.FreeMotion.from_body(BALL, angular_velocity=x)),
    "LagrangeMotion moments": ((1.0, 1.0, 0.5), lambda x: ph.LagrangeMotion(x, mgl=1.0, momentum=THREE)),
    "LagrangeMotion mgl": (1.0, lambda x: ph.LagrangeMotion((1.0, 1.0, 0.5), mgl=x, momentum=THREE)),
    "LagrangeMotion time": (1.0, lambda x: ph.LagrangeMotion((1.0, 1.0, 0.5), mgl=1.0, momentum=THREE).state(x)),
    "LagrangeMotion.from_body": (
        THREE,
        lambda x: ph.LagrangeMotion.from_body(BALL, pivot=(0.0, 0.0, -2.0), angular_velocity=x),
    ),
    "LagrangeMotion.from_body pivot": (
        (0.0, 0.0, -2.0),
        lambda x: ph.LagrangeMotion.from_body(BALL, pivot=x, angular_velocity=THREE),
    ),
    "LagrangeMotion.from_body gravity": (
        9.8,
        lambda x: ph.LagrangeMotion.from_body(BALL, pivot=THREE, angular_velocity=THREE, gravity=x),
    ),
    "list of numbers": ([np.float32(1.0), 2.0, 3.0], lambda x: ph.FreeMotion(x, momentum=THREE)),
    "Body": (MATRIX, lambda x: ph.Body(1.0, (0.0, 0.0, 0.0), x)),
    "rotation": (FOUR, ph.rotation.as_matrix),
    "rotation vector": (THREE, ph.rotation.from_rotation_vector),
    "axis": (THREE, lambda x: ph.rotation.from_axis_angle(x, 1.0)),
    "angle": (1.0, lambda x: ph.rotation.from_axis_angle(THREE, x)),
    "elliptic integral": (0.3, lambda x: carlson_rf(x, 1.0, 2.0)),
    "theta function": (0.1, lambda x: theta3(0.3, x)),
    "FreeRigidBody": (THREE, systems.FreeRigidBody),
    "HeavyTop": (THREE, lambda x: systems.HeavyTop(x, 1.0)),
    "HeavyTop axis": (THREE, lambda x: systems.HeavyTop(THREE, 1.0, x)),
    "HeavyTop mgl": (1.0, lambda x: systems.HeavyTop(THREE, x)),
    "HeavyTop.pack": (THREE, lambda x: systems.HeavyTop(THREE, 1.0).pack(angular_velocity=x)),
    "Gyrostat rotor": (THREE, lambda x: systems.Gyrostat(THREE, x)),
    "Kirchhoff": (SIX, systems.Kirchhoff),
    "Manakov": (THREE, systems.Manakov),
    "RigidBody": (THREE, spacecraft.RigidBody),
    "RigidBody.pack": (THREE, lambda x: spacecraft.RigidBody(THREE).pack(angular_velocity=x)),
    "Wheel axis": (THREE, lambda x: spacecraft.Wheel(x, 0.1)),
    "Wheel motor": (0.3, lambda x: spacecraft.Wheel(THREE, 0.1, x)),
    "HeldWheel rate": (0.3, lambda x: spacecraft.HeldWheel(THREE, 0.1, x)),
    "SphericalSlug": (0.3, lambda x: spacecraft.SphericalSlug(x, 0.1)),
    "LaggedTorque": (0.3, lambda x: spacecraft.LaggedTorque(half, x)),
    "DoubleBracket rate": (0.3, lambda x: systems.DoubleBracket(THREE, x)),
    "BrunBody strength": (0.3, lambda x: systems.BrunBody(THREE, x)),
    "EulerDisk": (1.0, lambda x: rolling.EulerDisk(x, 0.1)),
    "EulerDisk thickness": (0.01, lambda x: rolling.EulerDisk(1.0, 0.1, x)),
    "LinearDrag": (0.3, LinearDrag),
    "KeplerOrbit": (0.3, lambda x: KeplerOrbit(1.0, x)),
    "point": (THREE, poisson.bracket(SO3, half, lambda L: L[0])),
    "field": (THREE, poisson.hamiltonian_field(SO3, half)),
    "kks_form": (THREE, lambda x: poisson.kks_form(SO3, THREE, x, jnp.ones(3))),
    "orbit_dimension": (THREE, lambda x: poisson.orbit_dimension(SO3, x)),
    "covector": (MATRIX, lambda x: poisson.left_trivialize(FOUR, x)),
    "reconstruct_group": (THREE, lambda x: poisson.reconstruct_group(SO3, x, np.ones((3, 3)), lambda L: L)),
    "reconstruct": (THREE, lambda x: poisson.reconstruct(x, np.ones((3, 3)), lambda L: L)),
    "vector_field": (THREE, lambda x: BODY.vector_field(0.0, x)),
    "invariants": (THREE, BODY.invariants),
    "LiePoisson energy": (THREE, systems.LiePoisson(SO3, half).energy),
    "structure constants": (np.zeros((2, 2, 2)), algebra.from_structure_constants),
    "basis of matrices": (algebra.SU(2).basis, algebra.from_matrices),
    "simulate state": (THREE, lambda x: ph.simulate(BODY, x, (0.0, 1.0))),
    "simulate times": ((0.0, 1.0), lambda x: ph.simulate(BODY, THREE, x)),
    "solve state": (THREE, lambda x: ph.solve(BODY, x, (0.0, 1.0))),
    "solve times": ((0.0, 1.0), lambda x: ph.solve(BODY, THREE, x)),
    "solve step": (0.1, lambda x: ph.solve(BODY, THREE, (0.0, 1.0), step=x)),
    "stability": ((0.0, 1.0, 0.0), lambda x: ph.stability(BODY, x)),
    "section state": (THREE, lambda x: ph.section(BODY, x, lambda t, point: point[1], (0.0, 1.0))),
    "section times": ((0.0, 1.0), lambda x: ph.section(BODY, THREE, lambda t, point: point[1], x)),
    "continue_equilibria": (
        (0.0, 1.0, 0.0),
        lambda x: ph.analysis.continue_equilibria(
            lambda a: systems.FreeRigidBody((1.0, 2.0, 3.0 + a)), (0.0, 1.0), x, starts=4
        ),
    ),
    "certify state": (THREE, lambda x: ph.certify(BODY, x, (0.0, 0.1))),
    "certify times": ((0.0, 0.1), lambda x: ph.certify(BODY, THREE, x)),
    "lyapunov state": (THREE, lambda x: ph.analysis.lyapunov(BODY, x, (0.0, 1.0))),
    "lyapunov times": ((0.0, 1.0), lambda x: ph.analysis.lyapunov(BODY, THREE, x)),
    "monodromy state": (THREE, lambda x: ph.analysis.monodromy(BODY, x, (0.0, 1.0))),
    "monodromy times": ((0.0, 1.0), lambda x: ph.analysis.monodromy(BODY, THREE, x)),
    "periodic_motion": (THREE, lambda x: ph.analysis.periodic_motion(BODY, x, 9.0)),
    "continue_periodic state": (
        THREE,
        lambda x: ph.analysis.continue_periodic(lambda a: systems.FreeRigidBody((1.0, 2.0, a)), (3.0, 3.001), x, 9.0),
    ),
    "continue_periodic limits": (
        (3.0, 3.001),
        lambda x: ph.analysis.continue_periodic(lambda a: systems.FreeRigidBody((1.0, 2.0, a)), x, THREE, 9.0),
    ),
    "find_equilibria": ((0.0, 1.0, 0.0), lambda x: ph.find_equilibria(BODY, x)),
}


@pytest.fixture(autouse=True)
def any_type_of_number():
    """What a user's call without a type checker does."""
    config.update("jaxtyping_disable", True)
    yield
    config.update("jaxtyping_disable", False)


def single(value, make):
    if isinstance(value, list):
        return value
    return make(value, dtype="complex64" if np.iscomplexobj(value) else "float32")


@pytest.mark.parametrize("make", [np.asarray, jnp.asarray], ids=["NumPy", "JAX"])
@pytest.mark.parametrize("entry", ENTRIES)
def test_single_precision_is_refused(entry, make):
    value, call = ENTRIES[entry]
    with pytest.raises(InvalidInput, match=r"must be float64; got (float32|complex64)\. C"):
        call(single(value, make))


@pytest.mark.parametrize("dtype", ["float16", "bfloat16", "complex64"])
def test_other_types_of_few_digits(dtype):
    with pytest.raises(InvalidInput, match=dtype):
        ph.FreeMotion(jnp.asarray(THREE, dtype=dtype), momentum=THREE)


def test_traced_numbers_are_refused_as_their_type_is_known():
    with pytest.raises(InvalidInput, match="float32"):
        jax.jit(lambda x: ph.FreeMotion(x, momentum=jnp.asarray(THREE)).momentum(1.0))(
            jnp.asarray(THREE, dtype="float32")
        )


@pytest.mark.sweep
def test_whole_numbers_and_plain_ones_are_good():
    wanted = ph.FreeMotion((1.0, 2.0, 3.0), momentum=(1.0, 1.0, 2.0)).energy
    assert ph.FreeMotion(jnp.array([1, 2, 3]), momentum=np.array([1, 1, 2], dtype=np.int32)).energy == wanted


BEFORE_64_BITS = """
import polhode as ph
import jax
import jax.numpy as jnp
import numpy as np

I, whole = jnp.array([1.0, 2.0, 3.3]), jnp.array([1, 2, 3])
assert I.dtype == "float32"

def refused(call):
    try:
        call()
    except ph.InvalidInput as error:
        assert "jax_enable_x64" in str(error) and "array of numbers" not in str(error), error
        return
    raise AssertionError("not refused")

for x in (I, whole):
    refused(lambda: ph.FreeMotion(x, momentum=(0.3, 1.8, 1.5)))
    refused(lambda: ph.FreeMotion((1.0, 2.0, 3.3), momentum=x))
    refused(lambda: ph.rotation.from_rotation_vector(x))
    refused(lambda: jax.jit(ph.rotation.from_rotation_vector)(x))
refused(lambda: ph.FreeMotion((1.0, 2.0, 3.3), momentum=(0.3, 1.8, 1.5)).state(I[0]))
refused(lambda: jax.jit(lambda t: ph.FreeMotion((1.0, 2.0, 3.3), momentum=(0.3, 1.8, 1.5)).momentum(t))(2.0))
ph.algebra
assert jnp.array([1.0]).dtype == "float64"
refused(lambda: ph.systems.FreeRigidBody(I))
refused(lambda: ph.FreeMotion(I, momentum=(0.3, 1.8, 1.5)))
H = lambda L: 0.5 * jnp.sum(L**2 / I)
refused(lambda: ph.systems.LiePoisson(ph.algebra.SO3(), H))
refused(lambda: ph.systems.BodyInPotential((1.0, 2.0, 3.3), H))
refused(lambda: ph.stability(ph.systems.FreeRigidBody((1.0, 2.0, 3.3)), (0.0, 0.0, 1.0), integrals=[H]))
ph.FreeMotion(whole, momentum=(0.3, 1.8, 1.5))
"""


@pytest.mark.sweep
def test_what_was_made_before_64_bits_were_switched_on():
    run_limited(BEFORE_64_BITS, LONG_ENOUGH)
