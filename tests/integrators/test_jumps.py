"""What acts between two steps: pulses that are named as jumps, pulses that are found, and what the estimate says."""

from typing import Any

import diffrax
import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np
import pytest

import polhode as ph
from polhode import systems
from polhode.errors import InvalidInput
from polhode.integrators import LieMidpoint, MuntheKaas
from polhode.integrators.probing import find_undeclared_jumps
from polhode.spacecraft import AbstractTorque, LaggedTorque, RigidBody, Wheel
from polhode.systems import AbstractSystem

MOMENTS = (1.0, 2.0, 3.0)
SPAN = np.array([0.0, 1000.0])


class Pulse(AbstractTorque):
    """A torque about the third axis, on for a while; ΔL = τ × width whatever the body does about that axis."""

    start: Any
    width: Any
    torque_then: Any
    named: bool = eqx.field(static=True, default=False)

    @property
    def jumps(self):
        return jnp.stack([self.start, self.start + self.width]) if self.named else ()

    def torque(self, t, attitude, angular_velocity, actuator=None):
        on = (t >= self.start) & (t < self.start + self.width)
        return jnp.where(on, self.torque_then, 0.0)[..., None] * jnp.array([0.0, 0.0, 1.0]) + 0.0 * angular_velocity


def gained(system: Any, rate: float, times: Any, **more: Any) -> Any:
    found = ph.simulate(system, system.pack(angular_velocity=(0.0, 0.0, rate)), times, **more)
    return found.momentum[-1, 2] - found.momentum[0, 2], found


class Gate(AbstractSystem):
    """ẏ is one between t = 5 and 6, with edges of some width."""

    width: float

    def vector_field(self, t, state):
        return 0.5 * (jnp.tanh((t - 5.0) / self.width) - jnp.tanh((t - 6.0) / self.width)) + 0.0 * state

    def invariants(self, state):
        return {}


@pytest.mark.long_cases("two samples-500.0-20.0-0.0", "two samples-500.3-0.02-0.0")
@pytest.mark.parametrize("rate", [0.0, 1e-3])
@pytest.mark.parametrize(("start", "width"), [(500.0, 20.0), (500.3, 0.02)])
@pytest.mark.parametrize("times", [SPAN, np.linspace(0.0, 1000.0, 1001)], ids=["two samples", "a sample a second"])
def test_a_pulse_nobody_named_is_found(start, width, rate, times):
    """0.5 N m for 20 s changed nothing, with an estimate of 1.9e-13; slow bodies ran into a singularity."""
    got, found = gained(RigidBody(MOMENTS, torques=[Pulse(start, width, 0.5)]), rate, times)
    assert got == pytest.approx(0.5 * width, rel=1e-9) and found.error_estimate < 1e-8


@pytest.mark.long
def test_a_pulse_narrower_than_any_trial_is_seen_by_series_and_by_others_once_it_is_named():
    start, width = 123.456, 1e-6
    unnamed = RigidBody(MOMENTS, torques=[Pulse(start, width, 0.5)])
    got, found = gained(unnamed, 1e-3, SPAN)
    assert got == pytest.approx(0.5e-6, rel=1e-6) and found.error_estimate < 1e-12
    got, _ = gained(unnamed, 1e-3, SPAN, method=diffrax.Dopri8())
    assert got == 0.0, "found without its name: take a narrower one"
    got, found = gained(RigidBody(MOMENTS, torques=[Pulse(start, width, 0.5, named=True)]), 1e-3, SPAN)
    # the time itself is rounded by 1e-14 s
    assert got == pytest.approx(0.5e-6, rel=1e-7) and found.error_estimate < 1e-12


@pytest.mark.long_cases("Dopri8-True", "Kvaerno5-True", "Kvaerno5-False")
@pytest.mark.parametrize("named", [True, False])
@pytest.mark.parametrize("method", [None, diffrax.Kvaerno5()], ids=["Dopri8", "Kvaerno5"])
def test_backwards_and_by_implicit_steps(named, method):
    system = RigidBody(MOMENTS, torques=[Pulse(50.0, 2.0, 0.5, named)])
    got, _ = gained(system, 1e-3, [100.0, 0.0], method=method, tolerance=1e-9)
    assert got == pytest.approx(-1.0, rel=1e-7)


