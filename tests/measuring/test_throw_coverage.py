"""How often intervals of throws hold the truth where the gyro's gains are three times as wrong as is assumed.

These are the numbers of docs/fit.md: it promised .91, measured on 45 throws.
"""

import numpy as np
import pytest

from measuring.thrown import BODIES, SPINS, throw
from polhode.measuring import Window, clean_log, fit_throw

DRAWS = 210  # whose share of .85 has a standard deviation of .02, as the two ratios of a throw go together
FAR_OUT = 3.0 * 0.02


@pytest.mark.sweep
def test_gains_of_three_percent_are_held_as_often_as_the_docs_say():
    cases, inside = [(body, spin) for body in BODIES for spin in SPINS], []
    for i in range(DRAWS):
        body, spin = cases[i % len(cases)]
        times, rates, _ = throw(np.random.default_rng([46, i]), BODIES[body], SPINS[spin], cross=0.01, gain=0.03)
        fit = fit_throw(clean_log(times, rates), [[Window(-0.01, 0.61)]])
        if fit.ratios is not None and fit.misfit is None:
            low, high = fit.ratios.interval().T
            inside.append((low <= BODIES[body][:2]) & (BODIES[body][:2] <= high))
    assert len(inside) >= 0.95 * DRAWS
    assert abs(np.mean(inside) - 0.85) < FAR_OUT
