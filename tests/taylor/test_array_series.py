"""Series of whole arrays against power series of python-flint, and motions of fluids by other methods."""

import diffrax
import jax
import jax.numpy as jnp
import numpy as np
import pytest

import polhode as ph
from polhode import fields
from polhode.errors import InvalidInput
from polhode.integrators import IsospectralMidpoint, Taylor
from polhode.taylor import array_rules, array_series
from polhode.taylor.array_series import coefficients, run_arrays
from polhode.taylor.runs import choose_precision
from sweeping import first
from taylor.test_coefficients import OwnField, by_flint

ORDER, EPS = 16, 2.0**-52
A = np.array([[0.3, -0.7], [0.5, 0.2]])


def scanned(y):
    """Return running sums of 2 y_k by a loop of JAX's."""
    return jax.lax.scan(lambda s, x: (s + 2.0 * x, s + 2.0 * x), jnp.zeros(()), y)[1]


# fields for JAX, and the same for flint's series, of two components
FIELDS = {
    "products": (lambda t, y: jnp.stack([y[0] * y[1], y[0] ** 2 - y[1] ** 3]),
                 lambda t, y: [y[0] * y[1], y[0] * y[0] - y[1] * y[1] * y[1]]),
    "matrices": (lambda t, y: jnp.outer(y, y) @ (A @ y),
                 lambda t, y: [y[0] * (y[0] * (0.3 * y[0] - 0.7 * y[1]) + y[1] * (0.5 * y[0] + 0.2 * y[1])),
                               y[1] * (y[0] * (0.3 * y[0] - 0.7 * y[1]) + y[1] * (0.5 * y[0] + 0.2 * y[1]))]),
    "quotients": (lambda t, y: jnp.stack([1.0 / y[0], y[0] / (2.0 + y[1])]),
                  lambda t, y: [1 / y[0], y[0] / (2 + y[1])]),
    "powers": (lambda t, y: jnp.stack([y[0] ** -1.5 + jnp.sqrt(y[1]), jax.lax.rsqrt(y[0]) - y[1] ** -2]),
               lambda t, y: [1 / (y[0] * y[0].sqrt()) + y[1].sqrt(), y[0].rsqrt() - 1 / (y[1] * y[1])]),
    "functions": (lambda t, y: jnp.stack([jnp.exp(-y[0]) * jnp.sin(y[1]), jnp.log(3.0 + y[0]) + jnp.cos(y[1] * t)]),
                  lambda t, y: [(-y[0]).exp() * y[1].sin(), (3 + y[0]).log() + (y[1] * t).cos()]),
    "hyperbolic": (lambda t, y: jnp.stack([jnp.tanh(y[0] * y[1]), jnp.expm1(-y[0])]),
                   lambda t, y: [1 - 2 / ((2 * y[0] * y[1]).exp() + 1), (-y[0]).exp() - 1]),
    "loops": (lambda t, y: scanned(y) * y, lambda t, y: [2 * y[0] * y[0], (2 * y[0] + 2 * y[1]) * y[1]]),
}  # fmt: skip
START = [0.7, 1.3]


def of_arrays(field, start, t=0.4):
    return np.asarray(coefficients(OwnField(field), np.array(start), np.float64(t), np.float64(1.0), ORDER))


@pytest.mark.long_cases("a loop-products", "a loop-functions", "a loop-loops", "a loop-quotients")
@pytest.mark.long_cases(*(f"written out-{name}" for name in FIELDS if name != "products"))
@pytest.mark.parametrize("name", FIELDS)
@pytest.mark.parametrize("orders", ["a loop", "written out"])
def test_coefficients_are_those_of_power_series(orders, name, monkeypatch):
    if orders == "written out":
        given = array_series.LIMITS._replace(min_optimized_size=0, min_written_size=0)
        monkeypatch.setattr(array_series, "LIMITS", given)
    field, other = FIELDS[name]
    wanted = by_flint(other, START, 0.4, ORDER)
    assert np.abs(of_arrays(field, START) / wanted - 1.0).max() < 300.0 * EPS


@pytest.mark.parametrize(("size", "way"), [(2047, "_loop_thoroughly"), (2048, "_written_out")])
def test_orders_are_written_out_for_large_states_only(size, way, monkeypatch):
    """Writing them out takes XLA seconds, and makes steps of large matrices twice as quick."""
    def refuse(system, state, *others):
        raise AssertionError(way)

    monkeypatch.setattr(array_series, way, refuse)
    with pytest.raises(AssertionError, match=way):
        coefficients(OwnField(lambda t, y: -y), np.ones(size), np.float64(0.0), np.float64(1.0), 4)


def test_powers_of_zero_are_products():
    found = of_arrays(lambda t, y: jnp.stack([1.0 + 0.0 * y[0], y[0] ** 3]), [0.0, 0.0])
    assert (found[:5].T == [[0.0, 1.0, 0.0, 0.0, 0.0], [0.0, 0.0, 0.0, 0.0, 0.25]]).all()


