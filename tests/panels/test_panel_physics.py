"""The panels' numbers are polhode's: every formula against another method, and each comparison sees a wrong one."""

import math

import numpy as np
import pytest
from scipy.linalg import expm

import polhode as ph
from panels.answers import NODE, ROOT, ask, asked, broken_sources
from polhode.analysis.cone import cone_angles
from polhode.analysis.poinsot import herpolhode
from polhode.rolling import AirLayer, EulerDisk, RollingCouple, ViscousContourFriction
from polhode.rolling.euler_disk.spin_down import predicted_exponents
from polhode.rotation import rotate
from polhode.spectra import Rotor

pytestmark = pytest.mark.skipif(NODE is None, reason="node is missing")
EXACT = 1e-12  # relative, of what has a closed form
STEPPED = 1e-10  # of what is integrated by steps
BROKEN = 1e-3  # what a wrong formula must miss by at least
TIMES = [0.0, 0.7, 3.1, 40.0]
MOMENTS = (1.0, 2.0, 3.0)


def miss(found, wanted):
    """Return the largest difference of numbers or vectors, relative to the largest size."""
    found, wanted = np.asarray(found, dtype=float), np.asarray(wanted, dtype=float)
    return float(np.abs(found - wanted).max() / np.abs(wanted).max())


def on_sphere(energy):
    """Return the motion with |L| = 2 and this 2E, from the two conservation laws solved by NumPy."""
    squares = np.linalg.solve([[1.0, 1.0], [1.0, 1.0 / 3.0]], [4.0, energy])
    return ph.FreeMotion(MOMENTS, momentum=(math.sqrt(squares[0]), 0.0, math.sqrt(squares[1])))


def error_of_surfaces(sources):
    energies = [1.35, 1.9, 1.999, 2.4, 3.7]
    answers = ask([asked("surfaces", "motionAt", e, keys=["regime", "period", "cap"]) for e in energies], sources)
    states = ask([asked("surfaces", "motionAt", e, times=TIMES) for e in energies], sources)
    errors = []
    for energy, answer, found in zip(energies, answers, states, strict=True):
        motion = on_sphere(energy)
        assert answer["regime"] == motion.regime
        errors += [miss(answer["period"], motion.period), miss(answer["cap"], motion.solid_angle)]
        errors += [miss(s["momentum"], motion.momentum(t)) for s, t in zip(found, TIMES, strict=True)]
    return max(errors)


def error_of_book(sources):
    tilts, spin = [1e-6, 0.02, 0.3], 9.0
    moments = ph.read_spec(ROOT / "examples" / "book.toml").body.principal_moments
    norm = moments[1] * spin
    motions = [ph.FreeMotion(moments, momentum=(0.0, norm * math.cos(x), norm * math.sin(x))) for x in tilts]
    flips, lines = (
        ask([asked("book", name, x, spin) for x in tilts], sources) for name in ("flipTime", "straightTime")
    )
    (rate, decade) = ask([asked("book", "growthRate", spin), asked("book", "timePerDecade", spin)], sources)
    exponents = np.linalg.eigvals(linear_matrix(moments, 1, norm)).real.max()
    errors = [miss(found, motion.flip_interval) for found, motion in zip(flips, motions, strict=True)]
    errors += [miss(rate, exponents), miss(decade, 2.0 * math.log(10.0) / exponents)]
    assert abs(lines[1] / flips[1] - 1.0) < 1e-3  # the line is only the limit: it errs by the square of the tilt
    return max(*errors, miss(lines[0], motions[0].flip_interval))


def linear_matrix(moments, axis, norm):
    """Return the matrix of Euler's equations near an axis, by central differences: exact, as they are quadratic."""
    rest = np.zeros(3)
    rest[axis] = norm
    right = lambda L: np.cross(L, L / np.asarray(moments))  # noqa: E731
    steps = 1e-3 * norm * np.eye(3)
    return np.stack([(right(rest + s) - right(rest - s)) / (2e-3 * norm) for s in steps], axis=1)


