"""What all tests share.

Where annotations are checked, every call in the tests is, except where a test gives a wrong type on purpose: in the
sweeps, and where POLHODE_ANNOTATIONS=checked, as CI sets it. It takes a sixth of the time of the default tests.

Compiled functions are kept on disk for the length of a run, so that workers and subprocesses compile each once, and
are dropped from memory once a worker has grown large. Most time goes into compiling, so the default tests compile
without optimization. The sweeps, and what is compared with the oracle, compile as a user's program does.
"""

import collections
import contextlib
import ctypes
import gc
import os
import re
import shutil
import signal
import sys
import tempfile
from importlib.metadata import EntryPoint, EntryPoints
from pathlib import Path

import jaxtyping
import pytest
from jaxtyping import config, install_import_hook

import polhode
import typed
from lacking import NOT_THERE, missing
from polhode.cli.compiled import QUICKLY, compile_quickly
from registered import forget_entry_points

collect_ignore = NOT_THERE

UNCHECKED = "doubledouble"  # called tens of thousands of times for one motion; its checks took half of its tests' time
SOURCES = Path(polhode.__file__).parent
FILES = [path.relative_to(SOURCES.parent).with_suffix("") for path in SOURCES.rglob("*.py")]

COMPILED = "JAX_COMPILATION_CACHE_DIR"
FASTEST = ("--xla_backend_optimization_level=0", *QUICKLY[1:])  # a fifth of the time
LEAST_RESIDENT, SHARE = 1.4e9, 0.4  # bytes, and of the memory that a worker has: then it gives back, and compiles anew
SELDOM = 20_000, 20, 50  # allocations, and collections of the younger generations, after which Python collects garbage
gc.disable()  # while modules are imported, of which nothing is garbage: a fifth of that time
MAX_SECONDS = 900  # of one test, on a machine that does other things too
MAX_SECONDS_IN_A_BROWSER = 240
MAX_SECONDS_OF_A_SWEEP = 3000
CHROMIUM = Path("/usr/bin/chromium")  # of Debian
WORDS = {"browser": "mark.browser", "sweep": "sweep", "long": "mark.long"}  # by which files are known that have them
SWITCHES = (
    "--headless --no-sandbox --disable-gpu --disable-quic --no-first-run --disable-background-networking "
    "--disable-component-update --disable-sync "
    # without a graphics card four samples for each pixel are half of a picture's time, and no test looks at edges
    "--webgl-antialiasing-mode=none "
    # each window loads two more pages for its address bar, as long as the page under test takes. The last list that
    # is given counts: what playwright's has for pages stands here too
    "--disable-features=WebUIOmniboxPopup,WebUIOmniboxAimPopup,AimEnabled,HttpsUpgrades,MediaRouter,PaintHolding,"
    "OptimizationHints,AvoidUnnecessaryBeforeUnloadCheckSync,DestroyProfileOnBrowserClose"
)


def pytest_configure(config):
    """Name a new folder for compiled functions before workers start, so that every run starts cold; keep no reports."""
    os.environ["POLHODE_REPORTS_CACHE"] = ""
    if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:  # as in a shell's background; tests send it
        signal.signal(signal.SIGINT, signal.default_int_handler)
    if "not sweep" not in config.option.markexpr or os.environ.get("POLHODE_ANNOTATIONS") == "checked":
        check_annotations()
    if getattr(config.option, "numprocesses", None):  # threads of one worker's matrices keep the others waiting
        os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
    if not hasattr(config, "workerinput") and COMPILED not in os.environ:
        os.environ[COMPILED] = config.compiled_here = tempfile.mkdtemp(prefix="polhode-tests-")
        os.environ["JAX_PERSISTENT_CACHE_MIN_COMPILE_TIME_SECS"] = "0"
        os.environ["JAX_PERSISTENT_CACHE_MIN_ENTRY_SIZE_BYTES"] = "-1"
        if "not sweep" in config.option.markexpr or config.option.markexpr == "browser":
            compile_quickly(FASTEST)


