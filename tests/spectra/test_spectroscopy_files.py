"""Catalogues, lists of lines and files of constants: columns by hand, round trips, damage, another reader."""

import dataclasses

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from polhode import spectra
from polhode.errors import FormatError, InvalidInput
from polhode.spectra import MeasuredLines, Reduction, Rotor, fit_rotor, spin_matrices
from polhode.spectra._operators import TERMS
from polhode.spectra.formats.fixed_columns import read_coded, write_coded
from polhode.spectra.formats.spfit_constants import encode
from spectra.molecules import FORMALDEHYDE, WATER

# frequency    error   lg I    DR  E"        g' tag    form upper       lower
CAT = (
    "    4829.6600  0.0010 -5.9024 3   10.5398  9 -30501 303 1 1 0       1 1 1      \n"
    "   72837.9492  0.0004 -4.1792 3    0.0000  3  30501 303 1 0 1       0 0 0      \n"
    "12345678.9012999.9999-10.1234 312345.6789A09-999999 303A5Z9a0      -1b9 7      \n"
)
LIN = (
    "  1  1  0  1  1  1                       4829.660000    0.001000  1.0000  /an old line\n"
    "  2  1  2  1  1  1                         4.69792810  -0.0000005 first, half\n"
    "  2  1  2  1  0  1    a  note 12           4.69792810  -0.0000005 0.5\r\n"
    "102101  1101100  1                     1.408395020D5,.01\n"
    "\n"
    "  3  1  2  3  1  3                      28974.8055     0.01    discarded, and so on\n"
)


def test_a_catalogue_by_its_columns(tmp_path):
    """Fields touch in the third line; what each of its columns holds was counted by hand."""
    (tmp_path / "a.cat").write_text(CAT)
    result = spectra.read_cat(tmp_path / "a.cat")
    assert result.frequency.tolist() == [4829.66, 72837.9492, 12345678.9012]
    assert result.error.tolist() == [0.001, 0.0004, 999.9999]
    assert result.log_intensity.tolist() == [-5.9024, -4.1792, -10.1234]
    assert result.degrees.tolist() == [3, 3, 3] and result.lower_energy.tolist() == [10.5398, 0.0, 12345.6789]
    assert result.degeneracy.tolist() == [9, 3, 1009] and result.tag.tolist() == [-30501, 30501, -999999]
    assert result.upper.tolist() == [[1, 1, 0], [1, 0, 1], [105, 359, -10]]
    assert result.lower.tolist() == [[1, 1, 1], [0, 0, 0], [-1, -29, 7]]


def test_a_list_of_lines_by_its_columns(tmp_path):
    """To the first blank line, as the program reads it; notes behind the quantum numbers, and exponents of Fortran."""
    (tmp_path / "a.lin").write_bytes(LIN.encode())
    result = spectra.read_lin(tmp_path / "a.lin")
    assert result.upper.tolist() == [[1, 1, 0], [2, 1, 2], [2, 1, 2], [102, 101, 1]]
    assert result.lower.tolist() == [[1, 1, 1], [1, 1, 1], [1, 0, 1], [101, 100, 1]]
    assert result.weight.tolist() == [1.0, 1.0, 0.5, 1.0]
    assert result.left_out == 1
    with pytest.warns(UserWarning, match=r"behind the first blank line, .* left out: 1"):
        lines = result.measured()
    assert lines.frequency == pytest.approx([4829.66e6, 4.6979281 * 29979.2458e6, 4.6979281 * 29979.2458e6,
                                             140839.502e6], rel=1e-15)  # fmt: skip
    assert lines.error == pytest.approx([1e3, 5e-7 * 29979.2458e6, 5e-7 * 29979.2458e6, 1e4], rel=1e-15)


