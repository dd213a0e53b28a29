"""What coefficients at the beginning of a step do not show: roots of double zeros, and exponentials still too small."""

import jax.numpy as jnp
import mpmath
import numpy as np
import pytest
from scipy.integrate import quad

import polhode as ph
from polhode import spacecraft
from polhode.errors import NotConverged
from polhode.integrators import Taylor, _series
from polhode.taylor import advancing, kernel_series, kernels
from taylor.test_coefficients import OwnField


def end_of(field, state, end, method=None):
    run = ph.simulate(OwnField(field), state, [0.0, end], method)
    return np.asarray(run.states[-1]), float(run.error_estimate)


ROOTS = {
    "a root of a square": (lambda t, y: jnp.stack([0.0 * y[0] - 1.0, jnp.sqrt(y[0] ** 2)]), [1.0, 0.0]),
    "a norm": (lambda t, y: jnp.stack([0.0 * y[0] - 1.0, jnp.linalg.norm(y[:1])]), [1.0, 0.0]),
    "a root in time": (lambda t, y: jnp.stack([0.0 * y[0], jnp.sqrt((1.0 - t) ** 2)]), [0.0, 0.0]),
}


@pytest.mark.parametrize("name", ["a root of a square"])
def test_behind_a_double_zero_a_root_is_positive_again(name):
    """∫ |1 − t| dt from 0 to 2 is 1; the series of |1 − t| goes on to −|1 − t|, and gave 0."""
    found, error = end_of(*ROOTS[name], 2.0)
    assert found[1] == pytest.approx(1.0, abs=1e-10) and error < 1e-9


@pytest.mark.long
@pytest.mark.parametrize("name", [name for name in ROOTS if name != "a root of a square"])
def test_behind_a_double_zero_all_roots_are_positive_again(name):
    test_behind_a_double_zero_a_root_is_positive_again(name)


def test_series_alone_end_at_such_a_zero():
    with pytest.raises(NotConverged):
        end_of(*ROOTS["a root of a square"], 2.0, Taylor)


@pytest.mark.long
def test_what_comes_to_rest_under_a_root_is_not_thrown_back():
    """ẋ = −√x is at rest from t = 2 on; the series of (1 − t/2)² rose again."""
    with pytest.raises(NotConverged):
        end_of(lambda t, y: -jnp.sqrt(y), [1.0], 3.0)


def bump(width):
    return lambda t, y: jnp.stack([1.0 + 0.0 * y[0], jnp.exp(-(((y[0] - 50.123) / width) ** 2)) / width])


@pytest.mark.parametrize("width", [0.5, 4.0])
def test_a_bump_far_ahead_is_not_jumped_over(width):
    found, error = end_of(bump(width), [0.0, 0.0], 100.0)
    assert found[1] == pytest.approx(np.sqrt(np.pi), rel=1e-13) and error < 1e-12


def test_gates_open():
    gate = lambda t, y: jnp.stack([1.0 + 0.0 * y[0], 1.0 / (1.0 + jnp.exp((50.0 - y[0]) / 0.1))])  # noqa: E731
    found, _ = end_of(gate, [0.0, 0.0], 100.0)
    assert found[1] == pytest.approx(50.0, rel=1e-13)


def test_a_narrow_bump_within_natural_steps():
    field = lambda t, y: jnp.stack([y[1], -y[0], jnp.exp(-(((y[0] - 0.5) / 0.03) ** 2))])  # noqa: E731
    found, _ = end_of(field, [0.0, 1.0, 0.0], 2.0 * np.pi)
    parts = [(0.0, 0.5), (0.5, 0.55), (0.55, 1.0), (1.0, 2.6), (2.6, 2.65), (2.65, 2 * np.pi)]
    wanted = sum(quad(lambda t: np.exp(-(((np.sin(t) - 0.5) / 0.03) ** 2)), *part, epsabs=1e-14)[0] for part in parts)
    assert found[2] == pytest.approx(wanted, rel=1e-11)


def test_without_the_bound_it_is_jumped_over(monkeypatch):
    monkeypatch.setattr(kernel_series, "MAX_EXPONENT_CHANGE", np.inf)
    kernels.python_kernel.cache_clear()
    monkeypatch.setattr(advancing, "choose_kernel", lambda *_: kernels.python_kernel(1))
    found, error = end_of(bump(0.5), [0.0, 0.0], 100.0)
    kernels.python_kernel.cache_clear()
    assert abs(found[1]) < 1e-10 and error < 1e-10


@pytest.mark.long
def test_drag_brings_a_body_to_rest_and_a_torque_takes_it_on():
    """I ω̇ = −c ω|ω| − τ from ω = 1: ω = tan(π/4 − t/3) up to rest at t = 3π/4, then −tanh((t − 3π/4)/3)."""
    body = spacecraft.RigidBody((1.0, 2.0, 3.0), torques=[spacecraft.QuadraticDrag(1.0),
                                                       spacecraft.ConstantTorque((0.0, 0.0, -1.0))])  # fmt: skip
    run = ph.simulate(body, body.pack(angular_velocity=(0.0, 0.0, 1.0)), [0.0, 4.0])
    assert run.momentum[-1, 2] / 3.0 == pytest.approx(-np.tanh((4.0 - 0.75 * np.pi) / 3.0), abs=1e-10)


@pytest.mark.parametrize("by_arrays", [False, True])
def test_sines_that_cancel_in_a_smooth_motion(by_arrays, monkeypatch):
    """θ̈ = −½ w² sin 2(θ − t), by sines of θ and of t: φ = θ − t librates, sin φ = k cd(wt, k). It was off by 1 rad."""
    if by_arrays:
        monkeypatch.setattr(_series, "LIMITS", _series.LIMITS._replace(max_operations=0))
    w, times = 0.2, np.array([0.0, 20.0, 62.8])

    def field(t, y):
        (s, c), (s_t, c_t) = ((jnp.sin(2.0 * x), jnp.cos(2.0 * x)) for x in (y[1], y[0]))
        return jnp.stack([1.0 + 0.0 * y[0], y[2], -0.5 * w**2 * (s * c_t - c * s_t)])

    found = ph.simulate(OwnField(field), [0.0, 0.02, 1.0], times)
    k = mpmath.sin(0.02)
    wanted = [float(mpmath.asin(k * mpmath.ellipfun("cd", w * t, m=k**2))) for t in times]
    error = np.abs(found.states[:, 1] - times - wanted).max()
    assert error < (2e-11 if by_arrays else 1e-13) and error / 62.8 < 30.0 * found.error_estimate < 1e-8
