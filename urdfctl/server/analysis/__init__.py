"""What the server knows about the texts of a window: their robots, the names in them, and the place of a question."""
