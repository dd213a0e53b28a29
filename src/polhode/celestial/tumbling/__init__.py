"""``polhode tumble``: asteroids that tumble, their periods, light curves and damping."""
