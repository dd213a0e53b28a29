"""Which cases run by default, and which in the sweep alone."""

import pytest


def first(count, cases):
    """Return cases for ``parametrize``: so many as they are, the others marked as a sweep.

    Every kind of case has one that runs by default; the others repeat it with other numbers.
    """
    for k, case in enumerate(cases):
        values = case if isinstance(case, tuple) else (case,)
        yield case if k < count else pytest.param(*values, marks=pytest.mark.sweep)


def only(chosen, cases):
    """Return cases for ``parametrize``: those in ``chosen`` as they are, the others marked as a sweep."""
    for case in cases:
        values = case if isinstance(case, tuple) else (case,)
        yield case if case in chosen else pytest.param(*values, marks=pytest.mark.sweep)
