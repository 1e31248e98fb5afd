"""Count the work that a call does, so that a test of speed needs no clock: a busy machine does the same work."""

from __future__ import annotations

import sys
from collections.abc import Callable
from types import FrameType


def work(act: Callable[[], object]) -> int:
    """Return how many calls of functions, in Python and in C, an act makes."""
    calls = 0

    def count(_: FrameType, event: str, __: object) -> None:
        nonlocal calls
        calls += event in {"call", "c_call"}

    before = sys.getprofile()
    sys.setprofile(count)
    try:
        act()
    finally:
        sys.setprofile(before)
    return calls


def assert_linear(act: Callable[[int], object], size: int) -> None:
    """Assert that four times the input is at most five times the work; `act` takes the size of its input."""
    act(size)  # what is imported or cached once is not counted
    once, more = work(lambda: act(size)), work(lambda: act(4 * size))
    assert more <= 5 * once + 100, f"{once} calls for {size}, {more} for {4 * size}"
