"""The solvers of `reference/` in JavaScript and C give polhode's answers, now and after a million periods."""

import math
import re
import shutil
import subprocess

import numpy as np
import pytest

from oracle.families import draw
from oracle.lagrange import reference_top
from oracle.lagrange_families import draw_tops
from oracle.measures import EPS, error_in_eps
from polhode import rotation
from polhode.errors import InvalidInput
from polhode.exact.free_body._geometry import REGIMES as FREE_REGIMES
from polhode.exact.lagrange_top._geometry import REGIMES as TOP_REGIMES
from reference.solvers import (
    COMPILER,
    NODE,
    REFERENCE,
    STRICT,
    Given,
    a_million_periods,
    by_polhode,
    compiled,
    errors,
    in_c,
    in_javascript,
    run_javascript,
    size,
    together,
)

SOON = 1e-13  # within tens of turns; the promise is 1e-12, and measured are 3e-15
LATE = 1e-12  # after a million periods; the promise is 1e-9, and measured are 3e-15
PROMISE = 16.0  # eps from the truth, that of the library at any time
SAME_NUMBER = 1e-12  # relative; of an angle to 2π
TENS_OF_TURNS = 2.5  # powers of ten of the angle in rad
IN_SUITE, IN_SWEEP = 4, 300  # of each family
TURNED = (0.5, -0.5, 0.5, 0.5)
needs_node = pytest.mark.skipif(NODE is None, reason="node is missing")
needs_compiler = pytest.mark.skipif(COMPILER is None, reason="there is no C compiler")
LANGUAGES = [pytest.param("javascript", marks=needs_node), pytest.param("c", marks=needs_compiler)]
MOTIONS = ["free", "top"]

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


def cases(motion, count, seed):
    """Return motions of every family and two times of each, within tens of turns."""
    found = []
    for k, case in enumerate((draw if motion == "free" else draw_tops)(count, seed, TENS_OF_TURNS)):
        epoch = 0.25 * case.time if k % 3 == 0 else 0.0
        attitude = TURNED if motion == "free" else case.attitude
        given = Given(case.moments, case.momentum, attitude, epoch, None if motion == "free" else case.mgl)
        found.append((given, [case.time, -0.3 * case.time]))
    return [g for g, _ in found], [t for _, t in found]


@pytest.fixture(scope="module")
def program(tmp_path_factory):
    return compiled(tmp_path_factory.mktemp("c"))


@pytest.fixture(scope="module")
def answers(request):
    """Return the states of a language's solver."""

    def states(language, givens, times):
        if language == "javascript":
            return np.array([answer["states"] for answer in in_javascript(givens, times)], np.float64)
        found = in_c(request.getfixturevalue("program"), givens, times)
        assert not found.of_motion.any() and not found.of_times.any()
        return found.states

    return states


@pytest.mark.long_cases("c-free-4", "c-top-4")
@pytest.mark.parametrize("count", [IN_SUITE, pytest.param(IN_SWEEP, marks=pytest.mark.sweep)])
@pytest.mark.parametrize("motion", MOTIONS)
@pytest.mark.parametrize("language", LANGUAGES)
def test_every_family_soon_and_late(answers, language, motion, count):
    givens, soon = cases(motion, count, seed=count)
    late = a_million_periods(givens)
    times = np.concatenate([soon, late], axis=-1)
    found = errors(answers(language, givens, times), by_polhode(givens, times), givens)
    for part, limit in ((slice(0, 2), SOON), (slice(2, 4), LATE)):
        for error in found:
            worst = np.unravel_index(np.argmax(error[:, part]), error[:, part].shape)
            assert error[:, part].max() < limit, (givens[worst[0]], times[worst[0], part][worst[1]])


@pytest.mark.long
@pytest.mark.parametrize("language", LANGUAGES)
def test_extremes(answers, language):
    times = [EXTREME_TIMES] * len(EXTREMES)
    assert errors(answers(language, EXTREMES, times), by_polhode(EXTREMES, times), EXTREMES).worst < SOON


@pytest.mark.parametrize("count", [1, pytest.param(40, marks=pytest.mark.sweep)])
@pytest.mark.parametrize("motion", MOTIONS)
@pytest.mark.parametrize("language", LANGUAGES)
def test_against_exact_arithmetic(answers, language, motion, count):
    """Not polhode but other formulas, in ball arithmetic, say here what is right."""
    drawn = (draw if motion == "free" else draw_tops)(count, 5, 9.0)
    givens = [Given(c.moments, c.momentum, *([] if motion == "free" else [c.attitude, 0.0, c.mgl])) for c in drawn]
    states = answers(language, givens, [[c.time] for c in drawn])[:, 0].tolist()
    for case, given, state in zip(drawn, givens, states, strict=True):
        if motion == "free":
            worst = max(error_in_eps(state[:4], state[4:], case))
        else:
            exact = reference_top(*case[1:])
            wanted = [float(x) for x in (*exact.quaternion, *exact.momentum)]
            units = [EPS] * 4 + [EPS * size(given)] * 3
            worst = max(abs(x - y) / unit for x, y, unit in zip(state, wanted, units, strict=True))
        assert worst < PROMISE, (case, worst)