@pytest.mark.long
def test_jumps_on_samples_and_beside_the_run_do_no_harm():
    torques = [Pulse(5.0, 5.0, 0.5, True), Pulse(-3.0, 1.0, 1.0, True), Pulse(10.0, 7.0, 1.0, True)]
    got, found = gained(RigidBody(MOMENTS, torques=torques), 0.1, np.linspace(0.0, 10.0, 11))
    assert got == pytest.approx(2.5, rel=1e-12) and len(found.times) == 11
    assert found.momentum[7, 2] - found.momentum[0, 2] == pytest.approx(1.0, rel=1e-12)


def test_a_smooth_pulse_is_found():
    class Bell(AbstractTorque):
        def torque(self, t, attitude, angular_velocity, actuator=None):
            size = 0.5 * jnp.exp(-0.5 * ((t - 333.0) / 0.3) ** 2)
            return size[..., None] * jnp.array([0.0, 0.0, 1.0]) + 0.0 * angular_velocity

    got, _ = gained(RigidBody(MOMENTS, torques=[Bell()]), 0.0, SPAN)
    assert got == pytest.approx(0.5 * 0.3 * np.sqrt(2.0 * np.pi), rel=1e-9)


def test_a_gate_that_fades_is_not_made_of_jumps():
    """Its changes pass through the least that counts, slowly: 893 steps were ended at false jumps, 9914 to t = 4."""
    gate = Gate(0.1)
    for end in (4.0, 10.0):
        assert len(find_undeclared_jumps(gate, jnp.zeros(1), np.array([0.0, end]))) < 20
    found = ph.simulate(gate, [0.0], [0.0, 10.0])
    assert found.statistics["steps"] < 150 and abs(found.states[-1, 0] - 1.0) < 1e-14


class Ripple(AbstractSystem):
    """ẏ is one, and a little more in every second of many short intervals."""

    def vector_field(self, t, state):
        return 1.0 + 1e-8 * (jnp.sin(97.3 * t) > 0.0) + 0.0 * state

    def invariants(self, state):
        return {}


def test_many_small_switches_are_not_taken_for_rounding():
    found = find_undeclared_jumps(Ripple(), jnp.zeros(1), np.array([0.0, 10.0]))
    true = np.pi / 97.3 * np.arange(1, int(973.0 / np.pi) + 1)
    assert len(true) > 300 and np.abs(found[:, None] - true).min(axis=0).max() < 1e-12


def test_what_switches_as_often_as_times_are_tried_is_seen():
    """At equal trials, 1 ms apart, it was always off, and nothing was known of it."""

    class Modulated(AbstractTorque):
        def torque(self, t, attitude, angular_velocity, actuator=None):
            phase = jnp.mod(1000.0 * t, 1.0)
            on = jnp.where((phase >= 0.1) & (phase < 0.2), 0.5, 0.0)
            return on[..., None] * jnp.array([0.0, 0.0, 1.0]) + 0.0 * angular_velocity

    system = RigidBody(MOMENTS, torques=[Modulated()])
    with pytest.warns(UserWarning, match="switch at least"):
        find_undeclared_jumps(system, system.pack(), np.array([0.0, 131.072]))


@pytest.mark.long
def test_what_shows_only_along_the_motion_is_found_there():
    """A brake that acts for 20 s, on a body that another pulse sets turning: at the start it is nothing."""

    class Brake(AbstractTorque):
        def torque(self, t, attitude, angular_velocity, actuator=None):
            return -jnp.where((t >= 700.0) & (t < 720.0), 0.3, 0.0)[..., None] * angular_velocity

    system = RigidBody(MOMENTS, torques=[Pulse(100.0, 2.0, 0.5), Brake()])
    got, _ = gained(system, 0.0, np.linspace(0.0, 1000.0, 11))
    assert got == pytest.approx(np.exp(-0.3 * 20.0 / 3.0), rel=1e-9)


