"""The branch of ``polhode.fit`` for logs of throws and of attitudes, which are known only by reading them."""

from __future__ import annotations

from typing import TYPE_CHECKING

from polhode.errors import InvalidInput
from polhode.studies.fit_request import FitBranch, FitRequest

if TYPE_CHECKING:
    from polhode.measuring.attitudes.report import AttitudeReport
    from polhode.measuring.throws.report import ThrowReport


def _fit(request: FitRequest) -> ThrowReport | AttitudeReport:
    if request.free is not None:
        raise InvalidInput("`free` names constants of a molecule, and gyro logs are given. Leave it out.")
    from polhode.measuring.throws.study import fit_logs

    return fit_logs(request.files, request.options, request.progress)


FIT = FitBranch(None, _fit)
