"""Verdicts against exponents from mpmath, direct integration, and thresholds known in closed form."""

import re

import mpmath
import numpy as np
import pytest
from scipy.integrate import solve_ivp

from polhode.analysis.energy_casimir import energy_casimir
from polhode.analysis.free_axes import axis_stability
from polhode.certificates._definite import definite_combination
from polhode.errors import InvalidInput

EXACT = 1e-13
"""Square roots of products of exact differences."""
THRESHOLD = 1e-8
CANONICAL = np.array([[0.0, 1.0], [-1.0, 0.0]])
NOTHING = np.zeros((2, 2))


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


@pytest.mark.parametrize("unit", [1.0, 1e-9, 1e9])
def test_sleeping_top_threshold(unit):
    I1, I3, weight = 1.3 * unit, 0.5 * unit, 2.0 * unit
    critical = 2.0 * np.sqrt(I1 * weight) / I3
    above = energy_casimir(*sleeping_top(I1, I3, weight, critical * (1 + THRESHOLD)))
    below = energy_casimir(*sleeping_top(I1, I3, weight, critical * (1 - THRESHOLD)))
    assert (above.verdict, below.verdict) == ("stable", "unstable")
    # the exponent below, from the quadratic of the linearised top: λ² I1 = w − (I3 ω)²/4 I1
    slow = 0.7 * critical
    wanted = np.sqrt((weight - (I3 * slow) ** 2 / (4 * I1)) / I1)
    assert energy_casimir(*sleeping_top(I1, I3, weight, slow)).rate == pytest.approx(wanted, rel=1e-10)


def test_sleeping_top_at_the_threshold_is_undecided():
    spin = 2.0 * np.sqrt(1.3 * 2.0) / 0.5
    assert energy_casimir(*sleeping_top(1.3, 0.5, 2.0, spin)).verdict == "undecided"


def test_sleeping_top_without_its_third_integral_needs_more_spin():
    # by hand: the Casimirs alone give 1/I1 · (I3ω² − w) > ω², so a body taller than wide is never proved stable
    for I1, I3, spin in ((1.3, 0.5, 9.0), (0.5, 1.3, 1.5), (0.5, 1.3, 1.7)):
        flow, gradient, hessian, gradients, hessians = sleeping_top(I1, I3, 2.0, spin)
        found = energy_casimir(flow, gradient, hessian, gradients[:2], hessians[:2])
        assert (found.verdict == "stable") == ((I3 - I1) * spin**2 > 2.0)
        assert found.verdict != "unstable" or (I3 * spin) ** 2 < 4 * 2.0 * I1


def test_flows_that_conserve_nothing_are_refused():
    flow, *rest = free_body_matrices((1.0, 2.0, 3.0), 1, 2.0)
    assert energy_casimir(flow, *rest).verdict == "unstable"
    flipped = flow.copy()
    flipped[0, 2] = -flipped[0, 2]
    with pytest.raises(InvalidInput, match="second variation"):
        energy_casimir(flipped, *rest)
    leaving = flow.copy()
    leaving[1, 2] = 0.1
    with pytest.raises(InvalidInput, match="Casimirs"):
        energy_casimir(leaving, *rest)


def quadratic_parts(text, hessians, gradients):
    """Return D²F on all of the space from the certificate's own words: H + λ C + c Δ(C)²."""
    total = np.array(hessians["H"], dtype=float) if text.startswith("H") else 0.0 * hessians["H"]
    for sign, number, square, name in re.findall(r"([+−]) ([\d.e+-]+) (Δ\()?([^ )]+)", text):
        value = float(number) * (1 if sign == "+" else -1)
        outer = 2.0 * np.outer(gradients[name], gradients[name])
        total = total + value * (outer if square else np.asarray(hessians[name]))
    return total


def square_of(text):
    sign, number = re.findall(r"([+−]) ([\d.e+-]+) Δ", text)[0]
    return float(number) * (1 if sign == "+" else -1)


