"""The conducting fluid on a sphere: exact waves, growth rates, what is kept, and what broken ones do not keep."""

import jax.numpy as jnp
import numpy as np
import pytest

import polhode as ph
from polhode import algebra as lie
from polhode.errors import InvalidInput
from polhode.fields import SphereMHD
from polhode.fields.sphere.zonal_growth import zonal_growth
from polhode.integrators import IsospectralMidpoint
from polhode.testing import LawBroken, check_algebra, check_system

# of the sizes of their terms, after thousands of steps
CASIMIR, ENERGY = 3e-15, 4e-4
TREND = 0.4  # of the swing, as in tests/conservation


def flow(n, system=None):
    """Generic, of rms vorticity 1 and rms potential 0.3."""
    system, degree = system or SphereMHD(n), np.arange(min(n, 10))
    energies = np.where(degree > 0, 1.0 / np.maximum(degree, 1) ** 3, 0.0)
    state = system.random(energies, energies, seed=1)
    rms = jnp.linalg.norm(state, axis=(-2, -1)) / np.sqrt(n)
    return system, state * (jnp.array([0.3, 1.0]) / rms)[:, None, None]


def casimirs(states, powers=(1, 2, 3)):
    """tr Θ^(k+1) and tr WΘ^k of states (T, 2, N, N), relative to the norms of their factors."""
    theta, w = np.asarray(states)[:, 0], np.asarray(states)[:, 1]
    result, power = [], theta
    for _ in powers:
        for other in (theta, w):
            sizes = np.linalg.norm(other, axis=(1, 2)) * np.linalg.norm(power, axis=(1, 2))
            result.append(np.einsum("tij,tji->t", other, power) / sizes[0])
        power = power @ theta
    return np.array(result)


def run(system, state, steps, step=0.02, samples=5):
    times = np.linspace(0.0, steps * step, samples)
    return ph.simulate(system, state, times, IsospectralMidpoint, step=step, order=2, estimate_error=False)


@pytest.mark.sweep
@pytest.mark.parametrize(("n", "steps"), [(6, 100), pytest.param(24, 3000, marks=pytest.mark.sweep)])
def test_casimirs_stay_and_the_energy_does_not_drift(n, steps):
    system, state = flow(n)
    result = run(system, state, steps, samples=101)
    values = casimirs(result.states)
    assert np.abs(values - values[:, :1]).max() < CASIMIR
    assert np.abs(result.states + np.conj(np.swapaxes(result.states, -1, -2))).max() == 0.0
    assert max(value for name, value in result.drift.items() if name.startswith("L")) < 1e-13
    assert result.drift["energy"] < ENERGY
    if steps > 1000:
        energy = result.invariants["energy"]
        assert abs(np.mean(energy[:25]) - np.mean(energy[-25:])) < TREND * np.ptp(energy)


class HalfDual(lie.DualNumbers):
    """Dual numbers whose products in the midpoint leave out y₁ Θ y₀ and y₀ Θ y₁."""

    def cayley_terms(self, x, mu):
        one, two, three = super().cayley_terms(x, mu)
        zero = jnp.zeros_like(mu).at[..., 1, :, :].set(mu[..., 1, :, :])
        return one, two, three.at[..., 1, :, :].set(super().cayley_terms(x, zero)[2][..., 1, :, :])


@pytest.mark.sweep
def test_without_all_products_the_casimirs_drift():
    system, state = flow(8)
    object.__setattr__(system, "algebra", HalfDual(system.sphere))
    values = casimirs(run(system, state, 100).states)
    assert np.abs(values - values[:, :1]).max() > 1e6 * CASIMIR


class WrongForce(SphereMHD):
    """The force of the field the wrong way round: every Casimir is kept, the energy is not."""

    def velocity(self, point):
        return super().velocity(point) * jnp.array([1.0, -1.0])[:, None, None]


