"""The solvers of `reference/` in JavaScript, C and Rust: numbers of motions, what they refuse, and how they are used.

Their states are judged with those of all other implementations, in tests/twins.
"""

import math
import re
import shutil
import subprocess

import numpy as np
import pytest

from polhode import rotation
from polhode.errors import InvalidInput
from polhode.exact.free_body._geometry import REGIMES as FREE_REGIMES
from polhode.exact.lagrange_top._geometry import REGIMES as TOP_REGIMES
from reference.solvers import (
    COMPILER,
    NODE,
    REFERENCE,
    RUSTC,
    STRICT,
    Given,
    by_polhode,
    compiled,
    compiled_rust,
    errors,
    in_c,
    in_javascript,
    in_rust,
    run_javascript,
    together,
)
from twins.motions import COMMITTED, PROMISE, committed
from twins.motions import errors as errors_in_eps
from twins.motions_implementations import by_c, by_javascript, by_rust

SOON = 1e-13  # rad, and of |L|, between two that are each within 16 eps of the truth
SAME_NUMBER = 1e-14  # relative; of what cancels to its terms
OF_EACH = 20  # of each family
BAD_ARITHMETIC = 8  # the error code for fused or reordered sums
TURNED = (0.5, -0.5, 0.5, 0.5)
needs_node = pytest.mark.skipif(NODE is None, reason="node is missing")
needs_compiler = pytest.mark.skipif(COMPILER is None, reason="there is no C compiler")
needs_rustc = pytest.mark.skipif(RUSTC is None, reason="rustc is missing")
NEEDS = {"javascript": needs_node, "c": needs_compiler, "rust": needs_rustc}
LANGUAGES = [pytest.param(language, marks=mark) for language, mark in NEEDS.items()]
MOTIONS = ["free", "top"]
KIND = {"free": "body", "top": "top"}

EXTREMES = [
    Given((1.0, 2.0, 3.0), (0.0, 0.0, 0.0), TURNED),
    Given((1.0, 1.0, 1.0), (0.2, -0.3, 0.5), TURNED, 7.0),
    Given((1.0, 2.0, 3.0), (1e-9, -2e-9, 3.0)),
    Given((1.0, 2.0, 3.0), (3.0, -2e-12, 1e-12)),
    Given((1.0, 2.0, 3.0), (-1e-9, 2.0, 1e-9)),
    Given((1.0, 2.0, 3.0), (1.0, 2.0, math.sqrt(3.0))),
    Given((3.0, 4.0, 6.0), (1.0, 2.5, 1.0), TURNED, -3.0),
    Given((2.0, 2.0, 5.0), (0.3, 0.4, -0.5)),
    Given((5.0, 2.0, 5.0), (0.3, 0.4, -0.5)),
    Given((1.0, 2.0, 3.0), (0.3, 1.8, 1.5), TURNED),
    Given((1e-6, 1.0, 1e6), (1e-3, 0.5, 2.0)),
    Given((3e6, 1e-6, 2e6), (1.0, 2e-6, 0.5)),
    Given((0.0232, 0.0349, 0.0377), (-1.3e-58, -7.02, -3.4e-58)),
]
EXTREME_TIMES = [0.0, 1.7, -23.0, 41.5]


def of_table(motion, count):
    """Return the first motions of each family of the table, and a time of each."""
    motions, _ = committed(KIND[motion])
    chosen = [m for k, m in enumerate(motions) if k % COMMITTED < count]
    return [Given(*m[1:6]) for m in chosen], [[m.time] for m in chosen]


@pytest.fixture(scope="module")
def program(tmp_path_factory):
    return compiled(tmp_path_factory.mktemp("c"))


@pytest.fixture(scope="module")
def rust_program(tmp_path_factory):
    return compiled_rust(tmp_path_factory.mktemp("rust"))


@pytest.fixture(scope="module")
def listed(request):
    """Return what the compiled program of a language answers."""

    def listed(language, givens, times):
        if language == "c":
            return in_c(request.getfixturevalue("program"), givens, times)
        return in_rust(request.getfixturevalue("rust_program"), givens, times)

    return listed


