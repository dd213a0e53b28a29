"""The Lagrange tops of the reference table: generators of one family each; moments (I1, I1, I3) at the fixed point."""

from __future__ import annotations

from collections.abc import Iterator
from math import hypot, pi, sqrt
from random import Random

from oracle.hard_motions import (
    IDENTITY,
    LEVEL,
    TOP,
    HardMotion,
    Vector,
    drawn_attitude,
    drawn_vector,
    rounded,
    times_of,
)

DOWN = (0.0, 1.0, 0.0, 0.0)
LEANING = (0.8, 0.6, 0.0, 0.0)
"""The axis 73.7° from upright, towards −y."""
TIPPED = (0.96, 0.28, 0.0, 0.0)
"""The axis 32.5° from upright."""
TOY = (3.0e-4, 3.0e-4, 1.2e-4)
"""kg m²; a toy top of 100 g whose centre of mass is 3.5 cm above its tip."""
TOY_WEIGHT = 0.034
Motions = Iterator[HardMotion]


def top(name: str, family: str, moments: Vector, mgl: float, momentum: Vector, attitude: Vector) -> HardMotion:
    """A top with times in turns of its fastest rate and in its slow periods, of a pendulum or of precession."""
    size, (I1, _, I3) = hypot(*momentum), moments
    swing = sqrt(abs(mgl) / I1)
    rate = hypot(momentum[0] / I1, momentum[1] / I1, momentum[2] / I3) + 2.0 * swing
    slow = min(swing, abs(mgl) / size) if size else swing
    return HardMotion(name, family, TOP, tuple(map(float, moments)), float(mgl), tuple(map(float, momentum)),
                      tuple(map(float, attitude)), times_of(rate, 2.0 * pi / slow), rate)  # fmt: skip


def loops() -> Motions:
    """The axis runs backwards for a part of each nutation."""
    for back in (0.2, 0.5, 1.0, 2.0):
        momentum = (0.0, -back, 3.0)
        yield top(f"loops, {back:g} backwards", "top-loops", (1.0, 1.0, 0.5), 1.0, momentum, LEANING)
    yield top("loops of a toy top", "top-loops", TOY, TOY_WEIGHT, (0.0, -3.0e-3, 0.0151), TIPPED)


def cusps() -> Motions:
    """Let go with its axis at rest: the axis stops at every upper turning point."""
    for spin in (0.5, 2.0, 5.0):
        yield top(f"cusps, spin {spin:g}", "top-cusps", (1.0, 1.0, 0.5), 1.0, (0.0, 0.0, spin), LEANING)
    yield top("cusps, level", "top-cusps", (1.0, 1.0, 1.5), 2.0, (0.0, 0.0, -3.0), LEVEL)
    yield top("cusps of a toy top", "top-cusps", TOY, TOY_WEIGHT, (0.0, 0.0, 0.0151), TIPPED)


def waves() -> Motions:
    """The axis goes forwards all the time, faster and slower."""
    for forward in (0.1, 0.3, 1.5):
        momentum = (0.1, forward, 3.0)
        yield top(f"waves, {forward:g} forwards", "top-waves", (1.0, 1.0, 0.5), 1.0, momentum, LEANING)
    yield top("waves below the level", "top-waves", (1.0, 1.0, 0.5), 1.0, (0.2, 0.5, 2.0), (0.6, 0.8, 0.0, 0.0))
    yield top("waves of a toy top", "top-waves", TOY, TOY_WEIGHT, (1.0e-4, 3.0e-4, 0.0151), TIPPED)


def steady() -> Motions:
    """Steady precession with a level axis, L2 L3 = mgl I1 exactly, or off it by 1e-3 to 1e-12."""
    for spin, across in ((2.0, 0.5), (8.0, 0.125), (-1.0, 3.0)):
        mgl = across * spin
        yield top(f"steady, {spin:g}", "top-steady", (1.0, 1.0, 0.75), mgl, (0.0, across, spin), LEVEL)
    for off in (1e-3, 1e-6, 1e-9, 1e-12):
        yield top(f"nearly steady, {off:g}", "top-steady", (1.0, 1.0, 0.75), 1.0, (off, 0.5, 2.0), LEVEL)


