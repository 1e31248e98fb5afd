"""XML as a located tree."""
