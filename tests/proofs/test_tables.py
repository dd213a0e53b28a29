"""Tables of structure constants that Rocq proves to be Lie algebras are those of the code, of every class it has."""

import importlib.util
import inspect
import math
import re
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest

from polhode import algebra as lie

PROOFS = Path(__file__).parents[2] / "proofs"
SPEC = importlib.util.spec_from_file_location("export_tables", PROOFS / "export_tables.py")
assert SPEC and SPEC.loader
tables = importlib.util.module_from_spec(SPEC)
SPEC.loader.exec_module(tables)
EXPORTED = {name: algebra for algebras in tables.FILES.values() for name, algebra in algebras.items()}


@pytest.mark.long
def test_the_files_are_what_the_code_gives():
    for file, text in tables.file_texts().items():
        assert (PROOFS / file).read_text("utf-8") == text, f"{file}: run python proofs/export_tables.py"


def test_every_class_is_there():
    classes = [value for value in vars(lie).values() if inspect.isclass(value)]
    concrete = {c for c in classes if issubclass(c, lie.AbstractLieAlgebra) and not inspect.isabstract(c)}
    assert concrete <= {type(algebra) for algebra in EXPORTED.values()}


def test_a_changed_constant_is_noticed():
    class Changed(lie.SO3):
        def structure_constants(self):
            constants = np.array(super().structure_constants())
            constants[0, 1, 2] = 2.0
            return constants

    text = (PROOFS / "Algebras.v").read_text("utf-8")
    assert tables.algebra_text("so3", lie.SO3()) in text
    changed = tables.algebra_text("so3", Changed())
    assert "(0, 1, 2, 2)" in changed and changed not in text


def test_a_changed_casimir_is_noticed():
    class Changed(lie.SO3):
        def casimirs(self, mu):
            return (mu[..., :1] ** 2) + 2 * mu[..., 1:2] ** 2 + mu[..., 2:] ** 2

    changed = tables.algebra_text("so3", Changed())
    assert "([:: 1; 1], 2)" in changed and changed not in (PROOFS / "Algebras.v").read_text("utf-8")


def test_constants_that_are_no_fractions_are_refused():
    class Stretched(lie.SO3):
        def structure_constants(self):
            return math.sqrt(2.0) * np.array(super().structure_constants())

    with pytest.raises(ValueError, match="must be rational"):
        tables.algebra_text("so3", Stretched())


@pytest.mark.long_after(14)
@pytest.mark.parametrize("name", EXPORTED)
def test_the_tables_obey_jacobi(name):
    """In exact integers, as the kernel computes it: so a table that Rocq refuses is seen here, without Rocq."""
    n = EXPORTED[name].dim
    c = np.zeros((n, n, n), int)
    for i, j, k, value in tables.integer_constants(EXPORTED[name]):
        c[i, j, k] = value
    assert (c == -c.transpose(1, 0, 2)).all()
    nested = np.einsum("jkl,ilm->ijkm", c, c)
    assert not (nested + nested.transpose(1, 2, 0, 3) + nested.transpose(2, 0, 1, 3)).any()


def test_every_named_casimir_is_exported():
    text = "".join((PROOFS / f"{file}.v").read_text("utf-8") for file in tables.FILES)
    for name, algebra in EXPORTED.items():
        proved = re.findall(rf"^Theorem {name}_casimir\d+_commutes", text, re.MULTILINE)
        assert len(proved) == len(algebra.casimir_names), name


def test_polynomials_are_found_exactly():
    found = tables.polynomial(lambda x: x[..., 0] ** 2 * x[..., 1] / 3 - 5 * x[..., 2] ** 3, 3)
    assert found == {(0, 0, 1): Fraction(1, 3), (2, 2, 2): Fraction(-5)}
    assert tables.polynomial(lambda x: x[..., 0] / x[..., 1], 2) is None
    assert tables.polynomial(lambda x: np.sqrt(x[..., 0] ** 2 + x[..., 1] ** 2), 2) is None
