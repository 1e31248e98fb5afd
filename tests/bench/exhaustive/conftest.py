"""Here the tests run on all cases, not on a sample; see ../README.md."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest
import sampling
from hypothesis import settings

sampling.WHOLE.append(True)
settings.load_profile("whole")

TESTS = Path(__file__).parents[2]
sys.path += sorted({str(path.parent) for path in TESTS.glob("*/**/test_*.py") if path.parent != Path(__file__).parent})
"""What these tests import lies where pytest has not collected anything."""


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Let these tests take as long as they need."""
    for item in items:
        item.add_marker(pytest.mark.timeout(0))
