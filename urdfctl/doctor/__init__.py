"""`urdfctl doctor`: compare a running system, as a recording shows it, with the files that it should run."""
