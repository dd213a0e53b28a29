"""Making algebras from constants, matrices, and others; and what is refused."""

import os
import subprocess
import sys
import tracemalloc

import jax.numpy as jnp
import numpy as np
import pytest

from polhode import algebra as lie
from polhode import fields, systems
from polhode.errors import InvalidInput

EPSILON = lie.SO3().structure_constants()


def changed(index, value):
    constants = EPSILON.copy()
    constants[index] = value
    return constants


@pytest.mark.parametrize(
    ("constants", "words"),
    [
        (changed((0, 1, 2), -1.0), r"c\[0,1,2\] = -1 and c\[1,0,2\] = -1"),
        (np.zeros((2, 3, 3)), "shape"),
        ([["a"]], "must be numbers; got 'a'"),
        (changed((0, 1, 2), np.nan), "finite"),
        (np.ones((3, 3)), "shape"),
    ],
)
def test_constants_that_are_refused(constants, words):
    with pytest.raises(InvalidInput, match=words):
        lie.from_structure_constants(constants)


@pytest.mark.parametrize("rotations", [None, 3, np.array(0)])
def test_rotations_that_are_no_list_are_refused(rotations, any_type):
    for make in (lambda: lie.Product(lie.SO3(), lie.SO3(), rotations=rotations),
                 lambda: lie.from_structure_constants(EPSILON, rotations=rotations)):  # fmt: skip
        with pytest.raises(InvalidInput, match=r"^`rotations` must be three components one behind the other"):
            make()
    for none in ((), [], np.array([])):
        assert lie.Product(lie.SO3(), lie.SO3(), rotations=none).rotations == ()


def test_jacobi_names_the_indices():
    constants = np.zeros((3, 3, 3))
    constants[0, 1, 0], constants[1, 0, 0] = 1.0, -1.0
    constants[1, 2, 1], constants[2, 1, 1] = 1.0, -1.0
    with pytest.raises(InvalidInput, match=r"Jacobi's identity.*\(i, j, k\) = \(\d, \d, \d\)"):
        lie.from_structure_constants(constants)


def test_jacobi_is_checked_in_blocks():
    """so(3) twenty times over: dim⁴ numbers would be 104 MB, the constants themselves are 1.7 MB."""
    constants = np.zeros((60, 60, 60))
    for k in range(0, 60, 3):
        constants[k : k + 3, k : k + 3, k : k + 3] = EPSILON
    tracemalloc.start()
    lie.from_structure_constants(constants)
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert peak < 10 * constants.nbytes


def test_jacobi_finds_the_largest_fault_wherever_it_is():
    rng = np.random.default_rng(0)
    c = rng.normal(size=(5, 5, 5))
    c -= c.transpose(1, 0, 2)
    nested = np.einsum("jkm,iml->ijkl", c, c)
    whole = np.abs(nested + nested.transpose(2, 0, 1, 3) + nested.transpose(1, 2, 0, 3)).max()
    with pytest.raises(InvalidInput, match=f"-?{whole:g} along"):
        lie.from_structure_constants(c)


def test_matrices_that_do_not_close_or_depend():
    basis = lie.SL(2).basis
    with pytest.raises(InvalidInput, match=r"\[B_0, B_1\]|\[B_1, B_0\]"):
        lie.from_matrices(basis[:2])
    with pytest.raises(InvalidInput, match="independent"):
        lie.from_matrices(np.concatenate([basis, basis[:1]]))
    with pytest.raises(InvalidInput, match="shape"):
        lie.from_matrices(np.ones((2, 3)))


def test_matrices_and_constants_agree():
    made = lie.from_matrices(lie.SL(3).basis)
    assert made.structure_constants() == pytest.approx(lie.SL(3).structure_constants(), abs=1e-14)


def test_semidirect_sum_of_turns_and_vectors_is_se3():
    generators = EPSILON.transpose(0, 2, 1)  # (ρ_i)_ab = ε_iba: e_i × v
    made = lie.Semidirect(lie.SO3(), generators)
    assert made.structure_constants() == pytest.approx(lie.SE3().structure_constants(), abs=1e-15)
    with pytest.raises(InvalidInput, match="represent"):
        lie.Semidirect(lie.SO3(), -generators)
    with pytest.raises(InvalidInput, match="shape"):
        lie.Semidirect(lie.SO3(), generators[:2])


@pytest.mark.parametrize(
    "make",
    [lambda: lie.SO(1), lambda: lie.SU(0), lambda: lie.Heisenberg(0), lambda: lie.Power(lie.SO3(), 0),
     lambda: lie.Product(), lambda: lie.Product(lie.SO3(), 3)],
)  # fmt: skip
@pytest.mark.usefixtures("any_type")
def test_sizes_that_are_refused(make):
    with pytest.raises(InvalidInput, match="must be"):
        make()


@pytest.mark.parametrize("weights", [(1.0, 2.0), (1.0, 0.0, 1.0), (1.0, float("nan"), 1.0), ((1.0,), (2.0,), (3.0,))])
def test_weights_that_are_refused(weights):
    with pytest.raises(InvalidInput, match="`weights` must be"):
        lie.Power(lie.SO3(), 3, weights)


@pytest.mark.long
def test_weights_are_the_strengths_of_vortices():
    """Unit vectors whose weights are Γ move as μ = Γx of the vortices do; with other weights they do not."""
    strengths = np.array([1.0, -0.7, 0.4])

    def energy(x):
        apart = 2.0 - 2.0 * jnp.einsum("ik,jk->ij", x, x) + jnp.eye(3)
        return -jnp.sum(np.outer(strengths, strengths) * jnp.log(apart)) / (8.0 * np.pi)

    x = np.random.default_rng(1).normal(size=(3, 3))
    x /= np.linalg.norm(x, axis=-1, keepdims=True)
    wanted = fields.SphereVortices(strengths).vector_field(0.0, strengths[:, None] * x) / strengths[:, None]
    moved = {signs: systems.LiePoisson(lie.Power(lie.SO3(), 3, strengths * signs), energy, sign=1).vector_field(0.0, x)
             for signs in (1.0, 2.0)}  # fmt: skip
    np.testing.assert_allclose(moved[1.0], wanted, atol=1e-14)
    assert np.abs(moved[2.0] - wanted).max() > 0.01


def test_wrong_shapes_are_named():
    with pytest.raises(InvalidInput, match=r"element of SE3 has shape \(…, 6\)"):
        lie.SE3().batch_shape(np.zeros(5))
    with pytest.raises(InvalidInput, match="no Cayley map"):
        lie.SL(2).cayley(np.zeros((2, 2)))


@pytest.mark.long
def test_single_precision_set_on_purpose_is_refused():
    run = subprocess.run(
        [sys.executable, "-c", "import polhode.algebra"], env=os.environ | {"JAX_ENABLE_X64": "0"},
        capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert run.returncode != 0 and "JAX_ENABLE_X64" in run.stderr


def test_importing_polhode_does_not_import_jax():
    code = "import sys, polhode; sys.exit('jax' in sys.modules)"
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0
