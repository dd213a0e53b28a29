"""SPICE's kernels: loaded while they are needed, and text kernels to go with an attitude history."""

from __future__ import annotations

import contextlib
import math
import re
import tempfile
import threading
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any, NamedTuple

from polhode._base.extras import needing
from polhode.errors import FormatError, InvalidInput, shown
from polhode.formats.labels import AttitudeLabels
from polhode.formats.time_scales import barycentric_time, terrestrial_time

OF_BROKEN_FILES = ("SPICE(DAF", "SPICE(FILEREADFAILED)", "SPICE(FTPXFERERROR)")  # errors in the file's own structure
OF_SPICE = {"EME2000": "J2000", "ICRF": "J2000", "GCRF": "J2000"}  # SPICE holds these three for the same
DIRECTORY = 100  # records to an entry of a segment's directory
KINDS = {"frame": "tf", "clock": "tsc", "leap seconds": "tls"}
_ONE_AT_A_TIME = threading.RLock()


class ClockLimits(NamedTuple):
    """How fine and how long a spacecraft clock counts."""

    max_bits: int = 40  # ticks are 2^-40 s at the finest, 0.9 ps
    max_count_bits: int = 52  # ticks stay below 2^52, so that doubles resolve them


LIMITS = ClockLimits()


class Clock(NamedTuple):
    """A spacecraft clock made for one history.

    Attributes:
        zero: the trajectory's time of its zero [whole s].
        bits: its ticks are 2^-bits s, so that doubles in seconds are ticks by a shift, without rounding.
    """

    zero: int
    bits: int

    @classmethod
    def of(cls, first: float, last: float) -> Clock:
        """Return a clock for times from first to last [s]; SPICE's ticks may not be negative."""
        zero = math.floor(first) if first < 0 else 0
        _, exponent = math.frexp(last - zero)
        bits = min(LIMITS.max_bits, LIMITS.max_count_bits - exponent)
        if bits < 1:
            raise InvalidInput(f"SPICE counts ticks up to 2⁵²; a history until {last:g} s is too long. Give a part.")
        return cls(zero, bits)

    def ticks(self, times: Any) -> Any:
        """Return encoded clock times of times [s]; fractions of ticks are meant."""
        return (times - self.zero) * 2.0**self.bits


def spiceypy() -> Any:
    """Return the module spiceypy.

    Raises:
        InvalidInput: where it is not installed.
    """
    with needing("SPICE kernels need"):
        import spiceypy
    return spiceypy


@contextlib.contextmanager
def spice_alone() -> Iterator[None]:
    """Keep all other threads of polhode from SPICE: it has one state for the whole process, and no locks."""
    with _ONE_AT_A_TIME:
        yield


@contextlib.contextmanager
def load_kernels(kernels: Sequence[Path]) -> Iterator[Any]:
    """Load kernels and yield spiceypy, to one thread at a time; unload them in the end, those of others stay.

    Raises:
        FormatError: for what SPICE refuses to load.
    """
    spice = spiceypy()
    with contextlib.ExitStack() as stack:
        stack.enter_context(spice_alone())
        for kernel in kernels:
            with reword(kernel, "Check that it is a SPICE kernel, whole and of the kind that its option asks for."):
                try:
                    spice.furnsh(str(kernel))
                except spice.exceptions.SpiceyError:
                    _forget(spice)
                    raise
            stack.callback(spice.unload, str(kernel))
        yield spice


def _forget(spice: Any) -> None:
    """Remove the half of a refused kernel that SPICE kept: unloading any text kernel loads the others again."""
    with tempfile.TemporaryDirectory(prefix="polhode-") as folder:
        empty = Path(folder, "empty.tf")
        empty.write_text("KPL/FK\n", "ascii")
        spice.furnsh(str(empty))
        spice.unload(str(empty))


@contextlib.contextmanager
def reword(path: Path, remedy: str) -> Iterator[None]:
    """Turn SPICE's errors into one of ours that names the file."""
    spice = spiceypy()
    try:
        yield
    except spice.exceptions.SpiceyError as error:
        text = " ".join(f"{error.short} {error.long or error.explain}".split())
        if error.short.startswith(OF_BROKEN_FILES):
            remedy = "The file is cut short or damaged. Get it whole."
        raise FormatError(f"{path}: SPICE says: {text} {remedy}") from None


