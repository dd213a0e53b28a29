"""Fits of throws and of attitudes as a NetCDF dataset."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from polhode.estimation._estimate import Estimate
from polhode.formats.dataset import write_variables
from polhode.measuring.attitudes.attitude_fit import AttitudeFit
from polhode.measuring.throws.throw import ThrowFit
from polhode.types import Array

SQUARED = {"1": "1", "s-1": "s-2", "rad s-1": "rad2 s-2", "rad s-2": "rad2 s-4"}


def write_throw(fit: ThrowFit, names: Sequence[str], path: str | Path) -> Path:
    """Write measured and fitted rates of all throws, and the parameters; the file appears whole or not at all.

    Args:
        fit: as ``fit_throw`` returns it.
        names: of the logs.
        path: of the dataset.

    Raises:
        InvalidInput: if the file cannot be written there.
    """
    return write_variables(path, *_describe(fit, names))


def write_attitude_fit(fit: AttitudeFit, name: str, path: str | Path) -> Path:
    """Write the residuals of a fit of attitudes, and the parameters; the file appears whole or not at all.

    Args:
        fit: as ``fit_attitude`` returns it.
        name: of the log.
        path: of the dataset.

    Raises:
        InvalidInput: if the file cannot be written there.
    """
    turns = {"units": "rad", "long_name": "turn from the fitted to the measured attitude, about the device axes"}
    variables: dict[str, Any] = {
        "time": ("sample", fit.times, {"units": "s", "long_name": "time in the log"}),
        "residual": (("sample", "device_axis"), fit.residuals, turns),
    }
    if fit.ratios is not None and fit.axes is not None:
        variables["principal_axes"] = _axes(fit.axes)
        variables |= _estimates([
            ("ratios", fit.ratios, "ratio", "1", "I1/I3 and I2/I3"),
            ("torque", fit.torque, "device_axis", "rad s-2", "constant torque over I3, along the device axes"),
            ("bias", fit.bias, "device_axis", "rad s-1", "bias of the rates"),
        ])
    header = {"Conventions": "CF-1.11", "source": "polhode", "title": f"inertia from attitudes of {name}"}
    return write_variables(path, variables, _coordinates(), header | _doubts(fit))


def _axes(axes: Array) -> tuple[Any, ...]:
    said = {"units": "1", "long_name": "principal axes, by columns, in the device"}
    return ("device_axis", "axis"), axes, said


def _coordinates() -> dict[str, Any]:
    return {"device_axis": ("device_axis", np.array(["x", "y", "z"]), {}), "axis": ("axis", [1, 2, 3], {}),
            "device_pair": ("device_pair", np.array(["yz", "xz", "xy"]), {})}  # fmt: skip


def _describe(fit: ThrowFit, names: Sequence[str]) -> tuple[dict[str, Any], dict[str, Any], dict[str, str]]:
    counts = [len(throw.times) for throw in fit.throws]
    joined = lambda name: np.concatenate([getattr(throw, name) for throw in fit.throws])  # noqa: E731
    rates = {"units": "rad s-1", "long_name": "angular velocity along the device axes, measured"}
    variables: dict[str, Any] = {
        "time": ("sample", joined("times"), {"units": "s", "long_name": "time in the log"}),
        "throw": ("sample", np.repeat(np.arange(len(counts)), counts), {"units": "1", "long_name": "throw, from 0"}),
        "angular_velocity": (("sample", "device_axis"), joined("rates"), rates),
        "window": (("throw_index", "end"), np.array([[w.start, w.end] for w in fit.windows]),
                   {"units": "s", "long_name": "start and end of free flight"}),
        "log": ("throw_index", np.array([names[throw.log] for throw in fit.throws]), {"long_name": "file"}),
    }  # fmt: skip
    if fit.degenerate is None and fit.ratios is not None and fit.axes is not None:
        variables["fitted_angular_velocity"] = (
            ("sample", "device_axis"), joined("predicted"),
            {"units": "rad s-1", "long_name": "angular velocity along the device axes, fitted, with bias and gains"},
        )  # fmt: skip
        variables["principal_axes"] = _axes(fit.axes)
        variables |= _estimates([
            ("ratios", fit.ratios, "ratio", "1", "I1/I3 and I2/I3"),
            ("bias", fit.bias, "device_axis", "rad s-1", "bias of the gyro"),
            ("gain", fit.gain, "device_axis", "1", "gain of the gyro"),
            ("cross_axis", fit.cross_axis, "device_pair", "1", "gain of the gyro across axes"),
            ("drag", fit.drag, "axis", "1", "drag over I3, of the torque -c |w| w"),
            ("linear_drag", fit.linear_drag, "axis", "s-1", "drag over I3, of the torque -b w"),
            ("one_sided_drag", fit.one_sided_drag, "axis", "1", "drag over I3, of the torque -d |w| abs(w)"),
            ("rotor", fit.rotor, "axis", "rad s-1", "momentum of a wheel in the body, over I3"),
        ])
    header = {"Conventions": "CF-1.11", "source": "polhode", "title": "inertia of a thrown body from gyro logs"}
    return variables, _coordinates(), header | _doubts(fit)


def _doubts(fit: ThrowFit | AttitudeFit) -> dict[str, str]:
    doubts = {} if fit.degenerate is None else {"degenerate": fit.degenerate}
    return doubts if fit.misfit is None else doubts | {"misfit": "residuals are not noise: no estimate has an error"}


def _estimates(named: list[tuple[str, Estimate | None, str, str, str]]) -> dict[str, Any]:
    """Return estimates with their covariances."""
    variables: dict[str, Any] = {}
    for name, estimate, axis, units, meaning in named:
        if estimate is None:
            continue
        squared = SQUARED[units]
        variables[name] = (axis, estimate.value, {"units": units, "long_name": meaning})
        variables[f"{name}_covariance"] = ((axis, f"{axis}_2"), estimate.covariance,
                                       {"units": squared, "long_name": f"covariance of {name}"})  # fmt: skip
    return variables
