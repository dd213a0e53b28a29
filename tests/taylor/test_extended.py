"""States with twice as many digits, against closed forms after many turns."""

import jax.numpy as jnp
import numpy as np
import pytest
from mpmath import mp, mpf

import polhode as ph
from polhode import celestial, systems
from polhode.errors import InvalidInput
from polhode.integrators import Taylor
from polhode.integrators._series import NoSeries
from polhode.taylor import advancing, kernels

EXTENDED = Taylor(precision="extended")
EPS = 2.0**-52
MOMENTS, MOMENTUM, LEVEL = (1.3, 1.3, 0.7), (0.3, 0.2, 2.0), 2.0**-0.5  # the top lies on its side, exactly


def top_at(last, method=EXTENDED):
    """Return a top's states by series, the estimated error, and those in closed form."""
    top = systems.HeavyTop(MOMENTS, 1.0, (0.0, 0.0, 1.0))
    start = np.concatenate([(LEVEL, LEVEL, 0.0, 0.0), MOMENTUM, (0.0, 1.0, 0.0)])
    found = ph.simulate(top, start, np.linspace(0.0, last, 5), method)
    exact = ph.LagrangeMotion(MOMENTS, mgl=1.0, momentum=MOMENTUM, attitude=(LEVEL, LEVEL, 0.0, 0.0)).state(found.times)
    return np.abs(found.states[:, :7] - np.concatenate(exact, axis=1)).max(), found.error_estimate


@pytest.mark.sweep
@pytest.mark.parametrize("last", [200.0, pytest.param(2e3, marks=pytest.mark.sweep)])
def test_a_top_is_exact_after_hundreds_of_turns(last):
    error, said = top_at(last)
    assert error <= 8.0 * EPS and said <= 8.0 * EPS


@pytest.mark.sweep
def test_a_top_is_exact_after_1e5_seconds():
    error, said = top_at(1e5)
    assert error < 1e-14 and error < 4.0 * said
    plain, _ = top_at(1e5, Taylor())
    assert 1e-13 < plain < 1e-9


@pytest.mark.long
def test_a_moment_off_in_its_last_digit_is_seen(monkeypatch):
    """So that no number computed of the moments can have been rounded to a double."""
    exact_for = advancing.exact_for
    monkeypatch.setattr(advancing, "exact_for", lambda program, numbers, orders: exact_for(
        program, np.where(numbers == MOMENTS[2], np.nextafter(MOMENTS[2], 1.0), numbers), orders))  # fmt: skip
    error, said = top_at(2e3)
    assert error > 20.0 * EPS > 2.0 * said


@pytest.mark.long
def test_free_bodies_and_copies_agree_with_closed_forms():
    moments, momenta = (1.0, 2.0, 3.0), np.array([[0.3, 1.8, 1.5], [0.9, 1.6, 0.3], [1e-3, 2.0, 2e-3]])
    found = ph.simulate(systems.FreeRigidBody(moments), momenta, np.array([0.0, 300.0, 1500.0]), EXTENDED)
    exact = ph.FreeMotion(moments, momentum=momenta[:, None]).momentum(found.times)
    assert np.abs(found.states - exact).max() < 8.0 * EPS and np.max(found.error_estimate) < 8.0 * EPS


class Kepler(systems.AbstractSystem):
    """A planet in a plane: powers of the distance that are halves of whole numbers."""

    def vector_field(self, t, state):
        place, velocity = state[:2], state[2:]
        return jnp.concatenate([velocity, -place * jnp.sum(place**2) ** -1.5])

    def invariants(self, state):
        return {}


@pytest.mark.long
def test_powers_keep_their_digits():
    """After 160 orbits of e = .5 a planet is where it was; 2π is no double, so that it is off by its way since."""
    start = np.array([0.5, 0.0, 0.0, 3.0**0.5])
    # a speed that is rounded has another period: 2π a^(3/2) with a from the vis-viva integral of the double itself
    with mp.workdps(40):
        a = 1 / (4 - mpf(start[3]) ** 2)
        period = 2 * mp.pi * a ** mpf(1.5)
        last = float(160 * period)
        late = float(mpf(last) - 160 * period)
    found = ph.simulate(Kepler(), start, np.array([0.0, last]), EXTENDED)
    after = start + late * np.array([0.0, start[3], -4.0, 0.0])
    assert np.abs(found.states[-1] - after).max() < 10.0 * EPS
    plain = ph.simulate(Kepler(), start, np.array([0.0, last]), Taylor())
    assert np.abs(plain.states[-1] - after).max() > 1e-13


@pytest.mark.long
def test_python_and_numba_give_the_same_bits(monkeypatch):
    found = []
    for made in (kernels.python_kernel, kernels.compile_kernel):
        use = made(kernels.EXTENDED)
        monkeypatch.setattr(advancing, "choose_kernel", lambda copies, extended=False, use=use: use)
        found.append(ph.simulate(Kepler(), np.array([0.5, 0.0, 0.0, 1.7]), np.linspace(0.0, 3.0, 4), EXTENDED).states)
    assert (found[0] == found[1]).all()


class Pendulum(systems.AbstractSystem):
    """A pendulum, or what is pulled by a power of the place."""

    power: float = 0.0

    def vector_field(self, t, state):
        pull = jnp.sin(state[0]) if self.power == 0.0 else state[0] ** self.power
        return jnp.stack([state[1], -pull])

    def invariants(self, state):
        return {}


@pytest.mark.long
def test_what_has_no_such_series_is_refused():
    start, times = np.array([0.1, 0.2]), np.array([0.0, 1.0])
    with pytest.raises(NoSeries, match=r"'sine', which has no recurrence.*Give `precision` \"double\""):
        ph.simulate(Pendulum(), start, times, EXTENDED)
    with pytest.raises(NoSeries, match=r"the power 1\.3, .*halves of whole numbers"):
        ph.simulate(Pendulum(1.3), start, times, EXTENDED)
    with pytest.raises(NoSeries, match="Kepler's equation, which has no recurrence with twice as many digits"):
        ph.simulate(celestial.SpinOrbit(0.3, 0.1), start, times, EXTENDED)
    with pytest.raises(InvalidInput, match="one of double, extended; got 'quad'"):
        Taylor(precision="quad")
    with pytest.raises(InvalidInput, match="is for `simulate`"):
        ph.solve(Pendulum(1.5), start, times, EXTENDED)


@pytest.mark.long
def test_numbers_in_formulas_have_all_digits():
    """Quotients by moments that a function encloses, as by those that a system has: 5e-12 off at t = 1e5 if rounded."""
    own = ph.systems.LiePoisson(ph.algebra.SO3(), lambda m: 0.5 * jnp.sum(m**2 / jnp.array([0.7, 1.1, 1.3])))
    start, times = [0.3, 1.8, 1.5], [0.0, 1e4]
    found = ph.simulate(own, start, times, Taylor(precision="extended"), estimate_error=False).states[-1]
    truth = ph.FreeMotion((0.7, 1.1, 1.3), momentum=start).momentum(times[-1])
    assert np.abs(found - truth).max() < 4e-15
    with pytest.raises(InvalidInput, match="'logarithm', which has no recurrence with twice as many digits"):
        ph.simulate(ph.systems.LiePoisson(ph.algebra.SO3(), lambda m: jnp.log(3.0) * m[2] ** 2), start, times,
                    Taylor(precision="extended"))  # fmt: skip