@pytest.fixture(scope="module")
def answers(listed):
    """Return the states of a language's solver."""

    def states(language, givens, times):
        if language == "javascript":
            return np.array([answer["states"] for answer in in_javascript(givens, times)], np.float64)
        found = listed(language, givens, times)
        assert not found.of_motion.any() and not found.of_times.any()
        return found.states

    return states


@pytest.mark.long
@pytest.mark.parametrize("language", LANGUAGES)
def test_extremes(answers, language):
    times = [EXTREME_TIMES] * len(EXTREMES)
    assert errors(answers(language, EXTREMES, times), by_polhode(EXTREMES, times), EXTREMES).worst < SOON


# ---------------------------------------------------------------- the comparison itself


BROKEN = [
    ("javascript", "formulas/common.js", "1 + e4 * (2 + e4", "1 + e4 * (3 + e4", "nome"),
    ("javascript", "formulas/free_body_setup.js", "q4 * r2;", "q4 * r2 * 1.01;", "full form of the body"),
    ("javascript", "formulas/free_body.js", "g1 * g1 * q;", "g1 * g1 * q * 1.01;", "complementary form of the body"),
    ("javascript", "formulas/lagrange_top.js", "w1 = q * r;", "w1 = 1.01 * q * r;", "complementary form of the top"),
    ("javascript", "formulas/arithmetic.js", " + least * (high + low)", "", "low words of rates"),
    ("javascript", "formulas/arithmetic.js", " + (upper + lower) * rest", "", "rest of the time"),
    ("c", "polhode.h", "1.0 + e4 * (2.0 + e4", "1.0 + e4 * (3.0 + e4", "nome"),
    ("c", "polhode.h", "g3 = g2 * g1 * q2;", "g3 = 1.01 * g2 * g1 * q2;", "complementary form of the body"),
    ("c", "polhode.h", "w3 = q3 * r;", "w3 = 1.01 * q3 * r;", "complementary form of the top"),
    ("c", "polhode.h", " + least * (high + low)", "", "low words of rates"),
    ("c", "polhode.h", " + (upper + lower) * rest", "", "rest of the time"),
    ("c", "polhode.h", "const phd_sum kinetic =",
     "size = phd_as_sum(phd_distil(size)); const phd_sum kinetic =", "|q|² of a planar top"),
    ("rust", "rust/src/both.rs", " + least * (high + low)", "", "low words of rates"),
    ("rust", "rust/src/free_body.rs", "g3 = g2 * g1 * q2;", "g3 = 1.01 * g2 * g1 * q2;",
     "complementary form of the body"),
    ("rust", "rust/src/lagrange_top.rs", "w3 = q3 * r;", "w3 = 1.01 * q3 * r;", "complementary form of the top"),
    ("rust", "rust/src/lagrange_top.rs", "let kinetic =", "let size = as_sum(distil(size)); let kinetic =",
     "|q|² of a planar top"),
]  # fmt: skip


@pytest.mark.long_after(3)
@pytest.mark.parametrize("specimen", [
    pytest.param(b, id=f"{b[0]}: {b[4]}", marks=NEEDS[b[0]]) for b in BROKEN
])  # fmt: skip
def test_a_broken_solver_is_found_out(tmp_path, specimen):
    language, name, good, bad, what = specimen
    shutil.copytree(REFERENCE, tmp_path / "broken")
    text = (tmp_path / "broken" / name).read_text("utf-8")
    assert text.count(good) == 1
    (tmp_path / "broken" / name).write_text(text.replace(good, bad), "utf-8")
    motions, answers = committed("top" if "top" in what else "body")
    if language == "javascript":
        found = by_javascript(motions, module=tmp_path / "broken" / "polhode.js")
    elif language == "c":
        program = compiled(tmp_path, ("-std=c99",), tmp_path / "broken")
        found = by_c(motions, lambda: program)
    else:
        program = compiled_rust(tmp_path, tmp_path / "broken" / "rust", ("-O", "-A", "unused"))
        found = by_rust(motions, lambda: program)
    assert errors_in_eps(found, answers).worst.max() > PROMISE


# ---------------------------------------------------------------- what motions mean, and what is refused

