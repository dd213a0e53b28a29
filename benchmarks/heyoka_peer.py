"""heyoka as a peer: a system's equations in its expressions, one motion, and many in batches.

Source: Biscani & Izzo, Mon. Not. R. Astron. Soc. 504 (2021) 2614.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from typing import Any

import heyoka
import numpy as np
from cases import Case

from polhode.taylor.expressions import Expression, Tape
from polhode.taylor.jaxprs import write_jaxpr
from polhode.taylor.operations import Operation
from polhode.taylor.tracing import evaluate

BATCH = 8  # copies that heyoka moves at once: it is as quick with 4, and slower with 16


def one(case: Case, starts: np.ndarray, span: float) -> Callable[[float], np.ndarray]:
    """Return a function of the tolerance that moves copies one after the other, and gives their ends (C, …)."""
    equations = heyoka_equations(case.system, case.start)

    @cache
    def engine(tolerance: float) -> Any:
        return heyoka.taylor_adaptive(equations, list(starts[0].ravel()), tol=tolerance)

    def run(tolerance: float) -> np.ndarray:
        integrator, found = engine(float(tolerance)), np.empty_like(starts)
        for k, start in enumerate(starts):
            integrator.time, integrator.state[:] = 0.0, start.ravel()
            integrator.propagate_until(span)
            found[k] = integrator.state.reshape(start.shape)
        return found

    return run


def many(case: Case, starts: np.ndarray, span: float) -> Callable[[float], np.ndarray]:
    """Return the same for copies in batches of ``BATCH``, of which there must be a whole number."""
    equations, flat = heyoka_equations(case.system, case.start), starts.reshape(len(starts), -1)

    @cache
    def engine(tolerance: float) -> Any:
        return heyoka.taylor_adaptive_batch(equations, flat[:BATCH].T.copy(), tol=tolerance)

    def run(tolerance: float) -> np.ndarray:
        integrator, found = engine(float(tolerance)), np.empty_like(flat)
        for k in range(0, len(flat), BATCH):
            integrator.set_time(0.0)
            integrator.state[:] = flat[k : k + BATCH].T
            integrator.propagate_until(span)
            found[k : k + BATCH] = integrator.state.T
        return found.reshape(starts.shape)

    return run


def heyoka_equations(system: Any, start: np.ndarray) -> list[Any]:
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