def instrument(labels: AttitudeLabels) -> int:
    """Return the number under which SPICE has the body's attitude."""
    if not -(2**31) // 1000 < labels.spacecraft < 0:
        raise InvalidInput(f"`spice_id` must be NAIF's negative number of a spacecraft; got {labels.spacecraft}.")
    return 1000 * labels.spacecraft


def reference(labels: AttitudeLabels) -> str:
    """Return SPICE's name of the space axes."""
    name = OF_SPICE.get(labels.reference_frame.upper(), labels.reference_frame.upper())
    with spice_alone():
        known = spiceypy().namfrm(name) != 0
    if not known:
        why = "`reference_frame` must be one that SPICE knows, as EME2000, ICRF, B1950 or ECLIPJ2000"
        raise InvalidInput(f"{why}; got {shown(labels.reference_frame)}.")
    return name


def clock_kernel(labels: AttitudeLabels, clock: Clock) -> str:
    """Return the text of a clock kernel: seconds, and ticks of a power of two.

    Its seconds are those of TDB for epochs in TDB, else of TT, which UTC, TAI and GPS share with it.
    """
    barycentric, number = labels.time_system == "TDB", -labels.spacecraft
    start = (barycentric_time if barycentric else terrestrial_time)(labels.epoch, labels.time_system) + clock.zero
    return f"""KPL/SCLK

The clock of {_plain(labels.object_name)}, by polhode: seconds since its zero and ticks of 2^-{clock.bits} s.
Its zero is {labels.epoch} {labels.time_system} {clock.zero:+d} s.

\\begindata

SCLK_KERNEL_ID             = ( @2000-01-01 )
SCLK_DATA_TYPE_{number}         = ( 1 )
SCLK01_TIME_SYSTEM_{number}     = ( {1 if barycentric else 2} )
SCLK01_N_FIELDS_{number}        = ( 2 )
SCLK01_MODULI_{number}          = ( {2 ** (LIMITS.max_count_bits + 1 - clock.bits)} {2**clock.bits} )
SCLK01_OFFSETS_{number}         = ( 0 0 )
SCLK01_OUTPUT_DELIM_{number}    = ( 1 )
SCLK_PARTITION_START_{number}   = ( 0 )
SCLK_PARTITION_END_{number}     = ( {2 ** (LIMITS.max_count_bits + 1) - 1} )
SCLK01_COEFFICIENTS_{number}    = ( 0  {float(start)!r}  1 )
POLHODE_EPOCH_{number}          = ( '{labels.time_system}' '{labels.epoch}' '{clock.zero}' )

\\begintext
"""


def frame_kernel(labels: AttitudeLabels) -> str:
    """Return the text of a frame kernel, which names body, frame and clock."""
    number, name = instrument(labels), frame_name(labels)
    return f"""KPL/FK

The body axes of {_plain(labels.object_name)}, by polhode.

\\begindata

NAIF_BODY_NAME           += ( '{_plain(labels.object_name)[:36]}' )
NAIF_BODY_CODE           += ( {labels.spacecraft} )
FRAME_{name} = {number}
FRAME_{number}_NAME      = '{name}'
FRAME_{number}_CLASS     = 3
FRAME_{number}_CLASS_ID  = {number}
FRAME_{number}_CENTER    = {labels.spacecraft}
CK_{number}_SCLK         = {labels.spacecraft}
CK_{number}_SPK          = {labels.spacecraft}

\\begintext
"""


def frame_name(labels: AttitudeLabels) -> str:
    """Return the body axes' name as SPICE's frames may be called.

    Raises:
        InvalidInput: for a name that SPICE has for a frame of its own.
    """
    name = _plain(labels.body_frame)[:26]
    with spice_alone():
        own = spiceypy().namfrm(name) > 0  # negative ones come from kernels that are loaded now, which does not matter
    if own:
        raise InvalidInput(f"`body_frame` must not be one of SPICE's own frames; got {shown(labels.body_frame)}.")
    return name


def _plain(name: str) -> str:
    """Return a name in the characters that SPICE's names are safe with."""
    return re.sub(r"[^A-Z0-9_]", "_", name.upper()) or "BODY"