@pytest.mark.parametrize("axis", [0, 2])
def test_the_certificate_is_definite_on_all_of_the_space(axis):
    matrices = free_body_matrices((1.0, 2.0, 3.0), axis, 2.0)
    text = energy_casimir(*matrices, ["½|L|²"]).certificate
    function = text.split("second variation of ")[1].split(" is ")[0]
    second = quadratic_parts(function, {"H": matrices[2], "½|L|²": np.eye(3)}, {"½|L|²": matrices[3][0]})
    sizes = np.linalg.eigvalsh(second) * (1 if "positive" in text else -1)
    assert sizes.min() > 1e-3
    # the square is needed: without it the function is flat across the sphere
    assert np.abs(np.linalg.eigvalsh(second - 2.0 * square_of(function) * np.diag(matrices[3][0] ** 2))).min() < 1e-6


def test_the_tops_certificate_is_definite_on_all_of_the_space():
    matrices = sleeping_top(1.3, 0.5, 2.0, 7.0)
    names = ["Π·Γ", "½|Γ|²", "Π3"]
    text = energy_casimir(*matrices, names).certificate
    function = text.split("second variation of ")[1].split(" is ")[0]
    hessians = {"H": matrices[2], **dict(zip(names, matrices[4], strict=True))}
    second = quadratic_parts(function, hessians, dict(zip(names, matrices[3], strict=True)))
    assert "positive definite" in text and np.linalg.eigvalsh(second).min() > 1e-4


def test_a_negative_definite_function_is_said_with_its_signs():
    # H = −I1 + 2 I2 + 5 c² of two oscillators and a Casimir c; I2 is conserved too, and H − 3 I2 ≤ 0 on leaves
    first, second = np.diag([1.0, 1, 0, 0, 0]), np.diag([0.0, 0, 1, 1, 0])
    across = np.diag([0.0, 0, 0, 0, 1])
    hessian = -first + 2 * second + 10 * across
    symplectic = np.zeros((5, 5))
    symplectic[:4, :4] = np.block([[CANONICAL, NOTHING], [NOTHING, CANONICAL]])
    gradients, hessians = [np.zeros(5), np.eye(5)[4]], [second, np.zeros((5, 5))]
    text = energy_casimir(symplectic @ hessian, np.zeros(5), hessian, gradients, hessians, ["I2", "c"]).certificate
    function = text.split("second variation of ")[1].split(" is ")[0]
    parts = {"H": hessian, "I2": second, "c": 0 * second}
    found = quadratic_parts(function, parts, {"I2": gradients[0], "c": gradients[1]})
    assert "negative definite" in text and np.linalg.eigvalsh(found).max() < -1e-3


def spin_pair(first, second, field, exchange, anisotropy):
    """Return the matrices of two spins along z, H = field·(S1z, S2z) + J (S1x S2x + S1y S2y) + K S1z S2z."""
    dH = np.array([0, 0, field[0] + anisotropy * second, 0, 0, field[1] + anisotropy * first])
    coupling = np.diag([exchange, exchange, anisotropy])
    ddH = np.block([[np.zeros((3, 3)), coupling], [coupling, np.zeros((3, 3))]])
    S = np.array([0, 0, first, 0, 0, second])
    lift = lambda v: np.block([[hat(v[:3]), np.zeros((3, 3))], [np.zeros((3, 3)), hat(v[3:])]])  # noqa: E731
    gradients = [np.r_[S[:3], 0, 0, 0], np.r_[0, 0, 0, S[3:]]]
    hessians = [np.diag([1.0, 1, 1, 0, 0, 0]), np.diag([0, 0, 0, 1.0, 1, 1])]
    return lift(S) @ ddH - lift(dH), dH, ddH, gradients, hessians


@pytest.mark.parametrize("field", [-3.0, -0.9, 0.2, 1.5, 3.1])
@pytest.mark.parametrize("spins", [(1.0, 0.7), (1.0, -0.7), (1e6, -3e5)])
def test_spin_pairs_against_exponents_from_mpmath(spins, field):
    first, second = spins
    size = max(abs(first), abs(second))
    matrices = spin_pair(first, second, (field * size, -0.4 * field * size), 1.1, 0.6)
    with mpmath.workdps(40):
        exponents = mpmath.eig(mpmath.matrix(matrices[0].tolist()), left=False, right=False)
        exact = max(float(mpmath.re(x)) for x in exponents)
    found = energy_casimir(*matrices)
    if exact > 1e-9 * size:
        assert found.verdict == "unstable" and found.rate == pytest.approx(exact, rel=1e-11)
    else:
        # the pair's circular modes, by hand: definite if the 2 × 2 block of D²(H + Σ λ C) is
        block = np.array([[-matrices[1][2] / first, 1.1], [1.1, -matrices[1][5] / second]])
        assert found.verdict == ("stable" if np.linalg.det(block) > 0 else "undecided")
    assert len(found.spectrum) == 4


