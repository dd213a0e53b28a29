"""The inputs of each sample of a sweep: a function of its index alone, whatever computes it, in whatever order."""

from __future__ import annotations

import math
import warnings
import zlib
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np

from polhode.sweeps.distributions import AbstractDistribution, AbstractPlaced, AbstractRandom, Grid
from polhode.types import Float64

MIN_UNIFORM = 2.0**-54  # half a step of uniform numbers, as the normal distribution reaches to infinity at 0
SOBOL_BITS = 32  # of a Sobol' point, and so the most points, as powers of two; SciPy cannot go ahead with more


@dataclass(frozen=True)
class Design:
    """The inputs of all samples.

    Attributes:
        inputs: the distribution of each, by key.
        draws: samples at each point of the grids; base points of a sensitivity analysis.
        seed: of the random numbers.
        points: "random", or "sobol" for scrambled Sobol' points, which fill the space more evenly.
        crossed: whether samples are those of a variance-based sensitivity analysis: of each two base points A and B
            come A, then A with each input in turn from B, then B. Source: Saltelli et al., Comput. Phys. Commun. 181
            (2010) 259.
    """

    inputs: dict[str, AbstractDistribution]
    draws: int
    seed: int
    points: Literal["random", "sobol"] = "random"
    crossed: bool = False

    @property
    def grids(self) -> dict[str, Grid]:
        return {key: how for key, how in self.inputs.items() if isinstance(how, Grid)}

    @property
    def group(self) -> int:
        """Samples of a base point."""
        return len(self.inputs) + 2 if self.crossed else 1

    @property
    def count(self) -> int:
        """How many samples there are."""
        return self.draws * self.group * math.prod(grid.count for grid in self.grids.values())

    def values(self, low: int, high: int) -> dict[str, Float64[np.ndarray, "sample ..."]]:
        """Return the inputs of the samples low, …, high − 1."""
        samples = np.arange(low, high)
        if self.crossed:
            return self._cross(samples)
        uniform, point, values = self._uniform(low, high), samples // self.draws, {}
        for key, how in reversed(self.inputs.items()):  # the last grid runs fastest
            if isinstance(how, Grid):
                values[key] = how.at(point % how.count)
                point = point // how.count
            elif isinstance(how, AbstractPlaced):
                values[key] = how.at(samples % self.draws)
            else:
                assert isinstance(how, AbstractRandom)
                values[key] = how.values(uniform[key])
        return {key: values[key] for key in self.inputs}

    def _uniform(self, low: int, high: int, parts: int = 1) -> dict[str, Any]:
        """Return uniform numbers (sample, parts × dimensions) in (0, 1) for each random input."""
        sizes = {key: how.dimensions * parts for key, how in self.inputs.items() if how.dimensions}
        if self.points == "random" and not self.crossed:
            return {key: self._random(key, size, low, high) for key, size in sizes.items()}
        uniform, columns, at = {}, self._sobol(sum(sizes.values()), low, high), 0
        for key, size in sizes.items():
            uniform[key], at = columns[:, at : at + size], at + size
        return uniform

    def _random(self, key: str, size: int, low: int, high: int) -> Any:
        """Return numbers of the input's own stream, which other inputs do not change."""
        generator = np.random.Philox(np.random.SeedSequence([self.seed, zlib.crc32(key.encode())]))
        at_each_count = 4  # numbers of Philox
        counts, ahead = divmod(low * size, at_each_count)
        generator.advance(counts)
        numbers = np.random.Generator(generator).random(ahead + (high - low) * size)[ahead:]
        return np.maximum(numbers, MIN_UNIFORM).reshape(-1, size)

    def _sobol(self, size: int, low: int, high: int) -> Any:
        from scipy.stats import qmc

        engine = qmc.Sobol(size, scramble=True, bits=SOBOL_BITS, rng=np.random.default_rng(self.seed))
        if low:  # fast_forward(0) would go back
            engine.fast_forward(low)
        with warnings.catch_warnings():  # that a part of the points is not balanced by itself is meant
            warnings.simplefilter("ignore", UserWarning)
            return np.clip(engine.random(high - low), MIN_UNIFORM, 1.0 - 2.0 * MIN_UNIFORM)

    def _cross(self, samples: Any) -> dict[str, Any]:
        base, which = samples // self.group, samples % self.group
        low, high = int(base[0]), int(base[-1]) + 1
        uniform, values = self._uniform(low, high, parts=2), {}
        for k, (key, how) in enumerate(self.inputs.items()):
            assert isinstance(how, AbstractRandom)
            first, second = (uniform[key][:, part : part + how.dimensions] for part in (0, how.dimensions))
            taken = ((which == k + 1) | (which == self.group - 1))[:, None]
            values[key] = how.values(np.where(taken, second[base - low], first[base - low]))
        return values
