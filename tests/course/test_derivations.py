"""The derivations of the course: every line follows, and a line that does not is refused."""

import sys
from pathlib import Path

import pytest

from sweeping import only

sympy = pytest.importorskip("sympy")
COURSE = Path(__file__).parents[2] / "learn"
sys.path.insert(0, str(COURSE / "_ext"))
from checked_lines import LineBroken, Lines  # noqa: E402  needs the path

DERIVATIONS = sorted((COURSE / "derivations").glob("*.py"))
x = sympy.Symbol("x", positive=True)
QUICK = [path for path in DERIVATIONS if path.stem not in ("turning_frames", "two_signs")]


def lines_of(path, text=None):
    names = {"__name__": path.stem}
    exec(compile(path.read_text("utf-8") if text is None else text, str(path), "exec"), names)
    lines = Lines()
    names["derive"](lines)
    return lines.lines


@pytest.mark.long_after(5)
@pytest.mark.long_cases("what_is_conserved", "yielding_earth")
@pytest.mark.parametrize("path", only(QUICK, DERIVATIONS), ids=lambda path: path.stem)
def test_every_line_follows(path):
    lines = lines_of(path)
    assert sum(line.checked for line in lines) >= 2, path.stem


@pytest.mark.parametrize("broken", [
    lambda lines: lines.equal("t", (x + 1) ** 2, x**2 + 2 * x - 1),
    lambda lines: lines.equal("t", x, x, 2 * x),
    lambda lines: lines.equal("t", sympy.Matrix([x, 1]), sympy.Matrix([x, 2])),
    lambda lines: lines.holds("t", sympy.Eq(x, x + 1)),
    lambda lines: lines.holds("t", x < 0),
    lambda lines: lines.solves("t", sympy.Eq(x**2, 4), x, 3),
    lambda lines: lines.tends("t", sympy.sin(x) / x, x, 0, 2),
    lambda lines: lines.expands("t", sympy.cos(x), x, 4, 1 + x**2 / 2),
])  # fmt: skip
def test_a_line_that_does_not_follow_is_refused(broken):
    with pytest.raises(LineBroken):
        broken(Lines())
