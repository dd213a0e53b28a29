"""What integrators keep, over many steps: Casimirs to rounding, energy bounded and without drift, time reversal."""

from typing import ClassVar

import jax
import jax.numpy as jnp
import numpy as np
import pytest

import polhode as ph
from polhode import algebra as lie
from polhode import systems
from polhode.integrators import IsospectralMidpoint, LieMidpoint, MuntheKaas, SphericalMidpoint, Splitting
from polhode.integrators.base import AbstractOrbitSolver, explicit
from specimens import in_su3, spins

CASIMIR = 1e-13
TREND = 0.4  # of the swing, from first to last quarter: a steady drift makes it 0.75, chaotic wandering 0.2
STEP = 0.02
FEW, FIFTH, MANY = 20_000, 200_000, 1_000_000
SYMMETRIC = (Splitting, LieMidpoint, IsospectralMidpoint, SphericalMidpoint)
body = systems.FreeRigidBody((1.0, 2.0, 3.0))
fish = systems.Kirchhoff((1.0, 2.0, 3.0, 2.0, 3.0, 5.0))
four = systems.Manakov((1.0, 2.0, 3.0, 4.0))
eight = systems.LiePoisson(lie.SU(3), in_su3)
pair = systems.LiePoisson(lie.Power(lie.SO3(), 2), spins)
top = systems.BodyInPotential((1.0, 2.0, 3.0), lambda up: 0.7 * up[2] + 0.3 * up[0])
RNG = np.random.default_rng(0)
SYSTEMS = {"body": body, "fish": fish, "four": four, "eight": eight, "pair": pair, "top": top}
STARTS = {
    "body": np.array([1.0, 0, 0, 0, 0.3, 1.8, 1.5]),
    "fish": np.array([1.0, 0, 0, 0, 0.3, 1.8, 1.5, 0.7, -0.2, 0.4]),
    "four": np.asarray(four.algebra.from_dual_vector(RNG.normal(size=6))),
    "eight": np.asarray(eight.algebra.from_dual_vector(RNG.normal(size=8))),
    "pair": RNG.normal(size=(2, 3)),
    "top": np.array([1.0, 0, 0, 0, 0.3, 1.8, 1.5, 0.6, 0.0, 0.8]),
}
CASES = [
    *(("body", method, order) for method, order in ((Splitting, 2), (Splitting, 4), (LieMidpoint, 2), (MuntheKaas, 4))),
    *(("fish", method, order) for method, order in ((Splitting, 2), (LieMidpoint, 2), (MuntheKaas, 4))),
    *(("four", method, 2) for method in (Splitting, LieMidpoint, IsospectralMidpoint)),
    ("four", MuntheKaas, 4),
    *(("eight", method, 2) for method in (LieMidpoint, IsospectralMidpoint)),
    *(("pair", method, 2) for method in (SphericalMidpoint, LieMidpoint)),
    ("top", Splitting, 2),
    ("top", Splitting, 6),
]
LONG_RUN = [case for case in CASES if case[0] != "top"]
COSTLY = [case for case in LONG_RUN if case[0] in ("four", "eight") and case[1] is not Splitting]
"""Matrices by iteration, 30 to 130 seconds for a million steps: a fifth of them, and half the bound (rounding errors
that add up at random grow like the root of their number)."""


QUICK = [
    ("body", Splitting, 4), ("body", MuntheKaas, 4),
    ("four", IsospectralMidpoint, 2), ("pair", SphericalMidpoint, 2), ("body", LieMidpoint, 2),
]  # fmt: skip


def one_of_each(cases, quick):
    """Every method once, where it has most to do but for the one that is compiled for long; the others in the sweep."""
    return [pytest.param(case, marks=[] if case in quick else [pytest.mark.sweep]) for case in cases]


def names(case):
    return f"{case[0]}-{case[1].__name__}-{case[2]}"


def run(name, method, order, count):
    return ph.simulate(SYSTEMS[name], STARTS[name], np.linspace(0.0, count * STEP, 401), method, step=STEP, order=order,
                       estimate_error=False)  # fmt: skip