def test_a_list_that_is_filled_up_by_zeros_and_one_that_gives_a_blends_width(tmp_path):
    one, two = (f"  {level}  1  1  1  0  0  0  0  0  0  4829.66 " for level in ("1  1  0", "2  1  2"))
    one, two = one + "0.001\n", two + "{}\n"
    (tmp_path / "a.lin").write_text(one + two.format("0.001"))
    result = spectra.read_lin(tmp_path / "a.lin").measured()
    assert (result.upper.tolist(), result.lower.tolist()) == ([[1, 1, 0], [2, 1, 2]], [[1, 1, 1]] * 2)
    (tmp_path / "a.lin").write_text(one + two.format("0.001") + two.format("0.004"))
    with pytest.raises(InvalidInput, match=r"line 3 has the frequency of the blend before it.*width of the blend"):
        spectra.read_lin(tmp_path / "a.lin").measured()


@pytest.mark.parametrize(("text", "name", "read", "write"), [
    (CAT, "a.cat", spectra.read_cat, spectra.write_cat), (CAT.rstrip(), "a.cat", spectra.read_cat, spectra.write_cat),
    (LIN, "a.lin", spectra.read_lin, spectra.write_lin),
    ("\n" + CAT.replace("\n", "\r\n"), "a.cat", spectra.read_cat, spectra.write_cat),
])  # fmt: skip
def test_what_is_read_is_written_byte_for_byte(tmp_path, text, name, read, write):
    (tmp_path / name).write_bytes(text.encode())
    write(read(tmp_path / name), tmp_path / ("b" + name))
    assert (tmp_path / ("b" + name)).read_bytes() == text.encode()


def test_what_was_changed_is_written_anew(tmp_path):
    (tmp_path / "a.cat").write_text(CAT)
    result = spectra.read_cat(tmp_path / "a.cat")
    frequency = result.frequency.copy()
    frequency[1] += 1.0
    spectra.write_cat(dataclasses.replace(result, frequency=frequency), tmp_path / "b.cat")
    old, new = CAT.splitlines(), (tmp_path / "b.cat").read_text().splitlines()
    assert new[0] == old[0] and new[2] == old[2] and new[1] == old[1].replace("72837", "72838").rstrip()


def decimals(low, high):
    return st.integers(low * 10**4, high * 10**4).map(lambda k: k / 1e4)


def column(values, count, kind=float):
    return st.lists(values, min_size=count, max_size=count).map(lambda result: np.array(result, kind))


@st.composite
def catalogues(draw):
    # columns alone: the run-time check of types uses chance, which strategies must not
    count, quanta = draw(st.integers(1, 4)), draw(st.integers(1, 6))
    numbers = column(st.integers(-269, 359), count * quanta, int).map(lambda x: x.reshape(count, quanta))
    reals = (decimals(0, 99_999_999), decimals(-99, 999), decimals(-99, 999))
    return [
        *(draw(column(values, count)) for values in reals), draw(column(st.integers(0, 9), count, int)),
        draw(column(decimals(-9999, 99_999), count)), draw(column(st.integers(0, 3599), count, int)),
        draw(column(st.integers(-999_999, 9_999_999), count, int)), np.full(count, 300 + quanta), draw(numbers),
        draw(numbers)]  # fmt: skip


@pytest.mark.long
@settings(max_examples=30, deadline=None, suppress_health_check=[HealthCheck.too_slow])  # on busy machines
@given(catalogues())
def test_catalogues_come_back(tmp_path_factory, columns):
    catalogue = spectra.Catalogue(*columns)
    folder = tmp_path_factory.mktemp("cat")
    spectra.write_cat(catalogue, folder / "a.cat")
    result = spectra.read_cat(folder / "a.cat")
    for field in dataclasses.fields(catalogue)[:-1]:
        assert np.array_equal(getattr(result, field.name), getattr(catalogue, field.name)), field.name
    spectra.write_cat(dataclasses.replace(result, text=None), folder / "b.cat")
    assert (folder / "a.cat").read_bytes() == (folder / "b.cat").read_bytes()


@settings(max_examples=30, deadline=None, suppress_health_check=[HealthCheck.too_slow])  # on busy machines
@given(st.integers(1, 6).flatmap(lambda k: st.lists(st.tuples(
    st.lists(st.integers(-99, 999), min_size=2 * k, max_size=2 * k),
    st.floats(-1e9, 1e9).filter(lambda x: x == 0.0 or abs(x) > 1e-9), st.floats(1e-9, 1e3), st.floats(0.01, 9.0)),
    min_size=1, max_size=4)))  # fmt: skip