REGIMES = {"free": FREE_REGIMES, "top": TOP_REGIMES}
NUMBERS = {
    "free": {
        "energy": "energy", "momentum_norm": "momentumNorm", "encircled_axis": "encircledAxis", "modulus": "modulus",
        "period": "period", "precession_rate": "precessionRate", "precession_per_period": "precessionPerPeriod",
        "flip_interval": "flipInterval", "solid_angle": "solidAngle",
    },
    "top": {
        "energy": "energy", "vertical_momentum": "verticalMomentum", "axial_momentum": "axialMomentum",
        "nutation_limits": "nutationLimits", "nutation_period": "nutationPeriod", "spin_rate": "spinRate",
        "precession_per_period": "precessionPerPeriod", "spin_per_period": "spinPerPeriod",
        "precession_rate": "precessionRate",
    },
}  # fmt: skip


LISTED = {  # in the order that the compiled programs list them
    "free": ["energy", "momentum_norm", "encircled_axis", "modulus", "period", "precession_rate",
             "precession_per_period", "flip_interval"],
    "top": ["energy", "nutation_limits", "nutation_limits", "nutation_period", "precession_per_period",
            "spin_per_period"],
}  # fmt: skip


@pytest.mark.parametrize("motion", MOTIONS)
@pytest.mark.parametrize("language", LANGUAGES)
def test_numbers_of_the_motion(listed, language, motion):
    givens, times = of_table(motion, OF_EACH)
    if motion == "free":
        givens, times = givens + EXTREMES, times + [[0.0]] * len(EXTREMES)
    exact, names = together(givens), list(NUMBERS[motion])
    if language != "javascript":
        names = LISTED[motion]
        answer = listed(language, givens, times)
        regimes, columns = answer.regimes.tolist(), list(answer.numbers.T[: len(names)])
    else:
        answers = [a["numbers"] for a in in_javascript(givens, numbers=["regime", *NUMBERS[motion].values()])]
        regimes = [REGIMES[motion].index(answer[0][0]) for answer in answers]
        columns = list(np.array([[_number(x) for part in answer[1:] for x in part] for answer in answers]).T)
        names = [name for name in names for _ in range(1 + (name == "nutation_limits"))]
    assert regimes == exact.regime.tolist()
    for k, (name, found) in enumerate(zip(names, columns, strict=True)):
        wanted = getattr(exact, name)
        wanted = wanted[names.index(name) != k] if name == "nutation_limits" else wanted
        found = np.where(np.isnan(found), -1, found) if name == "encircled_axis" else found
        with np.errstate(invalid="ignore"):  # infinities
            near = np.abs(found - wanted) <= SAME_NUMBER * np.maximum(np.abs(wanted), _unit(exact, name))
        bad = ~(near | (found == wanted) | (np.isnan(found) & np.isnan(wanted)))
        assert not bad.any(), (name, givens[np.argmax(bad)])


def _number(x):
    return math.nan if x is None else float(x)


def _unit(exact, name):
    """Return the size of what is summed for a number, and may cancel."""
    L = np.abs(exact.momentum_at_epoch)
    if name == "energy":
        return (L / exact.moments * L).sum(axis=-1) + np.abs(getattr(exact, "mgl", 0.0))
    return L.max(axis=-1) if "momentum" in name else 1.0 if "limits" in name else 0.0


@needs_node
def test_points_along_the_polhode():
    givens, _ = of_table("free", 4)
    found = in_javascript(givens, numbers=["regime"], along=200)
    for given, answer in zip(givens, found, strict=True):
        L, moments = np.array(given.momentum), np.array(given.moments)
        points = np.array(answer["along"]) / np.linalg.norm(L)
        energy = (points**2 / moments).sum(axis=-1) / ((L / np.linalg.norm(L)) ** 2 / moments).sum()
        assert np.allclose(np.linalg.norm(points, axis=-1), 1.0, rtol=SAME_NUMBER)
        assert np.allclose(energy, 1.0, rtol=1e-11)
        if answer["numbers"] == [["separatrix"]]:
            continue
        assert np.allclose(points[0], L / np.linalg.norm(L), atol=1e-12)
        middle, step = 0.5 * (points[1:] + points[:-1]), np.diff(points, axis=0)
        forward = (step * np.cross(middle, middle / moments * moments.min())).sum(axis=-1)
        assert forward.sum() >= 0.0  # the way that the body goes


