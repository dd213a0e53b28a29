"""Reports on spins on eccentric orbits: numbers by other ways, words, figures, files, and refusals."""

import json

import matplotlib.image
import numpy as np
import pytest
import xarray as xr

from polhode.celestial.spin_orbit.history_figure import draw_spin_history
from polhode.celestial.spin_orbit.section_figure import draw_spin_section
from polhode.cli.main import main
from polhode.figures import style
from polhode.formats.dataset import as_dataset
from polhode.kinds.reading import read_spec
from polhode.reports.answer import Table

DAY = 86400.0
MERCURY = """
[system]
kind = "spin-orbit"
asphericity = 0.0257
eccentricity = 0.2056
orbital_period = "87.969 day"
angle = "10 deg"
spin_ratio = 1.5
section_orbits = 200
"""
BODY = '[body]\nmoments = ["1 kg*m^2", "2.5 kg*m^2", "3 kg*m^2"]\n'


@pytest.fixture
def report(tmp_path):
    def make(text=MERCURY):
        path = tmp_path / "case.toml"
        path.write_text(text, "utf-8")
        return read_spec(path).report()

    return make


@pytest.mark.sweep
def test_mercury_is_held_in_three_turns_to_two_orbits(report):
    found = report()
    values = found.as_json_dict()
    json.dumps(values, allow_nan=False)
    n = 2 * np.pi / (87.969 * DAY)
    assert values["verdict"] == "regular" and not values["chaos_expected"] and values["lyapunov_time"] is None
    assert values["libration"]["order"] == 1.5 and "3:2" in found.summary
    assert np.degrees(values["libration"]["amplitude"]) == pytest.approx(10.0, abs=0.05)
    assert values["mean_rate"] == pytest.approx(1.5 * n, rel=1e-8)
    # Mercury turns in 58.646 days
    assert 2 * np.pi / values["mean_rate"] / DAY == pytest.approx(58.646, abs=1e-3)
    assert [r["order"] for r in values["resonances"]] == [0.5, 1.0, 1.5, 2.0, 2.5, 3.0]
    e = 0.2056  # series of Goldreich & Peale (1966), next terms about e⁵
    assert values["resonances"][2]["strength"] == pytest.approx(3.5 * e - 123 / 16 * e**3, abs=5e-3)
    roots = np.sqrt([1 - 2.5 * e**2 + 13 / 16 * e**4, 3.5 * e - 123 / 16 * e**3])
    assert values["overlap_threshold"] == pytest.approx(0.5 / roots.sum(), rel=5e-3)
    assert set(values["drift"]) == {"energy_per_moment"} and values["drift"]["energy_per_moment"] < 1e-12
    assert len(values["notes"]) == 2 and "10000 orbits" in values["notes"][1]


@pytest.mark.sweep
def test_shape_from_a_body_and_orbit_from_its_size(report):
    orbit = 'semi_major_axis = "384400 km"\ngravitational_parameter = "4.035e14 m^3/s^2"'
    found = report(BODY + f'[system]\nkind = "spin-orbit"\neccentricity = 0.0\nspin_ratio = 1.2\n{orbit}\n')
    values = found.as_json_dict()
    assert values["asphericity"] == pytest.approx(np.sqrt(1.5), rel=1e-14)
    assert values["orbital_period"] == pytest.approx(2 * np.pi * np.sqrt(3.844e8**3 / 4.035e14), rel=1e-14)
    assert values["overlap_threshold"] is None and not values["chaos_expected"] and len(values["notes"]) == 1
    assert values["principal_moments"] == [1.0, 2.5, 3.0] and found.trajectory.frame is not None
    words = str([group.cells if isinstance(group, Table) else group.lines for group in found.answers])
    assert "pendulum" in words and "1:1" in words and "3:2" not in words


@pytest.mark.long
def test_chaos_is_said_with_how_long_it_can_be_followed(report):
    text = MERCURY.replace("0.0257", "0.89").replace("0.2056", "0.1").replace("10 deg", "90 deg")
    text = text.replace("1.5", "1.0").replace("200", "30")  # compiled once with the kind's own example
    found = report(text + '[time]\nuntil = "10 year"\nsamples = 300')
    values = found.as_json_dict()
    assert values["verdict"] == "chaotic" and values["chaos_expected"] and values["libration"] is None
    assert values["lyapunov_time"] == pytest.approx(1.0 / values["lyapunov_exponent"])
    tenfold = np.log(10) / 0.12 / (2 * np.pi)  # orbits, at λ = 0.12 n
    assert float(found.summary.split("as much ")[1].split()[0]) == pytest.approx(tenfold, rel=0.1)
    # from 1e-12 to one
    assert values["predictable_time"] == pytest.approx(12 * tenfold * values["orbital_period"], rel=0.1)
    assert len(found.notes) == 2 and "outlast" in found.notes[1]
    assert draw_spin_history(found).axes[0].lines[0].get_marker() == "."  # too few samples for a line