def test_lists_of_lines_come_back(tmp_path_factory, rows):
    path = tmp_path_factory.mktemp("lin") / "a.lin"
    quanta = len(rows[0][0]) // 2
    numbers = np.array([row[0] for row in rows])
    value, error, weight = (np.array([row[k] for row in rows]) for k in (1, 2, 3))
    spectra.write_lin(spectra.LineList(numbers[:, :quanta], numbers[:, quanta:], value, error, weight), path)
    result = spectra.read_lin(path)
    assert np.array_equal(np.hstack([result.upper, result.lower]), numbers)
    assert [result.value.tolist(), result.error.tolist(), result.weight.tolist()] == [
        value.tolist(), error.tolist(), weight.tolist()]  # fmt: skip


@settings(deadline=None)
@given(st.integers(-269, 359))
def test_long_numbers_in_two_columns(number):
    word = write_coded(number, 2)
    assert len(word) == 2 and read_coded(word.strip(), 2) == number


def test_numbers_of_operators():
    codes = {name: encode(term) for terms in (TERMS[Reduction.A], TERMS[Reduction.S]) for name, term in terms.items()}
    wanted = {"Delta_J": 200, "D_JK": 1100, "D_K": 2000, "d1": 40100, "d2": 50000, "delta_J": 40100, "delta_K": 41000,
              "H_J": 300, "H_JK": 1200, "H_KJ": 2100, "H_K": 3000, "h1": 40200, "h2": 50100, "h3": 60000,
              "phi_JK": 41100, "phi_K": 42000, "L_JJK": 1300, "l4": 70000}  # fmt: skip
    assert {name: codes[name] for name in wanted} == wanted


PAR = """a title                                                  Mon Nov 23
   9  100   20    0    0.0000E+00    1.0000E+06    1.0000E+00 1.0000000000
a 1, 1, 0 ,99,, 2 1 3
        10000  8.358402880000000E+05 1.0E+37 /A
          100  3.56745208500E+05 1e37 /(B+C)/2
        40000  3.93032542500E+04 1e37 /(B-C)/4
          200 -37.59422 1e-37
         1100  172.9128 0 /-DJK
         2099 -973.29052
        40100 -15.210402
       -41000 -41.0502, 0.1, /-dK
-1.0 0.5 and so on
"""


def test_constants_of_water(tmp_path):
    """(B + C)/2 and (B − C)/4 of De Lucia's B and C; A less by the first, as 100 counts for all three axes."""
    (tmp_path / "a.par").write_text(PAR.replace("   9  100", "   8  100").replace(
        "8.358402880000000E+05", f"{835840.288 - 356745.2085:.4f}"))  # fmt: skip
    table = spectra.read_par(tmp_path / "a.par")
    assert table.title.startswith("a title") and table.label[:2] == ("A", "(B+C)/2") and len(table.code) == 8
    assert table.options[:8] == (1.0, 1.0, 0.0, 99.0, None, 2.0, 1.0, 3.0)
    rotor = table.rotor()
    assert rotor.constants == pytest.approx(WATER.constants, rel=1e-13)
    assert rotor.distortion == pytest.approx(WATER.distortion, rel=1e-13)
    assert (rotor.reduction.name, rotor.spin_weights, rotor.spin_axis) == ("A", (1.0, 3.0), "b")


