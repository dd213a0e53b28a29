"""Damping and light curve in the report on a tumbling body."""

from __future__ import annotations

from typing import NamedTuple

from polhode.celestial.tumbling.light_curves import LightCurveLines
from polhode.types import Array, Float64


class Damping(NamedTuple):
    """Time of damping [s], and the assumptions: diameter [m], density [kg/m³], μQ [Pa], K₃²."""

    time: float
    diameter: float
    density: float
    rigidity: float
    shape_factor: float


class LightCurve(NamedTuple):
    """A synthetic light curve: semi-axes over the longest, geometry [rad], its frequencies, and its range [mag]."""

    semi_axes: Float64[Array, "3"]
    aspect: float
    phase: float
    lines: LightCurveLines
    times: Float64[Array, "time"]
    magnitudes: Float64[Array, "time"]
