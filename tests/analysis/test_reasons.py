"""What a verdict was reached by, as data: against numbers known by hand, and no sentence says another number."""

import mpmath
import numpy as np
import pytest

import polhode as ph
from analysis.test_certificates import UNDECIDED, borel, e1, e3, fluid
from polhode import analysis, rolling, spacecraft, systems
from polhode.analysis import _reasons as reasons
from polhode.analysis.energy_casimir import energy_casimir
from polhode.analysis.first_method import first_method

CLOSE = 1e-12


def test_the_axes_of_a_free_body_have_the_curvatures_of_their_energy():
    """H − |L|²/(2 I_i) bends by 1/I_j − 1/I_i along δL_j; about axis 2 neighbours leave at a rate known by hand."""
    I, norm = (mpmath.mpf(1), mpmath.mpf(2), mpmath.mpf(3)), mpmath.mpf("2.5")  # noqa: E741
    for i, found in enumerate(analysis.axis_stability((1.0, 2.0, 3.0), 2.5)):
        wanted = {j + 1: float(1 / I[j] - 1 / I[i]) for j in range(3) if j != i}
        assert isinstance(found.reason, reasons.AxisOfFreeBody)
        assert found.reason.moment == float(I[i]) and found.reason.curvatures == pytest.approx(wanted, rel=CLOSE)
    second = analysis.axis_stability((1.0, 2.0, 3.0), 2.5)[1].reason
    rate = float(norm * mpmath.sqrt((I[1] - I[0]) * (I[2] - I[1]) / (I[0] * I[2])) / I[1])
    assert second.values["rate"] == pytest.approx(rate, rel=CLOSE) and f"exp({rate:.6g}/s" in str(second)


def test_a_steady_drift_has_its_rate():
    """Beside the equator of a symmetric body L2 grows at |L| (1/I1 − 1/I3) δL3."""
    found = ph.stability(systems.FreeRigidBody((1.0, 1.0, 2.0)), 3.0 * e1)
    assert isinstance(found.reason, reasons.SteadyDrift) and found.rate == 0.0
    assert found.reason.drift_rate == pytest.approx(3.0 * (1.0 - 0.5), rel=1e-9)
    assert np.abs(found.reason.direction) == pytest.approx([0.0, 1.0, 0.0], abs=1e-9)


def test_exponents_stand_beside_what_they_were_compared_with():
    for matrix, verdict, largest in (
        ([[-1.0, 5.0], [0.0, -2.0]], "stable", -1.0),
        ([[1.0, 5.0], [0.0, -2.0]], "unstable", 1.0),
        ([[0.0, 1.0], [-4.0, 0.0]], "undecided", 0.0),
    ):
        found = first_method(np.array(matrix))
        assert isinstance(found.reason, reasons.Exponents) and found.verdict == verdict
        assert found.reason.real_part == pytest.approx(largest, abs=CLOSE)
        assert (found.reason.real_part > found.reason.sure_from > 0.0) == (verdict == "unstable")
        assert found.reason.all_negative == (verdict == "stable")


@pytest.mark.long
def test_what_is_left_open_says_by_how_much():
    system, point, options, _ = UNDECIDED["a balance of gyroscopes"]
    found = ph.stability(system, point, **options).reason
    assert isinstance(found, reasons.OpenVariation) and found.signs_differ
    assert found.function.signature[0] and found.function.signature[2] and found.real_part <= found.sure_from
    system, point, options, _ = UNDECIDED["a leaf of equilibria"]
    found = ph.stability(system, point, **options).reason
    assert isinstance(found, reasons.LeafOfEquilibria) and found.shear <= found.sure_from
    # no multiple of dC = e3 is dH = e1, which is all that is left of it
    flow = np.array([[0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 0.0, 0.0]])
    found = energy_casimir(flow, e1, np.eye(3), [e3], [0.0 * np.eye(3)], is_equilibrium=True).reason
    assert isinstance(found, reasons.NoCombination) and found.allowed < found.residual == pytest.approx(1.0)


