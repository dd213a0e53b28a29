"""The branch of ``polhode.fit`` for the periods of a pendulum on which a body hung."""

from __future__ import annotations

from typing import TYPE_CHECKING

from polhode.errors import InvalidInput
from polhode.studies.fit_request import FitBranch, FitRequest
from polhode.studies.naming import name_arguments

if TYPE_CHECKING:
    from polhode.measuring.pendulum.report import PendulumReport


def _knows(request: FitRequest) -> bool:
    return request.pendulum


def _fit(request: FitRequest) -> PendulumReport:
    options, files = request.options, request.files
    wrong = [*options.given, *(["free"] if request.free is not None else [])]
    wrong += options.with_columns[len(options.given) :]
    if wrong or len(files) > 1:
        what = f"{name_arguments(wrong)} cannot go with it" if wrong else f"got {len(files)} files"
        raise InvalidInput(f"`pendulum` takes one file of periods alone; {what}. Leave out the rest.")
    from polhode.measuring.pendulum.study import fit_periods

    return fit_periods(files[0])


FIT = FitBranch(_knows, _fit)
