"""LagrangeMotion and steady precession as users meet them: published numbers, meaning, batches, errors."""

import math

import jax
import jax.numpy as jnp
import numpy as np
import pytest

import polhode as ph
from polhode.errors import InvalidInput
from polhode.exact.lagrange_top.steady_precession import sleeping_threshold, steady_precession

PRINTED = 4e-15
"""Relative to tables of twenty digits: the tilt of 60 degrees is itself only known to an ulp."""
KEPT = 1e-14
"""Drift of invariants computed in float64 from states exact to a few ulp."""
MOMENTS = (1.0, 1.0, 0.5)


def tipped(theta, theta_rate, azimuth_rate, spin, **options):
    """A top with φ = ψ = 0: L1 = I1 θ̇, L2 = I1 φ̇ sin θ."""
    momentum = (theta_rate, azimuth_rate * math.sin(theta), MOMENTS[2] * spin)
    return ph.LagrangeMotion(
        MOMENTS, mgl=1.0, momentum=momentum, attitude=(math.cos(theta / 2), math.sin(theta / 2), 0.0, 0.0), **options
    )


TABLE = {
    "cusp": ((60, 0, 0, 5), (0.19176798753366819897, 0.5), 2.7639286494278718593, 1.1422887189755757981),
    "loop": ((60, 0, -0.3, 5), (-0.00533329827605812282, 0.5), 2.6051241064868719956, 1.0120342483896466149),
    "undulating": ((60, 0, 0.25, 5), (0.36647977867732114405, 0.5), 2.8994475826401496187, 1.2466550978964438343),
    "pendulum": ((120, 0, 0.7, 0), (-0.86549954302117308805, -0.5), 3.3830015248533432612, 3.9000751664097917182),
}


@pytest.mark.parametrize("name", TABLE)
def test_published_numbers(name):
    start, limits, period, precession = TABLE[name]
    top = tipped(math.radians(start[0]), *start[1:])
    assert top.nutation_limits == pytest.approx(limits, abs=PRINTED)
    assert top.nutation_period == pytest.approx(period, rel=PRINTED)
    assert top.precession_per_period == pytest.approx(precession, rel=PRINTED)
    assert top.regime == ("undulating" if name == "pendulum" else name)
    assert top.precession_rate == pytest.approx(precession / period, rel=PRINTED)


def test_spin_per_period_of_the_cusp():
    assert tipped(math.pi / 3, 0, 0, 5).spin_per_period == pytest.approx(13.506325088944312711, rel=PRINTED)


@pytest.mark.parametrize(("spin", "ratio"), [(20, 1.00991605), (50, 1.00159804)])
def test_the_fast_top_nutates_as_a_free_one_does(spin, ratio):
    top = tipped(math.pi / 3, 0, 0, spin)
    assert top.nutation_period * MOMENTS[2] * spin / (2 * math.pi) == pytest.approx(ratio, abs=5e-9)


def test_steady_precession_at_sixty_degrees():
    slow, fast = steady_precession(MOMENTS, 1.0, math.pi / 3, 5.0)
    assert slow == pytest.approx(0.438447187191169725089, rel=PRINTED)
    assert fast == pytest.approx(4.56155281280883027491, rel=PRINTED)


@pytest.mark.parametrize("which", [0, 1])
def test_a_top_started_at_a_steady_rate_keeps_its_tilt(which):
    rate = steady_precession(MOMENTS, 1.0, math.pi / 3, 5.0)[which]
    top = tipped(math.pi / 3, 0.0, rate, 5.0)
    low, high = top.nutation_limits
    assert high - low < 1e-14
    assert top.precession_rate == pytest.approx(rate, rel=KEPT)


def test_slow_precession_of_a_very_fast_top_does_not_cancel():
    slow, fast = steady_precession(MOMENTS, 1.0, 1.0, 1e10)
    assert slow == pytest.approx(2e-10, rel=PRINTED)
    assert fast == pytest.approx(0.5e10 / math.cos(1.0), rel=PRINTED)


