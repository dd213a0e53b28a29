"""Every integrator's order by slope, on nonlinear triaxial cases, well above rounding."""

import itertools
from functools import cache

import jax
import jax.numpy as jnp
import mpmath
import numpy as np
import pytest

import polhode as ph
from polhode import algebra as lie
from polhode import fields, systems
from polhode.integrators import (
    IsospectralMidpoint,
    LieMidpoint,
    MuntheKaas,
    SphericalMidpoint,
    Splitting,
)
from polhode.integrators import (
    _composition as composition,
)
from specimens import in_su3, spins

SLOPE = 0.3
FLOOR = 1e-13
SPAN = 4.0
body = systems.FreeRigidBody((1.0, 2.0, 3.0))
top = systems.BodyInPotential((1.0, 2.0, 3.0), lambda up: 0.7 * up[2] + 0.3 * up[0])
fish = systems.Kirchhoff(np.diag([1.0, 2.0, 3.0, 2.0, 3.0, 5.0]) + 0.2)
four = systems.Manakov((1.0, 2.0, 3.0, 4.0))
eight = systems.LiePoisson(lie.SU(3), in_su3)
pair = systems.LiePoisson(lie.Power(lie.SO3(), 2), spins)
TURNED = np.array([0.5, -0.5, 0.1, 0.7]) / np.linalg.norm([0.5, -0.5, 0.1, 0.7])
RNG = np.random.default_rng(3)
toda = fields.Toda(4)
SYSTEMS = {"body": body, "top": top, "fish": fish, "four": four, "eight": eight, "pair": pair,
           "toda": toda}  # fmt: skip
STARTS = {
    "body": np.concatenate([TURNED, [0.3, 1.8, 1.5]]),
    "top": np.concatenate([TURNED, [0.3, 1.8, 1.5, 0.6, 0.0, 0.8]]),
    "fish": np.concatenate([TURNED, [0.3, 1.8, 1.5, 0.7, -0.2, 0.4]]),
    "four": np.asarray(four.algebra.from_dual_vector(RNG.normal(size=6))),
    "eight": np.asarray(eight.algebra.from_dual_vector(RNG.normal(size=8))),
    "pair": RNG.normal(size=(2, 3)),
    "toda": np.array([0.5, -0.2, 0.1, 0.3, 1.0, 0.8, 1.2]),
}
SHORT, LONG = (0.1, 0.05, 0.025), (0.4, 0.2, 0.1)
CASES = [
    *(("body", Splitting, k, {}, LONG if k == 6 else SHORT) for k in (2, 4, 6)),
    *(("body", MuntheKaas, k, {}, SHORT) for k in (2, 4)),
    *(("body", LieMidpoint, k, {"coordinates": c}, SHORT) for k in (2, 4) for c in ("cayley", "exp")),
    *(("top", Splitting, k, {}, SHORT) for k in (2, 4, 6)),
    *(("toda", Splitting, k, {}, (0.8, 0.4, 0.2) if k == 6 else SHORT) for k in (2, 4, 6)),
    *(("fish", LieMidpoint, k, {"coordinates": c}, SHORT) for k in (2, 4) for c in ("cayley", "exp")),
    *(("fish", MuntheKaas, k, {}, SHORT) for k in (2, 4)),
    *(("four", IsospectralMidpoint, k, {}, SHORT) for k in (2, 4)),
    *(("four", Splitting, k, {}, LONG if k == 6 else SHORT) for k in (2, 4, 6)),
    *(("eight", IsospectralMidpoint, k, {}, (0.05, 0.025, 0.0125)) for k in (2, 4)),
    *(("eight", MuntheKaas, k, {}, (0.05, 0.025, 0.0125)) for k in (2, 4)),
    ("body", Splitting, 8, {}, (0.8, 0.4, 0.2)),
    ("eight", IsospectralMidpoint, 8, {}, LONG),
    *(("pair", SphericalMidpoint, k, {}, SHORT if k == 2 else LONG) for k in (2, 6)),
    ("pair", LieMidpoint, 4, {}, SHORT),
]

QUICK = {
    ("toda", Splitting, 6), ("body", Splitting, 8), ("fish", MuntheKaas, 2), ("four", IsospectralMidpoint, 2),
}  # fmt: skip
"""Every method but that of spheres; the others, each compiled for two seconds or more, are in the sweep."""


