"""The kernel as Python and as Numba compiles it, of one copy and of eight: the same bits, each where it is worth it."""

import jax.numpy as jnp
import numpy as np
import pytest

from polhode import celestial, fields, systems
from polhode._base.compiled import kept
from polhode.motion._outcome import Status
from polhode.taylor import advancing, kernels, lanes, straight_line
from polhode.taylor.machine import build_machine
from polhode.taylor.program import FACTOR, Program
from polhode.taylor.runs import choose_precision, run_copies


class OfAllFunctions(systems.AbstractSystem):
    """A motion with every function that has a recurrence, and a quantity that it conserves, and events."""

    watched: bool = True

    def vector_field(self, t, state):
        a, b, c, d = state
        return jnp.stack([
            jnp.exp(-(a**2)) * jnp.sin(b) + jnp.cos(t), jnp.sqrt(1.0 + c**2) * a,
            jnp.log(3.0 + a**2) - b / (2.0 + c**2) + 0.1 * jnp.tanh(a * b) - 0.1 * jnp.log1p(c**2) * jnp.expm1(-(b**2)),
            0.0 * d,
        ])  # fmt: skip

    def invariants(self, state):
        return {"d": state[3]}

    @property
    def events(self):
        return {"low": lambda t, y: y[0] + 0.75, "high": lambda t, y: 2.3 - jnp.sin(t) * y[2]} if self.watched else {}


class Nested(systems.AbstractSystem):
    """Products of products, with nothing between them."""

    def vector_field(self, t, state):
        a, b, c = state
        return jnp.stack([b * c, -a * c * (a * b), (a * b) * (a * c) * (b * c) - a])

    def invariants(self, state):
        return {}


class Blowing(systems.AbstractSystem):
    """A motion that does not last."""

    def vector_field(self, t, state):
        return state**2

    def invariants(self, state):
        return {}


def cases():
    """Yield systems, a start, and how far copies start from it."""
    yield systems.FreeRigidBody((1.0, 2.0, 3.0)), np.array([0.3, 1.9, 0.1]), 0.1
    top = systems.HeavyTop((1.0, 2.0, 3.0), 1.0, (0.0, 0.6, 0.8))
    yield top, np.array([1.0, 0, 0, 0, 0.5, 1.0, 2.0, 0, 0, 1.0]), 0.1
    vortices = fields.PlaneVortices(np.array([1.0, -0.7, 0.4]))
    yield vortices, vortices.pack([[0.0, 0.0], [1.0, 0.2], [-0.3, 0.9]]), 0.1
    yield OfAllFunctions(), np.array([0.1, 0.2, 0.3, 1.0]), 0.3
    yield OfAllFunctions(False), np.array([0.1, 0.2, 0.3, 1.0]), 0.3
    yield Nested(), np.array([0.5, -0.7, 0.9]), 0.1
    yield celestial.SpinOrbit(0.9, 0.3, 1.0, 0.7), np.array([0.4, 1.3]), 0.1
    yield Blowing(), np.array([1.0, -1.0]), 0.3
    yield systems.HeavyTop((1.0, 2.0, 3.5), 0.0, (0.0, 0.0, 1.0)), np.array([1.0, 0, 0, 0, 0, 0, 0, 0, 0, 1.0]), 0.0


def motions(copies=1, alone=False):
    """Return what becomes of copies, together or each alone, forwards and backwards."""
    found = []
    for system, start, kick in cases():
        starts = start + kick * np.random.default_rng(0).normal(size=(copies, *np.shape(start)))
        for last in (3.0, -3.0):
            given = system, np.linspace(0.0, last, 7), choose_precision(1e-10)
            parts = starts[:, None] if alone else [starts]
            runs = [run_copies(given[0], part, *given[1:])[:-1] for part in parts]
            found.extend(np.concatenate(column) for column in zip(*runs, strict=True))
    return found


def assert_same_bits(one, other):
    for x, y in zip(one, other, strict=True):
        np.testing.assert_array_equal(x, y)


@pytest.fixture
def by(monkeypatch):
    """Let one kernel move all copies."""
    return lambda use: monkeypatch.setattr("polhode.taylor.advancing.choose_kernel", lambda copies, extended=False: use)


@pytest.mark.long
def test_compiled_or_not_the_bits_are_the_same(by):
    by(kernels.python_kernel(1))
    plain = motions()
    by(kernels.compile_kernel(1))
    assert_same_bits(plain, motions())


