"""Reports, figures and datasets of every regime."""

import json
from dataclasses import replace

import matplotlib.image
import numpy as np
import pytest
import xarray as xr

import polhode as ph
from polhode.errors import InvalidInput
from polhode.figures.components_figure import components
from polhode.figures.sphere_figure import momentum_sphere
from polhode.formats.dataset import as_dataset, write_dataset
from polhode.kinds.free_body.answers import free_body_report
from polhode.kinds.free_body.figures import FIGURES
from sweeping import only

IDENTITY = (1.0, 0.0, 0.0, 0.0)
REGIMES = {
    "rest": ((1.0, 2.0, 3.0), (0.0, 0.0, 0.0)),
    "spherical": ((2.0, 2.0, 2.0), (1.0, 2.0, 3.0)),
    "permanent": ((1.0, 2.0, 3.0), (0.0, 2.0, 0.0)),
    "symmetric": ((1.0, 1.0, 2.0), (0.1, 0.2, 3.0)),
    "short-axis": ((1e-6, 2e-6, 2.9e-6), (1e-7, 2e-6, 2e-6)),
    "long-axis": ((1.0, 2.0, 3.0), (3.0, 0.2, 0.1)),
    "separatrix": ((3.0, 4.0, 6.0), (1.0, 2.0, 1.0)),
}


def report_on(regime):
    moments, momentum = REGIMES[regime]
    return free_body_report(ph.Body.from_moments(moments, mass=2.0), momentum, IDENTITY)


@pytest.mark.long_cases("separatrix")
@pytest.mark.parametrize("regime", only({"rest", "separatrix"}, REGIMES))
def test_every_regime_is_reported_and_drawn(regime, tmp_path):
    report = report_on(regime)
    values = report.as_json_dict()
    assert values["regime"] == regime and values["summary"].endswith(".")
    json.dumps(values, allow_nan=False)
    assert len(values["axes"]) == 3 and all(axis["certificate"] for axis in values["axes"])
    names = [path.name for path in replace(report, drawings=lambda: FIGURES).draw(tmp_path)]
    assert "components.png" in names and ("momentum_sphere.png" in names) == (regime != "rest")
    assert ("herpolhode.png" in names) == (regime not in ("rest", "spherical", "permanent"))
    for name in names:
        picture = matplotlib.image.imread(tmp_path / name)
        assert picture.shape[0] > 500 and picture[..., :3].std() > 0.02


SEEN = {
    "rest": ("rest", "at rest"),
    "spherical": ("steady", "Steady spin: all moments are equal"),
    "permanent": ("steady", "Steady spin about axis 2 (intermediate moment)"),
    "symmetric": ("coning", "cones (nutates): it leans 4.2"),
    "long-axis": ("coning", "Spin about axis 1 (least moment), which cones (nutates)"),
    "separatrix": ("flipping", "once from one end of the intermediate axis to the other"),
}


@pytest.mark.parametrize("regime", SEEN)
def test_the_headline_says_what_a_person_would_see(regime):
    form, words = SEEN[regime]
    report = report_on(regime)
    assert report.as_json_dict()["form"] == form and words in report.summary
    assert "reverses" not in report.summary and (form == "flipping") == ("intermediate axis" in report.summary)


def test_a_racket_flips_an_asteroid_tumbles_and_a_cone_is_a_cone():
    """Half-angles by hand: I = (1, 2, 2.9), L = (0, 2, 2) has tan² = P/Q = B L2² / (C L3²) … at the start, L1 = 0."""
    said = {}
    for momentum in ((0.01, 2.0, 0.01), (1.0, 1.0, 1.3), (0.1, 0.2, 3.0)):
        report = free_body_report(ph.Body.from_moments((1.0, 2.0, 2.9)), momentum, IDENTITY)
        said[report.as_json_dict()["form"]] = report
    assert set(said) == {"flipping", "tumbling", "coning"}
    flip, cone = said["flipping"], said["coning"]
    assert f"every {flip.motion.flip_interval:.6g} s" in flip.summary
    # at the start of the third L stands at atan(√(0.1² + 0.2²)/3) = 4.264°, between the ends of its cone
    leaning = cone.summary.split("leans ")[1].split(" from the angular momentum L")[0]
    ends = [float(x.strip("°")) for x in leaning.split(" to ")]
    assert ends[0] < 4.264 < ends[1] < 6.0


def test_spin_about_the_least_moment_is_warned_of():
    warned = report_on("long-axis")
    assert any("Explorer 1" in note for note in warned.notes)
    assert any("internal loss" in axis["because"] for axis in warned.as_json_dict()["axes"])
    assert not report_on("symmetric").notes and not report_on("rest").notes


