"""The command ``polhode``: runs it, and turns errors and signals into messages and exit codes."""

from __future__ import annotations

import atexit
import gc
import os
import signal
import sys
import warnings
from typing import Any, NoReturn

from polhode._base.extras import named
from polhode.cli.stopping import SIGNALS, Stopped, describe_stop, stop_on_signals
from polhode.cli.terminal import readable_output
from polhode.errors import InvalidInput, NotInstalled, PolhodeError, one_line, shown

THREADS = "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS", "VECLIB_MAXIMUM_THREADS", "BLIS_NUM_THREADS"
MISTAKE, PIPE_CLOSED = 2, 1  # exit codes


def main(arguments: list[str] | None = None) -> NoReturn:
    """Run the command; a user's mistake ends with one message on standard error and exit code 2.

    Args:
        arguments: those of the command line where left out; then the process ends with the command.

    Raises:
        SystemExit: always; with 128 and its number after a signal, and 1 where the output's reader is gone.
    """
    if arguments is None:
        _collect_rarely()
        _use_one_thread_for_matrices()
    try:
        with readable_output(), stop_on_signals(), warnings.catch_warnings():
            # NumPy's; results that are not finite are refused in the end
            warnings.filterwarnings("ignore", category=RuntimeWarning)
            warnings.showwarning = _say_warning
            code = _run(arguments)
    except Stopped as stop:
        code = 128 + stop.number
        _tell(describe_stop(stop.number))
        if arguments is None:
            # drafts are removed; a compiler's threads go on, and crash where Python frees objects that they use
            os._exit(code)
    if arguments is None:
        for number in SIGNALS:  # while Python ends nothing is left to clean up or to report
            if signal.getsignal(number) is not signal.SIG_IGN:
                signal.signal(number, signal.SIG_DFL)
    sys.exit(code)


def _collect_rarely() -> None:
    """Look for garbage in cycles a hundred times less often, and not at all while the process ends.

    Importing libraries and tracing make a million objects that all live until the end, and Python looks through them
    again and again: a third of the time of a short command.
    """
    gc.set_threshold(100_000, 50, 1000)
    atexit.register(gc.freeze)


def _use_one_thread_for_matrices() -> None:
    """Leave linear algebra to one thread, unless the environment sets how many; before NumPy is imported.

    Matrices here are small. A second thread only waits for its next one, and spends processor time while it waits.
    """
    if not any(name in os.environ for name in ("OMP_NUM_THREADS", *THREADS)):
        os.environ.update(dict.fromkeys(THREADS, "1"))


def _run(arguments: list[str] | None) -> int | str | None:
    """Return the exit code of a command."""
    try:
        if sys.stdout is None:
            raise InvalidInput("standard output is closed, so nothing can be printed. Send it to /dev/null instead.")
        from polhode.cli.arguments import check_arguments
        from polhode.cli.commands import app
        from polhode.cli.compiled import compile_quickly, keep_compiled
        from polhode.cli.foreign import is_compiled_as_by_python

        try:
            check_arguments(sys.argv[1:] if arguments is None else arguments)
            if arguments is None:  # the process is the command's own
                if not is_compiled_as_by_python(sys.argv[1:2]):
                    compile_quickly()
                keep_compiled()
            app(arguments)
        finally:
            if sys.stdout is not None:
                sys.stdout.flush()  # so that what fails, fails here
    except SystemExit as end:
        return end.code
    except PolhodeError as error:
        _tell(f"polhode: {error}\n")
        return MISTAKE
    except ModuleNotFoundError as error:
        said = named("the command needs", error)
        if not isinstance(said, NotInstalled):
            raise
        _tell(f"polhode: {said}\n")
        return MISTAKE
    except MemoryError as error:
        _tell(f"polhode: there is not enough memory ({error}). Give fewer `samples` under [time], or a smaller file.\n")
        return MISTAKE
    except (ArithmeticError, *_singular()):  # Python's own words for it help nobody
        _tell("polhode: a number leaves double precision on the way. Give sizes that are nearer to one.\n")
        return MISTAKE
    except BrokenPipeError:
        _silence()
        return PIPE_CLOSED
    except OSError as error:
        _tell(f"polhode: {_describe_failure(error)}\n")
        _silence()
        return MISTAKE
    return 0


def _describe_failure(error: OSError) -> str:
    """Return the message for an operation that the system refused: on a named file, or on the output."""
    if error.filename is not None:
        path = shown(str(error.filename))
        return f"{path} cannot be read or written: {error.strerror}. Check the path and its permissions."
    if error.strerror is None:  # raised by a library in its own words
        return f"{one_line(str(error)).rstrip('.')}. Check the path and its permissions."
    return f"the output cannot be written: {error.strerror}. Check disk and destination."


def _singular() -> tuple[type[Exception], ...]:
    """Return NumPy's error for a matrix that is not finite, as a tuple; empty where NumPy is not imported."""
    numpy = sys.modules.get("numpy")
    return () if numpy is None else (numpy.linalg.LinAlgError,)


def _say_warning(message: Warning | str, *where: Any, **more: Any) -> None:
    """Say a warning in one line, without the line of code that it came from."""
    from polhode.cli.naming import as_options

    _tell(f"polhode: {as_options(one_line(str(message)))}\n")


def _tell(message: str) -> None:
    try:
        sys.stderr.write(message)
        sys.stderr.flush()
    except (OSError, AttributeError):  # standard error is closed
        pass


def _silence() -> None:
    """Discard what standard output still holds; Python would report at exit that it cannot be written."""
    try:
        nowhere = os.open(os.devnull, os.O_WRONLY)
        os.dup2(nowhere, sys.__stdout__.fileno())  # type: ignore[union-attr]
        os.close(nowhere)
    except (OSError, AttributeError, ValueError):
        pass


if __name__ == "__main__":
    main()
