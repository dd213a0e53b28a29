"""Claims about all bodies and all tops that the solver z3 decides by itself, without a certificate."""

import time

import pytest

z3 = pytest.importorskip("z3")
SECONDS = 2.0  # of one claim; each takes some hundredths


def holds(*conditions):
    solver = z3.Solver()
    solver.set("timeout", 20_000)
    solver.add(*conditions)
    before = time.process_time()
    answer = solver.check()
    assert time.process_time() - before < SECONDS
    return answer == z3.unsat


I1, I2, I3, L = z3.Reals("I1 I2 I3 L")
ORDERED = [0 < I1, I1 < I2, I2 < I3, L != 0]


def square_of_rate(about, one, other):
    """λ² of the linearised flow about an axis of moment ``about``: (1/I_a − 1/I_b)(1/I_c − 1/I_a) L²."""
    return (1 / about - 1 / one) * (1 / other - 1 / about) * L * L


def test_the_outer_axes_oscillate_and_the_middle_one_grows():
    assert holds(*ORDERED, z3.Not(square_of_rate(I3, I2, I1) < 0))
    assert holds(*ORDERED, z3.Not(square_of_rate(I1, I3, I2) < 0))
    assert holds(*ORDERED, z3.Not(square_of_rate(I2, I1, I3) > 0))
    assert not holds(*ORDERED, z3.Not(square_of_rate(I2, I1, I3) < 0))


def test_energy_and_momentum_hold_motions_to_the_third_axis():
    x, y, z, u, v, w = z3.Reals("x y z u v w")
    energy = x * x / I1 + y * y / I2 + z * z / I3 == u * u / I1 + v * v / I2 + w * w / I3
    momentum = x * x + y * y + z * z == u * u + v * v + w * w
    bound = (I3 / I2 - 1) * (u * u + v * v) <= (I3 / I1 - 1) * (x * x + y * y)
    assert holds(*ORDERED, energy, momentum, z3.Not(bound))
    assert not holds(*ORDERED, energy, z3.Not(bound))


def test_moments_of_points_obey_the_triangle_inequality():
    masses = z3.Reals("m1 m2 m3")
    places = [z3.Reals(f"x{k} y{k} z{k}") for k in range(3)]
    pairs = list(zip(masses, places, strict=True))
    xx = sum(m * (y * y + z * z) for m, (_, y, z) in pairs)
    yy = sum(m * (x * x + z * z) for m, (x, _, z) in pairs)
    zz = sum(m * (x * x + y * y) for m, (x, y, _) in pairs)
    assert holds(*(m >= 0 for m in masses), z3.Not(zz <= xx + yy))
    assert not holds(z3.Not(zz <= xx + yy))


def test_a_sleeping_top_has_a_weight_that_makes_its_form_definite():
    """a² > 4 I1 mgl, for the momentum a about the axis: a weight x with I1 x² − a x + mgl < 0 exists exactly then."""
    a, moment, weight, x = z3.Reals("a I1 mgl x")
    positive = [moment > 0, weight > 0]
    some = z3.Exists([x], moment * x * x - a * x + weight < 0)
    assert holds(*positive, a * a > 4 * moment * weight, z3.Not(some))
    assert holds(*positive, a * a <= 4 * moment * weight, some)