def kept(system, trajectory):
    """Casimirs' drift relative to the sizes of their terms, and that of what is fixed in space."""
    points = system.parts(trajectory.states).point
    names = {*system.algebra.named_casimirs(points), "momentum_space", "linear_space"}
    found = {name: float(np.max(value)) for name, value in trajectory.drift.items() if name in names}
    if isinstance(system.algebra, lie.SU):
        # Σ λ³ of eigenvalues of both signs is small beside its terms; so is the drift beside Σ |λ|³
        levels = np.linalg.eigvalsh(1j * trajectory.states[0])
        for k in range(2, system.algebra.n + 1):
            found[f"tr (iμ)^{k}"] *= abs(np.sum(levels**k)) / np.sum(np.abs(levels) ** k)
    return found


def check(name, method, order, count, bound=CASIMIR):
    trajectory = run(name, method, order, count)
    assert trajectory.statistics["steps"] == count and str(trajectory.outcome) == "successful"
    drifts = kept(SYSTEMS[name], trajectory)
    assert drifts and max(drifts.values()) <= bound, drifts
    if method in SYMMETRIC:
        assert trend(trajectory) < TREND, "the energy drifts"


def trend(trajectory):
    """How far the energy moves from the first to the last quarter of the run, in units of its swing."""
    energy = trajectory.invariants["energy"]
    change = abs(np.mean(energy[:100] - energy[0]) - np.mean(energy[-100:] - energy[0]))
    return change / (np.ptp(energy) + 10 * CASIMIR * abs(energy[0]))


def test_a_drift_of_the_energy_is_caught():
    assert trend(run("body", MuntheKaas, 4, FEW)) > TREND


@pytest.mark.long_cases("four-IsospectralMidpoint-2", "pair-SphericalMidpoint-2")
@pytest.mark.parametrize("case", one_of_each(CASES, QUICK), ids=names)
def test_casimirs_and_energy(case):
    check(*case, 2_000 if case[0] == "top" else FEW)


@pytest.mark.sweep
@pytest.mark.parametrize("case", LONG_RUN, ids=names)
def test_casimirs_and_energy_over_a_million_steps_or_a_fifth(case):
    check(*case, *((FIFTH, CASIMIR / 2) if case in COSTLY else (MANY,)))


@pytest.mark.long_cases("pair-SphericalMidpoint-2", "top-Splitting-6")
@pytest.mark.parametrize(
    "case",
    one_of_each([case for case in CASES if case[1] in SYMMETRIC], [*QUICK[:1], *QUICK[-2:], ("top", Splitting, 6)]),
    ids=names,
)
def test_symmetric_methods_run_back(case):
    name, method, order = case
    system = SYSTEMS[name]
    times = np.linspace(0.0, 10.0, 11)
    there = ph.simulate(system, STARTS[name], times, method, step=STEP, order=order)
    back = ph.simulate(system, there.states[-1], times[::-1], method, step=STEP, order=order)
    assert np.abs(back.states[-1] - STARTS[name]).max() < 1e-13


@pytest.mark.long
def test_explicit_runge_kutta_methods_do_not_run_back():
    times = np.linspace(0.0, 10.0, 11)
    there = ph.simulate(body, STARTS["body"], times, MuntheKaas, step=0.1, order=4)
    back = ph.simulate(body, there.states[-1], times[::-1], MuntheKaas, step=0.1, order=4)
    assert np.abs(back.states[-1] - STARTS["body"]).max() > 1e-9


@pytest.mark.long
def test_a_method_off_the_orbit_is_caught():
    class Kutta(AbstractOrbitSolver):
        """The classical method on the state itself."""

        system: systems.AbstractLiePoissonSystem
        step_size: jax.Array
        keeps: ClassVar[str] = "nothing"

        def order(self, terms):
            return 4

        def change(self, t, h, state):
            field = lambda y: self.system.vector_field(0.0, y)  # noqa: E731
            a = field(state)
            b = field(state + 0.5 * h * a)
            c = field(state + 0.5 * h * b)
            return explicit(h * (a + 2 * b + 2 * c + field(state + h * c)) / 6)

    times = np.linspace(0.0, FEW * STEP, 101)
    found = ph.simulate(body, STARTS["body"], times, Kutta(body, jnp.asarray(STEP)))
    assert max(kept(body, found).values()) > CASIMIR