REFUSED = [
    ({"moments": (1.0, 2.0, 0.0)}, "moments", 1),
    ({"moments": (1.0, 2.0, -3.0)}, "moments", 1),
    ({"moments": (1.0, 2.0, "inf")}, "moments", 1),
    ({"momentum": (1.0, "nan", 0.0)}, "momentum", 2),
    ({"attitude": (1.0, 1.0, 0.0, 0.0)}, "attitude", 3),
    ({"attitude": (0.0, 0.0, 0.0, 0.0)}, "attitude", 3),
    ({"epoch": "inf"}, "epoch", 4),
    ({"mgl": "nan"}, "mgl", 5),
    ({"moments": (1.0, 1.5, 2.0), "mgl": 1.0}, "moments", 1),
]
GOOD = {"moments": (1.0, 1.0, 2.0), "momentum": (0.1, 0.2, 0.3), "attitude": (1.0, 0.0, 0.0, 0.0), "epoch": 0.0}


@needs_node
def test_javascript_says_what_is_wrong():
    givens = [Given(**(GOOD | change)) for change, _, _ in REFUSED]
    for answer, (_, name, _) in zip(in_javascript(givens), REFUSED, strict=True):
        assert answer["refused"].startswith(f"`{name}` must be "), answer


@needs_node
def test_javascript_refuses_times_that_have_no_phase():
    answers = in_javascript([Given(**GOOD)] * 3, [[1e30], ["nan"], [0.5]])
    assert ["`t`" in a.get("refused", "") for a in answers] == [True, True, False]


@pytest.mark.parametrize("language", LANGUAGES[1:])
def test_compiled_ones_say_what_is_wrong(listed, language):
    numbers = [{k: tuple(map(float, v)) if isinstance(v, tuple) else float(v) for k, v in (GOOD | change).items()}
               for change, _, _ in REFUSED]  # fmt: skip
    found = listed(language, [Given(**n) for n in numbers], [[0.0]] * len(REFUSED)).of_motion
    assert found.tolist() == [code for _, _, code in REFUSED]
    late = listed(language, [Given(**GOOD)] * 3, [[1e30], [math.nan], [0.5]]).of_times
    assert (late[:, 0] != 0).tolist() == [True, True, False]


def test_polhode_refuses_the_same():
    for change, name, _ in REFUSED:
        numbers = {k: tuple(map(float, v)) if isinstance(v, tuple) else float(v) for k, v in (GOOD | change).items()}
        with pytest.raises(InvalidInput, match=name):
            together([Given(**numbers)])


@needs_node
def test_quaternions():
    p, q, v = [0.1, 0.7, -0.5, 0.5], [0.5, -0.1, 0.3, 0.8], [0.3, -2.0, 1.1]
    p, q = (list(np.array(x) / np.linalg.norm(x)) for x in (p, q))
    wanted = [
        ("multiply", [p, q], rotation.multiply(p, q)),
        ("conjugate", [p], rotation.conjugate(p)),
        ("rotate", [p, v], rotation.rotate(p, v)),
        ("rotateBack", [p, v], rotation.rotate(rotation.conjugate(p), v)),
        ("asMatrix", [p], rotation.as_matrix(p)),
        ("normalize", [[3.0 * x for x in p]], np.array(p)),
        ("fromAxisAngle", [[0.0, 3.0, 0.0], 1.0], np.array([math.cos(0.5), 0.0, math.sin(0.5), 0.0])),
        ("angleBetween", [p, [-x for x in p]], np.array(0.0)),
    ]
    found = run_javascript([{"kind": "quaternion", "name": name, "args": args} for name, args, _ in wanted])
    for answer, (name, _, value) in zip(found, wanted, strict=True):
        assert np.allclose(answer, value, rtol=0.0, atol=1e-15), name


# ---------------------------------------------------------------- what they need, and how they are used


