"""C-kernels read through SPICE's own readers."""

from __future__ import annotations

import tempfile
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np

from polhode import rotation
from polhode.errors import FormatError, InvalidInput
from polhode.formats.given_axes import check_recorded
from polhode.formats.labels import AttitudeLabels
from polhode.formats.opening import MB, check_is_file, open_file
from polhode.formats.spice_kernels import DIRECTORY, KINDS, loaded, worded
from polhode.formats.time_scales import as_epoch, leap_seconds_kernel
from polhode.trajectory import Trajectory

Array = Any
BEGINNINGS = (b"DAF/CK", b"NAIF/DAF")
SUMMARY = (2, 6)  # doubles and integers of a segment's descriptor
PACKETS = {0: 8, 1: 4, 2: 14, 3: 7}  # doubles to a packet, by subtype of type 5
LARGEST_FILE = 2000 * MB  # as much as SPICE addresses by four bytes
LARGEST_TEXT = 64 * MB  # of a frame, clock or leap-seconds kernel
EQUAL = 2000  # samples, spread evenly, of types that keep no records at times of their own
NEEDED = "It needs the clock kernel (.tsc) of its spacecraft, often a frame kernel (.tf): give --sclk, --fk, --lsk."


@dataclass(frozen=True)
class _Segment:
    """What a segment's descriptor says; addresses count doubles from 1."""

    first_tick: float
    last_tick: float
    reference: int
    kind: int
    has_rates: bool
    start: int
    end: int


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
        sclk: the spacecraft's clock kernel; None for the one beside the C-kernel with the ending .tsc.
        fk: frame kernel; None for the one beside it with the ending .tf, if any.
        lsk: leap-seconds kernel; None for the one beside it with the ending .tls, if any, else polhode's own.
        spice_id: whose attitude, as the kernel has it; it is needed where there are several.

    Raises:
        InvalidInput: for files that are missing, or unless one body is meant.
        FormatError: for what SPICE refuses to read.
    """
    path = Path(path)
    with open_file(path, "C-kernel", LARGEST_FILE) as file:
        begun = file.read(8)
    if not begun.startswith(BEGINNINGS):
        raise FormatError(f"{path}: is no C-kernel, as it does not begin with DAF/CK. Check the file.")
    found = {name: _beside(path, ending, chosen) for (name, ending), chosen in
             zip(KINDS.items(), (fk, sclk, lsk), strict=True)}  # fmt: skip
    if found["clock"] is None:
        raise InvalidInput(f"{path}: needs the clock kernel of its spacecraft; give it with --sclk FILE.tsc.")
    with tempfile.TemporaryDirectory(prefix="polhode-") as folder:
        if found["leap seconds"] is None:
            found["leap seconds"] = Path(folder, "polhode.tls")
            found["leap seconds"].write_text(leap_seconds_kernel(), "ascii")
        return _read(path, [kernel for kernel in found.values() if kernel is not None], spice_id)


def _read(path: Path, kernels: Sequence[Path], spice_id: int | None) -> Trajectory:
    with loaded([*kernels, path]) as spice, worded(path, NEEDED):
        number = _whose(spice, path, spice_id)
        segments = _segments(spice, path, number)
        clock = int(spice.ckmeta(number, "SCLK"))
        if _pool(spice, f"SCLK_DATA_TYPE_{-clock}") is None:
            raise FormatError(f"{path}: no kernel loaded with it has its clock, of number {clock}. Check --sclk.")
        ticks = np.unique(np.concatenate([_record_ticks(spice, path, segment) for segment in segments]))
        return _sampled(spice, path, number, clock, ticks, segments)


def _beside(path: Path, ending: str, chosen: str | Path | None) -> Path | None:
    if chosen is not None:
        check_is_file(Path(chosen), "kernel", LARGEST_TEXT)
        return Path(chosen)
    beside = path.with_suffix(f".{ending}")
    if not beside.exists():
        return None
    check_is_file(beside, "kernel", LARGEST_TEXT)
    return beside


def _whose(spice: Any, path: Path, spice_id: int | None) -> int:
    numbers = [int(number) for number in spice.ckobj(str(path))]
    if spice_id is None and len(numbers) == 1:
        return numbers[0]
    if spice_id in numbers:
        return int(spice_id)
    if spice_id is not None and 1000 * spice_id in numbers:
        return 1000 * spice_id
    held = ", ".join(map(str, numbers)) or "none"
    came = "none was asked for" if spice_id is None else f"got {spice_id}"
    raise InvalidInput(f"{path}: holds attitudes of the numbers {held}; {came}. Choose one with --spice-id.")


def _segments(spice: Any, path: Path, number: int) -> list[_Segment]:
    found = []
    handle = spice.dafopr(str(path))
    try:
        spice.dafbfs(handle)
        while spice.daffna():
            doubles, integers = spice.dafus(spice.dafgs(), *SUMMARY)
            instrument, reference, kind, rates, start, end = (int(value) for value in integers)
            if instrument == number:
                first, last = float(doubles[0]), float(doubles[1])
                found.append(_Segment(first, last, reference, kind, bool(rates), start, end))
    finally:
        spice.dafcls(handle)
    return found


def _record_ticks(spice: Any, path: Path, segment: _Segment) -> Array:
    """Return the clock's times (n,) at which a segment has records; evenly spread ones where it has none.

    Layouts: NAIF, *CK Required Reading*, data types 1, 2, 3 and 5.
    """
    start, end = segment.start, segment.end
    size = 7 if segment.has_rates else 4
    handle = spice.dafopr(str(path))

    def part(first: int, count: int) -> Array:
        return np.atleast_1d(np.asarray(spice.dafgda(handle, first, first + count - 1)))

    try:
        if segment.kind in (1, 3):
            count = int(part(end, 1)[0])
            return part(start + size * count, count)
        if segment.kind == 2:  # start and stop of each, and a directory, but no count
            count = (DIRECTORY * (end - start + 1) + DIRECTORY) // (10 * DIRECTORY + 1)
            return part(start + 8 * count, 2 * count)
        if segment.kind == 5:
            subtype, _, _, count = part(end - 3, 4).astype(int)
            return part(start + PACKETS[int(subtype)] * int(count), int(count))
        return np.linspace(segment.first_tick, segment.last_tick, EQUAL)
    finally:
        spice.dafcls(handle)


def _sampled(spice: Any, path: Path, number: int, clock: int, ticks: Array, segments: Sequence[_Segment]) -> Trajectory:
    reference = spice.frmnam(segments[0].reference)
    has_rates = all(segment.has_rates for segment in segments)
    matrices, rates, found = np.empty((len(ticks), 3, 3)), np.empty((len(ticks), 3)), np.zeros(len(ticks), dtype=bool)
    for k, tick in enumerate(ticks):
        try:
            if has_rates:
                matrices[k], rates[k], _ = spice.ckgpav(number, tick, 0.0, reference)
            else:
                matrices[k], _ = spice.ckgp(number, tick, 0.0, reference)
            found[k] = True
        except spice.exceptions.NotFoundError:  # in a gap, where samples are spread evenly
            pass
    if not found.any():
        raise FormatError(f"{path}: SPICE finds no attitude in it. Check the clock and frame kernels.")
    attitude = _continuous(rotation.conjugate(rotation.from_matrix(matrices[found])))
    velocity = rotation.rotate(rotation.conjugate(attitude), rates[found]) if has_rates else None
    times, epoch, system = _times(spice, clock, ticks[found])
    check_recorded(path, times, attitude, velocity)
    labels = AttitudeLabels(
        object_name=_name(spice, number), reference_frame="EME2000" if reference == "J2000" else reference,
        body_frame=_frame(spice, number), epoch=epoch, time_system=system,
        spice_id=number // 1000 if number % 1000 == 0 else number, object_id=None, originator=None,
    )  # fmt: skip
    return Trajectory(labels, times, attitude, attitude=attitude, angular_velocity=velocity, status="read from SPICE")


def _continuous(attitude: Array) -> Array:
    """Return the same attitudes with signs that do not jump from sample to sample."""
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


def _times(spice: Any, clock: int, ticks: Array) -> tuple[Array, str, str]:
    """Return times [s] since an epoch, the epoch, and its time system."""
    number = -clock
    table = _pool(spice, f"SCLK01_COEFFICIENTS_{number}")
    moduli = _pool(spice, f"SCLK01_MODULI_{number}")
    if table is None or moduli is None:
        since = np.array([spice.sct2e(clock, tick) for tick in ticks])
        zero = np.floor(since[0])
        return since - zero, as_epoch(Fraction(float(zero))), "TDB"
    system = "TT" if _pool(spice, f"SCLK01_TIME_SYSTEM_{number}") == 2 else "TDB"  # where it is silent, TDB
    table, per_second = table.reshape(-1, 3), float(np.prod(moduli[1:]))
    row = np.clip(np.searchsorted(table[:, 0], ticks, side="right") - 1, 0, None)
    elapsed = (ticks - table[row, 0]) / per_second * table[row, 2]
    try:
        own_system, own_epoch, own_zero = spice.gcpool(f"POLHODE_EPOCH_{number}", 0, 3)
        return elapsed + float(own_zero), own_epoch, own_system
    except spice.exceptions.NotFoundError:
        pass
    # a double of seconds since 2000 is coarse: whole seconds come off before the rest is added
    zero = np.floor(table[row[0], 1] + elapsed[0])
    return (table[row, 1] - zero) + elapsed, as_epoch(Fraction(float(zero))), system


def _pool(spice: Any, name: str) -> Array | None:
    """Return a variable of the loaded kernels."""
    try:
        return np.asarray(spice.gdpool(name, 0, spice.dtpool(name)[0]))
    except spice.exceptions.NotFoundError:
        return None
