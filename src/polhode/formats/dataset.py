"""Trajectories as labelled arrays with units, and as NetCDF files and Zarr stores."""

from __future__ import annotations

import dataclasses
import errno
import json
from io import BytesIO
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from polhode._base import check
from polhode._base.extras import needing
from polhode.errors import InvalidInput
from polhode.formats.dataset_rules import COMPLEX_PART, COMPONENTS, COUNTED, MEMORY, PLAN, UNITS
from polhode.formats.labels import AttitudeLabels, find_labels
from polhode.formats.opening import MB, read_file
from polhode.formats.paths import as_path, write_whole
from polhode.motion._outcome import Outcome
from polhode.motion._trajectory import Trajectory
from polhode.motion.frame import BodyFrame

if TYPE_CHECKING:
    import xarray

Named = dict[str, Any]
_VECTORS = {
    "momentum": (UNITS["momentum"], "angular momentum along the body axes"),
    "angular_velocity": (UNITS["angular_velocity"], "angular velocity along the body axes"),
}


def as_dataset(trajectory: Trajectory, attributes: dict[str, str] | None = None) -> xarray.Dataset:
    """Return a trajectory as an xarray Dataset whose variables carry units and frames.

    Dimensions are ``body`` axes (``batch_0``, …) if any, ``time``, ``quaternion`` (w, x, y, z), ``axis`` (1, 2, 3)
    and ``space_axis`` (x, y, z). Complex states have ``complex_part`` (real, imaginary) behind their own axes.

    Args:
        trajectory: plain arrays; its frame is added, with the mass properties. One with a frame that is sampled from a
            motion made by ``from_body`` is turned to the principal axes; others are along them already.
        attributes: global attributes to add.

    Raises:
        InvalidInput: for what is not a trajectory.
    """
    with needing("Datasets need"):
        import xarray as xr

    check.instance("trajectory", trajectory, Trajectory, "a Trajectory, as `simulate` gives it")

    return xr.Dataset(*_describe(trajectory, attributes))


def _describe(trajectory: Trajectory, attributes: dict[str, str] | None) -> tuple[Named, Named, dict[str, Any]]:
    """Return variables and coordinates, each (dimensions, values, attributes), and global attributes."""
    frame = trajectory.frame
    if frame is not None:
        trajectory = trajectory.along("principal")
    times = np.asarray(trajectory.times)
    batch = [f"batch_{k}" for k in range(len(trajectory.batch_shape))]
    clock = ("time", times, {"units": "s", "long_name": "time"})
    coordinates: Named = {"time": clock, "axis": ("axis", [1, 2, 3])}
    if trajectory.attitude is not None:
        coordinates["quaternion"] = ("quaternion", ["w", "x", "y", "z"])
    if "momentum_space" in trajectory.invariants | trajectory.balances:
        coordinates["space_axis"] = ("space_axis", ["x", "y", "z"])
    if frame is not None or any(part.frame == "given" for part in trajectory.layout.parts):
        coordinates["given_axis"] = ("given_axis", ["x", "y", "z"])
    if any(map(np.iscomplexobj, (trajectory.states, *(trajectory.memory or ())))):
        coordinates[COMPLEX_PART] = (COMPLEX_PART, ["real", "imaginary"])
    variables = _state_variables(trajectory, batch) | _balance_variables(trajectory, batch)
    if trajectory.error_estimate is not None and np.isfinite(trajectory.error_estimate).all():
        meaning = "estimated largest error of the states, relative to the size of attitude and momentum"
        note = {"units": "1", "long_name": meaning, "role": "error estimate"}
        variables["error_estimate"] = (batch, np.asarray(trajectory.error_estimate, dtype=float), note)
    variables |= _memory_variables(trajectory)
    if frame is not None:
        variables |= _frame_variables(frame)
        for name in ("attitude", *_VECTORS):
            if name in variables:
                variables[name][2]["comment"] = "body axes are the principal ones; principal_axes has them"
    header = {"Conventions": "CF-1.11", "source": "polhode", **_outcome_attributes(trajectory.outcome)}
    if trajectory.plan is not None:
        header[PLAN] = json.dumps(trajectory.plan.as_json_dict(), ensure_ascii=False)
    header |= {f"{COUNTED}{name}": count for name, count in trajectory.statistics.items()}
    return variables, coordinates, header | label_attributes(find_labels(trajectory)) | (attributes or {})


