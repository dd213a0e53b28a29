"""The format ``ros``: orientations of a ROS bag, as ``rostopic echo -p``, bagpy and PlotJuggler write them as CSV.

Source: ROS, messages geometry_msgs/Quaternion (x, y, z, w) and sensor_msgs/Imu; REP 103 and 145: orientations take the
sensor's axes to those of the world, and angular velocities, in rad/s, are along the sensor's axes.
"""

from __future__ import annotations

from collections.abc import Sequence

from polhode.formats.known_tables import Words, find_one, find_series, make_table_form

CLOCKS = (
    ((r"header[./]stamp[./]secs$", r"header[./]stamp[./]nsecs$"), "s,ns"),
    ((r"header[./]stamp[./]sec$", r"header[./]stamp[./]nanosec$"), "s,ns"),
    ((r"header[./]stamp$",), "ns"),
    ((r"^%?time$",), "ns"),
)
"""Columns of times and their units, the best first: the sensor's own stamp, then that of the recorder."""


def words_for(names: Sequence[str]) -> Words | None:
    """Return the mapping of a table with one orientation; None for others."""
    quat = find_series(names, r"(^|[./])orientation[./]{}$", "xyzw")
    present = (([find_one(names, name) for name in columns], unit) for columns, unit in CLOCKS)
    clock = next((one for one in present if None not in one[0]), None)
    if quat is None or clock is None:
        return None
    columns, unit = clock
    words: Words = {"time": columns if len(columns) > 1 else columns[0], "time_unit": unit, "quat": quat,
                    "order": "xyzw", "direction": "body-to-space"}  # fmt: skip
    rates = find_series(names, r"(^|[./])angular_velocity[./]{}$", "xyz")
    return words if rates is None else words | {"gyro": rates, "unit": "rad/s"}


FORM = make_table_form("ros", "ROS table", "orientations and angular velocities of one topic of a bag", words_for)
