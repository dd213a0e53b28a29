"""The end of a disk: one exponent for each law, t0 as energy alone foretells it, and what happens before."""

import jax.numpy as jnp
import numpy as np
import pytest

import polhode as ph
from polhode.errors import InvalidInput, NotConverged
from polhode.rolling import (
    AirLayer,
    BoundaryLayer,
    DrillingFriction,
    DryContourFriction,
    EulerDisk,
    RollingCouple,
    ViscousContourFriction,
)
from polhode.rolling.euler_disk._power_law import fit_singularity, power_law
from polhode.rolling.euler_disk.spin_down import END_OF_REGIME, adiabatic_end, spin_down
from sweeping import only

MASS, RADIUS, GRAVITY = 0.4387, 0.0381, 9.80665
CLASSES = (AirLayer, BoundaryLayer, ViscousContourFriction, DryContourFriction, RollingCouple, DrillingFriction)
NONE = 1e-60  # a coefficient that does nothing: all disks then are of one type and are compiled once
BALANCE = 1e-10  # of E(0)
TILT = 0.02


def disk_with(**coefficients):
    laws = [law(coefficients.get(law.__name__, NONE)) for law in CLASSES]
    return EulerDisk(MASS, RADIUS, dissipation=laws)


CASES = [
    (AirLayer, 4e-6, 1 / 3, 4.0),
    (BoundaryLayer, 2e-9, 4 / 9, 4.0),
    (ViscousContourFriction, 2e-8, 1 / 2, 4.0),
    (DryContourFriction, 2e-5, 2 / 3, 4.0),
    (RollingCouple, 1e-4, 2.0, 2.0),
]


@pytest.mark.sweep
@pytest.mark.parametrize(
    ("law", "coefficient", "exponent", "decades"), only(CASES[:1], CASES), ids=[case[0].__name__ for case in CASES]
)
def test_each_law_has_its_exponent(law, coefficient, exponent, decades):
    assert law.exponent == exponent
    disk = disk_with(**{law.__name__: coefficient})
    found = spin_down(disk, disk.rolling_state(TILT), decades)
    assert found.energy_balance < BALANCE
    assert abs(found.tilt.exponent / exponent - 1) < 0.01
    assert abs(found.precession.exponent / (-exponent / 2) - 1) < 0.01
    assert abs(found.precession_by_tilt.exponent + 0.5) < 0.005
    # the stated uncertainty covers the truth
    for fit, wanted in ((found.tilt, exponent), (found.precession, -exponent / 2), (found.precession_by_tilt, -0.5)):
        assert abs(fit.exponent - wanted) < 4 * fit.uncertainty < 0.04
    # energy alone foretells the end but for corrections of the order of the tilt
    assert abs(found.end / adiabatic_end(disk, TILT) - 1) < TILT
    assert (np.diff(found.remaining) < 0).all() and abs(found.remaining[0] / found.end - 1) < 1e-12
    if exponent < 2:
        assert list(found.events) == [END_OF_REGIME, "flat"]
        force = np.asarray(disk.normal_force(jnp.asarray(found.trajectory.states)))
        assert force.min() > 0.19 * MASS * GRAVITY
        assert found.trajectory.states[-1, 5] < -0.01  # at finite speed
        assert found.adiabaticity[-1] > 0.3
    else:
        assert found.events == {} and found.first_event is None
        assert found.remaining[-1] < 1e-1 * found.remaining[0]


@pytest.mark.sweep
def test_the_wrong_exponent_is_told_apart():
    """The tolerances above tell neighbouring laws apart, and α^(−1/2) from 1/α."""
    disk = disk_with(ViscousContourFriction=2e-8)
    found = spin_down(disk, disk.rolling_state(TILT))
    assert abs(found.tilt.exponent / (4 / 9) - 1) > 0.1
    assert abs(found.precession_by_tilt.exponent + 1.0) > 0.4  # Ω ∝ 1/α is a slip


