"""Noise along orbits: means against the exact semigroup, Casimirs, and noise that knows its place."""

import jax
import jax.numpy as jnp
import numpy as np
import pytest
from scipy.linalg import expm

import polhode as ph
from polhode import algebra as lie
from polhode.errors import InvalidInput
from polhode.fields import SphereFluid, TransportNoise
from polhode.integrators import IsospectralMidpoint
from polhode.systems import FreeRigidBody, LiePoisson

FIELDS = np.array([[0.9, 0.0, 0.3], [0.0, 0.7, -0.4]])
ALONG = np.array([0.3, -0.5, 1.1])


def cross(x):
    """Return the matrix of ad*_x L = L × x."""
    return np.cross(np.eye(3), x).T


def mean_of_step(h, fields=FIELDS):
    """Return the matrix of the expected L after a step, by Gauss and Hermite's points for all normal numbers."""
    solver = TransportNoise(LiePoisson(lie.SO3(), lambda m: jnp.dot(ALONG, m)), h, fields)
    at, weights = np.polynomial.hermite_e.hermegauss(8)
    normals = np.stack(np.meshgrid(*[at] * 4, indexing="ij"), axis=-1).reshape(-1, 2, 2)
    weights = np.prod(np.meshgrid(*[weights / weights.sum()] * 4, indexing="ij"), axis=0).ravel()
    one = jax.vmap(lambda n, start: start + solver.change_by(0.0, h, start, n).state, (0, None))
    moved = np.stack([np.asarray(jax.jit(one)(normals, start)) for start in np.eye(3)], axis=-1)
    return np.einsum("n,nij->ij", weights, moved)


@pytest.mark.long
def test_means_are_of_weak_order_two():
    """E dL = (A + ½ Σ A_k²) L dt for a constant field: the mean of a step is off by h³, though they do not commute."""
    generator = cross(ALONG) + 0.5 * sum(cross(x) @ cross(x) for x in FIELDS)
    errors = [np.abs(mean_of_step(h) - expm(h * generator)).max() for h in (0.4, 0.2, 0.1)]
    assert 6.5 < errors[0] / errors[1] < 9.5 and 6.5 < errors[1] / errors[2] < 9.5
    without = expm(0.1 * cross(ALONG))
    assert np.abs(without - expm(0.1 * generator)).max() > 50 * errors[2]


@pytest.mark.sweep
def test_casimirs_stay_and_the_energy_does_not():
    fluid = SphereFluid(6, 0.4)
    rng = np.random.default_rng(3)
    fields, start = (fluid.algebra.from_vector(rng.normal(size=(k, 35)) * 0.3) for k in (2, 1))
    solver = TransportNoise(fluid, 0.02, fields, drift=IsospectralMidpoint)
    result = np.asarray(ph.solve(fluid, start[0], [0.0, 2.0, 4.0], solver).saved)
    spectra = np.linalg.eigvalsh(-1j * result)
    assert np.abs(spectra - spectra[0]).max() < 1e-14 * np.abs(spectra).max()
    energies = np.asarray(fluid.energy(jnp.asarray(result)))
    assert abs(energies[-1] / energies[0] - 1.0) > 0.01


@pytest.mark.sweep
def test_sampling_and_batches_change_nothing_and_attitudes_follow():
    body = FreeRigidBody((1.0, 2.0, 3.0))
    start = np.array([[1.0, 0.0, 0.0, 0.0, 0.2, 1.0, 0.4], [1.0, 0.0, 0.0, 0.0, 0.9, 0.1, -0.4]])
    solver = TransportNoise(body, 0.125, FIELDS, seed=4)
    often = ph.solve(body, start, np.arange(0.0, 2.1, 0.25), solver).saved
    seldom = ph.solve(body, start[1], [0.0, 2.0], solver).saved
    assert np.abs(np.asarray(often)[1, -1] - np.asarray(seldom)[-1]).max() < 1e-13
    momenta = ph.rotation.rotate(often[..., :4], often[..., 4:])
    assert np.abs(np.asarray(momenta) - start[:, None, 4:]).max() < 1e-13
    other = ph.solve(body, start[1], [0.0, 2.0], TransportNoise(body, 0.125, FIELDS, seed=5)).saved
    assert np.abs(np.asarray(other - seldom)[-1]).max() > 0.05


@pytest.mark.parametrize(("fields", "words"), [
    (np.eye(3)[0], r"`fields` must be \(m, 3\)"), (np.ones((2, 4)), r"`fields` must be \(m, 3\)"),
    (np.full((1, 3), np.nan), "`fields` must be finite"),
])  # fmt: skip
def test_fields_that_are_refused(fields, words):
    with pytest.raises(InvalidInput, match=words):
        TransportNoise(FreeRigidBody((1.0, 2.0, 3.0)), 0.1, fields)
