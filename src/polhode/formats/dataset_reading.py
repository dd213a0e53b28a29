"""Datasets that polhode wrote, read back as trajectories, bit for bit."""

from __future__ import annotations

import dataclasses
import json
import sys
import warnings
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from polhode._base.extras import needing
from polhode.errors import FormatError, InvalidInput, shown
from polhode.formats.attitude_checks import DAMAGED, check_recorded
from polhode.formats.dataset_rules import (
    COMPLEX_PART,
    COMPONENTS,
    COUNTED,
    MEMORY,
    NEEDED_OF_FRAME,
    PLAN,
    ROLES,
    check_variables,
)
from polhode.formats.hdf5_gate import check_hdf5
from polhode.formats.labels import AttitudeLabels, Recording
from polhode.formats.opening import MB, check_is_file, is_folder
from polhode.formats.paths import as_path
from polhode.formats.zarr_gate import check_store
from polhode.motion._layout import ANGULAR_VELOCITY, ATTITUDE, MOMENTUM, Quantity, StateLayout, StatePart
from polhode.motion._outcome import Ending, Outcome
from polhode.motion._plan import MotionPlan, Stepping
from polhode.motion._trajectory import Trajectory
from polhode.motion.frame import BodyFrame
from polhode.types import Array

if TYPE_CHECKING:
    import xarray

NEEDED_LABELS = ("object_name", "reference_frame", "body_frame", "epoch", "time_system")
LARGEST_FILE = 4000 * MB  # it is held in memory whole


def read_dataset(path: str | Path) -> Trajectory:
    """Return the trajectory in a NetCDF file or a Zarr store that polhode wrote.

    All arrays are those that were written, bit for bit, as doubles even if another tool changed their type. The states
    are what the file has of them: the attitude, then the momentum. The source is a ``Recording``.

    Raises:
        InvalidInput: if the file is missing, or zarr is for a store.
        FormatError: if it is not a dataset of polhode's, or a damaged one.
    """
    path = as_path("path", path)
    dataset = _load(path)
    if str(dataset.attrs.get("source")) != "polhode" or "time" not in dataset.coords:
        raise FormatError(f"{path}: is a dataset, but not one that polhode wrote. Read it with xarray.")
    check_variables(path, dataset)
    variables: dict[str, Any] = {str(name): variable for name, variable in dataset.data_vars.items()}
    arrays = {name: _doubles(variable.values) for name, variable in variables.items()}
    roles: dict[str, list[str]] = {role: [] for role in ROLES}
    for name, variable in variables.items():
        if "role" in variable.attrs:
            roles[variable.attrs["role"]].append(name)
    check_recorded(path, dataset["time"].values, arrays.get("attitude"), arrays.get("angular_velocity"))
    roles["state"].sort(key=lambda name: variables[name].attrs["place"])
    own = sum(str(dim).startswith("component_") for dim in dataset.dims)
    if "state" in dataset and dataset["state"].dims[-1] == COMPLEX_PART:
        arrays["state"] = arrays["state"][..., 0] + 1j * arrays["state"][..., 1]
    layout, states = _states(arrays, {name: variables[name] for name in roles["state"]}, own)
    kept = {name: variables[name].attrs for name in (*roles["invariant"], *roles["balance"], *roles["observed"])}
    return Trajectory(
        source=_make_recording(path, dataset),
        frame=_frame(variables),
        times=_doubles(dataset["time"].values),
        states=states,
        layout=layout,
        attitude=arrays.get("attitude"),
        momentum=arrays.get("momentum"),
        angular_velocity=arrays.get("angular_velocity"),
        invariants={name: arrays[name] for name in roles["invariant"]},
        balances={name: arrays[name] for name in roles["balance"]},
        received={name.removesuffix("_received"): arrays[name] for name in roles["received"]},
        observed={name: arrays[name] for name in roles["observed"]},
        drift={name: variable.attrs["drift"] for name, variable in variables.items() if "drift" in variable.attrs},
        quantities={
            key: Quantity(str(x.get("units", "")), str(x.get("long_name", "")), _of_copies(variables[key]))
            for key, x in kept.items()
        },
        outcome=_outcome(path, dataset.attrs),
        error_estimate=next((arrays[name] for name in roles["error estimate"]), None),
        statistics=_statistics(path, dataset.attrs),
        plan=_plan(path, dataset.attrs),
        memory=_memory({name: variables[name] for name in roles["memory"]}),
    )


def _statistics(path: Path, attributes: Any) -> dict[str, int]:
    counts = {str(key).removeprefix(COUNTED): x for key, x in attributes.items() if str(key).startswith(COUNTED)}
    for name, count in counts.items():
        if not isinstance(count, int | np.integer) or count < 0:
            raise FormatError(f"{path}: the number of {name} must be a whole number; got {shown(count)}. {DAMAGED}")
    return {name: int(count) for name, count in counts.items()}


def _plan(path: Path, attributes: Any) -> MotionPlan | None:
    if (text := attributes.get(PLAN)) is None:
        return None
    try:
        return make_plan(json.loads(text))
    except (TypeError, ValueError, RecursionError) as error:
        raise FormatError(f"{path}: the plan of the motion is not one: {error}. {DAMAGED}") from None


