"""Handles Ctrl-C while compiled loops run, and says of long ones that they go on."""

from __future__ import annotations

import signal
import threading
from collections.abc import Callable

from polhode._base.long_work import as_one_work


class keep_interrupts:
    """Give a function that raises KeyboardInterrupt if Ctrl-C was pressed since, even if the exception was lost.

    Python raises it wherever the main thread is. In a callback of the garbage collector, as JAX has one, it is printed
    and forgotten, and a long run would go on. A handler of a program's own is left alone. After a while the function
    says once that the motion goes on.
    """

    def __enter__(self) -> Callable[[], None]:
        self._whole, self._came, self._handles = as_one_work("the motion"), False, False
        self._work = self._whole.__enter__()
        if threading.get_ident() != threading.main_thread().ident:
            return self._work.go_on
        if signal.getsignal(signal.SIGINT) is not signal.default_int_handler:
            return self._work.go_on
        self._handles = True
        signal.signal(signal.SIGINT, self._note)
        return self._check

    def __exit__(self, *error: object) -> None:
        if self._handles:
            signal.signal(signal.SIGINT, signal.default_int_handler)
        self._whole.__exit__()

    def _note(self, number: int, frame: object) -> None:
        self._came = True
        raise KeyboardInterrupt

    def _check(self) -> None:
        self._work.go_on()
        if self._came:
            raise KeyboardInterrupt
