"""Switches JAX to double precision, on which everything rests that is stepped or differentiated."""

from __future__ import annotations

import os

from polhode._base.arrays.kept_programs import keep_programs
from polhode._base.extras import needing
from polhode.errors import InvalidInput, shown

with needing("Lie algebras and systems need"):
    import jax


def enable_double_precision() -> None:
    """Switch JAX to 64 bits for the whole process.

    Raises:
        InvalidInput: if the environment forbids it explicitly.
    """
    if os.environ.get("JAX_ENABLE_X64", "").lower() in ("0", "false", "off", "no", "n", "f"):
        raise InvalidInput(
            "`JAX_ENABLE_X64` must not be switched off; got "
            f"{shown(os.environ['JAX_ENABLE_X64'])} in the environment. "
            "Brackets and integrators need 64 bits: unset it."
        )
    jax.config.update("jax_enable_x64", True)
    keep_programs()
