"""Fluids on a sphere: the systems, quantized functions, spherical harmonics, zonal growth, initial fields, maps."""