def test_figures_say_what_they_show():
    report = report_on("long-axis")
    upper, lower = components(report.trajectory).axes
    assert "[rad/s]" in upper.get_ylabel() and "kg m²/s" in lower.get_ylabel() and "[s]" in lower.get_xlabel()
    shown = upper.lines[0].get_ydata()
    assert shown == pytest.approx(report.motion.angular_velocity(upper.lines[0].get_xdata())[:, 0])
    sphere = momentum_sphere(report.trajectory)
    curves = [line.get_xydata() for line in sphere.axes[0].lines if len(line.get_xdata()) > 100]
    radii = np.concatenate([np.hypot(*curve.T) for curve in curves])
    assert radii[np.isfinite(radii)].max() < 1.0 + 1e-9


def test_times_asked_for_and_not():
    assert report_on("long-axis").trajectory.times[-1] == pytest.approx(10 * report_on("long-axis").motion.period)
    body, times = ph.Body.from_moments((1.0, 2.0, 3.0)), np.array([0.0, 1.0])
    assert free_body_report(body, (1.0, 2.0, 3.0), IDENTITY, times).trajectory.times.tolist() == [0.0, 1.0]


def test_a_thin_rod_is_refused():
    with pytest.raises(InvalidInput, match="thin rod"):
        free_body_report(ph.shapes.rod(1.0, 1.0), (0.0, 1.0, 0.0), IDENTITY)


def test_dataset_round_trip(tmp_path):
    trajectory = report_on("short-axis").trajectory
    path = write_dataset(trajectory, tmp_path / "motion.nc", {"title": "case"})
    with xr.open_dataset(path) as data:
        assert np.array_equal(data.attitude, trajectory.attitude)
        assert np.array_equal(data.momentum_space, trajectory.invariants["momentum_space"])
        assert data.energy.attrs["units"] == "J" and data.attrs["title"] == "case"
        assert list(data["quaternion"].values) == ["w", "x", "y", "z"]
    assert [p.name for p in tmp_path.iterdir()] == ["motion.nc"]


def test_dataset_of_a_batch():
    motion = ph.FreeMotion((1.0, 2.0, 3.0), momentum=np.eye(3) + 0.1)
    data = as_dataset(motion.sample(np.linspace(0.0, 1.0, 7)))
    assert data.momentum.dims == ("batch_0", "time", "axis") and data.momentum.shape == (3, 7, 3)


def test_dataset_that_cannot_be_written(tmp_path):
    with pytest.raises(InvalidInput, match="cannot be written"):
        write_dataset(report_on("rest").trajectory, tmp_path / "none" / "motion.nc")


def test_the_herpolhode_is_drawn_turn_by_turn():
    """With three samples a turn in the report, chords of the curve would be far off it."""
    from polhode.figures.herpolhode_figure import herpolhode
    from polhode.kinds.free_body.answers import free_body_report

    body = ph.Body.from_moments((1.0, 1.1, 1.2))
    times = np.linspace(0.0, 400.0, 200)
    report = free_body_report(body, np.array([0.1, 0.3, 1.0]), np.array([1.0, 0, 0, 0]), times)
    curve = np.stack(herpolhode(report.trajectory).axes[0].lines[2].get_data(), axis=-1)
    turns = np.diff(np.unwrap(np.arctan2(curve[:, 1], curve[:, 0])))
    assert np.abs(turns).max() < 0.2


def test_the_dataset_relates_principal_axes_to_the_given_ones(tmp_path):
    body = ph.Body(2.0, (1.0, 2.0, 3.0), [[3.0, 1.0, 0.0], [1.0, 3.0, 0.0], [0.0, 0.0, 3.5]])
    report = free_body_report(body, np.array([0.1, 0.2, 0.3]), IDENTITY)
    path = write_dataset(report.trajectory, tmp_path / "motion.nc")
    with xr.open_dataset(path, engine="h5netcdf") as data:
        moments, axes = data["principal_moments"].values, data["principal_axes"].values
        assert axes @ np.diag(moments) @ axes.T == pytest.approx(np.asarray(body.inertia), abs=1e-14)
        assert float(data["mass"]) == 2.0 and "principal" in data["attitude"].attrs["comment"]


def test_a_note_where_times_are_beyond_all_meaning():
    body = ph.Body.from_moments((1.0, 2.0, 3.0))
    near = free_body_report(body, np.array([0.3, 1.8, 1.5]), IDENTITY, np.linspace(0.0, 1e9, 5))
    far = free_body_report(body, np.array([0.3, 1.8, 1.5]), IDENTITY, np.linspace(0.0, 1e19, 5))
    assert near.notes == [] and "turns" in far.notes[0]


def test_only_what_turns_over_has_a_flip_interval():
    """A T-handle spun about its axis 3 cones: it never turns over, and was said to every 1.5 s."""
    for momentum, flips in (((0.01, 2.0, 0.01), True), ((1.0, 1.0, 1.3), False), ((0.1, 0.2, 3.0), False)):
        report = free_body_report(ph.Body.from_moments((1.0, 2.0, 2.9)), momentum, IDENTITY)
        values = report.as_json_dict()
        assert (values["form"] == "flipping") == flips
        assert (values["flip_interval"] is not None) == (values["twist_per_flip"] is not None) == flips
        assert ("flip" in str([group.lines for group in report.answers if hasattr(group, "lines")])) == flips
