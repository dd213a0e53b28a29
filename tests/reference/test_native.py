"""The printers of C and Rust: what they print is checked in, compiles, and keeps the order of operations."""

import subprocess

import pytest

from printing.c import C
from printing.expressions import lines_of, ordered
from printing.language import Root, read
from printing.native import native_files
from printing.rust import Rust
from printing.tree import FLAG, NUMBER, Binary, Choice, Literal, Name, Unary
from reference.solvers import COMPILER, RUSTC, STRICT

LONGEST = 130
A, B = Name("a", NUMBER), Name("b", NUMBER)
YES, NO = Name("yes", FLAG), Name("no", FLAG)


def both(operator, left, right, kind=NUMBER):
    return Binary(operator, left, right, kind)


SUM, DIFFERENCE = both("+", A, B), both("-", A, B)
LESS = both("<", A, B, FLAG)
TEXTS = [
    (both("-", A, SUM), "a - (a + b)", None),
    (both("-", SUM, A), "a + b - a", None),
    (both("*", SUM, DIFFERENCE), "(a + b) * (a - b)", None),
    (both("/", A, both("*", A, B)), "a / (a * b)", None),
    (both("*", A, both("*", A, B)), "a * (a * b)", None),
    (both("-", A, Unary("-", B, NUMBER)), "a - -b", None),
    (Unary("-", SUM, NUMBER), "-(a + b)", None),
    (both("==", LESS, YES, FLAG), "(a < b) == yes", None),
    (both("or", YES, both("and", NO, LESS, FLAG), FLAG), "yes || (no && a < b)", None),
    (Unary("not", both("and", YES, NO, FLAG), FLAG), "!(yes && no)", None),
    (both("*", A, Choice(YES, A, B, NUMBER)), "a * (yes ? a : b)", "a * (if yes { a } else { b })"),
    (Choice(YES, Choice(NO, A, B, NUMBER), B, NUMBER), "yes ? (no ? a : b) : b",
     "if yes { if no { a } else { b } } else { b }"),
    (Literal(float("inf"), NUMBER), "INFINITY", "f64::INFINITY"),
]  # fmt: skip


@pytest.mark.parametrize(("node", "in_c", "in_rust"), TEXTS, ids=[text for _, text, _ in TEXTS])
def test_brackets_keep_the_order_of_operations(node, in_c, in_rust):
    assert [*lines_of(C(()).expression(node))] == [in_c]
    assert [*lines_of(Rust((), {}).expression(node))] == [in_rust or in_c]


# ---------------------------------------------------------------- the files


def test_the_files_are_what_is_printed():
    for path, text in native_files().items():
        assert path.read_text("utf-8") == text, f"{path.name}: run `python -m printing` in reference/"


def test_lines_are_not_too_long():
    for path, text in native_files().items():
        long = [line for line in text.splitlines() if len(line) > LONGEST]
        assert not long, (path.name, long[:3])


# ---------------------------------------------------------------- a specimen

SPECIMEN = '''
from typing import NamedTuple

class Inner(NamedTuple):
    """A record."""
    size: float  # in a unit
    turned: bool

class Outer(NamedTuple):
    inner: Inner
    pair: tuple[float, float]

def _swapped(x: float, y: float) -> tuple[float, float]:
    """Return both in the other order."""
    x, y = y, x
    return x, y

def swapped(outer: Outer) -> Outer:
    """Return the record with its pair in the other order."""
    # a private function of the same name
    pair = _swapped(outer.pair[0], outer.pair[1])
    return Outer(outer.inner, pair)

def total(outer: Outer) -> float:
    x, y = swapped(outer).pair
    for k in range(3):
        x = x + y
        if x > 10.0:
            break
    return x - outer.inner.size

def answer(x: float) -> float:
    return total(Outer(Inner(x, False), (2.0, 3.0)))
'''
ANSWER = 3.0 + 3.0 * 2.0 - 0.5


@pytest.fixture
def specimen(tmp_path, monkeypatch):
    (tmp_path / "specimen.py").write_text(SPECIMEN, "utf-8")
    monkeypatch.syspath_prepend(tmp_path)
    return read([Root("specimen", "answer")])


def answer_of(command, program):
    subprocess.run([*command, "-o", program], check=True, timeout=120)
    return float(subprocess.run([program], capture_output=True, text=True, timeout=60, check=True).stdout)


@pytest.mark.skipif(COMPILER is None, reason="there is no C compiler")
@pytest.mark.parametrize("options", [("-std=c99",), ("-x", "c++", "-std=c++11")], ids=["C", "C++"])
def test_a_specimen_in_c(specimen, tmp_path, options):
    language = C(specimen)
    lines = [line for module, node in ordered(specimen) for line in language.definition(module, node)]
    assert "    double size; /* in a unit */" in lines
    assert "    /* a private function of the same name */" in lines
    main = "int main(void) { printf(\"%.17g\\n\", phd_answer(0.5)); return 0; }"
    (tmp_path / "main.c").write_text("\n".join(["#include <stdio.h>", "#include <math.h>", *lines, main, ""]), "utf-8")
    assert answer_of([COMPILER, *options, *STRICT, tmp_path / "main.c"], tmp_path / "main") == ANSWER


@pytest.mark.skipif(RUSTC is None, reason="rustc is missing")
def test_a_specimen_in_rust(specimen, tmp_path):
    language = Rust(specimen, {"specimen": "specimen"})
    lines = [line for module, node in ordered(specimen) for line in language.definition(module, node)]
    assert "    /// in a unit" in lines and "    // a private function of the same name" in lines
    head = ["#![allow(unused)]", *language.short_names("specimen")]
    (tmp_path / "specimen.rs").write_text("\n".join([*head, *lines, ""]), "utf-8")
    (tmp_path / "main.rs").write_text('mod specimen;\nfn main() { println!("{}", specimen::answer(0.5)); }\n')
    command = [RUSTC, "--edition", "2021", "-D", "warnings", tmp_path / "main.rs"]
    assert answer_of(command, tmp_path / "main") == ANSWER
