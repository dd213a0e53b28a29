"""Computes the chunks of a sweep, here or on a Dask cluster, and keeps those that are finished."""

from __future__ import annotations

import asyncio
import contextlib
import hashlib
import os
import platform
import signal
import time
import warnings
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from functools import lru_cache
from multiprocessing import resource_tracker
from pathlib import Path
from typing import Any, NamedTuple

from polhode._base.compiled.threads import available_cores
from polhode._base.extras import needing
from polhode._base.plugins import Plugin, digest_plugins, record_plugins
from polhode._base.plugins.program import program_digest, program_parts
from polhode.errors import InvalidInput, PolhodeError
from polhode.formats.opening import record_files
from polhode.formats.paths import FULL
from polhode.sweeps.columns import Column
from polhode.sweeps.evaluation import STATUS, Evaluator
from polhode.sweeps.layout import Layout
from polhode.sweeps.plan import Plan
from polhode.sweeps.store import Store, check_room, compute_size

NO_DASHBOARD: Any = None
# Dask's own makes the C library give each array back to the system at once, and take new pages for the next: six
# times the CPU time. One thread each, as there is a worker to a core.
ENVIRONMENT = {"MALLOC_TRIM_THRESHOLD_": str(2**28), "MALLOC_MMAP_THRESHOLD_": str(2**27),
               "OMP_NUM_THREADS": "1", "MKL_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1",
               "DASK_LOGGING__DISTRIBUTED": "critical"}  # fmt: skip  # a silent cluster does not silence its workers


class ClusterThresholds(NamedTuple):
    """Numbers that decide whether a cluster is started, and when it is given up, in seconds.

    Attributes:
        min_work: of computing; starting a cluster does not pay for less.
        answer_timeout: in which a cluster must answer.
        worker_timeout: in which a cluster must have a worker; batch systems may start it late.
        stop_timeout: in which workers must end themselves when the sweep is stopped.
    """

    min_work: float = 20.0
    answer_timeout: float = 30.0
    worker_timeout: float = 300.0
    stop_timeout: float = 0.1


LIMITS = ClusterThresholds()


