"""Lines: strengths, sum rules, intensities as catalogues have them, partition functions."""

import math

import numpy as np
import pytest
from scipy import constants

from polhode.errors import InvalidInput
from polhode.spectra import DEBYE, Rotor
from spectra.molecules import FORMALDEHYDE, MHZ, WATER, W, rotor

KELVIN = constants.k / constants.h


def line(lines, upper, lower):
    result = np.flatnonzero((lines.upper == upper).all(axis=1) & (lines.lower == lower).all(axis=1))
    assert len(result) == 1
    return result[0]


def test_strengths_of_w():
    lines = W.lines(3)
    assert lines.strength[line(lines, (2, 2, 0), (1, 1, 1))] == pytest.approx(1.248547906400, rel=1e-12)
    assert lines.strength[line(lines, (2, 1, 1), (2, 0, 2))] == pytest.approx(2.080913177334, rel=1e-12)


@pytest.mark.parametrize("representation", ["Ir", "Il", "IIr", "IIIr", "IIIl"])
def test_strengths_from_a_level_add_up(representation):
    rotor = Rotor((27.0, 14.0, 9.0), {}, "A", representation, dipole=(0.3, 1.0, 0.5))
    lines, total = rotor.lines(8), {}
    for ends in (lines.upper, lines.lower):
        for end, strength in zip(map(tuple, ends.tolist()), lines.strength, strict=True):
            total[end] = total.get(end, 0.0) + strength
    assert all(value == pytest.approx((2 * J + 1) * 1.34, rel=1e-12) for (J, _, _), value in total.items() if J < 8)


def test_selection_rules():
    odd = {"a": (0, 1), "b": (1, 1), "c": (1, 0)}
    for k, axis in enumerate("abc"):
        lines = Rotor((27.0, 14.0, 9.0), dipole=np.eye(3)[k]).lines(6)
        change = (lines.upper - lines.lower) % 2
        assert (change[:, 1:] == odd[axis]).all() and (np.abs(lines.upper[:, 0] - lines.lower[:, 0]) <= 1).all()


def test_intensities_of_formaldehyde():
    lines = FORMALDEHYDE.lines(2, 300.0)
    for upper, lower, wanted in (((1, 1, 0), (1, 1, 1), -5.9024), ((1, 0, 1), (0, 0, 0), -4.1792),
                                 ((2, 1, 2), (1, 1, 1), -2.9775)):  # fmt: skip
        assert math.log10(lines.intensity[line(lines, upper, lower)] * 1e12) == pytest.approx(wanted, abs=6e-5)
    k = line(lines, (2, 1, 2), (1, 1, 1))
    wanted = 1.163965404e-20 * (lines.frequency[k] / MHZ) ** 3 * lines.strength[k] / DEBYE**2 / 5
    assert lines.einstein[k] == pytest.approx(wanted, rel=1e-8)


def test_partition_functions():
    assert W.partition_function(208.5104401458 / KELVIN) == pytest.approx(92.829263464996, rel=1e-12)
    ortho_para = Rotor(W.constants, spin_weights=(1, 3)).partition_function(208.5104401458 / KELVIN)
    assert ortho_para == pytest.approx(139.243895197494 + 46.414631732498, rel=1e-11)
    temperatures = np.array([300.0, 150.0, 75.0, 37.5, 18.75, 9.375])
    jpl = [2.2507, 1.8040, 1.3649, 0.9335, 0.4819, 0.0994]
    assert np.log10(WATER.partition_function(temperatures)) == pytest.approx(jpl, abs=2e-3)
    rigid = rotor(np.array(WATER.constants) / MHZ, spin_weights=(1, 3))
    assert math.log10(rigid.partition_function(300.0)) == pytest.approx(2.2474, abs=5e-5)


def test_partition_function_at_high_temperature():
    """Stripp & Kirkwood's series, and the linear rotor's."""
    A, B, C = 27.0, 14.0, 9.0
    beta = 1e-4
    first = beta / 12.0 * (2.0 * (A + B + C) - A * B / C - B * C / A - C * A / B)
    wanted = math.sqrt(math.pi / (A * B * C * beta**3)) * (1.0 + first)
    assert W.partition_function(1.0 / beta / KELVIN) == pytest.approx(wanted, rel=1e-5)
    x = 50.0
    linear = Rotor((math.inf, B, B)).partition_function(x * B / KELVIN)
    assert linear == pytest.approx(x + 1 / 3 + 1 / (15 * x) + 4 / (315 * x * x), rel=1e-7)


def test_distortion_that_runs_away_is_told():
    wild = rotor((27e3, 14e3, 9e3), {"D_J": 100.0}, "S", "Ir")
    with pytest.warns(UserWarning, match="levels fall from J"):
        wild.partition_function(1000.0)


@pytest.mark.parametrize(
    ("call", "said"),
    [(lambda: Rotor((27.0, 14.0, 9.0)).lines(2), "`dipole` must not be zero"),
     (lambda: W.lines(2, -3.0), "`temperature`"),
     (lambda: Rotor((math.inf, 14.0, 14.0), dipole=(0, 1, 0)).lines(2), "along a"),
     (lambda: Rotor((27.0, 14.0, 0.0)).partition_function(3.0), "C = 0")],
)  # fmt: skip
def test_what_is_refused(call, said):
    with pytest.raises(InvalidInput, match=said):
        call()


def test_lines_of_a_linear_molecule():
    carbon_monoxide = Rotor((math.inf, 57.6e9, 57.6e9), dipole=(0.11 * DEBYE, 0.0, 0.0))
    lines = carbon_monoxide.lines(3, 300.0)
    assert lines.frequency == pytest.approx(2.0 * 57.6e9 * np.arange(1, 4), rel=1e-14)
    assert lines.strength / (0.11 * DEBYE) ** 2 == pytest.approx([1.0, 2.0, 3.0])


@pytest.mark.parametrize(("constants", "dipole"), [
    ((9e9, 3e9, 3e9), (1e-30, 0.0, 0.0)), ((9e9, 9e9, 3e9), (0.0, 0.0, 1e-30)), ((9e9, 9e9, 9e9), (0.0, 0.0, 1e-30)),
])  # fmt: skip
def test_lines_of_symmetric_tops(constants, dipole):
    """ΔK = 0 along the figure axis: ν = 2B(J + 1), and nothing that only rounding allows; S = ((J+1)² − K²)/(J+1)."""
    result = Rotor(constants, dipole=dipole).lines(8)
    B = constants[1]
    assert result.frequency == pytest.approx(2.0 * B * result.upper[:, 0], rel=1e-12)
    assert (result.upper[:, 0] == result.lower[:, 0] + 1).all()
    for J in range(8):
        own = result.strength[result.lower[:, 0] == J].sum() / 1e-60
        assert own == pytest.approx(sum(((J + 1) ** 2 - K * K) / (J + 1) for K in range(-J, J + 1)), rel=1e-10)
