"""C-kernels read through SPICE's own readers."""

from __future__ import annotations

import tempfile
from collections.abc import Sequence
from fractions import Fraction
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from polhode import rotation
from polhode.errors import FormatError, InvalidInput
from polhode.formats.attitude_checks import check_recorded
from polhode.formats.epochs import TIME_SYSTEMS, read_epoch
from polhode.formats.labels import AttitudeLabels, Recording
from polhode.formats.numerals import read_number
from polhode.formats.opening import MB, open_file
from polhode.formats.paths import as_path
from polhode.formats.time_scales import as_epoch, leap_seconds_kernel
from polhode.motion._layout import ATTITUDE, StateLayout
from polhode.motion._outcome import Ending, Outcome
from polhode.motion._trajectory import Trajectory
from polhode.spacecraft.formats.spice_checks import Segment, byte_order, check_ck, check_text_kernel, record_ticks
from polhode.spacecraft.formats.spice_kernels import KINDS, load_kernels, reword
from polhode.types import Array

BEGINNINGS = (b"DAF/CK", b"NAIF/DAF")
LARGEST_FILE = 2000 * MB  # as much as SPICE addresses by four bytes
NEEDED = ("It needs the clock kernel (.tsc) of its spacecraft, often a frame kernel (.tf): put them next to it under "
          "its name, or give `sclk`, `fk`, `lsk` of `polhode.spacecraft.read_ck`.")


class CalendarLimits(NamedTuple):
    """Which times of a clock kernel are refused."""

    max_seconds: float = 6e10  # 1900 years either way of 2000


LIMITS = CalendarLimits()


def read_ck(
    path: str | Path,
    *,
    sclk: str | Path | None = None,
    fk: str | Path | None = None,
    lsk: str | Path | None = None,
    spice_id: int | None = None,
) -> Trajectory:
    """Return the attitude history of a C-kernel of any type, as SPICE gives it, with AttitudeLabels as its system.

    It is sampled at its records, or evenly where its type has none (4, 6). Attitude is body → space, angular velocity
    along the body's axes, None unless all segments have it. Where several segments hold, SPICE's priorities do. Time
    zero is the epoch in the labels: for kernels of polhode's their own, for others the first sample's whole second.

    Args:
        path: the C-kernel.
        sclk: the spacecraft's clock kernel; None for the one next to the C-kernel with the ending .tsc.
        fk: frame kernel; None for the one next to it with the ending .tf, if any.
        lsk: leap-seconds kernel; None for the one next to it with the ending .tls, if any, else polhode's own.
        spice_id: whose attitude, as the kernel has it; it is needed where there are several.

    Raises:
        InvalidInput: for files that are missing, or unless the body is unambiguous.
        FormatError: for what SPICE refuses to read.
    """
    path = as_path("path", path)
    with open_file(path, "C-kernel", LARGEST_FILE) as file:
        begun = file.read(8)
    if not begun.startswith(BEGINNINGS):
        raise FormatError(f"{path}: is not a C-kernel, as it does not begin with DAF/CK. Check the file.")
    kernels = {name: _beside(path, name, ending, chosen) for (name, ending), chosen in
             zip(KINDS.items(), (fk, sclk, lsk), strict=True)}
    if kernels["clock"] is None:
        raise InvalidInput(f"{path}: needs the clock kernel of its spacecraft. Put it next to this one under its name, "
                           "or give `sclk` of `polhode.spacecraft.read_ck`.")
    segments = check_ck(path)
    with tempfile.TemporaryDirectory(prefix="polhode-") as folder:
        if kernels["leap seconds"] is None:
            kernels["leap seconds"] = Path(folder, "polhode.tls")
            kernels["leap seconds"].write_text(leap_seconds_kernel(), "ascii")
        return _load(path, [kernel for kernel in kernels.values() if kernel is not None], segments, spice_id)