def on(t):
    return jnp.where((t >= 400.0) & (t < 400.001), 2.0, 0.0)


@pytest.mark.long
def test_a_motor_names_its_jumps(stepper):
    wheel = Wheel((0.0, 0.0, 1.0), 0.1, motor=lambda t, *more: on(t), jumps=[400.0, 400.001])
    system = RigidBody(MOMENTS, mounts=[wheel])
    found = ph.simulate(system, system.pack(angular_velocity=(0.0, 0.0, 0.0)), SPAN, stepper)
    assert found.angular_velocity[-1, 2] == pytest.approx(-0.002 / 2.9, rel=1e-6)


@pytest.mark.long
def test_an_actuator_names_its_jumps():
    command = lambda t, attitude, velocity: on(t)[..., None] * jnp.array([0.0, 0.0, 1.0]) + 0.0 * velocity  # noqa: E731
    system = RigidBody(MOMENTS, torques=[LaggedTorque(command, 0.5, jumps=[400.0, 400.001])])
    got, _ = gained(system, 0.0, SPAN)
    assert got == pytest.approx(0.002, rel=1e-6)


PUSHED = RigidBody(MOMENTS, torques=[Pulse(jnp.asarray(500.3), jnp.asarray(1.0), 0.5, True)])


def last(width, rate):
    """Return what a pulse of this width adds to the momentum of a body of this rate, by ``solve``."""
    system = eqx.tree_at(lambda b: b.torques[0].width, PUSHED, width)
    return ph.solve(system, jnp.array([0.0, 0.0, 3.0 * rate]), SPAN).end_state[2] - 3.0 * rate


@pytest.mark.sweep
def test_derivatives_of_reverse_mode_by_the_width():
    assert float(jax.grad(last)(1.0, 1e-3)) == pytest.approx(0.5, rel=1e-6)


@pytest.mark.sweep
def test_transformations():
    """ΔL = τ × width by ``solve`` under jit and vmap, with the derivative by the width."""
    widths, rates = jnp.array([0.02, 1.0, 1e-4]), jnp.array([0.0, 1e-3, 0.1])
    got = jax.jit(jax.vmap(last))(widths, rates)
    np.testing.assert_allclose(got, 0.5 * widths, rtol=1e-7)
    assert float(jax.jacfwd(last)(1.0, 1e-3)) == pytest.approx(0.5, rel=1e-6)


@pytest.mark.long
def test_a_batch(stepper):
    system = RigidBody(MOMENTS, torques=[Pulse(500.3, 0.02, 0.5)])
    many = system.pack(angular_velocity=jnp.array([[0.0, 0.0, 0.0], [0.0, 0.0, 0.1]]))
    found = ph.simulate(system, many, SPAN, stepper)
    np.testing.assert_allclose(found.momentum[:, -1, 2] - found.momentum[:, 0, 2], 0.01, rtol=1e-7)


class Turned(systems.FreeRigidBody):
    """A ball that is turned about its third axis from outside for a while, whatever its momentum does."""

    named: bool = eqx.field(static=True, default=False)

    @property
    def jumps(self):
        return jnp.array([50.3, 50.7]) if self.named else ()

    def generator(self, t, point):
        on = jnp.where((t >= 50.3) & (t < 50.7), 2.0, 0.0)
        return super().generator(t, point) + on * jnp.array([0.0, 0.0, 1.0])

    @property
    def conserves_energy(self):
        return False


@pytest.mark.sweep
@pytest.mark.parametrize("method", [LieMidpoint, MuntheKaas])
def test_methods_along_the_orbit_stop_at_jumps(method):
    """A ball's momentum is turned by rate × width, −0.8 rad, to the method's own error."""
    kind: Any = Turned
    system = kind((2.0, 2.0, 2.0))
    named = eqx.tree_at(lambda s: s.moments, kind((2.0, 2.0, 2.0)), system.moments)
    object.__setattr__(named, "named", True)
    start, exact = np.array([1e-3, 0.0, 0.0]), 1e-3 * np.array([np.cos(0.8), -np.sin(0.8), 0.0])
    for times in ([0.0, 100.0], [100.0, 0.0]):
        found = ph.simulate(named, start, times, method)
        wanted = exact * np.sign([1.0, times[1] - times[0], 1.0])
        assert np.abs(found.states[-1] - wanted).max() < 1e-9 * 1e-3
        assert np.abs(ph.solve(named, start, times, method).end_state - wanted).max() < 1e-9 * 1e-3
    # not named, it is found; stages may look across, which the estimate tells
    found = ph.simulate(system, start, [0.0, 100.0], method)
    off = np.abs(found.states[-1] - exact).max() / 1e-3
    assert off < 0.1 and off < 30.0 * found.error_estimate and len(found.times) == 2