def sleeping() -> Motions:
    """Upright: asleep above the threshold L3² = 4 mgl I1, at it and below; and knocked by 1e-3 to 1e-12."""
    for spin, name in ((3.0, "fast"), (2.0, "at the threshold"), (1.0, "slow")):
        yield top(f"asleep, {name}", "top-sleeping", (1.0, 1.0, 0.5), 1.0, (0.0, 0.0, spin), IDENTITY)
        yield top(f"knocked asleep, {name}", "top-sleeping", (1.0, 1.0, 0.5), 1.0, (1e-3, 0.0, spin), IDENTITY)
    for knock in (1e-6, 1e-9, 1e-12):
        momentum = (knock, -knock, 1.5)
        yield top(f"knocked awake, {knock:g}", "top-sleeping", (1.0, 1.0, 0.5), 1.0, momentum, IDENTITY)


def hanging() -> Motions:
    """The centre of mass straight below, or nearly."""
    yield top("hanging still, spinning", "top-hanging", (1.0, 1.0, 0.5), 1.0, (0.0, 0.0, 0.8), DOWN)
    for knock in (1.0, 1e-3, 1e-9):
        momentum = (0.0, knock, 0.3)
        yield top(f"hanging, knocked by {knock:g}", "top-hanging", (1.0, 1.0, 0.5), 1.0, momentum, DOWN)
    yield top("fixed point above, mgl < 0", "top-hanging", (1.0, 1.0, 0.5), -1.0, (0.2, 0.1, 0.7), LEANING)


def pendulums() -> Motions:
    """No spin about the axis: in a plane, through the top, round and round, and on a sphere."""
    body = (1.0, 1.0, 0.1)
    yield top("pendulum, small", "top-pendulum", body, 1.0, (0.01, 0.0, 0.0), DOWN)
    yield top("pendulum, from level", "top-pendulum", body, 1.0, (0.0, 0.0, 0.0), LEVEL)
    yield top("pendulum, almost over the top", "top-pendulum", body, 1.0, (1.999, 0.0, 0.0), DOWN)
    yield top("pendulum, to the top, exactly", "top-pendulum", body, 1.0, (2.0, 0.0, 0.0), DOWN)
    yield top("pendulum, over the top", "top-pendulum", body, 1.0, (0.0, 2.5, 0.0), DOWN)
    yield top("pendulum on a sphere", "top-pendulum", body, 1.0, (0.3, 0.8, 0.0), (0.5, 0.5, 0.5, -0.5))
    yield top("pendulum on a sphere, past the bottom", "top-pendulum", body, 1.0, (1.0, 1e-6, 0.0), LEVEL)


def gyroscopes() -> Motions:
    """So fast that they nutate finely and precess slowly."""
    for spin in (30.0, 300.0, 3000.0):
        yield top(f"gyroscope, {spin:g}", "top-gyroscope", (1.0, 1.0, 1.8), 1.0, (0.1, 0.3, spin), LEANING)
    yield top("gyroscope, backwards", "top-gyroscope", (1.0, 1.0, 1.8), 1.0, (0.0, 0.0, -100.0), LEVEL)
    yield top("toy gyroscope", "top-gyroscope", (1.1e-4, 1.1e-4, 4.2e-5), 0.028, (0.0, 0.0, 0.026), LEANING)


def separatrix() -> Motions:
    """Upright in the limit, exactly, as L1² + L3² = 2 mgl I1 and L2 = L3 at a level axis; and 1e-3 to 1e-12 off."""
    for x, a, r in ((3.0, 4.0, 5.0), (-4.0, 3.0, 5.0)):
        yield top(f"to upright, {x:g}", "top-separatrix", (1.0, 1.0, 0.6), r * r / 2.0, (x, a, a), LEVEL)
    for off in (1e-3, 1e-8, 1e-12):
        momentum = (3.0, 4.0 * (1.0 + off), 4.0)
        yield top(f"past upright, {off:g}", "top-separatrix", (1.0, 1.0, 0.6), 12.5, momentum, LEVEL)


def random() -> Motions:
    """Any top, any start."""
    rng = Random(4)
    for number in range(8):
        I1, I3 = (rounded(0.2 + 1.8 * rng.random()) for _ in range(2))
        momentum = [rounded(2.0 * x) for x in drawn_vector(rng)]
        mgl = rounded(0.1 + 2.0 * rng.random())
        yield top(f"random top {number + 1}", "top-random", (I1, I1, I3), mgl, momentum, drawn_attitude(rng))


TOP_FAMILIES = (loops, cusps, waves, steady, sleeping, hanging, pendulums, gyroscopes, separatrix, random)
