"""Bodies that swing: moments of inertia from the periods on filaments or a pivot."""
