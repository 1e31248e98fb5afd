"""A generator of systems: robots with their controllers, written as workspaces in random idioms, and a judge."""