def so4_body(moments, first, second):
    """Return the matrices of a free body in four dimensions, spinning in planes 12 and 34, L_ij = (J_i+J_j) Ω_ij."""
    pairs = [(i, j) for i in range(4) for j in range(i + 1, 4)]

    def matrix(v):
        m = np.zeros((4, 4))
        for (i, j), x in zip(pairs, v, strict=True):
            m[i, j], m[j, i] = x, -x
        return m

    vector = lambda m: np.array([m[i, j] for i, j in pairs])  # noqa: E731
    inverse = np.diag([1.0 / (moments[i] + moments[j]) for i, j in pairs])
    L = np.array([first, 0, 0, 0, 0, second])
    commute = lambda a, b: matrix(a) @ matrix(b) - matrix(b) @ matrix(a)  # noqa: E731
    unit = np.eye(6)
    flow = np.array([vector(commute(e, inverse @ L) + commute(L, inverse @ e)) for e in unit]).T
    pfaffian = np.zeros((6, 6))
    for i, j, sign in ((0, 5, 1), (1, 4, -1), (2, 3, 1)):
        pfaffian[i, j] = pfaffian[j, i] = sign
    return flow, inverse @ L, inverse, [L, pfaffian @ L], [np.eye(6), pfaffian]


@pytest.mark.parametrize("spin", [(1.0, 0.4), (1.0, -2.0), (3.0, 0.1)])
def test_bodies_in_four_dimensions_against_exponents_from_mpmath(spin):
    for moments in ((1.0, 2.0, 3.0, 4.5), (3.0, 4.5, 1.0, 2.0), (1.0, 3.0, 2.0, 4.5)):
        matrices = so4_body(moments, *spin)
        with mpmath.workdps(40):
            exponents = mpmath.eig(mpmath.matrix(matrices[0].tolist()), left=False, right=False)
            exact = max(float(mpmath.re(x)) for x in exponents)
        found = energy_casimir(*matrices, ["½|L|²", "Pf"])
        assert len(found.spectrum) == 4
        assert (found.verdict == "unstable") == (exact > 1e-9)
        if found.verdict == "unstable":
            assert found.rate == pytest.approx(exact, rel=1e-11)


def test_singular_leaves():
    # L12 = L34 makes one of so(4)'s two spheres a point: dC1 and dC2 are parallel, do not span dH, yet nothing moves
    for moments in ((3.0, 4.5, 1.0, 2.0), (1.0, 3.0, 2.0, 4.5)):
        matrices = so4_body(moments, 1.0, 1.0)
        with pytest.raises(InvalidInput, match="singular"):
            energy_casimir(*matrices)
        found = energy_casimir(*matrices, is_equilibrium=True)
        with mpmath.workdps(40):
            exponents = mpmath.eig(mpmath.matrix(matrices[0].tolist()), left=False, right=False)
            exact = max(float(mpmath.re(x)) for x in exponents)
        assert found.verdict == ("unstable" if exact > 1e-9 else "undecided")
        assert found.rate == pytest.approx(exact, abs=1e-12)


def test_dependent_casimirs():
    # two spins aligned with equal lengths and no field between: λ keeps a freedom where S1 + S2 is conserved as well
    flow, gradient, hessian, gradients, hessians = spin_pair(1.0, 1.0, (0.0, 0.0), 1.0, 1.0)
    total = np.array([0, 0, 1.0, 0, 0, 1.0])
    assert energy_casimir(flow, gradient, hessian, gradients, hessians).verdict == "undecided"
    found = energy_casimir(flow, gradient, hessian, [*gradients, total], [*hessians, np.zeros((6, 6))])
    assert found.verdict == "stable"
    # the same Casimir twice, on another scale, changes nothing
    flow, gradient, hessian, gradients, hessians = free_body_matrices((1.0, 2.0, 3.0), 2, 2.0)
    for factor in (1e-30, 1e30):
        twice = np.vstack([gradients, factor * gradients]), np.concatenate([hessians, factor * hessians])
        assert energy_casimir(flow, gradient, hessian, *twice).verdict == "stable"


