"""Kinds of motion that a spec can name: one folder each; none needs to be registered.

``docs/add_a_kind.md`` says what a folder holds, and how another package adds a kind of its own. What an author needs
for one is exported here.
"""

from polhode._base.extras import attach_stub

__getattr__, __dir__, __all__ = attach_stub(__name__, __file__)
