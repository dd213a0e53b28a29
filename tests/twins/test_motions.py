"""Every implementation of the closed forms gives the oracle's values, in every hard family; a new one needs a row."""

import pkgutil

import numpy as np
import pytest
from flint import ctx

import polhode.exact
import polhode.rotation
from oracle.lagrange import reference_top
from polhode._base.arrays.elementwise import WAYS
from polhode.exact._closed_form import COMPILING, Compiled, Kernels
from reference.solvers import REFERENCE, ROOT
from twins.families import BODIES, KINDS, TOPS
from twins.motions import (
    COMMITTED,
    PROMISE,
    SEED,
    SMALLEST,
    TABLE,
    WORK,
    Answers,
    Motion,
    as_text,
    by_oracle,
    committed,
    drawn,
    errors,
    line_of,
    worst_per_family,
)
from twins.motions_implementations import EXACT, IMPLEMENTATIONS, balls_of

SWEPT = 3000
"""Of each family."""
ROWS_CHECKED = 2
"""Of each family of the table, which are computed once more."""
NO_SOLVERS = {"README.md", "package.json", "index.d.ts", "gather.mjs", "polhode_cases.h"}
"""In reference/: words, types, what packs them, a table of cases; ``stepped/`` has other motions and its own tests."""
LOST = Motion("planar_separatrix", (0.9682719346341885, 0.9682719346341885, 0.18551392144253734),
              (-0.14539832407994902, 0.0, 0.0), (0.9968674072078577, 0.07909091254172769, 0.0, 0.0), 0.0,
              0.8725861054209123, -272062461253.76263)  # fmt: skip
"""A pendulum within rounding of the separatrix, of which C once gave L1 = −.57253538739 for −.57253538536."""


def rows(names, mark=lambda name: ()):
    """Return the implementations for ``parametrize``, those that lack a program skipped."""
    return [
        pytest.param(name, id=name, marks=[
            *mark(name), *([] if IMPLEMENTATIONS[name].needs else [pytest.mark.skip("its program is missing")])
        ]) for name in names
    ]  # fmt: skip


def share(kind, count):
    """Return the first ``count`` motions of each family of the table, and their answers."""
    motions, answers = committed(kind)
    chosen = [k for k in range(len(motions)) if k % COMMITTED < count]
    return [motions[k] for k in chosen], Answers(*(x[chosen] for x in answers))


def check(title, motions, found, announce):
    worst = worst_per_family(motions, found)
    announce(as_text(title, worst))
    bad = int(np.argmax(found.worst))
    assert found.worst[bad] <= PROMISE, (motions[bad], found.worst[bad])


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("name", rows(
    [name for name, row in IMPLEMENTATIONS.items() if row.by_default],
    lambda name: [pytest.mark.long] if IMPLEMENTATIONS[name].is_long else [],
))  # fmt: skip
def test_the_table(name, kind, announce):
    row = IMPLEMENTATIONS[name]
    motions, answers = share(kind, row.by_default)
    check(f"{name}, the table", motions, errors(row.states(motions), answers), announce)


@pytest.mark.parametrize(("kind", "count"), [
    ("body", 2), ("top", 2), *(pytest.param(kind, COMMITTED, marks=pytest.mark.sweep) for kind in KINDS)
])  # fmt: skip
def test_balls_hold_the_table(kind, count):
    """The enclosures of ``ph.certify``, far narrower than the table's last digit, reach to its rounded values."""
    motions, answers = share(kind, count)
    for motion, state, size in zip(motions, answers.states, answers.sizes, strict=True):
        with ctx.workprec(WORK):
            for ball, value, unit in zip(balls_of(motion), state.tolist(), [1.0] * 4 + [size] * 3, strict=True):
                assert float(ball.rad()) <= 1e-20 * unit
                assert abs(ball - value).lower() <= np.spacing(abs(value)) + SMALLEST * unit, motion


@pytest.mark.sweep
@pytest.mark.parametrize(("kind", "family"), [(kind, name) for kind, names in KINDS.items() for name in names])
def test_sweep_of_a_family(kind, family, announce):
    motions = drawn(kind, SWEPT, SEED + 1, (family,))
    answers = by_oracle(motions)
    for name, row in IMPLEMENTATIONS.items():
        if row.is_swept and row.needs:
            check(f"{name}, {SWEPT} drawn", motions, errors(row.states(motions), answers), announce)


# ---------------------------------------------------------------------- the table, and what it has to see


