"""Point vortices against closed forms, their own symmetries, and a general integrator."""

import diffrax
import jax
import jax.numpy as jnp
import numpy as np
import pytest
from scipy.integrate import solve_ivp

import polhode as ph
from polhode.analysis import stability_threshold
from polhode.errors import InvalidInput
from polhode.fields import (
    PlaneVortices,
    SphereVortices,
    polygon_exponents,
    ring_exponents,
    vortex_stability,
    vortex_turn,
)
from polhode.fields.point_vortices.system import rounds_of_pairs
from polhode.integrators import SphericalMidpoint, Splitting
from polhode.testing import LawBroken, check_system
from sweeping import first

RNG = np.random.default_rng(3)
STRENGTHS = np.array([1.0, -0.7, 0.4, 0.9, -0.5])
SPHERE, PLANE = SphereVortices(STRENGTHS), PlaneVortices(STRENGTHS)
PLACES = RNG.normal(size=(5, 3))
ON_SPHERE, IN_PLANE = SPHERE.pack(PLACES), PLANE.pack(2.0 * PLACES[:, :2])


@pytest.mark.parametrize("count", range(2, 9))
def test_every_pair_meets_once(count):
    met = [tuple(sorted((i, int(j)))) for mates in rounds_of_pairs(count) for i, j in enumerate(mates) if i < j]
    assert sorted(met) == [(i, j) for i in range(count) for j in range(i + 1, count)]


def plane_by_hand(strengths, z):
    """Return ż of Kirchhoff's equations as they stand in books, by complex numbers and loops."""
    rate = np.zeros(len(z), complex)
    for i in range(len(z)):
        for j in range(len(z)):
            if i != j:
                rate[i] += np.conj(strengths[j] / (2j * np.pi * (z[i] - z[j])))
    return rate


def sphere_by_hand(strengths, x):
    """Return ẋ by the law with 1 − cos of the distance."""
    rate = np.zeros_like(x)
    for i in range(len(x)):
        for j in range(len(x)):
            if i != j:
                rate[i] += strengths[j] * np.cross(x[j], x[i]) / (4.0 * np.pi * (1.0 - x[i] @ x[j]))
    return rate


@pytest.mark.long
def test_fields_are_those_of_books():
    x = np.asarray(SPHERE.positions(ON_SPHERE))
    np.testing.assert_allclose(SPHERE.positions(SPHERE.vector_field(0.0, ON_SPHERE)), sphere_by_hand(STRENGTHS, x),
                               rtol=0, atol=1e-14)  # fmt: skip
    xy = np.asarray(PLANE.positions(IN_PLANE))
    rate = plane_by_hand(STRENGTHS, xy @ [1.0, 1j])
    np.testing.assert_allclose(PLANE.positions(PLANE.vector_field(0.0, IN_PLANE)) @ np.array([1.0, 1j]), rate,
                               rtol=0, atol=1e-14)  # fmt: skip


def test_energy_of_the_sphere_is_that_of_books():
    x = np.asarray(SPHERE.positions(ON_SPHERE))
    pairs = [(i, j) for i in range(5) for j in range(i)]
    wanted = -sum(STRENGTHS[i] * STRENGTHS[j] * np.log(2.0 - 2.0 * x[i] @ x[j]) for i, j in pairs) / (4.0 * np.pi)
    assert abs(float(SPHERE.energy(ON_SPHERE)) - wanted) < 1e-14


def test_two_vortices_turn_about_their_moment_in_one_step():
    pair = SphereVortices((1.0, 0.6))
    x = np.array([[1.0, 0.0, 0.2], [0.0, 0.8, -0.5]])
    x /= np.linalg.norm(x, axis=1, keepdims=True)
    moment = x[0] + 0.6 * x[1]
    rate = np.linalg.norm(moment) / (4.0 * np.pi * (1.0 - x[0] @ x[1]))
    turn = ph.rotation.from_axis_angle(moment / np.linalg.norm(moment), 5.0 * rate)
    end = ph.solve(pair, pair.pack(x), (0.0, 5.0), Splitting, step=5.0, order=2).saved[-1]
    np.testing.assert_allclose(pair.positions(end), ph.rotation.rotate(turn, x), atol=1e-14)