@pytest.mark.parametrize(("basis", "axes"), [("Ir", "bca"), ("IIIl", "bac")])
@pytest.mark.parametrize("reduction", ["A", "S"])
def test_both_bases_are_those_of_the_program(tmp_path, basis, axes, reduction):
    """Its codes as operators: N_a², N_b², N_c², N², N_z² and N₊^2n + N₋^2n, in I^r and III^l, summed by matrices."""
    names = {"A": ("Delta_JK", "delta_J", "delta_K", "phi_K"), "S": ("D_JK", "d1", "d2", "h3")}[reduction]
    distortion = dict(zip(names, (3e6, -2e6, 1e6, 4e3), strict=True))
    rotor = Rotor((9e9, 7e9, 4e9), distortion, reduction, basis)
    spectra.write_par(spectra.constant_table(rotor), tmp_path / "a.par")
    table = spectra.read_par(tmp_path / "a.par")
    J = 4
    xyz = spin_matrices(J)
    one, square, z = np.eye(2 * J + 1), J * (J + 1) * np.eye(2 * J + 1), xyz[2] @ xyz[2]
    raised = xyz[0] + 1j * xyz[1]
    H = np.zeros_like(one, complex)
    for code, value in zip(table.code.tolist(), table.value.tolist(), strict=True):
        kind, of_z, of_J = code // 10000, code // 1000 % 10, code // 100 % 10
        N = xyz[axes.index("abc"[kind - 1])] if 1 <= kind <= 3 else None
        ladder = np.linalg.matrix_power(raised, 2 * max(kind - 3, 0))
        first = one if kind == 0 else N @ N if N is not None else ladder + ladder.conj().T
        rest = np.linalg.matrix_power(z, of_z) @ np.linalg.matrix_power(square, of_J)
        H += 1e6 * value * 0.5 * (first @ rest + rest @ first)
    assert np.linalg.eigvalsh(H) == pytest.approx(np.sort(rotor.levels_of(J).energy), rel=1e-12)
    again = table.rotor()
    assert again.representation is rotor.representation
    assert again.distortion == pytest.approx(rotor.distortion, rel=1e-14)
    other = Rotor((9e9, 7e9, 4e9), distortion, reduction, "Il" if basis == "Ir" else "IIIr")
    assert np.sort(other.levels_of(J).energy) != pytest.approx(np.linalg.eigvalsh(H), rel=1e-9)


def test_short_codes_stand_for_constants(tmp_path):
    """B of a symmetric top by 100, and A − B by 1000, C − B in the oblate basis."""
    for states, wanted in ((1, (9e9, 4e9, 4e9)), (-1, (4e9, 4e9, 2e9))):
        unique = wanted[0] - wanted[1] if states > 0 else wanted[2] - wanted[1]
        text = f"top\n 2 1 1 0\ns 1 {states} 0 99 0 1 1 1 0\n 100 4000.0 1e-3 /B\n 1000 {unique / 1e6} 1e-3 /more\n"
        (tmp_path / "a.par").write_text(text)
        assert spectra.read_par(tmp_path / "a.par").rotor().constants == pytest.approx(wanted, rel=1e-15)


def test_constants_come_back(tmp_path):
    sigma = {"A": 120.0, "D_J": 0.5}
    spectra.write_par(spectra.constant_table(FORMALDEHYDE, sigma, "H2CO"), tmp_path / "a.par")
    table = spectra.read_par(tmp_path / "a.par")
    assert table.error[:2].tolist() == [1.2e-4, 1e-37] and table.code[3:6].tolist() == [200, 1100, 2000]
    rotor = table.rotor(FORMALDEHYDE.dipole)
    assert rotor.constants == pytest.approx(FORMALDEHYDE.constants, rel=1e-15)
    assert rotor.distortion == pytest.approx(FORMALDEHYDE.distortion, rel=1e-15)
    assert rotor.lines(3, 300.0).intensity == pytest.approx(FORMALDEHYDE.lines(3, 300.0).intensity, rel=1e-12)
    spectra.write_par(dataclasses.replace(table, options=(1.0, None, None, 20.0)), tmp_path / "b.par")
    assert spectra.read_par(tmp_path / "b.par").options == (1.0, None, None, 20.0)


