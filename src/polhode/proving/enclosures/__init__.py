"""Proved bounds of the free body and the Lagrange top, in ball arithmetic."""
