"""Labels of an attitude file: whose attitude it is, in which frames, from which epoch."""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from typing import Any

from polhode.motion._trajectory import Trajectory

# for files that require them, where they are not given
USUAL_ID, USUAL_ORIGINATOR, USUAL_NUMBER = "1900-000A", "POLHODE", -999
# CCSDS 504.0-B-2, annex B3, and the registry of spacecraft body frames that it names
_IN_SPACECRAFT = re.compile(
    "(SC BODY|ACC|ACTUATOR|AST|CSS|DSS|ESA|GYRO FRAME|IMU FRAME|INSTRUMENT|MTA|RW|SA|SENSOR|STARTRACKER|TAM)( .*)?"
)


@dataclass(frozen=True)
class AttitudeLabels:
    """The labels of an attitude history; a trajectory read from a file has them in its source.

    Attributes:
        object_name: of the body; it and the frames are empty where a file does not name them.
        object_id: its international designator, or any id; None where it is not known.
        center: the body whose vicinity it is in, or None.
        reference_frame: the space axes.
        body_frame: the body's axes.
        epoch: calendar date and time of the trajectory's time zero, ISO 8601, without zone.
        time_system: of that epoch: "UTC", "TAI", "TT", "TDB" or "GPS".
        originator: who made the file, or None.
        spice_id: NAIF's negative number of a spacecraft, for SPICE; its frame is that times 1000. None if not known.
        comments: lines of text.

    >>> AttitudeLabels("BOX", epoch="2026-03-01T12:00:00", time_system="TAI").body_frame
    'SC_BODY_1'
    """

    object_name: str = "BODY"
    object_id: str | None = USUAL_ID
    center: str | None = None
    reference_frame: str = "EME2000"
    body_frame: str = "SC_BODY_1"
    epoch: str = "2000-01-01T00:00:00"
    time_system: str = "UTC"
    originator: str | None = USUAL_ORIGINATOR
    spice_id: int | None = USUAL_NUMBER
    comments: tuple[str, ...] = ()

    @property
    def spacecraft(self) -> int:
        """The number for SPICE, the usual one where it is not known."""
        return USUAL_NUMBER if self.spice_id is None else self.spice_id


@dataclass(frozen=True)
class Recording:
    """A file's metadata; the source of a trajectory that was read.

    Attributes:
        title: what moved.
        labels: of the attitude, where the file has them.
        attributes: the global attributes of the file.
    """

    title: str = ""
    labels: AttitudeLabels | None = None
    attributes: dict[str, Any] = field(default_factory=dict)


def nameless(epoch: str, time_system: str) -> AttitudeLabels:
    """Return labels with an epoch alone; the names are empty."""
    return AttitudeLabels("", None, None, "", "", epoch, time_system, None, None)


def find_labels(trajectory: Trajectory) -> AttitudeLabels | None:
    """Return the labels that a trajectory was read with, None where it was not or had none."""
    return trajectory.source.labels if isinstance(trajectory.source, Recording) else None


def plain(text: str) -> str:
    """Return a text value as CCSDS compares it: neither case nor underscore for blank matters."""
    return " ".join(text.upper().replace("_", " ").split())


def is_in_spacecraft(frame: str) -> bool:
    """Whether a frame's name is one that CCSDS keeps for frames fixed in a spacecraft or a part of it."""
    return _IN_SPACECRAFT.fullmatch(plain(frame)) is not None
