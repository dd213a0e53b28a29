"""Brackets, equations, integrals and stability in symbols, by SymPy, and derivations as pages."""
