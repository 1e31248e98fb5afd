"""The commands that an editor can call, and what they start."""
