"""Thrown bodies: from gyro logs to free flights, and moments of inertia and drag fitted to them."""
