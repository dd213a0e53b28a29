"""Checks that a dataset is a trajectory: variables along the right dimensions, finite real numbers, known roles."""

from __future__ import annotations

import warnings
from pathlib import Path
from typing import TYPE_CHECKING, Any, NoReturn

import numpy as np

from polhode.errors import FormatError, shown

if TYPE_CHECKING:
    import xarray

ROLES = ("invariant", "balance", "received", "observed", "state", "error estimate", "memory")
COMPONENTS = {"body": "axis", "given": "given_axis", "space": "space_axis"}  # dimension of a vector, by its frame
VECTORS = {"attitude": ("quaternion", 4), "momentum": ("axis", 3), "angular_velocity": ("axis", 3)}
FRAME = {  # name → dimensions and shape
    "principal_moments": (("axis",), (3,)),
    "principal_axes": (("given_axis", "axis"), (3, 3)),
    "center_of_mass": (("given_axis",), (3,)),
    "pivot": (("given_axis",), (3,)),
    "mass": ((), ()),
}
UNITS = {
    "time": "s", "attitude": "1", "momentum": "kg m2 s-1", "angular_velocity": "rad s-1", "principal_moments": "kg m2",
    "principal_axes": "1", "center_of_mass": "m", "pivot": "m", "mass": "kg",
}  # fmt: skip
NEEDED_OF_FRAME = ("principal_moments", "principal_axes", "center_of_mass")
COUNTED = "number_of_"  # attributes: steps and iterations
PLAN = "plan"  # attribute: how the motion was computed, in JSON
MEMORY = "memory_"  # variables of what a method carries along, with their number behind it
COMPLEX_PART = "complex_part"  # last dimension of complex states: real, imaginary
ORTHOGONAL = 1e-6  # how far principal axes of a file may be from orthogonal, as quaternions from unit length


def check_variables(path: Path, dataset: xarray.Dataset) -> None:
    """Refuse a dataset whose variables are not those of a trajectory.

    Raises:
        FormatError: naming the variable, and the sample where one is wrong.
    """
    variables = {str(name): variable for name, variable in dataset.variables.items()}
    time = variables.get("time")
    if time is None or time.dims != ("time",):
        _refuse(path, "has no time, a variable along its own dimension")
    for name, variable in variables.items():
        role = variable.attrs.get("role", ROLES[0])
        if not (isinstance(role, str) and role in ROLES):
            _refuse(path, f"the role of {shown(name)} must be one of {', '.join(ROLES)}; got {shown(role)}")
    parts = [name for name in (*VECTORS, "state") if name in variables]
    parts += [name for name, variable in variables.items() if variable.attrs.get("role") == "state"]
    if not parts:
        _refuse(path, "has neither attitude nor momentum nor another state")
    batch = tuple(dim for dim in map(str, variables[parts[0]].dims) if dim.startswith("batch_"))
    for name, variable in variables.items():
        _check_unit(path, name, variable)
        if name in FRAME:
            _check_frame(path, name, variable)
        elif name not in dataset.coords:
            _check_along_time(path, name, variable, (*batch, "time"))
        if name in dataset.data_vars or name == "time":
            _check_numbers(path, name, variable, bool(batch))
    if "principal_axes" in variables:
        _check_axes(path, variables)


def _refuse(path: Path, what: str) -> NoReturn:
    raise FormatError(f"{path}: {what}. The file is damaged, or changed by another tool; write it again with polhode.")


