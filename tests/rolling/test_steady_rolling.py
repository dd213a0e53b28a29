"""Steady rolling: known frequencies and thresholds, energy and spectrum of one mind."""

import jax.numpy as jnp
import numpy as np
import pytest

import polhode as ph
from polhode.errors import InvalidInput
from polhode.rolling import EulerDisk, RollingCouple
from polhode.rolling.euler_disk.steady_rolling import (
    critical_rolling_speed,
    critical_spin_rate,
    nutation,
    rolling_stability,
)
from sweeping import first

MASS, RADIUS, GRAVITY = 0.4387, 0.0381, 9.80665
thin = EulerDisk(MASS, RADIUS)
UPRIGHT = np.pi / 2
THRESHOLD = 1e-8  # relative, on either side


def conservative_spectrum(disk, state):
    """Return the exponents of the whole field, by differentiation, knowing nothing of integrals."""
    import jax

    return np.linalg.eigvals(np.asarray(jax.jacfwd(lambda x: disk.vector_field(jnp.zeros(()), x))(state)))


@pytest.mark.parametrize("tilt", [0.01, 0.1, 0.5, 1.0, 1.5])
def test_nutation_of_a_disk_whose_centre_is_at_rest(tilt):
    state = thin.rolling_state(tilt)
    ratio = nutation(thin, state) / float(thin.precession(state))
    assert abs(ratio**2 - (3 / 5 + np.sin(tilt) ** 2 / 5)) < 1e-13
    verdict = ph.stability(thin, state)
    assert verdict.verdict == "stable" and "positive definite" in verdict.certificate
    assert verdict.restriction == "in tilt and rates, not in heading and place"
    assert abs(verdict.spectrum.imag.max() - nutation(thin, state)) < 1e-8 * nutation(thin, state)


def test_the_family_of_steady_motions():
    """A φ̇² c − (C+ma²) φ̇ ω3 = mga c/s, both roots, and the spin that goes with each."""
    k = thin.mechanics
    A, C, m, a = (float(x) for x in (k.diametral_moment, k.axial_moment, k.mass, k.radius))
    s, c = np.sin(0.8), np.cos(0.8)
    roots = np.roots([A * c, -(C + m * a * a) * 12.0, -m * a * GRAVITY * c / s])
    assert roots.max() > 0 > roots.min()
    for rate in roots:
        assert abs(float(thin.rolling_state(0.8, rate)[7]) - 12.0) < 1e-9


def test_thresholds_of_upright_motion():
    speed, spin = critical_rolling_speed(thin), critical_spin_rate(thin)
    assert abs(speed**2 - GRAVITY * RADIUS / 3) < 1e-15
    assert abs(spin**2 - MASS * GRAVITY * RADIUS / (1.25 * MASS * RADIUS**2)) < 1e-11
    for side, wanted in ((1 - THRESHOLD, "unstable"), (1 + THRESHOLD, "stable")):
        assert ph.stability(thin, thin.rolling_state(UPRIGHT, 0.0, side * speed / RADIUS)).verdict == wanted
        assert ph.stability(thin, thin.rolling_state(UPRIGHT, side * spin, 0.0)).verdict == wanted


@pytest.mark.long
@pytest.mark.parametrize("thickness", first(1, [0.2, 0.0, 1.0]))
def test_energy_and_spectrum_agree(thickness):
    """Verdicts of the energy on the integrals' level, and exponents of the field, on many steady motions."""
    disk = EulerDisk(1.0, 1.0, thickness, gravity=3.0)
    rng = np.random.default_rng(5)
    verdicts = []
    for _ in range(30):
        state = disk.rolling_state(rng.uniform(0.05, 1.5 if thickness else 3.0), 2.0 * rng.normal())
        found = rolling_stability(disk, state)
        growth = conservative_spectrum(disk, state).real.max()
        assert found.verdict == ("unstable" if growth > 1e-5 else "stable")
        if found.verdict == "unstable":
            assert abs(found.rate / growth - 1) < 1e-6
        verdicts.append(found.verdict)
    assert set(verdicts) == {"stable", "unstable"}


@pytest.mark.sweep
def test_an_unstable_motion_leaves_at_its_rate():
    state = thin.rolling_state(UPRIGHT, 0.0, 0.7 * critical_rolling_speed(thin) / RADIUS)
    found = rolling_stability(thin, state)
    times = np.linspace(0.0, 12.0 / found.rate, 30)
    off = ph.simulate(thin, state.at[0].add(1e-8), times).states[:, 0] - UPRIGHT
    late = slice(15, 25)
    assert abs(np.polyfit(times[late], np.log(np.abs(off[late])), 1)[0] / found.rate - 1) < 1e-3


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda: rolling_stability(EulerDisk(1.0, 1.0, dissipation=[RollingCouple(1e-3)]), np.ones(8)), "without"),
        (lambda: ph.stability(thin, thin.rolling_state(0.5).at[6].add(0.1)), "not steady"),
        (lambda: ph.stability(thin, thin.rolling_state(0.5).at[5].add(0.1)), "not steady"),
        (lambda: ph.stability(3.0, np.ones(3)), "`system` must be"),
        (lambda: critical_spin_rate(EulerDisk(1.0, 1.0, 0.1)), "must be thin"),
    ],
)
@pytest.mark.usefixtures("any_type")
def test_bad_input(call, words):
    with pytest.raises(InvalidInput, match=words):
        call()
