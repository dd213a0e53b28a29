"""Files of spectroscopy: SPCAT, SPFIT, datasets of levels and lines."""
