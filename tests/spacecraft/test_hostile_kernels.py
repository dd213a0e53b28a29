"""C-kernels and the text that goes with them, damaged on purpose; SPICE goes on working after each."""

import struct
import warnings

import numpy as np
import pytest

from polhode.errors import FormatError, InvalidInput
from polhode.exact.free_body import FreeMotion
from polhode.formats.labels import AttitudeLabels
from polhode.spacecraft.formats.spice import write_ck
from polhode.spacecraft.formats.spice_reading import read_ck

spice = pytest.importorskip("spiceypy")
RECORD = 1024
SUMMARIES, NUMBERS = RECORD, 3 * RECORD
SEGMENT = SUMMARIES + 24  # bytes before the descriptor of the first segment


@pytest.fixture(scope="module")
def written(tmp_path_factory):
    """A kernel of 120 records, with those beside it, by ending."""
    labels = AttitudeLabels("BOX", spice_id=-777)
    path = tmp_path_factory.mktemp("kernels") / "a.bc"
    motion = FreeMotion((1.0, 2.0, 3.0), momentum=(0.3, 0.4, 0.5)).sample(np.linspace(0.0, 5.0, 120))
    return {file.suffix: file.read_bytes() for file in write_ck(motion, path, labels=labels)}


@pytest.fixture
def kernels(written, tmp_path):
    """Write a copy after changes: by ending, new content; of the C-kernel, bytes at places."""

    def make(*patches, **texts):
        content = bytearray(written[".bc"])
        for place, patch in patches:
            content[place : place + len(patch)] = patch
        for ending, text in written.items():
            (tmp_path / f"b{ending}").write_bytes(text)
        for ending, text in texts.items():
            (tmp_path / f"b.{ending}").write_bytes(text)
        (tmp_path / "b.bc").write_bytes(content)
        return tmp_path / "b.bc"

    return make


@pytest.fixture(autouse=True)
def left_clean(written, tmp_path_factory):
    """After whatever came, the next call works and nothing is loaded."""
    yield
    assert spice.ktotal("ALL") == 0 and not spice.failed()
    folder = tmp_path_factory.mktemp("again")
    for ending, text in written.items():
        (folder / f"a{ending}").write_bytes(text)
    assert len(read_ck(folder / "a.bc").times) == 120


def refused(path, words, **options):
    with warnings.catch_warnings(), pytest.raises(InvalidInput, match=words) as error:
        warnings.simplefilter("error")
        read_ck(path, **options)
    assert isinstance(error.value, FormatError) and len(str(error.value)) < 3000


def doubles(*values):
    return struct.pack(f"<{len(values)}d", *values)


def integers(*values):
    return struct.pack(f"<{len(values)}i", *values)


@pytest.mark.parametrize(("patch", "words"), [
    ((8, integers(3, 6)), "is not laid out as a C-kernel"),
    ((88, b"BIG-IEEE"), "is not laid out as a C-kernel"),
    ((76, integers(0)), "holds no segment"),
    ((76, integers(99999)), "leads to record 99999"),
    ((76, integers(-2)), "leads to record -2"),
    ((SUMMARIES, doubles(2.0)), "leads to record 2"),  # a list that leads back to itself
    ((SUMMARIES, doubles(np.nan)), "has the pointers"),
    ((SUMMARIES, doubles(1e300)), "has the pointers"),
    ((SUMMARIES + 16, doubles(1e9)), "has the pointers"),
    ((SEGMENT, doubles(np.nan)), "a segment is from nan"),
    ((SEGMENT + 16, integers(-777000, 1, 9)), "a segment is of type 9"),
    ((SEGMENT + 16, integers(-777000, 1, 1)), "has the counts|claims"),
    ((SEGMENT + 16, integers(-777000, 1, 2)), "of type 2 has"),
    ((SEGMENT + 16, integers(-777000, 1, 5)), "of type 5 has|of type 5 claims"),
    ((SEGMENT + 32, integers(385, 2**31 - 1)), "a segment is at 385 to 2147483647"),
    ((SEGMENT + 32, integers(-5)), "a segment is at -5"),
    ((SEGMENT + 16, integers(-777000, 424242)), "SPICE says|cannot be read"),
    ((NUMBERS, doubles(np.nan)), "is not finite"),
    ((NUMBERS, doubles(1e300)), "record 0 of a segment is not a unit quaternion"),
    ((NUMBERS, doubles(3.0)), "record 0 of a segment is not a unit quaternion"),
    ((NUMBERS + 120 * 56, doubles(1e18)), "do not ascend"),
])  # fmt: skip
def test_kernels_damaged_at_one_place(kernels, patch, words):
    refused(kernels(patch), words)