@pytest.mark.parametrize("strengths", [(1.0, 0.6), (1.0, -1.0), (1.0, -1.0 + 1e-9)])
def test_two_vortices_of_a_plane_in_one_step(strengths):
    pair, z = PlaneVortices(strengths), np.array([0.3 + 0.1j, -0.2 + 0.9j])
    total, apart = sum(strengths), z[0] - z[1]
    start = pair.pack(np.stack([z.real, z.imag], axis=1))
    end = ph.solve(pair, start, (0.0, 5.0), Splitting, step=5.0, order=2).saved[-1]
    share = 5.0 / (2.0 * np.pi * abs(apart) ** 2)
    rotated = np.expm1(1j * total * share) / total if total else 1j * share
    wanted = z + np.array([strengths[1], -strengths[0]]) * apart * rotated
    np.testing.assert_allclose(np.asarray(pair.positions(end)) @ [1.0, 1j], wanted, atol=1e-14)


@pytest.mark.long_cases("series-None")
@pytest.mark.parametrize("tolerance", [None, 1e-8])
@pytest.mark.parametrize("method", [None, diffrax.Dopri8()], ids=["series", "Dopri8"])
def test_vortices_of_a_superfluid_turn_as_large_ones_do(method, tolerance):
    """Beside 1/Γ of 10⁷ s/m² their places were next to nothing, and free to be off by more than all of them."""
    gamma, apart = 1e-7, 1e-5  # m²/s and m, of helium
    pair = PlaneVortices((gamma, gamma))
    start = np.asarray(pair.pack([[0.5 * apart, 0.0], [-0.5 * apart, 0.0]]))
    rate = gamma / (np.pi * apart**2)
    result = ph.simulate(pair, start, [0.0, 10.0 / rate], method, tolerance=tolerance)
    wanted = 0.5 * apart * np.array([np.cos(10.0), np.sin(10.0)])
    off = np.abs(np.asarray(pair.positions(result.states[-1]))[0] - wanted).max() / apart
    assert off < (tolerance or 1e-10) and off < 3.0 * result.error_estimate < 1e-6


def end_of(system, start, method, step, order):
    return np.asarray(ph.solve(system, start, (0.0, 2.0), method, step=step, order=order).saved[-1])


@pytest.mark.long_after(1)
@pytest.mark.parametrize(("system", "start"), [(SPHERE, ON_SPHERE), (PLANE, IN_PLANE)], ids=["sphere", "plane"])
def test_against_a_general_integrator_and_order_two(system, start):
    wanted = solve_ivp(lambda t, y: np.asarray(system.vector_field(t, jnp.asarray(y.reshape(5, 3)))).ravel(),
                       (0.0, 2.0), np.asarray(start).ravel(), method="DOP853", rtol=1e-12, atol=1e-13)  # fmt: skip
    wanted = wanted.y[:, -1].reshape(5, 3)
    errors = [np.abs(end_of(system, start, Splitting, h, 2) - wanted).max() for h in (0.05, 0.025)]
    assert errors[1] < 1e-3
    assert 1.9 < np.log2(errors[0] / errors[1]) < 2.1
    np.testing.assert_allclose(end_of(system, start, Splitting, 0.05, 6), wanted, atol=1e-7)


@pytest.mark.long_cases("sphere")
@pytest.mark.parametrize(("system", "start"), [(SPHERE, ON_SPHERE), (PLANE, IN_PLANE)], ids=["sphere", "plane"])
def test_moments_are_kept_to_rounding(system, start):
    motion = ph.solve(system, start, (0.0, 10.0, 20.0), Splitting, step=0.1, order=2).saved
    for name, value in system.invariants(motion).items():
        drift = np.abs(np.asarray(value) - np.asarray(value)[0]).max()
        assert drift < (0.05 if name == "energy" else 5e-14), name


@pytest.mark.long
def test_error_is_far_below_that_of_the_spherical_midpoint():
    vortices = SphereVortices(np.abs(STRENGTHS))
    start = vortices.pack(PLACES)
    wanted = end_of(vortices, start, Splitting, 0.05, 8)
    error = {method: np.abs(end_of(vortices, start, method, 0.1, 2) - wanted).max()
             for method in (Splitting, SphericalMidpoint)}  # fmt: skip
    assert error[Splitting] < 0.2 * error[SphericalMidpoint]


