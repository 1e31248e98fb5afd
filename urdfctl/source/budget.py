"""Limits for the expansion of one robot: above any real robot's needs, so that endless expansions end."""

from __future__ import annotations

MAX_CALL_DEPTH = 250
MAX_CALLS = 20_000
MAX_ELEMENTS = 1_000_000
MAX_PROBLEMS = 100
OUT_OF_MEMORY = "it needs more memory than one robot may use (see --memory)"


class OverBudget(Exception):
    """An expansion exceeds a limit. Its result so far is discarded."""
