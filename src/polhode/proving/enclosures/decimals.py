"""The exact numbers in the decimals of a spec, where they give the start of a free body."""

from __future__ import annotations

import tomllib
from collections.abc import Sequence
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np

from polhode import rotation
from polhode._base.rational import read_number
from polhode.formats.opening import read_text
from polhode.proving.enclosures._ball_turns import multiply
from polhode.spec.parsing import LARGEST
from polhode.spec.units import parse_exactly
from polhode.types import Array, Float64

Numbers = list[Fraction]


def exact_numbers(path: Path, axes: Float64[Array, "3 3"]) -> dict[str, Numbers]:
    """Return moments, momentum or angular velocity, and attitude of a spec that gives them, along the principal axes.

    Left out is what the file gives in another way: a body by its shape, a spin by a tilt, a number in degrees or rpm.
    For these, doubles serve.

    Args:
        path: of a spec that has been read without a mistake.
        axes: (3, 3) the principal axes by columns in the given ones.

    Raises:
        InvalidInput: for numbers out of range of exact arithmetic.
    """
    # numbers without quotes as the text that they are
    tables = tomllib.loads(read_text(path, "spec", LARGEST), parse_float=lambda text: text.replace("_", ""))
    turn = np.round(axes).astype(int)
    if not (turn == axes).all():  # the given axes are not principal, so that eigenvectors come in
        return {}
    body, spin = tables.get("body", {}), tables.get("spin", {})
    exact = {"moments": _along(_exactly(body.get("moments"), "kg*m^2"), np.abs(turn))}
    given = turn if spin.get("frame", "given") == "given" else np.eye(3, dtype=int)
    exact["momentum"] = _along(_exactly(spin.get("momentum"), "kg*m^2/s"), given)
    exact["angular_velocity"] = _along(_exactly(spin.get("angular_velocity"), "rad/s"), given) or _about(spin, turn)
    exact["attitude"] = _attitude(spin.get("attitude", [1, 0, 0, 0]), axes)
    return {name: numbers for name, numbers in exact.items() if numbers is not None}


def _exactly(values: Any, unit: str) -> Numbers | None:
    """Return three quantities as exact numbers; None if they are missing, or one has no decimal unit."""
    if values is None:
        return None
    exact = [parse_exactly(value, unit) for value in values]
    return None if any(value is None for value in exact) else exact  # type: ignore[return-value]


def _along(values: Sequence[Fraction] | None, turn: np.ndarray) -> Numbers | None:
    """Return the components along the columns of a matrix of whole numbers."""
    if values is None:
        return None
    return [sum((int(c) * x for c, x in zip(column, values, strict=True)), Fraction(0)) for column in turn.T]


def _about(spin: dict[str, Any], turn: np.ndarray) -> Numbers | None:
    """Return the angular velocity of a spin exactly about an axis."""
    if "rate" not in spin or (tilted := parse_exactly(spin.get("tilt", "0 deg"), "deg")) is None or tilted != 0:
        return None
    rate, about = parse_exactly(spin["rate"], "rad/s"), spin["about"]
    if rate is None:
        return None
    index = about - 1 if isinstance(about, int) else "xyz".index(about)
    vector = [rate if k == index else Fraction(0) for k in range(3)]
    return vector if isinstance(about, int) else _along(vector, turn)


def _attitude(given: Any, axes: Float64[Array, "3 3"]) -> Numbers | None:
    """Return the quaternion of an attitude that is given as one, not of unit length."""
    if not isinstance(given, list):
        return None
    to_principal = [read_number(x) for x in rotation.from_matrix(axes).tolist()]
    return multiply([read_number(x, name="spin.attitude") for x in given], to_principal)
