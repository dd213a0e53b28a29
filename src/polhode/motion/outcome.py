"""How a sampled motion came to its end."""

from __future__ import annotations

import enum
from dataclasses import dataclass


class Ending(enum.Enum):
    """What ended a sampled motion."""

    EXACT = "exact"  # evaluated in closed form at the times asked for
    COMPLETED = "successful"  # integrated to the last time asked for
    EVENT = "event"  # integrated until an event of the system
    NOT_CONVERGED = "not converged"  # the integrator failed, in one copy at least
    RECORDED = "read"  # read from a file that does not tell


@dataclass(frozen=True)
class Outcome:
    """How a sampled motion came to its end, and what else there is to say of it.

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
