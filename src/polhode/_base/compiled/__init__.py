"""Compiled code: kernels that Python runs as they are written, and Numba compiles where the work is long.

A kernel is one or several modules of functions of single numbers. ``copying`` copies them, so that their functions call
each other and, in place of some, those of Numba or of arrays; ``kernel_modules`` has both forms of one kernel and says
when compiling is worth it; ``compiling`` calls Numba, and is the only module here that loads it; ``kept`` names what is
kept on disk by all that it was made of; ``machine_code`` compiles what is written for LLVM; ``threads`` shares the work
among cores.
"""
