"""Thousands of broken specs: each is read, or refused in one message; no other error, no warning, no long wait."""

import contextlib
import faulthandler
import io
import re
import shutil
import signal
import warnings

import pytest
from hypothesis import HealthCheck, given, seed, settings
from hypothesis import strategies as st

from polhode.cli.render import as_json, print_report
from polhode.errors import PolhodeError
from polhode.kinds.reading import read_spec
from polhode.reports.about import about_body
from polhode.reports.answer import collect_values, plain
from spec.mutations import CHANGE, EXAMPLES, FILES, KEYS, KINDS, bases, mutated

LONGEST_MESSAGE = 2000  # characters
LONGEST_WAIT = 10  # s of the processor, so that a busy machine changes nothing
CASES, MANY_CASES = 500, 4_500
FEW_SAMPLES = 1000
BASES = bases()
CHANGES = st.tuples(st.sampled_from(sorted(BASES)), st.lists(CHANGE, min_size=1, max_size=3))


def stop(signum, frame):
    raise TimeoutError(f"took more than {LONGEST_WAIT} s")


@contextlib.contextmanager
def limited():
    """A case may take so long; where Python itself does not come round to say so, the process ends with a traceback."""
    before = signal.signal(signal.SIGVTALRM, stop)
    signal.setitimer(signal.ITIMER_VIRTUAL, LONGEST_WAIT)
    faulthandler.dump_traceback_later(30 * LONGEST_WAIT, exit=True)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_VIRTUAL, 0)
        faulthandler.cancel_dump_traceback_later()
        signal.signal(signal.SIGVTALRM, before)


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    made = tmp_path_factory.mktemp("fuzz")
    for name in FILES:
        shutil.copy(EXAMPLES / name, made)
    return made


def printed_report(spec):
    """Return what the report on a free body prints, as text and as JSON."""
    report = spec.report()
    written = io.StringIO()
    with contextlib.redirect_stdout(written):
        print_report(spec.name, report.summary, report.answers, report.notes, [])
    return written.getvalue(), as_json(report.as_json_dict())


def check(text, folder):
    """Read a spec, and if it is of a free body make its report; every outcome is success or one good message."""
    path = folder / "case.toml"
    path.write_bytes(text.encode("utf-8", "surrogateescape"))
    with limited(), warnings.catch_warnings(record=True) as noise:
        warnings.simplefilter("always")
        # one changed digit moves a date past the installed table, which is rightly said, and once a process
        warnings.filterwarnings("ignore", message="leap seconds are known until")
        try:
            spec = read_spec(path)
            assert spec.name.isprintable()
            if spec.body is not None:
                as_json(plain(collect_values([about_body(spec.body)])))
            if spec.kind.is_default and spec.samples <= FEW_SAMPLES:
                words, _ = printed_report(spec)
                assert not re.search(r"\b(nan|inf)\b", words, re.IGNORECASE), words
        except PolhodeError as error:
            said = str(error)
            assert 0 < len(said) < LONGEST_MESSAGE
            assert all(line.isprintable() for line in said.split("\n")), ascii(said)
    assert not noise, [str(one.message) for one in noise]


def fuzz(folder, start, cases):
    @seed(start)
    @settings(max_examples=cases, database=None, deadline=None, print_blob=False,
              suppress_health_check=list(HealthCheck))
    @given(CHANGES)
    def run(case):
        check(mutated(BASES[case[0]], case[1]), folder)

    run()


@pytest.mark.sweep
def test_mutated_specs(folder, any_type):
    fuzz(folder, 0, CASES)


@pytest.mark.sweep
@pytest.mark.parametrize("start", range(1, 5))
def test_many_mutated_specs(folder, any_type, start):
    fuzz(folder, start, MANY_CASES)


FOUND = {
    "the sum of an inertia and its transpose overflows": """
[body]
inertia = [["1e308 J*s^2", "1 J*s^2", "0 J*s^2"], ["1 J*s^2", "3 J*s^2", "0 J*s^2"], ["0 J*s^2", "0 J*s^2", "3 J*s^2"]]
mass = "2 kg"
about = ["1 m", "0 m", "0 m"]
center_of_mass = ["1 m", "0 m", "0.1 m"]
""",
    "momentum overflows": """
[body]
moments = ["0.61e15 kg*m^2", "0.965e15 kg*m^2", "1.0e15 kg*m^2"]
[spin]
angular_velocity = ["1e300 rad/s", "0 rad/s", "5e-05 rad/s"]
[time]
samples = 9
""",
    "momentum by a rate overflows": """
[body]
moments = ["0.61e15 kg*m^2", "0.965e15 kg*m^2", "1.0e15 kg*m^2"]
[spin]
rate = "1e300 rad/s"
about = "x"
[time]
samples = 9
""",
    "radius of gyration's square overflows": """
[body]
mass = "5.9722e-308 kg"
moments = ["8.010e37 kg*m^2", "8.010e37 kg*m^2", "8.036e37 kg*m^2"]
[spin]
rate = "7.292115e-5 rad/s"
about = 3
[time]
samples = 9
""",
}


@pytest.mark.parametrize("name", FOUND)
def test_what_fuzzing_found(folder, name):
    check(FOUND[name], folder)


def test_a_case_that_does_not_end_is_noticed(monkeypatch):
    monkeypatch.setitem(globals(), "LONGEST_WAIT", 0.05)
    with pytest.raises(TimeoutError), limited():
        while True:
            pass


def test_every_key_is_drawn():
    """Also those of the tables of kinds, in lists and in inner tables."""
    of_lists = {"shape", "law", "coefficient", "temperature", "precession", "allow_vibration", "damping_time", "epoch"}
    assert of_lists <= set(KEYS) and "lagrange-top" in KINDS


def test_the_bases_are_right_and_many_mutants_are_too(folder):
    """The fuzzer would prove little if all its cases failed at the first key."""
    for tables in BASES.values():
        path = folder / "case.toml"
        path.write_text(mutated(tables, []))
        read_spec(path)
