"""The bodies of many samples at once, where a sweep varies the table [body]."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
from pydantic import ValidationError

from polhode.bodies._inertia import ROUNDING
from polhode.errors import InvalidInput
from polhode.kinds.base import Spec
from polhode.kinds.ensembles import Bodies
from polhode.spec.building import build_body
from polhode.spec.keys import with_value, write_quantity
from polhode.spec.mistakes import list_mistakes
from polhode.spec.models import BodyTable

OF_MOMENTS = ("body.moments", "body.moments.1", "body.moments.2", "body.moments.3")


def vary_body(spec: Spec, tables: dict[str, Any], varied: Mapping[str, Any], units: Mapping[str, str]) -> Bodies | None:
    """Return the bodies of samples, one for all where none of their numbers is varied; None for kinds without one.

    Args:
        spec: of one sample.
        tables: of the spec's file.
        varied: key → values (sample, …) of the inputs.
        units: key → unit of the inputs.
    """
    if spec.body is None:
        return None
    own = {key: values for key, values in varied.items() if key.startswith("body.")}
    if not own:
        return Bodies(spec.body.principal_moments, spec.body.principal_axes, {})
    if spec.source is not None and spec.source.moments is not None and set(own) <= set(OF_MOMENTS):
        return _by_moments(spec.source.moments, own)
    return _one_by_one(spec.folder, tables, own, units)


def _by_moments(moments: tuple[float, float, float], varied: Mapping[str, Any]) -> Bodies:
    """Return bodies of given moments, sorted as ``bodies.body.principal_axes`` does."""
    count = len(next(iter(varied.values())))
    rows = np.tile(np.asarray(moments, dtype=float), (count, 1))
    for key, values in varied.items():
        if key == OF_MOMENTS[0]:
            rows = np.array(values, dtype=float)
        else:
            rows[:, int(key[-1]) - 1] = values
    order = np.argsort(rows, axis=1, kind="stable")
    rows = np.take_along_axis(rows, order, axis=1)
    axes = np.swapaxes(np.eye(3)[order], 1, 2)
    axes[np.linalg.det(axes) < 0.0, :, 2] *= -1.0
    beyond = rows[:, 0] + rows[:, 1] < rows[:, 2] * (1.0 - ROUNDING)
    refused = {}
    for k in np.flatnonzero((rows[:, 0] < 0.0) | (rows[:, 2] <= 0.0) | beyond):
        rule = "must satisfy I1 + I2 ≥ I3" if beyond[k] else "must be positive"
        got = ", ".join(f"{x:.6g}" for x in rows[k])
        refused[int(k)] = f"the principal moments {rule}; got ({got}) kg m²"
    return Bodies(rows, axes + 0.0, refused)


def _one_by_one(folder: Path, tables: dict[str, Any], varied: Mapping[str, Any], units: Mapping[str, str]) -> Bodies:
    count = len(next(iter(varied.values())))
    moments, axes, refused = np.ones((count, 3)), np.tile(np.eye(3), (count, 1, 1)), {}
    for k in range(count):
        changed = {"body": tables["body"]}
        for key, values in varied.items():
            changed = with_value(changed, key, write_quantity(np.asarray(values[k]).tolist(), units[key]))
        try:
            body = build_body(BodyTable.model_validate(changed["body"]), folder).body
            moments[k], axes[k] = body.principal_moments, body.principal_axes
        except ValidationError as error:
            wrong = list_mistakes(error, BodyTable, ("body",))
            refused[k] = "; ".join(f"{'.'.join(map(str, place))}: {text}" for place, text in wrong)
        except InvalidInput as error:
            refused[k] = str(error)
    return Bodies(moments, axes, refused)
