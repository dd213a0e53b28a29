"""Motions by Taylor series, at no more than the error of the peer: a hundred, one for long, ten thousand at once"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from typing import Any, NamedTuple

import diffrax
import jax
import jax.numpy as jnp
import numpy as np
from measure import Row, compared, median, missing

from polhode import certify, fields, spacecraft, systems
from polhode.taylor.expressions import Expression, Tape
from polhode.taylor.jaxprs import write_jaxpr
from polhode.taylor.operations import Operation
from polhode.taylor.runs import Precision, choose_precision, run_copies
from polhode.taylor.tracing import evaluate

SPAN, COPIES, TURNS = 20.0, 100, 7
LONG = 2000.0  # where one motion's steps are nearly all of its time
LATE = (1e-8, 1e-10, 1e-12)  # errors there, of motions that are not chaotic
CHAOTIC = "heavy top", "Kirchhoff's body, full matrix", "five vortices", "chain of eight spins", "body in orbit"
MANY, SHORT, BATCH = 10_000, 10.0, 8
TARGETS = (1e-8, 1e-12)
NEAREST = 1.5  # of the errors that both come to at best, where roundings decide
OURS = (None, *10.0 ** -np.arange(6.0, 17.0))
THEIRS = 10.0 ** -np.arange(5.0, 17.0)
DOPRI8 = 10.0 ** -np.arange(6.0, 15.0)


class Case(NamedTuple):
    """A system and where it starts from; copies start near to it."""

    name: str
    system: systems.base.AbstractSystem
    start: np.ndarray


def cases() -> Iterator[Case]:
    """Yield the systems, those of bodies with their attitude."""
    turned = np.array([1.0, 0.0, 0.0, 0.0])
    spinning = np.concatenate([turned, [0.3, 2.0, 0.1]])
    yield Case("free body", systems.FreeRigidBody((1.0, 2.0, 3.5)), spinning)
    top = systems.HeavyTop((1.0, 2.0, 3.5), 1.3, (0.6, 0.0, 0.8))
    yield Case("heavy top", top, np.asarray(top.pack(attitude=turned, angular_velocity=(0.3, 1.0, 0.1))))
    point = np.array([0.3, 1.0, 0.2, 0.5, -0.4, 1.0])
    yield Case("Clebsch's body", systems.BrunBody((1.0, 2.0, 3.0), 0.7), point)
    yield Case("Kirchhoff's body", systems.Kirchhoff((1.0, 2.0, 3.0, 2.0, 3.0, 5.0)), point)
    full = np.diag([1.0, 2.0, 3.0, 2.0, 3.0, 5.0]) + 0.1
    yield Case("Kirchhoff's body, full matrix", systems.Kirchhoff(full), point)
    yield Case("gyrostat", systems.Gyrostat((1.0, 2.0, 3.5), (0.2, 0.0, 0.4)), spinning)
    vortices = fields.PlaneVortices(np.array([1.0, 0.8, -0.7, 0.4, 1.2]))
    places = [[0.0, 0.0], [1.5, 0.2], [-0.3, 1.9], [2.0, 2.2], [-1.7, -0.8]]
    yield Case("five vortices", vortices, np.asarray(vortices.pack(places)))
    yield Case("Toda, four", fields.Toda(4), np.array([0.5, -0.2, 0.1, 0.3, 1.0, 0.8, 1.2]))
    drawn = np.random.default_rng(1)
    for n in (4, 6):
        whole = np.triu(drawn.normal(size=(n, n)), 1)
        yield Case(f"Manakov's body of so({n})", systems.Manakov(1.0 + np.arange(n)), whole - whole.T)
    spins = drawn.normal(size=(8, 3))
    spins = (spins / np.linalg.norm(spins, axis=1, keepdims=True)).reshape(8, 1, 1, 1, 3)
    chain = fields.SpinLattice(fields.Lattice([[1.0]], shape=(8,)), bonds=[fields.Bond(0, 0, (1,), 1.0)])
    yield Case("chain of eight spins", chain, spins)
    pulled = spacecraft.TorquedBody((1.0, 2.0, 2.5), [spacecraft.GravityGradient(systems.KeplerOrbit(1.0))])
    yield Case("body in orbit, gravity gradient", pulled, spinning)


def rows(quick: bool) -> Iterator[Row]:
    """Yield heyoka and Dopri8 at each error, with the cheapest order and reach of ours that is as exact."""
    copies = 2 if quick else COPIES
    for case in list(cases())[: 2 if quick else None]:
        starts = np.repeat(case.start[None], copies, axis=0)
        exact = certify(case.system, case.start, [0.0, SPAN]).states[-1]
        mine = _tried(partial(_ours, case, starts), map(choose_precision, OURS), exact)
        for name, make, choices in (("heyoka", _heyoka, THEIRS), ("diffrax Dopri8", _dopri8, DOPRI8)):
            peer = make(case, starts)
            if peer is None:
                yield missing(case.name, name, "`pip install heyoka`")
                continue
            theirs = _tried(peer, choices, exact)
            nearest = NEAREST * max(min(one.error for one in tried) for tried in (mine, theirs))
            for target in (TARGETS[1],) if quick else (*TARGETS, nearest):
                both = [min((one for one in tried if one.error <= target), default=None) for tried in (mine, theirs)]
                work = f"{case.name}, error at most {target:.1g}"
                if None in both:
                    yield Row(work, name, note=f"{'ours' if both[0] is None else 'the peer'} does not come as near")
                    continue
                ours, other = both
                runs = partial(_ours, case, starts, ours.choice), partial(peer, other.choice)
                note = f"order {ours.choice.order}; peer's tolerance {other.choice:g}"
                yield Row(work, name, ours.error, other.error, *compared(*runs, 2 if quick else TURNS), note)
            if name == "heyoka" and not case.name.startswith(CHAOTIC):
                yield from _long(case, starts[:1], SPAN if quick else LONG)
    yield from _many(quick)


def _long(case: Case, start: np.ndarray, span: float) -> Iterator[Row]:
    """Yield one motion for long, at equal errors at its end."""
    exact, peer = _ours(case, start, Precision(30, 0.1), span)[0], _heyoka(case, start, span)
    assert peer is not None
    ours = partial(_ours, case, start, span=span)
    tried = _tried(ours, map(choose_precision, OURS), exact), _tried(peer, THEIRS, exact)
    for target in LATE:
        both = [min((one for one in each if one.error <= target), default=None) for each in tried]
        work = f"{case.name}, one to t = {span:.0f}, error at most {target:.1g}"
        if None in both:
            yield Row(work, "heyoka", note=f"{'ours' if both[0] is None else 'the peer'} does not come as near")
            continue
        mine, other = both
        note = f"order {mine.choice.order}; peer's tolerance {other.choice:g}"
        times = compared(partial(ours, mine.choice), partial(peer, other.choice), TURNS)
        yield Row(work, "heyoka", mine.error, other.error, *times, note)


def _many(quick: bool) -> Iterator[Row]:
    """Yield ten thousand heavy tops, all from different starts, on one core."""
    case = next(one for one in cases() if one.name == "heavy top")
    copies = 16 if quick else MANY
    starts = np.repeat(case.start[None], copies, axis=0)
    starts[:, 4:7] += 0.1 * np.random.default_rng(0).normal(size=(copies, 3))
    work, peer = f"heavy tops, {copies:,} to t = {SHORT:.0f}", f"heyoka, {BATCH} at a time"
    theirs = _heyoka_batch(case, starts)
    if theirs is None:
        yield missing(work, peer, "`pip install heyoka`")
        return
    exact = _ours(case, starts[:64], Precision(40, 0.2), SHORT)
    for tolerance, by in ((1e-11, Precision(15, 0.15)), (1e-13, choose_precision(1e-14))):
        both = partial(_ours, case, starts, by, SHORT), partial(theirs, tolerance)
        errors = [float(np.abs(run()[: len(exact)] - exact).max() / np.abs(exact).max()) for run in both]
        yield Row(work, peer, *errors, *compared(*both, 2 if quick else TURNS),
                  f"order {by.order}; peer's tolerance {tolerance:g}")  # fmt: skip


class Tried(NamedTuple):
    """One way to run, the cheapest first in order."""

    time: float
    error: float
    choice: Any


def _tried(run: Callable[[Any], np.ndarray], choices: Any, exact: np.ndarray) -> list[Tried]:
    size, found = np.abs(exact).max(), []
    for choice in choices:
        error = float(np.abs(run(choice)[0] - exact).max() / size)
        found.append(Tried(median(lambda c=choice: run(c), 3), error, choice))
    return found


def _ours(case: Case, starts: np.ndarray, by: Precision, span: float = SPAN) -> np.ndarray:
    return run_copies(case.system, starts, np.array([0.0, span]), by).end_state


def _dopri8(case: Case, starts: np.ndarray) -> Callable[[float], np.ndarray]:
    @jax.jit
    def run(states: Any, tolerance: Any) -> Any:
        def one(state: Any) -> Any:
            term = diffrax.ODETerm(lambda t, y, args: case.system.vector_field(t, y))
            control = diffrax.PIDController(rtol=tolerance, atol=tolerance)
            return diffrax.diffeqsolve(term, diffrax.Dopri8(), 0.0, SPAN, None, state, stepsize_controller=control,
                                       max_steps=100_000).ys[0]  # fmt: skip

        return jax.lax.map(one, states)

    return lambda tolerance: np.asarray(run(jnp.asarray(starts), tolerance))


def _heyoka(case: Case, starts: np.ndarray, span: float = SPAN) -> Callable[[float], np.ndarray] | None:
    try:
        import heyoka
    except ImportError:
        return None
    equations, made = heyoka_equations(heyoka, case.system, case.start), {}

    def run(tolerance: float) -> np.ndarray:
        if tolerance not in made:
            made[tolerance] = heyoka.taylor_adaptive(equations, list(starts[0].ravel()), tol=float(tolerance))
        engine, found = made[tolerance], np.empty_like(starts)
        for k, start in enumerate(starts):
            engine.time, engine.state[:] = 0.0, start.ravel()
            engine.propagate_until(span)
            found[k] = engine.state.reshape(start.shape)
        return found

    return run


def _heyoka_batch(case: Case, starts: np.ndarray) -> Callable[[float], np.ndarray] | None:
    try:
        import heyoka
    except ImportError:
        return None
    equations, made = heyoka_equations(heyoka, case.system, case.start), {}

    def run(tolerance: float) -> np.ndarray:
        if tolerance not in made:
            made[tolerance] = heyoka.taylor_adaptive_batch(equations, starts[:BATCH].T.copy(), tol=float(tolerance))
        engine, found = made[tolerance], np.empty_like(starts)
        for k in range(0, len(starts), BATCH):
            engine.set_time(0.0)
            engine.state[:] = starts[k : k + BATCH].T
            engine.propagate_until(SHORT)
            found[k : k + BATCH] = engine.state.T
        return found

    return run


def heyoka_equations(heyoka: Any, system: Any, start: np.ndarray) -> list[Any]:
    """Return a system's equations, of the same operations as ours."""
    n = start.size
    tape = Tape(n + 1)  # the time last
    numbers = np.empty(n + 1, object)
    numbers[:] = tape.state()
    closed = write_jaxpr(lambda y: system.vector_field(y[n], y[:n].reshape(start.shape)), (n + 1,))
    rates = np.ravel(evaluate(closed, numbers)[0])
    variables = list(heyoka.make_vars(*[f"x{k}" for k in range(n)]))
    values = [*variables, heyoka.time]
    functions = {
        Operation.EXPONENTIAL: heyoka.exp, Operation.LOGARITHM: heyoka.log, Operation.SINE: heyoka.sin,
        Operation.COSINE: heyoka.cos,
    }  # fmt: skip

    def combined(terms: Any, constant: float) -> Any:
        parts = [c * values[k] for k, c in terms]
        parts += [heyoka.expression(float(constant))] if constant or not parts else []
        return heyoka.sum(parts)

    for node in tape.nodes:
        if node.operation is Operation.AFFINE:
            values.append(combined(zip(node.arguments, node.coefficients, strict=True), node.number))
        elif node.operation is Operation.PRODUCT:
            values.append(values[node.arguments[0]] * values[node.arguments[1]])
        elif node.operation is Operation.POWER:
            values.append(values[node.arguments[0]] ** node.number)
        else:
            values.append(functions[node.operation](values[node.arguments[0]]))
    whole = [r if isinstance(r, Expression) else tape.constant(float(r)) for r in rates]
    return [(v, combined(r.terms.items(), r.constant)) for v, r in zip(variables, whole, strict=True)]
