"""The kind ``sphere-mhd``: an ideal conducting fluid on a sphere, with its magnetic field."""
