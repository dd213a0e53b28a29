"""The figures of a top of any kind."""

from polhode.figures.axis_locus import draw_axis_locus
from polhode.figures.spinning_top import draw_spinning_top
from polhode.figures.top_motion import draw_top_motion

FIGURES = {"spinning_top": draw_spinning_top, "axis_locus": draw_axis_locus, "motion": draw_top_motion}
