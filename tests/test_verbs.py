"""Motions, trajectories and reports are drawn, shown and saved alike."""

from pathlib import Path

import jaxtyping
import numpy as np
import pytest
from matplotlib.figure import Figure

import polhode as ph
from polhode.errors import InvalidInput
from polhode.formats import read_csv, read_dataset
from polhode.formats.figure_file import save_figure
from polhode.viewer.page import NotebookPage

MOTION = ph.FreeMotion((1.0, 2.0, 3.0), momentum=(0.3, 1.8, 1.5))
TIMES = np.linspace(0.0, 3.0, 31)
HANDLE = Path(__file__).parents[1] / "examples" / "t_handle.toml"


@pytest.fixture(scope="module")
def report():
    return ph.report(HANDLE)


def test_each_has_a_page(report):
    for moved in (MOTION, MOTION.sample(TIMES), report):
        page = moved.show(name="a thing", height=300)
        assert isinstance(page, NotebookPage) and page.height == 300 and "a thing" in page.page
        assert page.page == ph.show(moved, name="a thing").page
    spec = ph.read_spec(HANDLE)
    assert report.show(surface=spec.picture).page == ph.show(spec).page
    assert MOTION.show(summary="how it turns", notes=["slowly"]).page.count("how it turns") == 1


def test_each_has_one_picture(report, tmp_path):
    """A report's is the first of its own, the same as the file that `draw` writes."""
    for moved in (MOTION, MOTION.sample(TIMES), report):
        assert isinstance(ph.plot(moved), Figure)
    drawn = save_figure(ph.plot(report), tmp_path / "plot.png").read_bytes()
    assert drawn == report.draw(tmp_path)[0].read_bytes()


def test_a_page_of_a_report_says_what_the_report_says(report):
    with pytest.raises(InvalidInput, match="are what a report says"):
        ph.show(report, summary="other words")
    with pytest.raises(InvalidInput, match="has no motion to show"):
        ph.tumble("apophis").show()


@pytest.mark.parametrize("ending", ["nc", "csv", "aem", "glb"])
def test_the_ending_chooses_the_format(ending, report, tmp_path):
    for k, moved in enumerate((MOTION, MOTION.sample(TIMES), report)):
        path = moved.save(tmp_path / f"{k}.{ending}")
        assert path == tmp_path / f"{k}.{ending}" and path.stat().st_size > 1000


def test_nothing_is_lost(report, tmp_path):
    samples = MOTION.sample(TIMES)
    for read, ending in ((read_dataset, "nc"), (read_csv, "csv")):
        found = read(samples.save(tmp_path / f"motion.{ending}"))
        assert np.array_equal(found.attitude, samples.attitude) and np.array_equal(found.times, TIMES)
        assert np.array_equal(read(MOTION.save(tmp_path / f"all.{ending}")).times, MOTION.sample().times)
        assert np.array_equal(read(report.save(tmp_path / f"r.{ending}")).attitude, report.trajectory.attitude)
    assert read_dataset(tmp_path / "motion.nc").source.labels is None


@pytest.mark.parametrize("path", ["motion.txt", "motion", "motion.par"])
def test_other_endings_are_refused(path, tmp_path, monkeypatch):
    with pytest.raises(InvalidInput, match=r"must end in \.aem, \.bc, \.csv, \.glb, \.nc, \.zarr"):
        MOTION.save(tmp_path / path)
    monkeypatch.setattr(jaxtyping.config, "jaxtyping_disable", True)
    with pytest.raises(InvalidInput, match="must be a motion or a trajectory"):
        ph.formats.write_motion(3.0, tmp_path / "motion.nc")


def test_a_batch_is_no_motion_to_save(tmp_path):
    many = ph.FreeMotion((1.0, 2.0, 3.0), momentum=np.ones((5, 3)))
    with pytest.raises(InvalidInput, match="`times` must be given"):
        many.save(tmp_path / "motion.nc")
