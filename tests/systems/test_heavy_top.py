"""The heavy top against Lagrange's exact motion, the mesh of a top, and its third integrals."""

import jax
import jax.numpy as jnp
import numpy as np
import pytest

import polhode as ph
from polhode.errors import InvalidInput
from polhode.systems import BodyInPotential, BrunBody, HeavyTop
from sweeping import first, only

EXACT = 1e-13
DRIFT = 1e-12  # over a million steps; half of it over a fifth, as rounding errors add up like a root
INTEGRABLE = {
    "Euler's |Π|²": ((1.0, 2.0, 3.0), 0.0, (0.0, 0.0, 1.0)),
    "Lagrange's Π·χ": ((1.0, 1.0, 0.5), 0.7, (0.0, 0.0, 1.0)),
    "Kovalevskaya's integral": ((2.0, 2.0, 1.0), 0.7, (0.6, 0.8, 0.0)),
    "Goryachev and Chaplygin's integral": ((0.5, 2.0, 2.0), 0.7, (0.0, 0.6, -0.8)),
}
THRESHOLD = 1e-8


def start(top, name, seed=0):
    rng = np.random.default_rng(seed)
    up = rng.normal(size=3)
    up /= np.linalg.norm(up)
    momentum = rng.normal(size=3)
    if name.startswith("Goryachev"):
        momentum -= up * (up @ momentum)
    return np.concatenate([momentum, up])


@pytest.mark.parametrize("name", INTEGRABLE)
def test_third_integrals_do_not_change(name):
    top = HeavyTop(*INTEGRABLE[name])
    for seed in range(5):
        state = jnp.asarray(start(top, name, seed))
        values, rates = jax.jvp(top.invariants, (state,), (top.vector_field(0.0, state),))
        assert name in values and abs(float(values[name])) > 1e-3
        assert max(abs(float(rate)) for rate in rates.values()) < EXACT


@pytest.mark.parametrize("name", [name for name in INTEGRABLE if not name.startswith("Euler")])
def test_third_integrals_change_in_other_tops(name):
    moments, mgl, axis = INTEGRABLE[name]
    top, other = HeavyTop(moments, mgl, axis), HeavyTop(np.array(moments) * (1.0, 1.1, 1.2), mgl, axis)
    state = jnp.asarray(start(top, name))
    rate = jax.jvp(top.invariants, (state,), (other.vector_field(0.0, state),))[1][name]
    assert other.case is None and abs(float(rate)) > 1e-3


@pytest.mark.sweep
def test_goryachev_and_chaplygin_off_their_leaf():
    name = "Goryachev and Chaplygin's integral"
    top = HeavyTop(*INTEGRABLE[name])
    off = ph.simulate(top, start(top, "any leaf"), np.linspace(0, 1, 3), step=0.05)
    on = ph.simulate(top, start(top, name), np.linspace(0, 1, 3), step=0.05)
    assert name in on.invariants and name not in off.invariants and "energy" in off.invariants


def run(name, steps, size=0.01):
    top = HeavyTop(*INTEGRABLE[name])
    times = np.linspace(0.0, steps * size, 201)
    return ph.simulate(top, start(top, name), times, step=size, order=6, estimate_error=False)


def check_drift(trajectory, name, steps, bound=DRIFT):
    assert trajectory.statistics["steps"] == steps
    assert name in trajectory.drift and max(trajectory.drift.values()) <= bound, trajectory.drift


@pytest.mark.long
@pytest.mark.parametrize("name", only(["Kovalevskaya's integral"], INTEGRABLE))
def test_all_invariants_over_many_steps(name):
    check_drift(run(name, 10_000), name, 10_000)


@pytest.mark.sweep
@pytest.mark.parametrize("name", INTEGRABLE)
def test_all_invariants_over_a_million_steps_or_a_fifth(name):
    steps, bound = (1_000_000, DRIFT) if name.startswith("Lagrange") else (200_000, DRIFT / 2)
    check_drift(run(name, steps), name, steps, bound)


@pytest.mark.sweep
def test_kovalevskayas_integral_is_bounded_at_order_two():
    name = "Kovalevskaya's integral"
    top = HeavyTop(*INTEGRABLE[name])
    times = np.linspace(0.0, 1e4, 401)
    values = ph.simulate(top, start(top, name), times, step=0.01, order=2, estimate_error=False).invariants[name]
    swing = np.ptp(values)
    assert swing < 1e-3 * values[0] and abs(values[:100].mean() - values[-100:].mean()) < 0.2 * swing


