"""The checker of annotations that the tests switch on: an int is a float, as type checkers have it."""

import functools
import inspect
import typing

import jaxtyping
from beartype import BeartypeConf, beartype
from beartype.roar import BeartypeCallHintViolation
from jaxtyping import config

check = beartype(conf=BeartypeConf(is_pep484_tower=True))
whole = jaxtyping.jaxtyped
MOST = 4
"""Calls of a function that are checked in each test: with all of them the tests would take a third more time."""
now = [0]
"""The number of the test that runs."""


def checked(function=None, *, typechecker):
    """Check a function's arguments and result in one call.

    It stands in for ``jaxtyped``, which checks the arguments twice, and makes a checker anew whenever a function within
    a function is defined: a third of the time of all tests. That one says what is wrong where something is, and
    checks axes that are named by the value of an argument.
    """
    if function is None:
        return functools.partial(checked, typechecker=typechecker)
    if inspect.isclass(function):  # of which a dataclass has an initializer that no source shows
        is_checked = hasattr(function.__init__, "__wrapped__")
        return function if is_checked else whole(function, typechecker=typechecker)
    if isinstance(function, classmethod | staticmethod):
        return type(function)(checked(function.__func__, typechecker=typechecker))
    if isinstance(function, property):
        return property(checked(function.fget, typechecker=typechecker))
    if "<locals>" in function.__qualname__ or not function.__annotations__:
        return function
    if inspect.isgeneratorfunction(function):
        return whole(function, typechecker=typechecker)
    return first_calls(function, typechecker)


def make_checking(function, typechecker):
    """Return a function that is checked whenever it is called."""
    if not reads_by_itself(function):
        return whole(function, typechecker=typechecker)
    at_once = typechecker(function)

    def called(*args, **kwargs):
        if config.jaxtyping_disable:
            return function(*args, **kwargs)
        try:
            with whole("context"):  # in which axes of one name have one length
                return at_once(*args, **kwargs)
        except BeartypeCallHintViolation:
            return whole(function, typechecker=typechecker)(*args, **kwargs)

    return called


def first_calls(function, typechecker):
    """Return a function that is checked when it is first called in a test, and then runs as it is.

    Its checker is made for the first call: a worker calls a part of all functions, and making all took 5 seconds.
    """
    test, calls, checking = -1, 0, None

    @functools.wraps(function)
    def called(*args, **kwargs):
        nonlocal test, calls, checking
        if test != now[0]:
            test, calls = now[0], 0
        calls += 1
        if calls > MOST:
            return function(*args, **kwargs)
        checking = checking or make_checking(function, typechecker)
        return checking(*args, **kwargs)

    return called


def reads_by_itself(function):
    """Return whether every annotation can be read now, and none names an axis by an argument's value."""
    try:
        hints = typing.get_type_hints(function, include_extras=True)
    except Exception:  # what a module defines further down, or imports for type checkers alone
        return False
    return not any("{" in getattr(hint, "dim_str", str(hint)) for hint in hints.values())
