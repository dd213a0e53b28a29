"""Brackets, equations, integrals and stability in symbols, by SymPy (extra `symbolic`), and derivations as pages."""
