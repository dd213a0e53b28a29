"""The format ``gmat``: attitudes in a report file of GMAT.

Source: GMAT, *User Guide*, calculation parameters: Q1 to Q4 of the rotation from the inertial axes to the body's, the
scalar last; modified Julian dates count from JD 2430000.0; Gregorian dates are like 01 Mar 2026 12:00:00.000. Angular
velocities are left out, because versions differ in the axes that they are along.
"""

from __future__ import annotations

import re
from collections.abc import Sequence

from polhode.formats.known_tables import Words, find_one, find_series, make_table_form

SYSTEMS = ("utc", "tai", "tt", "tdb")


def words_for(names: Sequence[str]) -> Words | None:
    """Return the mapping of a report with a spacecraft's quaternion or matrix; None for others."""
    clocks = r"\w+\.(?:\w+\.)?(elapsedsecs|elapseddays|\w+modjulian|\w+gregorian)"
    if not any(re.fullmatch(clocks, name.lower()) for name in names):
        return None
    quat = find_series(names, r"\.q{}$", "1234")
    matrix = find_series(names, r"\.(dcm|directioncosinematrix){}$", [f"{i}{j}" for i in "123" for j in "123"])
    mrp = find_series(names, r"\.mrp{}$", "123")
    attitude: Words | None = (
        {"quat": quat, "order": "xyzw", "direction": "body-to-space"} if quat
        else {"matrix": matrix, "direction": "space-to-body"} if matrix
        else {"mrp": mrp, "direction": "body-to-space"} if mrp else None
    )
    clock = _find_clock(names)
    return None if attitude is None or clock is None else attitude | clock


def _find_clock(names: Sequence[str]) -> Words | None:
    for name, unit in (("elapsedsecs", "s"), ("elapseddays", "d")):
        if (place := find_one(names, rf"\.{name}$")) is not None:
            return {"time": place, "time_unit": unit}
    for system in SYSTEMS:
        if (place := find_one(names, rf"\.{system}modjulian$")) is not None:
            return {"time": place, "time_unit": "gmat", "time_system": system.upper()}
    for system in SYSTEMS:
        if (place := find_one(names, rf"\.{system}gregorian$")) is not None:
            return {"time": place, "time_system": system.upper()}
    return None


FORM = make_table_form("gmat", "GMAT report", "quaternions, matrices or MRPs of a spacecraft", words_for, ".txt")
