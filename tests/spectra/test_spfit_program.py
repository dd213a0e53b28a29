"""Files that SPFIT wrote, and what SPCAT made of them: errors of lines, a linear molecule, options of their third line.

From the program's published examples (H2COH+ and HCP, Cologne Database for Molecular Spectroscopy; H. S. P. Müller et
al., Astron. Astrophys. 370 (2001) L49), as the programs of 2008 wrote them.
"""

import numpy as np
import pytest

from polhode import spectra
from polhode.errors import FormatError, InvalidInput
from polhode.spectra import Rotor
from polhode.spectra.fitting import _LineModel

PROTONATED = """H2COH+                                                  Tue Jun  3 23:17:18 2025
   8   32    5    0     1.0000E-10     1.0000E+03     1.0000E+00 1.0000000000
s   1   1   0  25   0   1   1   1       0     -1
        10000   1.975815594329546E+05 2.10391083E-02 /A
        20000   3.435054739588455E+04 2.49790647E-03 /B
        30000   2.917265425253290E+04 2.79056257E-03 /C
          200  -5.534126336114132E-02 3.92223122E-05 /-DJ
         1100  -6.291980947077179E-01 2.76360253E-04 /-DJK
         2000  -6.464408205562103E+00 8.70135225E-03 /-DK
        40100  -9.531001642388045E-03 7.51515645E-06 /d1
        50000  -1.933016057371318E-03 1.96108153E-05 /d2
-0.3645855-0.1221715-0.2206199 0.2037121 0.2753224 0.3729846 0.4041399-0.5138236
-0.2970426 0.4225525-0.4203631-0.5443156-0.4050536 0.3546508 0.8007350-0.5697291
 0.0349737-0.1332941 0.2385930-0.4254500 0.9274634 0.1728008-0.3003002 0.5639740
-0.1897546 0.0662290-0.1914656 0.8440167-0.3408333 0.4731035 0.5222506-0.7763625
 0.4164487 0.3211737 0.5363168 1.0000000
"""
# frequency and error [MHz] that SPCAT printed, upper and lower level
PREDICTED = (
    (5177.8169, 0.0025, (1, 1, 0), (1, 1, 1)), (8583.1578, 0.2756, (12, 3, 9), (12, 3, 10)),
    (63522.9803, 0.0045, (1, 0, 1), (0, 0, 0)), (27541.6986, 0.5692, (11, 2, 9), (12, 1, 12)),
    (372452.6388, 21.7774, (28, 3, 26), (27, 4, 23)), (103692.2098, 13.7957, (24, 2, 23), (23, 3, 20)),
)  # fmt: skip
LINEAR = """ HCP                                                    Tue Jun  3 23:19:29 2025
   3   22    2    0     1.0000E-10     1.0000E+06     1.0000E+00 1.0000000000
s   -1    1    0    0    0    1    1    1     0   -1    0
          100   1.997599422211193E+04 5.86704155E-04 /B
          200  -2.110383047436924E-02 1.31796171E-06 /-DJ
          300   1.467402519130994E-08 1.05309774E-09 /HJ
 0.2185321 0.7548646-0.5323874-0.6184037 0.8465008-1.0000000
"""


@pytest.fixture
def read(tmp_path):
    def of(text, name="a.var"):
        (tmp_path / name).write_text(text)
        return spectra.read_par(tmp_path / name)

    return of


def errors_of(table, correlation):
    """Return frequencies and errors [MHz] of the predicted lines, by the table's own errors."""
    rotor = table.rotor((0.0, 1.0, 0.0))
    names = ["A", "B", "C", "D_J", "D_JK", "D_K", "d1", "d2"]
    sign = np.array([1, 1, 1, -1, -1, -1, 1, 1])
    values = np.array([*rotor.constants, *(rotor.distortion[name] for name in names[3:])])
    upper, lower = (np.array([line[k] for line in PREDICTED]) for k in (2, 3))
    frequency, slope, _ = _LineModel(rotor, names, upper, lower)(values)
    scaled = slope * sign * table.error
    return np.abs(frequency) / 1e6, np.sqrt(np.einsum("ij,jk,ik->i", scaled, correlation, scaled))


@pytest.mark.filterwarnings("ignore:.*states of K above 25")
def test_errors_of_lines_are_those_that_spcat_printed(read):
    table = read(PROTONATED)
    frequency, error = errors_of(table, table.correlation)
    assert frequency == pytest.approx([line[0] for line in PREDICTED], abs=1e-4)
    assert error == pytest.approx([line[1] for line in PREDICTED], abs=6e-5)
    # as it was read before, row by row into a lower triangle, errors are wrong by factors of .23 to 1.65
    lower = np.zeros((8, 8))
    lower[np.tril_indices(8)] = np.array([float(line[k : k + 10]) for line in PROTONATED.splitlines()[11:]
                                          for k in range(0, len(line), 10)])  # fmt: skip
    wrong = errors_of(table, lower @ lower.T)[1] / error
    assert wrong.min() < 0.25 and wrong.max() > 1.6


