"""Files of times as ``polhode fit`` knows them: by their ending."""

from __future__ import annotations

from typing import TYPE_CHECKING

from polhode.errors import InvalidInput
from polhode.studies.fit_request import FitBranch, FitRequest

if TYPE_CHECKING:
    from swing_timer.report import SwingReport


def _knows(request: FitRequest) -> bool:
    return request.files[0].suffix == ".swings"


def _fit(request: FitRequest) -> SwingReport:
    from swing_timer.report import time_swings

    given = request.options.with_columns
    if given or request.free is not None or len(request.files) > 1:
        raise InvalidInput(f"{request.files[0]}: times of a swing are fitted alone, without options. Leave them out.")
    return time_swings(request.files[0])


FIT = FitBranch(_knows, _fit)
