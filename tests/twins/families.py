"""The hard families of motions, by name: the one list that tables, tests of every language and pages take them from."""

from __future__ import annotations

from twins.families_of_bodies import FAMILIES as OF_BODIES
from twins.families_of_tops import FAMILIES as OF_TOPS

BODIES, TOPS = (tuple(make.__name__ for make in families) for families in (OF_BODIES, OF_TOPS))
KINDS = {"body": BODIES, "top": TOPS}
