"""The layer between NumPy and JAX, for closed forms.

It is the only folder of the closed-form rooms that may import JAX, and does so only once a JAX array has come in.
"""

from polhode._base.arrays.derivatives import (
    COMPLEX_STEP,
    derivative_columns,
    forward_columns,
    stop_gradient,
)
from polhode._base.arrays.elementwise import Elementwise, closed_forms
from polhode._base.arrays.few_calls import arrays_for_few_calls, compiled_for_few_calls, compiled_quickly
from polhode._base.arrays.loops import barrier, choose, compiled, iterate, iterate_until, split_halves, stack_last
from polhode._base.arrays.namespaces import (
    always,
    as_float64,
    in_jax_numpy,
    is_foreign,
    is_jax,
    is_positive,
    is_traced,
    is_tracing,
    known_false,
    known_numbers_only,
    namespace,
    nearest,
    refuse_complex,
    require_doubles,
)

__all__ = [
    "COMPLEX_STEP",
    "Elementwise",
    "always",
    "arrays_for_few_calls",
    "as_float64",
    "barrier",
    "choose",
    "closed_forms",
    "compiled",
    "compiled_for_few_calls",
    "compiled_quickly",
    "derivative_columns",
    "forward_columns",
    "in_jax_numpy",
    "is_foreign",
    "is_jax",
    "is_positive",
    "is_traced",
    "is_tracing",
    "iterate",
    "iterate_until",
    "known_false",
    "known_numbers_only",
    "namespace",
    "nearest",
    "refuse_complex",
    "require_doubles",
    "split_halves",
    "stack_last",
    "stop_gradient",
]
