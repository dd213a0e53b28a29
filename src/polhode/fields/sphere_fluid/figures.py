"""The figures of an ideal fluid on a sphere."""

from polhode.fields.sphere_fluid.map_figures import draw_globe, draw_vorticity
from polhode.fields.sphere_fluid.profile_figures import draw_spectrum, draw_zonal

FIGURES = {"vorticity": draw_vorticity, "globe": draw_globe, "spectrum": draw_spectrum, "zonal": draw_zonal}