def make_plan(entries: Any) -> MotionPlan:
    """Return the plan that ``MotionPlan.as_json_dict`` gave.

    Raises:
        ValueError: for anything else, naming what is wrong.
    """
    if not isinstance(entries, dict) or not {"stepping", "method"} <= entries.keys():
        raise ValueError("it must have `stepping` and `method`")
    if unknown := entries.keys() - {field.name for field in dataclasses.fields(MotionPlan)}:
        raise ValueError(f"a plan has no {', '.join(sorted(map(str, unknown)))}")
    for name, value in entries.items():
        if name != "otherwise" and not _may_be(name, value):
            raise ValueError(f"`{name}` cannot be {shown(value)}")
    rest = {name: value for name, value in entries.items() if name not in ("stepping", "otherwise")}
    nested = entries.get("otherwise")
    return MotionPlan(Stepping(entries["stepping"]), **rest, otherwise=None if nested is None else make_plan(nested))


def _may_be(name: str, value: Any) -> bool:
    """Whether a value of JSON may be that of a plan's field."""
    if name in ("order", "copies"):
        return isinstance(value, int) and not isinstance(value, bool) and 0 <= value < 2**63
    if name in ("step", "tolerance"):
        return isinstance(value, float | int) and not isinstance(value, bool) and 0.0 < value <= sys.float_info.max
    return isinstance(value, str)


def _memory(variables: dict[str, Any]) -> tuple[Array, ...] | None:
    arrays = []
    for name in sorted(variables, key=lambda name: int(name.removeprefix(MEMORY))):
        values = _doubles(variables[name].values)
        arrays.append(values[..., 0] + 1j * values[..., 1] if variables[name].dims[-1:] == (COMPLEX_PART,) else values)
    return tuple(arrays) or None


def _of_copies(variable: Any) -> bool:
    return str(variable.dims[-1]).startswith("copy")


def _load(path: Path) -> xarray.Dataset:
    with needing("Datasets need"):
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
                return _load_store(path)
            with needing("NetCDF files need"):  # xarray does not say so of its engine
                import h5netcdf  # noqa: F401
            check_hdf5(path)
            return xr.load_dataset(path, engine="h5netcdf", decode_times=False)
    except InvalidInput:
        raise
    except Exception:  # xarray's engines raise whatever their libraries raise
        kind = "Zarr store" if store else "NetCDF file"
        raise FormatError(f"{path}: cannot be read as a {kind}: it is broken or cut short. Write it again.") from None


def _load_store(path: Path) -> xarray.Dataset:
    import xarray as xr

    with needing("Zarr stores need"):
        import zarr
        from zarr.storage import LocalStore
    names = check_store(path)
    # a store by its path could be taken for an address; consolidated documents are copies that may say something else
    store: Any = LocalStore(path, read_only=True)
    for name in names:  # one by one: what fails in zarr's own loop over all is printed next to the message
        zarr.open_array(store, path=name, mode="r", zarr_format=2)
    return xr.load_dataset(store, engine="zarr", decode_times=False, consolidated=False, zarr_format=2)


def _doubles(values: Array) -> Array:
    """Return numbers as doubles, or pairs of them; the checks refuse all else later."""
    values = np.asarray(values)
    kind = {"f": np.float64, "i": np.float64, "u": np.float64, "c": np.complex128}.get(values.dtype.kind)
    return values if kind is None else values.astype(kind, copy=False)


def _states(arrays: dict[str, Array], further: dict[str, Any], own: int) -> tuple[StateLayout, Array]:
    """Return the states: one array, or attitude and momentum, and further parts behind them or in their stead."""
    if "state" in arrays:
        return StateLayout(axes=own), arrays["state"]
    vectors = [part for part in (ATTITUDE, MOMENTUM) if part.name in arrays]
    if further and min(variable.attrs["place"] for variable in further.values()) == 0:
        vectors = []
    parts = [*vectors, *(_part(name, variable) for name, variable in further.items())] or [ANGULAR_VELOCITY]
    columns = [arrays[part.name] if part.size > 1 else arrays[part.name][..., None] for part in parts]
    return StateLayout(tuple(parts)), np.concatenate(columns, axis=-1)


def _part(name: str, variable: Any) -> StatePart:
    """Return a part of the states; its last dimension, if not time, says its frame."""
    last = str(variable.dims[-1])
    frames = {dimension: frame for frame, dimension in COMPONENTS.items()}
    size = 1 if last == "time" else variable.shape[-1]
    return StatePart(name, size, variable.attrs["units"], variable.attrs["long_name"], frames.get(last, ""))


def _outcome(path: Path, attributes: Any) -> Outcome:
    """Return how the motion came to its end; files of older versions say it in words only."""
    known = {ending.value: ending for ending in Ending}
    said, event, message = (attributes.get(name) for name in ("outcome", "event", "outcome_message"))
    said = Ending.RECORDED.value if said is None else said
    if not isinstance(said, str) or said not in known:
        words = ", ".join(known)
        raise FormatError(f"{path}: the attribute outcome must be one of {words}; got {shown(said)}. {DAMAGED}")
    for name, text in (("event", event), ("outcome_message", message)):
        if not isinstance(text, str | None):
            raise FormatError(f"{path}: the attribute {name} must be text; got {shown(text)}. {DAMAGED}")
    return Outcome(known[said], event, message or "")


def _make_recording(path: Path, dataset: xarray.Dataset) -> Recording:
    attributes: dict[str, Any] = {str(key): value for key, value in dataset.attrs.items()}
    labels = _labels(path, attributes) if "body_frame" in attributes else None
    return Recording(str(attributes.get("title", "")), labels, attributes)


def _frame(variables: dict[str, Any]) -> BodyFrame | None:
    if "principal_axes" not in variables:
        return None
    moments, axes, center = (_doubles(variables[name].values) for name in NEEDED_OF_FRAME)
    mass, pivot = (_doubles(variables[name].values) if name in variables else None for name in ("mass", "pivot"))
    return BodyFrame(moments, axes, center, None if mass is None else float(mass), pivot)


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
