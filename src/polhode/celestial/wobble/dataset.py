"""Results on the Chandler wobble (series, windows, process, excitation) as a NetCDF dataset."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from polhode.celestial.wobble.excitation import PolarExcitation
from polhode.celestial.wobble.process import ChandlerProcess
from polhode.celestial.wobble.windows import ChandlerWindows
from polhode.formats.dataset import write_variables

CLOCK = {"units": "s", "long_name": "time since modified Julian date 0, UTC"}


def write_wobble(
    windows: ChandlerWindows, process: ChandlerProcess, excitation: PolarExcitation, source: str, path: str | Path
) -> Path:
    """Write the results of sliding windows, the process and deconvolution; the file appears whole or not at all.

    Args:
        windows: as ``fit_chandler_windows`` returns them.
        process: as ``fit_chandler_process`` returns it.
        excitation: as ``polar_excitation`` returns it.
        source: of the data.
        path: of the dataset.

    Raises:
        InvalidInput: if the file cannot be written there.
    """
    variables: dict[str, Any] = {}

    def add(name: str, axis: str, values: Any, units: str, meaning: str) -> None:
        variables[name] = (axis, values, {"units": units, "long_name": meaning})

    add("amplitude", "window", windows.amplitude, "rad", "amplitude of the Chandler wobble in a window")
    add("amplitude_error", "window", windows.amplitude_error, "rad", "its standard deviation")
    add("phase", "window", windows.phase, "rad", f"phase against exp(i {windows.rate:.12g} (t - {windows.epoch:.12g}))")
    add("phase_error", "window", windows.phase_error, "rad", "its standard deviation")
    for name, axis, values, meaning in (
        ("wobble", "step", process.wobble, "Chandler wobble as a process, mean over a step"),
        ("psi", "excitation", excitation.psi, "excitation of polar motion"),
    ):
        add(f"{name}_greenwich", axis, values.real, "rad", f"{meaning}, towards Greenwich")
        add(f"{name}_east", axis, values.imag, "rad", f"{meaning}, towards 90 degrees East")
    add("wobble_error", "step", process.wobble_error, "rad", "standard deviation of each of its components")
    coordinates = {"window": ("window", windows.centres, CLOCK), "step": ("step", process.times, CLOCK),
                   "excitation": ("excitation", excitation.times, CLOCK)}  # fmt: skip
    header = {"Conventions": "CF-1.11", "source": source, "title": "the Chandler wobble from polar motion"}
    unknown = [name for name, error in (("amplitude and phase", windows.amplitude_error),
                                        ("wobble", process.wobble_error)) if np.isnan(error).all()]
    if unknown:
        header["misfit"] = f"what the model leaves is not noise: {' and '.join(unknown)} have no known error"
    return write_variables(path, variables, coordinates, header)
