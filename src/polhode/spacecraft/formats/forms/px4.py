"""The format ``px4``: attitudes of a PX4 log, as ulog2csv writes them.

Source: PX4, message definition ``VehicleAttitude``: q is the Hamilton quaternion from the body's axes (forward, right,
down) to those of the Earth (north, east, down), timestamps are microseconds since the start of the system.
"""

from __future__ import annotations

from collections.abc import Sequence

from polhode.formats.known_tables import Words, find_one, find_series, make_table_form


def words_for(names: Sequence[str]) -> Words | None:
    """Return the mapping of a table of vehicle_attitude; None for others."""
    time, quat = find_one(names, r"^timestamp$"), find_series(names, r"^q\[{}\]$", "0123")
    if time is None or quat is None:
        return None
    words: Words = {"time": time, "time_unit": "us", "quat": quat, "order": "wxyz", "direction": "body-to-space"}
    rates = [find_one(names, f"^{name}speed$") for name in ("roll", "pitch", "yaw")]  # of logs before version 1.11
    return words if None in rates else words | {"gyro": rates, "unit": "rad/s"}


FORM = make_table_form("px4", "PX4 log", "attitudes of vehicle_attitude, by ulog2csv", words_for)