def test_the_table_has_every_family_and_what_its_writer_writes():
    """What is drawn takes NumPy's powers and sines, whose last places are those of the processor that drew."""
    assert TABLE.stat().st_size <= 2_000_000
    text = TABLE.read_text("utf-8")
    for kind, names in KINDS.items():
        motions, _ = committed(kind)
        assert [m.family for m in motions] == [name for name in names for _ in range(COMMITTED)]
        for first in range(0, len(motions), COMMITTED):
            assert all(line_of(motion) in text for motion in motions[first : first + ROWS_CHECKED])
        for motion, again in zip(motions, drawn(kind, COMMITTED, SEED), strict=True):
            np.testing.assert_allclose(motion.moments, again.moments, rtol=1e-13)


def test_the_table_is_of_many_motions():
    for kind, names in (("body", BODIES), ("top", TOPS)):
        motions, answers = committed(kind)
        assert len({m[1:] for m in motions}) >= 0.95 * len(names) * COMMITTED
        assert np.allclose(np.linalg.norm(answers.states[:, :4], axis=1), 1.0, rtol=0.0, atol=1e-15)
        assert sum(m.epoch != 0.0 for m in motions) > 0.3 * len(motions)


@pytest.mark.parametrize("name", rows(k for k, row in IMPLEMENTATIONS.items() if row.by_default and not row.is_long))
def test_a_pendulum_within_rounding_of_the_separatrix(name):
    found = IMPLEMENTATIONS[name].states([LOST])
    assert abs(found[0, 4] + 0.5725353853578885) < PROMISE * 2.0**-52
    assert errors(found, by_oracle([LOST])).worst[0] <= PROMISE


def test_the_oracle_has_the_published_number_of_that_pendulum():
    assert float(reference_top(*(LOST[k] for k in (1, 5, 2, 3, 6))).momentum[0]) == -0.5725353853578885


def test_a_phase_off_by_1e_14_is_seen():
    _, answers = share("body", 5)
    half = np.array([np.cos(0.5e-14), 0.0, 0.0, np.sin(0.5e-14)])
    turned = np.concatenate([polhode.rotation.multiply(half, answers.states[:, :4]), answers.states[:, 4:]], axis=1)
    assert errors(answers.states, answers).worst.max() == 0.0
    assert np.median(errors(turned, answers).attitude) > PROMISE
    flipped = answers.states * np.array([-1.0] * 4 + [1.0] * 3)
    assert errors(flipped, answers).quaternion.min() > 1e15 and errors(flipped, answers).attitude.max() == 0.0
    assert np.isinf(errors(np.full_like(answers.states, np.nan), answers).worst).all()


# ---------------------------------------------------------------------- every implementation has its row


def files_without_a_row(folder):
    claimed = {path.name for row in IMPLEMENTATIONS.values() for pattern in row.files for path in folder.glob(pattern)}
    return {path.name for path in folder.glob("[!.]*") if path.is_file()} - claimed - NO_SOLVERS


def test_every_file_of_reference_has_a_row(tmp_path):
    assert not files_without_a_row(REFERENCE)
    assert all(list(REFERENCE.glob(pattern)) for row in IMPLEMENTATIONS.values() for pattern in row.files)
    for name in ("polhode.rs", "free_body.h", "polhode.jl"):
        (tmp_path / name).touch()
    assert files_without_a_row(tmp_path) == {"polhode.rs", "free_body.h", "polhode.jl"}


def test_every_engine_of_python_has_a_row():
    assert {row.way for row in IMPLEMENTATIONS.values() if row.way} == set(WAYS)
    packages = {module.name for module in pkgutil.iter_modules(polhode.exact.__path__) if module.ispkg}
    assert packages == set(EXACT.values()) and set(EXACT) == set(KINDS)
    entries = {name for row in IMPLEMENTATIONS.values() for name in row.kernels}
    functions = {*Kernels._fields, *Compiled._fields} - {"unflatten"}
    assert entries == set(COMPILING) | {"set_up_one", "state_at"} == functions


@pytest.mark.parametrize(("page", "words"), [
    ("docs/accuracy.md", f"{len(BODIES)} families of bodies and {len(TOPS)} families of tops"),
    ("docs/accuracy.md", f"over {len(TOPS)} families"), ("docs/accuracy.md", f"In all {len(BODIES)} families"),
    ("docs/lagrange_top.md", f"one top of each of {len(TOPS)} families"),
    ("reference/README.md", f"{len(BODIES)} families of bodies and {len(TOPS)} of tops"),
    ("reference/README.md", f"free bodies, {SWEPT * len(BODIES):,} | tops, {SWEPT * len(TOPS):,}"),
])  # fmt: skip
def test_pages_say_how_many_families_there_are(page, words):
    assert words in " ".join((ROOT / page).read_text("utf-8").split())
