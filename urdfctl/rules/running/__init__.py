"""UC8: faults of running systems."""