def check_annotations():
    """Have every function that is imported from now on check what it is given and returns."""
    jaxtyping.jaxtyped = typed.checked
    files = (".".join(file.parts) for file in FILES if file.name not in ("__init__", UNCHECKED))
    install_import_hook(list(files), "typed.check")


def pytest_unconfigure(config):
    if hasattr(config, "compiled_here"):
        shutil.rmtree(config.compiled_here, ignore_errors=True)


def pytest_collection_finish():
    """Have Python look for garbage seldom, and never among modules and tests: it took a seventh of all time."""
    gc.collect()
    gc.freeze()
    gc.set_threshold(*SELDOM)
    gc.enable()


def pytest_runtest_setup(item):
    typed.now[0] += 1


def says(path, mark):
    """Return whether a file has tests of such a mark, which each such file has to say in these words."""
    return WORDS[mark] in path.read_text("utf-8")


def pytest_ignore_collect(collection_path, config):
    """Where tests of one mark alone are run, leave out files without: each worker took half a minute to import all."""
    asked = re.fullmatch(rf"({'|'.join(WORDS)})( and (not )?[a-z]+)*", config.option.markexpr)
    if asked and collection_path.suffix == ".py":
        return not says(collection_path, asked[1]) or None
    return None


def pytest_collection_modifyitems(config, items):
    """Give every test a time limit: one that stands still fails instead of stopping the run.

    Tests that need what this system lacks are skipped; single cases that take long are told from the others.
    """
    cases = collections.Counter()
    for item in items:
        if is_long(item, cases):
            item.add_marker(pytest.mark.long)
        if lacking := missing(item.function) if hasattr(item, "function") else ():
            item.add_marker(pytest.mark.skip(reason=f"this system has no {', '.join(lacking)}"))
        slow = item.get_closest_marker("sweep")
        in_browser = item.get_closest_marker("browser")
        limit = MAX_SECONDS_OF_A_SWEEP if slow else MAX_SECONDS_IN_A_BROWSER if in_browser else MAX_SECONDS
        if item.get_closest_marker("timeout") is None:
            item.add_marker(pytest.mark.timeout(limit))
    for mark, word in WORDS.items():
        for path in {item.path for item in items if item.get_closest_marker(mark)}:
            if not says(path, mark):
                raise pytest.UsageError(f"{path} has tests of the mark {mark}: it must say `{word}` to be found")
    begin_sweeps_elsewhere(items)
    leave_other_shares(config, items)