@dataclass(frozen=True, eq=False)
class Sweep:
    """A sweep ready to run, or to go on.

    Attributes:
        plan: of the sweep.
        evaluator: computes samples.
        layout: of the store that it writes.
        read: the files that samples are computed from, with SHA-256 of their content.
        plugins: what takes part of other packages.
    """

    plan: Plan
    evaluator: Evaluator
    layout: Layout
    read: dict[Path, str]
    plugins: frozenset[Plugin]

    @classmethod
    def of(cls, plan: Plan) -> Sweep:
        """Return the sweep of a plan, after a try of its first samples.

        Raises:
            InvalidInput: for outputs that the report does not have, or if no sample can be computed.
        """
        evaluator = Evaluator(plan)
        inputs = [Column(key, (how.length,) if how.length else (), unit=plan.units[key])
                  for key, how in plan.design.inputs.items()]
        with record_files() as read, record_plugins() as plugins:
            columns = (*inputs, *evaluator.columns, Column(STATUS, text=True))
            chunk = evaluator.chunk_size
        read, used = plan.read | read, plan.plugins | plugins
        header = {"title": f"sweep of {plan.path.stem}", "Conventions": "CF-1.11", "seed": plan.design.seed}
        layout = Layout(_parts(plan, read, used), plan.design.count, chunk, plan.keep, columns, plan.times, header)
        return cls(plan, evaluator, layout, read, used)

    @property
    def columns(self) -> tuple[Column, ...]:
        """Of inputs, outputs and status."""
        return self.layout.columns

    @property
    def chunks(self) -> int:
        return self.layout.chunks

    @property
    def bytes(self) -> int:
        """Room that the store may need, with a mark for each chunk."""
        marks = self.chunks * 7000 * len(self.columns)
        return marks + (compute_size(self.columns, self.plan.design.count) if self.plan.keep == "all" else 0)

    @property
    def chunk_bytes(self) -> int:
        """The memory of a chunk's arrays."""
        return compute_size(self.columns, self.evaluator.chunk_size)

    def cost(self) -> float:
        """Return about how many seconds one core will take, by a measurement."""
        count = self.plan.design.count
        if self.evaluator.at_once:
            tried = min(self.evaluator.chunk_size, 128 if self.evaluator.by_steps else 4096)
        else:
            tried = min(count, 8)
        self.evaluator.chunk(0, 1)  # compilation and other work of a first call
        begin = time.perf_counter()
        self.evaluator.chunk(0, tried)
        return (time.perf_counter() - begin) / tried * count

    def usual_workers(self, seconds: float | None = None) -> int:
        """Return how many processes are worth their start, which takes a few seconds.

        Args:
            seconds: that one core takes, where it is known.
        """
        return 1 if (self.cost() if seconds is None else seconds) < LIMITS.min_work else available_cores()

    def begin(self, path: str | Path) -> Store:
        """Return the store to write to, new or begun before.

        Raises:
            InvalidInput: where it cannot be made, or is of another sweep.
        """
        store = Store(path, self.layout)
        done = len(store.list_finished()) if store.home.is_dir() else 0
        check_room(store.path, int(self.bytes * (1.0 - done / self.chunks)))
        store.begin()
        return store

    def run(
        self, store: Store, workers: int, scheduler: str | None = None,
        tell: Callable[[int], object] = lambda samples: None,
    ) -> None:
        """Compute all chunks that are not finished.

        Args:
            store: where to.
            workers: processes of this machine; with one, or with one chunk, it is done in this process.
            scheduler: address of a Dask scheduler, whose workers are used instead.
            tell: called with the number of samples of each chunk that is finished.

        Raises:
            InvalidInput: where the cluster or the disk fails; what is finished stays.
        """
        with store.lock():
            try:
                damage = store.settle()
                if damage.chunks:
                    warnings.warn(f"{store.path}: {damage.chunks} of {self.chunks} finished chunks are damaged, and "
                                  "are computed again.", stacklevel=2)
                if damage.documents:
                    warnings.warn(f"{store.path}: {damage.documents} of its documents on what arrays there are were "
                                  "missing or changed, and are as they were again.", stacklevel=2)
                self._run_missing(store, workers, scheduler, tell)
            except BaseException:
                store.remove_if_empty()
                raise

    def _run_missing(
        self, store: Store, workers: int, scheduler: str | None, tell: Callable[[int], object]
    ) -> None:
        finished = store.list_finished()
        missing = [number for number in range(self.chunks) if number not in finished]
        if scheduler is None and min(workers, len(missing)) <= 1:
            for number in missing:
                with _explain_failure(self, store):
                    _compute(self.evaluator, store, number, self.read, self.plugins)
                tell(self._samples(number))
        elif missing:
            self._distribute(store, missing, min(workers, len(missing)), scheduler, tell)

    def _samples(self, number: int) -> int:
        low, high = self.layout.sample_range(number)
        return high - low

    def _distribute(
        self, store: Store, missing: list[int], workers: int, scheduler: str | None, tell: Callable[[int], object]
    ) -> None:
        from distributed import as_completed

        with _cluster(workers, scheduler) as client, _explain_failure(self, store):
            # workers elsewhere have another present folder
            plan = replace(self.plan, path=self.plan.path.absolute())
            program = program_digest(self.plugins)
            job = client.scatter(_Job(plan, self.layout, self.read, self.plugins, program), broadcast=True, hash=False)
            waiting, place = iter(missing), str(store.path.absolute())
            name = f"polhode-{self.layout.fingerprint[:16]}"

            def hand_out(count: int) -> list[Any]:
                numbers = [number for _, number in zip(range(count), waiting, strict=False)]
                return [client.submit(_compute_remotely, job, place, number, key=f"{name}-{number}", pure=False)
                        for number in numbers]

            per_thread = 2  # chunks, so that no thread waits for the next
            at_work = as_completed(hand_out(per_thread * _threads(client)))
            for future in at_work:
                tell(self._samples(future.result()))
                # workers may have come, or gone
                for new in hand_out(max(0, per_thread * _threads(client) - at_work.count())):
                    at_work.add(new)


@dataclass(frozen=True, eq=False)
class _Job:
    """The data that a worker needs."""

    plan: Plan
    layout: Layout
    read: dict[Path, str]
    plugins: frozenset[Plugin]
    program: str


def _parts(plan: Plan, read: dict[Path, str], plugins: frozenset[Plugin]) -> dict[str, str]:
    """Return digests of all that the samples depend on, by name: the spec, files by content, and the program."""
    folder = plan.path.parent.absolute()
    files = {f"the file {Path(os.path.relpath(path, folder)).as_posix()}": digest for path, digest in read.items()}
    return {"the spec": hashlib.sha256(plan.asked.encode()).hexdigest()} | files | program_parts(plugins)


def _compute(
    evaluator: Evaluator, store: Store, number: int, read: dict[Path, str], plugins: frozenset[Plugin]
) -> None:
    """Compute a chunk and write it, if files and code that it was computed from are still those of the other chunks.

    Raises:
        InvalidInput: naming the file or the entry point of another package that is not.
    """
    with record_files() as digests:
        chunk = evaluator.chunk(*store.layout.sample_range(number))
    for path, digest in digests.items():
        if read.get(path, digest) != digest:
            raise InvalidInput(f"{path}: changed while the sweep ran, whose samples would be of two kinds. Put it back "
                               "and run the sweep again, or choose another folder with `store`.")
    digest_plugins(plugins)
    store.write(number, chunk)


