"""Motions by Taylor series, against closed forms, other integrators and quadrature; events, jumps, refusals."""

from typing import Any

import diffrax
import jax.numpy as jnp
import numpy as np
import pytest

import polhode as ph
from polhode import fields, spacecraft, systems
from polhode.errors import InvalidInput, NotConverged
from polhode.integrators import Taylor
from polhode.integrators._series import check_sizes
from polhode.taylor.expressions import Untraceable
from polhode.taylor.machine import build_machine
from polhode.testing.systems import _draw_states
from specimens import SYSTEMS, named

MOMENTS = (1.0, 2.0, 3.5)
START = np.array([1.0, 0.0, 0.0, 0.0, 0.3, 2.0, 0.1])
BODY = systems.FreeRigidBody(MOMENTS)
BY_PACK = (fields.SphereVortices, fields.PlaneVortices, fields.VlasovPoisson)
AT_ONCE = (systems.BrunBody, systems.Gyrostat, fields.Toda, systems.LiePoisson)


def moves(system):
    """Some at once; those whose states cannot be drawn at random have tests of their own."""
    return pytest.param(system, marks=[] if type(system) in AT_ONCE else [pytest.mark.sweep])


@pytest.mark.long_after(2)
@pytest.mark.long_cases("BrunBody on SE3", "LiePoisson on SU(3)0", "Toda on Bidiagonal(4)", "LiePoisson on SU(3)1")
@pytest.mark.parametrize("system", [moves(s) for s in SYSTEMS if not isinstance(s, BY_PACK)], ids=named)
def test_every_system_moves_as_by_runge_kutta(system):
    """Energy, Casimirs and integrals stay within two roundings; the other integrator's own error is 1e-13 a step."""
    start = np.asarray(_draw_states(system, 0, 1.0)[0])[0]
    times = np.linspace(0.0, 2.0, 3)
    ours = ph.simulate(system, start, times, Taylor)
    theirs = ph.simulate(system, start, times, diffrax.Dopri8(), tolerance=1e-13, estimate_error=False)
    assert np.abs(ours.states - theirs.states).max() < 1e-12 * np.abs(theirs.states).max()
    drift = {k: v for k, v in ours.drift.items() if "space" not in k}
    assert max((np.max(v) for v in drift.values()), default=0.0) < 2e-15
    assert ours.error_estimate < 1e-13


VORTICES = fields.PlaneVortices((1.0, -0.7, 0.4))
BALL = fields.SphereVortices((1.0, -0.7, 0.4))


@pytest.mark.long
@pytest.mark.parametrize(("system", "start"), [
    (VORTICES, VORTICES.pack(jnp.array([[0.0, 0.0], [1.0, 0.2], [-0.3, 0.9]]))),
    (BALL, BALL.pack(jnp.array([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.6, 0.8]]))),
], ids=["plane vortices", "vortices on a sphere"])  # fmt: skip
def test_systems_with_powers(system, start):
    times = np.linspace(0.0, 3.0, 4)
    ours = ph.simulate(system, start, times, Taylor)
    theirs = ph.simulate(system, start, times, diffrax.Dopri8(), tolerance=1e-13, estimate_error=False)
    assert np.abs(ours.states - theirs.states).max() < 1e-11 * np.abs(theirs.states).max()


@pytest.mark.parametrize("times", [np.linspace(0.0, 20.0, 9), np.linspace(3.0, -5.0, 5)], ids=["on", "back"])
def test_the_free_body_is_that_of_the_closed_form(times):
    found = ph.simulate(BODY, START, times, Taylor)
    attitude, momentum = ph.FreeMotion(MOMENTS, momentum=START[4:], epoch=times[0]).state(times)
    assert np.abs(found.attitude - attitude).max() < 1e-13 and np.abs(found.momentum - momentum).max() < 1e-13
    assert found.drift["energy"] < 1e-15 and found.drift["|L|²"] < 1e-15


