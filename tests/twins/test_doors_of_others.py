"""Numbers that come in by keys of the kinds of other packages."""

import pytest

from polhode.kinds.registry import kind_names
from twins import doors
from twins.table import read_tables
from twins.test_doors import NUMERALS

GUARDS = [row for row, at in read_tables()["Guards and doors"].pairs() if at == "plug-in"]


@pytest.fixture(autouse=True)
def others(plugin):
    """Have packages of others found by their entry points."""


@pytest.mark.usefixtures("any_type")
@pytest.mark.parametrize("guard", GUARDS)
def test_kinds(guard, tmp_path):
    kind = "spherical-pendulum"
    assert kind in kind_names()
    cases = list(doors.specs_with(kind, tmp_path))
    assert cases
    read = [f"{key} = {numeral[:20]}" for key, text in cases for numeral in NUMERALS[guard]
            if doors.read_spec_of(text(numeral), tmp_path) is None]  # fmt: skip
    assert not read
