"""The excitation of polar motion by deconvolution: ψ of ṁ = iσ_c(m − ψ).

Reference: C. R. Wilson, Geophys. J. R. astr. Soc. 80 (1985) 551.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from polhode._base import check
from polhode._base.arrays import known_numbers_only
from polhode.celestial.wobble._pole_series import DAY, clean_pole, even
from polhode.errors import InvalidInput, shown
from polhode.types import Array, ArrayLike, Complex128, Float64, Real

STEP = 10.0 * DAY


@dataclass(frozen=True, eq=False)
class PolarExcitation:
    """Excitation of polar motion.

    Attributes:
        times: (n,) middles of the steps [s].
        psi: (n,) ψ = χ1 + iχ2, towards Greenwich and 90° East [rad].
        error: standard deviation of each component by the noise of the pole [rad].
        correlation: complex, of the errors of one step and the next; none farther apart.
        step: [s].
    """

    times: Float64[Array, "n"] = field(repr=False)
    psi: Complex128[Array, "n"] = field(repr=False)
    error: float
    correlation: complex
    step: float

    @property
    def covariance(self) -> Complex128[Array, "n n"]:
        """Covariance of ψ, real and imaginary part together [rad²]: banded, constant along the diagonals."""
        count = len(self.psi)
        below = 2.0 * self.error**2 * self.correlation * np.eye(count, k=-1)
        return 2.0 * self.error**2 * np.eye(count) + below + below.conj().T


@known_numbers_only
def polar_excitation(
    times: Real[ArrayLike, "n"], x: Real[ArrayLike, "n"], y: Real[ArrayLike, "n"], period: float,
    quality_factor: float, step: float = STEP, noise: float = 0.0,
) -> PolarExcitation:
    """Return the excitation that produces a measured polar motion.

    From step to step m_(n+1) = e m_n + (1 − e)ψ, e = exp(iσ_cΔ), which is exact for a ψ that is constant within the
    step; otherwise ψ is nearly its mean.

    Args:
        times: [s], ascending, without gaps longer than the step.
        x: the pole towards Greenwich [rad].
        y: the pole towards 90° West [rad].
        period: of the free wobble [s].
        quality_factor: Q of the free wobble; infinite for none.
        step: over which the pole is averaged [s].
        noise: standard deviation of a coordinate's mean over a step [rad].

    Raises:
        InvalidInput: for a series that is wrong or has gaps, or numbers that are not positive.

    Example:
        >>> import numpy as np
        >>> t = 10 * 86400.0 * np.arange(100.0)
        >>> still = polar_excitation(t, np.full(100, 2e-7), np.full(100, -1e-6), 433 * 86400.0, 100.0)
        >>> complex(still.psi[50].round(12))
        (2e-07+1e-06j)
    """
    period = check.number("period", period, above=0)
    quality_factor = check.number("quality_factor", quality_factor, above=0, infinite=True)
    step = check.number("step", step, above=0, remedy="Leave it out for 10 d.")
    noise = check.number("noise", noise, "rad", least=0, remedy="It is a standard deviation, zero for none.")
    if step > 0.1 * period:
        raise InvalidInput(f"`step` must be a tenth of the period at most; got {shown(step)} s. Leave it out for 10 d.")
    raw = clean_pole(times, x, y)
    step = max(step, float(np.median(np.diff(raw.times))))
    pole = even(raw, step)
    turn = np.exp(1j * 2.0 * np.pi / period * (1.0 + 0.5j / quality_factor) * step)
    psi = (pole.m[1:] - turn * pole.m[:-1]) / (1.0 - turn)
    # of independent means of variance σ²: ⟨|ψ_n|²⟩ = σ² (1 + |e|²)/|1 − e|², ⟨ψ_{n+1} ψ̄_n⟩ = −e σ²/|1 − e|², as
    # neighbours share one mean
    gain = (1.0 + abs(turn) ** 2) / abs(1.0 - turn) ** 2
    return PolarExcitation(0.5 * (pole.times[1:] + pole.times[:-1]), psi, float(noise * np.sqrt(gain)),
                           complex(-turn / (1.0 + abs(turn) ** 2)), step)
