"""What the generators know of a robot (`facts.py`), and how a worker measures it (`job.py`)."""
