"""Molecules as specs tell them: constants, levels, lines, and what classical motion has to do with them."""

import json
from pathlib import Path

import numpy as np
import pytest

from polhode.cli.export import gather_content
from polhode.cli.main import main
from polhode.errors import InvalidInput
from polhode.formats.form import Content
from polhode.formats.form_registry import forms
from polhode.kinds.base import AbstractKind, Spec
from polhode.kinds.reading import read_spec
from polhode.kinds.registry import next_steps
from polhode.reports.base import SystemReport
from polhode.spec.models import SystemTable
from polhode.spectra import level_diagram, read_par, spectrum
from polhode.spectra._level_polhodes import level_polhodes
from polhode.spectra.figures.level_curves import level_curves
from polhode.spectra.rotor import Rotor
from polhode.spectra.spec_rotors import complete_rotor, molecule_to_write, rotor_of_spec

EXAMPLES = Path(__file__).parents[2] / "examples"
MHZ, WAVE_NUMBER = 1e6, 29979.2458e6
WATER = """[system]
kind = "quantum-rotor"
constants = ["835840.288 MHz", "435351.717 MHz", "278138.700 MHz"]
j_max = 3
"""


@pytest.fixture
def spec_of(tmp_path):
    def read(text):
        (tmp_path / "case.toml").write_text(text)
        return read_spec(tmp_path / "case.toml")

    return read


def test_units_of_energy_are_one(spec_of):
    """Wave numbers are converted by hc: 1 cm⁻¹ is 29979.2458 MHz."""
    in_waves = [f"{x / 29979.2458!r} cm^-1" for x in (835840.288, 435351.717, 278138.700)]
    text = f'[system]\nkind = "quantum-rotor"\nj_max = 3\nconstants = {json.dumps(in_waves)}\n'
    one, other = spec_of(WATER).report(), spec_of(text).report()
    assert np.allclose(one.rotor.constants, other.rotor.constants, rtol=1e-15, atol=0.0)
    assert one.rotor.constants[0] == 835840.288e6


def test_levels_and_missing_levels():
    water = read_spec(EXAMPLES / "water_spectrum.toml").report()
    assert water.levels.of(1, 0, 1) / WAVE_NUMBER == pytest.approx(23.79446251, abs=1e-8)
    assert any("levels fall from J = 26 to 27" in note for note in water.notes)
    dioxide = read_spec(EXAMPLES / "sulfur_dioxide.toml").report()
    assert set(dioxide.levels.weight[dioxide.levels.J == 1]) == {0.0, 1.0}
    line = np.flatnonzero((dioxide.lines.upper == (3, 1, 3)).all(1) & (dioxide.lines.lower == (2, 0, 2)).all(1))
    assert dioxide.lines.frequency[line] / MHZ == pytest.approx([104029.4102], abs=1e-4)


def test_a_geometry_has_isotopes(spec_of):
    """Constants of water.xyz with the masses of H-1 and O-16; standard weights would give 150 MHz less."""
    text = f'[system]\nkind = "quantum-rotor"\n[body]\nmolecule = "{(EXAMPLES / "water.xyz").as_posix()}"\n'
    result = spec_of(text).report().rotor.constants
    assert np.array(result) / MHZ == pytest.approx([822482.650, 437589.911, 285626.495], abs=1e-3)  # by hand
    assert rotor_of_spec(spec_of(text)).rotor.constants == result


def test_body_and_constants_agree(spec_of):
    """Rotational constants of [body] are the rotor's, though no rigid body has their inertial defect."""
    steam = read_spec(EXAMPLES / "steam.toml")
    rotor = rotor_of_spec(steam).rotor
    assert np.array(rotor.constants) / WAVE_NUMBER == pytest.approx([27.8806, 14.5216, 9.2778], rel=1e-14)


def test_classical_and_quantum_name_each_other(spec_of):
    classical = read_spec(EXAMPLES / "water.toml")
    assert [step.command for step in next_steps(classical)] == ["view", "levels"]
    assert [step.command for step in next_steps(read_spec(EXAMPLES / "book.toml"))] == ["view"]
    back = spec_of(WATER).report().notes[-1]
    assert "rotational_constants under [body]" in back and "classical motion" in back


