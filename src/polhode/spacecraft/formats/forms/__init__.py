"""The formats of attitudes and robots: one module each with its ``FORM``."""
