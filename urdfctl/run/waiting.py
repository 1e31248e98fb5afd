"""A line on the terminal while workers take longer than a user waits without wondering."""

from __future__ import annotations

import sys
import time

from urdfctl.output.printing import is_watched, visible

BAR_FROM = 20
"""From so many jobs on, their command shows a bar instead; of fewer nobody could read it."""
AFTER = 1.0
"""Seconds without a result until the line is shown, and between two of its states."""
_WIDEST = 79
_ERASED = "\r\x1b[K"


class WaitingLine:
    """Shows what is being done, how much of it is done, and for how long; on a terminal only, and erased afterwards.

    doing: `linting arm.urdf`; empty to show nothing. total: how many jobs there are.
    """

    def __init__(self, doing: str, total: int) -> None:
        self._doing, self._total = doing if doing and is_watched() else "", total
        self._began = self._shown_at = time.monotonic()
        self._is_shown = False

    @property
    def seconds(self) -> float | None:
        """How long to wait for a result before `show` is called; None for as long as it takes."""
        return max(self._shown_at + AFTER - time.monotonic(), 0.0) if self._doing else None

    def show(self, done: int) -> None:
        """Show the line if it is time to. done: how many jobs are done."""
        now = time.monotonic()
        if not self._doing or now < self._shown_at + AFTER:
            return
        self._shown_at, self._is_shown = now, True
        count = f", {done} of {self._total} done" if self._total > 1 else ""
        line = f"urdfctl: {self._doing}{count} ({now - self._began:.0f} s)"
        sys.stderr.write(f"{_ERASED}{visible(line)[:_WIDEST]}")
        sys.stderr.flush()

    def erase(self) -> None:
        """Erase the line, if it is shown, before anything else is printed."""
        if self._is_shown:
            sys.stderr.write(_ERASED)
            sys.stderr.flush()
            self._is_shown = False
