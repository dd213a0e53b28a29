"""``polhode.wobble``: the Chandler wobble from measured polar motion."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np

from polhode._base import check
from polhode.celestial.tumbling.euler_periods import euler_chain
from polhode.celestial.wobble._pole_series import DAY, YEAR
from polhode.celestial.wobble.estimation import fit_chandler
from polhode.celestial.wobble.excitation import polar_excitation
from polhode.celestial.wobble.process import fit_chandler_process
from polhode.celestial.wobble.report import WobbleReport
from polhode.celestial.wobble.series_files import PoleSeries, format_day, parse_day, read_polar_motion
from polhode.celestial.wobble.windows import fit_chandler_windows, pole_spectrum
from polhode.errors import InvalidInput, shown
from polhode.formats.paths import as_path
from polhode.reports.report import with_inputs


def wobble(
    series: PoleSeries | Path | str | None = None, *, start: str | None = None, end: str | None = None,
    window: float = 6.0,
) -> WobbleReport:
    """Return a report on the Earth's wobble: the Chandler period, amplitude and Q with errors, and the seasons.

    Args:
        series: polar motion as ``read_polar_motion`` gives it, or its file; C04 of astropy-iers-data if left out.
        start, end: first day to use, and the day before which to stop, like "1976-01-01".
        window: length of sliding windows [years].

    Raises:
        InvalidInput: for days in the wrong order, a file that cannot be read, or a series that is too short.

    Source: Wilson & Vicente, Geophys. J. Int. 103 (1990) 743, for period and Q.
    """
    days = {"start": start, "end": end}
    if wrong := [name for name, day in days.items() if day is not None and not isinstance(day, str)]:
        raise InvalidInput(f'`{wrong[0]}` must be a day like "1976-01-01"; got {shown(days[wrong[0]])}.')
    window = check.number("window", window, "years", above=0, infinite=True)
    source = series if series is None or isinstance(series, PoleSeries) else as_path("series", series)
    return with_inputs(lambda: wobble_report(source, start, end, window))


def wobble_report(
    series: PoleSeries | Path | str | None, start: str | None, end: str | None, window: float
) -> WobbleReport:
    """Return the report of ``wobble``."""
    first = None if start is None else parse_day(start, "`start`")
    last = None if end is None else parse_day(end, "`end`")
    if first is not None and last is not None and first >= last:
        raise InvalidInput(f"`start` must be before `end`; got {start} and {end}. Swap them.")
    if not isinstance(series, PoleSeries):
        series = read_polar_motion(None if series is None else Path(series))
    used = _cut_between(series, first, last)
    pole = (used.days * DAY, used.x, used.y)
    line, process = fit_chandler(*pole), fit_chandler_process(*pole)
    period, quality = (float(value) for value in process.estimate.value)
    windows = fit_chandler_windows(*pole, window * YEAR, float(line.estimate.value[0]))
    if not line.noise.test.is_noise:  # the windows' errors are of the same model
        windows = replace(windows, covariance=np.full_like(windows.covariance, np.nan))
    return WobbleReport(used, line, process, windows, polar_excitation(*pole, period, quality), pole_spectrum(*pole),
                  euler_chain())


def _cut_between(series: PoleSeries, start: float | None, end: float | None) -> PoleSeries:
    inside = (series.days >= (-1.0 if start is None else start)) & (series.days < (1e9 if end is None else end))
    if not inside.any():
        first, last = (format_day(float(series.days[k])) for k in (0, -1))
        raise InvalidInput(f"{series.source} has no data between `start` and `end`: its days go from {first} "
                           f"to {last}. Choose among these.")
    names = ("days", "x", "y", "x_error", "y_error")
    return replace(series, **{name: getattr(series, name)[inside] for name in names})