def _state_variables(trajectory: Trajectory, batch: list[str]) -> Named:
    """Return attitude, vectors and the further parts of the states, along these axes of the batch."""
    variables: Named = {}
    if trajectory.attitude is not None:
        note = {"units": "1", "long_name": "attitude quaternion, scalar first, body to space"}
        variables["attitude"] = ([*batch, "time", "quaternion"], np.asarray(trajectory.attitude), note)
    for name, (units, meaning) in _VECTORS.items():
        values = getattr(trajectory, name)
        if values is not None:
            note = {"units": units, "long_name": meaning}
            variables[name] = ([*batch, "time", "axis"], np.asarray(values), note)
    layout, further = trajectory.layout, trajectory.further_parts()
    for part, values in further:
        note = {"units": part.unit, "long_name": part.meaning, "role": "state", "place": layout.place(part.name).start}
        along = COMPONENTS.get(part.frame, f"{part.name}_number")
        variables[part.name] = ([*batch, "time", along][: np.ndim(values)], np.asarray(values), note)
    if not further and not variables:
        dims = [*batch, "time", *(f"component_{k}" for k in range(layout.axes))]
        states = np.asarray(trajectory.states)
        if np.iscomplexobj(states):  # NetCDF has no complex numbers
            dims, states = [*dims, COMPLEX_PART], np.stack([np.real(states), np.imag(states)], axis=-1)
        variables["state"] = (dims, states, {"long_name": "point of the dual"})
    return variables


def _balance_variables(trajectory: Trajectory, batch: list[str]) -> Named:
    """Return invariants, balances, what was received and what is observed, along these axes of the batch."""
    variables: Named = {}
    for name, values in trajectory.received.items():
        units, meaning = trajectory.quantity(name).unit, f"{name.replace('_', ' ')} received"
        note = {"units": units, "long_name": meaning, "role": "received"}
        variables[f"{name}_received"] = ([*batch, "time"], np.asarray(values), note)
    for name, values in trajectory.observed.items():
        units, meaning, _ = trajectory.quantity(name)
        note = {"units": units, "long_name": meaning, "role": "observed"}
        variables[name] = ([*batch, "time", f"{name}_number"][: np.ndim(values)], np.asarray(values), note)
    lengths: dict[str, int] = {}
    for name, values in (trajectory.invariants | trajectory.balances).items():
        units, meaning, of_copies = trajectory.quantity(name)
        components = "space_axis" if name == "momentum_space" else "axis"
        if of_copies:
            count = np.shape(values)[-1]
            components = "copy" if lengths.setdefault("copy", count) == count else f"copy_{count}"
        dims = [*batch, "time", components][: np.ndim(values)]
        role = "invariant" if name in trajectory.invariants else "balance"
        note: dict[str, Any] = {"units": units, "long_name": meaning, "role": role}
        if name in trajectory.drift and not batch:
            note["drift"] = float(np.max(trajectory.drift[name]))
        variables[name] = (dims, np.asarray(values), note)
    return variables


def _memory_variables(trajectory: Trajectory) -> Named:
    """Return the integrator's memory, each array along dimensions of its own."""
    variables: Named = {}
    for k, values in enumerate(trajectory.memory or ()):
        name, values = f"{MEMORY}{k}", np.asarray(values)
        dims, more = [f"{name}_axis_{j}" for j in range(values.ndim)], []
        if np.iscomplexobj(values):
            more, values = [COMPLEX_PART], np.stack([np.real(values), np.imag(values)], axis=-1)
        note = {"long_name": "what the method carries along at the last time", "role": "memory"}
        variables[name] = ([*dims, *more], values.astype(float), note)
    return variables


def _outcome_attributes(outcome: Outcome) -> dict[str, str]:
    """Return how the motion ended, in words and, for reading back, part by part."""
    attributes = {"status": str(outcome), "outcome": outcome.ending.value}
    attributes |= {} if outcome.event is None else {"event": outcome.event}
    return attributes | ({"outcome_message": outcome.message} if outcome.message else {})


def label_attributes(labels: AttitudeLabels | None) -> dict[str, str]:
    """Return labels as global attributes of a dataset, as ``read_dataset`` takes them back; none without labels."""
    if labels is None:
        return {}
    entries = {key: value for key, value in dataclasses.asdict(labels).items() if value not in (None, ())}
    return {key: "\n".join(value) if key == "comments" else str(value) for key, value in entries.items()}