@pytest.mark.long
def test_a_wrong_rule_is_noticed(monkeypatch):
    right = array_rules._product

    def wrong(equation, moving):
        return lambda given, own, k: [x * (1.0 + 1e-12 * k) for x in right(equation, moving)(given, own, k)]

    monkeypatch.setitem(array_rules.RULES, "mul", wrong)
    field, other = FIELDS["products"]
    anew = lambda t, y: field(t, y)  # noqa: E731  # so that nothing compiled before is taken
    assert np.abs(of_arrays(anew, START) / by_flint(other, START, 0.4, ORDER) - 1.0).max() > 1e-12


@pytest.mark.sweep
@pytest.mark.parametrize("make", first(1, [fields.SphereFluid, fields.SphereMHD]))
def test_fluids_move_as_by_the_midpoint_and_keep_more(make):
    system = make(7, 0.3)
    waves = {(2, 1): 0.3, (3, 0): 1.0, (4, 2): 0.2 - 0.4j}
    state = system.from_harmonics(waves) if make is fields.SphereFluid else system.from_harmonics({(2, 0): 0.4}, waves)
    times = np.linspace(0.0, 20.0, 5)
    found = ph.simulate(system, state, times)
    other = ph.simulate(system, state, times, IsospectralMidpoint, order=8, step=0.02, estimate_error=False)
    assert 5 * found.statistics["steps"] < other.statistics["steps"]
    assert np.abs(found.states - other.states).max() < 1e-10
    assert np.max(found.error_estimate) < (1e-12 if make is fields.SphereFluid else 5e-12)  # the field shears faster
    exact = {name: drift for name, drift in found.drift.items() if name != "energy"}
    assert found.drift["energy"] < 4e-15 and max(exact.values()) < 4e-15


@pytest.mark.sweep
def test_a_batch_has_the_bits_of_each_and_goes_backwards():
    fluid = fields.SphereFluid(5)
    states = np.stack([fluid.from_harmonics({(2, 1): x, (3, 2): 1.0}) for x in (0.3, 0.9)])
    times = np.array([0.0, 1.0, 5.0])
    found = ph.simulate(fluid, states, times, estimate_error=False)
    for k in range(2):
        assert (found.states[k] == ph.simulate(fluid, states[k], times, estimate_error=False).states).all()
    back = ph.simulate(fluid, found.states[:, -1], times[::-1], estimate_error=False)
    assert np.abs(back.states[:, -1] - states).max() < 1e-13


@pytest.mark.long
def test_what_cannot_go_on_says_so():
    fluid = fields.SphereFluid(5)
    states, times = np.stack([fluid.from_harmonics({(2, 1): 0.3, (3, 2): 1.0})] * 2), np.array([0.0, 0.25, 0.5])
    with pytest.raises(InvalidInput, match="goes with one state"):
        ph.simulate(fluid, states, times, resumable=True, estimate_error=False)
    half = ph.simulate(fluid, states[0], times, resumable=True, estimate_error=False)
    with pytest.raises(InvalidInput, match=r"a time, a state \(5, 5\) and a unit"):
        ph.simulate(fluid, states[0], times, memory=half.memory[:2], estimate_error=False)
    whole = ph.simulate(fluid, states[0], np.linspace(0.0, 1.0, 5), estimate_error=False)
    later = ph.simulate(fluid, half.states[-1], times + 0.5, memory=half.memory, estimate_error=False)
    assert (later.states[1:] == whole.states[3:]).all()


class Branching(fields.SphereFluid):
    """A fluid whose rates depend on which of two numbers is larger."""

    def vector_field(self, t, state):
        return super().vector_field(t, state) * jnp.maximum(jnp.real(state[0, 1]), 0.5)


@pytest.mark.sweep
def test_branches_go_by_series_of_single_numbers():
    fluid = Branching(5)
    state = fluid.from_harmonics({(2, 1): 0.3, (3, 2): 1.0})
    found = ph.simulate(fluid, state, np.array([0.0, 1.0]), Taylor)
    other = ph.simulate(fluid, state, np.array([0.0, 1.0]), diffrax.Dopri8(), tolerance=1e-10)
    assert np.abs(found.states - other.states).max() < 1e-8 * np.abs(found.states).max()


def bump(t, y):
    return jnp.stack([1.0 + 0.0 * y[0], jnp.exp(-(((y[0] - 50.123) / 2.0) ** 2))])


@pytest.mark.long_cases("written out")
@pytest.mark.parametrize("orders", ["a loop", "written out"])
def test_steps_end_before_hidden_changes(orders, monkeypatch):
    """A bump far ahead, whose coefficients cannot be seen, and a root whose argument has a double zero; see there."""
    if orders == "written out":
        given = array_series.LIMITS._replace(min_optimized_size=0, min_written_size=0)
        monkeypatch.setattr(array_series, "LIMITS", given)
    by = choose_precision(None)
    seen = run_arrays(OwnField(bump), np.zeros(2), np.array([0.0, 100.0]), by.order, by.reach)
    assert seen.states[-1, 1] == pytest.approx(2.0 * np.sqrt(np.pi), rel=1e-13)
    root = OwnField(lambda t, y: jnp.stack([0.0 * y[0] - 1.0, jnp.sqrt(y[0] ** 2)]))
    assert np.isnan(run_arrays(root, np.array([1.0, 0.0]), np.array([0.0, 2.0]), by.order, by.reach).end)
