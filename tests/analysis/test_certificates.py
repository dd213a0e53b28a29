"""What a certificate must not say: refusals, verdicts left open, and printed functions that prove what they claim."""

import re

import jax
import jax.numpy as jnp
import numpy as np
import pytest
from flint import fmpq

import polhode as ph
from polhode import algebra as lie
from polhode import rolling, systems
from polhode.algebra.properties import is_compact
from polhode.analysis import _equilibrium_data as equilibrium_data
from polhode.errors import InvalidInput
from sweeping import first

RATE = 1e-9  # relative, of exponents from matrices of order one
DEFINITE = 1e-6  # of the largest curvature: far above the difference quotients' errors
e1, e2, e3 = np.eye(3)
so3, se3 = lie.SO3(), lie.SE3()
body = systems.FreeRigidBody((1.0, 2.0, 3.0))
pair = systems.LiePoisson(lie.Power(so3, 2), lambda s: -jnp.dot(s[0], s[1]))
bent = np.array([[0.6, 0.0, 0.8], [-0.6, 0.0, 0.8]])  # turns about the third axis
upright = np.array([0.0, 0.0, 3.0, 0.0, 0.0, 1.0])
fluid = systems.Kirchhoff((1.0, 2.0, 3.0, 2.0, 3.0, 5.0))


def on_so3(hamiltonian, conserved=None):
    return systems.LiePoisson(so3, hamiltonian, conserved)


def energy(L):
    return 0.5 * jnp.sum(L**2 / jnp.array([1.0, 2.0, 3.0]))


def borel():
    """Upper triangular matrices of sl(3): one Casimir, C = h1 − h2 + 3xy/w by hand, and no polynomial one."""
    def unit(i, j):
        return np.eye(3)[i][:, None] * np.eye(3)[j]

    diagonal = [unit(0, 0) - unit(1, 1), unit(1, 1) - unit(2, 2)]
    return lie.from_matrices(np.array([*diagonal, unit(0, 1), unit(1, 2), unit(0, 2)]))


def borel_casimir(m):
    return m[0] - m[1] + 3.0 * m[2] * m[3] / m[4]


def borel_system():
    weights = jnp.array([1.0, 2.0, 3.0, 4.0, 5.0])
    return systems.LiePoisson(borel(), lambda m: 0.5 * jnp.sum(weights * m**2) - 2.0 * m[4])


def irrational():
    algebra = lie.from_structure_constants(so3.structure_constants() * np.sqrt(2.0))
    return systems.LiePoisson(algebra, energy)


def vortices(n):
    """Unit vortices on the sphere, by their logarithmic energy; right-invariant."""
    def H(x):
        products = jnp.sum(x[:, None] * x[None], axis=-1)[jnp.triu_indices(n, 1)]
        return -jnp.sum(jnp.log(2.0 - 2.0 * products)) / (4.0 * jnp.pi)

    return systems.LiePoisson(lie.Power(so3, n), H, sign=1)


def ring(n, colatitude):
    angles = 2.0 * np.pi * np.arange(n) / n
    height = np.cos(colatitude) * np.ones(n)
    return np.stack([np.sin(colatitude) * np.cos(angles), np.sin(colatitude) * np.sin(angles), height], axis=1)


class Dragged(systems.FreeRigidBody):
    """Moves otherwise than its energy says."""

    def vector_field(self, t, state):
        return super().vector_field(t, state) - 0.1 * state


class Driven(systems.FreeRigidBody):
    """Keeps energy and |L|, but turns ever faster."""

    def generator(self, t, point):
        return (1.0 + t) * self.velocity(point)


class Briefly(systems.FreeRigidBody):
    """Is driven for a tenth of a second alone, between any times at which one might look."""

    def generator(self, t, point):
        return jnp.where(jnp.abs(t - 5.0) < 0.05, 2.0, 1.0) * self.velocity(point)


class Unmoved(systems.FreeRigidBody):
    """Takes the time and does not use it."""

    def generator(self, t, point):
        late = 3.0 * t
        del late
        return self.velocity(point)


def test_a_generator_that_takes_the_time_and_does_not_use_it():
    assert ph.stability(Unmoved((1.0, 2.0, 3.0)), e3).verdict == "stable"