@pytest.mark.sweep
def test_a_wrong_force_is_caught():
    with pytest.raises(LawBroken, match="velocity"):
        check_system(WrongForce(3))


class Uncoupled(lie.DualNumbers):
    """Points of the dual that x₁ does not move."""

    def coadjoint(self, x, mu):
        return super().coadjoint(x.at[..., 1, :, :].set(0.0), mu)


@pytest.mark.sweep
def test_a_wrong_algebra_is_caught():
    with pytest.raises(LawBroken, match="duality"):
        check_algebra(Uncoupled(lie.SU(2)))


def test_dual_numbers_over_turns_are_rigid_motions():
    result = lie.DualNumbers(lie.SO3()).structure_constants()
    assert result == pytest.approx(lie.SE3().structure_constants(), abs=1e-15)
    point = np.arange(1.0, 7.0).reshape(2, 3)  # Θ is the linear part, W the angular one
    casimirs = lie.DualNumbers(lie.SO3()).named_casimirs(point)
    assert float(casimirs["|L|²"]) == pytest.approx(14.0)
    assert float(casimirs["d |L|²"]) == pytest.approx(2.0 * 32.0)


@pytest.mark.sweep
@pytest.mark.parametrize("n", [5, pytest.param(9, marks=pytest.mark.sweep), pytest.param(24, marks=pytest.mark.sweep)])
def test_alfven_rossby_waves_turn_rigidly(n):
    """W = (a + 2Ω)X₃ + Y, Θ = bX₃ + κY with any Y of degree l: (c − a/2 + (a+2Ω)/λ)(c − a/2) = b²(1 − 2/λ)."""
    a, b, rotation, degree, rng = 0.5, 0.6, 1.3, 3, np.random.default_rng(0)
    eigenvalue = degree * (degree + 1)
    middle, share = a / 2.0, (a + 2.0 * rotation) / eigenvalue
    speeds = np.roots([1.0, share, -(b**2) * (1.0 - 2.0 / eigenvalue)]) + middle
    assert sorted(speeds) == pytest.approx([-0.4419135261, 0.6835801927], abs=1e-10)
    system, table = SphereMHD(n, rotation), np.zeros((n, n), complex)
    table[degree, : degree + 1] = rng.normal(size=degree + 1) + 1j * rng.normal(size=degree + 1)
    table[degree, 0] = table[degree, 0].real
    wave, axis = system.sphere.from_harmonics(table), jnp.asarray(system.sphere.coordinates[2])
    m = np.arange(n) - (n - 1) / 2
    for speed in speeds:
        ratio = -b / eigenvalue / (speed - middle)
        state = jnp.stack([b * axis + ratio * wave, (a + 2.0 * rotation) * axis + wave])
        wanted = -1j * speed * (m[:, None] - m) * np.asarray(wave) * np.array([ratio, 1.0])[:, None, None]
        result = np.asarray(system.vector_field(0.0, state))
        assert result == pytest.approx(wanted, abs=1e-13 * np.abs(wanted).max())
        other = np.asarray(SphereMHD(n).vector_field(0.0, state))
        assert np.abs(other - wanted).max() > 0.1 * np.abs(wanted).max()


@pytest.mark.sweep
def test_steps_are_of_order_two_on_a_wave():
    n, rotation, a, b, degree = 9, 1.3, 0.5, 0.6, 3
    system, speed = SphereMHD(n, rotation), 0.68358019273
    ratio = -b / 12.0 / (speed - a / 2.0)
    wave, axis = system.sphere.from_harmonics(_one(n, degree, 2)), system.sphere.coordinates[2]
    state = jnp.stack([b * axis + ratio * wave, (a + 2.0 * rotation) * axis + wave])
    m, errors = np.arange(n) - (n - 1) / 2, []
    for step in (0.1, 0.05, 0.025):
        rotated = np.exp(-1j * speed * 2.0 * (m[:, None] - m)) * np.asarray(state)
        errors.append(np.abs(run(system, state, round(2.0 / step), step, 2).states[-1] - rotated).max())
    assert np.log2(np.array(errors[:-1]) / errors[1:]) == pytest.approx([2.0, 2.0], abs=0.1)


