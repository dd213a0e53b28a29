"""Two attitude histories compared: files, clocks, misalignment, and how far they differ."""
