"""The place of the centre of mass from swings about pivots, against periods by mpmath's elliptic integral."""

import math

import mpmath
import numpy as np
import pytest

import polhode as ph
from polhode.errors import InvalidInput
from polhode.measuring import Jig, Measured, Pivot, Swing, fit_pendulum

G, MASS = 9.80665, 0.3
AMPLITUDE = math.radians(20.0)


def period(moment, place, pivot, jig=(0.0, 0.0, 0.0), mass=MASS):
    """Return 4√((I + md² + I′)/(g(md + m′d′))) K of a body with a jig: moment I′ about the pivot, mass, distance."""
    far = abs(place - pivot)
    whole, leverage = moment + mass * far**2 + jig[0], mass * far + jig[1] * jig[2]
    return 4.0 * math.sqrt(whole / (G * leverage)) * float(mpmath.ellipk(mpmath.sin(AMPLITUDE / 2) ** 2))


def swings_at(pivots, place, moment, error=1e-4, jig=None):
    numbers = (0.0, 0.0, 0.0) if jig is None else (jig.moment.value, jig.mass.value, jig.distance.value)
    return [Swing((1, 0, 0), Pivot(None, p), Measured(period(moment, place, p, numbers), error), AMPLITUDE, jig=jig)
            for p in pivots]  # fmt: skip


def reach(one):
    """Return I/(md) + d [m] that a period tells of."""
    return G * (one / (4.0 * float(mpmath.ellipk(mpmath.sin(AMPLITUDE / 2) ** 2)))) ** 2


def places_by_scanning(pivots, periods):
    """Return the places where two pivots give one positive moment, by the signs of its difference on a fine scan."""
    lengths = [reach(t) for t in periods]
    fine = np.linspace(-1.0, 2.0, 3_000_001) + 1e-7 * math.pi
    one, other = (np.abs(fine - p) * (length - np.abs(fine - p)) for p, length in zip(pivots, lengths, strict=True))
    crosses = np.flatnonzero(((one - other)[:-1] * (one - other)[1:] <= 0.0) & (one[1:] > 0.0))
    return fine[crosses].tolist()


@pytest.mark.parametrize(
    ("pivots", "place", "moment"),
    [((0.3, 0.6), 0.45, 0.012), ((0.3, 0.6), 0.451, 0.012), ((0.0, 0.1), 0.31, 0.0075), ((0.1, 0.5), 0.22, 0.02)],
)
def test_two_pivots_leave_every_place_that_fits(pivots, place, moment):
    swings = swings_at(pivots, place, moment)
    wanted = places_by_scanning(pivots, [swing.period.value for swing in swings])
    assert len(wanted) > 1 and min(abs(s - place) for s in wanted) < 2e-6
    with pytest.raises(InvalidInput, match="do not determine") as refused:
        fit_pendulum(swings, Measured(MASS))
    said = [float(part.split(" m (")[0].split()[-1]) for part in str(refused.value).split("kg m²")[:-1]]
    assert len(said) == len(wanted)
    np.testing.assert_allclose(said, wanted, atol=6e-5)
    assert f"{place:.4g} m ({moment:.4g} kg m²)" in str(refused.value)


@pytest.mark.long_after(6)
@pytest.mark.parametrize("error", [1e-12, 1e-6, 1e-3])
@pytest.mark.parametrize(
    ("pivots", "place"),
    [((0.1, 0.25, 0.8), 0.45), ((0.1, 0.25, 0.8), 0.175), ((0.3, 0.6, 0.7), 0.45), ((0.3, 0.6, 0.2, 0.7), 0.45),
     ((-0.1, 0.0, 0.25), 0.45), ((0.1, 0.25, 0.35), 0.45), ((0.0, 0.4, 0.5), 0.2)],
)  # fmt: skip
def test_places_that_lie_evenly_between_pivots(pivots, place, error):
    fit = fit_pendulum(swings_at(pivots, place, 0.012, error), Measured(MASS))
    assert fit.center is not None
    assert fit.center.value[0] == pytest.approx(place, abs=1e-9)
    assert fit.combined.value[0] == pytest.approx(0.012, abs=1e-10)
    np.testing.assert_allclose(fit.moments.value, 0.012, atol=1e-9)