def error_of_cones(sources):
    errors = []
    for ratio, tilt in ((0.3, 0.4), (0.9, 1.2), (1.6, 0.5), (2.0, 0.02)):
        cones = ask([asked("cones", "conesOf", ratio, tilt)], sources)[0]
        motion = ph.FreeMotion((1.0, 1.0, ratio), momentum=(2.0 * math.sin(tilt), 0.0, 2.0 * math.cos(tilt)))
        rate = np.asarray(motion.angular_velocity(0.0))
        momentum = np.asarray(motion.momentum_at_epoch)
        angle = lambda a, b: math.atan2(np.linalg.norm(np.cross(a, b)), a @ b)  # noqa: E731
        axis = np.array([0.0, 0.0, 1.0])
        later = np.asarray(motion.angular_velocity(0.01))
        turned = rate[0] * later[1] - rate[1] * later[0]  # > 0: with the spin, which is about the positive axis
        assert np.sign(turned) == np.sign(cones["inBody"]) == np.sign(ratio - 1.0)
        assert miss(cone_angles(motion)[0], tilt) < 1e-12
        errors += [miss(cones["bodyCone"], angle(rate, axis)), miss(cones["spaceCone"], angle(rate, momentum))]
        errors += [miss(cones["size"], np.linalg.norm(rate)), miss(abs(cones["inBody"]), 2.0 * math.pi / motion.period)]
        errors += [miss(cones["precession"], motion.precession_rate)]
        errors += [miss(cones["own"], rate[2] - 2.0 * math.cos(tilt))]
    return max(errors)


def test_of_a_thrown_plate_wobbles_twice_as_fast_as_it_spins():
    cones = ask([asked("cones", "conesOf", 2.0, 1e-6)])[0]
    spin = cones["size"]
    assert cones["precession"] / spin == pytest.approx(2.0, rel=1e-9)


def error_of_gyroscope(sources):
    errors, step = [], 1e-4
    for lean, spin, push in ((1.3, 150.0, 0.0), (0.6, 90.0, 1.7), (1.9, 200.0, -1.0)):
        keys = ["regime", "nutationPeriod", "precessionRate", "nutationLimits", "moments", "mgl", "momentumAtEpoch"]
        answer = ask([asked("gyroscope", "motionOf", lean, spin, push, keys=keys)], sources)[0]
        attitude = (math.cos(lean / 2.0), math.sin(lean / 2.0), 0.0, 0.0)
        motion = ph.LagrangeMotion(
            answer["moments"], mgl=answer["mgl"], momentum=answer["momentumAtEpoch"], attitude=attitude
        )
        assert answer["regime"] == motion.regime
        errors += [miss(answer["nutationPeriod"], motion.nutation_period)]
        errors += [miss(answer["precessionRate"], motion.precession_rate)]
        errors += [miss(answer["nutationLimits"], motion.nutation_limits)]
        around = [t + k * step for t in TIMES[1:] for k in (-2, -1, 0, 1, 2)]
        call = asked("gyroscope", "motionOf", lean, spin, push, times=around, then="vectorsAt")
        for before, back, now, ahead, after in np.reshape(ask([call], sources)[0], (-1, 5)):
            ends = [np.array(x["momentum"]) for x in (before, back, ahead, after)]
            change = (8.0 * (ends[2] - ends[1]) - (ends[3] - ends[0])) / (12.0 * step)  # dL/dt, of order 4
            errors.append(miss(change, now["torque"]) / 1e3 if miss(change, now["torque"]) < 1e-6 else 1.0)
    return max(errors)


def test_the_push_of_one_is_steady_precession():
    for lean, spin in ((1.3, 150.0), (0.5, 260.0)):
        motion, rate = ask([asked("gyroscope", "motionOf", lean, spin, 1.0, keys=["nutationLimits", "precessionRate"]),
                            asked("gyroscope", "steadyRate", lean, spin)])  # fmt: skip
        assert motion["nutationLimits"][1] - motion["nutationLimits"][0] < 1e-7
        assert motion["precessionRate"] == pytest.approx(rate, rel=1e-7)


