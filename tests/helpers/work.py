"""Count the work that a call does, so that a test of speed needs no clock: a busy machine does the same work."""

from __future__ import annotations

import sys
import time
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


def steps(act: Callable[[], object]) -> int:
    """Return how many lines of Python an act runs, each as often as it is run."""
    ran = 0

    def count(_: FrameType, event: str, __: object) -> Callable[..., object]:
        nonlocal ran
        ran += event == "line"
        return count

    before = sys.gettrace()
    sys.settrace(count)
    try:
        act()
    finally:
        sys.settrace(before)
    return ran


def seconds(act: Callable[[], object]) -> float:
    """Return the least processor time that an act takes, of three times, in s. It counts what is done in C, too."""
    times = []
    for _ in range(3):
        began = time.process_time()
        act()
        times.append(time.process_time() - began)
    return min(times)


def assert_few_steps(act: Callable[[int], object], size: int) -> None:
    """Assert that four times the input runs at most five times the lines; `act` takes the size of its input."""
    act(size)
    once, more = steps(lambda: act(size)), steps(lambda: act(4 * size))
    assert more <= 5 * once + 500, f"{once} lines for {size}, {more} for {4 * size}"


def assert_little_time(act: Callable[[int], object], size: int) -> None:
    """Assert that 16 times the input takes less than 80 times the processor time: with its square, it takes 256 times.

    The size has to be such that the square, where there is one, is most of the work.
    """
    act(size)
    once, more = seconds(lambda: act(size)), seconds(lambda: act(16 * size))
    assert more < 80 * max(once, 0.0002), f"{once:.4f} s for {size}, {more:.4f} s for {16 * size}"


def assert_linear(act: Callable[[int], object], size: int) -> None:
    """Assert that four times the input is at most five times the work; `act` takes the size of its input."""
    act(size)  # what is imported or cached once is not counted
    once, more = work(lambda: act(size)), work(lambda: act(4 * size))
    assert more <= 5 * once + 100, f"{once} calls for {size}, {more} for {4 * size}"
