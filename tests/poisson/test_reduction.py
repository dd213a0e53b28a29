"""T*SO(3): trivialisations, momentum maps, reduction, and the attitude back from the reduced motion."""

import jax
import numpy as np
import pytest

import polhode as ph
from polhode import poisson, rotation
from polhode.errors import InvalidInput
from sweeping import first

EXACT = 1e-14
MOMENTS = np.array([1.0, 2.0, 3.0])
RNG = np.random.default_rng(5)
ATTITUDE = rotation.normalize(RNG.normal(size=(6, 4)))
COVECTOR = RNG.normal(size=(6, 3, 3))


def test_trivialisations_pair_as_the_covector_does():
    velocity = RNG.normal(size=(6, 3))
    R = rotation.as_matrix(ATTITUDE)
    pairing = 0.5 * np.einsum("nij,nij->n", COVECTOR, R @ rotation.hat(velocity))
    assert np.sum(poisson.left_trivialize(ATTITUDE, COVECTOR) * velocity, axis=1) == pytest.approx(pairing, abs=EXACT)
    pairing = 0.5 * np.einsum("nij,nij->n", COVECTOR, rotation.hat(velocity) @ R)
    assert np.sum(poisson.right_trivialize(ATTITUDE, COVECTOR) * velocity, axis=1) == pytest.approx(pairing, abs=EXACT)


def test_momentum_maps_and_the_lifted_action():
    body, space = poisson.left_trivialize(ATTITUDE, COVECTOR), poisson.right_trivialize(ATTITUDE, COVECTOR)
    assert poisson.space_momentum(ATTITUDE, body) == pytest.approx(space, abs=EXACT)
    assert poisson.body_momentum(ATTITUDE, space) == pytest.approx(body, abs=EXACT)
    turn = rotation.normalize(np.array([0.3, -0.2, 0.5, 0.1]))
    moved = poisson.lifted_action(turn, ATTITUDE, COVECTOR)
    assert poisson.left_trivialize(*moved) == pytest.approx(body, abs=EXACT)
    assert poisson.right_trivialize(*moved) == pytest.approx(rotation.rotate(turn, space), abs=EXACT)
    assert poisson.reduce(ATTITUDE, space) == pytest.approx(body, abs=EXACT)
    assert poisson.reduce(moved[0], rotation.rotate(turn, space)) == pytest.approx(body, abs=EXACT)
    assert (poisson.reduce(ATTITUDE, space, side="right") == space).all()
    with pytest.raises(InvalidInput, match="side"):
        poisson.reduce(ATTITUDE, space, side="up")


@pytest.mark.long
@pytest.mark.parametrize("momentum", first(1, [[0.3, 1.8, 1.5], [0.9, 1.6, 0.3]]))
def test_attitude_and_phases_come_back(momentum):
    motion = ph.FreeMotion(MOMENTS, momentum=momentum, attitude=rotation.normalize((0.5, 0.1, -0.7, 0.2)))
    again = jax.jit(lambda t, L, q: poisson.reconstruct(t, L, lambda L: L / MOMENTS, q))  # compiled as a whole
    start, errors = motion.attitude(0.0), []
    for count in (400, 800):
        times = np.linspace(0.0, motion.period, count + 1)
        found = again(times, motion.momentum(times), start)
        errors.append(np.abs(np.asarray(found.attitude) - motion.attitude(times)).max())
    assert np.log2(errors[0] / errors[1]) == pytest.approx(4.0, abs=0.1) and errors[1] < 1e-8
    dynamic, geometric = float(found.dynamic_phase[-1]), float(found.geometric_phase[-1])
    assert dynamic == pytest.approx(2.0 * motion.energy * motion.period / motion.momentum_norm, rel=1e-9)
    assert np.cos(geometric) == pytest.approx(np.cos(motion.geometric_phase), abs=1e-8)
    assert np.sin(geometric) == pytest.approx(np.sin(motion.geometric_phase), abs=1e-8)
    turned = np.exp(1j * (dynamic + geometric))
    assert turned == pytest.approx(np.exp(1j * motion.precession_per_period), abs=1e-8)
    space = rotation.rotate(np.asarray(found.attitude), motion.momentum(times))
    assert np.abs(space - space[0]).max() < 10 * EXACT


@pytest.mark.parametrize(
    ("times", "momentum", "words"),
    [
        ([0.0], [[1.0, 0, 0]], "match"),
        ([0.0, 1.0], [[1.0, 0, 0]], "match"),
        ([0.0, 0.0], [[1.0, 0, 0]] * 2, "advance"),
        ([0.0, 1.0], [[0.0, 0, 0]] * 2, "not zero"),
        ([0.0, 1.0], [[1.0, 0, np.nan]] * 2, "finite"),
    ],
)
def test_bad_input(times, momentum, words):
    with pytest.raises(InvalidInput, match=words):
        poisson.reconstruct(times, momentum, lambda L: L / MOMENTS)