def _check_along_time(path: Path, name: str, variable: Any, along: tuple[str, ...]) -> None:
    role, dims = variable.attrs.get("role"), tuple(map(str, variable.dims))
    if name in VECTORS:
        last, count = VECTORS[name]
        fits = dims == (*along, last) and variable.shape[-1] == count
    elif role == "received":
        fits = dims == along
    elif role == "state":
        known = (f"{name}_number", *COMPONENTS.values())
        fits = dims == along or (dims[:-1] == along and dims[-1] in known and variable.shape[-1] > 1)
    elif role == "error estimate":
        fits = dims == along[:-1]
    elif role == "memory":
        own = dims[:-1] if dims[-1:] == (COMPLEX_PART,) and variable.shape[-1] == 2 else dims
        fits = name.removeprefix(MEMORY).isdecimal() and own == tuple(f"{name}_axis_{k}" for k in range(len(own)))
    elif role is not None:
        fits = dims[: len(along)] == along and len(dims) <= len(along) + 1
    elif name == "state":
        own = dims[len(along) :]
        if own[-1:] == (COMPLEX_PART,) and variable.shape[-1] == 2:
            own = own[:-1]
        fits = dims[: len(along)] == along and all(dim.startswith("component_") for dim in own)
    else:
        _refuse(path, f"variable {shown(name)} is unknown, as it has no role")
    if not fits:
        has = f"({', '.join(dims)}) of lengths {variable.shape}"
        _refuse(path, f"{shown(name)} is along {shown(has)}, and must be along ({', '.join(along)}) and its own axes")
    if role == "state":
        for key, kind in (("place", int | np.integer), ("units", str), ("long_name", str)):
            if not isinstance(variable.attrs.get(key), kind):
                _refuse(path, f"{shown(name)} needs the attribute {key}; got {shown(variable.attrs.get(key))}")
    drift = variable.attrs.get("drift", 0.0)
    if not (isinstance(drift, float | int | np.floating | np.integer) and abs(drift) < np.inf):
        _refuse(path, f"the drift of {shown(name)} must be a finite number; got {shown(drift)}")


def _check_unit(path: Path, name: str, variable: Any) -> None:
    """Refuse a quantity in another unit than polhode writes; one without a unit is taken to be in it."""
    unit = variable.attrs.get("units", UNITS.get(name))
    if name in UNITS and not (isinstance(unit, str) and unit == UNITS[name]):
        _refuse(path, f"{name.replace('_', ' ')} must be in {UNITS[name]}; got {shown(str(unit))}")


def _check_numbers(path: Path, name: str, variable: Any, batched: bool) -> None:
    """Refuse what is not finite; of a batch an invariant may be NaN throughout a copy that does not have it."""
    values = np.asarray(variable.values)
    if values.dtype.kind not in "fiu":
        _refuse(path, f"{shown(name)} must be real numbers; got type {shown(str(values.dtype))}")
    if values.dtype.kind == "f" and values.dtype.itemsize < 8:
        what = f"the {name.replace('_', ' ')} is in single precision ({values.dtype}), which keeps seven digits"
        warnings.warn(f"{path}: {what}. Write double precision for comparisons to more.", stacklevel=2)
    wrong = ~np.isfinite(values)
    if batched and variable.attrs.get("role") in ("invariant", "balance"):
        missing = np.isnan(values).all(axis=variable.dims.index("time"), keepdims=True)
        wrong &= ~missing | missing.all()
    if not wrong.any():
        return
    place = tuple(np.argwhere(wrong)[0].tolist())
    got = shown(float(values[place]))
    if "time" in variable.dims:
        what = f"the {name.replace('_', ' ')} of sample {place[variable.dims.index('time')]}"
        _refuse(path, f"{what} is not a finite number; got {got} at index {place}")
    _refuse(path, f"{name.replace('_', ' ')} must be finite; got {got} at index {place}")


def _check_frame(path: Path, name: str, variable: Any) -> None:
    dims, shape = FRAME[name]
    if tuple(variable.dims) != dims or variable.shape != shape:
        _refuse(path, f"{name} must be along {dims} of lengths {shape}; it is along {shown(variable.dims)} of "
                      f"{shown(variable.shape)}")


def _check_axes(path: Path, variables: dict[str, Any]) -> None:
    if missing := [name for name in NEEDED_OF_FRAME if name not in variables]:
        _refuse(path, f"principal_axes need {' and '.join(missing)} together with them")
    axes = np.asarray(variables["principal_axes"].values, dtype=float)
    with np.errstate(over="ignore", invalid="ignore"):  # what overflows is not orthogonal
        off = np.abs(axes.T @ axes - np.eye(3)).max()
    if not (off <= ORTHOGONAL and np.linalg.det(axes) > 0):
        _refuse(path, f"principal_axes must be a rotation; its columns are off by {off:.3g}")
    for name in ("principal_moments", "mass"):
        values = np.atleast_1d(variables[name].values) if name in variables else np.ones(1)
        if (values < 0).any() or values.max() == 0:
            _refuse(path, f"{name.replace('_', ' ')} must be positive; got {shown(values.tolist())}")
