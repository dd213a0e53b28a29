"""Spins on lattices: exact motions, dipoles against direct sums, damping in closed form, and what is refused."""

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np
import pytest

import polhode as ph
from polhode import fields
from polhode.errors import InvalidInput
from polhode.fields import Bond, Lattice, SpinLattice, SublatticeTurns, exchange_matrix
from polhode.fields.spin_lattice._bonds import classes
from polhode.integrators import SphericalMidpoint, Splitting
from polhode.testing import LawBroken, check_system

RNG = np.random.default_rng(3)
UP = (0.0, 0.0, 1.0)


def chain(count=8, matrix=1.0, **more):
    return SpinLattice(Lattice([[1.0]], shape=(count,)), 1.0, [Bond(0, 0, (1,), matrix)], **more)


def cubic(size=4, periodic=True, bonds=True, **more):
    cells = [(1, 0, 0), (0, 1, 0), (0, 0, 1)] if bonds else []
    return SpinLattice(Lattice(np.eye(3), shape=(size,) * 3, periodic=periodic), 1.0,
                       [Bond(0, 0, c, 1.0) for c in cells], **more)  # fmt: skip


def end(system, start, span, method, step, order=2):
    return np.asarray(ph.solve(system, start, [0.0, span], method, step, order=order).end_state)


@pytest.mark.long_after(4)
@pytest.mark.parametrize("periodic", [True, False])
@pytest.mark.parametrize(("shape", "cell"), [((5, 4), (1, 0)), ((5, 4), (-1, 1)), ((7, 1), (2, 0)), ((2, 3), (1, 1)),
                                             ((3, 3), (2, 0)), ((6, 5), (0, -3))])  # fmt: skip
def test_energy_and_classes_of_bonds(shape, cell, periodic):
    """Against a loop over bonds; in a class no site occurs twice, and the classes hold each bond once."""
    lattice = Lattice(np.eye(2), shape=shape, periodic=periodic)
    matrix = RNG.normal(size=(3, 3))
    system = SpinLattice(lattice, 1.0, [Bond(0, 0, cell, matrix)])
    spins = RNG.normal(size=(*shape, 1, 1, 3))
    total, bonds = 0.0, set()
    for place in np.ndindex(*shape):
        last = tuple(np.add(place, cell))
        if periodic or all(0 <= n < size for n, size in zip(last, shape, strict=True)):
            last = tuple(np.mod(last, shape))
            total -= spins[place][0, 0] @ matrix @ spins[last][0, 0]
            bonds.add((place, last))
    assert abs(float(system.energy(spins)) - total) < 1e-12
    listed = []
    for mask in classes(lattice, system.bonds[0]):
        firsts = [tuple(p[:2]) for p in np.argwhere(mask).tolist()]
        pairs = [(p, tuple(np.mod(np.add(p, cell), shape))) for p in firsts]
        sites = [site for pair in pairs for site in pair]
        assert len(set(sites)) == len(sites)
        listed += pairs
    assert len(listed) == len(bonds) and set(listed) == bonds


@pytest.mark.long_cases("Splitting")
@pytest.mark.parametrize("method", [Splitting, SphericalMidpoint])
def test_total_spin_and_lengths_stay(method):
    system = cubic(4)
    start = np.asarray(system.aligned(RNG.normal(size=(4, 4, 4, 1, 3))))
    last = end(system, start, 2.0, method, 0.05)
    assert np.abs(last - start).max() > 0.5
    assert np.abs((last - start).sum(axis=(0, 1, 2, 3))).max() < 1e-12
    assert np.abs(np.linalg.norm(last, axis=-1) - 1.0).max() < 2e-15
    assert abs(float(system.energy(last) - system.energy(start))) < 0.3


@pytest.mark.long
def test_cone_is_exact_and_both_methods_have_order_two():
    """A ferromagnet's cone of any angle turns by −2JS cosθ (1 − cos k), k = 2π/4."""
    place, tilt, spin = np.arange(8), 0.8, 1.0
    angle = np.pi / 2 * place

    def cone(turn):
        parts = [np.sin(tilt) * np.cos(angle + turn), np.sin(tilt) * np.sin(angle + turn), np.cos(tilt) + 0 * angle]
        return spin * np.stack(parts, axis=-1)[:, None, None, None]

    expected = cone(-2.0 * spin * np.cos(tilt))
    for method in (Splitting, SphericalMidpoint):
        errors = [np.abs(end(chain(), cone(0.0), 1.0, method, h) - expected).max() for h in (0.1, 0.05)]
        assert 1e-5 < errors[1] < 2e-3 and 1.9 < np.log2(errors[0] / errors[1]) < 2.1
    assert np.abs(end(chain(), cone(0.0), 1.0, Splitting, 0.05, 8) - expected).max() < 1e-10


