"""An estimator of another package: the period of a swing from times at which it passed its lowest point."""
