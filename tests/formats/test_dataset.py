"""NetCDF and Zarr: bit for bit, by xarray alone, with units that are units."""

import re
from dataclasses import fields, replace
from pathlib import Path

import numpy as np
import pint
import pytest
import xarray as xr

import polhode as ph
from polhode import formats, spacecraft
from polhode.errors import FormatError, InvalidInput
from polhode.formats.dataset import label_attributes
from polhode.motion import MotionPlan, Outcome, StateLayout

MOTION = ph.FreeMotion((1.0, 2.0, 3.0), momentum=(0.3, 1.8, 1.5), attitude=(0.5, -0.5, 0.1, 0.7))
TIMES = np.linspace(0.0, 20.0, 101)
BATCH = ph.FreeMotion((1.0, 2.0, 3.0), momentum=np.random.default_rng(0).normal(size=(4, 1, 3)))
LABELS = formats.AttitudeLabels('a </script> = "b" Größe', center="EARTH", comments=("two", "lines"), spice_id=-77)
WAYS = {"nc": formats.write_dataset, "zarr": formats.write_zarr}


def check_identical(found, wanted):
    for one in fields(wanted):
        if one.name in ("source", "statistics", "quantities", "frame"):
            continue
        ours, theirs = getattr(found, one.name), getattr(wanted, one.name)
        if isinstance(theirs, dict):
            assert ours.keys() == theirs.keys()
            for key in theirs:
                assert np.array_equal(ours[key], np.asarray(theirs[key]))
        elif theirs is None or isinstance(theirs, Outcome | StateLayout | MotionPlan):
            assert ours == theirs
        else:
            assert np.array_equal(ours, np.asarray(theirs)) and ours.dtype == np.float64
    for name in wanted.invariants | wanted.balances:
        assert found.quantity(name) == wanted.quantity(name)


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize("ending", WAYS)
def test_what_is_read_is_what_was_written(tmp_path, ending):
    frame = ph.shapes.box(2.0, (1.0, 2.0, 3.0)).frame
    trajectory = replace(MOTION.sample(TIMES), frame=frame)
    header = {"title": "a box"} | label_attributes(LABELS)
    path = WAYS[ending](trajectory, tmp_path / f"motion.{ending}", header)
    found = formats.read_dataset(path)
    check_identical(found, trajectory)
    assert (found.source.title, found.source.labels) == ("a box", LABELS)
    assert all(np.array_equal(a, b) for a, b in zip(found.frame[:4], frame[:4], strict=True))
    assert found.frame.pivot is None
    again = formats.read_dataset(WAYS[ending](found, tmp_path / f"again.{ending}", header))
    check_identical(again, trajectory)


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize("ending", WAYS)
def test_xarray_reads_it_alone(tmp_path, ending):
    path = WAYS[ending](MOTION.sample(TIMES), tmp_path / f"motion.{ending}")
    with xr.open_dataset(path, engine="h5netcdf" if ending == "nc" else "zarr") as dataset:
        assert dataset.time.dtype == np.float64
        assert np.array_equal(dataset.attitude.sel(quaternion="w"), MOTION.attitude(TIMES)[:, 0])
        assert dataset.identical(ph.as_dataset(MOTION.sample(TIMES)))


def laden_body():
    """Return a trajectory of a body that has one of each mount, and a torque, with states of their own."""
    inertia = np.array([[2.0, 0.1, 0.2], [0.1, 3.0, -0.1], [0.2, -0.1, 2.5]])
    parts = [
        ph.spacecraft.Wheel((1.0, 0.0, 0.0), 0.01), ph.spacecraft.SphericalSlug(0.02, 0.01),
        ph.spacecraft.SprungMass((0.1, 0.0, 0.0), np.eye(3)[:2], 0.2, 1.0, 0.1),
        ph.spacecraft.SphericalPendulum((0.1, 0.0, 0.2), (0.0, 0.0, -0.3), 0.1, 1.0),
    ]  # fmt: skip
    lagged = ph.spacecraft.LaggedTorque(lambda t, q, w: -0.1 * w, 0.5)
    body = ph.spacecraft.RigidBody.from_body(ph.Body(10.0, (0.1, 0.2, 0.05), inertia), parts, [lagged])
    return ph.simulate(body, body.pack((1.0, 0.0, 0.0, 0.0), (0.1, 0.2, 0.3)), np.linspace(0.0, 5.0, 6))


