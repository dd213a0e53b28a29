"""The format ``ardupilot``: attitudes of an ArduPilot log, as mavlogdump and Mission Planner write them as CSV.

Source: ArduPilot, *Onboard Message Log Messages*, ATT: roll, pitch and yaw in degrees, of turns by yaw, pitch and roll
from the axes north, east, down; TimeUS is microseconds since the start of the system.
"""

from __future__ import annotations

from collections.abc import Sequence

from polhode.formats.known_tables import Words, find_one, make_table_form


def words_for(names: Sequence[str]) -> Words | None:
    """Return the mapping of a table of ATT messages; None for others."""
    time = find_one(names, r"^(att\.)?timeus$")
    angles = [find_one(names, rf"^(att\.)?{name}$") for name in ("yaw", "pitch", "roll")]
    if time is None or None in angles or find_one(names, r"^(att\.)?desroll$") is None:
        return None
    return {"time": time, "time_unit": "us", "euler": angles, "sequence": "ZYX", "unit": "deg",
            "direction": "body-to-space"}  # fmt: skip


FORM = make_table_form("ardupilot", "ArduPilot log", "attitudes of ATT messages, to 0.01°", words_for)
