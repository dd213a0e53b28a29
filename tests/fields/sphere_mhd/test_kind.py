"""Reports on conducting fluids on a sphere: exact waves, growth, restarts, maps, and what is refused."""

import json
import re

import numpy as np
import pytest

from polhode.errors import InvalidInput
from polhode.fields.sphere_mhd.panel import SphereMHDPanel
from polhode.formats.dataset import write_dataset
from polhode.kinds.reading import read_spec
from polhode.viewer.samples import take_samples
from sweeping import first

RANDOM = 'random = {degrees = [2, 3], vorticity = "2 rad/s"}\nrandom_field = {degrees = [1, 2], field = "0.3 rad/s"}'
WAVE = 'alfven_wave = {degree = 3, order = 2, vorticity = "1 rad/s", turning = "0.5 rad/s", field = "0.6 rad/s"'
# angular velocity 1 − μ² and field μ sin θ/2, of Gilman and Fox, with a small wave
JOINT = """
waves = [{degree = 1, order = 0, vorticity = "0.9237604307 rad/s"},
         {degree = 3, order = 0, vorticity = "-0.6047431568 rad/s"},
         {degree = 2, order = 1, vorticity = "1e-6 rad/s"}]
field_waves = [{degree = 2, order = 0, field = "-0.1825741858 rad/s"}]"""


@pytest.fixture
def spec(tmp_path):
    def make(system, until="20 ms", samples=5):
        path = tmp_path / "case.toml"
        time = f'[time]\nuntil = "{until}"\nsamples = {samples}\n'
        path.write_text(f'[system]\nkind = "sphere-mhd"\n{system}\n{time}', "utf-8")
        return read_spec(path)

    return make


@pytest.mark.sweep
@pytest.mark.parametrize(("branch", "speed"), first(1, [("eastward", 0.6835801927), ("westward", -0.4419135261)]))
def test_an_exact_wave_goes_round_as_it_should(spec, branch, speed):
    report = spec(f'resolution = 6\nrotation = "1.3 rad/s"\n{WAVE}, branch = "{branch}"}}').report()
    result = report.as_json_dict()
    assert result["wave_speed"] == pytest.approx(speed, abs=1e-10)
    assert result["wave_speed_in_run"] == pytest.approx(speed, rel=1e-4)
    wave = np.abs(np.asarray(report.system.to_harmonics(report.trajectory.states))[:, 1, 3, 2])
    assert wave[0] == pytest.approx(np.sqrt(2.0 * np.pi), rel=1e-12) and np.ptp(wave) < 1e-6 * wave[0]


@pytest.mark.long
def test_random_starts_have_their_sizes_and_orders_have_the_energy(spec):
    report = spec(f"resolution = 6\n{RANDOM}").report()
    result = report.as_json_dict()
    assert result["vorticity"] == pytest.approx(2.0, rel=1e-12) and result["field"] == pytest.approx(0.3, rel=1e-12)
    assert result["magnetic_energy"] == pytest.approx(0.5 * 4.0 * np.pi * 0.09, rel=1e-12)
    np.testing.assert_allclose(report.energies_by_order.sum(axis=1), report.energies.sum(axis=(1, 2)), rtol=1e-12)
    assert result["spectrum_change"] < 5e-15 and result["mixed_change"] < 3e-15


@pytest.mark.sweep
def test_a_wave_grows_as_linear_theory_says(spec):
    (row, *others) = spec(f"resolution = 8\n{JOINT}", "30 s", 31).report().as_json_dict()["zonal_growth"]
    assert row["linear"] == pytest.approx(0.1218741338, rel=0.05)
    assert row["run"] == pytest.approx(row["linear"], rel=0.07)
    assert [other["run"] for other in others] == [None, None]


@pytest.mark.long
def test_a_run_goes_on_from_its_file(spec, tmp_path):
    span, text = "0.5 s", f"resolution = 6\n{RANDOM}"
    whole, half = spec(text, "1 s", 5).report(), spec(text, span, 3).report()
    write_dataset(half.trajectory, tmp_path / "motion.nc")
    again = spec('resolution = 6\nstart_from = "motion.nc"', span, 3).report()
    assert np.array_equal(again.trajectory.states[-1], whole.trajectory.states[-1])
    with pytest.raises(InvalidInput, match="conducting fluid of resolution 7"):
        spec('resolution = 7\nstart_from = "motion.nc"').report()


@pytest.mark.long
def test_maps_of_the_page_are_those_of_the_fluid(spec):
    report = spec('resolution = 6\nfield_waves = [{degree = 2, order = 0, field = "1 rad/s"}]').report()
    vorticity, current = SphereMHDPanel().panels(report.trajectory, take_samples(report.trajectory), None)
    assert current["largest"] == pytest.approx(np.sqrt(6.0 * 5.0), rel=0.05)  # √5 √6 P₂ is largest at the pole
    assert vorticity["largest"] == 1.0 and json.dumps([vorticity, current])


@pytest.mark.parametrize(("system", "words"), [
    ("resolution = 6", "needs a start: random, waves, random_field and field_waves"),
    (f'resolution = 6\n{RANDOM}\nstart_from = "a.nc"', "start_from: goes without random and random_field"),
    (f"resolution = 6\n{RANDOM}\n{WAVE}}}", "alfven_wave: goes without random and random_field"),
    ("resolution = 300\n" + RANDOM, "resolution"),
    ('resolution = 6\nrandom_field = {degrees = [2, 6], field = "1 rad/s"}', "stay below the resolution, 6"),
    ('resolution = 6\nfield_waves = [{degree = 2, order = 3, field = "1 rad/s"}]', "order ≤ degree"),
    ('resolution = 6\nfield_waves = [{degree = 2, order = 1}]', "field"),
    ('resolution = 6\nalfven_wave = {degree = 1, order = 1, vorticity = "1 rad/s", field = "1 rad/s"}', "at least 2"),
    ('resolution = 3\nalfven_wave = {degree = 4, order = 1, vorticity = "1 rad/s", field = "1 rad/s"}', "resolution"),
])  # fmt: skip
def test_what_is_refused(spec, system, words):
    with pytest.raises(InvalidInput, match=re.escape(words)):
        spec(system)


@pytest.mark.parametrize("size", ["1e-200", "1e200"])
def test_sizes_beyond_the_numbers(spec, size):
    with pytest.raises(InvalidInput, match="must be zero or, in SI units, of a size from"):
        spec(f'resolution = 6\nfield_waves = [{{degree = 2, order = 1, field = "{size} rad/s"}}]').report()
