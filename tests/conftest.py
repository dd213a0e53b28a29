"""Every call in the tests has its annotations checked, except where a test gives a wrong type on purpose."""

import pytest
from jaxtyping import config, install_import_hook

install_import_hook("polhode", "typed.check")


@pytest.fixture
def any_type():
    """What a user's call without a type checker does."""
    config.update("jaxtyping_disable", True)
    yield
    config.update("jaxtyping_disable", False)


@pytest.fixture
def announce(record_property):
    """Say something at the end of the run, from any worker."""
    return lambda text: record_property("announced", text)


def pytest_terminal_summary(terminalreporter):
    for reports in terminalreporter.stats.values():
        for report in reports:
            if getattr(report, "when", None) == "call":
                for name, text in report.user_properties:
                    if name == "announced":
                        terminalreporter.write_line("\n" + text)
