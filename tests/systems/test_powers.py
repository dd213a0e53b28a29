"""What many copies of one algebra conserve: one entry of as many numbers, not as many entries."""

import jax.numpy as jnp
import numpy as np
import pytest

import polhode as ph
from polhode import algebra as lie
from polhode import systems
from polhode.formats.csv_table import read_csv, write_csv
from polhode.formats.dataset import write_dataset
from polhode.formats.dataset_reading import read_dataset
from polhode.reports.wording import drifts

ROUNDING = 1e-14
COUNT = 256
TIMES = np.linspace(0.0, 0.05, 3)


def chain(w):
    return -jnp.sum(w[:-1] * w[1:]) - 0.3 * jnp.sum(w[:, 2] ** 2)


def directions(*shape):
    values = np.random.default_rng(3).normal(size=(*shape, 3))
    return values * np.arange(1.0, shape[-1] + 1.0)[:, None] ** 0.1


def simulated(state, **more):
    system = systems.LiePoisson(lie.Power(lie.SO3(), state.shape[-2]), chain)
    return ph.simulate(system, state, TIMES, step=0.05, order=2, estimate_error=False, **more)


@pytest.mark.long
def test_many_copies_have_one_entry():
    state = directions(COUNT)
    found = simulated(state)
    assert set(found.invariants) == {"energy", "|L|²"}
    squares = found.invariants["|L|²"]
    assert squares.shape == (3, COUNT) and found.drift["|L|²"].shape == (COUNT,)
    assert np.abs(squares / np.sum(found.states**2, axis=-1) - 1.0).max() < ROUNDING
    wanted = np.abs(squares - squares[:1]).max(axis=0) / (2.0 * squares[0])  # Σ |x ∂C/∂x| of squares is twice their sum
    assert np.abs(found.drift["|L|²"] - wanted).max() < 1e-3 * wanted.max() and wanted.max() < ROUNDING
    assert len(repr(found).splitlines()) < 10 and "|L|² " in repr(found)
    assert drifts(found.drift).count("|L|²") == 1


@pytest.mark.long
def test_batches_of_copies_and_their_drift():
    found = simulated(directions(2, 4))
    assert found.invariants["|L|²"].shape == (2, 3, 4) and found.drift["|L|²"].shape == (2, 4)
    assert ph.as_dataset(found)["|L|²"].dims == ("batch_0", "time", "copy")
    assert found.between(0.0, 0.02).invariants["|L|²"].shape == (2, 1, 4)


@pytest.mark.long_after(1)
@pytest.mark.parametrize("count", [2, 3])
def test_copies_in_files(tmp_path, count):
    """Three copies are not the components of a vector."""
    found = simulated(directions(count))
    dataset = ph.as_dataset(found)["|L|²"]
    assert dataset.dims == ("time", "copy") and dataset.attrs["drift"] == found.drift["|L|²"].max()
    again = read_dataset(write_dataset(found, tmp_path / "spins.nc"))
    assert (again.invariants["|L|²"] == found.invariants["|L|²"]).all() and again.quantity("|L|²").of_copies
    table = read_csv(write_csv(found, tmp_path / "spins.csv"))
    assert (table.invariants["|L|²_1"] == found.invariants["|L|²"][:, 1]).all()


@pytest.mark.long
def test_names_of_powers_of_powers_and_of_sums():
    power = lie.Power(lie.Power(lie.SO3(), 2), 3)
    mu = directions(5, 3, 2)
    assert power.named_casimirs(mu)["|L|²"].shape == (5, 6)
    assert np.abs(power.named_casimirs(mu)["|L|²"] - np.sum(mu**2, axis=-1).reshape(5, 6)).max() < ROUNDING * 10
    both = lie.Product(lie.SO3(), lie.Power(lie.SO3(), 2))
    named = both.named_casimirs(np.arange(9.0))
    assert float(named["|L|² of 0"]) == 5.0 and named["|L|² of 1"].tolist() == [50.0, 149.0]
    assert both.casimir_names == ("|L|² of 0", "|L|² of 0 of 1", "|L|² of 1 of 1")
    system = systems.LiePoisson(both, lambda m: jnp.sum(m**4))
    found = ph.simulate(system, np.arange(9.0) / 9.0, TIMES, estimate_error=False)
    assert found.invariants["|L|² of 1"].shape == (3, 2) and max(map(np.max, found.drift.values())) < 1e-6
    assert found.drift["|L|² of 1"].max() < ROUNDING
