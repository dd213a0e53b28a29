"""Signals that stop a command: Ctrl-C, SIGTERM, and SIGHUP from a terminal that is closed.

Each raises ``Stopped`` where the command is, so that every file being written cleans up after itself, and the command
ends with 128 and the signal's number. Python's handlers run in the main thread between two of its instructions only,
and their exceptions are lost in some callbacks; so a second thread watches, and ends a process that does not end
itself.
"""

from __future__ import annotations

import contextlib
import os
import signal
import socket
import sys
import threading
from collections.abc import Iterator
from typing import Any, NamedTuple

SIGNALS = tuple(getattr(signal, name) for name in ("SIGINT", "SIGTERM", "SIGHUP") if hasattr(signal, name))


class StoppingLimits(NamedTuple):
    """A number that decides when a stopped process is ended."""

    grace: float = 2.0  # s in which a command may end by itself


LIMITS = StoppingLimits()


class Stopped(BaseException):
    """A signal came.

    Attributes:
        number: of the signal.
    """

    def __init__(self, number: int) -> None:
        super().__init__(number)
        self.number = number


class _Watch:
    """The signals received, and the thread that acts on them.

    Attributes:
        came: the exception of the first signal, None before.
    """

    def __init__(self) -> None:
        self.came: Stopped | None = None
        self._ended = threading.Event()
        self._told, self._teller = socket.socketpair()
        self._teller.setblocking(False)
        self._before: dict[int, Any] = {}
        self._told_before = sys.unraisablehook
        self._wakeup = -1

    def start(self) -> None:
        sys.unraisablehook = self._unraisable
        threading.Thread(target=self._see_to_it, name="polhode-signals", daemon=True).start()
        self._wakeup = signal.set_wakeup_fd(self._teller.fileno(), warn_on_full_buffer=False)
        for number in SIGNALS:
            if (handler := signal.getsignal(number)) is not signal.SIG_IGN:  # nohup's stay ignored
                self._before[number] = handler
                signal.signal(number, self._stop)

    def end(self) -> None:
        self._ended.set()
        for number, handler in self._before.items():
            signal.signal(number, handler)
        sys.unraisablehook = self._told_before
        signal.set_wakeup_fd(self._wakeup)
        self._teller.close()  # which lets the thread end

    def _stop(self, number: int, frame: Any) -> None:
        if self.came is None and not self._ended.is_set():  # more of them do not hurry it
            self.came = Stopped(number)
            raise self.came

    def _unraisable(self, lost: Any) -> None:
        """Ignore a ``Stopped`` that Python lost in a callback; the thread acts on it."""
        if not isinstance(lost.exc_value, Stopped):
            self._told_before(lost)

    def _see_to_it(self) -> None:
        with self._told:  # open until nobody writes any more: a signal that is held and raised again writes twice
            while (message := self._told.recv(1)) and message[0] not in SIGNALS:
                pass
            if message and not self._ended.wait(LIMITS.grace):
                _end_now(message[0])
            while message:
                message = self._told.recv(64)


@contextlib.contextmanager
def stop_on_signals() -> Iterator[None]:
    """Raise ``Stopped`` out of the block on a signal, or at its end if the block lost it and did not expect it.

    Elsewhere than in the main thread it does nothing, as signals do not come there.
    """
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    watch = _Watch()
    try:
        watch.start()
        yield
    except Exception:
        if watch.came is None:
            raise  # otherwise some library's exception for the signal
    finally:
        watch.end()
        if watch.came is not None:
            _remove_drafts()
            raise Stopped(watch.came.number) from None


def describe_stop(number: int) -> str:
    """Return the message for a command stopped by a signal."""
    return f"polhode: stopped by {signal.Signals(number).name}.\n"


def _end_now(number: int) -> None:
    """End the process from another thread, whatever the main thread is in, and leave no drafts."""
    _remove_drafts()
    with contextlib.suppress(OSError, ValueError):
        os.write(2, describe_stop(number).encode("ascii"))
    os._exit(128 + number)


def _remove_drafts() -> None:
    drafts = sys.modules.get("polhode.formats.drafts")  # where nothing was written it is not there
    if drafts is not None:
        drafts.remove_live_drafts()