@pytest.mark.parametrize("ratio", [1e-12, 1e-30, 1e12])
@pytest.mark.parametrize("norm", [1e-200, 1e-100, 1.0, 1e100, 1e200])
def test_verdicts_do_not_depend_on_units(ratio, norm):
    moments = (ratio, 1.0, 1 / ratio)
    found = [energy_casimir(*free_body_matrices(moments, axis, norm)) for axis in range(3)]
    assert [x.verdict for x in found] == ["stable", "unstable", "stable"]
    assert found[1].rate == pytest.approx(axis_stability(moments, norm)[1].rate, rel=1e-12)


@pytest.mark.parametrize("seed", range(6))
def test_rounding_of_a_shear_is_no_exponent(seed):
    # a free coordinate beside an oscillator, in skew coordinates: rounding splits the double zero exponent to ±1e-8
    change = np.random.default_rng(seed).normal(size=(4, 4))
    back = np.linalg.inv(change)
    symplectic, hessian = np.block([[CANONICAL, NOTHING], [NOTHING, CANONICAL]]), np.diag([0.0, 1.0, 1.0, 1.0])
    matrices = change @ symplectic @ hessian @ back, np.zeros(4), back.T @ hessian @ back
    assert np.linalg.eigvals(matrices[0]).real.max() < 1e-5
    none = np.zeros((0, 4)), np.zeros((0, 4, 4))
    assert energy_casimir(*matrices, *none).verdict == "undecided"
    found = energy_casimir(*matrices, *none, on_equilibria=True)
    assert (found.verdict, found.rate, found.growth) == ("unstable", 0.0, "linear")
    along = change[:, 0] / np.linalg.norm(change[:, 0])
    assert abs(found.direction @ along) == pytest.approx(1.0, abs=1e-9)


def test_equilibria_beside_an_oscillator_do_not_shear():
    symplectic = np.block([[CANONICAL, NOTHING], [NOTHING, NOTHING]])
    hessian = np.diag([1.0, 1.0, 0.0, 0.0])
    found = energy_casimir(
        symplectic @ hessian, np.zeros(4), hessian, np.zeros((0, 4)), np.zeros((0, 4, 4)), on_equilibria=True
    )
    assert found.verdict == "undecided" and "without shear" in found.certificate


def test_definite_combinations_and_their_absence():
    rng = np.random.default_rng(5)
    for size, count in ((2, 2), (4, 3), (6, 4)):
        mix = rng.normal(size=(size, size))
        definite = mix @ mix.T + 0.01 * np.eye(size)
        others = [x + x.T for x in rng.normal(size=(count - 1, size, size))]
        # hidden: the first matrix is the definite one spoiled by the others
        family = np.array([definite - sum(k * x for k, x in enumerate(others, 1)), *others])
        family = family / np.abs(family).max(axis=(1, 2), keepdims=True)
        found = definite_combination(family, 1e-12)
        assert found is not None and np.linalg.eigvalsh(np.einsum("k,kij->ij", found, family))[0] > 0
    # traceless with respect to one density matrix: none can be definite
    density = np.diag([0.2, 0.3, 0.5])
    for _ in range(5):
        family = np.array([x + x.T for x in rng.normal(size=(3, 3, 3))])
        family = np.array([x - np.trace(density @ x) * np.eye(3) for x in family])
        assert definite_combination(family, 1e-12) is None


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


@pytest.mark.parametrize(("moments", "norm"), [
    ((1e-300, 1.0, 1e300), 1.0), ((1e-5, 2e-5, 3e-5), 1e305), ((1e300, 2e300, 3e300), 1e-300),
])  # fmt: skip
def test_axes_whose_rates_are_no_numbers_are_refused(moments, norm):
    with pytest.raises(InvalidInput, match="choose other units"):
        axis_stability(moments, norm)
