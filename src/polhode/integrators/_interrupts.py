"""Handles Ctrl-C while compiled loops run, and says of long ones that they go on."""

from __future__ import annotations

import contextlib
import signal
import threading
from collections.abc import Callable, Iterator

from polhode._base.long_work import LongWork, as_one_work


@contextlib.contextmanager
def keep_interrupts() -> Iterator[Callable[[], None]]:
    """Yield a function that raises KeyboardInterrupt if Ctrl-C was pressed since, even if the exception was lost.

    Python raises it wherever the main thread is. In a callback of the garbage collector, as JAX has one, it is printed
    and forgotten, and a long run would go on. A handler of a program's own is left alone. After a while the function
    says once that the motion goes on.
    """
    with as_one_work("the motion") as work, _handle_interrupts(work) as check:
        yield check


@contextlib.contextmanager
def _handle_interrupts(work: LongWork) -> Iterator[Callable[[], None]]:
    if (
        threading.current_thread() is not threading.main_thread()
        or signal.getsignal(signal.SIGINT) is not signal.default_int_handler
    ):
        yield work.go_on
        return
    came = threading.Event()

    def note(number: int, frame: object) -> None:
        came.set()
        raise KeyboardInterrupt

    def check() -> None:
        work.go_on()
        if came.is_set():
            raise KeyboardInterrupt

    signal.signal(signal.SIGINT, note)
    try:
        yield check
    finally:
        signal.signal(signal.SIGINT, signal.default_int_handler)
