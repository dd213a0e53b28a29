"""Symbols of operators: values known in closed form, traces as integrals, and tensors that the ladder carries on."""

import numpy as np
import pytest

from polhode.errors import InvalidInput
from polhode.spectra import coherent_state, spherical_tensor, spin_matrices, symbol
from polhode.spectra.symbols import pole_values

N = np.array([0.3, -0.5, 0.8]) / np.sqrt(0.98)
RNG = np.random.default_rng(0)


def grid(s):
    """Directions and weights of an integral that is exact for two symbols' product."""
    count = 2 * int(2 * s) + 4
    x, weights = np.polynomial.legendre.leggauss(count)
    phi = 2.0 * np.pi * np.arange(2 * count) / (2 * count)
    z, angle = np.meshgrid(x, phi, indexing="ij")
    flat = np.sqrt(1.0 - z * z)
    return np.stack([flat * np.cos(angle), flat * np.sin(angle), z], axis=-1), np.outer(
        weights, np.full(2 * count, np.pi / count))  # fmt: skip


def matrix(s):
    size = round(2 * s) + 1
    return RNG.normal(size=(size, size)) + 1j * RNG.normal(size=(size, size))


@pytest.mark.parametrize("s", [0.5, 1, 2.5, 6])
def test_symbols_of_spin(s):
    S, one = spin_matrices(s), np.eye(round(2 * s) + 1)
    for kind, radius in (("q", s), ("weyl", np.sqrt(s * (s + 1))), ("p", s + 1)):
        assert np.array([symbol(x, N, kind) for x in S]) == pytest.approx(radius * N, abs=1e-11)
        assert symbol(one, N, kind) == pytest.approx(1.0, abs=1e-12)
    c = s * (s + 1)
    assert symbol(S[2] @ S[2], N) == pytest.approx(c / 3 + np.sqrt(c * (c - 0.75)) * (N[2] ** 2 - 1 / 3), abs=1e-12)


@pytest.mark.parametrize("s", [0.5, 1, 2.5])
def test_q_is_the_expectation_in_coherent_states(s):
    A, state = matrix(s), coherent_state(s, N)
    assert symbol(A, N, "q") == pytest.approx(state.conj() @ A @ state, abs=1e-13)


@pytest.mark.parametrize(("one", "other"), [("weyl", "weyl"), ("q", "p"), ("p", "q")])
def test_traces_are_integrals(one, other):
    s, (directions, weights) = 2.5, grid(2.5)
    A, B = matrix(s), matrix(s)
    integral = np.sum(weights * symbol(A, directions, one) * symbol(B, directions, other))
    assert (2 * s + 1) / (4 * np.pi) * integral == pytest.approx(np.trace(A @ B), rel=1e-11)
    wrong = np.sum(weights * symbol(A, directions, "q") * symbol(B, directions, "q"))
    assert (2 * s + 1) / (4 * np.pi) * wrong != pytest.approx(np.trace(A @ B), rel=1e-2)


def test_the_wigner_function_at_the_pole_of_a_half_spin():
    state = coherent_state(0.5, (0.0, 0.0, 1.0))
    assert symbol(np.outer(state, state.conj()), (0.0, 0.0, 1.0)) == pytest.approx((1 + np.sqrt(3)) / 2, abs=1e-15)


@pytest.mark.parametrize(
    ("s", "q"), [(0.5, 0), (7.5, 1), (40, 0), (40, 5), pytest.param(100, 30, marks=pytest.mark.sweep)]
)
def test_the_ladder_carries_tensors_on(s, q):
    """[S₊, T_kq] = √((k−q)(k+q+1)) T_{k,q+1} ties all signs together."""
    now, following, m = spherical_tensor(s, q), spherical_tensor(s, q + 1), s - np.arange(2 * s + 1)
    up = np.diag(np.sqrt((s - m[1:]) * (s + m[1:] + 1)), 1)
    for k in range(q + 1, round(2 * s) + 1):
        T = np.diag(now[k - q], q)
        raised = np.diagonal(up @ T - T @ up, q + 1) / np.sqrt((k - q) * (k + q + 1.0))
        assert np.abs(raised - following[k - q - 1]).max() < 1e-13


def test_tensors_of_a_large_spin_are_orthonormal():
    rows = spherical_tensor(500, 2)
    assert np.abs(rows @ rows.T - np.eye(len(rows))).max() < 1e-14


@pytest.mark.parametrize(
    "call",
    [lambda: symbol(np.ones((2, 3)), N), lambda: symbol(np.eye(2), N, "husimi"), lambda: symbol(np.eye(2), (0, 0, 0)),
     lambda: spherical_tensor(1, 3), lambda: spherical_tensor(1, -1)],
)  # fmt: skip
def test_what_is_refused(call):
    with pytest.raises(InvalidInput):
        call()


@pytest.mark.parametrize("s", [0.5, 1, 3, 6.5])
def test_values_at_the_pole_are_those_of_projectors(s):
    """½ (1 ± √3) of a spin ½: quantum.md's coherent state at its pole, and the other side."""
    result = pole_values(s)
    wanted = [symbol(np.diag(row), (0.0, 0.0, 1.0)).real for row in np.eye(len(result))]
    assert result == pytest.approx(wanted, abs=1e-12) and result.sum() == pytest.approx(1.0, abs=1e-12)
    if s == 0.5:
        assert result == pytest.approx([0.5 * (1 + np.sqrt(3)), 0.5 * (1 - np.sqrt(3))], abs=1e-15)
