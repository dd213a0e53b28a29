"""The figures of a top of any kind."""

from polhode.figures.axis_figure import axis_locus
from polhode.figures.tilt_figure import top_motion
from polhode.figures.top_figure import spinning_top

FIGURES = {
    "spinning_top": lambda report: spinning_top(report.trajectory, surface=report.surface),
    "axis_locus": lambda report: axis_locus(report.trajectory),
    "motion": lambda report: top_motion(report.trajectory),
}

OVERVIEW = ((axis_locus, 1), (top_motion, 2))
