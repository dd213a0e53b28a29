"""Files of attitudes and robots: CCSDS messages, SPICE kernels, STK, flight controllers, URDF, SDF, MJCF."""
