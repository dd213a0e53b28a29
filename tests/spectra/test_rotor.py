"""Levels of rotors against closed forms, published levels, dense matrices and one another."""

import math

import numpy as np
import pytest

import polhode as ph
from polhode.errors import InvalidInput
from polhode.spectra import Rotor, spin_matrices
from spectra.molecules import FORMALDEHYDE, MHZ, SULFUR_DIOXIDE, WATER, WAVE_NUMBER, W, rotor

A, B, C = 27.0, 14.0, 9.0
REPRESENTATIONS = ["Ir", "Il", "IIr", "IIl", "IIIr", "IIIl"]
J4 = [215.2196213175, 217.9026589304, 266.6708334961, 291.0638514735, 305.8211613421, 372.0973410696, 373.3291665039,
      478.9361485265, 478.9592173404]  # fmt: skip
HELD = {(1, 0, 1): 23.7944, (1, 1, 1): 37.1371, (1, 1, 0): 42.3717, (2, 0, 2): 70.0908, (2, 1, 2): 79.4964,
        (2, 1, 1): 95.1759, (2, 2, 1): 134.9016, (2, 2, 0): 136.1639}  # fmt: skip


def test_levels_of_low_j_in_closed_form():
    s = A + B + C
    root = 2.0 * math.sqrt(A * A + B * B + C * C - A * B - B * C - A * C)
    assert np.sort(W.levels_of(1).energy) == pytest.approx([B + C, A + C, A + B], rel=1e-15)
    two = sorted([2 * s - root, s + 3 * C, s + 3 * B, s + 3 * A, 2 * s + root])
    assert W.levels_of(2).energy == pytest.approx(two, rel=1e-15)
    three = [4 * s]
    for sum_, x in ((5 * A + 5 * B + 2 * C, 4 * (A - B) ** 2 + (A - C) * (B - C)),
                    (5 * A + 2 * B + 5 * C, 4 * (A - C) ** 2 - (A - B) * (B - C)),
                    (2 * A + 5 * B + 5 * C, 4 * (B - C) ** 2 + (A - B) * (A - C))):  # fmt: skip
        three += [sum_ - 2.0 * math.sqrt(x), sum_ + 2.0 * math.sqrt(x)]
    assert W.levels_of(3).energy == pytest.approx(sorted(three), rel=2e-15)
    assert W.levels_of(4).energy == pytest.approx(J4, abs=1e-10)
    assert W.levels_of(4).symmetry == ["A", "Bc", "Bb", "Ba", "A", "Bc", "Bb", "Ba", "A"]


@pytest.mark.parametrize("J", [0, 5, 30])
def test_levels_are_those_of_the_dense_matrix(J):
    """Σ A_i S_i² of spin matrices knows nothing of Wang's basis."""
    x, y, z = spin_matrices(J)
    dense = np.linalg.eigvalsh(A * x @ x + B * y @ y + C * z @ z)
    assert W.levels_of(J).energy == pytest.approx(dense, rel=1e-13, abs=1e-12)


@pytest.mark.parametrize("representation", REPRESENTATIONS)
def test_all_representations_give_the_same_rigid_rotor(representation):
    other, ours = Rotor((A, B, C), {}, "A", representation).levels(9), W.levels(9)
    assert other.energy == pytest.approx(ours.energy, rel=1e-14)
    assert [other.Ka.tolist(), other.Kc.tolist()] == [ours.Ka.tolist(), ours.Kc.tolist()]


def test_distortion_is_that_of_its_operators():
    """The S reduction's terms as products of dense matrices, of which J₊⁴ and J₊⁶ are formed by multiplying."""
    J, names = 6, ["D_J", "D_JK", "D_K", "d1", "d2", "H_J", "H_JK", "H_KJ", "H_K", "h1", "h2", "h3"]
    values = dict(zip(names, 1e-3 * np.random.default_rng(2).normal(size=12), strict=True))
    x, y, z = spin_matrices(J)
    up, down, j, zz = x + 1j * y, x - 1j * y, J * (J + 1.0), z @ z
    ladder = [np.linalg.matrix_power(up, n) + np.linalg.matrix_power(down, n) for n in (0, 2, 4, 6)]
    one = np.eye(len(x))
    # I^r: x, y, z are b, c, a
    H = A * zz + B * x @ x + C * y @ y
    H = H - values["D_J"] * j * j * one - values["D_JK"] * j * zz - values["D_K"] * zz @ zz
    H = H + values["H_J"] * j**3 * one + values["H_JK"] * j * j * zz + values["H_KJ"] * j * zz @ zz
    H = H + values["H_K"] * zz @ zz @ zz + (values["d1"] * j + values["h1"] * j * j) * ladder[1]
    H = H + (values["d2"] + values["h2"] * j) * ladder[2] + values["h3"] * ladder[3]
    ours = Rotor((A, B, C), values, "S", "Ir").levels_of(J)
    assert np.sort(ours.energy) == pytest.approx(np.linalg.eigvalsh(H), rel=1e-12)
    reversed_ = dict(values, d2=-values["d2"])
    assert np.sort(Rotor((A, B, C), reversed_, "S", "Ir").levels_of(J).energy) != pytest.approx(
        np.linalg.eigvalsh(H), rel=1e-6)  # fmt: skip


def test_going_from_r_to_l_turns_the_sign_of_some_constants():
    odd = {"delta_J", "delta_K"}
    values = {"Delta_J": 1e-3, "Delta_JK": 2e-3, "Delta_K": -3e-3, "delta_J": 4e-4, "delta_K": 5e-4}
    rotated = {name: -value if name in odd else value for name, value in values.items()}
    ours, other = (Rotor((A, B, C), v, "A", r).levels(8) for v, r in ((values, "Ir"), (rotated, "Il")))
    assert other.energy == pytest.approx(ours.energy, rel=1e-14)
    assert other.Kc.tolist() == ours.Kc.tolist()