@pytest.mark.parametrize("kind", [Dragged, Driven])
def test_equilibria_of_what_does_not_move_by_its_energy_are_not_looked_for(kind):
    """They would be those of the energy alone."""
    with pytest.raises(InvalidInput, match=r"overrides `vector_field`|depends on time"):
        ph.find_equilibria(kind((1.0, 2.0, 3.0)), np.array([0.3, 1.8, 1.0]))


# ---------------------------------------------------------------------- refusals

REFUSED = {
    "an integral that is none": (body, e2, {"integrals": [lambda L: L[0]]}, r"\{J1, H\} must vanish .* 0\.\d+ of its"),
    "one conserved at the point alone": (
        systems.BodyInPotential((1.0, 1.1, 0.5), lambda up: up[2]), upright, {"integrals": [lambda p: p[2]]}, "J1, H"),
    "one nearly conserved": (
        systems.BodyInPotential((1.0, 1.0 + 1e-10, 0.5), lambda up: up[2]), upright, {"integrals": [lambda p: p[2]]},
        "J1, H"),
    "the second of two": (
        systems.BodyInPotential((1.0, 1.0, 0.5), lambda up: up[2]), upright,
        {"integrals": [lambda p: p[2], lambda p: p[1]]}, "J2, H"),
    "integrals that do not commute": (
        pair, bent, {"integrals": [lambda s: s[0, 2] + s[1, 2], lambda s: s[0, 0] + s[1, 0]]}, r"\{J1, J2\}"),
    "what the system wrongly names conserved": (on_so3(energy, {"K": lambda L: L[2]}), e3, {}, r"\{K, H\}"),
    "an energy without a slope": (
        on_so3(lambda L: jnp.sqrt(L[0]) + L[2] ** 2), e3, {}, "energy must have finite first and second"),
    "an energy without a curvature": (
        on_so3(lambda L: jnp.abs(L[0]) ** 1.5 + L[2] ** 2), e3, {}, "energy must have finite first and second"),
    "an energy with a kink": (
        on_so3(lambda L: jax.nn.relu(L[0]) + jax.nn.relu(-L[0]) + L[2] ** 2), e3, {}, "energy must be twice"),
    "a curvature that jumps": (
        on_so3(lambda L: L[0] * jnp.abs(L[0]) + L[2] ** 2), e3, {}, "energy must be twice"),
    "an integral of the wrong shape": (body, e3, {"integrals": [lambda L: L]}, r"`integrals\[0\]` must be a real"),
    "a Casimir that is none": (body, e3, {"casimirs": [lambda L: L[2]]}, r"\{casimirs\[0\], x1\} must vanish"),
    "Casimirs that depend on each other": (
        body, e3, {"casimirs": [lambda L: jnp.sum(L**2), lambda L: jnp.sum(L**2) ** 2]}, "independent"),
    "a Casimir of the wrong shape": (body, e3, {"casimirs": [lambda L: L]}, r"`casimirs\[0\]` must be a real"),
    "a point that moves": (body, np.ones(3), {}, "not an equilibrium"),
    "a relative equilibrium without its integral": (vortices(5), ring(5, 0.5), {}, "not an equilibrium"),
    "a vector field of its own": (Dragged((1.0, 2.0, 3.0)), e3, {}, "overrides `vector_field`"),
    "a point of a size that overflows": (body, 1e308 * e3, {}, "must be between 1e-300 and 1e.300"),
    "one that underflows": (body, 1e-320 * e3, {}, "must be between 1e-300 and 1e.300"),
    "a generator that depends on time": (Driven((1.0, 2.0, 3.0)), e3, {}, "depends on time"),
    "one that depends on it for a moment": (Briefly((1.0, 2.0, 3.0)), e3, {}, "depends on time"),
    "a disk's integrals": (rolling.EulerDisk(1.0, 1.0), np.zeros(8), {"integrals": [lambda x: x[0]]}, "its own"),
    "integrals where energy is lost": (
        systems.DoubleBracket((1.0, 2.0, 3.0), 0.3), e3, {"integrals": [lambda L: jnp.sum(L**2)]}, "energy is lost"),
}  # fmt: skip


