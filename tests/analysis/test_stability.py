"""Verdicts against exponents from mpmath, direct integration, and thresholds known in closed form."""

import mpmath
import numpy as np
import pytest
from scipy.integrate import solve_ivp

from polhode.analysis.energy_casimir import energy_casimir
from polhode.analysis.free_axes import axis_stability
from polhode.errors import InvalidInput

EXACT = 1e-13
"""Square roots of products of exact differences."""
THRESHOLD = 1e-8


def hat(v):
    return np.array([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])


def free_body_matrices(moments, axis, norm):
    """Return the matrices of rotation about an axis, by hand from dL/dt = L × I⁻¹L."""
    inverse = np.diag(1.0 / np.asarray(moments))
    L = norm * np.eye(3)[axis]
    return hat(L) @ inverse - hat(inverse @ L), inverse @ L, inverse, L[None], np.eye(3)[None]


def sleeping_top(I1, I3, weight, spin):
    """Return the matrices of an upright heavy top on se(3)*: Π = (0,0,I3ω3), Γ = e3; conserved Π·Γ, ½|Γ|² and Π3."""
    inverse = np.diag([1 / I1, 1 / I1, 1 / I3])
    P, G, e = np.array([0, 0, I3 * spin]), np.array([0, 0, 1.0]), np.array([0, 0, 1.0])
    omega = inverse @ P
    # Π̇ = Π × ω + w Γ × e, Γ̇ = Γ × ω
    flow = np.block([[hat(P) @ inverse - hat(omega), -weight * hat(e)], [hat(G) @ inverse, -hat(omega)]])
    energy = np.block([[inverse, np.zeros((3, 3))], [np.zeros((3, 3)), np.zeros((3, 3))]])
    swap = np.block([[np.zeros((3, 3)), np.eye(3)], [np.eye(3), np.zeros((3, 3))]])
    length = np.block([[np.zeros((3, 6))], [np.zeros((3, 3)), np.eye(3)]])
    gradients = [np.concatenate([G, P]), np.concatenate([np.zeros(3), G]), np.concatenate([e, np.zeros(3)])]
    return flow, np.concatenate([omega, weight * e]), energy, gradients, [swap, length, np.zeros((6, 6))]


@pytest.mark.parametrize("moments", [(1.0, 2.0, 3.0), (3.0, 1.0, 2.0), (1e-9, 1.0, 1e9), (1.0, 1.0 + 1e-9, 2.0)])
def test_rates_of_the_three_axes(moments):
    order = np.argsort(moments)
    found = axis_stability(moments, 2.0)
    assert [found[k].verdict for k in order] == ["stable", "unstable", "stable"]
    low, middle, high = (mpmath.mpf(moments[k]) for k in order)
    rate = 2 / middle * mpmath.sqrt((middle - low) / low * (high - middle) / high)
    assert found[order[1]].rate == pytest.approx(float(rate), rel=EXACT)
    assert "|L|²" in found[order[0]].certificate and found[order[0]].direction is None


def test_general_matrices_give_the_same_verdicts():
    moments = (1.0, 2.0, 3.0)
    for axis, special in enumerate(axis_stability(moments, 2.0)):
        general = energy_casimir(*free_body_matrices(moments, axis, 2.0), ["½|L|²"])
        assert general.verdict == special.verdict
        assert general.rate == pytest.approx(special.rate, rel=EXACT)
        assert np.sort_complex(general.spectrum) == pytest.approx(np.sort_complex(special.spectrum), abs=EXACT)


def test_the_growing_direction_grows_as_said():
    moments, norm, small = np.array([1.0, 2.0, 3.0]), 2.0, 1e-8
    found = axis_stability(moments, norm)[1]
    start = norm * np.array([0.0, 1.0, 0.0]) + small * found.direction
    run = solve_ivp(lambda t, L: np.cross(L, L / moments), (0, 5.0), start, method="DOP853", rtol=1e-13, atol=1e-18)
    left = run.y[:, -1] - norm * np.array([0.0, 1.0, 0.0])
    assert left / small == pytest.approx(found.direction * np.exp(5.0 * found.rate), rel=1e-5, abs=1e-5)


def test_one_unit_in_the_last_place_decides():
    found = axis_stability((1.0, 1.0 + 2.0**-52, 2.0), 1.0)
    assert [x.verdict for x in found] == ["stable", "unstable", "stable"]
    assert found[1].rate == pytest.approx(float(mpmath.sqrt(mpmath.mpf(2) ** -52 * mpmath.mpf("0.5"))), rel=1e-12)


def test_symmetric_spherical_and_resting_bodies():
    oblate = axis_stability((1.0, 1.0, 2.0), 1.0)
    assert [(x.verdict, x.rate, x.growth) for x in oblate] == [
        ("unstable", 0.0, "linear"), ("unstable", 0.0, "linear"), ("stable", 0.0, None),
    ]  # fmt: skip
    assert np.abs(oblate[0].direction) == pytest.approx([0.0, 1.0, 0.0])
    assert all(x.verdict == "stable" for x in axis_stability((2.0, 2.0, 2.0), 1.0))
    assert all(x.verdict == "stable" and x.rate == 0.0 for x in axis_stability((1.0, 2.0, 3.0), 0.0))


def test_sleeping_top_threshold():
    I1, I3, weight = 1.3, 0.5, 2.0
    critical = 2.0 * np.sqrt(I1 * weight) / I3
    above = energy_casimir(*sleeping_top(I1, I3, weight, critical * (1 + THRESHOLD)))
    below = energy_casimir(*sleeping_top(I1, I3, weight, critical * (1 - THRESHOLD)))
    assert (above.verdict, below.verdict) == ("stable", "unstable")
    # the exponent below, from the quadratic of the linearised top: λ² I1 = w − (I3 ω)²/4 I1
    slow = 0.7 * critical
    wanted = np.sqrt((weight - (I3 * slow) ** 2 / (4 * I1)) / I1)
    assert energy_casimir(*sleeping_top(I1, I3, weight, slow)).rate == pytest.approx(wanted, rel=1e-10)


def test_a_flipped_sign_changes_the_verdict():
    flow, *rest = free_body_matrices((1.0, 2.0, 3.0), 1, 2.0)
    broken = flow.copy()
    broken[0, 2] = -broken[0, 2]
    assert energy_casimir(flow, *rest).verdict == "unstable"
    assert energy_casimir(broken, *rest).verdict == "undecided"


def test_gyroscopic_equilibria_are_undecided():
    # two oscillators of opposite energy sign: spectrum imaginary, second variation indefinite
    symplectic = np.block([[np.zeros((2, 2)), np.eye(2)], [-np.eye(2), np.zeros((2, 2))]])
    hessian = np.diag([1.0, -2.0, 1.0, -2.0])
    found = energy_casimir(symplectic @ hessian, np.zeros(4), hessian, np.zeros((0, 4)), np.zeros((0, 4, 4)))
    assert found.verdict == "undecided" and "indefinite" in found.certificate


def test_points_that_are_no_equilibria_and_bad_shapes():
    flow, gradient, *rest = free_body_matrices((1.0, 2.0, 3.0), 1, 2.0)
    with pytest.raises(InvalidInput, match="not an equilibrium"):
        energy_casimir(flow, gradient + np.array([0.1, 0, 0]), *rest)
    with pytest.raises(InvalidInput, match="shapes must match"):
        energy_casimir(flow[:2, :2], gradient, *rest)
    with pytest.raises(InvalidInput, match="positive"):
        axis_stability((0.0, 1.0, 1.0), 1.0)
