"""Verdicts on stability as files that provers check: Rocq and z3."""