def defect(solver, state):
    """Return how far a step is from a Poisson map: |D Π(S) Dᵀ − Π(S₁)|, by automatic derivatives."""

    def tensor(spins):
        blocks = [np.cross(np.eye(3), s) for s in np.asarray(spins).reshape(-1, 3)]
        return jax.scipy.linalg.block_diag(*blocks)

    def step(flat):
        return (state + solver.change(0.0, 0.1, state + (flat - state.ravel()).reshape(state.shape)).state).ravel()

    change = jax.jacfwd(step)(state.ravel()) + np.eye(state.size)
    last = state + solver.change(0.0, 0.1, state).state
    return float(jnp.abs(change @ tensor(state) @ change.T - tensor(last)).max())


@pytest.mark.sweep
def test_sublattice_turns_keep_the_energy_but_are_no_poisson_map():
    system = chain(4, exchange_matrix((1.0, 0.8, 0.5)), field=(0.0, 0.1, 0.4))
    state = jnp.asarray(system.aligned(RNG.normal(size=(4, 1, 1, 1, 3))))
    turns = SublatticeTurns(system, 0.1, np.arange(4).reshape(4, 1, 1, 1) % 2)
    result = ph.solve(system, state, [0.0, 5.0], turns).end_state
    assert abs(float(system.energy(result) - system.energy(state))) < 2e-14
    assert np.abs(np.asarray(result) - end(system, state, 5.0, Splitting, 0.02, 6)).max() < 0.1
    assert defect(turns, state) > 1e-5
    assert defect(Splitting(system, 0.1, 2), state) < 1e-14
    with pytest.raises(InvalidInput, match="bond between"):
        SublatticeTurns(system, 0.1, np.zeros((4, 1, 1, 1), int))


def test_dipoles_equal_the_direct_sum():
    lattice = Lattice([[1.0, 0.1, 0.0], [0.3, 0.9, 0.2], [0.0, 0.1, 1.2]], [[0.0, 0, 0], [0.4, 0.3, 0.5]],
                      shape=(3, 2, 2), periodic=False)  # fmt: skip
    system = SpinLattice(lattice, 1.0, dipolar=1.0)
    spins = RNG.normal(size=(3, 2, 2, 2, 3))
    places, flat = lattice.positions().reshape(-1, 3), spins.reshape(-1, 3)
    gaps = places[:, None] - places[None]
    distance = np.linalg.norm(gaps, axis=-1) + np.eye(len(places))
    field = 3 * gaps * np.einsum("abi,bi->ab", gaps, flat)[..., None] / distance[..., None] ** 5
    field -= ((1 - np.eye(len(places))) / distance**3)[..., None] * flat[None]
    direct = field.sum(axis=1)
    result = np.asarray(system.effective_field(spins)).reshape(-1, 3)
    assert np.abs(result - direct).max() < 4e-15 * np.abs(direct).max()
    assert abs(float(system.energy(spins)) + 0.5 * np.sum(direct * flat)) < 1e-13


@pytest.mark.long
def test_dipoles_of_a_cube_and_a_chain():
    cube = cubic(5, periodic=False, bonds=False, dipolar=1.0)
    assert abs(float(cube.energy(cube.aligned((1.0, 2.0, 3.0))))) < 1e-12
    long = SpinLattice(Lattice([[1.0]], shape=(2001,), periodic=False), 1.0, dipolar=1.0)
    middle = np.asarray(long.effective_field(long.aligned((1.0, 0.0, 0.0))))[1000, 0, 0, 0]
    assert np.abs(middle - [4 * 1.2020569031595942 - 2 / 1000.5**2, 0, 0]).max() < 1e-8


@pytest.mark.long
def test_damping_in_closed_form():
    """S_z/s = tanh(λBt), azimuth −Bt; the energy falls by what the power says."""
    damping, field, spin, span = 0.2, 1.3, 1.5, 4.0
    one = SpinLattice(Lattice([[1.0]], shape=(1,)), spin, field=(0.0, 0.0, field), damping=damping)
    start = one.aligned((1.0, 0.0, 0.0))
    polar = np.tanh(damping * field * span)
    across = np.sqrt(1 - polar**2)
    expected = spin * np.array([across * np.cos(field * span), -across * np.sin(field * span), polar])
    errors = [np.abs(end(one, start, span, SphericalMidpoint, h)[0, 0, 0, 0] - expected).max() for h in (0.1, 0.05)]
    assert 1e-5 < errors[1] < 1e-2 and 1.95 < np.log2(errors[0] / errors[1]) < 2.05
    balance = one.balances(0.0, start)["energy"]
    rate = jax.jvp(one.energy, (start,), (one.vector_field(0.0, start),))[1]
    assert abs(float(rate - balance.rate)) < 1e-13 and float(rate) < 0


