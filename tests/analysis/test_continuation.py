"""Branches of equilibria: Stoner and Wohlfarth's folds, gyrostats' pitchforks, a sleeping top's Hopf bifurcation."""

import jax.numpy as jnp
import numpy as np
import pytest
from scipy.optimize import brentq

import polhode as ph
from polhode.errors import InvalidInput
from sweeping import first

SO3 = ph.algebra.SO3()


def spin(along_x, along_z):
    """Return a spin with an easy axis z, in a field."""
    return ph.systems.LiePoisson(SO3, lambda m: -0.5 * m[2] ** 2 - along_x * m[0] - along_z * m[2])


@pytest.mark.sweep
@pytest.mark.parametrize("across", first(1, [0.3, 0.05, 0.8]))
def test_folds_lie_on_the_astroid(across):
    """Stoner & Wohlfarth, Phil. Trans. R. Soc. A 240 (1948) 599: |h_x|^⅔ + |h_z|^⅔ = 1."""
    found = ph.analysis.continue_equilibria(lambda h: spin(across, h), (-1.0, 1.0), [0.0, 0.0, 1.0])
    switching = (1.0 - across ** (2.0 / 3.0)) ** 1.5
    assert [one.kind for one in found.bifurcations] == ["fold", "fold"]
    assert np.abs([one.value for one in found.bifurcations] - switching * np.array([-1.0, 1.0])).max() < 1e-11
    hysteresis = found.branches[found.bifurcations[0].branches[0]]
    assert set(hysteresis.verdicts) == {"stable", "unstable"} and set(hysteresis.negative) == {0, 1}
    # between the folds there are four equilibria, beyond them two
    for h in (0.5 * switching, 0.5 * (1.0 + switching)):
        crossed = sum(np.sum((b.values[1:] > h) != (b.values[:-1] > h)) for b in found.branches)
        assert crossed == (4 if h < switching else 2)


@pytest.mark.sweep
def test_a_rotor_makes_the_middle_axis_stable_by_a_pitchfork():
    """A gyrostat's middle axis is stable once (L − h)/I2 < L/I3, here from h = ½ on; the arms are rotations aside."""
    make = lambda h: ph.systems.Gyrostat((1.0, 2.0, 4.0), (0.0, h, 0.0))  # noqa: E731
    found = ph.analysis.continue_equilibria(make, (0.0, 0.9), [0.0, 1.0, 0.0])
    (one,) = found.bifurcations
    assert one.kind == "pitchfork" and abs(one.value - 0.5) < 1e-12 and np.abs(one.point - [0.0, 1.0, 0.0]).max() < 1e-7
    assert len(one.branches) == 2
    for number in one.branches:
        branch = found.branches[number]
        if np.abs(branch.points[:, 1] - 1.0).max() < 1e-9:
            for h, verdict in zip(branch.values, branch.verdicts, strict=True):
                assert abs(h - 0.5) < 1e-6 or verdict == ("unstable" if h < 0.5 else "stable")
        else:  # at angular velocity ω3 = L3/I3 = ω2 = (L2 − h)/I2 about a common axis: L2 = 2 h
            assert np.abs(branch.points[:, 1] - 2.0 * branch.values).max() < 1e-9


@pytest.mark.sweep
def test_a_top_falls_asleep_by_a_hamiltonian_hopf_bifurcation():
    """An upright top is unstable above mgl = (I3 ω)²/(4 I1); its circle of rests that lean is one branch."""
    make = lambda mgl: ph.systems.HeavyTop((1.0, 1.0, 0.5), mgl)  # noqa: E731
    found = ph.analysis.continue_equilibria(make, (0.1, 2.0), [0.0, 0.0, 2.0, 0.0, 0.0, 1.0], starts=16)
    (one,) = found.bifurcations
    assert one.kind == "Hamiltonian Hopf" and abs(one.value - 1.0) < 1e-9
    assert np.abs(one.point - [0.0, 0.0, 2.0, 0.0, 0.0, 1.0]).max() < 1e-9 and len(found.branches) == 3


@pytest.mark.sweep
def test_branches_that_cross_and_fold():
    """On the circle x = cos θ, y = sin θ rests lie at θ = 0, π and where b = 1 − .9 sin θ − 1/cos θ."""
    def make(b):
        return ph.systems.LiePoisson(SO3, lambda m: -m[0] + 0.5 * (b - 1.0) * m[1] ** 2 + 0.3 * m[1] ** 3)

    found = ph.analysis.continue_equilibria(make, (-1.0, 1.5), [0.0, 0.0, 1.0])
    turn = brentq(lambda t: np.sin(t) + 0.9 * np.cos(t) ** 3, -1.5, 0.0)
    crossing, fold = found.bifurcations
    assert (crossing.kind, fold.kind) == ("transcritical", "fold") and len(crossing.branches) == 2
    assert abs(crossing.value) < 1e-9 and abs(fold.value - (1.0 - 0.9 * np.sin(turn) - 1.0 / np.cos(turn))) < 1e-11
    for branch in found.branches:
        on = np.abs(branch.points[:, 2]) < 1e-9
        angle = np.arctan2(branch.points[:, 1], branch.points[:, 0])
        aside = on & (np.abs(branch.points[:, 1]) > 1e-6)
        wanted = 1.0 - 0.9 * np.sin(angle) - 1.0 / np.cos(angle)
        assert on.all() and np.abs(branch.values - wanted)[aside].max(initial=0.0) < 1e-9


@pytest.mark.parametrize(
    ("make", "limits", "words"),
    [
        (lambda h: spin(0.3, h), (1.0, -1.0), "`limits` must be a lowest and a higher value"),
        (lambda h: None, (0.0, 1.0), "`make` must give Lie–Poisson systems that conserve energy"),
        (lambda h: ph.systems.DoubleBracket((1.0, 2.0, 3.0), 0.1 + h), (0.0, 1.0), "conserve energy"),
    ],
)
def test_what_is_no_family_is_refused(make, limits, words):
    with pytest.raises(InvalidInput, match=words):
        ph.analysis.continue_equilibria(make, limits, jnp.array([0.0, 0.0, 1.0]))


@pytest.mark.long
def test_a_circle_of_equilibria_is_no_pitchfork():
    """On sl(2) ½h² + e² + f² is half the Casimir h² + 4ef plus (e − f)²: all of h² + 4e² = C, e = f, is at rest."""
    c = np.zeros((3, 3, 3))
    for i, j, k, value in ((0, 1, 1, 2.0), (0, 2, 2, -2.0), (1, 2, 0, 1.0)):
        c[i, j, k], c[j, i, k] = value, -value
    sl2 = ph.algebra.from_structure_constants(c)
    found = ph.analysis.continue_equilibria(
        lambda p: ph.systems.LiePoisson(sl2, lambda m: 0.5 * m[0] ** 2 + p * m[1] ** 2 + m[2] ** 2), (0.2, 3.0),
        [0.0, 1.0, 1.0],
    )  # fmt: skip
    (circle,) = found.bifurcations
    assert circle.kind == "circle" and circle.value == pytest.approx(1.0, abs=1e-9)
    assert circle.branches == (0, 1, 2, 3)
    h, e, f = circle.point
    assert (e - f, h**2 + 4 * e * f) == pytest.approx((0.0, 4.0), abs=1e-8)