@pytest.mark.sweep
@pytest.mark.parametrize("ending", WAYS)
def test_the_states_of_what_is_on_a_body_are_there(tmp_path, ending):
    trajectory = laden_body()
    wanted = replace(trajectory, observed={"wheel_rate": np.outer(np.arange(6.0), (1.0, -2.0))}, given_axes=None)
    path = WAYS[ending](wanted, tmp_path / f"laden.{ending}")
    found = formats.read_dataset(path)
    check_identical(found, wanted)
    assert np.array_equal(found.states, trajectory.states) and found.layout == trajectory.layout
    with xr.open_dataset(path, engine="h5netcdf" if ending == "nc" else "zarr") as dataset:
        columns = np.split(trajectory.states, np.cumsum([4, 3, 1, 3, 2, 2, 3, 3]), axis=1)
        names = ("rotor_momentum", "slug_momentum", "displacement", "displacement_momentum", "deflection",
                 "deflection_momentum", "actuator_torque")  # fmt: skip
        for name, column in zip(names, columns[2:], strict=True):
            assert np.array_equal(dataset[name].values.reshape(column.shape), column), name
        assert dataset.slug_momentum.dims == ("time", "given_axis")
        assert dataset.wheel_rate.attrs["role"] == "observed"


@pytest.mark.parametrize("ending", WAYS)
def test_batches(tmp_path, ending):
    trajectory = BATCH.sample(TIMES)
    found = formats.read_dataset(WAYS[ending](trajectory, tmp_path / f"batch.{ending}"))
    check_identical(replace(found, drift={}), replace(trajectory, drift={}))
    assert found.attitude.shape[0] == 4


@pytest.mark.parametrize("ending", WAYS)
def test_a_copy_that_ended_is_not_written_to_be_refused_later(tmp_path, ending):
    whole = ph.FreeMotion((1.0, 2.0, 3.0), momentum=np.random.default_rng(0).normal(size=(4, 3))).sample(TIMES)
    states = np.array(whole.states)
    states[2, 40:] = np.inf
    path = tmp_path / f"ended.{ending}"
    with pytest.raises(InvalidInput, match=r"the states of copy 2 are not from 8 s on\. Follow"):
        WAYS[ending](replace(whole, states=states), path)
    assert not path.exists()


@pytest.mark.sweep
def test_motions_with_states_of_their_own(tmp_path):
    """A spin in an orbit has named parts and energy that comes and goes, matrices have states of two axes."""
    moon, turning = ph.celestial.SpinOrbit(0.5, 0.1), np.array([0.5, 1.2])
    matrices = ph.systems.Manakov((1.0, 2.0, 3.0, 4.0))
    point = np.triu(np.arange(16.0).reshape(4, 4), 1)
    for system, state, order in ((moon, turning, None), (matrices, point - point.T, 2)):  # soon compiled
        trajectory = ph.simulate(system, state, np.linspace(0.0, 0.1, 5), order=order)
        found = formats.read_dataset(formats.write_dataset(trajectory, tmp_path / "motion.nc"))
        check_identical(found, trajectory)
        again = formats.read_dataset(formats.write_dataset(found, tmp_path / "again.nc"))
        check_identical(again, trajectory)


@pytest.mark.parametrize("ending", WAYS)
def test_empty_trajectories(tmp_path, ending):
    empty = ph.FreeMotion((1.0, 2.0, 3.0), momentum=(0.3, 1.8, 1.5)).sample([0.0]).select(slice(0, 0))
    found = formats.read_dataset(WAYS[ending](empty, tmp_path / f"empty.{ending}"))
    assert found.times.shape == (0,) and found.attitude.shape == (0, 4)


def test_vectors_in_space_have_the_axes_of_space():
    dataset = ph.as_dataset(MOTION.sample(TIMES), label_attributes(formats.AttitudeLabels("BOX")))
    assert dataset.momentum_space.dims == ("time", "space_axis") and dataset.momentum.dims == ("time", "axis")
    assert list(dataset.space_axis.values) == ["x", "y", "z"]
    assert "comments" not in dataset.attrs  # there are none


def test_units_are_units():
    registry = pint.UnitRegistry()
    dataset = ph.as_dataset(replace(MOTION.sample(TIMES), frame=ph.shapes.box(2.0, (1.0, 2.0, 3.0)).frame))
    wanted = {"momentum": "kg*m**2/s", "energy": "J", "angular_velocity": "1/s", "principal_moments": "kg*m**2"}
    for name, variable in {**dataset.data_vars, "time": dataset.time}.items():
        # CF writes powers without a sign and products with a blank
        written = re.sub(r"([A-Za-z]+)(-?\d+)", r"\1**\2", variable.attrs["units"]).replace(" ", "*")
        unit = registry.parse_units(written if written != "1" else "")
        if name in wanted:
            assert unit.is_compatible_with(wanted[name])
    assert dataset.attrs["Conventions"].startswith("CF-")


def test_an_attitude_file_becomes_a_dataset(tmp_path):
    aem = spacecraft.write_aem(MOTION.sample(TIMES), tmp_path / "motion.aem", rates="derivative")
    read = spacecraft.read_aem(aem)
    found = formats.read_dataset(formats.write_dataset(read, tmp_path / "motion.nc"))
    assert found.source.labels == read.source.labels and np.array_equal(found.attitude, read.attitude)
    assert "state" not in ph.as_dataset(read)


