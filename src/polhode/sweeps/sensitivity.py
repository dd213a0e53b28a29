"""The share of each output's variance that each input explains: Sobol' indices, estimated by SALib."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from polhode._base.extras import needing
from polhode.sweeps.sampling import Design


class Indices(NamedTuple):
    """Sobol' indices of one output with respect to one input.

    Attributes:
        input: key of the spec.
        first: share of the variance that the input explains alone.
        first_error: half-width of its 95 % interval, by bootstrap.
        total: share that would remain if all other inputs were fixed.
        total_error: half-width of its 95 % interval.
    """

    input: str
    first: float
    first_error: float
    total: float
    total_error: float


def sobol_indices(design: Design, values: Any) -> list[Indices] | None:
    """Return the indices of an output by its values (sample,) at the samples of a crossed design.

    Base points of which a sample has no value are left out; None where the output does not vary, or too few are left.
    Source: Saltelli et al., Comput. Phys. Commun. 181 (2010) 259; Jansen, Comput. Phys. Commun. 117 (1999) 35.

    Args:
        design: whose samples they are.
        values: (sample,), NaN where there is none.
    """
    with needing("Sensitivities need"):
        from SALib.analyze import sobol
    groups = np.asarray(values, dtype=float).reshape(-1, design.group)
    groups = groups[np.isfinite(groups).all(axis=1)]
    if len(groups) < 2 or np.ptp(groups) == 0.0:
        return None
    names = list(design.inputs)
    problem = {"num_vars": len(names), "names": names, "bounds": [[0.0, 1.0]] * len(names)}
    with np.errstate(all="ignore"):
        indices = sobol.analyze(problem, groups.ravel(), calc_second_order=False, num_resamples=200,
                              conf_level=0.95, seed=design.seed % 2**32)
    columns = (indices[key] for key in ("S1", "S1_conf", "ST", "ST_conf"))
    return [Indices(name, *map(float, row)) for name, *row in zip(names, *columns, strict=True)]
