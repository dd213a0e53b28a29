"""What moves a system that names no method: Taylor series, and where it has none adaptive steps."""

import diffrax
import pytest


@pytest.fixture(params=[None, diffrax.Dopri8()], ids=["by series", "by adaptive steps"])
def stepper(request):
    """The default of ``simulate``, and the solver that it falls back on."""
    return request.param
