"""What bounds the steps of a proof by Taylor series, and when it gives up."""

from __future__ import annotations

from typing import NamedTuple


class ProofLimits(NamedTuple):
    """Numbers that decide how far a proof gets; none of them can make it wrong.

    Attributes:
        max_slope: 1/s, of the rates of change; squares of larger ones overflow.
        spare_growth: e-folds by which a proof may be worse than the estimate beforehand.
        max_order: of the series.
        max_bits: of the arithmetic.
        min_bits: of the arithmetic.
        tube_order: of the polynomial that encloses the motion during a step.
        widening: factor of a box, from one trial to the next.
        max_trials: of a box.
        rings: by which the disc of a step grows.
        min_ring: width over the disc, below which another ring gains nothing.
        max_excursion: from the midpoint, over the size of the state; a larger disc would be bounded no better.
        min_disc: over the time; a smaller one is a singularity.
    """

    max_slope: float = 1e150
    spare_growth: float = 8.0
    max_order: int = 400
    max_bits: int = 4000
    min_bits: int = 128
    tube_order: int = 10
    widening: float = 1.25
    max_trials: int = 4
    rings: int = 8
    min_ring: float = 0.03
    max_excursion: float = 3.0
    min_disc: float = 1e-12


LIMITS = ProofLimits()