@pytest.mark.long
def test_a_symmetric_top_is_that_of_elliptic_functions():
    moments, mgl, momentum = (1.0, 1.0, 0.5), 1.3, (0.4, 0.0, 2.0)
    attitude = np.array([np.cos(0.4), np.sin(0.4), 0.0, 0.0])
    top = systems.HeavyTop(moments, mgl, (0.0, 0.0, 1.0))
    start = top.pack(attitude=attitude, angular_velocity=np.array(momentum) / moments)
    times = np.linspace(0.0, 8.0, 4)
    found = ph.simulate(top, start, times, Taylor)
    wanted = ph.LagrangeMotion(moments, mgl=mgl, momentum=momentum, attitude=attitude).attitude(times)
    assert np.abs(found.attitude - wanted).max() < 1e-12
    assert max(np.max(v) for k, v in found.drift.items() if "space" not in k) < 1e-15


@pytest.mark.long
def test_samples_change_nothing_and_copies_are_as_one_alone():
    few = ph.simulate(BODY, START, [0.0, 4.0], Taylor)
    many = ph.simulate(BODY, START, np.linspace(0.0, 4.0, 301), Taylor)
    assert (few.states[-1] == many.states[-1]).all() and few.statistics == many.statistics
    saved = ph.simulate(BODY, START, np.linspace(0.0, 4.0, 301), Taylor, save=7)
    assert (saved.states == many.states[::7]).all()
    start = np.stack([START, START * [1, 1, 1, 1, 2, 0.5, -3], START])
    batch = ph.simulate(BODY, start.reshape(3, 1, 7), [0.0, 4.0], Taylor)
    assert batch.states.shape == (3, 1, 2, 7) and batch.error_estimate.shape == (3, 1)
    alone = ph.simulate(BODY, start[1], [0.0, 4.0], Taylor)
    assert (batch.states[0, 0] == few.states).all() and (batch.states[1, 0] == alone.states).all()
    assert batch.error_estimate[1, 0] == alone.error_estimate


@pytest.mark.parametrize("tolerance", [1e-4, 1e-8, 1e-13])
def test_a_tolerance_is_of_the_error(tolerance):
    times = np.linspace(0.0, 6.0, 4)
    found = ph.simulate(BODY, START, times, Taylor, tolerance=tolerance)
    truth = ph.FreeMotion(MOMENTS, momentum=START[4:]).state(times)
    error = max(np.abs(found.attitude - truth[0]).max(), np.abs(found.momentum - truth[1]).max() / 2.0)
    assert error <= found.error_estimate <= tolerance


def test_a_tolerance_below_rounding_is_not_met():
    with pytest.raises(NotConverged, match=r"`tolerance` 3e-16 could not be met: .* rounding or chaos"):
        ph.simulate(BODY, START, [0.0, 1.0], Taylor, tolerance=3e-16)


# ---------------------------------------------------------------------- events and jumps


def watched(level):
    """Return a body whose motion ends when the second component of its momentum has fallen to a level."""

    class Watched(systems.FreeRigidBody):
        @property
        def events(self):
            fallen = lambda t, state: state[..., 5] - level  # noqa: E731
            return {"turned over": fallen, "never": lambda t, state: state[..., 0] + 2.0}

    return Watched(MOMENTS)


@pytest.mark.long
@pytest.mark.parametrize("level", [0.0, 1.3, -1.9])
@pytest.mark.parametrize("forth", [1.0, -1.0])
def test_an_event_ends_the_motion_at_its_own_time(level, forth):
    body = watched(level)
    found = ph.simulate(body, START, forth * np.linspace(0.0, 40.0, 81), Taylor)
    assert str(found.outcome) == "turned over" and (found.states[:-1, 5] > level).all()
    exact = ph.FreeMotion(MOMENTS, momentum=START[4:]).momentum(found.times)
    assert exact[-1, 1] == pytest.approx(level, abs=1e-13) and np.abs(found.momentum - exact).max() < 1e-13
    theirs = ph.simulate(body, START, forth * np.linspace(0.0, 40.0, 81), diffrax.Dopri8())
    assert found.times[-1] == pytest.approx(theirs.times[-1], abs=1e-10)


class Falling(systems.AbstractSystem):
    """z̈ = −2 down to z = 0; another event never happens. Its series is a polynomial."""

    def vector_field(self, t, state):
        return jnp.stack([state[..., 1], -2.0 + 0.0 * state[..., 0]], axis=-1)

    def invariants(self, state):
        return {}

    @property
    def events(self):
        return {"ground": lambda t, state: state[..., 0], "ceiling": lambda t, state: 1.5 - state[..., 0]}


