"""Remarks for the reader of a report: how numbers of a spec were understood, and which assumptions were made."""

from __future__ import annotations

from typing import NamedTuple

from polhode.bodies.body import Body
from polhode.spec.models import SpinTable


class RemarkLimits(NamedTuple):
    """A number that decides on a remark about temperature."""

    min_classical: float = 5.0  # temperature over ħ²/(2 I k), from which on it is high for rotation


LIMITS = RemarkLimits()


def remarks_on(body: Body | None, spin: SpinTable | None) -> tuple[str, ...]:
    """Return a sentence or two on the assumptions about a body and its spin."""
    remarks = remarks_on_body(body)
    if spin is not None and spin.temperature is not None:
        remarks += (_of_temperature(body, spin.temperature),)
    return remarks


def remarks_on_body(body: Body | None) -> tuple[str, ...]:
    """Return a sentence on the assumptions about a body."""
    if body is None or body.inertial_defect <= 0.0:
        return ()
    from polhode.bodies.atoms import ANGSTROM, ATOMIC_MASS_UNIT

    defect = body.inertial_defect / (ATOMIC_MASS_UNIT * ANGSTROM**2)
    text = (
        "the rotational constants are averages over vibration, and their moments those of no rigid body: the inertial "
        f"defect I₃ − I₁ − I₂ is {defect:.4g} u Å², {body.inertial_defect / body.principal_moments[2]:.2g} of I₃. The "
        "motion is what the equations of a rigid body give with these moments."
    )
    return (text,)


def _of_temperature(body: Body | None, temperature: float) -> str:
    from polhode.analysis.thermal import BOLTZMANN, rotational_temperature

    text = (
        f"the spin is typical of {temperature:.6g} K: each principal axis has the root mean square angular momentum of "
        f"classical thermal equilibrium, √(kTI), and the energy is 3/2 kT = {1.5 * BOLTZMANN * temperature:.4g} J. "
        "Single molecules turn faster or slower than this, about any direction."
    )
    if body is None or not body.principal_moments[0] > 0.0:
        return text
    quantum = float(rotational_temperature(body.principal_moments).max())
    if temperature < LIMITS.min_classical * quantum:
        text += f" Quantum theory counts here: ħ²/2I of the axis of least moment is worth {quantum:.3g} K."
    return text
