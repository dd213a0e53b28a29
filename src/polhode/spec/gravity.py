"""The gravity that specs have where they give none."""

STANDARD_GRAVITY = 9.80665  # m/s², by definition