def error_of_inertia(sources):
    rng, errors = np.random.default_rng(5), []
    for _ in range(8):
        masses, points = rng.uniform(0.1, 4.0, 5), rng.uniform(-1.2, 1.2, (5, 3))
        found = ask([asked("inertia", "bodyOf", masses.tolist(), points.tolist())], sources)[0]
        body = ph.Body.from_points(masses, points)
        errors += [miss(found["tensor"], body.inertia), miss(found["moments"], body.principal_moments)]
        errors += [miss(found["centre"], body.center_of_mass), miss(found["mass"], body.mass)]
        axes = np.array(found["axes"])
        errors.append(miss(axes.T @ np.diag(found["moments"]) @ axes, body.inertia))
        assert np.linalg.det(axes) == pytest.approx(1.0, abs=1e-12)
        half = ask([asked("inertia", "equalEllipsoid", found["mass"], found["moments"])], sources)[0]
        squares = np.sum(np.square(half)) - np.square(half)  # a homogeneous ellipsoid has I1 = M (b² + c²)/5
        errors.append(miss(found["mass"] * squares / 5.0, found["moments"]))
    return max(errors)


def error_of_poinsot(sources):
    errors = []
    for energy in (1.5, 1.86, 2.3, 3.5):
        motion = on_sphere(energy)
        wanted = herpolhode(motion)
        contacts = ask([asked("poinsot", "motionOf", energy, times=TIMES, then="contactAt")], sources)[0]
        radii, distance = ask_of_motion(energy, sources)
        errors += [miss(radii, [wanted.inner_radius, wanted.outer_radius]), miss(distance, wanted.plane_distance)]
        for contact, t in zip(contacts, TIMES, strict=True):
            place = -np.asarray(motion.angular_velocity(t)) / math.sqrt(energy)
            errors += [miss(contact["inBody"], place), miss(contact["inSpace"][2], -distance)]
            errors.append(miss(rotate(np.array(contact["attitude"]), place), contact["inSpace"]))
            assert np.sum(np.array(MOMENTS) * place**2) == pytest.approx(1.0, abs=1e-13)
    return max(errors)


def ask_of_motion(energy, sources):
    """Return radii and distance, which the panel computes from the motion."""
    calls = [asked("poinsot", "numbersAt", energy)]
    found = ask(calls, sources)[0]
    return found["radii"], found["distance"]


def error_of_axes(sources):
    errors, tilt = [], 0.03
    for axis in range(3):
        norm = MOMENTS[axis] * 2.0
        i, j = (axis + 1) % 3, (axis + 2) % 3
        matrix = linear_matrix(MOMENTS, axis, norm)[np.ix_([i, j], [i, j])]
        found = ask([asked("axes", "exponentOf", axis)], sources)[0]
        eigenvalues = np.linalg.eigvals(matrix)
        assert found["stable"] == (abs(eigenvalues.real).max() < 1e-9)
        errors.append(miss(found["rate"], abs(eigenvalues).max()))
        momentum = np.zeros(3)
        momentum[[axis, i]] = norm * math.cos(tilt), norm * math.sin(tilt)
        motion = ph.FreeMotion(MOMENTS, momentum=momentum)
        for t in (0.3, 1.1, 2.5):
            straight = ask([asked("axes", "linearAt", axis, tilt, t)], sources)[0]
            errors.append(miss(straight, expm(matrix * t) @ [math.sin(tilt), 0.0]))
            exact = ask([asked("axes", "tiltOf", axis, tilt, t)], sources)[0]
            errors.append(miss(exact, math.acos(motion.momentum(t)[axis] / norm)) / 1e2)  # acos near 1 loses digits
    return max(errors)


POLYNOMIALS = {
    "L1": lambda L: L[0], "L2": lambda L: L[1], "L3": lambda L: L[2], "twist": lambda L: L[2] ** 2 / 2,
    "body": lambda L: L[0] ** 2 / 2 + L[1] ** 2 / 4 + L[2] ** 2 / 6, "saddle": lambda L: L[0] * L[1],
    "tilted": lambda L: L[0] ** 2 / 2 + L[2], "casimir": lambda L: (L[0] ** 2 + L[1] ** 2 + L[2] ** 2) / 2,
}  # fmt: skip