def test_javascript_needs_nothing():
    """Neither node nor a browser nor another package: every import is of a file beside it."""
    for path in REFERENCE.glob("*.js"):
        text = re.sub(r"(?s)/\*.*?\*/|(?-s://.*)", "", path.read_text("utf-8"))
        for target in re.findall(r'from "([^"]+)"', text):
            assert target.startswith("./") and (REFERENCE / target).exists(), (path.name, target)
        assert not re.search(r"\b(require|process|window|document|globalThis|import\()", text), path.name


@pytest.mark.long_cases("C++")
@needs_compiler
@pytest.mark.parametrize("options", [("-std=c11",), ("-x", "c++", "-std=c++11")], ids=["C11", "C++"])
def test_other_languages_compile_it_to_the_same(tmp_path, options):
    if "c++" in options and shutil.which("g++") is None and shutil.which("c++") is None:
        pytest.skip("there is no C++ compiler")
    givens, times = of_table("free", 4)
    found = in_c(compiled(tmp_path, (*options, *STRICT[1:])), givens, times).states
    assert errors(found, by_polhode(givens, times), givens).worst < SOON


@pytest.mark.long
@needs_compiler
@pytest.mark.parametrize("options", [
    ("-O0",), ("-O3",), ("-O3", "-march=native"), ("-std=gnu11", "-O2"), ("-O2", "-march=native", "-ffp-contract=fast"),
    ("-O2", "-ffp-contract=fast"), ("-O2", "-ffast-math"), ("-Ofast",), ("-O2", "-funsafe-math-optimizations"),
    ("-O2", "-fassociative-math", "-fno-signed-zeros", "-fno-trapping-math"), ("-O2", "-ffinite-math-only"),
    ("-O2", "-mfpmath=387"),
], ids=" ".join)  # fmt: skip
def test_options_of_compilers_change_nothing_or_are_refused(tmp_path, options):
    try:
        program = compiled(tmp_path, ("-std=c99", *options))
    except subprocess.CalledProcessError:
        return  # by the header itself, or an option that this compiler does not have
    motions, answers = committed("top")
    givens = [Given(*m[1:6]) for m in motions]
    found = in_c(program, givens, [[m.time] for m in motions])
    if found.of_motion.any():
        assert (found.of_motion == BAD_ARITHMETIC).all()
    else:
        assert errors_in_eps(found.states[:, 0], answers).worst.max() <= PROMISE


@needs_compiler
@pytest.mark.parametrize("option", ["-ffast-math", "-ffinite-math-only"])
def test_the_header_refuses_options_that_break_it(tmp_path, option):
    (tmp_path / "one.c").write_text('#include "polhode.h"\n')
    command = [COMPILER, "-std=c99", option, "-I", REFERENCE, "-fsyntax-only", tmp_path / "one.c"]
    done = subprocess.run(command, capture_output=True, text=True, timeout=60, check=False)
    assert done.returncode and f"without {option}" in done.stderr


def _examples(language):
    return re.findall(rf"```{language}\n(.*?)```", (REFERENCE / "README.md").read_text("utf-8"), re.DOTALL)


@needs_node
def test_the_readme_in_javascript(tmp_path):
    (example,) = _examples("js")
    (tmp_path / "example.mjs").write_text(example.replace('"./polhode.js"', f'"{(REFERENCE / "polhode.js").as_uri()}"'))
    done = subprocess.run([NODE, tmp_path / "example.mjs"], capture_output=True, text=True, timeout=60, check=True)
    assert done.stdout.split() == [x for line in re.findall(r"// (.*)", example) for x in line.split()]


@needs_compiler
def test_the_readme_in_c(tmp_path):
    (example,) = _examples("c")
    (tmp_path / "example.c").write_text(example)
    program = tmp_path / "example"
    command = [COMPILER, "-std=c99", *STRICT, "-I", REFERENCE, tmp_path / "example.c", "-o", program, "-lm"]
    subprocess.run(command, check=True, timeout=60)
    done = subprocess.run([program], capture_output=True, text=True, timeout=60, check=True)
    assert done.stdout.split() == [x for line in re.findall(r"/\* prints (.*?) \*/", example) for x in line.split()]
