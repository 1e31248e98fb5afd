"""The explanation of a log's messages, as text and as JSON."""