def _load(path: Path, kernels: Sequence[Path], segments: Sequence[Segment], spice_id: int | None) -> Trajectory:
    try:
        with load_kernels([*kernels, path]) as spice, reword(path, NEEDED):
            number = _whose(path, segments, spice_id)
            segments = [one for one in segments if one.instrument == number]
            clock = int(spice.ckmeta(number, "SCLK"))
            if _pool(spice, f"SCLK_DATA_TYPE_{-clock}") is None:
                raise FormatError(f"{path}: no kernel loaded with it has its clock, of number {clock}. Check the "
                                  "clock kernel (.tsc).")
            return _sample(spice, path, number, clock, _ticks(path, segments), segments)
    except InvalidInput:
        raise
    except Exception:  # SPICE's answers need not be text, numbers, or as many as requested
        why = "cannot be read with the kernels that go with it; one of them is damaged, or of another spacecraft"
        raise FormatError(f"{path}: {why}. Check its kernels, .tsc, .tf and .tls.") from None


def _beside(path: Path, name: str, ending: str, chosen: str | Path | None) -> Path | None:
    kernel = path.with_suffix(f".{ending}") if chosen is None else Path(chosen)
    if chosen is None and not kernel.exists():
        return None
    check_text_kernel(kernel, f"{name} kernel")
    return kernel


def _whose(path: Path, segments: Sequence[Segment], spice_id: int | None) -> int:
    numbers = sorted({one.instrument for one in segments})
    if spice_id is None and len(numbers) == 1:
        return numbers[0]
    if spice_id in numbers:
        return int(spice_id)
    if spice_id is not None and 1000 * spice_id in numbers:
        return 1000 * spice_id
    held = ", ".join(map(str, numbers[:20])) or "none"
    came = "none was asked for" if spice_id is None else f"got {spice_id}"
    raise InvalidInput(f"{path}: holds attitudes of the numbers {held}; {came}. Choose one with `spice_id` of "
                       "`polhode.spacecraft.read_ck`.")