def test_steps_are_turns_of_classical_motion():
    """2π/T at the energy between two levels of a ladder: to 9e-5 and 1.3e-5 at J = 100."""
    result = level_polhodes((27.0, 14.0, 9.0), 100)
    ratio = result.step / result.classical_step
    top = np.flatnonzero((result.Ka == 95) & (result.Kc == 5))[0]
    assert abs(ratio[top] - 1.0) < 2e-5
    middle = np.flatnonzero((result.Ka == 52) & (result.Kc == 48))[0]
    assert abs(ratio[middle] - 1.0) < 2e-4
    assert result.saddle == pytest.approx(14.0 * 100.5**2 - 0.25 * 8.982, rel=1e-14)  # 8.982 J(J + 1) is all levels'
    assert (result.above == (result.energy > result.saddle)).all()
    assert np.isnan(result.step[-2:]).all() and np.abs(result.semiclassical - result.energy).max() < 1e-3


RUNAWAY = (EXAMPLES / "sulfur_dioxide.toml").read_text().replace('"2.5904328 MHz"', '"{}"')


@pytest.mark.sweep
@pytest.mark.parametrize("large", ["2.5904328 GHz", "1e3 GHz"])
def test_a_distortion_constant_in_another_unit_is_said(spec_of, large):
    """Levels far below the ground state had infinite intensities, which ended in a traceback inside the spectrum."""
    report = spec_of(RUNAWAY.format(large) + "\n").report()
    first = {"2.5904328 GHz": 5, "1e3 GHz": 1}[large]
    assert sum(f"from J = {first} on levels lie below the ground state" in note for note in report.notes) == 1
    assert np.isfinite(report.lines.intensity).all() and 0.0 < report.values()["share_of_most_populated"] <= 1.0
    for drawn in (spectrum(report.lines), level_diagram(report.rotor, 20)):
        if drawn is not None:  # no line is left of those of the larger
            drawn.canvas.draw()


def test_a_distortion_constant_in_its_unit_is_not_doubted(spec_of):
    assert not any("below the ground" in note for note in spec_of(RUNAWAY.format("2.59 MHz")).report().notes)


ALONG_B = 'constants = ["60 GHz", "10 GHz", "9 GHz"]\ndipole = ["0 D", "1 D", "0 D"]\n'


@pytest.mark.long_after(3)
@pytest.mark.parametrize(("text", "said"), [
    (ALONG_B + 'spin_axis = "a"', "the dipole over along b"), (ALONG_B + 'spin_axis = "b"', None),
    ('constants = ["11 GHz"]\nspin_axis = "a"', "of a linear molecule"),
    ('spin_axis = "b"\n[body]\nmolecule = "WATER"', None),
    ('spin_axis = "a"\n[body]\nmolecule = "WATER"', "atoms where none of their kind"),
    ('spin_axis = "c"\n[body]\nmolecule = "ocs.xyz"', "atoms where none of their kind"),
    ('spin_axis = "c"\n[body]\nmolecule = "co2.xyz"', None),
])  # fmt: skip
def test_weights_about_an_axis_that_no_symmetry_has_are_noted(spec_of, tmp_path, text, said):
    (tmp_path / "ocs.xyz").write_text("3\n\nO 0 0 -1.6797\nC 0 0 -0.5217\nS 0 0 1.0391\n")
    (tmp_path / "co2.xyz").write_text("3\n\nO 0 0 -1.16\nC 0 0 0\nO 0 0 1.16\n")
    text = text.replace("WATER", (EXAMPLES / "water.xyz").as_posix())
    spec = spec_of(f'[system]\nkind = "quantum-rotor"\nj_max = 3\nspin_weights = [1.0, 3.0]\n{text}\n')
    notes = [note for note in spec.report().notes if "is no symmetry of this molecule" in note]
    assert len(notes) == (said is not None) and (said is None or said in notes[0])