def test_what_the_program_wrote_is_written_the_same(read, tmp_path):
    table = read(PROTONATED)
    spectra.write_par(table, tmp_path / "b.var")
    own, theirs = ((text.splitlines()[11:]) for text in ((tmp_path / "b.var").read_text(), PROTONATED))
    numbers = [[float(line[k : k + 10]) for line in lines for k in range(0, len(line), 10)] for lines in (own, theirs)]
    # a factor is fixed but for the signs of its columns
    assert np.abs(numbers[0]) == pytest.approx(np.abs(numbers[1]), abs=1e-6)
    assert [len(line) for line in own] == [len(line) for line in theirs]


def test_a_least_and_largest_k_of_zero_are_a_linear_molecule(read):
    """HCP: Q(300 K) = 313 and lines of CDMS's catalogue; as a spherical top, Q were 9831."""
    rotor = read(LINEAR).rotor((1.3e-30, 0.0, 0.0))
    assert rotor.is_linear and rotor.distortion.keys() == {"D_J", "H_J"}
    assert float(rotor.partition_function(300.0)) == pytest.approx(313.2, abs=0.3)
    B, D, H = 19975.99422211193, 0.02110383047436924, 1.467402519130994e-8
    J = np.arange(1, 6)
    wanted = 2 * B * J - 4 * D * J**3 + H * J**3 * ((J + 1) ** 3 - (J - 1) ** 3)
    assert rotor.lines(5).frequency / 1e6 == pytest.approx(wanted, rel=1e-13)
    # terms of J_z and J± do nothing at K = 0, and B may be given by the axes across
    B = "1.997599422211193E+04"
    other = LINEAR.replace("   3   22", "   5   22").replace(f"100   {B}", f"10000 1e6\n 30000 {B} 0 /C\n 20000 {B}")
    assert read(other).rotor().constants == pytest.approx(rotor.constants)


@pytest.mark.long
def test_a_linear_molecules_catalogue_has_j_alone(tmp_path):
    """Format 101, as the program writes HCP, whose first line is 39951.9 MHz."""
    lines = Rotor((np.inf, 19975.99422e6, 19975.99422e6), dipole=(1.3e-30, 0.0, 0.0)).lines(2, 300.0)
    spectra.write_cat(spectra.catalogue_of(lines, 0.0, 44006, 2), tmp_path / "a.cat")
    first = (tmp_path / "a.cat").read_text().splitlines()[0]
    assert first[:13] == "   39951.9884" and first[29:31] == " 2" and first[51:] == " 101 1" + 10 * " " + " 0"
    with pytest.raises(InvalidInput, match="no linear molecule"):
        spectra.catalogue_of(Rotor((3e9, 2e9, 1e9), dipole=(0.0, 1e-30, 0.0)).lines(2, 300.0), degrees=2)


def test_what_limits_k_is_said(read):
    with pytest.warns(UserWarning, match="leaves out states of K above 25 .* levels of J above 25 differ"):
        read(PROTONATED).rotor()
    with pytest.raises(InvalidInput, match=r"least K \(third option\) must be 0; got 1"):
        read(PROTONATED.replace("   0  25", "   1  25")).rotor()


OPTIONS = "s   1   1   0  99   0   2   1   3       {}     -1"


@pytest.mark.parametrize(("line", "weights"), [
    (OPTIONS.format(0), (1.0, 3.0)), (OPTIONS.format(1), (3.0, 1.0)), (OPTIONS.format(10), (1.0, 3.0)),
    ("a" + OPTIONS.format(0)[1:], (1.0, 3.0)), ("g" + OPTIONS.format(0)[1:], (1.0, 3.0)), ("s", (1.0, 1.0)),
    ("s1 1 0,, 0 -2 1 3", (1.0, 3.0)),
])  # fmt: skip
def test_options_as_the_program_takes_them(read, line, weights):
    """The letter is but a label: d2 makes it the S reduction. An odd symmetry changes the weights over."""
    rotor = read(PROTONATED.replace(PROTONATED.splitlines()[2], line)).rotor()
    assert rotor.spin_weights == weights and rotor.reduction.name == "S" and "d2" in rotor.distortion


def test_codes_and_errors_as_the_program_takes_them(read):
    text = PROTONATED.replace("        10000   1.975815594329546E+05 2.10391083E-02", "10000. 1.975815594329546D+05")
    assert read(text).error[0] == 0.0 and read(text, "a.par").error[0] == 1e37  # free
    assert read(text).code[0] == 10000 and read(text).value[0] == 197581.5594329546


@pytest.mark.parametrize(("change", "said"), [
    (("   1   1   1       0     -1", "   6   2   1       0     -1"), "axis of spin weights"),
    (("       0     -1", "      -1     -1\na   1   1   0  25   0   1   1   1   0  -1"), "with one line of options"),
    (("       0     -1", "       0    100"), "l-doubled"),
])  # fmt: skip
def test_what_is_not_of_one_plain_rotor_is_refused(read, change, said):
    with pytest.raises(InvalidInput, match=said):
        read(PROTONATED.replace(*change)).rotor()


def test_what_polhode_wrote_before_is_refused(read):
    wrong = PROTONATED.replace("-0.3645855-0.1221715", " 1.0000000-0.1221715")
    with pytest.raises(FormatError, match=r"length 1; got .* write it again"):
        read(wrong)