def test_what_is_no_dataset_of_ours(tmp_path):
    with pytest.raises(InvalidInput, match="no such NetCDF file"):
        formats.read_dataset(tmp_path / "missing.nc")
    with pytest.raises(InvalidInput, match="not a Zarr store"):
        formats.read_dataset(tmp_path)
    (tmp_path / "text.nc").write_text("no")
    with pytest.raises(FormatError, match="broken or cut short"):
        formats.read_dataset(tmp_path / "text.nc")
    xr.Dataset({"a": 1.0}).to_netcdf(tmp_path / "other.nc", engine="h5netcdf")
    with pytest.raises(FormatError, match="not one that polhode wrote"):
        formats.read_dataset(tmp_path / "other.nc")


@pytest.mark.parametrize("variable", ["attitude", "time", "angular_velocity"])
def test_a_store_that_lost_its_values_is_damaged(tmp_path, variable):
    store = formats.write_zarr(MOTION.sample(TIMES), tmp_path / "motion.zarr")
    for chunk in (store / variable).glob("[0-9]*"):
        chunk.unlink()
    with pytest.raises(FormatError, match=f"{variable.replace('_', ' ')} of sample 0 is not a .* damaged"):
        formats.read_dataset(store)


@pytest.mark.parametrize("wrong", [np.nan, 0.0, 3.0])
def test_an_attitude_that_is_none_is_found(tmp_path, wrong):
    trajectory = BATCH.sample(TIMES)
    trajectory.attitude[2, ..., 7, :] = wrong
    formats.write_dataset(trajectory, tmp_path / "motion.nc")
    with pytest.raises(FormatError, match="attitude of sample 7 is not a"):
        formats.read_dataset(tmp_path / "motion.nc")
    single = MOTION.sample(TIMES)
    single.attitude[5] = wrong
    formats.write_csv(single, tmp_path / "motion.csv")
    said = "line 7: 'nan' must be a number" if np.isnan(wrong) else "attitude of sample 5 is not a"
    with pytest.raises(FormatError, match=said):
        formats.read_csv(tmp_path / "motion.csv")


@pytest.mark.parametrize("ending", WAYS)
def test_places_that_cannot_be_written(tmp_path, ending):
    (tmp_path / "folder").mkdir()
    for place in ("/proc/motion", tmp_path / "missing" / "motion", tmp_path / "folder"):
        with pytest.raises(InvalidInput, match=r"cannot be written|is a folder"):
            WAYS[ending](MOTION.sample(TIMES), place)
    assert [path.name for path in tmp_path.iterdir()] == ["folder"] and list((tmp_path / "folder").iterdir()) == []


def test_a_store_is_replaced(tmp_path):
    for count in (10, 20):
        path = formats.write_zarr(MOTION.sample(TIMES[:count]), tmp_path / "motion.zarr")
    assert len(formats.read_dataset(path).times) == 20


def test_a_store_of_anothers_stays(tmp_path):
    store = xr.Dataset({"temperature": ("day", [1.0, 2.0])})
    store.to_zarr(tmp_path / "motion.zarr", zarr_format=2)
    with pytest.raises(InvalidInput, match="not the store of a motion"):
        formats.write_zarr(MOTION.sample(TIMES), tmp_path / "motion.zarr")
    assert xr.load_dataset(tmp_path / "motion.zarr", engine="zarr").identical(store)


def test_a_store_that_is_not_what_was_written_is_refused(tmp_path, monkeypatch):
    """As on a disk that loses bytes: the check itself can fail."""
    formats.write_zarr(MOTION.sample(TIMES), tmp_path / "motion.zarr")
    write = Path.write_bytes
    monkeypatch.setattr(Path, "write_bytes", lambda path, data: write(path, data[:-1] + b"?"))
    with pytest.raises(InvalidInput, match="what was written is not what is read"):
        formats.write_zarr(MOTION.sample(TIMES), tmp_path / "motion.zarr")
    monkeypatch.undo()
    assert np.array_equal(formats.read_dataset(tmp_path / "motion.zarr").times, TIMES)


@pytest.mark.long
@pytest.mark.parametrize("form", WAYS)
def test_complex_states_come_back(form, tmp_path):
    fluid = ph.fields.SphereFluid(4, 0.5)
    times = np.linspace(0.0, 0.1, 3)
    wanted = ph.simulate(fluid, fluid.random([0, 1, 1], seed=1), times, ph.integrators.IsospectralMidpoint,
                         estimate_error=False)  # fmt: skip
    path = WAYS[form](wanted, tmp_path / f"motion.{form}")
    found = formats.read_dataset(path)
    assert np.array_equal(found.states, wanted.states) and found.layout.axes == 2
    with (xr.open_dataset(path) if form == "nc" else xr.open_zarr(path)) as data:
        assert data["state"].dims[-1] == "complex_part" and list(data["complex_part"].values) == ["real", "imaginary"]