@pytest.mark.long
def test_three_pivots_at_random():
    draw, hits = np.random.default_rng(7), 0
    for _ in range(60):
        pivots, place = np.sort(draw.uniform(-0.5, 0.5, 3)), draw.uniform(-0.6, 0.6)
        moment = MASS * draw.uniform(0.05, 0.4) ** 2
        if np.min(np.diff(pivots)) < 0.05 or np.min(np.abs(pivots - place)) < 0.02:
            continue
        try:
            fit = fit_pendulum(swings_at(pivots, place, moment, 1e-7), Measured(MASS))
        except InvalidInput as refused:  # two places fit nearly as well
            assert f"{place:.4g} m (" in str(refused)
            continue
        assert fit.center is not None and fit.center.value[0] == pytest.approx(place, abs=1e-8)
        assert fit.combined.value[0] == pytest.approx(moment, rel=1e-6)
        hits += 1
    assert hits > 25


@pytest.mark.long
def test_errors_of_a_place_cover_it():
    draw, off = np.random.default_rng(3), []
    for _ in range(60):
        swings = [one._replace(period=Measured(draw.normal(one.period.value, 2e-4), 2e-4))
                  for one in swings_at((0.1, 0.25, 0.8), 0.45, 0.012)]  # fmt: skip
        fit = fit_pendulum(swings, Measured(MASS))
        off += [(fit.center.value[0] - 0.45) / fit.center.standard_error[0],
                (fit.combined.value[0] - 0.012) / fit.combined.standard_error[0]]  # fmt: skip
    assert 0.75 < np.std(off) < 1.3 and abs(np.mean(off)) < 0.4


def test_pivots_at_the_distance_of_equal_periods_leave_the_place_open():
    """d₁ + d₂ = I/(md₁) + d₁, Kater's: every place between two such pivots gives both periods."""
    place, far = 0.1, 0.1
    moment = MASS * far * 0.25
    pivots = (place - far, place + 0.25)
    both = swings_at(pivots, place, moment)
    assert both[0].period.value == pytest.approx(both[1].period.value, rel=1e-14)
    with pytest.raises(InvalidInput, match=r"anywhere from 0 to 0\.35 m .*do not determine where"):
        fit_pendulum(both, Measured(MASS))
    shifted = both[0]._replace(period=Measured(both[0].period.value * (1 + 2e-5), 1e-4))
    with pytest.raises(InvalidInput, match=r"anywhere from 0 to 0\.35 m"):
        fit_pendulum([shifted, both[1]], Measured(MASS))
    third = fit_pendulum(swings_at((*pivots, 0.5), place, moment), Measured(MASS))
    assert third.center is not None and third.center.value[0] == pytest.approx(place, abs=1e-9)


@pytest.mark.parametrize("place", [0.31, 0.25, 1.05])
def test_a_heavy_jig_reaches_farther_than_its_period_as_a_simple_pendulum(place):
    """The jig's weight shortens the period, so that the centre of mass may be farther from a pivot than that says."""
    jig = Jig(Measured(2.0, 1e-3), Measured(0.11, 1e-5), distance=Measured(0.22, 1e-5))
    pivots = (0.0, 0.25, 0.6)
    swings = swings_at(pivots, place, 0.004, 1e-5, jig)
    assert place != 1.05 or place - pivots[0] > reach(swings[0].period.value)
    fit = fit_pendulum(swings, Measured(MASS))
    assert fit.center is not None and fit.center.value[0] == pytest.approx(place, abs=1e-8)
    assert fit.combined.value[0] == pytest.approx(0.004, abs=1e-8)