def brackets():
    """Return all brackets by SymPy, from the definition: {F, G} = ± L · (∇F × ∇G)."""
    import sympy

    L = sympy.Matrix(sympy.symbols("L1:4"))
    gradient = lambda f: sympy.Matrix([sympy.diff(f(L), x) for x in L])  # noqa: E731
    return {(a, b): sympy.lambdify([L], L.dot(gradient(f).cross(gradient(g))))
            for a, f in POLYNOMIALS.items() for b, g in POLYNOMIALS.items()}  # fmt: skip


def error_of_bracket(sources):
    place, errors = np.array([0.7, -1.1, 0.4]), []
    pairs = brackets()
    for sign in (-1, 1):
        calls = [asked("bracket", "bracketOf", a, b, sign, polynomials=[0, 1]) for a, b in pairs]
        for (names, wanted), found in zip(pairs.items(), ask(calls, sources), strict=True):
            value = sum(c * np.prod(place ** np.array(powers)) for c, powers in found)
            errors.append(abs(value - sign * wanted(place)))
            assert names[0] != names[1] or found == []
            assert "casimir" not in names or found == []
    start = [0.9, 0.5, -1.2]
    for sign in (-1, 1):
        motion = ph.FreeMotion(MOMENTS, momentum=start)
        found = ask([asked("bracket", "flowFrom", "body", start, sign, polynomials=[0], times=TIMES)], sources)[0]
        errors += [miss(x, motion.momentum(-sign * t)) for x, t in zip(found, TIMES, strict=True)]
    return max(errors)


@pytest.mark.long
def test_the_rate_along_the_motion_is_the_bracket():
    """dF/dt by differences of F alone, and {F, H} by SymPy at the same places."""
    start, pairs = [0.9, 0.5, -1.2], brackets()
    for sign in (-1, 1):
        for H, F in (("body", "L3"), ("saddle", "body"), ("tilted", "L1"), ("L2", "twist")):
            calls = [asked("bracket", "flowFrom", H, start, sign, polynomials=[0], times=TIMES),
                     asked("bracket", "rateOf", F, H, start, sign, TIMES)]  # fmt: skip
            states, rates = ask(calls)
            for L, found in zip(states, rates, strict=True):
                assert found["value"] == pytest.approx(POLYNOMIALS[F](L), abs=1e-10)
                assert found["rate"] == pytest.approx(sign * pairs[F, H](np.array(L)), abs=1e-8)


@pytest.mark.parametrize(("F", "G", "sign", "words"), [
    ("L1", "L2", -1, "−L₃"), ("L1", "L2", 1, "L₃"), ("L3", "body", -1, "−½L₁L₂"), ("body", "casimir", -1, "0"),
    ("L1", "twist", -1, "L₂L₃"),
])  # fmt: skip
def test_brackets_in_words(F, G, sign, words):
    assert ask([asked("bracket", "bracketInWords", F, G, sign)])[0] == words


def error_of_disk(sources):
    """A history on the slow manifold and Python's integration of the whole disk, which knows no manifold."""
    friction, until = 4e-7, 24.0
    losses = [{"law": "viscous-contour-friction", "coefficient": friction}]
    times = np.linspace(0.0, until, 4)
    errors = []
    for half in (0.0, 0.00635):
        call = asked("disk", "historyOf", losses, 0.3, half, times=times.tolist(), then="stateAt")
        found = ask([call], sources)[0]
        disk = EulerDisk(0.4387, 0.0381, thickness=2 * half, dissipation=[ViscousContourFriction(friction)])
        trajectory = ph.simulate(disk, disk.rolling_state(0.3), times, estimate_error=False)
        states = np.asarray(trajectory.states)
        errors += [miss([x["tilt"] for x in found], states[:, 0]), miss([x["heading"] for x in found], states[:, 1])]
    return max(errors)


@pytest.mark.parametrize(("losses", "law"), [
    ("air", AirLayer(1.8e-5)), ("friction", ViscousContourFriction(2e-7)), ("rolling", RollingCouple(1e-5)),
])  # fmt: skip
def test_a_thin_disk_has_the_exponents_of_the_literature(losses, law):
    late, power = ask([asked("disk", "exponentsOf", losses, 0.2)])[0]
    wanted = predicted_exponents(law)
    assert late == pytest.approx(wanted.tilt, abs=0.002)
    assert power == pytest.approx(wanted.precession_by_tilt, abs=0.005)


