"""Sweeps: many motions of one spec, with some of its numbers varied."""