@pytest.mark.long
def test_symmetric_and_linear_molecules(spec_of):
    """Nothing of polhodes is said where they are circles; a linear molecule has one constant."""
    linear = spec_of('[system]\nkind = "quantum-rotor"\nconstants = ["57.635968 GHz"]\n').report()
    assert linear.rotor.is_linear and linear.summary.startswith("A linear molecule") and linear.polhodes is None
    assert linear.partition == pytest.approx(300.0 * 20836.6191233 / 57635.968 + 1 / 3, rel=1e-4)
    for constants, words in ((["9 GHz", "3 GHz", "3 GHz"], "prolate"), (["9 GHz", "9 GHz", "3 GHz"], "oblate"),
                             (["9 GHz"] * 3, "spherical")):  # fmt: skip
        text = f'[system]\nkind = "quantum-rotor"\nj_max = 2\nconstants = {json.dumps(constants)}\n'
        assert words in spec_of(text).report().summary


@pytest.mark.long
def test_a_flip(spec_of):
    """Answers in seconds of constants in Hz: a rate of 4π(J + ½)√((A − B)(B − C))."""
    system = '[system]\nkind = "quantum-rotor"\nconstants = ["27 GHz", "14 GHz", "9 GHz"]\nj_max = 2\nj = 25\n'
    on_axis = spec_of(system + "racket = {}\n").report().values()["racket"]
    assert on_axis["rate"] == pytest.approx(4e9 * np.pi * 25.5 * np.sqrt(65.0), rel=1e-14)
    assert on_axis["half_time"] * on_axis["rate"] == pytest.approx(2.248491392218925, rel=1e-12)
    assert on_axis["period"] is None and on_axis["revival_time"] is None
    beside = spec_of(system + 'racket = { tilt = "15 deg" }\n').report().values()["racket"]
    assert 0.0 < beside["first_reversal"]["time"] < beside["period"] < beside["revival_time"]
    with pytest.raises(InvalidInput, match=r"system\.racket\.tilt: must be from 0 to 85 deg; got 100 deg"):
        spec_of(system + 'racket = { tilt = "100 deg" }\n')


@pytest.mark.parametrize(("text", "said"), [
    ('[system]\nkind = "quantum-rotor"\n', "system.constants: is missing"),
    (WATER + '[body]\nmoments = ["1 kg*m^2", "1 kg*m^2", "1 kg*m^2"]\n', r"leave one out"),
    (WATER + '[spin]\nrate = "1 rpm"\nabout = 1\n', r"spin: does not go with the system quantum-rotor"),
    (WATER + '[system.distortion]\nDelta_J = "1 MHz"\n', r"(?s)system.reduction: is missing.*representation"),
    (WATER.replace("278138.700 MHz", "-278138.700 MHz"), r"has 1 mistake:\n  system\.constants\.3: must be positive"),
    (WATER.replace("278138.700 MHz", "0 MHz"), r"has 1 mistake:\n  system\.constants\.3: must be positive"),
    (WATER.replace("835840.288 MHz", "835840.288 rpm"), "names an angle"),
    (WATER.replace('"835840.288 MHz", ', ""), "needs three constants"),
    (WATER + "spin_axis = 'd'\n", 'must be one of "a", "b", "c"'),
    (WATER + "dipole = ['1 kg', '0 D', '0 D']\n", "has the wrong unit"),
    (WATER.replace("j_max = 3", "j_max = 1001"), "must be at most 1000"),
])  # fmt: skip
def test_mistakes(spec_of, text, said):
    with pytest.raises(InvalidInput, match=said):
        spec_of(text)


def test_wrong_order_is_said_with_its_file(spec_of, tmp_path, capsys):
    spec_of(WATER.replace('"835840.288 MHz", "435351.717 MHz"', '"435351.717 MHz", "835840.288 MHz"'))
    with pytest.raises(SystemExit, match="2"):
        main(["report", str(tmp_path / "case.toml")])
    assert "case.toml: `constants` must be in the order" in capsys.readouterr().err
    assert not (Path("case")).exists()