def test_too_slow_a_spin_has_no_steady_precession():
    assert steady_precession(MOMENTS, 1.0, math.pi / 3, 2.0) is None
    assert steady_precession(MOMENTS, 1.0, 2 * math.pi / 3, 2.0) is not None


def test_at_the_threshold_the_top_begins_to_sleep():
    """A top tipped by 1e-6 stays there above the threshold and falls below it."""
    spin = sleeping_threshold(MOMENTS, 1.0)
    assert spin == 4.0
    tops = [tipped(1e-6, 0.0, 0.0, factor * spin) for factor in (1.01, 0.99)]
    assert tops[0].nutation_limits[0] > 1 - 1e-8
    assert tops[1].nutation_limits[0] == pytest.approx(2 * 0.99**2 - 1, abs=1e-8)
    assert sleeping_threshold(MOMENTS, -1.0) == 0.0


UPRIGHT, DOWN, LEVEL = (1.0, 0.0, 0.0, 0.0), (0.0, 1.0, 0.0, 0.0), (0.5, 0.5, 0.5, 0.5)
REGIMES = {
    "rest": (1.0, (0, 0, 0), DOWN), "sleeping": (1.0, (0, 0, 1), UPRIGHT), "hanging": (1.0, (0, 0, 1), DOWN),
    "steady": (2.0, (0, 1, 2), LEVEL), "free": (0.0, (1, 2, 3), LEVEL), "planar": (1.0, (1, 0, 0), DOWN),
    "undulating": (1.0, (1, 0, 0.5), UPRIGHT), "cusp": (1.0, (0, 0, 2), LEVEL), "loop": (1.0, (0, -0.3, 3), LEVEL),
    "separatrix": (1.0, (2, 0, 0), DOWN),
}  # fmt: skip


@pytest.mark.parametrize("name", REGIMES)
def test_regimes(name):
    mgl, momentum, attitude = REGIMES[name]
    assert ph.LagrangeMotion(MOMENTS, mgl=mgl, momentum=momentum, attitude=attitude).regime == name


@pytest.mark.parametrize("spin", [0.0, 1.1, -2.0])
def test_a_smaller_displacement_takes_longer_to_leave_by_its_logarithm(spin):
    """An upright top leaves as e^{λt}, λ² = mgl/I1 − (L3/2I1)²; twice on the way to its next stand."""
    I1, mgl, sizes = 0.8, 1.3, np.array([1e-40, 1e-59, 1e-62, 1e-100, 1e-200, 1e-300])
    growth = math.sqrt(mgl / I1 - (spin / (2.0 * I1)) ** 2)
    tops = [
        ph.LagrangeMotion((I1, I1, 0.5), mgl=mgl, momentum=(0.3 * v, 0.0, spin), attitude=(1.0, v, 0.0, 0.0))
        for v in sizes
    ]
    assert {top.regime for top in tops} == {"planar" if spin == 0.0 else "loop"}
    periods = [top.nutation_period for top in tops]
    assert np.diff(periods) == pytest.approx(-2.0 * np.diff(np.log(sizes)) / growth, rel=1e-13)


def test_a_hanging_top_swings_alike_however_little():
    """Its swing is linear in the displacement, which the attitude's w and z and the momentum's first two are here."""
    swings = []
    for size in (1e-40, 1e-130, 1e-300):
        top = ph.LagrangeMotion(
            (0.8, 0.8, 0.5), mgl=1.3, momentum=(0.3 * size, -0.7 * size, 1.1), attitude=(size, 0.6, 0.8, -0.5 * size)
        )
        attitude, momentum = top.state(np.array([0.0, 7.3, -1e4, 1e9]))
        swings.append(np.concatenate([attitude[:, [0, 3]], momentum[:, :2]], axis=-1) / size)
    assert np.abs(swings[0]).max() < 5.0
    for other in swings[1:]:
        np.testing.assert_allclose(other, swings[0], rtol=0.0, atol=2e-14)