def _frame_variables(frame: BodyFrame) -> dict[str, Any]:
    variables: dict[str, Any] = {
        "principal_moments": ("axis", np.asarray(frame.moments),
                              {"units": "kg m2", "long_name": "moments about the principal axes"}),
        "principal_axes": (("given_axis", "axis"), np.asarray(frame.axes),
                           {"units": "1", "long_name": "principal axes, by columns, in the given ones"}),
        "center_of_mass": ("given_axis", np.asarray(frame.center_of_mass),
                           {"units": "m", "long_name": "centre of mass in the given axes"}),
    }  # fmt: skip
    if frame.pivot is not None:
        note = {"units": "m", "long_name": "fixed point in the given axes"}
        variables["pivot"] = ("given_axis", np.asarray(frame.pivot), note)
    if frame.mass is not None:
        variables["mass"] = ((), frame.mass, {"units": "kg", "long_name": "mass"})
    return variables


def write_dataset(trajectory: Trajectory, path: str | Path, attributes: dict[str, str] | None = None) -> Path:
    """Write a trajectory as NetCDF; the file appears whole or not at all.

    Raises:
        InvalidInput: if the file cannot be written there, or for states that are not finite.
    """
    _check_finite(trajectory)
    return write_variables(path, *_describe(trajectory, attributes))


def write_variables(path: str | Path, variables: Named, coordinates: Named, header: dict[str, Any]) -> Path:
    """Write NetCDF as xarray would, whose import takes longer than most reports; the file appears whole or not at all.

    Args:
        path: the file.
        variables, coordinates: name → (dimensions, values, attributes).
        header: global attributes.

    Raises:
        InvalidInput: if the file cannot be written there.
    """
    with needing("NetCDF files need"):
        import h5netcdf
        import h5py

    path = as_path("path", path)
    # HDF5 would try again to write what a full disk refused, and crash as Python ends: it gets memory, not the disk
    packed = BytesIO()
    with h5netcdf.File(packed, "w") as store:
        store.attrs.update(header)
        for name, (dims, values, *notes) in (coordinates | variables).items():
            dims, values = (dims,) if isinstance(dims, str) else tuple(dims), np.asarray(values)
            for dimension, length in zip(dims, values.shape, strict=True):
                if dimension not in store.dimensions:
                    store.dimensions[dimension] = length
            text = values.dtype.kind == "U"
            variable = store.create_variable(name, dims, h5py.string_dtype() if text else values.dtype)
            variable[...] = values.astype(object) if text else values
            for note in notes:
                variable.attrs.update(note)
    with write_whole(path) as draft:
        draft.write_bytes(packed.getbuffer())
    return path


def write_zarr(trajectory: Trajectory, path: str | Path, attributes: dict[str, str] | None = None) -> Path:
    """Write a trajectory as a Zarr store (format 2), a folder; it appears whole or not at all.

    Raises:
        InvalidInput: if it cannot be written there, for states that are not finite, or if zarr is not installed.
    """
    with needing("Zarr stores need"):
        import zarr.storage
    path = as_path("path", path)
    _check_finite(trajectory)
    dataset = as_dataset(trajectory, attributes)
    # zarr's own thread would go on writing while an interrupted draft is removed: it gets memory, not the disk
    packed: dict[str, Any] = {}
    # format 3 has no settled form for the text that names a quaternion's components
    dataset.to_zarr(zarr.storage.MemoryStore(packed), zarr_format=2, consolidated=True)
    with write_whole(path, replaces=_is_our_store) as draft:
        for key, part in packed.items():
            place, data = draft / key, part.to_bytes()
            place.parent.mkdir(parents=True, exist_ok=True)
            place.write_bytes(data)
            if place.read_bytes() != data:
                raise OSError(errno.EIO, f"what was written is not what is read for {key}")
    return path


def _check_finite(trajectory: Trajectory) -> None:
    """Refuse a trajectory that would not be read back: a copy of a batch has no states after its end."""
    wrong = np.argwhere(~np.isfinite(np.asarray(trajectory.states)))
    if not len(wrong):
        return
    copies = len(trajectory.batch_shape)
    copy, k = tuple(wrong[0][:copies].tolist()), int(wrong[0][copies])
    whose = f" of copy {copy if copies > 1 else copy[0]}" if copies else ""
    raise InvalidInput(
        f"a dataset holds finite numbers only; the states{whose} are not from {float(trajectory.times[k]):.9g} s on. "
        "Follow the motion to an earlier time, or each copy to its own end."
    )


def _is_our_store(path: Path) -> bool:
    """Whether a folder is the store of a motion, as written here; a sweep's store also has a hidden folder."""
    from polhode.formats.zarr_gate import DOCUMENTS

    try:
        attributes = json.loads(read_file(path / ".zattrs", "Zarr", MB))
    except (ValueError, RecursionError):
        return False
    hidden = {entry.name for entry in path.iterdir() if entry.name.startswith(".")}
    return isinstance(attributes, dict) and attributes.get("source") == "polhode" and hidden <= set(DOCUMENTS)
