"""The parts of bench.py: robots, the tools that read them, the heats, and the table."""
