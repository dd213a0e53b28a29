"""What can go wrong, in three kinds; every message names the value, the rule and the remedy."""


class PolhodeError(Exception):
    """Base of every error that polhode raises on purpose."""


class InvalidInput(PolhodeError, ValueError):
    """A value that breaks a rule; the message says which, what came, and what to do."""


class NotConverged(PolhodeError, RuntimeError):
    """An iteration that did not reach its tolerance."""


class FormatError(InvalidInput):
    """A file that is not what its format promises; the message adds the path and, where known, the line."""