def test_a_pendulum_started_on_its_way_up_turns_over_however_near_the_top():
    """w = 2 √(mgl I1) β is the growing direction exactly, and energy is above the top's by β⁴ alone."""
    size = 2.0**-300
    top = ph.LagrangeMotion((1.0, 1.0, 0.5), mgl=1.0, momentum=(2.0 * size, 0.0, 0.0), attitude=(1.0, size, 0.0, 0.0))
    # the modulus of a pendulum that turns over: k² = 1/(1 + w²β²/4) for unit moment and weight; K = ln 4/k'
    assert top.regime == "planar"
    assert top.nutation_period == pytest.approx(2.0 * (math.log(4.0) - math.log(size * size)), rel=1e-14)


def test_regimes_of_a_batch_are_codes_and_absent_values_nan_or_inf():
    mgl, momentum, attitude = (np.array(v, float) for v in zip(*REGIMES.values(), strict=True))
    tops = ph.LagrangeMotion(MOMENTS, mgl=mgl, momentum=momentum, attitude=attitude)
    assert tops.regime.tolist() == list(range(len(REGIMES)))
    period = dict(zip(REGIMES, tops.nutation_period.tolist(), strict=True))
    assert math.isnan(period["sleeping"]) and period["separatrix"] == math.inf and period["loop"] > 0
    assert ph.LagrangeMotion(MOMENTS, mgl=1.0, momentum=(2, 0, 0), attitude=DOWN).nutation_period == np.inf


def test_a_steady_top_precesses_and_spins_at_its_rates():
    """L3 φ̇ = mgl at a level axis, and ω3 = ψ̇ + φ̇ cos θ."""
    top = ph.LagrangeMotion(MOMENTS, mgl=2.0, momentum=(0, 1, 2), attitude=LEVEL)
    assert top.precession_rate == pytest.approx(1.0, rel=PRINTED)
    assert top.spin_rate == pytest.approx(4.0, rel=PRINTED)


def test_an_axis_is_level_to_sixteen_roundings():
    level, tilted = (steady_precession(MOMENTS, 2.0, math.pi / 2 - cosine, 4.0) for cosine in (3.3e-15, 3.9e-15))
    assert level.fast is None and tilted.fast > 1e14 and level.slow == pytest.approx(tilted.slow, rel=1e-12)


def test_without_weight_it_is_the_free_body():
    moments, momentum, attitude = (2.0, 2.0, 1.0), (0.3, 0.4, 1.2), (0.5, -0.5, 0.5, 0.5)
    top, body = (
        ph.LagrangeMotion(moments, mgl=0.0, momentum=momentum, attitude=attitude),
        ph.FreeMotion(moments, momentum=momentum, attitude=attitude),
    )
    times = np.linspace(-1e6, 1e6, 7)
    for x, y in zip(top.state(times), body.state(times), strict=True):
        assert np.abs(x - y).max() < KEPT


def test_samples_keep_their_invariants():
    top = tipped(1.0, 0.3, 0.2, 6.0)
    trajectory = top.sample(np.linspace(0.0, 1e6, 200))
    assert set(trajectory.drift) == {"energy", "vertical_momentum", "axial_momentum"}
    assert max(trajectory.drift.values()) < KEPT
    assert trajectory.invariants["energy"][0] == pytest.approx(top.energy, rel=KEPT)
    assert trajectory.invariants["vertical_momentum"][0] == pytest.approx(top.vertical_momentum, rel=KEPT)
    assert top.axial_momentum == 3.0
    matrix = top.rotation_matrix(3.0)
    assert np.abs(matrix @ matrix.T - np.eye(3)).max() < KEPT


