"""Molecules in specs: rotational constants, vibration, temperature."""

import numpy as np
import pytest
from scipy import constants

import polhode as ph
from polhode.errors import InvalidInput
from polhode.kinds.reading import read_spec

WATER = 'rotational_constants = ["27.8806 1/cm", "14.5216 1/cm", "9.2778 1/cm"]'
TAKEN = f"{WATER}\nallow_vibration = true"
UNIT = constants.physical_constants["atomic mass constant"][0] * 1e-20  # u Å² in kg m²


@pytest.fixture
def read(tmp_path):
    def reader(body, rest="", system=""):
        path = tmp_path / "case.toml"
        path.write_text(f"{system}\n[body]\n{body}\n{rest}")
        return read_spec(path)

    return reader


def test_water_as_measured(read):
    """Moments are 16.857629 u Å²/cm over the constants; the inertial defect of its ground state is +0.05 u Å²."""
    spec = read(TAKEN, "[time]\nsamples = 9")
    constants_per_cm = np.array([27.8806, 14.5216, 9.2778])
    assert spec.body.principal_moments / UNIT == pytest.approx(16.857629206 / constants_per_cm, rel=1e-8)
    assert spec.body.inertial_defect / UNIT == pytest.approx(0.0515, abs=5e-5)
    report = spec.report()
    assert "inertial defect I₃ − I₁ − I₂ is 0.05148 u Å²" in report.notes[0]
    assert report.values()["inertial_defect"] == spec.body.inertial_defect
    assert np.asarray(report.trajectory.attitude).shape == (9, 4)


def test_constants_may_be_frequencies(read):
    frequency = read('rotational_constants = ["100 GHz", "6e4 MHz", "4e10 Hz"]').body
    assert frequency.principal_moments == pytest.approx(
        constants.h / (8 * np.pi**2 * np.array([100e9, 60e9, 40e9])), rel=1e-14)  # fmt: skip
    assert not frequency.effective and frequency.inertial_defect < 0.0


def test_moments_of_no_rigid_body_need_the_word(read):
    with pytest.raises(InvalidInput, match=r"I1 \+ I2 ≥ I3; got .* set allow_vibration = true"):
        read(WATER)
    with pytest.raises(InvalidInput, match="I1 \\+ I2 ≥ 2/3 I3") as caught:
        read('rotational_constants = ["9 GHz", "9 GHz", "1 GHz"]\nallow_vibration = true')
    assert "allow_vibration" not in str(caught.value)


@pytest.mark.parametrize(
    ("body", "words"),
    [
        ('rotational_constants = ["1 rad/s", "1 GHz", "1 GHz"]', "names an angle"),
        ('rotational_constants = ["1 kg", "1 GHz", "1 GHz"]', 'like "27.88 1/cm" or "835.8 GHz"'),
        ('rotational_constants = ["-1 GHz", "1 GHz", "1 GHz"]', "must be positive"),
        ('rotational_constants = ["1 GHz", "1 GHz"]', "needs three quantities"),
        ('moments = ["1 kg*m^2", "1 kg*m^2", "1 kg*m^2"]\nallow_vibration = true', "goes with rotational_constants"),
    ],
)
def test_what_are_no_rotational_constants(read, body, words):
    with pytest.raises(InvalidInput, match=words):
        read(body)


def test_placing_and_combining_keep_that_moments_are_effective():
    water = ph.Body.from_rotational_constants(835.84e9, 435.35e9, 278.14e9, mass=3e-26, effective=True)
    turned = water.placed(ph.rotation.from_rotation_vector([0.3, 0.4, -0.5]), (1e-10, 0.0, 0.0))
    assert turned.effective and turned.inertial_defect == pytest.approx(water.inertial_defect, rel=1e-12)
    assert ph.combine([water]).effective and not ph.combine([ph.shapes.sphere(1.0, 1.0)]).effective
    assert ph.shapes.disk(1.0, 1.0).inertial_defect == 0.0  # flat, but for rounding
    with pytest.raises(InvalidInput, match="must be three positive finite"):
        ph.Body.from_rotational_constants(1e9, 0.0, 1e9)


@pytest.mark.parametrize(
    ("given", "kelvin"), [("300 K", 300.0), ("26.85 degC", 300.0), ("80.33 °F", 300.0), ("5 mK", 0.005)]
)
def test_a_temperature_is_three_halves_kt(read, given, kelvin):
    spec = read(TAKEN, f'[spin]\ntemperature = "{given}"\n[time]\nsamples = 5')
    report = spec.report()
    assert report.motion.energy == pytest.approx(1.5 * constants.k * kelvin, rel=1e-12)
    share = np.asarray(report.motion.momentum_at_epoch) ** 2 / report.motion.moments
    assert share == pytest.approx([constants.k * kelvin] * 3, rel=1e-12)
    assert any("classical thermal equilibrium" in note for note in report.notes)
    assert any("Quantum theory counts" in note for note in report.notes) == (kelvin < 1.0)


@pytest.mark.long
def test_other_kinds_say_it_too(read):
    system = '[system]\nkind = "damped-body"\ndamping = 0.1'
    report = read(TAKEN, '[spin]\ntemperature = "300 K"\n[time]\nuntil = "1 ps"\nsamples = 5', system).report()
    assert any("3/2 kT" in note for note in report.notes)


@pytest.mark.parametrize(
    ("spin", "words"),
    [
        ('temperature = "-300 degC"', "must be positive"), ('temperature = "0 K"', "must be positive"),
        ('temperature = "27 delta_degC"', "is a difference of temperatures"), ('temperature = 300', "unit in quotes"),
        ('temperature = "3 m"', "is not in K or alike"),
        ('temperature = "300 K"\nrate = "1 rpm"\nabout = 1', "exactly one of"),
        ('temperature = "300 K"\ntilt = "1 deg"', "go with rate, not with temperature"),
    ],
)  # fmt: skip
def test_what_is_no_temperature(read, spin, words):
    with pytest.raises(InvalidInput, match=words):
        read(TAKEN, f"[spin]\n{spin}")


def test_a_linear_molecule_is_refused_as_a_rod_is(tmp_path):
    (tmp_path / "co.xyz").write_text("2\n\nC 0 0 0\nO 0 0 1.128\n")
    (tmp_path / "case.toml").write_text('[body]\nmolecule = "co.xyz"\n[spin]\ntemperature = "300 K"\n')
    with pytest.raises(InvalidInput, match="of a linear molecule, `polhode body` gives the moments"):
        read_spec(tmp_path / "case.toml").report()
