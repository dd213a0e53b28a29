"""The kind ``spin-lattice``: spins with exchange, damping and heat; their waves, textures and hysteresis."""