@pytest.mark.long
def test_a_leaf_s_own_extremum_has_its_dimension_and_neighbours():
    """The leaf of se(3)* through Π = e3, P = 0 is the sphere of Π's, of dimension 2, and singular."""
    found = ph.stability(fluid, np.eye(6)[2])
    assert isinstance(found.reason, reasons.DefiniteOnLeaf)
    assert (found.reason.dimension, found.reason.leaves_nearby) == (2, "larger")
    system, point, options, _ = UNDECIDED["Casimirs that are missing"]
    missing = ph.stability(system, point, **options).missing
    assert missing is not None and (missing.count, missing.needed) == (0, borel().dim - ph.poisson.orbit_dimension(
        borel(), np.random.default_rng(1).normal(size=5)))  # fmt: skip


@pytest.mark.long
def test_restrictions_name_what_they_leave_out():
    top = systems.BodyInPotential((1.0, 1.0, 0.5), lambda up: up[2])
    tilted = np.array([0.0, 0.0, 0.0, 0.0, 0.0, -1.0])
    assert ph.stability(top, tilted).restricted is None
    disk = rolling.EulerDisk(mass=1.0, radius=1.0, gravity=3.0)
    found = ph.stability(disk, disk.rolling_state(np.pi / 2, 0.0, 1.01))
    assert found.restricted is not None and found.restricted.without == ("heading", "place")
    assert found.restriction == "in tilt and rates, not in heading and place"
    assert str(reasons.Restriction(flows=("J1", "J2"))) == "up to the flows of J1, J2"


def test_the_sentence_is_printed_from_the_data():
    """Another number or function in the reason is another in the sentence."""
    found = ph.stability(systems.FreeRigidBody((1.0, 2.0, 3.0)), 2.0 * np.eye(3)[1])
    assert f"exp({found.rate:.6g}/s" in found.certificate
    faster = reasons.ExponentialGrowth(7.0, found.reason.direction)
    assert "exp(7/s" in str(faster) and faster.values["title"] == "exponential growth"
    stable = ph.stability(systems.FreeRigidBody((1.0, 2.0, 3.0)), 2.0 * e3).reason
    assert isinstance(stable, reasons.DefiniteVariation) and "function" not in stable.values
    assert "|K|²" in str(stable.rename({stable.function.names[0]: "|K|²"}))


def test_of_a_circle_and_a_sphere_of_rests():
    """Across the equator of an oblate body the double bracket pulls L to the poles of a prolate one's circle."""
    alpha, norm, moments = 0.1, 2.0, (1.0, 3.0, 3.0)
    found = spacecraft.damped_axis_stability(systems.DoubleBracket(moments, alpha), norm)[2]
    assert isinstance(found.reason, reasons.SettlesOnCircle)
    # L̇ = −α L × (L × Ω): along δL1 beside L = e3 it is −α |L|² (1/I1 − 1/I3) δL1
    assert found.reason.rate == pytest.approx(-alpha * norm**2 * (1.0 - 1.0 / 3.0), rel=1e-9)
    sphere = spacecraft.damped_axis_stability(systems.DoubleBracket((2.0, 2.0, 2.0), alpha), norm)[0]
    assert isinstance(sphere.reason, reasons.SphereOfRests)
    assert isinstance(first_method(np.zeros((0, 0))).reason, reasons.LeafIsPoint)


@pytest.mark.long
def test_words_for_people_have_no_formula_and_say_which_extremum():
    least, middle, largest = (found.words for found in analysis.axis_stability((1.0, 2.0, 3.0), 2.5))
    assert "energy is at its greatest" in least and "internal loss" in least
    assert "neither" in middle and "leave exponentially" in middle
    assert largest == "the energy is at its least for this |L|"
    hanging = ph.stability(systems.HeavyTop((1.0, 1.0, 2.0), 1.0), [0.0, 0.0, 0.0, 0.0, 0.0, -1.0])
    assert hanging.verdict == "stable" and hanging.words.startswith("the energy is at its least among motions with the")
    for system, point, options, _ in UNDECIDED.values():
        words = ph.stability(system, point, **options).words
        assert len(words) > 20 and not any(mark in words for mark in "½δ=Σ∂")
