"""How finely an offset of two clocks is sought, and what decides whether it is one."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Search:
    """How finely an offset is sought.

    Attributes:
        turn: [rad] that the body turns between offsets that are tried first.
        max_offsets: tried first, however long the histories are.
        coarse_samples: on which offsets are tried.
        fine_samples: on which they are refined.
        candidates: offsets that are refined.
        max_rounds: of a refinement.
        coarse_loss: of agreement, where an offset lies halfway between two that are tried.
    """

    turn: float = 0.2
    max_offsets: int = 100_000
    coarse_samples: int = 48
    fine_samples: int = 1500
    candidates: int = 12
    max_rounds: int = 25

    @property
    def coarse_loss(self) -> float:
        return 0.25 * (0.5 * self.turn) ** 2


@dataclass(frozen=True)
class Thresholds:
    """What decides whether an offset is one, and the only one.

    Attributes:
        settled_step: of the usual step between samples; an offset that moves by less is refined.
        settled_turn: [rad]; turns of axes below it no longer change an offset.
        rival: times the residual of the best offset; one with a smaller residual may be the right one.
        max_residual: [rad, rms]; larger residuals are of another motion, and larger turns are of other axes.
        max_unexplained: of the samples' own turn, rms; an offset that leaves more does not follow them, however small.
        max_error: of the span in which offsets are sought; an error that is larger leaves them all possible.
        max_turn_within_error: [rad] that the body turns within an offset's error; a turn of axes that is larger is not
            distinguished from that.
        min_information_left: of the information on an offset; if fitting the axes leaves less, none is returned.
        min_noise: [rad, rms]; rounding, below which residuals are not compared.
        min_improvement: fall of χ² by three more unknowns, which noise alone reaches once in 140 times.
        same_effect: of the largest singular value; below it two unknowns have one effect, as far as steps resolve it.
        same_effect_alone: likewise, of turns of axes; those with less effect are not measured.
        nearest: of the distance to the second; an offset as near as this to the wanted one is chosen.
        axes_unmeasured: times the turn that two axes show; a third exceeds twice that error once in 30.
        min_overlap: of the shorter history.
    """

    settled_step: float = 1e-13
    settled_turn: float = 1e-11
    rival: float = 3.0
    max_residual: float = 0.3
    max_unexplained: float = 0.3
    max_error: float = 0.1
    max_turn_within_error: float = 0.1
    min_information_left: float = 1e-6
    min_noise: float = 1e-12
    min_improvement: float = 12.0
    same_effect: float = 1e-7
    same_effect_alone: float = 1e-2
    nearest: float = 0.5
    axes_unmeasured: float = 2.0
    min_overlap: float = 0.5


SEARCH, LIMITS = Search(), Thresholds()