@pytest.mark.parametrize(("old", "new", "said"), [
    ("j_max = 3", 'temperature = "1e9 K"', "levels up to J = .* count, and sums go to 600"),
    ('"835840.288 MHz"', '"1e25 Hz"', "constants must be below 1e.20 Hz"),
    ("j_max = 3", "spin_weights = [0.0, 0.0]", "not all zero"),
    ("j_max = 3", "racket = {}\nj = 0", "`J` must be a whole number from 1"),
])  # fmt: skip
def test_what_cannot_be_summed_is_refused(spec_of, old, new, said):
    with pytest.raises(InvalidInput, match=said):
        spec_of(WATER.replace(old, new)).report()


@pytest.mark.parametrize("constants", [
    ["27 GHz", "14.0000000001 GHz", "14 GHz"], ["27 GHz", "14 GHz", "14 GHz"], ["27 GHz", "27 GHz", "9 GHz"],
    ["14 GHz"],
])  # fmt: skip
@pytest.mark.parametrize("j", [0, 3])
def test_diagrams_of_any_molecule(spec_of, constants, j):
    text = f'[system]\nkind = "quantum-rotor"\nj_max = 3\ntemperature = "3 K"\nconstants = {json.dumps(constants)}\n'
    report = spec_of(f"{text}j = {j}\n").report()
    assert report.as_json_dict()["notes"]
    assert level_diagram(report.rotor, report.J).axes[0].get_ylim()[1] > 0.0
    assert (report.polhodes is None) == (not list(_curves(report)))


def _curves(report):
    """Polhodes as unit vectors, where the molecule has three different constants."""
    if report.polhodes is not None:
        for level in level_curves(report.rotor, report.J):
            assert np.linalg.norm(level.unit, axis=-1) == pytest.approx(1.0, abs=1e-12)
            yield level


@pytest.mark.parametrize(("constants", "said", "commands"), [
    ('["9 GHz", "9 GHz", "4 GHz"]', "An oblate symmetric top", ["view", "levels"]),
    ('["9 GHz", "4 GHz", "4 GHz"]', "A prolate symmetric top", ["view", "levels"]),
    ('["9 GHz", "9 GHz", "9 GHz"]', "A spherical top", ["levels"]),
    ('["9 GHz"]', "A linear molecule", ["levels"]),
])  # fmt: skip
def test_a_page_is_offered_where_something_moves(spec_of, constants, said, commands):
    spec = spec_of(f'[system]\nkind = "quantum-rotor"\nconstants = {constants}\ntemperature = "10 K"\nj_max = 3\n')
    assert spec.report().summary.startswith(said)
    assert [step.command for step in spec.kind.next_steps(spec)] == commands


class Other(AbstractKind):
    """A kind of another package, without motion, whose report has data and whose specs describe a rotor."""

    name, table, has_motion = "other", SystemTable, False

    def report(self, spec):
        return OtherReport()

    def rotor(self, spec):
        return complete_rotor(Rotor((27e9, 14e9, 9e9)), 10.0, 2)


class OtherReport(SystemReport):
    kind, summary, answers = "other", "Here.", ()

    def _write_data(self, path):
        path.write_bytes(b"data of others")
        return path


def test_what_does_not_move_of_others_is_exported(tmp_path):
    """NetCDF has the data of the report, whatever they are; formats of molecules ask the kind for its rotor."""
    spec = Spec("one", Other(), SystemTable(kind="other"), None, None, None, 2)
    content = gather_content(spec, spec.report())
    assert forms()["netcdf"].save(content, tmp_path / "a.nc").read_bytes() == b"data of others"
    assert read_par(forms()["par"].save(content, tmp_path / "a.par")).rotor().constants == (27e9, 14e9, 9e9)
    molecule = molecule_to_write(content)
    assert len(molecule.levels().energy) == 9 and molecule.lines() is None  # 1 + 3 + 5 to J = 2
    with pytest.raises(InvalidInput, match="a motion is not a molecule with rotational constants"):
        molecule_to_write(Content("a motion", None))
    with pytest.raises(InvalidInput, match="a motion has no motion to write"):
        forms()["netcdf"].save(Content("a motion", None), tmp_path / "b.nc")
