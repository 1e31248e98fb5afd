"""What a user asks for: joints from a list or by name, and controllers as words of the command line."""
