"""The format ``basilisk``: attitudes that a recorder of Basilisk keeps, saved as CSV.

Source: Basilisk, message ``SCStatesMsgPayload``: sigma_BN are the modified Rodrigues parameters of the body relative to
the inertial frame, omega_BN_B [rad/s] is along the body's axes; ``times()`` of a recorder are nanoseconds.
"""

from __future__ import annotations

from collections.abc import Sequence

from polhode.formats.header_words import TIME_UNITS, unit_in
from polhode.formats.known_tables import Words, find_one, find_series, make_table_form

NUMBERINGS = ("123", "012")
TIMES = r"^(time|times|t)\W*(_?[a-z]+)?\W*$"


def words_for(names: Sequence[str]) -> Words | None:
    """Return the mapping of a table with sigma_BN; None for others."""
    for marks in NUMBERINGS:
        mrp = find_series(names, r"^sigma_bn\W*_?{}\W*$", marks)
        time = find_one(names, TIMES)
        if mrp is None or time is None:
            continue
        words: Words = {"time": time, "mrp": mrp, "direction": "body-to-space"}
        if unit_in(names[time - 1], TIME_UNITS) is None:
            words["time_unit"] = "ns"
        rates = find_series(names, r"^omega(_bn_b)?\W*_?{}\W*$", marks)
        return words if rates is None else words | {"gyro": rates, "unit": "rad/s"}
    return None


FORM = make_table_form("basilisk", "Basilisk table", "MRPs sigma_BN and angular velocities of a recorder", words_for)
