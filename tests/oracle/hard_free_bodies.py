"""The free bodies of the reference table: generators of one family each."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import permutations
from math import cos, pi, radians, sin
from random import Random

from oracle.hard_motions import (
    IDENTITY,
    LEVEL,
    SHARE,
    STARTS,
    HardMotion,
    drawn_attitude,
    drawn_moments,
    drawn_vector,
    free,
    rounded,
    slope,
)

BODY = (1.0, 2.0, 3.0)
"""What many families take; L1 = L3/√3 on its separatrix."""
Motions = Iterator[HardMotion]


def short_axis() -> Motions:
    """L encircles the axis of the largest moment."""
    rng = Random(1)
    for number in range(10):
        moments, (x, y, z) = drawn_moments(rng), drawn_vector(rng)
        momentum = rounded(0.9 * slope(moments) * x * z), y, z
        yield free(f"short-axis {number + 1}", "short-axis", moments, momentum, drawn_attitude(rng))


def long_axis() -> Motions:
    """L encircles the axis of the smallest moment."""
    rng = Random(2)
    for number in range(10):
        moments, (x, y, z) = drawn_moments(rng), drawn_vector(rng)
        momentum = x, y, rounded(0.9 / slope(moments) * x * z)
        yield free(f"long-axis {number + 1}", "long-axis", moments, momentum, drawn_attitude(rng))


def flips() -> Motions:
    """Spun about the intermediate axis with a tilt, a body turns over and over, as a T-handle in orbit."""
    moments = (2.5e-5, 3.1e-5, 5.4e-5)
    for tilt in (10.0, 3.0, 1.0, 0.1):
        for towards, axis in ((0, "first"), (2, "third")):
            spin = [0.0, 12.0 * cos(radians(tilt)), 0.0]
            spin[towards] = 12.0 * sin(radians(tilt))
            momentum = [rounded(i * w, 8) for i, w in zip(moments, spin, strict=True)]
            yield free(f"flips, {tilt:g} deg to the {axis} axis", "flips", moments, momentum)


def near_stable_axis() -> Motions:
    """L is off the first or third axis by 1e-3 to 1e-12."""
    for off in (1e-3, 1e-5, 1e-7, 1e-9, 1e-12):
        yield free(f"by the first axis, {off:g}", "near-stable-axis", BODY, (1.0, off, -0.7 * off), LEVEL)
        yield free(f"by the third axis, {off:g}", "near-stable-axis", BODY, (0.6 * off, -off, -1.0))


def near_unstable_axis() -> Motions:
    """L is off the intermediate axis by 1e-3 to 1e-12; what is off grows e-fold until the body turns over."""
    for off in (1e-3, 1e-6, 1e-9, 1e-12):
        yield free(f"by the second axis, short-axis mode, {off:g}", "near-unstable-axis", BODY, (0.5 * off, 1.0, off))
        yield free(f"by the second axis, long-axis mode, {off:g}", "near-unstable-axis", BODY, (off, -1.0, 0.5 * off))


def near_separatrix() -> Motions:
    """L1 is off the separatrix by 1e-2 to 1e-14 of itself, to either side."""
    moments = (3.0, 4.0, 6.0)  # L1 = L3 on the separatrix
    for off in (1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-14):
        yield free(f"short-axis side of the separatrix, {off:g}", "near-separatrix", moments, (1.0 - off, 0.4, 1.0))
        momentum = (-(1.0 + off), 2.5, 1.0)
        yield free(f"long-axis side of the separatrix, {off:g}", "near-separatrix", moments, momentum, LEVEL)


def separatrix() -> Motions:
    """On the separatrix exactly: L1² (I2 − I1) I3 = L3² (I3 − I2) I1 in whole numbers."""
    bodies = ((3, 4, 6, 1, 1), (2, 5, 6, 1, 3), (3, 5, 8, 3, 4), (4, 5, 9, 4, 3), (9, 10, 18, 2, 1))
    for number, (i1, i2, i3, l1, l3) in enumerate(bodies):
        name = f"separatrix of {i1}, {i2}, {i3}"
        yield free(name, "separatrix", (i1, i2, i3), (l1, 1.5 * (-1) ** number, l3), STARTS[number])
    yield free("separatrix, away from the axis", "separatrix", (3, 4, 6), (-1.0, 0.25, 1.0))
    yield free("separatrix, next to the axis", "separatrix", (3, 4, 6), (2.0**-30, 1.0, 2.0**-30))
    yield free("separatrix, the middle of a flip", "separatrix", (3, 4, 6), (-1.0, 0.0, -1.0))


def symmetric() -> Motions:
    """Two moments are equal: L goes round a cone."""
    for ratio in (0.1, 0.5, 0.9, 1.1, 1.6, 2.0):
        shape = "prolate" if ratio < 1.0 else "oblate"
        for momentum in ((0.6, 0.0, 0.8), (0.48, -0.64, -0.6)):
            side = "up" if momentum[2] > 0.0 else "down"
            yield free(f"{shape} {ratio:g}, {side}", "symmetric", (1.0, 1.0, ratio), momentum)
    yield free("prolate about its first axis", "symmetric", (0.25, 1.0, 1.0), (0.3, 0.5, -0.9), LEVEL)
    yield free("oblate with its axis at right angles to L", "symmetric", (1.0, 1.0, 1.5), (0.6, 0.8, 0.0))


def near_symmetric() -> Motions:
    """Two moments differ by 1e-3 to 1e-12 of themselves."""
    for off in (1e-3, 1e-6, 1e-9, 1e-12):
        yield free(f"nearly oblate, {off:g}", "near-symmetric", (1.0, 1.0 + off, 1.7), SHARE)
        yield free(f"nearly prolate, {off:g}", "near-symmetric", (0.4, 1.0, 1.0 + off), SHARE, LEVEL)


def spheres() -> Motions:
    """All moments are equal, or differ by 1e-3 to 1e-12 of themselves."""
    yield free("sphere", "spheres", (0.4, 0.4, 0.4), SHARE)
    yield free("sphere about its first axis", "spheres", (2.0, 2.0, 2.0), (-3.0, 0.0, 0.0), LEVEL)
    for off in (1e-3, 1e-5, 1e-7, 1e-9, 1e-12):
        yield free(f"nearly a sphere, {off:g}", "spheres", (1.0, 1.0 + off, 1.0 + 2.0 * off), SHARE)


def flat() -> Motions:
    """I3 = I1 + I2 exactly."""
    for i1, i2 in ((1.0, 1.0), (0.5, 1.0), (0.125, 1.0), (0.0078125, 1.0), (0.75, 1.25)):
        yield free(f"flat {i1:g}, {i2:g}", "flat", (i1, i2, i1 + i2), (0.2, 0.9, 0.7))
    yield free("flat disk on edge", "flat", (1.0, 1.0, 2.0), (1.0, 0.0, 1e-6))


def needles() -> Motions:
    """I1 is 1e-2 to 1e-6 of the others; with a given Ω, L lies nearly across the needle."""
    for thin in (1e-2, 1e-4, 1e-6):
        moments = (thin, 1.0, 1.0 + 0.5 * thin)
        spin = (0.7, -0.4, 1.1)
        along = [rounded(i * w, 12) for i, w in zip(moments, spin, strict=True)]
        yield free(f"needle {thin:g}, any spin", "needles", moments, along)
        yield free(f"needle {thin:g}, any momentum", "needles", moments, SHARE, LEVEL)


def far_apart() -> Motions:
    """Moments by factors of up to 1e12 apart, which no rigid body has, but the equations do."""
    choices = ((1e-6, 1.0, 1e6), (1e-6, 1e-5, 1e6), (1e-6, 1e5, 1e6), (1e-3, 1.0, 1e3))
    for number, moments in enumerate(choices):
        yield free(f"far apart {number + 1}, any momentum", "far-apart", moments, SHARE)
        if number in (0, 3):
            spun = [rounded(i * w, 12) for i, w in zip(moments, (0.7, -0.4, 1.1), strict=True)]
            yield free(f"far apart {number + 1}, any spin", "far-apart", moments, spun)


def unordered() -> Motions:
    """The same body with its axes in every order: none may be taken for the first."""
    for number, order in enumerate(permutations(range(3))):
        momentum = (0.9, 1.6, 0.3) if number % 2 else (0.3, 1.8, 1.5)
        name = "moments " + ", ".join(f"{BODY[k]:g}" for k in order)
        yield free(name, "unordered", [BODY[k] for k in order], [momentum[k] for k in order], STARTS[number % 5])


def scales() -> Motions:
    """Units that are far too large or too small, and spins that are very fast or slow."""
    for mass in (1e-40, 1e-20, 1e12, 1e30):
        moments = [mass * i for i in (1.0, 2.0, 3.0)]
        yield free(f"moments of {mass:g}", "scales", moments, [mass * x for x in (0.3, 1.8, 1.5)])
    for rate in (1e-20, 1e12):
        yield free(f"rates of {rate:g}", "scales", BODY, [rate * x for x in (0.9, 1.6, 0.3)])


def steady() -> Motions:
    """Exactly about a principal axis, stable or not, with either sense."""
    for axis, name in enumerate(("first", "second", "third")):
        for sense in (1.0, -1.0):
            momentum = [0.0, 0.0, 0.0]
            momentum[axis] = 1.25 * sense
            start = IDENTITY if sense > 0.0 else STARTS[3]
            yield free(f"about the {name} axis, {'+' if sense > 0 else '−'}", "steady", BODY, momentum, start)


def spun(name: str, moments: tuple[float, ...], spin: tuple[float, ...]) -> HardMotion:
    """A real thing with a given angular velocity."""
    momentum = [rounded(i * w, 12) for i, w in zip(moments, spin, strict=True)]
    return free(name, "real", moments, momentum)


def real() -> Motions:
    """Things that exist, with moments and spins of about the right size."""
    turn = 2.0 * pi
    yield spun("asteroid Apophis", (0.61e15, 0.965e15, 1.0e15), (1.79069826969e-05, 0.0, 5.53102607444e-05))
    yield spun("asteroid Toutatis", (1.02e20, 3.19e20, 3.3e20), (1.36e-5, 3.6e-6, 2.1e-6))
    yield spun("Earth, rigid", (8.0101e37, 8.0103e37, 8.0365e37), (7.0e-11, 2.0e-11, 7.292115e-5))
    yield spun("Hyperion", (0.314, 0.459, 0.542), (1.6e-5, 4.0e-6, 9.0e-6))
    yield spun("space station, out of control", (1.07e8, 1.28e8, 2.01e8), (0.001, 0.0113, 0.0005))
    yield spun("Explorer 1", (0.021, 1.8, 1.8), (turn * 12.5, 0.02, 0.5))
    yield free("water molecule", "real", (1.02e-47, 1.92e-47, 2.94e-47), (0.3e-34, 0.95e-34, 0.34e-34))
    yield spun("smartphone", (7.3e-5, 3.3e-4, 4.0e-4), (0.3, 15.0, 0.4))
    yield spun("hardback book", (2.46e-3, 5.4e-3, 7.6e-3), (0.2, 9.4, 0.3))
    yield spun("tennis racket", (1.6e-3, 1.46e-2, 1.62e-2), (0.05, 6.3, 0.1))
    yield spun("wing nut", (2.1e-6, 3.4e-6, 4.9e-6), (0.02, 31.4, 0.01))
    yield spun("frisbee with a wobble", (1.2e-3, 1.2e-3, 2.35e-3), (4.0, 0.0, 50.0))


def random() -> Motions:
    """Any moments, any momentum, any attitude."""
    rng = Random(3)
    for number in range(20):
        moments = [rounded(0.1 + 0.9 * rng.random()) for _ in range(3)]
        yield free(f"random {number + 1}", "random", moments, drawn_vector(rng), drawn_attitude(rng))


FREE_FAMILIES = (short_axis, long_axis, flips, near_stable_axis, near_unstable_axis, near_separatrix, separatrix,
                 symmetric, near_symmetric, spheres, flat, needles, far_apart, unordered, scales, steady, real,
                 random)  # fmt: skip
