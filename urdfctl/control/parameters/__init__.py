"""The nodes that read parameters, the values that they get, and the rules on these."""
