"""Kinds of motion that a spec can name: a folder each, which registers itself by being here.

``docs/add_a_kind.md`` says what a folder holds, and how another package adds a kind of its own.
"""
