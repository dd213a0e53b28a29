"""Errors said of motions whose steps something else than the series makes, and small changes through jumps of rates."""

import jax.numpy as jnp
import mpmath
import numpy as np
import pytest

import polhode as ph
from polhode.analysis import lyapunov, monodromy
from polhode.integrators import _series_comparison
from polhode.systems.variations import Variations
from polhode.taylor import runs, switching
from taylor.test_coefficients import OwnField

HONEST = 30.0


class WithJumps(ph.systems.FreeRigidBody):
    """A free body with named jumps where nothing jumps."""

    jumps = np.linspace(0.0, 60.0, 200)


@pytest.mark.parametrize(("kind", "step"), [(ph.systems.FreeRigidBody, 0.3), (WithJumps, None)])
def test_forced_steps_hide_no_growth_of_roundings(kind, step):
    """Beside the saddle roundings grow as e^(t/√3); both runs had the same steps, bits, and an error of 9e-16."""
    moments, start, t = (1.0, 2.0, 3.0), [1e-7, 2.0, 1e-8], 60.0
    found = ph.simulate(kind(moments), start, [0.0, t], step=step)
    exact = ph.FreeMotion(moments, momentum=start).momentum(t)
    error = np.abs(np.asarray(found.states[-1]) - exact).max() / 2.0
    assert 1e-13 < error < HONEST * found.error_estimate < 1e-4


def test_without_other_starts_and_roundings_they_do(monkeypatch):
    monkeypatch.setattr(_series_comparison, "starts_a_rounding_away", lambda system, state: [state, state])
    monkeypatch.setattr(runs, "KICKS", 0.0 * runs.KICKS)
    assert ph.simulate(WithJumps((1.0, 2.0, 3.0)), [1e-7, 2.0, 1e-8], [0.0, 60.0]).error_estimate < 1e-14


def bounce(start):
    """Return ẍ = −sign x from rest, as simulated to t = 100, and exactly."""
    found = ph.simulate(OwnField(lambda t, y: jnp.stack([y[1], -jnp.sign(y[0])])), [start, 0.0], [0.0, 100.0])
    with mpmath.workdps(40):
        q = mpmath.sqrt(2 * mpmath.mpf(start))  # a quarter of the period, and the largest rate
        t, sign = mpmath.fmod(100, 4 * q), 1
        if t > 2 * q:
            t, sign = t - 2 * q, -1
        place = start - t * t / 2 if t <= q else -(q * (t - q) - (t - q) ** 2 / 2)
        rate = -t if t <= q else -(2 * q - t)
        exact = [sign * place / start, sign * rate / q]
        got = [mpmath.mpf(float(x)) / size for x, size in zip(found.states[-1], (start, q), strict=True)]
        return float(max(abs(a - b) for a, b in zip(got, exact, strict=True))), float(found.error_estimate)


@pytest.mark.parametrize("start", [0.3, 0.77, 2.9])
def test_crossings_are_late_by_roundings_of_their_time(start):
    error, said = bounce(start)
    assert 1e-15 < error < HONEST * said < 1e-8


def switch(w):
    """Return ẏ = ±1 by the sign of sin wt, which is neither a branch on the state nor named: its error, and as said."""
    found = ph.simulate(OwnField(lambda t, y: jnp.where(jnp.sin(w * t) > 0.0, 1.0, -1.0) + 0.0 * y), [0.0],
                        [0.0, 100.0])  # fmt: skip
    with mpmath.workdps(40):
        half = mpmath.pi / mpmath.mpf(w)
        turns = int(mpmath.floor(100 / half))
        exact = (half - (100 - turns * half)) if turns % 2 else 100 - turns * half
        return float(abs(mpmath.mpf(float(found.states[-1, 0])) - exact) / half), float(found.error_estimate)


@pytest.mark.long_after(1)
@pytest.mark.parametrize("w", [1.37, 4.1, 7.3])
def test_switches_by_the_time_are_late_too(w):
    error, said = switch(w)
    assert 1e-15 < error < HONEST * said < 1e-10


@pytest.mark.long
def test_without_lateness_it_is_not_seen(monkeypatch):
    monkeypatch.setattr(switching, "ROUNDED", 0.0)
    assert any(error > HONEST * said for error, said in map(switch, (1.37, 4.1, 7.3)))


class Pulse(OwnField):
    """A pulse between two named times."""

    jumps = np.array([73.61096631681636, 73.61198863185763])


def test_a_named_pulse_is_exact():
    """Its found beginning lay a rounding beside the named one, and of ten thousandths of a second that was 1e-11."""
    begin, end = Pulse.jumps
    found = ph.simulate(Pulse(lambda t, y: jnp.where((t > begin) & (t < end), 1.0, 0.0) + 0.0 * y), [0.0], [0.0, 100.0])
    assert found.states[-1, 0] == end - begin


BOUNCING = OwnField(lambda t, y: jnp.stack([y[1], -jnp.sign(y[0])]))


def test_small_changes_jump_where_rates_do():
    """Through x = 0 at t = 1: x = ½ − t²/2, then x = −(t − 1) + (t − 1)²/2, differentiated by hand."""
    assert np.abs(monodromy(BOUNCING, [0.5, 0.0], (0.0, 2.0)) - [[-1.0, 0.0], [-2.0, -1.0]]).max() < 1e-14


def test_without_their_jump_they_are_wrong(monkeypatch):
    monkeypatch.setattr(Variations, "count_of_changes", 0)
    assert np.abs(monodromy(BOUNCING, [0.5, 0.0], (0.0, 2.0)) - [[-1.0, 0.0], [-2.0, -1.0]]).max() > 1.0


def sheets(t, y):
    """Return the rates of four sheets that attract each other with a force that does not depend on the distance."""
    x, v = y[:4], y[4:]
    above, below = (jnp.where(s * x[None] > s * x[:, None], 1.0, 0.0).sum(axis=1) for s in (1.0, -1.0))
    return jnp.concatenate([v, above - below])


@pytest.mark.long
def test_gravitating_sheets_are_chaotic():
    """They were called regular, as small changes did not jump; the matrix is that of difference quotients."""
    system, start = OwnField(sheets), np.random.default_rng(2).normal(size=8)
    start[:4] -= start[:4].mean()
    start[4:] -= start[4:].mean()
    matrix, h = monodromy(system, start, (0.0, 10.0)), 1e-6
    moved = [np.asarray(ph.simulate(system, start + kick, [0.0, 10.0]).states[-1])
             for e in np.eye(8) for kick in (h * e, -h * e)]  # fmt: skip
    slopes = (np.array(moved[::2]) - moved[1::2]).T / (2.0 * h)
    assert np.abs(matrix - slopes).max() < 1e-6 * np.abs(slopes).max()
    assert lyapunov(system, start, (0.0, 300.0), count=1).is_chaotic