def begin_sweeps_elsewhere(items):
    """Put the sweeps of another file first, where POLHODE_SWEEPS is "3/5", and those before it last.

    CI begins at another place each time, and goes on as long as it may: what it leaves out, it takes the next time.
    """
    if place := os.environ.get("POLHODE_SWEEPS"):
        number, of = map(int, place.split("/"))
        files = list(dict.fromkeys(item.path for item in items if item.get_closest_marker("sweep")))
        first = set(files[number % of * len(files) // of :])
        items.sort(key=lambda item: item.path not in first)


def leave_other_shares(config, items):
    """Keep every third file of tests from the second on, where POLHODE_SHARE is "1/3": other runs take the others."""
    if place := os.environ.get("POLHODE_SHARE"):
        number, of = map(int, place.split("/"))
        files = sorted({item.path for item in items})[number % of :: of]
        config.hook.pytest_deselected(items=[item for item in items if item.path not in files])
        items[:] = [item for item in items if item.path in files]


def is_long(item, cases):
    """Return whether this case of a test with parameters takes long; its function counts the cases before it."""
    place, _, own = item.nodeid.partition("[")
    cases[place] += 1
    named = (name for mark in item.iter_markers("long_cases") for name in mark.args)
    first = [mark.args[0] for mark in item.iter_markers("long_after")]
    return any(own == f"{name}]" for name in named) or any(cases[place] > count for count in first)


@pytest.fixture
def without_home(monkeypatch):
    """Have this user have no home directory, as in containers under a number that belongs to nobody."""

    def find_nobody(number):
        raise KeyError(number)

    monkeypatch.delenv("HOME", raising=False)
    monkeypatch.setattr(pytest.importorskip("pwd"), "getpwuid", find_nobody)
    with pytest.raises(RuntimeError):
        Path.home()


@pytest.fixture(autouse=True)
def small_memory():
    """Give back what compiling left over and, where that is not enough, what was compiled.

    The C library keeps what the compiler frees, and JAX every function: 6 GB in the end. What is needed again comes
    from disk.
    """
    yield
    if _resident() > MOST_RESIDENT:
        _give_back()
        if _resident() > MOST_RESIDENT and "jax" in sys.modules:
            sys.modules["jax"].clear_caches()
            gc.collect()
            _give_back()


def _give_back():
    with contextlib.suppress(OSError, AttributeError):  # where the C library has no such call
        ctypes.CDLL(None).malloc_trim(0)


def _resident():
    pages = Path("/proc/self/statm")
    return int(pages.read_text().split()[1]) * os.sysconf("SC_PAGE_SIZE") if pages.exists() else 0


def _most_resident():
    """Return the bytes from which a worker gives memory back."""
    if not hasattr(os, "sysconf") or "SC_PHYS_PAGES" not in os.sysconf_names:
        return LEAST_RESIDENT
    workers = int(os.environ.get("PYTEST_XDIST_WORKER_COUNT", "1"))
    return max(LEAST_RESIDENT, SHARE * os.sysconf("SC_PHYS_PAGES") * os.sysconf("SC_PAGE_SIZE") / workers)


MOST_RESIDENT = _most_resident()


@pytest.fixture(scope="session")
def browser():
    """Chromium, which pip cannot bring: the README's test command skips without it, CI installs and requires it.

    One for all tests of a worker: playwright cannot be started twice in a process.
    """
    if not CHROMIUM.exists() and os.environ.get("POLHODE_BROWSER") != "required":
        pytest.skip(f"{CHROMIUM} is missing")
    with pytest.importorskip("playwright.sync_api").sync_playwright() as playwright:
        opened = playwright.chromium.launch(executable_path=str(CHROMIUM), args=SWITCHES.split())
        yield opened
        opened.close()


@pytest.fixture(scope="session")
def windows(browser):
    """Windows of the browser, which tests take and give back."""
    from windows import Windows

    return Windows(browser)


@pytest.fixture(scope="module")
def plugin():
    """Have packages of others on the path, found by their entry points as installed ones are, during one file's tests.

    The registries cache what they find. Unless they are cleared, later files find the plugin's format among ours.
    """
    folder = Path(__file__).parent / "plugin"
    sys.path.insert(0, str(folder))
    forget_entry_points()
    yield folder
    sys.path.remove(str(folder))
    forget_entry_points()


@pytest.fixture
def add_entry_points(monkeypatch):
    """Have further entry points of one group found, during a test; what the registries cache of them is cleared."""
    from polhode._base import plugins

    real, added = plugins.entry_points, {}

    def add(group, *points):
        added[group] = [EntryPoint(name, value, group) for name, value in points]
        forget_entry_points()

    def find(group=None):
        groups = plugins.GROUPS if group is None else (group,)
        return EntryPoints(point for name in groups for point in (*real(group=name), *added.get(name, ())))

    monkeypatch.setattr(plugins, "entry_points", find)
    yield add
    forget_entry_points()


@pytest.fixture
def any_type():
    """What a user's call without a type checker does."""
    config.update("jaxtyping_disable", True)
    yield
    config.update("jaxtyping_disable", False)


@pytest.fixture
def announce(record_property):
    """Say something at the end of the run, from any worker."""
    return lambda text: record_property("announced", text)


def pytest_terminal_summary(terminalreporter):
    for reports in terminalreporter.stats.values():
        for report in reports:
            if getattr(report, "when", None) == "call":
                for name, text in report.user_properties:
                    if name == "announced":
                        terminalreporter.write_line("\n" + text)
