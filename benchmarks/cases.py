"""The systems whose motions are measured, and where they start."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from polhode import fields, systems


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
    full = np.diag([1.0, 2.0, 3.0, 2.0, 3.0, 5.0]) + 0.1
    yield Case("Kirchhoff's body, full matrix", systems.Kirchhoff(full), point)
    yield Case("Toda, four", fields.Toda(4), np.array([0.5, -0.2, 0.1, 0.3, 1.0, 0.8, 1.2]))
    drawn = np.random.default_rng(1)
    for n in (4, 6):
        whole = np.triu(drawn.normal(size=(n, n)), 1)
        yield Case(f"Manakov's body of so({n})", systems.Manakov(1.0 + np.arange(n)), whole - whole.T)
    spins = drawn.normal(size=(8, 3))
    spins = (spins / np.linalg.norm(spins, axis=1, keepdims=True)).reshape(8, 1, 1, 1, 3)
    chain = fields.SpinLattice(fields.Lattice([[1.0]], shape=(8,)), bonds=[fields.Bond(0, 0, (1,), 1.0)])
    yield Case("chain of eight spins", chain, spins)
