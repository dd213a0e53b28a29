"""What is printed from the formulas: the files are up to date, and what they compute has Python's bits."""

import json
import math
import re
import shutil
import subprocess
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from polhode.exact import _kernel_arithmetic as words
from polhode.exact.free_body import _evaluation as body_evaluation
from polhode.exact.free_body import _formulas as body_formulas
from polhode.exact.free_body._formulas_rates import frequencies
from polhode.exact.free_body._formulas_reduction import reduction
from polhode.exact.free_body._formulas_setup import Given
from polhode.exact.free_body._formulas_setup import motion_of as body_motion
from polhode.exact.lagrange_top import _evaluation as top_evaluation
from polhode.exact.lagrange_top import _formulas as top_formulas
from polhode.exact.lagrange_top._formulas_rates import frequencies as top_frequencies
from polhode.exact.lagrange_top._formulas_reduction import reduction as top_reduction
from polhode.exact.lagrange_top._formulas_roots import turning_points
from printing import sources
from printing.javascript import hump
from printing.javascript_files import FOLDER, javascript_files
from printing.language import Root, read
from printing.sources import source
from printing.statements import NotAFormula
from reference.solvers import NODE
from twins.motions import COMMITTED, committed

EPS = 2.0**-52
APART = 2.0
"""In EPS of a state's size, where node's elementary functions are not Python's."""
OF_EACH, OF_MORE = 2, 20
"""Motions of each family, and in long tests."""
needs_node = pytest.mark.skipif(NODE is None, reason="node is missing")


# ---------------------------------------------------------------------- the files


def test_the_files_are_what_is_printed():
    """Where this fails, run `python -m printing` in reference/, and read what has changed."""
    printed = javascript_files()
    assert {path.name for path in FOLDER.iterdir()} == {path.name for path in printed}
    for path, text in printed.items():
        assert path.read_text("utf-8") == text, path.name


@pytest.mark.parametrize(("name", "right", "wrong", "file"), [
    ("exact/_formulas.py", "1.0 + e4 * (2.0 + e4", "1.0 + e4 * (3.0 + e4", "common.js"),
    ("_kernel_arithmetic.py", "e + (x[1] + y[1]))", "(e + x[1]) + y[1])", "arithmetic.js"),
    ("free_body/_formulas_reduction.py", "= other[0] < one[0]", "= other[0] <= one[0]", "free_body_reduction.js"),
    ("top/_formulas_reduction.py", "_terms(c, -l3)", "_terms(c, l3)", "lagrange_top_reduction.js"),
])  # fmt: skip
def test_a_changed_formula_is_seen(monkeypatch, name, right, wrong, file):
    def changed(path):
        text = path.read_text("utf-8")
        if not path.as_posix().endswith(name):
            return text
        assert text.count(right) == 1
        return text.replace(right, wrong)

    monkeypatch.setattr(sources, "text_of", changed)
    source.cache_clear()
    try:
        stale = [path.name for path, text in javascript_files().items() if path.read_text("utf-8") != text]
    finally:
        source.cache_clear()
    assert stale == [file]


def test_all_words_are_used_and_stores_are_not_printed():
    text = "".join(javascript_files().values())
    files = ((FOLDER.parent / name).read_text("utf-8") for name in ("words.js", "exact_sums.js"))
    words = [word for file in files for word in re.findall(r"^export \w+ (\w+)", file, re.MULTILINE)]
    assert len(words) >= 10 and all(f"{word}(" in text for word in words)
    assert not re.search(r"BLOCK|putRecord|\b(where|choose|iterate)\(", text)


# ---------------------------------------------------------------------- what is no formula


REFUSED = {  # the body of a function of x, y and pair; why
    "a method": ("return x.hex()", "no function of a formula: x.hex()"),
    "an unknown function": ("return print(x)", "no function of a formula: print(x)"),
    "a comprehension": ("z = [x for _ in (1, 2)]; return x", "no expression of a formula"),
    "a power": ("return x**3", "no expression of a formula: x ** 3"),
    "a while": ("while x > 1.0: x = 0.5 * x", "neither assignment"),
    "a number as a condition": ("return 1.0 if x else x", "neither true nor false: x"),
    "another type of a name": ("z = x; z = (x, x); return x", "`z` had another type before"),
    "two types of a choice": ("return x if x > 1.0 else pair", "two types"),
    "another type returned": ("return pair", "returns"),
    "an index that is computed": ("return pair[k]", "items are taken by numbers that are written out"),
    "a tuple of another length": ("a, b, c = pair; return a", "cannot take what has the type"),
    "what only a branch has": ("if x > 1.0: z = x\n    return z", "unknown: z"),
    "too few arguments": ("return sum_of(x)", "takes 2 arguments: sum_of(x)"),
    "a pair for a number": ("return sum_of(x, pair)", "`y` must be"),
}
AROUND = """
def sum_of(x: float, y: float) -> float:
    return x + y


def f(x: float, pair: tuple[float, float], k: int) -> float:
    {}
"""


