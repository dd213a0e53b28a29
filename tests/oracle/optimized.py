"""How XLA compiles for a user, where the flags of the tests would have it compile quickly."""

import os

CHANGED = bool(os.environ.get("XLA_FLAGS"))
OPTIMIZED = {"xla_cpu_use_fusion_emitters": True, "xla_backend_optimization_level": 3} if CHANGED else None