def test_turning_rates():
    ring, polygon = SphereVortices(np.full(5, 0.7)), PlaneVortices(np.full(5, 0.7))
    assert abs(vortex_turn(ring, ring.ring(1.1)).rate - 2.8 * np.cos(1.1) / (4 * np.pi * np.sin(1.1) ** 2)) < 1e-14
    assert abs(vortex_turn(polygon, polygon.polygon(1.3)).rate - 2.8 / (4.0 * np.pi * 1.3**2)) < 1e-14
    with pytest.raises(InvalidInput, match="do not turn as a whole"):
        vortex_turn(SPHERE, ON_SPHERE)


@pytest.mark.long
def test_stream_functions_move_a_vortex_of_no_strength():
    """x × ∇ψ, and ∇ψ turned, against the field of one more vortex, so weak that it moves no other."""
    tiny, place = 1e-9, jnp.array([0.4, -0.3])
    plane = PlaneVortices(np.append(STRENGTHS, tiny))
    more = plane.pack(np.vstack([np.asarray(PLANE.positions(IN_PLANE)), place]))
    gradient = jax.grad(lambda z: PLANE.stream_function(IN_PLANE, z))(place)
    np.testing.assert_allclose(plane.vector_field(0.0, more)[-1, 1::-1], [-gradient[1], gradient[0]], atol=1e-8)
    north = jnp.array([0.48, -0.6, 0.64])
    sphere = SphereVortices(np.append(STRENGTHS, tiny))
    more = sphere.pack(np.vstack([np.asarray(SPHERE.positions(ON_SPHERE)), north]))
    gradient = jax.grad(lambda x: SPHERE.stream_function(ON_SPHERE, x))(north)
    np.testing.assert_allclose(sphere.vector_field(0.0, more)[-1] / tiny, jnp.cross(north, gradient), atol=1e-8)


@pytest.mark.long
def test_turns_about_any_axis_and_centre():
    rotated = np.linalg.qr(np.random.default_rng(4).normal(size=(3, 3)))[0]
    rotated *= np.sign(np.linalg.det(rotated))
    ring, pair = SphereVortices(np.ones(5)), PlaneVortices((1.0, 2.0))
    start = np.asarray(ring.ring(1.0)) @ rotated.T
    result = vortex_turn(ring, start)
    assert abs(result.rate - np.cos(1.0) / (np.pi * np.sin(1.0) ** 2)) < 1e-14
    np.testing.assert_allclose(result.axis, rotated[:, 2], atol=1e-14)
    assert abs(vortex_stability(ring, start).rate - 0.2511457117) < 1e-9
    result = vortex_turn(pair, pair.pack([[3.0, 0.5], [4.0, -0.5]]))  # Γ/(2πd²) about the centre of vorticity
    assert abs(result.rate - 3.0 / (4.0 * np.pi)) < 1e-15
    np.testing.assert_allclose(result.center, [11.0 / 3.0, -1.0 / 6.0], atol=1e-14)


@pytest.mark.long
def test_vortices_that_move_straight_or_rest():
    opposite = PlaneVortices((1.0, -1.0))
    result = vortex_turn(opposite, opposite.pack([[0.0, 0.5], [0.0, -0.5]]))
    assert result.rate == 0.0 and result.center is None
    np.testing.assert_allclose(result.velocity, [0.5 / np.pi, 0.0], atol=1e-16)
    poles = SphereVortices((1.0, 1.0))
    start = poles.pack([[0.0, 0.0, 1.0], [0.0, 0.0, -1.0]])
    assert vortex_turn(poles, start).rate == 0.0
    assert vortex_stability(poles, start).verdict == "stable"  # the integral J_z is at rest there, J_x and J_y are not
    poles = SphereVortices((1.0, 2.0))  # with a momentum, about which the turns are those that keep it
    assert vortex_stability(poles, poles.pack([[0.0, 0.0, 1.0], [0.0, 0.0, -1.0]])).verdict == "stable"