@pytest.mark.sweep
def test_laws_add_up():
    """Air near the end, rolling friction before: the exponent comes down from 2 to 1/3."""
    disk = disk_with(AirLayer=1e-7, RollingCouple=4e-5)
    found = spin_down(disk, disk.rolling_state(0.05))
    times, tilt = found.remaining, found.trajectory.states[:, 0]
    inside = np.flatnonzero(found.adiabaticity < 0.02)
    slopes = np.diff(np.log(tilt[inside])) / np.diff(np.log(times[inside]))
    assert slopes[0] > 1.0 > 0.75 > slopes[-25:-15].mean()
    assert abs(found.end / adiabatic_end(disk, 0.05) - 1) < 0.01
    # fitted where air takes four fifths of the power: its own exponent, within twice the stated uncertainty
    assert abs(found.tilt.exponent - 1 / 3) < 2 * found.tilt.uncertainty < 0.05
    assert abs(found.unspun_by_tilt.exponent + 0.5) < 2 * found.unspun_by_tilt.uncertainty + 1e-3
    assert found.energy_balance < BALANCE


@pytest.mark.sweep
def test_drilling_alone_has_no_end():
    """By energy alone the tilt would fall as t⁻²; in the full motion the disk first stops turning on its contact."""
    disk = disk_with(DrillingFriction=1e-3)
    start = disk.rolling_state(0.1)
    assert adiabatic_end(EulerDisk(MASS, RADIUS, dissipation=[DrillingFriction(1e-3)]), 0.1) is None
    found = ph.simulate(disk, start, np.linspace(0.0, 0.6, 13))
    s, c = np.sin(found.states[:, 0]), np.cos(found.states[:, 0])
    vertical = found.states[:, 6] * s + found.states[:, 7] * c
    assert vertical[0] > 1.0 and abs(vertical[-1]) < 1e-3  # what drives it on, the capped couple holds
    assert found.states[-1, 0] > 0.097 and found.drift["energy"] < BALANCE
    assert float(disk.power(jnp.asarray(found.states[-1]))) < 1e-3 * float(disk.power(start))
    with pytest.raises(NotConverged, match="takes nothing any more"):
        spin_down(disk, start)


@pytest.mark.long
def test_foretold_ends_are_those_of_the_literature():
    """Thin uniform disk, one law at a time, to first order in the tilt."""
    m, a, g, tilt = MASS, RADIUS, GRAVITY, 1e-4
    rate = np.sqrt(4 * g / a)
    for law, k, wanted in (
        (AirLayer, 1.8e-5, tilt**3 * m / (2 * np.pi * 1.8e-5 * a)),
        (BoundaryLayer, 1e-9, (2 / 3) * m * g * a * tilt ** (9 / 4) / (1e-9 * (4 * g / a) ** (5 / 4))),
        (ViscousContourFriction, 1e-7, 3 * m * a**2 * tilt**2 / (16 * 1e-7)),
        (DryContourFriction, 1e-4, tilt**1.5 / (1e-4 * rate)),
        (RollingCouple, 1e-5, 3 * a * np.sqrt(tilt) / (1e-5 * rate)),
    ):
        assert abs(adiabatic_end(EulerDisk(m, a, dissipation=[law(k)]), tilt) / wanted - 1) < 1e-6


def test_fits_find_what_was_put_in():
    ahead = np.geomspace(1.0, 1e-6, 60)
    found = fit_singularity(-np.diff(ahead), 3.0 * ahead**0.4)
    assert abs(found.law.exponent - 0.4) < 1e-6 and abs(found.distance / 1e-6 - 1) < 1e-4
    since = np.geomspace(1.0, 1e4, 60)
    found = fit_singularity(np.diff(since), since**-2.0)
    assert abs(found.law.exponent + 2.0) < 1e-6 and abs(found.distance - 1.0) < 1e-4
    bent = power_law(ahead, ahead**0.4 * (1 + 0.1 * ahead))
    assert abs(bent.exponent - 0.4) < bent.uncertainty and bent.uncertainty > 1e-3


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda d: spin_down(EulerDisk(MASS, RADIUS), d.rolling_state(0.1)), "rolls for ever"),
        (lambda d: spin_down(d, d.rolling_state(0.1), decades=0.0), "`decades`"),
        (lambda d: spin_down(d, d.rolling_state(0.1).at[5].set(-8.0)), "not in the asymptotic regime"),
        (lambda d: spin_down(d, np.zeros(8)), "lies flat"),
    ],
)
@pytest.mark.usefixtures("any_type")
def test_bad_input(call, words):
    with pytest.raises(InvalidInput, match=words):
        call(disk_with(AirLayer=1e-5))
