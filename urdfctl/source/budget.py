"""How much one robot may cost: more than any real one needs, less than an endless one takes."""

from __future__ import annotations

MAX_CALL_DEPTH = 250
MAX_CALLS = 20_000
MAX_ELEMENTS = 1_000_000
MAX_PROBLEMS = 100


class OverBudget(Exception):
    """An expansion costs more than any robot needs; nothing of it is worth keeping."""
