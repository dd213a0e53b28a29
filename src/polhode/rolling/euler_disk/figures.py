"""The figures of a rolling disk."""

from polhode.rolling.euler_disk.end_figure import draw_disk_end
from polhode.rolling.euler_disk.path_figure import draw_contact_path
from polhode.rolling.euler_disk.rolling_figure import draw_rolling_disk

FIGURES = {"rolling_disk": draw_rolling_disk, "tilt": draw_disk_end, "contact_path": draw_contact_path}
