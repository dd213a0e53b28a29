"""The answers about a quantum rotor that flips about its intermediate axis."""

from __future__ import annotations

import math

from polhode.reports.answer import Answer, Group
from polhode.reports.wording import in_its_unit
from polhode.spectra.racket import Racket


def about_flip(racket: Racket) -> Group:
    """Return the answers about flips and their return."""
    first, revival = racket.first_reversal, racket.revival_time
    half, period = racket.half_time, None if math.isinf(racket.period) else racket.period
    tilt = f"{math.degrees(racket.tilt):.6g}° towards {racket.towards}"
    words = None if first is None else f"{in_its_unit(first.time)}, to ⟨L_b⟩ = {first.along:.4f} J"
    return Group(f"Flip of J = {racket.J} about the middle axis", [
        Answer("racket.tilt", racket.tilt, "rad", "L at the start", "from the b axis",
               tilt if racket.tilt else "on the middle axis"),
        Answer("racket.rate", racket.rate, "1/s", "classical rate of leaving the axis"),
        Answer("racket.half_time", half, "s", "⟨L_b⟩ falls to J/2 after"),
        Answer("racket.first_reversal.time", None if first is None else first.time, "s", "first reversal", "", words),
        Answer("racket.first_reversal.along", None if first is None else first.along, "", "", "⟨L_b⟩/J"),
        Answer("racket.period", period, "s", "classical period T"),
        Answer("racket.revival_time", revival, "s", "revival T_rev", "2/|d²ν/dn²|",
               None if revival is None else f"{in_its_unit(revival)} = {revival / racket.period:.4g} T"),
    ])
