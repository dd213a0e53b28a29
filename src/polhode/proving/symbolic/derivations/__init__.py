"""One file for each derivation that `polhode derive` prints; the registry finds them by their names."""
