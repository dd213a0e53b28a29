"""How XLA compiles for a user, where the flags of the tests would have it compile quickly."""

import os

from polhode._base.arrays.few_calls import quick_options

CHANGED = bool(os.environ.get("XLA_FLAGS"))
FULLY = {"xla_cpu_use_fusion_emitters": True, "xla_backend_optimization_level": 3}
OPTIMIZED = {name: FULLY[name] for name in quick_options()} if CHANGED else None