def test_bad_jumps_are_refused():
    with pytest.raises(InvalidInput, match="`jumps` must be a list of finite times"):
        Wheel((0.0, 0.0, 1.0), 0.1, jumps=[np.nan])
    with pytest.raises(InvalidInput, match="`jumps` must be finite numbers"):
        gained(RigidBody(MOMENTS, torques=[Pulse(np.inf, 1.0, 0.5, True)]), 0.0, SPAN)


class Brake(AbstractTorque):
    """Nothing for what rests."""

    def torque(self, t, attitude, angular_velocity, actuator=None):
        return -jnp.where((t >= 633.3) & (t < 633.315), 3.0, 0.0)[..., None] * angular_velocity


@pytest.mark.long_cases("by adaptive steps")
def test_a_pulse_that_only_another_copy_feels_is_found(stepper):
    """The first copy rests, and was the only one that was tried: 3.0 stayed 3.0, told 0.0."""
    system = RigidBody(MOMENTS, torques=[Brake()])
    start = system.pack(angular_velocity=np.array([[0.0, 0.0, 0.0], [0.0, 0.0, 1.0]]))
    found = ph.simulate(system, start, SPAN, stepper)
    np.testing.assert_allclose(found.momentum[:, -1, 2], [0.0, 3.0 * np.exp(-0.015)], rtol=1e-9)


class Switched(AbstractTorque):
    """On for a part of each period."""

    frequency: float

    def torque(self, t, attitude, angular_velocity, actuator=None):
        on = jnp.mod(t * self.frequency, 1.0) < 0.3
        return jnp.where(on, 5e-4, 0.0)[..., None] * jnp.array([0.0, 0.0, 1.0]) + 0.0 * angular_velocity


def test_it_is_said_where_rates_switch_too_often():
    """17,000 switchings in 100 s were all thrown away without a word, with an error of 20 %."""
    system = RigidBody(MOMENTS, torques=[Switched(85.0)])
    with pytest.warns(UserWarning, match=r"switch at least 17\d+ times .* Give `step=` shorter"):
        find_undeclared_jumps(system, system.pack(angular_velocity=(0.0, 0.0, 0.0)), np.array([0.0, 100.0]))


@pytest.mark.long
def test_a_pulse_that_nobody_met_leaves_a_doubt():
    """The estimate was exactly 0.0, which would say that the motion is exact."""
    _, found = gained(RigidBody(MOMENTS, torques=[Pulse(123.456, 1e-6, 0.5)]), 0.0, SPAN)
    assert found.error_estimate > 0.0


@pytest.mark.parametrize("kind", ["a field", "of the class"])
def test_jumps_may_be_a_field_or_of_the_class(kind):
    """Those that are found join them, where there was only a way for properties."""

    class Late(ph.systems.AbstractSystem):
        def vector_field(self, t, state):
            return jnp.where((t > 901.0) & (t < 901.25), 1.0, 0.0) + 0.0 * state

        def invariants(self, state):
            return {}

    class Field(Late):
        jumps: object = None

    class OfClass(Late):
        jumps = np.array([901.0])

    system = Field(np.array([901.0])) if kind == "a field" else OfClass()
    found = ph.simulate(system, [0.0], [0.0, 1000.0])
    # the time of the jump that is found is known to a rounding, and so is what comes of it
    assert found.states[-1, 0] == pytest.approx(0.25, rel=2e-12) and found.error_estimate > 1e-14