def test_counts_that_do_not_fit(kernels, written):
    """The last two numbers of a segment of type 3 count intervals and records."""
    end = struct.unpack_from("<i", written[".bc"], SEGMENT + 36)[0]
    for count in (1e12, 119.0, 121.0, 0.0, -1.0, 0.5):
        refused(kernels(((end - 1) * 8, doubles(count))), "claims|has the counts")


def test_kernels_cut_short_at_every_block(kernels, written):
    whole = written[".bc"]
    for size in {*range(0, len(whole), RECORD), *range(100, len(whole), 777)}:
        path = kernels()
        path.write_bytes(whole[:size])
        refused(path, "cut short or damaged|is not a C-kernel")


@pytest.mark.parametrize(("ending", "old", "new", "words"), [
    ("tsc", b"SCLK01_COEFFICIENTS_777", b"SCLK01_COEFFICIENTS_778", "b.bc"),
    ("tsc", b"SCLK01_MODULI_777", b"KERNELS_TO_LOAD = ( '/dev/zero' )\nSCLK01_MODULI_777", "meta-kernel"),
    ("tsc", b"\\begindata", b"\\begindata\n\xff\xfe = 1", "printable ASCII"),
    ("tsc", b"\\begindata", b"\\begindata\nA = ( 'x\0' )", "is not a clock kernel"),
    ("tsc", b"( 0  ", b"( 0 1 2 3 4 5 ", "table|SPICE"),
    ("tsc", b"( 0  ", b"( 1E999  ", "b.bc|b.tsc"),
    ("tsc", b"'UTC'", b"'MET'", "b.bc: cannot be read with the kernels"),
    ("tsc", b"'2000-01-01T00:00:00'", b"'soon'", "b.bc: cannot be read with the kernels"),
    ("tsc", b"'0' )", b"'1_0' )", "b.bc: cannot be read with the kernels"),
    ("tsc", b"POLHODE_EPOCH_777          = ( 'UTC'", b"POLHODE_EPOCH_777 = ( 'UTC' ) A = (", "b.bc: cannot be read"),
    ("tsc", b"KPL/SCLK", b"DAF/SPK ", "is not a clock kernel"),
    ("tf", b"FRAME_-777000_CLASS     = 3", b"FRAME_-777000_CLASS     = 'x'", ""),
    ("tls", b"DELTET/DELTA_T_A = ", b"DELTET/DELTA_T_A = 'x' ", ""),
    ("tls", b"\\begindata", b"\\begindata\n" + b"A" * 50_000 + b" = 1", "SPICE says"),
    ("tf", b"\\begindata", b"\\begindata\n" + b"".join(b"A%d = 1\n" % k for k in range(30_000)), "SPICE says"),
    ("tf", b"\\begindata", b"\\begindata\nA = ( 'x", "SPICE says"),
])  # fmt: skip
def test_text_kernels_of_junk(kernels, written, ending, old, new, words):
    text = written[f".{ending}"]
    assert old in text
    path = kernels(**{ending: text.replace(old, new)})
    if words:
        refused(path, words)
    else:
        try:
            assert len(read_ck(path).times) == 120
        except FormatError:
            pass


def test_kernels_of_the_wrong_kind(kernels):
    path = kernels()
    for option in ("sclk", "fk", "lsk"):
        refused(path, "is not a .* kernel, which is text", **{option: path})
    refused(path, r"b\.bc.*clock kernel", sclk=path.with_suffix(".tls"))