@pytest.mark.long
def test_a_place_at_the_pivot_of_a_jig_with_errors():
    jig = Jig(Measured(2.0), Measured(0.11), distance=Measured(0.22))
    draw = np.random.default_rng(4)
    for _ in range(20):
        swings = [one._replace(period=Measured(draw.normal(one.period.value, 1e-5), 1e-5))
                  for one in swings_at((0.0, 0.25, 0.6), 0.25, 0.004, jig=jig)]  # fmt: skip
        fit = fit_pendulum(swings, Measured(MASS))
        assert abs(fit.center.value[0] - 0.25) < 5.0 * fit.center.standard_error[0]
        assert abs(fit.combined.value[0] - 0.004) < 5.0 * fit.combined.standard_error[0]


def test_a_place_that_errors_nearly_exclude_still_counts():
    """Of a body that is nearly a point, periods may give a moment a little below zero: another place is no answer."""
    swings = swings_at((0.0, 0.25), 0.31, 2e-6, 3e-4)
    for shift in (-6e-4, -3e-4, 0.0, 3e-4):
        moved = [swings[0]._replace(period=Measured(swings[0].period.value + shift, 3e-4)), swings[1]]
        try:
            fit = fit_pendulum(moved, Measured(MASS))
        except InvalidInput as refused:
            assert "0.31" in str(refused) or "not positive" in str(refused)
            continue
        assert abs(fit.center.value[0] - 0.31) < 4.0 * fit.center.standard_error[0]


FILE = """
mass = "300 g"
[pendulum]
kind = "compound"
amplitude = "20 deg"
turns = {turns}
"""


def written(tmp_path, pivots, periods, turns=5):
    path = tmp_path / "pivots.toml"
    text = FILE.format(turns=turns)
    for pivot, (one, other) in zip(pivots, periods, strict=True):
        text += f'[[swing]]\naxis = "x"\npivot = "{pivot}"\nperiods = ["{one!r} s", "{other!r} s"]\n'
    path.write_text(text, encoding="utf-8")
    return path


@pytest.mark.parametrize("second", [(6.52, 6.53), (6.521, 6.53)])
def test_two_pivots_of_equal_periods_are_refused(tmp_path, second):
    path = written(tmp_path, ("30 cm", "60 cm"), ((6.52, 6.53), second))
    with pytest.raises(InvalidInput, match="do not determine") as refused:
        ph.fit(path, pendulum=True)
    words = str(refused.value)
    assert "0.7021" not in words and words.count("kg m²") == 3
    assert all(said in words for said in ("0.24", "0.45", "0.65", "0.012", "0.006", "further pivot"))


@pytest.mark.parametrize("turns", [7, 10, 15, 20, 50, 500])
def test_a_wrong_count_of_turns_is_one_sentence(tmp_path, turns):
    exact = [5 * period(0.012, 0.45, p) for p in (0.1, 0.25, 0.35)]
    path = written(tmp_path, ("10 cm", "25 cm", "35 cm"), [(t - 1e-3, t + 1e-3) for t in exact], turns)
    with pytest.raises(InvalidInput, match=r"count of (oscillations|turns)"):
        ph.fit(path, pendulum=True)


def test_what_pivots_too_far_apart_are_told():
    swings = [Swing((1, 0, 0), Pivot(None, p), Measured(0.6, 1e-3)) for p in (0.1, 0.25, 0.35)]
    with pytest.raises(InvalidInput) as refused:
        fit_pendulum(swings, Measured(MASS))
    far = G * (0.6 / (2 * math.pi)) ** 2 * (1.0 + 3.29 * 2.0 * 1e-3 / 0.6)  # with the error of a probability of .001
    assert "0.1 and 0.35 m are 0.25 m apart" in str(refused.value) and f"within {far:.3g}" in str(refused.value)


def test_a_place_on_a_scale_has_any_sign(tmp_path):
    for shift in (-0.1, -0.25):
        pivots = (0.1, 0.25, 0.8)
        exact = [5 * period(0.012, 0.45, p) for p in pivots]
        named = [f"{100 * (p + shift):.6g} cm" for p in pivots]
        report = ph.fit(written(tmp_path, named, [(t - 1e-4, t + 1e-4) for t in exact]), pendulum=True)
        assert report.fit.center.value[0] == pytest.approx(0.45 + shift, abs=1e-6)
        assert any("pivot" in note for note in report.notes if "taken as exact" in note)