def test_a_catalogue_of_formaldehyde_and_a_fit_of_its_lines(tmp_path):
    lines = FORMALDEHYDE.lines(6, 300.0)
    spectra.write_cat(spectra.catalogue_of(lines, 1e3, 30501), tmp_path / "a.cat")
    assert "    4829.6599  0.0010 -5.9024 3   10.5390  9  30501 303 1 1 0       1 1 1\n" in (
        tmp_path / "a.cat").read_text()  # fmt: skip
    observed = MeasuredLines(lines.upper, lines.lower, lines.frequency, np.full(len(lines.frequency), 1e3))
    spectra.write_lin(spectra.line_list(observed), tmp_path / "a.lin")
    start = Rotor((281.97e9, 38.83e9, 34.0e9), FORMALDEHYDE.distortion, "S", "Ir")
    fit = fit_rotor(start, spectra.read_lin(tmp_path / "a.lin").measured(), ["A", "B", "C"])
    assert fit.values == pytest.approx(FORMALDEHYDE.constants, rel=1e-12)


def test_another_reader_reads_the_same(tmp_path):
    pyckett = pytest.importorskip("pyckett", reason="pyckett, which reads these files too, is not installed")
    lines = FORMALDEHYDE.lines(12, 300.0)
    ours = spectra.catalogue_of(lines, 2e3, -30501)
    spectra.write_cat(ours, tmp_path / "a.cat")
    (tmp_path / "b.cat").write_text(CAT.replace("A09", "  9"))
    for path in (tmp_path / "a.cat", tmp_path / "b.cat"):
        result, kept = pyckett.cat_to_df(path), spectra.read_cat(path)
        assert result["x"].to_numpy() == pytest.approx(kept.frequency, rel=1e-15)
        assert np.log10(result["y"].to_numpy()) == pytest.approx(kept.log_intensity, abs=1e-9)
        for theirs, own in (("error", kept.error), ("elower", kept.lower_energy), ("usd", kept.degeneracy),
                            ("tag", kept.tag), ("qnfmt", kept.form), ("degfreed", kept.degrees)):  # fmt: skip
            assert result[theirs].tolist() == own.tolist(), theirs
        for k in range(3):
            assert result[f"qnu{k + 1}"].tolist() == kept.upper[:, k].tolist()
            assert result[f"qnl{k + 1}"].tolist() == kept.lower[:, k].tolist()
    observed = MeasuredLines(lines.upper, lines.lower, lines.frequency, np.full(len(lines.frequency), 1e3))
    spectra.write_lin(spectra.line_list(observed), tmp_path / "a.lin")
    result, kept = pyckett.lin_to_df(tmp_path / "a.lin"), spectra.read_lin(tmp_path / "a.lin")
    assert result["x"].tolist() == kept.value.tolist() and result["error"].tolist() == kept.error.tolist()
    assert result[["qnl1", "qnl2", "qnl3"]].to_numpy().tolist() == kept.lower.tolist()
    spectra.write_par(spectra.constant_table(FORMALDEHYDE), tmp_path / "a.par")
    theirs, table = pyckett.parvar_to_dict(tmp_path / "a.par"), spectra.read_par(tmp_path / "a.par")
    own = zip(table.code.tolist(), table.value.tolist(), table.error.tolist(), strict=True)
    assert [row[:3] for row in theirs["PARAMS"]] == [list(row) for row in own]
    assert (theirs["CHR"], theirs["KNMAX"], theirs["IAX"], theirs["WTMN"]) == ("s", 99, 1, 3)


def changed(text, line, begin, new):
    """Return text with other characters from a column, counted from 1, of a line."""
    lines = text.splitlines(keepends=True)
    old = lines[line - 1]
    lines[line - 1] = old[: begin - 1] + new + old[begin - 1 + len(new) :]
    return "".join(lines)


