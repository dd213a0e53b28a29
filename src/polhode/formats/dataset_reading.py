"""Datasets that polhode wrote, read back as trajectories, bit for bit."""

from __future__ import annotations

import dataclasses
import warnings
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from polhode.bodies.frame import BodyFrame
from polhode.errors import FormatError, InvalidInput, shown
from polhode.formats.dataset_rules import ROLES, check_variables
from polhode.formats.given_axes import DAMAGED, check_recorded
from polhode.formats.hdf5_gate import check_hdf5
from polhode.formats.labels import AttitudeLabels
from polhode.formats.opening import MB, check_is_file, is_folder
from polhode.formats.zarr_gate import check_store
from polhode.trajectory import Trajectory

if TYPE_CHECKING:
    import xarray

Array = Any
NEEDED_LABELS = ("object_name", "reference_frame", "body_frame", "epoch", "time_system")
LARGEST_FILE = 4000 * MB  # it is held in memory whole


@dataclass(frozen=True)
class Recording:
    """What a file says of the motion it holds; the system of a trajectory read from a dataset.

    Attributes:
        title: what moved.
        frame: the principal axes that the trajectory is along; None where its axes are the given ones.
        labels: of the attitude, where the file has them.
        components: name → (unit, meaning) of the parts of a state that is no momentum.
        state_axes: how many axes of the states one state takes.
        attributes: the global attributes of the file.
    """

    title: str = ""
    frame: BodyFrame | None = None
    labels: AttitudeLabels | None = None
    components: dict[str, tuple[str, str]] = field(default_factory=dict)
    state_axes: int = 1
    attributes: dict[str, Any] = field(default_factory=dict)


def read_dataset(path: str | Path) -> Trajectory:
    """Return the trajectory in a NetCDF file or a Zarr store that polhode wrote.

    All arrays are those that were written, bit for bit. The states are what the file has of them: the attitude, then
    the momentum. The system is a ``Recording``.

    Raises:
        InvalidInput: if the file is missing, or zarr is for a store.
        FormatError: if it is no dataset of polhode's, or a damaged one.
    """
    path = Path(path)
    dataset = _loaded(path)
    if str(dataset.attrs.get("source")) != "polhode" or "time" not in dataset.coords:
        raise FormatError(f"{path}: is a dataset, but not one that polhode wrote. Read it with xarray.")
    check_variables(path, dataset)
    variables: dict[str, Any] = {str(name): variable for name, variable in dataset.data_vars.items()}
    arrays = {name: np.asarray(variable.values) for name, variable in variables.items()}
    roles: dict[str, list[str]] = {role: [] for role in ROLES}
    for name, variable in variables.items():
        if "role" in variable.attrs:
            roles[variable.attrs["role"]].append(name)
    check_recorded(path, dataset["time"].values, arrays.get("attitude"), arrays.get("angular_velocity"))
    roles["state"].sort(key=lambda name: variables[name].attrs["place"])
    return Trajectory(
        system=_recording(path, dataset, variables, roles["state"]),
        times=np.asarray(dataset["time"].values),
        states=_states(arrays, roles["state"]),
        attitude=arrays.get("attitude"),
        momentum=arrays.get("momentum"),
        angular_velocity=arrays.get("angular_velocity"),
        invariants={name: arrays[name] for name in roles["invariant"]},
        balances={name: arrays[name] for name in roles["balance"]},
        received={name.removesuffix("_received"): arrays[name] for name in roles["received"]},
        drift={name: variable.attrs["drift"] for name, variable in variables.items() if "drift" in variable.attrs},
        status=str(dataset.attrs.get("status", "")),
        error_estimate=next((arrays[name] for name in roles["error estimate"]), None),
    )


def _loaded(path: Path) -> xarray.Dataset:
    import xarray as xr

    if not is_folder(path):
        check_is_file(path, "NetCDF", LARGEST_FILE)
    elif not (path / ".zgroup").is_file():
        raise InvalidInput(f"{path}: is a folder, but not a Zarr store that polhode wrote. Check the path.")
    store = is_folder(path)
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # what is wrong is said below, in one message
            if store:
                return _loaded_store(path)
            check_hdf5(path)
            return xr.load_dataset(path, engine="h5netcdf", decode_times=False)
    except InvalidInput:
        raise
    except Exception:  # xarray's engines raise whatever their libraries raise
        kind = "Zarr store" if store else "NetCDF file"
        raise FormatError(f"{path}: cannot be read as a {kind}: it is broken or cut short. Write it anew.") from None


def _loaded_store(path: Path) -> xarray.Dataset:
    import xarray as xr

    try:
        import zarr
        from zarr.storage import LocalStore
    except ImportError:
        raise InvalidInput('Zarr stores need zarr, which is not installed; `pip install "polhode[zarr]"`.') from None
    names = check_store(path)
    # a store by its path could be taken for an address; consolidated documents are copies that may say something else
    store: Any = LocalStore(path, read_only=True)
    for name in names:  # one by one: what fails in zarr's own loop over all is printed beside the message
        zarr.open_array(store, path=name, mode="r", zarr_format=2)
    return xr.load_dataset(store, engine="zarr", decode_times=False, consolidated=False, zarr_format=2)


def _states(arrays: dict[str, Array], components: list[str]) -> Array:
    if "state" in arrays:
        return arrays["state"]
    if components:
        return np.stack([arrays[name] for name in components], axis=-1)
    return np.concatenate([arrays[name] for name in ("attitude", "momentum") if name in arrays], axis=-1)


def _recording(
    path: Path, dataset: xarray.Dataset, variables: dict[str, Any], components: list[str]
) -> Recording:
    attributes: dict[str, Any] = {str(key): value for key, value in dataset.attrs.items()}
    frame = None
    if "principal_axes" in variables:
        names = ("principal_moments", "principal_axes", "center_of_mass", "mass", "pivot")
        parts = [np.asarray(variables[name].values) if name in variables else None for name in names]
        mass = None if parts[3] is None else float(parts[3])
        frame = BodyFrame(parts[0], parts[1], parts[2], mass, parts[4])
    labels = _labels(path, attributes) if "body_frame" in attributes else None
    meanings = {name: (variables[name].attrs["units"], variables[name].attrs["long_name"]) for name in components}
    axes = sum(str(dim).startswith("component_") for dim in dataset.dims)
    return Recording(str(attributes.get("title", "")), frame, labels, meanings, axes or 1, attributes)


def _labels(path: Path, attributes: dict[str, Any]) -> AttitudeLabels:
    known: dict[str, Any] = {one.name: attributes.get(one.name) for one in dataclasses.fields(AttitudeLabels)}
    for one in dataclasses.fields(AttitudeLabels):
        needed = one.name in NEEDED_LABELS
        if not isinstance(known[one.name], str) and (needed or known[one.name] is not None):
            raise FormatError(f"{path}: the attribute {one.name} must be text; got {shown(known[one.name])}. {DAMAGED}")
    try:
        known["spice_id"] = None if known["spice_id"] is None else int(known["spice_id"])
    except ValueError:
        why = f"the attribute spice_id must be a whole number; got {shown(known['spice_id'])}"
        raise FormatError(f"{path}: {why}. {DAMAGED}") from None
    known["comments"] = tuple(known["comments"].split("\n")) if known["comments"] else ()
    return AttitudeLabels(**known)