@pytest.mark.parametrize("case", REFUSED)
def test_what_cannot_be_said_is_refused(tmp_path, monkeypatch, case):
    text, why = REFUSED[case]
    name = f"refused_{list(REFUSED).index(case)}"
    (tmp_path / f"{name}.py").write_text(AROUND.format(text), "utf-8")
    monkeypatch.syspath_prepend(tmp_path)
    with pytest.raises(NotAFormula, match=name) as refusal:
        read([Root(name, "f")])
    assert why in str(refusal.value)


def test_a_parameter_needs_a_type(tmp_path, monkeypatch):
    (tmp_path / "untyped.py").write_text("def f(x) -> float:\n    return x\n", "utf-8")
    monkeypatch.syspath_prepend(tmp_path)
    with pytest.raises(NotAFormula, match="`x` of f has no type"):
        read([Root("untyped", "f")])


# ---------------------------------------------------------------------- what is computed


EDGES = (0.0, -0.0, 0.5, -0.5, 1.0, -1.0, 1.5, -1.5, 2.5, 0.49999999999999994, 4503599627370497.5, 3e-310, 5e-324)
POWERS = (-1074.0, -1022.0, -3.0, 0.0, 60.0, 1023.0)
"""Of two, by which no number below 1 overflows."""


def as_json(value):
    """Return a value of Python's formulas as node has it: a record is an object, and what is not finite is text."""
    if hasattr(value, "_asdict"):
        return {hump(name): as_json(x) for name, x in value._asdict().items()}
    if isinstance(value, tuple):
        return [as_json(x) for x in value]
    if isinstance(value, bool) or math.isfinite(value):
        return value
    return {"nan": "NaN", "inf": "Infinity", "-inf": "-Infinity"}[str(value)]


def by_node(calls, folder=FOLDER):
    """Return the values of printed formulas, each called as (file, function, arguments)."""
    command = [NODE, Path(__file__).parent / "run_formulas.mjs", folder.as_uri() + "/"]
    text = json.dumps([(file, name, as_json(given)) for file, name, given in calls])
    done = subprocess.run(command, input=text, text=True, capture_output=True, timeout=300, check=False)
    assert not done.returncode, done.stderr
    return json.loads(done.stdout)


def numbers(value):
    """Return all numbers of a value of JSON."""
    if isinstance(value, dict):
        value = list(value.values())
    return [x for each in value for x in numbers(each)] if isinstance(value, list) else [float(value)]


def differences(found, wanted):
    """Return the calls whose numbers are not all the same."""
    return [k for k, (x, y) in enumerate(zip(found, wanted, strict=True)) if repr(numbers(x)) != repr(numbers(y))]


def first_of_each(kind, count):
    """Return the first motions of each family, each with what a closed form takes of it."""
    chosen = [m for k, m in enumerate(committed(kind)[0]) if k % COMMITTED < count]
    more = lambda m: () if m.mgl is None else ((m.mgl,),)  # noqa: E731
    return [(m, (m.moments, *more(m), m.momentum, m.attitude)) for m in chosen]


@needs_node
def test_words_are_those_of_python():
    one = [(word, (x,)) for word in (words.nearest, words.binary_exponent) for x in EDGES]
    two = [(word, (x, y)) for word in (words.larger, words.smaller) for x in EDGES for y in EDGES]
    two += [(words.times_power, (x, n)) for x in EDGES for n in POWERS if abs(x) < 1.0]
    found = by_node([("../words.js", hump(word.__name__), given) for word, given in one + two])
    assert not differences(found, [as_json(word(*given)) for word, given in one + two])
    sums = [(1e16, 1.1, -1e16, x, y, -1.1, x * y) for x in EDGES for y in (0.1, 3e-30)]
    more = [(word, (x, *rest)) for word, rest in OF_SUMS.items() for x in sums]
    found = by_node([("../exact_sums.js", hump(word.__name__), given) for word, given in more])
    assert not differences(found, [as_json(word(*given)) for word, given in more])


OF_SUMS = {words.join: ((1.0, 1e-20),), words.negated: (), words.multiply_terms: (0.1,), words.compress: (4,),
           words.distil: ()}  # fmt: skip
OF_THE_TABLE = pytest.mark.parametrize("count", [OF_EACH, pytest.param(OF_MORE, marks=pytest.mark.long)])


@needs_node
@OF_THE_TABLE
def test_reduction_and_frequencies_have_the_same_bits(count):
    given = [(moments, momentum) for _, (moments, momentum, _) in first_of_each("body", count)]
    reduced = [reduction(*each) for each in given]
    found = by_node([("free_body_reduction.js", "reduction", each) for each in given])
    assert not differences(found, [as_json(each) for each in reduced])
    found = by_node([("free_body_rates.js", "frequencies", (each,)) for each in reduced])
    assert not differences(found, [as_json(frequencies(each)) for each in reduced])


