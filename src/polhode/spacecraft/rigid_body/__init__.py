"""The kind ``rigid-body``: a body with wheels, other mounts and torques, on an orbit and under control."""