def error_of_quanta(sources):
    errors = []
    for B, J in ((14.0, 4), (14.0, 10), (20.5, 7), (11.0, 20)):
        found = ask([asked("quanta", "pairedLevels", B, J)], sources)[0]
        levels = np.sort(Rotor((27.0, B, 9.0)).levels(J, J).energy)
        errors.append(miss([x["energy"] for x in found], levels))
        for level in found:
            if level["orbit"] is None:
                continue
            G = J + 0.5
            share = (level["orbit"] / G**2 - 9.0) / 18.0
            momentum = (G * math.sqrt(share), 0.0, G * math.sqrt(1.0 - share))
            motion = ph.FreeMotion((0.5 / 27.0, 0.5 / B, 0.5 / 9.0), momentum=momentum)
            assert motion.encircled_axis == {"a": 0, "c": 2}[level["axis"]]
            errors.append(miss(G * motion.solid_angle / (2.0 * math.pi), level["quanta"]))
        caps = ask([asked("quanta", "quantaOfCaps", B, J + 0.5)], sources)[0]
        errors.append(miss(2.0 * (caps["a"] + caps["c"]), 2 * J + 1))  # the four caps are the sphere
        share = (B - 9.0) / 18.0 - 1e-12  # a polhode about c beside the crossing
        momentum = (math.sqrt(share), 0.0, math.sqrt(1.0 - share))
        beside = ph.FreeMotion((0.5 / 27.0, 0.5 / B, 0.5 / 9.0), momentum=momentum)
        assert caps["c"] == pytest.approx((J + 0.5) * beside.solid_angle / (2.0 * math.pi), rel=1e-9)
    return max(errors)


CHECKS = {
    "surfaces": (error_of_surfaces, EXACT, "surfaces.js", "NORM * Math.sqrt(1 - share)", "NORM * (1 - share)"),
    "book": (error_of_book, EXACT, "book.js", "(c * (b - a))", "(a * (c - b))"),
    "cones": (error_of_cones, EXACT, "cones.js", "(ratio - 1) * along", "(ratio - 1.001) * along"),
    "gyroscope": (error_of_gyroscope, EXACT, "gyroscope.js", "times(axis, arm), weight", "times(axis, radius), weight"),
    "inertia": (error_of_inertia, EXACT, "inertia.js", "all : 0) - r[i]", "all : 0) + r[i]"),
    "poinsot": (error_of_poinsot, EXACT, "poinsot.js", "motion.period / 4", "motion.period / 3"),
    "axes": (error_of_axes, EXACT, "axes.js", "1 / MOMENTS[i] - 1", "1 / MOMENTS[j] - 1"),
    "bracket": (error_of_bracket, STEPPED, "bracket.js", "derivative(H, k), sign", "derivative(H, k), -sign"),
    "disk": (error_of_disk, 1e-5, "disk.js", "time * (push2 - fall * d2)", "time * push2"),
    "quanta": (error_of_quanta, EXACT, "quanta.js", "(A - mean) * K * K", "(A - C) * K * K"),
}  # fmt: skip


@pytest.mark.long_cases("inertia", "poinsot", "axes", "bracket", "disk", "quanta")
@pytest.mark.parametrize("panel", CHECKS)
def test_the_numbers_of_a_panel_are_polhodes(panel):
    error_of, tolerance, *_ = CHECKS[panel]
    assert error_of(None) < tolerance


@pytest.mark.long_cases("gyroscope", "inertia", "poinsot", "axes", "bracket", "disk", "quanta")
@pytest.mark.parametrize("panel", CHECKS)
def test_a_wrong_formula_is_seen(panel, tmp_path):
    error_of, _, file, right, wrong = CHECKS[panel]
    sources = broken_sources(tmp_path, file, right, wrong)
    try:
        error = error_of(sources)
    except AssertionError:
        return
    assert error > BROKEN


def test_every_panel_has_its_check():
    pages = {path.stem for path in (ROOT / "learn" / "panels").glob("*.html")}
    assert pages == set(CHECKS)
