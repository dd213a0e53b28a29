"""Datasets that were made to run code, fill the memory or mislead, and such that another tool changed."""

import gc
import json
import os
import pickle
import shutil
import warnings
import zlib
from dataclasses import replace

import h5py
import numpy as np
import pytest
import xarray as xr

import polhode as ph
from polhode import formats
from polhode.errors import FormatError, InvalidInput
from polhode.formats import AttitudeLabels

MOTION = ph.FreeMotion((1.0, 2.0, 3.0), momentum=(0.3, 0.4, 0.5))
TIMES = np.linspace(0.0, 5.0, 20)
FRAME = ph.shapes.box(2.0, (1.0, 2.0, 3.0)).frame


@pytest.fixture(scope="module")
def specimens(tmp_path_factory):
    """The same motion as NetCDF and as Zarr."""
    folder = tmp_path_factory.mktemp("datasets")
    trajectory = replace(MOTION.sample(TIMES), frame=FRAME)
    return (formats.write_dataset(trajectory, folder / "motion.nc"),
            formats.write_zarr(trajectory, folder / "motion.zarr"))  # fmt: skip


@pytest.fixture
def netcdf(specimens, tmp_path):
    return shutil.copy(specimens[0], tmp_path / "motion.nc")


@pytest.fixture
def store(specimens, tmp_path):
    return shutil.copytree(specimens[1], tmp_path / "motion.zarr")


def changed(store, variable="energy", **entries):
    """Change a variable's document, in the consolidated copy too."""
    path = store / variable / ".zarray"
    path.write_text(json.dumps(json.loads(path.read_text()) | entries))
    whole = json.loads((store / ".zmetadata").read_text())
    whole["metadata"][f"{variable}/.zarray"] |= entries
    (store / ".zmetadata").write_text(json.dumps(whole))


def refused(path, words):
    with warnings.catch_warnings(), pytest.raises(FormatError, match=f"(?s)motion.*{words}") as error:
        warnings.simplefilter("error")
        formats.read_dataset(path)
    assert len(str(error.value)) < 2000


# ---------------------------------------------------------------- Zarr


class Marks:
    """Makes a folder when it is unpickled."""

    def __init__(self, folder):
        self.folder = str(folder)

    def __reduce__(self):
        return os.mkdir, (self.folder,)


@pytest.mark.parametrize("place", ["compressor", "filters"])
def test_a_store_with_a_pickle_runs_no_code(store, place, monkeypatch):
    """numcodecs before 0.16.6 decodes pickles; the gate stands before whatever version there is."""
    monkeypatch.setenv("NUMCODECS_ALLOW_PICKLE", "1")
    codec = {"id": "pickle", "protocol": 5}
    changed(store, dtype="|O", filters=[codec] if place == "filters" else None,
            compressor=codec if place == "compressor" else None)  # fmt: skip
    (store / "energy" / "0").write_bytes(pickle.dumps(Marks(store.parent / "ran")))
    refused(store, "")
    assert not (store.parent / "ran").exists()


@pytest.mark.parametrize(("entries", "words"), [
    ({"compressor": {"id": "pickle"}}, "compressed by 'pickle'; read are blosc"),
    ({"compressor": {"id": "json2"}}, "compressed by 'json2'"),
    ({"compressor": {"id": ["blosc"]}}, "compressed by"),
    ({"compressor": "blosc2"}, "compressed by 'blosc2'"),
    ({"filters": [{"id": "delta", "dtype": "<f8"}]}, "has filters"),
    ({"dtype": "|O"}, r"of type '\|O'"),
    ({"dtype": "<U999999999"}, "of type"),
    ({"dtype": "<c16"}, "of type"),
    ({"dtype": [["a", "<f8"]]}, "of type"),
    ({"shape": [10**15], "chunks": [10**9]}, "compressed|claims arrays of|should"),
    ({"shape": [10**10], "chunks": [10**9], "compressor": None}, "claims arrays of"),
    ({"shape": [20], "chunks": [10**12]}, "claims arrays of"),
    ({"shape": [10**6], "chunks": [1], "compressor": None}, "chunks, and may have|should"),
    ({"shape": [-1]}, "shape"), ({"shape": [20.5]}, "shape"), ({"shape": [True]}, "shape"), ({"shape": None}, "shape"),
    ({"shape": [20, 1]}, "chunks of shape"), ({"chunks": [0]}, "chunks of shape"),
    ({"chunks": [7]}, "does not hold the 56 bytes"),
    ({"zarr_format": 3}, "broken|format"),
    ({"fill_value": {"a": 1}}, "broken"), ({"order": "Z"}, "broken"),
])  # fmt: skip
def test_documents_of_a_store_that_polhode_does_not_write(store, entries, words):
    changed(store, **entries)
    refused(store, words)


