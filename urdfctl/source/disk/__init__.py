"""What a run may read, and how it is read."""
