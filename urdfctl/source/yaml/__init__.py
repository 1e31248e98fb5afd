"""YAML as a located tree, and the types of its values."""