@pytest.mark.sweep
def test_brun_and_clebsch():
    body = BrunBody((1.0, 2.0, 3.0), 0.7)
    state = jnp.asarray(start(body, "any"))
    values, rates = jax.jvp(body.invariants, (state,), (body.vector_field(0.0, state),))
    assert "Clebsch's integral" in values and max(abs(float(rate)) for rate in rates.values()) < EXACT
    same = BodyInPotential((1.0, 2.0, 3.0), lambda up: 0.35 * jnp.sum(up**2 * jnp.array([1.0, 2.0, 3.0])))
    assert body.vector_field(0.0, state) == pytest.approx(np.asarray(same.vector_field(0.0, state)), abs=1e-14)
    kept = ph.simulate(body, state, np.linspace(0, 50, 11), step=0.01, order=6)
    assert max(kept.drift.values()) < 1e-12


@pytest.mark.long
@pytest.mark.parametrize(
    ("moments", "tilt", "spin"),
    first(1, [
        ((1.0, 1.0, 0.5), 60.0, (0.3, -0.2, 5.0)),
        ((1.0, 1.0, 0.5), 60.0, (0.0, 0.0, 5.0)),
        ((1.0, 1.0, 2.0), 120.0, (0.4, 0.6, 0.0)),
    ]),
)  # fmt: skip
def test_lagranges_top_is_followed(moments, tilt, spin):
    half = np.radians(tilt) / 2
    attitude = (np.cos(half), np.sin(half), 0.0, 0.0)
    top = HeavyTop(moments, 1.0)
    times = np.linspace(0.0, 20.0, 21)
    found = ph.simulate(top, top.pack(attitude, spin), times, step=0.01, order=6)
    exact = ph.LagrangeMotion(moments, mgl=1.0, momentum=np.array(moments) * spin, attitude=attitude).sample(times)
    assert np.abs(found.attitude - exact.attitude).max() < 1e-11
    assert np.abs(found.momentum - exact.momentum).max() < 1e-11


@pytest.mark.sweep
def test_order_by_slope_against_lagrange():
    moments, attitude, spin = (1.0, 1.0, 0.5), (np.cos(0.5), np.sin(0.5), 0.0, 0.0), (0.3, -0.2, 3.0)
    top, times = HeavyTop(moments, 1.0), np.array([0.0, 2.0])
    exact = ph.LagrangeMotion(moments, mgl=1.0, momentum=np.array(moments) * spin, attitude=attitude).state(2.0)
    for order, sizes in ((2, (0.04, 0.02, 0.01)), (4, (0.1, 0.05, 0.025))):
        misses = []
        for size in sizes:
            end = ph.simulate(top, top.pack(attitude, spin), times, step=size, order=order)
            misses.append(np.abs(end.momentum[-1] - exact[1]).max())
        slope = np.polyfit(np.log(sizes), np.log(misses), 1)[0]
        assert abs(slope - order) < 0.3


def test_a_mesh_is_a_top():
    trimesh = pytest.importorskip("trimesh")
    cone = trimesh.creation.cone(radius=0.03, height=0.06, sections=64)
    cone.apply_transform(trimesh.transformations.rotation_matrix(np.pi, (1, 0, 0)))  # on its point, at the origin
    cone.apply_translation((0, 0, 0.06))
    body = ph.Body.from_mesh(cone.vertices, cone.faces, mass=0.1)
    lowest = np.array(cone.vertices)[np.argmin(cone.vertices[:, 2])]
    top = HeavyTop.from_body(body, lowest)
    assert top.case is not None and top.case[0] == "Lagrange"
    assert float(top.mgl) == pytest.approx(0.1 * 9.80665 * 0.045, rel=1e-12)
    assert np.sort(top.moments) == pytest.approx(np.sort(np.linalg.eigvalsh(body.about(lowest))), rel=1e-12)
    turn, shift = np.array([0.5, 0.5, 0.5, 0.5]), np.array([1.0, 2.0, 3.0])
    other = HeavyTop.from_body(body.placed(turn, shift), ph.rotation.rotate(turn, lowest) + shift)
    assert np.sort(other.moments) == pytest.approx(np.sort(top.moments), rel=1e-9)


def test_states_in_given_axes():
    body = ph.shapes.box(1.0, (0.3, 0.1, 0.2)).placed((0.8, 0.6, 0.0, 0.0), (0.1, 0.2, 0.4))
    top = HeavyTop.from_body(body, (0.0, 0.0, 0.0))
    velocity = np.array([0.3, -1.0, 2.0])
    state = top.pack((0.6, 0.0, 0.8, 0.0), velocity)
    momentum = np.asarray(top.axes) @ np.asarray(state[4:7])
    assert momentum == pytest.approx(body.about((0, 0, 0)) @ velocity, rel=1e-12)
    up = np.asarray(top.axes) @ np.asarray(state[7:])
    wanted = ph.rotation.rotate(np.array([0.6, 0.0, -0.8, 0.0]), np.array([0.0, 0.0, 1.0]))
    assert up == pytest.approx(wanted, abs=1e-15)
    height = ph.rotation.rotate(np.array([0.6, 0.0, 0.8, 0.0]), body.center_of_mass)[2]
    kinetic = 0.5 * velocity @ body.about((0, 0, 0)) @ velocity
    assert float(top.energy(state[4:])) == pytest.approx(kinetic + 9.80665 * height, rel=1e-12)


