"""Reports on ideal fluids on a sphere: waves in closed form, starts, restarts, and what is refused."""

import json
import re
from dataclasses import replace

import numpy as np
import pytest

from polhode.errors import InvalidInput
from polhode.fields.sphere_fluid import answers
from polhode.fields.sphere_fluid.panel import SphereFluidPanel
from polhode.formats.dataset import write_dataset
from polhode.kinds.reading import read_spec
from polhode.viewer.samples import take_samples


@pytest.fixture
def spec(tmp_path):
    def make(system, until="1 s", samples=5):
        path = tmp_path / "case.toml"
        time = f'[time]\nuntil = "{until}"\nsamples = {samples}\n'
        path.write_text(f'[system]\nkind = "sphere-fluid"\n{system}\n{time}', "utf-8")
        return read_spec(path)

    return make


@pytest.mark.sweep
def test_a_planetary_wave_turns_as_rossby_and_haurwitz_say(spec):
    """Y of degree l at rest against a sphere with Ω: c = −2Ω/(l(l + 1)), whatever its amplitude."""
    text = 'resolution = 8\nrotation = "1.3 rad/s"\nwaves = [{degree = 5, order = 3, vorticity = "0.7 rad/s"}]'
    report = spec(text, "50 ms", 41).report()
    result = np.asarray(report.system.to_harmonics(report.trajectory.states[[0, -1]]))[:, 5, 3]
    assert abs(result[0]) == pytest.approx(0.7 * np.sqrt(2.0 * np.pi), rel=1e-12)
    rotated = -np.angle(result[1] / result[0]) / (3 * 0.05)
    assert rotated == pytest.approx(-2.6 / 30.0, rel=1e-6)
    values = report.as_json_dict()
    assert values["vorticity"] == pytest.approx(0.7, rel=1e-12)
    assert values["rossby_number"] == pytest.approx(0.7 / 2.6, rel=1e-12)
    assert values["spectrum"][4]["start"] == pytest.approx(values["energy"], rel=1e-12)


@pytest.mark.long
def test_random_starts_have_their_vorticity_and_vortices_their_circulation(spec):
    report = spec('resolution = 6\nradius = "2 m"\nrandom = {degrees = [2, 4], vorticity = "3 rad/s"}', "1 ms").report()
    assert report.as_json_dict()["vorticity"] == pytest.approx(3.0, rel=1e-12)
    assert np.ptp(report.energies[0, 2:5]) < 1e-12 * report.energies[0, 2]
    report = spec('resolution = 6\nradius = "2 m"\nvortices = [{strength = "6 m^2/s", latitude = "90 deg"}]',
                  "1 ms").report()  # fmt: skip
    momentum = report.as_json_dict()["angular_momentum"]  # Γ/R² times ⟨x₃⟩ of the smallest blob, 1 − 1/N nearly
    assert momentum[2] == pytest.approx(1.5 * np.sqrt((6 - 1) / (6 + 1)), rel=1e-12) and abs(momentum[0]) < 1e-14


SPAN = "0.5 s"  # its quarters are exact numbers, so that all steps are of one size


@pytest.mark.long
def test_a_run_goes_on_from_its_file(spec, tmp_path):
    text = 'resolution = 6\nrandom = {degrees = [2, 3], vorticity = "1 rad/s"}'
    whole, half = spec(text, "1 s", 5).report(), spec(text, SPAN, 3).report()
    write_dataset(half.trajectory, tmp_path / "motion.nc")
    again = spec('resolution = 6\nstart_from = "motion.nc"', SPAN, 3).report()
    assert np.array_equal(again.trajectory.states[-1], whole.trajectory.states[-1])
    forgetful = replace(half.trajectory, memory=None)
    write_dataset(forgetful, tmp_path / "motion.nc")
    again = spec('resolution = 6\nstart_from = "motion.nc"', SPAN, 3).report()
    assert 0.0 < np.abs(again.trajectory.states[-1] - whole.trajectory.states[-1]).max() < 1e-15
    with pytest.raises(InvalidInput, match="fluid of resolution 7"):
        spec('resolution = 7\nstart_from = "motion.nc"').report()


@pytest.mark.long
@pytest.mark.long
def test_large_matrices_keep_fewer_samples(spec, monkeypatch):
    monkeypatch.setattr(answers, "LIMITS", answers.LIMITS._replace(max_state_bytes=16 * 36 * 3))
    report = spec('resolution = 6\nrandom = {degrees = [2, 3], vorticity = "1 rad/s"}', "10 ms", 9).report()
    assert len(report.trajectory.times) == 3 and any("3 of 9 samples" in note for note in report.notes)


@pytest.mark.long
def test_maps_of_the_page_are_those_of_the_fluid(spec):
    report = spec('resolution = 6\nwaves = [{degree = 3, order = 0, vorticity = "1 rad/s"}]', "10 ms").report()
    (panel,) = SphereFluidPanel().panels(report.trajectory, take_samples(report.trajectory), None)
    assert panel["levels"]["kind"] == "u1" and panel["levels"]["shape"][1:] == [panel["rows"], panel["columns"]]
    assert panel["largest"] == pytest.approx(np.sqrt(7.0), rel=0.05)  # √7 P₃ is largest at the pole
    assert json.dumps(panel)


RANDOM = 'random = {degrees = [2, 3], vorticity = "1 rad/s"}'


@pytest.mark.parametrize(("system", "words"), [
    ("resolution = 6", "needs a start: random, vortices and waves"),
    (f'resolution = 6\n{RANDOM}\nstart_from = "a.nc"', "start_from: goes without random"),
    ("resolution = 3\n" + RANDOM, "resolution"),
    ("resolution = 600\n" + RANDOM, "resolution"),
    (RANDOM, "give the size of the matrices"),
    ('resolution = 6\nrandom = {degrees = [2, 6], vorticity = "1 rad/s"}', "stay below the resolution, 6"),
    ('resolution = 6\nrandom = {degrees = [4, 2], vorticity = "1 rad/s"}', "must ascend"),
    ('resolution = 6\nwaves = [{degree = 2, order = 3, vorticity = "1 rad/s"}]', "order ≤ degree"),
    ('resolution = 6\nwaves = [{degree = 2, order = 1}]', "vorticity"),
    ('resolution = 6\nwaves = [{degree = 2, order = 1, vorticity = "0 rad/s"}]', "vorticity: must not be zero"),
    ('resolution = 6\nvortices = [{strength = "1 m^2/s", latitude = "100 deg"}]', "must lie from -90 to 90 deg"),
])  # fmt: skip
def test_what_is_refused(spec, system, words):
    with pytest.raises(InvalidInput, match=re.escape(words)):
        spec(system)


@pytest.mark.parametrize("size", ["1e-200", "1e200"])
def test_vorticities_beyond_the_numbers(spec, size):
    with pytest.raises(InvalidInput, match="must be zero or, in SI units, of a size from"):
        spec(f'resolution = 6\nwaves = [{{degree = 2, order = 1, vorticity = "{size} rad/s"}}]').report()


def test_a_file_that_is_missing(spec):
    with pytest.raises(InvalidInput, match="nothing"):
        spec('resolution = 6\nstart_from = "nothing.nc"').report()