@pytest.mark.long_after(5)
@pytest.mark.parametrize("case", REFUSED)
def test_refused(case):
    system, point, options, words = REFUSED[case]
    with pytest.raises(InvalidInput, match=words):
        ph.stability(system, point, **options)


UNDECIDED = {
    "a balance of gyroscopes": (
        systems.BodyInPotential((1.0, 1.0, 0.5), lambda up: up[2]), np.array([0, 0, 2.5, 0, 0, 1.0]), {},
        "gyroscopic"),
    "a top at its threshold": (
        systems.BodyInPotential((1.0, 1.0, 0.5), lambda up: up[2]), np.array([0, 0, 2.0, 0, 0, 1.0]),
        {"integrals": [lambda p: p[2]]}, "higher order"),
    "a flat extremum": (on_so3(lambda L: L[0] ** 4 + L[1] ** 4), e3, {}, "degenerate"),
    "a singular leaf of a group that is not compact": (fluid, np.eye(6)[2], {}, "on its own leaf .* singular"),
    "Casimirs that are missing": (
        systems.LiePoisson(borel(), lambda m: 0.5 * (m[0] ** 2 - m[1] ** 2)), np.eye(5)[4], {},
        "only 0 of 1 Casimirs of degree ≤ 4 exist: give them by `casimirs=`"),
    # strict minima of the energy, whose field is almost zero for a long way
    **{f"a potential {c:g} q^{n}": (systems.LiePoisson(lie.Heisenberg(1), lambda m, c=c, n=n: 0.5 * m[1] ** 2
                                                      + c * m[0] ** n), np.eye(3)[2], {}, "degenerate")
       for c, n in ((1.0, 6), (1e-3, 4), (1.0, 20))},
    "a maximum of fourth order": (on_so3(lambda S: S[2] + 0.5 * S[0] ** 2 + S[0] ** 4 / 8), e3, {}, "degenerate"),
    "a leaf of equilibria": (on_so3(lambda L: (jnp.sum(L**2) - 1.0) ** 2 * L[2]), e1, {}, "second order"),
}  # fmt: skip


@pytest.mark.long_after(3)
@pytest.mark.parametrize("case", UNDECIDED)
def test_undecided(case):
    system, point, options, words = UNDECIDED[case]
    found = ph.stability(system, point, **options)
    assert found.verdict == "undecided" and re.search(words, found.certificate), found.certificate


def test_neighbouring_leaves_count():
    """(|L|² − 1) L3: on the unit sphere all is at rest; beside it L turns about the third axis at a rate of 2δ|L|."""
    found = ph.stability(on_so3(lambda L: (jnp.sum(L**2) - 1.0) * L[2]), e1)
    assert (found.verdict, found.growth, found.rate) == ("unstable", "linear", 0.0)
    assert np.abs(found.direction) == pytest.approx([0.0, 1.0, 0.0])
    assert ph.stability(systems.FreeRigidBody((2.0, 2.0, 2.0)), np.array([0.1, 0.2, 0.7])).verdict == "stable"


def test_symmetries_are_divided_out_only_where_needed():
    """A symmetric body's equator drifts: dividing its turn out must not hide it from an equilibrium's verdict."""
    found = ph.stability(systems.FreeRigidBody((1.0, 1.0, 2.0)), e1, [lambda L: L[2]])
    assert (found.verdict, found.growth) == ("unstable", "linear")


# ---------------------------------------------------------------------- noise

@pytest.mark.parametrize(("tilt", "above"), first(1, [(1e-14, "undecided"), (1e-15, "undecided"), (0.0, "stable")]))
def test_a_top_symmetric_up_to_rounding(tilt, above):
    """Lagrange's integral is then kept to rounding alone: it is not refused, but proves nothing."""
    top = systems.HeavyTop((1.0, 1.0 + tilt, 0.5), 1.0, (tilt, 0.0, 1.0))
    assert [ph.stability(top, top.upright(spin)).verdict for spin in (3.9, 4.1)] == ["unstable", above]


