"""Each number that comes in by any door is read as what it says, or refused in one message; none is read as another."""

from decimal import Decimal
from fractions import Fraction

import numpy as np
import pytest

from polhode.formats.form_registry import forms
from polhode.kinds.registry import kind_names
from twins import doors
from twins.table import read_tables

NUMERALS = {"digits and exponents": ("1e-99999999", "1e99999999", "9" * 5000, "1e400", "1e-400"),
            "finite": ("nan", "inf", "-inf")}  # fmt: skip
NUMBERS = {"digits and exponents": (10**400, Fraction(10**400), Decimal("1e99999999"), "1e400"),
           "finite": (np.nan, np.inf, -np.inf)}  # fmt: skip
BY_ELEMENT = {"rotation", "rotation vector", "axis", "angle", "elliptic integral", "theta function", "kks_form",
              "covector", "vector_field", "invariants", "LiePoisson energy"}  # fmt: skip
"""Functions of each element, inner ones of loops among them: NaN in gives NaN out, as in NumPy."""
BINARY = {"ck", "netcdf"}
"""Formats whose numbers are bytes, damaged in formats/reader_fuzz.py."""
KINDS = kind_names()
GUARDS = {column: [row for row, at in read_tables()["Guards and doors"].pairs() if at == column]
          for column in ("argument", "spec", "data file", "command option", "plug-in")}  # fmt: skip


@pytest.mark.usefixtures("any_type")
@pytest.mark.parametrize("entry", sorted(doors.ENTRIES.keys() - BY_ELEMENT))
@pytest.mark.parametrize("guard", GUARDS["argument"])
def test_arguments(entry, guard):
    """One half of the library read what no double holds by one function, the other half by NumPy's own errors."""
    for number in NUMBERS[guard]:
        assert isinstance(doors.call_with(entry, number), doors.Refused), number


@pytest.mark.usefixtures("any_type")
@pytest.mark.parametrize("guard", GUARDS["spec"])
@pytest.mark.parametrize("kind", KINDS)
def test_specs(kind, guard, tmp_path):
    read = [
        f"{key} = {numeral[:20]}"
        for key, text in doors.specs_with(kind, tmp_path)
        for numeral in NUMERALS[guard]
        if doors.read_spec_of(text(numeral), tmp_path) is None
    ]
    assert not read


@pytest.mark.usefixtures("any_type")
@pytest.mark.parametrize("guard", GUARDS["data file"])
@pytest.mark.parametrize("name", doors.data_files())
def test_data_files(name, guard, tmp_path):
    places = doors.numbers_of(name, tmp_path)
    assert places
    for place in places:
        for numeral in NUMERALS[guard]:
            refused = doors.read_changed(name, place, numeral, tmp_path)
            assert refused is not None and doors.data_files()[name].name in refused.message, numeral


@pytest.mark.sweep
@pytest.mark.usefixtures("any_type")
@pytest.mark.parametrize("guard", GUARDS["command option"])
@pytest.mark.parametrize(("command", "option"), doors.options_with_numbers())
def test_options(command, option, guard, tmp_path):
    for numeral in NUMERALS[guard]:
        faults, outcome = doors.run_with(command, option, numeral, tmp_path)
        assert not faults and outcome.code == 2 and option in outcome.error, (numeral, outcome.error)


def test_every_reader_has_a_specimen():
    """A format that reads, ours or another package's, is in the column of data files."""
    read = {name for name, form in forms().items() if form.read is not None}
    assert read == {one.form for one in doors.data_files().values()} & read | BINARY


def test_every_command_has_a_row_of_options():
    assert doors.commands() == set(doors.GIVEN)
