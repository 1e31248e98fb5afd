"""`urdfctl view`: a robot in 3-D, with its joints coloured by how they are controlled."""