@pytest.mark.sweep
def test_figures(report, tmp_path):
    found = report()
    (tmp_path / "out").mkdir()
    for path in found.draw(tmp_path / "out"):
        picture = matplotlib.image.imread(path)
        assert picture.shape[0] > 500 and picture[..., :3].std() > 0.02
    axes, _ = draw_spin_section(found).axes
    assert "[°]" in axes.get_xlabel() and "turns per orbit" in axes.get_ylabel()
    own = next(line for line in axes.lines if line.get_color() == style.BLUE).get_xydata()
    assert own.shape == (201, 2) and own[0] == pytest.approx([10.0, 1.5])
    # the pendulum of 3:2: rates within n ω0 √H sin 10° of the mean
    assert np.ptp(own[:, 1]) / 2 == pytest.approx(0.0257 * np.sqrt(0.6542) * np.sin(np.radians(10.0)), rel=0.05)
    upper, lower = draw_spin_history(found).axes
    assert upper.get_ylabel() == "θ − 3/2 n t  [°]" and "orbits of 87.969 d" in lower.get_xlabel()
    assert np.abs(upper.lines[0].get_ydata()).max() < 11.0


@pytest.mark.sweep
def test_datasets_name_angle_and_rate(report):
    data = as_dataset(report().trajectory)
    assert isinstance(data, xr.Dataset) and "state" not in data
    assert (data.angle.attrs["units"], data.rate.attrs["units"]) == ("rad", "rad s-1")
    assert data.energy_per_moment.attrs["units"] == "rad2 s-2"
    assert float(data.time[-1]) == pytest.approx(30 * 87.969 * DAY)


BAD = [
    ("0.0257", "1.8", "system.asphericity: must be from 0 to 1.73205"),
    ("0.0257", '"0.02"', "system.asphericity: must be a plain finite number"),
    ("0.2056", "1.0", "system.eccentricity: must be from 0 to 0.99"),
    ("0.2056", "-0.1", "system.eccentricity: must be from 0 to 0.99"),
    ("eccentricity = 0.2056\n", "", "system.eccentricity: is missing; give it like 0.1"),
    ('"87.969 day"', '"-1 day"', "system.orbital_period: must be positive"),
    ('"87.969 day"', "87.969", "system.orbital_period: needs a number with its unit"),
    ('orbital_period = "87.969 day"\n', "", "system: needs orbital_period"),
    ("orbital_period", 'semi_major_axis = "1 km"\norbital_period', "orbital_period: goes without semi_major_axis"),
    ('orbital_period = "87.969 day"', 'semi_major_axis = "1 km"', "got semi_major_axis"),
    ('"87.969 day"', '"1e-100 s"', "mean motion within 1e±100 rad/s"),
    ('"10 deg"', '"10 m"', "system.angle: has the wrong unit"),
    ("spin_ratio = 1.5", "spin_ratio = 31", "system.spin_ratio: must be from -30 to 30"),
    ("= 200", "= 0", "system.section_orbits: must be at least 1; got 0"),
    ("= 200", "= 2.5", "system.section_orbits: must be a whole number"),
    ("spin_ratio", "spin_ration", "system.spin_ration: unknown key; did you mean spin_ratio?"),
    ("asphericity = 0.0257\n", "", "body: is missing"),
    ("[system]", BODY + "[system]", "system.asphericity: goes without [body]"),
    ("[system]", '[spin]\nrate = "1 rpm"\nabout = 1\n[system]', "spin: does not go with the system spin-orbit"),
]


@pytest.mark.parametrize(("old", "new", "words"), BAD)
def test_what_is_wrong_is_said_in_one_mistake(old, new, words, tmp_path, capsys):
    path = tmp_path / "case.toml"
    path.write_text(MERCURY.replace(old, new, 1), "utf-8")
    with pytest.raises(SystemExit) as stopped:
        main(["report", str(path), "--out", str(tmp_path / "out")])
    err = capsys.readouterr().err
    assert stopped.value.code == 2 and words in err and ("1 mistake:" in err or "mean motion" in err), err
    assert not (tmp_path / "out").exists()


def test_all_mistakes_at_once(tmp_path, capsys):
    path = tmp_path / "case.toml"
    path.write_text(BODY + MERCURY.replace("0.2056", "2.0").replace('"10 deg"', "10") + "orbits = 3\n[spin]\n", "utf-8")
    with pytest.raises(SystemExit):
        main(["report", str(path)])
    err = capsys.readouterr().err
    wanted = (
        "5 mistakes", "asphericity: goes without", "eccentricity: must be", "angle: needs", "orbits: unknown",
        "spin: does not go",
    )  # fmt: skip
    assert not [words for words in wanted if words not in err], err
