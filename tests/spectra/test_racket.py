"""The quantum racket: its flip, collapse and revivals; times by the classical rate of leaving the axis."""

import math

import numpy as np
import pytest

from polhode.errors import InvalidInput
from polhode.spectra import Racket, coherent_state, evolve, spin_matrices

W = (27.0, 14.0, 9.0)


@pytest.mark.parametrize(("J", "half", "first", "depth"), [
    (25, 2.248491392218925, 5.545, -0.793), (100, 2.919605227229856, 6.900, -0.901),
])  # fmt: skip
def test_the_flip_takes_the_logarithm_of_J(J, half, first, depth):
    """Half times by the chain at 30 digits; they grow by half of ln J, first reversals by ln J."""
    racket = Racket(W, J)
    assert racket.half_time * racket.rate == pytest.approx(half, rel=1e-13)
    result = racket.first_reversal
    assert result.time * racket.rate == pytest.approx(first, abs=2e-3)
    assert result.along == pytest.approx(depth, abs=5e-4)
    assert racket.rate == pytest.approx(4.0 * math.pi * (J + 0.5) * math.sqrt(13.0 * 5.0), rel=1e-15)
    assert math.isinf(racket.period) and racket.revival_time is None


@pytest.mark.parametrize("towards", ["a", "c"])
def test_states_move_as_classical_momentum_does(towards):
    """Of a coherent state d⟨L⟩/dt is Euler's, with G replaced by J − ½: ⟨L_a L_b + L_b L_a⟩ = 2J(J − ½) n_a n_b."""
    J, time = 6, 1e-7
    A, B, C = W
    racket = Racket(W, J, 0.4, towards)
    a, b, c = racket.direction
    states = racket.states(np.array([0.0, time]))
    assert np.allclose(np.linalg.norm(states, axis=1), 1.0, rtol=1e-14)
    result = np.einsum("ti,kij,tj->tk", states.conj(), spin_matrices(J), states).real / J  # along c, a, b
    assert np.allclose(result[0], (c, a, b), atol=1e-14)
    euler = 4.0 * math.pi * (J - 0.5) * np.array([(B - A) * a * b, (C - B) * b * c, (A - C) * c * a])
    assert np.allclose((result[1] - result[0]) / time, euler, atol=2e-3 * np.abs(euler).max())
    later = np.array([0.3, 1.7]) / racket.rate
    along = np.abs(racket.states(later)) ** 2 @ np.arange(J, -J - 1, -1.0) / J
    assert np.allclose(along, racket.quantum(later), atol=1e-12)


def test_half_times_grow_by_half_of_the_logarithm():
    racket = Racket(W, 400)
    assert racket.half_time * racket.rate == pytest.approx(3.608388, abs=3e-6)
    assert (racket.half_time * racket.rate - 2.919605227229856) / math.log(4.0) == pytest.approx(0.5, abs=4e-3)


def test_beside_the_axis_it_collapses_and_revives():
    """J = 400 at 15°: T_rev is 231.7 T; half of it brings back more than the whole."""
    racket = Racket(W, 400, math.radians(15.0))
    T, revival = racket.period, racket.revival_time
    assert revival / T == pytest.approx(231.7, abs=0.05)
    assert racket.quantum(np.array([0.5 * T]))[0] == pytest.approx(-0.957, abs=5e-4)
    swing = np.linspace(-1.0, 1.0, 81) * T
    assert np.abs(racket.quantum(0.25 * revival + swing)).max() < 0.05
    assert racket.quantum(0.5 * revival + swing).max() == pytest.approx(0.55, abs=0.01)
    assert racket.quantum(revival + swing).max() == pytest.approx(0.40, abs=0.01)


@pytest.mark.parametrize("towards", ["a", "c"])
def test_the_chains_are_the_whole_space(towards):
    """Against dense matrices of the spin in another frame, z = c."""
    J, tilt = 6, 0.4
    a, b, c = spin_matrices(J)
    H = 2.0 * math.pi * (27.0 * a @ a + 14.0 * b @ b + 9.0 * c @ c)
    racket = Racket(W, J, tilt, towards)
    times = np.linspace(0.0, 3.0, 7) / racket.rate
    states = evolve(H, coherent_state(J, racket.direction), times)
    wanted = np.einsum("ti,ij,tj->t", states.conj(), b, states).real / J
    assert racket.quantum(times) == pytest.approx(wanted, abs=1e-13)


def test_the_classical_body():
    """After half a period L has turned over; on the axis it stays."""
    racket = Racket(W, 10, 0.3, "c")
    result = racket.classical(np.array([0.0, 0.5, 1.0]) * racket.period)
    assert result == pytest.approx(np.cos(0.3) * np.array([1.0, -1.0, 1.0]), abs=1e-12)
    assert Racket(W, 10).classical(np.array([0.0, 1.0, 9.0])).tolist() == [1.0, 1.0, 1.0]


def test_the_ensemble_starts_as_the_state():
    """The same mean, and at first the same motion; the state leaves it by a tenth at 3/2 ln J and some more."""
    racket = Racket(W, 25)
    times = np.array([0.0, 1.0, 2.0, 7.0, 9.0]) / racket.rate
    apart = racket.quantum(times) - racket.ensemble(times, 400)
    assert np.abs(apart[:3]).max() < 6e-3 and abs(apart[3]) < 0.1 < abs(apart[4])


@pytest.mark.parametrize(("make", "said"), [
    (lambda: Racket((2.0, 2.0, 1.0), 3), "no middle axis"),
    (lambda: Racket(W, 0), "from 1 to 4,000"),
    (lambda: Racket(W, 3, 2.0), "`tilt` must be from 0"),
    (lambda: Racket(W, 3, 0.1, "b"), '`towards` must be "a" or "c"'),
    (lambda: Racket(W, 3).quantum(np.array([np.nan])), "`times` must be finite"),
    (lambda: Racket(W, 3).ensemble(np.zeros(1), 3), "`members` must be a whole number"),
])  # fmt: skip
def test_mistakes(make, said):
    with pytest.raises(InvalidInput, match=said):
        make()
