"""Polar motion as the IERS writes it, and one clear error for each thing that can be wrong."""

from math import pi

import astropy_iers_data
import numpy as np
import pytest

from polhode.celestial import read_polar_motion
from polhode.celestial.wobble.series_files import format_day, parse_day
from polhode.errors import FormatError, InvalidInput

ARCSECOND = pi / 648_000
C04_20 = """# YR  MM  DD  HH       MJD        x(")        y(")  UT1-UTC(s)       dX(")       dY(")  xrt("/day)
1962   1   1   0  37665.00   -0.012700    0.213000   0.0326338    0.000000    0.000000    0.000000    0.000000   0.0017230    0.030000    0.031000   0.0020000
1962   1   2   0  37666.00   -0.015900    0.214100   0.0320547    0.000000    0.000000    0.000000    0.000000   0.0016690    0.030000    0.031000   0.0020000
"""  # noqa: E501
C04_14 = """                        EARTH ORIENTATION PARAMETER (EOP) PRODUCT CENTER
INTERNATIONAL EARTH ROTATION AND REFERENCE SYSTEMS SERVICE
      Date      MJD      x          y        UT1-UTC       LOD         dX        dY        x Err     y Err   UT1-UTC Err
                         "          "           s           s          "         "           "          "          s
     (0h UTC)

1962   1   1  37665  -0.012700   0.213000   0.0326338   0.0017230   0.000000   0.000000   0.030000   0.031000  0.0020000
1962   1   2  37666  -0.015900   0.214100   0.0320547   0.0016690   0.000000   0.000000   0.030000   0.031000  0.0020000
"""
FINALS = """73 1 2 41684.00 I  0.120733 0.009786  0.136966 0.015902  I 0.8084178 0.0002710  0.0000 0.1916  P    -0.766
73 1 3 41685.00 I  0.118980 0.011039  0.135656 0.013616  I 0.8056163 0.0002710  3.5563 0.1916  P    -0.751
73 1 4 41686.00 P  0.117227 0.011039  0.134348 0.013616  P 0.8027895 0.0002710  2.6599 0.1916  P    -0.738
73 1 5 41687.00                                                                                               \n"""


@pytest.fixture
def file(tmp_path):
    def of(text, name="pole.txt"):
        path = tmp_path / name
        path.write_text(text)
        return path

    return of


@pytest.mark.parametrize(("text", "form"), [(C04_20, "C04 20"), (C04_14, "C04 14")])
def test_both_forms_of_c04(file, text, form):
    found = read_polar_motion(file(text))
    assert found.form == form and found.source == "pole.txt"
    assert found.days.tolist() == [37665, 37666]
    assert np.allclose(found.x / ARCSECOND, [-0.0127, -0.0159]) and np.allclose(found.y / ARCSECOND, [0.213, 0.2141])
    assert np.allclose(found.x_error / ARCSECOND, 0.030) and np.allclose(found.y_error / ARCSECOND, 0.031)


def test_finals_without_predictions(file):
    found = read_polar_motion(file(FINALS))
    assert found.form == "finals" and found.predicted == 1
    assert np.allclose(found.x / ARCSECOND, [0.120733, 0.118980]) and np.allclose(found.y[0] / ARCSECOND, 0.136966)
    assert np.allclose(found.x_error[1] / ARCSECOND, 0.011039) and found.days[-1] == 41685


@pytest.mark.parametrize(("text", "words"), [
    ("", "is empty. Give a C04 file"),
    ("# only words\n", "has no line of data"),
    ("1 2 3\n", "line 1: is no line of polar motion: no modified Julian date is in column 4 or 5"),
    ("\n".join(line[:60] for line in C04_20.splitlines()), "line 2: has 8 columns; C04 20 has at least 15"),
    (C04_20.replace("0.214100", "     nan"), "line 3, column 7: 'nan' must be a number"),
    (C04_20.replace("37666", "37665"), "line 3: MJD 37665 comes after 37665; dates must ascend"),
    (C04_20.replace("0.213000", " 213.000"), r"the pole is at \(-0.0127, 213\) arcseconds; it stays within 5"),
    (C04_14.replace("0.031000", "-0.03100"), "line 7: errors of x and y must not be negative"),
    (FINALS.replace(" I  0.118980", " I  0.11x980"), "line 2, column 19: '0.11x980' must be a number"),
    (FINALS.replace("41685.00 I", "41685.00 Q"), "line 2, column 17: must be I .* or P"),
    (FINALS.replace(".00 I", ".00 P"), "no measured pole, only predictions"),
])  # fmt: skip
def test_what_is_wrong_is_said(file, text, words):
    with pytest.raises(FormatError, match=words) as told:
        read_polar_motion(file(text))
    assert "pole.txt" in str(told.value)


def test_files_that_cannot_be_read(tmp_path):
    with pytest.raises(InvalidInput, match="no such polar motion file"):
        read_polar_motion(tmp_path / "none.txt")
    with pytest.raises(InvalidInput, match="is a folder"):
        read_polar_motion(tmp_path)
    (tmp_path / "binary").write_bytes(b"\xff\xfe\x00\x01")
    with pytest.raises(FormatError, match="is not UTF-8 text"):
        read_polar_motion(tmp_path / "binary")


def test_the_package(tmp_path):
    c04, finals = read_polar_motion(), read_polar_motion(astropy_iers_data.IERS_A_FILE)
    assert c04.days[0] == 37665 and len(c04.days) > 20_000 and c04.source.startswith("IERS C04 of astropy-iers-data")
    _, ours, theirs = np.intersect1d(c04.days, finals.days, return_indices=True)
    apart = np.abs(c04.x[ours] - finals.x[theirs])[-5000:] / ARCSECOND
    assert np.median(apart) < 2e-4  # two services agree


def test_days():
    assert parse_day("2026-09-29", "--to") == 61312 and format_day(61312.0) == "2026-09-29"
    for wrong in ("1976", "1976-13-01", "76-01-01", "x", "1976-01-01T00"):
        with pytest.raises(InvalidInput, match="--from must be a day like 1976-01-01"):
            parse_day(wrong, "--from")
