"""Modules that are joined into one for Numba have no two constants of one name: one of them would serve for both.

Until names said what they bound, `FAR` was 256 units of a step and 1e300 of an anomaly, `FARTHEST` was two numbers too,
and the joined modules took one for both.
"""

import pytest

from polhode.taylor import kernel_kepler, kernel_series
from polhode.taylor.kernels import MODULES


def clashes(modules):
    """Return the names that modules give to different numbers, texts or tuples of such."""
    values = {}
    for module in modules:
        for name, value in vars(module).items():
            if isinstance(value, int | float | str | tuple) and not name.startswith("__"):
                values.setdefault(name, set()).add(repr(value))
    return sorted(name for name, each in values.items() if len(each) > 1)


@pytest.mark.parametrize("width", MODULES)
def test_no_two_constants_have_one_name(width):
    assert set(clashes(MODULES[width])) <= {"LANES"}  # which `kernel_lanes` sets for all


def test_two_of_one_name_are_seen(monkeypatch):
    monkeypatch.setattr(kernel_series, "FAR", 256.0, raising=False)
    monkeypatch.setattr(kernel_kepler, "FAR", 1e300, raising=False)
    assert clashes([kernel_series, kernel_kepler]) == ["FAR"]