def test_levels_of_water():
    result = WATER.levels(2)
    for label, energy in HELD.items():
        assert result.of(*label) / WAVE_NUMBER == pytest.approx(energy, abs=7e-3)
    assert result.of(1, 0, 1) / WAVE_NUMBER == pytest.approx(23.79446251, abs=1e-8)
    assert result.of(2, 2, 0) / WAVE_NUMBER == pytest.approx(136.15770041, abs=1e-8)


def test_a_thousand_quanta():
    result = W.levels_of(1000)
    assert result.of(1000, 500, 500) == pytest.approx(15656936.925394869, rel=3e-15)
    assert np.all(np.diff(result.energy) > -1e-6)
    assert result.energy.sum() == pytest.approx((A + B + C) / 3.0 * 1000 * 1001 * 2001, rel=1e-14)


def test_splitting_of_doublets_of_a_slightly_asymmetric_rotor():
    """ΔE_K by perturbation theory in B − C."""
    b, c, J, K = 10.001, 9.999, 5, 3
    result = Rotor((A, b, c)).levels_of(J)
    wanted = (b - c) ** K * math.factorial(J + K) / (
        2 ** (4 * K - 3) * math.factorial(J - K) * (A - 0.5 * (b + c)) ** (K - 1) * math.factorial(K - 1) ** 2)
    assert result.of(J, K, J - K) - result.of(J, K, J - K + 1) == pytest.approx(wanted, rel=2e-2)


def test_symmetric_spherical_and_linear_limits():
    J, K = 7, np.array([0, 1, 1, 2, 2, 3, 3, 4, 4, 5, 5, 6, 6, 7, 7])
    assert Rotor((A, C, C)).levels_of(J).energy == pytest.approx(C * J * (J + 1) + (A - C) * K**2, rel=1e-14)
    assert Rotor((A, A, C)).levels_of(J).energy == pytest.approx(A * J * (J + 1) + (C - A) * K[::-1] ** 2, rel=1e-14)
    assert Rotor((A, A, A)).levels_of(J).energy == pytest.approx(np.full(15, A * J * (J + 1)), rel=1e-14)
    linear = Rotor((math.inf, B, B), {"D_J": 1e-3}, "S", "Ir")
    assert linear.levels(3).energy == pytest.approx([B * x - 1e-3 * x * x for x in (0, 2, 6, 12)], rel=1e-14)
    assert (Rotor((A, C, C)).kappa, Rotor((A, A, C)).kappa, Rotor((A, A, A)).kappa) == (-1.0, 1.0, None)


def test_constants_from_a_body():
    body = ph.Body.from_moments((1e-47, 1.9e-47, 2.9e-47), mass=3e-26)
    result = Rotor.from_body(body)
    assert result.constants == pytest.approx(8.392015881190e-36 / np.array([1e-47, 1.9e-47, 2.9e-47]), rel=1e-12)
    assert Rotor.from_body(ph.Body.from_moments((0.0, 1e-46, 1e-46), mass=3e-26)).is_linear


@pytest.mark.parametrize(
    ("make", "said"),
    [
        (lambda: Rotor((9.0, 14.0, 27.0)), "order A ≥ B ≥ C"), (lambda: Rotor((27.0, 14.0, -9.0)), "not negative"),
        (lambda: Rotor((0.0, 57635.96e6, 57635.96e6)), r"infinite A: write \(inf, 5\.7636e\+10, 5\.7636e\+10\)"),
        (lambda: Rotor((27.0, 14.0)), "three numbers"), (lambda: Rotor((27.0, np.nan, 9.0)), "finite"),
        (lambda: Rotor((math.inf, 14.0, 9.0)), "B = C"),
        (lambda: rotor((27.0, 14.0, 9.0), {"D_J": 1.0}), "`reduction`"),
        (lambda: rotor((27.0, 14.0, 9.0), {"D_J": 1.0}, "A", "Ir"), "A reduction"),
        (lambda: rotor((27.0, 14.0, 9.0), {"D_J": 1.0}, "S", "IVr"), "`representation`"),
        (lambda: rotor((27.0, 14.0, 9.0), {"D_J": math.inf}, "S", "Ir"), "finite number"),
        (lambda: W.levels(3, 4), "`j_min`"), (lambda: W.levels(-1), "whole"),
        (lambda: Rotor((27.0, 14.0, 9.0), spin_weights=(0, 0)), "`spin_weights`"),
        (lambda: Rotor((27.0, 14.0, 9.0), spin_axis="x"), "`spin_axis`"),
        (lambda: W.levels(1).of(2, 0, 2), "among those"),
    ],
)  # fmt: skip
def test_what_is_refused(make, said):
    with pytest.raises(InvalidInput, match=said):
        make()


def test_lines_of_formaldehyde_and_sulfur_dioxide():
    levels = FORMALDEHYDE.levels(2)
    for upper, lower, measured in (((1, 1, 0), (1, 1, 1), 4829.6599), ((1, 0, 1), (0, 0, 0), 72837.9492),
                                   ((2, 1, 2), (1, 1, 1), 140839.5176)):  # fmt: skip
        assert (levels.of(*upper) - levels.of(*lower)) / MHZ == pytest.approx(measured, abs=6e-5)
    levels = SULFUR_DIOXIDE.levels(3)
    assert (levels.of(3, 1, 3) - levels.of(2, 0, 2)) / MHZ == pytest.approx(104029.4102, abs=6e-5)
