"""Compiled code: kernels that Python runs as they are written, and Numba compiles where the work is long.

A kernel is one or several modules of functions of single numbers. ``copying`` copies them, so that their functions call
each other and, in place of some, those of Numba or of arrays; ``kernel_modules`` has both forms of one kernel and says
when compiling is worth it; ``kept`` names what is kept on disk by all that it was made of; ``machine_code`` compiles
what is written for LLVM; ``threads`` shares the work among cores.

``entries`` has the functions that Python calls. On Linux on x86-64 they are ``images``, which ``objects`` makes by
Numba once and which are loaded without it; a release has some for classes of processors. On other systems ``compiling``
has Numba load what it has compiled. Only these two, ``objects`` and ``compiling``, import Numba.
"""
