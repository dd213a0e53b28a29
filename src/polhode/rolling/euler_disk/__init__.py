"""The kind ``euler-disk``: system, losses, steady rolling, the path and the end of the motion."""
