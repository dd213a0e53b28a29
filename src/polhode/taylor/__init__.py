"""Taylor series of motions: tapes, programs, the kernel that runs them."""
