"""Checks of the laws that algebras and systems must obey, for users' own ones."""

from polhode.testing.algebras import check_algebra
from polhode.testing.laws import LawBroken
from polhode.testing.systems import check_system

__all__ = ["LawBroken", "check_algebra", "check_system"]