@pytest.mark.parametrize(("name", "text", "said"), [
    ("a.cat", changed(CAT, 2, 1, "   x"), r"line 2, columns 1 to 13: frequency must be a number"),
    ("a.cat", changed(CAT, 1, 14, "        "), r"line 1, columns 14 to 21: error"),
    ("a.cat", changed(CAT, 1, 52, " 300"), r"line 1, columns 52 to 55: quantum number format"),
    ("a.cat", changed(CAT, 3, 56, "?5"), r"line 3, columns 56 to 57: upper quantum number 1"),
    ("a.cat", changed(CAT, 2, 68, "  "), r"line 2, columns 68 to 69: lower quantum number 1"),
    ("a.cat", changed(CAT, 2, 42, " 1."), r"line 2, columns 42 to 44: upper degeneracy"),
    ("a.cat", CAT[:-30], r"line 3, columns 5"), ("a.cat", "\n \n", "holds no lines"),
    ("a.lin", "\n" + LIN, "line 1 is blank, and reading ends at the first blank line"),
    ("a.lin", "\n", "holds no lines"),
    ("a.cat", CAT.replace("      \n", "      9 9\n", 1), "line 1, columns 80"),
    ("a.lin", changed(LIN, 1, 7, "   "), r"line 1, columns 1 to 36"),
    ("a.lin", changed(LIN, 1, 1, " x1"), r"line 1, columns 1 to 3: quantum number 1"),
    ("a.lin", LIN[:50] + "\n", r"line 1, columns 37 and on: must be a frequency and its error"),
    ("a.lin", LIN.replace("0.001000", "1e-"), r"line 1, columns 37 and on.*decimal digits"),
    ("a.lin", LIN.split("\n\n")[0] + "\n  1  1" + 32 * " " + "4. 1.\n", "entry 5: has 1 quantum numbers"),
    ("a.par", PAR.replace("a 1,", "ab 1,"), "line 3: each option must be a number"),
    ("a.par", PAR.replace("   9 ", "   x "), "line 2: each option must be a number"),
    ("a.par", PAR.replace("   9 ", "  -9 "), "line 2: must begin with the number of constants"),
    ("a.par", PAR.replace("1100", "11x0"), "line 8: must begin with a whole code"),
    ("a.par", "title\n1\n", "a title, two lines"), ("a.par", "title\n1\ns\n\n", "line 4"),
])  # fmt: skip
def test_damaged_files_are_refused_by_line_and_column(tmp_path, name, text, said):
    path = tmp_path / name
    path.write_bytes(text.encode())
    with pytest.raises(FormatError, match=said) as caught:
        getattr(spectra, "read_" + name[2:])(path)
    assert str(caught.value).startswith(str(path)) and "\n" not in str(caught.value)


@pytest.mark.parametrize(("constants", "given", "codes"), [
    ((9e9, 3e9, 3e9), "B", [10000, 20000, -30000]), ((9e9, 3e9, 3e9), "C", [10000, 20000, -30000]),
    ((9e9, 9e9, 3e9), "B", [10000, -20000, 30000]), ((9e9, 3e9, 3e9), "A", [10000, 20000, 30000]),
])  # fmt: skip
def test_equal_constants_are_written_as_ones_that_go_together(tmp_path, constants, given, codes):
    """A code below zero keeps its ratio to the one before; as a fixed constant C would stay, and B move alone."""
    table = spectra.constant_table(Rotor(constants), {given: 1e3}, "top", np.eye(1))
    assert table.code.tolist() == codes
    free = [code for code, error in zip(codes, table.error.tolist(), strict=True) if code > 0 and error > 1e-30]
    assert len(free) == 1 and (np.array(codes) < 0).sum() == (table.error > 1e-30).sum() - 1
    spectra.write_par(table, tmp_path / "a.var")
    again = spectra.read_par(tmp_path / "a.var")
    assert again.rotor().constants == pytest.approx(constants) and again.code.tolist() == codes


def test_what_cannot_be_written_leaves_nothing(tmp_path):
    (tmp_path / "a.cat").write_text(CAT)
    result = spectra.read_cat(tmp_path / "a.cat")
    for name, values, said in (("frequency", [1.0, 1e9, 3.0], "line 2.*columns 1 to 13"),
                               ("tag", [1, 2, -10_000_000], "line 3.*tag"),
                               ("upper", np.full((3, 3), 360), "line 1.*columns 56 to 57")):  # fmt: skip
        with pytest.raises(InvalidInput, match=said):
            spectra.write_cat(dataclasses.replace(result, **{name: np.array(values)}), tmp_path / "b.cat")
    assert [path.name for path in tmp_path.iterdir()] == ["a.cat"]


