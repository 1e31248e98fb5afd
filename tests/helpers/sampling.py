"""Samples of many cases for the default tests; tests/bench/exhaustive runs the same tests on all cases."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from typing import TypeVar

import pytest

Case = TypeVar("Case")
WHOLE: list[bool] = []
"""Not empty where all cases are wanted; see bench/exhaustive/conftest.py."""


def sample(cases: Iterable[Case], every: int) -> list[Case]:
    """Return each n-th case, or all of them in tests/bench/exhaustive."""
    return list(cases)[:: 1 if WHOLE else every]


def examples(few: int) -> int:
    """Return how many examples a property is tried with: few, or twenty times as many in tests/bench/exhaustive."""
    return 20 * few if WHOLE else few


def assert_each(check: Callable[[Case], object], cases: Mapping[str, Case]) -> None:
    """Assert that a check passes for each named case; the failures of all cases are in one message."""
    assert cases
    failures = []
    for name, case in cases.items():
        try:
            check(case)
        except Exception as error:  # noqa: BLE001 (a crash is a failure of its case)
            failures.append(f"{name}: {type(error).__name__}: {error}")
    if failures:
        pytest.fail(f"{len(failures)} of {len(cases)} cases fail\n\n" + "\n\n".join(failures), pytrace=False)
