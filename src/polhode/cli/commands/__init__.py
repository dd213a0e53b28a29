"""All commands, in the order in which the help lists them."""

from polhode.cli.commands import specs as specs  # noqa: I001  the order is that of the help
from polhode.cli.commands import records as records
from polhode.cli.commands.application import app as app