WITHOUT_FUNCTIONS = ("full", "first", "second", "parity", "toMomentum")
"""What of a motion takes no elementary function of node's."""
MOST_TIMES = 9.0
"""So many times an angle is taken in the series of the complementary form, and so its last digit."""


@needs_node
@OF_THE_TABLE
def test_set_up_has_the_same_bits_but_for_elementary_functions(count):
    calls, wanted = [], []
    for _, (moments, momentum, attitude) in first_of_each("body", count):
        body = reduction(moments, momentum)
        given = Given(moments, momentum, attitude, body, frequencies(body))
        calls.append(("free_body_setup.js", "motionOf", (given,)))
        wanted.append(as_json(body_motion(given)))
    found = by_node(calls)
    for name in WITHOUT_FUNCTIONS:
        assert not differences([each[name] for each in found], [each[name] for each in wanted]), name
    for name, times in (("start", 1.0), ("nome", 1.0), ("toAttitude", 1.0), ("series", MOST_TIMES)):
        ours, theirs = (np.array([numbers(each[name]) for each in x]) for x in (wanted, found))
        assert (np.abs(ours - theirs) <= times * APART * EPS * np.maximum(1.0, np.abs(ours))).all(), name


@needs_node
@OF_THE_TABLE
def test_reduction_turning_points_and_frequencies_of_a_top_have_the_same_bits(count):
    given: list[Any] = [(moments, mgl, *more) for _, (moments, (mgl,), *more) in first_of_each("top", count)]
    reduced = [top_reduction(*each) for each in given]
    found = by_node([("lagrange_top_reduction.js", "reduction", each) for each in given])
    assert not differences(found, [as_json(each) for each in reduced])
    tops, points, rates = [], [], []
    for top in reduced:
        try:
            its_points = turning_points(top)
            rates.append(as_json(top_frequencies(top, its_points)))
        except ArithmeticError:  # at rest or on the separatrix, where Python divides by no zero
            continue
        tops.append(top)
        points.append(its_points)
    assert len(tops) > 0.7 * len(given)
    assert not differences(by_node([("lagrange_top_roots.js", "turningPoints", (x,)) for x in tops]),
                           [as_json(each) for each in points])  # fmt: skip
    calls = [("lagrange_top_rates.js", "frequencies", both) for both in zip(tops, points, strict=True)]
    assert not differences(by_node(calls), rates)


def states(kind, count, folder=FOLDER):
    """Return states (N, 7) by node and by Python from the same constants, sizes of momenta, and which form is full."""
    form, formulas = FORMS[kind]
    columns = [form.columns(tuple(map(np.array, given))).tolist() for _, given in first_of_each(kind, count)]
    times = [motion.time for motion, _ in first_of_each(kind, count)]
    file = f"{formulas.__name__.split('.')[-2]}.js"
    found = by_node([(file, "stateAt", (formulas.unflatten(tuple(column)), time, 0.0))
                     for column, time in zip(columns, times, strict=True)], folder)  # fmt: skip
    wanted = [form.state(tuple(column), time, 0.0) for column, time in zip(columns, times, strict=True)]
    sizes = committed(kind)[1].sizes[[k for k in range(len(committed(kind)[0])) if k % COMMITTED < count]]
    return np.array(found, np.float64), np.array(wanted), sizes, np.array([column[0] != 0.0 for column in columns])


FORMS = {"body": (body_evaluation.FORM, body_formulas), "top": (top_evaluation.FORM, top_formulas)}


@needs_node
@pytest.mark.parametrize("kind", FORMS)
@OF_THE_TABLE
def test_states_have_the_same_bits_but_for_the_exponential(kind, count, announce):
    found, wanted, sizes, full = states(kind, count)
    assert full.any() and not full.all()
    assert (found[full] == wanted[full]).all()
    units = np.where(np.arange(7) < 4, 1.0, np.where(sizes > 0.0, sizes, 1.0)[:, None])
    apart = np.abs(found - wanted) / (units * EPS)
    same = (found == wanted).mean()
    announce(f"states of a {kind} by node: {same:.2%} have Python's bits, worst {apart.max():.2f} eps")
    assert apart.max() <= APART


@needs_node
def test_another_order_of_a_sum_is_seen(tmp_path):
    shutil.copytree(FOLDER, tmp_path / "formulas")
    shutil.copy(FOLDER.parent / "words.js", tmp_path)
    shutil.copy(FOLDER.parent / "package.json", tmp_path)
    path, right = tmp_path / "formulas" / "arithmetic.js", "na + (nb + nc) + more"
    fraction = "[fraction - more, error + (middleError + d)"
    text = path.read_text("utf-8")
    assert text.count(right) == text.count(fraction) == 1
    path.write_text(text.replace(fraction, "[fraction - more, error + middleError + d"), "utf-8")
    found, wanted, *_ = states("body", OF_EACH, tmp_path / "formulas")
    assert (found != wanted).any()
