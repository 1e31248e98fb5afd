"""The interfaces that a robot's hardware offers, and the simulator plugins that make them."""
