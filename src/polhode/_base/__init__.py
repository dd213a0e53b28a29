"""Rooms that no user imports: arrays, compiled code, rationals, plug-ins."""
