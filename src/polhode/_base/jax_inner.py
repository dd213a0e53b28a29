"""What polhode uses of JAX that JAX does not promise to keep: its interpreters, programs, tracers and its cache.

All of it is named here alone, so that a new version of JAX is met in one file; tests/test_jax_inner.py checks that,
and the default tests run by the oldest JAX that is allowed and by the newest. Modules that must not import JAX before
one of its arrays has come import this file where they need it.
"""

from jax.core import ShapedArray as ShapedArray
from jax.core import Tracer as Tracer
from jax.core import eval_jaxpr as eval_jaxpr  # type: ignore[attr-defined]
from jax.extend.core import Primitive as Primitive
from jax.interpreters import ad as ad
from jax.interpreters import batching as batching
from jax.interpreters import mlir as mlir

try:
    from jax._src.core import EvalTrace, trace_ctx
except ImportError:  # then an operation shows whether JAX traces now
    EvalTrace = trace_ctx = None
try:
    from jax._src import compilation_cache as compilation_cache
except ImportError:  # then nothing that JAX compiles is kept
    compilation_cache = None


def evaluates_at_once() -> bool:
    """Return whether JAX is known to compute operations on known numbers now; where it is not, it may trace them."""
    return trace_ctx is not None and type(trace_ctx.trace) is EvalTrace
