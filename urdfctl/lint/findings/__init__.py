"""What is done to findings after the rules: merge, group and order them, leave out what another one explains."""
