"""Pictures of levels, lines, and states on the sphere of angular momentum."""