@pytest.mark.parametrize("moments", [(1.0, 2.0, 3.0), (3.0, 1.0, 2.0), (1e-6, 1.0, 1e6)])
@pytest.mark.parametrize("size", first(1, [1e-30, 1.0, 1e30]))
def test_a_body_at_rest_beside_its_rotor(moments, size):
    """dH vanishes but for rounding: 0.1 + 0.2 is not 0.3."""
    rotor, point = size * np.array([0.1, 0.2, 0.1 + 0.2]), size * np.array([0.1, 0.2, 0.3])
    found = ph.stability(systems.Gyrostat(moments, rotor), point)
    assert found.verdict == "stable" and "H is positive definite" in found.certificate


@pytest.mark.long_cases("5-0.5")
@pytest.mark.parametrize(("n", "critical"), first(1, [(5, 1 / 2), (4, 1 / 3)]))
def test_vortex_rings_on_both_sides_of_their_threshold(n, critical):
    """Boatto & Cabral, SIAM J. Appl. Math. 64 (2003) 216: stable for cos²θ > 1/3, 1/2; growth by their formula."""
    system, Jz = vortices(n), [lambda x: jnp.sum(x[:, 2])]
    threshold = np.arccos(np.sqrt(critical))
    inside = ph.stability(system, ring(n, threshold - 0.01), Jz)
    assert inside.verdict == "stable" and inside.restriction == "up to the flow of J1"
    theta = threshold + 0.2
    outside, q = ph.stability(system, ring(n, theta), Jz), 2 * (n - 2)
    square = q * (q - (n - 1) * (1 + np.cos(theta) ** 2))
    assert outside.verdict == "unstable" and outside.restriction is None
    assert outside.rate == pytest.approx(np.sqrt(abs(square)) / (4 * np.pi * np.sin(theta) ** 2), rel=1e-7)


# ---------------------------------------------------------------------- scales

@pytest.mark.long
@pytest.mark.parametrize("size", first(1, [1e200, 1e-200, 1e152, 1e-152]))
def test_sizes_far_from_one(size):
    for axis, verdict in enumerate(("stable", "unstable", "stable")):
        near, far = ph.stability(body, np.eye(3)[axis]), ph.stability(body, size * np.eye(3)[axis])
        assert far.verdict == verdict and far.rate / size == pytest.approx(near.rate, rel=RATE)
        assert np.abs(far.spectrum.imag / size).max() == pytest.approx(np.abs(near.spectrum.imag).max(), rel=RATE)
        weights = [re.search(r"H − (\S+) \|L\|²", x.certificate) for x in (near, far)]
        assert verdict == "unstable" or weights[0][1] == weights[1][1]
        if verdict == "unstable":
            assert f"exp({far.rate:.6g}/s" in far.certificate
    found = ph.find_equilibria(body, size * np.array([0.3, 1.8, 1.5]))
    axes = sorted(map(tuple, np.round(found / (size * np.linalg.norm([0.3, 1.8, 1.5]))) + 0.0))
    assert axes == sorted(map(tuple, np.vstack([np.eye(3), -np.eye(3)])))


def test_energies_that_overflow_are_refused():
    with pytest.raises(InvalidInput, match="units"):
        ph.stability(on_so3(lambda L: L[0] ** 4 + L[1] ** 2), 1e200 * e1)


# ---------------------------------------------------------------------- singular leaves, missing Casimirs

@pytest.mark.sweep
def test_which_groups_are_compact():
    compact = [so3, lie.SO(4), lie.Product(so3, lie.SO(2))]
    others = [se3, lie.SL(2), lie.AffineLine(), borel()]
    assert all(map(is_compact, compact)) and not any(map(is_compact, others))


@pytest.mark.sweep
def test_singular_leaves_of_compact_groups():
    """so(4) with L12 = L34, where one of the two spheres is a point, and its gradients are parallel.

    Manakov's integrals prove it with the function itself, the leaf's tangent space without them.
    """
    verdicts = []
    for masses in ((3.0, 4.5, 1.0, 2.0), (1.0, 3.0, 2.0, 4.5), (1.0, 2.0, 3.0, 4.5)):
        manakov = systems.Manakov(masses)
        point = np.asarray(manakov.algebra.from_dual_vector(np.array([1.0, 0, 0, 0, 0, 1.0])))
        found = ph.stability(manakov, point)
        verdicts.append(found.verdict)
        times = np.linspace(0.0, 300.0, 31)
        for seed in range(3):
            off = manakov.algebra.from_dual_vector(np.random.default_rng(seed).normal(size=6))
            start = point + 1e-4 * np.asarray(off)
            run = ph.simulate(manakov, start, times, step=0.02, order=4, estimate_error=False)
            away = np.linalg.norm(run.states - point, axis=(1, 2)).max()
            assert (away < 5e-3) == (found.verdict == "stable")
        plain = ph.stability(systems.LiePoisson(manakov.algebra, manakov.energy), point)
        assert plain.verdict == found.verdict
        assert plain.verdict == "unstable" or "group compact" in plain.certificate
    assert set(verdicts) == {"stable", "unstable"}


