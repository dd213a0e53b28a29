"""The kind ``point-vortices``: vortices in a plane or on a sphere, their equilibria and stability."""