def test_which_components_of_the_total_spin_are_kept():
    tilted = exchange_matrix((1.0, 1.0, 0.5), (0.0, 0.0, 0.3))
    assert len(chain().kept) == 3
    assert np.abs(np.abs(chain(matrix=tilted).kept) - [UP]).max() < 1e-12
    assert chain(matrix=tilted, field=(0.1, 0.0, 0.0)).kept == ()
    assert np.abs(np.abs(chain(field=(0.0, 2.0, 0.0)).kept) - [(0.0, 1.0, 0.0)]).max() < 1e-12


class WrongSign(SpinLattice):
    def effective_field(self, point):
        return super().effective_field(point) - 2.0 * self.field


class OneBondShort(SpinLattice):
    @property
    def flows(self):
        return dict(list(super().flows.items())[1:])


@pytest.mark.long_after(1)
@pytest.mark.parametrize(("broken", "law"), [(WrongSign, "velocity"), (OneBondShort, "flows")])
def test_broken_lattices_are_found(broken, law):
    system = broken(Lattice([[1.0]], shape=(2,), periodic=False), 1.0, [Bond(0, 0, (1,), 1.0)], field=(0, 0, 0.5))
    with pytest.raises(LawBroken, match=law):
        check_system(system)


@pytest.mark.parametrize(
    ("make", "words"),
    [
        (lambda: Lattice([[1.0, 0.0], [2.0, 0.0]], shape=(2, 2)), "independent"),
        (lambda: Lattice([[1.0]], shape=(2, 2)), "one entry"),
        (lambda: Lattice([[1.0]], [[0.0], [0.0]], (2,)), "different places"),
        (lambda: SpinLattice(Lattice([[1.0]], shape=(4,)), dipolar=1.0), "open boundaries"),
        (lambda: SpinLattice(Lattice([[1.0]], shape=(4,)), bonds=[Bond(0, 1, (1,), 1.0)]), "the basis has 0 to 0"),
        (lambda: SpinLattice(Lattice([[1.0]], shape=(4,)), bonds=[Bond(0, 0, (0,), 1.0)]), "onsite"),
        (lambda: SpinLattice(Lattice([[1.0]], shape=(4,)), onsite=[[0, 1, 0], [0, 0, 0], [0, 0, 0]]), "symmetric"),
        (lambda: SpinLattice(Lattice([[1.0]], shape=(4,)), field=np.ones((3, 3))), "must fit"),
        (lambda: SpinLattice(Lattice([[1.0]], shape=(4,)), spin=-1.0), "`spin` must be positive finite numbers"),
        (lambda: chain(1).flows, "itself in a periodic lattice"),
        (lambda: fields.exchange_matrix(np.ones((2, 2))), "finite"),
    ],
)
def test_what_is_refused(make, words):
    with pytest.raises(InvalidInput, match=words):
        make()


@pytest.mark.sweep
def test_derivative_by_the_field():
    """A gradient through steps, by the field, against a difference."""
    start = np.asarray(chain(4).aligned(RNG.normal(size=(4, 1, 1, 1, 3))))

    def end_energy(field):
        system = chain(4, field=(0.0, 0.0, 1.0))
        system = eqx.tree_at(lambda s: s.field, system, field)
        return jnp.sum(ph.solve(system, start, [0.0, 0.3], Splitting, 0.1, order=2).end_state[..., 0])

    field, change = jnp.array([0.0, 0.0, 1.0]), jnp.array([0.0, 0.0, 1e-5])
    slope = float(jax.jit(jax.grad(end_energy))(field)[2])
    quotient = float(end_energy(field + change) - end_energy(field - change)) / 2e-5
    assert abs(slope - quotient) < 1e-8 * max(1.0, abs(slope))


@pytest.mark.long
def test_verdicts_take_the_total_spin_by_components():
    """Alike spins are at the least or the greatest energy of those with this total spin."""
    for exchange in (1.0, -1.0):
        chain = SpinLattice(Lattice([[1.0]], shape=(4,)), bonds=[Bond(0, 0, (1,), exchange * np.eye(3))])
        result = ph.stability(chain, chain.aligned(np.broadcast_to([0.0, 0.0, 1.0], (4, 1, 1, 1, 3))))
        assert result.verdict == "stable" and "total spin, 3" in result.words
