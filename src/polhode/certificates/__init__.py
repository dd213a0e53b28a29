"""Certificates of stability as exact data: found, checked, and written for a prover."""