def test_the_given_quaternion_comes_out_at_the_epoch_normalised_with_its_sign():
    given = np.array([-0.5, 0.1, -0.7, 0.2]) / np.linalg.norm([-0.5, 0.1, -0.7, 0.2])
    for mgl in (1.0, 0.0, -1.0):
        top = ph.LagrangeMotion(MOMENTS, mgl=mgl, momentum=(1, 2, 3), attitude=given * (1 + 3e-7), epoch=5.0)
        attitude, momentum = top.state(5.0)
        assert np.abs(attitude - given).max() < 1e-15
        assert np.abs(momentum - [1, 2, 3]).max() < 4e-15


@pytest.mark.long
def test_tops_and_times_broadcast():
    rng = np.random.default_rng(1)
    mgl, momentum, times = rng.normal(size=3), rng.normal(size=(3, 3)), np.linspace(0, 9, 5)
    attitude, angular = ph.LagrangeMotion(MOMENTS, mgl=mgl[:, None], momentum=momentum[:, None]).state(times)
    assert attitude.shape == (3, 5, 4)
    one = ph.LagrangeMotion(MOMENTS, mgl=mgl[1], momentum=momentum[1]).state(times[2])
    assert np.abs(attitude[1, 2] - one[0]).max() < 1e-15
    assert np.abs(angular[1, 2] - one[1]).max() < 4e-15
    assert ph.LagrangeMotion(MOMENTS, mgl=mgl, momentum=momentum).sample(times).attitude.shape == (3, 5, 4)


@pytest.mark.sweep
def test_jax_arrays_come_back_as_jax_arrays_with_all_answers():
    with jax.enable_x64(True):
        top = ph.LagrangeMotion(jnp.array(MOMENTS), mgl=jnp.array(1.0), momentum=jnp.array((0.1, 0.2, 2.5)))
        attitude, momentum = top.state(jnp.array(3.0))
        assert isinstance(attitude, jax.Array) and isinstance(momentum, jax.Array)
        same = ph.LagrangeMotion(MOMENTS, mgl=1.0, momentum=(0.1, 0.2, 2.5))
        assert np.abs(attitude - same.state(3.0)[0]).max() < 1e-15
        assert top.regime == same.regime
        assert top.nutation_period == pytest.approx(same.nutation_period, rel=PRINTED)


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"moments": (1.0, 2.0, 3.0)}, "simulate"),
        ({"moments": (1.0, 1.0, -3.0)}, "positive"),
        ({"mgl": math.nan}, "`mgl` must be finite"),
        ({"momentum": (0.0, math.inf, 1.0)}, "`momentum` must be finite"),
        ({"attitude": (1.0, 1.0, 0.0, 0.0)}, "unit quaternion"),
    ],
)
def test_bad_input_is_named(change, words):
    given = {"moments": MOMENTS, "mgl": 1.0, "momentum": (0.0, 0.0, 1.0)} | change
    with pytest.raises(InvalidInput, match=words):
        ph.LagrangeMotion(**given)


def test_bad_times_and_tilts_are_named():
    top = tipped(1.0, 0.0, 0.0, 5.0)
    with pytest.raises(InvalidInput, match="`t` must be finite"):
        top.state(math.nan)
    with pytest.raises(InvalidInput, match="`tilt`"):
        steady_precession(MOMENTS, 1.0, 4.0, 5.0)
    with pytest.raises(InvalidInput, match="axis of symmetry"):
        sleeping_threshold((1.0, 2.0, 3.0), 1.0)


def test_unequal_moments_are_shown_with_the_digits_that_tell_them_apart():
    with pytest.raises(InvalidInput, match=r"got \(1.0, 1.0000000000000002, 0.5\) kg m², 2.2e-16 .* by rounding: give"):
        ph.LagrangeMotion((1.0, 1.0 + 2.0**-52, 0.5), mgl=1.0, momentum=(0.1, 0.0, 2.0))
    with pytest.raises(InvalidInput, match="Other heavy tops have no closed form"):
        ph.LagrangeMotion((1.0, 1.1, 0.5), mgl=1.0, momentum=(0.1, 0.0, 2.0))
