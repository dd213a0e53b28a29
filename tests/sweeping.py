"""Which cases run by default, and which in the sweep alone."""

import pytest


def first(count, cases):
    """Return cases for ``parametrize``: so many as they are, the others marked as a sweep.

    Every kind of case has one that runs by default; the others repeat it with other numbers.
    """
    return [case if k < count else _swept(case) for k, case in enumerate(cases)]


def only(chosen, cases):
    """Return cases for ``parametrize``: those in ``chosen`` as they are, the others marked as a sweep."""
    return [case if case in chosen else _swept(case) for case in cases]


def _swept(case):
    values = case if isinstance(case, tuple) else (case,)
    return pytest.param(*values, marks=pytest.mark.sweep)
