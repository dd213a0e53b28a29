"""The quantised sphere and the fluid on it: eigenvalues, brackets, exact waves, growth rates, blobs, what is kept."""

import jax
import jax.numpy as jnp
import numpy as np
import pytest
from scipy.special import sph_harm_y

import polhode as ph
from polhode.errors import InvalidInput
from polhode.fields import QuantizedSphere, SphereFluid
from polhode.fields.sphere._laplacian import inverse_laplacian, laplacian
from polhode.integrators import IsospectralMidpoint

NODES, WEIGHTS = np.polynomial.legendre.leggauss(64)
AZIMUTHS = 2.0 * np.pi * np.arange(128) / 128


def harmonic(n, degree, order, value=1.0):
    table = np.zeros((n, n), complex)
    table[degree, order] = value
    return table


@pytest.mark.long_cases("5")
@pytest.mark.parametrize("n", [5, *(pytest.param(n, marks=pytest.mark.sweep) for n in (17, 64))])
def test_harmonics_are_eigenvectors_of_the_laplacian(n):
    sphere = QuantizedSphere(n)
    for degree in {1, 2, n // 2, n - 1}:
        for order in {0, 1, degree}:
            T = sphere.from_harmonics(harmonic(n, degree, order))
            off = jnp.abs(laplacian(T) + degree * (degree + 1.0) * T).max() / jnp.abs(T).max()
            assert off < 2e-15 * n * (n - 1)


@pytest.mark.long
def test_the_inverse_laplacian_is_one():
    sphere, rng = QuantizedSphere(17), np.random.default_rng(0)
    W = sphere.project(jnp.asarray(rng.normal(size=(2, 17, 17)) + 1j * rng.normal(size=(2, 17, 17))))
    assert jnp.abs(laplacian(inverse_laplacian(W)) - W).max() < 1e-13 * jnp.abs(W).max()
    assert jnp.abs(inverse_laplacian(laplacian(W)) - W).max() < 1e-13 * jnp.abs(W).max()
    assert jnp.abs(inverse_laplacian(W)[1] - inverse_laplacian(W[1])).max() == 0.0


def test_harmonics_and_coordinates_come_back():
    sphere, rng = QuantizedSphere(5), np.random.default_rng(1)
    x = rng.normal(size=(3, sphere.dim))
    assert np.asarray(sphere.to_vector(sphere.from_vector(x))) == pytest.approx(x, abs=2e-14)
    X = sphere.coordinates
    assert (X[0] @ X[1] - X[1] @ X[0]) / sphere.hbar == pytest.approx(-X[2], abs=1e-15)
    # x₃ = √(4π/3) Y₁₀, and x₁ has −√(2π/3) Y₁₁
    result = np.asarray(sphere.to_harmonics(jnp.asarray(X)))
    assert result[2, 1, 0] == pytest.approx(np.sqrt(4 * np.pi / 3))
    assert result[0, 1, 1] == pytest.approx(-np.sqrt(2 * np.pi / 3))


def poisson_of(one, other):
    """Coefficients of {Y, Y'} = ∂_μ f ∂_φ g − ∂_φ f ∂_μ g by quadrature, of complex harmonics, up to degree 40."""
    theta = np.arccos(NODES)[:, None]

    def parts(degree, order):
        step = 1e-6
        value = sph_harm_y(degree, order, theta, AZIMUTHS)
        above, below = (sph_harm_y(degree, order, theta + side * step, AZIMUTHS) for side in (1, -1))
        slope = (above - below) / (2.0 * step)
        return -slope / np.sin(theta), 1j * order * value

    (f_mu, f_phi), (g_mu, g_phi) = parts(*one), parts(*other)
    return f_phi * g_mu - f_mu * g_phi, one[1] + other[1]


@pytest.mark.parametrize(("one", "other", "limit"), [((2, 1), (2, 0), 1.826), ((3, 2), (4, 1), 25.0)])
def test_the_bracket_is_that_of_functions_to_second_order(one, other, limit):
    """‖[F, G]/ħ + {f, g}‖ N² tends to a number; of degree 1 nothing is missing."""
    function, order = poisson_of(one, other)
    theta = np.arccos(NODES)[:, None]
    errors = []
    for n in (32, 64):
        sphere = QuantizedSphere(n)
        T = [_complex_tensor(sphere, *place) for place in (one, other)]
        result = (T[0] @ T[1] - T[1] @ T[0]) / sphere.hbar
        exact = np.zeros((n, n), complex)
        for degree in range(max(order, 1), one[0] + other[0]):
            weight = np.conj(sph_harm_y(degree, order, theta, AZIMUTHS)) * function
            value = (weight.mean(axis=1) * 2 * np.pi) @ WEIGHTS
            exact += value * _complex_tensor(sphere, degree, order)
        errors.append(np.linalg.norm(result + exact) / np.linalg.norm(exact))
    assert errors[1] * 64**2 == pytest.approx(limit, rel=0.02)
    assert np.log2(errors[0] / errors[1]) == pytest.approx(2.0, abs=0.05)


def _complex_tensor(sphere, degree, order):
    """i T_lm/√4π of one complex harmonic, on its diagonal alone."""
    n, matrix = sphere.n, np.zeros((sphere.n, sphere.n), complex)
    row = sphere.tensors[order][degree - order]
    matrix[np.arange(order, n), np.arange(n - order)] = 1j / np.sqrt(4.0 * np.pi) * row
    return matrix


@pytest.mark.long
@pytest.mark.parametrize("n", [9, pytest.param(24, marks=pytest.mark.sweep)])
def test_rossby_haurwitz_waves_turn_rigidly(n):
    """W = (a + 2Ω) X₃ + Y turns at a/2 − (a + 2Ω)/(l(l+1)), at any amplitude."""
    rotation, a, degree, rng = 1.3, 0.7, 5, np.random.default_rng(0)
    fluid, table = SphereFluid(n, rotation), np.zeros((n, n), complex)
    table[degree, : degree + 1] = rng.normal(size=degree + 1) + 1j * rng.normal(size=degree + 1)
    table[degree, 0] = table[degree, 0].real
    wave = fluid.algebra.from_harmonics(table)
    state = (a + 2.0 * rotation) * jnp.asarray(fluid.algebra.coordinates[2]) + wave
    m = np.arange(n) - (n - 1) / 2
    speed = a / 2.0 - (a + 2.0 * rotation) / (degree * (degree + 1))
    assert speed == pytest.approx(0.24)
    wanted = -1j * speed * (m[:, None] - m) * np.asarray(wave)
    assert np.asarray(fluid.vector_field(0.0, state)) == pytest.approx(wanted, abs=1e-13 * np.abs(wanted).max())
    assert np.abs(np.asarray(SphereFluid(n).vector_field(0.0, state)) - wanted).max() > 0.1 * np.abs(wanted).max()


@pytest.mark.parametrize(("order", "growth", "at_32", "limit"), [
    (1, 0.0760157614, 0.0758683, 0.139), (2, 0.2589748314, 0.2582766, 0.830)])  # fmt: skip
@pytest.mark.sweep
def test_growth_on_a_zonal_flow(order, growth, at_32, limit):
    """ω = √7 P₃: the rates of the continuum, missed by a number over N²."""
    errors = []
    for n in (32, 48):
        fluid = SphereFluid(n)
        state = fluid.from_harmonics({(3, 0): np.sqrt(4.0 * np.pi)})
        rows = np.arange(n - order)

        @jax.jit
        def column(k, n=n, state=state, fluid=fluid):
            entry = jnp.zeros((n, n), complex).at[k + order, k].set(1.0)
            change = jax.jvp(lambda W: fluid.vector_field(0.0, W), (state,), (entry - jnp.conj(entry.T),))[1]
            return change[rows + order, rows]  # noqa: B023

        matrix = np.asarray(jax.vmap(column)(rows)).T
        errors.append(growth - np.linalg.eigvals(matrix).real.max())
    assert growth - errors[0] == pytest.approx(at_32, abs=1e-7)
    assert errors[1] * 48**2 == pytest.approx(limit, rel=0.1)


@pytest.mark.sweep
def test_blobs_turn_as_point_vortices():
    """Two at colatitude 0.6 come nearer to the point vortices' rate with N."""
    colatitude, strength = 0.6, 1.0
    places = [(s * np.sin(colatitude), 0.0, np.cos(colatitude)) for s in (1, -1)]
    rate = strength * np.cos(colatitude) / (2.0 * np.pi * (1.0 - np.cos(2 * colatitude)))
    for n, low, high in ((16, -0.12, -0.07), (32, -0.05, -0.02)):
        fluid = SphereFluid(n)
        start = sum(fluid.vortex(strength, place) for place in places)
        time = 0.05 * 2.0 * np.pi / rate
        run = ph.simulate(fluid, start, [0.0, time], IsospectralMidpoint, step=time / 40, order=2, estimate_error=False)
        phase = np.angle(np.asarray(fluid.to_harmonics(run.states))[:, 2, 2])
        assert low < -(phase[1] - phase[0]) / 2.0 / time / rate - 1.0 < high


def flow(n, rotation=0.0):
    fluid = SphereFluid(n, rotation)
    degree = np.arange(min(n, 10))
    state = fluid.random(np.where(degree > 0, 1.0 / np.maximum(degree, 1) ** 3, 0.0), seed=1)
    return fluid, state


def drifts(n, steps, rotation=0.0):
    fluid, state = flow(n, rotation)
    step = 0.25 / float(fluid.algebra.rate(fluid.stream_function(state)))
    run = ph.simulate(fluid, state, np.linspace(0.0, steps * step, 5), IsospectralMidpoint, step=step, order=2,
                      estimate_error=False)  # fmt: skip
    return fluid, run, step


@pytest.mark.sweep
@pytest.mark.parametrize(("n", "steps"), [(12, 60), pytest.param(48, 1000, marks=pytest.mark.sweep)])
def test_spectrum_and_angular_momentum_stay(n, steps):
    fluid, run, _ = drifts(n, steps)
    spectrum = np.asarray(fluid.algebra.spectrum(run.states))
    assert np.abs(spectrum - spectrum[0]).max() < 5e-15 * np.abs(spectrum).max()
    axes = jnp.asarray(fluid.algebra.coordinates)
    momentum = np.asarray(fluid.algebra.pairing(jnp.asarray(run.states)[:, None], axes))
    assert np.abs(momentum - momentum[0]).max() < 1e-13
    assert run.drift["energy"] < 2e-3


@pytest.mark.long
def test_on_a_rotating_sphere_the_momentum_turns():
    rotation = 0.8
    fluid, run, step = drifts(12, 40, rotation)
    axes = jnp.asarray(fluid.algebra.coordinates)
    relative = jnp.asarray(run.states)[:, None] - fluid.planetary
    momentum = np.asarray(fluid.algebra.pairing(relative, axes))
    angle = -rotation * run.times
    wanted = np.stack([momentum[0, 0] * np.cos(angle) - momentum[0, 1] * np.sin(angle),
                       momentum[0, 0] * np.sin(angle) + momentum[0, 1] * np.cos(angle),
                       np.full(len(angle), momentum[0, 2])], axis=-1)  # fmt: skip
    assert momentum == pytest.approx(wanted, abs=1e-2 * np.abs(momentum).max() * step * 40)
    assert run.drift["L3"] < 1e-14 and run.drift["L1² + L2²"] < 1e-3


@pytest.mark.long
@pytest.mark.long
def test_a_trace_does_not_reach_the_stream_function():
    """The midpoint's W̃ has a trace; if the Laplacian took it up, L would drift and the spectrum would not show it."""
    fluid, state = flow(12)
    with_trace = state + 0.3j * jnp.eye(12)
    assert jnp.abs(fluid.stream_function(with_trace) - fluid.stream_function(state)).max() < 1e-14
    assert abs(jnp.trace(fluid.stream_function(state))) < 1e-14


@pytest.mark.long
def test_energies_add_up_and_maps_show_the_function():
    fluid, state = flow(12, 0.5)
    assert float(fluid.energy_spectrum(state).sum()) == pytest.approx(float(fluid.energy(state)), rel=1e-13)
    single = fluid.from_harmonics({(3, 2): 0.4 - 0.2j})
    theta, phi = np.array([0.3, 1.2]), np.array([0.0, 1.0, 4.0])
    exact = 2.0 * np.real((0.4 - 0.2j) * sph_harm_y(3, 2, theta[:, None], phi))
    assert fluid.on_grid(single, theta, phi) == pytest.approx(exact, abs=1e-13)


@pytest.mark.long
@pytest.mark.parametrize("samples", [2, pytest.param(21, marks=pytest.mark.sweep)])
def test_memory_is_what_was_said_beforehand(samples):
    n = 16
    fluid, state = flow(n)

    def run(state):
        return ph.solve(fluid, state, np.linspace(0.0, 1.0, samples), IsospectralMidpoint, 0.01, order=2)

    given = jax.jit(run).lower(state).compile().memory_analysis()
    held = given.temp_size_in_bytes + given.output_size_in_bytes + given.argument_size_in_bytes
    assert fluid.cost(100, samples).bytes == pytest.approx(held, rel=0.15)
    assert fluid.cost(100).seconds == pytest.approx(100 * fluid.cost().seconds)
    # eight times the work and four times the memory at twice N, where N is large
    ratio = np.array(SphereFluid(2048).cost()) / SphereFluid(1024).cost()
    assert ratio == pytest.approx([8.0, 4.0], rel=0.05)


@pytest.mark.parametrize(
    ("call", "said"),
    [(lambda: SphereFluid(2), "`n`"), (lambda: SphereFluid(8, np.nan), "`rotation`"),
     (lambda: SphereFluid(8).from_harmonics({(8, 0): 1.0}), "1 ≤ l < 8"),
     (lambda: SphereFluid(8).from_harmonics({(2, 0): 1j}), "real for m = 0"),
     (lambda: SphereFluid(8).random([0.0, -1.0]), "`spectrum`"), (lambda: QuantizedSphere(1), "whole number"),
     (lambda: SphereFluid(8).vortex(1.0, (0, 0, 0)), "`direction`"),
     (lambda: SphereFluid(8).cost(0), "`steps`"), (lambda: SphereFluid(8).cost(1, 0), "`samples`"),
     (lambda: SphereFluid(8).cost(1, 1, 0.0), "`iterations`")],
)  # fmt: skip
def test_what_is_refused(call, said):
    with pytest.raises(InvalidInput, match=said):
        call()


@pytest.mark.long
def test_energy_moves_between_degrees_as_the_transfer_says():
    """Against differences of the spectrum over a short time, both ways."""
    fluid = SphereFluid(9, 0.7)
    state = fluid.random([0, 1, 2, 1, 1], seed=5)
    apart = 1e-4
    ends = [
        ph.solve(fluid, state, (0.0, t), IsospectralMidpoint, step=apart, order=2).saved[-1] for t in (apart, -apart)
    ]
    slopes = (fluid.energy_spectrum(ends[0]) - fluid.energy_spectrum(ends[1])) / (2.0 * apart)
    transfer = fluid.energy_transfer(state)
    np.testing.assert_allclose(transfer, slopes, atol=1e-6)
    assert np.abs(transfer).max() > 0.01 and abs(np.sum(transfer)) < 1e-13


@pytest.mark.long
def test_zonal_velocity_in_closed_form():
    """ω = P₃(x₃) = Δψ gives ψ = −P₃/12 and u = ∂ψ/∂θ; waves do not count."""
    fluid, theta = SphereFluid(8, 2.0), np.linspace(0.0, np.pi, 7)
    state = fluid.from_harmonics({(3, 0): np.sqrt(4.0 * np.pi / 7.0), (4, 2): 1.0 + 2.0j})
    wanted = np.sin(theta) * (15.0 * np.cos(theta) ** 2 - 3.0) / 24.0
    np.testing.assert_allclose(fluid.zonal_velocity(state, theta), wanted, atol=1e-14)


def test_harmonics_are_the_same_compiled():
    sphere, rng = QuantizedSphere(6), np.random.default_rng(2)
    table = np.tril(rng.normal(size=(2, 6, 6)) + 1j * rng.normal(size=(2, 6, 6)))
    np.testing.assert_allclose(jax.jit(sphere.from_harmonics)(table), sphere.from_harmonics(table), atol=1e-15)
    W = sphere.from_harmonics(table)
    np.testing.assert_allclose(jax.jit(sphere.to_harmonics)(W), sphere.to_harmonics(W), atol=1e-15)
