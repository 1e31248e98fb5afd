"""A private copy of the installed xacro package, and all that is replaced in it."""