@lru_cache(maxsize=4)
def _make_evaluator(job: _Job) -> Evaluator:
    """Return the evaluator of a worker, kept until its next job.

    Raises:
        InvalidInput: if it would compute other numbers than the command itself.
    """
    if program_digest(job.plugins) != job.program:
        raise InvalidInput(f"the worker on {platform.node()} has another version of polhode, of Python, of a library "
                           "or of a package that adds to polhode, or another setting such as XLA_FLAGS, than the "
                           "command, and would compute other last digits. Give all the same.")
    return Evaluator(job.plan)


def _compute_remotely(job: _Job, path: str, number: int) -> int:
    """Compute a chunk in a worker; errors travel as plain ones, whatever the client has imported."""
    _compute(_make_evaluator(job), Store(path, job.layout), number, job.read, job.plugins)
    return number


def _threads(client: Any) -> int:
    return max(1, sum(client.nthreads().values()))


@contextlib.contextmanager
def _cluster(workers: int, scheduler: str | None) -> Iterator[Any]:
    with needing("Sweeps on several processes need"):
        from dask import config
        from distributed import Client, LocalCluster
    with config.set({"distributed.comm.timeouts.connect": f"{LIMITS.answer_timeout}s",
                     "distributed.nanny.pre-spawn-environ": ENVIRONMENT}):
        if scheduler is not None:
            try:
                client = Client(scheduler, timeout=LIMITS.answer_timeout)
            except (OSError, ValueError, TimeoutError) as error:
                raise InvalidInput(f"`scheduler` {scheduler} does not answer ({error}). Start one with `dask "
                                   "scheduler` and give its address, like tcp://host:8786.") from None
            with client:
                _await_workers(client, scheduler)
                yield client
            return
        with _deaf_to_interrupts():
            cluster = LocalCluster(n_workers=workers, threads_per_worker=1, processes=True,
                                   dashboard_address=NO_DASHBOARD, silence_logs=50)
        with cluster, Client(cluster) as client:
            try:
                yield client
            except BaseException:  # unfinished chunks are lost anyway; the cluster would wait seconds for them
                cluster.sync(_end_workers, cluster)
                raise


async def _end_workers(cluster: Any) -> None:
    await asyncio.gather(*(nanny.close(timeout=LIMITS.stop_timeout) for nanny in list(cluster.workers.values())),
                         return_exceptions=True)


def _await_workers(client: Any, scheduler: str) -> None:
    """Wait for the first worker, which batch systems may start later than the scheduler.

    Raises:
        InvalidInput: if none comes.
    """
    if client.nthreads():
        return
    warnings.warn(f"the scheduler {scheduler} has no workers yet; waiting up to {LIMITS.worker_timeout:g} s for "
                  "one.", stacklevel=2)
    try:
        client.wait_for_workers(1, timeout=LIMITS.worker_timeout)
    except TimeoutError:
        raise InvalidInput(f"the scheduler {scheduler} has no workers. Start one with `dask worker {scheduler}`, "
                           "where it sees the store's folder.") from None


@contextlib.contextmanager
def _deaf_to_interrupts() -> Iterator[None]:
    """Shield child processes started in the block from a terminal's Ctrl-C; the parent ends them."""
    if not hasattr(signal, "pthread_sigmask"):
        yield
        return
    _start_tracker()  # which, when it starts, lets interrupts through again
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


def _start_tracker() -> None:
    """Start the process that frees semaphores of killed processes, without its warnings."""
    before = os.environ.get("PYTHONWARNINGS")
    os.environ["PYTHONWARNINGS"] = (f"{before}," if before else "") + "ignore:resource_tracker:UserWarning"
    try:
        resource_tracker.ensure_running()
    finally:
        if before is None:
            del os.environ["PYTHONWARNINGS"]
        else:
            os.environ["PYTHONWARNINGS"] = before


@contextlib.contextmanager
def _explain_failure(sweep: Sweep, store: Store) -> Iterator[None]:
    """Turn any failure of a sweep into one error with its cause and the number of kept chunks."""
    try:
        yield
    except (PolhodeError, KeyboardInterrupt):
        raise
    except Exception as error:
        done, again = len(store.list_finished()), "Run the same command again to go on."
        kept = f"{done} of {sweep.chunks} chunks are finished and kept. {again}"
        if isinstance(error, OSError):
            room = "Make room there." if error.errno in FULL else "Check the disk."
            why = f"{store.path}: cannot be written ({error.strerror or error}). {room} {kept}"
        elif isinstance(error, MemoryError) or _is_killed_worker(error):
            why = (f"{store.path}: workers were killed several times on one chunk, most likely for lack of memory. "
                   f"Set a smaller sweep.chunk, or take fewer workers. {kept}")
        else:
            why = f"{store.path}: a worker failed ({type(error).__name__}: {error}). {kept}"
        raise InvalidInput(why) from error


def _is_killed_worker(error: Exception) -> bool:
    """Return whether it is Dask's error for a killed worker; a sweep by one process does not import Dask."""
    try:
        from distributed import KilledWorker
    except ImportError:
        return False
    return isinstance(error, KilledWorker)
