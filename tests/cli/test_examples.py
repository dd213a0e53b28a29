"""Every example runs, and says what is known of its body."""

import contextlib
import importlib.util
import io
import json
from pathlib import Path

import numpy as np
import pytest
import xarray as xr

from polhode.cli.main import main

pytestmark = pytest.mark.sweep  # fifteen reports, two minutes; kinds' tests make shorter ones
EXAMPLES = Path(__file__).parents[2] / "examples"
HOUR, DAY = 3600.0, 86400.0
SAME = 1e-12
"""Two ways to the same body, each a few roundings."""


@pytest.fixture(scope="module")
def reports(tmp_path_factory):
    folder = tmp_path_factory.mktemp("reports")
    found = {}
    for path in sorted(EXAMPLES.glob("*.toml")):
        out = folder / path.stem
        with contextlib.redirect_stdout(io.StringIO()) as said, pytest.raises(SystemExit) as stopped:
            main(["report", str(path), "--json", "--out", str(out)])
        assert not stopped.value.code, path
        found[path.stem] = json.loads(said.getvalue())
    return found


def test_all_are_there(reports):
    free = "t_handle t_handle_parts book smartphone water steam earth apophis spacecraft cubesat"
    others = {"top", "precessing_top", "gyroscope", "explorer_1", "dual_spin", "hyperion", "euler_disk",
              "jupiter_cyclones", "sphere_turbulence", "joint_instability", "two_stream", "skyrmions", "water_spectrum",
              "sulfur_dioxide", "formaldehyde", "quantum_racket", "cubesat_6u"}  # fmt: skip
    assert set(reports) == set(free.split()) | others


def test_files_open(reports):
    for report in reports.values():
        for name in report["files"]:
            assert Path(name).stat().st_size > 1000
        datasets = [name for name in report["files"] if name.endswith(".nc")]
        assert len(datasets) == (report["kind"] != "quantum-rotor")
        for name in datasets:
            data = xr.load_dataset(name)
            if "momentum" in data:
                assert data.momentum.attrs["units"] == "kg m2 s-1"
            assert data.time.attrs["units"] == "s" or data.time.dtype.kind in "mM"
            assert all(np.isfinite(data[name]).all() for name in data.data_vars)


def test_drift_is_rounding_where_motion_is_exact(reports):
    for report in reports.values():
        if report["kind"] in ("free-body", "lagrange-top"):
            assert max(report["drift"].values()) < 16 * 2.0**-52


def test_tops(reports):
    top, gyroscope = reports["top"], reports["gyroscope"]
    assert top["regime"] == "cusp" and top["start_tilt"] == pytest.approx(np.radians(20.0), abs=1e-12)
    assert top["equilibria"]["upright, at 157.08 rad/s"]["verdict"] == "stable"
    assert top["sleeping_threshold"] < top["spin"] == pytest.approx(50.0 * np.pi, rel=1e-12)
    lowest, highest = top["nutation_limits"]
    assert highest == pytest.approx(np.cos(np.radians(20.0)), abs=1e-14) and lowest < highest
    assert gyroscope["integrable_case"] is None and max(gyroscope["drift"].values()) < 1e-11
    assert gyroscope["mgl"] == pytest.approx(9.80665 * 0.147 * np.hypot(0.035, 0.04 / 147), rel=1e-12)
    assert np.radians(75) < gyroscope["tilt"]["smallest"] < np.radians(80) < gyroscope["tilt"]["largest"]


def test_the_flat_top_precesses_steadily(reports):
    report = reports["precessing_top"]
    assert np.degrees(np.arccos(report["nutation_limits"])) == pytest.approx([30.0, 30.0], abs=1e-6)
    assert report["precession_rate"] == pytest.approx(report["steady_precession"]["slow"], rel=1e-9)


def test_hyperion_is_chaotic(reports):
    # Wisdom, Peale & Mignard (1984): ω0 = 0.89, threshold 0.31, exponent about 0.1 n, e-folding in about 1.5 orbits
    report = reports["hyperion"]
    a, b = 190.0, 145.0  # semi-axes: (B − A)/C = (a² − b²)/(a² + b²)
    assert report["asphericity"] == pytest.approx(np.sqrt(3 * (a**2 - b**2) / (a**2 + b**2)), abs=1e-4)
    assert report["verdict"] == "chaotic" and report["chaos_expected"] and report["libration"] is None
    assert report["small_eccentricity_threshold"] == pytest.approx(0.31, abs=0.005)
    assert report["lyapunov_exponent"] / report["mean_motion"] == pytest.approx(0.12, abs=0.02)
    assert report["orbital_period"] == pytest.approx(21.28 * DAY, rel=1e-14)
    assert max(report["drift"].values()) < 1e-11


