"""The end of a spinning disk: the finite-time singularity of its tilt, and the event that preempts it.

The tilt would vanish as (t0 − t)^n with the rate of precession growing as (t0 − t)^(−n/2) without bound. In time itself
no solver gets near: steps shrink to nothing, and t0 − t is a difference of almost equal numbers. Here the clock runs by
dt = (3V/2P) dλ with the potential energy V and the power P, so that V ∝ e^(−λ) on the slow manifold: t0 lies at
infinity, and equal steps of λ are equal steps of log(t0 − t). Time is counted again in each of them and summed from the
end, so that t0 − t keeps its relative accuracy. (The total energy would be no such clock: it tends to the energy of
the spin.)
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import NamedTuple

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np

from polhode._base import check
from polhode._base.arrays import known_numbers_only
from polhode.errors import InvalidInput, NotConverged
from polhode.integrators import _diffrax as diffrax
from polhode.integrators import _embedded as embedded
from polhode.integrators._adaptive import TOLERANCE, solve_adaptively
from polhode.motion._outcome import Ending, Outcome, Status
from polhode.motion._trajectory import Trajectory
from polhode.rolling.euler_disk._power_law import PowerLaw, Singularity, fit_singularity, power_law
from polhode.rolling.euler_disk.dissipation import RollingDissipation
from polhode.rolling.euler_disk.system import LAYOUT, EulerDisk, rolling_parts
from polhode.systems.trajectories import make_trajectory
from polhode.types import Array, ArrayLike, Float64, Real

END_OF_REGIME = "end of asymptotic regime"
FALL_SAMPLES = 32
TILT = LAYOUT.place("tilt")
ANGLES, CONTACT, RATES = (
    slice(LAYOUT.place(first).start, LAYOUT.place(last).stop)
    for first, last in (("heading", "face"), ("contact_x", "contact_y"), ("tilt_rate", "spin"))
)


class SpinDownLimits(NamedTuple):
    """What decides how far a motion is followed and which samples are fitted."""

    asymptotic_adiabaticity: float = 0.3  # |θ̇|/(θ|φ̇|); beyond it the tilt falls as fast as the disk goes round
    fitted_adiabaticity: float = 0.02  # of samples that are fitted, at most
    dominant_share: float = 0.8  # of the power; a law that takes less does not alone set the exponents
    min_samples: int = 8  # of a fit
    fall_time: float = 20.0  # √(a/g); a disk that has left the asymptotic regime lies flat or has taken off sooner
    steps_per_radian: float = 4.0  # of precession, by Dopri8 at its tolerance, as measured


LIMITS = SpinDownLimits()


@dataclass(frozen=True, eq=False)
class SpinDown:
    """The end of a disk's motion.

    Attributes:
        trajectory: all samples [s from the start], with states, attitude, energy and the energy received.
        remaining: (T,) t0 − t [s], not by subtraction; negative from the asymptotic t0 on. None without a finite t0.
        adiabaticity: (T,) |θ̇|/(θ|φ̇|).
        end: asymptotic t0 [s from the start], None if the motion has no finite one.
        end_uncertainty: [s].
        tilt: fit of α ∝ (t0 − t)^n over the samples with an adiabaticity below 0.02, those at the end where one law
            takes four fifths of the power if there are as many as eight; without a finite t0 of α ∝ t^n.
        precession: likewise of Ω, −n/2 in theory where the centre is at rest.
        precession_by_tilt: fit of Ω ∝ α^k, −1/2 in theory where the centre is at rest. A thick disk's is not: the spin
            that losses leave it holds a part of the weight.
        unspun_by_tilt: likewise without the spin's part, −1/2 in theory for every disk and law.
        fitted: the samples that were fitted, consecutive.
        events: name → time [s from the start], in order: "end of asymptotic regime", "flat", "lift-off", "on edge".
            Empty if the tilt fell by the given decades, or took the given number of steps, before any of them.
        energy_balance: largest |E(t) + dissipated − E(0)| / E(0).
    """

    trajectory: Trajectory
    remaining: Float64[Array, "time"] | None
    adiabaticity: Float64[Array, "time"]
    end: float | None
    end_uncertainty: float | None
    tilt: PowerLaw
    precession: PowerLaw
    precession_by_tilt: PowerLaw
    unspun_by_tilt: PowerLaw
    fitted: slice
    events: dict[str, float]
    energy_balance: float

    @property
    def late(self) -> slice:
        """The second half of the samples fitted, whose exponents are given."""
        return slice(self.fitted.start + self.tilt.samples // 2, self.fitted.start + self.tilt.samples)

    @property
    def first_event(self) -> str | None:
        """Name of the first event."""
        return next(iter(self.events), None)


@known_numbers_only
def spin_down(
    disk: EulerDisk,
    state: Real[ArrayLike, "8"],
    decades: float = 4.0,
    samples_per_decade: int = 32,
    most_steps: int = 1_000_000,
) -> SpinDown:
    """Follow a disk to its end.

    The full equations are integrated by the clock λ as long as the motion is asymptotic, then in time, until the disk
    lies flat or takes off.

    Args:
        disk: with at least one law of dissipation.
        state: (8,), as of ``disk.rolling_state``; elsewhere than on the slow manifold it nutates.
        decades: of the tilt over which to follow it, at most.
        samples_per_decade: of the tilt.
        most_steps: to stop after, where weak dissipation lets the disk go round for ever.

    Raises:
        InvalidInput: for a disk without dissipation, or a start that is not in the asymptotic regime.
        NotConverged: if the dissipation comes to an end before the motion does.

    >>> from polhode.rolling import EulerDisk, ViscousContourFriction
    >>> disk = EulerDisk(mass=0.4, radius=0.04, dissipation=[ViscousContourFriction(2e-7)])
    >>> fit = spin_down(disk, disk.rolling_state(tilt=0.05))
    >>> print(f"{fit.tilt.exponent:.3f}", list(fit.events))
    0.500 ['end of asymptotic regime', 'flat']

    Source: Moffatt, Nature 404 (2000) 833; Leine, Arch. Appl. Mech. 79 (2009) 1063, for the exponents.
    """
    start = _check_start(disk, state, decades, samples_per_decade)
    run = _Run([start], [0.0], [0.0], 0)
    over = _asymptotic(disk, run, decades, samples_per_decade, most_steps)
    regular = len(run.states)
    events: dict[str, float] = {}
    if over:
        events[_name_end(disk, run.states[-1])] = math.fsum(run.spans)
    if END_OF_REGIME in events:
        last = _fall(disk, run)
        if last is not None:
            events[last] = math.fsum(run.spans)
    states = jnp.asarray(np.stack([np.asarray(state) for state in run.states]))
    received = {"energy": -np.cumsum(run.lost)}
    last = next(reversed(events), None)
    outcome = Outcome(Ending.COMPLETED) if last is None else Outcome(Ending.EVENT, last)
    trajectory = make_trajectory(disk, np.cumsum(run.spans), states, outcome, {"steps": run.steps}, received)
    ratio, rate = (np.asarray(x) for x in _pace(disk, states))
    fitted = _ruled_by_one(_choose_samples(ratio[:regular]), np.asarray(disk.powers(states)))
    tilt, unspun = np.asarray(trajectory.part("tilt")), _unspun(disk, states[fitted])
    spans = np.asarray(run.spans)
    singularity = fit_singularity(spans[fitted][1:], tilt[fitted])
    distance = _distances(spans, fitted, singularity)
    finite = singularity.law.exponent > 0.0
    return SpinDown(
        trajectory=trajectory,
        remaining=distance if finite else None,
        adiabaticity=ratio,
        end=math.fsum([*spans[: fitted.stop], singularity.distance]) if finite else None,
        end_uncertainty=singularity.uncertainty if finite else None,
        tilt=singularity.law,
        precession=power_law(distance[fitted], rate[fitted]),
        precession_by_tilt=power_law(tilt[fitted], rate[fitted]),
        unspun_by_tilt=power_law(tilt[fitted], unspun),
        fitted=fitted,
        events=events,
        energy_balance=float(trajectory.drift["energy"]),
    )


class SpinDownExponents(NamedTuple):
    """Exponents of tilt and precession by the time left, and of the precession by the tilt."""

    tilt: float
    precession: float
    precession_by_tilt: float


def predicted_exponents(law: RollingDissipation) -> SpinDownExponents:
    """Return the exponents of a thin disk that one law alone slows down: n, −n/2 and −1/2, as Ω ∝ α^(−1/2).

    Source: Leine, Arch. Appl. Mech. 79 (2009) 1063, §4.

    >>> from polhode.rolling import ViscousContourFriction
    >>> predicted_exponents(ViscousContourFriction(2e-7))
    SpinDownExponents(tilt=0.5, precession=-0.25, precession_by_tilt=-0.5)
    """
    return SpinDownExponents(law.exponent, -0.5 * law.exponent, -0.5)


def adiabaticity(disk: EulerDisk, state: Float64[Array, "*batch 8"]) -> Float64[Array, "*batch"]:
    """Return |θ̇|/(θ|φ̇|) of states (…, 8): the relative decrease of the tilt per radian of precession."""
    tilt, tilt_rate, *_ = rolling_parts(state)
    return jnp.abs(tilt_rate) / (jnp.minimum(tilt, jnp.pi - tilt) * jnp.abs(disk.precession(state)))


@known_numbers_only
def adiabatic_end(disk: EulerDisk, tilt: float) -> float | None:
    """Return t0 [s] by energy alone, ∫ dE/P along steady motions whose centre is at rest; None where it diverges.

    For a thin uniform disk and one law this is, to first order in the tilt, the t0 in the literature. Source: Moffatt
    (2000); Leine (2009), §4.
    """
    from scipy.integrate import quad

    if not any(law.exponent > 0.0 for law in disk.dissipation):
        return None

    @jax.jit
    def slowness(depth: Array) -> Array:
        theta = tilt * jnp.exp(-depth)
        packed = lambda x: _at_rest(disk, x)  # noqa: E731
        slope = jax.grad(lambda x: disk.energy(packed(x)))(theta)
        rate = jnp.sqrt(disk.mechanics.precession_at_rest(theta))
        return theta * slope / sum(law.power(disk.mechanics, theta, rate) for law in disk.dissipation)

    deepest = 40.0 / min(1.0 / law.exponent for law in disk.dissipation if law.exponent > 0.0)
    return float(quad(lambda x: float(slowness(x)), 0.0, deepest, epsrel=1e-10, limit=500)[0])


def _at_rest(disk: EulerDisk, theta: Array) -> Array:
    rate = jnp.sqrt(disk.mechanics.precession_at_rest(theta)) * jnp.sin(theta)
    zero = jnp.zeros_like(theta)
    spin = rate * disk.mechanics.half_thickness / disk.mechanics.radius
    return jnp.stack([theta, zero, zero, zero, zero, zero, rate, spin])


@dataclass(eq=False)
class _Run:
    """The samples so far: states, and the time and energy lost since the one before."""

    states: list[Array]
    spans: list[float]
    lost: list[float]
    steps: int


class _Span(NamedTuple):
    """State in its own scales; time and loss since the last sample, over a tick of the clock and E there."""

    state: Array
    time: Array
    lost: Array


def _asymptotic(disk: EulerDisk, run: _Run, decades: float, samples_per_decade: int, most_steps: int) -> bool:
    """Follow the motion by its own clock from sample to sample; return whether an event ended it."""
    length = jnp.asarray(math.log(10.0) / samples_per_decade)
    for _ in range(math.ceil(decades * samples_per_decade)):
        turn = float(_turn(disk, run.states[-1], length))
        if run.steps + LIMITS.steps_per_radian * turn > most_steps:
            return False
        final, ended, fine, steps = _advance(disk, run.states[-1], length)
        run.steps += int(steps)
        if not bool(fine):
            raise NotConverged(
                f"no end in sight after {run.steps} steps: the dissipation takes nothing any more, as drilling "
                "friction does once the disk has stopped turning about the vertical. Use `simulate`, or add a law."
            )
        run.states.append(final.state)
        run.spans.append(float(final.time))
        run.lost.append(float(final.lost))
        if bool(ended):
            return True
    return False


@eqx.filter_jit
def _advance(disk: EulerDisk, state: Array, length: Array) -> tuple[_Span, Array, Array, Array]:
    """Return state, duration and loss up to the next sample, whether an event came first, success, number of steps."""
    most_steps = 100_000  # from one sample to the next, which only a motion without losses needs
    clock, first_energy = _tick(disk, state), disk.energy(state)

    @jax.jit  # so that it is traced once
    def rates(t: Array, y: _Span) -> _Span:
        now = _unscale_state(disk, y.state)
        field, slowness = disk.vector_field(t, now), _tick(disk, now)
        change = jax.jvp(lambda x: _scale_state(disk, x), (now,), (field,))[1]
        lost = 1.5 * disk.mechanics.potential_energy(LAYOUT.part(now, "tilt"))
        return _Span(slowness * change, slowness / clock, lost / first_energy)

    def margin(t: Array, y: _Span) -> Array:
        return _margin(disk, _unscale_state(disk, y.state))

    zero = jnp.zeros(())
    times, tolerance = jnp.stack([zero, length]), jnp.asarray(TOLERANCE)
    problem = embedded.Problem(rates, margin, lambda t, y: t)
    run = embedded.begin(_Span(_scale_state(disk, state), zero, zero), times, times[:1], problem.seen)
    run = embedded.advance(run, diffrax.Dopri8(), problem, times, times[:1], None, tolerance, most_steps)
    last = run.end_state
    final = _Span(_unscale_state(disk, last.state), last.time * clock, last.lost * first_energy)
    ended = run.status == Status.EVENT
    return final, ended, ended | (run.status == Status.COMPLETED), run.steps


@eqx.filter_jit
def _turn(disk: EulerDisk, state: Array, length: Array) -> Array:
    """Return the angle of precession [rad] up to the next sample."""
    return jnp.abs(disk.precession(state) * _tick(disk, state) * length)


def _tick(disk: EulerDisk, state: Array) -> Array:
    """Return the time [s] in which dissipation takes the energy that belongs to the tilt."""
    # on the slow manifold E = (3/2) V, so that dV/dλ = −(2P/3)(3V/2P) = −V
    return 1.5 * disk.mechanics.potential_energy(LAYOUT.part(state, "tilt")) / disk.power(state)


def _margin(disk: EulerDisk, state: Array) -> Array:
    """Return the smallest margin of the events."""
    ends = [event(jnp.zeros(()), state) for event in disk.events.values()]
    return jnp.min(jnp.stack([*ends, LIMITS.asymptotic_adiabaticity - adiabaticity(disk, state)]))


@eqx.filter_jit
def _pace(disk: EulerDisk, states: Array) -> tuple[Array, Array]:
    """Return adiabaticity and the rate of precession [rad/s] of states (…, 8)."""
    return adiabaticity(disk, states), jnp.abs(disk.precession(states))


@eqx.filter_jit
def _outlook(disk: EulerDisk, state: Array) -> tuple[Array, Array, Array]:
    """Return adiabaticity, the smallest margin of the events, and the dissipated power [W]."""
    return adiabaticity(disk, state), _margin(disk, state), disk.power(state)


def _name_end(disk: EulerDisk, state: Array) -> str:
    margins = {name: float(event(jnp.zeros(()), state)) for name, event in disk.events.items()}
    margins[END_OF_REGIME] = LIMITS.asymptotic_adiabaticity - float(adiabaticity(disk, state))
    return min(margins, key=lambda name: margins[name])


def _scale_state(disk: EulerDisk, state: Array) -> Array:
    """Return log θ, angles, contact in radii, and rates over √(gθ/a): of order one however small the tilt."""
    unit = jnp.sqrt(disk.mechanics.gravity * LAYOUT.part(state, "tilt") / disk.mechanics.radius)
    place = state[CONTACT] / disk.mechanics.radius
    return jnp.concatenate([jnp.log(state[TILT]), state[ANGLES], place, state[RATES] / unit])


def _unscale_state(disk: EulerDisk, scaled: Array) -> Array:
    theta = jnp.exp(scaled[TILT])
    unit = jnp.sqrt(disk.mechanics.gravity * theta / disk.mechanics.radius)
    return jnp.concatenate([theta, scaled[ANGLES], scaled[CONTACT] * disk.mechanics.radius, scaled[RATES] * unit])


def _fall(disk: EulerDisk, run: _Run) -> str | None:
    """Follow the disk in time until an event ends the motion, and return its name, None without one."""
    far = LIMITS.fall_time * math.sqrt(float(disk.mechanics.radius / disk.mechanics.gravity))
    start = run.states[-1]
    first = solve_adaptively(disk, diffrax.Dopri8(), start, np.linspace(0.0, far, FALL_SAMPLES))
    motion = solve_adaptively(disk, diffrax.Dopri8(), start, np.linspace(0.0, first.times[-1], FALL_SAMPLES))
    run.states.extend(motion.states[1:])
    run.spans.extend(np.diff(motion.times))
    run.lost.extend(-np.diff(np.asarray(motion.received["energy"])))
    run.steps += first.steps
    return first.event


def _choose_samples(ratio: Array) -> slice:
    """Return the samples to fit: up to the last one that is deep enough in the asymptotic regime."""
    deep = np.flatnonzero(ratio < LIMITS.fitted_adiabaticity)
    if len(deep) < LIMITS.min_samples or len(deep) < deep[-1] - deep[0]:
        raise InvalidInput(
            f"only {len(deep)} samples lie deep enough in the asymptotic regime for a fit: the dissipation is too "
            "strong at this tilt, or the disk nutates. Start at a larger tilt, or on the slow manifold by "
            "`rolling_state`."
        )
    return slice(int(deep[0]), int(deep[-1]) + 1)


def _ruled_by_one(fitted: slice, powers: Array) -> slice:
    """Return the last of the samples to fit, while one law takes most of the power (T, laws); all if they are few."""
    shares = powers[fitted] / powers[fitted].sum(axis=-1, keepdims=True)
    ruled = shares[:, int(shares[-1].argmax())] >= LIMITS.dominant_share
    count = int(np.argmin(ruled[::-1])) if not ruled.all() else len(ruled)
    return fitted if count < LIMITS.min_samples else slice(fitted.stop - count, fitted.stop)


def _unspun(disk: EulerDisk, states: Array) -> Float64[Array, "n"]:
    """Return |Ω| [rad/s] of states (n, 8) without the contribution of the spin about the disk's axis."""
    tilt, spin = (LAYOUT.part(states, name) for name in ("tilt", "spin"))
    return np.asarray(disk.mechanics.precession_without_spin(tilt, disk.precession(states), spin))


