"""Kinds of motion that a spec can name: one folder each; none needs to be registered.

``docs/add_a_kind.md`` says what a folder holds, and how another package adds a kind of its own. What an author needs
for one is exported here.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