@pytest.mark.parametrize("width", [1, pytest.param(lanes.LANES, marks=pytest.mark.long)])
def test_times_need_not_lie_beside_each_other_in_memory(by, width):
    """Every fourth of an array, and one that is read from its end, as users hand them in."""
    by(kernels.compile_kernel(width))
    system, start, _ = next(cases())
    precision, times = choose_precision(None), np.linspace(0.0, 10.0, 65)
    for some in (times[::4], times[::-1]):
        apart, beside = (run_copies(system, start[None], given, precision).states for given in (some, some.copy()))
        np.testing.assert_array_equal(apart, beside)


@pytest.mark.parametrize(("function", "start"), [(jnp.exp, 800.0), (jnp.sin, np.inf), (jnp.log, -1.0),
                                                 (jnp.expm1, 800.0), (jnp.log1p, -2.0), (jnp.log1p, -1.0)])
@pytest.mark.parametrize("width", [1, lanes.LANES])
def test_functions_of_what_they_are_not_for_end_no_run_in_an_error_of_pythons(by, width, function, start):
    class Of(systems.AbstractSystem):
        def vector_field(self, t, state):
            return function(state)

        def invariants(self, state):
            return {}

    by(kernels.python_kernel(width))
    found = run_copies(Of(), np.array([[start]]), np.array([0.0, 1.0]), choose_precision(None))
    assert found.status[0] == Status.NOT_CONVERGED and np.isnan(found.end[0])


@pytest.mark.sweep
def test_lanes_change_no_bit(by):
    """Eleven copies, of which three wait for a lane, and some end early, against each alone."""
    by(kernels.compile_kernel(1))
    alone = motions(11, alone=True)
    assert len({int(status) for status in np.concatenate(alone[2::10])}) == 3  # there are all kinds of ends
    assert_same_bits(alone, motions(11))
    by(kernels.compile_kernel(lanes.LANES))
    assert_same_bits(alone, motions(11))


@pytest.mark.long
def test_lanes_as_python_change_no_bit_either(by):
    by(kernels.compile_kernel(1))
    alone = motions(2)
    by(kernels.python_kernel(lanes.LANES))
    assert_same_bits(alone, motions(2))


@pytest.mark.sweep
@pytest.mark.parametrize(("make", "copies"), [(kernels.compile_kernel, 11), (kernels.python_kernel, 1)])
@pytest.mark.parametrize("width", [1, lanes.LANES])
def test_written_code_changes_no_bit(by, monkeypatch, width, make, copies):
    by(make(width))
    monkeypatch.setattr(kernels, "LIMITS", kernels.LIMITS._replace(min_seconds_of_operation=np.inf))
    from_tables = motions(copies)
    monkeypatch.setattr(kernels, "LIMITS", kernels.LIMITS._replace(min_seconds_of_operation=-1.0))
    written = []
    own = straight_line.generate
    monkeypatch.setattr(straight_line, "generate", lambda *given: written.append(own(*given)) or written[-1])
    assert_same_bits(from_tables, motions(copies))
    assert len({code.address for code in written}) == 9


def test_code_is_that_of_all_programs_that_differ_by_factors():
    """But not of one that has 1 or −1 where another has not, for which it is other code."""
    codes = []
    for moments in ((1.3, 2.0, 3.0), (1.1, 2.3, 3.2)):
        program = build_machine(systems.FreeRigidBody(moments), np.array([0.3, 1.9, 0.1]), None).program
        codes.append(straight_line.generate(program, 1))
    assert codes[0] is codes[1]
    first = program.whole[FACTOR]
    with_one = np.where(np.arange(program.number.size) == first, 1.0, program.number)
    assert program.number[first] != 1.0
    assert straight_line.generate(Program(program.whole, with_one), 1) is not codes[0]


def test_code_that_adds_wrongly_is_seen(by, monkeypatch):
    """A writer of subtraction for addition."""
    by(kernels.compile_kernel(1))
    right = motions()
    straight_line._compile.cache_clear()
    monkeypatch.setattr(straight_line.ir.IRBuilder, "fadd", straight_line.ir.IRBuilder.fsub)
    monkeypatch.setattr(kernels, "LIMITS", kernels.LIMITS._replace(min_seconds_of_operation=-1.0))
    wrong = motions()
    straight_line._compile.cache_clear()
    assert any(not np.array_equal(x, y) for x, y in zip(right, wrong, strict=True))


