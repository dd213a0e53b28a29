"""The course: exercises with answers that polhode computes, worksheets, and where the built course is.

It answers what a learner asks: whether an answer is right, which mistake explains it, and where the course is to be
read; for a teacher it writes worksheets with keys. It has no formulas of its own: the chapters' answers are expressions
over polhode's public names, and each has a second formula beside it that a test compares. From the core it takes
``errors`` alone, and the whole package by the name ``ph`` of these expressions.
"""

from polhode._base.extras import attach_stub

__getattr__, __dir__, __all__ = attach_stub(__name__, __file__)
