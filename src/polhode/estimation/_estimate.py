"""Named estimates with their uncertainty."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from scipy.stats import norm
from scipy.stats import t as student

from polhode._base import check
from polhode.types import Array, Float64


@dataclass(frozen=True, eq=False)
class Estimate:
    """Named estimates with their covariance.

    Attributes:
        names: the p estimated numbers.
        value: (p,) in SI units.
        covariance: (p, p); NaN where nothing is known of the errors, as in a fit whose residuals are not noise.
        degrees_of_freedom: of the residuals from which the size of the errors was estimated; None where it was known.
    """

    names: tuple[str, ...]
    value: Float64[Array, "p"]
    covariance: Float64[Array, "p p"]
    degrees_of_freedom: float | None = None

    @property
    def standard_error(self) -> Float64[np.ndarray, "p"]:
        """Standard deviations of the estimates."""
        return np.sqrt(np.diagonal(self.covariance))

    @property
    def correlation(self) -> Float64[Array, "p p"]:
        """Correlations of the estimates; zero beside one that has no error."""
        size = self.standard_error
        size = np.where(size > 0, size, 1.0)
        return self.covariance / np.outer(size, size)

    def without_errors(self) -> Estimate:
        """Return the estimates with nothing known of their errors."""
        return replace(self, covariance=np.full_like(self.covariance, np.nan), degrees_of_freedom=None)

    def interval(self, confidence: float = 0.95) -> Float64[Array, "p 2"]:
        """Return the lower and upper ends of confidence intervals.

        They are of Student's t where the size of the errors was estimated, and normal where it was known.

        Raises:
            InvalidInput: if ``confidence`` is not between 0 and 1.

        Example:
            >>> import numpy as np
            >>> Estimate(("I1",), np.array([2.0]), np.array([[0.01]])).interval().round(3).tolist()
            [[1.804, 2.196]]
        """
        confidence = check.number("confidence", confidence, above=0, below=1)
        tail = 0.5 + 0.5 * confidence
        reach = norm.ppf(tail) if self.degrees_of_freedom is None else student.ppf(tail, self.degrees_of_freedom)
        return self.value[:, None] + reach * self.standard_error[:, None] * np.array([-1.0, 1.0])
