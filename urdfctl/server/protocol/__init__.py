"""What editors and the server say to each other: messages, URIs, positions, texts and their versions, and windows."""
