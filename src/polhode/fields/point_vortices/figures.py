"""The figures of point vortices."""

from polhode.fields.point_vortices.streamlines_figure import draw_streamlines
from polhode.fields.point_vortices.tracks_figure import draw_tracks

FIGURES = {"tracks": draw_tracks, "streamlines": draw_streamlines}
