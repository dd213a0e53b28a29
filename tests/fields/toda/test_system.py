"""The Toda lattice against QR of the matrix exponential, Newton's equations, and its own integrals."""

import jax
import jax.numpy as jnp
import mpmath as mp
import numpy as np
import pytest
from scipy.integrate import solve_ivp

import polhode as ph
from polhode.errors import InvalidInput
from polhode.fields import Bidiagonal, Toda
from polhode.integrators import Splitting
from polhode.testing import LawBroken, check_algebra, check_system
from sweeping import first

RNG = np.random.default_rng(2)
N = 5
LATTICE = Toda(N)
START = np.concatenate([RNG.normal(size=N), RNG.uniform(0.3, 1.0, N - 1)])


def by_qr(state, t):
    """Return QᵀLQ of exp(tL) = QR, to 60 digits."""
    with mp.workdps(60):
        L = mp.zeros(N)
        for i in range(N):
            L[i, i] = mp.mpf(float(state[i]))
        for i in range(N - 1):
            L[i, i + 1] = L[i + 1, i] = mp.mpf(float(state[N + i]))
        Q = mp.qr(mp.expm(t * L))[0]
        M = Q.T * L * Q
        return (np.array([float(M[i, i]) for i in range(N)]), np.array([float(abs(M[i, i + 1])) for i in range(N - 1)]))


@pytest.mark.long
@pytest.mark.parametrize("t", [0.7, -2.0, 20.0])
def test_exact_motion_is_that_of_qr_factors(t):
    result = np.asarray(LATTICE.exact(START, t))
    b, a = by_qr(START, t)
    np.testing.assert_allclose(result[:N], b, atol=2e-14)
    np.testing.assert_allclose(result[N:], a, rtol=2e-13)
    if t == 20.0:
        assert a.min() < 1e-12  # so that the bound is of relative errors


@pytest.mark.long
def test_newtons_equations_of_particles():
    """Particles with potential Σ exp(q_i − q_{i+1}), by a general integrator, are at the exact state."""
    q, p = RNG.normal(size=N), RNG.normal(size=N)

    def rate(_, y):
        pulls = np.exp(y[: N - 1] - y[1:N])
        return np.concatenate([y[N:], np.append(-pulls, 0.0) + np.append(0.0, pulls)])

    def flaschka(y):
        return np.concatenate([-0.5 * y[N:], 0.5 * np.exp(0.5 * (y[: N - 1] - y[1:N]))])

    y = solve_ivp(rate, (0.0, 3.0), np.concatenate([q, p]), method="DOP853", rtol=1e-13, atol=1e-13).y[:, -1]
    np.testing.assert_allclose(LATTICE.exact(flaschka(np.concatenate([q, p])), 3.0), flaschka(y), atol=1e-11)


@pytest.mark.long
def test_signs_of_a_stay_and_batches():
    flipped = START * np.concatenate([np.ones(N), [1.0, -1.0, 1.0, -1.0]])
    times = np.array([0.5, 4.0])
    both = LATTICE.exact(np.stack([START, flipped])[:, None], times)
    np.testing.assert_array_equal(np.abs(both[0]), np.abs(both[1]))
    assert (np.sign(both[1, :, N:]) == np.sign(flipped[N:])).all()
    np.testing.assert_allclose(both[0, 1], LATTICE.exact(START, 4.0), atol=1e-14)


def test_it_sorts():
    values = np.linalg.eigvalsh(np.asarray(LATTICE.matrix(START)))
    for t, wanted in ((1e5, values[::-1]), (-1e5, values)):
        result = np.asarray(LATTICE.exact(START, t))
        np.testing.assert_allclose(result[:N], wanted, atol=1e-14)
        assert not result[N:].any()


@pytest.mark.long_cases("4")
@pytest.mark.parametrize("order", first(1, [4, 2]))
def test_splitting_has_its_order(order):
    wanted = LATTICE.exact(START, 1.0)
    errors = [float(jnp.abs(ph.solve(LATTICE, START, (0.0, 1.0), Splitting, step=h, order=order).saved[-1]
                            - wanted).max()) for h in (0.1, 0.05)]  # fmt: skip
    assert abs(np.log2(errors[0] / errors[1]) - order) < 0.25


@pytest.mark.long
def test_traces_are_in_involution_and_the_casimir_is_one():
    L = np.asarray(LATTICE.matrix(START))
    powers = [np.linalg.matrix_power(L, k) for k in range(N)]
    gradients = [k * np.concatenate([np.diag(powers[k - 1]), 2.0 * np.diag(powers[k - 1], 1)]) for k in range(1, N + 1)]
    third = jax.grad(LATTICE.extra_invariants["tr L^3"])(jnp.asarray(START))
    np.testing.assert_allclose(gradients[2], third, rtol=1e-13)
    for i, one in enumerate(gradients):
        for other in gradients[:i]:
            result = START @ np.asarray(LATTICE.algebra.bracket(jnp.asarray(one), jnp.asarray(other)))
            assert abs(result) < 1e-14 * N * np.linalg.norm(one) * np.linalg.norm(other)
    anything = jnp.asarray(RNG.normal(size=2 * N - 1))
    assert float(START @ LATTICE.algebra.bracket(jnp.asarray(gradients[0]), anything)) == 0.0
    assert abs(float(START @ LATTICE.algebra.bracket(jnp.asarray(gradients[1]), anything))) > 0.1


def test_algebra_is_that_of_matrices_without_lower_diagonals():
    algebra = Bidiagonal(4)
    x, y = RNG.normal(size=(2, 7))
    as_matrix = lambda v: np.diag(v[:4]) + np.diag(v[4:], -1)  # noqa: E731
    product = as_matrix(x) @ as_matrix(y) - as_matrix(y) @ as_matrix(x)
    wanted = np.concatenate([np.diag(product), np.diag(product, -1)])
    np.testing.assert_allclose(algebra.bracket(jnp.asarray(x), jnp.asarray(y)), wanted, atol=1e-15)


class WrongBracket(Bidiagonal):
    def bracket(self, x, y):
        return super().bracket(x, y).at[..., -1].multiply(2.0)


class WrongExponential(Bidiagonal):
    def exp_change(self, x, mu):
        return self.coadjoint(x, mu)


class NotInvolutive(Toda):
    @property
    def extra_invariants(self):
        return {"first trace": lambda x: x[..., 0]}


@pytest.mark.long_cases("WrongExponential")
@pytest.mark.parametrize("broken", [WrongBracket, WrongExponential])
def test_broken_algebras_are_caught(broken):
    with pytest.raises(LawBroken):
        check_algebra(broken(3))


@pytest.mark.long
def test_a_broken_lattice_is_caught():
    with pytest.raises(LawBroken, match="first trace"):
        check_system(NotInvolutive(3))


def test_bad_input():
    with pytest.raises(InvalidInput, match="at least 2"):
        Toda(1)
