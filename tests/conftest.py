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
