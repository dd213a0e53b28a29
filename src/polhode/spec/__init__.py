"""Specs: TOML files that describe a body, its spin, and what acts on it."""
