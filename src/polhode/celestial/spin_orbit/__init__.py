"""The kind ``spin-orbit``: a moon on an ellipse, its resonances and their overlap."""