# ---------------------------------------------------------------- the comparison itself


BROKEN = [
    ("javascript", "elliptic.js", "1 + e4 * (2 + e4", "1 + e4 * (3 + e4", "nome"),
    ("javascript", "free_series.js", "q4 * r * r];", "q4 * r * r * 1.01];", "full form of the body"),
    ("javascript", "free_series.js", "growBy *= q;", "growBy *= 1.01 * q;", "complementary form of the body"),
    ("javascript", "top_state.js", "qr *= q * q;", "qr *= 1.01 * q * q;", "complementary form of the top"),
    ("javascript", "phase.js", "+ rate[2] * (high + low)", "", "late: low words of rates"),
    ("c", "polhode.h", "1.0 + e4 * (2.0 + e4", "1.0 + e4 * (3.0 + e4", "nome"),
    ("c", "polhode.h", "grow_by *= q;", "grow_by *= 1.01 * q;", "complementary form of the body"),
    ("c", "polhode.h", "qr *= q2;", "qr *= 1.01 * q2;", "complementary form of the top"),
    ("c", "polhode.h", "+ rate.rest * (high + low)", "", "late: low words of rates"),
]


@pytest.mark.long_after(3)
@pytest.mark.parametrize("specimen", [
    pytest.param(b, id=f"{b[0]}: {b[4]}", marks=needs_node if b[0] == "javascript" else needs_compiler) for b in BROKEN
])  # fmt: skip
def test_a_broken_solver_is_found_out(tmp_path, specimen):
    language, name, good, bad, what = specimen
    shutil.copytree(REFERENCE, tmp_path / "broken")
    text = (tmp_path / "broken" / name).read_text("utf-8")
    assert text.count(good) == 1
    (tmp_path / "broken" / name).write_text(text.replace(good, bad), "utf-8")
    givens, times = cases("top" if "top" in what else "free", IN_SUITE, seed=IN_SUITE)
    if "late" in what:
        times = a_million_periods(givens)
    if language == "javascript":
        answers = in_javascript(givens, times, module=tmp_path / "broken" / "polhode.js")
        found = np.array([answer["states"] for answer in answers], np.float64)
    else:
        found = in_c(compiled(tmp_path, ("-std=c99",), tmp_path / "broken"), givens, times).states
    assert errors(found, by_polhode(givens, times), givens).worst > (LATE if "late" in what else SOON)


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


IN_C = {  # in the order that run_polhode.c lists them
    "free": ["energy", "momentum_norm", "encircled_axis", "modulus", "period", "precession_rate",
             "precession_per_period", "flip_interval"],
    "top": ["energy", "nutation_limits", "nutation_limits", "nutation_period", "precession_per_period",
            "spin_per_period"],
}  # fmt: skip


@pytest.mark.parametrize("motion", MOTIONS)
@pytest.mark.parametrize("language", LANGUAGES)
def test_numbers_of_the_motion(request, language, motion):
    givens, times = cases(motion, IN_SUITE, seed=3)
    if motion == "free":
        givens, times = givens + EXTREMES, times + [[0.0, 0.0]] * len(EXTREMES)
    exact, names = together(givens), list(NUMBERS[motion])
    if language == "c":
        names = IN_C[motion]
        answer = in_c(request.getfixturevalue("program"), givens, times)
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
    givens, _ = cases("free", IN_SUITE, seed=8)
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


@needs_compiler
def test_c_says_what_is_wrong(program):
    numbers = [{k: tuple(map(float, v)) if isinstance(v, tuple) else float(v) for k, v in (GOOD | change).items()}
               for change, _, _ in REFUSED]  # fmt: skip
    found = in_c(program, [Given(**n) for n in numbers], [[0.0]] * len(REFUSED)).of_motion
    assert found.tolist() == [code for _, _, code in REFUSED]
    late = in_c(program, [Given(**GOOD)] * 3, [[1e30], [math.nan], [0.5]]).of_times
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
    givens, times = cases("free", 1, seed=11)
    found = in_c(compiled(tmp_path, (*options, *STRICT[1:])), givens, times).states
    assert errors(found, by_polhode(givens, times), givens).worst < SOON


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