def _distances(spans: Array, fitted: slice, singularity: Singularity) -> Array:
    """Return the distance of all samples from the singularity in time, counted from the sample next to it."""
    elapsed = np.cumsum(spans)
    if singularity.law.exponent < 0.0:
        return elapsed - elapsed[fitted.start] + singularity.distance
    before = np.append(np.cumsum(spans[1 : fitted.stop][::-1])[::-1], 0.0) + singularity.distance
    return np.append(before, singularity.distance - np.cumsum(spans[fitted.stop :]))


def _check_start(disk: EulerDisk, state: Real[ArrayLike, "8"], decades: float, samples_per_decade: int) -> Array:
    if not isinstance(disk, EulerDisk) or not disk.dissipation:
        raise InvalidInput("`disk` must be an EulerDisk with `dissipation`: without it the disk rolls for ever.")
    decades = check.number("decades", decades, above=0)
    samples_per_decade = check.whole("samples_per_decade", samples_per_decade, 2)
    start = disk.check_state(state)
    if jnp.ndim(start) != 1:
        raise InvalidInput(f"`state` must be one state (8,); got shape {jnp.shape(start)}.")
    ratio, margin, power = (float(x) for x in _outlook(disk, start))
    if not (margin > 0.0 and power > 0.0):
        raise InvalidInput(
            f"`state` is not in the asymptotic regime: |θ̇|/(θ|φ̇|) is {ratio:.3g}, at most "
            f"{LIMITS.asymptotic_adiabaticity} is, with contact and dissipation. Take `disk.rolling_state(tilt)`, or "
            "`simulate` until it gets there."
        )
    return start