@pytest.mark.parametrize("last", [3.0, 1e12, 1e100, 1e300])
def test_an_event_is_found_however_late_the_last_time_is(last):
    """It was found at 1e69 s of 1e100, and never of 1e300: halves of the whole time do not come near to it."""
    found = ph.simulate(Falling(), [1.0, 1.0], [0.0, last], Taylor)
    assert str(found.outcome) == "ground" and found.times[-1] == pytest.approx((1 + 5**0.5) / 2, abs=1e-15)


@pytest.mark.long
def test_events_of_copies_and_one_that_never_happens():
    body = watched(1.0)
    starts = np.stack([START, START * [1, 1, 1, 1, 1, 0.75, 1], [1, 0, 0, 0, 0, 1.5, 0]])
    found = ph.simulate(body, starts, [0.0, 1.0, 40.0], Taylor)
    assert found.ends.event.tolist() == [0, 0, -1] and found.ends.time[2] == 40.0
    for k in range(2):
        exact = ph.FreeMotion(MOMENTS, momentum=starts[k, 4:]).momentum(found.ends.time[k])
        assert exact[1] == pytest.approx(1.0, abs=1e-13) and np.isinf(found.states[k, -1]).all()
    with pytest.raises(InvalidInput, match="at or past the event"):
        ph.simulate(body, START * [1, 1, 1, 1, 1, 0.4, 1], [0.0, 1.0], Taylor)


class Pulse(spacecraft.AbstractTorque):
    """A torque about the third axis that grows with time, on for a while."""

    start: Any
    end: Any

    @property
    def jumps(self):
        return jnp.stack([jnp.asarray(self.start), jnp.asarray(self.end)])

    def torque(self, t, attitude, angular_velocity, actuator=None):
        on = (t >= self.start) & (t < self.end)
        size = jnp.where(on, 0.5 * jnp.sin(t), 0.0)
        return size[..., None] * jnp.array([0.0, 0.0, 1.0]) + 0.0 * angular_velocity


@pytest.mark.long_cases("on")
@pytest.mark.parametrize("times", [[0.0, 2.5, 10.0], [10.0, 4.0, 0.0]], ids=["on", "back"])
def test_steps_end_where_a_torque_starts_and_ends(times):
    """∫ ½ sin t dt between the jumps, as the torque is about the axis of the spin."""
    body = spacecraft.RigidBody(MOMENTS, torques=[Pulse(3.0, 4.5)])
    found = ph.simulate(body, body.pack(angular_velocity=(0.0, 0.0, 1.0)), times, Taylor)
    gained = np.diff(found.momentum[:, 2]).sum()
    assert gained == pytest.approx(np.sign(times[-1] - times[0]) * 0.5 * (np.cos(3.0) - np.cos(4.5)), rel=1e-14)
    assert found.error_estimate < 1e-14 and max(v for v in found.drift.values()) < 1e-14


class Unnamed(spacecraft.AbstractTorque):
    """A pulse that nobody named, too short to be found by trying times."""

    def torque(self, t, attitude, angular_velocity, actuator=None):
        size = jnp.where((t >= 3.0) & (t < 3.0 + 1e-7), 0.5, 0.0)
        return size[..., None] * jnp.array([0.0, 0.0, 1.0]) + 0.0 * angular_velocity


def test_a_branch_on_the_time_without_a_jump_is_watched_and_not_lost():
    body = spacecraft.RigidBody(MOMENTS, torques=[Unnamed()])
    start = body.pack(angular_velocity=(0.0, 0.0, 1.0))
    found = ph.simulate(body, start, [0.0, 10.0], Taylor)
    assert np.diff(found.momentum[:, 2]) == pytest.approx(0.5e-7, rel=1e-7)
    both = spacecraft.RigidBody(MOMENTS, torques=[Pulse(3.0, 4.5), Pulse(6.0, 7.0)])
    build_machine(both, start, (4.6, 5.9))
    with pytest.raises(Untraceable, match="changes where no jump is named"):
        build_machine(both, start, (5.0, 9.0))


