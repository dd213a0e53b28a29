"""How a sampled motion ended."""

from __future__ import annotations

import enum
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from polhode.types import Array


class Ending(enum.Enum):
    """The cause of a sampled motion's end."""

    EXACT = "exact"  # evaluated in closed form at the times asked for
    COMPLETED = "successful"  # integrated to the last time asked for
    EVENT = "event"  # integrated until an event of the system
    NOT_CONVERGED = "not converged"  # the integrator failed, in one copy at least
    RECORDED = "read"  # read from a file that does not tell


@dataclass(frozen=True)
class Outcome:
    """How a sampled motion ended, with a message.

    Attributes:
        ending: what ended it.
        event: name of the event that ended it, None unless one did.
        message: a sentence without capital and full stop, "" where there is nothing more to say.

    >>> str(Outcome(Ending.EVENT, "lift-off")), str(Outcome())
    ('lift-off', 'exact')
    """

    ending: Ending = Ending.EXACT
    event: str | None = None
    message: str = ""

    def __str__(self) -> str:
        words = self.event or self.ending.value
        return f"{words}: {self.message}" if self.message else words


class Status(enum.IntEnum):
    """How one copy of a batch ended, as a number for arrays."""

    COMPLETED = 0
    EVENT = 1
    NOT_CONVERGED = 2


class Ends(NamedTuple):
    """How each copy of a batch ended.

    Attributes:
        status: (batch…) numbers of ``Status``.
        event: (batch…) which of ``events`` ended it, −1 where none did.
        time: (batch…) [s] when: the event's own time, or the last time asked for; NaN where the integrator failed.
        state: (batch…, …) the state then.
        events: names of the system's events.

    >>> ends = Ends([1, 0], [0, -1], [0.3, 2.0], [[0.0], [1.0]], ("ground",))
    >>> str(ends.outcome(0)), str(ends.outcome(1))
    ('ground', 'successful')
    """

    status: Array
    event: Array
    time: Array
    state: Array
    events: tuple[str, ...] = ()

    def beyond(self, times: Array) -> np.ndarray:
        """Return (batch…, T) which of the times [s] come with or after a copy's own event."""
        # by the time since the first sample, as runs may go backwards
        since = np.abs(np.asarray(times) - times[0])
        last = np.where(np.asarray(self.status) == Status.EVENT, np.abs(np.asarray(self.time) - times[0]), np.inf)
        return since >= last[..., None]

    def outcome(self, index: int | tuple[int, ...]) -> Outcome:
        """Return how the copy with this index ended."""
        status, event = self.status, self.event
        for k in (index,) if isinstance(index, int) else index:
            status, event = status[k], event[k]
        if status == Status.EVENT:
            return Outcome(Ending.EVENT, self.events[int(event)])
        return Outcome(Ending.COMPLETED if status == Status.COMPLETED else Ending.NOT_CONVERGED)
