"""Constants of a rotor from measured lines, by least squares.

Source: Albritton, Schmeltekopf & Zare, in *Molecular Spectroscopy: Modern Research* 2 (1976) 1; Belsley, Kuh & Welsch,
*Regression Diagnostics* (1980) for leverage and for what is determined; Birge, Phys. Rev. 40 (1932) 207 for errors
of lines that are too small by one factor.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from scipy.optimize import least_squares

from polhode._base.arrays import known_numbers_only
from polhode.errors import InvalidInput, NotConverged
from polhode.special._residual_noise import NoiseTest, test_known_errors
from polhode.spectra._derivatives import AXES, LevelModel, check_names, find_tied, get_constant, once_each
from polhode.spectra._measured import MeasuredLines, Observations, check_labels, observations
from polhode.spectra.rotor import Rotor
from polhode.types import Array, Float64, Integer


class RotorFitLimits(NamedTuple):
    """What decides whether lines determine constants, and whether a fit has converged and is right.

    Attributes:
        min_singular_value: over the largest, with columns of length one: below it a combination of constants is not
            determined.
        min_named_share: of an undetermined combination, from which on a constant is named.
        convergence: of a last step and of what it gains: in units of σ, far below them.
        max_scatter: root mean square of the residuals over the lines' errors; beyond it labels or model are wrong,
            rather than errors too small.
        max_rounding: of a derivative ∂E′/∂p − ∂E″/∂p, over its terms: a constant with smaller ones changes no line.
    """

    min_singular_value: float = 1e-10
    min_named_share: float = 0.1
    convergence: float = 1e-9
    max_scatter: float = 2.0
    max_rounding: float = 1e-13


LIMITS = RotorFitLimits()


@dataclass(frozen=True, eq=False)
class RotorFit:
    """A rotor fitted to measured lines; an observation is a line or a blend, in the order of the lines.

    Attributes:
        rotor: with the fitted constants.
        names: the p free constants.
        values, sigma: (p,) [Hz]; σ from the errors of the lines, times ``enlarged``.
        correlation: (p, p); NaN where σ is.
        noise: whether the errors of the lines explain the residuals, by χ².
        enlarged: factor of σ: 1 where they do; Birge's ratio √(χ²/ν) where residuals are up to twice as large, as they
            are if all errors are too small by one factor; NaN beyond, where the constants have no errors.
        observation: (n,) to which observation each line belongs.
        calculated: (n,) frequency of each line [Hz].
        residual: (m,) observed less calculated [Hz].
        weighted: (m,) residual over error.
        leverage: (m,) from 0 to 1, how far each observation determines its own calculated value; they add up to p.
        standardized: (m,) weighted residual over its standard deviation √(1 − leverage); NaN where nothing but this
            observation determines something, so that its residual is zero whatever was measured.
        rms: of the weighted residuals.
    """

    rotor: Rotor
    names: tuple[str, ...]
    values: Float64[Array, "p"]
    sigma: Float64[Array, "p"]
    correlation: Float64[Array, "p p"]
    noise: NoiseTest
    enlarged: float
    observation: Integer[Array, "n"]
    calculated: Float64[Array, "n"]
    residual: Float64[Array, "m"]
    weighted: Float64[Array, "m"]
    leverage: Float64[Array, "m"]
    standardized: Float64[Array, "m"]
    rms: float

    @property
    def determined(self) -> bool:
        """Whether the constants have standard errors."""
        return bool(np.isfinite(self.enlarged))

    @property
    def covariance(self) -> Float64[Array, "p p"]:
        """Of the free constants [Hz²]."""
        return self.correlation * np.outer(self.sigma, self.sigma)

    def worst(self, count: int = 10) -> Integer[Array, "k"]:
        """Return which observations fit worst, by standardised residual, the worst first."""
        return np.argsort(-np.nan_to_num(np.abs(self.standardized)), kind="stable")[:count]

    def predict(
        self, upper: Integer[Array, "k 3"], lower: Integer[Array, "k 3"]
    ) -> tuple[Float64[Array, "k"], Float64[Array, "k"]]:
        """Return frequencies (k,) [Hz] of lines, and their σ as the fitted constants leave them, NaN if they have none.

        Args:
            upper, lower: (k, 3) J, K_a, K_c.

        Raises:
            InvalidInput: for labels that no level has.
        """
        ends = check_labels("upper", upper), check_labels("lower", lower)
        frequency, slope, _ = _LineModel(self.rotor, list(self.names), *ends)(self.values)
        # by the scaled correlation: entries of the covariance differ by thirty powers of ten
        scaled = slope * self.sigma
        return frequency, np.sqrt(np.maximum(np.einsum("ij,jk,ik->i", scaled, self.correlation, scaled), 0.0))


@known_numbers_only
def fit_rotor(rotor: Rotor, lines: MeasuredLines, free: Sequence[str] | None = None) -> RotorFit:
    """Fit constants of a rotor to measured lines by weighted least squares, from the rotor's own as a start.

    Derivatives are exact; Levenberg and Marquardt's damping converges from far away, if the labels are those of the
    start.
    Of a symmetric top, whose B and C (or A and B) are equal at the start, these are one constant and stay equal: it is
    free under the first of its names that is given. To fit them each, start from constants that differ.

    Args:
        rotor: the start; its constants that are not free stay.
        lines: measured.
        free: names of constants, "A", "B", "C" and those of the rotor's reduction, such as "D_J"; where left out, all
            that the rotor has, but for those that change none of these lines, such as A where no line has another K.

    Raises:
        InvalidInput: for constants that the lines do not determine, which are named; invalid lines or names; linear
            molecules.
        NotConverged: if the fit does not converge.

    >>> rotor = Rotor((27e9, 14e9, 9e9), dipole=(0.0, 1e-30, 0.0))
    >>> exact = rotor.lines(4)
    >>> lines = MeasuredLines(exact.upper, exact.lower, exact.frequency, np.full(len(exact.frequency), 1e4))
    >>> fit = fit_rotor(Rotor((27.1e9, 13.9e9, 9e9)), lines, ["A", "B", "C"])
    >>> bool(np.allclose(fit.values, rotor.constants, rtol=1e-12)), fit.names
    (True, ('A', 'B', 'C'))
    """
    if rotor.is_linear:
        raise InvalidInput("`rotor` must not be linear: its lines are a polynomial in J + 1, which `np.polyfit` fits.")
    observed = observations(lines)
    names = once_each(rotor, check_names(rotor, [*AXES, *rotor.distortion] if free is None else free))
    if free is None:
        names = _find_sensitive(rotor, names, observed)
    model = _LineModel(rotor, names, observed.upper, observed.lower)
    start = np.array([get_constant(rotor, name) for name in names])
    _, scale, _, _ = _decompose(*_at(model, observed, start)[1:], names)

    def residual(steps: Array) -> Array:
        return _at(model, observed, start + steps * scale)[0]

    def jacobian(steps: Array) -> Array:
        return -_at(model, observed, start + steps * scale)[1] * scale

    # from a start that is 1e11 errors away, steps of a few errors would seem to gain nothing
    first_share = 1e-6  # of the residuals at the start: a hundredth of the first step at most
    unit = max(1.0, first_share * float(np.linalg.norm(residual(np.zeros(len(names))))))
    ways: Any = {"jac": jacobian, "x_scale": unit}
    small = LIMITS.convergence
    solution = least_squares(residual, np.zeros(len(names)), **ways, method="lm", xtol=small, ftol=small, gtol=small)
    values = start + solution.x * scale
    if solution.status <= 0 or not np.isfinite(values).all():
        raise NotConverged("the fit has not converged. Start nearer, check the labels, or free fewer constants.")
    return _fit_at(rotor, names, values, model, observed)


def _find_sensitive(rotor: Rotor, names: list[str], observed: Observations) -> list[str]:
    """Return the constants that change any line; all where none does, so that the error names them."""
    _, slope, size = _at(_LineModel(rotor, names, observed.upper, observed.lower), observed,
                         np.array([get_constant(rotor, name) for name in names]))
    alone = _is_rounding(slope, size)
    return [name for name, silent in zip(names, alone, strict=True) if not silent] or names


def _is_rounding(slope: Array, size: Array) -> Array:
    """Whether derivatives by a constant (p,) are nothing but rounding."""
    return np.linalg.norm(slope, axis=0) <= LIMITS.max_rounding * np.linalg.norm(size, axis=0)


class _LineModel:
    """Frequencies of lines as a function of constants."""

    def __init__(self, rotor: Rotor, names: list[str], upper: Array, lower: Array) -> None:
        levels, place = np.unique(np.concatenate([upper, lower]), axis=0, return_inverse=True)
        self._levels, self._ends = LevelModel(rotor, names, levels), place.reshape(2, -1)

    def __call__(self, values: Array) -> tuple[Array, Array, Array]:
        """Return frequencies (n,), derivatives (n, p), and the sizes of the terms these are differences of."""
        energy, slope = self._levels(values)
        high, low = self._ends
        return energy[high] - energy[low], slope[high] - slope[low], np.abs(slope[high]) + np.abs(slope[low])


def _at(model: _LineModel, observed: Observations, values: Array) -> tuple[Array, Array, Array]:
    """Return weighted residuals (m,), weighted derivatives of the calculated (m, p), and the size of their terms."""
    frequency, slope, size = (observed.means(part) for part in model(values))
    error = observed.error[:, None]
    return (observed.frequency - frequency) / observed.error, slope / error, size / error


def _decompose(slope: Array, size: Array, names: list[str]) -> tuple[Array, Array, Array, Array]:
    """Return U, the scale, S and Vᵀ of slope · scale = U S Vᵀ, whose columns have length one.

    Raises:
        InvalidInput: naming the constants that are not determined.
    """
    length = np.linalg.norm(slope, axis=0)
    alone = _is_rounding(slope, size)
    scale = 1.0 / np.where(alone, 1.0, length)
    few = len(slope) < len(names)  # only then are null vectors missing from the reduced V
    U, S, V = np.linalg.svd(slope * scale * ~alone, full_matrices=few)
    S = np.concatenate([S, np.zeros(len(names) - len(S))])
    lost = V[S <= LIMITS.min_singular_value * S.max()]
    if len(lost):
        named = [name for k, name in enumerate(names) if np.abs(lost[:, k]).max() > LIMITS.min_named_share]
        one = len(named) == 1
        raise InvalidInput(
            f"the free constant{' ' if one else 's '}{', '.join(named)} {'is' if one else 'are'} not determined by "
            f"these {len(slope)} observations; fix {'it' if one else f'{len(lost)} of them'}, or add lines."
        )
    return U[:, : len(names)], scale, S, V


def _fit_at(rotor: Rotor, names: list[str], values: Array, model: _LineModel, observed: Observations) -> RotorFit:
    weighted, slope, size = _at(model, observed, values)
    U, scale, S, V = _decompose(slope, size, names)
    # the covariance (XᵀX)⁻¹ of slope X = U S Vᵀ/scale is the square of this; its rows at unit length give the
    # correlation without forming a matrix whose entries differ by thirty powers of ten
    spread = (V.T / S) * scale[:, None]
    sigma = np.linalg.norm(spread, axis=1)
    unit = spread / sigma[:, None]
    # the diagonal of the hat matrix X (XᵀX)⁻¹ Xᵀ = U Uᵀ (Belsley, Kuh & Welsch, ch. 2)
    leverage = np.sum(U**2, axis=1)
    left = 1.0 - leverage
    standardized = np.where(left > 1e-9, weighted / np.sqrt(np.maximum(left, 1e-9)), np.nan)
    rms = float(np.sqrt(np.mean(weighted**2)))
    noise, enlarged = _test_lines(weighted, len(names), rms)
    correlation = unit @ unit.T if np.isfinite(enlarged) else np.full((len(names), len(names)), np.nan)
    return RotorFit(
        _with(rotor, names, values), tuple(names), values, sigma * enlarged, correlation, noise, enlarged,
        observed.member, model(values)[0], weighted * observed.error, weighted, leverage, standardized, rms,
    )


def _test_lines(weighted: Array, free: int, rms: float) -> tuple[NoiseTest, float]:
    """Return whether the errors of the lines explain the residuals, and the factor by which σ is enlarged."""
    squares, freedom = float((weighted**2).sum()), len(weighted) - free
    noise = test_known_errors(squares, freedom)
    if noise.is_noise:
        return noise, 1.0
    return noise, float(np.sqrt(squares / freedom)) if rms <= LIMITS.max_scatter else float("nan")


def _with(rotor: Rotor, names: list[str], values: Array) -> Rotor:
    """Return the rotor with other constants."""
    fitted = dict(zip(names, values.tolist(), strict=True))
    axes = dict(zip(AXES, rotor.constants, strict=True))
    axes |= {axis: fitted[name] for name in names if name in AXES for axis in find_tied(rotor, name, names)}
    A, B, C = axes.values()
    if not A >= B >= C >= 0.0:
        raise InvalidInput(
            f"the lines lead to A, B, C = {A:.9g}, {B:.9g}, {C:.9g} Hz, which are not in the order A ≥ B ≥ C ≥ 0. "
            "Check the labels of the lines, or start nearer."
        )
    distortion = rotor.distortion | {name: value for name, value in fitted.items() if name not in AXES}
    reduction, representation = (kind.name if kind else None for kind in (rotor.reduction, rotor.representation))
    return Rotor((A, B, C), distortion, reduction, representation, rotor.dipole, rotor.spin_weights, rotor.spin_axis)
