"""From a module of LLVM to machine code for this processor."""

from __future__ import annotations

from typing import Any

from llvmlite import binding


def host_features() -> Any:
    """Return what LLVM knows of this machine's instructions."""
    try:
        return binding.get_host_cpu_features()
    except RuntimeError:  # LLVM does not know this machine
        return binding.FeatureMap()


def compile_module(module: Any, name: str) -> tuple[int, Any]:
    """Return the address of a function of a module, and the engine that keeps it in memory."""
    binding.initialize_native_target()
    binding.initialize_native_asmprinter()
    module.triple = binding.get_default_triple()
    parsed = binding.parse_assembly(str(module))
    parsed.verify()
    target, features = binding.Target.from_default_triple(), host_features().flatten()
    machine = target.create_target_machine(cpu=binding.get_host_cpu_name(), features=features, opt=2)
    engine = binding.create_mcjit_compiler(parsed, machine)
    engine.finalize_object()
    return engine.get_function_address(name), engine