def end(name, method, step, order, **more):
    system = SYSTEMS[name]
    solver = method(system, jnp.asarray(step), order=order, **more)
    return np.asarray(ph.simulate(system, STARTS[name], [0.0, SPAN], method=solver, estimate_error=False).states[-1])


@cache
def reference(name):
    """The exact solution of the free body and the Toda lattice; of others, another method with a short step."""
    if name == "body":
        motion = ph.FreeMotion((1.0, 2.0, 3.0), momentum=STARTS["body"][4:], attitude=STARTS["body"][:4])
        return np.concatenate(motion.state(SPAN))
    if name == "toda":
        return np.asarray(toda.exact(STARTS["toda"], SPAN))
    return end(name, MuntheKaas, 0.001, 4)


def quick_or_in_the_sweep(case):
    system, method, order, more, _ = case
    name = f"{system}-{method.__name__}-{order}-{more.get('coordinates', '')}"
    return pytest.param(*case, id=name, marks=() if (system, method, order) in QUICK else pytest.mark.sweep)


@pytest.mark.long_cases("toda-Splitting-6-", "fish-MuntheKaas-2-", "four-IsospectralMidpoint-2-")
@pytest.mark.parametrize(
    ("name", "method", "order", "more", "steps"), list(map(quick_or_in_the_sweep, CASES)),
)  # fmt: skip
def test_order(name, method, order, more, steps):
    errors = [np.abs(end(name, method, h, order, **more) - reference(name)).max() for h in steps]
    slopes = np.log2(np.array(errors[:-1]) / errors[1:])
    assert errors[-1] > FLOOR, errors
    assert slopes[-1] == pytest.approx(order, abs=SLOPE), (errors, slopes)


@pytest.mark.sweep
def test_a_wrong_coefficient_of_kicks_and_drifts_loses_the_order(monkeypatch):
    kicks, drifts = composition.NYSTROM[6]
    wrong = (kicks[0] + 1e-4, kicks[1] - 1e-4, *kicks[2:-2], kicks[1] - 1e-4, kicks[0] + 1e-4)
    monkeypatch.setitem(composition.NYSTROM, 6, (wrong, drifts))
    jax.clear_caches()
    errors = [np.abs(end("toda", Splitting, h, 6) - reference("toda")).max() for h in LONG]
    jax.clear_caches()
    assert np.log2(errors[-2] / errors[-1]) < 4.0


@pytest.mark.long
def test_a_method_with_a_wrong_weight_loses_its_order():
    class Lame(MuntheKaas):
        def change(self, t, h, state):
            return super().change(t, h * (1.0 + 0.01 * h), state)

    errors = [np.abs(end("body", Lame, h, 4) - reference("body")).max() for h in SHORT]
    assert np.log2(errors[-2] / errors[-1]) < 2.0


@pytest.mark.parametrize("order", [4, 6])
def test_kicks_and_drifts_have_their_order_in_forty_digits(order):
    """A pendulum, which the integrators do not know: the slope is that of the coefficients as published."""
    with mpmath.workdps(40):
        kicks, drifts = (_symmetric([mpmath.mpf(repr(x)) for x in shares]) for shares in composition.NYSTROM[order])

        def pendulum(steps):
            q, p, h = mpmath.mpf("1.3"), mpmath.mpf("0.4"), mpmath.mpf(2) / steps
            for _ in range(steps):
                for kick, drift in zip(kicks, [*drifts, 0], strict=True):
                    p -= kick * h * mpmath.sin(q)
                    q += drift * h * p
            return mpmath.matrix([q, p])

        end = pendulum(1024)
        errors = [mpmath.norm(pendulum(n) - end) for n in (32, 64, 128)]
        slopes = [float(mpmath.log(a / b, 2)) for a, b in itertools.pairwise(errors)]
    assert slopes == pytest.approx([order, order], abs=0.02)


def _symmetric(shares):
    """Shares that add up to one in forty digits, by those in the middle."""
    outer = (len(shares) - 1) // 2
    middle = [(1 - 2 * sum(shares[:outer])) / (len(shares) - 2 * outer)] * (len(shares) - 2 * outer)
    return [*shares[:outer], *middle, *shares[:outer][::-1]]