def _ticks(path: Path, segments: Sequence[Segment]) -> Array:
    """Return the clock's times (n,) at which segments have records; evenly spread ones where they have none."""
    count = 2000  # evenly spread samples, of types that keep no times of records
    doubles = np.memmap(path, dtype=f"{byte_order(path)}f8", mode="r", shape=(path.stat().st_size // 8,))
    parts = []
    for one in segments:
        ticks, _ = record_ticks(path, one, doubles[one.start - 1 : one.end])
        equal = np.linspace(one.first_tick, one.last_tick, count)
        parts.append(equal if ticks is None else np.array(ticks, dtype=float))
    return np.unique(np.concatenate(parts))


def _sample(spice: Any, path: Path, number: int, clock: int, ticks: Array, segments: Sequence[Segment]) -> Trajectory:
    reference = spice.frmnam(segments[0].reference)
    has_rates = all(segment.has_rates for segment in segments)
    matrices, rates, covered = np.empty((len(ticks), 3, 3)), np.empty((len(ticks), 3)), np.zeros(len(ticks), dtype=bool)
    for k, tick in enumerate(ticks.tolist()):
        try:
            if has_rates:
                matrices[k], rates[k], _ = spice.ckgpav(number, tick, 0.0, reference)
            else:
                matrices[k], _ = spice.ckgp(number, tick, 0.0, reference)
            covered[k] = True
        except spice.exceptions.NotFoundError:  # in a gap, where samples are spread evenly
            pass
    if not covered.any():
        raise FormatError(f"{path}: SPICE finds no attitude in it. Check the clock and frame kernels.")
    attitude = _continuous(rotation.conjugate(rotation.from_matrix(matrices[covered])))
    velocity = rotation.rotate(rotation.conjugate(attitude), rates[covered]) if has_rates else None
    times, epoch, system = _times(spice, path, clock, ticks[covered])
    check_recorded(path, times, attitude, velocity)
    labels = AttitudeLabels(
        object_name=_name(spice, number), reference_frame="EME2000" if reference == "J2000" else reference,
        body_frame=_frame(spice, number), epoch=epoch, time_system=system,
        spice_id=number // 1000 if number % 1000 == 0 else number, object_id=None, originator=None,
    )
    return Trajectory(
        times, attitude, StateLayout((ATTITUDE,)), attitude, angular_velocity=velocity,
        outcome=Outcome(Ending.RECORDED), source=Recording(labels.object_name, labels=labels),
    )


def _continuous(attitude: Array) -> Array:
    """Return the attitudes with signs that do not jump from sample to sample."""
    jumps = np.sum(attitude[1:] * attitude[:-1], axis=-1) < 0
    signs = np.concatenate([[1.0], np.where(np.cumsum(jumps) % 2, -1.0, 1.0)])
    return attitude * signs[:, None]


def _name(spice: Any, number: int) -> str:
    for body in (number, number // 1000):
        try:
            return spice.bodc2n(body)
        except spice.exceptions.NotFoundError:
            continue
    return f"SPICE {number}"


def _frame(spice: Any, number: int) -> str:
    try:
        return spice.ccifrm(3, number)[1]
    except spice.exceptions.NotFoundError:
        return f"CK {number}"


def _times(spice: Any, path: Path, clock: int, ticks: Array) -> tuple[Array, str, str]:
    """Return times [s] since an epoch, the epoch, and its time system."""
    number = -clock
    table = _pool(spice, f"SCLK01_COEFFICIENTS_{number}")
    moduli = _pool(spice, f"SCLK01_MODULI_{number}")
    if table is None or moduli is None:
        since = np.array([spice.sct2e(clock, tick) for tick in ticks])
        zero = _zero(path, since[0])
        return since - zero, as_epoch(Fraction(zero)), "TDB"
    system = "TT" if _pool(spice, f"SCLK01_TIME_SYSTEM_{number}") == 2 else "TDB"  # where it is silent, TDB
    if len(table) % 3 or not np.isfinite(table).all() or not (moduli > 0).all() or (np.diff(table[::3]) <= 0).any():
        raise FormatError(f"{path}: the clock kernel's table for clock {clock} is broken. Check its file.")
    table, per_second = table.reshape(-1, 3), float(np.prod(moduli[1:]))
    row = np.clip(np.searchsorted(table[:, 0], ticks, side="right") - 1, 0, None)
    elapsed = (ticks - table[row, 0]) / per_second * table[row, 2]
    own = _own_epoch(spice, number)
    if own is not None:
        return elapsed + own[2], own[1], own[0]
    # a double of seconds since 2000 is coarse: whole seconds come off before the rest is added
    zero = _zero(path, table[row[0], 1] + elapsed[0])
    return (table[row, 1] - zero) + elapsed, as_epoch(Fraction(zero)), system


def _own_epoch(spice: Any, number: int) -> tuple[str, str, float] | None:
    """Return time system, epoch and clock's zero [s] that a kernel of polhode's has."""
    try:
        system, epoch, zero = spice.gcpool(f"POLHODE_EPOCH_{number}", 0, 3)
    except spice.exceptions.NotFoundError:
        return None
    read_epoch(epoch, system)
    if system not in TIME_SYSTEMS:
        raise ValueError(system)
    return system, epoch, read_number(zero)


def _zero(path: Path, seconds: float) -> float:
    """Return the whole second of a time past J2000, which a calendar of four digits has."""
    if not abs(seconds) < LIMITS.max_seconds:
        why = f"its clock kernel gives {seconds:g} s past 2000, outside the calendar"
        raise FormatError(f"{path}: {why}. Check that kernel.")
    return float(np.floor(seconds))


def _pool(spice: Any, name: str) -> np.ndarray | None:
    """Return a variable of the loaded kernels."""
    try:
        return np.asarray(spice.gdpool(name, 0, spice.dtpool(name)[0]))
    except spice.exceptions.NotFoundError:
        return None
