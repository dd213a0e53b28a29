"""The Toda chain, on the dual of bidiagonal matrices."""