def _one(n, degree, order):
    table = np.zeros((n, n), complex)
    table[degree, order] = 1.0
    return table


def growth(n, s0, beta, order=1):
    """Growth on angular velocity 1 − s₀μ² and field b_φ = βμ sin θ."""
    p1, p2, p3 = (np.sqrt(4.0 * np.pi / (2 * degree + 1)) for degree in (1, 2, 3))
    system = SphereMHD(n)
    stream = {1: (-1.0 + s0 / 5.0) * p1, 3: 2.0 * s0 / 15.0 * p3}
    vorticity = {(degree, 0): -degree * (degree + 1) * value for degree, value in stream.items()}
    state = system.from_harmonics(vorticity, {(2, 0): -beta / 3.0 * p2})
    return zonal_growth(system, state, order).rate


GROWTHS = [(0.5, 0.0, 0.0568467943, 0.221), (0.5, 0.1, 0.0575326332, 0.143), (1.0, 0.5, 0.1218741338, 0.0587)]


@pytest.mark.parametrize(("s0", "beta", "exact", "limit"),
                         [pytest.param(*given, marks=pytest.mark.sweep) for given in GROWTHS])
def test_the_joint_instability_grows_as_that_of_the_continuum(s0, beta, exact, limit):
    """Errors tend to a number over N²."""
    missing = [abs(exact - growth(n, s0, beta)) * n**2 for n in (24, 48)]
    assert missing[1] == pytest.approx(limit, rel=0.1)
    assert abs(missing[1] - limit) < abs(missing[0] - limit)


def test_a_field_changes_the_growth_of_a_small_matrix_as_well():
    """N = 8 has the rates of the continuum to an eighth, and tells the three cases apart."""
    result = [growth(8, s0, beta) for s0, beta, _, _ in GROWTHS]
    assert result == pytest.approx([exact for _, _, exact, _ in GROWTHS], rel=0.15)
    assert result[0] < result[1] < result[2]


@pytest.mark.sweep
def test_energies_add_up_and_maps_show_the_functions():
    system, state = flow(4, SphereMHD(4, 0.5))
    energies = system.energy_spectrum(state)
    assert float(energies.sum()) == pytest.approx(float(system.energy(state)), rel=1e-13)
    single = system.from_harmonics({(3, 2): 0.4 - 0.2j}, {(2, 0): 0.3})
    theta, phi = np.array([0.3, 1.2]), np.array([0.0, 1.0])
    potential, vorticity = system.on_grid(single, theta, phi)
    mu = np.cos(theta)[:, None] + 0.0 * phi
    assert potential == pytest.approx(0.3 * np.sqrt(5.0 / 4.0 / np.pi) * (1.5 * mu**2 - 0.5), abs=1e-14)
    assert vorticity == pytest.approx(system.fluid.on_grid(single[1], theta, phi), abs=1e-14)


@pytest.mark.parametrize(
    ("call", "said"),
    [(lambda: SphereMHD(2), "at least 3"), (lambda: SphereMHD(8, np.nan), "`rotation`"),
     (lambda: SphereMHD(8).from_harmonics({(8, 0): 1.0}, {}), "`vorticity`.*1 ≤ l < 8"),
     (lambda: SphereMHD(8).from_harmonics({}, {(2, 0): 1j}), "`potential`.*real for m = 0"),
     (lambda: SphereMHD(8).random([0.0, 1.0], [0.0, -1.0]), "`magnetic`"),
     (lambda: lie.DualNumbers(lie.SO3()).odd_part(jnp.zeros((2, 3))), "not matrices")],
)  # fmt: skip
def test_what_is_refused(call, said):
    with pytest.raises(InvalidInput, match=said):
        call()