@pytest.mark.sweep
def test_the_borel_subalgebra_of_sl3():
    """No polynomial Casimir: the leaf's tangent space decides at regular points, the user's Casimir writes it down."""
    system, start = borel_system(), np.array([1.0, 0.4, 0.3, 0.5, 0.8])
    with pytest.raises(InvalidInput, match="only 0 of 1 Casimirs of degree ≤ 4 exist: give them by `casimirs=`"):
        ph.find_equilibria(system, start)
    found = ph.find_equilibria(system, start, casimirs=[borel_casimir])
    regular = found[np.abs(found[:, 4]) > 0.1 * np.abs(found).max(axis=1)]
    assert len(regular)
    for point in regular:
        without, given = ph.stability(system, point), ph.stability(system, point, casimirs=[borel_casimir])
        assert without.verdict == given.verdict
        if without.verdict == "stable":
            assert "the point is regular" in without.certificate and "C1" in given.certificate
    ideal = np.array([0.0, 0.0, 0.0, 0.0, 1.0])
    shifted = systems.LiePoisson(borel(), lambda m: 0.5 * jnp.sum((m - ideal) ** 2 * jnp.array([1.0, 1, 1, 1, 0.1])))
    assert ph.stability(shifted, ideal).verdict == "stable"


@pytest.mark.sweep
def test_constants_that_are_no_simple_fractions():
    """The double next to √2 is a rational number too, for which |x|² is a Casimir."""
    system = irrational()
    for axis, verdict in enumerate(("stable", "unstable", "stable")):
        plain = ph.stability(system, np.eye(3)[axis])
        given = ph.stability(system, np.eye(3)[axis], casimirs=[lambda x: jnp.sum(x**2)])
        assert plain.verdict == given.verdict == verdict
        wanted = np.sqrt(2.0) * ph.stability(body, np.eye(3)[axis]).rate
        assert plain.rate == pytest.approx(wanted, rel=RATE)
    assert len(ph.find_equilibria(system, np.ones(3))) == 6
    assert len(ph.find_equilibria(system, np.ones(3), casimirs=[lambda x: jnp.sum(x**2)])) == 6


# ---------------------------------------------------------------------- what is printed

def printed_function(text, values):
    """Return the function that a certificate prints, as one of the point; ``values`` are the names' own functions."""
    function = text.split("second variation of ")[1].split(" is ")[0].split(" on the leaf")[0]
    for n, name in enumerate(sorted(values, key=len, reverse=True)):
        function = function.replace(name, f"f{n}(x)")
    function = function.replace("−", "-").replace("²", "**2")
    function = re.sub(r"Δ\((.*?)\)(?=\*\*2)", r"(\1 - at(lambda x: \1))", function)
    function = re.sub(r"x(\d+)", lambda m: f"x[{int(m[1]) - 1}]", function)
    function = re.sub(r"(?<=[\d\])]) (?=[\d(xf])", "*", function)
    names = {f"f{n}": values[name] for n, name in enumerate(sorted(values, key=len, reverse=True))}
    return lambda x, point: eval(function, names | {"x": x, "at": lambda f: f(point)})


