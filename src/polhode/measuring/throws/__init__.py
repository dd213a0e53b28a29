"""Thrown bodies: gyro logs read and cleaned, free flights found, moments of inertia and drag fitted to them."""