def test_the_disk_ends_by_air(reports):
    disk = reports["euler_disk"]
    down, (air, couple) = disk["spin_down"], disk["laws"]
    # a cylinder by hand
    assert disk["diametral_moment"] == pytest.approx(0.4387 * (0.0381**2 / 4 + 0.0127**2 / 12), rel=1e-12)
    assert disk["steady"]["stability"]["verdict"] == "stable" and list(down["events"])[-1] == "flat"
    # rolling friction at first, air in the end
    assert couple["share"] > 0.9 and down["dominant_law"] == air["law"] == "air-layer"
    assert 60.0 < down["end"] < 120.0 and abs(disk["end_time"] - down["end"]) < 0.1
    for exponent in (down["tilt_exponent"], down["unspun_by_tilt_exponent"]):  # of 1/3 and −1/2
        assert abs(exponent["fitted"] - exponent["predicted"]) < exponent["uncertainty"] < 0.02
    assert down["energy_balance"] < 1e-10
    assert disk["normal_force_minimum_of_weight"] > 0.15 and "laws are predicted for a thin disk" in disk["notes"][0]


def test_t_handle_mesh_and_parts_agree(reports):
    mesh, parts = reports["t_handle"], reports["t_handle_parts"]
    for key in ("mass", "energy", "momentum_norm", "polhode_period", "precession_per_period", "action"):
        assert mesh[key] == pytest.approx(parts[key], rel=SAME)
    for key in ("center_of_mass", "principal_moments", "principal_axes"):
        assert np.allclose(mesh[key], parts[key], rtol=SAME, atol=1e-18 if key != "principal_axes" else SAME)


def test_t_handle_turns_over_about_its_stem(reports):
    report = reports["t_handle"]
    stem = np.array(report["principal_axes"])[:, 1]
    assert np.abs(stem) == pytest.approx([0.0, 1.0, 0.0])
    assert report["axes"][1]["verdict"] == "unstable"
    # by hand: two boxes of 21.6 g and 10.8 g, their centres 25 mm apart
    about_stem = 0.0216 * (0.08**2 + 0.01**2) / 12 + 0.0108 * (0.01**2 + 0.01**2) / 12
    assert report["principal_moments"][1] == pytest.approx(about_stem, rel=1e-12)


def test_the_committed_mesh_is_what_the_script_writes(tmp_path):
    source = importlib.util.spec_from_file_location("build_t_handle", EXAMPLES / "build_t_handle.py")
    module = importlib.util.module_from_spec(source)
    source.loader.exec_module(module)
    module.__file__ = str(tmp_path / "build_t_handle.py")
    module.main()
    assert (tmp_path / "t_handle.stl").read_text() == (EXAMPLES / "t_handle.stl").read_text()


def test_earth_nutates_in_304_days(reports):
    # 1/H − 1 = 304.456 sidereal days
    sidereal = 2 * np.pi / 7.292115e-5
    assert reports["earth"]["polhode_period"] == pytest.approx(304.456 * sidereal, rel=1e-5)


def test_apophis_has_its_published_periods(reports):
    report = reports["apophis"]
    assert report["regime"] == "short-axis"
    assert report["tumbling_periods"]["P_phi"] / HOUR == pytest.approx(27.38, abs=0.01)
    assert report["tumbling_periods"]["P_psi"] / HOUR == pytest.approx(263.0, abs=6.0)
    assert report["long_axis_period"] / HOUR == pytest.approx(30.56, abs=0.05)


def test_water_has_its_rotational_constants(reports):
    # h/(8π²I) of this geometry, in GHz: 822, 436, 285 to a percent (Herzberg's A_e, B_e, C_e)
    constants = 6.62607015e-34 / (8 * np.pi**2 * np.array(reports["water"]["principal_moments"])) / 1e9
    assert constants == pytest.approx([822.0, 437.0, 285.0], rel=0.01)


def test_explorer_1_ends_in_a_flat_spin(reports):
    report = reports["explorer_1"]
    # a solid cylinder: r²/2 about its axis, (3r² + l²)/12 across
    ratio = (0.076**2 / 2) / ((3 * 0.076**2 + 2.03**2) / 12)
    assert [axis["verdict"] for axis in report["axes"]] == ["unstable", "stable", "stable"]
    assert np.degrees(report["start"]["angle_to_major_axis"]) == pytest.approx(90.0, abs=2.0)
    assert report["end"]["angle_to_major_axis"] < 1e-4 and max(report["drift"].values()) < 1e-12
    start, end = (np.linalg.norm(report[when]["angular_velocity"]) for when in ("start", "end"))
    assert end / start == pytest.approx(ratio, rel=1e-3)
    assert report["end"]["energy"] / report["start"]["energy"] == pytest.approx(ratio, rel=0.06)


def test_the_drum_holds_the_dual_spin_satellite(reports):
    report = reports["dual_spin"]
    assert report["rotor"]["moment"] == pytest.approx(200 * 1.1**2 / 2)
    held, other = report["equilibria"]
    assert held["extremum"] == "minimum" and held["verdict"] == "stable" and held["along"] == [1.0, 0.0, 0.0]
    assert other["extremum"] == "maximum"
    assert np.array(report["principal_axes"])[:, 0].tolist() == [0.0, 0.0, 1.0]
    assert report["rotor_axis_to_momentum"]["largest"] < np.radians(7.0) and max(report["drift"].values()) < 1e-13