@pytest.mark.parametrize(("case", "signs"), [("hanging", 1), ("spinning", 1), ("least", -1), ("middle", None)])
def test_the_printed_function_proves_what_is_said(case, signs):
    """Read back from its text, brackets and all, it has a critical point and a definite Hessian there."""
    if case == "hanging":
        algebra = lie.from_structure_constants(se3.structure_constants())
        H = lambda x: 0.5 * jnp.sum(x[:3] ** 2 / jnp.array([1.0, 2.0, 3.0])) + 0.7 * x[5]  # noqa: E731
        point = np.array([0, 0, 0, 0, 0, -1.0])
    else:
        algebra, H = lie.from_structure_constants(so3.structure_constants()), energy
        point = {"spinning": e3, "least": e1, "middle": e2}[case]
    found = ph.stability(systems.LiePoisson(algebra, H), point)
    if signs is None:
        assert found.verdict == "unstable"
        return
    F = printed_function(found.certificate, {"H": H})
    step, n = 1e-4, point.size
    slope = [(F(point + step * d, point) - F(point - step * d, point)) / (2 * step) for d in np.eye(n)]
    assert np.abs(slope).max() < 1e-5
    second = [[(F(point + step * (a + b), point) - F(point + step * (a - b), point) - F(point - step * (a - b), point)
                + F(point - step * (a + b), point)) / (4 * step**2) for a in np.eye(n)] for b in np.eye(n)]  # fmt: skip
    sizes = np.linalg.eigvalsh(np.array(second, dtype=float)) * signs
    assert sizes[0] > DEFINITE * np.abs(sizes).max()
    unbracketed = found.certificate.replace("(x", "x")
    assert case != "hanging" or unbracketed != found.certificate


def test_the_multiple_of_an_integral_is_printed():
    found = ph.stability(vortices(5), ring(5, 0.5), [lambda x: jnp.sum(x[:, 2])])
    turning = 4 * np.cos(0.5) / (4 * np.pi * np.sin(0.5) ** 2)  # [Boatto & Cabral 2003]
    assert f"H − {turning:.6g} J1" in found.certificate


# ---------------------------------------------------------------------- broken specimens

def test_a_wrong_sign_of_the_curvature_is_seen(monkeypatch):
    """The tests above would notice: the same verdicts with −D²H come out wrong or are refused."""
    right = equilibrium_data.polynomial_derivatives

    def wrong(polynomials, *args):
        found, is_energy = right(polynomials, *args), fmpq(1, 4) in polynomials[0].coeffs()
        return found._replace(hessians=-found.hessians) if is_energy else found

    monkeypatch.setattr(equilibrium_data, "polynomial_derivatives", wrong)
    verdicts = [ph.stability(body, np.eye(3)[k] + 0.0).verdict for k in range(3)]
    assert verdicts != ["stable", "unstable", "stable"]


def test_integrals_would_lie_if_they_were_not_checked(monkeypatch):
    monkeypatch.setattr(equilibrium_data, "check_commute", lambda *args: None)
    top = systems.BodyInPotential((1.0, 1.0, 0.5), lambda up: jnp.sin(up[2]) / jnp.cos(1.0))
    found = ph.stability(top, np.array([0, 0, 2.5, 0, 0, 1.0]), [lambda p: p[0]])
    assert (found.verdict, found.restriction) == ("stable", "up to the flow of J1")  # a lie: nothing keeps Π1


@pytest.mark.parametrize("gap", first(1, [1e-12, 1e-14, 1e-10]))
@pytest.mark.parametrize(("moments", "axis"), [((1.0, 1.0, 1.5), 0), ((1.0, 1.5, 1.5), 2)])
def test_moments_that_nearly_agree_make_no_circle_of_equilibria(gap, moments, axis):
    """The closed form calls the axes of least and greatest moment stable; a steady drift along a circle is none."""
    moments = np.array(moments)
    moments[1 if axis == 0 else 2] *= 1.0 + gap
    found = ph.stability(systems.FreeRigidBody(moments), np.eye(3)[axis])
    assert found.verdict != "unstable"
    exact = ph.stability(systems.FreeRigidBody((1.0, 1.0, 1.5)), np.eye(3)[0])
    assert (exact.verdict, exact.growth) == ("unstable", "linear")


@pytest.mark.usefixtures("any_type")
@pytest.mark.parametrize("name", ["integrals", "casimirs"])
def test_a_function_in_place_of_a_list_is_refused(name):
    with pytest.raises(InvalidInput, match=f"`{name}` must be a list of functions"):
        ph.stability(body, e2, **{name: lambda L: L[0]})
