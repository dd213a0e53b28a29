"""Exact motions in closed form: the free rigid body and the Lagrange top."""