@pytest.mark.parametrize(("change", "said"), [
    ((" 1, 1, 0", " 3, 1, 0"), "without spins"), ((" 1, 1, 0", " 1, 2, 0"), "one state"),
    ((" 2 1 3", " 5 1 3"), "axis of spin weights"), (("1100", "110010000"),
                                                                                         "no operator 110010000"),
])  # fmt: skip
def test_constants_that_are_no_plain_rotor(tmp_path, change, said):
    (tmp_path / "a.par").write_text(PAR.replace("   9  100", "   8  100").replace(*change))
    with pytest.raises(InvalidInput, match=said):
        spectra.read_par(tmp_path / "a.par").rotor()


@pytest.mark.parametrize(("make", "said"), [
    (lambda: spectra.catalogue_of(FORMALDEHYDE.lines(1)), "intensities"),
    (lambda: spectra.catalogue_of(FORMALDEHYDE.lines(1, 300.0), -1.0), "`error`"),
    (lambda: spectra.constant_table(Rotor((3e9, 2e9, 1e9), {}, "A", "IIIr")), "representation Ir or IIIl"),
    (lambda: spectra.constant_table(Rotor((np.inf, 1e9, 1e9))), "linear"),
    (lambda: spectra.constant_table(Rotor((3e9, 2e9, 1e9), spin_weights=(0.5, 1))), "whole numbers"),
    (lambda: spectra.LineList(*[np.ones((1, 4), int)] * 2, *[np.ones(1)] * 3).measured(), "three quantum numbers"),
])  # fmt: skip
def test_what_files_cannot_hold(make, said):
    with pytest.raises(InvalidInput, match=said):
        make()


def test_a_var_file_keeps_correlations(tmp_path):
    """An upper triangular factor by columns, as the program's own files have it (``test_spfit_program``)."""
    names = ("A", "B", "C", "D_K")
    root = np.array([[0.4, 0.3, 0.5, -(0.5**0.5)], [0, 0.6, 0, 0.8], [0, 0, -0.6, 0.8], [0, 0, 0, 1]])
    sigma = dict.fromkeys(names, 1e4)
    table = spectra.constant_table(FORMALDEHYDE, sigma, "H2CO", root @ root.T)
    spectra.write_par(table, tmp_path / "a.var")
    rows = (tmp_path / "a.var").read_text().splitlines()[3 + len(table.code) :]
    count = len(table.code)
    numbers = [float(row[k : k + 10]) for row in rows for k in range(0, len(row), 10)]
    assert len(numbers) == count * (count + 1) // 2
    assert max(map(len, rows)) == 80
    assert numbers[:6] == pytest.approx([0.4, 0.3, 0.6, -0.5, 0.0, 0.6], abs=2e-6)
    again = spectra.read_par(tmp_path / "a.var")
    assert np.abs(again.correlation - table.correlation).max() < 2e-6
    where = [again.label.index(name) for name in names]
    sign = np.array([1, 1, 1, -1])  # D_K's operator has the other sign in these files
    assert np.abs(again.correlation[np.ix_(where, where)] - root @ root.T * np.outer(sign, sign)).max() < 2e-6
    spectra.write_par(table, tmp_path / "a.par")
    assert spectra.read_par(tmp_path / "a.par").correlation is None
    text = (tmp_path / "a.var").read_text()
    (tmp_path / "b.var").write_text(text[:-30])
    assert spectra.read_par(tmp_path / "b.var").correlation is None  # incomplete: as SPFIT, none
    (tmp_path / "c.var").write_text(text.replace(" 0.6000000", " 0.9000000"))
    with pytest.raises(FormatError, match="length 1"):
        spectra.read_par(tmp_path / "c.var")
    with pytest.raises(InvalidInput, match="must be square"):
        spectra.constant_table(FORMALDEHYDE, sigma, "", np.eye(3))