@pytest.mark.sweep
def test_a_fixed_point_at_the_centre_of_mass_is_the_free_body():
    body = ph.shapes.box(1.0, (0.3, 0.1, 0.2)).placed(translation=(1.0, 2.0, 3.0))
    with pytest.warns(UserWarning, match="the body is free"):
        top = HeavyTop.from_body(body, (1.0, 2.0, 3.0))
    assert float(top.mgl) == 0.0 and top.case is not None and top.case[0] == "Euler"
    times = np.linspace(0.0, 100.0, 5)
    found = ph.simulate(top, top.pack(angular_velocity=(0.1, 1.0, 0.2)), times)
    exact = ph.FreeMotion(
        np.asarray(top.moments), momentum=np.asarray(found.momentum[0]), attitude=found.attitude[0]
    ).sample(times)
    assert np.abs(found.attitude - exact.attitude).max() < 1e-13


def verdict(spin, mgl=1.0, moments=(1.0, 1.0, 0.5)):
    top = HeavyTop(moments, mgl)
    assert top.upright(spin).tolist() == [0.0, 0.0, moments[2] * spin, 0.0, 0.0, 1.0]
    return ph.stability(top, top.upright(spin)).verdict


def test_sleeping_threshold():
    """Stable iff |ω3| ≥ 2 √(I1 mgl)/I3; by energy–Casimir above, by the spectrum below."""
    edge = 2.0 * np.sqrt(1.0 * 1.0) / 0.5
    assert verdict(edge * (1 + THRESHOLD)) == "stable" and verdict(edge * (1 - THRESHOLD)) == "unstable"
    assert verdict(0.1, mgl=-1.0) == "stable"


@pytest.mark.parametrize(
    ("make", "words"),
    [
        (lambda: HeavyTop((1.0, 2.0, 3.0), np.nan), "`mgl` must be a finite number"),
        (lambda: HeavyTop((1.0, 2.0, 3.0), 1.0, (0, 0, 0)), "`axis` must be a direction"),
        (lambda: HeavyTop((1.0, -2.0, 3.0), 1.0), "positive"),
        (lambda: HeavyTop.from_body(ph.Body.from_moments((1, 2, 3)), (0, 0, 0)), "mass"),
        (lambda: HeavyTop.from_body(ph.shapes.sphere(1.0, 1.0), (0, 0, 1), gravity=-1.0), "`gravity`"),
        (lambda: HeavyTop((1.0, 2.0, 3.0), 1.0).check_state([1, 0, 0, 0, 1, 1, 1, 0, 1, 0]), "Rᵀe_z"),
        (lambda: HeavyTop((1.0, 2.0, 3.0), 1.0, (0, 1, 1)).upright(2.0), "`spin` must be zero"),
        (lambda: BrunBody((1.0, 2.0, 3.0), np.inf), "`strength`"),
    ],
)
def test_bad_input(make, words):
    with pytest.raises(InvalidInput, match=words):
        make()


CASES = [((1.0, 2.0, 3.0), (0.0, 0.0, 1.0)), ((3.0, 1.0, 2.0), (0.0, 0.0, 1.0)), ((1.0, 1.0, 0.5), (0.0, 0.0, 1.0))]


@pytest.mark.long_cases("moments1-axis1")
@pytest.mark.parametrize(("moments", "axis"), CASES)
def test_energy_casimir_and_spectrum_agree_on_standing_tops(moments, axis):
    """Against eigenvalues of the linearised equations written out by hand, for spins from none to fast."""
    top, (i1, i2, i3) = HeavyTop(moments, 1.0, axis), moments
    seen = set()
    for spin in (0.0, 0.7, 1.9, 2.6, 3.7, 4.3, 9.0):
        for side in (1.0, -1.0):
            # δΠ̇1 = (a3/.. ) of Π × Ω + Γ × e3 about Π = (0, 0, I3 w), Γ = (0, 0, side)
            w = spin
            A = np.zeros((4, 4))  # (Π1, Π2, Γ1, Γ2)
            A[0, 1], A[0, 3] = w - i3 * w / i2, 1.0
            A[1, 0], A[1, 2] = i3 * w / i1 - w, -1.0
            A[2, 3], A[2, 1] = w, -side / i2
            A[3, 2], A[3, 0] = -w, side / i1
            growth = np.linalg.eigvals(A).real.max()
            found = ph.stability(top, top.upright(spin, hanging=side < 0))
            seen.add(found.verdict)
            if found.verdict == "stable":
                assert growth < 1e-7
            elif found.verdict == "unstable":
                assert found.rate == pytest.approx(growth, rel=1e-6)
            else:
                assert growth < 1e-7  # a gyroscopic balance: the spectrum is silent, no certificate is claimed
    assert {"stable", "unstable"} <= seen
