"""The figures of a spin on an orbit."""

from polhode.celestial.spin_orbit.history_figure import draw_spin_history
from polhode.celestial.spin_orbit.section_figure import draw_spin_section

FIGURES = {"section": draw_spin_section, "motion": draw_spin_history}