@pytest.mark.parametrize(("text", "words"), [
    ("[" * 100_000, "is not JSON"), ("[]", "is not JSON"), ("\xff\xfe", "is not JSON"), ("", "is not JSON"),
    ('{"shape": [' + "9" * 5000 + "]}", "is not JSON|shape"),
])  # fmt: skip
def test_documents_that_are_no_json(store, text, words):
    (store / "energy" / ".zarray").write_bytes(text.encode("latin-1"))
    refused(store, words)


def test_a_drift_of_too_many_digits(store):
    path = store / "energy" / ".zattrs"
    path.write_text(json.dumps(json.loads(path.read_text()) | {"drift": 2**70}))
    assert formats.read_dataset(store).drift["energy"] == 2**70


def test_chunks_that_unpack_to_more_than_they_should(store):
    """A megabyte of zlib unpacks to a thousand; Blosc and LZ4 say their size at the beginning."""
    changed(store, compressor={"id": "zlib", "level": 9})
    bomb = zlib.compress(bytes(10**8), 9)
    (store / "energy" / "0").write_bytes(bomb)
    refused(store, "chunk '0' of variable 'energy' does not hold the 160 bytes")
    for codec, content in {"lz4": b"\xff\xff\xff\x7f" + bytes(20), "zstd": b"\x28\xb5\x2f\xfd\xa0" + b"\xff" * 20,
                           "gzip": b"\x1f\x8b" + bytes(20), "blosc": bytes(20), "zstd ": b""}.items():  # fmt: skip
        changed(store, compressor={"id": codec.strip()})
        (store / "energy" / "0").write_bytes(content)
        refused(store, "does not hold the 160 bytes")


@pytest.mark.parametrize("codec", ["zlib", "gzip", "lz4", "zstd", None])
def test_codecs_that_are_read(store, codec):
    numcodecs = pytest.importorskip("numcodecs")
    expected = formats.read_dataset(store).invariants["energy"]
    changed(store, compressor=codec and {"id": codec})
    coder = numcodecs.get_codec({"id": codec}) if codec else None
    raw = expected.tobytes()
    (store / "energy" / "0").write_bytes(coder.encode(raw) if coder else raw)
    assert np.array_equal(formats.read_dataset(store).invariants["energy"], expected)


@pytest.mark.parametrize("make", [lambda p: os.mkfifo(p), lambda p: p.symlink_to("/dev/zero")], ids=["pipe", "link"])
@pytest.mark.parametrize("place", ["energy/0", ".zattrs", "energy/.zarray", "extra"])
def test_a_store_of_links_and_pipes(store, place, make):
    (store / place).unlink(missing_ok=True)
    make(store / place)
    refused(store, "other than files and folders")


def test_the_documents_on_the_disk_are_what_counts(store):
    """A consolidated copy that says something else, or leads elsewhere, is not read."""
    whole = json.loads((store / ".zmetadata").read_text())
    whole["metadata"]["../outside/.zarray"] = whole["metadata"]["energy/.zarray"]
    whole["metadata"]["energy/.zarray"] |= {"compressor": {"id": "pickle"}}
    (store / ".zmetadata").write_text(json.dumps(whole))
    assert len(formats.read_dataset(store).invariants["energy"]) == len(TIMES)


@pytest.mark.parametrize("lost", ["momentum/.zarray", "time/.zarray"])
def test_a_store_without_a_document_is_one_message(store, lost, capfd):
    """zarr reads arrays side by side, and prints a traceback for each that it was not asked about any more."""
    (store / lost).unlink()
    (store / "empty").mkdir()
    refused(store, "has folders that are not arrays")
    gc.collect()
    assert capfd.readouterr().err == ""


@pytest.mark.parametrize("entries", [{"fill_value": {"a": 1}}, {"order": "Z"}, {"compressor": {"id": "blosc", "x": 1}}])
def test_documents_that_zarr_refuses_are_one_message(store, entries, capfd):
    for variable in ("energy", "momentum", "attitude"):
        changed(store, variable, **entries)
    refused(store, "")
    gc.collect()
    assert capfd.readouterr().err == ""


def test_a_store_of_format_3(store):
    (store / "zarr.json").write_text("{}")
    refused(store, "format 3")


@pytest.mark.parametrize("name", ["s3::motion.zarr", "reference:motion.zarr"])
def test_a_store_by_a_name_like_an_address_is_the_folder(store, name):
    assert len(formats.read_dataset(store.rename(store.parent / name)).times) == len(TIMES)