def test_balances_receive_what_is_lost():
    """With drag, and a body that spins about one axis: dω/dt = −c ω|ω| / I₃ is solved by ω₀ / (1 + c ω₀ t / I₃)."""
    body = spacecraft.RigidBody(MOMENTS, torques=[spacecraft.LinearDrag(0.2)])
    found = ph.simulate(body, body.pack(angular_velocity=(0.0, 0.0, 2.0)), np.linspace(0.0, 5.0, 6), Taylor)
    assert found.angular_velocity[:, 2] == pytest.approx(2.0 * np.exp(-0.2 * found.times / 3.5), rel=1e-14)
    lost = found.received["kinetic_energy"]
    assert lost == pytest.approx(-7.0 * (1.0 - np.exp(-0.4 * found.times / 3.5)), rel=1e-13, abs=1e-14)


@pytest.mark.parametrize("size", [1e-149, 1e-90, 1e60, 1e149])
def test_slow_and_fast_bodies_move_alike(size):
    """Coefficients of 1e±90 and their powers would vanish or overflow by a unit of time that does not fit them."""
    size = float(2.0 ** round(np.log2(size)))
    alike = ph.simulate(BODY, START[4:], [0.0, 5.0], Taylor)
    found = ph.simulate(BODY, size * START[4:], [0.0, 5.0 / size], Taylor)
    assert found.statistics == alike.statistics and np.abs(found.states / size - alike.states).max() < 1e-14


# ---------------------------------------------------------------------- refusals


@pytest.mark.parametrize("size", [1e-160, 1e160])
def test_states_whose_squares_vanish_or_overflow(size):
    with pytest.raises(InvalidInput, match="`state` must be of a size within 1e-150 to 1e"):
        ph.simulate(BODY, size * START[4:], [0.0, 5.0 / size], Taylor)


def test_sizes_and_orders_just_inside_are_taken():
    check_sizes(np.array([[1e-150], [1e150]]))
    for size in (0.99e-150, 1.01e150):
        with pytest.raises(InvalidInput, match="must be of a size within"):
            check_sizes(np.array([[size]]))
    assert [Taylor(order).order for order in (4, 60)] == [4, 60]


@pytest.mark.parametrize("order", [3, 61])
def test_orders_that_make_no_series(order):
    with pytest.raises(InvalidInput, match="`order` of Taylor must be from 4 to 60"):
        Taylor(order)


def test_what_has_no_recurrence_is_refused():
    steps = systems.LiePoisson(ph.algebra.SO3(), lambda m: jnp.sum(m**2 * jnp.round(m)))
    with pytest.raises(InvalidInput, match=r"LiePoisson cannot be moved by Taylor series: .* contain `round` of"):
        ph.simulate(steps, [0.3, 2.0, 0.0], [0.0, 1.0], Taylor)


def test_what_goes_with_other_methods_is_refused():
    with pytest.raises(InvalidInput, match="start over"):
        ph.simulate(BODY, START, [0.0, 1.0], Taylor, resumable=True)
    with pytest.raises(InvalidInput, match="already has one"):
        ph.simulate(BODY, START, [0.0, 1.0], Taylor(12), order=8)
    found = ph.simulate(BODY, START, [0.0, 1.0], Taylor, order=8, step=0.1)
    assert found.statistics["steps"] >= 10


class Blowing(systems.base.AbstractSystem):
    """dy/dt = y², which is infinite at t = 1/y₀."""

    def vector_field(self, t, state):
        return state**2

    def invariants(self, state):
        return {}


@pytest.mark.long
def test_a_singularity_is_said():
    with pytest.raises(NotConverged, match=r"Taylor could not hold its tolerance .* singularity"):
        ph.simulate(Blowing(), [1.0], [0.0, 2.0], Taylor)
    fine = ph.simulate(Blowing(), [1.0], [0.0, 0.5, 0.99], Taylor)
    assert fine.states[:, 0] == pytest.approx([1.0, 2.0, 100.0], rel=1e-12)
    kept = ph.simulate(Blowing(), [[1.0], [0.1]], [0.0, 0.5, 2.0], Taylor, throw=False)
    assert np.isinf(kept.states[0, -1, 0]) and kept.states[1, -1, 0] == pytest.approx(0.125, rel=1e-14)
