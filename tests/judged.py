"""Commands run in this process, bounded in time and memory, and what is wrong with how they ended."""

import contextlib
import faulthandler
import io
import json
import os
import re
import resource
import signal
import sys
import time
import traceback
import warnings
from pathlib import Path
from typing import NamedTuple

from polhode.cli.main import main

LONGEST = 60.0  # s of the processor, compiling included, that a command may take without a word
MOST_MEMORY = 4e9  # bytes more than before
NOT_A_NUMBER = re.compile(r"(?<![\w'\"./-])[-+]?(nan|inf)(?![\w'\"./-])", re.IGNORECASE)
CODE_LINE = re.compile(r"\w*Warning\b|Traceback|\.py:\d+|^\s+File \"|warnings\.warn", re.MULTILINE)
CODES = (0, 1, 2, 3)  # as docs/files.md lists them, of a command that no signal stops


class Outcome(NamedTuple):
    """How a command ended.

    Attributes:
        code: of the exit; None where it ended otherwise, as ``raised`` says.
        seconds: of the processor.
        left: files that were not there before.
    """

    code: int | None
    out: str
    error: str
    raised: str
    seconds: float
    left: list[str]


class TooLong(BaseException):
    """The command took more time than it may."""


def _stop(signum, frame):
    raise TooLong("".join(traceback.format_stack(frame)[-3:]))


@contextlib.contextmanager
def bounded(seconds=LONGEST):
    """Bound time and memory; where Python itself does not come round to say so, the process ends with a traceback."""
    before = signal.signal(signal.SIGVTALRM, _stop)
    memory = resource.getrlimit(resource.RLIMIT_AS)
    there = int(Path("/proc/self/statm").read_text().split()[0]) * os.sysconf("SC_PAGE_SIZE")
    resource.setrlimit(resource.RLIMIT_AS, (int(there + MOST_MEMORY), memory[1]))
    signal.setitimer(signal.ITIMER_VIRTUAL, seconds)
    faulthandler.dump_traceback_later(30 * seconds, exit=True, file=sys.__stderr__)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_VIRTUAL, 0)
        faulthandler.cancel_dump_traceback_later()
        resource.setrlimit(resource.RLIMIT_AS, memory)
        signal.signal(signal.SIGVTALRM, before)


def run(arguments, folder):
    """Run a command in this process, in a folder, with warnings as in a process of its own."""
    before, there, began = set(folder.rglob("*")), Path.cwd(), time.process_time()
    out, error, code, raised = io.StringIO(), io.StringIO(), None, ""
    os.chdir(folder)
    try:
        with bounded(), contextlib.redirect_stdout(out), contextlib.redirect_stderr(error), warnings.catch_warnings():
            warnings.resetwarnings()
            warnings.simplefilter("always")
            warnings.simplefilter("ignore", DeprecationWarning)
            main([str(argument) for argument in arguments])
    except SystemExit as end:
        code = end.code
    except TooLong as late:
        raised = f"took more than {LONGEST:g} s: {late}"
    except BaseException:
        raised = "".join(traceback.format_exc()[-1500:])
    finally:
        os.chdir(there)
    left = sorted(str(path.relative_to(folder)) for path in set(folder.rglob("*")) - before if path.is_file())
    return Outcome(code, out.getvalue(), error.getvalue(), raised, time.process_time() - began, left)


def faults_of(outcome, given):
    """Return what is wrong with how a command ended, in words; nothing for a good end.

    Args:
        outcome: how it did.
        given: what it was given, as text; what it says may repeat these words.
    """
    found = []
    announced = "seconds" in outcome.error or "minutes" in outcome.error
    if outcome.raised and not (announced and outcome.raised.startswith("took")):
        return [outcome.raised]
    if outcome.code not in CODES and not outcome.raised:
        found.append(f"exit code {outcome.code}")
    if noise := CODE_LINE.search(outcome.error):
        found.append("code on standard error: " + outcome.error[max(noise.start() - 200, 0) : noise.end() + 300])
    if outcome.code == 2 and not outcome.error.strip():
        found.append("refused without a word")
    if outcome.code == 2 and outcome.left:
        found.append(f"refused, and left {outcome.left}")
    named = re.search(r"\b(nan|inf)\b", given, re.IGNORECASE)
    if not named and (number := NOT_A_NUMBER.search(outcome.out)):
        found.append("printed " + outcome.out[max(number.start() - 150, 0) : number.end() + 50])
    if not named and (number := NOT_A_NUMBER.search(outcome.error)):
        found.append("said " + outcome.error[max(number.start() - 150, 0) : number.end() + 50])
    if outcome.out.startswith("{"):
        try:
            json.loads(outcome.out, parse_constant=_refuse)
        except ValueError as wrong:
            found.append(f"its JSON cannot be read: {wrong}")
    return found


def _refuse(name):
    raise ValueError(f"{name} is no JSON")