# ---------------------------------------------------------------- HDF5


def test_values_kept_in_other_files(netcdf):
    secret = netcdf.parent / "secret"
    secret.write_bytes(np.full(20, 7.0).tobytes())
    with h5py.File(netcdf, "a") as file:
        file.create_dataset("outside", (20,), "f8", external=[(str(secret), 0, 160)])
    refused(netcdf, "'outside' keeps its values in other files")


@pytest.mark.parametrize("link", [
    h5py.ExternalLink("/etc/passwd", "/a"), h5py.SoftLink("/energy"), h5py.SoftLink("/nowhere"),
])  # fmt: skip
def test_links(netcdf, link):
    with h5py.File(netcdf, "a") as file:
        file["outside"] = link
    refused(netcdf, "'outside' is a link")


def test_virtual_variables(netcdf):
    layout = h5py.VirtualLayout((20,), "f8")
    layout[:] = h5py.VirtualSource("/etc/passwd", "a", (20,))
    with h5py.File(netcdf, "a") as file:
        file.create_virtual_dataset("outside", layout)
    refused(netcdf, "'outside' keeps its values in other files")


def test_a_heap_that_leads_nowhere(netcdf):
    """HDF5 walks such a heap of texts for ever; found by damaging files at random."""
    content = bytearray(netcdf.read_bytes())
    heap = content.find(b"GCOL")
    for place, words in ((heap + 24, "damaged in a heap"), (heap + 8, "ends outside of it")):
        patched = content.copy()
        patched[place : place + 8] = b"\xff" * 8 if place == heap + 8 else (2**40).to_bytes(8, "little")
        netcdf.write_bytes(patched)
        refused(netcdf, words)
    place = heap + 16
    while content[place : place + 2] != b"\0\0":  # the free space at the end has the number 0
        place += 16 + -(-int.from_bytes(content[place + 8 : place + 16], "little") // 8) * 8
    content[place + 8 : place + 16] = bytes(8)
    netcdf.write_bytes(content)
    refused(netcdf, "damaged in a heap")


def test_filters_that_would_load_a_plugin(netcdf):
    with h5py.File(netcdf, "a") as file:
        values = h5py.h5p.create(h5py.h5p.DATASET_CREATE)
        values.set_chunk((20,))
        values.set_filter(32015, h5py.h5z.FLAG_OPTIONAL, ())
        h5py.h5d.create(file.id, b"odd", h5py.h5t.NATIVE_DOUBLE, h5py.h5s.create_simple((20,)), values)
    refused(netcdf, "'odd' has the filter 32015")


@pytest.mark.parametrize(("values", "words"), [
    ({"shape": (10**12,), "dtype": "f8", "chunks": (1000,)}, "claims arrays of"),
    ({"shape": (10,), "dtype": "f8", "chunks": (10,), "maxshape": (None,), "compression": "lzf"}, "filter 32000"),
    ({"shape": (1,), "dtype": "f8", "chunks": (5 * 10**8 // 8 - 1,), "maxshape": (None,)}, "claims arrays of"),
    ({"data": np.array([(1.0, 2)], dtype=[("a", "f8"), ("b", "i4")])}, "is of type"),
    ({"data": np.ones(3, dtype=complex)}, "is of type"),
    ({"shape": (3,), "dtype": h5py.ref_dtype}, "is of type"),
    ({"shape": (3,), "dtype": h5py.vlen_dtype(float)}, "is of type"),
    ({"shape": (10**6,), "dtype": h5py.string_dtype(), "chunks": (10,)}, "1000000 texts"),
    ({"data": h5py.Empty("f8")}, "is empty"),
])  # fmt: skip
def test_variables_that_polhode_does_not_write(netcdf, values, words):
    with h5py.File(netcdf, "a") as file:
        file.create_dataset("odd", **values)
    refused(netcdf, words)


def test_groups_and_attributes(netcdf):
    with h5py.File(netcdf, "a") as file:
        file["energy"].attrs.create("odd", np.array([(1.0, 2)], dtype=[("a", "f8"), ("b", "i4")]))
    refused(netcdf, "attribute 'odd' of variable 'energy' is of type")
    with h5py.File(netcdf, "a") as file:
        del file["energy"].attrs["odd"]
        file.create_group("inside")
    refused(netcdf, "'inside' is a group")


# ---------------------------------------------------------------- meaning


def rewritten(netcdf, change):
    """Write the dataset again after a change, under the same name."""
    dataset = xr.load_dataset(netcdf, engine="h5netcdf", decode_times=False)
    found = change(dataset)
    (dataset if found is None else found).to_netcdf(netcdf, engine="h5netcdf")
    return netcdf


def set_at(name, index, value):
    def change(dataset):
        values = dataset[name].values.copy()
        values[index] = value
        return dataset.assign({name: dataset[name].copy(data=values)})

    return change


def attribute(name, **values):
    return lambda dataset: (dataset[name].attrs if name else dataset.attrs).update(values)


def scaled(dataset):
    dataset["momentum"].encoding.update(_FillValue=float(dataset["momentum"].values[3, 1]))


@pytest.mark.long_after(5)
@pytest.mark.parametrize(("change", "words"), [
    (set_at("momentum", (4, 1), np.nan), r"momentum of sample 4 is not a finite number; got nan at index \(4, 1\)"),
    (set_at("time", 3, np.nan), "time of sample 3 is not a finite number"),
    (set_at("time", 3, np.inf), "time of sample 3 is not a finite number; got inf"),
    (set_at("energy", 2, np.nan), "energy of sample 2 is not a finite number"),
    (set_at("angular_velocity", (5, 0), -np.inf), "angular velocity of sample 5"),
    (set_at("attitude", 5, 1e300), "attitude of sample 5 is not a unit quaternion"),
    (set_at("attitude", 5, 0.3), "attitude of sample 5 is not a unit quaternion"),
    (set_at("principal_moments", 1, np.nan), "principal moments must be finite"),
    (set_at("principal_moments", 1, -2.0), "principal moments must be positive"),
    (set_at("principal_axes", (1, 1), 0.5), "principal_axes must be a rotation"),
    (set_at("principal_axes", (1, 1), 1e300), "principal_axes must be a rotation"),
    (attribute(None, source=["a", "b"]), "not one that polhode wrote"),
    (lambda d: d.assign(mass=np.nan), "mass must be finite"),
    (scaled, r"momentum of sample 3 is not a finite number; got nan at index \(3, 1\)"),
    (attribute("energy", role="leader"), "role of 'energy' must be one of invariant"),
    (attribute("energy", role=[1, 2]), "role of 'energy' must be one of"),
    (attribute("energy", role="state"), "'energy' needs the attribute place"),
    (attribute("energy", drift=-np.inf), "drift of 'energy' must be a finite number"),
    (attribute("energy", drift="much"), "drift of 'energy' must be a finite number"),
    (attribute("energy", drift=[1.0, 2.0]), "drift of 'energy' must be a finite number"),
    (lambda d: d["energy"].attrs.pop("role") and None, "variable 'energy' is unknown"),
    (lambda d: d.isel(quaternion=slice(3)), r"'attitude' is along .*\(20, 3\)"),
    (lambda d: d.isel(axis=slice(2)), "is along|must be along"),
    (lambda d: d.transpose(), "'attitude' is along .*quaternion, time"),
    (lambda d: d.drop_vars(["attitude", "momentum", "angular_velocity"]), "neither attitude nor momentum"),
    (lambda d: d.drop_vars("principal_moments"), "principal_axes need principal_moments"),
    (lambda d: d.assign(momentum=d["momentum"].astype(str)), "'momentum' must be real numbers"),
    (lambda d: d.assign(momentum=d["momentum"].isel(time=0)), "'momentum' is along"),
    (lambda d: d.assign(attitude=d["attitude"].expand_dims("batch_0")), "'momentum' is along"),
    (lambda d: d.assign_coords(time=[str(k) for k in range(20)]), "'time' must be real numbers"),
    (attribute(None, body_frame="SC", spice_id="five", object_name="a", reference_frame="b", epoch="c",
               time_system="UTC"), "spice_id must be a whole number"),
    (attribute(None, body_frame="SC"), "object_name must be text; got None"),
    (attribute(None, body_frame=5), "must be text"),
])  # fmt: skip
def test_what_is_no_trajectory(netcdf, change, words):
    refused(rewritten(netcdf, change), words)


def test_what_another_tool_may_change(netcdf):
    """Other types of numbers, which are said, smaller files and further attributes leave the motion what it is."""
    before = formats.read_dataset(netcdf)

    def change(dataset):
        dataset.attrs["history"] = "copied"
        for name in dataset.data_vars:
            packed = dataset[name].ndim > 0
            dataset[name].encoding.update(zlib=packed, shuffle=packed, fletcher32=packed)
        return dataset.assign(momentum=dataset["momentum"].astype("f4"))

    rewritten(netcdf, change)
    with pytest.warns(UserWarning, match=r"the momentum is in single precision \(float32\)") as said:
        after = formats.read_dataset(netcdf)
    assert len(said) == 1
    assert np.array_equal(before.attitude, after.attitude)
    assert np.array_equal(before.momentum.astype("f4"), after.momentum)


def test_an_invariant_that_one_of_a_batch_does_not_have(tmp_path):
    """On a singular leaf an invariant is NaN throughout; a single NaN, or one of all copies, is damage."""
    batch = ph.FreeMotion((1.0, 2.0, 3.0), momentum=np.array([[0.3, 0.4, 0.5], [0.1, 0.2, 0.3]])).sample(TIMES)
    energy = np.array(batch.invariants["energy"])
    for rows, times, allowed in ((0, slice(None), True), (0, 3, False), (slice(None), slice(None), False)):
        values = energy.copy()
        values[rows, times] = np.nan
        path = formats.write_dataset(replace(batch, invariants={"energy": values}), tmp_path / "motion.nc")
        if allowed:
            assert np.array_equal(formats.read_dataset(path).invariants["energy"], values, equal_nan=True)
        else:
            refused(path, "energy of sample")


def test_labels_come_back(tmp_path):
    labels = AttitudeLabels("BOX", spice_id=-77, comments=("one", "two"))
    read = replace(MOTION.sample(TIMES), source=formats.Recording(labels=labels), momentum=None)
    assert formats.read_dataset(formats.write_dataset(read, tmp_path / "motion.nc")).source.labels == labels


def test_a_folder_that_is_no_store(tmp_path):
    with pytest.raises(InvalidInput, match="is a folder, but not a Zarr store"):
        formats.read_dataset(tmp_path)


@pytest.mark.parametrize("name", ["outcome", "event", "outcome_message"])
@pytest.mark.parametrize("value", [["arrived"], {"a": 1}, 3, True])
def test_an_outcome_that_is_no_text(store, name, value):
    path = store / ".zattrs"
    path.write_text(json.dumps(json.loads(path.read_text()) | {name: value}))
    refused(store, f"attribute {name} must be")


@pytest.mark.parametrize(("plan", "why"), [
    ("Taylor", "Expecting value"), (3, "must be str"), ("[]", "must have `stepping`"),
    ('{"stepping": "by hand", "method": "Taylor"}', "not a valid Stepping"),
    ('{"stepping": "Taylor series", "method": "Taylor", "order": "24"}', "`order` cannot be '24'"),
    ('{"stepping": "Taylor series", "method": "Taylor", "copies": true}', "`copies` cannot be True"),
    ('{"stepping": "Taylor series", "method": "Taylor", "speed": 1}', "a plan has no speed"),
    ('{"stepping": "Taylor series", "method": "Taylor", "engine": null}', "`engine` cannot be None"),
    ('{"stepping": "Taylor series", "method": "Taylor", "copies": -1}', "`copies` cannot be -1"),
    ('{"stepping": "Taylor series", "method": "Taylor", "step": NaN}', "`step` cannot be nan"),
    ('{"stepping": "Taylor series", "method": "Taylor", "step": 1' + 400 * "0" + "}", "cannot be <whole number of"),
    ('{"stepping": "Taylor series", "method": "Taylor", "otherwise": {}}', "must have `stepping`"),
    ('{"stepping": ' * 100_000, "the plan of the motion is not one"),
])  # fmt: skip
def test_a_plan_that_is_none(store, plan, why):
    path = store / ".zattrs"
    path.write_text(json.dumps(json.loads(path.read_text()) | {"plan": plan}))
    refused(store, why)


@pytest.mark.long_after(2)
@pytest.mark.parametrize(("name", "unit", "written"), [
    ("time", "minutes", "s"), ("time", "fortnights^999999", "s"), ("momentum", "g cm2/s", "kg m2 s-1"),
    ("angular_velocity", "deg s-1", "rad s-1"), ("principal_moments", "lb ft2", "kg m2"), ("mass", "lb", "kg"),
])  # fmt: skip
def test_other_units_are_refused(netcdf, name, unit, written):
    refused(rewritten(netcdf, attribute(name, units=unit)), f"must be in {written}; got {unit!r}".replace("^", r"\^"))


def test_units_that_are_numbers_are_refused(netcdf):
    """As damaged files have them."""
    refused(rewritten(netcdf, attribute("momentum", units=np.array([1, 2]))), "momentum must be in kg m2 s-1; got ")


def test_a_quantity_without_its_unit_is_in_the_usual_one(netcdf):
    rewritten(netcdf, lambda dataset: dataset["momentum"].attrs.pop("units") and None)
    assert np.array_equal(formats.read_dataset(netcdf).momentum, MOTION.momentum(TIMES))