@pytest.mark.sweep
def test_growth_against_closed_forms_and_published_numbers():
    ring, polygon = SphereVortices(np.ones(5)), PlaneVortices(np.ones(8))
    result = vortex_stability(ring, ring.ring(1.0))
    assert result.verdict == "unstable"
    assert abs(result.rate - ring_exponents(5, 1.0).real.max()) < 1e-9
    assert abs(result.rate - 0.2511457117) < 1e-9
    result = vortex_stability(polygon, polygon.polygon(1.3))
    assert abs(result.rate - polygon_exponents(8, 1.3).real.max()) < 1e-9
    assert abs(result.rate - 0.2663657740) < 1e-9
    assert not np.abs(polygon_exponents(7, 1.3).real).max() > 0.0


@pytest.mark.sweep
def test_a_square_is_proved_stable_below_its_threshold():
    square = SphereVortices(np.ones(4))
    result = stability_threshold(lambda c: vortex_stability(square, square.ring(np.arccos(np.sqrt(c)))), 0.3, 0.4, 1e-3)
    assert abs(result.value - 1.0 / 3.0) < 1e-3
    assert (result.below.verdict, result.above.verdict) == ("unstable", "stable")


@pytest.mark.sweep
@pytest.mark.parametrize(("count", "threshold"), [(4, 1.0 / 3.0), (5, 0.5), (6, 0.8)])
def test_thresholds_of_rings(count, threshold):
    ring = SphereVortices(np.ones(count))
    verdict = lambda c: vortex_stability(ring, ring.ring(np.arccos(np.sqrt(c))))  # noqa: E731
    result = stability_threshold(verdict, threshold - 0.1, threshold + 0.1, 1e-7)
    assert abs(result.value - threshold) < 1e-6


@pytest.mark.sweep
@pytest.mark.parametrize("count", range(2, 9))
def test_polygons_are_stable_up_to_six(count):
    polygon = PlaneVortices(np.ones(count))
    wanted = {7: "undecided", 8: "unstable"}.get(count, "stable")
    assert vortex_stability(polygon, polygon.polygon(0.8)).verdict == wanted


@pytest.mark.sweep
@pytest.mark.parametrize(("count", "angle"), [(3, 1.4), (5, 1.0), (6, 0.6), (7, 0.3)])
def test_spectra_of_rings(count, angle):
    ring = SphereVortices(np.ones(count))
    result = vortex_stability(ring, ring.ring(angle)).spectrum
    for wanted in ring_exponents(count, angle)[1:-1]:  # m = 1 and n − 1 are turns of the whole
        assert np.abs(result - wanted).min() < 1e-6


class Backwards(SphereVortices):
    @property
    def flows(self):
        return {name: (lambda t, s, f=flow: f(-t, s)) for name, flow in super().flows.items()}


class HalfTheEnergy(PlaneVortices):
    def energy(self, point):
        return 0.5 * super().energy(point)


@pytest.mark.long
@pytest.mark.parametrize(("broken", "law"), first(1, [(HalfTheEnergy, "velocity"), (Backwards, "add up")]))
def test_broken_vortices_are_caught(broken, law):
    with pytest.raises(LawBroken, match=law):
        check_system(broken((1.0, -0.7, 0.4)))


def test_bad_input():
    for strengths in ((1.0,), (1.0, 0.0), (1.0, np.nan)):
        for kind in (SphereVortices, PlaneVortices):
            with pytest.raises(InvalidInput, match="strengths"):
                kind(strengths)
    with pytest.raises(InvalidInput, match="directions other than zero"):
        SPHERE.pack(np.zeros((5, 3)))
    with pytest.raises(InvalidInput, match="unit vectors"):
        SPHERE.check_state(2.0 * ON_SPHERE)
    with pytest.raises(InvalidInput, match="1/Γ"):
        PLANE.check_state(2.0 * IN_PLANE)
    with pytest.raises(InvalidInput, match="vortices 1 and 3"):
        PLANE.check_state(PLANE.pack(np.array([[0, 0], [1, 1], [2, 1], [1, 1], [3, 3]])))
    with pytest.raises(InvalidInput, match="colatitude"):
        ring_exponents(5, 0.0)
    with pytest.raises(InvalidInput, match="count"):
        polygon_exponents(1, 1.0)
