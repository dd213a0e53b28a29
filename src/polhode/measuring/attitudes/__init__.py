"""Bodies whose attitude was recorded: moments of inertia and a torque fitted to it."""