@pytest.mark.long
def test_calls_that_end_before_the_copies_do_change_no_bit(by):
    by(kernels.compile_kernel(lanes.LANES))
    whole = motions(11)
    by(kernels.compile_kernel(lanes.LANES)._replace(stretch=150))
    assert_same_bits(whole, motions(11))


@pytest.mark.long
def test_threads_change_no_bit(by, monkeypatch):
    by(kernels.compile_kernel(lanes.LANES))
    whole = motions(11)
    monkeypatch.setattr(advancing, "LIMITS", advancing.LIMITS._replace(min_copies_of_thread=4))
    monkeypatch.setattr("os.sched_getaffinity", lambda process: range(3), raising=False)
    assert_same_bits(whole, motions(11))


def test_a_kernel_is_taken_once_it_is_worth_it(monkeypatch):
    monkeypatch.setattr(kernels._Spent, "ready", set())
    monkeypatch.setattr(kernels, "_is_on_disk", lambda width: False)
    one, eight = kernels.compile_kernel(1), kernels.compile_kernel(lanes.LANES)
    for by_python, one_by_one, copies, use in (
        (0.0, 0.0, 100, kernels.python_kernel(1)), (9.98, 0.0, 1, kernels.python_kernel(1)),
        (10.1, 0.0, 100, one), (10.1, 11.98, 100, one), (10.1, 12.1, 7, one), (10.1, 12.1, 8, eight),
    ):  # fmt: skip
        monkeypatch.setattr(kernels._Spent, "by_python", by_python)
        monkeypatch.setattr(kernels._Spent, "one_by_one", one_by_one)
        assert kernels.choose_kernel(copies) is use


def test_a_run_that_is_foreseen_to_be_long_is_compiled_at_once(monkeypatch):
    """Python went on for ten seconds, and the progress meter refused the run, as it would have taken Python hours."""
    class Compiling(Exception):
        pass

    def stop(width):
        raise Compiling

    for name, value in (("ready", set()), ("called", set()), ("by_program", {}), ("by_python", 0.0)):
        monkeypatch.setattr(kernels._Spent, name, value)
    for name, value in (("_is_on_disk", lambda width: False), ("compile_kernel", stop), ("loading_time", lambda: 0.02)):
        monkeypatch.setattr(kernels, name, value)
    body, start = systems.FreeRigidBody((1.0, 2.0, 3.0)), np.array([[0.3, 1.9, 0.1]])
    run_copies(body, start, np.array([0.0, 100.0]), choose_precision(None))  # which is short
    with pytest.raises(Compiling):
        run_copies(body, start, np.array([0.0, 1e6]), choose_precision(None))
    assert kernels._Spent.by_python < 0.5 * kernels.COMPILED[1]


def test_what_compiling_takes_is_no_reason_to_compile_more(monkeypatch):
    monkeypatch.setattr(kernels._Spent, "called", set())
    monkeypatch.setattr(kernels._Spent, "one_by_one", 0.0)
    monkeypatch.setattr(kernels._Spent, "by_program", {})
    program = build_machine(systems.FreeRigidBody((1.0, 2.0, 3.0)), np.array([0.3, 1.9, 0.1]), None).program
    for spent, wanted in ((8.0, 0.0), (0.5, 0.5)):
        kernels.note(kernels.compile_kernel(1), 100, program, spent)
        assert kernels._Spent.one_by_one == kernels._Spent.by_program.get(program.form, 0.0) == wanted


@pytest.mark.parametrize("width", [1, lanes.LANES])
def test_functions_call_each_other_as_they_are_made(width):
    """One that was left with the names of its own file would call what is not compiled."""
    (space,) = {id(space): space for space in kernels._modules(width).by_python().values()}.values()
    own = [value for value in space.values() if getattr(value, "__globals__", None) is space]
    assert len(own) >= 24 and space["advance"] in own and space["first_zero"] in own and space["vectors"] in own
    assert space["LANES"] == width


def test_what_was_compiled_of_other_sources_is_not_used(monkeypatch):
    """The name under which it is kept changes with the digest; what counts there: ``tests/twins``."""
    before = kernels.compile_kernel.__wrapped__(1).advance.name
    monkeypatch.setattr(kept, "digest_compiled", lambda modules, files: "another")
    monkeypatch.setattr(kernels, "_modules", kernels._modules.__wrapped__)
    assert kernels.compile_kernel.__wrapped__(1).advance.name != before
