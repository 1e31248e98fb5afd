"""What xacro asks for packages."""
