"""Says of long work that it goes on: one line on standard error, on a terminal or not."""

from __future__ import annotations

import contextlib
import sys
import threading
import time
from collections.abc import Iterator
from contextvars import ContextVar
from typing import NamedTuple


class LongWorkLimits(NamedTuple):
    """What decides that work is long."""

    silence: float = 30.0  # s: after it people ask themselves whether a program hangs


LIMITS = LongWorkLimits()
_silent: ContextVar[bool] = ContextVar("silent", default=False)
_whole: ContextVar[LongWork | None] = ContextVar("whole", default=None)


class LongWork:
    """Work that looks at the time now and then, as a thread that waits takes longer than a short motion.

    Args:
        what: subject of the line.
    """

    def __init__(self, what: str) -> None:
        self._what, self._begin, self._said = what, time.monotonic(), _silent.get()

    def go_on(self) -> None:
        """Say that it goes on, the first time that this is called after a while."""
        if not self._said and time.monotonic() - self._begin >= LIMITS.silence:
            self._said = True
            _say(self._what)


class as_one_work:
    """Have all that is within be one piece of work, of which one line is said in all.

    A class, as contexts written as generators take several times as long.
    """

    def __init__(self, what: str) -> None:
        self._what = what

    def __enter__(self) -> LongWork:
        work = _whole.get() or LongWork(self._what)
        self._token = _whole.set(work)
        return work

    def __exit__(self, *error: object) -> None:
        _whole.reset(self._token)


@contextlib.contextmanager
def long_work(what: str) -> Iterator[None]:
    """Say that what is within goes on, also in the middle of one call of compiled code, or while it is compiled."""
    if _silent.get():
        yield
        return
    waiting = threading.Timer(LIMITS.silence, _say, (what,))
    waiting.daemon = True
    waiting.start()
    try:
        with silent(True):
            yield
    finally:
        waiting.cancel()


class silent:
    """Have nothing said within, if so wanted: where progress is shown in another way, or not to be shown."""

    def __init__(self, wanted: bool) -> None:
        self._wanted = wanted

    def __enter__(self) -> None:
        self._token = _silent.set(self._wanted or _silent.get())

    def __exit__(self, *error: object) -> None:
        _silent.reset(self._token)


def _say(what: str) -> None:
    print(f"polhode: {what} goes on after {LIMITS.silence:g} s …", file=sys.stderr, flush=True)
